"""Single plates in the best plane for their tabs, and pairs of plates that hold inclined tabs at their angle."""

from collections.abc import Callable, Hashable, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from elastica_cad._types import BoolArray, FloatArray
from elastica_cad._values import require_positive
from elastica_cad.errors import Angle, InputError, Length, NotConvergedError, Refusal, note, sentences
from elastica_cad.geometry.frame import Frame
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.model.fixtures import Key, PlacedTab, place_tabs, tabs_to_hold
from elastica_cad.model.held_tabs import slot_walls, tab_seats
from elastica_cad.model.plate_holes import refuse_other_ends
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
    end_names,
    needed_length,
    options_by_name,
    options_of,
    plate_with,
    ring_plate,
    room_of_tab,
    shoulder_faults,
    tab_slot,
    tabs_of,
    up_to_tenth,
    with_shoulders,
)
from elastica_cad.strip.makeable_strip import refuse_broken
from elastica_cad.strip.outline import ENDS
from elastica_cad.strip.pieces import cut_key
from elastica_cad.strip.strip import Placed
from elastica_cad.strip.tab_seats import Lean, lean_against
from elastica_cad.strip.uncuttable_parts import accept_faults, find_strip_faults

MOST_BENT_RAD = np.radians(20.0)
"""Largest angle, rad, by which a load may bend a tab between two plates. Bending is computed for small angles."""


def plate_pair(
    placed: Sequence[Placed],
    sheet: Sheet | str,
    *,
    gap: float = GAP_MM,
    frame: Frame | None = None,
    **options: Any,
) -> tuple[BasePlate, BasePlate]:
    """Return two plates, one below the other, whose slots hold inclined tabs at their angle.

    In a single slot with vertical walls, an inclined tab can rock. A second slot, `gap` mm below and offset
    by gap cot(phi), fixes the angle phi of the tab. A loaded tab bends and shifts within its play, so the slots
    are moved slightly in the opposite direction. Tabs are drawn straight and overlap the plates slightly.

    Parameters
    ----------
    placed : sequence of Placed
    sheet : Sheet or its name
        Sheet of both plates.
    gap : float
        Distance between the plates, mm.
    frame : Frame, optional
        Upper face of the upper plate, z up.
    **options
        Other options of `base_plate`.

    Returns
    -------
    (BasePlate, BasePlate)
        The upper and the lower plate, with the names NAME and NAME-lower.
    """
    sheet = Sheet.of(sheet)
    plate_options = options_by_name(PlateOptions, options, "a pair of plates")
    upper = base_plate(placed, sheet, frame=frame, **vars(plate_options))
    upper, lower = add_second_plates(placed, [upper], gap, "-lower")
    return with_shoulders(upper, plate_options), lower


def ring_pair(
    placed: Sequence[Placed],
    tabs: Sequence[PlacedTab],
    sheet: Sheet,
    *,
    gap: float = GAP_MM,
    middle: float = np.inf,
    **options: Any,
) -> tuple[Ring, ...]:
    """Return two rings about the z axis, one behind the other, that hold one end of all strips at its angle.

    Tabs that are flat on the ring are glued to it, and a single ring is returned.

    Parameters
    ----------
    placed : sequence of Placed
        All strips of the surface.
    tabs : sequence of PlacedTab
        Tabs at the same end of every strip.
    sheet : Sheet
        Sheet of both rings.
    gap : float
        Distance between the rings, mm.
    **options
        Other options of `ring_plate`. The name of the second ring is NAME-outer.
    """
    options_by_name(RingOptions, options, "a pair of rings", ("shape", "ends"))
    return add_second_plates(placed, [ring_plate(tabs, sheet, middle=middle, **options)], gap)


