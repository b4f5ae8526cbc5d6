"""Search for the rod nearest to a drawn curve within limits of material and machine, also with gravity."""

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import fields, replace
from functools import partial
from typing import NamedTuple

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import is_one_of, require_record
from elastica_cad.errors import ElasticaError, InputError, NotConvergedError, note
from elastica_cad.form_finding.constraints import MarginLimit, margin_limit
from elastica_cad.form_finding.curve_distance import TargetCurve, measure_deviation
from elastica_cad.form_finding.leaf_ends import LeafedRod, lay_leaves, leaf_bends
from elastica_cad.form_finding.limits import (
    MET,
    STRAIN,
    ActiveLimit,
    Keep,
    Limits,
    Measure,
    Places,
    require_limits,
)
from elastica_cad.form_finding.nearest_record import NearestRod, judge_search
from elastica_cad.form_finding.nearest_task import NearestTask, SearchPoint
from elastica_cad.form_finding.rod_map import MappedRod
from elastica_cad.form_finding.rod_problem import RodOutcome, RodProblem, Search, active_limits, pose_problem
from elastica_cad.form_finding.rod_spec import RodSpec, Weights
from elastica_cad.form_finding.sqp import SETTINGS as SQP
from elastica_cad.form_finding.sqp import lift, minimize, worst_broken
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.cross_sections import LeavesLaw, Section, require_section
from elastica_cad.mechanics.least_ratio import rod_of_request
from elastica_cad.mechanics.loads import (
    Gravity,
    NaturalCurvature,
    Supports,
    require_curve,
    require_gravity,
    require_natural_curvature,
    require_supports,
    whole_number,
)
from elastica_cad.mechanics.optimal_balance import far_too_heavy
from elastica_cad.mechanics.rod import SEARCH_SAMPLES, Rod
from elastica_cad.mechanics.stability import stability


class SearchSettings(NamedTuple):
    """Settings of the search. Distances are mean distances as fractions of the diagonal of the target.

    Attributes
    ----------
    steps, unmet_steps : int
        Total number of steps after which no further initial guess is tried. `unmet_steps` applies while no result
        meets the limits, or if a margin is required and the first result violates a limit.
    tensions : tuple of float
        Tensions along the chord of initial guesses, as fractions of the tension that alone provides the margin.
        Guesses under tension are stable.
    long_distance, long_factor : float
        If the distance exceeds `long_distance`, an initial guess of `long_factor` times the length of the target
        is tried.
    random_distance : float
        Distance above which initial guesses with random waves are tried.
    random_starts, random_lifted_steps : int
        Largest number of random initial guesses, and of lifted steps (see `lift`) from each guess. With few steps,
        the guesses lead to different local optima.
    random_angle : float
        Typical angle of the random waves, rad.
    continued_distance, continued_factor : float
        The result of a continued search is accepted if the distance is less than `continued_distance`, or less than
        `continued_factor` times the previous distance.
    exact_distance : float
        Distance below which a rod follows the target exactly, and a smaller stiffness ratio is tried.
    ratio_distance : float
        Largest distance that is accepted for a smaller stiffness ratio.
    spline_factor : float
        Factor on the least stiffness ratio, because the stiffness is a spline with few coefficients.
    measured, measured_distance : int, float
        Largest number of optima by mean distance from which the largest distance is minimised, and the distance
        above which it is minimised.
    tie_factor, tie_distance : float
        Further results are reported if their distance is at most `tie_factor` times the least distance, and they
        are farther than `tie_distance` from each other.
    closed_gap : float
        Distance between the ends, as a fraction of the length, below which the tension of a guess is reduced.
    rescalings : int
        Largest number of searches to determine the scale of the sections.
    scale_reserve, scale_change : float
        Factor on the largest scale, because the widths may still change, and growth of the scale below which the
        search ends. The settings from `scale_reserve` on apply if the margin depends on the widths.
    scale_factors : tuple of float
        Factors on the scale that are tried in order.
    margin_fraction : float
        Fraction of the margin that a first search requires.
    """

    steps: int = 600
    unmet_steps: int = 200
    tensions: tuple[float, float] = (0.6, 0.0)
    long_distance: float = 0.009
    long_factor: float = 1.03
    random_distance: float = 0.02
    random_starts: int = 12
    random_lifted_steps: int = 3
    random_angle: float = 0.4
    continued_distance: float = 0.015
    continued_factor: float = 1.1
    exact_distance: float = 1e-3
    ratio_distance: float = 1e-4
    spline_factor: float = 1.005
    measured: int = 2
    measured_distance: float = 1e-5
    tie_factor: float = 1.02
    tie_distance: float = 0.02
    closed_gap: float = 1e-3
    rescalings: int = 8
    scale_reserve: float = 0.99
    scale_change: float = 1.03
    scale_factors: tuple[float, ...] = (1.0, 0.9, 0.75)
    margin_fraction: float = 0.8


