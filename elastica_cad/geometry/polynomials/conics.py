"""Exact rational B-splines of circular and elliptic arcs."""

from math import ceil, cos, pi

import numpy as np

from elastica_cad._types import FloatArray


def unit_circle_arc(start: float, end: float) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Knots, control points (m, 2) and weights (m,) of degree 2 for the unit circle from angle start to end.

    Segments of at most a quarter turn, joined by double knots at the angles where they meet; the middle
    control point of a segment of angle 2 h has weight cos h (Piegl and Tiller, The NURBS Book, section 7.3).
    """
    count = max(1, ceil(abs(end - start) / (pi / 2) * (1 - 1e-12)))
    half = (end - start) / count / 2
    angle = start + half * np.arange(2 * count + 1)
    weights = np.ones(angle.size)
    weights[1::2] = cos(half)
    points = np.stack([np.cos(angle), np.sin(angle)], axis=1) / weights[:, None]
    joints = np.linspace(min(start, end), max(start, end), count + 1) - min(start, end)
    knots = np.concatenate([[0.0], np.repeat(joints, 2), [joints[-1]]])
    return knots, points, weights
