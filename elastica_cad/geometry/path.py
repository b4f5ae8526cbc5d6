"""Paths: open or closed chains of lines, arcs and splines; their segments, and their distance from points."""

from collections.abc import Callable, Hashable, Iterable, Sequence
from dataclasses import dataclass
from math import acos, atan, atan2, ceil, cos, dist, floor, isfinite, pi, sin
from typing import TypeAlias

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import ArrayLike, FloatArray, IntArray
from elastica_cad._values import is_number, numbers, require_flag, require_number, require_positive, several
from elastica_cad.errors import InputError, Length
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import (
    angle_of,
    box_around,
    cross,
    distinct,
    dot,
    is_similarity,
    left_of,
    norm,
    place,
    require_affine,
    similarity_of,
    transform_points,
    unit,
    unit_vectors,
)
from elastica_cad.geometry.polynomials import gauss_rule
from elastica_cad.geometry.splines import SplineFunction, is_clamped

_FLATTEST_MM = 1e-7
"""An arc that rises less than this above its chord, mm, is replaced by a line."""

_FARTHEST_MM = 1e9
"""An arc with a larger radius than this, mm, is replaced by a line.

The ends of such an arc are not accurate to 1e-6 mm.
"""


@dataclass(frozen=True, eq=False)
class Line:
    """Straight segment.

    Parameters
    ----------
    start, end : (2,) array_like
        End points, mm; they must differ.

    Examples
    --------
    >>> Line((0, 0), (3, 4)).length
    5.0
    """

    start: FloatArray
    end: FloatArray

    def __init__(self, start: ArrayLike, end: ArrayLike) -> None:
        vars(self).update(start=point(start, "line start"), end=point(end, "line end"))
        if self.start.tolist() == self.end.tolist():
            raise InputError(f"a line at {place(self.start)} has no length: leave it out")

    @property
    def length(self) -> float:
        """Length, mm."""
        return dist(self.start.tolist(), self.end.tolist())

    @property
    def direction(self) -> tuple[float, float]:
        """Unit vector from start to end."""
        start, end = self.start.tolist(), self.end.tolist()
        size = dist(start, end)
        return (end[0] - start[0]) / size, (end[1] - start[1]) / size

    @property
    def bounds(self) -> FloatArray:
        """Bounding box [[x_min, y_min], [x_max, y_max]], mm."""
        (x0, y0), (x1, y1) = self.start.tolist(), self.end.tolist()
        return np.array([[min(x0, x1), min(y0, y1)], [max(x0, x1), max(y0, y1)]])

    def at(self, u: ArrayLike) -> FloatArray:
        """Return points (..., 2) at u in [0, 1]."""
        u = numbers(u, "u")[..., None]
        return self.start * (1 - u) + self.end * u

    def velocity_at(self, u: ArrayLike) -> FloatArray:
        """Return the derivative (..., 2) of `at` by u, mm."""
        return np.broadcast_to(self.end - self.start, (*numbers(u, "u").shape, 2)).copy()

    def tangent_at(self, u: ArrayLike) -> FloatArray:
        """Return unit tangents (..., 2) at u in [0, 1]."""
        return self.velocity_at(u) / self.length

    def swept_area(self, origin: ArrayLike = (0.0, 0.0)) -> float:
        """Return the signed area between `origin` and the line, mm2: half the integral of x dy - y dx."""
        origin = point(origin, "origin")
        return 0.5 * float(cross(self.start - origin, self.end - origin))

    def reversed(self) -> "Line":
        """Return the line with its direction reversed."""
        return Line(self.end, self.start)

    def transformed(self, matrix: ArrayLike) -> "Line":
        """Return the image of the line under a 3x3 affine matrix."""
        return self._image(require_affine(matrix))

    def _image(self, matrix: FloatArray) -> "Line":
        """Return the image under a matrix that `Path.transformed` has checked once for all its segments."""
        return Line(*transform_points(matrix, [self.start, self.end]))