SETTINGS = SearchSettings()


def _find_rod(task: NearestTask, start: NearestRod | None = None) -> NearestRod:
    """Return the nearest rod. If the first rod is not exact, smaller sections are searched too."""
    search = _search(task.without_followed_margin, None if start is None else start.ended)
    smaller = task.in_smaller_sections
    if smaller is not None and (search.best.violation > MET or search.off > SETTINGS.exact_distance):
        other, steps = _search(smaller), search.steps
        search = min(search, other, key=lambda trial: _rank(trial.best))._replace(steps=steps + other.steps)
    search = _measured(_rescaled(search, task.limits.margin))
    task = replace(task, section=search.task.section)
    problem, outcome, target = search.problem, search.best, task.target
    rod = task.rod_of(outcome.point)
    deviation = measure_deviation(target, rod.position)
    power = task.distance.power
    distance = (power * task.distance.value(outcome.point)) ** (1 / power)
    return NearestRod(
        found=rod, target=task.request.curve, deviation=deviation,
        status=judge_search(outcome.violation, deviation / (target.diagonal * target.size), outcome.settled),
        mean_deviation=search.task.off(outcome.point) * target.size,
        binding=active_limits(task, problem, outcome), violation=outcome.violation,
        iterations=search.steps, limits=task.limits, keep=task.keep, measure=task.request.measure,
        distance=distance * target.size,
        ties=tuple(task.rod_of(tie.point) for tie in search.others),
        ended=search.ended,
        again=partial(_again, replace(task.request, weights=task.weights)),
    )  # fmt: skip


def _search(task: NearestTask, before: SearchPoint | None = None) -> Search:
    """Search from `before`, the end of a similar search, or else from several initial guesses.

    The first guess nearly always suffices. Further guesses are tried if the result violates limits, has not
    converged, or is far from the target.
    """
    problem = pose_problem(task)
    if before is not None and (near := _from_before(task, problem, before)) is not None:
        return _compared(Search(task, problem, near, (), near.iterations, before.off), [near])
    outcomes = [minimize(problem, _start(task, problem))]
    # if the first result violates a limit while a margin is required, other guesses get fewer steps
    tight = outcomes[0].violation > MET and task.limits.margin is not None
    for enough, start in _starts(task, problem):
        best = min(outcomes, key=_rank)
        # a stalled search counts as if it had used all its steps
        spent = sum(SQP.steps if outcome.stalled else outcome.iterations for outcome in outcomes)
        most = SETTINGS.unmet_steps if tight or best.violation > MET else SETTINGS.steps
        good = _is_optimum(best) and task.off(best.point) / task.target.diagonal < enough
        if not good and (spent < most or enough == np.inf):
            outcomes.append(minimize(problem, start(), known=list(filter(_is_optimum, outcomes))))
    best = min(outcomes, key=_rank)
    off, steps = task.off(best.point) / task.target.diagonal, sum(outcome.iterations for outcome in outcomes)
    return _compared(Search(task, problem, best, (), steps, off), outcomes)


