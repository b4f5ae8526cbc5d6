"""Numbers in order: running sums of lengths and turns, numbers within groups, each number once."""

import numpy as np

from elastica_cad._types import FloatArray, IntArray


def lengths_along(points: FloatArray) -> FloatArray:
    """Lengths (n,) of the polyline through points (n, d) up to each of them.

    Examples
    --------
    >>> lengths_along(np.array([[0.0, 0.0], [3.0, 4.0], [3.0, 5.0]])).tolist()
    [0.0, 5.0, 6.0]
    """
    return np.append(0.0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1)))


def turns_along(angles: FloatArray) -> FloatArray:
    """How far (n,) angles (n,) have turned, to either side, up to each of them.

    Examples
    --------
    >>> turns_along(np.array([0.5, 1.5, 0.5])).tolist()
    [0.0, 1.0, 2.0]
    """
    return np.append(0.0, np.cumsum(np.abs(np.diff(angles))))


def numbers_in_groups(counts: IntArray) -> IntArray:
    """0, 1, ... within each of the groups of `counts` (k,), one group after the other.

    Examples
    --------
    >>> numbers_in_groups(np.array([2, 0, 3])).tolist()
    [0, 1, 0, 1, 2]
    """
    return np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)


def distinct(values: FloatArray) -> FloatArray:
    """The values (n,) in order, each once. (numpy's `unique` loads its masked arrays first.)

    Examples
    --------
    >>> distinct(np.array([2.0, 0.5, 2.0])).tolist()
    [0.5, 2.0]
    """
    ordered = np.sort(values)
    return np.asarray(ordered[np.append(True, ordered[1:] != ordered[:-1])])
