"""Paths: open or closed chains of lines, arcs and splines, and their distance from points."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from math import dist

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import is_number, numbers, require_flag, several
from elastica_cad.errors import InputError
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import (
    angle_of,
    box_around,
    dot,
    is_similarity,
    norm,
    place,
    require_affine,
)
from elastica_cad.geometry.segments import (
    Arc,
    Line,
    Segment,
    Spline,
    chords,
    chords_of_all,
    point,
    segment_from_bulge,
)
from elastica_cad.refusals import Length

_BLOCK = 4096
"""Number of points whose distances from all chords of a spline are computed at a time."""

_NEWTON_STEPS = 6
_ROUNDING_SHARE = 1e-12  # rounding error of a distance from a curve, as a fraction of its length
# Newton's method stops at a step below this fraction of the domain
_SETTLED = 1e-12


def distances(segment: Segment, points: ArrayLike) -> FloatArray:
    """Return the least distances (n,), mm, of points (n, 2) from a segment, except for rounding errors."""
    p = np.asarray(points, dtype=float).reshape(-1, 2)
    if isinstance(segment, Line):
        return _to_chords(p, segment.start[None], segment.end[None])[0][:, 0]
    if isinstance(segment, Arc):
        return _to_arc(p, segment)
    blocks = [p[i : i + _BLOCK] for i in range(0, max(len(p), 1), _BLOCK)]
    return np.concatenate([_to_spline(block, segment) for block in blocks])


def polyline_distances(line: FloatArray, points: FloatArray) -> FloatArray:
    """Return the least distances (n,), mm, of points (n, 2) from a polyline with vertices (m, 2)."""
    rows = max(1, _BLOCK * _BLOCK // (16 * len(line)))
    return np.concatenate(
        [
            _to_chords(points[i : i + rows], line[:-1], line[1:])[0].min(axis=1)
            for i in range(0, len(points), rows)
        ]
    )


def largest_deviation(target: PlaneCurve, found: PlaneCurve) -> float:
    """Return the largest distance, mm, of 401 points of `found` from `target`.

    The result is 0 if the distance is a rounding error.
    """
    if found is target:
        return 0.0
    points, rounding = found.sample(401).position, _ROUNDING_SHARE * found.length
    if np.abs(points - target.sample(401).position).max() <= rounding:
        return 0.0
    off = float(distances(Spline(target), points).max())
    return off if off > rounding else 0.0


def _to_chords(p: FloatArray, a: FloatArray, b: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return distances (n, m) of n points from m chords, and the nearest places (n, m) on the chords, in 0..1."""
    (x, y), (dx, dy) = a.T, (b - a).T
    left, down = p[:, :1] - x, p[:, 1:] - y
    square = dx**2 + dy**2
    where = left * dx
    where += down * dy
    where /= np.where(square > 0, square, 1.0)
    np.clip(where, 0.0, 1.0, out=where)
    return np.hypot(where * dx - left, where * dy - down), where


def _to_arc(p: FloatArray, arc: Arc) -> FloatArray:
    off = p - arc.center
    on = np.mod(np.sign(arc.sweep) * (angle_of(off) - arc.start_angle), 2 * np.pi) <= abs(arc.sweep)
    ends = [norm(p - end) for end in (arc.start, arc.end)]
    return np.where(on, np.abs(norm(off) - arc.radius), np.minimum(*ends))


def _to_spline(p: FloatArray, spline: Spline) -> FloatArray:
    """Return the distances (n,), mm, of points (n, 2) from a spline: Newton's method from the nearest chords."""
    flat = 1e-3 * max(1.0, spline.length / 100)
    u, q = chords(spline, flat)
    chord, where = _to_chords(p, q[:-1], q[1:])
    # keep all chords that may be the nearest, because chords differ from the spline
    close = chord <= chord.min(axis=1, keepdims=True) + 2 * flat
    # of neighbouring chords, only the nearest is kept
    close[:, 1:] &= chord[:, 1:] < chord[:, :-1]
    close[:, :-1] &= chord[:, :-1] <= chord[:, 1:]
    rows, i = np.nonzero(close)
    t = spline.parameter(u[i] + where[rows, i] * np.diff(u)[i])
    curve, (t0, t1) = spline.curve, spline.curve.domain
    count, p = len(p), p[rows]
    best = np.full(rows.size, np.inf)
    for _ in range(_NEWTON_STEPS + 1):
        position, d1, d2 = curve.derivatives(t, 2)
        off = position - p
        best = np.minimum(best, norm(off))
        slope = dot(d1, d1) + dot(off, d2)
        step = dot(off, d1) / np.where(slope > 0, slope, dot(d1, d1))
        before, t = t, (t - step).clip(t0, t1)
        if np.abs(t - before).max(initial=0.0) <= _SETTLED * (t1 - t0):
            break
    low, high = spans = spline.parameter(np.stack([u[i], u[i + 1]]))
    # Newton's method failed: it left the chord, did not converge, or found a point beyond the chord's distance
    failed = (np.abs(t - (low + high) / 2) > high - low) | (np.abs(t - before) > 1e-7 * (t1 - t0))
    failed |= best > chord[rows, i] + flat
    if failed.any():
        found, _ = nearest_by_sampling(
            lambda t: curve.evaluate(t.clip(t0, t1)), p[failed], *spans[:, failed], rounds=20
        )
        best[failed] = np.minimum(best[failed], found)
    least = np.full(count, np.inf)
    np.minimum.at(least, rows, best)
    return least