def _is_optimum(outcome: RodOutcome) -> bool:
    return outcome.settled and outcome.violation <= MET


def _rescaled(search: Search, margin: float | None) -> Search:
    """Repeat the search until the sections of the rod are as large as the limits allow.

    If the rod then violates the stability margin `margin`, the search is repeated with smaller sections.
    """
    for _ in range(SETTINGS.rescalings):
        settled = search.task.settled(search.best.point)
        # without weight, the shape does not depend on the scale
        if settled is search.task or settled.request.gravity is None:
            search = search._replace(task=settled)
            break
        search = _continued_search(search, settled)
    # the margin was not left out of the search: see `without_followed_margin`
    if margin == search.task.limits.margin:
        return search
    task = search.task.with_margin(margin)
    problem = pose_problem(task)
    met = [
        worst_broken(problem, problem.values(outcome.point)) <= MET
        for outcome in (search.best, *search.others)
    ]
    # no further search if the rod meets the margin, or violates other limits anyway
    if met[0] or search.best.violation > MET:
        others = tuple(other for other, stays in zip(search.others, met[1:], strict=True) if stays)
        return search._replace(task=task, others=others)
    task = replace(task.scaled_by(SETTINGS.scale_reserve), keeps_scale=True)
    for _ in range(SETTINGS.rescalings):
        wider = _narrowed(search, task)
        if search.task.keeps_scale and wider.best.violation > MET:
            return search._replace(steps=wider.steps)
        search = wider
        task = search.task.settled(search.best.point)
        if search.best.violation > MET or task.scale < SETTINGS.scale_change * search.task.scale:
            break
        task = task.scaled_by(SETTINGS.scale_reserve)
    return search


def _narrowed(search: Search, task: NearestTask) -> Search:
    """Repeat the search with the scale of `task`, then with smaller scales, until the limits are met.

    Narrower strips may meet a margin that wider strips violate. Each scale is first tried with a part of the
    required margin.
    """
    margin = task.limits.margin or 0.0
    for factor in SETTINGS.scale_factors:
        narrow = task.scaled_by(factor)
        eased = _continued_search(search, narrow.with_margin(min(margin, SETTINGS.margin_fraction * margin)))
        tried = _continued_search(eased, narrow)
        if tried.best.violation <= MET:
            break
        search = search._replace(steps=tried.steps)
    return tried


def _continued_search(search: Search, task: NearestTask) -> Search:
    more = _search(task, search.ended)
    return more._replace(steps=search.steps + more.steps)


def _from_before(task: NearestTask, problem: RodProblem, before: SearchPoint) -> RodOutcome | None:
    """Return the optimum near the result of the search before, or None if it is not a good start."""
    z = before.seen_from(task.target, problem.grid.unknowns)
    rod = None if z is None else problem.grid.shoot(z)
    if rod is None or not np.isfinite(rod.moments[-1]):
        return None
    outcome = minimize(problem, rod)
    enough = max(SETTINGS.continued_distance, SETTINGS.continued_factor * before.off)
    near = task.off(outcome.point) < enough * task.target.diagonal
    return outcome if near and _is_optimum(outcome) else None


def _compared(search: Search, outcomes: Sequence[RodOutcome]) -> Search:
    """Return the search with the rod of least stiffness ratio if rods follow the target exactly.

    Otherwise, return the search with the optima of other shapes as `others`.
    """
    task, problem, best, _, steps, _ = search
    free = task.is_scaled_freely or task.is_light
    if free and task.off(best.point) < SETTINGS.exact_distance * task.target.diagonal:
        least = _with_least_ratio(task, best)
        if least is not None:
            tight, problem, best = least
            return search._replace(task=tight, problem=problem, best=best, steps=steps + best.iterations)
    optima = sorted(filter(_is_optimum, outcomes), key=_rank)
    return search._replace(others=_distinct(task, problem, [best, *optima])[1:])


