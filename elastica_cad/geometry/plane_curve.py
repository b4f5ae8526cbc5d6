"""Curve of a strip: arc length, tangent, curvature, inflections, corners, crossings."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._notebook import BLUE, svg_of_lines
from elastica_cad._types import ArrayLike, FloatArray, IntArray
from elastica_cad._values import (
    is_number,
    is_series,
    numbers,
    pair,
    require_flag,
    require_number,
    require_record,
)
from elastica_cad.errors import InputError, Length, quoted
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
    tabulate_tangent_angle,
)
from elastica_cad.geometry.plane_points import norm, project
from elastica_cad.geometry.self_intersections import find_self_intersections
from elastica_cad.geometry.splines import adaptive_spline, finite, is_clamped


@dataclass(frozen=True, eq=False)
class CurveSamples:
    """Samples of a curve at n points.

    Attributes
    ----------
    s : (n,) array
        Arc lengths from the start, mm.
    position : (n, 2) array
        Positions of the points, mm.
    angle : (n,) array
        Angles of the tangent, rad, continuous along the curve.
    curvature : (n,) array
        Signed curvatures, 1/mm, positive to the left.
    t : (n,) array
        Parameters of the points.
    """

    s: FloatArray
    position: FloatArray
    angle: FloatArray
    curvature: FloatArray
    t: FloatArray


@dataclass(frozen=True)
class CurvatureZero:
    """Point at which the curvature is zero or jumps to the other sign, or a straight piece.

    Attributes
    ----------
    s, s_end : float
        Arc length of the point, mm; for a straight piece, of its start and end.
    t, t_end : float
        Parameters of the same points.
    kind : str
        "crossing" (the sign changes), "touch" (the sign does not change), "end" (at an end of the curve), "jump"
        (the sign changes by a jump at a knot), or "flat" (a straight piece from s to s_end).
    before, after : int
        Signs of the curvature before and after the point; 0 beyond the ends of the curve.
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
    """Interior knot of a curve.

    Attributes
    ----------
    s, t : float
        Arc length (mm) and parameter of the knot.
    continuity : int
        Least number of continuous derivatives by arc length: 0 at a corner, 1 at a jump of the curvature, 2 at a
        kink of the curvature. Numbers above 4 are computed from the multiplicity of the knot.
    """

    s: float
    t: float
    continuity: int


@dataclass(frozen=True)
class TangentBreak:
    """Corner of a curve: arc length (mm), parameter, and exterior angle (rad)."""

    s: float
    t: float
    angle: float


SURVEY_POINTS = 601

DRAWN_POINTS = 301  # number of points of a curve in a notebook, at distances of a few pixels

CORNER_RAD = 1e-5
"""Smallest jump of the tangent direction, rad, that counts as a corner."""

ROUNDED_END_SHARE = 5e-4
"""Arc lengths beyond an end by at most this fraction of the length count as at the end.

The tolerance allows for lengths of four digits that users copy from reports, and for splines that are fitted to
a rod.
"""

_ROUNDING = 1e-10  # rounding error of an angle, as a fraction of the angle


