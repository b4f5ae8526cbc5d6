"""The discrete rod of paper section 7.1 with weight: nodes 0..n, edges 1..n, all in plain arrays.

Angles, forces and modes live on edges, stiffness, moments and loads on nodes. alpha_0 and alpha_{n+1} are
the angles of fictitious edges that the supports hold. An angle that an end leaves free drops that end's
node from the energy: the moment there is given (zero unless a moment is applied).
"""

from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.mechanics.banded import lowest_constrained, small_solution
from elastica_cad.mechanics.supports import Supports

__all__ = [
    "Margin",
    "MarginDerivatives",
    "bending_moments",
    "constrained_margin",
    "constraint_rows",
    "edge_forces",
    "edge_positions",
    "margin_derivatives",
    "moment_imbalance",
    "node_weights",
    "second_variation",
    "tangents",
]


def tangents(angles: FloatArray) -> FloatArray:
    """Unit tangents T(alpha) = (cos alpha, sin alpha), (n, 2)."""
    T = np.empty((angles.size, 2))
    np.cos(angles, out=T[:, 0])
    np.sin(angles, out=T[:, 1])
    return T


def node_weights(edge_length: float | FloatArray, edges: int) -> FloatArray:
    """Voronoi lengths w (n+1,): half the sum of the incident edge lengths, mm."""
    lengths = np.broadcast_to(np.asarray(edge_length, dtype=float), (edges,))
    w = np.zeros(edges + 1)
    w[:-1] += lengths / 2
    w[1:] += lengths / 2
    return w


def edge_positions(start: FloatArray, angles: FloatArray, edge_length: float | FloatArray) -> FloatArray:
    """Nodes gamma (n+1, 2) of the chain of edges that leaves `start`, mm."""
    position = np.empty((angles.size + 1, 2))
    position[0] = start
    np.cumsum(np.reshape(edge_length, (-1, 1)) * tangents(angles), axis=0, out=position[1:])
    position[1:] += start
    return position


def edge_forces(first: FloatArray, load: FloatArray) -> FloatArray:
    """lambda of every edge (n, 2), 1/mm2, from that of the first and the nodal loads (n+1, 2).

    lambda_{i+1} = lambda_i + q_i: with weight q_i = -w_i K_i e this is b_{i+1} = b_i - w_i K_i R^t e.
    """
    force = np.empty((load.shape[0] - 1, 2))
    force[0] = first
    np.cumsum(load[1:-1], axis=0, out=force[1:])
    force[1:] += first
    return force


def bending_moments(
    stiffness: FloatArray,
    angles: FloatArray,
    w: FloatArray,
    *,
    ends: tuple[float | None, float | None],
    natural_curvature: float | FloatArray = 0.0,
    end_moments: tuple[float, float] = (0.0, 0.0),
) -> FloatArray:
    """Moments M_i = K_i ((alpha_{i+1} - alpha_i) / w_i - kappa_0) of all nodes (n+1,), 1/mm.

    Parameters
    ----------
    ends : pair of float or None
        Angles alpha_0 and alpha_{n+1} held by the supports; None where the angle is free.
    end_moments : pair of float
        Moments M_0 and M_n where the angle is free.
    """
    M = np.empty(stiffness.size)
    M[1:-1] = np.diff(angles)
    M[0] = angles[0] - (angles[0] if ends[0] is None else ends[0])
    M[-1] = (angles[-1] if ends[1] is None else ends[1]) - angles[-1]
    M /= w
    M -= natural_curvature
    M *= stiffness
    if ends[0] is None:
        M[0] = end_moments[0]
    if ends[1] is None:
        M[-1] = end_moments[1]
    return M


def moment_imbalance(
    moments: FloatArray,
    angles: FloatArray,
    force: FloatArray,
    edge_length: float | FloatArray,
    *,
    T: FloatArray | None = None,
) -> FloatArray:
    """M_{i-1} - M_i + l_i <b_i, T_i> of every edge (n,), 1/mm: the energy's gradient in the edge angles."""
    T = tangents(angles) if T is None else T
    return np.asarray(
        moments[:-1] - moments[1:] + edge_length * (force[:, 1] * T[:, 0] - force[:, 0] * T[:, 1])
    )


def second_variation(
    stiffness: FloatArray,
    angles: FloatArray,
    force: FloatArray,
    edge_length: float | FloatArray,
    supports: Supports | None = None,
    *,
    T: FloatArray | None = None,
) -> tuple[FloatArray, FloatArray]:
    """Tridiagonal Hessian H of the energy with respect to the edge angles (paper, section 7.1).

    h^t H h = sum_i K_i (h_{i+1} - h_i)^2 / w_i - sum_i l_i <lambda_i, T_i> h_i^2, with h_0 = h_{n+1} = 0
    where the angle is held; the end node's term drops where it is free.

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
        Clamped at both ends unless given.
    T : (n, 2) array, optional
        `tangents(angles)` when already at hand.

    Returns
    -------
    diagonal : (n,) array
    off : (n-1,) array
        1/mm.
    """
    spring = stiffness / node_weights(edge_length, angles.size)
    for node, held in zip((0, -1), held_angles(supports), strict=True):
        if not held:
            spring[node] = 0.0
    T = tangents(angles) if T is None else T
    pull = force[..., 0] * T[:, 0] + force[..., 1] * T[:, 1]
    return spring[:-1] + spring[1:] - edge_length * pull, -spring[1:-1]