def _with_least_ratio(
    task: NearestTask, best: RodOutcome
) -> tuple[NearestTask, RodProblem, RodOutcome] | None:
    """Return the rod with the least stiffness ratio among those equally near to the target, or None.

    If many rods can follow the target exactly, the search may end with an unnecessarily large ratio.
    """
    K = best.point.stiffness
    section = None if task.section is None or task.is_light else task.section.family
    try:
        rod = rod_of_request(replace(task.request, section=section, samples=None))
    except ElasticaError:
        return None
    least = rod.ratio * SETTINGS.spline_factor
    if best.violation > MET or least >= K.max() / K.min():
        return None
    try:
        tight = task.within_ratio(least)
        problem = pose_problem(tight)
    except InputError:  # the limits contradict each other at the smaller ratio
        return None
    outcome = minimize(problem, _start(tight, problem, stiffness=min(least, 4.0) ** 0.5))
    near = max(task.off(best.point), SETTINGS.ratio_distance * task.target.diagonal)
    good = outcome.violation <= MET and task.off(outcome.point) <= near
    return (tight, problem, outcome) if good else None


def _distinct(
    task: NearestTask, problem: RodProblem, outcomes: Sequence[RodOutcome]
) -> tuple[RodOutcome, ...]:
    """Return the outcomes without those whose shape is that of an earlier one."""
    apart = (SETTINGS.tie_distance * task.target.diagonal) ** 2
    distinct: list[RodOutcome] = []
    for outcome in outcomes:
        if all(problem.apart(outcome.point, other.point) > apart for other in distinct):
            distinct.append(outcome)
    return tuple(distinct)


def _measured(search: Search) -> Search:
    """Return the search with the rod that is nearest in the requested measure, and those that are almost as near.

    The searches minimise the mean distance, which is smooth. From its optima, the largest distance is minimised.
    """
    task, problem, outcomes = search.task, search.problem, (search.best, *search.others)
    far = task.off(search.best.point) > SETTINGS.measured_distance * task.target.diagonal
    if task.request.measure == "max" and far:
        problem = replace(problem, distance=task.distance)
        measured = [minimize(problem, o.point) for o in outcomes[: SETTINGS.measured]]
        search = search._replace(steps=search.steps + sum(o.iterations for o in measured))
        outcomes = (*measured, *(replace(o, objective=problem.objective(o.point)) for o in outcomes))
    best, *others = _distinct(task, problem, sorted(outcomes, key=_rank))
    most = best.objective * SETTINGS.tie_factor**problem.distance.power
    ties = tuple(o for o in others if _is_optimum(o) and o.objective <= most)
    return search._replace(problem=problem, best=best, others=ties)


def _rank(outcome: RodOutcome) -> tuple[bool, float]:
    # order of results, the best first: those that meet the limits by distance, then the others
    met = outcome.violation <= MET
    return not met, outcome.objective + (0.0 if met else outcome.violation)


def _starts(task: NearestTask, problem: RodProblem) -> Iterator[tuple[float, Callable[[], MappedRod]]]:
    """Yield pairs of a distance, in diagonals of the target, and a function that returns an initial guess.

    The guess is skipped if a known optimum is nearer to the target than the distance.
    """
    chord = task.target.position[-1] - task.target.position[0]
    chord = chord / max(float(np.hypot(*chord)), SETTINGS.closed_gap)
    # tension that alone provides the margin
    pull = max(task.limits.margin or 0.0, 0.0) * task.even_stiffness
    for tension in SETTINGS.tensions if pull else SETTINGS.tensions[-1:]:
        yield np.inf, partial(_start, task, problem, force=-tension * pull * chord)
    length = problem.grid.unknowns.length
    if problem.lower[length] < problem.upper[length]:
        yield SETTINGS.long_distance, partial(_start, task, problem, length=SETTINGS.long_factor)
    waves = partial(_start, task, problem, lifted_steps=SETTINGS.random_lifted_steps)
    for seed in range(SETTINGS.random_starts):
        yield SETTINGS.random_distance, partial(waves, seed=seed)


