"""Plane NURBS curves as numbers: how they are made, checked, evaluated and mapped."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any, Self

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import is_whole, numbers, require_number, require_record
from elastica_cad.errors import InputError
from elastica_cad.geometry.boxes import box_about
from elastica_cad.geometry.curves.curve_derivatives import (
    RationalPieces,
    in_millimetres,
    quotient,
    refuse_standstill,
)
from elastica_cad.geometry.curves.projective_maps import map_spline
from elastica_cad.geometry.pen_curves.measured_points import MeasuredPoints
from elastica_cad.geometry.pen_curves.provenance import Provenance
from elastica_cad.geometry.polynomials.spline_fits import adaptive_spline, distinct_points, fit_spline
from elastica_cad.geometry.polynomials.splines import (
    bezier_spans,
    check_knots,
    finite,
    unit_circle_arc,
    whole_degree,
)

SAME_KNOT = 1e-12
"""A place nearer to a knot than this share of the domain is that knot, so that no span is as short as rounding
errors."""

FAR_SIZES = 1e6
"""A curve that is moved farther than this many of its sizes loses digits and is checked again."""

_AHEAD_SHARE = 1e-6
"""Steps of a control polygon that advance by more than this share of the chord between the ends count as
advancing."""

MOST_TURNS = 100
"""Largest number of turns of an arc."""

MOST_UNEVEN = 1e8
"""Largest ratio of weights; beyond it, points are lost in rounding errors."""


@dataclass(frozen=True, eq=False)
class NurbsCurve:
    """Knots, control points and weights that make a curve with a tangent everywhere: see `PlaneCurve`."""

    knots: FloatArray
    control_points: FloatArray
    degree: int
    weights: FloatArray | None = None
    provenance: Provenance | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "degree", whole_degree(self.degree))
        points = finite("control_points", self.control_points)
        if points.ndim != 2 or points.shape[1] != 2:
            raise InputError(
                "control_points must be rows of x, y: shape (m, 2), not {shape}", shape=points.shape
            )
        object.__setattr__(self, "control_points", points)
        object.__setattr__(self, "knots", finite("knots", self.knots))
        check_knots(self.knots, points.shape[0], self.degree)
        if self.weights is not None:
            weights = finite("weights", self.weights)
            if weights.shape != (points.shape[0],):
                raise InputError(
                    "{shape} control points need as many weights, not {size}",
                    shape=points.shape[0],
                    size=weights.size,
                )
            if weights.min() <= 0:
                raise InputError(
                    "weight {given} is {least:g}: weights must be positive",
                    given=int(weights.argmin()),
                    least=weights.min(),
                )
            if weights.max() > MOST_UNEVEN * weights.min():
                raise InputError(
                    "weights run from {least:.3g} to {most:.3g}: the largest may be {most_uneven:g} "
                    "times the least; export the curve without them",
                    least=weights.min(),
                    most=weights.max(),
                    most_uneven=MOST_UNEVEN,
                )
            object.__setattr__(self, "weights", weights if np.ptp(weights) > 0 else None)
        drawn = self.provenance
        require_record(drawn, Provenance | None, "provenance", "what read_curves gives, or None")
        shown, rounding = (in_millimetres, 0.0) if drawn is None else (drawn.shown, drawn.rounding)
        steps = np.diff(points, axis=0)
        along = steps @ steps.sum(axis=0)
        if self.is_rational or along.min() <= _AHEAD_SHARE * along.sum():  # else it goes ahead everywhere
            refuse_standstill(self._pieces, self.control_points, shown, rounding)

    def __getstate__(self) -> dict[str, Any]:
        """The numbers alone: what was computed from them is larger by far, and soon had again."""
        return {field.name: getattr(self, field.name) for field in fields(self)}

    def _part(
        self, knots: FloatArray, control_points: FloatArray, weights: FloatArray | None,
        provenance: Provenance | None = None,
    ) -> Self:  # fmt: skip
        """A curve of this degree that is a part or a moved copy of this one, so that it needs no check."""
        made = object.__new__(type(self))
        for array in (knots, control_points, weights):
            if array is not None:
                array.setflags(write=False)
        vars(made).update(
            knots=knots,
            control_points=control_points,
            degree=self.degree,
            weights=weights,
            provenance=provenance,
        )
        return made

    @classmethod
    def spline(cls, control_points: ArrayLike, degree: int = 4) -> Self:
        """The clamped B-spline with uniform knots over `control_points` (m, 2), m > degree."""
        points, degree = finite("control_points", control_points), whole_degree(degree)
        count = points.shape[0] if points.ndim else 0
        if count <= degree:
            raise InputError(
                "{count} control points are too few for degree {degree}: give {degree_2} or more",
                count=count,
                degree=degree,
                degree_2=degree + 1,
            )
        inner = np.linspace(0.0, 1.0, count - degree + 1)
        knots = np.concatenate([np.zeros(degree), inner, np.ones(degree)])
        return cls(knots, points, degree)

    @classmethod
    def line(cls, start: ArrayLike, end: ArrayLike, *, degree: int = 2) -> Self:
        """The straight segment between two points."""
        a, b = finite("start", start), finite("end", end)
        degree = whole_degree(degree)
        if a.shape != (2,) or b.shape != (2,):
            raise InputError("a line runs between two points of two numbers each, in mm")
        u = np.linspace(0.0, 1.0, degree + 1)[:, None]
        return cls(np.repeat([0.0, 1.0], degree + 1), a * (1 - u) + b * u, degree)

    @classmethod
    def arc(cls, center: ArrayLike, radius: float, start_angle: float, end_angle: float) -> Self:
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
    ) -> Self:
        """The ellipse arc (a cos v, b sin v), v from start to end (rad), turned and moved; exact."""
        centre, axes = finite("center", center), finite("semi_axes", semi_axes)
        if centre.shape != (2,):
            raise InputError("the center must be two numbers, in mm, not {given}", given=centre.tolist())
        if axes.shape != (2,) or axes.min() <= 0:
            raise InputError("semi-axes (or the radius) must be positive, not {given}", given=axes.tolist())
        turn, first, last = finite("angles", [rotation, start, end]).tolist()
        if first == last:
            raise InputError("the arc has zero length: start and end angle are the same")
        if not abs(last - first) <= MOST_TURNS * 2 * np.pi:
            raise InputError(
                "the arc runs from {first:g} to {last:g} rad: give angles at most {most_turns} turns apart",
                first=first,
                last=last,
                most_turns=MOST_TURNS,
            )
        knots, points, weights = unit_circle_arc(first, last)
        c, s = np.cos(turn), np.sin(turn)
        return cls(knots, centre + points * axes @ np.array([[c, s], [-s, c]]), 2, weights)

    @classmethod
    def fit(
        cls, points: ArrayLike, degree: int = 4, tolerance: float = 0.05, smoothing: float | None = None
    ) -> Self:
        """Return a spline with few control points that passes all `points` (n, 2) within `tolerance` mm.

        Of points that waver, such as measured ones, the curve keeps the noise: strips tell where it rules their
        widths, and `smooth` of a strip takes it out.

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
        >>> from elastica_cad.geometry.curves.plane_curve import PlaneCurve
        >>> curve = PlaneCurve.fit(np.column_stack([100 * np.cos(v), 100 * np.sin(v)]), tolerance=1e-3)
        >>> round(curve.length, 2)
        300.0
        """
        knots, control_points = fit_spline(points, degree, tolerance, smoothing)
        drawn = Provenance(measured=MeasuredPoints.of(distinct_points(points)))
        return cls(knots, control_points, degree, provenance=drawn)

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
        """The spline that follows a smooth function within `tolerance` mm, in the function's own parameter.

        Parameters
        ----------
        function : callable
            Maps parameters (k,) between `start` and `end` to points (k, 2), mm.
        breaks : sequence of (parameter, continuity)
            Places where the function is only `continuity` times differentiable; they become knots.

        Examples
        --------
        >>> from elastica_cad.geometry.curves.plane_curve import PlaneCurve
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
        """Return the curve with another record of its source."""
        return self._part(self.knots, self.control_points, self.weights, provenance)

    @property
    def domain(self) -> tuple[float, float]:
        """First and last parameter."""
        return float(self.knots[self.degree]), float(self.knots[-self.degree - 1])

    @property
    def is_rational(self) -> bool:
        """Whether the weights differ."""
        return self.weights is not None

    def evaluate(self, t: ArrayLike, derivative: int = 0, *, left: bool = False) -> FloatArray:
        """Position or its derivative d/dt of order up to 3, shape (..., 2) for parameters (...).

        At a knot of low continuity the right-hand value is given, with `left=True` the left-hand one.
        """
        if not (is_whole(derivative) and 0 <= derivative <= 3):
            raise InputError(
                "derivatives of order 0 to 3 are known, not {derivative!r}", derivative=derivative
            )
        t = numbers(t, "parameters")
        return self._pieces.at(t.ravel(), derivative, left=left)[derivative].reshape(*t.shape, 2)

    def derivatives(self, t: FloatArray, order: int) -> list[FloatArray]:
        """Positions and their derivatives d/dt up to `order`, (n, 2) each, at parameters (n,), at one go."""
        return self._pieces.at(t, order)

    def basis(self, t: ArrayLike, derivative: int = 0) -> FloatArray:
        """Derivatives (n, m) of the position (or of its derivative) at t (n,) by the m control points.

        The rational basis functions R_i: position = sum of R_i(t) times control point i.
        """
        t = self._pieces.inside(np.atleast_1d(numbers(t, "parameters")))
        spans = self._pieces.spans
        if self.weights is None:
            return spans.basis(t, derivative)
        numerators = [(spans.basis(t, k) * self.weights).T for k in range(derivative + 1)]
        return quotient(numerators, [rows.sum(axis=0) for rows in numerators])[derivative].T

    def with_control_points(self, control_points: ArrayLike) -> Self:
        """The curve with the same knots and weights over other control points (m, 2)."""
        return type(self)(self.knots, numbers(control_points, "control_points"), self.degree, self.weights)

    def siblings(self, control_points: FloatArray) -> list[Self]:
        """Curves over the same knots and control points (n, m, 2), without weights.

        They are not checked, for thousands at one go: like this one they must run on without standing still.
        """
        return [self._part(self.knots, points, None) for points in control_points]

    @property
    def bezier_table(self) -> tuple[FloatArray, FloatArray]:
        """The knot spans' ends (p + 1,) and homogeneous control points (p, degree + 1, 3); not to be written on."""
        return self._pieces.edges, self._pieces.bezier

    def bezier_pieces(self) -> tuple[tuple[float, float, FloatArray], ...]:
        """The knot spans as (t0, t1, homogeneous control points (degree + 1, 3): rows x w, y w, w)."""
        edges = self._pieces.edges
        return tuple(
            (float(a), float(b), piece.copy())
            for a, b, piece in zip(edges[:-1], edges[1:], self._pieces.bezier, strict=True)
        )

    def reversed(self) -> Self:
        """The curve run from its other end."""
        weights = None if self.weights is None else self.weights[::-1]
        knots = self.knots[0] + self.knots[-1] - self.knots[::-1]
        drawn = self.provenance and self.provenance.reversed()
        return self._part(knots, self.control_points[::-1], weights, drawn)

    def trimmed(self, start: float, end: float) -> Self:
        """The part between two parameters as a clamped curve of its own (Boehm's knot insertion)."""
        p, start, end = self.degree, self._at_knot(start), self._at_knot(end)
        points = self._pieces.control_points.copy() if self.is_rational else self.control_points.copy()
        last = int(np.searchsorted(self.knots, end)) - 1
        for r, row in enumerate(_de_boor(self.knots, points, last, end), 1):
            points[last - p + r] = row[0]
        knots = np.minimum(self.knots, end)
        first = int(np.searchsorted(knots, start, side="right")) - 1
        for r, row in enumerate(_de_boor(knots, points, first, start), 1):
            points[first - r] = row[-1]
        knots, rows = np.maximum(knots, start)[first - p : last + p + 2], points[first - p : last + 1]
        if self.is_rational:
            return self._part(knots, rows[:, :2] / rows[:, 2:], rows[:, 2])
        return self._part(knots, rows, None)

    def _at_knot(self, t: float) -> float:
        """The knot that a parameter lies at but for rounding, else the parameter."""
        low, high = self.domain
        nearest = float(self.knots[np.abs(self.knots - t).argmin()])
        return nearest if abs(nearest - t) <= SAME_KNOT * (high - low) else t

    def transformed(self, matrix: ArrayLike) -> Self:
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
        even = not np.asarray(matrix, dtype=float)[2, :2].any()
        if even and np.abs(points).max() < FAR_SIZES * np.ptp(points, axis=0).max():
            return self._part(knots, points, weights, drawn)
        return type(self)(knots, points, self.degree, weights, drawn)

    @cached_property
    def bounds(self) -> FloatArray:
        """The smallest box around the curve, [[x_min, y_min], [x_max, y_max]], mm."""
        points, (low, high) = self.control_points, self.domain
        box = box_about(points[[0, -1]])
        clamped = self.knots[0] == low and self.knots[-1] == high
        if clamped and (points >= box[0]).all() and (points <= box[1]).all():  # the curve lies in their hull
            return box
        return box_about(self.evaluate(self._pieces.stationary()))

    @cached_property
    def _pieces(self) -> RationalPieces:
        spans = bezier_spans(self.knots, self.degree)
        weights = np.ones(self.control_points.shape[0]) if self.weights is None else self.weights
        homogeneous = np.column_stack([self.control_points * weights[:, None], weights])
        return RationalPieces(spans, homogeneous, self.is_rational)


def _de_boor(knots: FloatArray, points: FloatArray, span: int, t: float) -> list[FloatArray]:
    """De Boor's triangle at a parameter in the span that begins at a knot: its rows (degree, d) to (1, d)."""
    degree = knots.size - len(points) - 1
    rows, near = [points[span - degree : span + 1]], knots[span - degree + 1 : span + degree + 1]
    for level in range(1, degree + 1):
        low, high = near[level - 1 : degree], near[degree : 2 * degree - level + 1]
        share = ((t - low) / (high - low))[:, None]
        rows.append(rows[-1][:-1] * (1 - share) + rows[-1][1:] * share)
    return rows[1:]
