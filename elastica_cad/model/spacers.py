"""Spacers between the two plates of a pair: small plates on edge, whose tongues are in slots of both plates."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Annotated, TypeAlias

import numpy as np

from elastica_cad._types import BoolArray, FloatArray
from elastica_cad._values import several
from elastica_cad.declared import Option, require_declared
from elastica_cad.errors import FieldName, InputError, Length, note
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.path import Path
from elastica_cad.geometry.plane_points import box_about, left_of, near_pairs, norm, unit, unit_vectors
from elastica_cad.model.frames import Rib
from elastica_cad.model.plates import (
    PITCH_MM,
    BasePlate,
    Plate,
    TabSlot,
    around,
    dense_points,
    options_of,
    plate_with,
    rectangle_about,
    tabs_of,
)
from elastica_cad.strip.lettering import centred_text
from elastica_cad.strip.strip import Placed, require_placed
from elastica_cad.strip.uncuttable_parts import limits_or_default

_COUNT = Option("Number of spacers that keep two plates at their distance.", least=2, most=50, needs="gap")

Spacers: TypeAlias = Annotated[int | None, _COUNT]
"""Number of spacers of each pair of plates, or None."""

BESIDE_MM = 1.0
"""Least distance, mm, of a spacer from strips and tabs between the plates, and from edges and openings."""

GRID_RADIUS_MM, GRID_TURN = 1.0, np.radians(2.0)
"""Radial distance, mm, and angle, rad, between places that are tried for a spacer in a round plate."""

MOST_MARGIN_MM = 5.0
"""Distance, mm, from obstacles above which all places for spacers are equally good."""

DIRECTIONS = np.linspace(0.0, 2 * np.pi, 36, endpoint=False)
"""Angles, rad, of the directions in which a plate may tilt over its spacers."""

LEAST_SPREAD = 0.25
"""Least spread of spacers: their distance from the middle of the tabs, as a fraction of that of the slots.