def _start(
    task: NearestTask,
    problem: RodProblem,
    *,
    lifted_steps: int = SQP.lifted_steps,
    length: float | None = None,
    stiffness: float | None = None,
    seed: int | None = None,
    force: FloatArray | None = None,
) -> MappedRod:
    """Return an initial rod after lifted steps (see `lift`) from the target, with constant stiffness.

    With a `seed`, the shape and the stiffness are first varied randomly, to reach other local optima.
    """
    grid, target = problem.grid, task.target
    u, n = grid.unknowns, grid.edges
    # fractions of the length at which a rod has angles: its start, the middles of its edges, and its end
    places = np.concatenate([[0.0], (np.arange(n) + 0.5) / n, [1.0]])
    angles = target.angles(places)
    z = np.zeros(u.count)
    z[u.stiffness] = task.even_stiffness if stiffness is None else stiffness
    if seed is not None:
        rng = np.random.default_rng(seed)
        z[u.stiffness] *= rng.uniform(0.5, 2.0, u.coefficients)
        for k in range(1, 6):
            angles += rng.normal(scale=SETTINGS.random_angle / k) * np.sin(
                np.pi * k * places + rng.uniform(0, 2 * np.pi)
            )
    z[u.position], z[u.angle], z[u.length] = target.position[0], angles[0], 1.0
    if length is not None:
        z[u.length] = length
        problem = problem.with_given(u.length, z[u.length])
    if force is not None:
        problem = problem.with_given(u.force, force)
    z = z.clip(problem.lower, problem.upper)
    moments = (grid.basis @ z[u.stiffness]) * (np.diff(angles) / grid.shares - grid.natural_curvature)
    return lift(
        replace(problem, distance=task.mean_distance), grid.assemble(z, angles, moments), lifted_steps
    )


_OF_PLIES = {"ratio", "width", "length", "margin", "sheet", "strain", "ends", "tangents"}
"""Limits and kept properties that a search for plies meets, besides `Limits.at_places`."""


def _find_leaves(request: RodSpec, section: LeavesLaw) -> NearestRod:
    """Return the nearest stack of glued plies.

    The plies approximate a taper: the nearest rod of continuously varying thickness. If the stack violates a
    limit, the limits of the taper are tightened.
    """
    curve, limits, keep = request.curve, request.limits or Limits(), request.keep or Keep()
    met = _OF_PLIES | {limit.field for limit in limits.at_places(strain=False)}
    unmet = [
        f"`{name}.{entry.name}`"
        for name, record in (("limits", limits), ("keep", keep))
        for entry in fields(record)
        if entry.name not in met and getattr(record, entry.name) not in (entry.default, False)
    ]
    if unmet:
        raise InputError(f"a stack of plies cannot meet {' or '.join(unmet)}. Leave out these limits")
    # n plies are (n / k)^3 times as stiff as k plies, so the ratio determines the least number of plies, apart from
    # rounding errors
    fewest = int(np.ceil(section.leaves / limits.largest_ratio ** (1 / 3) - 1e-9))
    section = replace(section, fewest=min(max(section.fewest, fewest), section.leaves))
    strict, steps, taper = limits, 0, None
    if limits.length is None or limits.length[0] <= curve.length <= limits.length[1]:
        with suppress(ElasticaError):  # no taper follows the curve exactly
            taper = rod_of_request(replace(request, section=section.relaxed, samples=None))
    found = None if taper is None else _laid_leaves(taper, section, request, limits)
    # search with stricter and stricter limits; `found` is a stack, its violated limits, and the next limits
    for _ in range(6):
        if found is not None and not found[1]:
            break
        task = NearestTask.of(replace(request, limits=strict, section=section.relaxed))
        near = _find_rod(replace(task, grows=False))
        steps += near.iterations
        found = _laid_leaves(near.rod, section, request, strict)
        strict = found[2]
    assert found is not None
    laid, broken, _ = found
    missed = max((binding.broken for binding in broken), default=0.0)
    target = TargetCurve.of(curve)
    deviation = measure_deviation(target, laid.rod.position)
    points = curve.sample(laid.rod.s.size).position
    mean = float(np.sqrt(((laid.rod.position - points) ** 2).sum(axis=1).mean()))
    return NearestRod(
        found=laid.rod, target=curve, deviation=deviation, mean_deviation=mean,
        status=judge_search(missed, deviation / (target.diagonal * target.size), laid.settled),
        binding=broken, violation=missed, iterations=steps, limits=limits, keep=keep,
        measure=request.measure, distance=deviation if request.measure == "max" else mean,
        again=partial(_again, request),
    )  # fmt: skip


