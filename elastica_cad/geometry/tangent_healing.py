"""Removal of corners that are caused by rounding of coordinates.

A handle is the vector from a node of a spline to its neighbouring control point. If rounding moves each coordinate
by at most h, a handle of length l turns by at most asin(2 sqrt(2) h / l). If the turns of both handles explain the
corner at a node, both handles are turned into a common direction.
"""

from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.geometry.plane_points import angle_of, is_straight, norm, turn_between, unit_vectors
from elastica_cad.geometry.splines import elevate_degree, is_clamped, knot_runs

LARGEST_REMOVED_RAD = np.radians(5.0)
"""Largest angle of a corner, rad, that is removed by default if rounding explains it."""

_SHORT = 1e-12  # control points closer than this fraction of the extent of both pieces coincide


@dataclass(frozen=True)
class Turn:
    """Node of a spline at which the tangent jumps.

    Attributes
    ----------
    t : float
        Parameter of the node.
    point : (2,) array
        Position of the node, mm.
    angle : float
        Exterior angle of the corner, rad, not negative.
    bound : float
        Largest angle that rounding can cause, rad.
    handle : float
        Length of the shorter handle, mm.
    """

    t: float
    point: FloatArray
    angle: float
    bound: float
    handle: float


@dataclass(frozen=True, eq=False)
class Healing:
    """Spline after the removal of corners.

    Attributes
    ----------
    knots, control_points, degree, weights
        As in `PlaneCurve`; the original objects if nothing was moved.
    moved : float
        Upper bound of the distance between the curves before and after the removal, mm.
    healed : tuple of Turn
        Nodes whose corners were removed.
    undecided : tuple of Turn
        Nodes with corners above `LARGEST_REMOVED_RAD` that rounding can explain, but that may be real.
    """

    knots: FloatArray
    control_points: FloatArray
    degree: int
    weights: FloatArray | None
    moved: float
    healed: tuple[Turn, ...]
    undecided: tuple[Turn, ...]


def heal_tangents(
    knots: FloatArray,
    control_points: FloatArray,
    degree: int,
    weights: FloatArray | None = None,
    *,
    rounding: float,
) -> Healing:
    """Return the spline without the corners that rounding of its coordinates can cause.

    Corners are possible at knots of full multiplicity, and where a closed clamped spline starts and ends. The ends
    of both handles at a node are moved by equal distances, so the longer handle turns by the smaller angle. If only
    one of the two pieces is straight, only the handle of the other piece is turned. Splines of degree 2 are first
    raised to degree 3, because their control points belong to two nodes.

    Parameters
    ----------
    knots : (m + degree + 1,) array
        Clamped knots.
    control_points : (m, 2) array
        Control points, mm.
    weights : (m,) array, optional
    rounding : float
        Largest rounding error of a coordinate, mm: half a unit of the last written digit.
    """
    turns = [_turn(knots, control_points, degree, node, rounding) for node in _nodes(knots, degree)]
    even = weights is None or weights[0] == weights[-1]
    size = norm(np.ptp(control_points, axis=0))
    # heal the tangent at the seam of a closed curve
    if (
        is_clamped(knots, degree)
        and even
        and len(control_points) > degree + 1
        and norm(control_points[-1] - control_points[0]) <= 1e-9 * size
    ):
        around = _control_points_at_seam(control_points, degree)
        # `_turn` uses the knots only for the parameter of the node, here the start of the curve
        turns.append(_turn(np.repeat(knots[degree], 2 * degree + 2), around, degree, degree, rounding))
    # smaller corners, in rad, are harmless
    explained = [turn for turn in turns if 1e-9 < turn.angle <= turn.bound]
    undecided = tuple(turn for turn in explained if turn.angle > LARGEST_REMOVED_RAD)
    removable = {turn.t for turn in explained if turn.angle <= LARGEST_REMOVED_RAD}
    if not removable:
        return Healing(knots, control_points, degree, weights, 0.0, (), undecided)
    if degree == 2:
        knots, control_points, weights = elevate_degree(knots, control_points, degree, weights)
        degree = 3
    points = control_points.copy()
    for node in _nodes(knots, degree):
        if knots[node + 1] in removable:
            _smooth_node(points, node, degree)
    if knots[degree] in removable:
        around = _control_points_at_seam(points, degree)
        _smooth_node(around, degree, degree)
        points[-degree:-1] = around[1:degree]
        points[1:degree] = around[degree + 1 : -1]
    moved = float(norm(points - control_points).max())
    return Healing(
        knots, points, degree, weights, moved, tuple(t for t in explained if t.t in removable), undecided
    )


def _nodes(knots: FloatArray, degree: int) -> IntArray:
    """Return the indices of the control points at inner knots of full multiplicity.

    The knot of node i is knots[i + 1], the first of its equal knots.
    """
    values, counts = knot_runs(knots)
    inner = (counts >= degree) & (values > knots[degree]) & (values < knots[-degree - 1])
    return np.asarray((counts.cumsum() - counts)[inner] - 1, dtype=int)


def _handles(points: FloatArray, node: int, degree: int) -> tuple[FloatArray, FloatArray, int, int]:
    """Return the incoming and outgoing handle (2,) at a node, and the indices of their far ends.

    Control points that coincide with the node are passed over.
    """
    size = norm(np.ptp(points[max(0, node - degree) : node + degree + 1], axis=0))
    before, after = node - 1, node + 1
    while before > node - degree and norm(points[node] - points[before]) <= _SHORT * size:
        before -= 1
    while after < node + degree and norm(points[after] - points[node]) <= _SHORT * size:
        after += 1
    return points[node] - points[before], points[after] - points[node], before, after


def _turn(knots: FloatArray, points: FloatArray, degree: int, node: int, rounding: float) -> Turn:
    """Return the turn at a node, and the largest turn that rounding of its handles (`rounding`, mm) can cause."""
    into, out, _, _ = _handles(points, node, degree)
    lengths = np.array([norm(into), norm(out)])
    angle = abs(float(turn_between(into, out)))
    if lengths.min() == 0:
        return Turn(float(knots[node + 1]), points[node], angle, 0.0, 0.0)
    bound = float(np.arcsin(np.minimum(2 * np.sqrt(2.0) * rounding / lengths, 1.0)).sum())
    return Turn(float(knots[node + 1]), points[node].copy(), angle, bound, float(lengths.min()))


def _control_points_at_seam(points: FloatArray, degree: int) -> FloatArray:
    # control points (2 degree + 1, 2) of the last and the first piece, with the start as node `degree`
    return np.concatenate([points[-degree - 1 :], points[1 : degree + 1]])


def _smooth_node(points: FloatArray, node: int, degree: int) -> None:
    """Turn the handles at a node into a common direction. The array `points` is changed."""
    into, out, before, after = _handles(points, node, degree)
    inward, onward = float(norm(into)), float(norm(out))
    # fraction of the corner by which the incoming handle turns; a straight piece does not turn
    share = onward / (inward + onward)
    straight = (
        is_straight(points[node - degree : node + 1]),
        is_straight(points[node : node + degree + 1]),
    )
    if straight[0] != straight[1]:
        share = 0.0 if straight[0] else 1.0
    along = unit_vectors(angle_of(into) + share * turn_between(into, out))
    points[before] = points[node] - inward * along
    points[after] = points[node] + onward * along
