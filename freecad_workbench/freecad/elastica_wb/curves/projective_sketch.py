# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""A sketch's curve pulled by four handles: where they stand, what the sketch then holds, what it loses."""

from typing import Any

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.curves.plane_curve import PlaneCurve

LEAST_SIDE_SHARE = 0.2  # of the longer side: a box of a straight line is made this wide
AUTOMATIC = ("InternalAlignment", "Weight", "Equal")  # those that FreeCAD made itself


def box_around(curve: PlaneCurve) -> FloatArray:
    """Corners (4, 2) of the box around a curve, anticlockwise from the lower left; never too thin for handles."""
    low, high = np.array(curve.bounds)
    least = LEAST_SIDE_SHARE * float(np.max(high - low))
    grow = np.maximum(0.0, least - (high - low)) / 2
    (left, bottom), (right, top) = low - grow, high + grow
    return np.array([(left, bottom), (right, bottom), (right, top), (left, top)])


def evened(curve: PlaneCurve) -> PlaneCurve:
    """The same curve with weights about 1: the sketcher shows them as radii of the poles' circles."""
    if curve.weights is None:
        return curve
    weights = curve.weights / np.exp(np.log(curve.weights).mean())
    return PlaneCurve(curve.knots, curve.control_points, curve.degree, weights)


def lost_constraints(sketch: Any) -> int:
    """How many constraints of the user speak of what is drawn: a new curve has none of them."""
    drawn = {i for i in range(len(sketch.Geometry)) if not sketch.getConstruction(i)}
    return sum(
        bool(drawn & {c.First, c.Second, c.Third}) for c in sketch.Constraints if c.Type not in AUTOMATIC
    )
