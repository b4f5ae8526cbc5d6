"""Plane NURBS curves: construction, evaluation, derivatives, continuity at knots, maps."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields
from functools import lru_cache
from itertools import pairwise
from math import comb, perm
from typing import Any, Self

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import ArrayLike, FloatArray, IntArray
from elastica_cad._values import is_whole, numbers, require_number, require_record
from elastica_cad.errors import InputError, Length, note
from elastica_cad.geometry.arc_length import ArcLength, arc_length_table
from elastica_cad.geometry.measured_points import MeasuredPoints, Provenance
from elastica_cad.geometry.plane_points import (
    angle_of,
    box_about,
    cross,
    dot,
    homogeneous,
    is_smooth_around,
    lengths_along,
    norm,
    place,
    project,
    rotated,
    turn_between,
    unit,
)
from elastica_cad.geometry.polynomials import (
    binomials,
    interior_roots,
    product,
    raise_degree,
    scaled_bernstein,
    subdivide_pieces,
    sums_in_pieces,
)
from elastica_cad.geometry.projective_maps import map_spline
from elastica_cad.geometry.splines import (
    Spans,
    adaptive_spline,
    bezier_spans,
    check_knots,
    closed_spline,
    distinct_points,
    finite,
    fit_spline,
    unit_circle_arc,
    whole_degree,
)

# a tangent cone contains a velocity if its component along the axis of the cone exceeds this fraction of the speed
_ALONG_SHARE = 1e-9
# largest number of halvings of a knot span; if the velocities are then not in one half plane, there is a cusp
_MOST_HALVINGS = 27


@dataclass(frozen=True, eq=False)
class TangentAngle:
    """Angle of the tangent of a curve as a continuous function.

    The curve is cut into parts. All tangents of a part are in a cone around a middle direction.

    Attributes
    ----------
    edges : (k + 1,) array
        Parameters at which the parts meet.
    axis : (k, 2) array
        Unit vector of the middle direction of each part.
    angle : (k,) array
        Angle of the middle direction of each part, rad, without jumps of 2 pi between parts.
    spread : float
        Upper bound on the difference between the largest and the smallest angle of the curve, rad.
    """

    edges: FloatArray
    axis: FloatArray
    angle: FloatArray
    spread: float

    def at(self, t: FloatArray, velocity: FloatArray, *, left: bool = False) -> FloatArray:
        """Return the angles (n,), rad, of velocities (n, 2) at parameters (n,), without jumps of 2 pi."""
        cone = self.edges[1:-1].searchsorted(t, side="left" if left else "right")
        return self.angle[cone] + turn_between(self.axis[cone], velocity)


def hodograph(bezier: FloatArray) -> FloatArray:
    """Return Bernstein coefficients (p, n, 2) of vectors parallel to the velocity of Bezier pieces.

    The pieces have homogeneous control points `bezier` (p, degree + 1, 3). The vectors are the velocities times
    w^2 / degree, with weight w.
    """
    a, b = bezier[:, :-1], bezier[:, 1:]
    if np.ptp(bezier[..., 2]) == 0:
        return (b - a)[..., :2]
    aw, bw = a[..., 2], b[..., 2]
    return np.stack([product(aw, b[..., k]) - product(a[..., k], bw) for k in (0, 1)], axis=-1)


@dataclass(frozen=True, eq=False)
class TangentCones:
    """Parts of a curve on which all velocities are in an open half plane.

    Attributes
    ----------
    edges : (k + 1,) array
        Parameters at which the parts meet.
    hodographs : (k, n, 2) array
        Bernstein coefficients of vectors parallel to the velocity, as returned by `hodograph`.
    standstill : float or None
        Parameter of the first point with zero velocity, at a cusp or at coincident control points. With such a
        point, the other attributes are undefined.
    """

    edges: FloatArray
    hodographs: FloatArray
    standstill: float | None = None


def tabulate_tangent_angle(cones: TangentCones) -> TangentAngle:
    """Return the tangent angle of a curve without cusp. At a corner, the angle jumps by the exterior angle."""
    first, last = unit(cones.hodographs[:, [0, -1]].swapaxes(0, 1))
    axis = unit(first + last)
    # velocities are in the convex hull of the coefficients, so bounds of the coefficients hold on the whole piece
    off_axis = turn_between(axis[:, None], cones.hodographs)
    to_start, to_end = off_axis[:, 0], off_axis[:, -1]
    across = turn_between(last[:-1], first[1:])
    angle = np.empty(len(axis))
    angle[0] = angle_of(first[0]) - to_start[0]
    angle[1:] = to_end[:-1] + across - to_start[1:]
    angle = angle.cumsum()
    reached = angle[:, None] + off_axis
    return TangentAngle(cones.edges, axis, angle, float(reached.max() - reached.min()))


def cut_into_tangent_cones(hodographs: FloatArray, edges: FloatArray) -> TangentCones:
    """Return the tangent cones of pieces whose velocities have Bernstein coefficients (p, n, 2).

    Piece i is between the parameters edges[i] and edges[i + 1].
    """
    part, low, width = hodographs, edges[:-1], np.diff(edges)
    size = norm(part)
    largest = size.max(axis=1)
    # a slower knot span is a single point
    still = largest <= 1e-14 * largest.max()
    stopped = np.concatenate(
        [low[(size[:, 0] <= 1e-12 * largest) | still], (low + width)[size[:, -1] <= 1e-12 * largest]]
    )
    if stopped.size:
        return TangentCones(edges, part, float(stopped.min()))
    starts: list[FloatArray] = []
    cones: list[FloatArray] = []
    # speed that counts as zero
    slowest = 1e-9 * largest
    for _ in range(_MOST_HALVINGS):
        if not low.size:
            break
        axis = unit(part[:, [0, -1]]).sum(axis=1)
        along = (part @ axis[:, :, None])[:, :, 0]
        decided = (along > _ALONG_SHARE * size).all(axis=1) & (size[:, [0, -1]].min(axis=1) > slowest)
        if not starts and decided.all():
            return TangentCones(edges, part)
        starts.append(low[decided])
        cones.append(part[decided])
        rest = ~decided
        part = np.concatenate(subdivide_pieces(part[rest]))
        width, slowest = np.tile(width[rest] / 2, 2), np.tile(slowest[rest], 2)
        low = np.concatenate([low[rest], low[rest] + width[: rest.sum()]])
        size = norm(part)
    if low.size:
        return TangentCones(edges, part, float((low + width / 2).min()))
    begin, coefficients = np.concatenate(starts), np.concatenate(cones)
    order = begin.argsort(kind="stable")
    return TangentCones(np.append(begin[order], edges[-1]), coefficients[order])


@dataclass(frozen=True, eq=False)
class RationalPieces:
    """Curve as homogeneous Bezier pieces over the spans of its knots.

    Attributes
    ----------
    spans : Spans
        Knot spans.
    control_points : (m, 3) array
        Homogeneous control points: rows x w, y w, w for weight w.
    rational : bool
        True if the weights differ.
    """

    spans: Spans
    control_points: FloatArray
    rational: bool

    @cached_property
    def bezier(self) -> FloatArray:
        """Homogeneous control points x w, y w, w of every span, (p, degree + 1, 3)."""
        return self.spans.bezier(self.control_points)

    @property
    def edges(self) -> FloatArray:
        """Parameters (p + 1,) of the ends of the p pieces."""
        return self.spans.edges

    def inside(self, t: FloatArray) -> FloatArray:
        """Return the parameters clipped to the domain, and refuse those that are clearly outside."""
        a, b = self.edges[0], self.edges[-1]
        inside = np.minimum(np.maximum(t, a), b)
        off = np.abs(t - inside)
        if not off.max(initial=0.0) <= 1e-9 * (b - a):
            raise InputError(
                f"parameter {t.flat[off.argmax()]:.12g} is outside the curve: use {a:g} to {b:g}"
            )
        return np.asarray(inside)

    def at(self, t: FloatArray, order: int, *, left: bool = False) -> list[FloatArray]:
        """Return the position and its derivatives d/dt up to `order`, each (n, 2), at parameters t (n,)."""
        return self.within(*self.spans.locate(self.inside(t), left=left), order)

    def within(self, index: IntArray, u: FloatArray, order: int) -> list[FloatArray]:
        """Return position and derivatives up to `order` at local coordinates u (n,) of the spans `index` (n,)."""
        # columns: x, y (and w of a rational curve), then their derivatives order by order
        if order not in self._known:
            self._known[order] = np.concatenate([self._series(k) for k in range(order + 1)], axis=2)
        values = sums_in_pieces(scaled_bernstein(self.spans.degree, u), self._known[order], index)
        size = values.shape[1] // (order + 1)
        rows = [values[:, k : k + size] for k in range(0, values.shape[1], size)]
        if self.rational:
            parts = _quotient([row[:, :2].T for row in rows], [row[:, 2] for row in rows])
            rows = [part.T for part in parts]
        rows[0] = rows[0] + self._origins[index]
        return rows

    def speed(self, index: IntArray, t: FloatArray) -> FloatArray:
        """Return the speed (n,), mm per unit of t, at parameters t (n,) of the spans `index` (n,)."""
        u = (t - self.edges[index]) / self.spans.widths[index]
        u = np.minimum(np.maximum(u, 0.0), 1.0)
        return norm(self.within(index, u, 1)[1])

    def extremes(self) -> FloatArray:
        """Return the parameters (k,) at which x or y may have an extreme value.

        These are the knots, and the stationary points of x or y on pieces that may leave the bounding box of the
        curve points at the knots.
        """
        points, edges = project(self.bezier), self.edges
        low, high = box_about(np.concatenate([points[:, 0], points[-1:, -1]]))
        # a piece is in the convex hull of its control points
        beyond = np.flatnonzero(((points < low) | (points > high)).any(axis=(1, 2)))
        if not beyond.size:
            return edges
        velocity = hodograph(self.bezier[beyond])
        inner = interior_roots(np.concatenate([velocity[..., 0], velocity[..., 1]]))
        # the polynomials are the x of all pieces, then the y of all pieces
        at = beyond[np.array([r.piece for r in inner], dtype=int) % beyond.size]
        return np.concatenate(
            [edges, edges[at] + np.array([r.u for r in inner]) * (edges[at + 1] - edges[at])]
        )

    @cached_property
    def arc_length(self) -> ArcLength:
        """Arc length as a function of the parameter."""
        return arc_length_table(self.speed, self.edges)

    @cached_property
    def tangent_cones(self) -> TangentCones:
        """Parts of the curve on which the tangent turns by less than 180 degrees."""
        return cut_into_tangent_cones(hodograph(self.bezier), self.edges)

    def _series(self, order: int) -> FloatArray:
        """Return derivatives of one order as coefficients (p, degree + 1, 2 or 3) of `scaled_bernstein`.

        The polynomials are raised to the degree of the curve.
        """
        degree, widths = self.spans.degree, self.spans.widths[:, None, None]
        if order > degree:
            return np.zeros_like(self._local)
        # ignore overflows of nearly equal knots, because callers refuse such curves
        with np.errstate(over="ignore", invalid="ignore"):
            rate = perm(degree, order) / widths**order
            return _raised(degree, order) @ np.diff(self._local, order, axis=1) * rate

    @cached_property
    def _known(self) -> dict[int, FloatArray]:
        return {}

    @cached_property
    def _local(self) -> FloatArray:
        """Bezier points (p, degree + 1, 2 or 3) of the pieces, with different weights as the third column.

        Coordinates are relative to the middle control point of each piece. With coordinates relative to the origin,
        second derivatives of short, distant pieces would have large rounding errors.
        """
        near = self.control_points[self.spans.columns]
        near[..., :2] -= near[..., 2:] * self._origins[:, None, :]
        return self.spans.matrix @ near[..., : 3 if self.rational else 2]

    @cached_property
    def _origins(self) -> FloatArray:
        return project(self.control_points[self.spans.first + self.spans.degree // 2])


@lru_cache(maxsize=64)
def _raised(degree: int, times: int) -> FloatArray:
    """Return the matrix that raises a Bernstein polynomial by `times` degrees, for `scaled_bernstein`."""
    c = np.eye(degree + 1 - times)
    for _ in range(times):
        c = raise_degree(c) if c.shape[1] > 1 else c.repeat(2, axis=1)
    return np.ascontiguousarray((c * binomials(degree)).T)


def _quotient(numerators: list[FloatArray], weights: list[FloatArray]) -> list[FloatArray]:
    """Return derivatives (k, n) of P / w from derivatives of P (k, n) and of w (n,), by Leibniz' rule."""
    out: list[FloatArray] = []
    for k, numerator in enumerate(numerators):
        value = numerator.copy()
        for j in range(1, k + 1):
            value -= comb(k, j) * weights[j] * out[k - j]
        out.append(value / weights[0])
    return out