def add_second_plates(
    placed: Sequence[Placed],
    plates: Sequence[Plate],
    gap: float,
    suffix: str = "-outer",
    strips_at: "StripsAt | None" = None,
) -> tuple[Plate, ...]:
    """Return each plate and a second plate, `gap` mm behind it, with the name NAME + `suffix`.

    Slots are moved against the loads of tabs. A ring to which tabs are glued flat gets no second ring. Suggestions
    in errors are tested with all plates.

    Parameters
    ----------
    strips_at : function, optional
        Returns the strips for another gap, if their tabs depend on it.
    """
    require_positive(gap, "the gap between two plates")
    cures = partial(_tested_cures, placed, plates, gap, strips_at)
    result: list[Plate] = []
    for plate in plates:
        if not (tabs := tabs_of(plate)):
            result.append(plate)
            continue
        _refuse_short(plate, {tab.key: needed_length(tab, plate, gap) for tab in tabs}, cures)
        options = replace(options_of(plate), name=f"{plate.name}{suffix}")
        result += lean_pair(placed, (plate, _plate_behind(plate, options, gap)), cures)
    return tuple(result)


StripsAt = Callable[[float], Sequence[Placed]]
"""Function that returns the strips for a gap, mm, between two plates."""


def _plate_behind(first: Plate, options: PlateOptions, gap: float) -> Plate:
    sheet, ground = first.sheet, first.frame.shifted(z=-first.sheet.thickness - gap)
    named = replace(options, name=first.name)
    # `_leaned` makes the whole plate around its moved slots
    behind = _with_slots(first, lambda _, tab: tab_slot(tab, ground, sheet.thickness, named))
    return replace(behind, frame=ground, name=options.name, options=options)


def _with_slots(plate: Plate, changed: Callable[[TabSlot, PlacedTab], TabSlot]) -> Plate:
    """Return the plate with other slots for its tabs. Slots for tongues of other plates stay."""
    slots = (slot if slot.tab is None else changed(slot, slot.tab) for slot in plate.slots)
    return replace(plate, slots=tuple(slots))


Cures = Callable[[float], str]
"""Function that returns an instruction for the length that a tab needs, mm.

The length is infinite if the tab bends too far.
"""


def _untested_cures(length: float) -> str:
    if length == np.inf:
        return Refusal("fault", "let the strips meet the plate more steeply", severity="note")
    return note("make the tab {needed:g} long", needed=Length(length))


def _tested_cures(
    placed: Sequence[Placed],
    plates: Sequence[BasePlate],
    gap: float,
    strips_at: StripsAt | None,
    length: float,
) -> str:
    """Return remedies that were tried for a pair of plates that does not fit: other tabs, or a smaller gap.

    Without one, return the next problem or a remedy that was not tried.
    """
    cures, slotted = [], [plate for plate in plates if tabs_of(plate)]
    # a plate without slots is a ring to which tabs are glued flat, and longer tabs may not fit on this ring
    # if `strips_at` makes the strips, tabs of a given length lose their default width: suggest the width too
    if (
        length < np.inf
        and len(slotted) == len(plates)
        and (sized := fitting_tabs(placed, slotted, gap, length, keep=strips_at is None))
    ):
        long, wide = sized
        text = "make the tab {needed:g} long and {width:.0f} wide"
        cures.append(
            _untested_cures(long) if wide == np.inf else note(text, needed=Length(long), width=Length(wide))
        )
    # largest gap at which each present tab reaches through the second plate
    behind = [
        -float(plate.frame.local(tab.tip)[2]) - 2 * plate.sheet.thickness
        for plate in slotted
        for tab in tabs_of(plate)
    ]
    largest = min(gap, *behind)
    tested = dict.fromkeys(float(np.floor(fraction * largest)) for fraction in TESTED_FRACTIONS)
    strips = strips_at or (lambda _: placed)
    works = (nearer for nearer in tested if 1 <= nearer < gap and _fits(strips, slotted, nearer))
    if (nearer := next(works, None)) is not None:
        cures.append(note("reduce the gap to {nearer:g}", nearer=Length(nearer)))
    if not cures and length < np.inf:
        try:
            _fitted_length(placed, slotted, gap, length, np.inf)
        except (InputError, NotConvergedError) as problem:
            text = "with tabs {needed:g} long, there is another problem: {problem}"
            return note(text, needed=Length(length), problem=problem.refusal)
    return sentences(cures, note(", or ")) or _untested_cures(np.inf)


TESTED_FRACTIONS = (1.0, 0.9, 0.8, 0.7, 0.6, 0.5)
"""Tested widths of tabs and gaps, as fractions of the width of the narrowest tab and of the largest gap."""


