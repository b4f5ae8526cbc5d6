"""Rings and caps that hold the ends of a surface of revolution: flat plates with a slot or a seat for every tab."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import several
from elastica_cad.errors import InputError, refusing_old_names
from elastica_cad.fabrication.drawings.drawing import CUT_INNER, CUT_OUTER, ENGRAVE, Drawing, LayeredPath
from elastica_cad.fabrication.drawings.lettering import Text, text_width
from elastica_cad.fabrication.holders.base_plate import (
    FLATTEST_RAD,
    LABEL_MM,
    LEAST_OPENING_SHARE,
    BasePlate,
    TabSlot,
    around,
    check_sizes,
    check_slots,
    tab_slot,
)
from elastica_cad.fabrication.holders.placed_tab import PlacedTab
from elastica_cad.fabrication.makeability.shop import Shop
from elastica_cad.fabrication.sheets.pieces import Piece
from elastica_cad.fabrication.slots.slot import CLEARANCE_MM
from elastica_cad.fabrication.solids.strip_solids import FlatSolid
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.paths.path import Path
from elastica_cad.mechanics.material.sheet import Sheet

PLAY_MM = 0.3
"""Room beside a tab in its slot on either side; narrow, for tabs that stand close."""

GAP_MM = 20.0
"""Between two plates, unless told."""

BORDER_MM = 8.0
"""Least width of material beside slots and seats, unless told."""

LYING_RAD = np.radians(5.0)
"""Tabs at no larger angle to the ring lie on it: glue fills the wedge."""

CLEAR_MM = 0.5
"""Between a name and slots or rim."""

TAILS = 1 / 3
"""How far letters like g reach below their line, in heights."""

LEAST_LABEL_MM = 1.5
"""Smaller names are left out: they could not be read."""


@dataclass(frozen=True, eq=False)
class Ring:
    """A flat ring about an axis, or a cap where it has no hole.

    Attributes
    ----------
    sheet : Sheet
    frame : Frame
        The face that looks at the strips, its middle on the axis, z towards them.
    radii : (inner, outer)
        mm; inner 0 for a cap.
    slots : tuple of TabSlot
        For tabs that go through.
    seats : tuple of Path
        Engraved outlines of tabs that lie on it.
    holes : tuple of Path
        Of the bolts of such tabs.
    seated : tuple of str
        Names of such tabs.
    name : str
    warnings : tuple of str
        Why it should not be cut, where it was made all the same.
    """

    sheet: Sheet
    frame: Frame
    radii: tuple[float, float]
    slots: tuple[TabSlot, ...] = ()
    seats: tuple[Path, ...] = ()
    holes: tuple[Path, ...] = ()
    name: str = "ring"
    seated: tuple[str, ...] = ()
    warnings: tuple[str, ...] = ()

    @cached_property
    def outline(self) -> Path:
        """Its rim, in the frame."""
        return Path.circle((0.0, 0.0), self.radii[1])

    @cached_property
    def opening(self) -> Path | None:
        """A closed loop in its middle that is cut out; None of a cap."""
        return Path.circle((0.0, 0.0), self.radii[0]) if self.radii[0] else None

    @property
    def _others(self) -> tuple[Path, ...]:
        return (*self.holes, *(() if self.opening is None else (self.opening,)))

    @cached_property
    def _inner(self) -> tuple[Path, ...]:
        return (*(slot.path for slot in self.slots), *self._others)

    def checked(self, shop: Shop | None = None, *, ignore_limits: bool = False) -> "Ring":
        """The ring with what is to be said of it; one that cannot be cut is refused without `ignore_limits`.

        Raises
        ------
        InputError
            Slots that meet or are far wider than their tabs, thin bridges, a ring larger than the stock.
        """
        told = check_slots(
            self.name,
            self.sheet,
            self.outline,
            self.slots,
            self._others,
            shop=shop,
            ignore_limits=ignore_limits,
        )
        return replace(self, warnings=told)

    @property
    def solid(self) -> FlatSolid:
        """The plate in space, behind its frame."""
        thickness = self.sheet.thickness
        return FlatSolid(self.outline, self._inner, thickness, self.frame.shifted(z=-thickness))

    @cached_property
    def drawing(self) -> Drawing:
        """The cut pattern seen from the strips, with its name near the rim where there is room."""
        paths = [LayeredPath(CUT_INNER, path) for path in self._inner]
        paths += [LayeredPath(ENGRAVE, seat) for seat in self.seats]
        paths.append(LayeredPath(CUT_OUTER, self.outline))
        return Drawing(self.name, tuple(paths), self._label())

    @property
    def piece(self) -> Piece:
        """The ring as a piece to be cut."""
        return Piece(self.name, self.drawing, self.sheet)

    def _label(self) -> tuple[Text, ...]:
        loops = [slot.corners for slot in self.slots] + [seat.points(0.1) for seat in self.seats]
        inner = max(float(np.hypot(*loop.T).max()) for loop in loops) + CLEAR_MM
        outer = self.radii[1] - CLEAR_MM
        largest = min(LABEL_MM, 0.4 * (self.radii[1] - inner))
        if largest < LEAST_LABEL_MM:
            return ()
        for height in np.linspace(largest, LEAST_LABEL_MM, 12).tolist():
            half, below = text_width(self.name, height) / 2, height * TAILS
            most = float(np.sqrt(max(outer**2 - half**2, 0.0))) - height  # its upper corners lie on the rim
            if most >= inner + below:
                low = min(most, (inner + below + outer - height) / 2)
                return (Text((-half, low), self.name, height, 0.0, ENGRAVE),)
        return ()


def slot_reach(radius: float, angle: float, thickness: float, tab: float) -> float:
    """Least distance from the axis (mm) of a tab, `tab` mm thick, in a ring, or of the whole where it lies on it.

    It begins at a radius and goes out at an angle (rad) against the direction away from the axis.
    """
    if abs(np.sin(angle)) < np.sin(FLATTEST_RAD):
        return radius
    through = radius + thickness * float(np.cos(angle)) / abs(float(np.sin(angle)))
    return min(radius, through) - tab / 2 / abs(float(np.sin(angle))) - CLEARANCE_MM


@refusing_old_names
def ring_plate(
    tabs: Sequence[PlacedTab],
    sheet: Sheet | str,
    *,
    middle: float = np.inf,
    border: float = BORDER_MM,
    play: float = PLAY_MM,
    clearance: float = CLEARANCE_MM,
    name: str = "ring",
    shop: Shop | None = None,
    ignore_limits: bool = False,
) -> Ring:
    """The ring or cap about the z axis that holds one end of all strips of a surface of revolution.

    Tabs that meet its plane at more than 15 degrees go through slots; at less than 5 they lie on its face, on
    engraved seats, to be glued or bolted through their holes.

    Parameters
    ----------
    tabs : sequence of PlacedTab
        Of the same end of every strip.
    sheet : Sheet or its name
        Of the ring.
    middle : float
        Height of the model's middle, mm: where tabs lie on the ring it keeps to their other side.
    border : float
        Least width of material beside slots and seats, mm.
    play : float
        Room beside a tab in its slot on either side, mm.
    clearance : float
        Added to the width of slots, mm.
    name : str
    shop : Shop, optional
        What the workshop can make: bridges between slots, the largest sheet.
    ignore_limits : bool
        Make a ring that the workshop cannot, and say so in its warnings.

    Raises
    ------
    InputError
        Tabs that have no length, lie over each other, or meet the plane at angles between; slots that meet or are
        far wider than their tabs, bridges too thin to cut.
    """
    sheet = Sheet.of(sheet)
    check_sizes(name, border=border, play=play, clearance=clearance)
    tabs = several("tabs", tabs, PlacedTab, "PlacedTab")
    if not tabs:
        raise InputError(f"{name}: there is no tab for it to hold: give it PlacedTab records")
    first = tabs[0]
    if first.length == 0:
        raise InputError(f"{name}: strips without tabs cannot be held by a ring: give them tabs")
    height, rise = float(first.frame.origin[2]), float(first.frame.x_axis[2])
    if abs(rise) >= np.sin(FLATTEST_RAD):
        frame = _facing(height, up=rise < 0)
        slots = tuple(
            tab_slot(tab, frame, sheet.thickness, play=play, clearance=clearance, name=name) for tab in tabs
        )
        return ring_around(
            slots, sheet, frame, border=border, name=name, shop=shop, ignore_limits=ignore_limits
        )
    if abs(rise) > np.sin(LYING_RAD):
        lean, steep, flat = np.degrees([np.arcsin(abs(rise)), FLATTEST_RAD, LYING_RAD])
        raise InputError(
            f"{name}: the tabs meet its plane at {lean:.3g} degrees, too flat for slots and too steep to lie on "
            f"it: end strips where it is more than {steep:.0f} or less than {flat:.0f}"
        )
    below = middle > height
    frame = _facing(height + (-0.5 if below else 0.5) * first.thickness, up=below)
    seats = [_seat(tab, frame) for tab in tabs]
    _refuse_meeting_seats(seats, len(tabs), name)
    holes = tuple(
        Path.circle(frame.local(tab.frame.point((hole.at, hole.across, 0.0)))[:2], hole.diameter / 2)
        for tab in tabs
        for hole in tab.holes
    )
    loops = tuple(Path.polygon(seat) for seat in seats)
    found = Ring(sheet, frame, _radii(seats, border), seats=loops, holes=holes, name=name,
                 seated=tuple(tab.name for tab in tabs))  # fmt: skip
    return found.checked(shop, ignore_limits=ignore_limits)


def ring_around(
    slots: Sequence[TabSlot],
    sheet: Sheet | str,
    frame: Frame,
    *,
    border: float = BORDER_MM,
    name: str = "ring",
    shop: Shop | None = None,
    ignore_limits: bool = False,
) -> Ring:
    """The ring about the axis of its frame that has these slots; see `ring_plate`."""
    sheet = Sheet.of(sheet)
    radii = _radii([slot.corners for slot in slots], border)
    return Ring(sheet, frame, radii, tuple(slots), name=name).checked(shop, ignore_limits=ignore_limits)


def _facing(height: float, *, up: bool) -> Frame:
    """The plane across the axis at a height, looking up or down."""
    return Frame((0.0, 0.0, height), (1.0, 0.0, 0.0), (0.0, 1.0 if up else -1.0, 0.0))


def _seat(tab: PlacedTab, frame: Frame) -> FloatArray:
    """Corners (4, 2) of a tab that lies on the ring."""
    half = tab.width / 2
    corners = [(0.0, -half, 0.0), (tab.length, -half, 0.0), (tab.length, half, 0.0), (0.0, half, 0.0)]
    return frame.local(tab.frame.point(corners))[:, :2]


def _radii(loops: Sequence[FloatArray], border: float) -> tuple[float, float]:
    """Of the ring around loops (4, 2): inner, 0 where too little would be left open, and outer."""
    inner, outer = around(loops, np.zeros(2), border)
    return (inner if inner > LEAST_OPENING_SHARE * outer else 0.0), outer


def _refuse_meeting_seats(seats: Sequence[FloatArray], count: int, name: str) -> None:
    """Every tab keeps within its share of the full turn."""
    seat = seats[0]
    out = seat.mean(axis=0)
    out = out / max(float(np.hypot(*out)), 1e-300)
    along, across = seat @ out, np.abs(seat @ np.array([-out[1], out[0]]))
    if np.any(across >= along * np.tan(np.pi / count)):
        raise InputError(
            f"{name}: the tabs lie over each other {along.min():.3g} mm from the axis: end the strips at a larger "
            "ring, or give them shorter or narrower tabs"
        )


def needed_length(tab: PlacedTab, first: BasePlate | Ring, gap: float) -> float:
    """Length, in whole mm, that a tab needs to reach through a plate and another `gap` mm behind it."""
    back = first.frame.shifted(z=-2 * first.sheet.thickness - gap)
    missing = float(back.local(tab.tip)[2] / -(back.z_axis @ tab.frame.x_axis))
    return float(np.ceil(tab.length + missing))
