"""DXF drawings at random, and mutations of them: every curve that ezdxf finds is read, or named, or all is refused.

python -m tests.campaign.trust.lost_curves --files 500 --seed 1

ezdxf expands the blocks and flattens each entity. An entity is lost if no curve of ours runs along it, and more are
missing than the notes count. Entities that stand in the text of the file, but that ezdxf drops, count as lost, too.
"""

import io
import math
import random
import re
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import ezdxf
import numpy as np
from ezdxf import path as flattened
from ezdxf.units import conversion_factor
from scipy.spatial import cKDTree

from elastica_cad import ElasticaError
from elastica_cad.files import read_drawing
from tests.campaign.trust.corpus import originals
from tests.campaign.trust.numbered_cases import arguments, run_cases

KINDS = ("LINE", "ARC", "CIRCLE", "ELLIPSE", "SPLINE", "LWPOLYLINE", "POLYLINE")
OTHERS = {"TEXT", "MTEXT", "POINT", "ATTDEF", "SOLID", "HATCH", "VERTEX", "SEQEND", "ATTRIB", "VIEWPORT"}
NEAR = 0.01
"""Distance from a curve, as a fraction of the entity's size, within which a point is on it."""

CIRCLE = np.array([(math.cos(t), math.sin(t)) for t in np.linspace(0, 2 * math.pi, 400)])


def drawn(rng: random.Random) -> bytes:
    """A drawing of some entities, with blocks, layers and units."""
    version = rng.choice(("R12", "R2000", "R2007", "R2010", "R2018"))
    document = ezdxf.new(version, units=0 if version == "R12" else rng.choice((0, 1, 2, 4, 4, 4, 5, 6, 14)))
    if rng.random() < 0.3:
        document.header["$MEASUREMENT"] = rng.randrange(2)
    for name in ("cut", "off", "frozen"):
        layer = document.layers.add(name)
        (layer.off if name == "off" else layer.freeze if name == "frozen" else layer.on)()
    for name in ("B", "C"):
        block = document.blocks.new(name, base_point=(rng.uniform(-5, 5), 0))
        for _ in range(rng.randint(1, 3)):
            entity(rng, block, version)
        if name == "C":
            insert(rng, block, "B")
    space = document.modelspace()
    for _ in range(rng.randint(1, 6)):
        entity(rng, space, version)
    for _ in range(rng.choice((0, 0, 1, 2))):
        insert(rng, space, rng.choice("BC"))
    if rng.random() < 0.1:
        entity(rng, document.paperspace(), version)
    stream = io.StringIO()
    document.write(stream)
    return stream.getvalue().encode()


def entity(rng: random.Random, space: Any, version: str) -> None:
    """Draw one, now and then where another one ends."""
    last = list(space)[-1] if len(space) and rng.random() < 0.3 else None
    x, y = rng.uniform(-400, 400), rng.uniform(-400, 400)
    if last is not None and last.dxftype() == "LINE":  # a gap of one unit of the last digit
        x, y = last.dxf.end.x + rng.choice((0, 0.001, 1e-6)), last.dxf.end.y
    size = rng.choice((1, 10, 10, 100)) * rng.uniform(0.5, 3)
    points = [(x + k * size, y + rng.uniform(-1, 1) * size) for k in range(rng.randint(4, 9))]
    attributes: dict[str, Any] = {"layer": rng.choice(("0", "0", "cut", "cut", "cut", "off", "frozen"))}
    kind = rng.choice(KINDS if version != "R12" else ("LINE", "ARC", "CIRCLE", "POLYLINE"))
    if rng.random() < 0.1 and kind in ("ARC", "CIRCLE", "LWPOLYLINE"):
        attributes["extrusion"] = (0, 0, -1)
    bulges = [(*p, rng.choice((0, 0, 0.2, -1, 0.9))) for p in points]
    angles = rng.uniform(0, 360), rng.uniform(0, 360)
    closed = rng.random() < 0.2
    match kind:
        case "LINE":
            space.add_line(points[0], points[1], attributes)
        case "ARC":
            space.add_arc((x, y), size, *angles, dxfattribs=attributes)
        case "CIRCLE":
            space.add_circle((x, y), size, attributes)
        case "ELLIPSE":
            space.add_ellipse(
                (x, y), (size, size / 3), rng.uniform(0.1, 1), *map(math.radians, angles), attributes
            )
        case "SPLINE":
            add = rng.choice((space.add_spline, space.add_open_spline))
            add(points, dxfattribs=attributes)
        case "LWPOLYLINE":
            space.add_lwpolyline(bulges, format="xyb", close=closed, dxfattribs=attributes)
        case "POLYLINE" if rng.random() < 0.5:
            space.add_polyline2d(bulges, format="xyb", close=closed, dxfattribs=attributes)
        case _:
            space.add_polyline3d([(*p, 0) for p in points], close=closed, dxfattribs=attributes)