def curvature(d1: FloatArray, d2: FloatArray) -> FloatArray:
    """Return the signed curvature (n,) from first and second derivatives (n, 2) by any parameter."""
    speed = norm(d1)
    return cross(d1, d2) / (speed * speed * speed)


def curvature_slope(d1: FloatArray, d2: FloatArray, d3: FloatArray) -> FloatArray:
    """Return the derivative of the curvature by arc length (n,), from derivatives (n, 2) by any parameter."""
    speed2 = dot(d1, d1)
    square = speed2 * speed2
    return cross(d1, d3) / square - 3 * cross(d1, d2) * dot(d1, d2) / (square * speed2)


def _curvature_bend(d1: FloatArray, d2: FloatArray, d3: FloatArray, d4: FloatArray) -> FloatArray:
    """Return the second derivative of the curvature by arc length (n,), from derivatives (n, 2)."""
    speed2 = dot(d1, d1)
    growth = dot(d1, d2) / speed2
    change = 18 * growth**2 - 3 * (dot(d1, d3) + dot(d2, d2)) / speed2
    bend = cross(d1, d4) + cross(d2, d3) - 7 * growth * cross(d1, d3) + change * cross(d1, d2)
    return bend / speed2**2.5


ORDERS_OF_SIDES = 4
"""Number of derivatives that `KnotSides` compares. Higher derivatives follow from the multiplicity of a knot.
"""

