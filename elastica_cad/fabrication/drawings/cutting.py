"""Input of the cutter: loops moved by half the kerf, bridges that hold parts in their sheet, single parts."""

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import is_number, require_number, require_record
from elastica_cad.declared import Asked, require_declared
from elastica_cad.errors import InputError
from elastica_cad.fabrication.drawings.drawing import CUT_INNER, CUT_OUTER, Drawing, LayeredPath
from elastica_cad.geometry.curves.curve_derivatives import turn_between
from elastica_cad.geometry.paths.offset import offset_path
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.path_intersections import encloses, polylines_cross
from elastica_cad.geometry.paths.segments import Segment, Spline, place, trim_segment
from elastica_cad.refusals import Length as Mm

DEFAULT_KERF_MM = 0.0
"""Kerf that cutting files and nests are corrected for unless one is given: none, as many cutting services correct
for their own. The kerf of a material is `Sheet.kerf`; it is used on request."""

FINEST_KERF_MM, COARSEST_KERF_MM = 1e-5, 10.0
"""Errors of a moved spline, mm: no machine cuts more finely, and no kerf is wider than the coarsest."""

WIDEST_KERF_MM = 15.0
"""Largest kerf, mm; a router's bit of half an inch is 12.7 mm wide."""


def compensate_kerf(drawing: Drawing, kerf: float, *, tolerance: float = 1e-4) -> Drawing:
    """The drawing as the tool must run so that the parts come out as drawn.

    Closed loops on CUT_OUTER move outward by kerf / 2, those on CUT_INNER inward; a negative kerf moves them
    the other way. Open cuts, engraving and marks stay.

    Parameters
    ----------
    drawing : Drawing
    kerf : float
        Width of the cut, mm.
    tolerance : float
        Largest error of a moved spline, mm; lines and arcs are exact.

    Raises
    ------
    InputError
        A kerf wider than that of any tool; a loop is swallowed by the cut, or moved loops cross or touch each
        other.

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
            "the kerf is {kerf:g}, wider than the cut of any tool: give the width of the cut in "
            "mm, such as 0.15 for a laser",
            kerf=Mm(kerf),
        )
    if kerf == 0:
        return drawing
    if not (is_number(tolerance) and FINEST_KERF_MM <= tolerance <= COARSEST_KERF_MM):
        raise InputError(
            "the tolerance is {tolerance}: give {finest:g} to {coarsest:g} mm",
            tolerance=tolerance, finest=FINEST_KERF_MM, coarsest=COARSEST_KERF_MM,
        )  # fmt: skip
    sides = {CUT_OUTER: kerf / 2, CUT_INNER: -kerf / 2}
    moved = []
    loops = []
    for item in drawing.paths:
        if item.layer in sides and item.path.closed:
            loops.append(_moved(item, sides[item.layer], kerf, tolerance))
            moved.append(LayeredPath(item.layer, loops[-1]))
        else:
            moved.append(item)
    _refuse_overlaps(loops, kerf, tolerance)
    return Drawing(drawing.name, tuple(moved), drawing.texts)


def _moved(item: LayeredPath, distance: float, kerf: float, tolerance: float) -> Path:
    try:
        return offset_path(item.path, distance, tolerance=tolerance)
    except InputError as error:
        raise InputError(
            "a kerf of {kerf:g} is too wide for a loop on {layer}: {error}",
            kerf=Mm(kerf),
            layer=item.layer,
            error=error,
        ) from error


def _refuse_overlaps(loops: list[Path], kerf: float, tolerance: float) -> None:
    if len(loops) < 2:
        return
    bounds = np.array([loop.bounds for loop in loops])
    low, high = bounds[:, 0], bounds[:, 1]
    order = np.argsort(low[:, 0], kind="stable")
    outlines: dict[int, np.ndarray] = {}

    def outline(i: int) -> np.ndarray:
        if i not in outlines:
            points = loops[i].points(tolerance)
            outlines[i] = np.concatenate([points, points[:1]])
        return outlines[i]

    for k, i in enumerate(order):
        rest = order[k + 1 :]
        rest = rest[: np.searchsorted(low[rest, 0], high[i, 0], side="right")]
        for j in rest[(low[rest, 1] <= high[i, 1]) & (high[rest, 1] >= low[i, 1])]:
            crossing = polylines_cross(outline(int(i)), outline(int(j)))
            if crossing is not None:
                raise InputError(
                    "with a kerf of {kerf:g} two cut loops meet at {crossing}: move them apart there or "
                    "use a smaller kerf",
                    kerf=Mm(kerf),
                    crossing=place(crossing),
                )


CORNER_RAD = 0.05
"""Angle between two segments, rad, from which on bridges avoid the corner; smaller ones come from fitting."""

SAME_PLACE_MM = 1e-9
"""Arc lengths nearer to each other than this are the same."""


@dataclass(frozen=True)
class HoldingTabs:
    """Bridges that interrupt closed cuts.

    Parameters
    ----------
    width : float
        Length of cut that each leaves out, mm.
    spacing : float
        Largest distance between two of them along the cut, mm.
    least : int
        How many each loop has at least.
    inner : bool
        Interrupt inner cuts too, those longer than `spacing`.
    """

    width: Annotated[float, Asked("Width of a bridge.", "mm", above=0)] = 0.5
    spacing: Annotated[float, Asked("Largest distance between two bridges.", "mm", least=1)] = 100.0
    least: Annotated[int, Asked("How many bridges each loop has at least.", least=1, most=1000)] = 2
    inner: Annotated[bool, Asked("Interrupt inner cuts too.")] = False

    def __post_init__(self) -> None:
        require_declared(HoldingTabs, vars(self), "holding tabs:")


def add_holding_tabs(drawing: Drawing, tabs: HoldingTabs | None = None) -> Drawing:
    """The drawing with bridges in its closed outer cuts: each loop becomes open cuts, in its order.

    Bridges are spread evenly and moved off corners. The last step of all: kerf moves closed loops only.

    Parameters
    ----------
    drawing : Drawing
    tabs : HoldingTabs, optional
        The default ones unless given.

    Raises
    ------
    InputError
        A loop too short for its bridges.

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
    found: list[LayeredPath] = []
    for item in drawing.paths:
        inner = item.layer == CUT_INNER and tabs.inner and item.path.length > tabs.spacing
        if item.path.closed and (item.layer == CUT_OUTER or inner):
            found += [LayeredPath(item.layer, piece) for piece in _Loop(item.path).opened(tabs)]
        else:
            found.append(item)
    return Drawing(drawing.name, tuple(found), drawing.texts)


