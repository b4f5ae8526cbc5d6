"""Arrays of vectors and points in the plane: products, matrices, boxes, cumulative sums."""

from collections.abc import Iterator
from math import atan2, hypot, inf, isfinite

import numpy as np

from elastica_cad._types import ArrayLike, BoolArray, FloatArray, IntArray
from elastica_cad._values import numbers
from elastica_cad.errors import InputError


def norm(v: FloatArray) -> FloatArray:
    """Return the lengths (...,) of vectors (..., 2)."""
    return np.hypot(v[..., 0], v[..., 1])


def dot(u: FloatArray, v: FloatArray) -> FloatArray:
    """Return the scalar products (...,) of pairs of vectors (..., 2)."""
    return u[..., 0] * v[..., 0] + u[..., 1] * v[..., 1]


def cross(u: FloatArray, v: FloatArray) -> FloatArray:
    """Return the determinants (...,) of pairs of vectors (..., 2)."""
    return u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]


def is_straight(points: FloatArray) -> bool:
    """Return True if points (n, 2) are on the line through the first and the last point, but for rounding."""
    chord = points[-1] - points[0]
    return bool(np.abs(cross(chord, points - points[0])).max() <= 1e-12 * max(float(chord @ chord), 1e-300))


def unit(v: FloatArray) -> FloatArray:
    """Return vectors (..., 2) divided by their lengths. A vector of length 0 does not change."""
    length = norm(v)[..., None]
    return v / np.where(length > 0, length, 1.0)


def angle_of(v: FloatArray) -> FloatArray:
    """Return the angles (...), rad, of vectors (..., 2) from the x axis."""
    return np.arctan2(v[..., 1], v[..., 0])


def unit_vectors(angles: ArrayLike) -> FloatArray:
    """Return the unit vectors (..., 2) with the angles (...), rad, from the x axis.

    Examples
    --------
    >>> unit_vectors([0.0, np.pi / 2]).round(9).tolist()
    [[1.0, 0.0], [0.0, 1.0]]
    """
    vectors = np.empty((*np.shape(angles), 2))
    np.cos(angles, out=vectors[..., 0])
    np.sin(angles, out=vectors[..., 1])
    return vectors


def left_of(vectors: ArrayLike) -> FloatArray:
    """Return vectors (..., 2) turned by 90 degrees to the left.

    Examples
    --------
    >>> left_of(np.array([[2.0, 1.0], [0.0, 3.0]])).tolist()
    [[-1.0, 2.0], [-3.0, 0.0]]
    """
    v = np.asarray(vectors, dtype=float)
    return np.stack([-v[..., 1], v[..., 0]], axis=-1)


def rotated(points: FloatArray, angle: float) -> FloatArray:
    """Return points (..., 2) rotated anticlockwise about the origin by an angle, rad."""
    along = unit_vectors(angle)
    return np.asarray(points @ np.array([along, left_of(along)]))


def homogeneous(points: FloatArray, weights: FloatArray | None) -> FloatArray:
    """Return the rows (m, d + 1), x w, y w, w, of points (m, d) with weights (m,). Without weights, w is 1."""
    w = np.ones(len(points)) if weights is None else weights
    return np.column_stack([points * w[:, None], w])


def project(rows: FloatArray) -> FloatArray:
    """Return the points (..., d) with homogeneous coordinates (..., d + 1): x w, y w, w."""
    return rows[..., :-1] / rows[..., -1:]


def turn_between(u: FloatArray, v: FloatArray) -> FloatArray:
    """Return the angles (...,), rad, from directions u to v (..., 2), in (-pi, pi], positive to the left."""
    return np.arctan2(cross(u, v), dot(u, v))


def place(p: ArrayLike) -> str:
    """Return the coordinates of a point (2,), mm, as text for messages."""
    x, y = np.asarray(p, dtype=float).round(9) + 0.0  # convert -0.0 to 0.0
    return f"({x:.6g}, {y:.6g}) mm"


def transform_points(m: FloatArray, points: ArrayLike) -> FloatArray:
    """Return the images of points (..., 2) under a 3x3 affine matrix."""
    moved = (np.asarray(points, dtype=float) @ m[:2, :2].T + m[:2, 2]) / m[2, 2]
    return np.asarray(moved, dtype=float)