SHORT_SPAN_SHARE = 1e-6
"""Knot multiplicities prove continuity only if knots are at least this fraction of the domain apart."""


@dataclass(frozen=True, eq=False)
class KnotSides:
    """Tangent angle (rad), curvature and its two derivatives, (4, p - 1), on both sides of the interior knots."""

    before: FloatArray
    after: FloatArray

    @classmethod
    def of(cls, pieces: RationalPieces, turning: TangentAngle) -> "KnotSides":
        """Return the values on both sides of each interior knot."""
        t, knots = pieces.edges[1:-1], pieces.edges.size - 2
        index, u = np.append(np.arange(knots), np.arange(knots) + 1), np.repeat([1.0, 0.0], knots)
        both = pieces.within(index, u, ORDERS_OF_SIDES)
        before, after = [d[:knots] for d in both], [d[knots:] for d in both]
        return cls(_side(turning, t, before, left=True), _side(turning, t, after, left=False))

    @classmethod
    def of_seam(cls, pieces: RationalPieces, turning: TangentAngle) -> "KnotSides":
        """Return the values (4, 1) at the end of a closed curve and at its start."""
        before, after = (
            _side(turning, t, pieces.at(t, ORDERS_OF_SIDES, left=left), left=left)
            for t, left in ((pieces.edges[-1:], True), (pieces.edges[:1], False))
        )
        # remove the full turns between the end and the start of the curve
        after[0] = before[0] + (after[0] - before[0] + np.pi) % (2 * np.pi) - np.pi
        return cls(before, after)

    @property
    def corners(self) -> FloatArray:
        """Exterior angles (p - 1,), rad, of the corners at the interior knots."""
        return np.asarray(self.after[0] - self.before[0])


