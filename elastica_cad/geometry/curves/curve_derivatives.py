"""Positions and derivatives of rational Bezier pieces, their tangent angle, and how smooth they are at knots."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import pairwise
from math import comb, perm

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.errors import InputError
from elastica_cad.geometry.curves.arc_length import ArcLength, arc_length_table
from elastica_cad.geometry.polynomials.bernstein import (
    binomials,
    interior_roots,
    product,
    raise_degree,
    subdivide,
    sums_in_pieces,
)
from elastica_cad.geometry.polynomials.splines import Spans
from elastica_cad.refusals import Length, note

_STANDSTILL_SHARE = 1e-9  # of the largest speed on the span; a curve slower than that stands still
_STILL_SPAN = 1e-14  # of the largest speed of all; a span that is nowhere faster is a point
_ALONG_SHARE = 1e-9  # of a velocity, that it has along the axis of its cone
_MOST_HALVINGS = 27  # halvings of a knot span; a direction that still is undecided there is a cusp


@dataclass(frozen=True, eq=False)
class TangentAngle:
    """Angle of the tangent over the cones of the curve, continued from one to the next.

    Attributes
    ----------
    edges : (k + 1,) array
        Parameters t at which the cones meet.
    axis : (k, 2) array
        Unit middle direction of each cone.
    angle : (k,) array
        Angle of that direction, continued from cone to cone.
    spread : float
        Between the least and the largest angle of the curve, rad, or a little more.
    """

    edges: FloatArray
    axis: FloatArray
    angle: FloatArray
    spread: float

    def at(self, t: FloatArray, velocity: FloatArray, *, left: bool = False) -> FloatArray:
        """Angle (n,) of velocities (n, 2) at parameters (n,), without jumps of 2 pi."""
        cone = np.searchsorted(self.edges[1:-1], t, side="left" if left else "right")
        return np.asarray(self.angle[cone] + turn_between(self.axis[cone], velocity), dtype=float)


def hodograph(bezier: FloatArray) -> FloatArray:
    """Bernstein coefficients (p, n, 2) along the velocity of homogeneous Bezier pieces (p, degree + 1, 3).

    The derivative by u times the squared weight: w P' - P w' (degree times left out).
    """
    a, b = bezier[:, :-1], bezier[:, 1:]
    if np.ptp(bezier[..., 2]) == 0:
        return np.asarray((b - a)[..., :2])
    aw, bw = a[..., 2], b[..., 2]
    return np.stack([product(aw, b[..., k]) - product(a[..., k], bw) for k in (0, 1)], axis=-1)


@dataclass(frozen=True, eq=False)
class TangentCones:
    """Parts of a curve within which the velocity stays in an open half plane.

    Attributes
    ----------
    edges : (k + 1,) array
        Parameters at which they meet.
    hodographs : (k, n, 2) array
        Bernstein coefficients along the velocity.
    standstill : float or None
        Parameter of the first place where the velocity vanishes (cusp, coincident control points); the other
        fields are of no use then.
    """

    edges: FloatArray
    hodographs: FloatArray
    standstill: float | None = None


def tabulate_tangent_angle(cones: TangentCones) -> TangentAngle:
    """The turning angle of a curve without cusp; at a tangent break it jumps by the exterior angle."""
    first, last = _unit(cones.hodographs[:, [0, -1]].swapaxes(0, 1))
    axis = _unit(first + last)
    # the velocity runs between its coefficients
    off_axis = turn_between(axis[:, None], cones.hodographs)
    to_start, to_end = off_axis[:, 0], off_axis[:, -1]
    across = turn_between(last[:-1], first[1:])
    angle = np.empty(len(axis))
    angle[0] = np.arctan2(first[0, 1], first[0, 0]) - to_start[0]
    angle[1:] = to_end[:-1] + across - to_start[1:]
    angle = angle.cumsum()
    reached = angle[:, None] + off_axis
    return TangentAngle(cones.edges, axis, angle, float(reached.max() - reached.min()))


def cut_into_tangent_cones(hodographs: FloatArray, edges: FloatArray) -> TangentCones:
    """The tangent cones of pieces whose velocities have Bernstein coefficients (p, n, 2)."""
    part, low, width = hodographs, edges[:-1], edges[1:] - edges[:-1]
    size = np.hypot(part[..., 0], part[..., 1])
    largest = size.max(axis=1)
    still = largest <= _STILL_SPAN * largest.max()
    stopped = np.concatenate(
        [low[(size[:, 0] <= 1e-12 * largest) | still], (low + width)[size[:, -1] <= 1e-12 * largest]]
    )
    if stopped.size:
        return TangentCones(edges, part, float(stopped.min()))
    starts: list[FloatArray] = []
    found: list[FloatArray] = []
    slowest = _STANDSTILL_SHARE * largest
    for _ in range(_MOST_HALVINGS):
        if not low.size:
            break
        axis = _unit(part[:, [0, -1]]).sum(axis=1)
        along = (part @ axis[:, :, None])[:, :, 0]
        decided = (along > _ALONG_SHARE * size).all(axis=1) & (size[:, [0, -1]].min(axis=1) > slowest)
        if not starts and decided.all():
            return TangentCones(edges, part)
        starts.append(low[decided])
        found.append(part[decided])
        rest = ~decided
        left, right = subdivide(np.swapaxes(part[rest], 1, 2))
        part = np.swapaxes(np.concatenate([left, right]), 1, 2)
        width, slowest = np.tile(width[rest] / 2, 2), np.tile(slowest[rest], 2)
        low = np.concatenate([low[rest], low[rest] + width[: rest.sum()]])
        size = np.hypot(part[..., 0], part[..., 1])
    if low.size:
        return TangentCones(edges, part, float((low + width / 2).min()))
    begin, coefficients = np.concatenate(starts), np.concatenate(found)
    order = np.argsort(begin, kind="stable")
    return TangentCones(np.append(begin[order], edges[-1]), coefficients[order])


def _unit(v: FloatArray) -> FloatArray:
    length = np.hypot(v[..., :1], v[..., 1:])
    return np.asarray(v / np.where(length > 0, length, 1.0))


def turn_between(u: FloatArray, v: FloatArray) -> FloatArray:
    """Angles (...,) from directions u to directions v (..., 2), rad in (-pi, pi], positive to the left."""
    cross = u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]
    return np.asarray(np.arctan2(cross, u[..., 0] * v[..., 0] + u[..., 1] * v[..., 1]))


@dataclass(frozen=True, eq=False)
class RationalPieces:
    """A curve as homogeneous Bezier pieces over the spans of its knots.

    Attributes
    ----------
    spans : Spans
        The knot spans.
    control_points : (m, 3) array
        Rows x w, y w, w.
    rational : bool
        Do the weights differ?
    """

    spans: Spans
    control_points: FloatArray
    rational: bool

    @cached_property
    def bezier(self) -> FloatArray:
        """Rows x w, y w, w of every span, (p, degree + 1, 3)."""
        return self.spans.bezier(self.control_points)

    @property
    def edges(self) -> FloatArray:
        """Parameters (p + 1,) at which the pieces meet."""
        return self.spans.edges

    @property
    def ends(self) -> tuple[list[float], list[float]]:
        """First and last point, as x w, y w, w."""
        return self.bezier[0, 0].tolist(), self.bezier[-1, -1].tolist()

    def inside(self, t: FloatArray) -> FloatArray:
        """The parameters, rounding beyond the ends taken off; others outside are refused."""
        a, b = self.edges[0], self.edges[-1]
        inside = np.minimum(np.maximum(t, a), b)
        if not np.abs(t - inside).max(initial=0.0) <= 1e-9 * (b - a):
            raise InputError("parameter outside the curve: use {a:g} to {b:g}", a=a, b=b)
        return np.asarray(inside)

    def at(self, t: FloatArray, order: int, *, left: bool = False) -> list[FloatArray]:
        """Position and derivatives d/dt up to `order`, each (n, 2)."""
        return self.within(*self.spans.locate(self.inside(t), left=left), order)

    def within(self, index: IntArray, u: FloatArray, order: int) -> list[FloatArray]:
        """Evaluate at local coordinates u (n,) of spans (n,)."""
        rows = [sums_in_pieces(self._series(k), index, u) for k in range(order + 1)]
        if self.rational:
            parts = quotient([row[:, :2].T for row in rows], [row[:, 2] for row in rows])
            rows = [part.T for part in parts]
        rows[0] = rows[0] + self._origins[index]
        return rows

    def beside_knots(self, order: int) -> tuple[list[FloatArray], list[FloatArray]]:
        """Derivatives up to `order` just before and just after the p - 1 interior knots, each (p - 1, 2)."""
        knots = self.edges.size - 2
        before = np.arange(knots)
        both = self.within(np.concatenate([before, before + 1]), np.repeat([1.0, 0.0], knots), order)
        return [d[:knots] for d in both], [d[knots:] for d in both]

    def speed(self, index: IntArray, t: FloatArray) -> FloatArray:
        """Lengths (n,) of the velocities d/dt, mm, at parameters (n,) of spans (n,)."""
        u = (t - self.edges[index]) / self.spans.widths[index]
        u = np.minimum(np.maximum(u, 0.0), 1.0)
        if self.rational:
            return norm(self.within(index, u, 1)[1])
        return norm(sums_in_pieces(self._series(1), index, u))

    def stationary(self) -> FloatArray:
        """Parameters (k,) of the knots and of all places where x or y is stationary."""
        velocity, edges = hodograph(self.bezier), self.edges
        inner = interior_roots(np.concatenate([velocity[..., 0], velocity[..., 1]]))
        at, u = np.array([r.piece for r in inner], dtype=int) % len(velocity), np.array([r.u for r in inner])
        return np.concatenate([edges, edges[at] + u * (edges[at + 1] - edges[at])])

    @cached_property
    def arc_length(self) -> ArcLength:
        """Arc length as a function of the parameter."""
        return arc_length_table(self.speed, self.edges)

    @cached_property
    def tangent_cones(self) -> TangentCones:
        """Parts of the curve within which it turns by less than half a turn."""
        return cut_into_tangent_cones(hodograph(self.bezier), self.edges)

    def _series(self, order: int) -> FloatArray:
        """The derivative d/dt of this order of all pieces, (p, degree + 1, 2 or 3), in a scaled Bernstein basis."""
        if order not in self._known:
            degree, widths = self.spans.degree, self.spans.widths[:, None, None]
            if order > degree:
                return np.zeros_like(self._local)
            # derivatives overflow where knots nearly coincide: callers that need them refuse such curves
            with np.errstate(over="ignore", invalid="ignore"):
                rate = perm(degree, order) / widths**order
                self._known[order] = _raised(degree, order) @ np.diff(self._local, order, axis=1) * rate
        return self._known[order]

    @cached_property
    def _known(self) -> dict[int, FloatArray]:
        """The series that were asked for, by order."""
        return {}

    @cached_property
    def _local(self) -> FloatArray:
        """Bezier points (p, degree + 1, 2 or 3) of the pieces, w among them where weights differ.

        Each piece is seen from its middle control point, from which the others are subtracted without rounding: the
        second derivatives of short pieces far from the origin would otherwise carry that of their coordinates.
        """
        near = self.control_points[self.spans.first[:, None] + np.arange(self.spans.degree + 1)]
        near[..., :2] -= near[..., 2:] * self._origins[:, None, :]
        return np.asarray(self.spans.matrix @ near[..., : 3 if self.rational else 2])

    @cached_property
    def _origins(self) -> FloatArray:
        """Middle control points (p, 2) of the pieces, mm."""
        middle = self.control_points[self.spans.first + self.spans.degree // 2]
        return np.asarray(middle[:, :2] / middle[:, 2:])


@lru_cache(maxsize=64)
def _raised(degree: int, times: int) -> FloatArray:
    """Scaled Bernstein coefficients of `degree` from plain ones of `times` degrees less, (degree + 1, ...)."""
    c = np.eye(degree + 1 - times)
    for _ in range(times):
        c = raise_degree(c) if c.shape[1] > 1 else np.repeat(c, 2, axis=1)
    return np.ascontiguousarray((c * binomials(degree)).T)


def quotient(numerators: list[FloatArray], weights: list[FloatArray]) -> list[FloatArray]:
    """Derivatives (k, n) of P / w from those of P (k, n) and w (n,), by Leibniz' rule."""
    out: list[FloatArray] = []
    for k, numerator in enumerate(numerators):
        value = numerator.copy()
        for j in range(1, k + 1):
            value -= comb(k, j) * weights[j] * out[k - j]
        out.append(value / weights[0])
    return out


