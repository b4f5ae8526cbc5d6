"""Positions and derivatives of rational Bezier pieces, many parameters at once."""

from dataclasses import dataclass
from functools import cached_property, lru_cache
from math import comb

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.errors import InputError
from elastica_cad.geometry.curves.arc_length import ArcLength, arc_length_table
from elastica_cad.geometry.curves.tangent_angle import TangentCones, cut_into_tangent_cones, hodograph
from elastica_cad.geometry.polynomials.bernstein import (
    binomials,
    interior_roots,
    raise_degree,
    sums_in_pieces,
)
from elastica_cad.geometry.polynomials.bezier_pieces import Spans


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
            raise InputError(f"parameter outside the curve: use {a:g} to {b:g}")
        return np.asarray(inside)

    def at(self, t: FloatArray, order: int, *, left: bool = False) -> list[FloatArray]:
        """Position and derivatives d/dt up to `order`, each (n, 2)."""
        return self.within(*self.spans.locate(self.inside(t), left=left), order)

    def within(self, index: IntArray, u: FloatArray, order: int) -> list[FloatArray]:
        """The same at local coordinates u (n,) of spans (n,)."""
        size = self._dimension
        columns = size * (order + 1)
        values = self._sums(index, u, 0, columns)
        rows = [values[:, k : k + size] for k in range(0, columns, size)]
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

    def position_and_velocity(self, t: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Positions and velocities d/dt, (n, 2) each."""
        position, velocity = self.at(t, 1)
        return position, velocity

    def speed(self, index: IntArray, t: FloatArray) -> FloatArray:
        """Lengths (n,) of the velocities d/dt, mm, at parameters (n,) of spans (n,)."""
        u = (t - self.edges[index]) / self.spans.widths[index]
        u = np.minimum(np.maximum(u, 0.0), 1.0)
        if self.rational:
            return norm(self.within(index, u, 1)[1])
        return norm(self._sums(index, u, 2, 4))

    def _sums(self, index: IntArray, u: FloatArray, first: int, end: int) -> FloatArray:
        """Columns (n, ...) from `first` to `end` of `_series` at local coordinates u (n,) of spans (n,)."""
        return sums_in_pieces(self._series, index, u, first, end)

    def stationary(self) -> FloatArray:
        """Parameters (k,) of the knots and of all places where x or y is stationary."""
        velocity, edges = hodograph(self.bezier), self.edges
        inner = [root for axis in (0, 1) for root in interior_roots(velocity[..., axis])]
        return np.array(
            [*edges, *(edges[r.piece] + r.u * (edges[r.piece + 1] - edges[r.piece]) for r in inner)]
        )

    @cached_property
    def arc_length(self) -> ArcLength:
        """By the parameter."""
        return arc_length_table(self.speed, self.edges)

    @cached_property
    def tangent_cones(self) -> TangentCones:
        """Parts of the curve within which it turns by less than half a turn."""
        return cut_into_tangent_cones(hodograph(self.bezier), self.edges)

    @property
    def _dimension(self) -> int:
        """Numbers of a place: x, y, and w where weights differ."""
        return 3 if self.rational else 2

    @cached_property
    def _series(self) -> FloatArray:
        """Position and its first three derivatives d/dt of every piece, in one scaled Bernstein basis.

        (p, degree + 1, 4 * 2 or 3). Each piece is seen from its middle control point, from which the others are
        subtracted without rounding: the second derivatives of short pieces far from the origin would otherwise
        carry that of their coordinates.
        """
        spans, degree = self.spans, self.spans.degree
        near = self.control_points[self._acting]
        near[..., :2] -= near[..., 2:] * self._origins[:, None, :]
        difference = spans.matrix @ near[..., : self._dimension]
        series = np.zeros((len(near), degree + 1, _ORDERS, self._dimension))
        factor = np.ones(len(near))
        # derivatives overflow where knots nearly coincide: callers that need them refuse such curves
        with np.errstate(over="ignore", invalid="ignore"):
            for k in range(min(degree, _ORDERS - 1) + 1):
                if k:
                    difference = difference[:, 1:] - difference[:, :-1]
                    factor = factor * (degree - k + 1) / spans.widths
                series[:, :, k] = _raised(degree, k) @ difference * factor[:, None, None]
        return series.reshape(len(near), degree + 1, -1)

    @cached_property
    def _acting(self) -> IntArray:
        """The control points that act on each piece, (p, degree + 1)."""
        return np.asarray(self.spans.first[:, None] + np.arange(self.spans.degree + 1))

    @cached_property
    def _origins(self) -> FloatArray:
        """Middle control points (p, 2) of the pieces, mm."""
        middle = self.control_points[self.spans.first + self.spans.degree // 2]
        return np.asarray(middle[:, :2] / middle[:, 2:])


_ORDERS = 4  # position and three derivatives


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
