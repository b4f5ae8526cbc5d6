"""What the optimiser knows of a problem, and where its search stands.

A point has unknowns z and a state that follows from them by equations (z alone decides a closed point). Search
runs over points that are not quite closed: what it is told of one is to first order what holds once it is closed.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Generic, NamedTuple, TypeVar

import numpy as np

from elastica_cad._types import BoolArray, FloatArray, IntArray

Point = TypeVar("Point")

KEY_STRIDE = 1_000_000
"""More than the number of values of any constraint: the key of a row is its constraint's number times this plus
its index."""


class Closing(NamedTuple):
    """Settings by which a point is closed. States are in numbers whose linearity ends at 1 (angles in radians).

    Attributes
    ----------
    steps : int
        Newton corrections on the way to one iterate: the error is squared four times.
    room : float
        Scales from a bound within which an unknown is at it.
    closed : float
        Change of the state that still shows when a point is as good as closed: its square is rounding.
    lost : float
        A state that would have to change so far does not close: beyond a quarter turn.
    tolerable : float
        By which the state of an iterate may be off when it is not reliable: errors of a percent.
    reliable : float
        Share of what a step promises that may be unknown.
    badly_broken : float
        Of a constraint's value: a hundred times what counts as met.
    """

    steps: int = 4
    room: float = 1e-6
    closed: float = 1e-8
    lost: float = 1.5
    tolerable: float = 0.1
    reliable: float = 0.5
    badly_broken: float = 1e-4


CLOSING = Closing()


@dataclass(frozen=True, eq=False)
class LocalModel:
    """value + h^T d + d^T H d / 2, plus the largest of peaks + peak_rows d where there are peaks.

    Attributes
    ----------
    value : float
    hessian, gradient : (p, p), (p,) arrays
    peaks, peak_rows : (k,), (k, p) arrays
        Empty for smooth objectives.
    """

    value: float
    hessian: FloatArray
    gradient: FloatArray
    peaks: FloatArray
    peak_rows: FloatArray


@dataclass(frozen=True, eq=False)
class ConstraintRows:
    """The constraints' rows that matter near a point, stacked: value + jacobian @ step.

    Attributes
    ----------
    constraint, index : (j,) arrays
        The number of each row's constraint, and its place among the values of that.
    value : (j,) array
        Once the point is closed, where the rows come from a linearization.
    jacobian : (j, p) array
    price : (j,) array
        The most that breaking a row by 1 costs.
    one_sided : (j,) boolean array
        At least 0, not 0.
    """

    constraint: IntArray
    index: IntArray
    value: FloatArray
    jacobian: FloatArray
    price: FloatArray
    one_sided: BoolArray


@dataclass(frozen=True, eq=False)
class Linearization(Generic[Point]):
    """A point and what changes (p + 1,) do to it; their last entry is the share of closing it.

    Attributes
    ----------
    point : Point
    z : (p,) array
        Its unknowns.
    rows : ConstraintRows
        Constraints in steps (p,) from the closed point.
    model : LocalModel
        The objective in the same steps.
    state_jacobian : (k, p + 1) array
        Of the part of the state that tells how far linearity holds, in numbers of order 1 where it ends.
    moved : callable
        The point after a change, its unknowns within their box, to first order.
    """

    point: Point
    z: FloatArray
    rows: ConstraintRows
    model: LocalModel
    state_jacobian: FloatArray
    moved: Callable[[FloatArray], Point]


@dataclass(frozen=True, eq=False)
class NonlinearProgram(ABC, Generic[Point]):
    """Minimise an objective over unknowns in a box under constraints.

    Attributes
    ----------
    lower, upper : (p,) arrays
        Equal where an unknown is given.
    scale : (p,) array
        Typical sizes of the unknowns.
    """

    lower: FloatArray
    upper: FloatArray
    scale: FloatArray

    @property
    @abstractmethod
    def one_sided(self) -> BoolArray:
        """Whether the values of each constraint (c,) must be at least 0 instead of 0."""

    @property
    @abstractmethod
    def highest_prices(self) -> FloatArray:
        """Largest multiplier (c,) among the values of each constraint."""

    @abstractmethod
    def objective(self, point: Point) -> float:
        """The number to be minimised."""

    @abstractmethod
    def apart(self, one: Point, other: Point) -> float:
        """Mean square distance of two points, in the unit of the objective."""

    @abstractmethod
    def values(self, point: Point) -> Sequence[FloatArray]:
        """Values of each constraint."""

    @abstractmethod
    def rows(self, point: Point, values: Sequence[FloatArray]) -> tuple[FloatArray, ConstraintRows]:
        """The unknowns of a closed point with these values, and the constraints in steps between closed points."""

    @abstractmethod
    def linearize(self, point: Point) -> Linearization[Point] | None:
        """The point, closed or not, with its derivatives; None where they are no numbers to go by."""

    @abstractmethod
    def close(self, point: Point, step: FloatArray | None = None) -> Point | None:
        """The closed point of the unknowns of `point`, after a step (p,) in the box; None where there is none."""

    @abstractmethod
    def clip(self, point: Point) -> Point:
        """The point with its unknowns moved into the box, its state as it is."""

    @abstractmethod
    def fallback(self) -> Point:
        """A closed point, where the search has no other."""

    @abstractmethod
    def for_open_points(self) -> "NonlinearProgram[Point]":
        """Return the program without the constraints that make no sense for points far from closed."""


@dataclass(frozen=True, eq=False)
class ActiveSet:
    """Rows, by their keys (k,), that a point keeps at the values `aim` (k,) while it closes."""

    keys: IntArray
    aim: FloatArray


_NONE_ACTIVE = ActiveSet(np.zeros(0, dtype=int), np.zeros(0))


@dataclass(frozen=True, eq=False)
class Iterate(Generic[Point]):
    """The present point of a search; its state need not quite follow from its unknowns.

    Attributes
    ----------
    program : NonlinearProgram
    local : Linearization
    change : (p + 1,) array
        The least step that closes the point to first order and keeps the active rows at their aim; its last
        entry is 1.
    state_change : array
        What `change` does to the state.
    """

    program: NonlinearProgram[Point]
    local: Linearization[Point]
    change: FloatArray
    state_change: FloatArray

    @cached_property
    def defect(self) -> float:
        """Largest change of the state that closes the point."""
        return float(np.abs(self.state_change).max())

    @cached_property
    def objective(self) -> float:
        """The objective of the closed point, to second order in the defect."""
        return self._expected(self.change[:-1])

    @cached_property
    def violation(self) -> float:
        """Largest violation of a constraint at the closed point, to first order."""
        return float(self._broken_closed.max(initial=0.0))

    @cached_property
    def _broken_closed(self) -> FloatArray:
        """Violation of each row at the closed point, to first order."""
        return self._broken(self.change[:-1])

    def merit(self, prices: FloatArray) -> float:
        """Objective and price of what is broken, once closed."""
        return self.objective + self._cost(self._broken_closed, prices)

    def predicted_merit(self, step: FloatArray, prices: FloatArray) -> float:
        """The merit that the local program expects after a step."""
        return self._expected(step) + self._cost(self._broken(step), prices)

    def is_reliable(self, promise: float, highest_price: float) -> bool:
        """Whether the second-order change from closing the point is small beside a predicted decrease."""
        if not self.defect**2 * highest_price < CLOSING.reliable * promise:  # whatever the objective
            return False
        weight = 1.0 if self.local.model.peaks.size else float(np.sqrt(2 * max(self.objective, 0.0)))
        return self.defect**2 * (weight + highest_price) < CLOSING.reliable * promise

    def restores_feasibility(self, step: FloatArray) -> bool:
        """Whether a step removes most of a large violation, even if it lowers the merit little."""
        return self.violation > CLOSING.badly_broken and bool(
            self._broken(step).max(initial=0.0) < 0.5 * self.violation
        )

    def _expected(self, step: FloatArray) -> float:
        """The objective that the model expects after a step (p,)."""
        model = self.local.model
        smooth = model.value + float((model.gradient + 0.5 * (model.hessian @ step)) @ step)
        return smooth + (float((model.peaks + model.peak_rows @ step).max()) if model.peaks.size else 0.0)

    def _broken(self, step: FloatArray) -> FloatArray:
        """Violation of each row after a step (p,)."""
        rows = self.local.rows
        value = rows.value + rows.jacobian @ step
        return np.where(rows.one_sided, np.maximum(-value, 0.0), np.abs(value))

    def _cost(self, broken: FloatArray, prices: FloatArray) -> float:
        """The price of rows that are broken by so much."""
        return float(prices[self.local.rows.constraint] @ broken)


def iterate_at(
    program: NonlinearProgram[Point], point: Point, active: ActiveSet = _NONE_ACTIVE
) -> Iterate[Point] | None:
    """The iterate of a point, closed or not; None where it has no usable derivatives."""
    local = program.linearize(point)
    return None if local is None else _with_active(program, local, active)


def meet_equalities(at: Iterate[Point]) -> Iterate[Point]:
    """Return the iterate such that it is closed by the least change that meets every equality."""
    return _with_active(at.program, at.local, all_equalities(at))


def all_equalities(at: Iterate[Point]) -> ActiveSet:
    """Every equality, to be met."""
    keys = row_keys(at.local.rows)[~at.local.rows.one_sided]
    return ActiveSet(keys, np.zeros(keys.size))


def _find_free(program: NonlinearProgram[Point], z: FloatArray) -> BoolArray:
    """Which unknowns (p,) have room on both sides."""
    return np.asarray(np.minimum(z - program.lower, program.upper - z) > CLOSING.room * program.scale)


def row_keys(rows: ConstraintRows) -> IntArray:
    """One number for each row, the same from point to point."""
    return rows.constraint * KEY_STRIDE + rows.index


def _with_active(
    program: NonlinearProgram[Point], local: Linearization[Point], active: ActiveSet
) -> Iterate[Point]:
    change = np.zeros(local.z.size + 1)
    change[-1] = 1.0
    if active.keys.size:
        rows = local.rows
        _, here, there = np.intersect1d(row_keys(rows), active.keys, assume_unique=True, return_indices=True)
        free = _find_free(program, local.z)
        s = program.scale[free]
        gap = active.aim[there] - rows.value[here]
        # where more rows are kept than unknowns are free the rows that react most come first
        change[:-1][free] = np.linalg.lstsq(rows.jacobian[here][:, free] * s, gap, rcond=1e-10)[0] * s
    return Iterate(program, local, change, local.state_jacobian @ change)


def follow_step(
    start: Iterate[Point], step: FloatArray, active: ActiveSet, promise: float, highest_price: float
) -> Iterate[Point] | None:
    """Return the point that a step (p + 1,) leads to; None when its state does not converge there.

    The state takes its linear change, then Newton steps bring it towards closed and, by least changes of the
    unknowns that are free, active rows to where the program expected them, until what is left is of second
    order small beside the promise. A state that is sensitive to the unknowns stands far larger steps so than
    solved anew from them (and no Maratos effect).
    """
    at, change = start, step
    for _ in range(CLOSING.steps):
        found = iterate_at(start.program, at.local.moved(change), active)
        if found is None or not found.defect < CLOSING.lost:
            return None
        if found.is_reliable(promise, highest_price):
            return found
        at, change = found, found.change
    return at if at.defect < CLOSING.tolerable else None


def close_iterate(start: Iterate[Point], active: ActiveSet) -> Point | None:
    """The closed point near an iterate; None when there is none."""
    at = start
    for _ in range(2 * CLOSING.steps):
        if not at.defect < CLOSING.lost:
            return None
        point = at.local.moved(at.change)
        found = None if at.defect < CLOSING.closed else iterate_at(start.program, point, active)
        if found is None:
            break
        at = found
    return start.program.close(point)
