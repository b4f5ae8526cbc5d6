"""Two plates that hold inclined tabs at their angle."""

from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import replace
from typing import Any, TypeVar

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import is_number
from elastica_cad.errors import InputError, refuse_options_unlike
from elastica_cad.fabrication.holders.base_plate import BasePlate, TabSlot, base_plate, plate_with, tab_slot
from elastica_cad.fabrication.holders.placed_tab import Key, PlacedTab
from elastica_cad.fabrication.holders.ring_plate import GAP_MM, Ring, needed_length, ring_around, ring_plate
from elastica_cad.fabrication.holders.tab_seats import slot_walls, tab_seats
from elastica_cad.fabrication.holding.lean import Lean, lean_against
from elastica_cad.fabrication.holding.tab_seat import TabSeat
from elastica_cad.fabrication.placed_strip import Placed
from elastica_cad.fabrication.sheets.pieces import cut_key
from elastica_cad.fabrication.slots.slot import CLEARANCE_MM
from elastica_cad.fabrication.strip.tabs import ENDS
from elastica_cad.geometry.frame import Frame
from elastica_cad.mechanics.material.sheet import Sheet

LEAN_ROUNDS = 6
"""Most rounds of moving slots: three serve."""

LEANED_MM = 0.03
"""The last round moves slots by less: each leaves a tenth of what it moved."""

Plate = TypeVar("Plate", BasePlate, Ring)


def plate_pair(
    placed: Sequence[Placed],
    sheet: Sheet | str,
    *,
    gap: float = GAP_MM,
    frame: Frame | None = None,
    **options: Any,
) -> tuple[BasePlate, BasePlate]:
    """Two plates, one below the other, whose slots hold inclined tabs at their angle.

    A slot with vertical walls lets an inclined tab rock; a second one, further along the tab by the gap between the
    plates and so offset by gap cot(phi), leaves it no angle but its own. Slots are moved a little against the load
    of their tabs, which take up their play and bend between the plates: bodies of straight tabs run into them.

    Parameters
    ----------
    placed : sequence of Placed
    sheet : Sheet or its name
        Of both plates.
    gap : float
        Between the plates, mm.
    frame : Frame, optional
        The upper plate's upper face, z up.
    **options
        All others of `base_plate`.

    Returns
    -------
    (BasePlate, BasePlate)
        The upper and the lower one, called NAME and NAME-lower.

    Raises
    ------
    InputError
        A tab too short for the lower plate, with the length it needs; and as `base_plate`.
    """
    sheet = Sheet.of(sheet)
    require_gap(gap)
    refuse_options_unlike(options, base_plate, "a pair of plates")
    upper = base_plate(placed, sheet, frame=frame, **options)

    def lower(slots: Sequence[TabSlot], ground: Frame) -> BasePlate:
        kept = {key: options[key] for key in ("shape", "shop", "ignore_limits") if key in options}
        border = options.get("border", 12.0)
        return plate_with(slots, sheet, ground, border=border, name=f"{upper.name}-lower", **kept)

    room = {"play": options.get("play", 0.5), "clearance": options.get("clearance", CLEARANCE_MM)}
    return add_second(placed, upper, lower, gap=gap, least=options.get("slot_width") or 0.0, **room)


def ring_pair(
    placed: Sequence[Placed],
    tabs: Sequence[PlacedTab],
    sheet: Sheet,
    *,
    gap: float = GAP_MM,
    name: str = "ring",
    **options: Any,
) -> tuple[Ring, ...]:
    """Two rings about the z axis, one behind the other, that hold one end of all strips at its angle.

    Tabs that lie on a ring are glued to it: then it is one ring.

    Parameters
    ----------
    placed : sequence of Placed
        All strips of the surface.
    tabs : sequence of PlacedTab
        Of the same end of every strip.
    sheet : Sheet
        Of both rings.
    gap : float
        Between the rings, mm.
    name : str
        The second is called NAME-outer.
    **options
        All others of `ring_plate`.

    Raises
    ------
    InputError
        A tab too short for the second ring, with the length it needs; and as `ring_plate`.
    """
    require_gap(gap)
    refuse_options_unlike(options, ring_plate, "a pair of rings")
    first = ring_plate(tabs, sheet, name=name, **options)
    if first.seats:
        return (first,)

    def outer(slots: Sequence[TabSlot], ground: Frame) -> Ring:
        kept = {key: options[key] for key in ("border", "shop", "ignore_limits") if key in options}
        return ring_around(slots, sheet, ground, name=f"{name}-outer", **kept)

    room = {key: options[key] for key in ("play", "clearance") if key in options}
    return add_second(placed, first, outer, gap=gap, **room)


