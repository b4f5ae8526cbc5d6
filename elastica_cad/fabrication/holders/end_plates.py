"""Plates that follow tabs wherever these are: the plane that suits them, a slot for each."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from elastica_cad.errors import InputError, refusing_old_names
from elastica_cad.fabrication.holders.base_plate import (
    FLATTEST_RAD,
    BasePlate,
    Shape,
    TabSlot,
    plate_with,
    tab_slot,
)
from elastica_cad.fabrication.holders.placed_tab import PlacedTab, tabs_to_hold
from elastica_cad.fabrication.holders.plate_pair import add_second, require_gap
from elastica_cad.fabrication.holders.ring_plate import PLAY_MM
from elastica_cad.fabrication.makeability.shop import Shop
from elastica_cad.fabrication.placed_strip import Placed
from elastica_cad.fabrication.slots.slot import CLEARANCE_MM
from elastica_cad.fabrication.strip.tabs import ENDS, StripEnd
from elastica_cad.geometry.frame import Frame
from elastica_cad.mechanics.material.sheet import Sheet

LEVEL_GAIN_MM = 0.5
"""Tabs that begin this much more level are worth a plate that is not square to their mean direction."""


@refusing_old_names
def end_plates(
    placed: Sequence[Placed],
    sheet: Sheet | str,
    *,
    ends: Sequence[StripEnd] = ENDS,
    together: bool = False,
    border: float = 8.0,
    play: float = PLAY_MM,
    clearance: float = CLEARANCE_MM,
    shape: Shape = "ring",
    name: str = "ring",
    gap: float | None = None,
    shop: Shop | None = None,
    ignore_limits: bool = False,
) -> tuple[BasePlate, ...]:
    """A plate for the tabs of each end of any strips, in the plane that suits these tabs.

    Parameters
    ----------
    placed : sequence of Placed
    sheet : Sheet or its name
        Of the plates.
    ends : sequence of "start" and "end"
    together : bool
        One plate for the tabs of all these ends, instead of one for each.
    border : float
        Least distance of slots from the edges, mm.
    play, clearance : float
        Room beside tabs on either side, and added to the width of slots, mm.
    shape : "ring", "hull" or "rectangle"
        "ring" is round with a round opening, where the slots stand about one; else the hull of the slots.
    name : str
        The plates are called NAME-start and NAME-end, or NAME where there is one.
    gap : float, optional
        Two plates instead of each, so far apart, mm, that hold inclined tabs at their angle; the second is called
        NAME-start-outer and so on.
    shop : Shop, optional
        What the workshop can make.
    ignore_limits : bool
        Make plates that the workshop cannot, and say so in their warnings.

    Raises
    ------
    InputError
        Tabs that point in too many directions, end before the plate or lie too flat, slots that meet; parts are
        named. Plates that cannot be cut, without `ignore_limits`.

    Examples
    --------
    >>> from elastica_cad.fabrication.strip_spec import make_strip
    >>> from elastica_cad.geometry.curves.plane_curve import PlaneCurve
    >>> bow = PlaneCurve.spline([(60, 0), (90, 60), (90, 120), (60, 180)], degree=3)
    >>> rib = make_strip(bow, "birch-plywood-0.8", max_width=20)
    >>> turn = np.radians([0, 72, 144, 216, 288])
    >>> lamp = [Placed(rib, (0, 0, 0), (np.cos(t), np.sin(t), 0), (0, 0, 1)) for t in turn]
    >>> [(plate.name, plate.opening is not None) for plate in end_plates(lamp, Sheet.named("mdf-3"))]
    [('ring-start', True), ('ring-end', True)]
    """
    sheet = Sheet.of(sheet)
    groups = [tuple(ends)] if together or len(ends) == 1 else [(end,) for end in ends]
    names = [name] if len(groups) == 1 else [f"{name}-{end}" for (end,) in groups]
    sizes: dict[str, Any] = {"border": border, "play": play, "clearance": clearance, "shape": shape}
    sizes |= {"shop": shop, "ignore_limits": ignore_limits}
    found: list[BasePlate] = []
    for group, called in zip(groups, names, strict=True):
        plate = _plate(tabs_to_hold(placed, group), sheet, called, **sizes)
        found += [plate] if gap is None else _pair_plate(placed, plate, gap=gap, **sizes)
    return tuple(found)


def _pair_plate(
    placed: Sequence[Placed],
    plate: BasePlate,
    *,
    gap: float,
    play: float = PLAY_MM,
    clearance: float = CLEARANCE_MM,
    **rest: Any,
) -> tuple[BasePlate, BasePlate]:
    """A plate and another behind it, so that inclined tabs keep their angle; the rest as for `plate_with`."""
    require_gap(gap)

    def outer(slots: Sequence[TabSlot], ground: Frame) -> BasePlate:
        return plate_with(slots, plate.sheet, ground, name=f"{plate.name}-outer", **rest)

    return add_second(placed, plate, outer, gap=gap, play=play, clearance=clearance)


def facing_plates(
    placed: Sequence[Placed], sheet: Sheet | str, *, name: str = "ring", **options: Any
) -> tuple[BasePlate, ...]:
    """Two plates: one for all tabs that go out one way, one for those that go out the other, the lower first.

    Raises
    ------
    InputError
        As `end_plates`.
    """
    sheet = Sheet.of(sheet)
    tabs = tabs_to_hold(placed)
    outs = np.array([tab.frame.x_axis for tab in tabs])
    _, _, axes = np.linalg.svd(outs)
    way = outs @ axes[0] > 0
    sides = [[tab for tab, one in zip(tabs, way, strict=True) if one == side] for side in (False, True)]
    found = sorted((side for side in sides if side), key=lambda side: min(tab.tip[2] for tab in side))
    names = [f"{name}-low", f"{name}-high"]
    return tuple(_plate(side, sheet, called, **options) for side, called in zip(found, names, strict=False))


def _plate(
    tabs: Sequence[PlacedTab],
    sheet: Sheet,
    name: str,
    *,
    border: float = 8.0,
    play: float = PLAY_MM,
    clearance: float = CLEARANCE_MM,
    shape: Shape = "ring",
    **gate: Any,
) -> BasePlate:
    frame = tab_plane(tabs, name)
    slots = through_slots(tabs, frame, sheet, play=play, clearance=clearance, name=name)
    return plate_with(slots, sheet, frame, border=border, shape=shape, name=name, **gate)


def through_slots(
    tabs: Sequence[PlacedTab], frame: Frame, sheet: Sheet, *, play: float, clearance: float, name: str
) -> list[TabSlot]:
    """A slot for every tab; one that does not reach half way through the plate is refused."""
    for tab in tabs:
        tip = float(frame.local(tab.tip)[2])
        if tab.length <= 0 or tip > -0.5 * sheet.thickness:
            raise InputError(
                f"{name}: the tab of {tab.name} ends {max(tip, 0.0):.4g} mm in front of the plate or within it: "
                "give that strip a longer tab, or bring the ends of the strips into a plane"
            )
    return [tab_slot(tab, frame, sheet.thickness, play=play, clearance=clearance, name=name) for tab in tabs]


def tab_plane(tabs: Sequence[PlacedTab], name: str) -> Frame:
    """The plane that suits the tabs: through the lowest of their origins, z against the way they go."""
    if not tabs:
        raise InputError(f"{name}: no tab of these strips can be held: give placed strips with tabs")
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
            f"{name}: the tabs point in too many directions for one plate: hold them with fixtures, or "
            "give their ends more alike directions"
        )
    spread = [float(np.ptp(points @ n)) if ok else np.inf for n, ok in zip(normals, fit, strict=True)]
    better = len(spread) > 1 and spread[1] < spread[0] - LEVEL_GAIN_MM
    z = normals[1 if better else 0]
    x = along - (along @ z) * z
    x = x / np.linalg.norm(x)
    lowest = float((points @ z).min())
    return Frame(center + (lowest - center @ z) * z, x, np.cross(z, x))
