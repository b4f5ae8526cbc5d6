"""Checks for cutting files from any source, read back with ezdxf and svgelements instead of the package."""

import re
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

ORDER = ("SHEET", "ENGRAVE", "MARK", "CUT_INNER", "CUT_OUTER")
CUTS = ORDER[3:]
SVG = "{http://www.w3.org/2000/svg}"
LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"


@dataclass(frozen=True)
class Curve:
    """A loop or an open line of a file as dense points (n, 2), mm. A loop repeats its first point."""

    layer: str
    points: np.ndarray
    closed: bool

    @property
    def length(self):
        return np.hypot(*np.diff(self.points, axis=0).T).sum()

    @property
    def area(self):
        x, y = (self.points - self.points[0]).T
        return abs(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1])) / 2


def check_drawing_file(path, *, open_cuts=False):
    """Check a cutting file and return its curves in the order of the file."""
    path = Path(path)
    curves = {".dxf": _dxf_curves, ".svg": _svg_curves}[path.suffix](path)
    assert curves, "the file is empty"
    ranks = [ORDER.index(curve.layer) for curve in curves]
    assert ranks == sorted(ranks), "the border, engraving, marks, inner cuts, outer cuts, in this order"
    for curve in curves:
        assert np.all(np.isfinite(curve.points))
        assert curve.closed or open_cuts or curve.layer not in CUTS, f"an open cut at {curve.points[0]}"
        assert not curve.closed or curve.area > 0
    _assert_nothing_twice(curves)
    outer = [curve for curve in curves if curve.layer == "CUT_OUTER"]
    for curve in curves:
        if curve.layer == "CUT_INNER" and outer:
            assert any(_inside(curve.points[0], loop.points) for loop in outer), (
                "an inner cut outside every part"
            )
    return curves


def check_drawing(drawing, folder, *, open_cuts=False, **options):
    """Write a drawing as DXF and SVG, and check that both files are sound and match the drawing."""
    from elastica_cad.formats import write_drawing

    for suffix in (".dxf", ".svg"):
        first = write_drawing(drawing, Path(folder) / f"checked{suffix}", force=True, **options)
        again = write_drawing(drawing, Path(folder) / f"again{suffix}", force=True, **options)
        assert first.read_bytes() == again.read_bytes(), "the same drawing gives the same file"
        curves = check_drawing_file(first, open_cuts=open_cuts)
        drawn = drawing.strokes
        assert [curve.layer for curve in curves] == [item.layer for item in drawn]
        if options.get("kerf"):
            continue
        exact = options.get("curves", "spline") == "spline" and options.get("version") != "R12"
        slack = 1e-3 if exact else options.get("tolerance", 0.02)
        for curve, item in zip(curves, drawn, strict=True):
            assert curve.closed == item.path.closed
            assert abs(curve.length / item.path.length - 1) < 1e-5 + slack
            if curve.closed:
                assert abs(curve.area - abs(item.path.area)) <= slack * item.path.length


def _dxf_curves(path):
    import ezdxf

    document = ezdxf.readfile(path)
    audit = document.audit()
    assert not audit.errors
    assert not audit.fixes
    if document.dxfversion != "AC1009":
        assert document.header["$INSUNITS"] == 4
        assert document.header["$MEASUREMENT"] == 1
    curves, chain, last = [], [], ""
    for entity in document.modelspace():
        assert entity.dxf.layer in document.layers
        points, closed = _entity_points(entity)
        layer = entity.dxf.layer
        loose = entity.dxftype() in ("LINE", "ARC", "SPLINE") and not closed
        longer = _appended(chain, points) if loose and layer == last else None
        if chain and longer is None:
            curves.append(Curve(last, np.concatenate(chain), False))
            chain = []
        if not loose:
            curves.append(Curve(layer, points, closed))
            continue
        chain, last = longer or [points], layer
        if _meet(chain[0][0], chain[-1][-1]):
            curves.append(Curve(layer, np.concatenate(chain), True))
            chain = []
    return [*curves, Curve(last, np.concatenate(chain), False)] if chain else curves


def _appended(chain, points):
    """Return the chain with an entity appended, or None if the entity does not continue it."""
    turned = [piece[::-1] for piece in chain[::-1]]
    for pieces in (chain, turned) if len(chain) == 1 else (chain,):
        for piece in (points, points[::-1]):
            if pieces and _meet(pieces[-1][-1], piece[0]):
                return [*pieces, piece]
    return None


def _plane(v):
    assert abs(v.z) == 0
    return np.array([v.x, v.y])


def _meet(p, q):
    return np.hypot(*(p - q)) <= 1e-6


