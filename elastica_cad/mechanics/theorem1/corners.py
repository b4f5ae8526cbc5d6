"""Corners: what no strip can follow, whatever holds it; whether the digits of a file may have made them."""

from collections.abc import Sequence

import numpy as np

from elastica_cad.errors import Change, InputError
from elastica_cad.geometry.curve_editing.fairing import smooth_for_corners
from elastica_cad.geometry.curves.plane_curve import PlaneCurve, TangentBreak
from elastica_cad.geometry.pen_curves.provenance import Provenance
from elastica_cad.geometry.pen_curves.tangent_healing import Turn
from elastica_cad.mechanics.theorem1.verdict import places, shown_on


def require_bendable(curve: PlaneCurve) -> None:
    """Refuse what no strip can follow, whatever holds it: a corner, also where a curve closes.

    Raises
    ------
    InputError
        The message says where, and what to do.
    """
    corners = curve.tangent_breaks
    if corners:
        slight = _taken_out(curve)
        apart = Change("split_corners", True), Change("nearest", True)
        raise InputError(_tell_corners(curve, corners), kind="corner", changes=slight or apart)
    if curve.has_corners:
        changes = _taken_out(curve) or (Change("nearest", True),)
        raise InputError(_tell_seam(curve), kind="corner", changes=changes)


def _tell_corners(curve: PlaneCurve, corners: Sequence[TangentBreak]) -> str:
    """What is wrong with corners, and whether the digits of a file may have made them."""
    drawn = curve.provenance
    maybe = {} if drawn is None else {turn.t: turn for turn in drawn.undecided}
    if drawn is not None and all(corner.t in maybe for corner in corners):
        turn = max((maybe[corner.t] for corner in corners), key=lambda one: one.angle)
        return _tell_undecided(drawn, turn, places(c.s for c in corners))
    at = f" ({drawn.shown(curve.evaluate(np.array(corners[0].t)))})" if drawn is not None else ""
    sharpest = max(np.degrees(abs(corner.angle)) for corner in corners)
    return (
        f"the curve has a corner {places(c.s for c in corners)}{at}, of {sharpest:.3g} degrees: a strip "
        "bends without "
        f"kinks; round it, or draw two curves{_tell_smooth(curve)}"
    )


def _tell_seam(curve: PlaneCurve) -> str:
    """The same of a closed curve whose only corner is where it closes."""
    drawn = curve.provenance
    start = curve.evaluate(np.array(curve.domain[0]))
    for turn in () if drawn is None else drawn.undecided:
        if turn.t == curve.domain[0]:
            return _tell_undecided(drawn, turn, places((0.0,)))
    return (
        f"the curve is closed with a corner of {np.degrees(abs(curve.seam_turn)):.3g} degrees at "
        f"{shown_on(curve, start)}: a strip bends without kinks; round it, or leave a gap between its "
        f"ends{_tell_smooth(curve)}"
    )


def _tell_undecided(drawn: Provenance | None, turn: Turn, where: str) -> str:
    shown = drawn or Provenance()
    return (
        f"undecided at this precision: the curve turns by {np.degrees(turn.angle):.2g} degrees at "
        f"{shown.shown(turn.point)}, {where} along it, and the digits "
        f"of the file alone can turn its handle of {turn.handle:.3g} mm by "
        f"{np.degrees(turn.bound):.2g}: save it "
        "with more decimals, or make the node smooth with longer handles"
    )


def _taken_out(curve: PlaneCurve) -> tuple[Change, ...]:
    """The distance within which slight corners are taken out."""
    slight = smooth_for_corners(curve)
    return () if slight is None else (Change("smooth", slight),)


def _tell_smooth(curve: PlaneCurve) -> str:
    return "".join(
        f", or take it out within {one.value:g} mm (smooth = {one.value:g}, --smooth {one.value:g})"
        for one in _taken_out(curve)
    )
