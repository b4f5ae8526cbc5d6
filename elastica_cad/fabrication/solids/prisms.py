"""Bodies made of prisms: some are put together, others and round grooves taken away."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from math import cos, sin, tan

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import several
from elastica_cad.errors import InputError
from elastica_cad.fabrication.solids.strip_solids import FlatSolid
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Arc, Line

DENT = 0.85
"""Length of the way, in radii, below which one dent does: the dots of letters."""

FLAT_SHARE = 1e-15
"""Of the squared size of a polygon, the area by which a corner must stand out of it: rounding."""


@dataclass(frozen=True, eq=False)
class RoundGroove:
    """What a ball of this radius would take away along a line or an arc, with plane ends: few faces for a letter.

    Attributes
    ----------
    way : Line or Arc
        Of the ball's middle, in the xy plane of `frame`; a way shorter than `DENT` radii that goes on nowhere is a
        single dent.
    radius : float
        mm.
    frame : Frame
        Its z axis points out of the body; the ball's middle lies outside, so that no seam of a ball does.
    turns : pair of float or None
        At the start and the end: None where the groove ends; else the turn to the left, rad, to another that goes
        on there. The end of a line that turns is mitred.
    """

    way: Line | Arc
    radius: float
    frame: Frame
    turns: tuple[float | None, float | None] = (None, None)

    @property
    def is_dent(self) -> bool:
        """A ball at the middle of the way?"""
        return self.turns == (None, None) and self.way.length < DENT * self.radius

    @property
    def tips(self) -> tuple[float, float]:
        """How far the outer sides of mitred ends reach beyond the way, mm."""
        start, end = (self.radius * tan(abs(turn or 0.0) / 2) for turn in self.turns)
        return start, end

    @property
    def length(self) -> float:
        """Of a line with its tips, mm."""
        return self.way.length + sum(self.tips)

    @property
    def start(self) -> Frame:
        """Of a line where its tip starts, x axis out of the body and z axis along it; of an arc its centre, x axis
        to the end from which it turns to the left; of a dent its middle.
        """
        way, out = self.way, self.frame.z_axis
        if self.is_dent:
            return Frame(self.frame.point(way.at(0.5)), self.frame.x_axis, self.frame.y_axis)
        if isinstance(way, Line):
            along = self.frame.direction((way.end - way.start) / way.length)
            return Frame(self.frame.point(way.start) - self.tips[0] * along, out, np.cross(along, out))
        first = way.start if way.sweep > 0 else way.end
        along = self.frame.direction((first - way.center) / way.radius)
        return Frame(self.frame.point(way.center), along, np.cross(out, along))

    @property
    def mitres(self) -> tuple[FlatSolid, ...]:
        """Blocks beyond the planes in which the groove meets others at corners: they are cut off it."""
        found = []
        for place, turn, way in zip((0.0, 1.0), self.turns, (-1.0, 1.0), strict=True):
            if turn:
                # the mitre's plane halves the corner
                c, s = cos(turn / 2), sin(turn / 2)
                x, y = self.way.tangent_at(place).tolist()
                away = self.frame.direction([way * c * x - s * y, s * x + way * c * y])
                plane = Frame(self.frame.point(self.way.at(place)), away, np.cross(self.frame.z_axis, away))
                size = 4 * self.radius
                block = Path.rectangle(size, 2 * size, corner=(0.0, -size))
                found.append(FlatSolid(block, (), 2 * size, plane.shifted(z=-size)))
        return tuple(found)


@dataclass(frozen=True, eq=False)
class PrismSolid:
    """The union of the prisms `added`, less the prisms and grooves `removed`.

    Attributes
    ----------
    added : tuple of FlatSolid
        Closed outlines with holes and thickness, each in its own frame.
    removed : tuple of FlatSolid and RoundGroove
    joints : mapping of str to Frame
        Places to join other parts to.

    Raises
    ------
    InputError
        Nothing added.
    """

    added: tuple[FlatSolid, ...]
    removed: tuple[FlatSolid | RoundGroove, ...] = ()
    joints: Mapping[str, Frame] = field(default_factory=dict)

    def __post_init__(self) -> None:
        kinds = {"added": FlatSolid, "removed": FlatSolid | RoundGroove}
        for name, kind in kinds.items():
            found = several(f"the {name} prisms", getattr(self, name), kind, "FlatSolid or RoundGroove")
            object.__setattr__(self, name, found)
        if not self.added:
            raise InputError("a body of prisms needs at least one prism")


def convex_corners(points: FloatArray) -> FloatArray:
    """Corners (n, 2), anticlockwise from the leftmost, of the least convex polygon around points (m, 2) of an area.

    Points that lie on its sides but for rounding are none. (Andrew's monotone chain, 1979; scipy's hull takes a
    seventh of a second to be loaded.)

    Examples
    --------
    >>> convex_corners(np.array([[0.0, 0.0], [1.0, 0.5], [2.0, 0.0], [1.0, 0.0], [1.0, 2.0]])).tolist()
    [[0.0, 0.0], [2.0, 0.0], [1.0, 2.0]]
    """
    places = sorted(set(zip(*np.asarray(points, dtype=float).T.tolist(), strict=True)))
    least = FLAT_SHARE * float(np.ptp(points, axis=0).max()) ** 2
    lower, upper = _right_turns_cut(places, least), _right_turns_cut(places[::-1], least)
    return np.array([*lower[:-1], *upper[:-1]], dtype=float)


def _right_turns_cut(places: Sequence[tuple[float, float]], least: float) -> list[tuple[float, float]]:
    """The chain from the first to the last of sorted places that turns to the left alone."""
    chain: list[tuple[float, float]] = []
    for x, y in places:
        while len(chain) > 1:
            (a, b), (c, d) = chain[-2:]
            if (c - a) * (y - b) - (d - b) * (x - a) > least:
                break
            chain.pop()
        chain.append((x, y))
    return chain
