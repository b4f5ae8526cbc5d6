"""An end of a strip whose tab has room in its holder: its stiffness, its walls, and one step of it."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache, cached_property

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.holding.tab_seat import TabSeat
from elastica_cad.forming.optimizer.quadratic_program import (
    QuadraticProgram,
    QuadraticSolution,
    solve_quadratic,
)
from elastica_cad.mechanics.rod.rod_record import Rod

STEP_SHARE = 0.05  # of the length: largest move of an end in one step
STEP_RAD = 0.15  # largest turn of an end in one step
PRICE = 100.0  # of a mm of overlap, over the forces that are there: far above most contacts' multipliers
TAB_PIECES = 16  # of a tab that bends: its turn at the mouth is then right to half a percent


@dataclass(frozen=True, eq=False)
class SeatedEnd:
    """An end with room: its tab as a chain of rigid pieces between bending joints.

    Unknowns are its shift, its turn and the angles of its tab's pieces; angles times the length of the strip, so
    that all are mm.

    Attributes
    ----------
    index : int
        0 for the start, 1 for the end.
    seat : TabSeat
    stiffness : float
        E I of the tab over the rod's B; infinite for tabs that do not bend.
    """

    index: int
    seat: TabSeat
    stiffness: float

    @property
    def way(self) -> int:
        """Which way along the strip its tab points."""
        return 1 if self.index else -1

    @property
    def pieces(self) -> int:
        """How many the tab has; none where it is stiff."""
        return TAB_PIECES if np.isfinite(self.stiffness) else 0

    @cached_property
    def piece(self) -> float:
        """Length of a piece, mm."""
        return self.seat.depth / TAB_PIECES

    @property
    def bending(self) -> FloatArray:
        """Hessian (m, m) of the tab's energy over B in the angles of its pieces, 1/mm."""
        return np.asarray(self.stiffness / self.piece * _chain(self.pieces))

    @cached_property
    def sideways(self) -> FloatArray:
        """How far (k, m) each edge's gap closes for the angle of each piece, mm."""
        into, _, side = self.seat.edges
        begins = self.piece * np.arange(self.pieces)
        covered = np.minimum(np.maximum(into[:, None] - begins, 0.0), self.piece)
        return np.asarray(-self.way * side[:, None] * covered)

    def load(self, rod: Rod, left: FloatArray, length: float) -> tuple[float, float]:
        """What its holder does to a rod along shift and turn, over B, 1/mm2; `left` is a unit vector (2,)."""
        k, sign = -self.index, -1.0 if self.index else 1.0
        return sign * float(rod.force[k] @ left), -sign * float(rod.moment[k]) / length

    def walls(self, part: FloatArray, length: float) -> tuple[FloatArray, FloatArray]:
        """Slopes (k, 2 + m) by its unknowns and gaps (k,), mm, between tab and edges; negative overlaps."""
        pose = float(part[0]), float(part[1]) / length
        gaps = self.seat.gaps(*pose, self.way)
        rows = np.empty((gaps.size, part.size))
        rows[:, :2] = self.seat.slopes(*pose, self.way)
        rows[:, 1] /= length
        if part.size > 2:
            rows[:, 2:] = self.sideways / length
            gaps = gaps + rows[:, 2:] @ part[2:]
        return rows, gaps


@cache
def _chain(pieces: int) -> FloatArray:
    """Hessian (m, m) of a chain of pieces whose joints have the stiffness 1."""
    # the first piece turns about the mouth, half a piece away from its middle
    springs = np.ones(pieces)
    springs[:1] = 2.0
    joints = np.eye(pieces) - np.eye(pieces, k=-1)
    return np.asarray(joints.T @ (springs[:, None] * joints))


def step_within(
    hessian: FloatArray,
    gradient: FloatArray,
    walls: tuple[FloatArray, FloatArray],
    length: float,
    shifts: Sequence[int],
    *,
    scale: float,
    price: float = PRICE,
    reach: float = np.inf,
) -> QuadraticSolution:
    """The next step of sequential quadratic programming, mm.

    Parameters
    ----------
    hessian, gradient : (n, n), (n,) arrays
        Of the energy over B.
    walls : ((k, n), (k,)) arrays
        Slopes and gaps of all edges.
    length : float
        Of the strip, mm: steps are bounded by shares of it.
    shifts : sequence of int
        Which unknowns are shifts; all others are angles.
    scale : float
        Stiffness of the ends by which all is divided, 1/mm3.
    price : float
        Of a mm of overlap.
    reach : float
        Farthest step of any unknown, mm.
    """
    rows, gaps = walls
    bound = np.full(gradient.size, STEP_RAD * length)
    bound[shifts] = STEP_SHARE * length
    each = price * (np.abs(gradient).max() / scale + bound.max())
    program = QuadraticProgram(
        hessian / scale, gradient / scale, -np.minimum(bound, reach), np.minimum(bound, reach), rows, -gaps,
        np.full(gaps.size, each), np.ones(gaps.size, dtype=bool),
    )  # fmt: skip
    return solve_quadratic(program)
