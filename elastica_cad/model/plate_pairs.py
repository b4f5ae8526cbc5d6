"""Plates that follow tabs wherever these are, alone or in pairs that hold inclined tabs at their angle."""

from collections.abc import Hashable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import require_positive
from elastica_cad.errors import InputError
from elastica_cad.geometry.frame import Frame
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.model.fixtures import Key, PlacedTab, tabs_to_hold
from elastica_cad.model.held_tabs import slot_walls, tab_seats
from elastica_cad.model.plates import (
    FLATTEST_RAD,
    GAP_MM,
    BasePlate,
    Plate,
    PlateOptions,
    Ring,
    RingOptions,
    TabSlot,
    base_plate,
    needed_length,
    options_by_name,
    plate_with,
    ring_plate,
    tab_slot,
)
from elastica_cad.refusals import Length
from elastica_cad.strip.outline import ENDS
from elastica_cad.strip.pieces import cut_key
from elastica_cad.strip.strip import Placed
from elastica_cad.strip.tab_seats import Lean, TabSeat, lean_against

LEAN_ROUNDS = 6
"""Largest number of rounds of moving slots; three are usually enough."""

LEANED_MM = 0.03
"""Rounds end when they move slots by less than this, mm; each leaves a tenth of what it moved."""


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
    require_positive(gap, "the gap between two plates")
    asked = options_by_name(PlateOptions, options, "a pair of plates")
    upper = base_plate(placed, sheet, frame=frame, **vars(asked))
    return _add_second(placed, upper, replace(asked, name=f"{upper.name}-lower"), gap)


def ring_pair(
    placed: Sequence[Placed],
    tabs: Sequence[PlacedTab],
    sheet: Sheet,
    *,
    gap: float = GAP_MM,
    middle: float = np.inf,
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
    **options
        All others of `ring_plate`; the second ring is called NAME-outer.

    Raises
    ------
    InputError
        A tab too short for the second ring, with the length it needs; and as `ring_plate`.
    """
    require_positive(gap, "the gap between two plates")
    asked = options_by_name(RingOptions, options, "a pair of rings", ("shape", "ends"))
    first = ring_plate(tabs, sheet, middle=middle, **options)
    if first.seats:
        return (first,)
    return _add_second(placed, first, replace(asked, name=f"{first.name}-outer"), gap)


def _add_second(
    placed: Sequence[Placed], first: Plate, options: PlateOptions, gap: float
) -> tuple[Plate, Plate]:
    """A plate and another of its kind behind it, `gap` mm further along the tabs, both leaned against their loads.

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
            "{name}: the tab of {name_2} does not reach through the second plate: make it "
            "{needed:.0f} long, or the gap smaller",
            name=first.name,
            name_2=short[0].name,
            needed=Length(needed),
        )
    named = replace(options, name=first.name)
    slots = [tab_slot(tab, ground, sheet.thickness, named) for tab in tabs]
    return lean_pair(placed, (first, plate_with(slots, sheet, ground, options, type(first))))


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
    """Shift of the holder of each tab; ends that are cut and held alike are computed once."""
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


LEVEL_GAIN_MM = 0.5
"""Gain in level, mm, from which on a plate is tilted against the mean direction of the tabs."""


def end_plates(
    placed: Sequence[Placed],
    sheet: Sheet | str,
    *,
    together: bool = False,
    gap: float | None = None,
    **options: Any,
) -> tuple[BasePlate, ...]:
    """A plate for the tabs of each end of any strips, in the plane that suits these tabs.

    Parameters
    ----------
    placed : sequence of Placed
    sheet : Sheet or its name
        Of the plates.
    together : bool
        One plate for the tabs of all these ends, instead of one for each.
    gap : float, optional
        Two plates instead of each, so far apart, mm, that hold inclined tabs at their angle; the second is called
        NAME-start-outer and so on.
    **options
        Fields of `RingOptions`. The plates are called NAME-start and NAME-end, or NAME where there is one. The
        shape "ring" is round with a round opening, where the slots are arranged about one; else it is the hull of
        the slots.

    Raises
    ------
    InputError
        Tabs that point in too many directions, end before the plate or lie too flat, slots that meet; parts are
        named. Plates that cannot be cut, without `ignore_limits`.

    Examples
    --------
    >>> from elastica_cad.strip.strip_spec import make_strip
    >>> from elastica_cad.geometry.plane_curve import PlaneCurve
    >>> bow = PlaneCurve.spline([(60, 0), (90, 60), (90, 120), (60, 180)], degree=3)
    >>> rib = make_strip(bow, "birch-plywood-0.8", max_width=20)
    >>> turn = np.radians([0, 72, 144, 216, 288])
    >>> lamp = [Placed(rib, (0, 0, 0), (np.cos(t), np.sin(t), 0), (0, 0, 1)) for t in turn]
    >>> [(plate.name, plate.opening is not None) for plate in end_plates(lamp, Sheet.named("mdf-3"))]
    [('ring-start', True), ('ring-end', True)]
    """
    sheet, asked = Sheet.of(sheet), options_by_name(RingOptions, options, "end plates")
    groups = [tuple(asked.ends)] if together or len(asked.ends) == 1 else [(end,) for end in asked.ends]
    names = [asked.name] if len(groups) == 1 else [f"{asked.name}-{end}" for (end,) in groups]
    if gap is not None:
        require_positive(gap, "the gap between two plates")
    found: list[BasePlate] = []
    for group, name in zip(groups, names, strict=True):
        plate = _plate(tabs_to_hold(placed, group), sheet, replace(asked, name=name))
        outer = replace(asked, name=f"{name}-outer")
        found += [plate] if gap is None else _add_second(placed, plate, outer, gap)
    return tuple(found)


