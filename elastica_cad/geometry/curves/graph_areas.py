"""The area beside a long spline that is the graph of a function: a sum over its control points."""

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.polynomials.knot_runs import greville

ROUNDING = 1e-14
"""Share of its size by which x of a graph strays from running evenly: rounding, which no area feels."""


def area_beside_graph(curve: PlaneCurve, origin: FloatArray) -> float | None:
    """Signed area swept by the ray from `origin` (2,), mm2, where x runs evenly along a clamped curve, else None.

    The integral of a basis function over clamped knots is its support's width over degree + 1, so the area under
    the graph is a sum, to rounding error.

    Examples
    --------
    >>> parabola = PlaneCurve([0, 0, 0, 3, 3, 3], [(0, 0), (1.5, 0), (3, 9)], 2)
    >>> area_beside_graph(parabola, np.zeros(2))
    4.5
    """
    p, knots, (x, y) = curve.degree, curve.knots, curve.control_points.T
    if curve.weights is not None or knots[0] != knots[p] or knots[-1] != knots[-p - 1]:
        return None
    (first, last), run = curve.domain, x[-1] - x[0]
    even = x[0] + run * (greville(knots, p) - first) / (last - first)
    if np.abs(even - x).max() > ROUNDING * np.abs(x).max():
        return None
    (left, right), (low, high) = x[[0, -1]] - origin[0], y[[0, -1]] - origin[1]
    under = run / (last - first) * ((y - origin[1]) @ (knots[p + 1 :] - knots[: -p - 1])) / (p + 1)
    return float((right * high - left * low) / 2 - under)
