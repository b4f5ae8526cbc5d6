"""Second variation of a rod with rails, pins and ties between its ends: constraints and added terms.

If the tangent's angle of a rod gamma(s) changes by h(s), the second-order change of the energy is

    Q = int K h'^2 - <lambda, gamma'> h^2 ds + sum over ties (T / l) (int from p to q of <u, gamma'> h ds)^2
        - sum over rails (2 t h sigma + t kappa sigma^2),    sigma = -<gamma', v> at the rail.

K is the bending stiffness, lambda the negative internal force, kappa the curvature, and v(s) the displacement. A
tie of length l pulls along the unit vector u between the arc lengths p and q with the force T. A rail pushes along
the normal n with the force t n, and touches the strip at a point that moves by sigma along the strip.

The constraints are v = 0 at pins, <n, v> = 0 at rails, <d, v> = 0 at guides along d, and <u, v_q - v_p> = 0 for
taut ties.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.plane_points import left_of, norm, unit
from elastica_cad.mechanics.elements import ElementForce, Guide, Pin, Rail, Tie, edge_weights, floats
from elastica_cad.mechanics.loads import Supports

SLACK_SHARE = 0.01
"""A tie or one-sided rail is slack if its force is below this fraction of the largest force in the rod."""

# singular value below which constraints on the translation of the rod are linearly dependent
_RANK = 1e-9


@dataclass(frozen=True, eq=False)
class Bracing:
    """Contribution of rails, pins and ties to the second variation of a discrete rod of n edges.

    The vector h (n,) contains the changes of the edge angles. For an axially elastic rod, h (2 n,) also contains
    the changes of the strains of the edges.

    Attributes
    ----------
    rows : (k, n) array
        Constraints rows @ h = 0.
    terms : (r, n) array
        Linear forms of h, each a row of norm 1.
    coefficients : (r, r) array
        Symmetric, invertible matrix C; terms^t C terms is added to the Hessian.
    """

    rows: FloatArray
    terms: FloatArray
    coefficients: FloatArray


def slack_elements(between: Sequence[ElementForce], force: FloatArray) -> tuple[ElementForce, ...]:
    """Return ties and one-sided rails whose force is almost 0. `force` (n, 2), 1/mm2, is the force in the rod."""
    largest = max(float(norm(force).max()), max((action.size for action in between), default=0.0))
    return tuple(action for action in between if action.is_one_sided and action.size <= SLACK_SHARE * largest)


@dataclass(frozen=True, eq=False)
class _Edges:
    """Edges of a rod, whose displacements are linear in the changes of their angles and strains.

    The fields are those of `bracing_of`.
    """

    tangents: FloatArray
    edge_length: float
    supports: Supports
    directions: FloatArray | None

    @property
    def count(self) -> int:
        return len(self.tangents)

    def covered(self, s: float, order: int = 0) -> FloatArray:
        return edge_weights(s, self.edge_length, self.count, order)

    def moves_with(self, weights: FloatArray) -> FloatArray:
        """Return the derivatives (2, m) of a weighted sum of edge vectors by the m angles and strains.

        `weights` is (n,), or (2, n) if the weights of x and y differ.
        """
        moves = self.edge_length * left_of(self.tangents).T * weights
        if self.directions is None:
            return moves
        return np.concatenate([moves, self.edge_length * self.directions.T * weights], axis=1)

    def moves(self, s: float) -> FloatArray:
        """Return the derivatives (2, m + 2) of the position at arc length s.

        The columns are the m angles and strains, and the translation of the whole rod.
        """
        held = self.supports.held
        # a coordinate that only the end holds is measured from there
        from_end = held[3:5] & ~held[:2]
        return np.concatenate([self.moves_with(self.covered(s) - from_end[:, None]), np.eye(2)], axis=1)

    def chord(self, s: FloatArray) -> tuple[FloatArray, float]:
        """Return the unit vector (2,) from the first to the second arc length `s`, and the distance, mm."""
        p, q = (self.covered(float(place)) for place in s)
        chord = self.edge_length * ((q - p) @ self.tangents)
        size = float(norm(chord))
        return chord / size, size


_Brace: TypeAlias = tuple[FloatArray, FloatArray, FloatArray]
"""Contribution of a rail, pin or tie to the second variation.

