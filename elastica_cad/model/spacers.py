"""Spacers between the two plates of a pair: small plates on edge, whose tongues are in slots of both plates."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Annotated, TypeAlias, TypeVar

import numpy as np

from elastica_cad._types import BoolArray, FloatArray
from elastica_cad._values import several
from elastica_cad.declared import Option, require_declared
from elastica_cad.errors import InputError
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.path import Path
from elastica_cad.geometry.plane_points import near_pairs
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.model.frames import Rib
from elastica_cad.model.plates import (
    LEAST_OPENING_MM,
    PITCH_MM,
    BasePlate,
    PlateOptions,
    TabSlot,
    around,
    dense_points,
)
from elastica_cad.refusals import FieldName, Length
from elastica_cad.strip.lettering import centred_text
from elastica_cad.strip.strip import Placed, require_placed
from elastica_cad.strip.uncuttable_parts import FabricationLimits, limits_or_default

_COUNT = Option("Number of spacers that keep two plates at their distance.", least=2, most=50)

Spacers: TypeAlias = Annotated[int | None, _COUNT]
"""Number of spacers of each pair of plates, or None."""

WIDTHS_MM = (24.0, 18.0, 12.0)
"""Widths of spacers, mm, in the order in which they are tried. A tongue has half the width of its spacer."""

BESIDE_MM = 1.0
"""Least distance, mm, of a spacer from strips and tabs between the plates, and from edges and openings."""

KEPT_OPENING = 0.5
"""Spacers are first tried inside the slots if the opening then keeps at least this fraction of its radius."""

GRID_MM, GRID_LINES = 2.0, 60
"""Least distance, mm, between places that are tried for a spacer, and largest number of places across the plate."""

GRID_RADIUS_MM, GRID_TURN = 1.0, np.radians(2.0)
"""Radial distance, mm, and angle, rad, between places that are tried for a spacer in a round plate."""

MOST_MARGIN_MM = 5.0
"""Distance, mm, from obstacles above which all places for spacers are equally good."""

BORDER_EXTRA_MM = 2.0
"""Additional width, mm, of a border with a spacer: for clearance, and because a round rim recedes beside the
spacer."""

EXCHANGES = 20
"""Largest number of rounds in which spacers are moved apart. Usually, five rounds suffice."""

LABEL_MM = 4.0
"""Height of the engraved word on a spacer, mm, if the spacer is large enough."""


class Spacer(Rib):
    """Plate between two plates that hold the same tabs. Its y axis is the z axis of these plates."""


def spacer_name(first: BasePlate) -> str:
    """Return the name of the spacers of two plates, from the name of the plate nearer to the strips."""
    return f"{first.name}-spacer"


def pairs_of_plates(plates: Sequence[BasePlate]) -> Iterator[tuple[BasePlate, BasePlate, float]]:
    """Yield the two plates that hold the same tabs, the plate nearer to the strips first, and their gap, mm."""
    for i, first in enumerate(plates):
        for second in plates[i + 1 :]:
            distance = float((first.frame.origin - second.frame.origin) @ first.frame.z_axis)
            if _tabs_of(first) & _tabs_of(second) and distance > first.sheet.thickness:
                yield first, second, distance - first.sheet.thickness


def _tabs_of(plate: BasePlate) -> set[object]:
    return {slot.tab.key for slot in plate.slots if slot.tab is not None}


Plate = TypeVar("Plate", bound=BasePlate)


def add_spacers(
    placed: Sequence[Placed], plates: Sequence[Plate], count: Annotated[int, _COUNT]
) -> tuple[tuple[Plate, ...], tuple[Spacer, ...]]:
    """Return the plates with slots for spacers, and the spacers between the two plates of each pair.

    A spacer is perpendicular to its plates and as high as their gap. Its tongues end at the outer faces of the
    plates. Spacers are distributed over the plates, clear of strips, tabs, holes and edges. Round plates become
    as wide as their spacers need: inwards if their openings remain large enough, else outwards.

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
        width, places = _places(placed, (first, second), gap, count)
        sheet, options = first.sheet, first.options or PlateOptions()
        size = np.array([width / 2 + 2 * options.play, sheet.thickness + options.clearance])
        slots = tuple(TabSlot(_rectangle(place, size), "spacer", sheet.thickness) for place in places)
        bodies = [_rectangle(place, np.array([width, sheet.thickness])) for place in places]
        slotted |= {id(plate): _with_slots(plate, slots, bodies) for plate in (first, second)}
        spacers += [_spacer((first, second), gap, width, place).checked(options) for place in places]
    if not spacers:
        raise InputError(
            "{spacers} needs two plates that hold the same tabs. Set {gap}, the distance between them.",
            spacers=FieldName("spacers"), gap=FieldName("gap"),
        )  # fmt: skip
    return tuple(slotted.values()), tuple(spacers)


