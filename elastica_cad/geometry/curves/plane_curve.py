"""Plane NURBS curves: the drawn curve that a strip is to take."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from elastica_cad._notebook import BLUE, svg_of_lines
from elastica_cad._types import ArrayLike, BoolArray, FloatArray, IntArray
from elastica_cad.errors import InputError
from elastica_cad.geometry.curves import curvature_zeros as zeros
from elastica_cad.geometry.curves.arc_length import ArcLength, arc_length_table
from elastica_cad.geometry.curves.continuity import (
    KnotSides,
    continuity_orders,
    in_millimetres,
    refuse_standstill,
)
from elastica_cad.geometry.curves.curve_derivatives import (
    RationalPieces,
    curvature,
    curvature_slope,
    quotient,
)
from elastica_cad.geometry.curves.curve_records import Break, CurvatureZero, CurveSamples, TangentBreak
from elastica_cad.geometry.curves.projective_maps import keeps_shape, map_spline
from elastica_cad.geometry.curves.provenance import Provenance
from elastica_cad.geometry.curves.self_intersections import find_self_intersections
from elastica_cad.geometry.curves.tangent_angle import TangentAngle, tabulate_tangent_angle
from elastica_cad.geometry.polynomials.bezier_pieces import bezier_spans
from elastica_cad.geometry.polynomials.conics import unit_circle_arc
from elastica_cad.geometry.polynomials.fit_function import adaptive_spline
from elastica_cad.geometry.polynomials.fit_points import fit_spline
from elastica_cad.geometry.polynomials.spline_checks import check_knots, finite, whole_degree

FAR_SIZES = 1e6
"""A curve moved farther away than so many of its sizes loses digits, and is checked again."""

SURVEY_POINTS = 601  # at which all who look along the whole curve find it evaluated

DRAWN_POINTS = 301  # of a curve in a notebook, a few pixels apart

_ROUNDING = 1e-10  # of an angle

MOST_UNEVEN = 1e8
"""Largest weight over the least: beyond, places come to rounding."""


@dataclass(frozen=True, eq=False)
class PlaneCurve:
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
        What the file that it was drawn in says beside the numbers.

    Raises
    ------
    InputError
        When the numbers make no curve with a tangent everywhere: too few or non-finite control points, knots
        that decrease or break the curve apart, weights not positive, zero length, a cusp.

    Examples
    --------
    >>> curve = PlaneCurve.spline([(0, 0), (30, 40), (60, 40), (90, 0)], degree=3)
    >>> round(curve.length, 3)
    112.078
    """

    knots: FloatArray
    control_points: FloatArray
    degree: int
    weights: FloatArray | None = None
    provenance: Provenance | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "degree", whole_degree(self.degree))
        points = finite("control_points", self.control_points)
        if points.ndim != 2 or points.shape[1] != 2:
            raise InputError(f"control_points must be rows of x, y: shape (m, 2), not {points.shape}")
        object.__setattr__(self, "control_points", points)
        object.__setattr__(self, "knots", finite("knots", self.knots))
        check_knots(self.knots, points.shape[0], self.degree)
        if self.weights is not None:
            weights = finite("weights", self.weights)
            if weights.shape != (points.shape[0],):
                raise InputError(f"{points.shape[0]} control points need as many weights, not {weights.size}")
            if weights.min() <= 0:
                raise InputError(
                    f"weight {int(weights.argmin())} is {weights.min():g}: weights must be positive"
                )
            if weights.max() > MOST_UNEVEN * weights.min():
                raise InputError(
                    f"weights run from {weights.min():.3g} to {weights.max():.3g}: the largest may be "
                    f"{MOST_UNEVEN:g} times the least; export the curve without them"
                )
            object.__setattr__(self, "weights", weights if np.ptp(weights) > 0 else None)
        drawn = self.provenance
        shown, rounding = (in_millimetres, 0.0) if drawn is None else (drawn.shown, drawn.rounding)
        refuse_standstill(self._pieces, self.control_points, shown, rounding)

    @classmethod
    def of_sound(
        cls,
        knots: FloatArray,
        control_points: FloatArray,
        degree: int,
        weights: FloatArray | None,
        provenance: Provenance | None = None,
    ) -> "PlaneCurve":
        """The curve of numbers that need no check, being those of a part or a moved copy of a curve."""
        made = object.__new__(cls)
        for name, value in (("knots", knots), ("control_points", control_points), ("weights", weights)):
            if value is not None:
                value.setflags(write=False)
            object.__setattr__(made, name, value)
        object.__setattr__(made, "degree", degree)
        object.__setattr__(made, "provenance", provenance)
        return made

    @classmethod
    def spline(cls, control_points: ArrayLike, degree: int = 4) -> "PlaneCurve":
        """The clamped B-spline with uniform knots over `control_points` (m, 2), m > degree."""
        points, degree = finite("control_points", control_points), whole_degree(degree)
        count = points.shape[0] if points.ndim else 0
        if count <= degree:
            raise InputError(
                f"{count} control points are too few for degree {degree}: give {degree + 1} or more"
            )
        inner = np.linspace(0.0, 1.0, count - degree + 1)
        knots = np.concatenate([np.zeros(degree), inner, np.ones(degree)])
        return cls(knots, points, degree)

    @classmethod
    def line(cls, start: ArrayLike, end: ArrayLike, *, degree: int = 2) -> "PlaneCurve":
        """The straight segment between two points."""
        a, b = finite("start", start), finite("end", end)
        u = np.linspace(0.0, 1.0, degree + 1)[:, None]
        return cls(np.repeat([0.0, 1.0], degree + 1), a * (1 - u) + b * u, degree)

    @classmethod
    def arc(cls, center: ArrayLike, radius: float, start_angle: float, end_angle: float) -> "PlaneCurve":
        """The circular arc between two angles (rad), counterclockwise when end_angle > start_angle; exact."""
        return cls.ellipse(center, (radius, radius), start=start_angle, end=end_angle)

    @classmethod
    def ellipse(
        cls,
        center: ArrayLike,
        semi_axes: ArrayLike,
        rotation: float = 0.0,
        start: float = 0.0,
        end: float = 2 * np.pi,
    ) -> "PlaneCurve":
        """The ellipse arc (a cos v, b sin v), v from start to end (rad), turned and moved; exact."""
        centre, axes = finite("center", center), finite("semi_axes", semi_axes)
        if axes.shape != (2,) or axes.min() <= 0:
            raise InputError(f"semi-axes (or the radius) must be positive, not {axes.tolist()}")
        span = finite("angles", [rotation, start, end])
        if start == end:
            raise InputError("the arc has zero length: start and end angle are the same")
        knots, points, weights = unit_circle_arc(float(span[1]), float(span[2]))
        c, s = np.cos(rotation), np.sin(rotation)
        return cls(knots, centre + points * axes @ np.array([[c, s], [-s, c]]), 2, weights)

    @classmethod
    def fit(
        cls, points: ArrayLike, degree: int = 4, tolerance: float = 0.05, smoothing: float | None = None
    ) -> "PlaneCurve":
        """A spline with few control points that passes all `points` (n, 2) within `tolerance` mm.

        Parameters
        ----------
        points : (n, 2) array_like
            Points in order, mm; the first and last are met exactly.
        degree : int
            3, 4 or 5.
        tolerance : float
            Largest distance of a point from the curve, mm.
        smoothing : float, optional
            Weight of the mean square third derivative (mm, parameter from 0 to 1) beside the mean square
            distance (mm2); it may then miss the tolerance. Chosen by the noise of the points when not given.

        Examples
        --------
        >>> v = np.linspace(0, 3, 60)
        >>> curve = PlaneCurve.fit(np.column_stack([100 * np.cos(v), 100 * np.sin(v)]), tolerance=1e-3)
        >>> round(curve.length, 2)
        300.0
        """
        knots, control_points = fit_spline(points, degree, tolerance, smoothing)
        return cls(knots, control_points, degree)

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
    ) -> "PlaneCurve":
        """The spline that follows a smooth function within `tolerance` mm, in the function's own parameter.

        Parameters
        ----------
        function : callable
            Maps parameters (k,) between `start` and `end` to points (k, 2), mm.
        breaks : sequence of (parameter, continuity)
            Places where the function is only `continuity` times differentiable; they become knots.

        Examples
        --------
        >>> spiral = PlaneCurve.fit_function(lambda v: np.column_stack([v * np.cos(v), v * np.sin(v)]), 3, 9)
        >>> round(spiral.length, 4)
        36.5433
        """
        knots, control_points = adaptive_spline(
            function, (float(start), float(end)), degree=degree, tolerance=tolerance, breaks=breaks
        )
        return cls(knots, control_points, degree)

    def drawn_as(self, provenance: Provenance | None) -> "PlaneCurve":
        """The same curve with another record of where it comes from."""
        return PlaneCurve.of_sound(self.knots, self.control_points, self.degree, self.weights, provenance)

    @property
    def domain(self) -> tuple[float, float]:
        """First and last parameter."""
        return float(self.knots[self.degree]), float(self.knots[-self.degree - 1])

    @property
    def is_rational(self) -> bool:
        """Are there weights that differ?"""
        return self.weights is not None

    def evaluate(self, t: ArrayLike, derivative: int = 0, *, left: bool = False) -> FloatArray:
        """Position or its derivative d/dt of order up to 3, shape (..., 2) for parameters (...).

        At a knot of low continuity the right-hand value is given, with `left=True` the left-hand one.
        """
        if not 0 <= derivative <= 3:
            raise InputError(f"derivatives of order 0 to 3 are known, not {derivative}")
        t = np.asarray(t, dtype=float)
        return self._pieces.at(t.ravel(), derivative, left=left)[derivative].reshape(*t.shape, 2)

    def derivatives(self, t: FloatArray, order: int) -> list[FloatArray]:
        """Positions and their derivatives d/dt up to `order`, (n, 2) each, at parameters (n,), at one go."""
        return self._pieces.at(t, order)

    def position_and_velocity(self, t: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Positions and their derivatives d/dt, (n, 2) each, at parameters (n,), in one evaluation."""
        return self._pieces.position_and_velocity(t)

    def basis(self, t: ArrayLike, derivative: int = 0) -> FloatArray:
        """Derivatives (n, m) of the position (or of its derivative) at t (n,) by the m control points.

        The rational basis functions R_i: position = sum of R_i(t) times control point i.
        """
        t = self._pieces.inside(np.atleast_1d(np.asarray(t, dtype=float)))
        spans = self._pieces.spans
        if self.weights is None:
            return spans.basis(t, derivative)
        numerators = [(spans.basis(t, k) * self.weights).T for k in range(derivative + 1)]
        return quotient(numerators, [rows.sum(axis=0) for rows in numerators])[derivative].T

    def with_control_points(self, control_points: ArrayLike) -> "PlaneCurve":
        """The curve with the same knots and weights over other control points (m, 2)."""
        return PlaneCurve(self.knots, np.asarray(control_points, dtype=float), self.degree, self.weights)

    def curvature_at(self, t: ArrayLike, *, left: bool = False) -> FloatArray:
        """Signed curvature, 1/mm, at parameters t."""
        t = np.asarray(t, dtype=float)
        return curvature(*self._pieces.at(t.ravel(), 2, left=left)[1:]).reshape(t.shape)

    def curvature_slope_at(self, t: ArrayLike, *, left: bool = False) -> FloatArray:
        """Derivative of the curvature by arc length, 1/mm2, at parameters t."""
        t = np.asarray(t, dtype=float)
        return curvature_slope(*self._pieces.at(t.ravel(), 3, left=left)[1:]).reshape(t.shape)

    def angle_at(self, t: ArrayLike, *, left: bool = False) -> FloatArray:
        """Turning angle, rad, at parameters t: continuous along the curve, in [-pi, pi] at its start."""
        t = np.asarray(t, dtype=float)
        _, d1 = self._pieces.at(t.ravel(), 1, left=left)
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
        return float(self._arc_length.s[-1])

    def arc_length(self, t: ArrayLike) -> FloatArray:
        """Arc length from the start, mm, at parameters t."""
        t = np.asarray(t, dtype=float)
        return self._arc_length.length_at(self._pieces.inside(t.ravel())).reshape(t.shape)

    def parameter(self, s: ArrayLike) -> FloatArray:
        """Parameters at arc lengths s (mm)."""
        s = np.asarray(s, dtype=float)
        slack = 1e-9 * self.length
        if s.size and not (np.all(s >= -slack) and np.all(s <= self.length + slack)):
            raise InputError(f"arc length outside the curve: use 0 to {self.length:g} mm")
        return self._arc_length.parameter_at(np.clip(s.ravel(), 0.0, self.length)).reshape(s.shape)

    @property
    def smooth_panels(self) -> FloatArray:
        """Parameters, both ends included, between which a Gauss rule of 16 points integrates to rounding."""
        return self._arc_length.t

    def at(self, s: ArrayLike) -> CurveSamples:
        """Position, angle and curvature at arc lengths s (n,)."""
        s = np.atleast_1d(np.asarray(s, dtype=float))
        t = self.parameter(s)
        position, d1, d2 = self._pieces.at(t, 2)
        return CurveSamples(s, position, self._turning.at(t, d1), curvature(d1, d2), t)

    def sample(self, count: int) -> CurveSamples:
        """`count` points at equal distances along the curve, both ends included."""
        if not count >= 2:
            raise InputError(f"a curve is sampled at 2 points or more, not {count!r}")
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
        found = zeros.curvature_zero_places(
            self._pieces.bezier, self._pieces.edges, self._curvature_continuous
        )
        return self._measured(found)

    def curvature_equals(self, level: float) -> tuple[CurvatureZero, ...]:
        """All places where the curvature is `level` (1/mm); before, after: signs of curvature - level."""
        level = float(finite("level", level))
        if level == 0:
            return self.curvature_zeros
        found = zeros.curvature_level_places(
            self._pieces.bezier, self._pieces.edges, self._curvature_continuous, level
        )
        return self._measured(found)

    def zeros_along(
        self,
        function: Callable[[FloatArray], FloatArray],
        size: float,
        breaks: Sequence[tuple[float, bool]] = (),
    ) -> tuple[CurvatureZero, ...]:
        """All zeros and sign changes of a function along the curve, in order.

        Parameters
        ----------
        function : callable
            Maps parameters (k,) to values (k,); as smooth as the curvature, but at `breaks`.
        size : float
            Of the function: values are small beside it.
        breaks : sequence of (parameter, bool)
            Where it has a kink, and whether it is continuous there.
        """
        low, high = self.domain
        places = dict(
            zip(self._pieces.edges[1:-1].tolist(), self._curvature_continuous.tolist(), strict=True)
        )
        for t, continuous in breaks:
            near = min(places, key=lambda known: abs(known - t), default=low)
            at = near if abs(near - t) < 1e-9 * (high - low) else t
            if low < at < high:
                places[at] = places.get(at, True) and continuous
        edges = np.array([low, *sorted(places), high])
        smooth = np.array([places[t] for t in sorted(places)], dtype=bool)
        return self._measured(zeros.function_zero_places(function, edges, smooth, size))

    @cached_property
    def inflections(self) -> FloatArray:
        """Arc lengths (k,), mm, where the curvature changes sign; of a straight piece between, its middle."""
        return np.array([(z.s + z.s_end) / 2 for z in self.curvature_zeros if z.changes_sign])

    @cached_property
    def breaks(self) -> tuple[Break, ...]:
        """All interior knots with their continuity."""
        t = self._pieces.edges[1:-1]
        return tuple(
            Break(float(s), float(at), int(order))
            for s, at, order in zip(self.arc_length(t), t, self._continuity, strict=True)
        )

    @cached_property
    def tangent_breaks(self) -> tuple[TangentBreak, ...]:
        """Corners of more than 1e-5 rad."""
        angle = self._knot_sides.corners
        sharp = np.flatnonzero(np.abs(angle) > 1e-5)
        t = self._pieces.edges[1:-1][sharp]
        return tuple(
            TangentBreak(*map(float, corner))
            for corner in zip(self.arc_length(t), t, angle[sharp], strict=True)
        )

    @cached_property
    def is_straight(self) -> bool:
        """Is the whole curve a straight segment?"""
        return [z.kind for z in self.curvature_zeros] == ["flat"] and not self.tangent_breaks

    @property
    def is_closed(self) -> bool:
        """Do the ends meet (within 1e-9 of the length)?"""
        start, end = self.evaluate(np.array(self.domain), left=False)
        return bool(np.hypot(*(end - start)) <= 1e-9 * self.length)

    def self_intersections(self) -> FloatArray:
        """Pairs of arc lengths (k, 2), mm, at which the curve crosses or touches itself, in order."""
        if self._turning.spread <= np.pi * (1 + _ROUNDING):
            return np.zeros((0, 2))  # it never comes back: what closes must turn by more than half a turn
        bezier, edges = self._pieces.bezier, self._pieces.edges
        return self.arc_length(find_self_intersections(bezier, edges, self.position_and_velocity))

    def bezier_pieces(self) -> tuple[tuple[float, float, FloatArray], ...]:
        """The knot spans as (t0, t1, homogeneous control points (degree + 1, 3): rows x w, y w, w)."""
        edges = self._pieces.edges
        return tuple(
            (float(a), float(b), piece.copy())
            for a, b, piece in zip(edges[:-1], edges[1:], self._pieces.bezier, strict=True)
        )

    def reversed(self) -> "PlaneCurve":
        """The curve run from its other end."""
        weights = None if self.weights is None else self.weights[::-1]
        return PlaneCurve.of_sound(
            self.knots[0] + self.knots[-1] - self.knots[::-1],
            self.control_points[::-1],
            self.degree,
            weights,
            self.provenance,
        )

    def transformed(self, matrix: ArrayLike) -> "PlaneCurve":
        """The exact image under a projective map: matrix @ (x, y, 1), divided by its third number.

        Realizable curves stay realizable with clamped ends (paper, section 4.3).

        Raises
        ------
        InputError
            When the matrix is singular, or when it sends a point of the curve to infinity.
        """
        knots, points, weights = map_spline(
            self.knots,
            self.control_points,
            self.weights,
            matrix,
            degree=self.degree,
            pieces=lambda: (self._pieces.bezier, self._pieces.edges),
        )
        drawn = (
            None if self.provenance is None else self.provenance.transformed(np.asarray(matrix, dtype=float))
        )
        if keeps_shape(matrix) and np.abs(points).max() < FAR_SIZES * np.ptp(points, axis=0).max():
            return PlaneCurve.of_sound(knots, points, self.degree, weights, drawn)
        return PlaneCurve(knots, points, self.degree, weights, drawn)

    @cached_property
    def bounds(self) -> FloatArray:
        """The smallest box around the curve, [[x_min, y_min], [x_max, y_max]], mm."""
        points = self.evaluate(self._pieces.stationary())
        return np.array([points.min(axis=0), points.max(axis=0)])

    @cached_property
    def _pieces(self) -> RationalPieces:
        spans = bezier_spans(self.knots, self.degree)
        weights = np.ones(self.control_points.shape[0]) if self.weights is None else self.weights
        homogeneous = np.column_stack([self.control_points * weights[:, None], weights])
        return RationalPieces(spans, spans.bezier(homogeneous), self.is_rational)

    @cached_property
    def _turning(self) -> TangentAngle:
        return tabulate_tangent_angle(self._pieces.tangent_cones)

    @cached_property
    def _arc_length(self) -> ArcLength:
        return arc_length_table(self._pieces.speed, self._pieces.edges)

    @cached_property
    def _continuity(self) -> IntArray:
        return continuity_orders(self._pieces, self._knot_sides, self.knots, self.length)

    @cached_property
    def _knot_sides(self) -> KnotSides:
        return KnotSides.of(self._pieces, self._turning)

    @cached_property
    def _curvature_continuous(self) -> BoolArray:
        return self._continuity >= 2

    def _measured(self, found: tuple[zeros.ZeroPlace, ...]) -> tuple[CurvatureZero, ...]:
        s = self.arc_length(np.array([[place.t, place.t_end] for place in found]).reshape(-1, 2))
        return tuple(
            CurvatureZero(float(at), p.t, p.kind, float(to), p.t_end, p.before, p.after)
            for p, (at, to) in zip(found, s, strict=True)
        )
