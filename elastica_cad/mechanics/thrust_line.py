"""Thrust line of a rod with rails, pins, ties or point forces, as drawn in pictures."""

from itertools import pairwise

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.plane_points import at_sign_changes, clipped, left_of
from elastica_cad.mechanics.rod import Rod

PARALLEL = 1e-6
"""Neighbouring sides of a thrust line are parallel, without a corner, if the sine of their angle is smaller."""


def inflections_of(rod: Rod) -> FloatArray:
    """Return the points (k, 2) at which the curvature minus the natural curvature changes sign.

    For a strip that is cut flat, these points are the inflections of its shape.
    """
    if rod.shape is not None and not np.any(rod.natural_curvature):
        return np.asarray(rod.shape.at(rod.shape.inflections).position, dtype=float).reshape(-1, 2)
    return at_sign_changes(rod.curvature - rod.natural_curvature, rod.position)


def thrust_sides(rod: Rod, low: FloatArray, high: FloatArray) -> list[FloatArray]:
    """Return the sides of the thrust line inside a box, each side as points (n, 2).

    A side extends as far as its corners with other sides, its inflections and the ends of the rod. Sides of a rod
    without weight are straight (n = 2). The result is empty for a rod without rails, pins, ties and point forces,
    because its thrust line is the inflection line.
    """
    if rod.acting and rod.gravity is not None:
        return _curved_sides(rod, low, high)
    turns, lines = inflections_of(rod), rod.thrust_line
    if not rod.acting or not lines:
        return []
    reached: list[list[FloatArray]] = [[] for _ in lines]
    reached[0].append(rod.position[0])
    reached[-1].append(rod.position[-1])
    for k, (first, second) in enumerate(pairwise(lines)):
        if first is None or second is None:
            continue
        point, direction = np.array(first.point), np.array(first.direction)
        sine = float(second.b @ direction)
        if abs(sine) > PARALLEL:
            corner = point - float(second.distance(point)) / sine * direction
            reached[k].append(corner)
            reached[k + 1].append(corner)
    none = np.full(len(turns), np.inf)
    distances = np.array([none if line is None else np.abs(line.distance(turns)) for line in lines])
    for turn, row in zip(turns, distances.T, strict=True):
        reached[row.argmin()].append(turn)
    sides = []
    for line, points in zip(lines, reached, strict=True):
        if line is None or len(points) < 2:
            continue
        point, direction = np.array(line.point), np.array(line.direction)
        ends = clipped(point, direction, low, high)
        if ends is None:
            continue
        t, inside = (np.array(points) - point) @ direction, (ends - point) @ direction
        least, most = max(t.min(), inside[0]), min(t.max(), inside[1])
        if least < most:
            sides.append(point + direction * np.array([[least], [most]]))
    return sides


def _curved_sides(rod: Rod, low: FloatArray, high: FloatArray) -> list[FloatArray]:
    """Return the thrust line of a rod with weight inside a box, as pieces, each with points (n, 2).

    Rails, pins, ties and point forces separate the pieces.

    The internal force at the point gamma of the rod acts along the line M + <b, x - gamma> = 0. Here M is the
    moment at gamma, b the negative internal force turned clockwise by 90 degrees, and e the direction of gravity.
    The thrust line is the envelope of these lines. Its points are gamma - M / <b, e> e, because weight changes
    only the component of the force along e.
    """
    assert rod.gravity is not None
    e = np.array(rod.gravity.direction)
    along = -left_of(rod.force) @ e
    with np.errstate(divide="ignore", invalid="ignore"):
        points = rod.position - (rod.moment / along)[:, None] * e
    inside = ((low <= points) & (points <= high)).all(axis=1)
    joined = inside[1:] & inside[:-1] & (along[1:] * along[:-1] > 0)
    stations = np.concatenate([action.s for action in rod.acting])
    joined[rod.s.searchsorted(stations).clip(1, rod.s.size - 1) - 1] = False
    return [part for part in np.split(points, np.flatnonzero(~joined) + 1) if len(part) > 1]