def require_affine(matrix: ArrayLike) -> FloatArray:
    """Return the matrix, and refuse it unless it is affine and invertible."""
    m = numbers(matrix, "the matrix that a path is moved by")
    # plain numbers are faster than arrays in this often called function
    (a, b, x), (c, d, y), last = m.tolist() if m.shape == (3, 3) else 3 * [3 * [inf]]
    if not all(map(isfinite, (a, b, x, c, d, y))) or last[:2] != [0.0, 0.0] or not 0 < abs(last[2]) < inf:
        raise InputError("the matrix cannot move a path: use a finite 3x3 matrix with the last row 0, 0, 1")
    if abs(a * d - b * c) <= 1e-14 * max(abs(a), abs(b), abs(c), abs(d)) ** 2:
        raise InputError("the matrix flattens the path to a line: use an invertible matrix")
    return m


def is_similarity(matrix: FloatArray) -> bool:
    """Return True if a 3x3 affine matrix maps circles to circles."""
    (a, b, _), (c, d, _), _ = matrix.tolist()
    slack = 1e-12 * max(abs(a), abs(b), abs(c), abs(d))
    # a rotation, or else a reflection, each with a scale
    turned = bool(abs(b + c) <= slack and abs(d - a) <= slack)
    return turned or bool(abs(b - c) <= slack and abs(d + a) <= slack)


def similarity_of(matrix: FloatArray) -> tuple[float, float, float]:
    """Return the scale, angle (rad) and orientation of a similarity: a 3x3 matrix that maps circles to circles.

    The orientation is 1.0, or -1.0 if the map mirrors in the x axis before it rotates. The caller must check with
    `is_similarity` that the matrix is a similarity.

    Examples
    --------
    >>> similarity_of(np.diag([2.0, -2.0, 1.0]))
    (2.0, 0.0, -1.0)
    """
    (a, b, _), (c, d, _), (_, _, last) = matrix.tolist()
    hand = 1.0 if last > 0 else -1.0
    return hypot(a, c) / abs(last), atan2(hand * c, hand * a), 1.0 if a * d > b * c else -1.0


SMOOTH_TURN = 50.0
"""Largest turn, degrees, between neighbouring sides of a polyline through the points of a smooth curve."""

FEWEST_AROUND = 8
"""Smallest number of points of a smooth closed outline, because they turn by 360 degrees in total."""

SHARPER, SHARPEST_TURN = 3.0, 80.0
"""Largest turn of a smooth closed outline as a multiple of its mean turn, and in degrees."""


def is_closed(points: FloatArray) -> bool:
    """Return True if points (n, 2) return to the first one, after at least `FEWEST_AROUND` points."""
    gap = np.abs(points[-1] - points[0]).max()
    return len(points) > FEWEST_AROUND and bool(gap <= 1e-9 * np.abs(points).max())


def sharp_points(points: FloatArray, angle: float, least: float = 0.0) -> list[int]:
    """Return the points at which a polyline (n, 2) turns by more than `angle` degrees.

    Both sides at such a point are longer than `least`, mm. On a closed polyline, the last point is examined too.
    """
    step = np.diff(np.concatenate([points, points[1:2]]) if is_closed(points) else points, axis=0)
    size = norm(step)
    long = np.minimum(size[:-1], size[1:]) > least
    turn = np.abs(turn_between(step[:-1], step[1:]))
    return [int(i) + 1 for i in np.flatnonzero(long & (turn > np.radians(angle)))]


def corner_points(points: FloatArray, least: float = 0.0) -> list[int]:
    """Return the points (n, 2) of a curve at which it has a corner: see `sharp_points`.

    A closed outline of few points turns by more than `SMOOTH_TURN` where it bends most, as an ellipse at its ends.
    """
    around = min(SHARPER * 360 / (len(points) - 1), SHARPEST_TURN) if is_closed(points) else 0.0
    return sharp_points(points, max(SMOOTH_TURN, around), least)


