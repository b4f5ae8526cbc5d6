"""What holders leave free: the seats of tabs, strips' shapes in them, their play, and tabs that rock."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TypeGuard

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import and_more, is_series
from elastica_cad.errors import InputError, NotConvergedError, quoted
from elastica_cad.model.fixtures import EndFixture, Key, PlacedTab
from elastica_cad.model.plates import GAP_MM, BasePlate, Ring, needed_length
from elastica_cad.refusals import FieldName, Length, note
from elastica_cad.strip.held_shape import HeldShape
from elastica_cad.strip.outline import ENDS, StripEnd
from elastica_cad.strip.pieces import cut_key
from elastica_cad.strip.strip import Placed, distinct_names, require_placed
from elastica_cad.strip.tab_seats import WALL_PLACES, TabSeat


def _seat_between(walls: FloatArray, tab: PlacedTab, plate: BasePlate) -> TabSeat:
    """The walls (2, n, 2) of a slot beside its tab, in the plane of the strip's curve."""
    # of a wall that begins beyond the tab's tip its edge counts
    reached = [places[places[:, 0] <= max(tab.length, places[:, 0].min())] for places in walls]
    left, right = sorted(reached, key=lambda places: -float(places[:, 1].mean()))
    return TabSeat(left, right, tab.thickness, note("slot of {name}", name=plate.name))


def slot_walls(plate: BasePlate) -> list[tuple[int, PlacedTab, FloatArray]]:
    """Return for each slot with a tab its number among the plate's slots, the tab, and its walls, the first
    corners' first.

    Walls are places (2, n, 2) into the tab and to its left, where lines down them meet the plane of the curve.
    """
    through = [(k, slot.tab) for k, slot in enumerate(plate.slots) if slot.tab is not None]
    if not through:
        return []
    depths = np.linspace(0.0, -plate.sheet.thickness, WALL_PLACES)
    corners = np.empty((len(through), 4, depths.size, 3))
    corners[..., :2] = np.array([plate.slots[k].corners for k, _ in through])[:, :, None]
    corners[..., 2] = depths
    frames = [tab.frame for _, tab in through]
    origins, axes = np.array([frame.origin for frame in frames]), np.array([frame.axes for frame in frames])
    # along the tab, across it and off the strip's upper side
    local = (plate.frame.point(corners) - origins[:, None, None]) @ np.swapaxes(axes, 1, 2)[:, None]
    begin, finish = local[:, [0, 3]], local[:, [1, 2]]
    u = begin[..., 1] / (begin[..., 1] - finish[..., 1])
    met = begin + u[..., None] * (finish - begin)
    # the tab's z axis is off the strip's upper side, which lies to the right of the curve
    walls = met[..., [0, 2]] * (1.0, -1.0)
    return [(*which, own) for which, own in zip(through, walls, strict=True)]


def tab_seats(holders: Iterable[object]) -> dict[Key, TabSeat]:
    """The seats of all tabs that holders hold with play, by where the tab is; two plates make one seat."""
    found: dict[Key, TabSeat] = {}
    for tab, seat in _seated(holders):
        before = found.get(tab.key)
        if before is not None:
            left, right = np.concatenate([before.left, seat.left]), np.concatenate([before.right, seat.right])
            both = note("{one} and {other}", one=before.name, other=seat.name.split()[-1])
            found[tab.key] = TabSeat(left, right, seat.thickness, both)
        else:
            found[tab.key] = seat
    return found


def _seated(holders: Iterable[object]) -> Iterator[tuple[PlacedTab, TabSeat]]:
    holders = _require_holders(holders)
    for holder in holders:
        if isinstance(holder, EndFixture):
            yield holder.tab, holder.seat
    for plate in _plates_of(holders):
        for _, tab, walls in slot_walls(plate):
            yield tab, _seat_between(walls, tab, plate)


def _require_holders(holders: object) -> tuple[object, ...]:
    """Holders as a tuple; refuses what cannot be gone through."""
    if not is_series(holders):
        raise InputError(
            f"holders are {quoted(holders)}: give a list of base plates, rings, frames and fixtures"
        )
    return tuple(holders)


def _plates_of(holders: Iterable[object]) -> Iterator[BasePlate]:
    """The plates among holders whose slots leave tabs their play: of frames too, none whose tabs are glued."""
    for holder in holders:
        # a slotted frame is told by its rails: it is made by means of this module
        for plate in getattr(holder, "rails", (holder,)):
            if isinstance(plate, BasePlate) and not plate.glued:
                yield plate


def held_shapes(placed: Sequence[Placed], holders: Iterable[object] = ()) -> tuple[HeldShape, ...]:
    """The shape of each strip as it is made and held; ends without a holder are held as designed.

    Raises
    ------
    NotConvergedError
        A strip finds no rest.
    """
    found = []
    for shape in hold_each(placed, holders):
        if isinstance(shape, NotConvergedError):
            raise shape
        found.append(shape)
    return tuple(found)


def hold_each(
    placed: Sequence[Placed], holders: Iterable[object] = ()
) -> Iterator[HeldShape | NotConvergedError]:
    """Hold the strips one by one, with the reason where a strip finds no rest; strips held alike are bent once."""
    placed = require_placed(placed)
    seats, known = tab_seats(holders), dict[object, HeldShape | NotConvergedError]()
    for one in placed:
        start, end = (_seat_of(seats, one, k) for k in ENDS)
        alike = cut_key(one.strip), *(None if seat is None else seat.places for seat in (start, end))
        if alike not in known:
            try:
                known[alike] = one.strip.held(start, end)
            except NotConvergedError as problem:
                known[alike] = problem
        yield known[alike]


