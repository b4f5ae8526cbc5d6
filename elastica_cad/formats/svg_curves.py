"""Reader of curves in SVG files. Bezier curves and arcs are read without approximation."""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from io import BytesIO
from pathlib import Path
from typing import Any, NamedTuple
from xml.etree import ElementTree

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._units import MILLIMETRES, MM_PER_INCH, look_up_unit
from elastica_cad.errors import InputError, missing_library, quoted
from elastica_cad.formats.drawn_file import DrawnFile, ReadUnit, collect_curves
from elastica_cad.formats.edges import Edge, Run, Source
from elastica_cad.formats.source_file import MOST_EDGES, NUMBER, UNIT, check_count
from elastica_cad.formats.svg_path_data import PathData, arc_between, bezier_edge, path_data
from elastica_cad.formats.svg_tree import CLIPPED, CLONE, MARK, PHYSICAL, Box, SvgTree, read_length, svg_tree
from elastica_cad.geometry.measured_points import Provenance
from elastica_cad.refusals import Length, Listed, note

_PX, _PT = MILLIMETRES["px"], MILLIMETRES["pt"]
_INKSCAPE = "{http://www.inkscape.org/namespaces/inkscape}version"
_AFFINITY = "xmlns:serif"
_ILLUSTRATOR = "Generator: Adobe Illustrator"
# pattern for classes in files that Illustrator exports for screens
_EXPORTED_CLASS = re.compile(r"cls-\d+")
_ZERO = re.compile(r"\s*[+]?(0*\.?0+|0+\.)(e[-+]?\d+)?\s*(%|[a-z]*)\s*", re.IGNORECASE)
_TRANSPARENT = re.compile(
    r"(rgb|hsl)a?\(([^,]*,){3}\s*0*\.?0*%?\s*\)|(rgb|hsl)a?\([^,]*/\s*0*\.?0*%?\s*\)|#[0-9a-f]{6}00|#[0-9a-f]{3}0"
)
"""Pattern for colours with opacity 0."""

# least size of a user unit, mm
_LEAST_UNIT = 1e-9
# limit of numbers, far below the overflow of their products
_LARGEST = 1e15


def read_svg_drawing(
    file: Path, *, tolerance: float, fit_tolerance: float, unit: str | None, corners: bool = True
) -> DrawnFile:
    """Read the curves of an SVG file with their names and layers, in mm; the arguments are those of `read_drawing`.

    The y axis points up, so y is minus SVG's y. Bezier curves and arcs are read exactly, with all transforms
    applied. A path of straight lines only is fitted. The size of a user unit follows from width, height and
    viewBox. Without a width in a physical unit, a user unit is a CSS pixel, 25.4/96 mm. In files of Adobe
    Illustrator it is a point, 25.4/72 mm, and in files of Inkscape before 0.92 it is 25.4/90 mm. The origin is
    the origin of the user units. Text, images, definitions and hidden shapes are only counted.
    """
    tree = svg_tree(file)
    known, pixel = (ReadUnit.requested(unit), _PX) if unit else _program(tree)
    scale = np.full(2, look_up_unit(unit)) if unit else _scale(tree) * pixel / _PX
    if not (np.all(scale >= _LEAST_UNIT) and np.all(scale <= 1 / _LEAST_UNIT)):
        raise InputError(
            "a drawing unit is {wide} wide and {high} high, which is unlikely: check width, height and "
            "viewBox of the SVG element",
            wide=Length(scale[0]),
            high=Length(scale[1]),
        )
    to_mm = np.diag(scale * (1.0, -1.0))
    place = np.diag([1 / scale[0], -1 / scale[1], 1.0])
    shapes = _Shapes(tree)
    drawn = collect_curves(
        file, _runs(file, shapes, to_mm), tree.skipped, tolerance=tolerance, fit_tolerance=fit_tolerance,
        nothing="has no curve: draw a path, line, polyline, circle, ellipse or rectangle that is shown",
        corners=corners, shown=Provenance(place=place, unit="mm" if np.all(scale == 1) else "user units"),
    )  # fmt: skip
    return replace(drawn, unit=known, remarks=(*drawn.remarks, *shapes.remarks()))