def is_smooth_around(points: FloatArray, least: float = 0.0) -> bool:
    """Return True if points (n, 2) are closed without a corner where they begin and end.

    Corners with a side of at most `least` mm are ignored.

    Examples
    --------
    >>> angle = np.linspace(0.0, 2 * np.pi, 25)
    >>> circle = np.column_stack([np.cos(angle), np.sin(angle)])
    >>> circle[-1] = circle[0]
    >>> is_smooth_around(circle), is_smooth_around(circle[:-1])
    (True, False)
    """
    return is_closed(points) and len(points) - 1 not in corner_points(points, least)


def begun_at(points: FloatArray, first: int) -> FloatArray:
    """Return closed points (n, 2) in the same order from another start, which is repeated at the end."""
    return np.concatenate([points[first:-1], points[: first + 1]])


def midpoints(values: FloatArray) -> FloatArray:
    """Return the means (n - 1, ...) of neighbouring values (n, ...)."""
    return (values[:-1] + values[1:]) / 2


def thinned(points: FloatArray, step: int) -> FloatArray:
    """Return every `step`-th of points (n, d), and the last point."""
    return np.concatenate([points[:-1:step], points[-1:]])


def box_about(points: FloatArray) -> FloatArray:
    """Return the least and largest coordinates (..., 2, d) of points (n, d), or of each set of points (..., n, d).

    Examples
    --------
    >>> box_about(np.array([[0.0, 5.0], [2.0, 1.0]])).tolist()
    [[0.0, 1.0], [2.0, 5.0]]
    >>> box_about(np.array([[[0, 5], [2, 1]], [[1, 1], [0, 0]]])).tolist()
    [[[0, 1], [2, 5]], [[0, 0], [1, 1]]]
    """
    return np.stack([points.min(axis=-2), points.max(axis=-2)], axis=-2)


def box_around(boxes: FloatArray) -> FloatArray:
    """Return the box (2, d) that encloses boxes (n, 2, d).

    Examples
    --------
    >>> box_around(np.array([[[0, 1], [2, 3]], [[1, 0], [3, 2]]])).tolist()
    [[0, 0], [3, 3]]
    """
    return box_about(boxes.reshape(-1, boxes.shape[-1]))


def boxes_meet(a: FloatArray, b: FloatArray) -> BoolArray:
    """Return flags (...,) that are True for pairs of boxes (..., 2, d) that overlap or touch.

    Examples
    --------
    >>> boxes_meet(np.array([[0, 0], [2, 2]]), np.array([[[1, 1], [3, 3]], [[3, 0], [4, 1]]])).tolist()
    [True, False]
    """
    return np.asarray(((a[..., 0, :] <= b[..., 1, :]) & (a[..., 1, :] >= b[..., 0, :])).all(axis=-1))


def lengths_along(points: FloatArray) -> FloatArray:
    """Return the lengths (n,) of the polyline through points (n, d) from its first point to each point.

    Examples
    --------
    >>> lengths_along(np.array([[0.0, 0.0], [3.0, 4.0], [3.0, 5.0]])).tolist()
    [0.0, 5.0, 6.0]
    """
    return np.append(0.0, np.linalg.norm(np.diff(points, axis=0), axis=1).cumsum())


def points_at(places: FloatArray, s: FloatArray, points: FloatArray) -> FloatArray:
    """Return points (k, d) at places (k,) on the polyline through points (n, d), which are at places s (n,).

    Examples
    --------
    >>> points_at(np.array([0.5, 3.0]), np.array([0.0, 2.0, 4.0]), np.array([[0, 0], [4, 0], [4, 8]])).tolist()
    [[1.0, 0.0], [4.0, 4.0]]
    """
    return np.column_stack([np.interp(places, s, column) for column in points.T])


def at_sign_changes(values: FloatArray, places: FloatArray) -> FloatArray:
    """Interpolate places (n, ...) to the k sign changes of values (n,), as places (k, ...)."""
    i = np.flatnonzero(values[:-1] * values[1:] < 0)
    u = values[i] / (values[i] - values[i + 1])
    return (places[i].T + u * (places[i + 1] - places[i]).T).T


def turns_along(angles: FloatArray) -> FloatArray:
    """Return the cumulative absolute change (n,) of angles (n,).

    Examples
    --------
    >>> turns_along(np.array([0.5, 1.5, 0.5])).tolist()
    [0.0, 1.0, 2.0]
    """
    return np.append(0.0, np.abs(np.diff(angles)).cumsum())