def nearest_by_sampling(
    at: Callable[[FloatArray], FloatArray],
    points: FloatArray,
    low: FloatArray,
    high: FloatArray,
    *,
    rounds: int,
) -> tuple[FloatArray, FloatArray]:
    """Return the least distances (n,) of points (n, d) from a curve, and the nearest parameters (n,).

    Each round of sampling reduces the interval of a point to a quarter or less. This succeeds where Newton's method
    fails because of an uneven speed.

    Parameters
    ----------
    at : callable
        Function of parameters (n, 9) that returns points (n, 9, d) of the curve.
    low, high : (n,) array
        Interval in which the nearest parameter of each point is.
    """
    rows = np.arange(len(points))
    for _ in range(rounds):
        t = low[:, None] + (high - low)[:, None] * np.linspace(0.0, 1.0, 9)
        gap = np.linalg.norm(at(t) - points[:, None], axis=2)
        k = gap.argmin(axis=1)
        low, high = t[rows, np.maximum(k - 1, 0)], t[rows, np.minimum(k + 1, 8)]
    return gap[rows, k], t[rows, k]


JOIN = 1e-6
"""Largest gap between the ends of neighbouring segments, mm."""


def meets(before: Segment, after: Segment, within: float = JOIN) -> bool:
    """Return True if the segment `before` ends where the segment `after` starts, within a distance, mm."""
    return dist(before.end.tolist(), after.start.tolist()) <= within


