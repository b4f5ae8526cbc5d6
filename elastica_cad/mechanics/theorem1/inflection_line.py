"""The line of Theorem 1 as a record."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import numbers
from elastica_cad.errors import InputError


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
        points = numbers(position, "positions")
        if points.shape[-1:] != (2,):
            raise InputError(f"positions are points (n, 2), in mm, not of shape {points.shape}")
        return np.asarray((points - np.asarray(self.point)) @ self.b)

    def as_dict(self) -> dict[str, Any]:
        """For reports."""
        return {
            "point": list(self.point),
            "direction": list(self.direction),
            "a": self.a,
            "b": self.b.tolist(),
        }
