"""Free play of tabs in pockets and slots, and its effect on the shapes of strips."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import is_series
from elastica_cad.errors import Degrees, FieldName, InputError, Length, NotConvergedError, note, quoted
from elastica_cad.model.fixtures import EndFixture, Key, PlacedTab
from elastica_cad.model.plates import BasePlate
from elastica_cad.strip.held_shape import HeldShape
from elastica_cad.strip.outline import ENDS, StripEnd
from elastica_cad.strip.pieces import cut_key
from elastica_cad.strip.strip import Placed, require_placed
from elastica_cad.strip.tab_seats import WALL_PLACES, TabSeat


def _seat_between_walls(walls: FloatArray, tab: PlacedTab, plate: BasePlate) -> TabSeat:
    # use the points of a wall that the tab reaches; if the tab reaches none, use the nearest point
    reached = [places[places[:, 0] <= max(tab.length, places[:, 0].min())] for places in walls]
    left, right = sorted(reached, key=lambda places: -float(places[:, 1].mean()))
    steepness = abs(float(tab.frame.x_axis @ plate.frame.z_axis))
    named = note("slot of {name}", name=plate.name)
    return TabSeat(left, right, tab.thickness, named, cut=steepness, key=FieldName("gap"))


def slot_walls(plate: BasePlate) -> list[tuple[int, PlacedTab, FloatArray]]:
    """Return the index of each slot with a tab, the tab, and the two walls of the slot.

    The walls (2, n, 2) are points in the plane of the strip's curve. Their coordinates are the distances along
    the tab and to its left. Wall 0 is between the corners 0 and 1 of the slot.
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
    # coordinates along the tab, across it, and away from the upper side of the strip
    local = (plate.frame.point(corners) - origins[:, None, None]) @ np.swapaxes(axes, 1, 2)[:, None]
    # each wall is between two corners, and its points are where it crosses the plane of the curve (y = 0)
    begin, finish = local[:, [0, 3]], local[:, [1, 2]]
    u = begin[..., 1] / (begin[..., 1] - finish[..., 1])
    met = begin + u[..., None] * (finish - begin)
    # the z axis of the tab points away from the upper side of the strip, to the right of the curve
    return [(*which, wall) for which, wall in zip(through, met[..., [0, 2]] * (1.0, -1.0), strict=True)]


def tab_seats(holders: Iterable[object]) -> dict[Key, TabSeat]:
    """Return the seat of each tab that is not glued, by the `key` of the tab.

    If two plates hold a tab, their slots form a single seat.
    """
    holders, seats = require_holders(holders), dict[Key, TabSeat]()
    seated = [(holder.tab, holder.seat) for holder in holders if isinstance(holder, EndFixture)]
    for plate in plates_with_play(holders):
        seated += [(tab, _seat_between_walls(walls, tab, plate)) for _, tab, walls in slot_walls(plate)]
    for tab, seat in seated:
        before = seats.get(tab.key)
        if before is not None:
            left, right = np.concatenate([before.left, seat.left]), np.concatenate([before.right, seat.right])
            both = note("{one} and {other}", one=before.name, other=seat.name.split()[-1])
            # two slots at a distance limit the angle of the tab by their clearance
            seats[tab.key] = replace(seat, left=left, right=right, name=both, key=FieldName("clearance"))
        else:
            seats[tab.key] = seat
    return seats


def require_holders(holders: object) -> tuple[object, ...]:
    """Return the holders as a tuple, or raise InputError if they are not iterable."""
    if not is_series(holders):
        raise InputError(
            f"holders are {quoted(holders)}: give a list of base plates, rings, frames and fixtures"
        )
    return tuple(holders)


def plates_with_play(holders: Iterable[object]) -> Iterator[BasePlate]:
    """Yield plates, and rails of frames, in which tabs can move because they are not glued."""
    for holder in holders:
        # recognise frames by their `rails`, because the module of frames imports this module
        for plate in getattr(holder, "rails", (holder,)):
            if isinstance(plate, BasePlate) and not plate.glued:
                yield plate


def held_shapes(placed: Sequence[Placed], holders: Iterable[object] = ()) -> tuple[HeldShape, ...]:
    """Return the shape of each strip as cut, with its tabs in the holders.

    Ends without a holder have their designed position and direction.

    Raises
    ------
    NotConvergedError
        A strip has no equilibrium.
    """
    shapes = []
    for shape in hold_each(placed, holders):
        if isinstance(shape, NotConvergedError):
            raise shape
        shapes.append(shape)
    return tuple(shapes)


def hold_each(
    placed: Sequence[Placed], holders: Iterable[object] = ()
) -> Iterator[HeldShape | NotConvergedError]:
    """Yield the held shape of each strip, or the error if the strip has no equilibrium.

    Strips with equal cuts in equal seats are computed once.
    """
    placed = require_placed(placed)
    seats, known = tab_seats(holders), dict[object, HeldShape | NotConvergedError]()
    for member in placed:
        start, end = (seat_of(seats, member, k) for k in ENDS)
        alike = cut_key(member.strip), *(None if seat is None else seat.places for seat in (start, end))
        if alike not in known:
            try:
                known[alike] = member.strip.held(start, end)
            except NotConvergedError as problem:
                known[alike] = problem
        yield known[alike]


def seat_of(seats: Mapping[Key, TabSeat], member: Placed, end: StripEnd) -> TabSeat | None:
    """Return the seat of an end of a placed strip, or None if the end has no holder."""
    return seats.get(PlacedTab.of(member.strip, end, member.frame).key)


NO_PLAY_MM, NO_PLAY_DEGREES = 1e-3, 1e-2
"""Shift (mm) and rotation (degrees) of a tab below which no play is reported."""


def holder_plays(placed: Sequence[Placed], holders: Iterable[object]) -> tuple[str, ...]:
    """Return a sentence for each holder in which tabs can shift or rotate."""
    messages = []
    for name, held in seats_by_holder(require_placed(placed), holders).items():
        turn = max(np.degrees(np.ptp(seat.turning)) for _, _, seat in held)
        shift = max(seat.room for _, _, seat in held)
        if shift >= NO_PLAY_MM or turn >= NO_PLAY_DEGREES:
            messages.append(note(
                "In the {name}, a tab can tip within a range of {turn:.2g}" if shift < NO_PLAY_MM else
                "In the {name}, a tab can shift by {across:.2g}" if turn < NO_PLAY_DEGREES else
                "In the {name}, a tab can shift by {across:.2g} and tip within a range of {turn:.2g}",
                name=name, across=Length(shift), turn=Degrees(turn),
            ))  # fmt: skip
    return tuple(messages)


def seats_by_holder(
    placed: Sequence[Placed], holders: Iterable[object]
) -> dict[str, list[tuple[Placed, StripEnd, TabSeat]]]:
    """Return the held strips, with the held end and its seat, by the name of the holder."""
    seats, groups = tab_seats(holders), dict[str, list[tuple[Placed, StripEnd, TabSeat]]]()
    for strip in placed:
        for end in ENDS:
            seat = seat_of(seats, strip, end)
            if seat is not None:
                groups.setdefault(seat.name, []).append((strip, end, seat))
    return groups
