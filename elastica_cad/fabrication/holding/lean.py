"""How a holder is to be shifted and turned, so that the loaded tab in it lies as designed."""

from dataclasses import dataclass
from functools import cached_property
from itertools import chain, repeat

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.holding.seated_end import SeatedEnd, step_within
from elastica_cad.fabrication.holding.tab_seat import TabSeat
from elastica_cad.forming.optimizer.quadratic_program import QuadraticSolution
from elastica_cad.mechanics.rod.rod_record import Rod

SHORTENING = (1.0, 0.1, 0.01)
"""Stiffness of an end over its load / length in the first steps: what is stiff in its place keeps them short."""

FREE = 1e-4
"""The same in all others, which end where it is of no account: each leaves this share of what it moved."""

MOST_STEPS = 36
"""Half a dozen are usual, one or two near what was found before."""

SETTLED_SHARE = 1e-7
"""Of the length: what a step moves when the contacts have been found."""

ALIKE_DIGITS = 11
"""Of loads and lengths that are one: rounding of strips made alike in different places."""


@dataclass(frozen=True)
class Lean:
    """How a holder is shifted, mm, and turned, rad, to the left.

    `slopes` are those of the tab's pieces at rest, each `piece` mm long, to its left; `touching` is the last step,
    with what touches.
    """

    shift: float
    turn: float
    slopes: FloatArray
    piece: float
    touching: QuadraticSolution | None = None

    def touched(self, wall: FloatArray) -> tuple[float, float]:
        """How far into the tab at rest a wall of the moved holder comes nearest to it, mm, and its slope there.

        Parameters
        ----------
        wall : (n, 2) array
            Places of the wall before it is moved, into the tab and to its left, mm.
        """
        (into, left), (slopes, places, bent) = wall.T, self._at_rest
        gaps = left + self.shift + self.turn * into - np.interp(into, places, bent)
        place = float(into[np.abs(gaps).argmin()])
        return place, float(slopes[min(int(place / self.piece), slopes.size - 1)])

    @cached_property
    def _at_rest(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """The tab's slopes (k,), and where its pieces begin and end (k + 1,): into it and to its left, mm."""
        slopes = np.resize(self.slopes, max(self.slopes.size, 1))  # stiff tabs are one straight piece
        bent = np.append(0.0, np.cumsum(slopes)) * self.piece
        return slopes, np.asarray(self.piece * np.arange(slopes.size + 1), dtype=float), bent


def lean_against(
    design: Rod,
    index: int,
    seat: TabSeat,
    tab_stiffness: float = np.inf,
    near: Lean | None = None,
) -> Lean:
    """How a holder is shifted and turned so that the loaded tab lies as designed.

    The strip's force and moment press the tab against some edges of the holder: moved by this, those edges are
    where the tab is meant to be, and all play lies on the other sides. The load stays what it is, so an end that
    were free to move would be thrown as far as a step may go: it is held by a spring that is softened.

    Parameters
    ----------
    design : Rod
    index : int
        0 for the start, 1 for the end.
    seat : TabSeat
        The holder where it was designed.
    tab_stiffness : float
        E I of the tab over the rod's B; a stiff tab unless given.
    near : Lean, optional
        Found in a seat like this one: changes the time only.
    """
    end, length = SeatedEnd(index, seat, tab_stiffness), design.length
    load, piece, way, n = _load(end, design), end.piece, end.way, 2 + end.pieces
    shift = turn = 0.0
    slopes, touching = (np.zeros(end.pieces), None) if near is None else (near.slopes, near.touching)
    pressed = max(map(abs, load))
    if pressed == 0:
        return Lean(shift, turn, slopes, piece, touching)
    H, g, q = np.zeros((n, n)), np.zeros(n), np.zeros(n)
    g[:2], q[2:] = load, way * length * slopes
    springs = chain(SHORTENING if near is None else (), repeat(FREE))
    for spring, _ in zip(springs, range(MOST_STEPS), strict=False):
        H[0, 0] = H[1, 1] = spring * pressed / length
        if n > 2:
            H[2:, 2:] = end.bending / length**2
            g[2:] = H[2:, 2:] @ q[2:]
        touching = step_within(H, g, end.walls(q, length), length, [0], scale=H[0, 0])
        q[2:] += touching.x[2:]
        # the holder is moved against the tab, which stays where it is
        shift, turn = shift - float(touching.x[0]), turn - way * float(touching.x[1]) / length
        if np.abs(touching.x).max() <= SETTLED_SHARE * length:
            break
        end = SeatedEnd(index, seat.moved(shift, turn), tab_stiffness)
    return Lean(shift, turn, q[2:] * way / length, piece, touching)


def what_leans(
    design: Rod, index: int, seat: TabSeat, tab_stiffness: float = np.inf
) -> tuple[int | float, ...]:
    """All that `lean_against` hangs on, to rounding: of ends that are loaded and held alike the same."""
    numbers = (design.length, *_load(SeatedEnd(index, seat, tab_stiffness), design), tab_stiffness)
    return (index, *(float(f"{number:.{ALIKE_DIGITS}g}") for number in numbers), seat.thickness, *seat.places)


def _load(end: SeatedEnd, design: Rod) -> tuple[float, float]:
    """What the holder does to the end of the design, along its shift and turn."""
    angle = float(design.angle[-end.index])
    return end.load(design, np.array([-np.sin(angle), np.cos(angle)]), design.length)
