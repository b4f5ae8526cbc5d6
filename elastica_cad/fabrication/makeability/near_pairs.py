"""Pairs of points that lie near each other."""

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.geometry.running_sums import numbers_in_groups


def near_pairs(points: FloatArray, reach: float) -> IntArray:
    """The pairs (2, k) of points (n, 2) no farther apart than `reach`, the smaller number of each first.

    Points are sorted into square cells of that size: a point's neighbours lie in its own cell and the next up its
    column, or in three of the next column. (scipy's trees find as much, and are a quarter of a second in loading.)

    Examples
    --------
    >>> near_pairs(np.array([[0.0, 0.0], [5.0, 0.0], [0.6, 0.8], [5.0, 1.1]]), 1.0).tolist()
    [[0], [2]]
    """
    column, row = np.floor((points - points.min(axis=0)) / reach).astype(np.int64).T
    tall = int(row.max()) + 3
    cell = column * tall + row
    order = np.argsort(cell, kind="stable")
    cell, each = cell[order], np.arange(cell.size)
    x, y = points[order].T.copy()
    found = []
    for first, last in ((each + 1, cell + 1), (cell.searchsorted(cell + tall - 1), cell + tall + 1)):
        end = cell.searchsorted(last, side="right")
        count = end - first
        i = np.repeat(each, count)
        j = numbers_in_groups(count) + np.repeat(first, count)
        near = np.hypot(x.take(i) - x.take(j), y.take(i) - y.take(j)) <= reach
        i, j = order.take(i[near]), order.take(j[near])
        found.append(np.stack([np.minimum(i, j), np.maximum(i, j)]))
    return np.concatenate(found, axis=1)