def _fits(strips_at: StripsAt, plates: Sequence[BasePlate], gap: float) -> bool:
    """Return True if two plates at this gap can replace each plate."""
    try:
        placed = strips_at(gap)
    except InputError:
        return False
    return all(pair_with_tabs(placed, plate, gap) for plate in plates)


def fitting_tabs(
    placed: Sequence[Placed], plates: Sequence[BasePlate], gap: float, length: float, *, keep: bool
) -> tuple[float, float] | None:
    """Return the length and width of tabs, mm, with which two plates can replace each plate, or None.

    The length is at least `length`. The width is the largest tested width that works. With `keep`, the
    present widths are tested first. If they work, the width is infinite.
    """
    narrowest = min(tab.width for plate in plates for tab in tabs_of(plate))
    for fraction in TESTED_FRACTIONS:
        width = np.inf if keep and fraction == 1 else float(np.floor(fraction * narrowest))
        with suppress(InputError, NotConvergedError):
            return _fitted_length(placed, plates, gap, length, width), width
    return None


def _fitted_length(
    placed: Sequence[Placed], plates: Sequence[BasePlate], gap: float, length: float, width: float
) -> float:
    # bent tabs may need more than `length`; the result is the length, mm, that all of them need
    sized = _makeable(placed, length, width, options_of(plates[0]))
    tried = [_tried_pair(sized, plate, gap) for plate in plates]
    longer = max(length, *(up_to_tenth(max(needed.values())) for _, needed in tried))
    _makeable(placed, longer, width, options_of(plates[0]))
    return float(longer)


def with_tabs(placed: Sequence[Placed], length: float, width: float) -> list[Placed]:
    """Return the strips with tabs of this length and, if `width` is finite, of this width."""
    strips = {
        strip: replace(
            strip,
            ends=tuple(
                replace(tab, length=length, width=tab.width if width == np.inf else width)
                for tab in strip.ends
            ),
        )
        for strip in {member.strip: None for member in placed}
    }
    return [replace(member, strip=strips[member.strip]) for member in placed]


def _makeable(placed: Sequence[Placed], length: float, width: float, options: PlateOptions) -> list[Placed]:
    """Return the strips of `with_tabs`. Refuse those that cannot be cut, or may crack where `placed` does not."""
    sized = with_tabs(placed, length, width)
    known = {warning for member in placed for warning in member.strip.strain_warnings}
    for strip in {member.strip: None for member in sized}:
        refuse_broken(strip, options.ignore_limits)
        if cracks := [warning for warning in strip.strain_warnings if warning not in known]:
            raise InputError(cracks[0])
        accept_faults(find_strip_faults(strip, options.shop), options.ignore_limits)
    return sized


def pair_with_tabs(placed: Sequence[Placed], first: Plate, gap: float) -> tuple[Plate, ...]:
    """Return two plates that replace plate `first`, or () if they cannot be made.

    The plates hold the tabs of `placed`, which have the positions of the tabs in `first` but may have another
    size.
    """
    try:
        plates, needed = _tried_pair(placed, first, gap)
    except (InputError, NotConvergedError):
        return ()
    return () if any(tab.length < needed[tab.key] for tab in tabs_of(plates[1])) else plates


def _tried_pair(
    placed: Sequence[Placed], first: Plate, gap: float
) -> tuple[tuple[Plate, Plate], dict[Key, float]]:
    """Return the two plates of `pair_with_tabs`, and the length, mm, that each tab needs."""
    options = options_of(first)
    tabs = {tab.key: tab for tab in place_tabs(placed)}
    inner = _with_slots(
        replace(first, options=options),
        lambda _, tab: tab_slot(tabs[tab.key], first.frame, first.sheet.thickness, options),
    )
    accept_faults(shoulder_faults(tabs_of(inner), first.frame, options), options.ignore_limits)
    return _leaned(placed, (inner, _plate_behind(inner, options, gap)), _untested_cures)


