"""Zeros of functions that change sign between known places."""

from collections.abc import Callable

import numpy as np

from elastica_cad._types import FloatArray

ZERO = 1e-11
"""A value below this, in the unit of the function, counts as zero: of lengths in mm, rounding of a 10 m model."""

ZERO_STEPS = 80
"""Far more than the rule needs: it gains more than a digit and a half a step."""


def bracketed_zeros(
    function: Callable[[FloatArray], FloatArray],
    low: FloatArray,
    high: FloatArray,
    *,
    values: tuple[FloatArray, FloatArray],
) -> FloatArray:
    """Zeros (n,), one between each low and high, where the function has the given values of different signs.

    All at once by the false position of Anderson and Bjorck (BIT 13, 1973).
    """
    if not low.size:
        return low
    f, g = values
    root, h = high, g
    for _ in range(ZERO_STEPS):
        moving = np.abs(h) > ZERO
        if not np.any(moving & (np.abs(high - low) > 1e-15 * np.maximum(np.abs(high), np.abs(low)))):
            break
        slope = np.where(g != f, g - f, 1.0)
        root = np.where(moving, high - g * (high - low) / slope, root)
        h = function(root)
        crossed = np.sign(h) * np.sign(g) <= 0
        kept = 1.0 - h / np.where(g != 0, g, 1.0)
        low, f = np.where(crossed, high, low), np.where(crossed, g, f * np.where(kept > 0, kept, 0.5))
        high, g = root, h
    return root
