"""Slots: narrow cuts that let strips interlock, and the outline that each opens exactly where it meets the edge."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Annotated, Literal

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import numbers
from elastica_cad.declared import Asked, require_declared
from elastica_cad.errors import InputError
from elastica_cad.geometry.boxes import box_about, boxes_meet
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.path_intersections import Chords, chord_crossings, polylines_cross
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.geometry.paths.segments import Arc, Line, Segment, Spline, left_of, place, trim_segment
from elastica_cad.geometry.polynomials.splines import spline_through
from elastica_cad.geometry.running_sums import lengths_along
from elastica_cad.refusals import Length, note

STRAIGHT_MM = 1e-7
"""Sides that bend less than this are lines."""

CLEARANCE_MM = 0.1
"""Default clearance of a slot, mm: a laser-cut sheet then slides in and stays."""

Side = Literal["upper", "lower"]
Relief = Literal["square", "round"]


def _center_line(path: object, widths: object, here: str) -> tuple[FloatArray, FloatArray]:
    rows, across = numbers(path, f"{here}: path"), numbers(widths, f"{here}: widths")
    if rows.ndim != 2 or rows.shape[1] != 2 or len(rows) < 2 or across.shape != (len(rows),):
        raise InputError("{here}: path has two or more rows (x, y), widths one number for each", here=here)
    return rows, across


@dataclass(frozen=True, eq=False)
class Slot:
    """A slot from inside the strip to its edge.

    Parameters
    ----------
    at : float
        Arc length of the inner end of its centre line, mm.
    width : float
        Across the slot, mm; of a slot along a `path` the width at the inner end.
    depth : float, optional
        From the edge of the strip to the inner end, measured across the strip, mm; to the centre line of the
        strip where not given.
    side : "upper" or "lower"
        The edge on which it opens: y > 0 or y < 0 of the flat pattern.
    lean : float
        Angle of the centre line to the strip's ruling, rad: outward it moves towards larger x where positive.
    relief : "square" or "round"
        The inner end: straight across, or a half circle beyond it.
    mate : str
        What goes in here; written beside the slot.
    path : (k, 2) array, optional
        Centre line in the flat pattern from the inner end to the edge, mm, in place of depth and lean.
    widths : (k,) array, optional
        Width at every point of `path`, mm.

    Raises
    ------
    InputError
        Sizes that are not positive, a path without its widths.

    Examples
    --------
    >>> Slot(40.0, width=1.2, depth=5.0, side="lower").mirrored().side
    'upper'
    """

    at: Annotated[float, Asked("Place along the strip.", "mm")]
    width: Annotated[float, Asked("Width of the slot.", "mm", above=0)]
    depth: Annotated[
        float | None, Asked("Depth from the edge; to the centre line unless given.", "mm", above=0)
    ] = None
    side: Annotated[Side, Asked("The edge on which it opens.")] = "upper"
    lean: Annotated[float, Asked("Angle to the ruling of the strip.", "rad")] = 0.0
    relief: Annotated[Relief, Asked("Its inner end.")] = "square"
    mate: Annotated[str, Asked("What goes in; written beside it.")] = ""
    path: FloatArray | None = None
    widths: FloatArray | None = None

    def __post_init__(self) -> None:
        require_declared(Slot, vars(self), "slot")
        here = note("slot at {at}", at=Length(self.at))
        if abs(self.lean) >= np.pi / 2:
            raise InputError(
                "{here}: lean is {lean:g} rad: it must stay within a quarter turn", here=here, lean=self.lean
            )
        if (self.path is None) != (self.widths is None):
            raise InputError("{here}: path and widths go together", here=here)
        if self.path is not None:
            path, widths = (array.copy() for array in _center_line(self.path, self.widths, here))
            if not np.all(np.isfinite(path)) or not np.all(widths > 0):
                raise InputError("{here}: path and widths must be finite, widths positive, in mm", here=here)
            for name, array in (("path", path), ("widths", widths)):
                array.setflags(write=False)
                object.__setattr__(self, name, array)

    @classmethod
    def along(
        cls, path: ArrayLike, widths: ArrayLike, *, side: Side, relief: Relief = "square", mate: str = ""
    ) -> "Slot":
        """A slot along a centre line (k, 2) from its inner end to the edge, as wide as `widths` (k,) say."""
        rows, across = _center_line(path, widths, "slot along a path")
        return cls(
            float(rows[0, 0]), float(across[0]), side=side, relief=relief, mate=mate, path=rows, widths=across
        )

    def mirrored(self) -> "Slot":
        """The slot of the strip turned over about its centre line (y to -y)."""
        path = None if self.path is None else self.path * (1.0, -1.0)
        return replace(self, side="lower" if self.side == "upper" else "upper", path=path)

    def center_line(self, width: Profile) -> tuple[FloatArray, FloatArray]:
        """Points (k, 2) from the inner end to the edge and widths (k,), in a strip of that width, mm."""
        if self.path is not None and self.widths is not None:
            return self.path, self.widths
        sign = 1.0 if self.side == "upper" else -1.0
        half = float(width(np.clip(self.at, 0.0, width.length))) / 2
        depth = half if self.depth is None else self.depth
        outward = np.array([np.sin(self.lean), sign * np.cos(self.lean)])
        inner = np.array([self.at, sign * (half - depth)])
        return np.array([inner, inner + outward * depth / np.cos(self.lean)]), np.full(2, self.width)


def slot_cut(slot: Slot, width: Profile, *, beyond: float) -> Path:
    """The open path that a cutter follows: from outside the edge inward, about the inner end, and out again.

    Parameters
    ----------
    slot : Slot
    width : Profile
        Full width of the strip.
    beyond : float
        How far the sides run on, straight, beyond the end of the centre line, mm.
    """
    right, left = _sides(slot, width)
    first, last = right.points[0], left.points[0]
    end = Arc.from_bulge(first, last, -1.0) if slot.relief == "round" else Line(first, last)
    inward = [segment.reversed() for segment in reversed(right.drawn(beyond))]
    return Path([*inward, end, *left.drawn(beyond)])


def _left_of(tangents: FloatArray) -> FloatArray:
    """Unit normals (k, 2) to the left of tangents (k, 2)."""
    normals = np.stack([-tangents[:, 1], tangents[:, 0]], axis=1)
    return np.asarray(normals / np.hypot(*tangents.T)[:, None], dtype=float)


@dataclass(frozen=True, eq=False)
class _Side:
    """A side of a slot from its inner end: points (n, 2), their spline where it is bent, the way on at its end."""

    points: FloatArray
    direction: FloatArray
    bent: Spline | None = None

    def drawn(self, beyond: float) -> list[Segment]:
        """The side, and straight on by `beyond` mm."""
        onward = self.points[-1] + self.direction * beyond / np.hypot(*self.direction)
        if self.bent is None:
            return [Line(self.points[0], onward)]
        return [self.bent, Line(self.points[-1], onward)]


def _sides(slot: Slot, width: Profile) -> tuple[_Side, _Side]:
    """The right and the left side, seen outward."""
    points, widths = slot.center_line(width)
    t = lengths_along(points)
    degree = min(3, len(points) - 1)  # of a spline through them
    tangents = spline_through(t, points, degree)(t, 1)
    normals = _left_of(tangents)
    right, left = (points + sign * widths[:, None] / 2 * normals for sign in (-1, 1))
    sides = spline_through(t, np.hstack([right, left]), degree)
    return _side(right, sides.t, sides.c[:, :2]), _side(left, sides.t, sides.c[:, 2:])


def _side(points: FloatArray, knots: FloatArray, controls: FloatArray) -> _Side:
    """A side through points in order: straight where they lie on a line."""
    chord = points[-1] - points[0]
    off = (points - points[0]) @ left_of(chord) / np.hypot(*chord)
    if len(points) == 2 or np.abs(off).max() < STRAIGHT_MM:
        return _Side(points, chord)
    if len(points) < 4:
        raise InputError("a bent slot needs four points or more along its centre line")
    return _Side(points, controls[-1] - controls[-2], Spline(PlaneCurve(knots, controls, 3)))


FLAT_MM = 1e-3
"""Flatness of the polylines with which loops are compared, mm: finer than any machine."""

SAME_POINT_MM = 1e-9
"""Points nearer to each other than this are the same."""

SAME_PARAMETER = 1e-6
"""Parameters nearer to each other than this may be the same place; the distance decides."""

REACHES = (1.0, 4.0, 16.0)
"""Lengths, in widths of the slot, by which its sides are extended until they meet the edge."""


@dataclass(frozen=True)
class _Place:
    """A place on a chain: segment and its u in [0, 1]."""

    segment: int
    u: float


@dataclass(frozen=True, eq=False)
class _Opening:
    """Opening of a slot: where its cut leaves the outline and returns, the cut in between, and points along it."""

    slot: Slot
    out: _Place
    back: _Place
    cut: tuple[Segment, ...]
    points: FloatArray


def cut_slots(
    outline: Path, holes: Sequence[Path], slots: Sequence[Slot], width: Profile, *, name: str = "strip"
) -> Path:
    """The outline with its slots.

    Parameters
    ----------
    outline, holes : Path
        Closed loops of the flat pattern, the outline anticlockwise.
    slots : sequence of Slot
    width : Profile
        Full width of the strip.
    name : str
        What messages call the part.

    Raises
    ------
    InputError
        A slot that does not open at the edge, cuts the strip through, or meets a hole or another slot.
    """
    if not slots:
        return outline
    edge = _Edge(outline)
    openings = sorted(
        (edge.opening(slot, width, name) for slot in slots), key=lambda o: (o.out.segment, o.out.u)
    )
    _refuse_meetings(openings, holes, name)
    for before, after in zip(openings, [*openings[1:], openings[0]], strict=True):
        wraps = after is openings[0]
        if not wraps and (after.out.segment, after.out.u) < (before.back.segment, before.back.u):
            raise InputError(_meeting(name, before.slot, after.slot))
    return Path(edge.spliced(openings), closed=True)


class _Edge:
    """The outline, ready to be crossed by many slots."""

    def __init__(self, outline: Path) -> None:
        self.segments = outline.segments
        self.chords = [Chords.of(segment) for segment in self.segments]
        begins, ends = (
            np.concatenate([c.points[part] for c in self.chords]) for part in (slice(-1), slice(1, None))
        )
        self.low, self.high = np.minimum(begins, ends) - FLAT_MM, np.maximum(begins, ends) + FLAT_MM
        self.owner = np.repeat(np.arange(len(self.chords)), [len(c.points) - 1 for c in self.chords])

    def opening(self, slot: Slot, width: Profile, name: str) -> _Opening:
        """Find where the slot meets the edge; its sides are extended until they do."""
        crossings: list[tuple[_Place, _Place]] = []
        chords: list[Chords] = []
        for reach in REACHES:
            chords = [Chords.of(part) for part in slot_cut(slot, width, beyond=reach * slot.width).segments]
            crossings = self._crossings(chords)
            if len(crossings) > 1:
                break
        if len(crossings) != 2:
            low, high = float(self.low[:, 0].min()), float(self.high[:, 0].max())
            if not low < slot.at < high:
                raise InputError(
                    "{name}: the slot at {at:.6g} is not on the strip, which goes from {low:.4g} to "
                    "{high:.4g} with its tabs: move it",
                    name=name,
                    at=Length(slot.at),
                    low=low,
                    high=Length(high),
                )
            raise InputError(
                "{strip}: the slot at {at} does not open at the edge: make it deeper or move it"
                if len(crossings) < 2
                else "{strip}: the slot at {at} cuts through to another edge: make it shallower or narrower "
                "or move it",
                strip=name,
                at=Length(slot.at),
            )
        (first, a), (second, b) = sorted(crossings, key=lambda pair: (pair[1].segment, pair[1].u))
        points = np.concatenate([c.points for c in chords[a.segment : b.segment + 1]])
        cut = _between([c.segment for c in chords], a, b)
        return _Opening(slot, first, second, tuple(cut), points)

    def _crossings(self, cut: Sequence[Chords]) -> list[tuple[_Place, _Place]]:
        found: list[tuple[_Place, _Place]] = []
        for k, chords in enumerate(cut):
            low, high = chords.points.min(axis=0) - FLAT_MM, chords.points.max(axis=0) + FLAT_MM
            near = ((self.low <= high) & (self.high >= low)).all(axis=1)
            # chords of a segment follow one another
            for i in dict.fromkeys(self.owner[near].tolist()):
                for u, v in chord_crossings(self.chords[i], chords):
                    point = chords.segment.at(v)
                    if all(
                        np.hypot(*(cut[p.segment].segment.at(p.u) - point)) > SAME_POINT_MM for _, p in found
                    ):
                        found.append((_Place(i, u), _Place(k, v)))
        return found

    def spliced(self, openings: Sequence[_Opening]) -> list[Segment]:
        """The whole loop: edge from the end of each slot to the start of the next, then that slot's cut."""
        chain: list[Segment] = []
        for before, after in zip([openings[-1], *openings[:-1]], openings, strict=True):
            chain += _between(self.segments, before.back, after.out)
            chain += after.cut
        return chain


