"""The tabs of a strip in space: plates that go on straight from the bent part."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import require_record
from elastica_cad.errors import InputError
from elastica_cad.fabrication.placed_strip import Placed, require_placed, strip_names
from elastica_cad.fabrication.strip.outline import ENDS, Hole, StripEnd, TSlot
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.frame import Frame, frame_or_plain

Key: TypeAlias = tuple[float, ...]


def tab_name(strip: str, end: StripEnd) -> str:
    """Number of the part that is the tab at an end of a strip: the way its label reads."""
    return f"{strip}:{1 if end == 'start' else 2}"


@dataclass(frozen=True, eq=False)
class PlacedTab:
    """A tab in space.

    Attributes
    ----------
    frame : Frame
        Origin where the free part ends, half way through the thickness; x out of the strip into the tab, y across
        it, z off the strip's upper side.
    length, width, thickness : float
        mm.
    holes : tuple of Hole
        Seen along y of this frame.
    name : str
        Part number: the strip's name with 1 for the start and 2 for the end, which is the way its label reads.
    t_slot : TSlot or None
        The screw that goes in from the tip.
    """

    frame: Frame
    length: float
    width: float
    thickness: float
    holes: tuple[Hole, ...]
    name: str
    t_slot: TSlot | None = None

    @classmethod
    def of(
        cls, strip: Strip, end: StripEnd, frame: Frame | None = None, *, name: str | None = None
    ) -> "PlacedTab":
        """The tab at the start or the end of a strip whose curve is drawn in `frame`."""
        require_record(strip, Strip, "what a tab is of", "a Strip, as make_strip makes one")
        require_ends([end])
        place = frame_or_plain(frame)
        k, way = (0, -1.0) if end == "start" else (-1, 1.0)
        alpha = float(strip.rod.angle[k])
        out = way * place.direction([np.cos(alpha), np.sin(alpha)])
        origin = place.point(strip.rod.position[k])
        tab, own = strip.ends[k], strip.end_widths[k]
        if name is not None:
            require_record(name, str, "the name of a tab", "a text")
        called = name or strip.label or "strip"
        return cls(
            Frame(origin, out, way * place.z_axis),
            tab.length,
            tab.width or own,
            strip.end_thicknesses[k],
            tab.holes,
            tab_name(called, end),
            tab.t_slot,
        )

    @cached_property
    def key(self) -> Key:
        """Rounded position, by which holders and strips are matched."""
        return tuple(np.round([*self.frame.origin, *self.frame.x_axis], 6).tolist())

    @property
    def tip(self) -> FloatArray:
        """Middle of the tab's far end (3,), mm."""
        return self.frame.point((self.length, 0.0, 0.0))

    @property
    def edges(self) -> FloatArray:
        """Origins (4, 3) of the tab's four long edges; all run along x of the frame."""
        corners = [(0.0, i * self.width / 2, j * self.thickness / 2) for i in (-1, 1) for j in (-1, 1)]
        return self.frame.point(corners)


def place_tabs(placed: Sequence[Placed], ends: Sequence[StripEnd] = ENDS) -> list[PlacedTab]:
    """The tabs of all strips at these ends, strip by strip, called like the strips."""
    return [
        PlacedTab.of(one.strip, end, one.frame, name=name)
        for one, name in zip(placed, strip_names(placed), strict=True)
        for end in ends
    ]


def tabs_to_hold(placed: Sequence[Placed], ends: Sequence[StripEnd] = ENDS) -> list[PlacedTab]:
    """Place the tabs for which holders are to be made; refuses strips that none of our holders fits."""
    require_ends(ends)
    for one, name in zip(require_placed(placed), strip_names(placed), strict=True):
        require_holdable(one.strip, name)
    return place_tabs(placed, ends)


def require_ends(ends: object) -> None:
    """Refuse what names no ends of strips."""
    named = ends if isinstance(ends, Sequence) and not isinstance(ends, str) else (ends,)
    if not all(isinstance(end, str) and end in ENDS for end in named):
        raise InputError('ends are {ends!r}: give a list of "start" and "end" of the records', ends=ends)


def require_holdable(strip: Strip, name: str | None = None) -> None:
    """Refuse a strip whose ends fit none of our holders."""
    if strip.layout.stack is not None:
        raise InputError(
            "{name}: a stack of leaves lies on one side of its curve, where none of our holders "
            "is: hold its ends in clamps, and name the other strips as those that are held",
            name=name or strip.label or "strip",
        )
