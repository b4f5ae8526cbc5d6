"""Outline of a flat strip: its long sides, tabs and holes."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, pairwise
from math import hypot
from typing import Annotated, Any, Literal, TypeAlias

import numpy as np

from elastica_cad._types import EMPTY, BoolArray, FloatArray, Takes
from elastica_cad._values import counted, require_positive, several
from elastica_cad.declared import Option, require_declared
from elastica_cad.defaults import TAB_LENGTH
from elastica_cad.errors import BareLength, InputError, Length
from elastica_cad.geometry.path import Arc, Line, Path, Segment, Spline, distances, meets
from elastica_cad.geometry.path_intersections import encloses
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.profile import Profile
from elastica_cad.geometry.splines import greville, kinks, over_knots
from elastica_cad.mechanics.loads import Supports

StripEnd: TypeAlias = Literal["start", "end"]
ENDS: tuple[StripEnd, StripEnd] = ("start", "end")

SHORTEST_MM = 1e-3
"""Least length of a tab, mm. In solids, the corners of a shorter tab would coincide."""


@dataclass(frozen=True)
class Hole:
    """A round hole in a tab.

    Parameters
    ----------
    at : float
        Distance of the centre from the end of the bent part, outward into the tab, mm.
    diameter : float
        Diameter of the hole, mm.
    across : float
        Distance of the centre from the centre line, mm; positive to the left, seen outward along the tab.
    """

    at: Annotated[float, Option("Distance from the inner end of the tab.", "mm")]
    diameter: Annotated[float, Option("Diameter of the hole.", "mm", above=0)]
    across: Annotated[float, Option("Distance from the centre line.", "mm")] = 0.0

    def __post_init__(self) -> None:
        require_declared(Hole, vars(self), "hole")


@dataclass(frozen=True)
class TSlot:
    """A slot from the middle of the tab's outer edge for a screw, with a pocket that holds its nut.

    Parameters
    ----------
    depth : float
        Depth of the slot from the outer edge, mm: the length of the screw inside the tab.
    screw : float
        Width of the slot, mm; 3.2 for M3.
    nut : (width, height)
        Size of the pocket across and along the screw, mm; 5.6 by 2.6 for M3.
    wall : float
        Distance between the outer edge and the nut, mm.
    """

    depth: Annotated[float, Option("Depth from the outer edge inward.", "mm", above=0)]
    screw: Annotated[float, Option("Width of the slot.", "mm", above=0)] = 3.2
    nut: Annotated[
        tuple[float, float], Option("Size of the nut's pocket across and along the screw.", "mm", above=0)
    ] = (
        5.6,
        2.6,
    )
    wall: Annotated[float, Option("Distance between the outer edge and the nut.", "mm", above=0)] = 4.0

    def __post_init__(self) -> None:
        require_declared(TSlot, vars(self), "T-slot")
        if self.nut[0] <= self.screw:
            raise InputError(
                "a nut {nut:g} wide slips through the slot of its screw, {screw:g} wide: make the nut wider",
                nut=Length(self.nut[0]),
                screw=Length(self.screw),
            )
        if self.depth < self.wall + self.nut[1]:
            raise InputError(
                (
                    "a T-slot {depth:g} deep is too shallow for its nut, which reaches {wall:g} deep: make "
                    "the slot deeper"
                ),
                depth=Length(self.depth),
                wall=Length(self.wall + self.nut[1]),
            )

    def side(self, edge: float) -> list[tuple[float, float]]:
        """Return the corners of the lower half of the slot (y < 0), from the outer edge at x = `edge` inward."""
        # y of the slot's side, y of the pocket's side, and x of the nut's face
        y, n, a = -self.screw / 2, -self.nut[0] / 2, edge - self.wall
        deep = edge - self.depth
        points = [(edge, y), (a, y), (a, n), (a - self.nut[1], n), (a - self.nut[1], y), (deep, y)]
        return points if deep < a - self.nut[1] else points[:-1]


@dataclass(frozen=True)
class Tab:
    """A straight piece beyond the bent part of a strip, by which its end is held.

    Parameters
    ----------
    length : float
        Length, mm; 0 for a straight cut without a tab.
    width : float, optional
        Width, mm; by default the strip's width at that end.
    corner_radius, chamfer : float
        Radius or chamfer of the two outer corners, mm. At most one of them can be set.
    holes : Hole or tuple of Hole
        Round holes.
    t_slot : TSlot, optional
        Slot for a screw with its nut.
    taper : float
        Reduction of the width towards the outer edge on each side, mm, as for a glue flap.

    Examples
    --------
    >>> Tab(12, holes=(Hole(6, 3.2),)).length
    12
    """

    length: Annotated[
        float, Option("Length of the tab; 0 for none.", "mm", least=0, most=10_000, common=True)
    ] = TAB_LENGTH
    width: Annotated[
        float | None, Option("Width of the tab; by default the width of the strip.", "mm", above=0)
    ] = None
    corner_radius: Annotated[float, Option("Rounding of the outer corners.", "mm", least=0)] = 0.0
    chamfer: Annotated[float, Option("Chamfer of the outer corners.", "mm", least=0)] = 0.0
    holes: Annotated[Takes[tuple[Hole, ...], Hole | Sequence[Hole]], Option("Round holes.")] = EMPTY
    t_slot: Annotated[TSlot | None, Option("Slot for a screw with its nut.")] = None
    taper: Annotated[
        float, Option("Taper of the tab: reduction of its width on each side.", "mm", least=0)
    ] = 0.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "holes", several("holes", self.holes, Hole, "Hole"))
        require_declared(Tab, vars(self), "tab")
        if 0 < self.length < SHORTEST_MM:
            raise InputError(
                "tab length is {length!r}: use 0 for no tab, or {shortest_mm:g} or more",
                length=self.length,
                shortest_mm=Length(SHORTEST_MM),
            )
        if self.corner_radius and self.chamfer:
            raise InputError("a tab cannot have both a corner radius and a chamfer: leave out one of them")
        if self.taper and (self.corner_radius or self.chamfer):
            raise InputError("a tab with a taper cannot have a corner radius or a chamfer: leave these out")
        if self.t_slot is not None and self.t_slot.depth >= self.length:
            raise InputError(
                "a T-slot {depth:g} deep does not fit a tab {length:g} long: lengthen the tab",
                depth=Length(self.t_slot.depth),
                length=Length(self.length),
            )
        for hole in self.holes:
            r = hole.diameter / 2
            if hole.at - r <= 0 or hole.at + r >= self.length:
                raise InputError(
                    "a hole of {diameter:g}, {at:g} from the start of the tab, does not fit a tab {length:g} "
                    "long: move the hole or lengthen the tab",
                    diameter=Length(hole.diameter),
                    at=Length(hole.at),
                    length=Length(self.length),
                )
        for first, second in combinations(self.holes, 2):
            if (
                hypot(first.at - second.at, first.across - second.across)
                <= (first.diameter + second.diameter) / 2
            ):
                raise InputError(
                    "holes of {diameter:g} and {diameter_2:g}, {at:g} and {at_2:g} from the start of the "
                    "tab, overlap: move one of them",
                    diameter=Length(first.diameter),
                    diameter_2=Length(second.diameter),
                    at=BareLength(first.at),
                    at_2=Length(second.at),
                )

    @property
    def plain(self) -> "Tab":
        """The rectangular tab of this length, as wide as the strip and without holes."""
        return Tab(self.length)

    def mirrored(self) -> "Tab":
        """Return the tab of the strip turned over about its centre line."""
        return replace(self, holes=tuple(replace(hole, across=-hole.across) for hole in self.holes))

    def widest(self, width: float) -> float:
        """Return the largest width of the tab, mm, for which blocks, plates and stock have room."""
        return self.width or width

    def corners(self, width: float) -> tuple[Line | Arc, ...]:
        """Return the outline of the tab, from the bent part outward, along the outer edge and back.

        The x axis points outward. The outline starts at (0, -w/2) and ends at (0, w/2), where w is the width of
        the tab or, by default, the `width` of the strip.
        """
        require_positive(width, "width")
        w, length = self.width or width, self.length
        cut = self.corner_radius or self.chamfer
        if cut > length or 2 * cut > w:
            raise InputError(
                "tab corners of {cut:g} do not fit a tab of {length:g} by {w:g}: make the corners smaller",
                cut=Length(cut),
                length=BareLength(length),
                w=Length(w),
            )
        if 2 * self.taper >= w:
            raise InputError(
                "a taper of {taper:g} on each side is too large for a tab {w:.4g} wide: make the taper smaller",
                taper=Length(self.taper),
                w=Length(w),
            )
        if length == 0:
            return lines_through([(0.0, -w / 2), (0.0, w / 2)])
        near, far = length - cut, w / 2 - max(cut, self.taper)
        edge = self._outer_edge(far)
        if not cut:
            return lines_through([(0.0, -w / 2), *edge, (0.0, w / 2)])
        if self.chamfer:
            return lines_through([(0.0, -w / 2), (near, -w / 2), *edge, (near, w / 2), (0.0, w / 2)])
        return (
            *lines_through([(0.0, -w / 2), (near, -w / 2)]),
            Arc((near, -far), cut, -np.pi / 2, 0.0),
            *lines_through(edge),
            Arc((near, far), cut, 0.0, np.pi / 2),
            *lines_through([(near, w / 2), (0.0, w / 2)]),
        )

    def _outer_edge(self, far: float) -> list[tuple[float, float]]:
        """Return the points of the tab's outer edge, from right to left, with its T-slot.

        `far` is half the width, mm.
        """
        ends = (self.length, -far), (self.length, far)
        if self.t_slot is None:
            return list(ends)
        if self.t_slot.nut[0] / 2 >= far:
            raise InputError(
                "the nut of a T-slot is {nut:g} wide, wider than the tab's outer edge of {far:.4g}: make the "
                "tab wider",
                nut=Length(self.t_slot.nut[0]),
                far=Length(2 * far),
            )
        side = self.t_slot.side(self.length)
        return [ends[0], *side, *((x, -y) for x, y in reversed(side)), ends[1]]

    def depth_at(self, at: float, across: float, width: float) -> float:
        """Return the distance, mm, of a point (`at`, `across`) from the outline of the tab; negative outside.

        `width` is the width of the strip, mm.
        """
        outline, point = self.corners(width), np.array([at, across])
        depth = min(float(distances(segment, point)[0]) for segment in outline)
        loop = Path(close_chain(outline), closed=True).closed_points(SHOULDER_MM)
        return depth if encloses(loop, point) else -depth

    def hole_paths(self, width: float) -> tuple[Path, ...]:
        """Return the holes as circles in the coordinates of the tab. `width` is the width of the strip, mm."""
        for hole in self.holes:
            if self.depth_at(hole.at, hole.across, width) <= hole.diameter / 2:
                raise InputError(
                    "a hole of {diameter:g}, {at:g} from the start of the tab and {across:g} from its centre line, "
                    "cuts the edge of a tab {w:.4g} wide: move the hole, make it smaller, or make the tab wider",
                    diameter=Length(hole.diameter),
                    at=Length(hole.at),
                    across=Length(hole.across),
                    w=Length(self.width or width),
                )
        return tuple(Path.circle((hole.at, hole.across), hole.diameter / 2) for hole in self.holes)


def lines_through(points: Sequence[tuple[float, float] | FloatArray]) -> tuple[Line, ...]:
    """Return lines between successive points (2,), mm, without lines of zero length."""
    rows: list[FloatArray] = [np.array(p) for p in points]
    return tuple(Line(p, q) for p, q in pairwise(rows) if np.any(p != q))


def pair_of_tabs(tabs: object, supports: Supports | None = None) -> tuple[Tab, Tab]:
    """Return the tabs of both ends. A single tab is used for both ends. By default, a free end has no tab."""
    if tabs is USUAL_TABS and supports is not None:
        first, last = (Tab(0) if end.is_free else Tab() for end in supports.ends)
        return first, last
    both = several("ends", tabs, Tab, "Tab") * (2 if isinstance(tabs, Tab) else 1)
    if len(both) != 2:
        raise InputError(
            f"`ends` has {counted(len(both), 'tab')}: give two, for the start and the end (Tab(0) means no tab)"
        )
    return both[0], both[1]


Ends = tuple[Tab, Tab]

USUAL_TABS: Any = (Tab(), Tab())

SHOULDER_MM = 1e-3
"""Least width of a shoulder beside a tab, mm. Narrower shoulders are omitted, because they cannot be cut and CAD
kernels fail."""

LEVEL_MM = 0.01
"""Largest change of half the width, mm, by which a long side ends level."""

LEVEL_SLOPE = 0.15
"""Slope below which long sides end level. CAD kernels fail to chamfer edges with a slight corner between them."""

MEETING_MM = 1e-9
"""Largest distance, mm, between the ends of two segments that meet."""


def flat_rim(width: Profile, ends: Ends) -> Path:
    """Return the closed outer loop, anticlockwise, of a strip of full width `width` (mm) with its tabs.

    The long sides are B-splines. The x coordinates of their control points are the Greville abscissae of the
    knots, so that y(x) is exactly half the width, except for a level end beside a tab that is as wide.
    """
    start, end = map(_without_small_shoulders, ends, _end_widths(width))
    joined = [bool(tab.length and tab.width is None and not tab.taper) for tab in (start, end)]
    pieces = _parts_between_jumps(width)
    tips = np.array([0, len(pieces) - 1])
    pieces = [_with_level_ends(piece, joined & (tips == k)) for k, piece in enumerate(pieces)]
    lower = [_side(piece, -0.5) for piece in pieces]
    upper = [_side(piece, 0.5, backward=True) for piece in reversed(pieces)]
    near, far = (
        [segment.transformed(to_strip) for segment in tab.corners(wide)]
        for tab, wide, to_strip in _placed_tabs(width, (start, end))
    )
    return Path(close_chain([*lower, *far, *upper, *near]), closed=True)


def _with_level_ends(width: Profile, level: BoolArray) -> Profile:
    """Return the width with slope zero where `level` (2,) is True, at its start and its end: see `LEVEL_SLOPE`."""
    t, k = width.knots, width.degree
    slopes = np.abs(width(t[[0, -1]], 1)) / 2
    level = level & (slopes > 0) & (slopes < LEVEL_SLOPE)
    if not level.any():
        return width
    # a knot at this distance from an end limits the change
    reach = k * LEVEL_MM / np.where(level, slopes, np.inf)
    knots = np.sort([*t, *(x for x in (t[0] + reach[0], t[-1] - reach[1]) if t[0] < x < t[-1])])
    coefficients = over_knots(width, knots, k)
    coefficients[[1, -2]] = np.where(level, coefficients[[0, -1]], coefficients[[1, -2]])
    return Profile(knots, coefficients, k)


def long_sides(width: Profile) -> tuple[list[Spline], list[Spline]]:
    """Return the lower and the upper long side, each as splines between jumps of the width, from start to end."""
    pieces = _parts_between_jumps(width)
    lower, upper = ([_side(piece, factor) for piece in pieces] for factor in (-0.5, 0.5))
    return lower, upper


def end_holes(width: Profile, ends: Ends) -> tuple[Path, ...]:
    """Return the round holes of both tabs as closed loops in the coordinates of the strip."""
    return tuple(
        path.transformed(to_strip)
        for tab, wide, to_strip in _placed_tabs(width, ends)
        for path in tab.hole_paths(wide)
    )


def fix_tab_widths(width: Profile, ends: Ends) -> Ends:
    """Return the tabs of a strip with their default widths replaced by numbers."""
    start, end = ends
    first, last = _end_widths(width)
    return replace(start, width=start.width or first), replace(end, width=end.width or last)


def add_alignment_holes(width: Profile, ends: Ends, diameter: float) -> Ends:
    """Return the tabs with an additional hole in the middle of each tab that has no hole and is large enough."""
    start, end = (
        tab
        if tab.holes or tab.length < 2 * diameter or tab.depth_at(tab.length / 2, 0.0, wide) < diameter
        else replace(tab, holes=(Hole(tab.length / 2, diameter),))
        for tab, wide in zip(ends, _end_widths(width), strict=True)
    )
    return start, end


def graph(knots: FloatArray, values: FloatArray, degree: int = 3, *, backward: bool = False) -> Spline:
    """Return the graph of a spline function y(x) with coefficients `values` (m,), directed along x.

    `backward` reverses the direction.
    """
    return graphs(knots, values[None], degree, backward=backward)[0]


def graphs(knots: FloatArray, values: FloatArray, degree: int = 3, *, backward: bool = False) -> list[Spline]:
    """Return a `graph` for each row of `values` (n, m), with the same clamped knots."""
    points = np.empty((*values.shape, 2))
    points[..., 0], points[..., 1] = greville(knots, degree), values
    if backward:
        knots, points = knots[0] + knots[-1] - knots[::-1], points[:, ::-1]
    return [Spline(curve) for curve in PlaneCurve(knots, points[0], degree).siblings(points)]


def pace(segment: Segment) -> tuple[float, float] | None:
    """Return (offset, speed) such that x = offset + speed * parameter on the whole segment, or None."""
    if isinstance(segment, Line):
        return float(segment.start[0]), float((segment.end[0] - segment.start[0]) / segment.length)
    if not isinstance(segment, Spline) or segment.curve.is_rational:
        return None
    x, sites = segment.curve.control_points[:, 0], greville(segment.curve.knots, segment.curve.degree)
    speed = float((x[-1] - x[0]) / (sites[-1] - sites[0]))
    offset = float(x[0] - speed * sites[0])
    stray = np.abs(offset + speed * sites - x).max()
    # x is linear, except for rounding
    return (offset, speed) if speed and stray <= 1e-10 * max(1.0, np.abs(x).max()) else None


def close_chain(segments: Iterable[Segment]) -> tuple[Segment, ...]:
    """Return a closed chain of the segments and of lines in the gaps between them."""
    chain: list[Segment] = []
    for segment in segments:
        if chain and not meets(chain[-1], segment, MEETING_MM):
            chain.append(Line(chain[-1].end, segment.start))
        chain.append(segment)
    if not meets(chain[-1], chain[0], MEETING_MM):
        chain.append(Line(chain[-1].end, chain[0].start))
    return tuple(chain)


def _parts_between_jumps(width: Profile) -> list[Profile]:
    """Return the width as profiles that are continuous, divided where the width jumps."""
    k = width.degree
    cuts = kinks(width.knots, k, 0)
    if not cuts.size:
        return [width]
    pieces, first = [], 0  # `first` is the index of the first knot and coefficient of the piece
    for cut in [*cuts, None]:
        last = width.coefficients.size if cut is None else int(width.knots.searchsorted(cut))
        pieces.append(Profile(width.knots[first : last + k + 1], width.coefficients[first:last], k))
        first = last
    return pieces


def _side(width: Profile, factor: float, *, backward: bool = False) -> Spline:
    return graph(width.knots, factor * width.coefficients, width.degree, backward=backward)


def _without_small_shoulders(tab: Tab, width: float) -> Tab:
    # return the tab with the width of the strip if the difference, or the tab's length, is too small: `SHOULDER_MM`
    small = tab.width is not None and min(abs(tab.width - width), tab.length) < SHOULDER_MM
    return replace(tab, width=None) if small else tab


def _end_widths(width: Profile) -> tuple[float, float]:
    # the first and last coefficients of a clamped spline are its end values
    return float(width.coefficients[0]), float(width.coefficients[-1])


def _placed_tabs(width: Profile, ends: Ends) -> Iterator[tuple[Tab, float, FloatArray]]:
    """Yield each tab, the width (mm) of the strip beside it, and the (3, 3) map from the tab to the strip."""
    for tab, wide, x, direction in zip(ends, _end_widths(width), (0.0, width.length), (-1, 1), strict=True):
        yield tab, wide, np.array([[direction, 0.0, x], [0.0, direction, 0.0], [0.0, 0.0, 1.0]])
