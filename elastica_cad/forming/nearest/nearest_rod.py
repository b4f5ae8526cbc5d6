"""The nearest rod to a drawn curve that material, machine and gravity allow."""

from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from elastica_cad.errors import ElasticaError, InputError
from elastica_cad.forming.leaf_ends import LeafedRod, lay_leaves, leaf_bends
from elastica_cad.forming.limits import MET, Keep, Limits
from elastica_cad.forming.nearest.advice import advise
from elastica_cad.forming.nearest.binding_limits import list_bindings
from elastica_cad.forming.nearest.curve_distance import measure_deviation
from elastica_cad.forming.nearest.nearest_record import Binding, NearestRod, Status
from elastica_cad.forming.nearest.nearest_task import Measure, NearestTask, Weights
from elastica_cad.forming.nearest.starts import mean_distance, search
from elastica_cad.forming.nearest.target_curve import TargetCurve
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads.gravity import Gravity
from elastica_cad.mechanics.loads.rest_curvature import NaturalCurvature
from elastica_cad.mechanics.loads.supports import Supports
from elastica_cad.mechanics.material.stiffness_law import BoundedLaw
from elastica_cad.mechanics.material.tapered_sections import LeavesLaw
from elastica_cad.mechanics.rod.node_counts import SEARCH_SAMPLES
from elastica_cad.mechanics.rod.rod_record import Rod
from elastica_cad.mechanics.stability.stability_verdict import stability
from elastica_cad.mechanics.stiffness.optimal_rod import optimal_rod

_STRICTER = 6  # tapers at most, each within stricter limits, from which leaves are laid
_BEYOND = 1.2  # times what a stack breaks of a limit is asked of the next taper
_WHOLE = 1e-9  # of a leaf: more than rounding
_RESCALINGS = 8  # searches more, at most, until a section weighs what it is made of
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
        The answer to nearly the same wish, such as the curve before a small move: the search begins at its rod and
        takes two thirds of the time, or a tenth where many starts were needed. It stays in that rod's valley while
        what it finds there meets the limits and is nearly as near as that rod was; else it begins afresh.

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
    if isinstance(section, LeavesLaw):
        return _nearest_leaves(
            curve, limits, keep, gravity, section, supports=supports, weights=weights, measure=measure,
            samples=samples, coefficients=coefficients, natural_curvature=natural_curvature,
        )  # fmt: skip
    if not (start is None or isinstance(start, NearestRod)):
        raise InputError(
            f"start is {start!r}: give the record that nearest_rod gave for a like curve, or None"
        )
    task = NearestTask.of(
        curve, limits, keep, gravity, supports, weights, samples, coefficients, section, natural_curvature
    )
    found = search(task, measure, None if start is None else start.ended)
    steps = found.steps
    for _ in range(_RESCALINGS):
        settled = found.task.settled(found.best.point)
        if settled is found.task:
            break
        found = search(settled, measure, found.ended)
        steps += found.steps
    task, problem, outcome = replace(task, section=found.task.section), found.problem, found.best
    target = task.target
    deviation = measure_deviation(target, outcome.point.position) * target.size
    distance = outcome.objective if measure == "max" else float(np.sqrt(2 * outcome.objective))
    return NearestRod(
        found=task.rod_of(outcome.point), target=curve, deviation=deviation,
        status=_status(outcome.violation, deviation, target, outcome.settled),
        mean_deviation=mean_distance(task, outcome) * target.size,
        binding=list_bindings(task, problem, outcome, measure), violation=outcome.violation, iterations=steps,
        limits=task.limits, keep=task.keep, measure=measure,
        distance=distance * target.size,
        ties=tuple(task.rod_of(tie.point) for tie in found.ties),
        ended=found.ended,
        advise=advise,
        again=partial(
            nearest_rod, curve, gravity=gravity, supports=supports, weights=task.weights, measure=measure,
            samples=task.nodes, coefficients=task.coefficients, section=section,
            natural_curvature=natural_curvature,
        ),
    )  # fmt: skip


def _status(violation: float, deviation: float, target: TargetCurve, settled: bool) -> Status:
    """How a search ended: by what is broken first, then by how far the rod is, then by whether it came to rest."""
    if violation > MET:
        return Status.NOT_MET
    if deviation > _FAR * target.diagonal * target.size:
        return Status.FAR
    return Status.MET if settled else Status.UNSETTLED


