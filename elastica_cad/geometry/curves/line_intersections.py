"""Common points of a curve and a straight line."""

import numpy as np

from elastica_cad._types import ArrayLike
from elastica_cad._values import require_record
from elastica_cad.errors import InputError
from elastica_cad.geometry.curves.curvature_zeros import line_places
from elastica_cad.geometry.curves.curve_records import LineCrossing
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.polynomials.splines import finite


def line_crossings(curve: PlaneCurve, a: float, b: ArrayLike) -> tuple[LineCrossing, ...]:
    """All points that a curve has in common with the line a + <b, x> = 0, in order along the curve.

    Parameters
    ----------
    a : float
        Constant of the line.
    b : (2,) array_like
        Its normal (any length but 0).

    Examples
    --------
    >>> arch = PlaneCurve.arc((0, 0), 50, 0.0, np.pi)
    >>> [(root.kind, round(root.s, 3)) for root in line_crossings(arch, -50, (0, 1))]
    [('touch', 78.54)]
    """
    require_record(curve, PlaneCurve, "what a line crosses", "a PlaneCurve")
    normal, constant = finite("b", b), finite("a", a)
    if constant.shape:
        raise InputError(f"the constant of a line is one number, not {constant.tolist()}")
    if normal.shape != (2,) or not normal.any():
        raise InputError(f"the normal of a line must be two numbers, not both zero: {normal.tolist()}")
    edges, bezier = curve.bezier_table
    found = line_places(bezier, edges, float(constant), normal)
    s = curve.arc_length(np.array([[place.t, place.t_end] for place in found]).reshape(-1, 2))
    return tuple(
        LineCrossing(float(at), p.t, p.kind, float(to), p.t_end, p.before, p.after)
        for p, (at, to) in zip(found, s, strict=True)
    )