FLAT_MM = 0.02
"""Flatness of outlines when the holes inside them are found."""


def separate_parts(drawing: Drawing) -> tuple[Drawing, ...]:
    """Return a drawing for each closed outer cut, with the inner cuts inside it, without engraving and marks.

    Cutting services cut every line, so nothing else may be in their files.

    Parameters
    ----------
    drawing : Drawing

    Raises
    ------
    InputError
        A cut that is not closed.

    Examples
    --------
    >>> plates = [Path.rectangle(40, 10), Path.rectangle(40, 10, corner=(0, 20))]
    >>> hole = LayeredPath(CUT_INNER, Path.circle((20, 25), 3))
    >>> parts = separate_parts(Drawing("plates", [*(LayeredPath(CUT_OUTER, one) for one in plates), hole]))
    >>> [(part.name, len(part.paths)) for part in parts]
    [('plates', 1), ('plates-2', 2)]
    """
    require_record(drawing, Drawing, "what is separated", "a Drawing")
    cuts = drawing.only(CUT_INNER, CUT_OUTER).strokes
    for item in cuts:
        if not item.path.closed:
            raise InputError(
                "{name}: the cut from {start} is open, and a cutting service cuts closed outlines and holes "
                "only; close it or leave it out",
                name=drawing.name,
                start=place(item.path.start),
            )
    holes = [item for item in cuts if item.layer == CUT_INNER]
    outlines = [item for item in cuts if item.layer == CUT_OUTER]
    parts = []
    for number, outline in enumerate(outlines, start=1):
        rim = outline.path.points(FLAT_MM)
        inside = holes if len(outlines) == 1 else [one for one in holes if encloses(rim, one.path.start)]
        name = drawing.name if number == 1 else f"{drawing.name}-{number}"
        parts.append(Drawing(name, (*inside, outline)))
    return tuple(parts)


class _Loop:
    """A closed path by arc length."""

    def __init__(self, path: Path) -> None:
        self.segments = path.segments
        self.ends = np.cumsum([segment.length for segment in path.segments])
        self.length = float(self.ends[-1])
        self.corners = np.array(
            [
                end
                for end, before, after in zip(
                    self.ends, self.segments, (*self.segments[1:], self.segments[0]), strict=True
                )
                if _turn(before, after) > CORNER_RAD
            ]
        )

    def opened(self, tabs: HoldingTabs) -> list[Path]:
        """The cuts between the bridges."""
        count = max(tabs.least, int(np.ceil(self.length / tabs.spacing)))
        if self.length < 4 * count * tabs.width:
            raise InputError(
                "the loop at {start} is {length:.4g} around: too short for {count} holding tabs of "
                "{width:g}; use fewer or narrower ones",
                start=place(self.segments[0].start),
                length=Mm(self.length),
                count=count,
                width=Mm(tabs.width),
            )
        step = self.length / count
        middles = [self._off_corners((i + 0.5) * step, tabs.width, step / 4) for i in range(count)]
        starts = [middle + tabs.width / 2 for middle in middles]
        stops = [
            *(middle - tabs.width / 2 for middle in middles[1:]),
            middles[0] - tabs.width / 2 + self.length,
        ]
        return [Path(self._between(a, b)) for a, b in zip(starts, stops, strict=True)]

    def _off_corners(self, middle: float, width: float, reach: float) -> float:
        """The nearest place whose bridge, with as much again on both sides, meets no corner."""
        for shift in np.linspace(0.0, reach, 41):
            for at in (middle + shift, middle - shift):
                away = np.abs((self.corners - at + self.length / 2) % self.length - self.length / 2)
                if not np.any(away < width):
                    return float(at)
        return middle

    def _between(self, a: float, b: float) -> list[Segment]:
        """The segments from one arc length to a later one, around the start where need be."""
        pieces: list[Segment] = []
        for turn in (0.0, self.length):
            for segment, end in zip(self.segments, self.ends + turn, strict=True):
                start = end - segment.length
                first, last = max(a, start), min(b, end)
                if last - first > SAME_PLACE_MM:
                    pieces.append(_part(segment, first - start, last - start))
        return pieces


def _part(segment: Segment, a: float, b: float) -> Segment:
    """The segment between two of its arc lengths."""
    length = segment.length
    if a <= SAME_PLACE_MM and b >= length - SAME_PLACE_MM:
        return segment
    if not isinstance(segment, Spline):
        return trim_segment(segment, max(a / length, 0.0), min(b / length, 1.0))
    t0, t1 = segment.curve.domain
    u: FloatArray = (segment.curve.parameter(np.clip([a, b], 0.0, length)) - t0) / (t1 - t0)
    return trim_segment(segment, float(max(u[0], 0.0)), float(min(u[1], 1.0)))


def _turn(before: Segment, after: Segment) -> float:
    return abs(float(turn_between(before.tangent_at(1.0), after.tangent_at(0.0))))