_IN_POINTS = (
    "its units are read as points (72 to the inch), because Adobe Illustrator writes points but calls them "
    "px. If an inch has 96 units, set {field} to px"
)


_OF_AFFINITY = (
    "its pixels are read as 96 to the inch, but Affinity uses the DPI of its document (Document Setup). If "
    "the document has other DPI, set 96 and export again. For 72 DPI, setting {field} to pt is enough"
)

_WITHOUT_UNIT = (
    "its size has no unit, so its pixels are read as 96 to the inch, as in browsers; if its numbers are "
    "millimetres, set {field} to mm"
)

_OF_OTHER_UNIT = (
    "its size, {size}, is not in a unit of length. Its pixels are read as 96 to the inch, and a font as 16 "
    "pixels high, as in browsers. If its numbers are millimetres, set {field} to mm"
)

_OF_INKSCAPE = (
    "its pixels are read as 90 to the inch, as in Inkscape before 0.92; if that is wrong, set {field} to px"
)


def _program(tree: SvgTree) -> tuple[ReadUnit, float]:
    """Return the unit of the file, and the size of a pixel, mm, in the program that wrote the file.

    Illustrator and Affinity may omit a size in a physical unit. Inkscape before 0.92 may also omit the
    viewBox.
    """
    sizes = [(text, read_length(text)) for text in tree.size if text]
    sized = any(length and length[1] in PHYSICAL for _, length in sizes)
    other = next((text for text, _ in sizes if re.search(r"\d\s*(?!px)[a-z]+\s*$", text.lower())), "")
    if not sized and (_ILLUSTRATOR in tree.head or _is_exported_for_screens(tree)):
        return ReadUnit("pt", "guessed", note=note(_IN_POINTS, field=UNIT)), _PT
    if _AFFINITY in tree.head and not sized:
        return ReadUnit("px", "guessed", note=note(_OF_AFFINITY, field=UNIT)), _PX
    version = re.match(r"0\.(\d+)", tree.root.get(_INKSCAPE, ""))
    if version and int(version[1][:2]) < 92 and not (sized and tree.root.get("viewBox")):
        return ReadUnit("px", "guessed", note=note(_OF_INKSCAPE, field=UNIT)), MM_PER_INCH / 90
    if sized:
        name = next(length[1] for _, length in sizes if length and length[1] in PHYSICAL)
        return ReadUnit(name, "stated", "width and height"), _PX
    if tree.root.get(_INKSCAPE) and not other:
        return ReadUnit("px", "guessed"), _PX
    doubt = note(_OF_OTHER_UNIT, size=quoted(other), field=UNIT) if other else note(_WITHOUT_UNIT, field=UNIT)
    return ReadUnit("px", note=doubt), _PX


def _is_exported_for_screens(tree: SvgTree) -> bool:
    """Return True if the file was written by Illustrator's Export As.

    Such a file does not contain the name of Illustrator. Files of Adobe XD are similar, but have a size.
    """
    if any(tree.size):
        return "data-name" in tree.root.attrib
    return any(
        "data-name" in element.attrib or _EXPORTED_CLASS.fullmatch(element.get("class", ""))
        for element in tree.root.iter()
    )


def _scale(tree: SvgTree) -> FloatArray:
    size = [read_length(text) for text in tree.size]
    box = [float(v) for v in re.findall(NUMBER, tree.root.get("viewBox", ""))]
    if len(box) != 4 or not np.all(np.isfinite(box)) or box[2] <= 0 or box[3] <= 0:
        return np.full(2, _PX)
    known = [length[0] / extent for length, extent in zip(size, box[2:], strict=True) if length and length[0]]
    if not known:
        return np.full(2, _PX)
    aspect = tree.root.get("preserveAspectRatio", "")
    if len(known) == 2 and "none" in aspect:
        return np.array(known)
    return np.full(2, max(known) if "slice" in aspect else min(known))