def _laid_leaves(
    taper: Rod, section: LeavesLaw, request: RodSpec, strict: Limits
) -> tuple[LeafedRod, tuple[ActiveLimit, ...], Limits]:
    """Return the stack that approximates a taper, the limits that it violates, and stricter limits.

    The taper was found within the limits `strict`.
    """
    limits, keep, length = request.limits or Limits(), request.keep or Keep(), request.curve.length
    laid = lay_leaves(taper, section, tangents=keep.both_tangents)
    rod = laid.rod
    s, bend = leaf_bends(rod, laid.section)
    position = np.column_stack([np.interp(s, rod.s, x) for x in rod.position.T])
    places = Places(
        length, s / rod.length * length, position, bend, np.interp(s, rod.s, rod.curvature), keep.both_ends
    )
    # limit, relative excess, and function that returns limits made stricter by a fraction
    found = [
        (active, -float(room(places)[0].min()), stricter)
        for _, active, room, stricter in limits.at_places(strain=False)
    ]
    if limits.margin is not None:
        margin = MarginLimit(active=margin_limit(limits.margin))
        over = (margin.limit - stability(rod).margin) / margin.scale
        found.append((margin.active, over, lambda limits, by: replace(
            limits, margin=(limits.margin or 0.0) + by * margin.scale
        )))  # fmt: skip
    if limits.sheet is not None:
        (strain,) = laid.section.strains(bend, laid.section.sheet.thickness * laid.section.counts(s))
        over = strain.largest / (limits.strain or strain.limit) - 1
        found.append((STRAIN, over, lambda limits, by: limits.tightened(strain=1 + by)))
    broken = [(replace(active, broken=over, title=note(active.title)), stricter)
              for active, over, stricter in found if over > MET]  # fmt: skip
    for limit, stricter in broken:
        # tighten a violated limit by somewhat more than the violation
        strict = stricter(strict, 1.2 * limit.broken)
    return laid, tuple(limit for limit, _ in broken), strict


_MOST_NODES = 5000  # more nodes hardly change the shape