def insert(rng: random.Random, space: Any, name: str) -> None:
    """Insert a block, turned, scaled, mirrored, or in rows."""
    scale = rng.choice((1, 1, 2, -1, 0.1)), rng.choice((1, 1, 3, -1))
    attributes: dict[str, Any] = {
        "xscale": scale[0], "yscale": scale[1], "rotation": rng.choice((0, 90, 37.0)),
        "layer": rng.choice(("0", "cut")),
    }  # fmt: skip
    if rng.random() < 0.3:
        attributes |= {
            "row_count": 2,
            "column_count": rng.randint(1, 3),
            "row_spacing": 900,
            "column_spacing": 900,
        }
    space.add_blockref(name, (rng.uniform(-2000, 2000), rng.uniform(-2000, 2000)), attributes)


def changed(rng: random.Random, data: bytes) -> bytes:
    """Change tags of the entities (coordinates, kinds, layers, flags, names of blocks), or take a tag away."""
    rows = data.replace(b"\r\n", b"\n").split(b"\n")
    begin = next((k for k, row in enumerate(rows) if row.strip() in (b"BLOCKS", b"ENTITIES")), 0)
    tags = list(range(begin + 1, len(rows) - 1, 2))
    for _ in range(rng.choice((1, 1, 2, 4, 8))):
        at = rng.choice(tags)
        code = rows[at].strip()
        number = (
            re.fullmatch(rb"[-+]?[\d.]+(?:[eE][-+]?\d+)?", rows[at + 1].strip())
            if at + 1 < len(rows)
            else None
        )
        what = rng.random()
        if code == b"0" and rows[at + 1].strip().decode("latin1") in KINDS and what < 0.5:
            rows[at + 1] = rng.choice(KINDS).encode()
        elif code == b"8":
            rows[at + 1] = rng.choice((b"cut", b"off", b"frozen", b"none", b"0"))
        elif code == b"2" and what < 0.3:
            rows[at + 1] = rng.choice((b"B", b"C", b"nowhere"))
        elif number and code.startswith((b"1", b"2", b"3", b"4")) and what < 0.6:
            value = float(number[0])
            rows[at + 1] = rng.choice((
                b"%.9g" % (value + rng.gauss(0, 1e-3)), b"%.9g" % -value, b"%.3f" % value,
                b"0", b"nan", b"1e300", b"-0",
            ))  # fmt: skip
        elif number and code.startswith((b"6", b"7", b"9")) and what < 0.8:
            rows[at + 1] = rng.choice((b"0", b"1", b"2", b"3", b"8", b"64", b"128", b"1000000000"))
        elif what > 0.9:
            del rows[at : at + 2]
            tags = tags[:-1]
    return b"\n".join(rows)


def in_text(data: bytes) -> int:
    """Number of curve entities of the section ENTITIES by its tags alone; those of paper layouts too."""
    section = re.search(rb"\n\s*2\s*\n\s*ENTITIES\s*\n(.*?)(?:\n\s*0\s*\n\s*ENDSEC|\Z)", data, re.DOTALL)
    rows = section[1].replace(b"\r", b"").split(b"\n") if section else []
    names = [
        b.strip().decode("latin1") for a, b in zip(rows[::2], rows[1::2], strict=False) if a.strip() == b"0"
    ]
    return sum(name in KINDS for name in names)


