"""Curves drawn in an SVG file, exact where the file is exact."""

import re
from collections.abc import Iterator
from io import BytesIO
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError, MissingDependencyError
from elastica_cad.formats.chains import FIT_TOLERANCE, JOIN_TOLERANCE, chained, curve_from_run
from elastica_cad.formats.edges import Edge, Run
from elastica_cad.formats.opening import MILLIMETRES, existing_file, millimetres, naming
from elastica_cad.geometry import PlaneCurve

__all__ = ["read_svg_curves"]

_LENGTH = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(px|pt|pc|mm|cm|in|[qQ])?\s*")
_MM = {"pc": 25.4 / 6, "q": 0.25} | {unit: MILLIMETRES[unit] for unit in ("px", "pt", "mm", "cm", "in")}
_PX = MILLIMETRES["px"]
_LENGTH_ATTRIBUTES = ("x", "y", "x1", "y1", "x2", "y2", "cx", "cy", "r", "rx", "ry", "width", "height")


def read_svg_curves(
    path: str | Path,
    *,
    tolerance: float = JOIN_TOLERANCE,
    fit_tolerance: float = FIT_TOLERANCE,
    unit: str | None = None,
) -> list[PlaneCurve]:
    """All paths and basic shapes of the drawing, in mm, with up on the screen up: y is minus SVG's y.

    Bezier curves and arcs stay exact, with all transforms applied; pieces whose ends meet are joined to one
    curve; a path of straight lines only is fitted. The size of a user unit follows from width, height and
    viewBox of the drawing; without a width in mm or the like it is a CSS pixel, 25.4/96 mm. The origin is the
    one of the user units. Text, images, definitions and what is not displayed are left out.

    Parameters
    ----------
    tolerance : float
        Ends nearer than this are joined, mm.
    fit_tolerance : float
        Largest distance of a polyline's vertex from its curve, mm.
    unit : str, optional
        "mm", "in", "px", ...: what a user unit of the drawing is; overrides what the file says.

    Raises
    ------
    InputError
        No such file, not an SVG file, an unknown unit, path data that break off, nothing usable in it.
    MissingDependencyError
        svgelements is not installed.
    """
    path = existing_file(path)
    with naming(path):
        root = _root(path)
        scale = np.full(2, millimetres(unit)) if unit else _scale(root)
        to_mm = np.diag(scale * (1.0, -1.0))
        runs = [tuple(e.mapped(to_mm, (0.0, 0.0)) for e in run) for run in _runs(path, root)]
        chains = chained((run for run in runs if run), tolerance)
        if not chains:
            raise InputError(
                "holds no curve: draw a path, line, polyline, circle, ellipse or rectangle that is shown"
            )
        return [curve_from_run(chain, tolerance=tolerance, fit_tolerance=fit_tolerance) for chain in chains]


def _root(path: Path) -> ElementTree.Element:
    try:
        root = ElementTree.parse(path).getroot()
    except (ElementTree.ParseError, ValueError, LookupError) as error:
        raise InputError(f"is not an SVG file ({error}): export it anew") from error
    if root.tag.rpartition("}")[2] != "svg":
        raise InputError(
            f"is not an SVG file: it begins with <{root.tag.rpartition('}')[2]}>, not with <svg>"
        )
    return root


