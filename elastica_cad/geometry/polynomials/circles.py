"""Circles of many arcs as arrays."""

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray


def points_on_circles(
    centers: FloatArray, radii: FloatArray | float, angles: FloatArray | float
) -> FloatArray:
    """Points (..., 2) at angles (...), rad, from the x axis.

    Examples
    --------
    >>> points_on_circles(np.array([[3.0, 4.0]]), np.array([2.0]), np.array([0.0])).tolist()
    [[5.0, 4.0]]
    """
    reach = np.asarray(radii)[..., None]
    return np.asarray(centers + reach * np.stack([np.cos(angles), np.sin(angles)], axis=-1), dtype=float)


def swept_by(start: FloatArray, end: FloatArray, radius: ArrayLike, sweep: ArrayLike) -> FloatArray:
    """Areas (...,), mm2, that rays sweep along arcs, or lines (radius and sweep 0), from start to end (..., 2)."""
    triangle = start[..., 0] * end[..., 1] - start[..., 1] * end[..., 0]
    segment = np.square(radius) * _beyond_sine(np.asarray(sweep, dtype=float))
    return np.asarray(0.5 * (triangle + segment), dtype=float)


def _beyond_sine(x: FloatArray) -> FloatArray:
    """x - sin x without cancellation, so that the segment of a flat arc keeps its digits."""
    y = x * x
    near = x * y / 6 * (1 - y / 20 * (1 - y / 42 * (1 - y / 72 * (1 - y / 110))))
    return np.where(np.abs(x) > 0.3, x - np.sin(x), near)
