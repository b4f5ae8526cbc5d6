"""Drawings on named layers: kerf compensation, bridges, and a file for each part, as cutting services want it."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from typing import Annotated

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._notebook import BLUE, GREY, INK, RED, svg_of_lines
from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import is_number, require_number, require_record, several
from elastica_cad.declared import Option, require_declared
from elastica_cad.errors import InputError
from elastica_cad.errors import Length as Mm
from elastica_cad.geometry.offset import offset_path
from elastica_cad.geometry.path import Path, Segment, Spline, distances, trim_segment
from elastica_cad.geometry.path_intersections import encloses, polylines_cross
from elastica_cad.geometry.plane_points import (
    box_around,
    is_similarity,
    near_pairs,
    norm,
    place,
    require_affine,
    similarity_of,
    transform_points,
    turn_between,
)
from elastica_cad.mechanics.sheets import require_name
from elastica_cad.strip.lettering import Text, text_strokes

CUT_OUTER = "CUT_OUTER"
CUT_INNER = "CUT_INNER"
ENGRAVE = "ENGRAVE"
MARK = "MARK"
SHEET = "SHEET"

LAYERS = (SHEET, ENGRAVE, MARK, CUT_INNER, CUT_OUTER)
"""All layers in the order of machining. Outlines are cut last, because this releases the parts. SHEET has
only the border of the sheet, which is not cut."""

SAME_MM = 1e-6
"""Distance, mm, below which two paths are duplicates, because files store six decimals."""

LAYER_INK = {CUT_OUTER: RED, CUT_INNER: BLUE, ENGRAVE: INK, MARK: GREY, SHEET: GREY}


@dataclass(frozen=True, eq=False)
class LayeredPath:
    """A path and the name of its layer, one of `LAYERS`."""

    layer: str
    path: Path

    def __post_init__(self) -> None:
        _check_layer(self.layer)
        require_record(self.path, Path, "the path on a layer", "a Path")


def cut_paths(outline: Path, holes: Iterable[Path], marks: Iterable[Path] = ()) -> tuple[LayeredPath, ...]:
    """Return the marks, holes and outline of a part on their layers, in the order of cutting."""
    return (
        *(LayeredPath(MARK, mark) for mark in marks),
        *(LayeredPath(CUT_INNER, hole) for hole in holes),
        LayeredPath(CUT_OUTER, outline),
    )


@dataclass(frozen=True, eq=False)
class Drawing:
    """A flat drawing, mm.

    Parameters
    ----------
    name : str
        Name of the contents, for titles and file names.
    paths : sequence of LayeredPath
    texts : sequence of Text

    Examples
    --------
    >>> plate = Drawing("plate", [LayeredPath(CUT_OUTER, Path.rectangle(40, 10))])
    >>> plate.bounds.tolist()
    [[0.0, 0.0], [40.0, 10.0]]
    """

    name: str
    paths: tuple[LayeredPath, ...] = ()
    texts: tuple[Text, ...] = ()

    def __post_init__(self) -> None:
        vars(self).update(
            paths=several("paths", self.paths, LayeredPath, "LayeredPath"),
            texts=several("texts", self.texts, Text, "Text"),
            name=require_name(self.name, "the drawing's name"),
        )
        for text in self.texts:
            _check_layer(text.layer)

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.name!r}, {len(self.paths)} paths, {len(self.texts)} texts>"

    def _repr_svg_(self) -> str:
        low, high = self.bounds
        chord = float(norm(high - low)) * 1e-4
        lines = [(item.path.points(chord), LAYER_INK[item.layer], item.path.closed) for item in self.strokes]
        return svg_of_lines(lines, repr(self))

    @cached_property
    def strokes(self) -> tuple[LayeredPath, ...]:
        """All paths in the order of machining (`LAYERS`), including the strokes of texts, without duplicates."""
        written = [LayeredPath(text.layer, stroke) for text in self.texts for stroke in text_strokes(text)]
        everything = [*written, *self.paths]
        return _without_duplicates([item for layer in LAYERS for item in everything if item.layer == layer])

    @property
    def layers(self) -> tuple[str, ...]:
        """Layers of a file; SHEET is included only if the drawing has paths on it."""
        return LAYERS if self.on(SHEET) else tuple(layer for layer in LAYERS if layer != SHEET)

    @cached_property
    def bounds(self) -> FloatArray:
        """Bounding box [[x_min, y_min], [x_max, y_max]], mm."""
        if not self.strokes:
            raise InputError(f"the drawing {self.name!r} has neither paths nor texts: add a path")
        return box_around(np.array([item.path.bounds for item in self.strokes]))

    def on(self, *layers: str) -> tuple[Path, ...]:
        """Return the paths (without texts) on the named layers."""
        for layer in layers:
            _check_layer(layer)
        return tuple(item.path for item in self.paths if item.layer in layers)

    def only(self, *layers: str) -> "Drawing":
        """Return the drawing with only the paths and texts on the named layers."""
        texts = tuple(text for text in self.texts if text.layer in layers)
        return Drawing(self.name, tuple(item for item in self.paths if item.layer in layers), texts)

    def transformed(self, matrix: ArrayLike) -> "Drawing":
        """Return the drawing transformed by a 3x3 affine matrix.

        Texts that would be mirrored or skewed are replaced by paths.
        """
        m = require_affine(matrix)
        paths = [LayeredPath(item.layer, item.path.transformed(m)) for item in self.paths]
        if is_similarity(m) and np.linalg.det(m[:2, :2]) > 0:
            scale, turn, _ = similarity_of(m)
            texts = []
            for text in self.texts:
                x, y = transform_points(m, text.position)
                texts.append(
                    Text((float(x), float(y)), text.text, text.height * scale, text.angle + turn, text.layer)
                )
            return Drawing(self.name, tuple(paths), tuple(texts))
        for text in self.texts:
            paths.extend(LayeredPath(text.layer, stroke.transformed(m)) for stroke in text_strokes(text))
        return Drawing(self.name, tuple(paths))

    @classmethod
    def merged(cls, name: str, drawings: Iterable["Drawing"]) -> "Drawing":
        """Return one drawing with the paths and texts of all drawings."""
        parts = several("drawings", drawings, Drawing, "Drawing")
        return cls(name, tuple(p for d in parts for p in d.paths), tuple(t for d in parts for t in d.texts))


def _check_layer(layer: str) -> None:
    if not isinstance(layer, str) or layer not in LAYERS:
        raise InputError(f"there is no layer {layer!r}: use one of {', '.join(LAYERS)}")


def _without_duplicates(items: list[LayeredPath]) -> tuple[LayeredPath, ...]:
    """Return the items without a second cut or engraving of the same path, as parts with a common edge have."""
    if not items:
        return ()
    boxes = np.array([item.path.bounds for item in items]).reshape(-1, 4)
    # if no coordinate differs by more than SAME_MM, two boxes (4 coordinates) are at most sqrt(4) SAME_MM
    # apart
    alike = np.transpose(near_pairs(boxes, boxes, 2 * SAME_MM))
    dropped: set[int] = set()
    for i, j in sorted(alike.tolist()):
        if i < j and not {i, j} & dropped and _twins(items[i], items[j]):
            dropped.add(j)
    return tuple(item for i, item in enumerate(items) if i not in dropped)


def _twins(a: LayeredPath, b: LayeredPath) -> bool:
    """Return True if two paths have the same purpose and, at samples, the same place."""
    cut = (CUT_INNER, CUT_OUTER)
    if a.layer != b.layer and not (a.layer in cut and b.layer in cut):
        return False
    if abs(a.path.length - b.path.length) > 10 * SAME_MM:
        return False
    samples = np.concatenate([s.at(np.array([0.0, 0.3, 0.7, 1.0])) for s in b.path.segments])
    near = np.min([distances(segment, samples) for segment in a.path.segments], axis=0)
    return bool(near.max() <= SAME_MM)


FINEST_KERF_MM, COARSEST_KERF_MM = 1e-5, 10.0
"""Least and largest value, mm, of the argument `tolerance` of `compensate_kerf`; the kerf may be any size up to
`WIDEST_KERF_MM`."""

WIDEST_KERF_MM = 15.0
"""Largest kerf, mm. A half-inch router bit is 12.7 mm wide."""


def compensate_kerf(drawing: Drawing, kerf: float, *, tolerance: float = 1e-4) -> Drawing:
    """Return the drawing with its cuts offset by half the kerf, so that the parts have their drawn sizes.

    Closed loops on CUT_OUTER are offset outward, and closed loops on CUT_INNER inward. A negative kerf reverses
    both directions. Open cuts, engraving and marks are unchanged.

    Parameters
    ----------
    drawing : Drawing
    kerf : float
        Width of the cut, mm.
    tolerance : float
        Largest error of an offset spline, mm; lines and arcs are exact.

    Examples
    --------
    >>> plate = Drawing("plate", [LayeredPath(CUT_OUTER, Path.circle((0, 0), 10))])
    >>> compensate_kerf(plate, 0.2).paths[0].path.segments[0].radius
    10.1
    """
    require_number(kerf, "the kerf", "mm")
    require_record(drawing, Drawing, "what is cut", "a Drawing record")
    if abs(kerf) > WIDEST_KERF_MM:
        raise InputError(
            "the kerf is {kerf:g}, wider than the cut of any tool: set the width of the cut in mm, such as "
            "0.15 for a laser",
            kerf=Mm(kerf),
        )
    if kerf == 0:
        return drawing
    if not (is_number(tolerance) and FINEST_KERF_MM <= tolerance <= COARSEST_KERF_MM):
        raise InputError(
            "the tolerance is {tolerance}: give {finest:g} to {coarsest:g} mm",
            tolerance=tolerance, finest=FINEST_KERF_MM, coarsest=COARSEST_KERF_MM,
        )  # fmt: skip
    return _compensated(drawing, kerf, tolerance)


@lru_cache(maxsize=1)  # the same drawing is written as DXF and then as SVG
def _compensated(drawing: Drawing, kerf: float, tolerance: float) -> Drawing:
    """Return the drawing with its closed cuts moved by half a kerf: outlines outwards, and holes inwards."""
    sides = {CUT_OUTER: kerf / 2, CUT_INNER: -kerf / 2}
    moved = []
    loops = []
    for item in drawing.paths:
        if item.layer in sides and item.path.closed:
            try:
                loops.append(offset_path(item.path, sides[item.layer], tolerance=tolerance))
            except InputError as error:
                raise InputError(
                    "a kerf (width of the cut) of {kerf:g} is too wide for a closed cut on layer {layer}: {error}",
                    kerf=Mm(kerf),
                    layer=item.layer,
                    error=error,
                ) from error
            moved.append(LayeredPath(item.layer, loops[-1]))
        else:
            moved.append(item)
    _refuse_overlaps(loops, kerf, tolerance)
    return Drawing(drawing.name, tuple(moved), drawing.texts)


def _refuse_overlaps(loops: list[Path], kerf: float, tolerance: float) -> None:
    """Refuse compensated closed cuts that meet each other."""
    if len(loops) < 2:
        return
    bounds = np.array([loop.bounds for loop in loops])
    low, high = bounds[:, 0], bounds[:, 1]
    order = low[:, 0].argsort(kind="stable")
    outlines: dict[int, np.ndarray] = {}

    def outline(i: int) -> np.ndarray:
        if i not in outlines:
            outlines[i] = loops[i].closed_points(tolerance)
        return outlines[i]

    for k, i in enumerate(order):
        rest = order[k + 1 :]
        rest = rest[: low[rest, 0].searchsorted(high[i, 0], side="right")]
        for j in rest[(low[rest, 1] <= high[i, 1]) & (high[rest, 1] >= low[i, 1])]:
            crossing = polylines_cross(outline(int(i)), outline(int(j)))
            if crossing is not None:
                raise InputError(
                    "with a kerf (width of the cut) of {kerf:g}, two closed cuts meet at {crossing}: move them "
                    "apart there or use a smaller kerf",
                    kerf=Mm(kerf),
                    crossing=place(crossing),
                )


SAME_PLACE_MM = 1e-9
"""Difference, mm, below which two arc lengths are equal."""


@dataclass(frozen=True)
class HoldingTabs:
    """Sizes of the bridges that hold cut parts in the sheet.

    Parameters
    ----------
    width : float
        Length of a bridge along the cut, mm.
    spacing : float
        Largest distance between two bridges along the cut, mm.
    least : int
        Least number of bridges in each loop.
    inner : bool
        Add bridges to inner cuts longer than `spacing` too.
    """

    width: Annotated[float, Option("Width of a bridge.", "mm", above=0)] = 0.5
    spacing: Annotated[float, Option("Largest distance between two bridges.", "mm", least=1)] = 100.0
    least: Annotated[int, Option("Least number of bridges in each loop.", least=1, most=1000)] = 2
    inner: Annotated[bool, Option("Interrupt inner cuts too.")] = False

    def __post_init__(self) -> None:
        require_declared(HoldingTabs, vars(self), "holding tabs:")


def add_holding_tabs(drawing: Drawing, tabs: HoldingTabs | None = None) -> Drawing:
    """Return the drawing with bridges: its closed outer cuts are divided into open cuts.

    Bridges are spaced evenly and shifted away from corners. Compensate the kerf first, because compensation
    offsets only closed loops.

    Parameters
    ----------
    drawing : Drawing
    tabs : HoldingTabs, optional
        Sizes of the bridges; `HoldingTabs()` by default.

    Examples
    --------
    >>> plate = Drawing("plate", [LayeredPath(CUT_OUTER, Path.rectangle(40, 10))])
    >>> held = add_holding_tabs(plate, HoldingTabs(width=1.0, spacing=60.0))
    >>> [round(item.path.length, 6) for item in held.paths]
    [49.0, 49.0]
    """
    require_record(drawing, Drawing, "what gets holding tabs", "a Drawing")
    tabs = HoldingTabs() if tabs is None else tabs
    require_record(tabs, HoldingTabs, "tabs", "a HoldingTabs record")
    paths: list[LayeredPath] = []
    for item in drawing.paths:
        inner = item.layer == CUT_INNER and tabs.inner and item.path.length > tabs.spacing
        if item.path.closed and (item.layer == CUT_OUTER or inner):
            paths += [LayeredPath(item.layer, piece) for piece in _opened(item.path, tabs)]
        else:
            paths.append(item)
    return Drawing(drawing.name, tuple(paths), drawing.texts)


def separate_parts(drawing: Drawing) -> tuple[Drawing, ...]:
    """Return a drawing of each part, with only its outer cut and the inner cuts inside it.

    Other lines are left out, because cutting services cut every line of a file.

    Parameters
    ----------
    drawing : Drawing

    Examples
    --------
    >>> plates = [Path.rectangle(40, 10), Path.rectangle(40, 10, corner=(0, 20))]
    >>> hole = LayeredPath(CUT_INNER, Path.circle((20, 25), 3))
    >>> parts = separate_parts(Drawing("plates", [*(LayeredPath(CUT_OUTER, one) for one in plates), hole]))
    >>> [(part.name, len(part.paths)) for part in parts]
    [('plates', 1), ('plates-2', 2)]
    """
    cuts = drawing.only(CUT_INNER, CUT_OUTER).strokes
    for item in cuts:
        if not item.path.closed:
            raise InputError(
                "{name}: the cut from {start} is open, but a cutting service cuts only closed outlines and "
                "holes: close the cut or leave it out",
                name=drawing.name,
                start=place(item.path.start),
            )
    holes = [item for item in cuts if item.layer == CUT_INNER]
    outlines = [item for item in cuts if item.layer == CUT_OUTER]
    parts = []
    for number, outline in enumerate(outlines, start=1):
        rim = outline.path.points(0.02)
        inside = holes if len(outlines) == 1 else [path for path in holes if encloses(rim, path.path.start)]
        name = drawing.name if number == 1 else f"{drawing.name}-{number}"
        parts.append(Drawing(name, (*inside, outline)))
    return tuple(parts)


def _opened(path: Path, tabs: HoldingTabs) -> list[Path]:
    """Return the parts of a closed cut between its holding tabs, about equally spaced and clear of corners."""
    ends = np.cumsum([segment.length for segment in path.segments])
    length = float(ends[-1])
    count = max(tabs.least, int(np.ceil(length / tabs.spacing)))
    if length < 4 * count * tabs.width:
        raise InputError(
            "the closed cut at {start} is {length:.4g} long, too short for {count} holding tabs {width:g} "
            "wide: use fewer or narrower tabs",
            start=place(path.start),
            length=Mm(length),
            count=count,
            width=Mm(tabs.width),
        )
    around = zip(path.segments, (*path.segments[1:], path.segments[0]), strict=True)
    turns = [turn_between(before.tangent_at(1.0), after.tangent_at(0.0)) for before, after in around]
    # pieces of fitted curves meet at smaller angles
    corners, step = ends[np.abs(turns) > 0.05], length / count

    def off_corners(middle: float) -> float:
        # return the nearest place at least the width of a bridge from corners, or the middle if there is none
        for shift in np.linspace(0.0, step / 4, 41):
            for at in (middle + shift, middle - shift):
                if not np.any(np.abs((corners - at + length / 2) % length - length / 2) < tabs.width):
                    return float(at)
        return middle

    middles = [off_corners((i + 0.5) * step) for i in range(count)]
    # from each bridge to the next; the last part passes the start of the loop
    around_loop = pairwise([*middles, middles[0] + length])
    half = tabs.width / 2
    return [Path(_between(path.segments, ends, a + half, b - half)) for a, b in around_loop]


def _between(segments: Sequence[Segment], ends: FloatArray, a: float, b: float) -> list[Segment]:
    """Return the part of a loop between two arc lengths. The segments end at arc lengths `ends` (n,).

    `b` may be up to twice the length of the loop, because a part may pass the start of the loop.
    """
    pieces: list[Segment] = []
    for turn in (0.0, ends[-1]):
        for segment, end in zip(segments, ends + turn, strict=True):
            start = end - segment.length
            first, last = max(a, start), min(b, end)
            if last - first > SAME_PLACE_MM:
                pieces.append(_part(segment, first - start, last - start))
    return pieces


def _part(segment: Segment, a: float, b: float) -> Segment:
    """Return the part of a segment between two lengths a and b from its start, mm."""
    length = segment.length
    if a <= SAME_PLACE_MM and b >= length - SAME_PLACE_MM:
        return segment
    if not isinstance(segment, Spline):
        return trim_segment(segment, max(a / length, 0.0), min(b / length, 1.0))
    t0, t1 = segment.curve.domain
    u: FloatArray = (segment.curve.parameter(np.clip([a, b], 0.0, length)) - t0) / (t1 - t0)
    return trim_segment(segment, float(max(u[0], 0.0)), float(min(u[1], 1.0)))
