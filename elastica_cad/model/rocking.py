"""Tabs that can tip in their holders, and tested suggestions for holding them at their angle."""

from collections.abc import Callable, Iterable, Sequence
from functools import cache, partial

import numpy as np

from elastica_cad._values import and_more
from elastica_cad.errors import (
    Angle,
    Change,
    FieldName,
    InputError,
    Length,
    NotConvergedError,
    note,
    sentences,
)
from elastica_cad.model.fixtures import PlacedTab, crowded_blocks, end_fixtures
from elastica_cad.model.frames import add_feet
from elastica_cad.model.held_tabs import (
    plates_with_play,
    require_holders,
    seat_of,
    seats_by_holder,
    tab_seats,
)
from elastica_cad.model.plate_pairs import fitting_tabs, pair_with_tabs, with_tabs
from elastica_cad.model.plates import GAP_MM, BasePlate, Ring, needed_length, tabs_of
from elastica_cad.strip.outline import ENDS, StripEnd
from elastica_cad.strip.strip import Placed, distinct_names, require_placed
from elastica_cad.strip.tab_seats import TabSeat

FEET_MM = 10.0


def rocking_tabs(placed: Sequence[Placed], holders: Iterable[object]) -> tuple[str, ...]:
    """Return a sentence for each holder in which tabs can rock.

    The sentence names the tab with the largest rotation, the deviation of its strip, and suggestions that were
    tested with these strips.
    """
    placed, holders, messages = require_placed(placed), require_holders(holders), []
    names = dict(zip(map(id, placed), distinct_names(placed), strict=True))
    two_plates = cache(partial(_two_plates, placed, holders))
    for holder, held in seats_by_holder(placed, holders).items():
        rocking = [place for place in held if place[2].rocks]
        if rocking:
            strip, end, seat = max(rocking, key=lambda row: float(np.ptp(row[2].turning)))
            here, other = (
                PlacedTab.of(strip.strip, k, strip.frame).frame for k in sorted(ENDS, key=lambda k: k != end)
            )
            right, left = np.abs(seat.turning)
            # if the tab turns to the left of the curve, the strip tips to its right, in the direction z
            lies_right = (other.origin - here.origin) @ here.z_axis > 0
            toward, away = (left, right) if lies_right else (right, left)
            messages.append(note(
                "{strip}{more}: in the {holder}, the tab at the {end} of the strip can tip by {toward:.0f} "
                "towards the other end and by {away:.0f} in the opposite direction. The tab "
                "does not keep the drawn angle; {shape}. {cure}",
                strip=names[id(strip)], more=and_more(rocking), holder=holder, end=end, toward=Angle(toward),
                away=Angle(away), shape=_deviation_sentence(strip, tab_seats(holders)), severity="warning",
                cure=_suggestions(strip, end, placed, holders, two_plates),
            ))  # fmt: skip
    return tuple(messages)


def _deviation_sentence(member: Placed, seats: dict[tuple[float, ...], TabSeat]) -> str:
    try:
        largest = member.strip.held(*(seat_of(seats, member, end) for end in ENDS)).deviation
    except NotConvergedError:
        return note("no stable shape of the strip was found with its tabs in the slots")
    return note(
        "the strip then deviates by up to {far:.2g} ({percent:.2g} % of its length)",
        far=Length(largest),
        percent=100 * largest / member.strip.rod.length,
    )


def _suggestions(
    member: Placed,
    end: StripEnd,
    placed: Sequence[Placed],
    holders: Sequence[object],
    two_plates: Callable[[], str],
) -> str:
    """Return the sentence on holders that keep the angle of a tab and were tested with these strips."""
    here = PlacedTab.of(member.strip, end, member.frame)
    plates = [
        plate for plate in plates_with_play(holders) if any(tab.key == here.key for tab in tabs_of(plate))
    ]
    ways = [
        two_plates() if len(plates) == 1 else "",
        note("end fixtures") if _blocks_fit(here, placed) else "",
        note("feet ({field} = {size:g}) glued at the angle of the tab", field=FieldName("feet"), size=FEET_MM)
        if _feet_fit(plates)
        else "",
    ]
    if not any(ways):
        return note("Let the strip meet the plate more steeply")
    return note("Use {ways}", ways=sentences([way for way in ways if way], note(", or ")))


def _feet_fit(plates: Sequence[BasePlate]) -> bool:
    try:
        add_feet(plates, FEET_MM)
    except InputError:
        return False
    return bool(plates) and not any(isinstance(plate, Ring) for plate in plates)


def _blocks_fit(tab: PlacedTab, placed: Sequence[Placed]) -> bool:
    """Return True if printed blocks fit at the strip of a tab and at the two strips nearest to it.

    Other strips are not compared, because a block overlaps first with its nearest neighbours.
    """

    def distance(member: Placed) -> float:
        origins = [PlacedTab.of(member.strip, end, member.frame).frame.origin for end in ENDS]
        return min(float(np.linalg.norm(origin - tab.frame.origin)) for origin in origins)

    near = sorted(placed, key=distance)[:3]
    try:
        return not crowded_blocks(end_fixtures(near), near)
    except InputError:
        return False


def _two_plates(placed: Sequence[Placed], holders: Sequence[object]) -> str:
    """Return the suggestion of two plates at the first of several gaps at which no tab rocks, or ""."""
    plates = [plate for plate in plates_with_play(holders) if tabs_of(plate)]
    held = [tab for plate in plates for tab in tabs_of(plate)]
    keys = {tab.key for tab in held}
    if len(keys) < len(held):  # two plates already hold some tabs
        return ""
    ends = {
        PlacedTab.of(member.strip, end, member.frame).key: (member, k)
        for member in placed
        for k, end in enumerate(ENDS)
    }
    mine = [ends[key] for key in keys if key in ends]
    # the suggestion names no width if all tabs have their default width and this width fits
    keep = all(member.strip.ends[k].width is None for member, k in mine)
    longest = max(tab.length for member, _ in mine for tab in member.strip.ends)
    # in the order of preference
    for gap in (GAP_MM, 15.0, 10.0, 6.0):
        needed = (needed_length(tab, plate, gap) for plate in plates for tab in tabs_of(plate))
        sized = fitting_tabs(placed, plates, gap, max(longest, *needed), keep=keep)
        if sized is not None:
            sized_strips, (length, width) = with_tabs(placed, *sized), sized
            pairs = [plate for first in plates for plate in pair_with_tabs(sized_strips, first, gap)]
            if not any(seat.rocks for seat in tab_seats(pairs).values()):
                tab = {"length": length} | ({} if width == np.inf else {"width": width})
                return note(
                    "two plates ({field} = {gap:g}) and tabs {length:g} long"
                    if width == np.inf
                    else "two plates ({field} = {gap:g}) and tabs {length:g} long and {width:.0f} wide",
                    field=FieldName("gap"), gap=gap, length=Length(length), width=Length(width),
                    changes=(Change("two_plates", {"gap": gap, "tab": tab}),),
                )  # fmt: skip
    return ""