def facing_plates(placed: Sequence[Placed], sheet: Sheet, options: PlateOptions) -> tuple[BasePlate, ...]:
    """Two plates: one for all tabs that go out one way, one for those that go out the other, the lower first.

    Raises
    ------
    InputError
        As `end_plates`.
    """
    tabs = tabs_to_hold(placed)
    outs = np.array([tab.frame.x_axis for tab in tabs])
    _, _, axes = np.linalg.svd(outs)
    way = outs @ axes[0] > 0
    sides = [[tab for tab, one in zip(tabs, way, strict=True) if one == side] for side in (False, True)]
    found = sorted((side for side in sides if side), key=lambda side: min(tab.tip[2] for tab in side))
    called = (replace(options, name=f"{options.name}-{side}") for side in ("low", "high"))
    return tuple(_plate(side, sheet, own) for side, own in zip(found, called, strict=False))


def _plate(tabs: Sequence[PlacedTab], sheet: Sheet, options: PlateOptions) -> BasePlate:
    frame = tab_plane(tabs, options.name)
    return plate_with(through_slots(tabs, frame, sheet, options), sheet, frame, options, BasePlate)


def through_slots(
    tabs: Sequence[PlacedTab], frame: Frame, sheet: Sheet, options: PlateOptions
) -> list[TabSlot]:
    """A slot for every tab; one that does not reach half way through the plate is refused."""
    for tab in tabs:
        tip = float(frame.local(tab.tip)[2])
        if tab.length <= 0 or tip > -0.5 * sheet.thickness:
            raise InputError(
                "{name}: the tab of {name_2} ends {tip:.4g} in front of the plate or within it: give "
                "that strip a longer tab, or bring the ends of the strips into a plane",
                name=options.name,
                name_2=tab.name,
                tip=Length(max(tip, 0.0)),
            )
    return [tab_slot(tab, frame, sheet.thickness, options) for tab in tabs]


def tab_plane(tabs: Sequence[PlacedTab], name: str) -> Frame:
    """The plane that suits the tabs: through the lowest of their origins, z against the way they go."""
    if not tabs:
        raise InputError(
            "{name}: no tab of these strips can be held: give placed strips with tabs", name=name
        )
    points = np.array([tab.frame.origin for tab in tabs])
    outs = np.array([tab.frame.x_axis for tab in tabs])
    down = outs.mean(axis=0)
    center = points.mean(axis=0)
    _, _, axes = np.linalg.svd(points - center)
    along = axes[0] if len(tabs) > 1 else tabs[0].frame.y_axis
    square = down - (down @ along) * along
    normals = [-square / max(float(np.linalg.norm(square)), 1e-12)]
    if len(tabs) > 2:
        normals.append(-np.sign(axes[2] @ down) * axes[2])
    fit = [float((outs @ n).max()) < -np.sin(FLATTEST_RAD) for n in normals]
    if not any(fit):
        raise InputError(
            "{name}: the tabs point in too many directions for one plate: hold them with "
            "fixtures, or give their ends more alike directions",
            name=name,
        )
    spread = [float(np.ptp(points @ n)) if ok else np.inf for n, ok in zip(normals, fit, strict=True)]
    better = len(spread) > 1 and spread[1] < spread[0] - LEVEL_GAIN_MM
    z = normals[1 if better else 0]
    x = along - (along @ z) * z
    x = x / np.linalg.norm(x)
    lowest = float((points @ z).min())
    return Frame(center + (lowest - center @ z) * z, x, np.cross(z, x))
