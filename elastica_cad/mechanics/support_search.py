"""Search for the rail, pin or tie that makes an impossible curve possible."""

from collections.abc import Sequence
from contextlib import suppress
from itertools import combinations

from elastica_cad.errors import ElasticaError
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.elements import Element, Pin, Rail, Tie, require_elements
from elastica_cad.mechanics.equilibrium_check import examine
from elastica_cad.mechanics.least_ratio import rod_of_request
from elastica_cad.mechanics.loads import (
    NaturalCurvature,
    Supports,
    require_natural_curvature,
    require_supports,
)
from elastica_cad.mechanics.moment_conditions import RodRequest
from elastica_cad.mechanics.optimal_balance import ratio_within
from elastica_cad.mechanics.stability import stability

PLACES = 11
"""Number of points along the curve, evenly spaced between its ends, at which rails, pins and ties are tried."""

PLACE_DIGITS = 3
"""Number of significant digits of a suggested arc length."""

CLEARLY_BETTER = 2.0
"""Factor by which a pin must reduce the stiffness ratio to replace a rail, or a tie to replace a rail or pin."""

MOST_RATIO = 8.0
"""Largest stiffness ratio of a useful strip."""


def suggest_support(
    curve: PlaneCurve,
    supports: Supports | None = None,
    natural_curvature: NaturalCurvature = 0.0,
    between: "Element | Sequence[Element]" = (),
) -> Element | None:
    """Return the rail, pin or tie with which a stable rod without weight can have the shape of a curve.

    Rails and pins are tried at 11 points, and ties between these points, so at most 77 linear programs are
    solved. Rails are preferred: a pin is returned only if it at least halves the least stiffness ratio with a rail,
    and a tie only if it at least halves the least ratio with a rail or pin.

    Parameters
    ----------
    curve : PlaneCurve
        Drawn curve, mm.
    supports : Supports, optional
        By default both ends are clamped.
    natural_curvature : float or RestCurvature
        Curvature of the unloaded strip, 1/mm.
    between : Rail, Pin or Tie, or several
        Rails, pins and ties that the rod already has.

    Returns
    -------
    Rail, Pin, Tie or None
        The rail, pin or tie to add. Positions are arc lengths, mm, with 3 significant digits. None if no rail, pin
        or tie gives a stable rod with a ratio up to 8.

    Examples
    --------
    >>> points = [(0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (360, 0)]
    >>> suggest_support(PlaneCurve.spline(points, degree=5))
    Rail(at=197.0, one_sided=True)
    """
    supports = require_supports(supports)
    require_natural_curvature(natural_curvature)
    present = require_elements(between)
    check = examine(curve, supports, natural_curvature, heavy=True)
    if not check.realizable or check.any_stiffness:
        return None
    step = curve.length / (PLACES + 1)
    places = [float(f"{k * step:.{PLACE_DIGITS}g}") for k in range(1, PLACES + 1)]
    kinds: list[list[Element]] = [
        [Rail(at) for at in places],
        [Pin(at) for at in places],
        [Tie(start, end) for start, end in combinations(places, 2)],
    ]
    # the first kind must reach a ratio up to MOST_RATIO
    best, least = None, CLEARLY_BETTER * MOST_RATIO
    for elements in kinds:
        if least <= CLEARLY_BETTER:  # another kind cannot be clearly better, because no ratio is below 1
            break
        requests = [
            RodRequest(
                curve,
                supports=supports,
                natural_curvature=natural_curvature,
                known_check=check,
                between=(*present, element),
            )
            for element in elements
        ]
        support = _stable(requests, min(MOST_RATIO, least / CLEARLY_BETTER))
        if support is not None:
            least, best = support
    return best


def _stable(requests: Sequence[RodRequest], most: float) -> tuple[float, Element] | None:
    """Return the ratio and the rail, pin or tie of the stable rod of least stiffness ratio, or None."""
    possible = []
    for i, request in enumerate(requests):
        with suppress(ElasticaError):
            if (ratio := ratio_within(request, most)) is not None:
                possible.append((ratio, i))
    # compute the stability of few rods only
    for ratio, i in sorted(possible)[:3]:
        with suppress(ElasticaError):
            if stability(rod_of_request(requests[i])).stable:
                return ratio, requests[i].between[-1]
    return None
