"""Several ways into the valley: starts and continuations, the best outcome kept."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from elastica_cad.forming.march import MarchedRod
from elastica_cad.forming.problem import Problem
from elastica_cad.forming.setting import Measure, Setting
from elastica_cad.forming.sqp import LIFTS, Outcome, lifted, solve

__all__ = ["MET", "best_outcome"]

MET = 1e-6  # worst broken limit, in lengths, radians or shares of the limit, that counts as met
_MOST_STEPS = 160  # in all, after which no new attempt is begun
_EVEN = 1.4  # ratio of a rod that is nearly even
_FEW = 3  # lifted steps after which a hard wish is still open to several valleys
_PATIENCE = 40  # steps of one part of a continuation


def best_outcome(setting: Setting, measure: Measure) -> tuple[Problem, Outcome, int]:
    """The problem, the best outcome of all starts, and the number of steps taken in all.

    The first start nearly always does; the others are for what it leaves broken, unsettled or far from the wish.
    """
    problem = setting.problem(measure)
    first = _start(setting, problem)
    best = solve(problem, first)
    steps = best.iterations
    for attempt in _attempts(setting, measure, problem, first):
        done = best.settled and best.violation <= MET
        near = mean_distance(setting, best) < attempt.enough * setting.wish.diagonal
        if steps > _MOST_STEPS or (done and near):
            break
        known = best if done and measure != "max" else None
        outcome = solve(problem, attempt.start(), radius=attempt.radius, known=known)
        steps += outcome.iterations
        best = min(best, outcome, key=_rank)
    return problem, best, steps


def mean_distance(setting: Setting, outcome: Outcome) -> float:
    """Root mean square distance, arc length against arc length, in lengths."""
    return float(np.sqrt(2 * setting.distance("mean").value(outcome.rod)))


def _rank(outcome: Outcome) -> tuple[bool, float]:
    """What is met comes first, then what is near; what is not met is judged by both."""
    met = outcome.violation <= MET
    return not met, outcome.distance + (0.0 if met else outcome.violation)


class _Attempt(NamedTuple):
    """Where to start from, unless the mean distance found is small `enough`, in diagonals of the wish."""

    enough: float
    start: Callable[[], MarchedRod]
    radius: float = 1.0


def _attempts(setting: Setting, measure: Measure, problem: Problem, first: MarchedRod) -> Iterator[_Attempt]:
    """Further attempts."""
    yield _Attempt(0.015, lambda: _start(setting, problem, same_length=True))
    if measure != "mean":
        yield _Attempt(0.03, lambda: solve(setting.problem("mean"), first).rod)
    if setting.limits.margin is not None:
        yield _Attempt(0.03, lambda: solve(setting.problem(measure, with_margin=False), first).rod)
    if setting.gravity is not None:
        yield _Attempt(0.03, lambda: _half_the_weight(setting, measure))
    yield _Attempt(0.03, lambda: _start(setting, problem, stiffness=1.0), 0.3)
    if setting.limits.largest_ratio > _EVEN and setting.limits.stiffness_bounds is None:
        yield _Attempt(0.03, lambda: _nearly_even(setting, measure))
    yield _Attempt(0.03, lambda: problem.grid.rod(_start(setting, problem, lifts=_FEW).z))


def _start(
    setting: Setting,
    problem: Problem,
    *,
    lifts: int = LIFTS,
    same_length: bool = False,
    stiffness: float | None = None,
) -> MarchedRod:
    """The rod that the lifted program finds from the wish itself with constant stiffness."""
    if stiffness is None:
        stiffness = float(np.sqrt(min(setting.limits.largest_ratio, 16.0)))
    grid, wish = problem.grid, setting.wish
    u, n = grid.unknowns, grid.edges
    angles = wish.angles(np.concatenate([[0.0], (np.arange(n) + 0.5) / n, [1.0]]))
    z = np.zeros(u.count)
    z[u.stiffness] = stiffness
    z[u.position], z[u.angle], z[u.length] = wish.position[0], wish.angle[0], 1.0
    if same_length:
        problem = problem.with_length(z[u.length])
    z = np.clip(z, problem.lower, problem.upper)
    moments = (grid.basis @ z[u.stiffness]) * np.diff(angles) / grid.shares
    return lifted(replace(problem, distance=setting.distance("mean")), z, angles, moments, lifts)


def _nearly_even(setting: Setting, measure: Measure) -> MarchedRod:
    """The nearest rod of little ratio: what it cannot follow it does not try to."""
    even = replace(setting, limits=replace(setting.limits, ratio=_EVEN))
    problem = even.problem(measure)
    return solve(problem, _start(even, problem), steps=_PATIENCE).rod


def _half_the_weight(setting: Setting, measure: Measure) -> MarchedRod:
    """From the weightless rod in steps of weight."""
    problem = setting.problem(measure, weight=0.0)
    rod = _start(setting, problem)
    for weight in (0.0, 0.25, 0.5):
        rod = solve(setting.problem(measure, weight=weight), rod, steps=_PATIENCE).rod
    return rod
