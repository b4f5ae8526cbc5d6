"""Where a holder touches a tab, and how far the tab can turn in it."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import is_number, numbers, require_positive
from elastica_cad.errors import InputError

STEEPEST_RAD = np.radians(80.0)
"""A tab that can turn this far counts as not held."""

STOP_RAD = np.radians(0.05)
"""Step of the turns that are tried."""

WALL_PLACES = 17
"""Number of places of a wall at which contact is checked: a tab bends in its pocket and may touch it in the
middle."""


@dataclass(frozen=True)
class EndPose:
    """Rest position of an end: `shift` mm to the left of the design, `turn` rad anticlockwise."""

    shift: float = 0.0
    turn: float = 0.0


@dataclass(frozen=True, eq=False)
class TabSeat:
    """The edges of a holder on both sides of a tab, in the plane of the strip's curve.

    Places are told as (into, left): how far into the tab from the end of the free part, and how far to the left of
    the tab's designed middle line, seen along the strip from start to end; mm.

    Parameters
    ----------
    left, right : (k, 2) array_like
        Edges that the tab's left and right faces can touch.
    thickness : float
        Of the tab, mm.
    name : str
        What holds it, as messages say it.

    Examples
    --------
    >>> seat = TabSeat.pocket(length=10, thickness=0.8, play=0.15)
    >>> [round(float(np.degrees(turn)), 2) for turn in seat.turning]
    [-1.72, 1.72]
    """

    left: FloatArray
    right: FloatArray
    thickness: float
    name: str = "holder"

    def __post_init__(self) -> None:
        for side in ("left", "right"):
            edges = numbers(getattr(self, side), f"{side} edges of a seat")
            if edges.ndim == 0 or (edges.size and edges.shape[-1] != 2):
                raise InputError(
                    "{side} edges of a seat are rows (k, 2) of the record, in mm, not {shape}",
                    side=side,
                    shape=edges.shape,
                )
            object.__setattr__(self, side, edges.reshape(-1, 2))

    @classmethod
    def pocket(cls, length: float, thickness: float, play: float, *, name: str = "pocket") -> "TabSeat":
        """A straight pocket around the tab with `play` mm on either face.

        Raises
        ------
        InputError
            Play below 0.
        """
        require_positive(length, f"{name}: the length")
        require_positive(thickness, f"{name}: the thickness")
        if not (is_number(play) and play >= 0):
            raise InputError(
                "{name}: the play is {play!r} mm: it must be 0 or more for the tab to go in",
                name=name,
                play=play,
            )
        into = np.linspace(0.0, length, WALL_PLACES)
        half = np.full(into.size, thickness / 2 + play)
        return cls(np.column_stack([into, half]), np.column_stack([into, -half]), thickness, name)

    @cached_property
    def edges(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Into and left of all edges, those of the left face first, and their faces' sides: 1 left, -1 right."""
        into, left = np.concatenate([self.left, self.right]).T.copy()
        return into, left, np.repeat([1.0, -1.0], [len(self.left), len(self.right)])

    @property
    def depth(self) -> float:
        """Depth to which the holder reaches into the tab, mm."""
        return float(max(self.left[:, 0].max(), self.right[:, 0].max()))

    @property
    def room(self) -> float:
        """Distance by which the tab can shift across between the edges, in its designed direction, mm; 0 where
        they press it."""
        return max(0.0, float(self.left[:, 1].min() - self.right[:, 1].max()) - self.thickness)

    @property
    def places(self) -> tuple[float, ...]:
        """All edges, rounded: of seats that are alike the same."""
        return tuple(np.round([*self.left.ravel(), *self.right.ravel()], 9).tolist())

    def moved(self, shift: float, turn: float) -> "TabSeat":
        """The holder shifted to the left, mm, and turned towards the left, rad, about the end of the free part."""
        cos, sin = np.cos(turn), np.sin(turn)
        rotation = np.array([[cos, sin], [-sin, cos]])
        left, right = (side @ rotation + (0.0, shift) for side in (self.left, self.right))
        return TabSeat(left, right, self.thickness, self.name)

    def gaps(self, shift: float, turn: float, way: int) -> FloatArray:
        """Room (k,), mm, between each edge and the tab's face; negative where they overlap.

        The free part ends `shift` mm to the left of the design and the strip's tangent is turned by `turn` rad
        anticlockwise; `way` is +1 at the end of the strip and -1 at its start, where the tab points backwards.
        """
        cos, sin = np.cos(turn), np.sin(turn)
        into, left, side = self.edges
        return np.asarray(side * (-way * into * sin + (left - shift) * cos) - self.thickness / 2)

    def slopes(self, shift: float, turn: float, way: int) -> FloatArray:
        """Derivatives (k, 2) of `gaps` by shift and turn."""
        cos, sin = np.cos(turn), np.sin(turn)
        into, left, side = self.edges
        return np.column_stack([-cos * side, side * (-way * into * cos - (left - shift) * sin)])

    def bends(self, shift: float, turn: float, way: int) -> FloatArray:
        """Second derivatives (k, 2, 2) of `gaps` by shift and turn."""
        cos, sin = np.cos(turn), np.sin(turn)
        into, left, side = self.edges
        found = np.zeros((side.size, 2, 2))
        found[:, 0, 1] = found[:, 1, 0] = sin * side
        found[:, 1, 1] = side * (way * into * sin - (left - shift) * cos)
        return found

    @cached_property
    def turning(self) -> tuple[float, float]:
        """Angles, rad, by which the tab can turn to the right (negative) and to the left, seen outward."""
        return -self._stop(-1), self._stop(1)

    def _stop(self, sense: int) -> float:
        # at way = +1 the outward direction is the strip's, so turns are the tab's own
        turn = np.arange(0.0, STEEPEST_RAD, STOP_RAD)
        cos, sin = np.cos(sense * turn)[:, None], np.sin(sense * turn)[:, None]
        (a, b), (c, d) = self.left.T, self.right.T
        most = (b - (a * sin + self.thickness / 2) / cos).min(axis=1)
        least = (d + (self.thickness / 2 - c * sin) / cos).max(axis=1)
        # what fits at an angle need not fit at all smaller ones, but the first stop on the way out counts
        room = most - least
        jams = np.flatnonzero(room[1:] < -1e-12)
        if not jams.size:
            return float(STEEPEST_RAD)
        k = jams[0]
        return float(turn[k] + STOP_RAD * max(0.0, room[k]) / (max(0.0, room[k]) - room[k + 1]))