@dataclass(frozen=True, eq=False)
class Path:
    """Chain of segments whose ends meet within 1e-6 mm.

    Parameters
    ----------
    segments : sequence of Line, Arc, Spline
        Each segment begins where the previous segment ends.
    closed : bool
        True if the last segment ends at the start of the first segment.

    Examples
    --------
    >>> plate = Path.rectangle(40, 10)
    >>> plate.area, plate.length
    (400.0, 100.0)
    """

    segments: tuple[Segment, ...]
    closed: bool = False

    def __init__(self, segments: Sequence[Segment], closed: bool = False) -> None:
        vars(self).update(
            segments=several("the segments of a path", segments, Segment, "Line, Arc and Spline"),
            closed=require_flag(closed, "closed"),
        )
        if not self.segments:
            raise InputError("the path has no segment: give at least one segment")
        for segment, after in self._joints:
            gap = dist(after.start.tolist(), segment.end.tolist())
            if not gap <= JOIN:
                raise InputError(
                    "the path has a gap of {gap} at {end}: let its segments meet there",
                    gap=Length(gap),
                    end=place(segment.end),
                )

    @property
    def _joints(self) -> Iterable[tuple[Segment, Segment]]:
        """Each segment with the segment after it."""
        following = self.segments[1:] + (self.segments[:1] if self.closed else ())
        return zip(self.segments, following, strict=False)

    @classmethod
    def polyline(cls, points: ArrayLike, bulges: ArrayLike | None = None, *, closed: bool = False) -> "Path":
        """Return a path of lines through `points` (n, 2), or of arcs for nonzero bulges, as in DXF files.

        A bulge is tan(turn / 4) for the angle `turn` of the arc. Repeated points are omitted. A closed path may
        repeat its first point at the end.
        """
        p = numbers(points, "the points of a polyline")
        if p.ndim != 2 or p.shape[1:] != (2,) or not np.isfinite(p).all():
            raise InputError(
                "the points of a polyline cannot be read: give an array (n, 2) of finite numbers, in mm"
            )
        b = np.zeros(len(p)) if bulges is None else numbers(bulges, "the bulges of a polyline")
        if b.shape != (len(p),) or not np.isfinite(b).all():
            raise InputError(
                "the bulges of a polyline do not match its points: give one finite bulge per point"
            )
        after = np.roll(p, -1, axis=0) if require_flag(closed, "closed") else p[1:]
        segments = [
            segment_from_bulge(start, end, float(bulge))
            for start, end, bulge in zip(p, after, b, strict=False)
            if np.any(start != end)
        ]
        return cls(segments, closed)

    @classmethod
    def polygon(cls, points: ArrayLike) -> "Path":
        """Return the closed path of lines through `points` (n, 2)."""
        return cls.polyline(points, closed=True)

    @classmethod
    def rectangle(cls, width: float, height: float, *, corner: ArrayLike = (0.0, 0.0)) -> "Path":
        """Return a closed rectangle, anticlockwise from its lower left `corner`, mm."""
        if not (is_number(width) and is_number(height) and width > 0 and height > 0):
            raise InputError(f"a rectangle has sides of {width} and {height} mm: give positive sides")
        x, y = point(corner, "the corner of a rectangle")
        return cls.polygon([(x, y), (x + width, y), (x + width, y + height), (x, y + height)])

    @classmethod
    def circle(cls, center: ArrayLike, radius: float) -> "Path":
        """Return a circle as a single anticlockwise arc."""
        return cls((Arc(center, radius, 0.0, 2 * np.pi),), closed=True)

    @property
    def start(self) -> FloatArray:
        """First point (2,), mm."""
        return self.segments[0].start

    @property
    def end(self) -> FloatArray:
        """Last point (2,), mm."""
        return self.segments[-1].end

    @property
    def widest_gap(self) -> float:
        """Largest gap between the end of a segment and the start of the next, mm; at most `JOIN`."""
        gaps = (dist(before.end.tolist(), after.start.tolist()) for before, after in self._joints)
        return max(gaps, default=0.0)

    @cached_property
    def length(self) -> float:
        """Length of the path, mm."""
        return float(sum(segment.length for segment in self.segments))

    @cached_property
    def area(self) -> float:
        """Area inside a closed path, mm2: positive if the path is anticlockwise, negative if clockwise."""
        if not self.closed:
            raise InputError("an open path has no area: close it first")
        return sum(segment.swept_area(self.start) for segment in self.segments)

    @cached_property
    def bounds(self) -> FloatArray:
        """Exact bounding box [[x_min, y_min], [x_max, y_max]], mm."""
        return box_around(np.array([segment.bounds for segment in self.segments]))

    def reversed(self) -> "Path":
        """Return the path with its direction reversed."""
        return Path([segment.reversed() for segment in reversed(self.segments)], self.closed)

    def transformed(self, matrix: ArrayLike) -> "Path":
        """Return the image of the path under a 3x3 affine matrix.

        Arcs become splines unless the matrix is a similarity.
        """
        m = require_affine(matrix)
        even = is_similarity(m)
        plain = [s.as_spline() if isinstance(s, Arc) and not even else s for s in self.segments]
        return Path([s.transformed(m) for s in plain], self.closed)

    def moved(self, x: float, y: float) -> "Path":
        """Return the path shifted by (x, y) mm."""
        return self.transformed([[1.0, 0.0, x], [0.0, 1.0, y], [0.0, 0.0, 1.0]])

    def points(self, tolerance: float) -> FloatArray:
        """Return points (n, 2) on the path, whose polyline is within `tolerance` mm of the path.

        The first point of a closed path is not repeated at the end.
        """
        which, points = chords_of_all(self.segments, tolerance)
        begins = points[:-1][which[1:] == which[:-1]]
        points = begins if self.closed else np.append(begins, self.end[None], axis=0)
        if self.closed and len(points) < 3 and not all(isinstance(s, Line) for s in self.segments):
            # a thin closed path needs more points, so that its polygon has an area
            return self.points(tolerance / 4)
        return points

    def closed_points(self, tolerance: float) -> FloatArray:
        """Return `points`, with the first point of a closed path repeated at the end."""
        points = self.points(tolerance)
        return np.concatenate([points, points[:1]]) if self.closed else points

    @property
    def has_splines(self) -> bool:
        """True if a segment is a spline."""
        return any(isinstance(segment, Spline) for segment in self.segments)
