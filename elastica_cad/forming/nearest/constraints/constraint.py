"""Numbers that must be zero, or not negative, and the derivatives of those that matter near a rod."""

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.forming.nearest.rod_map import MappedRod, Sensitivities

MOST_ROWS = 56  # of one constraint in one program: with its ends below 64, where factorisations start threads


@dataclass(frozen=True, kw_only=True)
class Constraint(ABC):
    """Values that must be 0, or at least 0 where `one_sided`; all are of order 1 when badly broken.

    Attributes
    ----------
    name : str
        What the user calls it.
    one_sided : bool
        At least 0, not 0.
    price : float
        The most that breaking one by 1 costs.
    near_balance_only : bool
        Does it make no sense far from balance?
    """

    name: str
    one_sided: bool = False
    price: float = 100.0
    near_balance_only: bool = False

    @abstractmethod
    def values(self, rod: MappedRod) -> FloatArray:
        """All values (k,)."""

    @abstractmethod
    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """Indices (j,) into the values and derivatives (j, p) of those that matter near this rod."""


def thin_rows(indices: IntArray, urgency: FloatArray) -> IntArray:
    """At most MOST_ROWS of `indices`: the peaks of `urgency` (n,), then the others at equal steps.

    Rows left out may be broken by a step; the next program then finds them among the peaks.
    """
    if indices.size <= MOST_ROWS:
        return indices
    high = np.concatenate([[-np.inf], urgency, [-np.inf]])
    peak = (urgency >= high[:-2]) & (urgency >= high[2:])
    kept = np.zeros(indices.size, dtype=bool)
    kept[np.flatnonzero(peak[indices])[: MOST_ROWS // 2]] = True
    others = np.flatnonzero(~kept)
    kept[others[:: -(-others.size // (MOST_ROWS - kept.sum()))]] = True
    return indices[kept]


def all_rows(rows: FloatArray) -> tuple[IntArray, FloatArray]:
    """Every row, with its index."""
    return np.arange(rows.shape[0]), rows
