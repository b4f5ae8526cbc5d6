"""What is asked in numbers: a distance over unknowns in a box, under constraints, and its rows around one rod."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._types import BoolArray, FloatArray, IntArray
from elastica_cad.forming.constraints import Constraint
from elastica_cad.forming.distance import Distance
from elastica_cad.forming.march import MarchedRod, Sensitivities, StripGrid

__all__ = ["Problem", "Rows", "rows_near"]


@dataclass(frozen=True, eq=False)
class Problem:
    """Minimise `distance` over z in a box under `constraints`.

    Attributes
    ----------
    lower, upper : (p,) arrays
        Equal where an unknown is given.
    scale : (p,) array
        Typical sizes of the unknowns.
    """

    grid: StripGrid
    distance: Distance
    constraints: tuple[Constraint, ...]
    lower: FloatArray
    upper: FloatArray
    scale: FloatArray

    def values(self, rod: MarchedRod) -> list[FloatArray]:
        """Values of all constraints."""
        return [c.values(rod) for c in self.constraints]

    def violation(self, values: Sequence[FloatArray]) -> float:
        """The worst broken constraint."""
        return max(
            (
                float((np.maximum(-v, 0.0) if c.one_sided else np.abs(v)).max())
                for c, v in zip(self.constraints, values, strict=True)
            ),
            default=0.0,
        )

    def inside(self, z: FloatArray) -> FloatArray:
        """The nearest unknowns in the box."""
        return np.asarray(np.clip(z, self.lower, self.upper))

    def free(self, z: FloatArray) -> FloatArray:
        """Which unknowns (p,) have room on both sides."""
        return np.asarray(np.minimum(z - self.lower, self.upper - z) > 1e-6 * self.scale)

    def with_length(self, length: float) -> "Problem":
        """The same with the length given, as far as it is allowed."""
        lower, upper, at = self.lower.copy(), self.upper.copy(), self.grid.unknowns.length
        lower[at] = upper[at] = np.clip(length, lower[at], upper[at])
        return replace(self, lower=lower, upper=upper)

    def eager(self) -> "Problem":
        """The same without the constraints that make no sense far from balance."""
        return replace(self, constraints=tuple(c for c in self.constraints if not c.patient))


@dataclass(frozen=True, eq=False)
class Rows:
    """The constraints' rows that matter near a rod, stacked: value + jacobian @ step.

    Attributes
    ----------
    constraint, index : (j,) arrays
        The number of each row's constraint, and its place among the values of that.
    value : (j,) array
        Once the rod is closed, where the sensitivities have a closing column.
    jacobian : (j, p) array
    price : (j,) array
        The most that breaking a row by 1 costs.
    one_sided : (j,) boolean array
    """

    constraint: IntArray
    index: IntArray
    value: FloatArray
    jacobian: FloatArray
    price: FloatArray
    one_sided: BoolArray

    @property
    def keys(self) -> IntArray:
        """One number for each row, the same from rod to rod."""
        return self.constraint * 1_000_000 + self.index

    def broken(self, value: FloatArray) -> FloatArray:
        """By how much rows of given values are broken."""
        return np.where(self.one_sided, np.maximum(-value, 0.0), np.abs(value))


def rows_near(
    problem: Problem, sensitivities: Sensitivities, values: Sequence[FloatArray] | None = None
) -> Rows:
    """Rows of all constraints around a rod; their `values` if they are at hand."""
    p = sensitivities.rod.z.size
    parts: list[tuple[FloatArray | IntArray, ...]] = []
    for k, constraint in enumerate(problem.constraints):
        value = constraint.values(sensitivities.rod) if values is None else values[k]
        index, jacobian = constraint.rows(sensitivities)
        at = value[index]
        if jacobian.shape[1] > p:
            at, jacobian = at + jacobian[:, p], jacobian[:, :p]
        same = np.ones(index.size)
        parts.append((k * same, index, at, jacobian, constraint.price * same, constraint.one_sided * same))
    if not parts:
        none, empty = np.zeros(0), np.zeros(0, dtype=int)
        return Rows(empty, empty, none, np.zeros((0, p)), none, none > 0)
    number, index, at, jacobian, price, one_sided = (
        np.concatenate(part) for part in zip(*parts, strict=True)
    )
    return Rows(number.astype(int), index.astype(int), at, jacobian, price, one_sided > 0)