def curvature(d1: FloatArray, d2: FloatArray) -> FloatArray:
    """Signed curvature (n,) from first and second derivatives (n, 2) by any parameter."""
    speed = norm(d1)
    return np.asarray(cross(d1, d2) / (speed * speed * speed))


def curvature_slope(d1: FloatArray, d2: FloatArray, d3: FloatArray) -> FloatArray:
    """Derivative of the curvature by arc length (n,), from derivatives (n, 2) by any parameter."""
    speed2 = dot(d1, d1)
    square = speed2 * speed2
    return np.asarray(cross(d1, d3) / square - 3 * cross(d1, d2) * dot(d1, d2) / (square * speed2))


def norm(v: FloatArray) -> FloatArray:
    """Lengths (n,) of vectors (n, 2)."""
    return np.asarray(np.hypot(v[:, 0], v[:, 1]))


def dot(u: FloatArray, v: FloatArray) -> FloatArray:
    """Products (n,) of pairs of vectors (n, 2)."""
    return np.asarray(u[:, 0] * v[:, 0] + u[:, 1] * v[:, 1])


def cross(u: FloatArray, v: FloatArray) -> FloatArray:
    """Determinants (n,) of pairs of vectors (n, 2)."""
    return np.asarray(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])


ORDERS_OF_SIDES = 3
"""Number of derivatives that `KnotSides` compares; higher ones follow from the multiplicity of a knot."""

