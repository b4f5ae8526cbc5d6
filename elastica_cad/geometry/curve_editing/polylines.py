"""Polylines of drawings: the smooth curve through the vertices, and its distance from the drawn sides."""

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.polynomials.spline_fits import fit_spline
from elastica_cad.geometry.running_sums import lengths_along

DEGREE = 4
FIT_TOLERANCE = 0.05
"""Distance, mm, of a curve from the points that it is fitted to."""

_EACH = 4  # samples of the curve for each side


def fit_polyline(vertices: FloatArray, tolerance: float) -> tuple[PlaneCurve, float]:
    """Return the smooth curve within `tolerance` mm of the vertices (n, 2), and its distance from the sides.

    Raises
    ------
    NotConvergedError
        The vertices are too noisy for a smooth curve.

    Examples
    --------
    >>> angles = np.linspace(0, np.pi, 37)
    >>> curve, distance = fit_polyline(100 * np.column_stack([np.cos(angles), np.sin(angles)]), 0.05)
    >>> round(curve.length, 1), round(distance, 1)
    (314.2, 0.1)
    """
    curve = smooth_through(vertices, tolerance)
    return curve, _distance_from_sides(curve, vertices)


def allowed_distance(vertices: FloatArray) -> float:
    """Return the distance, mm, up to which a smooth curve counts as what a polyline with these vertices means."""
    return max(0.5, 0.005 * float(np.ptp(vertices, axis=0).max()))


def smooth_through(points: FloatArray, tolerance: float) -> PlaneCurve:
    """Return the line through points (n, 2) that are in line, else the spline within `tolerance` mm of them."""
    chord = points[-1] - points[0]
    x, y = chord / max(float(np.hypot(*chord)), 1e-300)
    along, across = ((points - points[0]) @ np.array([[x, -y], [y, x]])).T
    if np.abs(across).max() <= 1e-9 * np.abs(along).max() and np.all(np.diff(along) > 0):
        return PlaneCurve.line(points[0], points[-1])
    return PlaneCurve(*fit_spline(points, DEGREE, tolerance), DEGREE)


def _distance_from_sides(curve: PlaneCurve, vertices: FloatArray) -> float:
    """Return the largest distance of the curve from the sides near the same fraction of the length."""
    places = lengths_along(vertices)
    count = _EACH * len(places)
    positions = curve.sample(count).position
    side = np.searchsorted(places, places[-1] * np.linspace(0, 1, count)[1:-1], side="right") - 1
    nearest = np.full(count - 2, np.inf)
    for offset in (-1, 0, 1):
        index = np.clip(side + offset, 0, len(places) - 2)
        start, way = vertices[index], vertices[index + 1] - vertices[index]
        out = positions[1:-1] - start
        fraction = np.clip((out * way).sum(axis=1) / (way**2).sum(axis=1), 0, 1)
        nearest = np.minimum(nearest, np.linalg.norm(out - fraction[:, None] * way, axis=1))
    return float(nearest.max())