def lean_pair(
    placed: Sequence[Placed], plates: tuple[Plate, Plate], cures: Cures = _untested_cures
) -> tuple[Plate, Plate]:
    """Return the plates with moved slots, so that every loaded tab is in its designed position.

    The movement compensates the play and the bending of tabs under the load of the strips as cut. Each slot is as
    wide as the bent tab needs. Then each plate is made again around its moved slots.

    Raises
    ------
    InputError
        A tab bends too far, or is too short. `cures` returns the instruction.
    """
    leaned, needed = _leaned(placed, plates, cures)
    _refuse_short(leaned[0], needed, cures)
    return leaned


def _leaned(
    placed: Sequence[Placed], plates: tuple[Plate, Plate], cures: Cures
) -> tuple[tuple[Plate, Plate], dict[Key, float]]:
    """Return the plates with moved slots (see `lean_pair`), and the length, mm, that each bent tab needs.

    The lengths are by the `key` of the tab.
    """
    leaned = plates
    # the cut of the strip, the strip, the index of its end, and the key of its tab
    ends = [
        (cut_key(member.strip), member.strip, index, PlacedTab.of(member.strip, end, member.frame).key)
        for member in placed
        for index, end in enumerate(ENDS)
    ]
    # five rounds usually suffice, because the movement decreases tenfold in each round
    for _ in range(16):
        # endless tabs touch all points of a wall, also in a plate that the present tab does not reach
        endless = (
            _with_slots(plate, lambda slot, tab: replace(slot, tab=replace(tab, length=np.inf)))
            for plate in leaned
        )
        seats = tab_seats(endless)
        leans, known = dict[Key, Lean](), dict[Hashable, Lean]()
        for cut, strip, index, key in ends:
            # equal ends of equal cuts in equal seats are computed once
            if key in seats:
                alike = cut, index, seats[key].places
                if alike not in known:
                    loaded = strip.as_made.loaded
                    ratio = strip.as_made.tab_ratios(loaded)[index]
                    known[alike] = lean_against(loaded, index, seats[key], ratio)
                leans[key] = known[alike]
        first, second = (replace(plate, slots=_moved_slots(plate, leans, cures)) for plate in leaned)
        old, new = (np.array([slot.corners for plate in pair for slot in plate.slots])
                    for pair in (leaned, (first, second)))  # fmt: skip
        leaned = first, second
        # the slots are settled
        if np.abs(new - old).max(initial=0.0) <= 0.01:
            break
    else:
        raise _bends_too_far(plates[0], tabs_of(plates[0])[0], cures)
    # a tab must reach to the far face of the second plate
    back = plates[1].frame.shifted(z=-plates[1].sheet.thickness)
    tabs = [tab for tab in tabs_of(plates[1]) if tab.key in leans]
    needed = {tab.key: _bent_length(tab, leans[tab.key], back) for tab in tabs}
    first, second = (
        plate
        if plate.options is None
        else plate_with(plate.slots, plate.sheet, plate.frame, plate.options, type(plate))
        for plate in leaned
    )
    return (first, second), needed


def _moved_slots(plate: Plate, leans: Mapping[Key, Lean], cures: Cures) -> tuple[TabSlot, ...]:
    """Return the slots of a plate, moved to where the bent tabs pass through it.

    `leans` has the displacement of the holder of each tab and the shape of the bent tab (see `Lean`), by the key
    of the tab.
    """
    slots = list(plate.slots)
    for k, tab, walls in slot_walls(plate):
        if (lean := leans.get(tab.key)) is not None:
            places, slopes, distances = np.transpose([lean.touched(wall) for wall in walls])
            slope, frame = float(slopes.mean()), tab.frame
            # the left of the curve is in direction -z of the tab
            out = np.cos(slope) * frame.x_axis - np.sin(slope) * frame.z_axis
            bent = replace(tab, frame=Frame(frame.origin, out, frame.y_axis))
            angle = float(np.arcsin(-(bent.frame.x_axis @ plate.frame.z_axis)))
            if lean.bend > MOST_BENT_RAD or angle < FLATTEST_RAD:
                raise _bends_too_far(plate, tab, cures)
            # a tab is pressed against a wall if the gap is at most 0.01 mm
            offsets, pressed = lean.shift + lean.turn * places, distances <= tab.thickness / 2 + 0.01
            slots[k] = _moved_slot(plate, slots[k], tab, bent, offsets, pressed)
    return tuple(slots)


