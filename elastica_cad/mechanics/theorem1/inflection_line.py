"""The line of Theorem 1 as a record."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import numbers


@dataclass(frozen=True)
class InflectionLine:
    """A line, zero of a + <b, x>, with |b| = 1.

    Attributes
    ----------
    point : (2,) tuple
        A point of it, mm.
    direction : (2,) tuple
        Unit vector along it.
    """

    point: tuple[float, float]
    direction: tuple[float, float]

    @property
    def b(self) -> FloatArray:
        """Unit normal (2,): the direction turned left."""
        return np.array([-self.direction[1], self.direction[0]])

    @property
    def a(self) -> float:
        """Constant of a + <b, x>, mm."""
        return -float(self.b @ np.asarray(self.point))

    def distance(self, position: FloatArray) -> FloatArray:
        """Signed distances (n,) of points (n, 2), mm."""
        return np.asarray((numbers(position, "positions") - np.asarray(self.point)) @ self.b)

    def as_dict(self) -> dict[str, Any]:
        """For reports."""
        return {
            "point": list(self.point),
            "direction": list(self.direction),
            "a": self.a,
            "b": self.b.tolist(),
        }
