"""Displacement of a strip if a rail or pin is mounted at a wrong position, or a cord has a wrong length."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.plane_points import left_of, norm
from elastica_cad.mechanics.bending import fixed_places, state_of, system_of
from elastica_cad.mechanics.elements import ElementForce, Pin, Rail
from elastica_cad.mechanics.followed_path import shape_of
from elastica_cad.mechanics.mounted_elements import mounted
from elastica_cad.mechanics.newton_continuation import newton_step
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.rod_system import Residual, RodState

ROUNDING_FRACTION = 1e-6
"""Forces of rails, pins and ties up to this fraction of the largest force in the rod are rounding errors."""


def displacements_per_mm(rod: Rod) -> tuple[float, ...]:
    """Return the largest displacement of the rod, mm, per mm of error in mounting each rail, pin or tie.

    The error is a displacement of a pin in the worst direction, a displacement of a rail along its normal, or a
    change of the length of a tie. The equations of equilibrium are linearised about the present shape. The value
    does not hold for errors above the spare length of a pin (`spare_pieces`). It is 0 for a slack rail or tie.

    Parameters
    ----------
    rod : Rod
        Rod in equilibrium, with rails, pins or ties.

    Examples
    --------
    >>> from elastica_cad.geometry.plane_curve import PlaneCurve
    >>> from elastica_cad.mechanics.least_ratio import optimal_rod
    >>> wave = PlaneCurve.spline(
    ...     [(0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (360, 0)], degree=5)
    >>> [round(moved, 1) for moved in displacements_per_mm(optimal_rod(wave, between=Rail(200)))]
    [1.0]
    """
    rod = rod.following()
    actions = mounted(rod, None)
    least = ROUNDING_FRACTION * norm(rod.discrete.force).max()
    taut = [action.size > least for action in actions]
    acting = tuple(action for action, is_taut in zip(actions, taut, strict=True) if is_taut)
    if not acting:
        return (0.0,) * len(actions)
    moved = iter(_largest_moves(state_of(rod, replace(system_of(rod, rod), actions=acting)), acting))
    return tuple(next(moved) if is_taut else 0.0 for is_taut in taut)


@dataclass(frozen=True)
class SparePiece:
    """Piece of a rod between two fixed places: ends that are held in place, and pins.

    Attributes
    ----------
    start, end : float
        Arc lengths of the two places, mm.
    spare : float
        Length of the piece minus the distance between its ends, mm. Places that are farther apart by more than
        `spare` are out of reach.
    """

    start: float
    end: float
    spare: float


def spare_pieces(rod: Rod) -> tuple[SparePiece | None, ...]:
    """Return, for each pin, the neighbouring piece with the least spare length; None for rails and ties.

    Examples
    --------
    >>> from elastica_cad.geometry.plane_curve import PlaneCurve
    >>> from elastica_cad.mechanics.least_ratio import optimal_rod
    >>> arch = optimal_rod(PlaneCurve.arc((0, 0), 100, 2, 1), between=(Rail(30), Pin(40)))
    >>> [piece and round(piece.spare, 3) for piece in spare_pieces(arch)]
    [None, 0.266]
    """
    actions = mounted(rod, None)
    pieces = [
        SparePiece(s, next_s, max(next_s - s - float(norm(next_place - place)), 0.0))
        for (s, place), (next_s, next_place) in pairwise(fixed_places(actions, system_of(rod, rod)))
    ]
    return tuple(
        min(
            (piece for piece in pieces if action.s[0] in (piece.start, piece.end)),
            key=lambda piece: piece.spare,
            default=None,
        )
        if isinstance(action.element, Pin)
        else None
        for action in actions
    )


def _largest_moves(state: RodState, acting: Sequence[ElementForce]) -> Iterator[float]:
    """Yield, for each element, the largest displacement of the rod, mm, per mm of its mounting error.

    A pin may be off in all directions, a rail only across the strip, and a cord only in its length.
    """
    shape = shape_of(state)
    # index of the first position error of each element in `Residual.miss`, after those of the ends
    places = len(state.system.held) + state.system.elements.first_unknowns
    for action, at in zip(acting, places.tolist(), strict=True):
        if isinstance(action.element, Pin):
            directions = np.eye(2)
        elif isinstance(action.element, Rail):
            directions = left_of(shape.at(float(action.s[0]), 1))[None]
        else:
            directions = (shape.at(float(action.s[1])) - shape.at(float(action.s[0])))[None]
        units = directions / norm(directions)[:, None]
        moves = [_displacement(state, slice(at, at + 2), unit) for unit in units]
        # the spectral norm is the displacement of a node for the worst direction of the error
        yield float(np.linalg.norm(np.stack(moves, axis=-1), ord=2, axis=(1, 2)).max())


def _displacement(state: RodState, rows: slice, direction: FloatArray) -> FloatArray:
    """Return the displacements (n, 2) of the nodes per mm of position error along `direction`."""
    miss = np.zeros(state.reactions.size)
    miss[rows] = direction
    step = newton_step(state, Residual(np.zeros(state.angles.size), miss))
    # so small that the strip responds linearly
    small = 1e-6 * state.system.length
    return (state.moved(step, small).position - state.moved(step, -small).position) / (2 * small)