def _moved_slot(
    plate: BasePlate,
    slot: TabSlot,
    tab: PlacedTab,
    bent: PlacedTab,
    offsets: FloatArray,
    pressed: BoolArray,
) -> TabSlot:
    """Return the slot with its two walls moved by `offsets` (2,), mm, to the left of the tab.

    The slot is as wide as the bent tab with its clearance, or narrower if both walls are `pressed` (2,).
    """
    _, low, high = room_of_tab(bent, plate.frame, plate.sheet.thickness)
    # least width of the slot for the bent tab, and this width with the clearance, mm
    tight = float(high[1] - low[1])
    loose = tight + options_of(plate).room_beside(tight)
    left, across = (-(plate.frame.axes @ one.frame.z_axis)[:2] for one in (tab, bent))
    walls = np.array([slot.corners[:2], slot.corners[3:1:-1]])
    # the offsets are measured across the bent tab, but the walls move in the plate
    walls = walls + (offsets / float(across @ left))[:, None, None] * left
    # direction from wall 0 to wall 1
    out = (slot.corners[3] - slot.corners[0]) / slot.size[1]
    # a single pressed wall keeps its moved position, and the slot becomes wider on the other side
    middle = walls.mean(axis=0)
    if pressed.sum() == 1:
        half = loose / 2 * out
        middle = walls[0] + half if pressed[0] else walls[1] - half
    else:
        half = ((walls[1] - walls[0])[0] @ out).clip(tight, loose) / 2 * out
    return replace(slot, corners=np.concatenate([middle - half, (middle + half)[::-1]]))


def _bends_too_far(plate: BasePlate, tab: PlacedTab, cures: Cures) -> InputError:
    return InputError(
        "{name}: the load of the strip bends the tab of {name_2} too far. Slots follow tabs that bend by at most "
        "{most:.0f} and meet the plate at more than {flattest:.0f}: {cures}",
        name=plate.name, name_2=tab.name, most=Angle(MOST_BENT_RAD), flattest=Angle(FLATTEST_RAD),
        cures=cures(np.inf),
    )  # fmt: skip


def _refuse_short(first: BasePlate, needed: Mapping[Key, float], cures: Cures) -> None:
    if short := [tab for tab in tabs_of(first) if tab.length < needed.get(tab.key, 0.0)]:
        raise InputError(
            "{name}: the tab of {name_2} does not reach through the second plate: {cures}",
            name=first.name, name_2=short[0].name, cures=cures(up_to_tenth(max(needed.values()))),
        )  # fmt: skip


def _bent_length(tab: PlacedTab, lean: Lean, ground: Frame) -> float:
    """Return the length, mm, of a bent tab from its start to the plane z = 0 of `ground`."""
    slopes, places, left = lean.resting
    heights = ground.local(tab.frame.point(np.column_stack([places, np.zeros(places.size), -left])))[:, 2]
    lengths = np.append(0.0, (lean.piece * np.hypot(1.0, slopes)).cumsum())
    # the tab is straight beyond its last bent piece
    k = min(int((-heights).searchsorted(0.0)), slopes.size) - 1
    return float(lengths[k] + heights[k] * (lengths[k + 1] - lengths[k]) / (heights[k] - heights[k + 1]))