def _runs(path: Path, shapes: "_Shapes", to_mm: FloatArray) -> Iterator[Run]:
    try:
        from svgelements import SVG, Shape
    except ImportError as error:
        raise missing_library(f"reading {path.name} needs svgelements", "svgelements") from error
    count = 0
    try:
        drawing = SVG.parse(BytesIO(_in_user_units(shapes.tree)), reify=False, on_error="raise")
        for shape in shapes.painted(
            [element for element in drawing.elements() if isinstance(element, Shape)]
        ):
            drawn = shapes.read(shape)
            if drawn is None:
                continue
            matrix = to_mm @ drawn.matrix
            source = replace(drawn.source, rounding=drawn.source.rounding * float(np.linalg.norm(matrix, 2)))
            for run in drawn.runs:
                count = check_count(count + len(run), MOST_EDGES, "pieces", "leave out what is no strip")
                yield tuple(edge.mapped(matrix, to_mm @ drawn.offset, source) for edge in run)
    except InputError:
        raise
    except (
        ValueError,
        TypeError,
        IndexError,
        KeyError,
        AttributeError,
        RecursionError,
        OverflowError,
    ) as error:
        raise InputError(
            "has incomplete or invalid path data or attributes: export the file again"
        ) from error
    shapes.report_left_out()


class _DrawnShape(NamedTuple):
    runs: Sequence[Run]
    source: Source
    matrix: FloatArray
    offset: FloatArray


class _Shapes:
    """Reader of the shapes of an SVG tree. It parses a path once for all clones, and counts skipped shapes.

    Attributes
    ----------
    drawn : set of int
        Indices of visible shapes.
    unpainted : set of int
        Indices of shapes without stroke and fill.
    clipped : dict
        Names of shapes, as ordered keys, that a clip path or mask may hide in part.
    bad : dict
        Errors of shapes that cannot be read, by index.
    """

    def __init__(self, tree: SvgTree) -> None:
        self.tree = tree
        self.drawn: set[int] = set()
        self.bad: dict[int, InputError] = {}
        self.unpainted: set[int] = set()
        self.clipped: dict[str, None] = {}
        self._paths: dict[int, PathData] = {}

    def painted(self, shapes: Sequence[Any]) -> Sequence[Any]:
        shown = [shape for shape in shapes if not _is_hidden(shape)]
        visible = [shape for shape in shown if any(_is_painted(shape.values, what) for what in _PAINTS)]
        if visible:
            self.unpainted = {int(shape.values[MARK]) for shape in shown} - {
                int(shape.values[MARK]) for shape in visible
            }
        return visible or shapes

    def read(self, shape: Any) -> _DrawnShape | None:
        mark = int(shape.values[MARK])
        m = shape.transform
        matrix, offset = np.array([[m.a, m.c], [m.b, m.d]], dtype=float), np.array([m.e, m.f], dtype=float)
        if _is_hidden(shape) or not matrix.any():
            return None
        self.drawn.add(mark)
        if mark in self.bad:
            return None
        try:
            if not (np.all(np.abs(matrix) < _LARGEST) and np.all(np.abs(offset) < _LARGEST)):
                raise InputError(
                    "has a transform with numbers that are not finite or too large: export the file again"
                )
            runs, rounding = self._edges(mark, shape)
        except InputError as error:
            self.bad[mark] = error
            return None
        clone = next((int(value) for name, value in shape.values.items() if name.startswith(CLONE)), None)
        drawn = self.tree.shapes[mark]
        names = [drawn.name] if clone is None else [self.tree.clones[clone], drawn.name]
        source = Source(
            "/".join(name.shown for name in names if name.shown),
            drawn.layer,
            rounding,
            "/".join(name.id for name in names if name.id),
            is_named=any(name.is_chosen for name in names),
        )
        if CLIPPED in shape.values or any(_may_be_clipped(runs, *clip) for clip in drawn.clips):
            self.clipped[source.name or drawn.kind] = None
        return _DrawnShape(runs, source, matrix, offset)

    def _edges(self, mark: int, shape: Any) -> tuple[list[Run], float]:
        source = self.tree.shapes[mark]
        if source.data is None:
            return list(_subpaths(shape.segments(transformed=False))), source.rounding
        if mark not in self._paths:
            self._paths[mark] = path_data(source.data)
        path = self._paths[mark]
        return [_with_polylines(run) for run in path.runs], path.rounding

    def report_left_out(self) -> None:
        shapes, skipped = self.tree.shapes, self.tree.skipped
        hidden = {mark for mark, shape in enumerate(shapes) if shape.shown} - self.drawn - self.unpainted
        for kind, marks in (
            ("hidden or empty shape", hidden),
            ("shape without stroke and fill", self.unpainted),
        ):
            if marks:
                skipped[kind] += len(marks)
        if self.bad and len(self.bad) == len(self.drawn):
            raise next(iter(self.bad.values()))
        for mark, problem in self.bad.items():
            name = f" {shapes[mark].name.shown}" if shapes[mark].name.shown else ""
            skipped[f"{shapes[mark].kind}{name} that {problem}"] += 1

    def remarks(self) -> tuple[str, ...]:
        clipped = [note(
            "clipped or masked in the drawing, but read whole: {shapes}. Release the clip to see the whole "
            "curve, or cut the path where the curve ends",
            shapes=Listed(self.clipped),
        )] if self.clipped else []  # fmt: skip
        unread = [note(
            "the drawing uses styles that are not supported: {styles}. Compare the curves with the drawing",
            styles=Listed(dict.fromkeys(self.tree.unread)),
        )] if self.tree.unread else []  # fmt: skip
        return (*clipped, *unread)


