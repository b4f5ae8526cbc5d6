"""Knots of a spline: their multiplicities, and where along them its coefficients stand."""

from collections.abc import Mapping

import numpy as np

from elastica_cad._types import FloatArray, IntArray


def knot_runs(knots: FloatArray) -> tuple[FloatArray, IntArray]:
    """The distinct knots (k,) of a vector that never falls, and how often each stands there (k,).

    Examples
    --------
    >>> places, counts = knot_runs(np.array([0.0, 0.0, 1.0, 2.0, 2.0]))
    >>> places.tolist(), counts.tolist()
    ([0.0, 1.0, 2.0], [2, 1, 2])
    """
    rises = np.ones(knots.size + 1, dtype=bool)
    np.not_equal(knots[1:], knots[:-1], out=rises[1:-1])
    first = rises.nonzero()[0]  # of every run, and the end of the last one
    counts = first[1:] - first[:-1]
    return knots[first[:-1]], counts


def clamped_knots(edges: FloatArray, continuity: Mapping[float, int], degree: int) -> FloatArray:
    """Knots (m,) of a spline over the spans between edges (k,), as smooth at some of these as `continuity` says.

    Examples
    --------
    >>> clamped_knots(np.array([0.0, 1.0, 2.0]), {1.0: 0}, 2).tolist()
    [0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 2.0]
    """
    return edges.repeat(knot_repeats(edges, continuity, degree))


def knot_repeats(edges: FloatArray, continuity: Mapping[float, int], degree: int) -> IntArray:
    """How often (k,) each edge stands among the `clamped_knots`.

    Examples
    --------
    >>> knot_repeats(np.array([0.0, 1.0, 2.0]), {1.0: 0}, 2).tolist()
    [3, 2, 3]
    """
    counts = np.ones(edges.size, dtype=int)
    repeats = [min(max(degree - order, 1), degree + 1) for order in continuity.values()]
    counts[edges.searchsorted(list(continuity))] = repeats
    counts[[0, -1]] = degree + 1
    return counts


def greville(knots: FloatArray, degree: int) -> FloatArray:
    """Greville abscissae (..., m) of knot vectors (..., m + degree + 1): with these as x a spline draws itself.

    Examples
    --------
    >>> greville(np.array([0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 2.0]), 2).tolist()
    [0.0, 0.5, 1.5, 2.0]
    """
    count = knots.shape[-1] - degree - 1
    total = sum((knots[..., i : i + count] for i in range(2, degree + 1)), start=knots[..., 1 : count + 1])
    return np.asarray(total / degree, dtype=float)
