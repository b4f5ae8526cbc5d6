"""Whether the digits of a file decide if its curve can be bent: curves that round to the same numbers, tried."""

from collections.abc import Iterator
from dataclasses import replace
from itertools import chain

import numpy as np

from elastica_cad.errors import ElasticaError
from elastica_cad.forming.fairing_request import smooth_curve
from elastica_cad.geometry.curve_editing.fairing import choose_tolerance, usual_tolerance
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.pen_curves.provenance import Provenance
from elastica_cad.geometry.pen_curves.tangent_healing import heal_tangents
from elastica_cad.mechanics.loads.supports import Supports
from elastica_cad.mechanics.theorem1.equilibrium_check import check_equilibrium

TRIES = 8
"""Curves that are tried, each number as far off as it may be; each costs a verdict of Theorem 1."""

SLIGHT = 1e-7
"""Rounding below this share of the length changes no verdict that is not the border itself."""

UNDECIDED = (
    "Undecided at this precision: the numbers in the file are exact to {rounding:.2g} mm, and of the "
    "curves that round "
    "to them some can be bent and some cannot. Save the drawing with more decimals (Inkscape: Preferences > "
    "Input/Output > SVG output > Numeric precision), or move the curve farther from the border."
)


def undecided_by_rounding(
    curve: PlaneCurve, realizable: bool, smooth: float | None = None, supports: Supports | None = None
) -> str:
    """A sentence where rounding of the coordinates alone can change the verdict on a pen curve, else empty.

    Parameters
    ----------
    curve : PlaneCurve
        As read from a file.
    realizable : bool
        The verdict on it.
    smooth, supports
        As in `smooth_curve`.
    """
    drawn = curve.provenance
    if drawn is None or drawn.drawn != "pen" or drawn.rounding <= SLIGHT * curve.length:
        return ""
    alike = ((other, smooth) for other in _rounded_alike(curve, drawn))
    finer = smooth is None and choose_tolerance(curve) > usual_tolerance(curve)  # else it was tried
    for other, tolerance in chain([(curve, usual_tolerance(curve))] if finer else [], alike):
        try:
            fair = smooth_curve(other, tolerance, supports=supports).curve
            if check_equilibrium(fair, supports).realizable != realizable:
                return UNDECIDED.format(rounding=drawn.rounding)
        except ElasticaError:
            continue
    return ""


def _rounded_alike(curve: PlaneCurve, drawn: Provenance) -> Iterator[PlaneCurve]:
    """Smooth curves that round to the same numbers."""
    rng = np.random.default_rng(0)
    for _ in range(TRIES):
        moved = curve.control_points + drawn.rounding * rng.choice([-1.0, 1.0], curve.control_points.shape)
        if curve.is_closed:
            moved[-1] = moved[0]
        healing = heal_tangents(curve.knots, moved, curve.degree, curve.weights, rounding=2 * drawn.rounding)
        try:
            other = PlaneCurve(
                healing.knots,
                healing.control_points,
                healing.degree,
                healing.weights,
                replace(drawn, healed=0.0),
            )
        except ElasticaError:
            continue
        if not other.tangent_breaks:
            yield other
