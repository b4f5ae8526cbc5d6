"""Families of planes that a surface is cut by."""

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import as_floats, is_whole, require_flag
from elastica_cad.errors import InputError, quoted
from elastica_cad.forming.plane_sections.triangle_mesh import FARTHEST_MM
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.running_sums import lengths_along

MOST_PLANES = 1000
"""More are a slip of the keyboard, and hours of work."""


def parallel_planes(
    point: ArrayLike, normal: ArrayLike, offsets: ArrayLike, *, up: ArrayLike = (0.0, 0.0, 1.0)
) -> tuple[Frame, ...]:
    """Planes across `normal` (3,) through `point` (3,), shifted by `offsets` (k,) mm along it.

    The y axis of each is as near to `up` as it can be.

    Raises
    ------
    InputError
        A direction that is zero, or `up` along the normal.

    Examples
    --------
    >>> [frame.origin.tolist() for frame in parallel_planes((0, 0, 0), (0, 1, 0), (0, 5))]
    [[0.0, 0.0, 0.0], [0.0, 5.0, 0.0]]
    """
    p, n = _vector("point", point), _direction("normal", normal)
    return tuple(_across(p + offset * n, n, up) for offset in _row("offsets", offsets))


def radial_planes(
    point: ArrayLike,
    axis: ArrayLike,
    angles: ArrayLike,
    *,
    zero: ArrayLike = (1.0, 0.0, 0.0),
) -> tuple[Frame, ...]:
    """Half planes about an axis: x leads away from the axis, y along it; their sections have x >= 0.

    Parameters
    ----------
    point, axis : (3,) array_like
        A point (mm) and the direction of the axis.
    angles : (k,) array_like
        Where the half planes lie, rad, from `zero` about the axis.
    zero : (3,) array_like
        Direction of angle 0; its part across the axis counts.

    Raises
    ------
    InputError
        A direction that is zero, or `zero` along the axis.

    Examples
    --------
    >>> radial_planes((0, 0, 0), (0, 0, 1), [np.pi / 2])[0].x_axis.round(12).tolist()
    [0.0, 1.0, 0.0]
    """
    p, a = _vector("point", point), _direction("axis", axis)
    x = _rejected("zero", zero, a)
    y = np.cross(a, x)
    return tuple(Frame(p, np.cos(t) * x + np.sin(t) * y, a) for t in _row("angles", angles))


def planes_along(
    path: ArrayLike, count: int, *, ends: bool = False, up: ArrayLike = (0.0, 0.0, 1.0)
) -> tuple[Frame, ...]:
    """Planes across a path in space, at equal distances along it.

    Parameters
    ----------
    path : (n, 3) array_like
        Points of the path, mm; a smooth one is given by many.
    count : int
        Planes; the first and the last stand half a distance from the ends, or on them with `ends=True`.
    up : (3,) array_like
        The y axis of each is as near to this as it can be.

    Raises
    ------
    InputError
        Fewer than two different points, no planes, or a path that runs along `up`.

    Examples
    --------
    >>> [float(frame.origin[0]) for frame in planes_along([(0, 0, 0), (9, 0, 0)], 3)]
    [1.5, 4.5, 7.5]
    """
    points = _numbers("path", path)
    if points.ndim != 2 or points.shape[1] != 3:
        raise InputError(f"a path is points (n, 3) in mm, not {points.shape}")
    if not is_whole(count) or not 1 <= count <= MOST_PLANES or (require_flag(ends, "ends") and count < 2):
        raise InputError(
            f"count={quoted(count)}: a path is cut by a whole number of planes, one plane at least, two with "
            f"ends=True, and {MOST_PLANES} at most"
        )
    points = points[np.append(True, np.any(np.diff(points, axis=0) != 0, axis=1))]
    if len(points) < 2:
        raise InputError("a path needs two different points or more")
    s = lengths_along(points)
    at = np.linspace(0.0, s[-1], count) if ends else s[-1] * (np.arange(count) + 0.5) / count
    slopes = np.column_stack([_slopes(s, column) for column in points.T])
    places, ways = (np.column_stack([np.interp(at, s, c) for c in rows.T]) for rows in (points, slopes))
    return tuple(_across(p, _direction("path", w), up) for p, w in zip(places, ways, strict=True))


def _slopes(s: FloatArray, values: FloatArray) -> FloatArray:
    """Derivatives (n,) by arc length."""
    if s.size < 3:
        return np.full(s.size, (values[-1] - values[0]) / s[-1])
    return np.asarray(np.gradient(values, s, edge_order=2), dtype=float)


def _across(point: FloatArray, normal: FloatArray, up: ArrayLike) -> Frame:
    y = _rejected("up", up, normal)
    return Frame(point, np.cross(y, normal), y)


def _rejected(name: str, value: ArrayLike, along: FloatArray) -> FloatArray:
    """The unit part of a vector across a unit direction."""
    v = _direction(name, value)
    part = v - (v @ along) * along
    size = float(np.linalg.norm(part))
    if size < 1e-9:
        raise InputError(f"{name}={v.tolist()} is at right angles to the plane: choose another direction")
    return np.asarray(part / size)


def _direction(name: str, value: ArrayLike) -> FloatArray:
    v = _vector(name, value)
    size = float(np.linalg.norm(v))
    if size == 0:
        raise InputError(f"{name} is zero: give a direction of three numbers")
    return np.asarray(v / size)


def _vector(name: str, value: ArrayLike) -> FloatArray:
    v = _numbers(name, value)
    if v.shape != (3,):
        raise InputError(f"{name} must be three numbers, not {np.shape(value)}")
    return v


def _row(name: str, value: ArrayLike) -> list[float]:
    """One number or several in a row."""
    v = np.atleast_1d(_numbers(name, value))
    if v.ndim != 1:
        raise InputError(f"{name} must be one number or a row of numbers, not an array of shape {v.shape}")
    return [float(x) for x in v]


def _numbers(name: str, value: ArrayLike) -> FloatArray:
    v = as_floats(value)
    if v is None:
        raise InputError(f"{name} must be numbers, not {str(value)[:60]!r}")
    if not np.all(np.isfinite(v)):
        raise InputError(f"{name} must be finite numbers, got {v.tolist()}")
    if np.abs(v).max(initial=0.0) > FARTHEST_MM:
        raise InputError(f"{name} holds {np.abs(v).max():.3g}: nothing made of strips is so far away")
    return v
