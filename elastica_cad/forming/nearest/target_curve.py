"""The drawn curve as a table in units of its own length, fast to look up and to drop perpendiculars on."""

from dataclasses import dataclass
from functools import cached_property
from math import hypot
from typing import TYPE_CHECKING

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.forming.limits import Symmetry
from elastica_cad.geometry.curves.plane_curve import PlaneCurve

if TYPE_CHECKING:
    from scipy.interpolate import CubicHermiteSpline

SPANS = 1000  # of the table: its cubics are off a drawn curve by less than 1e-9 lengths
_WINDOW_LENGTHS = 0.08  # how far along the curve a foot may lie from its node's arc length
_SYMMETRIC_LENGTHS = 1e-4  # a curve off its mirror image by less, in lengths, is symmetric


@dataclass(frozen=True, eq=False)
class TargetCurve:
    """Points at equal distances along the curve, and cubic Hermite pieces between them.

    Attributes
    ----------
    position : (spans + 1, 2) array
        In lengths, from `origin`.
    angle, curvature : (spans + 1,) arrays
    size : float
        The unit of length, mm.
    origin : (2,) array
        mm.
    """

    position: FloatArray
    angle: FloatArray
    curvature: FloatArray
    size: float
    origin: FloatArray

    @classmethod
    def of(cls, curve: PlaneCurve) -> "TargetCurve":
        """The table of a curve."""
        samples = curve.sample(SPANS + 1)
        origin = samples.position.mean(axis=0)
        size = curve.length
        return cls((samples.position - origin) / size, samples.angle, samples.curvature * size, size, origin)

    def at(self, s: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Positions and unit-speed derivatives, each (n, 2), at arc lengths s (n,) in 0..1."""
        spline = self._spline
        return spline(s), spline(s, 1)

    def angles(self, s: FloatArray) -> FloatArray:
        """Angles (n,) at arc lengths s (n,) in 0..1."""
        return np.interp(s, even_steps(self.angle.size), self.angle)

    def feet(self, points: FloatArray, near: FloatArray) -> FloatArray:
        """Arc lengths (n,) of the nearest points within a window about `near` (n,)."""
        offsets = np.linspace(-_WINDOW_LENGTHS, _WINDOW_LENGTHS, 17)
        tries = np.clip(near[:, None] + offsets, 0, 1)
        spots = np.rint(tries * (self.position.shape[0] - 1)).astype(int)
        off = self.position[spots] - points[:, None]
        s = tries[np.arange(points.shape[0]), np.argmin((off**2).sum(axis=2), axis=1)]
        for _ in range(4):
            position, direction = self.at(s)
            s = np.clip(
                s + ((points - position) * direction).sum(axis=1) / self._stretch(s, points, position), 0, 1
            )
        return np.asarray(s)

    def _stretch(self, s: FloatArray, points: FloatArray, position: FloatArray) -> FloatArray:
        """1 - kappa d of Newton's method for feet, kept away from the evolute."""
        i = np.rint(s * (self.position.shape[0] - 1)).astype(int)
        direction = self._directions[i]
        off = points - position
        bend = self.curvature[i] * (off[:, 1] * direction[:, 0] - off[:, 0] * direction[:, 1])
        return np.asarray(np.maximum(1 - bend, 0.3))

    @cached_property
    def _spline(self) -> "CubicHermiteSpline":
        from scipy.interpolate import CubicHermiteSpline

        return CubicHermiteSpline(even_steps(self.angle.size), self.position, self._directions)

    @cached_property
    def _directions(self) -> FloatArray:
        return np.column_stack([np.cos(self.angle), np.sin(self.angle)])

    @cached_property
    def diagonal(self) -> float:
        """Diagonal of the bounding box, in lengths."""
        x, y = self.position.T
        return hypot(x.max() - x.min(), y.max() - y.min())


def even_steps(count: int) -> FloatArray:
    """0..1 in equal steps (count,)."""
    return np.linspace(0, 1, count)


def symmetry_frame(target: TargetCurve, kind: Symmetry) -> tuple[FloatArray, FloatArray]:
    """Centre and axis direction (both (2,)) of the curve's mirror image or half turn, in the target's units.

    Raises
    ------
    InputError
        When the curve has no such symmetry.
    """
    p, q = target.position, target.position[::-1]
    middles, across = (p + q) / 2, p - q
    centre = middles.mean(axis=0)
    if kind == "turn":
        error = float(np.abs(middles - centre).max())
        axis = np.array([1.0, 0.0])
    else:
        values, vectors = np.linalg.eigh(across.T @ across)
        axis = vectors[:, int(np.argmin(values))]
        normal = np.array([-axis[1], axis[0]])
        error = float(max(np.abs(across @ axis).max(), np.abs((middles - centre) @ normal).max()))
    if error > _SYMMETRIC_LENGTHS:
        name = "mirror image" if kind == "mirror" else "half turn"
        raise InputError(
            f"the drawn curve is not its own {name}: it is {error * target.size:.3g} mm off; "
            "draw it symmetric, or do without keep symmetry"
        )
    return centre, axis