SHORT_SPAN_SHARE = 1e-6
"""Knots nearer to each other than this share of the domain are examined on both sides of each knot only."""


@dataclass(frozen=True, eq=False)
class KnotSides:
    """Angle (rad), curvature and its slope just before and just after the interior knots, (3, p - 1) each."""

    before: FloatArray
    after: FloatArray

    @classmethod
    def of(cls, pieces: RationalPieces, turning: TangentAngle) -> "KnotSides":
        """Compare the curve on both sides of each knot."""
        sides = []
        for (_, d1, d2, d3), left in zip(pieces.beside_knots(3), (True, False), strict=True):
            angle = turning.at(pieces.edges[1:-1], d1, left=left)
            sides.append(np.array([angle, curvature(d1, d2), curvature_slope(d1, d2, d3)]))
        return cls(*sides)

    @classmethod
    def of_seam(cls, pieces: RationalPieces, turning: TangentAngle) -> "KnotSides":
        """Compare a closed curve (3, 1) where its end meets its start: before it closes, and after it begins."""
        sides = []
        for t, left in ((pieces.edges[-1:], True), (pieces.edges[:1], False)):
            _, d1, d2, d3 = pieces.at(t, 3, left=left)
            sides.append(
                np.array([turning.at(t, d1, left=left), curvature(d1, d2), curvature_slope(d1, d2, d3)])
            )
        turn = (sides[1][0] - sides[0][0] + np.pi) % (2 * np.pi) - np.pi
        sides[1][0] = sides[0][0] + turn
        return cls(*sides)

    @property
    def corners(self) -> FloatArray:
        """Exterior angles (p - 1,), rad."""
        return np.asarray(self.after[0] - self.before[0])


