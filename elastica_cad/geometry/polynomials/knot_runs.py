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
    places: list[float] = []
    counts: list[int] = []
    for knot in knots.tolist():  # a vector is short: numpy's own sort and search take four times as long
        if places and places[-1] == knot:
            counts[-1] += 1
        else:
            places.append(knot)
            counts.append(1)
    return np.array(places, dtype=float), np.array(counts, dtype=int)