@dataclass(frozen=True, eq=False)
class Arc:
    """Circular arc, anticlockwise if `end_angle` > `start_angle`; a full turn is a circle.

    Parameters
    ----------
    center : (2,) array_like
        Center, mm.
    radius : float
        Radius, mm, positive.
    start_angle, end_angle : float
        Angles from the x axis, rad; their difference is at most 2 pi.

    Examples
    --------
    >>> quarter = Arc((0, 0), 2.0, 0.0, 3.141592653589793 / 2)
    >>> round(quarter.length, 6), round(quarter.swept_area(), 6)
    (3.141593, 3.141593)
    """

    center: FloatArray
    radius: float
    start_angle: float
    end_angle: float

    def __init__(self, center: ArrayLike, radius: float, start_angle: float, end_angle: float) -> None:
        vars(self).update(
            center=point(center, "arc center"),
            radius=require_number(radius, "arc radius"),
            start_angle=require_number(start_angle, "arc start_angle"),
            end_angle=require_number(end_angle, "arc end_angle"),
        )
        if self.radius <= 0:
            raise InputError(
                "arc radius is {radius:g} at {center}: give a number above 0",
                radius=Length(self.radius),
                center=place(self.center),
            )
        if self.sweep == 0 or abs(self.sweep) > 2 * np.pi * (1 + 1e-12):
            raise InputError(
                f"arc at {place(self.center)} turns by {self.sweep:g} rad: give more than 0 and at most 2 pi"
            )

    @classmethod
    def from_bulge(cls, start: ArrayLike, end: ArrayLike, bulge: float) -> "Arc":
        """Return the arc between two points with `bulge` = tan(turn / 4), positive anticlockwise, as in DXF."""
        start, end = point(start, "arc start"), point(end, "arc end")
        require_number(bulge, "the bulge of an arc")
        (x0, y0), (x1, y1) = start.tolist(), end.tolist()
        if not bulge or (x0, y0) == (x1, y1):
            raise InputError(
                f"the arc from {place(start)} has equal ends or a bulge of 0: give different ends and a "
                "bulge other than 0"
            )
        square = bulge * bulge
        # signed distance of the center from the middle of the chord, divided by the chord
        off = (1 - square) / (4 * bulge)
        x, y = (x0 + x1) / 2 - (y1 - y0) * off, (y0 + y1) / 2 + (x1 - x0) * off
        first = atan2(y0 - y, x0 - x)
        radius = dist((x0, y0), (x1, y1)) * (1 + square) / (4 * abs(bulge))
        arc = cls((x, y), radius, first, first + 4 * atan(bulge))
        vars(arc).update(start=start, end=end)  # keep the exact end points
        return arc

    @property
    def sweep(self) -> float:
        """Angle of the arc, rad, positive anticlockwise."""
        return self.end_angle - self.start_angle

    @property
    def bulge(self) -> float:
        """Bulge of the arc in DXF polylines: tan(sweep / 4)."""
        return float(np.tan(self.sweep / 4))

    @property
    def is_circle(self) -> bool:
        """True if the arc is a full turn."""
        return abs(abs(self.sweep) - 2 * np.pi) < 1e-12

    @cached_property
    def start(self) -> FloatArray:
        """First point (2,), mm."""
        return self._end(self.start_angle)

    @cached_property
    def end(self) -> FloatArray:
        """Last point (2,), mm; exactly equal to `start` for a circle."""
        return self.start if self.is_circle else self._end(self.end_angle)

    @property
    def length(self) -> float:
        """Length, mm."""
        return self.radius * abs(self.sweep)

    @property
    def bounds(self) -> FloatArray:
        """Bounding box [[x_min, y_min], [x_max, y_max]], mm."""
        low, high = sorted((self.start_angle, self.end_angle))
        quarter = pi / 2
        poles = (quarter * k for k in range(ceil(low / quarter), floor(high / quarter) + 1))
        (x, y), r, angles = self.center.tolist(), self.radius, (low, high, *poles)
        across, up = [x + r * cos(angle) for angle in angles], [y + r * sin(angle) for angle in angles]
        return np.array([[min(across), min(up)], [max(across), max(up)]])

    def at(self, u: ArrayLike) -> FloatArray:
        """Return points (..., 2) at u in [0, 1], uniform in arc length."""
        return self.center + self.radius * unit_vectors(self.start_angle + self.sweep * numbers(u, "u"))

    def velocity_at(self, u: ArrayLike) -> FloatArray:
        """Return the derivative (..., 2) of `at` by u, mm."""
        return self.length * self.tangent_at(u)

    def tangent_at(self, u: ArrayLike) -> FloatArray:
        """Return unit tangents (..., 2) at u in [0, 1]."""
        forward = left_of(unit_vectors(self.start_angle + self.sweep * numbers(u, "u")))
        return forward if self.sweep > 0 else -forward

    def swept_area(self, origin: ArrayLike = (0.0, 0.0)) -> float:
        """Return the signed area between `origin` and the arc, mm2."""
        origin = point(origin, "origin")
        triangle = float(cross(self.start - origin, self.end - origin))
        return 0.5 * (triangle + self.radius**2 * _beyond_sine(self.sweep))

    def reversed(self) -> "Arc":
        """Return the arc with its direction reversed."""
        return Arc(self.center, self.radius, self.end_angle, self.start_angle)

    def transformed(self, matrix: ArrayLike) -> "Arc":
        """Return the image of the arc under a 3x3 affine matrix that moves, rotates, mirrors or scales."""
        return self._image(require_affine(matrix))

    def _image(self, matrix: FloatArray) -> "Arc":
        """Return the image under a matrix that `Path.transformed` has checked once for all its segments."""
        if not is_similarity(matrix):
            raise InputError(
                "an arc can only be moved, rotated, mirrored or scaled evenly: use a matrix of this kind"
            )
        scale, turn, sign = similarity_of(matrix)
        return Arc(
            transform_points(matrix, self.center),
            self.radius * scale,
            turn + sign * self.start_angle,
            turn + sign * self.end_angle,
        )

    def as_spline(self) -> "Spline":
        """Return the same arc as an exact rational spline."""
        return Spline(PlaneCurve.arc(self.center, self.radius, self.start_angle, self.end_angle))

    def _end(self, angle: float) -> FloatArray:
        # plain numbers are faster than arrays, and engraved texts have thousands of arcs
        x, y = self.center.tolist()
        return np.array([x + self.radius * cos(angle), y + self.radius * sin(angle)])