def _entity_points(entity):
    kind = entity.dxftype()
    if kind == "LINE":
        return np.array([_plane(entity.dxf.start), _plane(entity.dxf.end)]), False
    if kind in ("ARC", "CIRCLE"):
        a, b = (entity.dxf.start_angle, entity.dxf.end_angle) if kind == "ARC" else (0.0, 360.0)
        v = np.radians(np.linspace(a, b if b > a else b + 360.0, 2001))
        ring = _plane(entity.dxf.center) + entity.dxf.radius * np.column_stack([np.cos(v), np.sin(v)])
        return ring, kind == "CIRCLE"
    if kind == "SPLINE":
        return _spline_points(entity), bool(entity.closed)
    if kind == "LWPOLYLINE":
        return _bulged(entity.get_points("xyb"), entity.closed), bool(entity.closed)
    if kind == "POLYLINE":
        rows = [(*_plane(v.dxf.location), v.dxf.get("bulge", 0.0)) for v in entity.vertices]
        return _bulged(rows, entity.is_closed), bool(entity.is_closed)
    raise AssertionError(f"no {kind} belongs into a cutting file")


def _spline_points(entity):
    from scipy.interpolate import BSpline

    assert entity.dxf.degree <= 3
    knots, points = np.array(entity.knots), np.array(list(entity.control_points))[:, :2]
    weights = np.array(entity.weights) if len(entity.weights) else np.ones(len(points))
    assert len(knots) == len(points) + entity.dxf.degree + 1
    curve = BSpline(knots, np.column_stack([points * weights[:, None], weights]), entity.dxf.degree)
    inner = np.unique(knots)
    t = np.unique(np.concatenate([np.linspace(a, b, 201) for a, b in pairwise(inner)]))
    rows = curve(t)
    return rows[:, :2] / rows[:, 2:]


def _bulged(rows, closed):
    rows = [tuple(map(float, row)) for row in rows]
    after = rows[1:] + (rows[:1] if closed else [])
    points = [np.array([rows[0][:2]])]
    for (x, y, bulge), (u, v, _) in zip(rows, after, strict=False):
        p, q = complex(x, y), complex(u, v)
        turn = 4 * np.arctan(bulge)
        part = np.linspace(0, 1, 501 if bulge else 2)[1:]
        if bulge:  # the chord to a point of the arc is a sine of its angle, and turns uniformly
            part = np.sin(part * turn / 2) / np.sin(turn / 2) * np.exp(1j * (part - 1) * turn / 2)
        z = p + (q - p) * part
        points.append(np.column_stack([z.real, z.imag]))
    return np.concatenate(points)


def _svg_curves(path):
    import svgelements

    root = ElementTree.parse(path).getroot()
    width, height = (float(re.fullmatch(r"([0-9.]+)mm", root.get(k)).group(1)) for k in ("width", "height"))
    assert root.get("viewBox") == f"0 0 {root.get('width')[:-2]} {root.get('height')[:-2]}"
    curves = []
    for group in root.findall(f"{SVG}g"):
        assert group.get("fill") == "none"
        for element in group.findall(f"{SVG}path"):
            drawn = svgelements.Path(element.get("d"))
            assert sum(isinstance(piece, svgelements.Move) for piece in drawn) == 1, "one loop a path"
            pieces = [p for p in drawn if not isinstance(p, (svgelements.Move, svgelements.Close))]
            rows = [_svg_points(piece) for piece in pieces]
            closed = isinstance(drawn[-1], svgelements.Close)
            points = np.concatenate([*rows, rows[0][:1]] if closed else rows)
            assert points.min() >= -1e-6
            assert np.all(points.max(axis=0) <= np.array([width, height]) + 1e-6)
            curves.append(Curve(group.get(LABEL), points * (1, -1) + (0, height), closed))
    return curves


def _svg_points(piece):
    import svgelements

    if isinstance(piece, svgelements.CubicBezier):
        corners = np.array([(p.x, p.y) for p in (piece.start, piece.control1, piece.control2, piece.end)])
        t = np.linspace(0, 1, 301)[:, None]
        return np.hstack([(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t**2 * (1 - t), t**3]) @ corners
    t = np.linspace(0, 1, 2 if isinstance(piece, svgelements.Line) else 301)
    return np.array([(p.x, p.y) for p in map(piece.point, t)])


def _assert_nothing_twice(curves):
    boxes = np.array([[*c.points.min(axis=0), *c.points.max(axis=0)] for c in curves])
    for i, box in enumerate(boxes):
        for j in np.flatnonzero(np.abs(boxes[:i] - box).max(axis=1) < 1e-5):
            a, b = curves[int(j)].points, curves[i].points
            middle = b[len(b) // 3] * 0.37 + b[len(b) // 3 - 1] * 0.63
            assert _distance(middle, a) > 1e-5, f"the same curve twice at {middle}"


def _distance(p, line):
    a, d = line[:-1], np.diff(line, axis=0)
    u = np.clip(((p - a) * d).sum(axis=1) / np.maximum((d**2).sum(axis=1), 1e-300), 0, 1)
    return np.hypot(*(a + u[:, None] * d - p).T).min()


def _inside(p, loop):
    (x0, y0), (x1, y1) = loop[:-1].T, loop[1:].T
    hit = (y0 > p[1]) != (y1 > p[1])
    with np.errstate(divide="ignore", invalid="ignore"):
        x = x0 + (p[1] - y0) * (x1 - x0) / (y1 - y0)
    return bool(np.count_nonzero(hit & (x > p[0])) % 2)
