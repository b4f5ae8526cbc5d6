"""A rod nearly in balance with its local program, and where a step leads when the whole rod follows it."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.forming.dense import applied
from elastica_cad.forming.distance import LocalModel
from elastica_cad.forming.march import MarchedRod, Sensitivities
from elastica_cad.forming.problem import Problem, Rows, rows_near

__all__ = ["Held", "Place", "balanced", "equalities", "followed", "meeting_equalities", "moved", "place"]

_NEWTON = 4  # corrections on the way to one place
_CLOSED = 1e-8  # rad that still change when a rod is as good as in balance
_LOST = 1.5  # rad: a rod that would have to turn so far does not close
_BADLY = 1e-4  # of a constraint's value
_NEARLY = 0.1  # rad by which a place may be off when it tells too little
_WILD = 1e50
_TELLING = 0.5  # share of what a step promises that may be unknown


@dataclass(frozen=True, eq=False)
class Held:
    """Rows that a rod keeps at given values while it closes."""

    keys: IntArray
    aim: FloatArray


_NOTHING = Held(np.zeros(0, dtype=int), np.zeros(0))


@dataclass(frozen=True, eq=False)
class Place:
    """Where the search stands: a rod whose angles and moments need not be quite in balance with its unknowns.

    Attributes
    ----------
    problem : Problem
    rod : MarchedRod
    sensitivities : Sensitivities
        With the closing column.
    rows : Rows
    change : (p + 1,) array
        The least step that closes the rod to first order and holds what is held; its last entry is 1.
    turned : (n + 2,) array
        What `change` does to the angles.
    """

    problem: Problem
    rod: MarchedRod
    sensitivities: Sensitivities
    rows: Rows
    change: FloatArray
    turned: FloatArray

    @property
    def off(self) -> float:
        """The angle, rad, by which the rod is out of balance."""
        return float(np.abs(self.turned).max())

    @cached_property
    def model(self) -> LocalModel:
        """Of the distance, in steps from the closed rod."""
        return self.problem.distance.model(self.rod, self.sensitivities)

    @cached_property
    def distance(self) -> float:
        """The distance of the closed rod, to second order in `off`."""
        return self.model.at(self.change[:-1])

    def merit(self, prices: FloatArray) -> float:
        """Distance and price of what is broken, once closed."""
        return self.distance + self._cost(self.change[:-1], prices)

    def promised(self, step: FloatArray, prices: FloatArray) -> float:
        """The merit that the local program expects after a step."""
        return self.model.at(step) + self._cost(step, prices)

    def tells(self, promise: float, largest_price: float) -> bool:
        """Is what closing the rod may still change, beyond the first order, small beside a promise?"""
        weight = 1.0 if self.model.peaks.size else float(np.sqrt(2 * max(self.distance, 0.0)))
        return self.off**2 * (weight + largest_price) < _TELLING * promise

    def mends(self, step: FloatArray) -> bool:
        """Does a step put right most of what is badly broken, be it worth little?"""
        now, then = (self._broken(change).max(initial=0.0) for change in (self.change[:-1], step))
        return bool(now > _BADLY and then < 0.5 * now)

    def _cost(self, step: FloatArray, prices: FloatArray) -> float:
        if not self.rows.value.size:
            return 0.0
        return float(prices[self.rows.constraint] @ self._broken(step))

    def _broken(self, step: FloatArray) -> FloatArray:
        return self.rows.broken(self.rows.value + self.rows.jacobian @ step)


def place(problem: Problem, rod: MarchedRod, held: Held = _NOTHING) -> Place | None:
    """The place of a rod, out of balance or not; None where it winds up, or is sensitive, beyond all measure."""
    if not np.isfinite(rod.moments[-1]):
        return None
    sensitivities = problem.grid.sensitivities(rod, closing=True)
    if not np.abs(sensitivities.angles).max() < _WILD:
        return None
    rows = rows_near(problem, sensitivities)
    return _holding(problem, sensitivities, rows, held)


def meeting_equalities(at: Place) -> Place:
    """The same, to be closed by the least change that meets every equality."""
    return _holding(at.problem, at.sensitivities, at.rows, equalities(at))


def equalities(at: Place) -> Held:
    """Every equality met."""
    keys = at.rows.keys[~at.rows.one_sided]
    return Held(keys, np.zeros(keys.size))


def _holding(problem: Problem, sensitivities: Sensitivities, rows: Rows, held: Held) -> Place:
    rod = sensitivities.rod
    change = np.zeros(rod.z.size + 1)
    change[-1] = 1.0
    if held.keys.size:
        here, there = _common(rows.keys, held.keys)
        free = problem.free(rod.z)
        s = problem.scale[free]
        gap = held.aim[there] - rows.value[here]
        change[:-1][free] = np.linalg.lstsq(rows.jacobian[np.ix_(here, free)] * s, gap, rcond=1e-10)[0] * s
    return Place(problem, rod, sensitivities, rows, change, applied(sensitivities.angles, change))


def followed(
    start: Place, step: FloatArray, held: Held, promise: float, largest_price: float
) -> Place | None:
    """Where a step (p + 1,) leads when angles and moments follow; None when the rod does not close there.

    They take their linear change, then Newton steps bring the rod towards balance and, by least changes of the
    unknowns that are free, what is held to where the program thought it, until what is left is of second order
    small beside the promise. A rod that is sensitive to its start stands far larger steps so than marched from
    there (and no Maratos effect).
    """
    at, change = start, step
    for _ in range(_NEWTON):
        found = place(start.problem, moved(at, change), held)
        if found is None or not found.off < _LOST:
            return None
        if found.tells(promise, largest_price):
            return found
        at, change = found, found.change
    return at if at.off < _NEARLY else None


def balanced(start: Place, held: Held) -> MarchedRod | None:
    """The rod in balance near a place; None when there is none."""
    at = start
    for _ in range(2 * _NEWTON):
        if not at.off < _LOST:
            return None
        rod = moved(at, at.change)
        found = None if at.off < _CLOSED else place(start.problem, rod, held)
        if found is None:
            break
        at = found
    marched = start.problem.grid.rod(rod.z)
    return marched if np.isfinite(marched.moments[-1]) else None


def moved(at: Place, change: FloatArray) -> MarchedRod:
    """The rod after a change (p + 1,), to first order."""
    rod, d, problem = at.rod, at.sensitivities, at.problem
    z = problem.inside(rod.z + change[:-1])
    return problem.grid.guessed(
        z, rod.angles + applied(d.angles, change), rod.moments + applied(d.moments, change)
    )


def _common(here: IntArray, there: IntArray) -> tuple[IntArray, IntArray]:
    """Places of the keys that both have, each key once in either."""
    order = np.argsort(here)
    if not here.size:
        return order, order
    found = np.minimum(np.searchsorted(here[order], there), here.size - 1)
    matches = here[order[found]] == there
    return order[found[matches]], np.flatnonzero(matches)
