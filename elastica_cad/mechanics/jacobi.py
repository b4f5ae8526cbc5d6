"""The Jacobi test: determinant Z(s), its adjoint, isoperimetric conjugate point (paper, 6.2, App. B).

All with weight: it enters through the force of each edge alone. Arrays are those of the discrete rod
(section 7.1).
"""

from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.mechanics.banded import constrained_inertia, lowest_constrained, solve_bordered
from elastica_cad.mechanics.discrete import (
    constraint_rows,
    held_angles,
    node_weights,
    second_variation,
    tangents,
)
from elastica_cad.mechanics.supports import Supports

__all__ = ["Determinant", "conjugate_point", "determinant_gradient", "stability_determinant"]


@dataclass(frozen=True, eq=False)
class Determinant:
    """The stability determinant along a rod (Fig. 9).

    Attributes
    ----------
    s : (n+1,) array
        Midpoints of the edges and the end of the rod, mm from the start.
    value : (n+1,) array
        Z(s); its sign changes are the conjugate points, but for the rounding noise near s = 0, where Z has
        a zero of high order.
    noise : (n+1,) array
        Rounding error of Z(s): smaller values have no sign.
    fields : (n+2, 1+p) array
        zeta, eta_1, .. eta_p of the Jacobi equation on the edges and the two fictitious ones.
    integrals : (n, p, 1+p) array
        M_i and N_ij up to the end of each edge.
    """

    s: FloatArray
    value: FloatArray
    noise: FloatArray
    fields: FloatArray
    integrals: FloatArray

    @property
    def sign_changes(self) -> FloatArray:
        """Places (k,), mm, where Z changes sign beyond rounding noise; none before the first zero of zeta."""
        zeta = self.fields[1:, 0]
        beyond = np.flatnonzero(zeta <= 0)
        if beyond.size == 0:
            return np.zeros(0)
        # while zeta keeps its sign no interval can be unstable (the unconstrained Jacobi test)
        sure = np.flatnonzero(np.abs(self.value) > self.noise)
        sure = sure[sure >= max(int(beyond[0]) - 1, 0)]
        at, z = self.s[sure], self.value[sure]
        k = np.flatnonzero(z[:-1] * z[1:] < 0)
        return np.asarray(at[k] + (at[k + 1] - at[k]) * z[k] / (z[k] - z[k + 1]))


def stability_determinant(
    stiffness: FloatArray,
    angles: FloatArray,
    force: FloatArray,
    edge_length: float | FloatArray,
    supports: Supports | None = None,
) -> Determinant:
    """The curve Z(s) by the discrete Jacobi recursion of section 7.1, started from the start of the rod.

    Parameters
    ----------
    stiffness : (n+1,) array
        K at the nodes.
    angles : (n,) array
        Edge angles, rad.
    force : (n, 2) or (2,) array
        lambda of the edges, 1/mm2.
    edge_length : float or (n,) array
        mm.
    supports : Supports, optional
        Clamped at both ends unless given. Where the start leaves the angle free, zeta starts with slope
        zero; a coordinate that is not held at both ends drops its rows.

    Returns
    -------
    Determinant

    Examples
    --------
    A straight, unloaded cantilever has no conjugate point.

    >>> z = stability_determinant(np.ones(51), np.zeros(50), np.zeros(2), 1.0, Supports("free", "clamped"))
    >>> z.sign_changes.size
    0
    """
    n = angles.size
    rows = constraint_rows(angles, edge_length, supports)
    matrix = _recursion(stiffness, angles, force, edge_length, supports)
    right = np.zeros((n + 1, 1 + rows.shape[0]))
    right[0] = _initial(edge_length, n, supports)
    right[1:, 1:] = -rows.T
    fields = np.zeros((n + 2, right.shape[1]))
    fields[1:] = _marched(matrix, right)
    integrals = np.cumsum(rows.T[:, :, None] * fields[1:-1, None, :], axis=0)
    Z = _matrices(fields, integrals)
    lengths = np.broadcast_to(np.asarray(edge_length, dtype=float), (n,))
    ends = np.cumsum(lengths)
    s = np.append(ends - lengths / 2, ends[-1])
    # rounding of a determinant: eps times the product of its columns' sizes, once its rows are scaled
    scaled = Z / np.maximum(np.abs(Z).max(axis=2, keepdims=True), np.finfo(float).tiny)
    bound = np.prod(np.abs(scaled).sum(axis=1), axis=1) * np.prod(np.abs(Z).max(axis=2), axis=1)
    return Determinant(s, _determinants(Z), 1e-15 * np.sqrt(n) * 16 * bound, fields, integrals)