The vector x (m + 2,) contains the m changes of angles and strains, and the translation of the whole rod. The
arrays are the rows (k, m + 2) of constraints rows @ x = 0, the rows (r, m + 2) of linear forms f, and the matrix C
(r, r) of the term f^t C f that is added to the energy. For a pin or guide, C is 0.
"""


def _tie_brace(action: ElementForce, edges: _Edges) -> _Brace:
    u, size = edges.chord(action.s)
    p, q = (edges.moves(float(s)) for s in action.s)
    return (u @ (q - p))[None], (left_of(u) @ (q - p))[None], np.array([[float(action.force[0] @ u) / size]])


def _pin_brace(action: ElementForce, edges: _Edges) -> _Brace:
    moves = action.held_directions @ edges.moves(float(action.s[0]))
    return moves, moves, np.zeros((len(moves), len(moves)))


def _rail_brace(action: ElementForce, edges: _Edges) -> _Brace:
    """Return the contribution of a taut rail, across which the strip cannot move.

    The linear forms are the turn of the strip and its displacement against the tangent.
    """
    s = float(action.s[0])
    moves, turn = edges.moves(s), edges.edge_length * edges.covered(s, 1)
    tangent = unit(turn @ edges.tangents)
    normal = left_of(tangent)
    push = float(action.force[0] @ normal)
    kappa = edges.edge_length * float(edges.covered(s, 2) @ edges.tangents @ normal)
    turning = np.pad(turn, (0, moves.shape[1] - edges.count))
    return (
        (normal @ moves)[None], np.array([turning, -tangent @ moves]),
        -push * np.array([[0.0, 1.0], [1.0, kappa]]),
    )  # fmt: skip


_BRACES = {Tie: _tie_brace, Pin: _pin_brace, Guide: _pin_brace, Rail: _rail_brace}


def bracing_of(
    between: Sequence[ElementForce],
    *,
    tangents: FloatArray,
    edge_length: float,
    supports: Supports,
    directions: FloatArray | None,
) -> Bracing:
    """Return the contribution of taut rails, pins and ties to the second variation of a discrete rod.

    Parameters
    ----------
    tangents : (n, 2) array
        Edge vectors divided by `edge_length`.
    directions : (n, 2) array or None
        Unit tangents of the edges, only for an axially elastic rod.
    edge_length : float
        Nominal length of an edge, mm.
    """
    edges, free = _Edges(tangents, edge_length, supports, directions), np.array(supports.free_axes)
    n = edges.count if directions is None else 2 * edges.count
    braces = [_BRACES[type(action.element)](action, edges) for action in between]
    acting = [(forms, matrix) for _, forms, matrix in braces if matrix.any()]
    rows = np.concatenate([np.zeros((0, n + 2)), *(constraints for constraints, _, _ in braces)])
    terms = np.concatenate([np.zeros((0, n + 2)), *(forms for forms, _ in acting)])
    # along axes that a support holds, the rod has no translation; solve as many constraints as possible for the
    # translation along free axes, and insert it in the other constraints and in the terms
    if free.any():
        u, sigma, vt = np.linalg.svd(rows[:, n:][:, free])
        rank = int(np.count_nonzero(sigma > _RANK))
        translation = -(vt[:rank].T / sigma[:rank]) @ u[:, :rank].T @ rows
        terms = terms + terms[:, n:][:, free] @ translation
        rows = u[:, rank:].T @ rows
    rows, terms = rows[:, :n], terms[:, :n]
    if floats(supports, between):
        # a rod that floats can turn as a whole without a change of energy, so exclude this rotation
        turn = left_of(edges.chord(between[0].s)[0]) @ edges.moves_with(np.ones(edges.count))
        rows = np.concatenate([rows, turn[None]])
    # avoid a division by zero, because a row of `terms` can be zero on a straight strip
    lengths = np.maximum(np.linalg.norm(terms, axis=1), _RANK * edge_length)
    coefficients, first = np.zeros((len(terms), len(terms))), 0
    for _, matrix in acting:
        last = first + len(matrix)
        coefficients[first:last, first:last] = matrix
        first = last
    return Bracing(rows, terms / lengths[:, None], coefficients * lengths[:, None] * lengths)
