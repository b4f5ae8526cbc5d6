"""Sequential quadratic programming with a trust region and an exact penalty.

A point has p unknowns z and a state, such as the angles of a rod. In equilibrium, z determines the state. The
points of a search are only nearly in equilibrium, and derivatives predict the point in equilibrium to first order.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, replace
from typing import Generic, NamedTuple, TypeVar

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import BoolArray, FloatArray, IntArray
from elastica_cad.errors import NotConvergedError
from elastica_cad.form_finding.quadratic_program import QuadraticProgram, QuadraticSolution, solve_quadratic

Point = TypeVar("Point")

KEY_STRIDE = 1_000_000
"""Factor in the key of a row of `ConstraintRows`: key = constraint * KEY_STRIDE + index.

The key is unique, because no constraint has so many values.
"""


class ProgramSettings(NamedTuple):
    """Settings of a search.

    The defect of a point is the change of its state, rad, that brings the point into equilibrium. Radii and
    distances "in scales" are multiples of the typical sizes of the unknowns.

    Attributes
    ----------
    steps, lifted_steps : int
        Largest number of steps in a search, and of lifted steps (see `lift`). Lifted steps converge quadratically
        or not at all.
    progress_tolerance, peak_tolerance : float
        The search ends if the model predicts that a step reduces the objective by less than this fraction. The
        second applies to an objective with a maximum, which is a distance instead of the square of one.
    resolution : float
        Absolute accuracy of the objective, which is half a mean of squared distances: about 1 um for a strip of
        300 mm.
    smallest_radius, lifted_radius : float
        Radius of the trust region, in scales, at which the search ends without success, and radius for lifted
        steps.
    ascent_radius : float
        Radius, in scales, below which the search ends if the model predicts an increase of the objective.
    damping, lifted_damping : float
        Damping of steps, and of the first lifted step, as a fraction of the largest second derivative of the
        objective. Damping selects the smallest of several possible steps.
    damping_cost, peak_damping : float
        Largest cost that damping adds to a step of length 1 in scales, as a fraction of the objective, and twice
        this cost for an objective with a maximum.
    least_damping : float
        Least fraction to which the damping is reduced while steps achieve the predicted decrease.
    lifted_tolerance, lifted_progress : float
        Lifted steps end if a step changes the state by less than `lifted_tolerance`, rad, and more than the
        fraction `lifted_progress` of the objective remains.
    patience, stall_fraction, stall_violation : int, float, float
        The search ends if more than the fraction `stall_fraction` of the violation remains after `patience` steps,
        unless the violation is less than `stall_violation`.
    same_optimum : float
        The search ends if its distance from a known optimum is less than this fraction of the distance between
        the optimum and the target.
    sensitivity : float
        The scale of an unknown is reduced if the square root of the second derivative of the objective, per scale,
        exceeds this value.

    newton_steps : int
        Largest number of Newton corrections of an iterate. Each correction squares the defect.
    bound_tolerance : float
        Distance from a bound, in scales, below which an unknown counts as at the bound.
    closed_defect : float
        Defect below which a point counts as in equilibrium.
    divergence_defect, start_defect : float
        Defect above which Newton corrections diverge (about a quarter turn), and largest defect of an initial
        point. An initial point with a larger defect is replaced by the point in equilibrium with the same
        unknowns.
    tolerated_defect : float
        Largest accepted defect if Newton corrections do not converge. The effect of such a defect is about 1 %.
    defect_reduction : float
        A rejected point is accepted if its defect is below this fraction of the present defect.
    reliability : float
        Largest uncertainty of the merit, as a fraction of the predicted decrease.
    large_violation : float
        Violation that counts as large: 100 times the tolerance.

    clearance : float
        Distance from an active limit that prevents a violation by rounding errors.
    exact_steps : int
        Number of final Newton steps. Each step squares the violation.
    correctable_violation, exact_violation : float
        Largest violation that the final Newton steps correct, and violation at which these steps end.
    correction_bound : float
        Bound of the final Newton steps and of their multipliers, as a multiple of the violation.
    correction_accuracy : float
        Accuracy of the final Newton steps, which is low because the next step corrects the error.
    """

    steps: int = 80
    lifted_steps: int = 12
    progress_tolerance: float = 3e-4
    peak_tolerance: float = 1e-3
    resolution: float = 1e-11
    smallest_radius: float = 1e-7
    lifted_radius: float = 20.0
    ascent_radius: float = 0.01
    damping: float = 1e-9
    lifted_damping: float = 1e-6
    damping_cost: float = 1e-2
    peak_damping: float = 1e-2
    least_damping: float = 1e-4
    lifted_tolerance: float = 0.1
    lifted_progress: float = 0.7
    patience: int = 7
    stall_fraction: float = 0.95
    stall_violation: float = 0.02
    same_optimum: float = 0.1
    sensitivity: float = 100.0

    newton_steps: int = 4
    bound_tolerance: float = 1e-6
    closed_defect: float = 1e-8
    divergence_defect: float = 1.5
    start_defect: float = 1.0
    tolerated_defect: float = 0.1
    defect_reduction: float = 0.1
    reliability: float = 0.5
    large_violation: float = 1e-4

    clearance: float = 1e-9
    exact_steps: int = 6
    correctable_violation: float = 1e-3
    exact_violation: float = 1e-13
    correction_bound: float = 1e4
    correction_accuracy: float = 1e-4


SETTINGS = ProgramSettings()


@dataclass(frozen=True, eq=False)
class LocalModel:
    """Model of the objective for a step d: value + gradient^T d + d^T hessian d / 2 + max(peaks + peak_rows d).

    Attributes
    ----------
    value : float
    hessian, gradient : (p, p), (p,) arrays
    peaks, peak_rows : (k,), (k, p) arrays
        The k terms of the maximum; k = 0 for a smooth objective without a maximum.
    peak_keys : (k,) array
        Negative numbers that identify the terms in the models of other points.
    """

    value: float
    hessian: FloatArray
    gradient: FloatArray
    peaks: FloatArray
    peak_rows: FloatArray
    peak_keys: IntArray


@dataclass(frozen=True, eq=False)
class ConstraintRows:
    """Linearised values of the constraints that a step may violate: value + jacobian @ step.

    Attributes
    ----------
    constraint, index : (j,) arrays
        Index of the constraint of each row, and index of the row in the values of this constraint.
    value : (j,) array
        Values for a step of zero.
    jacobian : (j, p) array
    penalty : (j,) array
        Upper bound of the penalty for a violation of 1.
    one_sided : (j,) boolean array
        True if the value must be at least 0; False if it must be 0.
    """

    constraint: IntArray
    index: IntArray
    value: FloatArray
    jacobian: FloatArray
    penalty: FloatArray
    one_sided: BoolArray


@dataclass(frozen=True, eq=False)
class Linearization(Generic[Point]):
    """A point with its derivatives.

    A change (p + 1,) is a step of the p unknowns and, as the last number, a fraction. The residuals of the
    state equations are reduced by this fraction.

    Attributes
    ----------
    z : (p,) array
        Unknowns of the point.
    rows : ConstraintRows
        Constraints as functions of steps (p,) from the point in equilibrium.
    model : LocalModel
        Model of the objective as a function of the same steps.
    state_jacobian : (k, p + 1) array
        Derivatives by a change, rad, of k state variables that must change little for the linear model to hold.
    moved : callable
        Function that returns the point after a change, to first order, with the unknowns within their bounds.
    """

    point: Point
    z: FloatArray
    rows: ConstraintRows
    model: LocalModel
    state_jacobian: FloatArray
    moved: Callable[[FloatArray], Point]


@dataclass(frozen=True, eq=False)
class NonlinearProgram(ABC, Generic[Point]):
    """Problem to minimise an objective over p bounded unknowns under c constraints.

    Attributes
    ----------
    lower, upper : (p,) arrays
        Bounds of the unknowns. A fixed unknown has equal bounds.
    scale : (p,) array
        Typical sizes of the unknowns.
    """

    lower: FloatArray
    upper: FloatArray
    scale: FloatArray

    @property
    @abstractmethod
    def one_sided(self) -> BoolArray:
        """For each constraint (c,), True if its values must be at least 0, and False if they must be 0."""

    @property
    @abstractmethod
    def highest_penalties(self) -> FloatArray:
        """For each constraint (c,), upper bound of the penalty for a violation of 1."""

    @abstractmethod
    def objective(self, point: Point) -> float:
        """Return the value to minimise."""

    @abstractmethod
    def apart(self, first: Point, other: Point) -> float:
        """Return half the mean squared distance of the nodes of two rods (points), in the unit of the objective."""

    @abstractmethod
    def values(self, point: Point) -> Sequence[FloatArray]:
        """Return the values of each constraint."""

    @abstractmethod
    def rows(self, point: Point, values: Sequence[FloatArray]) -> tuple[FloatArray, ConstraintRows]:
        """Return the unknowns and the linearised constraints of a point in equilibrium."""

    @abstractmethod
    def linearize(self, point: Point) -> Linearization[Point] | None:
        """Return a point with its derivatives, or None if they overflow.

        The point need not be in equilibrium.
        """

    @abstractmethod
    def close(self, point: Point, step: FloatArray | None = None) -> Point | None:
        """Return the point in equilibrium after a step (p,) of the unknowns, or None if there is no such point."""

    @abstractmethod
    def clip(self, point: Point) -> Point:
        """Return the point with its unknowns clipped to their bounds and its state unchanged."""

    @abstractmethod
    def fallback(self) -> Point:
        """Return a point in equilibrium for a search whose start or result cannot be moved to equilibrium."""

    @abstractmethod
    def for_open_points(self) -> "NonlinearProgram[Point]":
        """Return the program for points far from equilibrium, without constraints that are meaningless there."""


@dataclass(frozen=True, eq=False)
class ActiveSet:
    """Keys (k,) of the active constraint rows, and values `aim` (k,) that the rows must have in equilibrium.

    A key identifies a row: see `KEY_STRIDE`.
    """

    keys: IntArray
    aim: FloatArray

    @property
    def without_peaks(self) -> "ActiveSet":
        """The active set of the constraints alone."""
        return ActiveSet(self.keys[self.keys >= 0], self.aim[self.keys >= 0])


_NONE_ACTIVE = ActiveSet(np.zeros(0, dtype=int), np.zeros(0))


def _row_keys(rows: ConstraintRows) -> IntArray:
    return rows.constraint * KEY_STRIDE + rows.index


def _rows_and_peaks(local: Linearization[Point]) -> tuple[IntArray, FloatArray, FloatArray]:
    """Return keys (k,), values (k,) and derivatives (k, p) of the constraint rows and the peaks."""
    rows, model = local.rows, local.model
    return (
        np.concatenate([_row_keys(rows), model.peak_keys]), np.concatenate([rows.value, model.peaks]),
        np.concatenate([rows.jacobian, model.peak_rows]),
    )  # fmt: skip


@dataclass(frozen=True, eq=False)
class Iterate(Generic[Point]):
    """The present point of a search, nearly in equilibrium.

    Attributes
    ----------
    active : ActiveSet
        Rows with given values in equilibrium.
    """

    program: NonlinearProgram[Point]
    local: Linearization[Point]
    active: ActiveSet = _NONE_ACTIVE

    @cached_property
    def change(self) -> FloatArray:
        """Least change (p + 1,) that brings the point into equilibrium, to first order.

        The change also gives the active rows their required values.
        """
        change = np.zeros(self.local.z.size + 1)
        change[-1] = 1.0
        if self.active.keys.size:
            program, z = self.program, self.local.z
            keys, value, jacobian = _rows_and_peaks(self.local)
            _, here, there = np.intersect1d(keys, self.active.keys, assume_unique=True, return_indices=True)
            free = np.minimum(z - program.lower, program.upper - z) > SETTINGS.bound_tolerance * program.scale
            s = program.scale[free]
            gap = self.active.aim[there] - value[here]
            # with more rows than free unknowns, rows with large derivatives dominate the least-squares solution
            change[:-1][free] = np.linalg.lstsq(jacobian[here][:, free] * s, gap, rcond=1e-10)[0] * s
        return change

    @cached_property
    def defect(self) -> float:
        """Largest change of the state that brings the point into equilibrium, rad."""
        return float(np.abs(self.local.state_jacobian @ self.change).max())

    @property
    def equalities(self) -> ActiveSet:
        """Active set of all equality constraints."""
        keys = _row_keys(self.local.rows)[~self.local.rows.one_sided]
        return ActiveSet(keys, np.zeros(keys.size))

    @cached_property
    def objective(self) -> float:
        """Objective that the quadratic model predicts after the change to equilibrium."""
        return self._expected(self.change[:-1])

    @cached_property
    def violation(self) -> float:
        """Largest violation of a constraint that the linearisation predicts after the change to equilibrium."""
        return float(self._broken_closed.max(initial=0.0))

    @cached_property
    def _broken_closed(self) -> FloatArray:
        return self._broken(self.change[:-1])

    def merit(self, penalties: FloatArray) -> float:
        """Return the merit: the objective plus the penalties for violations, in equilibrium."""
        return self.objective + self._cost(self._broken_closed, penalties)

    def predicted_merit(self, step: FloatArray, penalties: FloatArray) -> float:
        """Return the merit after a step (p,), as predicted by the linearisation."""
        return self._expected(step) + self._cost(self._broken(step), penalties)

    def is_reliable(self, promise: float, highest_penalty: float) -> bool:
        """Return True if the uncertainty of the merit is small compared with the predicted decrease `promise`."""
        if not self.defect**2 * highest_penalty < SETTINGS.reliability * promise:
            return False
        weight = 1.0 if self.local.model.peaks.size else float(np.sqrt(2 * max(self.objective, 0.0)))
        return self.defect**2 * (weight + highest_penalty) < SETTINGS.reliability * promise

    def restores_feasibility(self, step: FloatArray) -> bool:
        """Return True if a step at least halves a large violation, even if the merit decreases little."""
        return self.violation > SETTINGS.large_violation and bool(
            self._broken(step).max(initial=0.0) < 0.5 * self.violation
        )

    def _expected(self, step: FloatArray) -> float:
        model = self.local.model
        smooth = model.value + float((model.gradient + 0.5 * (model.hessian @ step)) @ step)
        return smooth + (float((model.peaks + model.peak_rows @ step).max()) if model.peaks.size else 0.0)

    def _broken(self, step: FloatArray) -> FloatArray:
        rows = self.local.rows
        value = rows.value + rows.jacobian @ step
        return np.where(rows.one_sided, np.maximum(-value, 0.0), np.abs(value))

    def _cost(self, broken: FloatArray, penalties: FloatArray) -> float:
        return float(penalties[self.local.rows.constraint] @ broken)


def iterate_at(
    program: NonlinearProgram[Point], point: Point, active: ActiveSet = _NONE_ACTIVE
) -> Iterate[Point] | None:
    """Return the `Iterate` at a point, or None if derivatives overflow."""
    local = program.linearize(point)
    return None if local is None else Iterate(program, local, active)


def meet_equalities(here: Iterate[Point]) -> Iterate[Point]:
    """Return the iterate with all equality constraints as its active set."""
    return replace(here, active=here.equalities)


def follow_step(
    start: Iterate[Point], step: FloatArray, active: ActiveSet, promise: float, highest_penalty: float
) -> Iterate[Point] | None:
    """Return the iterate after a step (p + 1,), or None if the state does not converge.

    The state first changes linearly. Newton steps then bring the point into equilibrium and the active rows to
    their predicted values, with the least change of the unknowns. The Newton steps end when the second-order error
    is small compared with the predicted decrease. Compared with a new computation of the state, this method allows
    larger steps and avoids the Maratos effect. Active peaks are corrected once, by the first Newton step.
    """
    here, change = start, step
    for _ in range(SETTINGS.newton_steps):
        after = iterate_at(start.program, here.local.moved(change), active)
        if after is None or not after.defect < SETTINGS.divergence_defect:
            return None
        if after.is_reliable(promise, highest_penalty) and (active.keys >= 0).all():
            return after
        here, change, active = after, after.change, active.without_peaks
    return here if here.defect < SETTINGS.tolerated_defect else None


def close_iterate(start: Iterate[Point], active: ActiveSet) -> Point | None:
    """Return the point in equilibrium near an iterate, or None if it was not found."""
    here = start
    for _ in range(2 * SETTINGS.newton_steps):
        if not here.defect < SETTINGS.divergence_defect:
            return None
        point = here.local.moved(here.change)
        after = None if here.defect < SETTINGS.closed_defect else iterate_at(start.program, point, active)
        if after is None:
            break
        here = after
    return start.program.close(point)


@dataclass(frozen=True, eq=False)
class Outcome(Generic[Point]):
    """Result of a search.

    Attributes
    ----------
    point : Point
        Point in equilibrium.
    objective, violation : float
    multipliers : tuple of (k,) arrays
        Derivatives of the objective with respect to the values of each constraint.
    at_lower, at_upper : (p,) arrays
        Multipliers of the lower and the upper bounds.
    settled, stalled : bool
        `settled` is True if no step predicts a further decrease. `stalled` is True if the violation decreased too
        slowly.
    """

    point: Point
    objective: float
    violation: float
    multipliers: tuple[FloatArray, ...]
    at_lower: FloatArray
    at_upper: FloatArray
    iterations: int
    settled: bool
    stalled: bool


def lift(program: NonlinearProgram[Point], start: Point, steps: int) -> Point:
    """Return a point nearly in equilibrium near a point that is far from equilibrium.

    In each lifted step, the state is an additional unknown, and the linearised state equations are a constraint.
    Therefore the quadratic program is convex for any start.
    """
    program = program.for_open_points()
    point = best = start
    before = least = np.inf
    for k in range(steps):
        here = iterate_at(program, point)
        if here is None:
            break
        damping = _damping(here, SETTINGS.lifted_damping, np.inf if k == 0 else SETTINGS.damping_cost)
        solved = _solve_step(here, SETTINGS.lifted_radius, damping)
        if solved is None:
            break
        change = np.append(solved[0], 1.0)
        point = here.local.moved(change)
        after = program.objective(point)
        changed = float(np.abs(here.local.state_jacobian @ change).max())
        # the second term estimates how much the change to equilibrium increases the distance
        if (rank := float(np.sqrt(2 * after)) + 0.1 * changed**2) < least:
            best, least = point, rank
        if (
            changed < SETTINGS.lifted_tolerance
            and after > SETTINGS.lifted_progress * before - SETTINGS.resolution
        ):
            break
        before = after
    return best


# number of steps that searches in a block of `at_most` may still take
_STEPS_LEFT = ContextVar("_STEPS_LEFT", default=np.inf)


@contextmanager
def at_most(steps: int) -> Iterator[None]:
    """Limit the total number of steps of the searches in a `with` block; beyond it they raise NotConvergedError."""
    before = _STEPS_LEFT.set(steps)
    try:
        yield
    finally:
        _STEPS_LEFT.reset(before)


def minimize(
    program: NonlinearProgram[Point], start: Point, *, known: Sequence[Outcome[Point]] = ()
) -> Outcome[Point]:
    """Return a local minimum, found from a point that need not be in equilibrium.

    The search ends early near an optimum in `known`.

    Each step solves a quadratic program, which consists of a model of the objective, linearised constraints with
    penalties, and a trust region. Then the state is brought into equilibrium (see `follow_step`). The penalties of
    the merit function are computed from the multipliers (Powell's rule).

    Raises
    ------
    NotConvergedError
        No initial point was found, or the steps of `at_most` are used up.
    """
    walk = _Walk(_begin(program, start), np.zeros(program.highest_penalties.size))
    iteration, broken, stalled = 0, [walk.here.violation], False
    while not (
        walk.settled or stalled or iteration == SETTINGS.steps or walk.radius <= SETTINGS.smallest_radius
    ):
        for other in known:
            if program.apart(walk.here.local.point, other.point) < SETTINGS.same_optimum**2 * other.objective:
                return replace(other, iterations=iteration)
        iteration += 1
        _STEPS_LEFT.set(_STEPS_LEFT.get() - 1)
        if _STEPS_LEFT.get() < 0:
            raise NotConvergedError("the search took more steps than allowed")
        walk.advance()
        broken.append(walk.here.violation)
        before = max(broken[-SETTINGS.patience :]) if iteration > SETTINGS.patience else np.inf
        stalled = broken[-1] > max(SETTINGS.stall_violation, SETTINGS.stall_fraction * before)
    point = _make_exact(program, walk.end())
    values = program.values(point)
    multipliers, low, high = _multipliers(program, values, walk.solved)
    return Outcome(
        point, program.objective(point), worst_broken(program, values), multipliers, low, high, iteration,
        walk.settled, stalled,
    )  # fmt: skip


@dataclass(eq=False)
class _Walk(Generic[Point]):
    """State of a search: present iterate, penalties of the merit function, trust region, and damping.

    `solved` contains the constraint rows and the solution of the latest quadratic program. `damping_fraction` is
    the factor on the damping, which is reduced while steps succeed.
    """

    here: Iterate[Point]
    penalties: FloatArray
    radius: float = 1.0
    damping_fraction: float = 1.0
    solved: tuple[ConstraintRows, QuadraticSolution] | None = None
    settled: bool = False

    def __post_init__(self) -> None:
        self.active = self.here.equalities

    def advance(self) -> None:
        while self.radius > SETTINGS.smallest_radius and not self._try_step():
            pass

    def end(self) -> Point:
        program = self.here.program
        point = close_iterate(self.here, self.active) or program.close(self.here.local.point)
        return point or program.fallback()

    def _try_step(self) -> bool:
        """Try one step. Return False if the step must be repeated with a smaller radius."""
        here = self.here
        damping = self.damping_fraction * _damping(here, SETTINGS.damping, SETTINGS.damping_cost)
        solved = _solve_step(here, self.radius, damping)
        if solved is None:
            self.radius *= 0.25
            return False
        step, solution = solved
        self.solved = here.local.rows, solution
        self.penalties = _penalties(here.program, here.local.rows, solution, self.penalties)
        merit, peaks = here.merit(self.penalties), here.local.model.peaks.size
        tolerance = SETTINGS.peak_tolerance if peaks else SETTINGS.progress_tolerance
        floor = tolerance * here.objective + SETTINGS.resolution
        # predicted decrease of the merit; a decrease below `floor` is not worth a step
        promised = merit - here.predicted_merit(step, self.penalties)
        worth, highest = max(promised, floor), float(self.penalties.max(initial=0.0))
        reliable = here.is_reliable(worth, highest)
        if reliable and promised <= floor and not here.restores_feasibility(step):
            if promised < -floor and self.radius > SETTINGS.ascent_radius:
                # a predicted increase shows that the solution is inaccurate: repeat with a smaller radius and
                # full damping
                self.damping_fraction, self.radius = 1.0, 0.25 * self.radius
                return False
            self.settled = True
        touched = _touched(here, step, solution)
        trial, gain = None, -np.inf
        # without, then with a correction that makes the active peaks equal
        for active in (touched.without_peaks, touched):
            after = follow_step(here, np.append(step, 1.0), active, worth, highest)
            if after is not None and (gained := (merit - after.merit(self.penalties)) / worth) > gain:
                trial, gain = after, gained
            if gain > 0.75 or (touched.keys >= 0).all():
                break
        accepted = gain > 1e-4
        if trial is not None and accepted:
            self.here, self.active = trial, touched.without_peaks
        elif not reliable and (nearer := self._nearer(trial, worth, highest)) is not None:
            self.here = nearer
            return True
        if not self.settled:
            self._adapt(gain, float(np.abs(step / here.program.scale).max()), accepted=accepted)
        return accepted or self.settled

    def _nearer(
        self, trial: Iterate[Point] | None, promise: float, highest_penalty: float
    ) -> Iterate[Point] | None:
        """Return a point nearer to equilibrium after a step whose prediction was not reliable, or None."""
        here = self.here
        nearer = follow_step(here, here.change, self.active, promise, highest_penalty)
        if nearer is None and trial is not None and trial.defect < SETTINGS.defect_reduction * here.defect:
            nearer = trial
        if nearer is None and self.radius < SETTINGS.ascent_radius:
            point = here.program.close(here.local.point)
            nearer = None if point is None else iterate_at(here.program, point)
        return nearer

    def _adapt(self, gain: float, size: float, *, accepted: bool) -> None:
        """Change the radius of the trust region and the damping after a step.

        `gain` is the achieved fraction of the predicted decrease. `size` is the largest change of an unknown, as
        a multiple of its typical size.
        """
        if gain > 0.75:
            self.radius = max(self.radius, min(5.0, 2 * size))
            self.damping_fraction = max(0.1 * self.damping_fraction, SETTINGS.least_damping)
        elif gain < 0.25:
            self.radius, self.damping_fraction = (0.5 if accepted else 0.3) * size, 1.0


def _begin(program: NonlinearProgram[Point], start: Point) -> Iterate[Point]:
    """Return the first iterate: the start, if its defect is small.

    For a large defect, return the point in equilibrium with the same unknowns, or the fallback of the program.
    """
    point = program.clip(start)
    here = iterate_at(program, point)
    if here is not None:
        here = meet_equalities(here)
        if here.defect < SETTINGS.start_defect:
            return here
    for closed in (program.close(point), program.fallback()):
        here = None if closed is None else iterate_at(program, closed)
        if here is not None:
            return here
    raise NotConvergedError("no rod was found to start the search: draw a smoother or shorter curve")


def _touched(here: Iterate[Point], step: FloatArray, solution: QuadraticSolution) -> ActiveSet:
    """Return the active set after a step: equalities, and inequalities and peaks with a multiplier."""
    rows, (keys, value, jacobian) = here.local.rows, _rows_and_peaks(here.local)
    touched = solution.row_multipliers > 1e-6
    touched[: rows.value.size] = ~rows.one_sided | (
        solution.row_multipliers[: rows.value.size] > 1e-6 * rows.penalty
    )
    return ActiveSet(keys[touched], (value + jacobian @ step)[touched])


def _penalties(
    program: NonlinearProgram[Point], rows: ConstraintRows, solution: QuadraticSolution, before: FloatArray
) -> FloatArray:
    """Return the penalties of the merit function by Powell's rule, from the penalties `before`."""
    y = np.abs(solution.row_multipliers[: rows.value.size])
    largest = np.zeros_like(before)
    np.maximum.at(largest, rows.constraint, 1.5 * y)
    return np.minimum(program.highest_penalties, np.maximum(largest, 0.1 * before))


def _solve_step(
    here: Iterate[Point], radius: float, damping: float
) -> tuple[FloatArray, QuadraticSolution] | None:
    """Return the step (p,) that solves the quadratic program, and the scaled solution.

    The scaled solution and `radius` are multiples of the typical sizes of the unknowns. `damping` is added to the
    diagonal of the scaled Hessian. Return None if the step is not finite.
    """
    program, local = here.program, here.local
    rows, model, z = local.rows, local.model, local.z
    p = z.size
    # reduce the scales of very sensitive unknowns, which would reduce the accuracy of all other unknowns
    curved = model.hessian.diagonal() * (program.scale / SETTINGS.sensitivity) ** 2
    fine = np.sqrt(np.maximum(1.0, curved))
    s = program.scale / fine
    hessian, gradient = model.hessian * np.outer(s, s) + np.diag(damping / fine**2), model.gradient * s
    lower = np.maximum((program.lower - z) / s, -radius * fine)
    upper = np.minimum((program.upper - z) / s, radius * fine)
    jacobian, value, penalty, one_sided = rows.jacobian * s, rows.value, rows.penalty, rows.one_sided
    if model.peaks.size:
        # the maximum of the peaks is an additional unknown; a large penalty keeps the unknown at least at
        # every peak
        k, top = model.peaks.size, float(model.peaks.max())
        hessian, gradient = np.pad(hessian, (0, 1)), np.append(gradient, 1.0)
        lower, upper = np.append(lower, -2 * top - 1e-9), np.append(upper, 2 * top + 1e-9)
        jacobian = np.block([[jacobian, np.zeros((value.size, 1))], [-model.peak_rows * s, np.ones((k, 1))]])
        value = np.append(value, top - model.peaks)
        penalty, one_sided = (
            np.append(penalty, np.full(k, 10.0)),
            np.append(one_sided, np.ones(k, dtype=bool)),
        )
    solution = solve_quadratic(
        QuadraticProgram(hessian, gradient, lower, upper, jacobian, -value, penalty, one_sided)
    )
    if not np.isfinite(solution.x).all():
        return None
    low, high = solution.lower_multipliers[:p] * fine, solution.upper_multipliers[:p] * fine
    return solution.x[:p] * s, replace(
        solution, x=solution.x[:p] / fine, lower_multipliers=low, upper_multipliers=high
    )


def _damping(here: Iterate[Point], most: float, share: float) -> float:
    """Return the damping, which prevents long steps with little effect on the objective.

    The damping is at most the fraction `most` of the largest diagonal entry of the Hessian. For a step of length 1,
    with each unknown divided by its scale, damping costs at most the fraction `share` of the objective.
    """
    model = here.local.model
    objective = here.program.objective(here.local.point)
    if model.peaks.size:
        return SETTINGS.peak_damping * objective
    return min(most * float(model.hessian.diagonal().max()), max(share * objective, 1e-16))


def worst_broken(program: NonlinearProgram[Point], values: Sequence[FloatArray]) -> float:
    """Return the largest violation of a constraint."""
    return max(
        (
            float((np.maximum(-value, 0.0) if one_sided else np.abs(value)).max())
            for value, one_sided in zip(values, program.one_sided, strict=True)
        ),
        default=0.0,
    )


def _make_exact(program: NonlinearProgram[Point], point: Point) -> Point:
    """Return a point in equilibrium near `point` whose constraints are violated only by rounding errors.

    Newton's method is used, with steps of least norm within the bounds.
    """
    best, least = point, np.inf
    for _ in range(SETTINGS.exact_steps):
        z, rows = program.rows(point, program.values(point))
        aim = np.where(rows.one_sided, SETTINGS.clearance - rows.value, -rows.value)
        missed = float(np.where(rows.one_sided, aim, np.abs(aim)).max(initial=0.0))
        if missed < least:
            best, least = point, missed
        elif least <= SETTINGS.clearance:
            break
        if missed <= SETTINGS.exact_violation or missed > SETTINGS.correctable_violation:
            break
        # scale the unknowns so that derivatives are at most 1, because one unknown could dominate all rows
        s, p = program.scale / np.maximum(1.0, np.linalg.norm(rows.jacobian * program.scale, axis=0)), z.size
        # the step is divided by `missed`, so that the numbers of the program are not small
        bound = SETTINGS.correction_bound
        lower, upper = ((limit - z) / s / missed for limit in (program.lower, program.upper))
        step = solve_quadratic(
            QuadraticProgram(
                np.eye(p), np.zeros(p), np.maximum(lower, -bound), np.minimum(upper, bound),
                rows.jacobian * s, aim / missed, np.full(aim.size, bound), rows.one_sided,
            ),
            accuracy=SETTINGS.correction_accuracy,
        )  # fmt: skip
        trial = program.close(point, step.x * s * missed)
        if trial is None:
            break
        point = trial
    return best


def _multipliers(
    program: NonlinearProgram[Point],
    values: Sequence[FloatArray],
    solved: tuple[ConstraintRows, QuadraticSolution] | None,
) -> tuple[tuple[FloatArray, ...], FloatArray, FloatArray]:
    """Return the multipliers of each constraint, and of the lower and upper bounds.

    They are those of the last quadratic program, and 0 if there was none.
    """
    out = [np.zeros_like(v) for v in values]
    if solved is None:
        return tuple(out), np.zeros(program.scale.size), np.zeros(program.scale.size)
    rows, solution = solved
    # the solution may have further rows, for the peaks of the objective
    for k, i, y in zip(rows.constraint, rows.index, solution.row_multipliers, strict=False):
        out[k][i] = y
    return (
        tuple(out),
        solution.lower_multipliers / program.scale,
        solution.upper_multipliers / program.scale,
    )