def determinant_gradient(
    stiffness: FloatArray,
    angles: FloatArray,
    force: FloatArray,
    edge_length: float | FloatArray,
    *,
    weights: FloatArray,
    moments: FloatArray,
    supports: Supports | None = None,
    load_slope: FloatArray | None = None,
) -> FloatArray:
    """Derivative of sum_i weights_i Z(s_i) with respect to the nodal K, by the adjoint method (App. B).

    The rod stays in equilibrium while K changes: its ends are held, its angles and forces follow. With
    weights that form a bump around a conjugate point sigma (or interpolate Z there) this is dZ/dK at sigma
    up to a positive factor, and moving along it moves sigma towards the end of the rod.

    Parameters
    ----------
    stiffness, angles, force, edge_length, supports
        As in `stability_determinant`: a rod in equilibrium.
    weights : (n+1,) array
        Weights of Z at the midpoints of the edges and at the end.
    moments : (n+1,) array
        M at the nodes, 1/mm.
    load_slope : (n+1, 2) array, optional
        Derivative of each node's weight with respect to its K, 1/mm2 (weight ~ K: load / K).

    Returns
    -------
    (n+1,) array
    """
    n = angles.size
    force = np.broadcast_to(force, (n, 2))
    lengths = np.broadcast_to(np.asarray(edge_length, dtype=float), (n,))
    z = stability_determinant(stiffness, angles, force, edge_length, supports)
    X, p = z.fields, z.fields.shape[1] - 1
    rows = constraint_rows(angles, edge_length, supports)
    w, T = node_weights(edge_length, n), tangents(angles)

    # back through the determinants and the running integrals
    G = weights[:, None, None] * _cofactors(_matrices(X, z.integrals))
    suffix = np.cumsum(G[:0:-1, 1:, :], axis=0)[::-1]  # what hangs on the integrals up to each edge
    per_field = G[:, 0, :].copy()
    per_field[:-1] += np.einsum("kp,kpm->km", rows.T, suffix)
    per_row = np.einsum("kpm,km->kp", suffix, X[1:-1])

    # back through the recursion
    matrix = _recursion(stiffness, angles, force, edge_length, supports)
    adjoint = np.zeros((n + 2, 1 + p))
    adjoint[1:-1] = _marched(matrix, per_field, transposed=True)[1:]
    per_spring = np.einsum("km,km->k", np.diff(adjoint, axis=0), np.diff(X, axis=0))
    per_pull = -np.einsum("km,km->k", adjoint[1:-1], X[1:-1])
    per_row -= adjoint[1:-1, 1:]

    # what Z feels of angles and forces directly
    held = [
        i for i, both in enumerate((True, True) if supports is None else supports.transmits_force) if both
    ]
    across = force[:, 1] * T[:, 0] - force[:, 0] * T[:, 1]
    per_angle = per_pull * lengths * across - lengths * np.einsum("kp,kp->k", per_row, T[:, held])
    per_force = (per_pull * lengths)[:, None] * T

    # back through the equilibrium: its Jacobian is symmetric
    diagonal, off = second_variation(stiffness, angles, force, edge_length, supports)
    y, _ = solve_bordered(diagonal, off, rows, right=per_angle, below=per_force[:, held].sum(axis=0))
    per_force -= (lengths * y)[:, None] * np.column_stack([-T[:, 1], T[:, 0]])
    free = [not angle for angle in held_angles(supports)]
    gradient = per_spring / w - moments / stiffness * np.diff(y, prepend=0.0, append=0.0)
    gradient[0] = 0.0 if free[0] else gradient[0]
    gradient[-1] = 0.0 if free[1] else gradient[-1]
    if load_slope is not None:
        gradient += np.einsum("kp,kp->k", load_slope, _per_load(per_force, supports))
    return np.asarray(gradient, dtype=float)


def conjugate_point(
    stiffness: FloatArray,
    angles: FloatArray,
    force: FloatArray,
    edge_length: float | FloatArray,
    supports: Supports | None = None,
) -> float | None:
    """First isoperimetric conjugate point from the start of the rod, mm; None when there is none in (0, l].

    The shortest piece [0, s] of the rod, clamped at s, on which the second variation is not positive:
    found by bisection on the inertia of the leading pieces, so that the zero of high order that Z has at s
    = 0 cannot be counted.

    Raises
    ------
    InputError
        When the end of the rod leaves the angle free; start from the other end then.
    """
    if not held_angles(supports)[1]:
        raise InputError("conjugate points need an end that holds the angle: run the rod the other way round")
    diagonal, off = second_variation(stiffness, angles, force, edge_length, supports)
    rows = constraint_rows(angles, edge_length, supports)
    lengths = np.broadcast_to(np.asarray(edge_length, dtype=float), angles.shape)
    found = first_unstable_piece(diagonal, off, rows)
    if found is None:
        return None
    ends = np.cumsum(lengths)
    place = np.append(ends[:-1] + lengths[1:] / 2, ends[-1])  # where the piece of k edges is clamped
    if found == 1:
        return float(place[0])
    lower, upper = (
        float(lowest_constrained(diagonal[:k], off[: k - 1], rows[:, :k])[0][0]) if _free(rows, k) else np.inf
        for k in (found - 1, found)
    )
    fraction = (
        1.0 if not np.isfinite(lower) or lower <= upper else float(np.clip(lower / (lower - upper), 0, 1))
    )
    return float(place[found - 2] + fraction * (place[found - 1] - place[found - 2]))