def expected(layout: Any, hidden: set[str], *placed: Any) -> Iterator[tuple[Any, Any]]:
    """Visible curve entities by ezdxf, blocks expanded, and the points of each in the plane of the drawing."""
    for one in layout:
        if one.dxf.get("layer", "0").lower() in hidden or one.dxf.get("invisible", 0):
            continue
        if one.dxftype() == "INSERT":
            with suppress(ezdxf.DXFError, TypeError):  # an insertion without a name or a place
                for copy in one.multi_insert() if one.mcount > 1 else (one,):
                    yield from expected(one.block() or (), hidden, copy.matrix44(), *placed)
        elif one.dxftype() in KINDS:
            with np.errstate(all="ignore"), suppress(ValueError, TypeError, ArithmeticError):
                points = list(flattened.make_path(one).approximate(12))
                for matrix in placed:
                    points = list(matrix.transform_vertices(points))
                if len(points) > 1:
                    yield one, np.array([(x, y) for x, y, _ in points])


def lost(file: Path) -> tuple[str, list[str]]:
    """How the reading of a file ended, and which curves are lost."""
    try:
        found = read_drawing(file)
        curves = [(one, None if one.problem else one.curve) for one in found.curves]
    except ElasticaError as refusal:
        return "refused", [] if str(refusal) else ["an empty refusal"]
    try:
        document = ezdxf.readfile(file)
    except (ezdxf.DXFError, ValueError, TypeError, LookupError, AttributeError, OSError):
        document, _ = ezdxf.recover.readfile(file)
    named = sum(count for kind, count in found.skipped.items() if kind not in OTHERS)
    unit = document.header.get("$INSUNITS", 0)
    scale = conversion_factor(unit, 4) if unit else {"mm": 1.0, "in": 25.4}[found.unit.name]
    places = [np.array([[math.inf, math.inf]])]
    for one, curve in curves:
        # as they stand in the file: a curve may have a problem, which is a note, or a slanted plane of its own
        places += [edge.at(edge.stations(400))[:, :2] for edge in one.chain]
        if curve is None:
            continue
        places.append(curve.sample(2001).position)
        holes = curve.provenance.holes if curve.provenance else ()
        places += [(x, y) + size / 2 * CIRCLE for x, y, size in holes]
    near = cKDTree(np.vstack(places)[1:])
    hidden = {one.dxf.name.lower() for one in document.layers if one.is_frozen() or one.is_off()}
    missing = []
    for one, points in expected(document.modelspace(), hidden):
        line = scale * points
        size = float(np.ptp(line, axis=0).max())
        if not math.isfinite(size) or size == 0:
            continue
        if near.query(line)[0].max() > max(NEAR * size, 0.5):
            missing.append(f"{one.dxftype()} {one.dxf.handle} of {size:.3g} mm")
    wrong = [f"{missing[:5]}; {len(missing)} missing, {named} named"] if len(missing) > named else []
    held = sum(one.dxftype() in KINDS for space in document.layouts for one in space)
    if (text := in_text(file.read_bytes())) > held + named:
        wrong.append(f"{text} in the file, {held} read by ezdxf, {named} named")
    return "read, some named" if missing else "read", wrong


def made(seed: int, number: int, folder: Path) -> tuple[str, list[str]]:
    """How one file ended, and what is wrong with that."""
    rng = random.Random(f"{seed} {number}")
    data = drawn(rng) if rng.random() < 0.7 else rng.choice(originals("dxf"))
    file = folder / "case.dxf"
    file.write_bytes(changed(rng, data) if rng.random() < 0.8 else data)
    return lost(file)


def main() -> None:
    request = arguments(__doc__ or "", "files", 500, minutes=20.0)
    with TemporaryDirectory() as folder:
        run_cases(request, "lost_curves", "files", lambda seed, number: made(seed, number, Path(folder)))


if __name__ == "__main__":
    main()