def _side(turning: TangentAngle, t: FloatArray, derivatives: list[FloatArray], *, left: bool) -> FloatArray:
    # the rows (4, n) of `KnotSides`, from position and four derivatives (n, 2) at parameters t (n,)
    _, d1, d2, d3, d4 = derivatives
    return np.array([
        turning.at(t, d1, left=left),
        curvature(d1, d2),
        curvature_slope(d1, d2, d3),
        _curvature_bend(d1, d2, d3, d4),
    ])  # fmt: skip


def agreeing_orders(sides: KnotSides, length: float) -> IntArray:
    """Return how many of angle, curvature and its derivatives, in this order, agree on both sides of each knot."""
    before, after = sides.before, sides.after
    scale = 1 / length + np.maximum(np.abs(before[1]), np.abs(after[1]))
    allowed = np.array([np.full(scale.size, 1e-9), 1e-8 * scale, 1e-6 * scale**2, 1e-4 * scale**3])
    return np.asarray(np.cumprod(np.abs(before - after) <= allowed, axis=0).sum(axis=0))


def _refuse_standstill(
    pieces: RationalPieces,
    control_points: FloatArray,
    shown: Callable[[FloatArray], str],
    rounding: float,
) -> None:
    """Refuse a curve whose speed is 0 somewhere, because it has no tangent there.

    The function `shown` formats a point (2,) for a message. `rounding` is the rounding of the file, mm.
    """
    size = np.ptp(control_points, axis=0).max()
    if size == 0:
        raise InputError("all control points coincide, so the curve has no length: draw the curve again")
    t = pieces.tangent_cones.standstill
    if t is None:
        return
    at = shown(pieces.at(np.array([t]), 0)[0][0])
    twins = np.flatnonzero((np.diff(control_points, axis=0) == 0).all(axis=1))
    dense = [np.linspace(a, b, 65) for a, b in pairwise(np.append(pieces.edges[pieces.edges < t], t))]
    length = sum(lengths_along(pieces.at(places, 0)[0])[-1] for places in dense)
    where = note(
        "the curve has no tangent at {place}, {s} from its start",
        place=at,
        s=Length(length),
    )
    if not twins.size:
        raise InputError(
            "the curve has a cusp, and {place}: move or delete a control point near this place",
            place=where,
        )
    cause = note("control points {one} and {next} coincide", one=twins[0], next=twins[0] + 1)
    # a longer handle, from the end of a piece to its next control point, is not a rounding error
    if 2 * np.sqrt(2.0) * rounding > 1e-3 * size:
        raise InputError(
            "after rounding to {rounding}, {cause}, so it is uncertain whether {place}. Save the file with more "
            "decimals, or lengthen the handle of that node",
            place=where,
            cause=cause,
            rounding=Length(rounding),
        )
    raise InputError(
        "{cause}, so {place}: move or delete one of these control points (in a drawing program: lengthen "
        "the handle of that node)",
        place=where,
        cause=cause,
    )