def _with_slots(plate: Plate, slots: tuple[TabSlot, ...], bodies: Sequence[FloatArray]) -> Plate:
    """Return the plate with slots for spacers. A round plate is made wide enough for the slots and the bodies."""
    options = plate.options or PlateOptions()
    if plate.is_round:
        center = plate.outline.bounds.mean(axis=0)
        bridge = limits_or_default(options.shop).bridge_for(plate.sheet)
        inner, outer = np.transpose([
            _radii(plate),
            around([slot.corners for slot in slots], center, bridge + PITCH_MM / 2),
            around(bodies, center, BESIDE_MM),
        ])  # fmt: skip
        plate = plate.resized(float(inner.min()), float(outer.max()))
    checked = replace(plate, slots=(*plate.slots, *slots)).checked(options)
    return replace(checked, warnings=tuple(dict.fromkeys((*plate.warnings, *checked.warnings))))


def _rectangle(place: FloatArray, size: FloatArray) -> FloatArray:
    """Return the corners (4, 2), anticlockwise, of a rectangle of a `size` (2,), mm, at (x, y, angle)."""
    along = np.array([np.cos(place[2]), np.sin(place[2])])
    sides = np.array([along, (-along[1], along[0])]) * size[:, None] / 2
    return np.asarray(place[:2] + np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) @ sides, dtype=float)


def _spacer(plates: tuple[BasePlate, BasePlate], gap: float, width: float, place: FloatArray) -> Spacer:
    first, second = plates
    middle = first.frame.shifted(z=-first.sheet.thickness - gap / 2)
    along = np.cos(place[2]) * middle.x_axis + np.sin(place[2]) * middle.y_axis
    frame = Frame(middle.point([*place[:2], 0.0]), along, middle.z_axis)
    half, tongue, body = width / 2, width / 4, gap / 2
    low, high = body + second.sheet.thickness, body + first.sheet.thickness
    corners = [
        (-half, -body), (-tongue, -body), (-tongue, -low), (tongue, -low), (tongue, -body), (half, -body),
        (half, body), (tongue, body), (tongue, high), (-tongue, high), (-tongue, body), (-half, body),
    ]  # fmt: skip
    label = centred_text("spacer", (0.0, 0.0), min(LABEL_MM, 0.4 * gap), 0.8 * width)
    return Spacer(spacer_name(first), first.sheet, frame, Path.polygon(np.array(corners)), label)


def _places(
    placed: Sequence[Placed], plates: tuple[BasePlate, BasePlate], gap: float, count: int
) -> tuple[float, FloatArray]:
    """Return the largest possible width, mm, of spacers, and their places (count, 3): x, y and angle."""
    most = 0
    for tried in _sizes(plates):
        for width, places in _free_places(placed, tried, gap):
            if len(places) >= count:
                return width, _far_apart(places, count)
            most = max(most, len(places))
    first, options = plates[0], plates[0].options or PlateOptions()
    slots = [slot.corners for slot in first.slots], [slot.corners for slot in plates[1].slots]
    offset = float(np.hypot(*np.diff(slots, axis=0)[0].mean(axis=1).T).max())
    raise InputError(
        "{name}: there is room for {most} spacers between the two plates, not for {count}. Use fewer spacers."
        if first.is_round
        else "{name}: there is room for {most} spacers between the two plates, not for {count}. Use fewer spacers, "
        "or a {border} of more than {wide:.0f}.",
        name=first.name, most=most, count=count, border=FieldName("border"),
        wide=Length(max(options.border, _border_with_spacers(first.sheet, options.shop) + np.ceil(offset))),
    )  # fmt: skip


def _sizes(plates: tuple[BasePlate, BasePlate]) -> Iterator[tuple[BasePlate, BasePlate]]:
    """Yield the plates as they are and, if round, with room for spacers inside the slots, outside, or both."""
    yield plates
    first, second = plates
    if not (first.is_round and second.is_round):
        return
    options, radii = first.options or PlateOptions(), np.array([_radii(plate) for plate in plates])
    room = _border_with_spacers(first.sheet, options.shop) + GRID_RADIUS_MM - options.border
    inner, outer = float(radii[:, 0].min()) - room, float(radii[:, 1].max()) + room
    inside, outside = np.minimum(radii, [inner, np.inf]), np.maximum(radii, [-np.inf, outer])
    kept = inner >= max(KEPT_OPENING * float(radii[:, 0].min()), LEAST_OPENING_MM / 2)
    one_side = (inside, outside) if kept else (outside, inside)
    for sizes in (*one_side, np.column_stack([inside[:, 0], outside[:, 1]])):
        yield first.resized(*sizes[0]), second.resized(*sizes[1])


def _radii(plate: BasePlate) -> tuple[float, float]:
    loops = [slot.corners for slot in plate.slots if slot.tab is not None]
    return around(loops, plate.outline.bounds.mean(axis=0), (plate.options or PlateOptions()).border)


