"""What holders leave free: their play in numbers, and tabs that rock."""

from collections.abc import Iterable, Sequence
from typing import TypeGuard

import numpy as np

from elastica_cad._counts import and_more
from elastica_cad.errors import NotConvergedError
from elastica_cad.fabrication.holders.base_plate import BasePlate
from elastica_cad.fabrication.holders.placed_tab import PlacedTab
from elastica_cad.fabrication.holders.ring_plate import GAP_MM, Ring, needed_length
from elastica_cad.fabrication.holders.tab_seats import plates_of, require_holders, seat_of, tab_seats
from elastica_cad.fabrication.holding.tab_seat import TabSeat
from elastica_cad.fabrication.placed_strip import Placed, distinct_names, require_placed
from elastica_cad.fabrication.strip.tabs import ENDS, StripEnd

ROCKING_RAD = np.radians(3.0)
"""A tab that turns farther in its holder rocks: at the mouth of a strip it moves the shape by percents."""

NO_PLAY_MM, NO_PLAY_DEGREES = 1e-3, 1e-2
"""What is told as no play."""


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
    """A sentence for every holder in which tabs rock: the one that rocks most, its shape, and a cure."""
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
    """What would hold a tab: two plates in place of the one that does, or what else there is."""
    key, others = (
        PlacedTab.of(one.strip, end, one.frame).key,
        "end fixtures or feet (feet = 10) glued at its angle",
    )
    lengths = [
        needed_length(slot.tab, plate, GAP_MM)
        for plate in plates_of(holders)
        for slot in plate.slots
        if slot.tab is not None and slot.tab.key == key
    ]
    if len(lengths) != 1:
        return f"use {others}"
    long = max(*lengths, *(tab.length for tab in one.strip.ends))
    return f"use two plates (gap = {GAP_MM:g}) and tabs of {long:.0f} mm, or {others}"
