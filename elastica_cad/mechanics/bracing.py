"""Second variation of a rod with elements between its ends: constraints and added terms.

With h the change of angle, v(s) = int h R gamma' ds the change of position, and lambda with its steps,

    Q = int K h'^2 - <lambda, gamma'> h^2 ds + sum over ties (T / l) (int from p to q of <u, gamma'> h ds)^2
        - sum over rails (2 t h sigma + t kappa sigma^2),    sigma = -<gamma', v> at the station,

on the changes for which the ends stay, v = 0 at pins, <n, v> = 0 at rails, and <u, v_q - v_p> = 0 for taut ties.
T is the pull of a tie of length l along u, and t n the force of a rail. The term of a tie is that of a cord that
keeps its length while its ends turn about each other. The term of a rail lets the strip slide over it: the place of
contact moves by sigma along the strip.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.geometry.plane_points import left_of
from elastica_cad.mechanics.elements import ElementForce, Pin, Rail, Tie
from elastica_cad.mechanics.loads import Supports

SLACK_SHARE = 0.01
"""Force of a one-sided element, as a fraction of the largest force, below which it counts as slack."""

_RANK = 1e-9  # relative singular value of dependent constraints


@dataclass(frozen=True, eq=False)
class Bracing:
    """Elements in the second variation of a discrete rod of n edges.

    Attributes
    ----------
    rows : (k, n) array
        Constraints rows @ h = 0.
    terms : (r, n) array
        Linear forms of h, each of length 1.
    coefficients : (r, r) array
        Symmetric, invertible C: terms^t C terms is added to the Hessian.
    """

    rows: FloatArray
    terms: FloatArray
    coefficients: FloatArray


def slack_elements(between: Sequence[ElementForce], force: FloatArray) -> tuple[ElementForce, ...]:
    """Return the one-sided elements that hardly act; `force` (n, 2) is lambda along the rod, 1/mm2."""
    largest = max(float(np.hypot(*force.T).max()), max((action.size for action in between), default=0.0))
    return tuple(
        action
        for action in between
        if (
            isinstance(action.element, Tie) or (isinstance(action.element, Rail) and action.element.one_sided)
        )
        and action.size <= SLACK_SHARE * largest
    )


def bracing_of(
    between: Sequence[ElementForce],
    *,
    tangents: FloatArray,
    edge_length: float,
    supports: Supports,
    position: FloatArray,
    curvature: FloatArray,
) -> Bracing:
    """Return the bracing of a discrete rod by its taut elements.

    Parameters
    ----------
    tangents : (n, 2) array
        Unit tangents of the edges.
    edge_length : float
        mm.
    position : (n + 1, 2) array
        Nodes, mm.
    curvature : (n + 1,) array
        At the nodes, 1/mm.

    Raises
    ------
    InputError
        Neither an end nor an element stops the rod from sliding on its rails.
    """
    n = len(tangents)
    across = edge_length * left_of(tangents).T
    ends = supports.ends
    middles, nodes = edge_length * (np.arange(n) + 0.5), edge_length * np.arange(n + 1)
    free = np.array([not (getattr(ends[0], axis) or getattr(ends[1], axis)) for axis in "xy"])
    from_end = np.array([getattr(ends[1], axis) and not getattr(ends[0], axis) for axis in "xy"])

    def covered(s: float) -> FloatArray:
        """Return the fraction of each edge before arc length s."""
        return np.asarray(np.clip(s / edge_length - np.arange(n), 0.0, 1.0))

    def moves(s: float) -> FloatArray:
        """Return the change of position (2, n) at arc length s, from the end that holds each coordinate."""
        return np.asarray(across * (covered(s) - from_end[:, None]))

    rows: list[tuple[FloatArray, FloatArray]] = []  # of h, and of a translation of the whole rod
    slides: list[tuple[FloatArray, FloatArray]] = []
    terms: list[FloatArray] = []
    blocks: list[FloatArray] = []
    chords: list[FloatArray] = []
    for action in between:
        if isinstance(action.element, Tie):
            p, q = (np.array([np.interp(s, nodes, c) for c in position.T]) for s in action.s)
            size = float(np.hypot(*(q - p)))
            u = (q - p) / size
            chords.append(u)
            cover = covered(float(action.s[1])) - covered(float(action.s[0]))
            rows.append((u @ (across * cover), np.zeros(2)))
            terms.append(edge_length * cover * (tangents @ u))
            blocks.append(np.array([[float(action.force[0] @ u) / size]]))
            continue
        s = float(action.s[0])
        if isinstance(action.element, Pin):
            rows += list(zip(moves(s), np.eye(2), strict=True))
            continue
        right = np.clip(np.searchsorted(middles, s), 1, n - 1)
        share = np.clip((s - middles[right - 1]) / edge_length, 0.0, 1.0)
        turn = np.zeros(n)
        turn[[right - 1, right]] = 1 - share, share
        tangent = turn @ tangents
        tangent /= np.hypot(*tangent)
        normal = left_of(tangent)
        rows.append((normal @ moves(s), normal))
        push = float(action.force[0] @ normal)
        if push != 0:
            slides.append((-tangent @ moves(s), -tangent))
            terms += [turn, slides[-1][0]]
            kappa = float(np.interp(s, nodes, curvature))
            blocks.append(-push * np.array([[0.0, 1.0], [1.0, kappa]]))
    forms = np.array([form for form, _ in rows]).reshape(-1, n)
    if free.any():
        shift = np.array([shift for _, shift in rows]).reshape(-1, 2)[:, free]
        u, sigma, vt = np.linalg.svd(shift)
        rank = int(np.count_nonzero(sigma > _RANK))
        if slides and rank < np.count_nonzero(free):
            raise InputError("The strip can slide off its rails. Hold an end, or pin it at a place between.")
        # the translation is that for which the constraints hold: shift @ v = -forms @ h
        translation = -(vt[:rank].T / sigma[:rank]) @ u[:, :rank].T @ forms
        for form, along in slides:
            form[:] = form + along[free] @ translation
        forms = u[:, rank:].T @ forms
    if (
        chords
        and free.all()
        and not any(end.angle for end in ends)
        and all(isinstance(action.element, Tie) for action in between)
    ):
        # a bow turns as a whole without a change of energy
        forms = np.concatenate([forms, edge_length * (tangents @ chords[0])[None]])
    coefficients, first = np.zeros((len(terms), len(terms))), 0
    for block in blocks:
        last = first + len(block)
        coefficients[first:last, first:last] = block
        first = last
    added = np.array(terms).reshape(-1, n)
    length = np.linalg.norm(added, axis=1)
    return Bracing(forms, added / length[:, None], coefficients * length[:, None] * length)
