"""Gauss rules, whose places numpy finds anew each time as eigenvalues."""

from functools import lru_cache

import numpy as np

from elastica_cad._types import FloatArray


@lru_cache(maxsize=64)
def gauss_rule(count: int) -> tuple[FloatArray, FloatArray]:
    """Places and weights (count,) of the Gauss rule over [-1, 1], read-only."""
    places, weights = np.polynomial.legendre.leggauss(count)
    places.setflags(write=False)
    weights.setflags(write=False)
    return places, weights
