"""Ends of a curve that carry no moment: unbent ends and straight tails.

The part of a strip between a free end and the first rail, pin, tie or force is a tail. Without weight, a tail
carries no moment and is straight.
"""

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass

import numpy as np

from elastica_cad._types import BoolArray, FloatArray
from elastica_cad.errors import Length, NotConvergedError, Refusal, note, rounded_down, rounded_up
from elastica_cad.geometry.plane_curve import PlaneCurve, clamp_ends
from elastica_cad.geometry.plane_points import homogeneous, norm, project
from elastica_cad.geometry.splines import elevate_degree
from elastica_cad.mechanics.elements import AT_JOINT_SHARE
from elastica_cad.mechanics.loads import ExcessCurvature, NaturalCurvature, Supports
from elastica_cad.mechanics.theorem1 import AT_END_SHARE

MEANT_SHARE = 0.01
"""Inaccuracy of a drawn end that is meant to be unbent.

The distance of a zero of the curvature from the end may be this fraction of the length. The curvature at the end,
or at the start of a straight tail, may be this fraction of the largest curvature.
"""


LOCAL_SHARE = 0.05
"""Distance of an inserted knot from an end, as a fraction of the parameter range.

The knot keeps changes of the end local.
"""

LOCAL_DEGREE = 4
"""Least degree of a curve with inserted knots, at which the slope of the curvature must be continuous."""


def almost_unbent(excess: ExcessCurvature, t: FloatArray, length: float) -> BoolArray:
    """Return flags (k,) of the parameters t (k,) at which a curve is meant to be unbent.

    A zero of the curvature is near, or the curvature is small; see `MEANT_SHARE`. `length` is that of the whole
    curve, mm.
    """
    reach, noise = MEANT_SHARE * length, MEANT_SHARE * float(np.abs(excess.survey).max())
    return np.asarray(np.abs(excess.at(t)) <= np.maximum(reach * np.abs(excess.slope_at(t)), noise))


def without_bend_at(excess: ExcessCurvature, ends: FloatArray) -> PlaneCurve:
    """Return a nearby curve that has the natural curvature at the parameters `ends`.

    The end positions and end tangents do not change.

    Raises
    ------
    NotConvergedError
        No such curve is found.
    """
    # few curves need these constraints, and their module is not loaded for the others
    from elastica_cad.geometry.control_point_constraints import (
        CurvatureAt,
        EndPositions,
        EndTangents,
        SmoothJoints,
        least_norm_newton,
    )

    curve = excess.curve
    constraints = (
        CurvatureAt(ends, excess.rest_at(ends), curve.length),
        EndPositions.of(curve),
        EndTangents.of(curve),
        SmoothJoints.of(curve),
    )
    return least_norm_newton(curve, constraints, tolerance=1e-12)[0].drawn_as(curve.provenance)


@dataclass(frozen=True)
class FreeTail:
    """Part of a curve between a free end and the first rail, pin, tie or force.

    Attributes
    ----------
    end : int
        0 at the start of the curve, 1 at its end.
    station : float
        Arc length of this rail, pin, tie or force, mm.
    straight : float or None
        Arc length, mm, to which the curve is straight from the free end; None if it is not straight there.
    t, length : float
        Parameter of the curve at the inner end of the tail, at or near `station`, and length of the tail, mm.
    """

    end: int
    station: float
    straight: float | None
    t: float
    length: float


def find_free_tails(
    curve: PlaneCurve, supports: Supports, natural_curvature: NaturalCurvature, stations: Sequence[float]
) -> list[FreeTail]:
    """Return the tails of a flat-cut strip, for rails, pins, ties and forces at arc lengths `stations`, mm.

    A tail extends from a free end to the nearest station. If there is a kink of the curvature or an end of a
    straight piece near this station, the tail extends to that point.
    """
    prebent = ExcessCurvature(curve, natural_curvature).is_bent_beforehand
    if not stations or prebent or curve.is_closed or curve.is_straight:
        return []
    near, tails = AT_END_SHARE * curve.length, list[FreeTail]()
    flats = [zero for zero in curve.curvature_zeros if zero.kind == "flat"]
    for end, support in enumerate(supports.ends):
        free_end, station = (curve.length, max(stations)) if end else (0.0, min(stations))
        if not support.is_free or abs(station - free_end) <= near:
            continue
        joints = [(knot.s, knot.t) for knot in curve.breaks if knot.continuity <= 2]
        straight = None
        for flat in flats:
            if flat.s - near <= free_end <= flat.s_end + near:
                joints.append((flat.s, flat.t) if end else (flat.s_end, flat.t_end))
                straight = joints[-1][0]
        near_joints = [joint for joint in joints if abs(joint[0] - station) <= AT_JOINT_SHARE * curve.length]
        drawn_at = (station, float(curve.parameter(station)))
        _, t = min(near_joints, key=lambda joint: abs(joint[0] - station), default=drawn_at)
        tails.append(FreeTail(end, station, straight, t, abs(float(curve.arc_length(t)) - free_end)))
    return tails if sum(tail.length for tail in tails) < curve.length - near else []


