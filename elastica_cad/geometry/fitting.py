"""Few control points for measured or computed points: least-squares splines with fixed ends."""

from itertools import pairwise

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.errors import InputError
from elastica_cad.geometry.checks import finite
from elastica_cad.geometry.extraction import Spans, bezier_spans

__all__ = ["fitted_spline"]

_CORRECTIONS = 4


def fitted_spline(
    points: ArrayLike, degree: int, tolerance: float, smoothing: float | None
) -> tuple[FloatArray, FloatArray]:
    """Knots and control points of a clamped spline within `tolerance` of `points` (n, 2)."""
    data = _cleaned(points)
    if degree not in (3, 4, 5):
        raise InputError(f"curves are fitted with degree 3, 4 or 5, not {degree!r}")
    if not tolerance > 0:
        raise InputError(f"the tolerance of a fit must be positive, not {tolerance!r} mm")
    chord = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(data, axis=0).T))])
    t = chord / chord[-1]
    inner = np.empty(0)
    most = max(data.shape[0] - degree - 1, 0)
    while True:
        knots = np.concatenate([np.zeros(degree + 1), inner, np.ones(degree + 1)])
        spans = bezier_spans(knots, degree)
        for _ in range(_CORRECTIONS):
            control = _least_squares(spans, t, data, smoothing)
            t = _corrected(spans, control, t, data)
        control = _least_squares(spans, t, data, smoothing)
        error = _distance(spans, control, t, data)
        if error.max() <= tolerance or inner.size >= most:
            return knots, control
        added = _new_knots(spans.edges, t, error, tolerance)
        if not added.size:
            return knots, control
        inner = np.sort(np.concatenate([inner, added]))[: most + inner.size]


def _cleaned(points: ArrayLike) -> FloatArray:
    data = finite("points", points)
    if data.ndim != 2 or data.shape[1] != 2:
        raise InputError(f"points to fit must be rows of x, y: shape (n, 2), not {data.shape}")
    kept = (
        np.concatenate([[True], np.any(np.diff(data, axis=0) != 0, axis=1)])
        if len(data)
        else np.empty(0, bool)
    )
    data = data[kept]
    if data.shape[0] < 2:
        raise InputError(
            "points to fit all coincide or are fewer than two: give at least two different points"
        )
    return data


def _least_squares(spans: Spans, t: FloatArray, data: FloatArray, smoothing: float | None) -> FloatArray:
    basis = spans.basis(t)
    normal, right = basis.T @ basis, basis.T @ data
    weight = 1e-12 if smoothing is None else float(smoothing)
    normal = normal + (weight * data.shape[0]) * _penalty(spans)
    ends = data[[0, -1]]
    right = right - normal[:, [0, -1]] @ ends
    inner: FloatArray = np.linalg.solve(normal[1:-1, 1:-1], right[1:-1])
    return np.asarray(np.concatenate([ends[:1], inner, ends[1:]]))


def _penalty(spans: Spans) -> FloatArray:
    """Gram matrix (m, m) of the third derivatives of the basis functions."""
    x, w = np.polynomial.legendre.leggauss(max(spans.degree - 2, 1))
    width = np.diff(spans.edges)
    t = (spans.edges[:-1, None] + width[:, None] * (1 + x) / 2).ravel()
    rows = spans.basis(t, 3) * np.sqrt((width[:, None] / 2 * w).ravel())[:, None]
    return np.asarray(rows.T @ rows)


def _corrected(spans: Spans, control: FloatArray, t: FloatArray, data: FloatArray) -> FloatArray:
    """Parameters moved to the feet of the points on the curve (one Gauss-Newton step), order kept."""
    gap = data - spans.basis(t) @ control
    velocity = spans.basis(t, 1) @ control
    speed2 = np.maximum((velocity**2).sum(axis=1), 1e-30)
    moved = np.clip(t + (gap * velocity).sum(axis=1) / speed2, 0.0, 1.0)
    moved[[0, -1]] = 0.0, 1.0
    return moved if np.all(np.diff(moved) > 0) else t


def _distance(spans: Spans, control: FloatArray, t: FloatArray, data: FloatArray) -> FloatArray:
    gap = data - spans.basis(t) @ control
    return np.asarray(np.hypot(gap[:, 0], gap[:, 1]))


def _new_knots(edges: FloatArray, t: FloatArray, error: FloatArray, tolerance: float) -> FloatArray:
    """One knot in the middle of every span that misses the tolerance and holds points on both sides of it."""
    added = []
    for a, b in pairwise(edges):
        inside = (t >= a) & (t <= b)
        if inside.sum() >= 2 and error[inside].max() > tolerance:
            added.append((a + b) / 2)
    return np.array(added)
