"""What holders leave free: their play in numbers, tabs that rock, and two plates tried in place of one."""

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import TypeGuard

import numpy as np

from elastica_cad._counts import and_more
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.fabrication.holders.base_plate import BasePlate, TabSlot
from elastica_cad.fabrication.holders.placed_tab import PlacedTab
from elastica_cad.fabrication.holders.plate_pair import Plate, add_second, needed_length
from elastica_cad.fabrication.holders.ring_plate import Ring
from elastica_cad.fabrication.holders.tab_seats import plates_of, require_holders, seat_of, tab_seats
from elastica_cad.fabrication.holding.tab_seat import TabSeat
from elastica_cad.fabrication.placed_strip import Placed, distinct_names, require_placed
from elastica_cad.fabrication.strip.tabs import ENDS, StripEnd
from elastica_cad.geometry.frame import Frame

ROCKING_RAD = np.radians(3.0)
"""A tab that turns farther in its holder rocks: at the mouth of a strip it moves the shape by percents."""

NO_PLAY_MM, NO_PLAY_DEGREES = 1e-3, 1e-2
"""What is told as no play."""

TRIED_GAPS_MM = (10.0, 20.0)
"""Between two plates that are tried in place of one; the first that keeps the tab from rocking is told."""


def holder_plays(placed: Sequence[Placed], holders: Iterable[object]) -> tuple[str, ...]:
    """A sentence for every holder: how far its tabs shift across and turn in it at most, before they jam."""
    placed, holders, told = require_placed(placed), require_holders(holders), []
    for name, held in _by_holder(placed, holders).items():
        low, high = np.degrees(np.array([seat.turning for _, _, seat in held]).T)
        room = max(seat.room for _, _, seat in held)
        if room < NO_PLAY_MM and high.max() - low.min() < NO_PLAY_DEGREES:
            told.append(f"{name} leaves its tabs no play: they bend a little between its edges")
        else:
            across = 0.0 if room < NO_PLAY_MM else room
            least, most = _turn(low.min()), _turn(high.max())
            told.append(f"{name} leaves its tabs {across:.2g} mm across and {least} to {most} degrees")
    glued = (one for one in holders if (isinstance(one, BasePlate) and one.glued) or _lies_on(one))
    return (*told, *(f"{one.name} leaves its tabs no play: they are glued at their angle" for one in glued))


def _lies_on(holder: object) -> TypeGuard[Ring]:
    """Is this a ring on which tabs lie?"""
    return isinstance(holder, Ring) and bool(holder.seats)


def _turn(degrees: float) -> str:
    """With its sign; 0 for a turn too small to be seen."""
    return "0" if abs(degrees) < NO_PLAY_DEGREES else f"{degrees:+.2g}"


def rocking_tabs(placed: Sequence[Placed], holders: Iterable[object]) -> tuple[str, ...]:
    """A sentence for every holder in which tabs rock: the one that rocks most, its shape, and a cure, tried."""
    placed, holders, told = require_placed(placed), require_holders(holders), []
    names = dict(zip(map(id, placed), distinct_names(placed), strict=True))
    for holder, held in _by_holder(placed, holders).items():
        rocking = [one for one in held if np.ptp(one[2].turning) > 2 * ROCKING_RAD]
        if rocking:
            one, end, seat = max(rocking, key=lambda row: float(np.ptp(row[2].turning)))
            low, high = np.degrees(seat.turning)
            told.append(
                f"{names[id(one)]}{and_more(rocking)}: in the {holder} the tab at its {end} rocks by "
                f"{low:+.0f} to {high:+.0f} degrees and does not hold the drawn angle; "
                f"{_shape(one, tab_seats(holders))}; {_cure(one, end, holders)}"
            )
    return tuple(told)


def _by_holder(
    placed: Sequence[Placed], holders: Iterable[object]
) -> dict[str, list[tuple[Placed, StripEnd, TabSeat]]]:
    """Strips, ends and seats by what holds them."""
    seats, found = tab_seats(holders), dict[str, list[tuple[Placed, StripEnd, TabSeat]]]()
    for one in placed:
        for end in ENDS:
            seat = seat_of(seats, one, end)
            if seat is not None:
                found.setdefault(seat.name, []).append((one, end, seat))
    return found


def _shape(one: Placed, seats: dict[tuple[float, ...], TabSeat]) -> str:
    """What becomes of a strip in its seats."""
    try:
        strayed = one.strip.held(*(seat_of(seats, one, end) for end in ENDS)).deviation
    except NotConvergedError:
        return "the strip finds no rest in it"
    return f"the strip strays {strayed:.2g} mm so, {100 * strayed / one.strip.rod.length:.2g} % of its length"


def _cure(one: Placed, end: StripEnd, holders: Sequence[object]) -> str:
    """Two plates in place of the one that holds a tab, bent forward, or what else there is."""
    others = "end fixtures or feet (feet = 10) glued at its angle"
    for gap in TRIED_GAPS_MM:
        tried = _with_pair(one, end, holders, gap)
        if tried is not None:
            long, strayed = tried
            return (
                f"two plates (gap = {gap:g}) and tabs of {long:.0f} mm hold it to {strayed:.2g} mm, as was tried, "
                f"or use {others}"
            )
    return f"use {others}"


def _with_pair(
    one: Placed, end: StripEnd, holders: Sequence[object], gap: float
) -> tuple[float, float] | None:
    """Length of the tabs and how far the strip strays, mm, with a second plate behind its own; None: no cure."""
    keys = {PlacedTab.of(one.strip, which, one.frame).key: which for which in ENDS}
    mine = [(plate, slot, keys[slot.tab.key]) for plate in plates_of(holders) for slot in plate.slots
            if slot.tab is not None and slot.tab.key in keys]  # fmt: skip
    if not any(which == end for _, _, which in mine) or len({which for _, _, which in mine}) < len(mine):
        return None
    lengths = [needed_length(slot.tab, plate, gap) for plate, slot, _ in mine if slot.tab is not None]
    long = max(*lengths, *(tab.length for tab in one.strip.ends))
    first, last = (replace(tab, length=long) for tab in one.strip.ends)
    longer = one.with_strip(replace(one.strip, ends=(first, last)))
    plates: list[BasePlate | Ring] = []
    try:
        for plate, slot, which in mine:
            tab = PlacedTab.of(longer.strip, which, longer.frame, name=slot.name)
            slots = (replace(slot, tab=tab),)
            # one by one: a type for each
            if isinstance(plate, Ring):
                plates += _pair(longer, replace(plate, slots=slots), gap)
            else:
                plates += _pair(longer, replace(plate, slots=slots), gap)
        seats = tab_seats(plates)
        if any(np.ptp(seat.turning) > 2 * ROCKING_RAD for seat in seats.values()):
            return None
        return long, longer.strip.held(*(seat_of(seats, longer, which) for which in ENDS)).deviation
    except (InputError, NotConvergedError):
        return None


def _pair(one: Placed, plate: Plate, gap: float) -> tuple[Plate, Plate]:
    """A plate and another behind it."""

    def behind(slots: Sequence[TabSlot], ground: Frame) -> Plate:
        return replace(plate, slots=tuple(slots), frame=ground, name=f"{plate.name}-outer")

    return add_second((one,), plate, behind, gap=gap)