def _nearest_leaves(
    curve: PlaneCurve,
    limits: Limits | None,
    keep: Keep | None,
    gravity: Gravity | None,
    law: LeavesLaw,
    **asked: Any,
) -> NearestRod:
    """A stack of glued leaves near the nearest taper; where a step breaks a limit, that of a stricter taper."""
    limits, keep = limits or Limits(), keep or Keep()
    if limits.stiffness_bounds is not None or keep.points or keep.symmetry or keep.line:
        raise InputError(
            "leaves keep ends, tangents and length, within ratio, margin, curvature, strain and regions: leave out "
            "stiffness_bounds, points, symmetry and line"
        )
    # (n / k)^3 is the ratio of n leaves and k
    fewest = int(np.ceil(law.leaves / limits.largest_ratio ** (1 / 3) - _WHOLE))
    law = replace(law, fewest=min(max(law.fewest, fewest), law.leaves))
    laid, steps = None, 0
    taper = _taper_on_curve(curve, limits, gravity, law, asked)
    if taper is not None:
        laid = lay_leaves(taper, law, tangents=keep.both_tangents)
    strict = limits
    for _ in range(_STRICTER):
        if laid is not None and not _broken_by(laid, limits):
            break
        near = nearest_rod(curve, strict, keep, gravity, section=law.relaxed, **asked)
        steps += near.iterations
        laid = lay_leaves(near.rod, law, tangents=keep.both_tangents)
        strict = _stricter(strict, _broken_by(laid, limits))
    assert laid is not None
    broken = _broken_by(laid, limits)
    missed = max((binding.broken for binding in broken), default=0.0)
    target = TargetCurve.of(curve)
    position = (laid.rod.position - target.origin) / target.size
    deviation = measure_deviation(target, position) * target.size
    drawn = curve.sample(laid.rod.s.size).position
    mean = float(np.sqrt(((laid.rod.position - drawn) ** 2).sum(axis=1).mean()))
    return NearestRod(
        found=laid.rod, target=curve, deviation=deviation, mean_deviation=mean,
        status=_status(missed, deviation, target, laid.settled),
        binding=broken, violation=missed, iterations=steps, limits=limits, keep=keep,
        measure=asked["measure"], distance=mean, advise=advise,
        again=partial(nearest_rod, curve, gravity=gravity, section=law, **asked),
    )  # fmt: skip


def _taper_on_curve(
    curve: PlaneCurve, limits: Limits, gravity: Gravity | None, law: LeavesLaw, asked: dict[str, Any]
) -> Rod | None:
    """The taper that rests in the curve itself, as thick as the stack may be, where there is one."""
    if limits.length is not None and not limits.length[0] <= curve.length <= limits.length[1]:
        return None
    try:
        return optimal_rod(curve, gravity, asked["supports"], asked["natural_curvature"], section=law.relaxed)
    except ElasticaError:
        return None


def _broken_by(laid: LeafedRod, limits: Limits) -> tuple[Binding, ...]:
    """The limits that a stack breaks, and by how much, in shares of each."""
    rod = laid.rod
    s, bend = leaf_bends(rod, laid.section)
    shares: dict[str, tuple[float | None, float]] = {}
    if limits.margin is not None:
        scale = max(10.0, abs(limits.margin))
        shares["margin"] = limits.margin, (limits.margin - stability(rod).margin) / scale
    if limits.curvature is not None:
        shares["curvature"] = limits.curvature, float(bend.max()) / limits.curvature - 1
    if limits.sheet is not None:
        (strain,) = laid.section.strains(bend, laid.section.sheet.thickness * laid.section.counts(s))
        shares["strain"] = None, strain.largest / (limits.strain or strain.limit) - 1
    if limits.keep_out:
        inside = -min(float(region.clearance(rod.position)[0][1:-1].min()) for region in limits.keep_out)
        shares["keep-out"] = None, inside / rod.length
    return tuple(Binding(name, limit, 0.0, over) for name, (limit, over) in shares.items() if over > MET)


def _stricter(limits: Limits, broken: tuple[Binding, ...]) -> Limits:
    """Limits for the taper, of which a stack then breaks less."""
    for one in broken:
        more = 1 + _BEYOND * one.broken
        if one.name == "margin":
            scale = max(10.0, abs(one.limit or 0.0))
            limits = replace(limits, margin=(limits.margin or 0.0) + _BEYOND * one.broken * scale)
        elif one.name == "curvature":
            limits = limits.tightened(curvature=more)
        elif one.name == "strain":
            limits = limits.tightened(strain=more)
    return limits
