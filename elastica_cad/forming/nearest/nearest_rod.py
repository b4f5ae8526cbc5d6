"""The nearest rod to a drawn curve that material, machine and gravity allow."""

from functools import partial

import numpy as np

from elastica_cad.forming.limits import Keep, Limits
from elastica_cad.forming.nearest.advice import advise
from elastica_cad.forming.nearest.binding_limits import list_bindings
from elastica_cad.forming.nearest.curve_distance import measure_deviation
from elastica_cad.forming.nearest.nearest_record import NearestRod, Status
from elastica_cad.forming.nearest.nearest_task import Measure, NearestTask, Weights
from elastica_cad.forming.nearest.starts import MET, mean_distance, search
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads.gravity import Gravity
from elastica_cad.mechanics.loads.supports import Supports
from elastica_cad.mechanics.material.stiffness_law import BoundedLaw
from elastica_cad.mechanics.rod.node_counts import SEARCH_SAMPLES

_FAR = 0.05  # largest distance, in diagonals of the target, beyond which a rod no longer looks like it


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
        direction counts) it carries its own weight, and a limit `sheet` bounds its strain.

    Returns
    -------
    NearestRod
        Of the least ratio (within 0.5 %) where the curve itself meets the limits. Also when limits cannot be
        met: see its `status`, `met` and `binding`.

    Raises
    ------
    InputError
        Limits that contradict each other or the curve.

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
    task = NearestTask.of(curve, limits, keep, gravity, supports, weights, samples, coefficients, section)
    problem, outcome, ties, steps = search(task, measure)
    target = task.target
    deviation = measure_deviation(target, outcome.point.position) * target.size
    distance = outcome.objective if measure == "max" else float(np.sqrt(2 * outcome.objective))
    if outcome.violation > MET:
        status = Status.NOT_MET
    elif deviation > _FAR * target.diagonal * target.size:
        status = Status.FAR
    else:
        status = Status.MET if outcome.settled else Status.UNSETTLED
    return NearestRod(
        found=task.rod_of(outcome.point), target=curve, status=status, deviation=deviation,
        mean_deviation=mean_distance(task, outcome) * target.size,
        binding=list_bindings(task, problem, outcome, measure), violation=outcome.violation, iterations=steps,
        limits=task.limits, keep=task.keep, measure=measure,
        distance=distance * target.size,
        ties=tuple(task.rod_of(tie.point) for tie in ties),
        advise=advise,
        again=partial(
            nearest_rod, curve, gravity=gravity, supports=supports, weights=task.weights, measure=measure,
            samples=task.nodes, coefficients=task.coefficients, section=section,
        ),
    )  # fmt: skip