@dataclass(frozen=True, eq=False)
class Spline:
    """Segment along a whole `PlaneCurve`."""

    curve: PlaneCurve

    @property
    def start(self) -> FloatArray:
        """First point (2,), mm."""
        return self._ends[0]

    @property
    def end(self) -> FloatArray:
        """Last point (2,), mm."""
        return self._ends[1]

    @cached_property
    def _ends(self) -> tuple[FloatArray, FloatArray]:
        c = self.curve
        start, end = c.control_points[[0, -1]] if is_clamped(c.knots, c.degree) else self.at(_ENDS)
        return start, end

    @property
    def length(self) -> float:
        """Length, mm."""
        return float(self.curve.length)

    @property
    def bounds(self) -> FloatArray:
        """Bounding box [[x_min, y_min], [x_max, y_max]], mm."""
        return self.curve.bounds

    def parameter(self, u: ArrayLike) -> FloatArray:
        """Return the parameters of the curve at u in [0, 1]."""
        t0, t1 = self.curve.domain
        u = numbers(u, "u")
        return t0 * (1 - u) + t1 * u

    def at(self, u: ArrayLike) -> FloatArray:
        """Return points (..., 2) at u in [0, 1], which is proportional to the parameter of the curve."""
        return self.curve.evaluate(self.parameter(u))

    def velocity_at(self, u: ArrayLike) -> FloatArray:
        """Return the derivative (..., 2) of `at` by u, mm."""
        t0, t1 = self.curve.domain
        return self.curve.evaluate(self.parameter(u), 1) * (t1 - t0)

    def tangent_at(self, u: ArrayLike, *, left: bool = False) -> FloatArray:
        """Return unit tangents (..., 2) at u in [0, 1].

        At a corner, the result is the tangent after the corner, or before the corner with `left`.
        """
        d = self.curve.evaluate(self.parameter(u), 1, left=require_flag(left, "left"))
        return unit(d)

    def swept_area(self, origin: ArrayLike = (0.0, 0.0)) -> float:
        """Return the signed area between `origin` and the spline, mm2, by Gauss's rule on each Bezier piece.

        The result is exact without weights: the degree of x y' - y x' is at most 2 p - 1 for a spline of degree p.
        """
        origin = point(origin, "origin")
        edges, _ = self.curve.bezier_table
        # with 32 nodes, the area of a rational quarter circle is exact
        x, w = gauss_rule(32 if self.curve.is_rational else self.curve.degree)
        half = np.diff(edges)[:, None] / 2
        p, d = self.curve.derivatives((edges[:-1, None] + half * (1 + x)).ravel(), 1)
        return float(0.5 * ((half * w).ravel() * cross(p - origin, d)).sum())

    def reversed(self) -> "Spline":
        """Return the spline with its direction reversed."""
        return Spline(self.curve.reversed())

    def transformed(self, matrix: ArrayLike) -> "Spline":
        """Return the image of the spline under a 3x3 projective matrix."""
        return Spline(self.curve.transformed(matrix))