_PAINTS = ("stroke", "fill")


def _is_hidden(shape: Any) -> bool:
    return shape.values.get("visibility", "").strip().lower() in ("hidden", "collapse")


def _is_painted(values: Mapping[str, str], what: str) -> bool:
    paint = values[what].strip().lower()
    clear = paint in ("none", "transparent") or _TRANSPARENT.fullmatch(paint)
    sizes = [values.get(f"{what}-opacity"), values.get("stroke-width") if what == "stroke" else None]
    return not (clear or any(size and _ZERO.fullmatch(size) for size in sizes))


def _may_be_clipped(runs: Sequence[Run], box: Box | None, transform: str) -> bool:
    from svgelements import Matrix

    if box is None:
        return True
    m = Matrix(transform)
    points = np.concatenate([edge.at(edge.stations()) for run in runs for edge in run] or [np.empty((0, 2))])
    mapped = points @ np.array([[m.a, m.b], [m.c, m.d]], dtype=float) + np.array([m.e, m.f], dtype=float)
    near = 1e-6 * max(box[2] - box[0], box[3] - box[1])
    return bool(np.any(mapped < np.array(box[:2]) - near) or np.any(mapped > np.array(box[2:]) + near))


def _in_user_units(tree: SvgTree) -> bytes:
    """Return the document without viewBox, so that the parser does not scale coordinates."""
    root = tree.root
    box = root.get("viewBox", "").replace(",", " ").split()
    lengths = [read_length(text) for text in tree.size]
    size = box[2:] if len(box) == 4 else [repr(length[0] / _PX) if length else "100%" for length in lengths]
    for name in ("viewBox", "preserveAspectRatio", "x", "y"):
        root.attrib.pop(name, None)
    root.set("width", size[0])
    root.set("height", size[1])
    return bytes(ElementTree.tostring(root, encoding="utf-8"))


def _subpaths(segments: Any) -> Iterator[Run]:
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


def _with_polylines(run: Sequence[Edge]) -> Run:
    if len(run) > 1 and all(edge.degree == 1 for edge in run):
        return (Edge.polyline(np.concatenate([run[0].points[:1], *(edge.points[1:] for edge in run)])),)
    return tuple(run)


def _edge(kind: str, segment: Any) -> Edge | None:
    if kind not in ("Line", "Close"):
        return _arc(segment)
    ends = _points(segment.start, segment.end)
    # svgelements rounds the end of an ellipse, so the line that closes it has a length
    rounded = kind == "Close" and np.ptp(ends, axis=0).max() <= 1e-12 * np.abs(ends).max()
    return None if rounded else bezier_edge(ends)


def _points(*points: Any) -> FloatArray:
    places = np.array([(p.x, p.y) for p in points], dtype=float)
    if not np.all(np.abs(places) < _LARGEST):
        raise InputError("has numbers that are not finite or too large: check the size of the drawing")
    return places


def _arc(segment: Any) -> Edge | None:
    """Return the exact arc of a segment.

    The centre that svgelements computes for half turns is inaccurate.
    """
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
    sweep = float(segment.sweep)
    return arc_between(start, end, axes, large=abs(sweep) >= np.pi, sweep=sweep > 0)
