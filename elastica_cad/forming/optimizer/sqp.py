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
from elastica_cad.forming.optimizer.quadratic_program import QuadraticSolution
from elastica_cad.forming.optimizer.step_program import damping_of, solve_step

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
_SAME = 0.02  # of the distance to an optimum known that breaks its limits
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
        step, solution = solve_step(
            here, _FAR, damping_of(here, _CALM, np.inf if k == 0 else _IDLE), solution
        )
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
    walk = _Walk(_begin(program, start), np.zeros(program.highest_prices.size), radius)
    iteration, broken, hopeless = 0, [walk.here.violation], False
    while iteration < steps and walk.goes_on and not hopeless:
        for other in known:
            if _leads_to(walk.here, other):
                return replace(other, iterations=iteration)
        iteration += 1
        walk.advance()
        broken.append(walk.here.violation)
        hopeless = not walk.settled and _is_hopeless(broken, steps - iteration)
    point = make_exact(program, walk.end())
    values = program.values(point)
    multipliers, low, high = _multipliers(program, values, walk.solved)
    return Outcome(
        point, program.objective(point), worst_broken(program, values), multipliers, low, high, iteration,
        walk.settled, hopeless,
    )  # fmt: skip


@dataclass(eq=False)
class _Walk(Generic[Point]):
    """A search from one iterate to the next, and what it has learned on the way.

    Attributes
    ----------
    here : Iterate
    prices : (c,) array
        Of every constraint in the merit.
    radius : float
        Of the trust region, in scales.
    damping_share : float
        Of the full damping: falls where steps keep what they promise.
    solved : pair of ConstraintRows and QuadraticSolution, or None
        The last quadratic program.
    settled : bool
        Does no step promise more than the search resolves?
    active : ActiveSet
        What the last step touched.
    last : Point or None
        The closed point after the last step, where it was worth taking.
    """

    here: Iterate[Point]
    prices: FloatArray
    radius: float
    damping_share: float = 1.0
    solved: tuple[ConstraintRows, QuadraticSolution] | None = None
    settled: bool = False
    last: Point | None = None

    def __post_init__(self) -> None:
        self.active = all_equalities(self.here)

    @property
    def goes_on(self) -> bool:
        """Is there a step left to try?"""
        return not self.settled and self.radius > SMALLEST_RADIUS

    def advance(self) -> None:
        """Steps within smaller and smaller radii, until one is taken or none is worth it."""
        floor = SETTLED * self.here.objective + _RESOLUTION
        damping = damping_of(self.here, _DAMPING, _IDLE)
        while self.radius > SMALLEST_RADIUS and not self._try_step(floor, damping):
            pass

    def end(self) -> Point:
        """The closed point where it ended."""
        here = self.here
        program = here.program
        return (
            self.last
            or close_iterate(here, self.active)
            or program.close(here.local.point)
            or program.fallback()
        )

    def _try_step(self, floor: float, damping: float) -> bool:
        """One step of the quadratic program; False asks for another, within the radius as it is then."""
        here, near = self.here, None if self.solved is None else self.solved[1]
        step, solution = solve_step(here, self.radius, self.damping_share * damping, near)
        if step is None or solution is None:
            self.radius *= 0.25
            return False
        self.solved = here.local.rows, solution
        self.prices = _prices(here.program, here.local.rows, solution, self.prices)
        merit = here.merit(self.prices)
        promised = merit - here.predicted_merit(step, self.prices)
        worth, highest = max(promised, floor), float(self.prices.max(initial=0.0))
        reliable = here.is_reliable(worth, highest)
        if reliable and promised <= floor and not here.restores_feasibility(step):
            if promised < -floor and self.radius > _STUCK:
                # a step for the worse solves no program: a shorter one, damped, is found better
                self.damping_share, self.radius = 1.0, 0.25 * self.radius
                return False
            self.settled = True
            self.last = _last_point(here, step, self.prices, merit - 1e-4 * worth)
            if self.last is not None:
                return True
        touched = _touched(here, step, solution)
        trial = follow_step(here, np.append(step, 1.0), touched, worth, highest)
        gain = -np.inf if trial is None else (merit - trial.merit(self.prices)) / worth
        accepted = gain > 1e-4
        if trial is not None and accepted:
            self.here, self.active = trial, touched
        elif not reliable:
            # the merit that the trial did not come up to may be that of a point that does not close so
            nearer = _closer(here, trial, self.active, self.radius, worth, highest)
            if nearer is not None:
                self.here = nearer
                return True
        if not self.settled:
            self._adapt(gain, float(np.abs(step / here.program.scale).max()), accepted=accepted)
        return accepted or self.settled

    def _adapt(self, gain: float, size: float, *, accepted: bool) -> None:
        """Radius and damping after a step of `size` scales that gained this share of what it promised."""
        if gain > 0.75:
            self.radius = max(self.radius, min(5.0, 2 * size))
            self.damping_share = max(0.1 * self.damping_share, _EASIEST)
        elif gain < 0.25:
            self.radius, self.damping_share = (0.5 if accepted else 0.3) * size, 1.0


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
