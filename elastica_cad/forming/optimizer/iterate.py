"""A point nearly closed with its local program, and where a step leads when its state follows."""

from dataclasses import dataclass
from functools import cached_property
from typing import Generic

import numpy as np

from elastica_cad._types import BoolArray, FloatArray, IntArray
from elastica_cad.forming.optimizer.dense_solves import least_step, matvec
from elastica_cad.forming.optimizer.nonlinear_program import (
    ConstraintRows,
    Linearization,
    NonlinearProgram,
    Point,
)

_NEWTON_STEPS = 4  # corrections on the way to one iterate: the error is squared four times
_KEY_STRIDE = 1_000_000  # more values than any constraint has
_ROOM = 1e-6  # scales from a bound, within which an unknown is at it
# The state of a program is in numbers whose linearity ends at 1 (angles in radians).
_CLOSED = 1e-8  # of the state still changes when a point is as good as closed: its square is rounding
_LOST = 1.5  # a state that would have to change so far does not close: beyond a quarter turn
_TOLERABLE = 0.1  # by which the state of an iterate may be off when it is not reliable: errors of a percent
_BADLY_BROKEN = 1e-4  # of a constraint's value: a hundred times what counts as met
_RELIABLE = 0.5  # share of what a step promises that may be unknown


@dataclass(frozen=True, eq=False)
class ActiveSet:
    """Rows, by their keys (k,), that a point keeps at the values `aim` (k,) while it closes."""

    keys: IntArray
    aim: FloatArray


_NONE_ACTIVE = ActiveSet(np.zeros(0, dtype=int), np.zeros(0))


@dataclass(frozen=True, eq=False)
class Iterate(Generic[Point]):
    """Where the search stands: a point whose state need not quite follow from its unknowns.

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
        """By how much the state is off."""
        return float(np.abs(self.state_change).max())

    @cached_property
    def objective(self) -> float:
        """The objective of the closed point, to second order in the defect."""
        return self._expected(self.change[:-1])

    @cached_property
    def violation(self) -> float:
        """By how much the worst constraint of the closed point is broken, to first order."""
        return float(self._broken_closed.max(initial=0.0))

    @cached_property
    def _broken_closed(self) -> FloatArray:
        """By how much each row of the closed point is broken, to first order."""
        return self._broken(self.change[:-1])

    def merit(self, prices: FloatArray) -> float:
        """Objective and price of what is broken, once closed."""
        return self.objective + self._cost(self._broken_closed, prices)

    def predicted_merit(self, step: FloatArray, prices: FloatArray) -> float:
        """The merit that the local program expects after a step."""
        return self._expected(step) + self._cost(self._broken(step), prices)

    def is_reliable(self, promise: float, highest_price: float) -> bool:
        """Is what closing the point may still change, beyond the first order, small beside a promise?"""
        if not self.defect**2 * highest_price < _RELIABLE * promise:  # whatever the objective
            return False
        weight = 1.0 if self.local.model.peaks.size else float(np.sqrt(2 * max(self.objective, 0.0)))
        return self.defect**2 * (weight + highest_price) < _RELIABLE * promise

    def restores_feasibility(self, step: FloatArray) -> bool:
        """Does a step put right most of what is badly broken, even where it lowers the merit little?"""
        return self.violation > _BADLY_BROKEN and bool(
            self._broken(step).max(initial=0.0) < 0.5 * self.violation
        )

    def _expected(self, step: FloatArray) -> float:
        """The objective that the model expects after a step (p,)."""
        model = self.local.model
        smooth = model.value + float((model.gradient + 0.5 * (model.hessian @ step)) @ step)
        return smooth + (float((model.peaks + model.peak_rows @ step).max()) if model.peaks.size else 0.0)

    def _broken(self, step: FloatArray) -> FloatArray:
        """By how much each row is broken after a step (p,)."""
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
    """The same, to be closed by the least change that meets every equality."""
    return _with_active(at.program, at.local, all_equalities(at))


def all_equalities(at: Iterate[Point]) -> ActiveSet:
    """Every equality, to be met."""
    keys = row_keys(at.local.rows)[~at.local.rows.one_sided]
    return ActiveSet(keys, np.zeros(keys.size))


def find_free(program: NonlinearProgram[Point], z: FloatArray) -> BoolArray:
    """Which unknowns (p,) have room on both sides."""
    return np.asarray(np.minimum(z - program.lower, program.upper - z) > _ROOM * program.scale)


def row_keys(rows: ConstraintRows) -> IntArray:
    """One number for each row, the same from point to point."""
    return rows.constraint * _KEY_STRIDE + rows.index


def _with_active(
    program: NonlinearProgram[Point], local: Linearization[Point], active: ActiveSet
) -> Iterate[Point]:
    change = np.zeros(local.z.size + 1)
    change[-1] = 1.0
    if active.keys.size:
        rows = local.rows
        here, there = _find_common(row_keys(rows), active.keys)
        free = find_free(program, local.z)
        s = program.scale[free]
        gap = active.aim[there] - rows.value[here]
        change[:-1][free] = least_step(rows.jacobian[here][:, free] * s, gap) * s
    return Iterate(program, local, change, matvec(local.state_jacobian, change))


def follow_step(
    start: Iterate[Point], step: FloatArray, active: ActiveSet, promise: float, highest_price: float
) -> Iterate[Point] | None:
    """Where a step (p + 1,) leads when the state follows; None when the point does not close there.

    The state takes its linear change, then Newton steps bring it towards closed and, by least changes of the
    unknowns that are free, active rows to where the program expected them, until what is left is of second
    order small beside the promise. A state that is sensitive to the unknowns stands far larger steps so than
    solved anew from them (and no Maratos effect).
    """
    at, change = start, step
    for _ in range(_NEWTON_STEPS):
        found = iterate_at(start.program, at.local.moved(change), active)
        if found is None or not found.defect < _LOST:
            return None
        if found.is_reliable(promise, highest_price):
            return found
        at, change = found, found.change
    return at if at.defect < _TOLERABLE else None


def close_iterate(start: Iterate[Point], active: ActiveSet) -> Point | None:
    """The closed point near an iterate; None when there is none."""
    at = start
    for _ in range(2 * _NEWTON_STEPS):
        if not at.defect < _LOST:
            return None
        point = at.local.moved(at.change)
        found = None if at.defect < _CLOSED else iterate_at(start.program, point, active)
        if found is None:
            break
        at = found
    return start.program.close(point)


def _find_common(here: IntArray, there: IntArray) -> tuple[IntArray, IntArray]:
    """Places of the keys that both have, each key once in either."""
    if np.array_equal(here, there):
        order = np.arange(here.size)
        return order, order
    order = np.argsort(here)
    if not here.size:
        return order, order
    found = np.minimum(np.searchsorted(here[order], there), here.size - 1)
    matches = here[order[found]] == there
    return order[found[matches]], np.flatnonzero(matches)
