"""Splines as functions: their values, and those through given values."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from elastica_cad._compiled_scipy import collocation, lapack
from elastica_cad._types import FloatArray
from elastica_cad.geometry.polynomials.bezier_pieces import Spans, bezier_spans
from elastica_cad.geometry.polynomials.knot_runs import greville


@dataclass(frozen=True, eq=False)
class SplineFunction:
    """A spline whose values and derivatives are asked at many places.

    Parameters
    ----------
    spans : Spans
        Of its knots.
    pieces : (p, degree + 1, ...) array
        Its Bezier coefficients on each span.

    Examples
    --------
    >>> parabola = SplineFunction.of(np.repeat([0.0, 2.0], 3), np.array([0.0, 0.0, 4.0]), 2)
    >>> parabola(np.array([1.0, 3.0])).tolist(), float(parabola(np.array(1.0), 1))
    ([1.0, 9.0], 2.0)
    """

    spans: Spans
    pieces: FloatArray

    @classmethod
    def of(cls, knots: FloatArray, coefficients: FloatArray, degree: int) -> "SplineFunction":
        """Of a full knot vector (m + degree + 1,) and coefficients (m, ...)."""
        spans = bezier_spans(knots, degree)
        return cls(spans, spans.bezier(coefficients))

    def scaled(self, factor: float) -> "SplineFunction":
        """The function times `factor`."""
        return SplineFunction(self.spans, self.pieces * factor)

    def stretched(self, fixed: float, now: float, factor: float) -> "SplineFunction":
        """The function stretched by `factor` about the value `fixed`, which becomes `now`."""
        return SplineFunction(self.spans, now + (self.pieces - fixed) * factor)

    def __call__(self, x: FloatArray, derivative: int = 0) -> FloatArray:
        """Values of the shape of x and of one coefficient; beyond the ends the last pieces go on."""
        spans, degree = self.spans, self.spans.degree
        if derivative > degree:
            return np.zeros((*x.shape, *self.pieces.shape[2:]))
        index = spans.edges[1:-1].searchsorted(x, side="right")
        width = spans.widths.take(index)
        u = (x - spans.edges.take(index)) / width
        if self.pieces.ndim > 2:
            u, width = (np.reshape(one, x.shape + (1,) * (self.pieces.ndim - 2)) for one in (u, width))
        rows = self._rows.take(index, axis=1)
        factor: float | FloatArray = 1.0
        for k in range(derivative):
            rows, factor = rows[1:] - rows[:-1], factor * (degree - k) / width
        while len(rows) > 1:  # de Casteljau
            steps = rows[1:] - rows[:-1]
            steps *= u
            steps += rows[:-1]
            rows = steps
        return np.asarray(rows[0] * factor if derivative else rows[0])

    @cached_property
    def _rows(self) -> FloatArray:
        """The first coefficients of all spans, the second ones and so on, (degree + 1, p, ...)."""
        return np.ascontiguousarray(self.pieces.swapaxes(0, 1))


def spline_through(x: FloatArray, values: FloatArray, degree: int) -> tuple[FloatArray, FloatArray]:
    """Knots and coefficients (n, ...) of the spline of odd degree through values (n, ...) at increasing x (n,).

    A cubic one has no knots at the places next to its ends, so that it is one polynomial there, a quintic one none
    at the two next to them. Of even degree it is the one polynomial through degree + 1 places.

    Examples
    --------
    >>> knots, coefficients = spline_through(np.arange(4.0), np.arange(4.0) ** 3 + 1, 3)
    >>> knots.tolist(), coefficients.round(9).tolist()
    ([0.0, 0.0, 0.0, 0.0, 3.0, 3.0, 3.0, 3.0], [1.0, 1.0, 1.0, 28.0])
    """
    beside = (degree + 1) // 2
    ends = np.repeat(x[:1], degree + 1), np.repeat(x[-1:], degree + 1)
    knots = np.concatenate([ends[0], x[beside:-beside] if degree % 2 else x[:0], ends[1]])
    spans = bezier_spans(knots, degree)
    basis, index = spans.local_basis(x)
    column = spans.first[index][:, None] + np.arange(degree + 1)
    bands = np.zeros((3 * degree + 1, x.size))
    bands[2 * degree + np.arange(x.size)[:, None] - column, column] = basis
    *_, coefficients, info = lapack().dgbsv(degree, degree, bands, values)
    if info != 0:
        raise np.linalg.LinAlgError("places of an interpolation are too close together")
    return knots, np.asarray(coefficients, dtype=float)


def interpolation_sites(knots: FloatArray, degree: int) -> FloatArray:
    """Where splines over clamped knots take values (m,): Greville abscissae, the ends exactly at the ends."""
    sites = greville(knots, degree)
    sites[[0, -1]] = knots[[0, -1]]
    return sites


def interpolated(sites: FloatArray, values: FloatArray, knots: FloatArray, degree: int) -> FloatArray:
    """Coefficients (m, ...) of the spline over given knots that has `values` (m, ...) at `sites` (m,)."""
    fill = collocation()
    if fill is None:
        from scipy.interpolate import make_interp_spline

        return np.asarray(make_interp_spline(sites, values, k=degree, t=knots).c, dtype=float)
    # what that does, without its checks, which cost as much
    bands = np.zeros((3 * degree + 1, sites.size), order="F")
    fill(sites, knots, degree, bands)
    *_, coefficients, info = lapack().dgbsv(
        degree, degree, bands, values.reshape(sites.size, -1), overwrite_ab=True
    )
    if info != 0:
        raise np.linalg.LinAlgError("places of an interpolation are too close together")
    return np.ascontiguousarray(coefficients).reshape(values.shape)
