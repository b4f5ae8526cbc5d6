"""Ends that are not bent, or nearly so: the curve is moved until they keep no trace of bending."""

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import NotConvergedError
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads.rest_curvature import ExcessCurvature, NaturalCurvature
from elastica_cad.mechanics.loads.supports import Supports
from elastica_cad.mechanics.theorem1.curvature_conditions import examine_curvature
from elastica_cad.mechanics.theorem1.verdict import EquilibriumCheck

UNBENT_SHARE = 1e-12  # of the largest curvature: an end with less is not bent

MEANT_SHARE = 0.01
"""An end that is free to turn is meant to be unbent where the curvature vanishes this near to it, in lengths of the
curve, or would beyond it: no pen draws it nearer."""


def examine_unbent(
    curve: PlaneCurve, supports: Supports, natural_curvature: NaturalCurvature, tolerance: float
) -> EquilibriumCheck:
    """`examine_curvature` of the curve with control points moved so that its unbent ends are not bent at all.

    These are ends in which the curvature vanishes to rounding, and those that are free to turn and all but
    unbent. Places and tangents of both ends stay. A curve that would move farther than `tolerance`, in its
    lengths, stays as it is.
    """
    check = examine_curvature(curve, supports, natural_curvature)
    if check.curve.is_closed or check.any_stiffness:
        return check
    excess = ExcessCurvature(check.curve, natural_curvature)
    ends = np.array([*_traces(excess, check), *_meant(excess, check, supports)])
    if not ends.size:
        return check
    try:
        unbent = _unbent(excess, ends)
    except NotConvergedError:
        return check
    again = examine_curvature(unbent, supports, natural_curvature)
    moved = largest_move(check.curve, unbent)
    drawn = _ends_near_zeros(check) - set(ends.tolist())
    strays = _ends_near_zeros(again) - drawn
    return check if moved > tolerance * check.length or strays else replace(again, moved=moved)


def ends_keep_bend(check: EquilibriumCheck, natural_curvature: NaturalCurvature) -> bool:
    """Is an inflection at an end off it by more than rounding? The stiffness beside it would be noise."""
    return bool(list(_traces(ExcessCurvature(check.curve, natural_curvature), check)))


def largest_move(before: PlaneCurve, after: PlaneCurve) -> float:
    """Largest distance of points of the same parameter, mm."""
    t = np.linspace(*before.domain, 1001)
    return float(np.hypot(*np.moveaxis(np.asarray(after.evaluate(t)) - before.evaluate(t), -1, 0)).max())


def _traces(excess: ExcessCurvature, check: EquilibriumCheck) -> Iterable[float]:
    """Parameters of the ends that count as zeros, and are none to rounding."""
    ends = np.array([z.t for z in check.zeros if z.kind == "end"])
    if ends.size:
        size = float(np.abs(excess.survey).max())
        yield from ends[np.abs(excess.at(ends)) > UNBENT_SHARE * size].tolist()


def _meant(excess: ExcessCurvature, check: EquilibriumCheck, supports: Supports) -> Iterable[float]:
    """Parameters of the ends that are free to turn and all but unbent."""
    unbent = {z.t for z in check.zeros if z.kind == "end"}
    for t, support in zip(check.curve.domain, supports.ends, strict=True):
        if support.angle or t in unbent:
            continue
        at, reach = np.array(t), MEANT_SHARE * check.length
        if np.abs(excess.at(at)) <= reach * np.abs(excess.slope_at(at)):
            yield t


def _ends_near_zeros(check: EquilibriumCheck) -> set[float]:
    """Parameters of the ends beside which the curvature vanishes inside the curve."""
    (start, end), near = check.curve.domain, MEANT_SHARE * check.length
    inner = [z.s for z in check.zeros if z.kind != "end"]
    return {start for s in inner if s < near} | {end for s in inner if s > check.length - near}


def _unbent(excess: ExcessCurvature, ends: FloatArray) -> PlaneCurve:
    # loaded for the few curves that need it
    from elastica_cad.geometry.curve_editing.control_point_constraints import (
        Constraint,
        CurvatureAt,
        EndPositions,
        EndTangents,
        SmoothJoints,
        least_norm_newton,
    )

    curve = excess.curve
    constraints: list[Constraint] = [CurvatureAt(ends, excess.rest_at(ends), curve.length)]
    constraints += [EndPositions.of(curve), EndTangents.of(curve), SmoothJoints.of(curve)]
    return least_norm_newton(curve, constraints, tolerance=1e-12)[0]