def end_plates(
    placed: Sequence[Placed],
    sheet: Sheet | str,
    *,
    together: bool = False,
    gap: float | None = None,
    **options: Any,
) -> tuple[BasePlate, ...]:
    """Return a plate for the tabs at each end of the strips, in the best plane for these tabs.

    The first strip defines start and end. Strips drawn in the opposite direction are reversed.

    Parameters
    ----------
    placed : sequence of Placed
    sheet : Sheet or its name
        Sheet of the plates.
    together : bool
        Make one plate for all ends instead of one for each end.
    gap : float, optional
        If given, two plates at this distance, mm, replace each single plate and hold inclined tabs at their
        angle. The name of each second plate ends in -outer.
    **options
        Fields of `RingOptions`. The names are NAME-bottom and NAME-top if the tabs point down and up, else
        NAME-start and NAME-end, or NAME for a single plate. With the shape "ring", a plate whose slots leave
        room for a large enough opening is round. Other plates have the hull of their slots as outline.

    Examples
    --------
    >>> from elastica_cad.strip.strip_spec import make_strip
    >>> from elastica_cad.geometry.plane_curve import PlaneCurve
    >>> bow = PlaneCurve.spline([(60, 0), (90, 60), (90, 120), (60, 180)], degree=3)
    >>> rib = make_strip(bow, "birch-plywood-0.8", max_width=20)
    >>> turn = np.radians([0, 72, 144, 216, 288])
    >>> lamp = [Placed(rib, (0, 0, 0), (np.cos(t), np.sin(t), 0), (0, 0, 1)) for t in turn]
    >>> [(plate.name, plate.opening is not None) for plate in end_plates(lamp, Sheet.named("mdf-3"))]
    [('ring-bottom', True), ('ring-top', True)]
    """
    sheet, ring_options = Sheet.of(sheet), options_by_name(RingOptions, options, "end plates")
    # strips drawn in the opposite direction are reversed, so that each end has neighbouring tabs
    tabs = tabs_to_hold(placed)
    pairs = [*zip(tabs[::2], tabs[1::2], strict=True)]
    opposite = _opposite(np.array([[tab.frame.origin for tab in pair] for pair in pairs]))
    ordered = [pair[::-1] if turned else pair for pair, turned in zip(pairs, opposite, strict=True)]
    ends, tabs_at = ring_options.ends, {end: [pair[k] for pair in ordered] for k, end in enumerate(ENDS)}
    outs = [np.mean([tab.frame.x_axis for tab in tabs_at[end]], axis=0) for end in ENDS]
    # the plates are named by the heights of vertical tabs; the height 0 for other tabs gives the names of ends
    upright = all(abs(out[2]) >= UPRIGHT_COSINE * np.linalg.norm(out) for out in outs)
    first, last = (
        float(np.mean([tab.frame.origin[2] for tab in tabs_at[end]])) if upright else 0.0 for end in ENDS
    )
    called = end_names(ring_options.name, (first, last))
    groups = [(called[end], [end]) for end in ends]
    if together or len(ends) == 1:
        groups = [(ring_options.name, [*ends])]
    refuse_other_ends(ring_options.holes, [name for name, _ in groups])
    plates = tuple(
        _plate([tab for end in group for tab in tabs_at[end]], sheet, replace(ring_options, name=name))
        for name, group in groups
    )
    return plates if gap is None else add_second_plates(placed, plates, gap)


UPRIGHT_COSINE = 0.9
"""Plates are named bottom and top if the angle between mean tab and vertical has at least this cosine."""


def _opposite(ends: FloatArray) -> BoolArray:
    """Return flags (n,) that are True for strips drawn in the opposite direction to strip 0.

    `ends` (n, 2, 3) are the starts and ends of the strips. Each strip is compared with the nearest strip of
    known direction, so that starts are near each other.
    """
    apart = np.linalg.norm(ends[:, None, :, None] - ends[None, :, None, :], axis=-1)
    alike, turned = apart[:, :, 0, 0] + apart[:, :, 1, 1], apart[:, :, 0, 1] + apart[:, :, 1, 0]
    opposite, known = np.zeros((2, len(ends)), dtype=bool)
    known[0] = True
    while not known.all():
        steps = np.where(known[:, None] & ~known, np.minimum(alike, turned), np.inf)
        old, new = np.unravel_index(steps.argmin(), steps.shape)
        # the ends are clearly nearer to those of the neighbour if the strip is reversed
        opposite[new] = opposite[old] ^ (turned[old, new] < (1 - 1e-6) * alike[old, new])
        known[new] = True
    return opposite


