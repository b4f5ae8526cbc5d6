"""The curve of a strip: arc length, tangent, curvature, inflections, corners, crossings."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from math import hypot

import numpy as np

from elastica_cad._notebook import BLUE, svg_of_lines
from elastica_cad._types import ArrayLike, BoolArray, FloatArray, IntArray
from elastica_cad._values import (
    is_number,
    is_series,
    numbers,
    pair,
    require_flag,
    require_number,
    require_record,
)
from elastica_cad.errors import InputError, quoted
from elastica_cad.geometry import curvature_zeros as zeros
from elastica_cad.geometry.curvature_zeros import ZeroKind, line_places
from elastica_cad.geometry.nurbs_curve import (
    ORDERS_OF_SIDES,
    SHORT_SPAN_SHARE,
    KnotSides,
    NurbsCurve,
    TangentAngle,
    agreeing_orders,
    curvature,
    curvature_slope,
    knot_orders,
    tabulate_tangent_angle,
)
from elastica_cad.geometry.plane_points import norm
from elastica_cad.geometry.self_intersections import find_self_intersections
from elastica_cad.geometry.splines import adaptive_spline, finite
from elastica_cad.refusals import Length


@dataclass(frozen=True, eq=False)
class CurveSamples:
    """Points of a curve, all arrays over the same n places.

    Attributes
    ----------
    s : (n,) array
        Arc length from the start, mm.
    position : (n, 2) array
        Points, mm.
    angle : (n,) array
        Turning angle, rad, continuous along the curve.
    curvature : (n,) array
        Signed curvature, 1/mm, positive to the left.
    t : (n,) array
        Parameter of the curve.
    """

    s: FloatArray
    position: FloatArray
    angle: FloatArray
    curvature: FloatArray
    t: FloatArray


@dataclass(frozen=True)
class CurvatureZero:
    """A point (or, if flat, a stretch) where the curvature vanishes or jumps to the other sign.

    Attributes
    ----------
    s, s_end : float
        Arc length, mm; s_end differs from s for a straight piece only.
    t, t_end : float
        The same points in the curve's parameter.
    kind : str
        "crossing" (sign change), "touch" (none), "end" (at an end of the curve), "jump" (the sign changes by
        a jump at a knot), "flat" (a straight piece s..s_end).
    before, after : int
        Sign of the curvature on either side; 0 beyond the ends of the curve.
    """

    s: float
    t: float
    kind: ZeroKind
    s_end: float
    t_end: float
    before: int
    after: int

    @property
    def changes_sign(self) -> bool:
        """True if the curvature has opposite signs before and after."""
        return self.before * self.after < 0


@dataclass(frozen=True)
class Break:
    """An interior knot.

    Attributes
    ----------
    s, t : float
        Arc length (mm) and parameter.
    continuity : int
        Number of continuous derivatives with respect to arc length: 0 tangent break, 1 curvature jump,
        2 kink of the curvature, ... (at least; orders above 3 follow from the knot's multiplicity).
    """

    s: float
    t: float
    continuity: int


@dataclass(frozen=True)
class TangentBreak:
    """A corner: arc length (mm), parameter, and the exterior angle (rad)."""

    s: float
    t: float
    angle: float


SURVEY_POINTS = 601  # number of points of the sample that all functions share

DRAWN_POINTS = 301  # number of points of a curve in a notebook, a few pixels apart

CORNER_RAD = 1e-5
"""Smallest jump of the direction, rad, that counts as a corner."""

ROUNDED_ZERO_SHARE = 1e-6
"""Largest rounding error of a zero of the curvature, as a fraction of the length of a piece."""

_ROUNDING = 1e-10  # rounding error of an angle, as a fraction of the angle


@dataclass(frozen=True, eq=False)
class PlaneCurve(NurbsCurve):
    """A plane NURBS curve of degree 2 or more, with any knots.

    Parameters
    ----------
    knots : (m + degree + 1,) array_like
        Full knot vector, not decreasing, clamped or not; the curve runs over
        knots[degree] .. knots[-degree - 1].
    control_points : (m, 2) array_like
        Control points, mm.
    degree : int
        Polynomial degree, at least 2.
    weights : (m,) array_like, optional
        Positive weights of a rational curve.
    provenance : Provenance, optional
        Record of the curve's origin in a file.

    Raises
    ------
    InputError
        The numbers do not define a curve with a tangent everywhere: too few or non-finite control points, knots
        that decrease or break the curve apart, weights not positive, zero length, a cusp.

    Examples
    --------
    >>> curve = PlaneCurve.spline([(0, 0), (30, 40), (60, 40), (90, 0)], degree=3)
    >>> round(curve.length, 3)
    112.078
    """

    def curvature_at(self, t: ArrayLike, *, left: bool = False) -> FloatArray:
        """Return the signed curvature, 1/mm, at parameters t."""
        t = numbers(t, "parameters")
        return curvature(*self._pieces.at(t.ravel(), 2, left=require_flag(left, "left"))[1:]).reshape(t.shape)

    def curvature_slope_at(self, t: ArrayLike, *, left: bool = False) -> FloatArray:
        """Return the derivative of the curvature by arc length, 1/mm2, at parameters t."""
        t = numbers(t, "parameters")
        return curvature_slope(*self._pieces.at(t.ravel(), 3, left=require_flag(left, "left"))[1:]).reshape(
            t.shape
        )

    def angle_at(self, t: ArrayLike, *, left: bool = False) -> FloatArray:
        """Return the turning angle, rad, at parameters t: continuous along the curve, in [-pi, pi] at its start."""
        t = numbers(t, "parameters")
        _, d1 = self._pieces.at(t.ravel(), 1, left=require_flag(left, "left"))
        return self._turning.at(t.ravel(), d1, left=left).reshape(t.shape)

    def __repr__(self) -> str:
        rational = ", rational" if self.weights is not None else ""
        points = len(self.control_points)
        return (
            f"<PlaneCurve of degree {self.degree}{rational}, {points} control points, {self.length:.4g} mm>"
        )

    def _repr_svg_(self) -> str:
        return svg_of_lines([(self.sample(DRAWN_POINTS).position, BLUE, False)], repr(self))

    @cached_property
    def length(self) -> float:
        """Arc length, mm."""
        return float(self._pieces.arc_length.s[-1])

    def arc_length(self, t: ArrayLike) -> FloatArray:
        """Return the arc length from the start, mm, at parameters t."""
        t = numbers(t, "parameters")
        return self._pieces.arc_length.length_at(self._pieces.inside(t.ravel())).reshape(t.shape)

    def parameter(self, s: ArrayLike) -> FloatArray:
        """Return parameters at arc lengths s (mm)."""
        s = numbers(s, "arc lengths")
        slack = 1e-9 * self.length
        if s.size and not (s.min() >= -slack and s.max() <= self.length + slack):
            raise InputError("arc length outside the curve: use 0 to {length:g}", length=Length(self.length))
        inside = np.minimum(np.maximum(s.ravel(), 0.0), self.length)
        return self._pieces.arc_length.parameter_at(inside).reshape(s.shape)

    @property
    def smooth_panels(self) -> FloatArray:
        """Parameters, including both ends, between which a Gauss rule of 16 points is exact to rounding."""
        return self._pieces.arc_length.t

    def at(self, s: ArrayLike) -> CurveSamples:
        """Return the position, angle and curvature at arc lengths s (n,)."""
        s = np.atleast_1d(numbers(s, "arc lengths"))
        if s.ndim > 1:
            raise InputError(f"arc lengths are an array of {s.ndim} dimensions: give one row")
        t = self.parameter(s)
        position, d1, d2 = self._pieces.at(t, 2)
        return CurveSamples(s, position, self._turning.at(t, d1), curvature(d1, d2), t)

    def sample(self, count: int) -> CurveSamples:
        """`count` points at equal distances along the curve, both ends included."""
        if not (is_number(count) and count >= 2):
            raise InputError(f"a curve must be sampled at 2 or more points, not {count!r}")
        return self.at(np.linspace(0.0, self.length, int(count)))

    @cached_property
    def survey(self) -> CurveSamples:
        """The curve at `SURVEY_POINTS` equal distances, evaluated once; its arrays are read-only."""
        nodes = self.sample(SURVEY_POINTS)
        for values in (nodes.s, nodes.position, nodes.angle, nodes.curvature, nodes.t):
            values.setflags(write=False)
        return nodes

    @cached_property
    def curvature_zeros(self) -> tuple[CurvatureZero, ...]:
        """All zeros and sign changes of the curvature, in order."""
        places = zeros.curvature_zero_places(
            self._pieces.bezier, self._pieces.edges, self._curvature_continuous
        )
        return self._measured(self._polished(places))

    def curvature_equals(self, level: float) -> tuple[CurvatureZero, ...]:
        """Return all points where the curvature is `level` (1/mm), with the signs of curvature - level."""
        level = require_number(level, "the curvature to look for", "1/mm")
        if level == 0:
            return self.curvature_zeros
        return self.zeros_along(lambda t: self.curvature_at(t) - level, abs(level))

    def zeros_along(
        self,
        function: Callable[[FloatArray], FloatArray],
        size: float,
        breaks: Sequence[tuple[float, bool]] = (),
    ) -> tuple[CurvatureZero, ...]:
        """Return all zeros and sign changes of a function along the curve, in order.

        Parameters
        ----------
        function : callable
            Maps parameters (k,) to values (k,); as smooth as the curvature, except at `breaks`.
        size : float
            Typical size of the function, to which tolerances are relative.
        breaks : sequence of (parameter, bool)
            Parameters of its kinks, and True where it is continuous.
        """
        if not callable(function) or not (is_number(size) and size > 0):
            raise InputError(f"zeros of {quoted(function)}, whose size is {quoted(size)}, cannot be found: give a "
"callable and a positive size")  # fmt: skip
        low, high = self.domain
        places = dict(
            zip(self._pieces.edges[1:-1].tolist(), self._curvature_continuous.tolist(), strict=True)
        )
        for t, continuous in (pair(item, "a break") for item in (breaks if is_series(breaks) else [breaks])):
            near = min(places, key=lambda known: abs(known - t), default=low)
            at = near if abs(near - t) < 1e-9 * (high - low) else t
            if low < at < high:
                places[at] = places.get(at, True) and bool(continuous)
        edges = np.array([low, *sorted(places), high])
        smooth = np.array([places[t] for t in sorted(places)], dtype=bool)
        return self._measured(zeros.function_zero_places(function, edges, smooth, size))

    @cached_property
    def inflections(self) -> FloatArray:
        """Arc lengths (k,), mm, where the curvature changes sign; if it does so along a straight piece, the
        middle."""
        return np.array([(z.s + z.s_end) / 2 for z in self.curvature_zeros if z.changes_sign])

    @cached_property
    def breaks(self) -> tuple[Break, ...]:
        """All interior knots with their continuity."""
        t = self._pieces.edges[1:-1]
        return tuple(map(Break, self.arc_length(t).tolist(), t.tolist(), self._continuity.tolist()))

    @cached_property
    def tangent_breaks(self) -> tuple[TangentBreak, ...]:
        """Corners of more than 1e-5 rad, without the corner at the seam of a closed curve."""
        if self._pieces.edges.size == 2 or self._is_smooth(1):
            return ()
        angle = self._knot_sides.corners
        sharp = np.flatnonzero(np.abs(angle) > CORNER_RAD)
        t = self._pieces.edges[1:-1][sharp]
        return tuple(
            TangentBreak(*map(float, corner))
            for corner in zip(self.arc_length(t), t, angle[sharp], strict=True)
        )

    @cached_property
    def seam(self) -> Break | None:
        """Start of a closed curve with its continuity, or None for an open curve."""
        if not self.is_closed:
            return None
        return Break(0.0, self.domain[0], int(agreeing_orders(self._seam_sides, self.length)[0]))

    @property
    def seam_turn(self) -> float:
        """Jump of the direction, rad, at the seam of a closed curve; 0 for an open curve."""
        return float(self._seam_sides.corners[0]) if self.is_closed else 0.0

    @cached_property
    def has_corners(self) -> bool:
        """True if the direction jumps by more than 1e-5 rad anywhere, including the seam of a closed curve."""
        return bool(self.tangent_breaks) or abs(self.seam_turn) > CORNER_RAD

    @cached_property
    def is_straight(self) -> bool:
        """True if the whole curve is a straight segment."""
        flats = [(z.kind, z.before, z.after) for z in self.curvature_zeros]
        return flats == [("flat", 0, 0)] and not self.tangent_breaks  # straight everywhere

    @cached_property
    def is_closed(self) -> bool:
        """True if the ends meet within 1e-9 of the length."""
        (x0, y0, w0), (x1, y1, w1) = self._pieces.ends
        gap = hypot(x1 / w1 - x0 / w0, y1 / w1 - y0 / w0)
        return gap <= 1e-9 * self.length

    def self_intersections(self) -> FloatArray:
        """Return pairs of arc lengths (k, 2), mm, where the curve crosses or touches itself, in order."""
        if self._turning.spread <= np.pi * (1 + _ROUNDING):
            return np.zeros((0, 2))  # a curve that meets itself turns by more than 180 degrees
        bezier, edges = self._pieces.bezier, self._pieces.edges
        return self.arc_length(find_self_intersections(bezier, edges, lambda t: self.derivatives(t, 1)))

    @cached_property
    def _turning(self) -> TangentAngle:
        return tabulate_tangent_angle(self._pieces.tangent_cones)

    @cached_property
    def _continuity(self) -> IntArray:
        if self._is_smooth(ORDERS_OF_SIDES):
            return self._knot_orders
        return np.maximum(self._knot_orders, agreeing_orders(self._knot_sides, self.length))

    @cached_property
    def _knot_orders(self) -> IntArray:
        return knot_orders(self._pieces, self.knots)

    def _is_smooth(self, order: int) -> bool:
        """Return True if the knot multiplicities alone show that the curve is smooth to this order."""
        spans = self._pieces.spans
        apart = spans.widths.min() > SHORT_SPAN_SHARE * (spans.edges[-1] - spans.edges[0])
        return bool(apart and self._knot_orders.min(initial=order) >= order)

    @cached_property
    def _knot_sides(self) -> KnotSides:
        return KnotSides.of(self._pieces, self._turning)

    @cached_property
    def _seam_sides(self) -> KnotSides:
        return KnotSides.of_seam(self._pieces, self._turning)

    @cached_property
    def _curvature_continuous(self) -> BoolArray:
        return self._continuity >= 2

    def _polished(self, zero_places: tuple[zeros.ZeroPlace, ...]) -> tuple[zeros.ZeroPlace, ...]:
        """Refine crossings by a step of Newton's method, because coordinates of short pieces are rounded."""
        crossing = [i for i, place in enumerate(zero_places) if place.kind == "crossing"]
        if not crossing:
            return zero_places
        t, edges = np.array([zero_places[i].t for i in crossing]), self._pieces.edges
        index, u = self._pieces.spans.locate(t)
        _, d1, d2, d3 = self._pieces.within(index, u, 3)
        with np.errstate(divide="ignore", invalid="ignore"):
            better = t - curvature(d1, d2) / (curvature_slope(d1, d2, d3) * norm(d1))
        near = np.abs(better - t) < ROUNDED_ZERO_SHARE * (edges[index + 1] - edges[index])
        near &= (edges[index] < better) & (better < edges[index + 1])
        places = list(zero_places)
        for i, at in zip(np.array(crossing)[near], better[near].tolist(), strict=True):
            zero = zero_places[i]
            places[i] = zeros.ZeroPlace(at, at, zero.kind, zero.before, zero.after)
        return tuple(places)

    def _measured(self, places: tuple[zeros.ZeroPlace, ...]) -> tuple[CurvatureZero, ...]:
        s = self.arc_length(np.array([[place.t, place.t_end] for place in places]).reshape(-1, 2))
        return tuple(
            CurvatureZero(float(at), p.t, p.kind, float(to), p.t_end, p.before, p.after)
            for p, (at, to) in zip(places, s, strict=True)
        )


def line_crossings(curve: PlaneCurve, a: float, b: ArrayLike) -> tuple[CurvatureZero, ...]:
    """Return all intersections of a curve with the line a + <b, x> = 0, in order along the curve.

    Parameters
    ----------
    a : float
        Constant of the line.
    b : (2,) array_like
        Its normal (any length but 0).

    Examples
    --------
    >>> arch = PlaneCurve.arc((0, 0), 50, 0.0, np.pi)
    >>> [(root.kind, round(root.s, 3)) for root in line_crossings(arch, -50, (0, 1))]
    [('touch', 78.54)]
    """
    require_record(curve, PlaneCurve, "what a line crosses", "a PlaneCurve")
    normal, constant = finite("b", b), finite("a", a)
    if constant.shape:
        raise InputError(f"the constant of a line must be one number, not {constant.tolist()}")
    if normal.shape != (2,) or not normal.any():
        raise InputError(f"the normal of a line must be two numbers, not both zero: {normal.tolist()}")
    edges, bezier = curve.bezier_table
    crossings = line_places(bezier, edges, float(constant), normal)
    return curve._measured(crossings)


def clamp_ends(curve: PlaneCurve) -> PlaneCurve:
    """Return the curve with repeated end knots, so that it starts and ends on control points."""
    p, knots = curve.degree, curve.knots
    if knots[0] == knots[p] and knots[-1] == knots[-p - 1]:
        return curve
    return curve.trimmed(*curve.domain)


def split_at_corners(curve: PlaneCurve) -> tuple[PlaneCurve, ...]:
    """Return the smooth pieces of a curve, in order, or the curve itself if it has no corner.

    Examples
    --------
    >>> roof = PlaneCurve([0, 0, 0, 1, 1, 2, 2, 2], [(0, 0), (15, 20), (30, 40), (45, 20), (60, 0)], 2)
    >>> [round(piece.length, 6) for piece in split_at_corners(roof)]
    [50.0, 50.0]
    """
    low, high = curve.domain
    places = [low, *(corner.t for corner in curve.tangent_breaks), high]
    if len(places) == 2:
        return (curve,)
    drawn = curve.provenance and curve.provenance.of_part()
    return tuple(curve.trimmed(*ends).drawn_as(drawn) for ends in pairwise(places))


DEGREE = 5  # two continuous derivatives of the curvature, which checks of equilibrium use


def integrate_tangents(
    tangent: Callable[[FloatArray], FloatArray],
    length: float,
    start: FloatArray,
    *,
    tolerance: float,
    breaks: Sequence[tuple[float, int]] = (),
) -> PlaneCurve:
    """Return the spline of degree 5 from `start` (2,), mm, with arc length as its parameter, to the tolerance.

    Parameters
    ----------
    tangent : callable
        Maps arc lengths (k,), mm, to unit vectors (k, 2).
    tolerance : float
        Largest error of a tangent.
    breaks : sequence of (s, continuity)
        Places where the tangent is only `continuity` times differentiable.

    Examples
    --------
    >>> quarter = integrate_tangents(
    ...     lambda s: np.column_stack([np.cos(s), np.sin(s)]), np.pi / 2, np.zeros(2), tolerance=1e-9
    ... )
    >>> quarter.evaluate(np.array(np.pi / 2)).round(6).tolist()
    [1.0, 1.0]
    """
    knots, rows = adaptive_spline(
        tangent, (0.0, length), degree=DEGREE - 1, tolerance=tolerance, breaks=breaks
    )
    reach = (knots[DEGREE:] - knots[:-DEGREE]) / DEGREE  # integrals of the basis functions
    points = start + np.pad(np.cumsum(reach[:, None] * rows, axis=0), ((1, 0), (0, 0)))
    return PlaneCurve(np.pad(knots, 1, mode="edge"), points, DEGREE)
