"""Patterns of placed strips: mirrored, repeated about an axis, repeated along a direction."""

from collections.abc import Sequence

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import as_floats, is_number, is_whole
from elastica_cad.errors import InputError, quoted
from elastica_cad.fabrication.placed_strip import Placed

MOST_PLACED = 100_000
"""Strips of one model."""


def mirror(
    placed: Sequence[Placed], point: ArrayLike, normal: ArrayLike, *, keep: bool = True
) -> tuple[Placed, ...]:
    """The mirror images in the plane through `point` across `normal`, behind the strips themselves if kept."""
    n, p = _vector(normal), _vector(point)
    if n is None or p is None or not n.any():
        raise InputError("a mirror needs a point and a normal of three numbers, the normal not zero")
    n = n / np.linalg.norm(n)
    turn = np.eye(3) - 2 * np.outer(n, n)
    images = tuple(one.moved(turn, 2 * (p @ n) * n) for one in placed)
    return (*placed, *images) if keep else images


def rotate(
    placed: Sequence[Placed],
    count: int,
    *,
    axis: ArrayLike = (0.0, 0.0, 1.0),
    point: ArrayLike = (0.0, 0.0, 0.0),
    step: float | None = None,
) -> tuple[Placed, ...]:
    """The strips `count` times about an axis, each `step` rad further; the full turn by `count` unless given."""
    k, p = _vector(axis), _vector(point)
    _refuse_too_many(count, len(placed))
    if not (is_whole(count) and count >= 1) or k is None or not k.any():
        raise InputError("a rotation pattern needs a count of 1 or more and an axis that is not zero")
    if p is None or not (step is None or is_number(step)):
        raise InputError(
            f"a rotation pattern turns about a point of three numbers by a step in rad, not {point!r} and {step!r}"
        )
    angle = 2 * np.pi / count if step is None else float(step)
    k = k / np.linalg.norm(k)
    cross = np.array([[0, -k[2], k[1]], [k[2], 0, -k[0]], [-k[1], k[0], 0]])
    copies = list(placed)
    for i in range(1, count):
        turn = np.eye(3) + np.sin(i * angle) * cross + (1 - np.cos(i * angle)) * cross @ cross
        copies += [one.moved(turn, p - turn @ p) for one in placed]
    return tuple(copies)


def repeat(placed: Sequence[Placed], count: int, step: ArrayLike) -> tuple[Placed, ...]:
    """The strips `count` times, the first where they are, each `step` (3,) mm further."""
    if not (is_whole(count) and count >= 1):
        raise InputError(f"a pattern repeats 1 time or more, not {count}")
    _refuse_too_many(count, len(placed))
    d = _vector(step)
    if d is None:
        raise InputError(f"a pattern repeats at a step of three numbers in mm, not {step!r}")
    return tuple(one.moved(np.eye(3), i * d) for i in range(count) for one in placed)


def _refuse_too_many(count: int, of: int) -> None:
    if is_whole(count) and count * of > MOST_PLACED:
        raise InputError(
            f"a pattern of {of} strips, {quoted(count)} times: a model holds {MOST_PLACED} at most"
        )


def _vector(values: ArrayLike) -> FloatArray | None:
    """Three finite numbers (3,); None of anything else."""
    array = as_floats(values)
    return array if array is not None and array.shape == (3,) and np.isfinite(array).all() else None
