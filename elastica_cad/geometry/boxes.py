"""Boxes along the axes, as their least and largest coordinates."""

import numpy as np

from elastica_cad._types import BoolArray, FloatArray


def box_about(points: FloatArray) -> FloatArray:
    """Least and largest coordinates (2, d) of points (n, d).

    Examples
    --------
    >>> box_about(np.array([[0.0, 5.0], [2.0, 1.0]])).tolist()
    [[0.0, 1.0], [2.0, 5.0]]
    """
    return np.array([points.min(axis=0), points.max(axis=0)])


def boxes_about(points: FloatArray) -> FloatArray:
    """Least and largest coordinates (k, 2, d) of each of many sets of points (k, n, d).

    Examples
    --------
    >>> boxes_about(np.array([[[0, 5], [2, 1]], [[1, 1], [0, 0]]])).tolist()
    [[[0, 1], [2, 5]], [[0, 0], [1, 1]]]
    """
    return np.stack([points.min(axis=1), points.max(axis=1)], axis=1)


def box_around(boxes: FloatArray) -> FloatArray:
    """The box (2, d) about boxes (n, 2, d).

    Examples
    --------
    >>> box_around(np.array([[[0, 1], [2, 3]], [[1, 0], [3, 2]]])).tolist()
    [[0, 0], [3, 3]]
    """
    return np.array([boxes[:, 0].min(axis=0), boxes[:, 1].max(axis=0)])


def boxes_meet(a: FloatArray, b: FloatArray) -> BoolArray:
    """Do boxes (..., 2, d) overlap or touch?

    Examples
    --------
    >>> boxes_meet(np.array([[0, 0], [2, 2]]), np.array([[[1, 1], [3, 3]], [[3, 0], [4, 1]]])).tolist()
    [True, False]
    """
    return np.asarray(((a[..., 0, :] <= b[..., 1, :]) & (a[..., 1, :] >= b[..., 0, :])).all(axis=-1))