def numbers_in_groups(counts: IntArray) -> IntArray:
    """Return the numbers 0, 1, ... count - 1 for each of `counts` (k,), concatenated.

    Examples
    --------
    >>> numbers_in_groups(np.array([2, 0, 3])).tolist()
    [0, 1, 0, 1, 2]
    """
    return np.arange(counts.sum()) - (counts.cumsum() - counts).repeat(counts)


_ROW, _FINEST_CELL = 2**31, 2.0**-30
"""Number of cells in a row, and least width of a cell as a fraction of the extent of all points."""

_MOST_COMPARED = 500_000
"""Number of pairs that are compared at once, which bounds the memory of a search."""


def near_pairs(
    points: FloatArray, others: FloatArray, reach: float, *, most: int | None = None
) -> tuple[IntArray, IntArray]:
    """Return index pairs (k,) of points (n, d) and other points (m, d) whose distance is at most `reach`.

    The plane of the first two coordinates is divided into square cells of width `reach` or more. Each point is
    compared with the other points in its cell and in the eight cells around it. If these are more than `most`, the
    point has no pairs in the result. Pairs are in the order of the points.
    """
    i, j = zip(*blocks_of_near_pairs(points, others, reach, most=most), strict=True)
    return np.concatenate(i), np.concatenate(j)


def blocks_of_near_pairs(
    points: FloatArray, others: FloatArray, reach: float, *, most: int | None = None
) -> Iterator[tuple[IntArray, IntArray]]:
    """Yield the pairs of `near_pairs` in one or more blocks. All pairs of a point are in one block."""
    both = np.concatenate([points, others])[:, :2]
    cells = both - both.min(axis=0, initial=np.inf)
    cell = max(reach, _FINEST_CELL * cells.max(initial=0.0))
    row, column = np.floor(cells / cell).astype(np.int64).T
    # numbers (n + m, 3) of the cell of each point, with the same column in the rows before, here and after
    numbers = (row * _ROW + column)[:, None] + np.array([-_ROW, 0, _ROW])
    order = numbers[len(points) :, 1].argsort(kind="stable")
    in_order, near = numbers[len(points) :, 1][order], numbers[: len(points)]
    # the cells near - 1, near and near + 1 are neighbours in a row, so their points are consecutive in `in_order`
    first = in_order.searchsorted(near - 1)
    counts = in_order.searchsorted(near + 1, side="right") - first
    if most is not None:
        counts *= counts.sum(axis=1, keepdims=True) <= most
    block = counts.sum(axis=1).cumsum() // _MOST_COMPARED
    for rows in np.split(np.arange(len(points)), np.flatnonzero(np.diff(block)) + 1):
        count = counts[rows].ravel()
        i = rows.repeat(counts[rows].sum(axis=1))
        j = order[first[rows].ravel().repeat(count) + numbers_in_groups(count)]
        gap = points[i] - others[j]
        close = np.einsum("ij,ij->i", gap, gap) <= reach**2
        yield i[close], j[close]


def distinct(values: FloatArray) -> FloatArray:
    """Return the sorted distinct values (n,). Unlike `numpy.unique`, this does not import masked arrays.

    Examples
    --------
    >>> distinct(np.array([2.0, 0.5, 2.0])).tolist()
    [0.5, 2.0]
    """
    ordered = np.sort(values)
    return np.asarray(ordered[np.diff(ordered, prepend=np.nan) != 0])


def clipped(point: FloatArray, direction: FloatArray, low: FloatArray, high: FloatArray) -> FloatArray | None:
    """Return the part of a line inside a box as end points (2, 2), or None if the line misses the box.

    The line is given by a point (2,) and a direction (2,), the box by its least and largest coordinates (2,).
    """
    # if the line is parallel to an axis, the quotients of the other axis are replaced below
    with np.errstate(divide="ignore", invalid="ignore"):
        t = np.sort(np.array([low - point, high - point]) / direction, axis=0)
    inside = np.all((direction != 0) | ((low <= point) & (point <= high)))
    first, last = (
        np.nanmax(np.where(direction != 0, t[0], -np.inf)),
        np.nanmin(np.where(direction != 0, t[1], np.inf)),
    )
    return (
        np.array([point + first * direction, point + last * direction]) if inside and first < last else None
    )
