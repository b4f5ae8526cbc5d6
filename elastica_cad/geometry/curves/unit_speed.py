"""Curves from their tangent along the arc length."""

from collections.abc import Callable, Sequence

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.polynomials.spline_fits import adaptive_spline

DEGREE = 5  # curvature with two derivatives, which checks of equilibrium look at


def integrate_tangents(
    tangent: Callable[[FloatArray], FloatArray],
    length: float,
    start: FloatArray,
    *,
    tolerance: float,
    breaks: Sequence[tuple[float, int]] = (),
) -> PlaneCurve:
    """The spline of degree 5 from `start` (2,), mm, whose parameter is arc length, to the tolerance.

    Parameters
    ----------
    tangent : callable
        Maps arc lengths (k,), mm, to unit vectors (k, 2).
    tolerance : float
        Largest error of a tangent.
    breaks : sequence of (s, continuity)
        Places where the tangent is only `continuity` times differentiable.

    Examples
    --------
    >>> quarter = integrate_tangents(
    ...     lambda s: np.column_stack([np.cos(s), np.sin(s)]), np.pi / 2, np.zeros(2), tolerance=1e-9
    ... )
    >>> quarter.evaluate(np.array(np.pi / 2)).round(6).tolist()
    [1.0, 1.0]
    """
    knots, rows = adaptive_spline(
        tangent, (0.0, length), degree=DEGREE - 1, tolerance=tolerance, breaks=breaks
    )
    reach = (knots[DEGREE:] - knots[:-DEGREE]) / DEGREE  # of a basis function's integral
    points = start + np.pad(np.cumsum(reach[:, None] * rows, axis=0), ((1, 0), (0, 0)))
    return PlaneCurve(np.pad(knots, 1, mode="edge"), points, DEGREE)