@dataclass(frozen=True, eq=False)
class PlaneCurve(NurbsCurve):
    """Plane NURBS curve of degree 2 or more.

    Parameters
    ----------
    knots : (m + degree + 1,) array_like
        Full knot vector, clamped or not, without a decrease. The domain of the curve is from knots[degree] to
        knots[-degree - 1].
    control_points : (m, 2) array_like
        Control points, mm.
    degree : int
        Polynomial degree, at least 2.
    weights : (m,) array_like, optional
        Positive weights of a rational curve.
    provenance : Provenance, optional
        Record of the curve's origin in a file.

    Examples
    --------
    >>> curve = PlaneCurve.spline([(0, 0), (30, 40), (60, 40), (90, 0)], degree=3)
    >>> round(curve.length, 3)
    112.078
    """

    def curvature_at(self, t: ArrayLike, *, left: bool = False) -> FloatArray:
        """Return the signed curvature, 1/mm, at parameters t."""
        return curvature(*self._derivatives(t, 2, left)[1:]).reshape(np.shape(t))

    def curvature_slope_at(self, t: ArrayLike, *, left: bool = False) -> FloatArray:
        """Return the derivative of the curvature by arc length, 1/mm2, at parameters t."""
        return curvature_slope(*self._derivatives(t, 3, left)[1:]).reshape(np.shape(t))

    def angle_at(self, t: ArrayLike, *, left: bool = False) -> FloatArray:
        """Return the angle of the tangent, rad, at parameters t: continuous, and in [-pi, pi] at the start."""
        t = numbers(t, "parameters")
        _, d1 = self._derivatives(t, 1, left)
        return self._turning.at(t.ravel(), d1, left=left).reshape(t.shape)

    def _derivatives(self, t: ArrayLike, order: int, left: bool) -> list[FloatArray]:
        return self._pieces.at(numbers(t, "parameters").ravel(), order, left=require_flag(left, "left"))

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
        """Length of the curve, mm."""
        return float(self._pieces.arc_length.s[-1])

    def arc_length(self, t: ArrayLike) -> FloatArray:
        """Return the arc lengths from the start, mm, at parameters t."""
        t = numbers(t, "parameters")
        return self._pieces.arc_length.length_at(self._pieces.inside(t.ravel())).reshape(t.shape)

    def parameter(self, s: ArrayLike) -> FloatArray:
        """Return the parameters at arc lengths s, mm; see `ROUNDED_END_SHARE`."""
        s = numbers(s, "arc lengths")
        inside = np.minimum(np.maximum(s.ravel(), 0.0), self.length)
        off = np.abs(s.ravel() - inside)
        if not off.max(initial=0.0) <= ROUNDED_END_SHARE * self.length:
            raise InputError(
                "the arc length {s:g} is outside the curve: use 0 to {length:g}",
                s=Length(s.ravel()[off.argmax()]),
                length=Length(self.length),
            )
        return self._pieces.arc_length.parameter_at(inside).reshape(s.shape)

    @property
    def smooth_panels(self) -> FloatArray:
        """Parameters (k + 1,) at the ends of panels.

        In each panel, a Gauss rule of 16 points has only rounding errors.
        """
        return self._pieces.arc_length.t

    def at(self, s: ArrayLike) -> CurveSamples:
        """Return positions, angles and curvatures at arc lengths s (n,), mm."""
        s = np.atleast_1d(numbers(s, "arc lengths"))
        if s.ndim > 1:
            raise InputError(f"arc lengths are an array of {s.ndim} dimensions: give an array of 1 dimension")
        t = self.parameter(s)
        position, d1, d2 = self._pieces.at(t, 2)
        return CurveSamples(s, position, self._turning.at(t, d1), curvature(d1, d2), t)

    def sample(self, count: int) -> CurveSamples:
        """Return samples at `count` points at equal distances along the curve, including both ends."""
        if not (is_number(count) and count >= 2):
            raise InputError(f"the number of samples is {count!r}: use 2 or more")
        return self.at(np.linspace(0.0, self.length, int(count)))

    @cached_property
    def survey(self) -> CurveSamples:
        """Samples at `SURVEY_POINTS` equal distances, computed once, with read-only arrays."""
        nodes = self.sample(SURVEY_POINTS)
        for values in vars(nodes).values():
            values.setflags(write=False)
        return nodes

    @cached_property
    def curvature_zeros(self) -> tuple[CurvatureZero, ...]:
        """All zeros and sign changes of the curvature, in the order of the curve."""
        places = zeros.curvature_zero_places(self._pieces.bezier, self._pieces.edges, self._continuity >= 2)
        return self._measured(self._polished(places))

    def curvature_equals(self, level: float) -> tuple[CurvatureZero, ...]:
        """Return all points at which the curvature is `level` (1/mm), with the signs of curvature - level."""
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
        """Return all zeros and sign changes of a function along the curve, in the order of the curve.

        Parameters
        ----------
        function : callable
            Function of parameters (k,) that returns values (k,). The function is as smooth as the curvature,
            except at `breaks`.
        size : float
            Typical size of the values, to which tolerances are relative.
        breaks : sequence of (parameter, bool)
            Parameters at which the function is not smooth, each with a flag that is True if it is continuous.
        """
        if not callable(function) or not (is_number(size) and size > 0):
            raise InputError(
                f"zeros cannot be found: the function is {quoted(function)} and the size {quoted(size)}. "
                "Give a callable and a positive size")  # fmt: skip
        low, high = self.domain
        places = {knot.t: knot.continuity >= 2 for knot in self.breaks}
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
        """Arc lengths (k,), mm, at which the curvature changes its sign.

        If its sign changes along a straight piece, the inflection is the middle of the piece.
        """
        return np.array([(z.s + z.s_end) / 2 for z in self.curvature_zeros if z.changes_sign])

    @cached_property
    def breaks(self) -> tuple[Break, ...]:
        """All interior knots with their continuity."""
        t = self._pieces.edges[1:-1]
        return tuple(map(Break, self.arc_length(t).tolist(), t.tolist(), self._continuity.tolist()))

    @cached_property
    def tangent_breaks(self) -> tuple[TangentBreak, ...]:
        """Corners of more than 1e-5 rad, except a corner where a closed curve starts and ends."""
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
        """Point where a closed curve starts and ends, with the continuity there; None for an open curve."""
        if not self.is_closed:
            return None
        return Break(0.0, self.domain[0], int(agreeing_orders(self._seam_sides, self.length)[0]))

    @property
    def seam_turn(self) -> float:
        """Jump of the tangent direction, rad, where a closed curve starts and ends; 0 for an open curve."""
        return float(self._seam_sides.corners[0]) if self.is_closed else 0.0

    @cached_property
    def has_corners(self) -> bool:
        """True if the tangent jumps by more than 1e-5 rad anywhere, also where a closed curve starts and ends."""
        return bool(self.tangent_breaks) or abs(self.seam_turn) > CORNER_RAD

    @cached_property
    def is_straight(self) -> bool:
        """True if the whole curve is a straight segment."""
        flats = [(z.kind, z.before, z.after) for z in self.curvature_zeros]
        return flats == [("flat", 0, 0)] and not self.tangent_breaks

    @cached_property
    def is_closed(self) -> bool:
        """True if both ends are the same point within 1e-9 of the length."""
        start, end = project(self._pieces.bezier[[0, -1], [0, -1]])
        return bool(norm(end - start) <= 1e-9 * self.length)

    def self_intersections(self) -> FloatArray:
        """Return pairs of arc lengths (k, 2), mm, at which the curve crosses or touches itself, in order."""
        if self._turning.spread <= np.pi * (1 + _ROUNDING):
            return np.zeros((0, 2))  # a curve that turns by 180 degrees or less cannot meet itself
        bezier, edges = self._pieces.bezier, self._pieces.edges
        return self.arc_length(find_self_intersections(bezier, edges, lambda t: self.derivatives(t, 1)))

    @cached_property
    def _turning(self) -> TangentAngle:
        return tabulate_tangent_angle(self._pieces.tangent_cones)

    @cached_property
    def _continuity(self) -> IntArray:
        # numbers (p - 1,) of continuous derivatives by arc length at the interior knots
        if self._is_smooth(ORDERS_OF_SIDES):
            return self._knot_orders
        return np.maximum(self._knot_orders, agreeing_orders(self._knot_sides, self.length))

    @cached_property
    def _knot_orders(self) -> IntArray:
        """Numbers (p - 1,) of continuous derivatives at the interior knots, from their multiplicities."""
        t = self._pieces.edges[1:-1]
        repeated = self.knots.searchsorted(t, side="right") - self.knots.searchsorted(t)
        return self.degree - repeated

    def _is_smooth(self, order: int) -> bool:
        """Return True if the knot multiplicities alone prove that the curve has `order` continuous derivatives."""
        spans = self._pieces.spans
        apart = spans.widths.min() > SHORT_SPAN_SHARE * (spans.edges[-1] - spans.edges[0])
        return bool(apart and self._knot_orders.min(initial=order) >= order)

    @cached_property
    def _knot_sides(self) -> KnotSides:
        return KnotSides.of(self._pieces, self._turning)

    @cached_property
    def _seam_sides(self) -> KnotSides:
        return KnotSides.of_seam(self._pieces, self._turning)

    def _polished(self, zero_places: tuple[zeros.ZeroPlace, ...]) -> tuple[zeros.ZeroPlace, ...]:
        """Improve sign changes by a Newton step, because parameters on short pieces have rounding errors."""
        crossing = [i for i, place in enumerate(zero_places) if place.kind == "crossing"]
        if not crossing:
            return zero_places
        t, edges = np.array([zero_places[i].t for i in crossing]), self._pieces.edges
        index, u = self._pieces.spans.locate(t)
        _, d1, d2, d3 = self._pieces.within(index, u, 3)
        with np.errstate(divide="ignore", invalid="ignore"):
            better = t - curvature(d1, d2) / (curvature_slope(d1, d2, d3) * norm(d1))
        # rounding error of a zero of the curvature
        near = np.abs(better - t) < 1e-6 * self._pieces.spans.widths[index]
        near &= (edges[index] < better) & (better < edges[index + 1])
        places = list(zero_places)
        for i, at in zip(np.array(crossing)[near], better[near].tolist(), strict=True):
            zero = zero_places[i]
            places[i] = zeros.ZeroPlace(at, at, zero.kind, zero.before, zero.after)
        return tuple(places)

    def _measured(self, places: tuple[zeros.ZeroPlace, ...]) -> tuple[CurvatureZero, ...]:
        # the same zeros with their arc lengths
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
        Constant a of the line.
    b : (2,) array_like
        Normal of the line, of any length except 0.

    Examples
    --------
    >>> arch = PlaneCurve.arc((0, 0), 50, 0.0, np.pi)
    >>> [(root.kind, round(root.s, 3)) for root in line_crossings(arch, -50, (0, 1))]
    [('touch', 78.54)]
    """
    require_record(curve, PlaneCurve, "what a line crosses", "a PlaneCurve")
    normal, constant = finite("b", b), finite("a", a)
    if constant.shape:
        raise InputError(f"the constant a of the line a + <b, x> = 0 is {constant.tolist()}: give one number")
    if normal.shape != (2,) or not normal.any():
        raise InputError(f"the normal of a line is {normal.tolist()}: give two numbers, not both 0")
    edges, bezier = curve.bezier_table
    return curve._measured(line_places(bezier, edges, float(constant), normal))


def clamp_ends(curve: PlaneCurve) -> PlaneCurve:
    """Return the curve with repeated end knots, so that its ends are control points."""
    return curve if is_clamped(curve.knots, curve.degree) else curve.trimmed(*curve.domain)


def split_at_corners(curve: PlaneCurve) -> tuple[PlaneCurve, ...]:
    """Return the pieces of a curve between its corners, in order.

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
    provenance = curve.provenance and curve.provenance.of_part()
    return tuple(curve.trimmed(*ends).drawn_as(provenance) for ends in pairwise(places))


DEGREE = 5  # the curvature then has two continuous derivatives, as needed by checks of equilibrium


def integrate_tangents(
    tangent: Callable[[FloatArray], FloatArray],
    length: float,
    start: FloatArray,
    *,
    tolerance: float,
    breaks: Sequence[tuple[float, int]] = (),
) -> PlaneCurve:
    """Return the curve from `start` (2,), mm, with the given tangents, as a spline of degree 5 over arc length.

    Parameters
    ----------
    tangent : callable
        Function of arc lengths (k,), mm, that returns unit vectors (k, 2).
    tolerance : float
        Largest error of a unit tangent.
    breaks : sequence of (s, continuity)
        Arc lengths at which the tangent has only `continuity` continuous derivatives.

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
    points = start + np.pad((reach[:, None] * rows).cumsum(axis=0), ((1, 0), (0, 0)))
    return PlaneCurve(np.pad(knots, 1, mode="edge"), points, DEGREE)