Segment: TypeAlias = Line | Arc | Spline


def segment_from_bulge(start: ArrayLike, end: ArrayLike, bulge: float) -> Line | Arc:
    """Return the arc from start to end with `bulge` = tan(turn / 4), or a line if the arc is too flat."""
    chord = float(norm(np.asarray(end, dtype=float) - np.asarray(start, dtype=float)))
    rise = abs(bulge) * chord / 2
    if rise < _FLATTEST_MM or chord**2 > 8 * rise * _FARTHEST_MM:
        return Line(start, end)
    return Arc.from_bulge(start, end, bulge)


def point(value: ArrayLike, name: str) -> FloatArray:
    """Return a point (2,), mm, as a read-only array. Refuse other values."""
    p = numbers(value, name).copy()
    if p.shape != (2,) or not all(map(isfinite, p.tolist())):
        raise InputError(f"{name} is {value!r}: give two finite numbers, in mm")
    p.setflags(write=False)
    return p


def _beyond_sine(x: float) -> float:
    """Return x - sin x without cancellation, for the area between a flat arc and its chord."""
    y = x * x
    near = x * y / 6 * (1 - y / 20 * (1 - y / 42 * (1 - y / 72 * (1 - y / 110))))
    return x - sin(x) if abs(x) > 0.3 else near


def trim_segment(segment: Segment, u0: float, u1: float) -> Segment:
    """Return the exact part of a segment between u0 and u1, with 0 <= u0 < u1 <= 1."""
    if not 0 <= u0 < u1 <= 1:
        raise InputError(f"a segment cannot be trimmed to {u0:g} .. {u1:g}: use 0 <= u0 < u1 <= 1")
    if (u0, u1) == (0, 1):
        return segment
    if isinstance(segment, Line):
        return Line(segment.at(u0), segment.at(u1))
    if isinstance(segment, Arc):
        a, sweep = segment.start_angle, segment.sweep
        return Arc(segment.center, segment.radius, a + u0 * sweep, a + u1 * sweep)
    return Spline(segment.curve.trimmed(float(segment.parameter(u0)), float(segment.parameter(u1))))


_PROBES = np.array([0.25, 0.5, 0.75])
"""Fractions of a parameter interval at which the distance of a segment from its chord is measured."""

_ENDS, _HALVES = np.array([0.0, 1.0]), np.array([0.0, 0.5, 1.0])

MOST_ROUNDS = 40
"""Largest number of halvings of an interval, which is then as short as rounding errors."""


def require_tolerance_mm(tolerance: float) -> float:
    """Return the tolerance, mm, and refuse it unless it is positive and finite."""
    require_positive(tolerance, "the tolerance")
    return float(tolerance)


def chords(segment: Segment, tolerance: float) -> tuple[FloatArray, FloatArray]:
    """Return parameters u (n,) and points (n, 2) of a segment.

    The chords between the points are within `tolerance` mm of the segment.
    """
    return _chords([segment], tolerance)[1:]


