"""Bring nearly collinear inflections onto one line by a small move of the control points (Appendix C)."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._types import BoolArray, FloatArray
from elastica_cad.errors import NotConvergedError
from elastica_cad.geometry import CurvatureZero, PlaneCurve
from elastica_cad.mechanics.line import InflectionLine, fitted_line

__all__ = ["snapped_to_line"]

STEPS = 12
REACHED = 1e-12
"""Distance from the line, in lengths of the curve, at which an inflection lies on it."""


def snapped_to_line(
    curve: PlaneCurve,
    zeros: Sequence[CurvatureZero],
    *,
    normal: FloatArray | None = None,
    natural_curvature: float = 0.0,
) -> PlaneCurve:
    """The curve with control points moved so that all `zeros` of kappa - kappa_0 lie on one line.

    The line is the nearest one to the zeros (of given `normal`, if any) and is held. Newton steps of least
    norm follow each zero along the curve: with F = det(gamma', gamma'') - kappa_0 |gamma'|^3, dt = -dF / F_t.
    End points and end tangents are held as long as the curve has the freedom for it.

    Raises
    ------
    NotConvergedError
        The control points cannot bring the inflections onto the line.

    References
    ----------
    Paper, Appendix C.
    """
    t = np.array([z.t for z in zeros])
    places = _Places(t, np.array([z.kind == "end" for z in zeros]), natural_curvature)
    line = fitted_line(np.asarray(curve.evaluate(t)), normal)
    for held in (2, 1, 0):
        moved = _newton(curve, places, line, held)
        if moved is not None:
            return moved
    raise NotConvergedError("no small move of the control points brings the inflections onto one line")


@dataclass(frozen=True, eq=False)
class _Places:
    """Parameters t (k,) of the zeros of kappa - kappa_0, and which are at an end of the curve."""

    t: FloatArray
    at_end: BoolArray
    kappa_0: float


def _newton(curve: PlaneCurve, places: _Places, line: InflectionLine, held: int) -> PlaneCurve | None:
    """Newton's iteration with `held` derivatives of the free ends kept; None unless it settles nearby."""
    size = curve.length
    for _ in range(STEPS):
        followed = _followed(curve, places)
        if followed is None:
            return None
        places = followed
        rows, gaps = _constraints(curve, places, line, held)
        if np.abs(gaps[: places.t.size]).max() <= REACHED * size:
            return curve
        step, *_ = np.linalg.lstsq(rows, -gaps, rcond=1e-12)
        if np.abs(rows @ step + gaps).max() > 1e-6 * np.abs(gaps).max() or np.abs(step).max() > 0.05 * size:
            return None
        points = curve.control_points + step.reshape(-1, 2)
        curve = PlaneCurve(curve.knots, points, curve.degree, curve.weights)
    return None


def _followed(curve: PlaneCurve, places: _Places) -> _Places | None:
    """The zeros of the moved curve next to those before; None when one was lost."""
    found = np.array([z.t for z in curve.curvature_equals(places.kappa_0) if z.changes_sign])
    t, at_end = places.t, places.at_end
    inner = t[~at_end]
    if inner.size:
        if not found.size:
            return None
        nearest = np.abs(found[None, :] - inner[:, None]).argmin(axis=1)
        if np.unique(nearest).size < inner.size:
            return None
        t = t.copy()
        t[~at_end] = found[nearest]
    return replace(places, t=t)


def _constraints(
    curve: PlaneCurve, places: _Places, line: InflectionLine, held: int
) -> tuple[FloatArray, FloatArray]:
    """Jacobian (k, 2m) over control points and present values (k,) of all constraints, in mm."""
    t, at_end, kappa_0 = places.t, places.at_end, places.kappa_0
    N = _basis(curve, t)
    d1, d2, d3 = (np.asarray(curve.evaluate(t, k)) for k in (1, 2, 3))
    speed = np.hypot(d1[:, 0], d1[:, 1])
    # F = det(gamma', gamma'') - kappa_0 |gamma'|^3 and its derivatives by t and by the control points
    turn = _perpendicular(d2)  # det(u, gamma'') = <u, turn>
    F = (d1 * turn).sum(axis=1) - kappa_0 * speed**3
    F_t = (d1 * _perpendicular(d3)).sum(axis=1) - 3 * kappa_0 * speed * (d1 * d2).sum(axis=1)
    F_q = (
        N[1][..., None] * (turn - 3 * kappa_0 * speed[:, None] * d1)[:, None, :]
        - N[2][..., None] * _perpendicular(d1)[:, None, :]
    )
    on_line = N[0][..., None] * line.b
    slide = (d1 @ line.b)[:, None, None] * F_q / F_t[:, None, None]
    rows = [np.where(at_end[:, None, None], on_line, on_line - slide)]
    gaps = [line.distance(np.asarray(curve.evaluate(t)))]
    # a zero at an end stays there: F = 0, as a length
    unit = (curve.length / speed**2)[at_end] * curve.length / np.maximum(speed[at_end], 1e-300)
    rows.append(F_q[at_end] * unit[:, None, None])
    gaps.append(F[at_end] * unit)
    ends = np.array([e for e in curve.domain if not np.any(at_end & (np.abs(t - e) < 1e-12))])
    if held and ends.size:
        M = _basis(curve, ends)
        velocity = np.asarray(curve.evaluate(ends, 1))
        normal = (
            _perpendicular(velocity) / np.hypot(velocity[:, 0], velocity[:, 1])[:, None] ** 2 * curve.length
        )
        rows += [M[0][..., None] * axis for axis in np.eye(2)]
        gaps += [np.zeros(ends.size)] * 2
        if held > 1:
            rows.append(M[1][..., None] * normal[:, None, :])
            gaps.append(np.zeros(ends.size))
    return np.concatenate(rows).reshape(-1, curve.control_points.size), np.concatenate(gaps)


def _perpendicular(v: FloatArray) -> FloatArray:
    """(v_y, -v_x) for each row: <u, that> = det(u, v)."""
    return np.stack([v[:, 1], -v[:, 0]], axis=1)


def _basis(curve: PlaneCurve, t: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Rational basis functions of the control points and their first two derivatives, (k, m) each."""
    from scipy.interpolate import BSpline

    count = len(curve.control_points)
    weights = np.ones(count) if curve.weights is None else curve.weights
    # a copy: scipy before 1.11 evaluates writable arrays only
    spline = BSpline(np.array(curve.knots), np.diag(weights), curve.degree)
    A, A1, A2 = (np.asarray(spline(t, nu)) for nu in range(3))
    w, w1, w2 = (part.sum(axis=1, keepdims=True) for part in (A, A1, A2))
    B = A / w
    B1 = (A1 - w1 * B) / w
    B2 = (A2 - 2 * w1 * B1 - w2 * B) / w
    return B, B1, B2
