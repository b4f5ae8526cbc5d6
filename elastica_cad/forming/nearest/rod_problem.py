"""The nearest rod as a nonlinear program: a distance under constraints over rods that need not be in balance."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial

import numpy as np

from elastica_cad._types import BoolArray, FloatArray, IntArray
from elastica_cad.forming.nearest.constraints.constraint import Constraint
from elastica_cad.forming.nearest.curve_distance import Distance
from elastica_cad.forming.nearest.rod_map import MappedRod, Sensitivities, StripGrid
from elastica_cad.forming.optimizer.nonlinear_program import ConstraintRows, Linearization, NonlinearProgram

_TOO_SENSITIVE = 1e50  # rad per unknown: squares of such derivatives overflow


@dataclass(frozen=True, eq=False, kw_only=True)
class RodProblem(NonlinearProgram[MappedRod]):
    """Minimise `distance` over the unknowns of `grid` in a box under `constraints`.

    A point is a rod; its state, angles and moments, follows from the unknowns by the balance of moments.
    """

    grid: StripGrid
    distance: Distance
    constraints: tuple[Constraint, ...]

    @cached_property
    def one_sided(self) -> BoolArray:
        """Of each constraint: are its values at least 0, not 0?"""
        return np.array([c.one_sided for c in self.constraints], dtype=bool)

    @cached_property
    def highest_prices(self) -> FloatArray:
        """The most that breaking a value of each constraint by 1 costs."""
        return np.array([c.price for c in self.constraints], dtype=float)

    def objective(self, point: MappedRod) -> float:
        """The distance."""
        return self.distance.value(point)

    def values(self, point: MappedRod) -> list[FloatArray]:
        """Values of each constraint."""
        return [c.values(point) for c in self.constraints]

    def rows(self, point: MappedRod, values: Sequence[FloatArray]) -> tuple[FloatArray, ConstraintRows]:
        """The unknowns of a rod in balance with these values, and its constraints around it."""
        return point.z, _stack_rows(self.constraints, self.grid.sensitivities(point), values)

    def linearize(self, point: MappedRod) -> Linearization[MappedRod] | None:
        """A rod with its derivatives; None where it winds up, or reacts to its unknowns, too much for numbers."""
        if not np.isfinite(point.moments[-1]):
            return None
        sensitivities = self.grid.sensitivities(point, closing=True)
        if not np.abs(sensitivities.angles).max() < _TOO_SENSITIVE:
            return None
        return Linearization(
            point, point.z, _stack_rows(self.constraints, sensitivities),
            self.distance.model(point, sensitivities), sensitivities.angles,
            partial(self._moved, sensitivities),
        )  # fmt: skip

    def close(self, point: MappedRod, step: FloatArray | None = None) -> MappedRod | None:
        """The rod in balance; None where it winds up so far that numbers overflow."""
        rod = self.grid.shoot(point.z if step is None else self._inside(point.z + step))
        return rod if np.isfinite(rod.moments[-1]) else None

    def clip(self, point: MappedRod) -> MappedRod:
        """The rod with its unknowns moved into the box, angles and moments as they are."""
        z = self._inside(point.z)
        return point if np.array_equal(z, point.z) else self.grid.assemble(z, point.all_angles, point.moments)

    def fallback(self) -> MappedRod:
        """An even rod without forces."""
        u = self.grid.unknowns
        z = np.zeros(u.count)
        z[u.stiffness], z[u.length] = 1.0, 1.0
        return self.grid.shoot(self._inside(z))

    def apart(self, one: MappedRod, other: MappedRod) -> float:
        """Mean square distance of the nodes."""
        return float(np.mean((one.position - other.position) ** 2))

    def for_open_points(self) -> "RodProblem":
        """The same without the constraints that make no sense far from balance."""
        return replace(self, constraints=tuple(c for c in self.constraints if not c.near_balance_only))

    def _moved(self, d: Sensitivities, change: FloatArray) -> MappedRod:
        """The rod after a change (p + 1,), to first order."""
        z = self._inside(d.rod.z + change[:-1])
        angles, moments = d.angles @ change, d.moments @ change
        return self.grid.assemble(z, d.rod.all_angles + angles, d.rod.moments + moments)

    def _inside(self, z: FloatArray) -> FloatArray:
        """The nearest unknowns in the box."""
        return np.asarray(np.clip(z, self.lower, self.upper))

    def with_given(self, unknowns: int | slice, value: FloatArray | float) -> "RodProblem":
        """The same with these unknowns given, as far as that is allowed."""
        lower, upper = self.lower.copy(), self.upper.copy()
        lower[unknowns] = upper[unknowns] = np.clip(value, lower[unknowns], upper[unknowns])
        return replace(self, lower=lower, upper=upper)


def _stack_rows(
    constraints: Sequence[Constraint],
    sensitivities: Sensitivities,
    values: Sequence[FloatArray] | None = None,
) -> ConstraintRows:
    """Rows of all constraints that matter near a rod; values once it is closed where there is a closing column."""
    p = sensitivities.rod.z.size
    if not constraints:
        none, empty = np.zeros(0), np.zeros(0, dtype=int)
        return ConstraintRows(empty, empty, none, np.zeros((0, p)), none, none > 0)
    indices: list[IntArray] = []
    heights: list[FloatArray] = []
    slopes: list[FloatArray] = []
    for k, constraint in enumerate(constraints):
        value = constraint.values(sensitivities.rod) if values is None else values[k]
        index, jacobian = constraint.rows(sensitivities)
        indices.append(index)
        heights.append(value[index])
        slopes.append(jacobian)
    at, jacobian = np.concatenate(heights), np.concatenate(slopes)
    if jacobian.shape[1] > p:
        at, jacobian = at + jacobian[:, p], jacobian[:, :p]
    counts = [index.size for index in indices]
    number = np.repeat(np.arange(len(constraints)), counts)
    price = np.array([one.price for one in constraints], dtype=float)[number]
    one_sided = np.array([one.one_sided for one in constraints], dtype=bool)[number]
    return ConstraintRows(number, np.concatenate(indices), at, jacobian, price, one_sided)