def constraint_rows(
    angles: FloatArray,
    edge_length: float | FloatArray,
    supports: Supports | None = None,
    *,
    T: FloatArray | None = None,
) -> FloatArray:
    """Rows C (p, n), mm, of d(gamma_l - gamma_0) = C d(alpha), for the coordinates held at both ends.

    C = l_i (-sin alpha_i, cos alpha_i).
    """
    T = tangents(angles) if T is None else T
    rows = []
    held = (True, True) if supports is None else supports.transmits_force
    if held[0]:
        rows.append(-edge_length * T[:, 1])
    if held[1]:
        rows.append(edge_length * T[:, 0])
    return np.array(rows).reshape(len(rows), angles.size)


def held_angles(supports: Supports | None) -> tuple[bool, bool]:
    """Whether the start and the end hold the tangent."""
    if supports is None:
        return True, True
    a, b = supports.ends
    return a.angle, b.angle


@dataclass(frozen=True, eq=False)
class Margin:
    """Lowest eigenvalue of the second variation on the tangent space of the end constraints.

    Attributes
    ----------
    value : float
        The eigenvalue of h -> int K h'^2 - <lambda, gamma'> h^2 against int h^2, times length^2.
    mode : (n,) array
        The edge values of its mode h, int h^2 = 1, so 1/sqrt(mm).
    multipliers : (2,) array
        nu of H v - mu W v = C^t nu, for x and y; zero for a coordinate that is not held at both ends.
    """

    value: float
    mode: FloatArray
    multipliers: FloatArray


def constrained_margin(
    stiffness: FloatArray,
    angles: FloatArray,
    force: FloatArray,
    edge_length: float | FloatArray,
    supports: Supports | None = None,
    *,
    T: FloatArray | None = None,
) -> Margin:
    """Stability margin of a discrete rod, O(n); positive means stable.

    Parameters
    ----------
    stiffness : (n+1,) array
        K at the nodes.
    angles : (n,) array
        Edge angles, rad.
    force : (n, 2) or (2,) array
        lambda of the edges, 1/mm2 (minus the usual internal force).
    edge_length : float or (n,) array
        mm.
    supports : Supports, optional
        Clamped at both ends unless given.
    T : (n, 2) array, optional
        `tangents(angles)` when already at hand.

    Returns
    -------
    Margin

    Examples
    --------
    A straight rod without load: the lowest sine of mean zero.

    >>> margin = constrained_margin(np.ones(201), np.zeros(200), np.zeros(2), 0.5)
    >>> round(margin.value / np.pi**2, 3)
    4.0
    """
    lengths = np.full(angles.size, edge_length, dtype=float)
    T = tangents(angles) if T is None else T
    diagonal, off = second_variation(stiffness, angles, force, edge_length, supports, T=T)
    rows = constraint_rows(angles, edge_length, supports, T=T)
    root = np.sqrt(lengths)
    values, vectors = lowest_constrained(diagonal / lengths, off / (root[:-1] * root[1:]), rows / root)
    v = vectors[0] / root
    v = v if v[np.argmax(np.abs(v))] > 0 else -v
    left = diagonal * v - values[0] * lengths * v
    left[1:] += off * v[:-1]
    left[:-1] += off * v[1:]
    nu = np.zeros(2)
    held = [
        i for i, flag in enumerate((True, True) if supports is None else supports.transmits_force) if flag
    ]
    if held:
        per_length = rows / lengths
        nu[held] = small_solution(
            np.einsum("in,jn->ij", per_length, rows), np.einsum("in,n->i", per_length, left)
        )
    return Margin(float(values[0] * lengths.sum() ** 2), v, nu)


@dataclass(frozen=True, eq=False)
class MarginDerivatives:
    """Partial derivatives of the margin.

    Attributes
    ----------
    stiffness : (n+1,) array
        With respect to the nodal K.
    force : (n, 2) array
        With respect to each edge's lambda, mm2.
    angles : (n,) array
        With respect to each edge's angle.
    length : float
        With respect to the total length (all edges in proportion, K, angles and lambda kept), 1/mm.
    """

    stiffness: FloatArray
    force: FloatArray
    angles: FloatArray
    length: float


def margin_derivatives(
    stiffness: FloatArray,
    angles: FloatArray,
    force: FloatArray,
    edge_length: float | FloatArray,
    supports: Supports | None = None,
    *,
    margin: Margin | None = None,
    T: FloatArray | None = None,
) -> MarginDerivatives:
    """Derivatives of the margin: d(mu) = v^t dH v - mu v^t dW v - 2 nu^t dC v, with v^t W v = 1, C v = 0.

    Parameters as in `constrained_margin`; `margin` is its answer, `T` the tangents when already at hand.
    """
    if margin is None:
        margin = constrained_margin(stiffness, angles, force, edge_length, supports)
    v, nu = margin.mode, margin.multipliers
    lengths = np.full(angles.size, edge_length, dtype=float)
    total = float(lengths.sum())
    square = total**2 * lengths * v**2
    step = np.diff(v, prepend=0.0, append=0.0)
    per_stiffness = total**2 * step**2 / node_weights(edge_length, angles.size)
    for node, held in zip((0, -1), held_angles(supports), strict=True):
        if not held:
            per_stiffness[node] = 0.0
    T = tangents(angles) if T is None else T
    per_force = -square[:, None] * T
    across = force[..., 1] * T[:, 0] - force[..., 0] * T[:, 1]
    per_angle = -square * across + 2 * total**2 * lengths * v * (T @ nu)
    per_length = 2 / total * float(np.sum(per_force * force))
    return MarginDerivatives(per_stiffness, per_force, per_angle, per_length)
