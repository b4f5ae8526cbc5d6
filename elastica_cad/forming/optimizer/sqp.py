"""Sequential quadratic programming with a trust region and an exact penalty over points that are nearly closed."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Generic

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import NotConvergedError
from elastica_cad.forming.optimizer.dense_solves import matvec
from elastica_cad.forming.optimizer.exact_point import make_exact, worst_broken
from elastica_cad.forming.optimizer.iterate import (
    ActiveSet,
    Iterate,
    all_equalities,
    close_iterate,
    follow_step,
    iterate_at,
    meet_equalities,
    row_keys,
)
from elastica_cad.forming.optimizer.nonlinear_program import ConstraintRows, NonlinearProgram, Point
from elastica_cad.forming.optimizer.quadratic_program import (
    QuadraticProgram,
    QuadraticSolution,
    solve_quadratic,
)

STEPS = 80  # most quadratic programs of one search: usual ones take less than half
LIFTS = 12  # most lifted steps: they converge quadratically, or not at all
SETTLED = 3e-4  # a step that promises less than this share of the objective ends the search
SMALLEST_RADIUS = 1e-7  # in scales: where longer steps fail, shorter ones are no progress
_DAMPING = 1e-9  # of the largest curvature: keeps the program strictly convex
_IDLE = 1e-2  # share of the objective left that a step of one scale costs where it changes nothing
_EASIEST = 1e-4  # share of the damping that is left where steps keep what they promise
_FAR = 20.0  # radius of the lifted steps, in scales
_CALM = 1e-6  # damping of the first: where several unknowns do, the start takes the least
_CALMED = 0.1  # of the state: a lifted step that changes it by less leaves a point that closes
_WORTHWHILE = 0.7  # a lifted step that leaves more of the objective is the last
_AJAR = 1.0  # of the state: a start that is off by more is closed from its unknowns instead
_ALIKE = 0.1  # of the distance to the optimum known: nearer points lie in the same valley
_SENSITIVE = 100.0  # root of the objective's curvature, per scale: beyond it an unknown is measured finer
_SAME = 0.02  # the same of an optimum that breaks its limits
_BROKEN = 1e-6  # of a constraint's value
_AS_BROKEN = 0.9  # of what is broken at an optimum known: less of it may lead elsewhere
_CLOSER = 0.1  # of its defect: a trial that is off by less is worth more than the point it came from
_ENDED = 1e-5  # of a constraint's value: more is not put right at the end of a search
_STUCK = 0.01  # radius, in scales: where longer steps than it are no use, something else is tried
_WATCHED = 6  # steps by which what is broken must come down
_HOPELESS = 0.5  # share of it that the steps left would put right at that pace: the search ends
_FAR_FROM_MET = 0.02  # of a constraint's value: less is put right at the end, at whatever pace before
_RESOLUTION = 1e-11  # of an objective of order 1 (half a mean square): a micrometre on a strip of 300 mm


@dataclass(frozen=True, eq=False)
class Outcome(Generic[Point]):
    """Where the search ended.

    Attributes
    ----------
    point : Point
        Closed.
    objective, violation : float
    multipliers : tuple of (k,) arrays
        Of every constraint's values: d(objective) / d(value).
    at_lower, at_upper : (p,) arrays
        Multipliers of the box.
    iterations : int
    settled : bool
    """

    point: Point
    objective: float
    violation: float
    multipliers: tuple[FloatArray, ...]
    at_lower: FloatArray
    at_upper: FloatArray
    iterations: int
    settled: bool
    hopeless: bool = False

    @property
    def spent(self) -> int:
        """The steps that it counts for: a search that was given up would have used up all."""
        return STEPS if self.hopeless else self.iterations


def lift(program: NonlinearProgram[Point], start: Point, steps: int = LIFTS) -> Point:
    """A point near one that is far from closed, nearly closed itself.

    The state is an unknown of its own here and its equations are one more constraint, linearised about it: the
    quadratic program is convex whatever the start (its first step weighs the equations' error by its effect on
    the objective).
    """
    program = program.for_open_points()
    point = best = start
    before = least = np.inf
    solution: QuadraticSolution | None = None
    for k in range(steps):
        here = iterate_at(program, point)
        if here is None:
            break
        step, solution = _solve_step(here, _FAR, _damping(here, _CALM, np.inf if k == 0 else _IDLE), solution)
        if step is None or solution is None:
            break
        change = np.append(step, 1.0)
        point = here.local.moved(change)
        after = program.objective(point)
        changed = float(np.abs(matvec(here.local.state_jacobian, change)).max())
        # second order in the change of state is what closing the point may add to its distance
        if (rank := float(np.sqrt(2 * after)) + 0.1 * changed**2) < least:
            best, least = point, rank
        if changed < _CALMED and after > _WORTHWHILE * before - _RESOLUTION:
            break
        before = after
    return best


def minimize(
    program: NonlinearProgram[Point],
    start: Point,
    *,
    steps: int = STEPS,
    radius: float = 1.0,
    known: Sequence[Outcome[Point]] = (),
) -> Outcome[Point]:
    """The local minimum downhill from a point that need not be closed; of what is `known` that of the same valley.

    The local model of the objective, linearised constraints with prices, a box of size `radius` (in scales),
    one quadratic program a step. The state follows a step with the unknowns (see `follow_step`); the merit's
    prices follow the multipliers (Powell's rule).

    Raises
    ------
    NotConvergedError
        When no point is found to begin with.
    """
    here = _begin(program, start)
    prices = np.zeros(program.highest_prices.size)
    active = all_equalities(here)
    found: tuple[ConstraintRows, QuadraticSolution] | None = None
    settled, iteration, ease = False, 0, 1.0
    broken, hopeless = [here.violation], False
    ended: Point | None = None
    while iteration < steps and not (settled or hopeless) and radius > SMALLEST_RADIUS:
        for other in known:
            if _leads_to(here, other):
                return replace(other, iterations=iteration)
        iteration += 1
        floor = SETTLED * here.objective + _RESOLUTION
        damping = _damping(here, _DAMPING, _IDLE)
        accepted = False
        while not accepted and radius > SMALLEST_RADIUS:
            step, solution = _solve_step(here, radius, ease * damping, None if found is None else found[1])
            if step is None or solution is None:
                radius *= 0.25
                continue
            found = here.local.rows, solution
            prices = _prices(program, here.local.rows, solution, prices)
            merit = here.merit(prices)
            promised = merit - here.predicted_merit(step, prices)
            size = float(np.abs(step / program.scale).max())
            worth, highest = max(promised, floor), float(prices.max(initial=0.0))
            reliable = here.is_reliable(worth, highest)
            settled = reliable and promised <= floor and not here.restores_feasibility(step)
            if settled and promised < -floor and radius > _STUCK:
                # a step for the worse solves no program: a shorter one, damped, is found better
                settled, ease, radius = False, 1.0, 0.25 * radius
                continue
            if settled and (ended := _last_point(here, step, prices, merit - 1e-4 * worth)) is not None:
                break
            touched = _touched(here, step, solution)
            trial = follow_step(here, np.append(step, 1.0), touched, worth, highest)
            gain = -np.inf if trial is None else (merit - trial.merit(prices)) / worth
            accepted = gain > 1e-4
            if trial is not None and accepted:
                here, active = trial, touched
            elif not reliable:
                # the merit that the trial did not come up to may be that of a point that does not close so
                nearer = _closer(here, trial, active, radius, worth, highest)
                if nearer is not None:
                    here, accepted = nearer, True
                    continue
            if settled:
                break
            if gain > 0.75:
                radius, ease = max(radius, min(5.0, 2 * size)), max(0.1 * ease, _EASIEST)
            elif gain < 0.25:
                radius, ease = (0.5 if accepted else 0.3) * size, 1.0
        broken.append(here.violation)
        hopeless = not settled and _is_hopeless(broken, steps - iteration)
    point = ended or close_iterate(here, active) or program.close(here.local.point) or program.fallback()
    point = make_exact(program, point)
    values = program.values(point)
    multipliers, low, high = _multipliers(program, values, found)
    return Outcome(
        point, program.objective(point), worst_broken(program, values), multipliers, low, high, iteration, settled,
        hopeless,
    )  # fmt: skip


def _begin(program: NonlinearProgram[Point], start: Point) -> Iterate[Point]:
    """Where the search begins: at a point as it is given, or where that does not close, at that of its unknowns."""
    point = program.clip(start)
    found = iterate_at(program, point)
    if found is not None:
        here = meet_equalities(found)
        if here.defect < _AJAR:
            return here
    for other in (program.close(point), program.fallback()):
        found = None if other is None else iterate_at(program, other)
        if found is not None:
            return found
    raise NotConvergedError("no rod is found to begin with: draw a smoother curve, or a shorter one")


def _leads_to(here: Iterate[Point], known: Outcome[Point]) -> bool:
    """Is the search so near what it found before, and no nearer to meeting its limits, that it ends there again?"""
    # what breaks its limits may have come to rest on a saddle: such a point is left from quite near
    alike = _ALIKE if known.violation < _BROKEN else _SAME
    near = here.program.apart(here.local.point, known.point) < alike**2 * known.objective
    return near and here.violation >= _AS_BROKEN * known.violation


def _last_point(here: Iterate[Point], step: FloatArray, prices: FloatArray, enough: float) -> Point | None:
    """The closed point after the last step, whose state is shot anew; None where its merit is not low `enough`.

    What is broken there is left to the end of the search, which puts little right.
    """
    program = here.program
    point = program.close(here.local.point, step)
    if point is None:
        return None
    values = program.values(point)
    if worst_broken(program, values) > _ENDED:
        return None
    broken = (
        float((np.maximum(-value, 0.0) if one_sided else np.abs(value)).sum())
        for value, one_sided in zip(values, program.one_sided, strict=True)
    )
    merit = program.objective(point) + sum(p * b for p, b in zip(prices, broken, strict=True))
    return point if merit < enough else None


def _closer(
    here: Iterate[Point], trial: Iterate[Point] | None, active: ActiveSet, radius: float, promise: float,
    highest_price: float,
) -> Iterate[Point] | None:  # fmt: skip
    """Where to go on from a point that is not closed: itself, closed, or a trial that is, whatever its merit.

    Where steps have become short without leading anywhere, the closed point of its unknowns.
    """
    found = follow_step(here, here.change, active, promise, highest_price)
    if found is None and trial is not None and trial.defect < _CLOSER * here.defect:
        return trial
    if found is None and radius < _STUCK:
        point = here.program.close(here.local.point)
        return None if point is None else iterate_at(here.program, point)
    return found


def _is_hopeless(broken: Sequence[float], left: int) -> bool:
    """Will what is `broken` step by step stay so in the steps that are left, at the pace of the last ones?"""
    if len(broken) <= _WATCHED or broken[-1] < _FAR_FROM_MET:
        return False
    pace = (max(broken[-1 - _WATCHED : -_WATCHED // 2]) - broken[-1]) / _WATCHED
    return pace * left < _HOPELESS * broken[-1]


def _touched(here: Iterate[Point], step: FloatArray, solution: QuadraticSolution) -> ActiveSet:
    """Equalities and the limits that a step touches, where it leads."""
    rows = here.local.rows
    y = solution.row_multipliers[: rows.value.size]
    touched = ~rows.one_sided | (y > 1e-6 * rows.price)
    return ActiveSet(row_keys(rows)[touched], (rows.value + rows.jacobian @ step)[touched])


def _solve_step(
    here: Iterate[Point], radius: float, damping: float, near: QuadraticSolution | None
) -> tuple[FloatArray | None, QuadraticSolution | None]:
    """The step of the quadratic program within `radius` scales, and its solution in scales; `near` is the last."""
    program, local = here.program, here.local
    rows, model, z = local.rows, local.model, local.z
    s = program.scale
    p = z.size
    # what the objective is very sensitive to is measured finer: it would set how well the others are solved for
    fine = np.sqrt(np.maximum(1.0, model.hessian.diagonal() * (s / _SENSITIVE) ** 2))
    s = s / fine
    hessian = model.hessian * np.outer(s, s)
    hessian.flat[:: p + 1] += damping / fine**2
    lower = np.maximum((program.lower - z) / s, -radius * fine)
    upper = np.minimum((program.upper - z) / s, radius * fine)
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
        QuadraticProgram(hessian, gradient, lower, upper, jacobian, -value, price, one_sided), near=near
    )
    if not np.all(np.isfinite(solution.x)):
        return None, None
    if fine.max() == 1.0:
        return solution.x[:p] * s, solution
    back = np.append(fine, np.ones(solution.x.size - p))
    in_scales = replace(
        solution, x=solution.x / back, lower_multipliers=solution.lower_multipliers * back,
        upper_multipliers=solution.upper_multipliers * back,
    )  # fmt: skip
    return solution.x[:p] * s, in_scales


def _damping(here: Iterate[Point], most: float, share: float) -> float:
    """Against long steps that change nothing: less and less as the objective comes down."""
    most *= float(here.local.model.hessian.diagonal().max())
    if here.local.model.peaks.size or not np.isfinite(share):
        return most
    return min(most, max(share * here.program.objective(here.local.point), 1e-16))


def _prices(
    program: NonlinearProgram[Point], rows: ConstraintRows, solution: QuadraticSolution, before: FloatArray
) -> FloatArray:
    """Prices for the merit: half as much again as the multipliers, falling step by step (Powell's rule)."""
    y = np.abs(solution.row_multipliers[: rows.value.size])
    largest = np.zeros_like(before)
    np.maximum.at(largest, rows.constraint, 1.5 * y)
    return np.minimum(program.highest_prices, np.maximum(largest, 0.1 * before))


def _multipliers(
    program: NonlinearProgram[Point],
    values: Sequence[FloatArray],
    found: tuple[ConstraintRows, QuadraticSolution] | None,
) -> tuple[tuple[FloatArray, ...], FloatArray, FloatArray]:
    """d(objective) / d(value) of every constraint and of the box, from the last quadratic program."""
    p = program.scale.size
    out = [np.zeros_like(v) for v in values]
    if found is None:
        return tuple(out), np.zeros(p), np.zeros(p)
    rows, solution = found
    for k, i, y in zip(rows.constraint, rows.index, solution.row_multipliers, strict=False):
        out[k][i] = y
    return (
        tuple(out),
        solution.lower_multipliers[:p] / program.scale,
        solution.upper_multipliers[:p] / program.scale,
    )