def knot_orders(pieces: RationalPieces, knots: FloatArray) -> IntArray:
    """Number of continuous derivatives at the interior knots (p - 1,), from their multiplicity."""
    t = pieces.edges[1:-1]
    repeated = np.searchsorted(knots, t, side="right") - np.searchsorted(knots, t)
    return np.asarray(pieces.spans.degree - repeated)


def agreeing_orders(sides: KnotSides, length: float) -> IntArray:
    """Number of the quantities angle, curvature and its slope, in this order, that agree on both sides."""
    before, after = sides.before, sides.after
    scale = 1 / length + np.maximum(np.abs(before[1]), np.abs(after[1]))
    allowed = np.array([np.full(scale.size, 1e-9), 1e-8 * scale, 1e-6 * scale**2])
    return np.asarray(np.cumprod(np.abs(before - after) <= allowed, axis=0).sum(axis=0))


def in_millimetres(point: FloatArray) -> str:
    """A place as it stands in messages."""
    return f"({point[0]:g}, {point[1]:g}) mm"


SHORT_HANDLE = 1e-3
"""A handle shorter than this share of the curve's size was drawn so short: it is not a result of missing
digits."""


def refuse_standstill(
    pieces: RationalPieces,
    control_points: FloatArray,
    shown: Callable[[FloatArray], str] = in_millimetres,
    rounding: float = 0.0,
) -> None:
    """Raise InputError, with the place, when the curve has zero length or a point without tangent.

    `shown` writes a point (2,) in mm the way the drawing program does; `rounding` is how far one may be from what
    was drawn, mm.
    """
    if np.ptp(control_points, axis=0).max() == 0:
        raise InputError("all control points coincide: the curve has zero length")
    t = pieces.tangent_cones.standstill
    if t is None:
        return
    place = shown(pieces.at(np.array([t]), 0)[0][0])
    twins = np.flatnonzero((np.diff(control_points, axis=0) == 0).all(axis=1))
    size = float(np.ptp(control_points, axis=0).max())
    where = note(
        "the curve has no tangent at {place}, {s} from its start",
        place=place,
        s=Length(_length_until(pieces, t)),
    )
    if not twins.size:
        raise InputError("{place}: it has a cusp; move or delete a control point there", place=where)
    cause = note("control points {one} and {next} coincide", one=twins[0], next=twins[0] + 1)
    if 2 * np.sqrt(2.0) * rounding > SHORT_HANDLE * size:
        raise InputError(
            "undecided at this precision: {place}, for {cause}, and the numbers in the file are "
            "exact to {rounding}, so a shorter handle is lost: save it with more decimals, or "
            "draw out the handle of that node",
            place=where,
            cause=cause,
            rounding=Length(rounding),
        )
    raise InputError(
        "{place}: {cause}; move or delete one of them (in a drawing program: draw out the "
        "handle of that node)",
        place=where,
        cause=cause,
    )


def _length_until(pieces: RationalPieces, t: float) -> float:
    edges = np.append(pieces.edges[pieces.edges < t], t)
    dense = [np.linspace(a, b, 65) for a, b in pairwise(edges)]
    return float(sum(norm(np.diff(pieces.at(places, 0)[0], axis=0)).sum() for places in dense))
