"""Corners so slight that a strip may round them: taken out by turning handles, within a distance asked for."""

from collections.abc import Callable

import numpy as np

from elastica_cad.geometry.curve_editing.fairing import usual_tolerance
from elastica_cad.geometry.curves.plane_curve import CORNER_RAD, PlaneCurve
from elastica_cad.geometry.pen_curves.tangent_healing import SURE, Healing, heal_tangents

PER_ROUNDING = 2 * np.sqrt(2.0)
"""How far a handle's end moves against its node for one of rounding in every coordinate."""

SMOOTHING_SHARE = 0.5
"""Of the distance asked for: the rest is left to make the curvature fair."""

WORTH_SHARE = 1e-3
"""Of the length: a move beyond this is no detail of the drawing any more, and is not offered."""


def round_corners(curve: PlaneCurve, smooth: float) -> tuple[PlaneCurve, float]:
    """The curve without slight corners, and how far, mm, it was moved at most to take them out.

    Corners of more than 5 degrees stay, and those for which it would move by more than half of `smooth` (mm).

    Examples
    --------
    >>> kinked = PlaneCurve([0] * 4 + [1] * 3 + [2] * 4,
    ...                     [(0, 0), (20, 20), (40, 30), (60, 30), (80, 30.02), (100, 20), (120, 0)], 3)
    >>> smooth, moved = round_corners(kinked, 0.1)
    >>> len(kinked.tangent_breaks), len(smooth.tangent_breaks), round(moved, 4)
    (1, 0, 0.01)
    """
    if not curve.has_corners or curve.degree < 2:
        return curve, 0.0
    healing = _healed(curve, SMOOTHING_SHARE * smooth)
    if not healing.healed:
        return curve, 0.0
    rounded = PlaneCurve(healing.knots, healing.control_points, healing.degree, healing.weights)
    return rounded.drawn_as(curve.provenance), healing.moved


def smooth_for_corners(curve: PlaneCurve) -> float | None:
    """The `smooth`, mm, of one figure, with which `round_corners` takes out all corners; None if it is no detail.

    It is at least what curves of a pen tool are made fair with, at most a thousandth of the length.

    Examples
    --------
    >>> kinked = PlaneCurve([0] * 4 + [1] * 3 + [2] * 4,
    ...                     [(0, 0), (20, 20), (40, 30), (60, 30), (80, 30.02), (100, 20), (120, 0)], 3)
    >>> smooth_for_corners(kinked)
    0.06
    """
    corners = [one.angle for one in curve.tangent_breaks]
    if abs(curve.seam_turn) > CORNER_RAD:
        corners.append(curve.seam_turn)
    if not corners or curve.degree < 2 or max(map(abs, corners)) > SURE:
        return None
    most = WORTH_SHARE * curve.length
    healing = _healed(curve, SMOOTHING_SHARE * most)
    if len(healing.healed) < len(corners):
        return None
    needed = 1.05 * healing.moved / SMOOTHING_SHARE  # the bound of a turn is of sines
    offered = max(_one_figure(needed, np.ceil), _one_figure(usual_tolerance(curve), np.floor))
    return offered if offered <= most and not round_corners(curve, offered)[0].has_corners else None


def _one_figure(x: float, rounded: Callable[[float], float]) -> float:
    step = 10.0 ** np.floor(np.log10(x))
    return float(f"{rounded(x / step) * step:.1g}")


def _healed(curve: PlaneCurve, reach: float) -> Healing:
    """With the corners taken out for which no handle's end moves farther than `reach`, mm."""
    return heal_tangents(
        curve.knots, curve.control_points, curve.degree, curve.weights, rounding=reach / PER_ROUNDING
    )
