"""How smooth a curve is at its knots, and the refusal of curves that stand still."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.errors import InputError
from elastica_cad.geometry.jets import Jets, curvature, curvature_slope, norm
from elastica_cad.geometry.turning import Turning

__all__ = ["KnotSides", "continuity_orders", "refuse_standstill"]


@dataclass(frozen=True, eq=False)
class KnotSides:
    """Angle (rad), curvature and its slope just before and just after the interior knots, (3, p - 1) each."""

    before: FloatArray
    after: FloatArray

    @classmethod
    def of(cls, jets: Jets, turning: Turning) -> "KnotSides":
        """What a curve does at its knots."""
        sides = []
        for (_, d1, d2, d3), left in zip(jets.beside_knots(3), (True, False), strict=True):
            angle = turning.at(jets.edges[1:-1], d1, left=left)
            sides.append(np.array([angle, curvature(d1, d2), curvature_slope(d1, d2, d3)]))
        return cls(*sides)

    @property
    def corners(self) -> FloatArray:
        """Exterior angles (p - 1,), rad."""
        return np.asarray(self.after[0] - self.before[0])


def continuity_orders(jets: Jets, sides: KnotSides, knots: FloatArray, length: float) -> IntArray:
    """Numbers (p - 1,) of continuous derivatives by arc length at the interior knots.

    At least degree - multiplicity; more where angle, curvature and its slope agree on both sides, as at the
    double knots of an arc written as a NURBS.
    """
    t = jets.edges[1:-1]
    multiplicity = (knots[None, :] == t[:, None]).sum(axis=1)
    before, after = sides.before, sides.after
    scale = 1 / length + np.maximum(np.abs(before[1]), np.abs(after[1]))
    allowed = np.array([np.full(t.size, 1e-9), 1e-8 * scale, 1e-6 * scale**2])
    agreeing = np.cumprod(np.abs(before - after) <= allowed, axis=0).sum(axis=0)
    return np.asarray(np.maximum(jets.spans.degree - multiplicity, agreeing))


def refuse_standstill(jets: Jets, control_points: FloatArray) -> None:
    """Raise InputError, with the place, when the curve has zero length or a point without tangent."""
    if np.ptp(control_points, axis=0).max() == 0:
        raise InputError("all control points coincide: the curve has zero length")
    t = jets.sectors.standstill
    if t is None:
        return
    x, y = jets.at(np.array([t]), 0)[0][0]
    twins = np.flatnonzero((np.diff(control_points, axis=0) == 0).all(axis=1))
    cause = f"control points {twins[0]} and {twins[0] + 1} coincide" if twins.size else "it has a cusp"
    raise InputError(
        f"the curve has no tangent at ({x:g}, {y:g}) mm, {_length_until(jets, t):.4g} mm from its start: "
        f"{cause}; move or delete a control point there"
    )


def _length_until(jets: Jets, t: float) -> float:
    edges = np.append(jets.edges[jets.edges < t], t)
    dense = [np.linspace(a, b, 65) for a, b in pairwise(edges)]
    return float(sum(norm(np.diff(jets.at(places, 0)[0], axis=0)).sum() for places in dense))
