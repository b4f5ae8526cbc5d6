"""Two plates that hold inclined tabs at their angle."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.fabrication.holders.base_plate import BasePlate, TabSlot, base_plate, stands_in
from elastica_cad.fabrication.holders.placed_tab import ENDS, PlacedTab
from elastica_cad.fabrication.holders.tab_seats import slot_walls, tab_key, tab_seats
from elastica_cad.fabrication.holding.rest_in_seats import lean_against
from elastica_cad.fabrication.placed_strip import Placed
from elastica_cad.geometry.frame import Frame
from elastica_cad.mechanics.material.sheet import Sheet

LEAN_ROUNDS = 5
"""Of moving slots: what a tab touches changes little after the first."""


def plate_pair(
    placed: Sequence[Placed], sheet: Sheet, *, gap: float = 20.0, frame: Frame | None = None, **options: Any
) -> tuple[BasePlate, BasePlate]:
    """Two plates, one below the other, whose slots hold inclined tabs at their angle.

    A slot with vertical walls lets an inclined tab rock; a second one, further along the tab by the gap between the
    plates and so offset by gap cot(phi), leaves it no angle but its own. Slots are moved a little against the load
    of their tabs, which take up their play and bend between the plates.

    Parameters
    ----------
    placed : sequence of Placed
    sheet : Sheet
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
    if not (np.isfinite(gap) and gap > 0):
        raise InputError(f"the gap between two plates is {gap} mm: it must be positive")
    upper = base_plate(placed, sheet, frame=frame, **options)
    ground = upper.frame.shifted(z=-sheet.thickness - gap)
    for slot in upper.slots:
        tab = slot.tab
        if tab is not None and not stands_in(tab, ground.shifted(z=-sheet.thickness)):
            missing = ground.shifted(z=-sheet.thickness).local(tab.tip)[2] / -(
                ground.z_axis @ tab.frame.x_axis
            )
            raise InputError(
                f"{upper.name}: the tab of {tab.name} does not reach through the lower plate: make it "
                f"{np.ceil(tab.length + missing + 0.5):.0f} mm long, or the gap smaller"
            )
    lower = base_plate(placed, sheet, frame=ground, **{**options, "name": f"{upper.name}-lower"})
    return _leaned(placed, (upper, lower))


def _leaned(placed: Sequence[Placed], plates: tuple[BasePlate, BasePlate]) -> tuple[BasePlate, BasePlate]:
    """The plates with their slots moved so that every loaded tab, play taken up and bent, lies as designed."""
    upper, lower = plates
    for _ in range(LEAN_ROUNDS):
        seats, moves = tab_seats((upper, lower)), dict[tuple[float, ...], tuple[float, float]]()
        for one in placed:
            for index, end in enumerate(ENDS):
                key = tab_key(PlacedTab.of(one.strip, end, one.frame))
                if key in seats:
                    stiffness = one.strip.as_made.tab_ratios()[index]
                    moves[key] = lean_against(one.strip.rod, index, seats[key], stiffness)
        upper, lower = (
            replace(plate, slots=tuple(_moved(slot, plate, moves) for slot in plate.slots))
            for plate in (upper, lower)
        )
    return upper, lower


def _moved(slot: TabSlot, plate: BasePlate, moves: dict[tuple[float, ...], tuple[float, float]]) -> TabSlot:
    """A slot moved within its plate by what its tab's holder is to be shifted and turned."""
    tab = slot.tab
    if tab is None or tab_key(tab) not in moves:
        return slot
    shift, turn = moves[tab_key(tab)]
    # left of the curve is -z of the tab; what is moved within the plate by m moves across the tab by m sin(phi)
    left: FloatArray = -(plate.frame.axes @ tab.frame.z_axis)[:2]
    within = left / float(left @ left)
    # of each wall the place nearest to the tab is what the tab touches
    near = [places[int(np.argmin(np.abs(places[:, 1])))] for places in slot_walls(slot, plate)]
    first, second = ((shift + turn * float(place[0])) * within for place in near)
    return replace(slot, corners=slot.corners + np.array([first, first, second, second]))
