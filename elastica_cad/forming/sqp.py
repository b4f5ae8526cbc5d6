"""Sequential quadratic programming with a trust region and an exact penalty over rods that stay in balance."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import NotConvergedError
from elastica_cad.forming.constraints import Constraint
from elastica_cad.forming.dense import applied
from elastica_cad.forming.march import MarchedRod
from elastica_cad.forming.place import (
    Held,
    Place,
    balanced,
    equalities,
    followed,
    meeting_equalities,
    moved,
    place,
)
from elastica_cad.forming.problem import Problem, Rows, rows_near
from elastica_cad.forming.qp import QuadraticProgram, QuadraticSolution, solve_quadratic

__all__ = ["LIFTS", "Outcome", "lifted", "solve"]

STEPS = 80
LIFTS = 12
SETTLED = 3e-4  # a step that promises less than this share of the distance ends the search
CLOSED = 1e-9  # what a limit that is touched keeps in hand
SMALLEST_RADIUS = 1e-7
_TOUCHED = 1e-3
_DAMPING = 1e-9
_IDLE = 1e-2  # share of the distance left that a step of one scale costs where it changes nothing
_EASIEST = 1e-4  # share of the damping that is left where steps keep what they promise
_FAR = 20.0  # radius of the lifted steps
_CALM = 1e-6  # where several forces do, the start takes the least: the likeliest to be stable
_CALMED = 0.1  # rad: a lifted step that turns no edge further leaves a rod that closes
_WORTHWHILE = 0.7  # a lifted step that leaves more of the distance is the last
_AJAR = 1.0  # rad
_ALIKE = 0.1
_FIRM = 1e4  # times what is missed: no step that mends it is longer, no multiplier larger
_RESOLUTION = 1e-11  # of half the mean square distance: a micrometre on a strip of 300 mm


@dataclass(frozen=True, eq=False)
class Outcome:
    """Where the search ended.

    Attributes
    ----------
    rod : MarchedRod
    distance, violation : float
    multipliers : tuple of (k,) arrays
        Of every constraint's values: d(distance) / d(value).
    at_lower, at_upper : (p,) arrays
        Multipliers of the box.
    iterations : int
    settled : bool
    """

    rod: MarchedRod
    distance: float
    violation: float
    multipliers: tuple[FloatArray, ...]
    at_lower: FloatArray
    at_upper: FloatArray
    iterations: int
    settled: bool


def lifted(
    problem: Problem, z: FloatArray, angles: FloatArray, moments: FloatArray, steps: int = LIFTS
) -> MarchedRod:
    """A rod near given angles (n+2,) and moments (n+1,) that are not in balance, nearly in balance itself.

    Angles and moments are unknowns of their own here and the march is one more constraint, linearised about
    them: the start may be the wish itself, and the program is convex whatever the wish (the first step weighs
    the equation's error K kappa - M by its effect on the shape).
    """
    problem = problem.eager()
    rod = best = problem.grid.guessed(z, angles, moments)
    before = least = np.inf
    for k in range(steps):
        here = place(problem, rod)
        if here is None:
            break
        damping = _damping(here, _CALM, np.inf if k == 0 else _IDLE)
        step, solution = _step(here, _FAR, damping)
        if step is None or solution is None:
            break
        change = np.append(step, 1.0)
        rod = moved(here, change)
        after = problem.distance.value(rod)
        turned = float(np.abs(applied(here.sensitivities.angles, change)).max())
        # second order in the turn is what closing the rod may add to its distance
        if (rank := float(np.sqrt(2 * after)) + 0.1 * turned**2) < least:
            best, least = rod, rank
        if turned < _CALMED and after > _WORTHWHILE * before - _RESOLUTION:
            break
        before = after
    return best


def solve(
    problem: Problem,
    start: MarchedRod,
    *,
    steps: int = STEPS,
    radius: float = 1.0,
    known: Outcome | None = None,
) -> Outcome:
    """The local minimum downhill from a rod that need not be in balance; `known` where that is the same valley.

    The Gauss-Newton model of the distance, linearised constraints with prices, a box of size `radius` (in
    scales), one quadratic program a step. The whole rod follows a step, angles and moments as well (see
    `followed`); the merit's prices follow the multipliers (Powell's rule).
    """
    here = _first(problem, start)
    prices = np.zeros(len(problem.constraints))
    held = equalities(here)
    found: tuple[Rows, QuadraticSolution] | None = None
    settled, iteration, ease = False, 0, 1.0
    while iteration < steps and not settled and radius > SMALLEST_RADIUS:
        if known is not None and _like(here.rod, known):
            return replace(known, iterations=iteration)
        iteration += 1
        floor = SETTLED * here.distance + _RESOLUTION
        damping = ease * _damping(here, _DAMPING, _IDLE)
        accepted = False
        while not accepted and radius > SMALLEST_RADIUS:
            step, solution = _step(here, radius, damping)
            if step is None or solution is None:
                radius *= 0.25
                continue
            found = here.rows, solution
            prices = _prices(problem, here.rows, solution, prices)
            merit = here.merit(prices)
            promised = merit - here.promised(step, prices)
            size = float(np.abs(step / problem.scale).max())
            worth, dearest = max(promised, floor), float(prices.max(initial=0.0))
            told = here.tells(worth, dearest)
            settled = told and promised <= floor and not here.mends(step)
            touched = _touched(here, step, solution)
            trial = followed(here, np.append(step, 1.0), touched, worth, dearest)
            gain = -np.inf if trial is None else (merit - trial.merit(prices)) / worth
            accepted = gain > 1e-4
            if trial is not None and accepted:
                here, held = trial, touched
            elif not told:
                # what the trial did not come up to may be the merit of a rod that does not close so
                nearer = followed(here, here.change, held, worth, dearest)
                if nearer is not None:
                    here, accepted = nearer, True
                    continue
            if settled:
                break
            if gain > 0.75:
                radius, ease = max(radius, min(5.0, 2 * size)), max(0.1 * ease, _EASIEST)
            elif gain < 0.25:
                radius, ease = (0.5 if accepted else 0.3) * size, 1.0
    rod = balanced(here, held)
    if rod is None:
        rod = problem.grid.rod(here.rod.z)
    if not np.isfinite(rod.moments[-1]):
        rod = _slack(problem)
    rod = _closed(problem, rod)
    values = problem.values(rod)
    multipliers, low, high = _multipliers(problem, values, found)
    return Outcome(
        rod, problem.distance.value(rod), problem.violation(values), multipliers, low, high, iteration, settled
    )  # fmt: skip


def _like(rod: MarchedRod, known: Outcome) -> bool:
    """Is a rod far nearer to a known one than that is to the wish?"""
    apart = float(np.mean((rod.position - known.rod.position) ** 2))
    return apart < _ALIKE**2 * known.distance


def _first(problem: Problem, start: MarchedRod) -> Place:
    """Where the search begins: at a rod as it is given, or where that closes nowhere, as it is marched."""
    rod = problem.grid.guessed(problem.inside(start.z), start.angles, start.moments)
    found = place(problem, rod)
    if found is not None:
        here = meeting_equalities(found)
        if here.off < _AJAR:
            return here
    for other in (problem.grid.rod(rod.z), _slack(problem)):
        found = place(problem, other)
        if found is not None:
            return found
    raise NotConvergedError("no rod is found to begin with: draw a smoother curve, or a shorter one")


def _slack(problem: Problem) -> MarchedRod:
    """A rod without forces: where nothing else closes, here something can be said."""
    u = problem.grid.unknowns
    z = np.zeros(u.count)
    z[u.stiffness], z[u.length] = 1.0, 1.0
    return problem.grid.rod(problem.inside(z))


def _touched(here: Place, step: FloatArray, solution: QuadraticSolution) -> Held:
    """Equalities and the limits that a step touches, where it leads."""
    rows = here.rows
    y = solution.row_multipliers[: rows.value.size]
    touched = ~rows.one_sided | (y > 1e-6 * rows.price)
    return Held(rows.keys[touched], (rows.value + rows.jacobian @ step)[touched])


def _step(here: Place, radius: float, damping: float) -> tuple[FloatArray | None, QuadraticSolution | None]:
    """The step of the quadratic program within `radius` scales, and its solution in scales."""
    problem, rows, model, z = here.problem, here.rows, here.model, here.rod.z
    s = problem.scale
    p = z.size
    hessian = model.hessian * np.outer(s, s)
    hessian[np.diag_indices(p)] += damping
    lower = np.maximum((problem.lower - z) / s, -radius)
    upper = np.minimum((problem.upper - z) / s, radius)
    jacobian, value = rows.jacobian * s, rows.value
    gradient, price, one_sided = model.gradient * s, rows.price, rows.one_sided
    if model.peaks.size:
        # one more unknown t >= every peak; its rows cannot be worth breaking
        k, top = model.peaks.size, float(model.peaks.max())
        grown = np.zeros((p + 1, p + 1))
        grown[:p, :p] = hessian
        hessian, gradient = grown, np.append(gradient, 1.0)
        lower, upper = np.append(lower, -2 * top - 1e-9), np.append(upper, 2 * top + 1e-9)
        jacobian = np.block([[jacobian, np.zeros((value.size, 1))], [-model.peak_rows * s, np.ones((k, 1))]])
        value = np.append(value, top - model.peaks)
        price = np.append(price, np.full(k, 10.0))
        one_sided = np.append(one_sided, np.ones(k, dtype=bool))
    solution = solve_quadratic(
        QuadraticProgram(hessian, gradient, lower, upper, jacobian, -value, price, one_sided)
    )
    if not np.all(np.isfinite(solution.x)):
        return None, None
    return solution.x[:p] * s, solution


def _damping(here: Place, most: float, share: float) -> float:
    """Against long steps that change nothing: less and less as the rod comes near."""
    most *= float(np.diag(here.model.hessian).max())
    if here.model.peaks.size or not np.isfinite(share):
        return most
    return min(most, max(share * here.problem.distance.value(here.rod), 1e-16))


def _prices(problem: Problem, rows: Rows, solution: QuadraticSolution, before: FloatArray) -> FloatArray:
    """Prices for the merit: half as much again as the multipliers, falling step by step (Powell's rule)."""
    y = np.abs(solution.row_multipliers[: rows.value.size])
    largest = np.zeros_like(before)
    np.maximum.at(largest, rows.constraint, 1.5 * y)
    return np.minimum([c.price for c in problem.constraints], np.maximum(largest, 0.1 * before))


def _closed(problem: Problem, rod: MarchedRod) -> MarchedRod:
    """Newton's method on the equalities and on the limits that are touched, by least steps of what is free."""
    values = problem.values(rod)
    for k in range(6):
        if not any(_missed(c, v) for c, v in zip(problem.constraints, values, strict=True)):
            return rod
        rows = rows_near(problem, problem.grid.sensitivities(rod), values)
        aim = np.where(rows.one_sided, np.maximum(CLOSED - rows.value, 0.0), -rows.value)
        if np.abs(aim).max() > 1e-3:
            return rod
        step = _least(problem, rows, rod.z, aim) if k == 0 else _least_within(problem, rows, rod.z, aim)
        trial = problem.grid.rod(problem.inside(rod.z + step))
        if not np.isfinite(trial.moments[-1]):
            return rod
        trial_values = problem.values(trial)
        if problem.violation(trial_values) < problem.violation(values):
            rod, values = trial, trial_values
        elif k > 0:
            return rod
    return rod


def _least(problem: Problem, rows: Rows, z: FloatArray, aim: FloatArray) -> FloatArray:
    """The least step that changes equalities by `aim`, and the limits that are touched."""
    touched, free = ~rows.one_sided | (rows.value < _TOUCHED), problem.free(z)
    s, step = problem.scale[free], np.zeros(z.size)
    step[free] = np.linalg.lstsq(rows.jacobian[np.ix_(touched, free)] * s, aim[touched], rcond=1e-10)[0] * s
    return step


def _least_within(problem: Problem, rows: Rows, z: FloatArray, aim: FloatArray) -> FloatArray:
    """The same where more limits are touched than can be held: none is left broken."""
    s, unit, p = problem.scale, float(np.abs(aim).max()), z.size
    right = np.where(rows.one_sided, CLOSED - rows.value, -rows.value)
    solution = solve_quadratic(
        QuadraticProgram(
            np.eye(p), np.zeros(p), np.maximum((problem.lower - z) / s / unit, -_FIRM),
            np.minimum((problem.upper - z) / s / unit, _FIRM), rows.jacobian * s, right / unit,
            np.full(right.size, _FIRM), rows.one_sided,
        ),
        accuracy=1e-6,
    )  # fmt: skip
    return np.asarray(solution.x * s * unit)


def _missed(constraint: Constraint, values: FloatArray) -> bool:
    """Is an equality, or what a limit should keep in hand, missed by more than rounding?"""
    gap = CLOSED - values.min() if constraint.one_sided else np.abs(values).max()
    return bool(gap > 1e-13)


def _multipliers(
    problem: Problem, values: Sequence[FloatArray], found: tuple[Rows, QuadraticSolution] | None
) -> tuple[tuple[FloatArray, ...], FloatArray, FloatArray]:
    """d(distance) / d(value) of every constraint and of the box, from the last quadratic program."""
    p = problem.scale.size
    out = [np.zeros_like(v) for v in values]
    if found is None:
        return tuple(out), np.zeros(p), np.zeros(p)
    rows, solution = found
    for k, i, y in zip(rows.constraint, rows.index, solution.row_multipliers, strict=False):
        out[k][i] = y
    return (
        tuple(out),
        solution.lower_multipliers[:p] / problem.scale,
        solution.upper_multipliers[:p] / problem.scale,
    )