def _initial_parameters(segment: Segment, tolerance: float) -> FloatArray:
    """Return the parameters u (n,) of the ends of chords: final for lines and arcs, initial for splines."""
    tolerance = require_tolerance_mm(tolerance)
    if isinstance(segment, Line):
        return _ENDS
    if isinstance(segment, Arc):
        # a chord spans at most 120 degrees, so that the polygon of a circle has an area
        half = acos(min(max(1 - tolerance / segment.radius, 0.5), 1 - 1e-15))
        return np.linspace(0.0, 1.0, ceil(abs(segment.sweep) / (2 * half) - 1e-9) + 1)
    knots, (t0, t1) = segment.curve.knots, segment.curve.domain
    inner = knots[(knots > t0) & (knots < t1)]
    return distinct(np.concatenate([[0.0], (inner - t0) / (t1 - t0), [0.5, 1.0]])) if inner.size else _HALVES


_Motion: TypeAlias = Callable[[IntArray, FloatArray, int], FloatArray]
"""Function of segment indices (n,), parameters u (n,) and an order, for segments of one kind.

The function returns points (n, 2) for the order 0, and their derivatives by u for the order 1.
"""


class SegmentTable:
    """Lines, arcs and splines that are evaluated together.

    Segments of one kind share a motion, a function that evaluates all of them in one call: see `_Motion`.

    Examples
    --------
    >>> table = SegmentTable([Line((0, 0), (4, 0)), Arc((0, 0), 2.0, 0.0, np.pi)])
    >>> table.at(np.array([0, 1]), np.array([0.5, 0.5])).round(6).tolist()
    [[2.0, 0.0], [0.0, 2.0]]
    """

    def __init__(self, segments: Sequence[Segment]) -> None:
        kinds: dict[Hashable, list[int]] = {}
        for i, segment in enumerate(segments):
            kinds.setdefault(_kind(segment), []).append(i)
        # segment i is number `_number[i]` of the segments in the motion `_motions[_kind[i]]`
        self._kind, self._number = np.empty((2, len(segments)), dtype=int)
        self._motions: list[_Motion] = []
        for k, members in enumerate(kinds.values()):
            self._kind[members], self._number[members] = k, np.arange(len(members))
            self._motions.append(_motion([segments[i] for i in members]))

    def at(self, which: IntArray, u: FloatArray, derivative: int = 0) -> FloatArray:
        """Return points (n, 2), or derivatives by u, mm, at u (n,) in [0, 1] on segments with indices (n,)."""
        points, kind = np.empty((which.size, 2)), self._kind[which]
        for k, motion in enumerate(self._motions):
            here = kind == k
            if here.any():
                points[here] = motion(self._number[which[here]], u[here], derivative)
        return points


def chords_of_all(segments: Sequence[Segment], tolerance: float) -> tuple[IntArray, FloatArray]:
    """Return the points (n, 2) of the `chords` of all segments, and the segment index (n,) of each point."""
    return _chords(segments, tolerance)[::2]


def _chords(segments: Sequence[Segment], tolerance: float) -> tuple[IntArray, FloatArray, FloatArray]:
    """Return segment indices (n,), parameters u (n,) and points (n, 2) of the `chords` of all segments."""
    places = [_initial_parameters(segment, tolerance) for segment in segments]
    which, u = np.arange(len(places)).repeat([row.size for row in places]), np.concatenate(places)
    bent = np.array([isinstance(segment, Spline) for segment in segments])
    if not bent.any():
        at_places = [segment.at(u) for segment, u in zip(segments, places, strict=True)]
        return which, u, np.concatenate(at_places)
    at = SegmentTable(segments).at
    # insert points into the chords of bent segments until the chords are accurate
    spans = np.flatnonzero(bent[which][:-1] & (which[1:] == which[:-1]))
    number, low, high = which[spans], u[spans], u[spans + 1]
    points = at(which, u)
    begins, ends = points[spans], points[spans + 1]
    rounds = [(which, u, points)]
    while len(rounds) <= MOST_ROUNDS:
        inner = low[:, None] + (high - low)[:, None] * _PROBES
        probes = at(number.repeat(_PROBES.size), inner.ravel()).reshape(*inner.shape, 2)
        chord, off = ends - begins, probes - begins[:, None, :]
        size = dot(chord, chord)[:, None]
        # the distance of a point beyond an end of the chord, as in hairpins, is measured from this end
        along = np.divide(dot(off, chord[:, None]), size, out=np.zeros(off.shape[:2]), where=size > 0)
        errors = norm(off - along.clip(0.0, 1.0)[..., None] * chord[:, None]).max(axis=1)
        # the factor allows for a largest error between the probes
        bad = errors > 0.95 * tolerance
        if not bad.any():
            break
        number, middle, points = number[bad], inner[bad, 1], probes[bad, 1]
        rounds.append((number, middle, points))
        number, low, high = np.tile(number, 2), np.append(low[bad], middle), np.append(middle, high[bad])
        begins, ends = np.concatenate([begins[bad], points]), np.concatenate([points, ends[bad]])
    which, u, points = map(np.concatenate, zip(*rounds, strict=True))
    order = np.lexsort((u, which))
    return which[order], u[order], points[order]


