"""Starts and continuations of the search for the nearest rod; the best outcome is kept."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import NamedTuple, TypeAlias

import numpy as np

from elastica_cad.forming.nearest.nearest_task import Measure, NearestTask
from elastica_cad.forming.nearest.rod_map import MappedRod
from elastica_cad.forming.nearest.rod_problem import RodProblem
from elastica_cad.forming.optimizer.sqp import LIFTS, Outcome, lift, minimize

RodOutcome: TypeAlias = Outcome[MappedRod]

MET = 1e-6  # worst broken limit, in lengths, radians or shares of the limit, that counts as met
_MOST_STEPS = 160  # in all, after which no new attempt is begun: two searches that use up their steps
_EVEN_RATIO = 1.4  # of a rod that is nearly even
_FEW_LIFTS = 3  # after which a start from a hard target is still open to several valleys
_CONTINUATION_STEPS = 40  # of one part of a continuation, which need not settle


def search(task: NearestTask, measure: Measure) -> tuple[RodProblem, RodOutcome, int]:
    """The problem, the best outcome of all starts, and the number of steps taken in all.

    The first start nearly always does; the others are for what it leaves broken, unsettled or far from the target.
    """
    problem = task.problem(measure)
    first = _start(task, problem)
    best = minimize(problem, first)
    steps = best.iterations
    for attempt in _attempts(task, measure, problem, first):
        done = best.settled and best.violation <= MET
        near = mean_distance(task, best) < attempt.enough * task.target.diagonal
        if steps > _MOST_STEPS or (done and near):
            break
        known = best if done and measure != "max" else None
        outcome = minimize(problem, attempt.start(), radius=attempt.radius, known=known)
        steps += outcome.iterations
        best = min(best, outcome, key=_rank)
    return problem, best, steps


def mean_distance(task: NearestTask, outcome: RodOutcome) -> float:
    """Root mean square distance, arc length against arc length, in lengths."""
    return float(np.sqrt(2 * task.distance("mean").value(outcome.point)))


def _rank(outcome: RodOutcome) -> tuple[bool, float]:
    """What is met comes first, then what is near; what is not met is judged by both."""
    met = outcome.violation <= MET
    return not met, outcome.objective + (0.0 if met else outcome.violation)


class _Attempt(NamedTuple):
    """Where to start from, unless the mean distance found is small `enough`, in diagonals of the target."""

    enough: float
    start: Callable[[], MappedRod]
    radius: float = 1.0


def _attempts(
    task: NearestTask, measure: Measure, problem: RodProblem, first: MappedRod
) -> Iterator[_Attempt]:
    """Further attempts."""
    yield _Attempt(0.015, lambda: _start(task, problem, same_length=True))
    if measure != "mean":
        yield _Attempt(0.03, lambda: minimize(task.problem("mean"), first).point)
    if task.limits.margin is not None:
        yield _Attempt(0.03, lambda: minimize(task.problem(measure, with_margin=False), first).point)
    if task.gravity is not None:
        yield _Attempt(0.03, lambda: _half_the_weight(task, measure))
    yield _Attempt(0.03, lambda: _start(task, problem, stiffness=1.0), 0.3)
    if task.limits.largest_ratio > _EVEN_RATIO and task.limits.stiffness_bounds is None:
        yield _Attempt(0.03, lambda: _nearly_even(task, measure))
    yield _Attempt(0.03, lambda: problem.grid.shoot(_start(task, problem, lifts=_FEW_LIFTS).z))


def _start(
    task: NearestTask,
    problem: RodProblem,
    *,
    lifts: int = LIFTS,
    same_length: bool = False,
    stiffness: float | None = None,
) -> MappedRod:
    """The rod that the lifted program finds from the target itself with constant stiffness."""
    if stiffness is None:
        stiffness = float(np.sqrt(min(task.limits.largest_ratio, 16.0)))
    grid, target = problem.grid, task.target
    u, n = grid.unknowns, grid.edges
    angles = target.angles(np.concatenate([[0.0], (np.arange(n) + 0.5) / n, [1.0]]))
    z = np.zeros(u.count)
    z[u.stiffness] = stiffness
    z[u.position], z[u.angle], z[u.length] = target.position[0], target.angle[0], 1.0
    if same_length:
        problem = problem.with_length(z[u.length])
    z = np.clip(z, problem.lower, problem.upper)
    moments = (grid.basis @ z[u.stiffness]) * np.diff(angles) / grid.shares
    start = grid.assemble(z, angles, moments)
    return lift(replace(problem, distance=task.distance("mean")), start, lifts)


def _nearly_even(task: NearestTask, measure: Measure) -> MappedRod:
    """The nearest rod of small stiffness ratio, which leaves out what only a large one can follow."""
    even = replace(task, limits=replace(task.limits, ratio=_EVEN_RATIO))
    problem = even.problem(measure)
    return minimize(problem, _start(even, problem), steps=_CONTINUATION_STEPS).point


def _half_the_weight(task: NearestTask, measure: Measure) -> MappedRod:
    """From the weightless rod in steps of weight."""
    problem = task.problem(measure, weight=0.0)
    rod = _start(task, problem)
    for weight in (0.0, 0.25, 0.5):
        rod = minimize(task.problem(measure, weight=weight), rod, steps=_CONTINUATION_STEPS).point
    return rod
