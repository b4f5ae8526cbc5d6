"""Knots of a spline with their multiplicities."""

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