def _free_places(
    placed: Sequence[Placed], plates: tuple[BasePlate, BasePlate], gap: float
) -> Iterator[tuple[float, FloatArray]]:
    """Yield the widths, mm, of spacers, from wide to narrow, and all free places (n, 3): x, y and angle."""
    first, options = plates[0], plates[0].options or PlateOptions()
    bridge = limits_or_default(options.shop).bridge_for(first.sheet)
    closed, cuts, bodies = _obstacles(placed, plates, gap)
    tried = _tried_places(first)
    inside = np.logical_and.reduce(
        [_enclosed(plate.outline.points(PITCH_MM / 10), tried) for plate in plates]
    )
    tried = tried[inside & ~np.logical_or.reduce([_enclosed(loop, tried) for loop in closed])]
    near, _ = near_pairs(tried[:, :2], cuts, bridge + first.sheet.thickness / 2)
    tried = np.delete(tried, near, axis=0)
    for width in WIDTHS_MM:
        body = np.array([width, first.sheet.thickness]) / 2
        margin = np.minimum(
            _margins(tried, cuts, np.array([width / 4, body[1]]) + bridge + PITCH_MM / 2),
            _margins(tried, np.concatenate([cuts, bodies]), body + BESIDE_MM),
        )
        apart = float(np.hypot(*(body + bridge))) * 2
        yield width, _thinned(tried[margin > 0], margin[margin > 0], apart)


def _border_with_spacers(sheet: Sheet, shop: FabricationLimits | None) -> float:
    bridge = limits_or_default(shop).bridge_for(sheet)
    return float(np.ceil(2 * bridge + sheet.thickness + BORDER_EXTRA_MM))


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
        x, y = (low + high)[:, None] / 2 + r * np.array([np.cos(turn), np.sin(turn)])
    else:
        step = max(GRID_MM, float((high - low).max()) / GRID_LINES)
        x, y = (
            np.ravel(grid)
            for grid in np.meshgrid(*(np.arange(*ends, step) for ends in zip(low, high, strict=True)))
        )
        turn = np.zeros(x.size)
    return np.concatenate([np.column_stack([x, y, turn + more]) for more in (0.0, np.pi / 2)])


def _obstacles(
    placed: Sequence[Placed], plates: tuple[BasePlate, BasePlate], gap: float
) -> tuple[list[FloatArray], FloatArray, FloatArray]:
    """Return loops that exclude spacers, points (n, 2) on cuts, and points (m, 2) of strips and tabs in the gap."""
    first, second = plates
    loops = [loop.points(PITCH_MM / 10) for plate in plates for loop in plate._inner_loops]
    tabs = []
    places = {slot.tab.key: slot.corners for slot in second.slots if slot.tab is not None}
    for slot in first.slots:
        if slot.tab is not None and slot.tab.key in places:
            side = slot.corners[1] - slot.corners[0]
            u = side / np.hypot(*side)
            axes = np.array([u, (-u[1], u[0])])
            low, high = np.quantile(
                np.concatenate([slot.corners, places[slot.tab.key]]) @ axes.T, (0, 1), axis=0
            )
            tabs.append(np.array([low, (high[0], low[1]), high, (low[0], high[1])]) @ axes)
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
    inside = np.zeros(len(places), dtype=bool)
    for (x0, y0), (x1, y1) in zip(loop, np.roll(loop, -1, axis=0), strict=True):
        rises = (y0 > places[:, 1]) != (y1 > places[:, 1])
        inside ^= rises & (places[:, 0] < x0 + (places[:, 1] - y0) * (x1 - x0) / ((y1 - y0) or 1.0))
    return inside


def _margins(places: FloatArray, points: FloatArray, half: FloatArray) -> FloatArray:
    """Return the distance (n,), mm, from a rectangle at each place to the nearest point.

    `half` (2,) are half the sides of the rectangle. The distance is negative if a point is inside the
    rectangle, and at most `MOST_MARGIN_MM`.
    """
    margin = np.full(len(places), MOST_MARGIN_MM)
    i, k = near_pairs(places[:, :2], points, float(np.hypot(*(half + MOST_MARGIN_MM))))
    away, (c, s) = points[k] - places[i, :2], (np.cos(places[i, 2]), np.sin(places[i, 2]))
    local = np.column_stack([c * away[:, 0] + s * away[:, 1], c * away[:, 1] - s * away[:, 0]])
    np.minimum.at(margin, i, (np.abs(local) - half).max(axis=1))
    return margin


def _thinned(places: FloatArray, margin: FloatArray, apart: float) -> FloatArray:
    """Return places at least `apart` mm from each other. Large margins are preferred, then outer places."""
    radius = np.hypot(*(places[:, :2] - places[:, :2].mean(axis=0)).T) if len(places) else margin
    places = places[np.lexsort((-radius, -margin.round(1)))]
    kept = list[FloatArray]()
    while len(places):
        kept.append(places[0])
        places = places[np.hypot(*(places[:, :2] - places[0, :2]).T) >= apart]
    return np.array(kept)


def _far_apart(places: FloatArray, count: int) -> FloatArray:
    apart = np.linalg.norm(places[:, None, :2] - places[:, :2], axis=-1)
    chosen = [int(np.argmax(apart.sum(axis=1)))]
    while len(chosen) < count:
        chosen.append(int(np.argmax(apart[:, chosen].min(axis=1))))
    for k in [*range(count)] * EXCHANGES:
        others = chosen[:k] + chosen[k + 1 :]
        least = apart[:, others].min(axis=1)
        if least.max() > least[chosen[k]]:
            chosen[k] = int(np.argmax(least))
    return places[sorted(chosen)]
