"""How smooth a curve is at its knots, and the refusal of curves that stand still."""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.errors import InputError
from elastica_cad.geometry.curves.curve_derivatives import RationalPieces, curvature, curvature_slope, norm
from elastica_cad.geometry.curves.tangent_angle import TangentAngle

ORDERS_OF_SIDES = 3
"""Of continuity that `KnotSides` tell of: beyond, it is taken from the multiplicity of a knot."""

SHORT_SPAN_SHARE = 1e-6
"""Of the domain: what knots as near to each other make of the direction is seen on both sides of each only."""


@dataclass(frozen=True, eq=False)
class KnotSides:
    """Angle (rad), curvature and its slope just before and just after the interior knots, (3, p - 1) each."""

    before: FloatArray
    after: FloatArray

    @classmethod
    def of(cls, pieces: RationalPieces, turning: TangentAngle) -> "KnotSides":
        """What a curve does at its knots."""
        sides = []
        for (_, d1, d2, d3), left in zip(pieces.beside_knots(3), (True, False), strict=True):
            angle = turning.at(pieces.edges[1:-1], d1, left=left)
            sides.append(np.array([angle, curvature(d1, d2), curvature_slope(d1, d2, d3)]))
        return cls(*sides)

    @classmethod
    def of_seam(cls, pieces: RationalPieces, turning: TangentAngle) -> "KnotSides":
        """The same (3, 1) where a closed curve meets its start: before it closes, and after it begins."""
        sides = []
        for t, left in ((pieces.edges[-1:], True), (pieces.edges[:1], False)):
            _, d1, d2, d3 = pieces.at(t, 3, left=left)
            sides.append(
                np.array([turning.at(t, d1, left=left), curvature(d1, d2), curvature_slope(d1, d2, d3)])
            )
        turn = (sides[1][0] - sides[0][0] + np.pi) % (2 * np.pi) - np.pi
        sides[1][0] = sides[0][0] + turn
        return cls(*sides)

    @property
    def corners(self) -> FloatArray:
        """Exterior angles (p - 1,), rad."""
        return np.asarray(self.after[0] - self.before[0])


def knot_orders(pieces: RationalPieces, knots: FloatArray) -> IntArray:
    """How many derivatives by the parameter go on at the interior knots (p - 1,), by how often these stand."""
    t = pieces.edges[1:-1]
    repeated = np.searchsorted(knots, t, side="right") - np.searchsorted(knots, t)
    return np.asarray(pieces.spans.degree - repeated)


def agreeing_orders(sides: KnotSides, length: float) -> IntArray:
    """How many of angle, curvature and its slope, in this order, are alike on both sides."""
    before, after = sides.before, sides.after
    scale = 1 / length + np.maximum(np.abs(before[1]), np.abs(after[1]))
    allowed = np.array([np.full(scale.size, 1e-9), 1e-8 * scale, 1e-6 * scale**2])
    return np.asarray(np.cumprod(np.abs(before - after) <= allowed, axis=0).sum(axis=0))


def in_millimetres(point: FloatArray) -> str:
    """A place as it stands in messages."""
    return f"({point[0]:g}, {point[1]:g}) mm"


SHORT_HANDLE = 1e-3
"""A handle shorter than this, in sizes of its curve, was drawn in: no digits are missing."""


def refuse_standstill(
    pieces: RationalPieces,
    control_points: FloatArray,
    shown: Callable[[FloatArray], str] = in_millimetres,
    rounding: float = 0.0,
) -> None:
    """Raise InputError, with the place, when the curve has zero length or a point without tangent.

    `shown` writes a point (2,) in mm the way the drawing program does; `rounding` is how far one may be from what
    was drawn, mm.
    """
    if np.ptp(control_points, axis=0).max() == 0:
        raise InputError("all control points coincide: the curve has zero length")
    t = pieces.tangent_cones.standstill
    if t is None:
        return
    place = shown(pieces.at(np.array([t]), 0)[0][0])
    twins = np.flatnonzero((np.diff(control_points, axis=0) == 0).all(axis=1))
    size = float(np.ptp(control_points, axis=0).max())
    where = f"the curve has no tangent at {place}, {_length_until(pieces, t):.4g} mm from its start"
    if not twins.size:
        raise InputError(f"{where}: it has a cusp; move or delete a control point there")
    cause = f"control points {twins[0]} and {twins[0] + 1} coincide"
    if 2 * np.sqrt(2.0) * rounding > SHORT_HANDLE * size:
        raise InputError(
            f"undecided at this precision: {where}, for {cause}, and the numbers in the file are exact to "
            f"{rounding:.2g} mm, so a shorter handle is lost: save it with more decimals, or draw out the "
            "handle of that node"
        )
    raise InputError(
        f"{where}: {cause}; move or delete one of them (in a drawing program: draw out the handle of that node)"
    )


def _length_until(pieces: RationalPieces, t: float) -> float:
    edges = np.append(pieces.edges[pieces.edges < t], t)
    dense = [np.linspace(a, b, 65) for a, b in pairwise(edges)]
    return float(sum(norm(np.diff(pieces.at(places, 0)[0], axis=0)).sum() for places in dense))