def first_unstable_piece(diagonal: FloatArray, off: FloatArray, rows: FloatArray) -> int | None:
    """Least number of leading edges with an unstable mode that respects `rows`; None without any."""

    def unstable(k: int) -> bool:
        return _free(rows, k) and bool(constrained_inertia(diagonal[:k], off[: k - 1], rows[:, :k]))

    low, high = 0, diagonal.size
    if not unstable(high):
        return None
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if unstable(middle) else (middle, high)
    return high


def _free(rows: FloatArray, edges: int) -> bool:
    return edges > len(rows)


def _initial(edge_length: float | FloatArray, n: int, supports: Supports | None) -> float:
    """First edge's value of all fields: zeta'(0) = 1 as in Eq. 7, or zeta(0) = 1 where the angle is free."""
    return float(node_weights(edge_length, n)[0]) if held_angles(supports)[0] else 1.0


def _recursion(
    stiffness: FloatArray,
    angles: FloatArray,
    force: FloatArray,
    edge_length: float | FloatArray,
    supports: Supports | None,
) -> FloatArray:
    """Lower triangular band (3, n+1) of the recursion for zeta_1 .. zeta_{n+1}."""
    n = angles.size
    w = node_weights(edge_length, n)
    pull = edge_length * np.sum(force * tangents(angles), axis=1)
    spring = stiffness / w
    if not held_angles(supports)[0]:
        spring[0] = 0.0
    band = np.zeros((3, n + 1))
    band[0, 0] = 1.0
    band[0, 1:] = spring[1:]
    band[1, :-1] = pull - spring[:-1] - spring[1:]
    band[2, :-2] = spring[1:-1]
    return band


def _marched(band: FloatArray, right: FloatArray, *, transposed: bool = False) -> FloatArray:
    from scipy.linalg.lapack import dtbtrs

    solution, info = dtbtrs(band, right, uplo="L", trans="T" if transposed else "N")
    if info != 0 or not np.all(np.isfinite(solution)):
        raise InputError(
            "the Jacobi equation overflows: the rod is pulled far too hard for Z(s) to be a number"
        )
    return np.asarray(solution)


def _matrices(fields: FloatArray, integrals: FloatArray) -> FloatArray:
    """Stability matrices (n+1, 1+p, 1+p) at the edges and at the end."""
    n, _, m = integrals.shape
    Z = np.empty((n + 1, m, m))
    Z[:, 0, :] = fields[1:]
    Z[0, 1:, :] = 0.0
    Z[1:, 1:, :] = integrals
    return Z


def _cofactors(Z: FloatArray) -> FloatArray:
    """Cofactor matrices (k, m, m), m <= 3; exact where the determinant vanishes."""
    m = Z.shape[1]
    if m == 1:
        return np.ones_like(Z)
    if m == 2:
        flipped = Z[:, ::-1, ::-1].copy()
        flipped[:, 0, 1] *= -1
        flipped[:, 1, 0] *= -1
        return np.asarray(flipped)
    return np.stack(
        [np.cross(Z[:, 1], Z[:, 2]), np.cross(Z[:, 2], Z[:, 0]), np.cross(Z[:, 0], Z[:, 1])], axis=1
    )


def _determinants(Z: FloatArray) -> FloatArray:
    return np.asarray(np.einsum("km,km->k", Z[:, 0], _cofactors(Z)[:, 0]))


def _per_load(per_force: FloatArray, supports: Supports | None) -> FloatArray:
    """Derivatives (n+1, 2) with respect to the nodal loads from those with respect to the edge forces."""
    n = per_force.shape[0]
    per_load = np.zeros((n + 1, 2))
    ends = Supports().ends if supports is None else supports.ends
    for i, axis in enumerate("xy"):
        if getattr(ends[0], axis) and not getattr(ends[1], axis):
            per_load[1:, i] = -np.cumsum(per_force[:, i])
        else:
            per_load[1:-1, i] = np.cumsum(per_force[:0:-1, i])[::-1]
            if not getattr(ends[0], axis):
                per_load[0, i] = per_force[:, i].sum()
    return per_load
