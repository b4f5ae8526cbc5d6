"""Interior-point method for small dense convex quadratic programs with penalties for violated constraints."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from elastica_cad import _native
from elastica_cad._compiled_scipy import lapack
from elastica_cad._types import BoolArray, FloatArray


class InteriorPoints(NamedTuple):
    """Settings of the method, which usually needs about twelve factorisations.

    The active-set method of HiGHS is not used, because it did not terminate for some programs near the end of a
    search.

    Attributes
    ----------
    accuracy : float
        Default accuracy. It is much smaller than the errors of linearised constraints.
    backoff : float
        Largest length of a step, as a fraction of the distance to the nearest bound.
    cycling, centered : int, float
        After `cycling` factorisations, the second-order correction is omitted, and each step reduces the
        complementarity to the fraction `centered`. Without this rule, one program in a thousand would not converge.
    most : int
        Largest number of factorisations.
    """

    accuracy: float = 1e-10
    backoff: float = 0.995
    cycling: int = 20
    centered: float = 0.3
    most: int = 60


METHOD = InteriorPoints()


@dataclass(frozen=True, eq=False)
class QuadraticProgram:
    """Minimise x^T H x / 2 + g^T x plus penalties for violated constraints, with lower <= x <= upper.

    Constraint k is A_k x = r_k, or A_k x >= r_k if `one_sided`, with row k of A = `rows` and r = `right`. The
    penalty for a violation by u is `penalty[k]` u. If `penalty[k]` exceeds the Lagrange multiplier, the solution
    meets the constraint exactly.

    Attributes
    ----------
    hessian, gradient : (p, p), (p,) arrays
        H, which is positive semidefinite, and g.
    lower, upper : (p,) arrays
        Finite bounds of x.
    rows, right : (m, p), (m,) arrays
        A and r of the m constraints.
    penalty : (m,) array
        Penalties, positive.
    one_sided : (m,) boolean array
    """

    hessian: FloatArray
    gradient: FloatArray
    lower: FloatArray
    upper: FloatArray
    rows: FloatArray
    right: FloatArray
    penalty: FloatArray
    one_sided: BoolArray


@dataclass(frozen=True, eq=False)
class QuadraticSolution:
    """Minimum x, with the Lagrange multipliers of constraints and bounds.

    A positive multiplier of a constraint means that A x would be smaller without the constraint.

    `converged` is True if the tolerance was reached.
    """

    x: FloatArray
    row_multipliers: FloatArray
    lower_multipliers: FloatArray
    upper_multipliers: FloatArray
    converged: bool


def solve_quadratic(program: QuadraticProgram, *, accuracy: float = METHOD.accuracy) -> QuadraticSolution:
    """Return the minimum, by an interior-point method with Mehrotra's predictor and corrector.

    `accuracy` is relative to the largest number in the gradient or on the diagonal of the Hessian. The
    multiplier y of a constraint is at most y_high = `penalty`, and at least y_low = -`penalty`, or 0 if
    `one_sided`. Let p, q >= 0 with A x - r = p - q. The conditions are p (y - y_low) = 0 and q (y_high - y) =
    0.

    Examples
    --------
    >>> import numpy as np
    >>> one = np.ones(1)
    >>> program = QuadraticProgram(np.eye(1), -one, -9 * one, 9 * one, np.eye(1), 3 * one, 9 * one, one > 0)
    >>> float(solve_quadratic(program).x[0].round(8))
    3.0
    """
    p = program
    free = p.upper - p.lower >= 1e-14 * (1 + np.abs(p.lower))
    x = np.where(free, 0.0, p.lower)
    gap, pull = p.right - p.rows @ x, p.gradient + p.hessian @ x
    if free.any():
        inner = QuadraticProgram(
            p.hessian[np.ix_(free, free)], pull[free], p.lower[free], p.upper[free], p.rows[:, free], gap,
            p.penalty, p.one_sided,
        )  # fmt: skip
        if _native.compiled is None:
            x[free], y, converged = _in_python(inner, accuracy)
        else:
            given = *vars(inner).values(), accuracy
            (x[free], y, *_), converged, _ = _native.interior_points(*given)
    else:
        y, converged = p.penalty * np.where(p.one_sided, gap > 0, np.sign(gap)), True
    pull = p.hessian @ x + p.gradient - y @ p.rows
    return QuadraticSolution(x, y, np.maximum(pull, 0), np.maximum(-pull, 0), converged)


_SIDES = np.array([[1.0], [-1.0]])
"""Derivatives of the distances from the lower and the upper bound with respect to the unknown."""


def _in_python(p: QuadraticProgram, accuracy: float) -> tuple[FloatArray, FloatArray, bool]:
    """Return the solution, the multipliers of the rows, and True if it converged, as the compiled version does."""
    n, m = p.gradient.size, p.right.size
    scale = 1 / max(1e-30, float(np.abs(p.gradient).max()), float(np.abs(np.diag(p.hessian)).max()))
    g, y_high = p.gradient * scale, p.penalty * scale
    y_low = np.where(p.one_sided, 0.0, -y_high)
    lower, upper = np.concatenate([p.lower, y_low]), np.concatenate([p.upper, y_high])
    matrix = np.block([[p.hessian * scale, -p.rows.T], [p.rows, np.zeros((m, m))]])
    offset = np.concatenate([g, -p.right])
    tolerance = accuracy * float(np.clip(np.abs(g).max(), 1e-6, 1.0))
    inner = 0.1 * (p.upper - p.lower)
    z = np.concatenate([np.clip(0.0, p.lower + inner, p.upper - inner), (y_low + y_high) / 2])
    # u (2, n + m) are the distances of z = (x, y) from its bounds, and v the multipliers or slacks;
    # the products u v are kept near the barrier parameter mu, which decreases to 0
    u = np.stack([z - lower, upper - z])
    mu = max(0.03, 0.1 * float(np.abs(g) @ inner) / n)
    v = mu / u
    gap = (matrix @ z + offset)[n:]
    v[0, n:] += gap / 2 + np.hypot(v[0, n:], gap / 2)
    v[1, n:] = np.maximum(v[0, n:] - gap, mu)
    for iteration in range(METHOD.most):
        residual = matrix @ z + offset - v[0] + v[1]
        product = u * v
        mu = float(np.vdot(u, v)) / u.size
        met = np.abs(residual[n:]).max(initial=0.0) < 10 * METHOD.accuracy
        if met and mu < tolerance and np.abs(residual[:n]).max() < 10 * tolerance:
            return z[:n], z[n:] / scale, True
        ratio = v / u
        system = matrix.copy()
        system.flat[:: n + m + 1] += ratio[0] + ratio[1]
        factors, pivots, info = lapack().dgetrf(system)
        # stop if rounding has made a distance or multiplier 0, which further steps cannot change
        if info != 0 or not min(u.min(), v.min()) > 0:
            break
        # the predictor step aims at mu = 0; the corrector step aims at a mu computed from the predictor step
        aim = -product
        for corrector in (False, True):
            change = aim / u
            dz, _ = lapack().dgetrs(factors, pivots, change[0] - change[1] - residual)
            du = _SIDES * dz
            dv = change - ratio * du
            nearest = max(float((-du / u).max()), float((-dv / v).max()), METHOD.backoff)
            step = 1 / nearest
            if not corrector:
                after = float(np.vdot(u + step * du, v + step * dv)) / u.size
                centred = iteration >= METHOD.cycling
                aim = (METHOD.centered * mu if centred else mu * (after / mu) ** 3 - du * dv) - product
        step *= METHOD.backoff
        z, u, v = z + step * dz, u + step * du, v + step * dv
    return z[:n], z[n:] / scale, False
