"""What makes a model stand: the simplest holder that takes all its tabs."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from elastica_cad.errors import InputError, refusing_old_names
from elastica_cad.fabrication.holders.end_fixtures import EndFixture, end_fixtures
from elastica_cad.fabrication.holders.plate_pairs import end_plates, facing_plates
from elastica_cad.fabrication.holders.plates import BasePlate
from elastica_cad.fabrication.holders.slotted_frame import Rib, slotted_frame
from elastica_cad.fabrication.makeability.fabrication_limits import FabricationLimits
from elastica_cad.fabrication.placed_strip import Placed
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.refusals import note

LEAST_SPREAD = 0.2
"""Least ratio of the spread of slots across to that along, with which strips hold two plates to each other."""


@dataclass(frozen=True, eq=False)
class Stand:
    """What holds the strips.

    Attributes
    ----------
    holders : tuple of BasePlate, Rib or EndFixture
    sentence : str
        What they are, and where no plates hold all tabs, why.
    """

    holders: tuple[BasePlate | Rib | EndFixture, ...]
    sentence: str


@refusing_old_names
def stand(
    placed: Sequence[Placed],
    sheet: Sheet | str,
    *,
    name: str | None = None,
    shop: FabricationLimits | None = None,
    ignore_limits: bool = False,
) -> Stand:
    """Make the simplest holder that takes the tabs of all strips.

    These are tried in turn, and the first that can be made is taken: one plate, two plates that the strips hold
    apart, a slotted frame, a printed block for every end.

    Parameters
    ----------
    placed : sequence of Placed
        The strips in their places, with tabs.
    sheet : Sheet or its name
        What plates and frames are cut from.
    name : str, optional
        What one plate or two are called; rails, ribs and blocks are called by what they are.
    shop : FabricationLimits, optional
        What the workshop can cut; plates beyond it do not count as made.
    ignore_limits : bool
        Accept plates that the workshop cannot cut.

    Returns
    -------
    Stand
        The holders, and a sentence that says which of these they are.

    Raises
    ------
    InputError
        Strips without tabs.

    Examples
    --------
    >>> from elastica_cad.fabrication.strip_spec import make_strip
    >>> from elastica_cad.geometry.curves.plane_curve import PlaneCurve
    >>> arch = make_strip(PlaneCurve.arc((0, 0), 60, 3.1, 0.04), "birch-plywood-0.8", max_width=20)
    >>> arches = [Placed(arch, (0, y, 0), (1, 0, 0), (0, 0, 1)) for y in (0, 40, 80)]
    >>> print(stand(arches, Sheet.named("mdf-3")).sentence)
    stands on one plate
    """
    sheet = Sheet.of(sheet)
    gate: dict[str, Any] = {"shop": shop, "ignore_limits": ignore_limits}
    ways: tuple[tuple[str, Callable[[], tuple[BasePlate | Rib, ...]]], ...] = (
        (
            "stands on one plate",
            partial(end_plates, placed, sheet, together=True, name=name or "base", **gate),
        ),
        (
            "held by two plates",
            partial(_plates_apart, placed, sheet, gate | ({"name": name} if name else {})),
        ),
        ("held by a slotted frame", partial(_frame, placed, sheet, gate)),
    )
    problem = ""
    for sentence, make in ways:
        try:
            return Stand(make(), sentence)
        except InputError as error:
            problem = str(error)
    blocks = end_fixtures(placed)
    if not blocks:
        raise InputError(
            "nothing can hold strips without tabs: give them ends of some length ({problem})", problem=problem
        )
    return Stand(
        blocks,
        note(
            "held by a printed block at every end, for plates cannot hold all tabs: {problem}",
            problem=problem,
        ),
    )


def _plates_apart(placed: Sequence[Placed], sheet: Sheet, gate: Mapping[str, Any]) -> tuple[BasePlate, ...]:
    """Two plates, where strips stand around and so hold them apart."""
    plates = facing_plates(placed, sheet, **gate)
    for plate in plates:
        centers = np.array([slot.corners.mean(axis=0) for slot in plate.slots])
        # one only, of a single slot
        spreads = np.linalg.svd(centers - centers.mean(axis=0), compute_uv=False)
        if len(plate.slots) < 3 or spreads[1] < LEAST_SPREAD * spreads[0]:
            raise InputError("{name}: the slots lie in a row, so that the plate would tip", name=plate.name)
    return plates


def _frame(placed: Sequence[Placed], sheet: Sheet, gate: Mapping[str, Any]) -> tuple[BasePlate | Rib, ...]:
    made = slotted_frame(placed, sheet, **gate)
    return (*made.rails, *made.ribs)
