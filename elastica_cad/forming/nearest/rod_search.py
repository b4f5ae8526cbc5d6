"""The search for the nearest rod: where it starts, what leads there, and its best outcome as a record."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from typing import NamedTuple

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import ElasticaError, InputError
from elastica_cad.forming.limits import MET, Keep, Limits
from elastica_cad.forming.nearest.advice import advise
from elastica_cad.forming.nearest.constraints.binding_limits import list_bindings
from elastica_cad.forming.nearest.curve_distance import measure_deviation
from elastica_cad.forming.nearest.nearest_record import NearestRod, judge_search
from elastica_cad.forming.nearest.nearest_task import Measure, NearestTask, SearchPoint, Weights
from elastica_cad.forming.nearest.rod_map import MappedRod
from elastica_cad.forming.nearest.rod_problem import RodProblem
from elastica_cad.forming.nearest.rod_program import RodOutcome, Search, pose_problem
from elastica_cad.forming.optimizer.exact_point import worst_broken
from elastica_cad.forming.optimizer.sqp import LIFTS, STEPS, lift, minimize
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads.gravity import Gravity
from elastica_cad.mechanics.loads.rest_curvature import NaturalCurvature
from elastica_cad.mechanics.loads.supports import Supports
from elastica_cad.mechanics.material.stiffness_law import BoundedLaw
from elastica_cad.mechanics.rod.rod_record import Rod
from elastica_cad.mechanics.stiffness.optimal_rod import optimal_rod

_RESCALINGS = 8  # searches more, at most, until a section weighs what it is made of
_NARROWER = (1.0, 0.9, 0.75)  # times a scale, where a margin is sought that hangs on it
_EASED = 0.8  # of such a margin, which is kept first where all of it is not found at once
_MARGIN_SCALES = 8  # that are tried in turn from there
_MOST_STEPS = 160  # in all, after which no new attempt is begun: two searches that use up their steps
_MOST_STEPS_ELSEWHERE = 600  # the same for the bent starts of what is still far
_BENT_STARTS, _FIRST_BENT_STARTS = 20, 4
_BENT_RAD = 0.4  # typical size of the waves by which such a start is bent off the target
_EVEN_RATIO = 1.4  # of a rod that is nearly even
_NEAR = 0.015  # mean distance, in diagonals, up to which a like search that goes on is believed
_FOLLOWS = 0.009  # the same, above which a longer rod may be nearer: it waves more often
_LONGER = 1.03  # lengths of such a rod to start from
_FAR = 0.03  # the same, above which other valleys are looked for
_BENT_ENOUGH = 0.02  # the same of the first bent starts
_WEIGHTS = (0.0, 0.25, 0.5)  # shares of the weight on the way from the weightless rod
_AS_NEAR = 1.1  # times the distance from all starts: a search that goes on may come to that
_FOLLOWED = 1e-3  # mean distance, in diagonals, below which a rod follows its target
_LEAN = 1e-4  # the same, that a lesser ratio may cost
_SPLINE_STIFFNESS = 1.005  # of the least ratio: K is a spline of few coefficients
_TIE = 1.02  # times the least distance: as near
_APART = 0.02  # distance of two rods, in diagonals, from which on they are two answers
_TENSIONS = (0.6, 0.0)  # shares of the tension that alone keeps the margin in a straight rod
_CLOSED = 1e-3  # lengths between the ends of a curve that nothing pulls straight
_AGREED = 14  # starts that came to rest at the same rod, which breaks its limits: there is no better one near
_SAME = 2e-3  # distance of two rods, in diagonals, up to which they are the same
_FEW_LIFTS = 3  # after which a start from a hard target is still open to several valleys
_CONTINUATION_STEPS = 40  # of one part of a continuation, which need not settle


def find_rod(
    curve: PlaneCurve,
    limits: Limits | None,
    keep: Keep | None,
    section: BoundedLaw | None,
    *,
    gravity: Gravity | None,
    supports: Supports | None,
    weights: Weights,
    measure: Measure,
    samples: int,
    coefficients: int | None,
    natural_curvature: NaturalCurvature,
    again: Callable[..., NearestRod],
    start: NearestRod | None = None,
    grown: bool = True,
) -> NearestRod:
    """The answer to `nearest_rod` for sections of any size; `again` is what asks anew within other limits.

    With `grown`, sizes without weight are as large as the limits let them be.
    """
    if not (start is None or isinstance(start, NearestRod)):
        raise InputError(
            f"start is {start!r}: give the record that nearest_rod gave for a like curve, or None"
        )
    task = NearestTask.of(
        curve, limits, keep, gravity, supports, weights, samples, coefficients, section, natural_curvature
    )
    task = task if grown else replace(task, grows=False)
    found = _search(task.without_followed_margin, measure, None if start is None else start.ended)
    smaller = task.in_smaller_sections
    if smaller is not None and (found.best.violation > MET or found.off > _FOLLOWED):
        other, steps = _search(smaller, measure), found.steps
        found = min(found, other, key=lambda search: _rank(search.best))._replace(steps=steps + other.steps)
    found = _rescaled(found, measure, task.limits.margin)
    if found.task.section is not task.section:
        task = replace(task, section=found.task.section)
    problem, outcome, target = found.problem, found.best, task.target

    def rod_of(point: MappedRod) -> Rod:
        return task.grown(point).rod_of(point)

    deviation = measure_deviation(target, outcome.point.position) * target.size
    distance = outcome.objective if measure == "max" else float(np.sqrt(2 * outcome.objective))
    return NearestRod(
        found=rod_of(outcome.point), target=curve, deviation=deviation,
        status=judge_search(outcome.violation, deviation / (target.diagonal * target.size), outcome.settled),
        mean_deviation=found.task.off(outcome.point) * target.size,
        binding=list_bindings(task, problem, outcome, measure), violation=outcome.violation,
        iterations=found.steps, limits=task.limits, keep=task.keep, measure=measure,
        distance=distance * target.size,
        ties=tuple(rod_of(tie.point) for tie in found.ties),
        ended=found.ended,
        advise=advise,
        again=partial(
            again, curve, gravity=gravity, supports=supports, weights=task.weights, measure=measure,
            samples=task.nodes, coefficients=task.coefficients, section=section,
            natural_curvature=natural_curvature,
        ),
    )  # fmt: skip


def _search(task: NearestTask, measure: Measure, before: SearchPoint | None = None) -> Search:
    """From where a like search ended before, or from as many starts as are needed.

    The first start nearly always does; the others are for what it leaves broken, unsettled or far from the target.
    """
    problem = pose_problem(task, measure)
    if before is not None and (near := _from_before(task, problem, before)) is not None:
        return _concluded(measure, Search(task, problem, near, (), near.iterations, before.off), [near])
    first = _start(task, problem)
    best = minimize(problem, first)
    steps, spent, off = best.iterations, best.spent, task.off(best.point) / task.target.diagonal
    found, broken = [best], best.violation > MET and task.limits.margin is not None
    for attempt in _attempts(task, measure, problem, first):
        done = best.settled and best.violation <= MET
        # what breaks its limits from all starts, or a margin from the first, is refused sooner than what is far
        most = _MOST_STEPS if broken or not done else attempt.most_steps
        if spent > most or (done and off < attempt.enough) or _is_refused(task, problem, best, found):
            continue
        known = [one for one in found if one.settled and one.violation > MET]
        if done and attempt.most_steps == _MOST_STEPS:
            known.append(best)
        if measure == "max":  # which tells nothing of the distance of two rods
            known = []
        outcome = minimize(problem, attempt.route().end(), radius=attempt.radius, known=known)
        steps, spent = steps + outcome.iterations, spent + outcome.spent
        found.append(outcome)
        best = min(best, outcome, key=_rank)
        off = task.off(best.point) / task.target.diagonal
    return _concluded(measure, Search(task, problem, best, (), steps, off), found)


def _rescaled(found: Search, measure: Measure, margin: float | None) -> Search:
    """The search of sections that are as large as the limits let the rod found be."""
    for _ in range(_RESCALINGS):
        settled = found.task.settled(found.best.point)
        if settled is found.task or settled.gravity is None:  # without weight nothing hangs on the scale
            found = found._replace(task=settled)
            break
        found = _go_on(found, settled, measure)
    if margin == found.task.limits.margin:
        return found
    task = found.task.with_margin(margin)
    problem = pose_problem(task, measure)
    met = [worst_broken(problem, problem.values(one.point)) <= MET for one in (found.best, *found.ties)]
    if met[0] or found.best.violation > MET:
        ties = tuple(tie for tie, stays in zip(found.ties, met[1:], strict=True) if stays)
        return found._replace(task=task, ties=ties)
    kept = _narrowed(found, task, measure)
    for _ in range(_MARGIN_SCALES):
        other = kept.task.rescaled(kept.best.point)
        if other is None or kept.best.violation > MET:
            break
        wider = _narrowed(kept, other, measure)
        if kept.task.keeps_scale and wider.best.violation > MET:
            kept = kept._replace(steps=wider.steps)
            break
        kept = wider
    return kept


def _narrowed(found: Search, task: NearestTask, measure: Measure) -> Search:
    """From where a search ended, at a scale or at smaller ones, where narrower strips keep what is asked."""
    for share in _NARROWER:
        tried = _eased_on(found, task.scaled_by(share), measure)
        if tried.best.violation <= MET:
            break
        found = found._replace(steps=tried.steps)
    return tried


def _eased_on(found: Search, task: NearestTask, measure: Measure) -> Search:
    """From where a search ended; where that does not keep the margin, by way of most of it."""
    straight, margin = _go_on(found, task, measure), task.limits.margin
    if straight.best.violation <= MET or margin is None or margin <= 0:
        return straight
    eased = _go_on(straight, task.with_margin(_EASED * margin), measure)
    if eased.best.violation > MET:
        return straight._replace(steps=eased.steps)
    again = _go_on(eased, task, measure)
    return min(straight, again, key=lambda one: _rank(one.best))._replace(steps=again.steps)


def _go_on(found: Search, task: NearestTask, measure: Measure) -> Search:
    """What is asked now, from where a search ended; its steps count too."""
    more = _search(task, measure, found.ended)
    return more._replace(steps=found.steps + more.steps)


def _is_refused(
    task: NearestTask, problem: RodProblem, best: RodOutcome, found: Sequence[RodOutcome]
) -> bool:
    """Have enough starts come to rest where the best rod breaks its limits?"""
    same = (_SAME * task.target.diagonal) ** 2
    return (
        best.violation > MET
        and sum(other.settled and problem.apart(other.point, best.point) < same for other in found) >= _AGREED
    )


def _from_before(task: NearestTask, problem: RodProblem, before: SearchPoint) -> RodOutcome | None:
    """What is found from there, where that meets the limits and is about as near as what all starts found."""
    z = before.seen_from(task.target, problem.grid.unknowns)
    rod = None if z is None else problem.grid.shoot(z)
    if rod is None or not np.isfinite(rod.moments[-1]):
        return None
    found = minimize(problem, rod)
    enough = max(_NEAR, _AS_NEAR * before.off)
    near = task.off(found.point) < enough * task.target.diagonal
    return found if near and found.settled and found.violation <= MET else None


def _concluded(measure: Measure, so_far: Search, found: Sequence[RodOutcome]) -> Search:
    """The search with a leaner rod that is as near as its best, or with the outcomes `found` elsewhere that are."""
    task, problem, best, _, steps, _ = so_far
    free = task.is_scaled_freely or task.is_light
    if free and task.off(best.point) < _FOLLOWED * task.target.diagonal:
        lean = _leaner(task, measure, best)
        if lean is not None:
            tight, problem, best = lean
            return so_far._replace(task=tight, problem=problem, best=best, steps=steps + best.iterations)
    return so_far._replace(ties=tuple(_ties(task, problem, measure, best, found)))


def _leaner(
    task: NearestTask, measure: Measure, best: RodOutcome
) -> tuple[NearestTask, RodProblem, RodOutcome] | None:
    """A rod of the least ratio that the target itself needs, where that is less than the best one's and as near.

    The distance does not see the ratio: on a target that can be met exactly it would stay as the search left it.
    """
    K = best.point.stiffness
    law = None if task.section is None or task.is_light else task.section.law
    try:
        rod = optimal_rod(task.curve, task.gravity, task.supports, task.natural_curvature, section=law)
    except ElasticaError:
        return None
    least = rod.ratio * _SPLINE_STIFFNESS
    if best.violation > MET or least >= float(K.max() / K.min()):
        return None
    try:
        tight = task.within_ratio(least)
        problem = pose_problem(tight, measure)
    except InputError:  # the stiffness is bounded elsewhere too
        return None
    outcome = minimize(problem, _start(tight, problem, stiffness=min(least, 4.0) ** 0.5))
    near = max(task.off(best.point), _LEAN * task.target.diagonal)
    good = outcome.violation <= MET and task.off(outcome.point) <= near
    return (tight, problem, outcome) if good else None


def _ties(
    task: NearestTask, problem: RodProblem, measure: Measure, best: RodOutcome, found: Sequence[RodOutcome]
) -> Iterator[RodOutcome]:
    """Outcomes of another shape than the best one and each other that are as near as it, but for 2 %."""
    allowed = best.objective * (_TIE if measure == "max" else _TIE**2)
    apart = (_APART * task.target.diagonal) ** 2
    told = [best]
    for outcome in sorted(found, key=lambda one: one.objective):
        if not outcome.settled or outcome.violation > MET or outcome.objective > allowed:
            continue
        if all(problem.apart(outcome.point, other.point) > apart for other in told):
            told.append(outcome)
            yield outcome


def _rank(outcome: RodOutcome) -> tuple[bool, float]:
    """What is met comes first, then what is near; what is not met is judged by both."""
    met = outcome.violation <= MET
    return not met, outcome.objective + (0.0 if met else outcome.violation)


class _Route(NamedTuple):
    """A rod to start from, and easier problems whose answers lead on, each searched from that before."""

    rod: MappedRod
    through: Sequence[RodProblem] = ()
    steps: int = STEPS

    def end(self) -> MappedRod:
        """Where it leads."""
        rod = self.rod
        for problem in self.through:
            rod = minimize(problem, rod, steps=self.steps).point
        return rod


class _Attempt(NamedTuple):
    """Where to start from, unless the mean distance found is small `enough`, in diagonals of the target."""

    enough: float
    route: Callable[[], _Route]
    radius: float = 1.0
    most_steps: int = _MOST_STEPS


def _attempts(
    task: NearestTask, measure: Measure, problem: RodProblem, first: MappedRod
) -> Iterator[_Attempt]:
    """Further attempts."""
    for tension in _TENSIONS if task.limits.margin is not None else _TENSIONS[-1:]:
        yield _Attempt(np.inf, partial(_from_pulled, task, problem, tension))
    length = problem.grid.unknowns.length
    if problem.lower[length] < problem.upper[length]:
        yield _Attempt(_FOLLOWS, lambda: _Route(_start(task, problem, length=_LONGER)))
    if measure != "mean":
        yield _Attempt(_FAR, lambda: _Route(first, [pose_problem(task, "mean")]))
    if task.limits.margin is not None:
        yield _Attempt(_FAR, lambda: _Route(first, [pose_problem(task, measure, with_margin=False)]))
    if task.gravity is not None:
        yield _Attempt(_FAR, lambda: _in_steps_of_weight(task, measure))
    yield _Attempt(_FAR, lambda: _Route(_start(task, problem, stiffness=1.0)), 0.3)
    if task.limits.largest_ratio > _EVEN_RATIO and task.limits.stiffness_bounds is None:
        yield _Attempt(_FAR, lambda: _nearly_even(task, measure))
    yield _Attempt(_FAR, lambda: _Route(problem.grid.shoot(_start(task, problem, lifts=_FEW_LIFTS).z)))
    for seed in range(_BENT_STARTS):
        enough = _BENT_ENOUGH if seed < _FIRST_BENT_STARTS else _FAR
        yield _Attempt(enough, partial(_from_bent, task, problem, seed), most_steps=_MOST_STEPS_ELSEWHERE)


def _from_pulled(task: NearestTask, problem: RodProblem, tension: float) -> _Route:
    """From the nearest rod under a force along the chord: taut ones are stable, unloaded ones do not buckle."""
    chord = task.target.position[-1] - task.target.position[0]
    pull = tension * max(task.limits.margin or 0.0, 0.0) * task.even_stiffness
    return _Route(_start(task, problem, force=-pull * chord / max(float(np.hypot(*chord)), _CLOSED)))


def _from_bent(task: NearestTask, problem: RodProblem, seed: int) -> _Route:
    """From the target bent by waves."""
    return _Route(_start(task, problem, lifts=_FEW_LIFTS, seed=seed))


def _nearly_even(task: NearestTask, measure: Measure) -> _Route:
    """By the nearest rod of small stiffness ratio, which leaves out what only a large one can follow."""
    even = replace(task, limits=replace(task.limits, ratio=_EVEN_RATIO))
    problem = pose_problem(even, measure)
    return _Route(_start(even, problem), [problem], _CONTINUATION_STEPS)


def _in_steps_of_weight(task: NearestTask, measure: Measure) -> _Route:
    """From the weightless rod in steps of weight."""
    problems = [pose_problem(task, measure, weight=share) for share in _WEIGHTS]
    return _Route(_start(task, problems[0]), problems, _CONTINUATION_STEPS)


def _start(
    task: NearestTask,
    problem: RodProblem,
    *,
    lifts: int = LIFTS,
    length: float | None = None,
    stiffness: float | None = None,
    seed: int | None = None,
    force: FloatArray | None = None,
) -> MappedRod:
    """The rod that the lifted program finds from the target with constant stiffness, under `force` where given.

    A `seed` bends the target by slow waves and varies the stiffness: for other valleys.
    """
    if stiffness is None:
        stiffness = task.even_stiffness
    grid, target = problem.grid, task.target
    u, n = grid.unknowns, grid.edges
    places = np.concatenate([[0.0], (np.arange(n) + 0.5) / n, [1.0]])
    angles = target.angles(places)
    z = np.zeros(u.count)
    z[u.stiffness] = stiffness
    if seed is not None:
        rng = np.random.default_rng(seed)
        z[u.stiffness] *= rng.uniform(0.5, 2.0, u.coefficients)
        for k in range(1, 6):
            angles += rng.normal(scale=_BENT_RAD / k) * np.sin(np.pi * k * places + rng.uniform(0, 2 * np.pi))
    z[u.position], z[u.angle], z[u.length] = target.position[0], angles[0], 1.0
    if length is not None:
        z[u.length] = length
        problem = problem.with_given(u.length, z[u.length])
    if force is not None:
        problem = problem.with_given(u.force, force)
    z = np.clip(z, problem.lower, problem.upper)
    moments = (grid.basis @ z[u.stiffness]) * (np.diff(angles) / grid.shares - grid.natural_curvature)
    start = grid.assemble(z, angles, moments)
    return lift(replace(problem, distance=task.mean_distance), start, lifts)