Both distances are measured in the direction in which they are shortest. Three spacers at equal angles on the
circle of the slots have about 0.5. If there are two spacers, or if a spacer is wider than the distance of the
slots, the distance of the spacers is divided by the width of a spacer instead.
"""


class Spacer(Rib):
    """Plate between two plates that hold the same tabs. Its y axis is the z axis of these plates."""


def spacer_name(first: BasePlate) -> str:
    """Return the name of the spacers of two plates, from the name of the plate nearer to the strips."""
    return f"{first.name}-spacer"


def pairs_of_plates(plates: Sequence[BasePlate]) -> Iterator[tuple[BasePlate, BasePlate, float]]:
    """Yield the two plates that hold the same tabs, the plate nearer to the strips first, and their gap, mm."""
    for i, first in enumerate(plates):
        keys = {tab.key for tab in tabs_of(first)}
        for second in plates[i + 1 :]:
            distance = float((first.frame.origin - second.frame.origin) @ first.frame.z_axis)
            if not keys.isdisjoint(tab.key for tab in tabs_of(second)) and distance > first.sheet.thickness:
                yield first, second, distance - first.sheet.thickness


def add_spacers(
    placed: Sequence[Placed], plates: Sequence[Plate], count: Annotated[int, _COUNT]
) -> tuple[tuple[Plate, ...], tuple[Spacer, ...]]:
    """Return the plates with slots for spacers, and the spacers between the two plates of each pair.

    A spacer is perpendicular to its plates and as high as their gap. Its tongues end at the outer faces of the
    plates. Spacers are spread around the middle of the tabs, clear of strips, tabs, holes and edges. Round plates
    become as wide as their spacers need: inwards if their openings remain large enough, else outwards.

    Parameters
    ----------
    placed : sequence of Placed
        Strips that the plates hold.
    plates : sequence of BasePlate
        Plates from `plate_pair`, `ring_pair`, or `end_plates` with a gap.
    count : int
        Number of spacers of each pair.

    Examples
    --------
    >>> from elastica_cad.strip.strip_spec import make_strip
    >>> from elastica_cad.geometry.plane_curve import PlaneCurve
    >>> from elastica_cad.model.plate_pairs import plate_pair
    >>> from elastica_cad.strip.outline import Tab
    >>> arc = PlaneCurve.arc((0, 0), 60, 3.1, 0.04)
    >>> arch = make_strip(arc, "birch-plywood-0.8", max_width=20, ends=(Tab(20), Tab(20)))
    >>> arches = [Placed(arch, (0, y, 0), (1, 0, 0), (0, 0, 1)) for y in (0, 40, 80)]
    >>> plates, spacers = add_spacers(arches, plate_pair(arches, "mdf-3", gap=10), 3)
    >>> [spacer.name for spacer in spacers]
    ['base-spacer', 'base-spacer', 'base-spacer']
    """
    placed, plates = require_placed(placed), several("plates", plates, BasePlate, "BasePlate")
    require_declared(add_spacers, {"count": count}, "spacers")
    slotted, spacers = {id(plate): plate for plate in plates}, list[Spacer]()
    for first, second, gap in pairs_of_plates(plates):
        sized, width, places, spread = _places(placed, (first, second), gap, count)
        sheet, options = first.sheet, options_of(first)
        size = np.array([width / 2 + 2 * options.play, sheet.thickness + options.clearance])
        slots = tuple(TabSlot(_rectangle(place, size), "spacer", sheet.thickness) for place in places)
        bodies = [_rectangle(place, np.array([width, sheet.thickness])) for place in places]
        slotted |= {
            id(plate): _with_slots(plate, tried, slots, bodies)
            for plate, tried in zip((first, second), sized, strict=True)
        }
        spacers += [_spacer((first, second), gap, width, place).checked(options) for place in places]
        if spread < LEAST_SPREAD:
            text = _near_a_line(placed, (first, second), gap, count)
            slotted[id(first)] = replace(slotted[id(first)], warnings=(*slotted[id(first)].warnings, text))
    if not spacers:
        raise InputError(
            "{spacers} needs two plates that hold the same tabs. Set {gap}, the distance between them.",
            spacers=FieldName("spacers"), gap=FieldName("gap"),
        )  # fmt: skip
    return tuple(slotted.values()), tuple(spacers)


def _with_slots(
    plate: Plate, tried: BasePlate, slots: tuple[TabSlot, ...], bodies: Sequence[FloatArray]
) -> Plate:
    """Return the plate with slots for spacers. A round plate is made wide enough for slots and bodies.

    Its opening is at least as large as in `tried`, the plate for which the places of the spacers were found.
    """
    options = options_of(plate)
    if plate.is_round:
        center = plate.outline.bounds.mean(axis=0)
        inner, outer = np.transpose([
            _radii(plate),
            around([slot.corners for slot in slots], center, _bridge(plate) + PITCH_MM / 2),
            around(bodies, center, BESIDE_MM),
        ])  # fmt: skip
        plate = plate.resized(max(float(inner.min()), tried.opening_radius), float(outer.max()))
    checked = replace(plate, slots=(*plate.slots, *slots)).checked(options)
    return replace(checked, warnings=tuple(dict.fromkeys((*plate.warnings, *checked.warnings))))


def _rectangle(place: FloatArray, size: FloatArray) -> FloatArray:
    return rectangle_about(place[:2], unit_vectors(place[2]), size)


def _spacer(plates: tuple[BasePlate, BasePlate], gap: float, width: float, place: FloatArray) -> Spacer:
    """Return a spacer with two tongues, at x, y and angle (rad) in the frame of the first plate."""
    first, second = plates
    middle = first.frame.shifted(z=-first.sheet.thickness - gap / 2)
    frame = Frame(middle.point(place[:2]), middle.direction(unit_vectors(place[2])), middle.z_axis)
    half, tongue, body = width / 2, width / 4, gap / 2
    low, high = body + second.sheet.thickness, body + first.sheet.thickness
    corners = [
        (-half, -body), (-tongue, -body), (-tongue, -low), (tongue, -low), (tongue, -body), (half, -body),
        (half, body), (tongue, body), (tongue, high), (-tongue, high), (-tongue, body), (-half, body),
    ]  # fmt: skip
    label = centred_text("spacer", (0.0, 0.0), min(4.0, 0.4 * gap), 0.8 * width)
    return Spacer(spacer_name(first), first.sheet, frame, Path.polygon(np.array(corners)), label)


def _places(
    placed: Sequence[Placed], plates: tuple[BasePlate, BasePlate], gap: float, count: int
) -> tuple[tuple[BasePlate, BasePlate], float, FloatArray, float]:
    """Return two plates, and the width, mm, the places (count, 3) and the spread of spacers between them.

    A place is x, y and angle. The spread is the extent of the spacers around the middle of the tabs; see
    `LEAST_SPREAD`. The first places that are spread enough are returned or, if there are none, the most spread.
    """
    most, best, sheet, bridge = 0, None, plates[0].sheet, _bridge(plates[0])
    for tried in _sizes(plates):
        for width, places, margin in _free_places(placed, tried, gap):
            # at this distance, mm, two spacers do not meet at any angle
            apart = 2 * float(norm(np.array([width, sheet.thickness]) / 2 + bridge))
            thinned = _thinned(places, margin, apart)
            most = max(most, len(thinned))
            if len(thinned) >= count:
                # each spacer is as far as possible from the spacers before it; the first is farthest from all
                distances = np.linalg.norm(places[thinned, None, :2] - places[thinned, :2], axis=-1)
                ranks = [int(distances.sum(axis=1).argmax())]
                while len(ranks) < count:
                    ranks.append(int(distances[:, ranks].min(axis=1).argmax()))
                chosen = [thinned[k] for k in ranks]
                # places to which the spacers may still be moved
                free = places[margin >= margin[chosen].min() / 2]
                moved, spread = _spread(free, places[chosen], apart, width, plates)
                if best is None or spread > best[-1]:
                    best = tried, width, moved, spread
                if spread >= LEAST_SPREAD:
                    return best
    if best is not None:
        return best
    raise InputError(
        "{name}: there is room for {most} spacers between the two plates, not for {count}. Use fewer spacers."
        if plates[0].is_round
        else "{name}: there is room for {most} spacers between the two plates, not for {count}. Use fewer spacers, "
        "or a {border} of more than {wide:.0f}.",
        name=plates[0].name, most=most, count=count, border=FieldName("border"),
        wide=Length(_wide_border(plates)),
    )  # fmt: skip


def _wide_border(plates: tuple[BasePlate, BasePlate]) -> float:
    slots = [plate.tab_loops for plate in plates]
    # largest distance between the two slots of a tab, in the plane of the plates
    offset = float(norm(np.diff(slots, axis=0)[0].mean(axis=1)).max())
    return max(options_of(plates[0]).border, _border_with_spacers(plates[0]) + float(np.ceil(offset)))


def _near_a_line(
    placed: Sequence[Placed], plates: tuple[BasePlate, BasePlate], gap: float, count: int
) -> str:
    """Return the note that the plates can tilt, with a border that was tried and prevents this."""
    name, wide = plates[0].name, _wide_border(plates)
    first, second = (
        plate_with(
            plate.slots, plate.sheet, plate.frame,
            replace(options_of(plate), border=wide), type(plate),
        )
        for plate in plates
    )  # fmt: skip
    *_, spread = _places(placed, (first, second), gap, count)
    return note(
        "{name}: the spacers are almost in a line, so the plates can tilt. Use a {border} of {wide:.0f}."
        if spread >= LEAST_SPREAD
        else "{name}: the spacers are almost in a line, so the plates can tilt. Check that the plates are "
             "parallel.",
        name=name, border=FieldName("border"), wide=Length(wide),
    )  # fmt: skip


def _sizes(plates: tuple[BasePlate, BasePlate]) -> Iterator[tuple[BasePlate, BasePlate]]:
    """Yield the plates as they are. If they are round, then yield them with room for spacers.

    The room is inside the slots, outside the slots, or both. Sizes that close the openings, or reduce them
    too much, are the last.
    """
    yield plates
    first, second = plates
    if not (first.is_round and second.is_round):
        return
    # rows are the plates, and columns the radii of opening and rim
    radii = np.array([_radii(plate) for plate in plates])
    room = _border_with_spacers(first) + GRID_RADIUS_MM - options_of(first).border
    inner, outer = float(radii[:, 0].min()) - room, float(radii[:, 1].max()) + room
    inside, outside = np.minimum(radii, [inner, np.inf]), np.maximum(radii, [-np.inf, outer])
    narrow = first.resized(*inside[0]), second.resized(*inside[1])
    wide = first.resized(*outside[0]), second.resized(*outside[1])
    # spacers inside the slots must leave at least half the radius of an opening
    kept = all(
        plate.opening_radius >= 0.5 * given.opening_radius > 0
        for plate, given in zip(narrow, plates, strict=True)
    )
    yield from (narrow, wide) if kept else (wide, narrow)
    yield first.resized(inside[0, 0], outside[0, 1]), second.resized(inside[1, 0], outside[1, 1])


def _radii(plate: BasePlate) -> tuple[float, float]:
    # radii, mm, of opening and rim that keep the border from the slots for tabs
    return around(plate.tab_loops, plate.outline.bounds.mean(axis=0), options_of(plate).border)


def _free_places(
    placed: Sequence[Placed], plates: tuple[BasePlate, BasePlate], gap: float
) -> Iterator[tuple[float, FloatArray, FloatArray]]:
    """For each width, mm, from wide to narrow, yield the width, the free places (n, 3) and their margins (n,), mm.

    A place is x, y and angle.
    """
    thickness, bridge = plates[0].sheet.thickness, _bridge(plates[0])
    closed, cuts, bodies = _obstacles(placed, plates, gap)
    tried = _tried_places(plates[0])
    inside = np.logical_and.reduce(
        [_enclosed(plate.outline.points(PITCH_MM / 10), tried) for plate in plates]
    )
    tried = tried[inside & ~np.logical_or.reduce([_enclosed(loop, tried) for loop in closed])]
    # leave out places that are too close to a cut for any tongue
    near, _ = near_pairs(tried[:, :2], cuts, bridge + thickness / 2)
    tried = np.delete(tried, near, axis=0)
    # a tongue has half the width of its spacer and keeps a bridge from all cuts
    # a body keeps a smaller distance from cuts, strips and tabs
    for width in (24.0, 18.0, 12.0):
        body = np.array([width, thickness]) / 2
        margin = np.minimum(
            _margins(tried, cuts, np.array([width / 4, body[1]]) + bridge + PITCH_MM / 2),
            _margins(tried, np.concatenate([cuts, bodies]), body + BESIDE_MM),
        )
        yield width, tried[margin > 0], margin[margin > 0]


def _bridge(plate: BasePlate) -> float:
    return limits_or_default(options_of(plate).shop).bridge_for(plate.sheet)


def _border_with_spacers(plate: BasePlate) -> float:
    # 2 mm are for clearance, and because a round rim recedes beside a spacer
    return float(np.ceil(2 * _bridge(plate) + plate.sheet.thickness + 2.0))


def _tried_places(plate: BasePlate) -> FloatArray:
    """Return the tried places (n, 3) of spacers: x and y in the plate, mm, and the angle to the x axis, rad.

    Spacers are radial or tangential in a round plate, and parallel to the x or y axis in other plates.
    """
    low, high = plate.outline.bounds
    if plate.is_round:
        r, turn = (
            np.ravel(grid)
            for grid in np.meshgrid(
                np.arange(GRID_RADIUS_MM, (high - low)[0] / 2, GRID_RADIUS_MM),
                np.arange(0.0, 2 * np.pi, GRID_TURN),
            )
        )
        x, y = (low + high)[:, None] / 2 + r * unit_vectors(turn).T
    else:
        # places are at least 2 mm apart, at most 60 across the plate
        step = max(2.0, float((high - low).max()) / 60)
        x, y = (
            np.ravel(grid)
            for grid in np.meshgrid(*(np.arange(*ends, step) for ends in zip(low, high, strict=True)))
        )
        turn = np.zeros(x.size)
    return np.concatenate([np.column_stack([x, y, turn + more]) for more in (0.0, np.pi / 2)])


def _obstacles(
    placed: Sequence[Placed], plates: tuple[BasePlate, BasePlate], gap: float
) -> tuple[list[FloatArray], FloatArray, FloatArray]:
    """Return loops in which no spacer may be, points (n, 2) on cuts, and points (m, 2) of strips and tabs.

    The strips and tabs are those in the gap between the plates.
    """
    first, second = plates
    loops = [loop.points(PITCH_MM / 10) for plate in plates for loop in plate._inner_loops]
    tabs = []
    places = {slot.tab.key: slot.corners for slot in second.slots if slot.tab is not None}
    for slot in first.slots:
        if slot.tab is not None and slot.tab.key in places:
            # rectangle around both slots of the tab, which passes from one slot to the other
            u = unit(slot.corners[1] - slot.corners[0])
            axes = np.array([u, left_of(u)])
            low, high = box_about(np.concatenate([slot.corners, places[slot.tab.key]]) @ axes.T)
            tabs.append(rectangle_about((low + high) / 2 @ axes, u, high - low))
    edges = [dense_points(plate.outline.points(PITCH_MM / 10)) for plate in plates]
    cuts = np.concatenate([*edges, *map(dense_points, loops)])
    between = [dense_points(tab) for tab in tabs]
    for member in placed:
        rod = member.strip.rod
        across = np.linspace(-0.5, 0.5, 9)[:, None, None] * member.strip.width(rod.s)[:, None]
        points = first.frame.local(
            (member.frame.point(rod.position) + across * member.frame.z_axis).reshape(-1, 3)
        )
        depth = -points[:, 2] - first.sheet.thickness
        between.append(points[(depth > 0) & (depth < gap), :2])
    return [*loops, *tabs], cuts, np.concatenate(between)


def _enclosed(loop: FloatArray, places: FloatArray) -> BoolArray:
    # True for places (n,) inside the loop: a ray along x crosses an odd number of its sides
    inside = np.zeros(len(places), dtype=bool)
    for (x0, y0), (x1, y1) in zip(loop, np.roll(loop, -1, axis=0), strict=True):
        rises = (y0 > places[:, 1]) != (y1 > places[:, 1])
        inside ^= rises & (places[:, 0] < x0 + (places[:, 1] - y0) * (x1 - x0) / ((y1 - y0) or 1.0))
    return inside


def _margins(places: FloatArray, points: FloatArray, half: FloatArray) -> FloatArray:
    """Return the distance (n,), mm, from a rectangle at each place (x, y and angle) to the nearest point.

    `half` (2,) are half the sides of the rectangle. The distance is the larger of those along the two sides, so
    the true distance from a corner is larger. It is negative if a point is inside the rectangle, and at most
    `MOST_MARGIN_MM`.
    """
    margin = np.full(len(places), MOST_MARGIN_MM)
    i, k = near_pairs(places[:, :2], points, float(norm(half + MOST_MARGIN_MM)))
    away, (c, s) = points[k] - places[i, :2], (np.cos(places[i, 2]), np.sin(places[i, 2]))
    local = np.column_stack([c * away[:, 0] + s * away[:, 1], c * away[:, 1] - s * away[:, 0]])
    np.minimum.at(margin, i, (np.abs(local) - half).max(axis=1))
    return margin


def _thinned(places: FloatArray, margin: FloatArray, apart: float) -> list[int]:
    """Return indices of places at least `apart` mm apart. Large margins are preferred, then outer places."""
    radius = norm(places[:, :2] - places[:, :2].mean(axis=0)) if len(places) else margin
    rest = np.lexsort((-radius, -margin.round(1)))
    kept = list[int]()
    while len(rest):
        kept.append(int(rest[0]))
        rest = rest[norm((places[rest] - places[rest[0]])[:, :2]) >= apart]
    return kept


def _spread(
    free: FloatArray, chosen: FloatArray, apart: float, width: float, plates: tuple[BasePlate, BasePlate]
) -> tuple[FloatArray, float]:
    """Return the chosen places, moved apart around the middle of the tabs, and their relative extent.

    The extent of points is their least reach from the middle in any direction. The extent is negative if the
    middle is not between the points. It is divided by the extent of the slots or, if larger, by `width`. Two
    spacers support the plates only by their width, and more spacers by their positions.
    """
    slots = [loop for plate in plates for loop in plate.tab_loops]
    middle, count = np.mean(slots, axis=(0, 1)), len(chosen)
    towards = unit_vectors(DIRECTIONS).T

    def reach(places: FloatArray) -> FloatArray:
        # distances (n, k), mm, to which spacers extend from the middle in each of `DIRECTIONS`
        half = width / 2 if count == 2 else 0.0
        across = half * np.abs(np.cos(places[:, 2:] - DIRECTIONS))
        return np.asarray((places[:, :2] - middle) @ towards + across, dtype=float)

    reaches = reach(free)
    # usually, five rounds suffice
    for _ in range(20):
        before, chosen = chosen, chosen.copy()
        for k in range(count):
            others = np.delete(chosen, k, axis=0)
            # for each free place: distance from the nearest other spacer, and extent together with the others
            least = np.linalg.norm(free[:, None, :2] - others[:, :2], axis=-1).min(axis=1)
            extent = np.maximum(reaches, reach(others).max(axis=0)).min(axis=1)
            chosen[k] = free[np.where(least >= apart, extent + least, -np.inf).argmax()]
        if np.array_equal(before, chosen):
            break
    extent = 0.0 if count == 2 else ((np.concatenate(slots) - middle) @ towards).max(axis=0).min()
    return chosen, float(reach(chosen).max(axis=0).min() / max(extent, width))