def straightened(
    drawn: PlaneCurve, tails: Sequence[FreeTail], allowed: float
) -> tuple[PlaneCurve, float, tuple[Refusal, ...]]:
    """Return the curve with exactly straight tails along its tangents.

    Also return the largest distance, mm, by which the curve was moved, and the reasons why the drawn tails are
    impossible. The largest allowed move is `allowed`, mm.
    """
    low, high = drawn.domain
    for tail in tails:
        low, high = (low, tail.t) if tail.end else (tail.t, high)
    bent = drawn.trimmed(low, high)
    excess, joints = ExcessCurvature(bent, 0.0), np.array([bent.domain[tail.end] for tail in tails])
    almost = joints[almost_unbent(excess, joints, drawn.length)]
    t = np.linspace(low, high, 1001)
    moved = 0.0
    for start in (bent, _with_knots_near(bent, almost)) if almost.size else ():
        with suppress(NotConvergedError):
            unbent = without_bend_at(ExcessCurvature(start, 0.0), almost)
            moved = float(norm(unbent.evaluate(t) - drawn.evaluate(t)).max())
            bent = unbent
            if moved <= allowed:
                break
    curve, reasons = bent, list[Refusal]()
    for tail in tails:
        curve = _with_tail(curve, tail)
        along = np.linspace(0.0, tail.length, 201)
        before, after = (line.length - along if tail.end else along for line in (drawn, curve))
        off = float(norm(drawn.at(before).position - curve.at(after).position).max())
        moved = max(moved, off)
        reasons += _reasons(tail, off, allowed, AT_JOINT_SHARE * drawn.length)
    if moved > allowed and not reasons:
        return drawn, 0.0, ()
    return curve.drawn_as(drawn.provenance), moved, tuple(reasons)


def _with_knots_near(curve: PlaneCurve, ends: FloatArray) -> PlaneCurve:
    """Insert a knot near each of the `ends`, so that later changes of an end stay local."""
    p, (low, high) = curve.degree, curve.domain
    knots, control_points, weights = curve.knots, curve.control_points, curve.weights
    while p < LOCAL_DEGREE:
        knots, control_points, weights = elevate_degree(knots, control_points, p, weights)
        p += 1
    points = homogeneous(control_points, weights)
    for end in ends:
        x = end + LOCAL_SHARE * ((high if end == low else low) - end)
        k = int(knots.searchsorted(x, side="right")) - 1
        before, after = knots[k - p + 1 : k + 1], knots[k + 1 : k + p + 1]
        u = ((x - before) / (after - before))[:, None]
        mixed = (1 - u) * points[k - p : k] + u * points[k - p + 1 : k + 1]  # Boehm's knot insertion
        knots = np.insert(knots, k + 1, x)
        points = np.concatenate([points[: k - p + 1], mixed, points[k:]])
    return PlaneCurve(knots, project(points), p, None if weights is None else points[:, 2])


def _with_tail(curve: PlaneCurve, tail: FreeTail) -> PlaneCurve:
    """Return the curve, extended by a straight tail at the end of the curve `tail.end` (0: start, 1: end)."""
    curve = clamp_ends(curve)
    p, t = curve.degree, curve.domain[tail.end]
    velocity = curve.evaluate(t, 1)
    sign, size = (1 if tail.end else -1), float(norm(velocity))
    steps = np.linspace(0.0, sign * tail.length / size, p + 1)[1:, None]
    line, knots = curve.control_points[-tail.end] + steps * velocity, np.full(p + 1, t + steps[-1, 0])
    weights = np.ones(len(curve.control_points)) if curve.weights is None else curve.weights
    added = np.full(p, weights[-tail.end])
    if tail.end:
        parts = [curve.knots[:-1], knots], [curve.control_points, line], [weights, added]
    else:
        parts = [knots, curve.knots[1:]], [line[::-1], curve.control_points], [added, weights]
    knots, points, weights = map(np.concatenate, parts)
    return PlaneCurve(knots, points, p, None if curve.weights is None else weights)


def _reasons(tail: FreeTail, off: float, allowed: float, reach: float) -> Iterator[Refusal]:
    """Yield why a free end does not fit the curve.

    `off` is the distance, mm, of the curve from its straight tail. An element or load that is farther than
    `reach`, mm, inside the straight part would bend it.
    """
    straight = None if tail.straight is None else Length(round(tail.straight, 6))
    inside = tail.straight is not None and (tail.straight - tail.station) * (1 - 2 * tail.end) > reach
    if inside:
        yield note(
            "The curve is straight between its free {end} and the place {straight} from its start, but the "
            "element or load at {station} would bend this part. Move the element or load to {straight}.",
            end=note("end" if tail.end else "start"), straight=straight, station=Length(tail.station),
        )  # fmt: skip
    elif off > allowed:
        yield note(
            "The {end} is free, so the strip is straight between this end and the first element or load, at "
            "{station}. The curve there is up to {off} from a straight line (allowed: {allowed}). Draw this part "
            "straight."
            if straight is None else
            "The {end} is free, so the strip is straight between this end and the first element or load, at "
            "{station}. The curve there is up to {off} from a straight line (allowed: {allowed}). Draw this part "
            "straight, or move the element or load to {straight}.",
            end=note("end" if tail.end else "start"), station=Length(round(tail.station, 6)),
            off=Length(rounded_up(off, 2)), allowed=Length(rounded_down(allowed, 2)), straight=straight,
        )  # fmt: skip
