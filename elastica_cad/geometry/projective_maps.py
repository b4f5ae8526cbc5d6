"""Projective maps of the plane: definition by four points (handles), and images of rational splines."""

from collections.abc import Callable
from itertools import combinations

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.errors import InputError, Length
from elastica_cad.geometry.plane_points import cross, homogeneous, place, project
from elastica_cad.geometry.polynomials import subdivide_pieces
from elastica_cad.geometry.splines import finite

_MOST_HALVINGS = 30

IN_LINE_SHARE = 1e-9
"""Three points are collinear if their triangle is lower than this fraction of the extent of all four points."""


def four_point_map(before: ArrayLike, after: ArrayLike) -> FloatArray:
    """Return the projective map that moves four handles (points) to new positions, for `PlaneCurve.transformed`.

    The image of a line is a line, so collinear inflections remain collinear. The image of a curve that a strip
    can have is therefore a curve that a strip can have (paper, section 4.3).

    Parameters
    ----------
    before, after : (4, 2) array_like
        Handles before and after the edit, mm; no three handles are collinear.

    Returns
    -------
    (3, 3) array
        Matrix of the map. The image of (x, y) is matrix @ (x, y, 1) divided by its third component; this
        component is 1 at the first handle.

    Examples
    --------
    >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> matrix = four_point_map(square, [(0, 0), (1, 0), (2, 2), (0, 1)])
    >>> image = matrix @ (0.5, 0.0, 1)
    >>> (image[:2] / image[2]).round(6).tolist()
    [0.4, 0.0]
    """
    forth, home = _basis("before", before), _basis("after", after)
    matrix = home @ np.linalg.inv(forth)
    x, y = np.asarray(before, dtype=float)[0]
    matrix = matrix / (matrix[2] @ (x, y, 1.0))
    # make the map exactly affine if only rounding errors differ, so that polynomial curves remain polynomial
    if np.abs(matrix[2, :2]).max() * np.abs(np.asarray(before, dtype=float)).max() < 1e-13:
        matrix[2] = 0.0, 0.0, 1.0
    return np.asarray(matrix)


def _basis(name: str, points: ArrayLike) -> FloatArray:
    """Return the matrix from the unit vectors and their sum to the four points, in homogeneous coordinates."""
    handles = finite(name, points)
    if handles.shape != (4, 2):
        raise InputError(f"{name} has the shape {handles.shape}: give four handles (x, y), shape (4, 2)")
    middle, size = handles.mean(axis=0), float(np.ptp(handles, axis=0).max())
    if size == 0:
        raise InputError(f"{name}: all four handles are at {place(handles[0])}: move them apart")
    rows = np.column_stack([(handles - middle) / size, np.ones(4)])
    for i, j in combinations(range(4), 2):
        if np.linalg.norm(rows[i] - rows[j]) <= IN_LINE_SHARE:
            apart = float(np.linalg.norm(handles[i] - handles[j]))
            if apart > 0:
                raise InputError(
                    "{name}: handles {i} and {j} are only {apart} apart, but all four extend over {size}: move the "
                    "distant handles closer",
                    name=name,
                    i=i + 1,
                    j=j + 1,
                    apart=Length(apart),
                    size=Length(size),
                )
            raise InputError(
                f"{name}: handles {i + 1} and {j + 1} are both at {place(handles[i])}: move one of them"
            )
    for three in combinations(range(4), 3):
        corner = rows[list(three)]
        longest = np.linalg.norm(corner - np.roll(corner, 1, axis=0), axis=1).max()
        if abs(cross(*(corner[1:] - corner[0]))) <= IN_LINE_SHARE * longest:
            numbers = ", ".join(str(i + 1) for i in three)
            raise InputError(
                f"{name}: handles {numbers} are on one line, through {place(handles[three[0]])} and "
                f"{place(handles[three[2]])}: move one off this line"
            )
    # the fourth point is a sum of the first three with these factors; `back` restores position and size
    shares = np.linalg.solve(rows[:3].T, rows[3])
    back = np.array([[size, 0.0, middle[0]], [0.0, size, middle[1]], [0.0, 0.0, 1.0]])
    return np.asarray(back @ (rows[:3] * shares[:, None]).T)


def _vanishing(piece: FloatArray) -> FloatArray:
    """Return the homogeneous point of a Bezier piece at which the weight, positive at the start, becomes 0."""
    for _ in range(_MOST_HALVINGS):
        left, right = subdivide_pieces(piece)
        piece = left if left[-1, 2] <= 0 else right
    return np.asarray(piece[0])


def map_spline(
    knots: FloatArray,
    control_points: FloatArray,
    weights: FloatArray | None,
    matrix: ArrayLike,
    *,
    degree: int,
    pieces: Callable[[], tuple[FloatArray, FloatArray]],
) -> tuple[FloatArray, FloatArray, FloatArray | None]:
    """Return knots, control points and weights of a spline after a projective map by a 3 x 3 matrix.

    The map is linear in homogeneous control points. If the weight of a control point would not be positive, the
    image is divided into Bezier pieces until all weights are positive. `pieces` returns the homogeneous Bezier
    pieces of the spline and their edges.
    """
    m = finite("matrix", matrix)
    if m.shape != (3, 3):
        raise InputError(f"a projective map has the shape {m.shape}: give a 3 x 3 matrix")
    if np.linalg.matrix_rank(m) < 3:
        raise InputError("the matrix is singular and would flatten the plane: use an invertible matrix")
    affine = not m[2, :2].any()
    image = homogeneous(control_points, weights) @ m.T
    if affine:
        return knots, project(image), weights
    if (image[:, 2] > 0).all() or (image[:, 2] < 0).all():
        return knots, project(image), np.abs(image[:, 2])
    bezier, edges = pieces()
    # halve the pieces where the map could send a point to infinity
    mapped = bezier @ m.T
    sign = np.sign(mapped[0, 0, 2])
    # stack of start, end, control points and number of halvings, with the first piece on top
    todo = [(float(a), float(b), p * sign, 0) for a, b, p in zip(edges[:-1], edges[1:], mapped, strict=True)][
        ::-1
    ]
    done: list[tuple[float, FloatArray]] = []
    while todo:
        a, b, piece, depth = todo.pop()
        if (piece[:, 2] > 0).all():
            done.append((a, piece))
            continue
        if min(piece[0, 2], piece[-1, 2]) <= 0 or depth == _MOST_HALVINGS:
            x, y, w = np.asarray(np.linalg.inv(m), dtype=float) @ _vanishing(piece)
            raise InputError(
                f"the projective map moves the curve near {place(np.array([x, y]) / w)} to infinity: "
                "move the handles less"
            )
        left, right = subdivide_pieces(piece)
        middle = (a + b) / 2
        todo += [(middle, b, right, depth + 1), (a, middle, left, depth + 1)]
    ends = np.array([*(start for start, _ in done), edges[-1]])
    t = np.pad(ends.repeat(degree), 1, mode="edge")
    # neighbours share an end point, so omit the first control point of all pieces but the first
    points = np.concatenate([done[0][1], *(p[1:] for _, p in done[1:])])
    return t, project(points), np.abs(points[:, 2])