def _between(chain: Sequence[Segment], start: _Place, end: _Place) -> list[Segment]:
    """The part of a chain from one place on to another, past its end and on from its start if need be."""
    if start.segment == end.segment and start.u <= end.u:
        return _piece(chain[start.segment], start.u, end.u)
    following = range(start.segment + 1, end.segment + (len(chain) if end.segment <= start.segment else 0))
    middle = [chain[i % len(chain)] for i in following]
    return [*_piece(chain[start.segment], start.u, 1.0), *middle, *_piece(chain[end.segment], 0.0, end.u)]


def _piece(segment: Segment, u0: float, u1: float) -> list[Segment]:
    """The segment between two parameters; nothing where they differ by rounding only."""
    if u1 - u0 < SAME_PARAMETER and np.hypot(*(segment.at(u1) - segment.at(u0))) < SAME_POINT_MM:
        return []
    return [trim_segment(segment, u0, u1)]


def _refuse_meetings(openings: Sequence[_Opening], holes: Sequence[Path], name: str) -> None:
    cuts = [opening.points for opening in openings]
    boxes = [box_about(cut) for cut in cuts]
    for i, opening in enumerate(openings):
        for j in range(i):
            if not boxes_meet(boxes[i], boxes[j]):
                continue
            if polylines_cross(cuts[i], cuts[j]) is not None:
                raise InputError(_meeting(name, openings[j].slot, opening.slot))
        for hole in holes:
            if not boxes_meet(boxes[i], hole.bounds):
                continue
            loop = hole.points(FLAT_MM)
            at = polylines_cross(cuts[i], np.concatenate([loop, loop[:1]]))
            if at is not None:
                raise InputError(
                    "{name}: the slot at {at:.6g} meets a hole at {at_2}: move one of them",
                    name=name,
                    at=Length(opening.slot.at),
                    at_2=place(at),
                )


def _meeting(name: str, a: Slot, b: Slot) -> str:
    return note(
        "{strip}: the slots at {one} and {other} meet: move them apart, or make them narrower or shallower",
        strip=name, one=Length(a.at), other=Length(b.at),
    )  # fmt: skip