def nearest_rod(
    curve: PlaneCurve,
    limits: Limits | None = None,
    keep: Keep | None = None,
    gravity: Gravity | None = None,
    *,
    supports: Supports | None = None,
    weights: Weights = None,
    measure: Measure = "max",
    samples: int = SEARCH_SAMPLES,
    coefficients: int | None = None,
    section: Section | None = None,
    natural_curvature: NaturalCurvature = 0.0,
    start: NearestRod | None = None,
) -> NearestRod:
    """Return the rod that meets all limits and is nearest to a drawn curve, which need not be realizable.

    The unknowns are the stiffness, the length and the start of the rod. The shape follows from the equilibrium
    of moments (Eqs. 3 and 5), so every rod in the search is in equilibrium. The method is described in
    `form_finding.sqp`.

    Parameters
    ----------
    curve : PlaneCurve
        Drawn curve.
    limits : Limits, optional
        Limits that the rod must meet, such as ratio, stability margin and curvature.
    keep : Keep, optional
        Properties of the drawn curve to keep; by default the positions of the ends.
    gravity : Gravity, optional
        Gravity, for a weight proportional to the stiffness, as in a solid strip.
    supports : Supports, optional
        Supports of the ends; by default both are clamped.
    weights : optional
        Weight of each part of the curve in the distance: a number, evenly spaced values, or a function of the
        arc length, mm.
    measure : "max" or "mean"
        Distance to minimise: the largest distance of a point of the rod from the curve or of the curve from the
        rod, or the mean of squared distances between rod and curve at equal fractions of their lengths.
    samples : int
        Number of nodes of the rod.
    coefficients : int
        Number of B-spline coefficients of the stiffness. By default there are 20, and about 4 more for each
        half turn of the curve.
    section : Section, optional
        Section, as in `optimal_rod`. The limits of the section also limit the stiffness ratio. With
        gravity, the rod carries the weight of its sections, and only the direction of gravity has an effect.
        `limits.sheet` limits the strain. For a `LeavesLaw`, the nearest rod of continuously varying thickness
        is found first, and is then approximated by plies (`lay_leaves`).
    natural_curvature : float or RestCurvature
        Curvature of the unbent rod, 1/mm. For a `RestCurvature`, the lengths of the rod and of the pre-bent strip
        agree within 1 %.
    start : NearestRod, optional
        Result of a similar request, such as the same curve before a small change. The search begins with its rod,
        which saves a third of the time or more. If the result violates limits or is much farther away, the search
        is repeated from new initial guesses.

    Returns
    -------
    NearestRod
        Nearest rod. If the drawn curve meets the limits, the rod has the least stiffness ratio within 0.5 %. If
        the limits cannot be met, the best rod is returned: see `status`, `met` and `binding`.

    Raises
    ------
    NotConvergedError
        There is no initial rod, because the curve bends too much, or the weight is far too large for the stiffness.

    References
    ----------
    Paper, sections 4.2, 6.4 and 7.2. The paper moves control points instead.

    Examples
    --------
    >>> arch = PlaneCurve.spline([(0, 0), (30, 60), (70, 60), (100, 0)], degree=3)
    >>> near = nearest_rod(arch, Limits(ratio=1.5, margin=5))
    >>> near.met, round(near.rod.ratio, 6)
    (True, 1.5)
    """
    require_curve(curve)
    require_gravity(gravity)
    supports = require_supports(supports)
    require_natural_curvature(natural_curvature)
    require_limits(limits, keep)
    if section is not None:
        require_section(section)
    if whole_number(samples, "samples", 20) > _MOST_NODES:
        raise InputError(f"samples is {samples!r}: use 20 to {_MOST_NODES}, usually {SEARCH_SAMPLES}")
    if not is_one_of(measure, ("mean", "max")):
        raise InputError(f"unknown measure {measure!r}: use 'mean' or 'max'")
    if coefficients is not None and whole_number(coefficients, "coefficients", 4) > (samples - 1) // 2:
        raise InputError(f"`coefficients` is {coefficients!r}: give 4 to {(samples - 1) // 2}, at most half "
                         "of `samples`")  # fmt: skip
    require_record(
        start, NearestRod | None, "start", "the result of nearest_rod for a similar curve, or None"
    )
    return find_nearest(
        RodSpec(
            curve, gravity, supports, natural_curvature, samples, section=section, limits=limits, keep=keep,
            smooth=0.0, weights=weights, measure=measure, coefficients=coefficients,
        ),
        start,
    )  # fmt: skip


def find_nearest(request: RodSpec, start: NearestRod | None = None) -> NearestRod:
    """Return the nearest rod of a checked request: see `nearest_rod`."""
    if isinstance(request.section, LeavesLaw):
        return _find_leaves(request, request.section)
    try:
        return _find_rod(NearestTask.of(request), start)
    except NotConvergedError as error:
        gravity, length = request.gravity, request.curve.length
        # only a very large weight explains a failed search
        if gravity is None or length < 50.0 * gravity.length:
            raise
        raise NotConvergedError(far_too_heavy(gravity, length)) from error


def _again(request: RodSpec, limits: Limits, keep: Keep) -> NearestRod:
    return find_nearest(replace(request, limits=limits, keep=keep))