def facing_plates(placed: Sequence[Placed], sheet: Sheet, options: PlateOptions) -> tuple[BasePlate, ...]:
    """Return two plates, the lower plate first, for tabs that point in two opposite directions."""
    tabs = tabs_to_hold(placed)
    outs = np.array([tab.frame.x_axis for tab in tabs])
    # the first axis is the line to which the tabs are most nearly parallel
    _, _, axes = np.linalg.svd(outs)
    is_upward = outs @ axes[0] > 0
    sides = [
        [tab for tab, upward in zip(tabs, is_upward, strict=True) if upward == side] for side in (False, True)
    ]
    groups = sorted(filter(None, sides), key=lambda side: min(tab.tip[2] for tab in side))
    words = ("bottom", "top") if abs(axes[0][2]) >= UPRIGHT_COSINE else ("low", "high")
    return tuple(
        _plate(side, sheet, replace(options, name=f"{options.name}-{word}"))
        for side, word in zip(groups, words, strict=False)
    )


def _plate(tabs: Sequence[PlacedTab], sheet: Sheet, options: PlateOptions) -> BasePlate:
    frame = tab_plane(tabs, options.name)
    return plate_with(through_slots(tabs, frame, sheet, options), sheet, frame, options, BasePlate)


def through_slots(
    tabs: Sequence[PlacedTab], frame: Frame, sheet: Sheet, options: PlateOptions
) -> list[TabSlot]:
    """Return a slot for every tab. Refuse a tab that ends before the middle of the plate."""
    for tab in tabs:
        tip = float(frame.local(tab.tip)[2])
        if tab.length <= 0 or tip > -0.5 * sheet.thickness:
            raise InputError(
                "{name}: the tab of {name_2} ends {tip:.4g} in front of the plate: lengthen this tab, or move "
                "the ends of the strips into one plane"
                if tip > 0
                else "{name}: the tab of {name_2} ends inside the plate: lengthen this tab, or move the ends of "
                "the strips into one plane",
                name=options.name,
                name_2=tab.name,
                tip=Length(max(tip, 0.0)),
            )
    return [tab_slot(tab, frame, sheet.thickness, options) for tab in tabs]


def tab_plane(tabs: Sequence[PlacedTab], name: str) -> Frame:
    """Return the best plane for the tabs.

    Its z axis points against the tabs, and the plane passes through the lowest start of a tab along z.
    """
    if not tabs:
        raise InputError(
            "{name}: these strips have no tab that a plate can hold: add tabs to the strips", name=name
        )
    points = np.array([tab.frame.origin for tab in tabs])
    outs = np.array([tab.frame.x_axis for tab in tabs])
    down = outs.mean(axis=0)
    center = points.mean(axis=0)
    _, _, axes = np.linalg.svd(points - center)
    along = axes[0] if len(tabs) > 1 else tabs[0].frame.y_axis
    # normal to the line on which the starts nearly are, and as opposite to the mean tab as possible
    square = down - (down @ along) * along
    normals = [-square / max(float(np.linalg.norm(square)), 1e-12)]
    # normal of the plane nearest to the starts
    if len(tabs) > 2:
        normals.append(-np.sign(axes[2] @ down) * axes[2])
    # a normal is possible if all tabs are steep enough for slots
    fit = [float((outs @ n).max()) < -np.sin(FLATTEST_RAD) for n in normals]
    if not any(fit):
        flattest = max(-float((outs @ n).max()) for n in normals)
        raise InputError(
            "{name}: the tabs meet the plate at {lean:.3g}, but slots need more than {steep:.0f}. "
            "Hold the tabs with fixtures, or let the strips meet the plate more steeply."
            if flattest > 0
            else "{name}: the tabs point in too many directions for one plate: hold them with fixtures, or make "
            "the directions of the ends more similar",
            name=name,
            lean=Angle(np.arcsin(np.clip(flattest, 0.0, 1.0))),
            steep=Angle(FLATTEST_RAD),
        )
    spread = [float(np.ptp(points @ n)) if ok else np.inf for n, ok in zip(normals, fit, strict=True)]
    # incline the plate only if this reduces the height differences of tabs by more than 0.5 mm
    better = len(spread) > 1 and spread[1] < spread[0] - 0.5
    z = normals[1 if better else 0]
    x = along - (along @ z) * z
    x = x / np.linalg.norm(x)
    lowest = float((points @ z).min())
    return Frame(center + (lowest - center @ z) * z, x, np.cross(z, x))
