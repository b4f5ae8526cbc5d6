"""Reader of curves in SVG files: Bezier curves and arcs unchanged, and the unit, stated or guessed."""

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cache
from itertools import chain
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._units import MILLIMETRES, MM_PER_INCH, look_up_unit
from elastica_cad.errors import InputError, Length, Listed, note, quoted
from elastica_cad.formats.drawn_file import DrawnFile, ReadUnit, collect_curves
from elastica_cad.formats.edges import Edge, Run, Source, sample_run
from elastica_cad.formats.source_file import MOST_EDGES, NUMBER, UNIT, check_count, half_last_place
from elastica_cad.formats.svg_path_data import path_data
from elastica_cad.formats.svg_shapes import Box, Name, Shape, SvgShapes, view_box
from elastica_cad.formats.svg_tree import PHYSICAL, SvgTree, read_length, svg_tree, tag
from elastica_cad.geometry.measured_points import Provenance

_PX, _PT = MILLIMETRES["px"], MILLIMETRES["pt"]
_INKSCAPE = "{http://www.inkscape.org/namespaces/inkscape}version"
# pattern for classes in files that Illustrator exports for screens
_EXPORTED_CLASS = re.compile(r"cls-\d+")
_ZERO = re.compile(r"\s*[+]?(0*\.?0+|0+\.)(e[-+]?\d+)?\s*(%|[a-z]*)\s*", re.IGNORECASE)
_TRANSPARENT = re.compile(
    r"(rgb|hsl)a?\(([^,]*,){3}\s*0*\.?0*%?\s*\)|(rgb|hsl)a?\([^,]*/\s*0*\.?0*%?\s*\)|#[0-9a-f]{6}00|#[0-9a-f]{3}0"
)
"""Pattern for colours with opacity 0."""

# least size of a user unit, mm
_LEAST_UNIT = 1e-9
# condition number of a transform above which a shape is flat
_FLAT = 1e12


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
    reader = _Reader(SvgShapes(tree))
    drawn = collect_curves(
        file, reader.runs(to_mm), reader.skipped, tolerance=tolerance, fit_tolerance=fit_tolerance,
        nothing="has no curve: draw a path, line, polyline, circle, ellipse or rectangle that is shown",
        corners=corners, shown=Provenance(place=place, unit="mm" if np.all(scale == 1) else "user units"),
    )  # fmt: skip
    return replace(drawn, unit=known, remarks=(*drawn.remarks, *reader.remarks()))


def _program(tree: SvgTree) -> tuple[ReadUnit, float]:
    """Return the unit of the file, and the size of a pixel, mm, in the program that wrote the file.

    Illustrator and Affinity may omit a size in a physical unit. Inkscape before 0.92 may also omit the
    viewBox.
    """
    sizes = [(text, read_length(text)) for text in _size(tree) if text]
    sized = [length[1] for _, length in sizes if length and length[1] in PHYSICAL]
    other = next((text for text, _ in sizes if re.search(r"\d\s*(?!px)[a-z]+\s*$", text.lower())), "")
    if not sized and ("Generator: Adobe Illustrator" in tree.head or _is_exported_for_screens(tree)):
        doubt = note(
            "its units are read as points (72 to the inch), because Adobe Illustrator writes points but calls them "
            "px. If an inch has 96 units, set {field} to px",
            field=UNIT,
        )
        return ReadUnit("pt", "guessed", note=doubt), _PT
    if "xmlns:serif" in tree.head and not sized:
        doubt = note(
            "its pixels are read as 96 to the inch, but Affinity uses the DPI of its document (Document Setup). If "
            "the document has other DPI, set 96 and export again. For 72 DPI, setting {field} to pt is enough",
            field=UNIT,
        )
        return ReadUnit("px", "guessed", note=doubt), _PX
    version = re.match(r"0\.(\d+)", tree.root.get(_INKSCAPE, ""))
    if version and int(version[1][:2]) < 92 and not (sized and tree.root.get("viewBox")):
        doubt = note(
            "its pixels are read as 90 to the inch, as in Inkscape before 0.92; if that is wrong, set {field} to "
            "px",
            field=UNIT,
        )
        return ReadUnit("px", "guessed", note=doubt), MM_PER_INCH / 90
    if sized:
        return ReadUnit(sized[0], "stated", "width and height"), _PX
    if tree.root.get(_INKSCAPE) and not other:
        return ReadUnit("px", "guessed"), _PX
    doubt = note(
        "its size, {size}, is not in a unit of length. Its pixels are read as 96 to the inch, and a font as 16 "
        "pixels high, as in browsers. If its numbers are millimetres, set {field} to mm",
        size=quoted(other), field=UNIT,
    ) if other else note(
        "its size has no unit, so its pixels are read as 96 to the inch, as in browsers; if its numbers are "
        "millimetres, set {field} to mm",
        field=UNIT,
    )  # fmt: skip
    return ReadUnit("px", note=doubt), _PX


