"""Projective maps of rational splines."""

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.errors import InputError
from elastica_cad.geometry.bernstein import split
from elastica_cad.geometry.checks import finite

__all__ = ["projected"]

_MOST_HALVINGS = 30


def projected(
    knots: FloatArray,
    control_points: FloatArray,
    weights: FloatArray | None,
    matrix: ArrayLike,
    *,
    degree: int,
    bezier: FloatArray,
    edges: FloatArray,
) -> tuple[FloatArray, FloatArray, FloatArray | None]:
    """Knots, control points and weights of the image of a spline under a 3 x 3 matrix.

    The map acts linearly on homogeneous control points. Where a control point (not the curve) would get a
    weight that is not positive, the image is written as Bezier pieces, halved until all weights are positive.
    """
    m = finite("matrix", matrix)
    if m.shape != (3, 3):
        raise InputError(f"a projective map is a 3 x 3 matrix, not {m.shape}")
    if np.linalg.matrix_rank(m) < 3:
        raise InputError("the matrix is singular: it would flatten the plane; use an invertible one")
    affine = not m[2, :2].any()
    w = np.ones(control_points.shape[0]) if weights is None else weights
    image = np.column_stack([control_points * w[:, None], w]) @ m.T
    if affine:
        return knots, image[:, :2] / image[:, 2:], weights
    if np.all(image[:, 2] > 0) or np.all(image[:, 2] < 0):
        return knots, image[:, :2] / image[:, 2:], np.abs(image[:, 2])
    pieces = _positive_pieces(bezier @ m.T, edges)
    t = [edges[0]] * (degree + 1)
    for start, _ in pieces[1:]:
        t += [start] * degree
    t += [edges[-1]] * (degree + 1)
    # neighbours share their end point, so each piece but the first leaves out its first control point
    points = np.concatenate([pieces[0][1], *(p[1:] for _, p in pieces[1:])])
    return np.array(t), points[:, :2] / points[:, 2:], np.abs(points[:, 2])


def _positive_pieces(bezier: FloatArray, edges: FloatArray) -> list[tuple[float, FloatArray]]:
    sign = np.sign(bezier[0, 0, 2])
    todo = [(float(a), float(b), p * sign, 0) for a, b, p in zip(edges[:-1], edges[1:], bezier, strict=True)][
        ::-1
    ]
    done: list[tuple[float, FloatArray]] = []
    while todo:
        a, b, piece, depth = todo.pop()
        if np.all(piece[:, 2] > 0):
            done.append((a, piece))
            continue
        if min(piece[0, 2], piece[-1, 2]) <= 0 or depth == _MOST_HALVINGS:
            raise InputError(
                "the projective map sends the curve through infinity, near parameter "
                f"{a if piece[0, 2] <= 0 else b:g}: keep the map's vanishing line off the curve"
            )
        left, right = (np.ascontiguousarray(h.T) for h in split(piece.T))
        middle = (a + b) / 2
        todo += [(middle, b, right, depth + 1), (a, middle, left, depth + 1)]
    return done
