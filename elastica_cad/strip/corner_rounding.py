"""Rounded corners: arcs of a given radius in place of the corners of closed paths."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import islice

import numpy as np

from elastica_cad._types import BoolArray, FloatArray, IntArray
from elastica_cad.errors import InputError, Length
from elastica_cad.geometry.path import Arc, Path, Segment, SegmentTable, Spline, chords, trim_segment
from elastica_cad.geometry.plane_points import cross, left_of, norm, place, turn_between

CLOSE_MM = 1e-9
"""Length, mm, that counts as zero: the overlap of two arcs, or the gap between the two centres of one arc."""

CLOSE_SHARE = 1e-3
"""Tolerance of the test whether an arc crosses a side, as a fraction of the arc's radius.

For the test, the side is replaced by chords with the same error."""


def round_corners(path: Path, radius: float) -> Path:
    """Return the closed path with an arc of `radius` mm, tangent to both sides, in place of every corner.

    Examples
    --------
    >>> plate = round_corners(Path.rectangle(10, 6), 1.0)
    >>> round(plate.area - (60 - 4), 6)  # four squares less, four quarter circles more
    3.141593
    """
    (rounded,) = rounded_where_they_fit([path], radius)
    if rounded is None:
        raise too_small_for(radius, path)
    return rounded


def too_small_for(radius: float, path: Path) -> InputError:
    """Return the error for a corner that is too small for the radius."""
    return InputError(
        "a corner radius of {radius:g} does not fit at {place}: make it smaller",
        radius=Length(radius),
        place=place(path.bounds.mean(axis=0)),
    )


def rounded_where_they_fit(paths: Sequence[Path], radius: float) -> list[Path | None]:
    """Return paths with rounded corners, and None for paths whose sides are too short for the radius.

    A side too short for its two arcs is omitted if a single arc fits between its neighbours. For example, a
    pointed hole with a truncated tip is rounded as if its tip were sharp.
    """
    segments = [segment for path in paths for segment in path.segments]
    if not segments:
        return []
    table = SegmentTable(segments)
    # the control polygon of a spline is at least as long as the spline, and quickly measured
    sizes = np.array([
        norm(np.diff(segment.curve.control_points, axis=0)).sum() if isinstance(segment, Spline) else
        segment.length for segment in segments
    ])  # fmt: skip
    rounded: list[Path | None] = [None] * len(paths)
    numbers = iter(range(len(segments)))
    rings = [list(islice(numbers, len(path.segments))) for path in paths]
    remaining = {i: _Ring(ring, [()] * len(ring)) for i, ring in enumerate(rings)}
    # round all corners; loops with sides that are too short are tried again without these sides
    while remaining:
        before = np.array([k for ring in remaining.values() for k in ring.sides])
        after = np.array([k for ring in remaining.values() for k in (*ring.sides[1:], ring.sides[0])])
        gaps = np.array([bool(gap) for ring in remaining.values() for gap in ring.gaps])
        before, after, places, corner_arcs = _corners(table, before, after, gaps, radius)
        # each side remains between the parameters `first`, where an arc ends, and `last`, where the next arc begins
        first, last = np.zeros(len(segments)), np.ones(len(segments))
        last[before], first[after] = places.T
        beyond = np.maximum(-first, last - 1) * sizes > CLOSE_MM
        short = set(np.flatnonzero((first > last) | beyond).tolist())
        last = np.where((last - first) * sizes > CLOSE_MM, last, first)
        parts = [
            trim_segment(segment, a, b) if a < b else None
            for segment, a, b in zip(segments, *np.clip([first, last], 0, 1).tolist(), strict=True)
        ]
        arcs = dict(zip(before.tolist(), corner_arcs, strict=True))
        following: dict[int, _Ring] = {}
        for i, ring in remaining.items():
            if not short.isdisjoint(ring.sides):
                if (smaller := ring.without(short)) is not None:
                    following[i] = smaller
                continue
            turns = [arcs.get(k) for k in ring.sides]
            if all(_is_inside(arc, gap, segments) for arc, gap in zip(turns, ring.gaps, strict=True)):
                chain = [side for k, arc in zip(ring.sides, turns, strict=True) for side in (parts[k], arc)]
                rounded[i] = Path([side for side in chain if side is not None], closed=True)
        remaining = following
    return rounded


@dataclass(frozen=True)
class _Ring:
    """Indices of the remaining sides of a loop, and of the omitted sides after each remaining side."""

    sides: list[int]
    gaps: list[tuple[int, ...]]

    def without(self, short: set[int]) -> "_Ring | None":
        """Return the ring without the `short` sides, or None if fewer than two sides remain."""
        around = list(zip(self.sides, self.gaps, strict=True))
        # begin at a side that remains, so that each omitted side is after one
        first = next((j for j, k in enumerate(self.sides) if k not in short), 0)
        sides: list[int] = []
        gaps: list[tuple[int, ...]] = []
        for k, gap in (*around[first:], *around[:first]):
            if k not in short:
                sides.append(k)
                gaps.append(gap)
            elif gaps:
                gaps[-1] = (*gaps[-1], k, *gap)
        return _Ring(sides, gaps) if len(sides) > 1 else None


def _is_inside(arc: Arc | None, gap: Sequence[int], segments: Sequence[Segment]) -> bool:
    """Return True if the arc does not cross the omitted sides, whose indices are `gap`.

    The omitted sides are then outside the circle of the arc, and on the same side of its chord as the arc. The
    result is also True if no side was omitted.
    """
    if not gap:
        return True
    if arc is None:
        return False
    points = np.concatenate([chords(segments[k], CLOSE_SHARE * arc.radius)[1] for k in gap])
    chord = arc.end - arc.start
    sense = np.sign(cross(chord, arc.at(0.5) - arc.start))
    clear = norm(points - arc.center) >= (1 - CLOSE_SHARE) * arc.radius
    return bool((clear & (sense * cross(chord, points - arc.start) > 0)).all())


def _corners(
    table: SegmentTable, before: IntArray, after: IntArray, gaps: BoolArray, radius: float
) -> tuple[IntArray, IntArray, FloatArray, list[Arc | None]]:
    """Return the k corners between sides `before` (n,) and `after` (n,), with their arcs of `radius` mm.

    The result is the indices (k,) of the sides before and after each corner, the parameters (k, 2), from 0 to 1
    along these sides, at which the arc begins and ends, and the arcs. If a side is too short, its parameter is
    outside this range. `gaps` (n,) is True for corners at which sides were omitted.
    """
    s = table.at(before, np.ones(before.size), 1)
    t = table.at(after, np.zeros(after.size), 1)
    turn = turn_between(s, t)
    # pieces of a curve fitted to points meet at smaller angles
    sharp = (np.abs(turn) >= 0.02) | gaps
    before, after, turn, s, t = before[sharp], after[sharp], turn[sharp], s[sharp], t[sharp]
    # the centre of an arc is at the distance `side` (positive to the left) from both sides of the corner
    side = (radius * np.sign(turn))[:, None]
    reach = radius * np.tan(np.abs(turn) / 2)
    # parameters (k, 2) of the ends of the arcs; at first, as if the sides were straight
    x = np.column_stack([1 - reach / norm(s), reach / norm(t)]).clip(0.0, 1.0)
    open_ = np.arange(before.size)
    ends = np.zeros((4, before.size, 2))  # position and velocity at the start of each arc, and at its end
    fits, turned_back = np.zeros(before.size, dtype=bool), np.zeros(before.size, dtype=int)
    for _ in range(40):
        near, far = (
            (table.at(sides[open_], x[open_, k]), table.at(sides[open_], x[open_, k], 1))
            for k, sides in enumerate((before, after))
        )
        ends[:, open_] = *near, *far
        # difference of the two centres that the two sides give
        gap = _offset_points(*near, side[open_]) - _offset_points(*far, side[open_])
        apart = np.abs(gap).max(axis=1) >= CLOSE_MM
        fits[open_[~apart]] = True
        # Newton's method treats the sides as straight, because their curvature is small
        v, w, gap = near[1][apart], far[1][apart], gap[apart]
        open_ = open_[apart]
        determinant = cross(w, v)
        # if the sides are parallel, the computed arc then ends beyond the sides
        determinant[determinant == 0] = 1e-200
        target = x[open_] + np.column_stack([cross(gap, w), cross(gap, v)]) / determinant[:, None]
        outside = (target < 0) | (target > 1)
        turned_back[open_] += outside.any(axis=1)
        halfway = (x[open_] + target.clip(0.0, 1.0)) / 2
        # a step that would pass the end of a side is shortened; after six such steps the side is too short
        given_up = turned_back[open_] > 6
        x[open_] = np.where(outside & ~given_up[:, None], halfway, target)
        open_ = open_[~given_up]
        if not open_.size:
            break
    x[open_] = -1.0, 2.0  # outside the range: no arc was found
    start, leaving, end, entering = ends
    bulges = np.tan(turn_between(leaving, entering) / 4)
    arcs = [
        Arc.from_bulge(first, last, bulge) if fit else None
        for first, last, bulge, fit in zip(start, end, bulges.tolist(), fits.tolist(), strict=True)
    ]
    return before, after, x, arcs


def _offset_points(points: FloatArray, velocities: FloatArray, distance: FloatArray) -> FloatArray:
    return points + distance * left_of(velocities) / norm(velocities)[:, None]