def _is_exported_for_screens(tree: SvgTree) -> bool:
    """Return True if the file was written by Illustrator's Export As.

    Such a file does not contain the name of Illustrator. Files of Adobe XD are similar, but have a size.
    """
    if any(_size(tree)):
        return "data-name" in tree.root.attrib
    return any(
        "data-name" in element.attrib or _EXPORTED_CLASS.fullmatch(element.get("class", ""))
        for element in tree.root.iter()
    )


def _size(tree: SvgTree) -> tuple[str, str]:
    return tree.root.get("width", ""), tree.root.get("height", "")


def _scale(tree: SvgTree) -> FloatArray:
    """Return the size, mm, of a user unit along x and y, computed from width, height and viewBox."""
    box = view_box(tree.root)
    lengths = zip(map(read_length, _size(tree)), box[2:] if box else (), strict=False)
    known = [length[0] / extent for length, extent in lengths if length and length[0]]
    if not known:
        return np.full(2, _PX)
    aspect = tree.root.get("preserveAspectRatio", "")
    if len(known) == 2 and "none" in aspect:
        return np.array(known)
    # the drawing covers its size with "slice", and fits into its size by default
    return np.full(2, max(known) if "slice" in aspect else min(known))


# attributes of shapes that hold numbers
_NUMBERS = ("x", "y", "x1", "y1", "x2", "y2", "cx", "cy", "r", "rx", "ry", "width", "height", "points")


