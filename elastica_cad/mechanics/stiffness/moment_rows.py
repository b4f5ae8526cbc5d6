"""Balance of a drawn curve, with or without weight, as a linear map: few numbers -> moment, force and
stiffness.

On a drawn curve the rod's equations (paper, Eqs. 3 and 5)

    M' = <b, gamma'>,   b' = -(q K + p tau) R^t e,   K (kappa - kappa_0) = M

are linear in the state (M, b) at the end of the curve, so each of the three numbers needs one march only. q
is the weight per stiffness (1/l_eg^3), p a dead weight (N/mm), tau one over the least bending stiffness, e
points up. Weightless rods have constant b, and M = a + <b, gamma>.
"""

from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.polynomials.panel_functions import LEFT, RIGHT, WEIGHTS
from elastica_cad.mechanics.stiffness.quadrature_panels import Panels


@dataclass(frozen=True, eq=False)
class LineLoad:
    """Weight along a curve cut into panels.

    Attributes
    ----------
    up : (2,) array
        Unit vector against gravity.
    own : (N, p) array
        Weight per stiffness over the least bending stiffness, 1/mm3: 1/l_eg^3 for a plain strip.
    dead : (N, p) array
        Weight per length that does not depend on the stiffness, N/mm.
    points : (N + 1,) array
        Point weights at the panel ends, N.
    """

    up: FloatArray
    own: FloatArray
    dead: FloatArray
    points: FloatArray

    @property
    def is_proportional(self) -> bool:
        """Is all the weight proportional to the stiffness?"""
        return not (self.dead.any() or self.points.any())


@dataclass(frozen=True, eq=False)
class MomentRows:
    """What the numbers (M, b_x, b_y, and tau with dead weight) at the curve's end make of the rod; m of them.

    Attributes
    ----------
    stiffness : (N, p, m) array
        K at the nodes of the panels.
    force : (N, p, 2, m) array
        b at the nodes.
    edge_moment : (N + 1, m) array
        M at the panel ends.
    start_force, end_force : (2, m) arrays
        b that the supports give at the two ends.
    """

    stiffness: FloatArray
    force: FloatArray
    edge_moment: FloatArray
    start_force: FloatArray
    end_force: FloatArray


def moment_rows(panels: Panels, load: LineLoad | None = None) -> MomentRows:
    """March from the end of the curve to its start, panel by panel.

    At a zero of kappa - kappa_0 the moment is taken as zero (which the caller must demand of the numbers: the
    rows `edge_moment` there), so that K comes out as its limit, not as a quotient of rounding errors.
    """
    if load is None:
        return _weightless(panels)
    with np.errstate(over="ignore", invalid="ignore"):  # a weight far too large overflows; the caller checks
        return _weighted(panels, load)


def _weightless(panels: Panels) -> MomentRows:
    count, order = panels.t.shape
    reach = panels.edge_position - panels.edge_position[-1]
    edge_moment = np.ones((count + 1, 3))
    edge_moment[:, 1:] = reach
    # M at a node = M at the panel's near end + <b, step>; at a zero the first term vanishes
    from_left = panels.zero_left
    vanishing = _vanishing_at_zeros(panels, edge_moment)
    base = np.where(from_left[:, None], vanishing[:-1], vanishing[1:])
    step = np.where(from_left[:, None, None], panels.from_left, panels.from_right)
    rows = np.empty((count, order, 3))
    rows[..., 0] = base[:, :1]
    np.add(base[:, None, 1:], step, out=rows[..., 1:])
    rows /= panels.curvature[..., None]
    constant = np.eye(2, 3, 1)
    return MomentRows(
        stiffness=rows,
        force=np.broadcast_to(constant, (count, order, 2, 3)),
        edge_moment=edge_moment, start_force=constant, end_force=constant,
    )  # fmt: skip


def _vanishing_at_zeros(panels: Panels, edge_moment: FloatArray) -> FloatArray:
    """The moment at the panel ends less the traces (zero but for rounding) that it has where it must vanish.

    Taken off linearly between the zeros of kappa - kappa_0: next to a zero the trace would be large beside M.
    """
    vanishes = np.zeros(panels.count + 1, dtype=bool)
    vanishes[:-1] = panels.zero_left
    vanishes[1:] |= panels.zero_right
    zeros = vanishes.nonzero()[0]
    if not zeros.size:
        return edge_moment
    traces, at = np.empty_like(edge_moment), panels.edge_s[zeros]
    for number, column in enumerate(edge_moment[zeros].T):
        traces[:, number] = np.interp(panels.edge_s, at, column)
    return np.asarray(edge_moment - traces)


def _weighted(panels: Panels, load: LineLoad) -> MomentRows:
    count, order = panels.t.shape
    size = 3 if load.is_proportional else 4
    G = np.array([load.up[1], -load.up[0]])  # R^t e
    left, zero = panels.zero_left, panels.zero_left | panels.zero_right
    local = np.where(left[:, None, None], panels.from_left, panels.from_right)
    integral = np.where(left[:, None, None], -LEFT, RIGHT) * panels.stretch[:, None, :]
    lever = local @ G
    kernel = integral * (lever[:, :, None] - lever[:, None, :])
    matrix = -kernel * load.own[:, None, :]
    matrix[:, np.arange(order), np.arange(order)] += panels.curvature
    known = np.zeros((count, order, size))
    known[~zero, :, 0] = 1.0
    known[..., 1:3] = local
    if size == 4:
        known[..., 3] = np.einsum("nij,nj->ni", kernel, load.dead)
    stiffness = np.linalg.solve(matrix, known)
    weight = load.own[..., None] * stiffness
    if size == 4:
        weight[..., 3] += load.dead
    shares = WEIGHTS * panels.stretch
    # the state at the far end of each panel from the near one: right to left, except beside a zero on the
    # left
    sign = np.where(left, -1.0, 1.0)
    far = np.where(left[:, None, None], panels.from_right, panels.from_left) @ G
    chord = np.diff(panels.edge_position, axis=0) * -sign[:, None]
    transfer = np.tile(np.eye(size), (count, 1, 1))
    transfer[:, 0, 1:3] = chord
    transfer[:, 0] -= np.einsum("n,ni,nim->nm", sign, shares * far, weight)
    transfer[:, 1:3] += np.einsum("n,k,ni,nim->nkm", sign, G, shares, weight)
    backward = transfer.copy()
    backward[left] = np.linalg.inv(transfer[left])
    near = np.empty((count, size, size))
    edge_moment = np.empty((count + 1, size))
    state = np.eye(size)
    for k in range(count, 0, -1):
        state = _past_point(state, load.points[k], G)
        edge_moment[k] = state[0]
        before = backward[k - 1] @ state
        near[k - 1] = before if left[k - 1] else state
        state = before
    edge_moment[0] = state[0]
    first = _past_point(state, load.points[0], G)
    stiffness = stiffness @ near
    weight = weight @ near
    force = near[:, None, 1:3, :] + np.einsum("k,nij,njm->nikm", G, integral, weight)
    end = np.eye(size)
    return MomentRows(
        stiffness=stiffness, force=force, edge_moment=edge_moment, start_force=first[1:3], end_force=end[1:3]
    )


def _past_point(state: FloatArray, newtons: float, G: FloatArray) -> FloatArray:
    """The state before a point weight from that after it: b grows by the weight times R^t e."""
    if newtons == 0:
        return state
    state = state.copy()
    state[1:3, 3] += newtons * G
    return state
