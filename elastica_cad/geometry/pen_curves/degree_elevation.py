"""The same spline with a higher degree."""

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.polynomials.splines import bezier_spans


def elevate_degree(
    knots: FloatArray, control_points: FloatArray, degree: int, weights: FloatArray | None = None
) -> tuple[FloatArray, FloatArray, FloatArray | None]:
    """Knots, control points and weights of the same clamped spline with one degree more.

    Every piece is raised as a Bezier piece, and control points are joined where pieces meet: knots that had
    multiplicity degree have degree + 1; knots of lower multiplicity become full ones, which leaves the curve as it
    is.

    Examples
    --------
    >>> knots, points, _ = elevate_degree(np.repeat([0.0, 1.0], 3), np.array([(0, 0), (3, 6), (6, 0)]), 2)
    >>> points.tolist()
    [[0.0, 0.0], [2.0, 4.0], [4.0, 4.0], [6.0, 0.0]]
    """
    spans = bezier_spans(knots, degree)
    w = np.ones(len(control_points)) if weights is None else weights
    pieces = spans.bezier(np.column_stack([control_points * w[:, None], w]))
    share = np.arange(1, degree + 1)[:, None] / (degree + 1)
    inner = share * pieces[:, :-1] + (1 - share) * pieces[:, 1:]
    raised = np.concatenate([pieces[:, :1], inner, pieces[:, -1:]], axis=1)
    rows = np.concatenate([raised[0], *(piece[1:] for piece in raised[1:])])
    edges = spans.edges
    new_knots = np.concatenate([edges[:1], np.repeat(edges, degree + 1), edges[-1:]])
    points = rows[:, :2] / rows[:, 2:]
    return new_knots, points, None if weights is None else rows[:, 2]