SAME_KNOT = 1e-12
"""A parameter closer to a knot than this fraction of the domain counts as the knot.

Without this rule, a knot span could be as short as rounding errors.
"""

MOST_TURNS = 100

MOST_UNEVEN = 1e8
"""Largest ratio of weights. With a larger ratio, points of the curve are lost in rounding errors."""


@dataclass(frozen=True, eq=False)
class NurbsCurve:
    """Curve with knots, control points and weights that has a tangent everywhere; see `PlaneCurve`."""

    knots: FloatArray
    control_points: FloatArray
    degree: int
    weights: FloatArray | None = None
    provenance: Provenance | None = None

    def __post_init__(self) -> None:
        degree, points = whole_degree(self.degree), finite("control_points", self.control_points)
        if points.ndim != 2 or points.shape[1] != 2:
            raise InputError(
                f"control_points have the shape {points.shape}: give rows of x and y, shape (m, 2)"
            )
        vars(self).update(degree=degree, control_points=points, knots=finite("knots", self.knots))
        check_knots(self.knots.tobytes(), len(points), degree)
        if self.weights is not None:
            weights = finite("weights", self.weights)
            if weights.shape != (len(points),):
                raise InputError(
                    f"there are {weights.size} weights for {len(points)} control points: give a weight "
                    "for each point"
                )
            if weights.min() <= 0:
                raise InputError(
                    f"the weight of control point {int(weights.argmin())} (from 0) is {weights.min():g}: "
                    "give positive weights"
                )
            if weights.max() > MOST_UNEVEN * weights.min():
                raise InputError(
                    f"the weights of the control points are {weights.min():.3g} to {weights.max():.3g}, a "
                    f"ratio above the limit of {MOST_UNEVEN:g}: export the curve without weights"
                )
            object.__setattr__(self, "weights", weights if np.ptp(weights) > 0 else None)
        provenance = self.provenance
        require_record(provenance, Provenance | None, "provenance", "what read_curves gives, or None")
        format_point, rounding = (
            (place, 0.0) if provenance is None else (provenance.shown, provenance.rounding)
        )
        steps = np.diff(points, axis=0)
        along = steps @ steps.sum(axis=0)
        # the speed is never zero if all sides of the control polygon advance along the chord
        if self.is_rational or along.min() <= 1e-6 * along.sum():
            _refuse_standstill(self._pieces, self.control_points, format_point, rounding)

    def __getstate__(self) -> dict[str, Any]:
        """Omit cached results, which are much larger than the other attributes and quickly computed again."""
        return {field.name: getattr(self, field.name) for field in fields(self)}

    def _part(
        self, knots: FloatArray, control_points: FloatArray, weights: FloatArray | None,
        provenance: Provenance | None = None,
    ) -> Self:  # fmt: skip
        """Return a part or a moved copy of this curve without checks."""
        curve = object.__new__(type(self))
        for array in (knots, control_points, weights):
            if array is not None:
                array.setflags(write=False)
        vars(curve).update(
            knots=knots,
            control_points=control_points,
            degree=self.degree,
            weights=weights,
            provenance=provenance,
        )
        return curve

    @classmethod
    def spline(cls, control_points: ArrayLike, degree: int = 4) -> Self:
        """Return the clamped B-spline with uniform knots and `control_points` (m, 2), m > degree."""
        points, degree = finite("control_points", control_points), whole_degree(degree)
        count = len(points) if points.ndim else 0
        if count <= degree:
            raise InputError(
                f"{count} control points are too few for degree {degree}: give {degree + 1} or more"
            )
        knots = np.concatenate([np.zeros(degree), np.linspace(0.0, 1.0, count - degree + 1), np.ones(degree)])
        return cls(knots, points, degree)

    @classmethod
    def line(cls, start: ArrayLike, end: ArrayLike, *, degree: int = 2) -> Self:
        """Return the straight segment between two points."""
        a, b = finite("start", start), finite("end", end)
        degree = whole_degree(degree)
        if a.shape != (2,) or b.shape != (2,):
            raise InputError("the line cannot be read: give two points of two numbers each, in mm")
        u = np.linspace(0.0, 1.0, degree + 1)[:, None]
        return cls(np.repeat([0.0, 1.0], degree + 1), a * (1 - u) + b * u, degree)

    @classmethod
    def arc(cls, center: ArrayLike, radius: float, start_angle: float, end_angle: float) -> Self:
        """Return the exact circular arc between two angles (rad), counterclockwise if end_angle > start_angle."""
        return cls.ellipse(center, (radius, radius), start=start_angle, end=end_angle)

    @classmethod
    def ellipse(
        cls,
        center: ArrayLike,
        semi_axes: ArrayLike,
        rotation: float = 0.0,
        start: float = 0.0,
        end: float = 2 * np.pi,
    ) -> Self:
        """Return the exact ellipse arc (a cos v, b sin v), v from start to end (rad), rotated and moved."""
        centre, axes = finite("center", center), finite("semi_axes", semi_axes)
        if centre.shape != (2,):
            raise InputError(f"the center is {centre.tolist()}: give two numbers, in mm")
        if axes.shape != (2,) or axes.min() <= 0:
            raise InputError(f"semi-axes (or the radius) are {axes.tolist()}: give positive numbers, in mm")
        turn, first, last = finite("angles", [rotation, start, end]).tolist()
        if first == last:
            raise InputError(
                "the arc has no length, because its start and end angles are equal: give different angles"
            )
        if not abs(last - first) <= MOST_TURNS * 2 * np.pi:
            raise InputError(
                f"the arc runs from {first:g} to {last:g} rad: give angles at most {MOST_TURNS} turns apart"
            )
        knots, points, weights = unit_circle_arc(first, last)
        return cls(knots, centre + rotated(points * axes, turn), 2, weights)

    @classmethod
    def fit(
        cls, points: ArrayLike, degree: int = 4, tolerance: float = 0.05, smoothing: float | None = None
    ) -> Self:
        """Return a spline with few control points whose distance from all `points` is at most `tolerance` mm.

        The curve contains the noise of measured points. Strips report noise that affects their widths. The option
        `smooth` of a strip removes the noise.

        Parameters
        ----------
        points : (n, 2) array_like
            Points in order, mm. The curve starts and ends exactly at the first and last point. If these points are
            equal, the curve is closed and smooth there.
        degree : int
            Degree of the spline: 3, 4 or 5.
        tolerance : float
            Largest distance of a point from the curve, mm.
        smoothing : float, optional
            Weight of the mean square third derivative (mm2, for a parameter from 0 to 1) relative to the mean
            square distance (mm2). With a given weight, the distance may exceed the tolerance. By default the weight
            depends on the noise of the points.

        Examples
        --------
        >>> v = np.linspace(0, 3, 60)
        >>> from elastica_cad.geometry.plane_curve import PlaneCurve
        >>> curve = PlaneCurve.fit(np.column_stack([100 * np.cos(v), 100 * np.sin(v)]), tolerance=1e-3)
        >>> round(curve.length, 2)
        300.0
        """
        data = distinct_points(points)
        closed = smoothing is None and is_smooth_around(data)
        knots, control_points = (
            closed_spline(data, degree, tolerance)
            if closed
            else fit_spline(data, degree, tolerance, smoothing)
        )
        return cls(knots, control_points, degree, provenance=Provenance(measured=MeasuredPoints.of(data)))

    @classmethod
    def fit_function(
        cls,
        function: Callable[[FloatArray], FloatArray],
        start: float,
        end: float,
        *,
        tolerance: float = 1e-6,
        degree: int = 4,
        breaks: Sequence[tuple[float, int]] = (),
    ) -> Self:
        """Return a spline within `tolerance` mm of a smooth function at every parameter.

        Parameters
        ----------
        function : callable
            Function of parameters (k,) between `start` and `end` that returns points (k, 2), mm.
        breaks : sequence of (parameter, continuity)
            Parameters at which the function has only `continuity` continuous derivatives. Knots are put there.

        Examples
        --------
        >>> from elastica_cad.geometry.plane_curve import PlaneCurve
        >>> spiral = PlaneCurve.fit_function(lambda v: np.column_stack([v * np.cos(v), v * np.sin(v)]), 3, 9)
        >>> round(spiral.length, 4)
        36.5433
        """
        for name, value in {"start": start, "end": end}.items():
            require_number(value, f"the {name} of a function")
        knots, control_points = adaptive_spline(
            function, (float(start), float(end)), degree=degree, tolerance=tolerance, breaks=breaks
        )
        return cls(knots, control_points, degree)

    def drawn_as(self, provenance: Provenance | None) -> Self:
        """Return the curve with another record of its origin."""
        return self._part(self.knots, self.control_points, self.weights, provenance)

    @property
    def domain(self) -> tuple[float, float]:
        """First and last parameter."""
        return float(self.knots[self.degree]), float(self.knots[-self.degree - 1])

    @property
    def is_rational(self) -> bool:
        """True if the weights of the control points differ."""
        return self.weights is not None

    def evaluate(self, t: ArrayLike, derivative: int = 0, *, left: bool = False) -> FloatArray:
        """Return the position, or its derivative d/dt of order 1 to 3, (..., 2), at parameters t (...).

        At a knot where the result jumps, the right-hand value is returned, or the left-hand value with `left=True`.
        """
        if not (is_whole(derivative) and 0 <= derivative <= 3):
            raise InputError(f"the order of a derivative is {derivative!r}: use 0 to 3")
        t = numbers(t, "parameters")
        return self._pieces.at(t.ravel(), derivative, left=left)[derivative].reshape(*t.shape, 2)

    def derivatives(self, t: FloatArray, order: int) -> list[FloatArray]:
        """Return positions and their derivatives d/dt up to `order`, (n, 2) each, at parameters (n,)."""
        return self._pieces.at(t, order)

    def basis(self, t: ArrayLike, derivative: int = 0) -> FloatArray:
        """Return the rational basis functions (n, m), or their derivatives d/dt, at parameters t (n,).

        The position is the sum of R_i(t) q_i, with basis functions R_i and control points q_i.
        """
        t = self._pieces.inside(np.atleast_1d(numbers(t, "parameters")))
        spans = self._pieces.spans
        if self.weights is None:
            return spans.basis(t, derivative)
        numerators = [(spans.basis(t, k) * self.weights).T for k in range(derivative + 1)]
        return _quotient(numerators, [rows.sum(axis=0) for rows in numerators])[derivative].T

    def with_control_points(self, control_points: ArrayLike) -> Self:
        """Return the curve with the same knots and weights, but other control points (m, 2)."""
        return type(self)(self.knots, numbers(control_points, "control_points"), self.degree, self.weights)

    def siblings(self, control_points: FloatArray) -> list[Self]:
        """Return n curves with the same knots, the given control points (n, m, 2) and no weights.

        The speed of the curves must be positive everywhere. A check would be slow for thousands of curves.
        """
        return [self._part(self.knots, points, None) for points in control_points]

    @property
    def bezier_table(self) -> tuple[FloatArray, FloatArray]:
        """Ends (p + 1,) and homogeneous control points (p, degree + 1, 3) of the knot spans.

        The arrays must not be modified.
        """
        return self._pieces.edges, self._pieces.bezier

    def reversed(self) -> Self:
        """Return the curve with its direction reversed."""
        weights = None if self.weights is None else self.weights[::-1]
        knots = self.knots[0] + self.knots[-1] - self.knots[::-1]
        provenance = self.provenance and self.provenance.reversed()
        return self._part(knots, self.control_points[::-1], weights, provenance)

    def trimmed(self, start: float, end: float) -> Self:
        """Return the part between two parameters as a new clamped curve, by Boehm's knot insertion."""
        p, start, end = self.degree, self._at_knot(start), self._at_knot(end)
        points = (self._pieces if self.is_rational else self).control_points.copy()
        last = int(self.knots.searchsorted(end)) - 1
        for r, row in enumerate(_de_boor(self.knots, points, last, end), 1):
            points[last - p + r] = row[0]
        knots = np.minimum(self.knots, end)
        # the start is inserted into the knots of the part up to the end
        first = int(knots.searchsorted(start, side="right")) - 1
        for r, row in enumerate(_de_boor(knots, points, first, start), 1):
            points[first - r] = row[-1]
        knots, rows = np.maximum(knots, start)[first - p : last + p + 2], points[first - p : last + 1]
        if self.is_rational:
            return self._part(knots, project(rows), rows[:, 2])
        return self._part(knots, rows, None)

    def _at_knot(self, t: float) -> float:
        low, high = self.domain
        nearest = float(self.knots[np.abs(self.knots - t).argmin()])
        return nearest if abs(nearest - t) <= SAME_KNOT * (high - low) else t

    def transformed(self, matrix: ArrayLike) -> Self:
        """Return the exact image under a projective map: matrix @ (x, y, 1) divided by its third component.

        If a strip with clamped ends can have this curve, a strip can also have the image (paper, section 4.3).
        """
        knots, points, weights = map_spline(
            self.knots,
            self.control_points,
            self.weights,
            matrix,
            degree=self.degree,
            pieces=lambda: (self._pieces.bezier, self._pieces.edges),
        )
        m = np.asarray(matrix, dtype=float)
        provenance = self.provenance and self.provenance.transformed(m)
        even = not m[2, :2].any()
        # larger coordinates lose digits, so the curve is validated again
        if even and np.abs(points).max() < 1e6 * np.ptp(points, axis=0).max():
            return self._part(knots, points, weights, provenance)
        return type(self)(knots, points, self.degree, weights, provenance)

    @cached_property
    def bounds(self) -> FloatArray:
        """Smallest box around the curve, [[x_min, y_min], [x_max, y_max]], mm."""
        points, (low, high) = self.control_points, self.domain
        box = box_about(points[[0, -1]])
        clamped = self.knots[0] == low and self.knots[-1] == high
        # the curve is in the convex hull of the control points
        if clamped and (points >= box[0]).all() and (points <= box[1]).all():
            return box
        return box_about(self.evaluate(self._pieces.extremes()))

    @cached_property
    def _pieces(self) -> RationalPieces:
        spans = bezier_spans(self.knots, self.degree)
        return RationalPieces(spans, homogeneous(self.control_points, self.weights), self.is_rational)


def _de_boor(knots: FloatArray, points: FloatArray, span: int, t: float) -> list[FloatArray]:
    """Return the rows of De Boor's triangle for parameter t in span `span`. The last row is the curve point."""
    degree = knots.size - len(points) - 1
    rows, near = [points[span - degree : span + 1]], knots[span - degree + 1 : span + degree + 1]
    for level in range(1, degree + 1):
        low, high = near[level - 1 : degree], near[degree : 2 * degree - level + 1]
        share = ((t - low) / (high - low))[:, None]
        rows.append(rows[-1][:-1] * (1 - share) + rows[-1][1:] * share)
    return rows[1:]
