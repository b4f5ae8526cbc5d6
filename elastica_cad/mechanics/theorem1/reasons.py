"""What to tell of a curve that cannot be bent, or only just: where, why, and what to do."""

from collections.abc import Iterable, Sequence

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.curve_editing.slight_corners import smooth_for_corners
from elastica_cad.geometry.curves.curve_records import CurvatureZero, TangentBreak
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.pen_curves.provenance import Provenance
from elastica_cad.geometry.pen_curves.tangent_healing import Turn
from elastica_cad.mechanics.loads.rest_curvature import ExcessCurvature
from elastica_cad.mechanics.loads.supports import Supports
from elastica_cad.mechanics.theorem1.verdict import (
    figure,
    listed,
    places,
)

AT_END_SHARE = 1e-7
"""A zero of the curvature nearer to an end than this, in lengths of the curve, is the end's."""


PINNED_SHARE = 1e-6
"""Curvature at a pinned end, relative to the largest, that counts as none."""

GENTLE_SHARE = 1e-5
"""Slope of the curvature in an inflection, relative to the largest curvature over the length, that counts as none:
the stiffness would exceed that of other places by some ten thousand times."""

FAINT_SHARE = 1e-7
"""Curvature in a dip, relative to the largest, that counts as none: as for the slope, whose square it goes with."""


def tell_corners(curve: PlaneCurve, corners: Sequence[TangentBreak]) -> str:
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
        f"kinks; round it, or draw two curves{_taken_out(curve)}"
    )


def tell_seam(curve: PlaneCurve) -> str:
    """The same of a closed curve whose only corner is where it closes."""
    drawn = curve.provenance
    start = curve.evaluate(np.array(curve.domain[0]))
    for turn in () if drawn is None else drawn.undecided:
        if turn.t == curve.domain[0]:
            return _tell_undecided(drawn, turn, places((0.0,)))
    return (
        f"the curve is closed with a corner of {np.degrees(abs(curve.seam_turn)):.3g} degrees at "
        f"{shown_on(curve, start)}: a strip bends without kinks; round it, or leave a gap between its "
        f"ends{_taken_out(curve)}"
    )


def shown_on(curve: PlaneCurve, point: FloatArray) -> str:
    """A point (2,) as the program shows it in which the curve was drawn."""
    drawn = curve.provenance
    return f"({point[0]:.4g}, {point[1]:.4g})" if drawn is None else drawn.shown(point)


def _tell_undecided(drawn: Provenance | None, turn: Turn, where: str) -> str:
    shown = drawn or Provenance()
    return (
        f"undecided at this precision: the curve turns by {np.degrees(turn.angle):.2g} degrees at "
        f"{shown.shown(turn.point)}, {where} along it, and the digits "
        f"of the file alone can turn its handle of {turn.handle:.3g} mm by "
        f"{np.degrees(turn.bound):.2g}: save it "
        "with more decimals, or make the node smooth with longer handles"
    )


def _taken_out(curve: PlaneCurve) -> str:
    slight = smooth_for_corners(curve)
    if slight is None:
        return ""
    return f", or take it out within {slight:g} mm (smooth = {slight:g}, --smooth {slight:g})"


def tell_pinned_ends(
    excess: ExcessCurvature, supports: Supports, zeros: Sequence[CurvatureZero]
) -> Iterable[str]:
    """Ends that turn freely where the curve is bent."""
    curve = excess.curve
    for name, support, t, s in zip(
        ("start", "end"), supports.ends, curve.domain, (0.0, curve.length), strict=True
    ):
        if support.angle or any(z.kind == "end" and z.t == t for z in zeros):
            continue
        kappa = float(curve.curvature_at(np.array(t)))
        natural = float(excess.rest_at(np.array(t)))
        over = f" less the natural {natural:.4g}" if natural else ""
        yield (
            f"The {name} (at {s:.4g} mm) is free to turn, so the curve must have no curvature there; it has "
            f"{kappa:.4g} 1/mm{over}: clamp this end, or let the curvature run out to zero."
        )


def tell_straight_parts(
    excess: ExcessCurvature, flats: Sequence[CurvatureZero], largest: float
) -> Iterable[str]:
    """Straight parts, at whose ends no stiffness would do."""
    curve = excess.curve
    for flat in flats:
        joints = [joint for joint in ((flat.s, flat.t, True), (flat.s_end, flat.t_end, False))
                  if AT_END_SHARE * curve.length < joint[0] < (1 - AT_END_SHARE) * curve.length]  # fmt: skip
        what = "has exactly the natural curvature" if excess.is_bent_beforehand else "is straight"
        opening = (
            f"The piece from {figure(flat.s)} to {flat.s_end:.4g} mm {what} and joined to a bent one, so "
            "the stiffness would have to go to 0 at the joint"
        )
        if any(_is_gentle(excess, t, largest, left=left) for _, t, left in joints):
            yield f"{opening}, whatever supports the strip there: bend the piece a little."
        else:
            yield (
                f"{opening}: support the strip {places(s for s, _, _ in joints)}, or bend the piece a little."
            )


def _is_gentle(excess: ExcessCurvature, t: float, largest: float, *, left: bool) -> bool:
    """Does kappa - kappa_0 leave zero at t without a slope, so that no strip takes the bent piece alone?"""
    at = np.array(t)
    kappa = abs(float(excess.at(at, left=left)))
    slope = abs(float(excess.slope_at(at, left=left)))
    return kappa <= PINNED_SHARE * largest and slope <= PINNED_SHARE * largest / excess.curve.length


def tell_jumps(jumps: Sequence[float]) -> Iterable[str]:
    """Jumps of the curvature through zero."""
    if jumps:
        yield (
            f"The bending is reversed by a jump of the curvature {places(jumps)}, where the stiffness would "
            "have to go to 0: support the strip there, or let the curvature pass through zero smoothly "
            "(smooth = 0.1, or --smooth 0.1, does that within 0.1 mm)."
        )


def tell_touches(touches: Sequence[float]) -> Iterable[str]:
    """Places where the curvature touches zero."""
    if touches:
        yield (
            f"The curvature runs out to zero {places(touches)} without a clear change of sign, where the "
            "stiffness would have to be infinite or zero, whatever supports the strip: bend the curve a "
            "little more there, or reverse its bending at a clear rate."
        )


def warn_of_widths(curve: PlaneCurve, jumps: Sequence[float]) -> Iterable[str]:
    """Where the width will jump or kink with the curvature."""
    breaks = curve.breaks if curve.seam is None else (curve.seam, *curve.breaks)
    steps = [b.s for b in breaks if b.continuity == 1 and b.s not in jumps]
    kinks = [b.s for b in breaks if b.continuity == 2]
    if steps:
        yield (
            f"The width of the strip steps {places(steps)}, where the curvature jumps: smooth = 0.1, or "
            "--smooth 0.1, makes it a fair curve of degree 4 within 0.1 mm."
        )
    if kinks:
        advice = (
            "smooth = 0.1, or --smooth 0.1, makes it a fair curve of degree 4 within 0.1 mm"
            if curve.degree < 4
            else "do not repeat the knot there"
        )
        yield (
            f"The width of the strip has a kink {places(kinks)}, where the slope of the curvature jumps: "
            f"{advice}."
        )


def warn_of_crossing(curve: PlaneCurve) -> tuple[str, ...]:
    """Where the curve crosses itself."""
    pairs = curve.self_intersections()
    if not pairs.size:
        return ()
    where = listed(f"{first:.4g} and {second:.4g}" for first, second in pairs)
    return (
        f"The curve crosses itself (at {where} mm): two parts of the strip must pass side by side there.",
    )
