"""Affine maps of the plane as 3x3 matrices: what moves, turns, mirrors or scales a drawing."""

from math import atan2, hypot, inf, isfinite

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import numbers
from elastica_cad.errors import InputError


def transform_points(matrix: ArrayLike, points: ArrayLike) -> FloatArray:
    """Points (..., 2) moved by a 3x3 affine matrix."""
    m = require_affine(matrix)
    moved = (np.asarray(points, dtype=float) @ m[:2, :2].T + m[:2, 2]) / m[2, 2]
    return np.asarray(moved, dtype=float)


def require_affine(matrix: ArrayLike) -> FloatArray:
    """The matrix, refused unless it is affine and invertible."""
    m = numbers(matrix, "the matrix that a path is moved by")
    if m.shape != (3, 3):
        raise InputError("a path is moved by a finite 3x3 matrix with the last row 0, 0, 1")
    (a, b, x), (c, d, y), last = m.tolist()  # plain numbers: this is asked once for every segment
    if not all(map(isfinite, (a, b, x, c, d, y))) or last[:2] != [0.0, 0.0] or not 0 < abs(last[2]) < inf:
        raise InputError("a path is moved by a finite 3x3 matrix with the last row 0, 0, 1")
    if abs(a * d - b * c) <= 1e-14 * max(abs(a), abs(b), abs(c), abs(d)) ** 2:
        raise InputError("a path can't be flattened to a line: use an invertible matrix")
    return m


def is_similarity(matrix: ArrayLike) -> bool:
    """True where a 3x3 affine matrix keeps circles circles."""
    (a, b, _), (c, d, _), _ = require_affine(matrix).tolist()
    slack = 1e-12 * max(abs(a), abs(b), abs(c), abs(d))
    turned = bool(abs(b + c) <= slack and abs(d - a) <= slack)
    return turned or bool(abs(b - c) <= slack and abs(d + a) <= slack)


def similarity_of(matrix: FloatArray) -> tuple[float, float, float]:
    """Scale, angle (rad) and hand of a similarity, a 3x3 matrix that keeps circles circles.

    The hand is 1.0, or -1.0 where the map mirrors in the x axis before it turns. That the matrix is a similarity is
    not checked: `is_similarity` does that.

    Examples
    --------
    >>> similarity_of(np.diag([2.0, -2.0, 1.0]))
    (2.0, 0.0, -1.0)
    """
    (a, b, _), (c, d, _), (_, _, last) = matrix.tolist()
    way = 1.0 if last > 0 else -1.0
    return hypot(a, c) / abs(last), atan2(way * c, way * a), 1.0 if a * d > b * c else -1.0
