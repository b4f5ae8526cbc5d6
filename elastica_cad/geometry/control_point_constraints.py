"""Constraints on the control points of a curve, and the least change that satisfies them.

Every constraint of the paper, Appendix C, is an equation G(q) = 0 for the control points q (m, 2) of the curve
gamma(t). The notation <u, v> is the scalar product.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad._values import is_whole, pair, require_positive, require_record
from elastica_cad.errors import InputError, NotConvergedError, quoted
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import cross, dot, left_of, norm, unit
from elastica_cad.geometry.polynomials import gauss_rule

_EPS = float(np.finfo(float).eps)


class Constraint(Protocol):
    """Equations that the control points of a curve must satisfy."""

    def equations(self, curve: PlaneCurve) -> tuple[FloatArray, FloatArray]:
        """Return residuals (k,), and derivatives (k, 2 m) by control point coordinates x0, y0, x1, y1, ..."""


@dataclass(frozen=True, eq=False)
class EndPositions:
    """Constraint that the ends of a curve are at given points (2,), mm. An end with the value None is free."""

    start: FloatArray | None
    end: FloatArray | None

    @classmethod
    def of(cls, curve: PlaneCurve, held: Sequence[bool] = (True, True)) -> "EndPositions":
        """Return the constraint that the held ends (start, end) of `curve` remain where they are."""
        require_record(curve, PlaneCurve, "the curve", "a PlaneCurve")
        return cls(*_where(held, curve.evaluate(np.array(curve.domain))))

    def equations(self, curve: PlaneCurve) -> tuple[FloatArray, FloatArray]:
        """Return the residuals and the matrix of the constraint.

        The residuals are the distances, mm, in x and y of the fixed ends of the curve from their points. The matrix
        has their derivatives by the control points.
        """
        t, points = _at_held_ends(curve, self.start, self.end)
        gap = curve.evaluate(t) - points
        return gap.ravel(), directed_rows(curve.basis(t).repeat(2, axis=0), np.tile(np.eye(2), (t.size, 1)))


@dataclass(frozen=True, eq=False)
class EndTangents:
    """Constraint that the end tangents are normal to given vectors (2,). An end with the value None is free."""

    start_normal: FloatArray | None
    end_normal: FloatArray | None

    @classmethod
    def of(cls, curve: PlaneCurve, held: Sequence[bool] = (True, True)) -> "EndTangents":
        """Return the constraint that the tangents at the held ends (start, end) of `curve` remain the same."""
        require_record(curve, PlaneCurve, "the curve", "a PlaneCurve")
        return cls(*_where(held, left_of(unit(curve.evaluate(np.array(curve.domain), 1)))))

    def equations(self, curve: PlaneCurve) -> tuple[FloatArray, FloatArray]:
        """Return the components of the velocities at the ends along the given normals."""
        t, normal = _at_held_ends(curve, self.start_normal, self.end_normal)
        return dot(curve.evaluate(t, 1), normal), directed_rows(curve.basis(t, 1), normal)


@dataclass(frozen=True, eq=False)
class SmoothJoints:
    """Constraint that tangents are continuous where pieces of a curve meet in a control point.

    Attributes
    ----------
    at : (k,) array
        Indices of the control points in which pieces meet.
    size : (k,) array
        Distance, mm, from each joint to the next control point. This factor makes the residuals lengths.
    """

    at: IntArray
    size: FloatArray

    @classmethod
    def of(cls, curve: PlaneCurve) -> "SmoothJoints":
        """Return the constraint for all joints between the pieces of `curve`, except its corners."""
        corners = {corner.t for corner in curve.tangent_breaks}
        free = [joint.t for joint in curve.breaks if joint.t not in corners]
        first = curve.knots.searchsorted(free)
        ends = curve.knots.searchsorted(free, side="right")
        at = (first - 1)[ends - first == curve.degree]
        return cls(at, norm(curve.control_points[at + 1] - curve.control_points[at]))

    def equations(self, curve: PlaneCurve) -> tuple[FloatArray, FloatArray]:
        """Return the residuals and the matrix of the constraint.

        A residual is the distance, mm, of the control point before a joint from the tangent after the joint. The
        matrix has the derivatives of the residuals by the control points.
        """
        points, at = curve.control_points, self.at
        before, after = points[at] - points[at - 1], points[at + 1] - points[at]
        residual = cross(before, after) / self.size
        rows, row = np.zeros((at.size, *points.shape)), np.arange(at.size)
        by_before = -left_of(after) / self.size[:, None]
        by_after = left_of(before) / self.size[:, None]
        rows[row, at - 1], rows[row, at], rows[row, at + 1] = -by_before, by_before - by_after, by_after
        return residual, rows.reshape(at.size, points.size)


@dataclass(frozen=True)
class FixedLength:
    """Constraint on the arc length, with its value `length`, mm."""

    length: float

    def equations(self, curve: PlaneCurve) -> tuple[FloatArray, FloatArray]:
        """Return the excess length, mm, and its derivatives by the control points.

        The derivative by control point q_i is the integral of R_i' gamma' / |gamma'| over t, with the basis
        function R_i of q_i.
        """
        low, width = curve.smooth_panels[:-1], np.diff(curve.smooth_panels)
        x, w = gauss_rule(16)
        t = (low[:, None] + width[:, None] * (1 + x) / 2).ravel()
        weight = (width[:, None] * w / 2).ravel()
        gradient = curve.basis(t, 1).T @ (unit(curve.evaluate(t, 1)) * weight[:, None])
        return np.array([curve.length - self.length]), gradient.reshape(1, -1)


@dataclass(frozen=True, eq=False)
class InflectionsOnLine:
    """Constraint that the inflections near parameters `t` (k,) are on the line a + <b, x> = 0.

    With a natural curvature, 1/mm, inflections are the points where the curvature crosses the natural curvature.
    """

    a: float
    b: FloatArray
    t: FloatArray
    natural_curvature: float = 0.0

    def equations(self, curve: PlaneCurve) -> tuple[FloatArray, FloatArray]:
        """Return the values a + <b, gamma(t)> at the inflections of the curve gamma.

        The parameters t of the inflections change with the control points.
        """
        position, jacobian = _inflections(curve, self.t, self.natural_curvature)
        return self.a + position @ self.b, np.einsum("k,ikq->iq", self.b, jacobian)


@dataclass(frozen=True, eq=False)
class PointsOnLine:
    """Constraint that points at parameters `t` (k,), such as pinned ends, are on the line a + <b, x> = 0."""

    a: float
    b: FloatArray
    t: FloatArray

    def equations(self, curve: PlaneCurve) -> tuple[FloatArray, FloatArray]:
        """Return the values a + <b, gamma(t)> of the curve gamma."""
        rows = directed_rows(curve.basis(self.t), np.tile(self.b, (self.t.size, 1)))
        return self.a + curve.evaluate(self.t) @ self.b, rows


@dataclass(frozen=True, eq=False)
class CurvatureAt:
    """Constraint on the `curvature`, 1/mm, at parameters `t` (k,).

    The length `size`, mm, scales the residuals.
    """

    t: FloatArray
    curvature: float | FloatArray
    size: float

    def equations(self, curve: PlaneCurve) -> tuple[FloatArray, FloatArray]:
        """Return the differences from the required curvature, times `size`^2, mm."""
        excess = curve.curvature_at(self.t) - self.curvature
        return excess * self.size**2, curvature_rows(curve, self.t) * self.size**2


@dataclass(frozen=True, eq=False)
class CollinearInflections:
    """Constraint that the inflections near parameters `t` (k,) are collinear."""

    t: FloatArray

    def equations(self, curve: PlaneCurve) -> tuple[FloatArray, FloatArray]:
        """Return the distances, mm, of inflections from the line through the two inflections farthest apart."""
        # positions (k, 2), and their derivatives (k, 2, 2 m) by the control points
        position, jacobian = _inflections(curve, self.t)
        apart = norm(position[:, None] - position[None])
        i, j = np.unravel_index(int(apart.argmax()), apart.shape)
        inner = [k for k in range(len(position)) if k not in (i, j)]
        if not inner:
            return _no_equations(curve)
        chord, size = position[j] - position[i], apart[i, j]
        normal = left_of(chord) / size
        offset = position[inner] - position[i]
        along = offset @ chord / size**2
        # motion of each inflection relative to the moving line through inflections i and j
        step = jacobian[inner] - jacobian[i] - along[:, None, None] * (jacobian[j] - jacobian[i])
        return offset @ normal, np.einsum("k,ikq->iq", normal, step)


def least_norm_newton(
    curve: PlaneCurve,
    constraints: Sequence[Constraint],
    *,
    tolerance: float = 1e-10,
    max_steps: int = 30,
) -> tuple[PlaneCurve, tuple[float, ...]]:
    """Return the curve after the least move of its control points that satisfies all constraints.

    Each step dq is the least-norm solution of J dq = -G, with residuals G and their derivatives J (paper,
    Appendix C). Steps that would increase the residual are shortened.

    Parameters
    ----------
    tolerance : float
        Norm of all residuals, relative to the size of the curve, at which the iteration stops. The iteration also
        stops if the residuals are rounding errors of the control points.

    Returns
    -------
    curve : PlaneCurve
    residuals : tuple of float
        Norm of the residuals at the start and after every step.

    Raises
    ------
    NotConvergedError
        The constraints contradict each other, or an inflection disappears during the iteration.

    Examples
    --------
    >>> curve = PlaneCurve.spline([(0, 0), (30, 40), (60, -40), (90, 0), (120, 30)])
    >>> shorter, _ = least_norm_newton(curve, [EndPositions.of(curve), FixedLength(130.0)])
    >>> round(shorter.length, 6)
    130.0
    """
    require_record(curve, PlaneCurve, "the curve", "a PlaneCurve")
    require_positive(tolerance, "the tolerance of constraints", "shares of the size")
    if not (is_whole(max_steps) and max_steps >= 1):
        raise InputError(f"`max_steps` is {max_steps!r}: give a whole number, 1 or more")
    if not isinstance(constraints, Sequence) or not all(
        hasattr(constraint, "equations") for constraint in constraints
    ):
        raise InputError(
            f"`constraints` are {quoted(constraints)}: give a list of constraints, such as "
            "[FixedLength(130.0)]"
        )
    size = float(np.ptp(curve.control_points, axis=0).max())
    residual, jacobian = _assembled(curve, constraints)
    norms = [float(np.linalg.norm(residual))]
    while norms[-1] > tolerance * size:
        # residuals that rounding errors of the control points may cause
        rounding = 8 * _EPS * np.linalg.norm(np.abs(jacobian) @ np.abs(curve.control_points).ravel())
        is_rounding = norms[-1] <= rounding
        if len(norms) > max_steps and is_rounding:
            break
        if len(norms) > max_steps:
            raise NotConvergedError(
                f"after {max_steps} steps the curve does not meet its constraints (norm of the residuals: "
                f"{norms[-1]:.3g}, allowed: {tolerance * size:.3g}): leave out one constraint, or start "
                "from a nearer curve"
            )
        step = np.asarray(np.linalg.lstsq(jacobian, -residual, rcond=1e-12)[0].reshape(-1, 2), dtype=float)
        try:
            curve, residual, jacobian = _damped_step(curve, constraints, step, norms[-1])
        except NotConvergedError:
            if is_rounding:
                break
            raise
        norms.append(float(np.linalg.norm(residual)))
    return curve, tuple(norms)


def _damped_step(
    curve: PlaneCurve, constraints: Sequence[Constraint], step: FloatArray, norm: float
) -> tuple[PlaneCurve, FloatArray, FloatArray]:
    """Take the first of `step` (m, 2), `step` / 2, ... `step` / 64 that reduces the norm of the residuals.

    Return the moved curve with its residuals and their derivatives.
    """
    lost: Exception | None = None
    for halving in range(7):
        try:
            moved = curve.with_control_points(curve.control_points + step / 2**halving)
            residual, jacobian = _assembled(moved, constraints)
        except (InputError, NotConvergedError) as error:
            lost = error
            continue
        if np.linalg.norm(residual) < norm:
            return moved, residual, jacobian
    raise NotConvergedError(
        f"the curve cannot meet its constraints, because no step reduces the residuals (norm: {norm:.3g}): "
        "leave out one constraint, or start from a nearer curve"
    ) from lost


def _assembled(curve: PlaneCurve, constraints: Sequence[Constraint]) -> tuple[FloatArray, FloatArray]:
    # residuals (k,) and derivatives (k, 2 m) of all constraints, one after the other
    parts = [constraint.equations(curve) for constraint in constraints]
    if not parts:
        return _no_equations(curve)
    return np.concatenate([r for r, _ in parts]), np.concatenate([j for _, j in parts])


def _no_equations(curve: PlaneCurve) -> tuple[FloatArray, FloatArray]:
    return np.zeros(0), np.zeros((0, curve.control_points.size))


def _where(held: Sequence[bool], rows: FloatArray) -> Iterator[FloatArray | None]:
    return (row if is_held else None for row, is_held in zip(rows, pair(held, "the held ends"), strict=True))


def _at_held_ends(
    curve: PlaneCurve, start: FloatArray | None, end: FloatArray | None
) -> tuple[FloatArray, FloatArray]:
    """Return the parameters (k,) of the ends with a given vector, and these vectors (k, 2)."""
    held = [(t, v) for t, v in zip(curve.domain, (start, end), strict=True) if v is not None]
    return np.array([t for t, _ in held]), np.reshape([v for _, v in held], (-1, 2))


def directed_rows(basis: FloatArray, direction: FloatArray) -> FloatArray:
    """Return the derivatives (k, 2 m) of sum_i basis[k, i] <direction[k], q_i> by the control points q_i."""
    return (basis[:, :, None] * direction[:, None, :]).reshape(len(basis), 2 * basis.shape[1])


def curvature_rows(curve: PlaneCurve, t: FloatArray) -> FloatArray:
    """Return the derivatives (k, 2 m) of the curvature at parameters t (k,) by the control points."""
    d1, d2 = curve.evaluate(t, 1), curve.evaluate(t, 2)
    speed = norm(d1)[:, None]
    turned1, turned2 = map(left_of, (d1, d2))
    kappa = curve.curvature_at(t)[:, None]
    by_velocity = directed_rows(curve.basis(t, 1), turned2 + 3 * kappa * speed * d1)
    return (directed_rows(curve.basis(t, 2), turned1) - by_velocity) / speed**3


def _inflections(curve: PlaneCurve, near: FloatArray, kappa_0: float = 0.0) -> tuple[FloatArray, FloatArray]:
    """Return the positions (k, 2) of the inflections near parameters (k,), and derivatives of the positions.

    The derivatives (k, 2, 2 m) are taken by the control points q. The curvature kappa at an inflection remains
    kappa_0, so the parameter t of the inflection changes: dt/dq = -(d kappa/dq) / (d kappa/dt).
    """
    t = _nearest_inflections(curve, np.atleast_1d(near), kappa_0)
    velocity = curve.evaluate(t, 1)
    slope = curve.curvature_slope_at(t) * norm(velocity)
    moved = -curvature_rows(curve, t) / slope[:, None]
    fixed = np.stack([directed_rows(curve.basis(t), np.tile(e, (t.size, 1))) for e in np.eye(2)], axis=1)
    return curve.evaluate(t), fixed + velocity[:, :, None] * moved[:, None, :]


def _nearest_inflections(curve: PlaneCurve, near: FloatArray, kappa_0: float) -> FloatArray:
    """Return the parameters (k,) of the inflections nearest to parameters `near` (k,).

    If the curve has exactly k inflections, each belongs to one parameter, in order.
    """
    inflections = np.array([z.t for z in curve.curvature_equals(kappa_0) if z.kind == "crossing"])
    if inflections.size < near.size:
        raise NotConvergedError(
            f"the moved curve has {inflections.size} inflections instead of {near.size}: make the move "
            "smaller, or bend the curve more on both sides of each inflection"
        )
    if inflections.size == near.size:
        # the second argsort gives the rank of each parameter
        return inflections[near.argsort().argsort()]
    picked = inflections[np.abs(inflections[None, :] - near[:, None]).argmin(axis=1)]
    if np.unique(picked).size < near.size:
        raise NotConvergedError("two inflections of the curve merge: make the move smaller")
    return np.asarray(picked)
