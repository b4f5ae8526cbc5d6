"""Drawings of strips drawn at random, written and read by others: closed, not through themselves, inside the stock.

python -m tests.campaign.trust.written --strips 3000 --seed 1 --minutes 30

ezdxf reads what was written, shapely judges it; neither shares code with what drew it. Refusals are counted.
"""

import random
import traceback
import warnings
from pathlib import Path
from tempfile import TemporaryDirectory

import ezdxf
import ezdxf.path
import numpy as np
import shapely

import elastica_cad as ec
from elastica_cad.model import nest_pieces
from elastica_cad.strip.pieces import strip_pieces
from tests.campaign.trust.numbered_cases import arguments, run_cases

SHEETS = ("birch-plywood-0.8", "card-200gsm", "birch-plywood-4", "pom-0.5")
FLAT_MM = 0.002
"""How closely lines follow splines and arcs before shapely sees them."""

JOINED_MM = 1e-3
"""Ends of one loop meet as near as files keep."""

SLIVER_MM2 = 1e-6
"""Area below which two lines that cross do so by the last digits of the file."""

STOCK_MM = (900.0, 600.0)

TOUCHING = "parts touch or cross"
"""Said of pieces, of which each has a cut of its own."""


def strip_of(rng):
    """A strip as somebody might ask for: any style, ends and slots."""
    scale = rng.uniform(0.5, 3.0)
    x = np.cumsum([0.0, *(rng.uniform(25, 60) for _ in range(rng.randint(3, 5)))])
    high = rng.uniform(8, 40)  # an arch, with some noise: most of these can be bent
    points = [(scale * float(a), scale * (high * np.sin(np.pi * a / x[-1]) + rng.uniform(-3, 3))) for a in x]
    sheet = rng.choice(SHEETS)
    wide = rng.uniform(15, 60)
    style = rng.choice(
        (
            ec.Plain(),
            ec.Plain(),
            ec.Perforated(width=wide, columns=rng.randint(1, 4), rows=rng.choice((None, 4, 9))),
            ec.Perforated(width=wide, columns=2, sides="arc", corner_radius=rng.uniform(0, 0.5)),
            ec.Laminated(width=wide, backing=rng.choice(SHEETS)),
        )
    )
    options = {"max_width": wide} if isinstance(style, ec.Plain) else {}
    ends = (ec.Tab(0.0), ec.Tab(rng.uniform(4, 20)), ec.Tab(rng.uniform(8, 20), holes=(ec.Hole(4.0, 2.0),)))
    options["ends"] = tuple(rng.choice(ends) for _ in range(2))
    length = ec.PlaneCurve.spline(points, degree=3).length
    options["slots"] = tuple(
        ec.Slot(
            at=rng.uniform(0.05, 0.95) * length,
            width=rng.uniform(0.3, 2.5),
            depth=rng.uniform(1.0, wide / 2),
            side=rng.choice(("upper", "lower")),
            lean=rng.uniform(-0.5, 0.5),
            relief=rng.choice(("square", "round")),
        )
        for _ in range(rng.choice((0, 0, 1, 2, 4)))
    )
    if rng.random() < 0.4:
        options["limits"] = ec.Limits(ratio=rng.uniform(1.5, 5.0))
    curve = ec.PlaneCurve.spline(points, degree=3)
    return ec.make_strip(curve, sheet, style=style, label="R7", ignore_limits=rng.random() < 0.5, **options)


def loops(path, layer):
    """Polygons of the closed lines on a layer of a DXF file as another program reads it, and how many stay open."""
    chains = [
        np.array([(p.x, p.y) for p in ezdxf.path.make_path(entity).flattening(FLAT_MM)])
        for entity in ezdxf.readfile(path).modelspace().query(f'*[layer=="{layer}"]')
    ]
    chains = [chain for chain in chains if np.ptp(chain, axis=0).max() > JOINED_MM]  # a crumb is bridged
    found, open_ones = [], 0
    while chains:
        line = chains.pop()
        while np.hypot(*(line[-1] - line[0])) > JOINED_MM:
            near = [
                (float(np.hypot(*(chain[end] - line[-1]))), number, end)
                for number, chain in enumerate(chains)
                for end in (0, -1)
            ]
            gap, number, end = min(near, default=(np.inf, 0, 0))
            if gap > JOINED_MM:
                open_ones += 1
                break
            chain = chains.pop(number)
            line = np.concatenate([line, (chain if end == 0 else chain[::-1])[1:]])
        else:
            found.append(shapely.Polygon(line))
    return found, open_ones


def _simple(polygon):
    """Whether a loop goes round one area; slivers where two splines meet in a sharp tip do not count."""
    areas = shapely.area(shapely.get_parts(shapely.make_valid(polygon)))
    return int((areas > SLIVER_MM2).sum()) == 1


def faults(path, size=None):
    """What is wrong with the cuts of one file."""
    outer, gaps = loops(path, "CUT_OUTER")
    inner, more = loops(path, "CUT_INNER")
    found = [f"{gaps + more} lines stay open"] if gaps + more else []
    found += [f"through itself: {one.bounds}" for one in (*outer, *inner) if not _simple(one)]
    if found or not outer:
        return found or ["nothing is cut"]
    parts, holes = shapely.STRtree(outer), shapely.STRtree(inner)
    if sum(len(parts.query(one, predicate="within")) for one in inner) != len(inner):
        found.append("a hole is in no part, or crosses its edge")
    if len(inner) and len(holes.query(inner, predicate="intersects")[0]) > len(inner):
        found.append("holes touch or cross")
    if len(parts.query(outer, predicate="intersects")[0]) > len(outer):
        found.append(TOUCHING)
    if size and not all(shapely.box(0, 0, *size).contains(one) for one in outer):
        found.append("a part leaves the sheet")
    return found


def drawn(seed, number, folder):
    """How one request ended, and what is wrong with its files."""
    rng = random.Random(f"{seed} {number}")
    with warnings.catch_warnings(record=True) as warned:
        warnings.simplefilter("always", category=RuntimeWarning)
        try:
            strip = strip_of(rng)
            wrong = []
            for drawing in strip.drawings():
                path = folder / "part.dxf"
                curves, kerf = rng.choice(("spline", "arc")), rng.choice((0.0, 0.0, 0.15, 0.3))
                ec.save(drawing, path, kerf=kerf, curves=curves, force=True)
                wrong += [f"{curves}, kerf {kerf}: {fault}" for fault in faults(path)]
            if rng.random() < 0.3:
                pieces = strip_pieces(ec.Model([ec.Placed(strip)]).parts)
                for sheet in nest_pieces(pieces, sheet_size=STOCK_MM):
                    ec.save(sheet, path, force=True)
                    wrong += [f"nested: {fault}" for fault in faults(path, STOCK_MM)]
        except ec.ElasticaError as problem:
            return "sentence", [str(problem)] if "\n" in str(problem) else []
        except Exception:
            return "traceback", [traceback.format_exc(limit=-4)]
    return type(strip.style).__name__, wrong + [str(one.message) for one in warned]


def main():
    request = arguments(__doc__, "strips", 3000, minutes=60.0)
    with TemporaryDirectory() as folder:
        run_cases(request, "written", "strips", lambda seed, number: drawn(seed, number, Path(folder)))


if __name__ == "__main__":
    main()
