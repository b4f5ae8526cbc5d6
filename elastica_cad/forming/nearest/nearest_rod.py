"""The nearest rod to a drawn curve that material, machine and gravity allow."""

from typing import Any

from elastica_cad.errors import NotConvergedError
from elastica_cad.forming.limits import Keep, Limits
from elastica_cad.forming.nearest.nearest_leaves import find_leaves
from elastica_cad.forming.nearest.nearest_record import NearestRod
from elastica_cad.forming.nearest.nearest_task import Measure, Weights
from elastica_cad.forming.nearest.rod_search import find_rod
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads.gravity import Gravity
from elastica_cad.mechanics.loads.rest_curvature import NaturalCurvature
from elastica_cad.mechanics.loads.supports import Supports
from elastica_cad.mechanics.material.stiffness_law import BoundedLaw
from elastica_cad.mechanics.material.tapered_sections import LeavesLaw
from elastica_cad.mechanics.rod.node_counts import SEARCH_SAMPLES
from elastica_cad.mechanics.stiffness.optimal_balance import far_too_heavy

_UNBEARABLE = 50.0
"""Gravity lengths in a curve from which it is its weight that leaves no rod to begin with."""


def nearest_rod(
    curve: PlaneCurve,
    limits: Limits | None = None,
    keep: Keep | None = None,
    gravity: Gravity | None = None,
    *,
    supports: Supports | None = None,
    weights: Weights = None,
    measure: Measure = "mean",
    samples: int = SEARCH_SAMPLES,
    coefficients: int | None = None,
    section: BoundedLaw | None = None,
    natural_curvature: NaturalCurvature = 0.0,
    start: NearestRod | None = None,
) -> NearestRod:
    """The rod nearest to a drawn curve, realizable or not, that meets all limits.

    Stiffness, length and start of the rod are the unknowns and its shape follows from the balance of moments
    (Eqs. 3 and 5), so every rod that is tried rests in its shape; see `forming.optimizer.sqp` for the method.

    Parameters
    ----------
    curve : PlaneCurve
        The target.
    limits : Limits, optional
        Hard limits: ratio, stability margin, curvature, ...
    keep : Keep, optional
        What must stay; the end positions unless told.
    gravity : Gravity, optional
        Weight proportional to the stiffness, as of a plain strip.
    supports : Supports, optional
        Clamped at both ends unless given.
    weights : optional
        How much each part of the curve matters: a number, values at equal distances, or a function of the arc
        length of the curve (mm).
    measure : "mean", "closest" or "max"
        Mean square distance, arc length against arc length or each point against the nearest; or the largest
        distance.
    samples : int
        Nodes of the rod.
    coefficients : int
        B-spline coefficients of the stiffness; unless given 20, and 4 more for each half turn of the curve.
    section : BoundedLaw, optional
        What stiffness is made of, as in `optimal_rod`: its limits bound the ratio, under gravity (of which only the
        direction counts) it carries its own weight, and a limit `sheet` bounds its strain. Of a `LeavesLaw` the
        nearest rod of any thickness is sought first, then leaves are laid to come near that (`lay_leaves`).
    natural_curvature : float or RestCurvature
        kappa_0, 1/mm, or that of a blank bent beforehand: the rod is then as long as the blank, but for 1 %.
    start : NearestRod, optional
        The answer to nearly the same request, such as the curve before a small move: the search begins at its rod
        and takes two thirds of the time, or a tenth where many starts were needed. It stays in that rod's valley
        while what it finds there meets the limits and is nearly as near as that rod was; else it begins afresh.

    Returns
    -------
    NearestRod
        Of the least ratio (within 0.5 %) where the curve itself meets the limits. Also when limits cannot be
        met: see its `status`, `met` and `binding`.

    Raises
    ------
    InputError
        Limits that contradict each other or the curve.
    NotConvergedError
        No rod to begin with: a curve too wild, or a weight far too much for the stiffness.

    References
    ----------
    Paper, sections 4.2, 6.4 and 7.2, whose control point moves this replaces.

    Examples
    --------
    >>> arch = PlaneCurve.spline([(0, 0), (30, 60), (70, 60), (100, 0)], degree=3)
    >>> near = nearest_rod(arch, Limits(ratio=1.5, margin=5))
    >>> near.met, round(near.rod.ratio, 6)
    (True, 1.5)
    """
    asked: dict[str, Any] = {
        "gravity": gravity, "supports": supports, "weights": weights, "measure": measure, "samples": samples,
        "coefficients": coefficients, "natural_curvature": natural_curvature, "again": nearest_rod,
    }  # fmt: skip
    if isinstance(section, LeavesLaw):
        return find_leaves(curve, limits or Limits(), keep or Keep(), section, **asked)
    try:
        return find_rod(curve, limits, keep, section, start=start, **asked)
    except NotConvergedError as error:
        if gravity is None or curve.length < _UNBEARABLE * gravity.length:
            raise
        raise NotConvergedError(far_too_heavy(gravity, curve.length)) from error
