"""Bring nearly collinear inflections onto one line by a small move of the control points (Appendix C)."""

from collections.abc import Sequence

import numpy as np

from elastica_cad.errors import NotConvergedError
from elastica_cad.geometry.curve_editing.control_point_constraints import (
    Constraint,
    CurvatureAt,
    EndPositions,
    EndTangents,
    InflectionsOnLine,
    PointsOnLine,
    SmoothJoints,
    least_norm_newton,
)
from elastica_cad.geometry.curves.plane_curve import CurvatureZero, PlaneCurve
from elastica_cad.mechanics.theorem1.inflection_line import InflectionLine

MOST_STEPS = 12
"""Newton steps before the move counts as none."""

ON_LINE_SHARE = 1e-12
"""Distance from the line, in sizes of the curve, at which an inflection lies on it."""

LARGEST_MOVE_SHARE = 0.05
"""Move of a control point, in lengths of the curve, that is no small one any more."""


def project_inflections(
    curve: PlaneCurve,
    zeros: Sequence[CurvatureZero],
    line: InflectionLine,
    natural_curvature: float = 0.0,
) -> PlaneCurve:
    """The curve with control points moved so that all `zeros` of kappa - kappa_0 lie on a line.

    End points and end tangents are held as long as the curve has the freedom for it; a zero at an end stays
    there, and where pieces of a pen's path meet the tangent stays continuous.

    Raises
    ------
    NotConvergedError
        The control points cannot bring the inflections onto the line.

    References
    ----------
    Paper, Appendix C.
    """
    needed = [*_on_line(curve, zeros, line, natural_curvature), SmoothJoints.of(curve)]
    for kept in _kept_ends(curve, zeros):
        try:
            moved, _ = least_norm_newton(
                curve, [*needed, *kept], tolerance=ON_LINE_SHARE, max_steps=MOST_STEPS
            )
        except NotConvergedError:
            continue
        if np.abs(moved.control_points - curve.control_points).max() <= LARGEST_MOVE_SHARE * curve.length:
            return moved
    raise NotConvergedError("no small move of the control points brings the inflections onto one line")


def _on_line(
    curve: PlaneCurve, zeros: Sequence[CurvatureZero], line: InflectionLine, kappa_0: float
) -> list[Constraint]:
    """All zeros on the line; those at ends without moment too."""
    inner = np.array([z.t for z in zeros if z.kind != "end"])
    ends = np.array([z.t for z in zeros if z.kind == "end"])
    wanted: list[Constraint] = []
    if inner.size:
        wanted.append(InflectionsOnLine(line.a, line.b, inner, kappa_0))
    if ends.size:
        wanted += [PointsOnLine(line.a, line.b, ends), CurvatureAt(ends, kappa_0, curve.length)]
    return wanted


def _kept_ends(curve: PlaneCurve, zeros: Sequence[CurvatureZero]) -> list[list[Constraint]]:
    """What else is held, most first: places and tangents of the ends that are not on the line."""
    pinned = {z.t for z in zeros if z.kind == "end"}
    place, turn = EndPositions.of(curve), EndTangents.of(curve)
    start, end = (t not in pinned for t in curve.domain)
    places = EndPositions(place.start if start else None, place.end if end else None)
    turns = EndTangents(turn.start_normal if start else None, turn.end_normal if end else None)
    return [[places, turns], [places], []]
