"""Segments of a flat pattern along which x runs evenly: what is bent along x is a spline along them too."""

from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.fabrication.strip.flat_outline import pace
from elastica_cad.geometry.paths.segments import Segment, Spline
from elastica_cad.geometry.polynomials.splines import knot_runs

SAME_PLACE = 1e-12
"""Share of its length by which the knots of another side over the same x may be off: rounding."""

KEY_DIGITS = 6
"""Decimals of a mm in which the ends of sides are compared first."""


@dataclass(frozen=True, eq=False)
class EvenSide:
    """A segment between two parameters, seen along x.

    Attributes
    ----------
    number : int
        What it is called by.
    offset, speed : float
        x = offset + speed * parameter.
    limits : (float, float)
        First and last parameter.
    degree : int
        Of its shape; 1 for a line.
    knots, continuity : (k,) array
        Its own knots, and how smooth it is there.
    """

    number: int
    segment: Segment
    offset: float
    speed: float
    limits: tuple[float, float]
    degree: int
    knots: FloatArray
    continuity: IntArray

    @classmethod
    def of(cls, number: int, segment: Segment, first: float, last: float) -> "EvenSide | None":
        """None where x does not run evenly."""
        even = pace(segment)
        if even is None:
            return None
        if not isinstance(segment, Spline):
            return cls(number, segment, *even, (first, last), 1, np.empty(0), np.empty(0, dtype=int))
        knots, counts = knot_runs(segment.curve.knots)
        degree = segment.curve.degree
        return cls(number, segment, *even, (first, last), degree, knots, degree - counts)

    @property
    def key(self) -> tuple[float, ...]:
        """What sides over the same x share."""
        ends = sorted(self.offset + self.speed * t for t in self.limits)
        return self.degree, self.knots.size, *(round(x, KEY_DIGITS) for x in ends)

    def beside(self, t: FloatArray, other: "EvenSide") -> FloatArray:
        """The parameters at which it has the x that another side has at t (n,)."""
        return (other.offset - self.offset + other.speed * t) / self.speed

    def is_over(self, other: "EvenSide") -> bool:
        """Does it run over the same x with the same knots as another of its key?"""
        way = self._way(other)
        there = self.beside(np.append(other.knots[::way], other.limits[::way]), other)
        off = np.abs(there - np.append(self.knots, self.limits)).max()
        same = off <= SAME_PLACE * (self.limits[1] - self.limits[0])
        return bool(same) and np.array_equal(self.continuity, other.continuity[::way])

    def knots_beside(self, knots: FloatArray, degree: int, other: "EvenSide") -> FloatArray:
        """The clamped knots of another side over the same x, in its own parameter."""
        own = self.beside(knots, other)[:: self._way(other)].copy()
        own[: degree + 1], own[-degree - 1 :] = self.limits
        return own

    def control_points(self, points: FloatArray, other: "EvenSide") -> FloatArray:
        """Control points (m, ...) over the knots of another side, in the order of its own."""
        return points[:: self._way(other)]

    def _way(self, other: "EvenSide") -> int:
        return 1 if self.speed * other.speed > 0 else -1