class _Reader:
    """Reader of the edges of shapes. It parses a path once for all clones, and counts skipped shapes.

    Attributes
    ----------
    skipped : Counter
        Number of skipped items of each kind.
    drawn : set of Element
        Visible shapes.
    clipped : dict
        Names of shapes, as ordered keys, that a viewport, clip path or mask may hide in part.
    bad : dict
        Errors of shapes that cannot be read.
    """

    def __init__(self, shapes: SvgShapes) -> None:
        self.shapes = shapes
        self.skipped = Counter(shapes.left_out.values())
        self.drawn: set[Element] = set()
        self.bad: dict[Element, InputError] = {}
        self.clipped: dict[str, None] = {}
        self._edges = cache(_edges)

    def runs(self, to_mm: FloatArray) -> Iterator[Run]:
        """Yield the edges of all visible shapes, mm, and count the other shapes."""
        shown = [
            shape
            for shape in self.shapes.displayed
            if shape.context.values["visibility"].strip().lower() not in ("hidden", "collapse")
        ]
        painted = [shape for shape in shown if _is_painted(shape.context.values)] or shown
        count = 0
        for shape in painted:
            for run in self._read(shape, to_mm):
                count = check_count(count + len(run), MOST_EDGES, "pieces", "leave out what is no strip")
                yield run
        unpainted = {shape.element for shape in shown} - {shape.element for shape in painted}
        hidden = self.shapes.elements - self.drawn - unpainted
        counts = {"hidden or empty shape": len(hidden), "shape without stroke and fill": len(unpainted)}
        # adding drops counts of 0
        self.skipped += Counter(counts)
        if self.bad and len(self.bad) == len(self.drawn):
            raise next(iter(self.bad.values()))
        for element, problem in self.bad.items():
            name = f" {title}" if (title := Name.of(element).shown) else ""
            self.skipped[f"{tag(element)}{name} that {problem}"] += 1

    def _read(self, shape: Shape, to_mm: FloatArray) -> Iterator[Run]:
        """Yield the runs of a shape, mm. A shape that cannot be read is noted in `bad`."""
        element, _, context = shape
        # products of larger numbers may overflow
        is_finite = bool(np.all(np.abs(context.matrix) < 1e15))
        # a shape that is flattened to a line or a point is not displayed
        if element in self.bad or (is_finite and np.linalg.cond(context.matrix[:2, :2]) > _FLAT):
            return
        self.drawn.add(element)
        try:
            if not is_finite:
                raise InputError(
                    "has a transform with numbers that are not finite or too large: export the file again"
                )
            runs, rounding = self._edges(shape.data)
        except InputError as error:
            self.bad[element] = error
            return
        if tag(element) != "path":
            written = [text for name in _NUMBERS if "%" not in (text := element.get(name, ""))]
            rounding = half_last_place(re.findall(NUMBER, " ".join(written)))
        names = [name for name in (context.clone, Name.of(element)) if name]
        matrix = to_mm @ context.matrix[:2]
        source = Source(
            "/".join(name.shown for name in names if name.shown),
            context.layer,
            rounding * float(np.linalg.norm(matrix[:, :2], 2)),
            "/".join(name.id for name in names if name.id),
            is_named=any(name.is_chosen for name in names),
        )
        if runs and any(_may_be_clipped(runs, *clip) for clip in context.clips):
            self.clipped[source.name or tag(element)] = None
        for run in runs:
            yield tuple(edge.mapped(matrix[:, :2], matrix[:, 2], source) for edge in run)

    def remarks(self) -> tuple[str, ...]:
        clipped = [note(
            "clipped or masked in the drawing, but read whole: {shapes}. Release the clip to see the whole "
            "curve, or cut the path where the curve ends",
            shapes=Listed(self.clipped),
        )] if self.clipped else []  # fmt: skip
        unread = [note(
            "the drawing uses styles that are not supported: {styles}. Compare the curves with the drawing",
            styles=Listed(dict.fromkeys(self.shapes.unread)),
        )] if self.shapes.unread else []  # fmt: skip
        return (*clipped, *unread)


def _is_painted(values: Mapping[str, str]) -> bool:
    """Return True if a shape has a visible stroke or fill."""
    for what in ("stroke", "fill"):
        paint = values[what].strip().lower()
        is_clear = paint in ("none", "transparent") or _TRANSPARENT.fullmatch(paint)
        sizes = values[f"{what}-opacity"], values["stroke-width"] if what == "stroke" else "1"
        if not (is_clear or any(map(_ZERO.fullmatch, sizes))):
            return True
    return False


def _may_be_clipped(runs: Sequence[Run], box: Box | None, matrix: FloatArray) -> bool:
    """Return True if a part may be outside the clipping box, or if the shape of the clip is unknown (None)."""
    if box is None:
        return True
    points = sample_run(chain.from_iterable(runs))
    mapped = points @ matrix[:2, :2].T + matrix[:2, 2]
    near = 1e-6 * max(box[2] - box[0], box[3] - box[1])
    return bool(np.any(mapped < np.array(box[:2]) - near) or np.any(mapped > np.array(box[2:]) + near))


def _edges(data: str) -> tuple[list[Run], float]:
    """Return the edges of path data in user units, and half a unit of the last digit."""
    if re.search("inf|nan", data):
        raise InputError("has numbers that are not finite or too large: check the size of the drawing")
    path = path_data(data)
    return [_with_polylines(run) for run in path.runs], path.rounding


def _with_polylines(run: Sequence[Edge]) -> Run:
    if len(run) > 1 and all(edge.degree == 1 for edge in run):
        return (Edge.polyline(np.concatenate([run[0].points[:1], *(edge.points[1:] for edge in run)])),)
    return tuple(run)