def require_gap(gap: float) -> None:
    """Refuse a gap between two plates that is none."""
    if not (is_number(gap) and gap > 0):
        raise InputError(f"the gap between two plates is {gap!r} mm: it must be positive")


def add_second(
    placed: Sequence[Placed],
    first: Plate,
    second: Callable[[Sequence[TabSlot], Frame], Plate],
    *,
    gap: float,
    play: float = 0.3,
    clearance: float = CLEARANCE_MM,
    least: float = 0.0,
) -> tuple[Plate, Plate]:
    """A plate and another behind it, `gap` mm further along the tabs, both leaned against their loads.

    Parameters
    ----------
    second : callable
        Makes the other plate of its slots and its upper face.
    play, clearance, least : float
        As in `tab_slot`.

    Raises
    ------
    InputError
        A tab too short, with the length it needs.
    """
    sheet, ground = first.sheet, first.frame.shifted(z=-first.sheet.thickness - gap)
    tabs = [slot.tab for slot in first.slots if slot.tab is not None]
    short = [tab for tab in tabs if tab.length < needed_length(tab, first, gap)]
    if short:
        needed = max(needed_length(tab, first, gap) for tab in short)
        raise InputError(
            f"{first.name}: the tab of {short[0].name} does not reach through the second plate: make it "
            f"{needed:.0f} mm long, or the gap smaller"
        )
    slots = [
        tab_slot(tab, ground, sheet.thickness, play=play, clearance=clearance, least=least, name=first.name)
        for tab in tabs
    ]
    return lean_pair(placed, (first, second(slots, ground)))


def lean_pair(placed: Sequence[Placed], plates: tuple[Plate, Plate]) -> tuple[Plate, Plate]:
    """The plates with their slots moved so that every loaded tab, play taken up and bent, lies as designed.

    The load is that of the strip as it is made: slots and widths that make up for them change it.
    """
    for _ in range(LEAN_ROUNDS):
        leans = _leans(placed, tab_seats(plates))
        first, second = (replace(plate, slots=_moved(plate, leans)) for plate in plates)
        old, new = (np.array([slot.corners for plate in pair for slot in plate.slots])
                    for pair in (plates, (first, second)))  # fmt: skip
        plates = first, second
        if np.abs(new - old).max(initial=0.0) <= LEANED_MM:
            break
    return plates


def _leans(placed: Sequence[Placed], seats: Mapping[Key, TabSeat]) -> dict[Key, Lean]:
    """How the holder of each tab is to be moved, ends that are cut and held alike computed once."""
    found, known = dict[Key, Lean](), dict[Hashable, Lean]()
    for one in placed:
        cut = cut_key(one.strip)
        for index, end in enumerate(ENDS):
            key = PlacedTab.of(one.strip, end, one.frame).key
            if key in seats:
                alike = cut, index, seats[key].places
                if alike not in known:
                    made = one.strip.as_made
                    ratio = made.tab_ratios(made.loaded)[index]
                    known[alike] = lean_against(made.loaded, index, seats[key], ratio)
                found[key] = known[alike]
    return found


def _moved(plate: Plate, leans: Mapping[Key, Lean]) -> tuple[TabSlot, ...]:
    """The slots of a plate, each moved within it by what its tab's holder is to be shifted and turned."""
    slots, walls = list(plate.slots), slot_walls(plate)
    # left of the curve is -z of the tab; its projection is the way within the plate
    ways = np.array([(tab.frame.x_axis, -tab.frame.z_axis) for _, tab, _ in walls]).reshape(-1, 2, 3)
    for (k, tab, own), (into, left) in zip(walls, (ways @ plate.frame.axes.T)[..., :2], strict=True):
        if (lean := leans.get(tab.key)) is not None:
            slots[k] = _moved_slot(slots[k], own, into, left, lean)
    return tuple(slots)


def _moved_slot(slot: TabSlot, walls: FloatArray, into: FloatArray, left: FloatArray, lean: Lean) -> TabSlot:
    """A slot whose walls (2, n, 2) are moved; into the tab and to its left are ways (2,) within the plate."""
    moves = []
    for wall in walls:
        place, slope = lean.touched(wall)
        # the tab is bent there: a wall that moves within the plate goes across it and along it
        across = left - slope * into
        moves.append((lean.shift + lean.turn * place) / float(across @ left) * left)
    first, second = moves
    return replace(slot, corners=slot.corners + np.array([first, first, second, second]))