def _kind(segment: Segment) -> Hashable:
    # segments with equal keys share a motion; a rational or unclamped spline is its own key
    if isinstance(segment, Spline):
        curve = segment.curve
        clamped = (curve.knots[0], curve.knots[-1]) == curve.domain
        return curve.degree if clamped and not curve.is_rational else segment
    return type(segment).__name__


def _motion(segments: Sequence[Segment]) -> _Motion:
    """Return a function that evaluates segments of one kind together, at different parameters."""
    arcs = [segment for segment in segments if isinstance(segment, Arc)]
    if arcs:
        centers = np.array([arc.center for arc in arcs])
        radii, starts, sweeps = np.array([(arc.radius, arc.start_angle, arc.sweep) for arc in arcs]).T

        def motion(which: IntArray, u: FloatArray, derivative: int) -> FloatArray:
            out = unit_vectors(starts[which] + u * sweeps[which] + derivative * np.pi / 2)
            out *= (radii[which] * sweeps[which] ** derivative)[:, None]
            return out if derivative else out + centers[which]

        return motion
    lines = [segment for segment in segments if isinstance(segment, Line)]
    splines = [segment for segment in segments if isinstance(segment, Spline)]
    if lines:
        ends = [np.array([line.start, line.end]) for line in lines]
        return _on_splines([np.array([0.0, 0.0, 1.0, 1.0])] * len(lines), ends, 1)
    first = splines[0]
    if len(splines) == 1:
        return lambda _, u, derivative: first.velocity_at(u) if derivative else first.at(u)
    return _on_splines(
        [(spline.curve.knots - spline.curve.knots[0]) / np.ptp(spline.curve.knots) for spline in splines],
        [spline.curve.control_points for spline in splines],
        first.curve.degree,
    )


def _on_splines(knots: Sequence[FloatArray], points: Sequence[FloatArray], degree: int) -> _Motion:
    """Return a function that evaluates all splines as one B-spline. Spline i has the parameters 2 i to 2 i + 1.

    The knots of each spline run from 0 to 1. Zero control points fill the unused spans between the splines.
    """
    nothing = np.zeros((degree + 1, 2))
    chain = [part for array in points for part in (array, nothing)][:-1]
    joined = SplineFunction(
        np.concatenate([2 * i + array for i, array in enumerate(knots)]), np.concatenate(chain), degree
    )

    def motion(which: IntArray, u: FloatArray, derivative: int) -> FloatArray:
        # the end of a spline belongs to the unused span after it, so evaluate just before the end
        at = np.minimum(2.0 * which + u, np.nextafter(2.0 * which + 1, 0.0))
        return joined(at, derivative)

    return motion


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
        off = p - segment.center
        turn = np.sign(segment.sweep) * (angle_of(off) - segment.start_angle)
        # True for points whose nearest point of the circle is on the arc
        on = np.mod(turn, 2 * np.pi) <= abs(segment.sweep)
        ends = [norm(p - end) for end in (segment.start, segment.end)]
        return np.where(on, np.abs(norm(off) - segment.radius), np.minimum(*ends))
    blocks = [p[i : i + _BLOCK] for i in range(0, max(len(p), 1), _BLOCK)]
    return np.concatenate([_to_spline(block, segment) for block in blocks])


def polyline_distances(line: FloatArray, points: FloatArray) -> FloatArray:
    """Return the least distances (n,), mm, of points (n, 2) from a polyline with vertices (m, 2)."""
    # blocks of points limit the memory for the distances from all chords
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
        images = (s.transformed(m) if isinstance(s, Spline) else s._image(m) for s in plain)
        return Path(list(images), self.closed)

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