def _seat_of(seats: Mapping[Key, TabSeat], one: Placed, end: StripEnd) -> TabSeat | None:
    """Seat of an end of a placed strip; None where nothing holds it."""
    return seats.get(PlacedTab.of(one.strip, end, one.frame).key)


ROCKING_RAD = np.radians(3.0)
"""A tab that can turn farther than this in its holder is reported as rocking; it moves the shape by percents."""

NO_PLAY_MM, NO_PLAY_DEGREES = 1e-3, 1e-2
"""Largest play that is reported as none."""


def holder_plays(placed: Sequence[Placed], holders: Iterable[object]) -> tuple[str, ...]:
    """A sentence for every holder: how far its tabs shift across and turn in it at most, before they jam."""
    placed, holders, told = require_placed(placed), _require_holders(holders), []
    for name, held in _by_holder(placed, holders).items():
        turn = max(np.degrees(np.ptp(seat.turning)) for _, _, seat in held)
        room = max(seat.room for _, _, seat in held)
        if room < NO_PLAY_MM and turn < NO_PLAY_DEGREES:
            told.append(
                note("{name} leaves its tabs no play: they bend a little between its edges", name=name)
            )
        else:
            across = 0.0 if room < NO_PLAY_MM else room
            told.append(note(
                "{name} leaves its tabs {across:.2g} across and {turn:.2g} degrees to turn",
                name=name, across=Length(across), turn=turn,
            ))  # fmt: skip
    glued = (one for one in holders if (isinstance(one, BasePlate) and one.glued) or _lies_on(one))
    return (
        *told,
        *(
            note("{name} leaves its tabs no play: they are glued at their angle", name=one.name)
            for one in glued
        ),
    )


def _lies_on(holder: object) -> TypeGuard[Ring]:
    """Whether this is a ring on which tabs lie."""
    return isinstance(holder, Ring) and bool(holder.seats)


def rocking_tabs(placed: Sequence[Placed], holders: Iterable[object]) -> tuple[str, ...]:
    """A sentence for every holder in which tabs rock: the one that rocks most, its shape, and a cure."""
    placed, holders, told = require_placed(placed), _require_holders(holders), []
    names = dict(zip(map(id, placed), distinct_names(placed), strict=True))
    for holder, held in _by_holder(placed, holders).items():
        rocking = [one for one in held if np.ptp(one[2].turning) > 2 * ROCKING_RAD]
        if rocking:
            one, end, seat = max(rocking, key=lambda row: float(np.ptp(row[2].turning)))
            toward, away = _tipping(one, end, seat)
            told.append(note(
                "{strip}{more}: in the {holder} its {end} can tip {toward:.0f} degrees towards the other end and "
                "{away:.0f} away from it, and does not hold the drawn angle; {shape}; {cure}",
                strip=names[id(one)], more=and_more(rocking), holder=holder, end=end, toward=toward, away=away,
                shape=_shape(one, tab_seats(holders)), cure=_cure(one, end, holders), severity="warning",
            ))  # fmt: skip
    return tuple(told)


def _tipping(one: Placed, end: StripEnd, seat: TabSeat) -> tuple[float, float]:
    """How far, in degrees, a strip can tip in a seat towards its other end and away from it."""
    own, other = (PlacedTab.of(one.strip, k, one.frame).frame for k in sorted(ENDS, key=lambda k: k != end))
    right, left = np.abs(np.degrees(seat.turning))
    # where the tab turns to the left of the curve, the strip before it turns to the right, which is its z axis
    lies_right = (other.origin - own.origin) @ own.z_axis > 0
    return (left, right) if lies_right else (right, left)


def _by_holder(
    placed: Sequence[Placed], holders: Iterable[object]
) -> dict[str, list[tuple[Placed, StripEnd, TabSeat]]]:
    """Strips, ends and seats by what holds them."""
    seats, found = tab_seats(holders), dict[str, list[tuple[Placed, StripEnd, TabSeat]]]()
    for one in placed:
        for end in ENDS:
            seat = _seat_of(seats, one, end)
            if seat is not None:
                found.setdefault(seat.name, []).append((one, end, seat))
    return found


def _shape(one: Placed, seats: dict[tuple[float, ...], TabSeat]) -> str:
    """Sentence about a strip in its seats."""
    try:
        strayed = one.strip.held(*(_seat_of(seats, one, end) for end in ENDS)).deviation
    except NotConvergedError:
        return note("the strip finds no rest in it")
    return note(
        "the strip strays {far:.2g} so, {percent:.2g} % of its length",
        far=Length(strayed),
        percent=100 * strayed / one.strip.rod.length,
    )


def _cure(one: Placed, end: StripEnd, holders: Sequence[object]) -> str:
    """Suggest what would hold a tab: two plates instead of one, or another fixture."""
    key = PlacedTab.of(one.strip, end, one.frame).key
    others = note("end fixtures or feet ({field} = 10) glued at its angle", field=FieldName("feet"))
    lengths = [
        needed_length(slot.tab, plate, GAP_MM)
        for plate in _plates_of(holders)
        for slot in plate.slots
        if slot.tab is not None and slot.tab.key == key
    ]
    if len(lengths) != 1:
        return note("use {others}", others=others)
    long = max(*lengths, *(tab.length for tab in one.strip.ends))
    return note(
        "use two plates ({field} = {gap:g}) and tabs of {length:.0f}, or {others}",
        field=FieldName("gap"), gap=GAP_MM, length=Length(long), others=others,
    )  # fmt: skip
