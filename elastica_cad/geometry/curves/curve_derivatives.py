"""Positions and derivatives of rational Bezier pieces, many parameters at once."""

from dataclasses import dataclass
from functools import cached_property
from math import comb

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.errors import InputError
from elastica_cad.geometry.curves.tangent_angle import TangentCones, cut_into_tangent_cones, hodograph
from elastica_cad.geometry.polynomials.bernstein import interior_roots
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

    def inside(self, t: FloatArray) -> FloatArray:
        """The parameters, rounding beyond the ends taken off; others outside are refused."""
        a, b = self.edges[0], self.edges[-1]
        slack = 1e-9 * (b - a)
        if t.size and not (t.min() >= a - slack and t.max() <= b + slack):
            raise InputError(f"parameter outside the curve: use {a:g} to {b:g}")
        return np.asarray(np.minimum(np.maximum(t, a), b))

    def at(self, t: FloatArray, order: int, *, left: bool = False) -> list[FloatArray]:
        """Position and derivatives d/dt up to `order`, each (n, 2)."""
        return self.within(*self.spans.locate(self.inside(t), left=left), order)

    def within(self, index: IntArray, u: FloatArray, order: int) -> list[FloatArray]:
        """The same at local coordinates u (n,) of spans (n,), by de Casteljau's scheme."""
        degree = self.spans.degree
        # the coefficients of the only piece need no copy for every place
        alone = len(self.bezier) == 1 and not self.rational and order < degree
        c = self._columns if alone else self._columns[:, :, index]
        differences: list[FloatArray] = []
        for remaining in range(degree, -1, -1):
            if remaining <= order:
                differences.append(_difference(c))
            if remaining:
                step = (c[1:] - c[:-1]) * u
                step += c[:-1]
                c = step
        homogeneous = []
        factor = np.ones_like(self.spans.widths if alone else u)
        width, origins = (
            (self.spans.widths, self._origins)
            if alone
            else (self.spans.widths[index], self._origins[:, index])
        )
        for k, difference in enumerate(reversed(differences)):
            if k:  # no place is divided by the width: it may be too small for that
                factor = factor * (degree - k + 1) / width
            homogeneous.append(difference * factor)
        homogeneous += [np.zeros_like(homogeneous[0])] * (order + 1 - len(homogeneous))
        if self.rational:
            homogeneous = quotient([h[:2] for h in homogeneous], [h[2] for h in homogeneous])
        homogeneous[0] = homogeneous[0] + origins
        return [np.ascontiguousarray(h.T) for h in homogeneous]

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

    def speed(self, t: FloatArray) -> FloatArray:
        """Lengths (n,) of the velocities d/dt, mm."""
        return norm(self.at(t, 1)[1])

    def stationary(self) -> FloatArray:
        """Parameters (k,) of the knots and of all places where x or y is stationary."""
        velocity, edges = hodograph(self.bezier), self.edges
        inner = [root for axis in (0, 1) for root in interior_roots(velocity[..., axis])]
        return np.array(
            [*edges, *(edges[r.piece] + r.u * (edges[r.piece + 1] - edges[r.piece]) for r in inner)]
        )

    @cached_property
    def tangent_cones(self) -> TangentCones:
        """Parts of the curve within which it turns by less than half a turn."""
        return cut_into_tangent_cones(hodograph(self.bezier), self.edges)

    @cached_property
    def _columns(self) -> FloatArray:
        """Pieces as (degree + 1, 3 or 2, p), the layout in which many points are evaluated fast.

        Each is seen from its middle control point, from which the others are subtracted without rounding: the
        second derivatives of short pieces far from the origin would otherwise carry that of their coordinates.
        """
        near = self.control_points[self._acting]
        near[..., :2] -= near[..., 2:] * self._origins.T[:, None, :]
        kept = near if self.rational else near[..., :2]
        return np.ascontiguousarray(np.einsum("pij,pjk->ikp", self.spans.matrix, kept))

    @cached_property
    def _acting(self) -> IntArray:
        """The control points that act on each piece, (p, degree + 1)."""
        return np.asarray(self.spans.first[:, None] + np.arange(self.spans.degree + 1))

    @cached_property
    def _origins(self) -> FloatArray:
        """Middle control points (2, p) of the pieces, mm."""
        middle = self.control_points[self.spans.first + self.spans.degree // 2]
        return np.ascontiguousarray((middle[:, :2] / middle[:, 2:]).T)


def _difference(c: FloatArray) -> FloatArray:
    """The last forward difference of coefficients (k + 1, ...)."""
    for _ in range(len(c) - 1):
        c = c[1:] - c[:-1]
    return np.asarray(c[0])


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
    return np.asarray(cross(d1, d2) / norm(d1) ** 3)


def curvature_slope(d1: FloatArray, d2: FloatArray, d3: FloatArray) -> FloatArray:
    """Derivative of the curvature by arc length (n,), from derivatives (n, 2) by any parameter."""
    speed2 = (d1**2).sum(axis=1)
    return np.asarray(cross(d1, d3) / speed2**2 - 3 * cross(d1, d2) * (d1 * d2).sum(axis=1) / speed2**3)


def norm(v: FloatArray) -> FloatArray:
    """Lengths (n,) of vectors (n, 2)."""
    return np.asarray(np.hypot(v[:, 0], v[:, 1]))


def cross(u: FloatArray, v: FloatArray) -> FloatArray:
    """Determinants (n,) of pairs of vectors (n, 2)."""
    return np.asarray(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])
