"""Among stiffness profiles of nearly the least ratio the smoothest: the second phase of section 5.3."""

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import NotConvergedError


def least_variation(
    rows: FloatArray, offset: FloatArray, bends: FloatArray, bend_offset: FloatArray, largest: float
) -> FloatArray:
    """The numbers x that minimise sum |bends @ x + bend_offset| subject to 1 <= rows @ x + offset <= largest.

    With bends = K'' times the length it stands for this is V(K'), the total variation of K' (paper, section
    5.3).

    Parameters
    ----------
    rows, offset : (n, m) and (n,) arrays
        Stiffness.
    bends, bend_offset : (k, m) and (k,) arrays
        The terms of the variation.
    """
    from scipy.optimize import linprog

    if bends.shape[1] == 1:
        return _least_variation_of_one(rows[:, 0], offset, bends[:, 0], bend_offset, largest)
    # the dual program: as many rows as there are numbers, which are the prices of its rows
    matrix = np.concatenate([bends, -rows, rows]).T
    cost = -np.concatenate([bend_offset, 1 - offset, offset - largest])
    bounds = np.zeros((cost.size, 2))
    bounds[:, 1] = np.inf
    bounds[: len(bends)] = -1.0, 1.0
    result = linprog(cost, A_eq=matrix, b_eq=np.zeros(len(matrix)), bounds=bounds, method="highs",
                     options={"presolve": False})  # fmt: skip
    if result.status != 0:
        raise NotConvergedError(f"the second phase for a smooth stiffness stopped: {result.message}")
    return np.asarray(result.eqlin.marginals, dtype=float)


def _least_variation_of_one(
    row: FloatArray, offset: FloatArray, bend: FloatArray, bend_offset: FloatArray, largest: float
) -> FloatArray:
    """The same for a single number: the weighted median of where the terms vanish, moved into its bounds."""
    counts = bend != 0
    zeros, steep = -bend_offset[counts] / bend[counts], np.abs(bend[counts])
    order = np.argsort(zeros)
    passed = np.cumsum(steep[order])
    best = float(zeros[order][np.searchsorted(passed, passed[-1] / 2)]) if zeros.size else 0.0
    moves = row != 0
    bounds = np.sort([(1 - offset[moves]) / row[moves], (largest - offset[moves]) / row[moves]], axis=0)
    low, high = float(bounds[0].max()), float(bounds[1].min())
    return np.array([min(max(best, low), high) if low <= high else (low + high) / 2])


def largest_number(rows: FloatArray, number: FloatArray, largest: float) -> FloatArray:
    """The numbers x of the largest number @ x subject to 1 <= rows @ x <= largest."""
    from scipy.optimize import linprog

    limit = np.concatenate([np.full(len(rows), -1.0), np.full(len(rows), largest)])
    result = linprog(-number, np.concatenate([-rows, rows]), limit, bounds=(None, None), method="highs")
    if result.status != 0:
        raise NotConvergedError(f"the linear program for the bending stiffness stopped: {result.message}")
    return np.asarray(result.x, dtype=float)
