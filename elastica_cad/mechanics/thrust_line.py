"""Thrust line of a rod with rails, pins, ties or point forces, as drawn in pictures."""

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.plane_points import clipped, left_of
from elastica_cad.mechanics.rod import Rod

PARALLEL = 1e-6
"""Neighbouring sides of a thrust line are parallel, without a corner, if the sine of their angle is smaller."""


def inflections_of(rod: Rod) -> FloatArray:
    """Return the points (k, 2) at which the curvature minus the natural curvature changes sign.

    For a strip that is cut flat, these points are the inflections of its shape.
    """
    if rod.shape is not None and not np.any(rod.natural_curvature):
        return np.asarray(rod.shape.at(rod.shape.inflections).position, dtype=float).reshape(-1, 2)
    kappa = rod.curvature - rod.natural_curvature
    i = np.flatnonzero(kappa[:-1] * kappa[1:] < 0)
    u = (kappa[i] / (kappa[i] - kappa[i + 1]))[:, None]
    return np.asarray(rod.position[i] * (1 - u) + rod.position[i + 1] * u, dtype=float)


def thrust_sides(rod: Rod, low: FloatArray, high: FloatArray) -> list[FloatArray]:
    """Return the sides of the thrust line inside a box, each side as points (n, 2).

    A side extends as far as its corners with other sides, its inflections and the ends of the rod. Sides of a rod
    without weight are straight (n = 2). The result is empty for a rod without rails, pins, ties and point forces,
    because its thrust line is the inflection line.
    """
    if rod.acting and rod.gravity is not None:
        return _curved_sides(rod, low, high)
    turns = inflections_of(rod)
    lines = [
        None if side is None else (np.array(side.point), np.array(side.direction)) for side in rod.thrust_line
    ]
    if not rod.acting or not lines:
        return []
    reached: list[list[FloatArray]] = [[] for _ in lines]
    reached[0].append(rod.position[0])
    reached[-1].append(rod.position[-1])
    for k in range(len(lines) - 1):
        first, second = lines[k], lines[k + 1]
        if first is None or second is None:
            continue
        ways = np.column_stack([first[1], -second[1]])
        if abs(np.linalg.det(ways)) > PARALLEL:
            corner = first[0] + first[1] * np.linalg.solve(ways, second[0] - first[0])[0]
            reached[k].append(corner)
            reached[k + 1].append(corner)
    none = np.full(len(turns), np.inf)
    distances = np.array([none if side is None else np.abs(side.distance(turns)) for side in rod.thrust_line])
    for turn, row in zip(turns, distances.T, strict=True):
        reached[int(row.argmin())].append(turn)
    sides = []
    for line, points in zip(lines, reached, strict=True):
        clipped_side = None if line is None else clipped(*line, low, high)
        if line is None or clipped_side is None or len(points) < 2:
            continue
        t = (np.array(points) - line[0]) @ line[1]
        inside = (clipped_side - line[0]) @ line[1]
        least, most = max(t.min(), inside[0]), min(t.max(), inside[1])
        if least < most:
            sides.append(line[0] + line[1] * np.array([[least], [most]]))
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
    joined[np.searchsorted(rod.s, stations).clip(1, rod.s.size - 1) - 1] = False
    parts = np.split(points, np.flatnonzero(~joined) + 1)
    return [part for part in parts if len(part) > 1]
