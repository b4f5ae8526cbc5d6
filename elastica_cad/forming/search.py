"""Several ways into the valley: starts and continuations, the best outcome kept."""

from collections.abc import Callable, Iterator

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.forming.setting import Measure, Setting
from elastica_cad.forming.sqp import Outcome, Problem, lifted, solve

__all__ = ["MET", "best_outcome"]

MET = 1e-6  # worst broken limit, in lengths, radians or shares of the limit, that counts as met
_NEAR = 0.03  # mean distance, in diagonals of the wish, below which no other start is tried
_PATIENCE = 40  # steps of one part of a continuation


def best_outcome(setting: Setting, measure: Measure) -> tuple[Problem, Outcome, int]:
    """The problem, the best outcome of all starts, and the number of steps taken in all.

    The first start nearly always does; the others are for what it leaves broken or far from the wish.
    """
    problem = setting.problem(measure)
    first = _start(setting, problem, _middle(setting))
    best = solve(problem, first)
    steps = best.iterations
    for attempt in _attempts(setting, measure, problem, first):
        if (
            best.settled
            and best.violation <= MET
            and mean_distance(setting, best) < _NEAR * setting.wish.diagonal
        ):
            break
        outcome = attempt()
        steps += outcome.iterations
        best = min(best, outcome, key=_rank)
    return problem, best, steps


def mean_distance(setting: Setting, outcome: Outcome) -> float:
    """Root mean square distance, arc length against arc length, in lengths."""
    return float(np.sqrt(2 * setting.problem("mean", with_margin=False).distance.value(outcome.rod)))


def _rank(outcome: Outcome) -> tuple[bool, float]:
    """What is met comes first, then what is near; what is not met is judged by both."""
    met = outcome.violation <= MET
    return not met, outcome.distance + (0.0 if met else outcome.violation)


def _middle(setting: Setting) -> float:
    """A stiffness half way between the least and the largest."""
    return float(np.sqrt(min(setting.limits.largest_ratio, 16.0)))


def _attempts(
    setting: Setting, measure: Measure, problem: Problem, first: FloatArray
) -> Iterator[Callable[[], Outcome]]:
    middle = _middle(setting)
    if measure != "mean":
        yield lambda: solve(problem, solve(setting.problem("mean"), first).rod.z)
    if setting.limits.margin is not None:
        yield lambda: solve(problem, solve(setting.problem(measure, with_margin=False), first).rod.z)
    if setting.gravity is not None:
        yield lambda: _by_weight(setting, measure, middle)
    yield lambda: solve(problem, _start(setting, problem, 1.0, lifts=8))
    yield lambda: solve(problem, _start(setting, problem, middle, lifts=8), radius=0.1)
    if setting.limits.largest_ratio < 8:
        yield lambda: _by_ratio(problem, first)


def _start(setting: Setting, problem: Problem, stiffness: float, *, lifts: int = 3) -> FloatArray:
    """Unknowns that the lifted program finds from the wish itself with constant stiffness."""
    grid, wish = problem.grid, setting.wish
    u, n = grid.unknowns, grid.edges
    angles = wish.angles(np.concatenate([[0.0], (np.arange(n) + 0.5) / n, [1.0]]))
    z = np.zeros(u.count)
    z[u.stiffness] = stiffness
    z[u.position], z[u.angle], z[u.length] = wish.position[0], wish.angle[0], 1.0
    z = np.clip(z, problem.lower, problem.upper)
    moments = (grid.basis @ z[u.stiffness]) * np.diff(angles) / grid.shares
    return lifted(setting.problem("mean", with_margin=False), z, angles, moments, lifts)


def _by_weight(setting: Setting, measure: Measure, stiffness: float) -> Outcome:
    """From the weightless rod in steps of weight."""
    problem = setting.problem(measure, weight=0.0)
    outcome = solve(problem, _start(setting, problem, stiffness), steps=_PATIENCE)
    for weight in (0.25, 0.5, 1.0):
        outcome = solve(setting.problem(measure, weight=weight), outcome.rod.z, steps=_PATIENCE)
    return outcome


def _by_ratio(problem: Problem, first: FloatArray) -> Outcome:
    """From a rod that may vary more, in steps of the ratio."""
    z = first
    for factor in (4.0, 2.0, 1.4, 1.0):
        part = problem.relaxed(factor)
        z = solve(part, z, steps=_PATIENCE).rod.z
    return solve(problem, z)
