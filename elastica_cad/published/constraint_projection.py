"""Inflections on a line, ends, tangents and length restored by the least move of the control points."""

from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import is_number, require_record
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.forming.equilibrium_curve import BothEnds, collinear, kept
from elastica_cad.geometry.curve_editing.control_point_constraints import (
    Constraint,
    InflectionsOnLine,
    least_norm_newton,
)
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads.arguments import require_curve
from elastica_cad.mechanics.theorem1.verdict import InflectionLine


@dataclass(frozen=True, eq=False)
class EnforcedCurve:
    """What `enforce_constraints` found.

    Attributes
    ----------
    curve : PlaneCurve
        The curve that meets the constraints.
    residuals : tuple of float
        Norm of what is left of them at the start and after every step, mm.
    moved : float
        Largest move of a point of the curve, mm, at the same parameter.
    """

    curve: PlaneCurve
    residuals: tuple[float, ...]
    moved: float


def enforce_constraints(
    curve: PlaneCurve,
    *,
    line: InflectionLine | None = None,
    ends: BothEnds = True,
    tangents: BothEnds = True,
    length: bool = True,
    like: PlaneCurve | None = None,
    tolerance: float = 1e-10,
    max_steps: int = 30,
) -> EnforcedCurve:
    """Move the control points a little until the inflections are collinear and the rest is as it should be.

    Parameters
    ----------
    line : InflectionLine, optional
        The line to put them on; whichever is nearest unless given (then two inflections or fewer ask for
        nothing).
    ends, tangents : bool or (bool, bool)
        Keep end points, end tangents of `like`: of both ends, or of (start, end).
    length : bool
        Keep the arc length of `like`.
    like : PlaneCurve, optional
        The curve whose ends, tangents and length are restored; `curve` itself unless given.
    tolerance : float
        Norm of all residuals at which to stop, relative to the size of the curve.

    Raises
    ------
    NotConvergedError
        The constraints contradict each other, an inflection gets lost on the way, or another one comes.

    References
    ----------
    Paper, Appendix C (underdetermined Newton).

    Examples
    --------
    >>> wave = PlaneCurve.spline([(0, 0), (20, 60), (40, -60), (60, 62), (80, -55), (100, 0)], degree=4)
    >>> found = enforce_constraints(wave)
    >>> abs(found.curve.length - wave.length) < 1e-6
    True
    """
    require_curve(curve)
    if like is not None:
        require_curve(like)
    if line is not None:
        require_record(line, InflectionLine, "line", "an InflectionLine, or None")
    if not (is_number(tolerance) and tolerance > 0):
        raise InputError("tolerance is {tolerance!r}: it must be positive", tolerance=tolerance)
    wanted: list[Constraint] = [
        *kept(curve if like is None else like, ends=ends, tangents=tangents, length=length)
    ]
    if line is None:
        wanted += collinear(curve)
    else:
        t = np.array([z.t for z in curve.curvature_zeros if z.kind == "crossing"])
        if t.size:
            wanted.append(InflectionsOnLine(line.a, line.b, t))
    moved, residuals = least_norm_newton(curve, wanted, tolerance=tolerance, max_steps=max_steps)
    before, after = _crossings(curve), _crossings(moved)
    if after.size > before.size and (line is not None or after.size > 2):
        listed = ", ".join(f"{s:.4g}" for s in after)
        raise NotConvergedError(
            "on the way the curve got {size} inflections (at {listed} mm) in place of {size_2}: "
            "keep less (ends, tangents, length), or use nearest_rod",
            size=after.size,
            listed=listed,
            size_2=before.size,
        )
    t = np.linspace(*curve.domain, 1001)
    off = moved.evaluate(t) - curve.evaluate(t)
    return EnforcedCurve(moved, residuals, float(np.hypot(off[:, 0], off[:, 1]).max()))


def _crossings(curve: PlaneCurve) -> FloatArray:
    """Arc lengths (k,) of the inflections, mm."""
    return np.array([z.s for z in curve.curvature_zeros if z.kind == "crossing"])
