"""Theorem 1: can a flat strip take the drawn curve, and if not, where and why not."""

from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads.arguments import require_supports, require_tolerance
from elastica_cad.mechanics.loads.rest_curvature import NaturalCurvature
from elastica_cad.mechanics.loads.supports import Supports
from elastica_cad.mechanics.theorem1.line_conditions import check_line
from elastica_cad.mechanics.theorem1.unbent_ends import examine_unbent
from elastica_cad.mechanics.theorem1.verdict import EquilibriumCheck


def check_equilibrium(
    curve: PlaneCurve,
    supports: Supports | None = None,
    natural_curvature: NaturalCurvature = 0.0,
    *,
    tolerance: float = 1e-4,
) -> EquilibriumCheck:
    """Decide whether a flat strip of some admissible width can rest in this curve, without weight.

    Condition (1): a line meets the curve in the zeros of its curvature, in nothing else, and is tangent in
    none. Condition (2): the curvature changes sign in each of them with a finite slope. A pinned end must
    have no curvature, which puts it on the line too; an end free to slide along x (y) makes the line vertical
    (horizontal); ends that carry no force at all allow no line. A natural curvature is taken off the
    curvature. A closed curve is held by its own other end; where it was drawn to begin in an inflection, it is
    begun elsewhere (`curve`), and a warning says so.

    Parameters
    ----------
    supports : Supports
        Clamped at both ends unless given.
    natural_curvature : float or RestCurvature
        kappa_0, 1/mm, or that of a blank bent beforehand.
    tolerance : float
        Inflections that lie this near to one line, in lengths of the curve, are moved onto it (`moved`,
        `curve`); and so is the curve where an end that is free to turn is bent by next to nothing.

    Raises
    ------
    InputError
        A curve with corners, also where it closes.

    References
    ----------
    Paper, Theorem 1 and section 4.3.

    Examples
    --------
    >>> wave = PlaneCurve.spline([(0, 0), (40, 60), (80, -60), (120, 0)], degree=3)
    >>> check = check_equilibrium(wave)
    >>> check.realizable, len(check.inflections)
    (True, 1)
    """
    require_tolerance(tolerance)
    supports = require_supports(supports)
    check = examine_unbent(curve, supports, natural_curvature, tolerance)
    if check.any_stiffness or not check.zeros:
        return check
    return check_line(check, supports, natural_curvature, tolerance)