def _scale(root: ElementTree.Element) -> FloatArray:
    """Millimetres in one user unit along x and y, from width, height and viewBox."""
    size = [_absolute(root.get(side)) for side in ("width", "height")]
    box = [
        float(v) for v in re.findall(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?", root.get("viewBox", ""))
    ]
    if len(box) != 4 or box[2] <= 0 or box[3] <= 0:
        return np.full(2, _PX)
    known = [length / extent for length, extent in zip(size, box[2:], strict=True) if length]
    if not known:
        return np.full(2, _PX)
    aspect = root.get("preserveAspectRatio", "")
    if len(known) == 2 and "none" in aspect:
        return np.array(known)
    return np.full(2, max(known) if "slice" in aspect else min(known))


def _absolute(text: str | None) -> float | None:
    """A length in mm; None for percentages and what is no length."""
    match = _LENGTH.fullmatch(text or "")
    return float(match[1]) * _MM[(match[2] or "px").lower()] if match else None


def _runs(path: Path, root: ElementTree.Element) -> Iterator[Run]:
    """The subpaths of all shapes that are shown, in user units."""
    try:
        from svgelements import SVG, Matrix, Shape
    except ImportError as error:
        raise MissingDependencyError(
            f"reading {path.name} needs svgelements, which is not installed: pip install svgelements"
        ) from error
    try:
        drawing = SVG.parse(BytesIO(_in_user_units(root)), reify=False, on_error="raise")
        for shape in drawing.elements():
            if isinstance(shape, Shape):
                m = Matrix(shape.transform)
                matrix, offset = np.array([[m.a, m.c], [m.b, m.d]]), np.array([m.e, m.f])
                for run in _subpaths(shape.segments(transformed=False)):
                    yield tuple(edge.mapped(matrix, offset) for edge in run)
    except (ValueError, TypeError, IndexError, KeyError, AttributeError, RecursionError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(
            "has path data or attributes that break off or make no sense: export it anew"
        ) from error


def _in_user_units(root: ElementTree.Element) -> bytes:
    """The document without the size of its root, and lengths such as 10mm written as plain user units."""
    for element in root.iter():
        for name in _LENGTH_ATTRIBUTES:
            text = element.get(name)
            match = _LENGTH.fullmatch(text) if text else None
            if match and match[2]:
                element.set(name, repr(float(match[1]) * _MM[match[2].lower()] / _PX))
    box = root.get("viewBox", "").replace(",", " ").split()
    size = box[2:] if len(box) == 4 else [root.get("width", "100%"), root.get("height", "100%")]
    for name in ("viewBox", "preserveAspectRatio", "x", "y"):
        root.attrib.pop(name, None)
    root.set("width", size[0])
    root.set("height", size[1])
    return ElementTree.tostring(root)


def _subpaths(segments: Any) -> Iterator[Run]:
    """Edges between one Move and the next."""
    run: list[Edge] = []
    for segment in segments:
        kind = type(segment).__name__
        if kind == "Move":
            yield _with_polylines(run)
            run = []
        elif segment.start is not None and segment.end is not None:
            edge = _edge(kind, segment)
            if edge is not None:
                run.append(edge)
    yield _with_polylines(run)


def _with_polylines(run: list[Edge]) -> Run:
    """Several straight edges and nothing else are one polyline."""
    if len(run) > 1 and all(edge.degree == 1 for edge in run):
        return (Edge.polyline(np.concatenate([run[0].points[:1], *(edge.points[1:] for edge in run)])),)
    return tuple(run)


def _edge(kind: str, segment: Any) -> Edge | None:
    """One path segment in its own coordinates; None when it has no length."""
    if kind in ("Line", "Close"):
        points = _points(segment.start, segment.end)
    elif kind == "QuadraticBezier":
        points = _points(segment.start, segment.control, segment.end)
    elif kind == "CubicBezier":
        points = _points(segment.start, segment.control1, segment.control2, segment.end)
    else:
        return _arc(segment)
    if not np.any(points != points[0]):
        return None
    return Edge.polyline(points[[0, -1]]) if _is_straight(points) else Edge.bezier(points)


def _is_straight(points: FloatArray) -> bool:
    """Do the control points follow each other on the chord? Drawn-in handles often make straight lines."""
    chord = points[-1] - points[0]
    along = (points - points[0]) @ chord
    across = (points - points[0]) @ np.array([-chord[1], chord[0]])
    return bool(np.abs(across).max() <= 1e-12 * along[-1] and np.all(np.diff(along) >= 0))


def _points(*points: Any) -> FloatArray:
    return np.array([(p.x, p.y) for p in points], dtype=float)


def _arc(segment: Any) -> Edge | None:
    """The exact arc through both ends; its centre found anew, for a half turn leaves it ill-conditioned."""
    start, end, center, px, py = _points(segment.start, segment.end, segment.center, segment.prx, segment.pry)
    x_axis, y_axis = px - center, py - center
    rx, ry = float(np.hypot(*x_axis)), float(np.hypot(*y_axis))
    if rx == 0 or ry == 0:
        return Edge.polyline([start, end]) if np.any(start != end) else None
    axes = np.column_stack([x_axis, y_axis])
    if not np.any(start != end):
        turn = float(segment.sweep)
        first = np.linalg.solve(axes, start - center)
        begin = float(np.arctan2(first[1], first[0]))
        return Edge.arc(center, x_axis, y_axis, begin, begin + turn) if abs(turn) > 1e-9 else None
    # in units of the axes: the centre lies on the perpendicular bisector of the chord of a unit circle
    half = np.linalg.solve(axes, (end - start) / 2)
    reach = float(np.hypot(*half))
    rest = 1 - reach**2
    along = np.sqrt(rest) / reach if rest > 1e-12 else 0.0
    sweep = float(segment.sweep)
    side = along if (abs(sweep) < np.pi) == (sweep > 0) else -along
    middle = side * np.array([-half[1], half[0]])
    if along == 0.0:
        axes = axes * reach
        half = half / reach
    begin = np.arctan2(*(-half - middle)[::-1])
    turn = np.arctan2(*(half - middle)[::-1]) - begin
    turn = turn % (2 * np.pi) if sweep > 0 else -((-turn) % (2 * np.pi))
    center = (start + end) / 2 + axes @ middle
    return Edge.arc(center, axes[:, 0], axes[:, 1], float(begin), float(begin + turn))
