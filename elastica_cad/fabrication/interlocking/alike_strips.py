"""Strips that are cut alike by their neighbours: equal but for rounding, labels and the names of mates."""

from collections.abc import Sequence
from dataclasses import fields, replace

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.slots.slot import Slot
from elastica_cad.fabrication.strip.strip_record import Strip

SAME_MM = 1e-9
"""Slots that differ by less are one: crossings of equal strips in different places of a model round differently."""

ITS_OWN = ("label", "slots")
"""What strips that are cut alike may differ in; of slots the mates only."""


def cut_as_known(strip: Strip, known: Sequence[Strip]) -> Strip:
    """The strip with the slots and the layers of one that is known and cut alike; itself where there is none."""
    first = next((one for one in known if _alike(one, strip)), None)
    if first is None:
        return strip
    slots = tuple(replace(slot, mate=own.mate) for slot, own in zip(first.slots, strip.slots, strict=True))
    twin = replace(strip, slots=slots)
    vars(twin)["layers"] = first.layers  # the same numbers make the same loops
    return twin


def _alike(one: Strip, other: Strip) -> bool:
    if len(one.slots) != len(other.slots) or one.rod is not other.rod:
        return False
    same = (
        getattr(one, field.name) == getattr(other, field.name)
        for field in fields(Strip)
        if field.name not in (*ITS_OWN, "rod", "correction", "plates")
    )
    if one.correction is not other.correction or one.plates is not other.plates or not all(same):
        return False
    return all(_slots_alike(a, b) for a, b in zip(one.slots, other.slots, strict=True))


def _slots_alike(one: Slot, other: Slot) -> bool:
    if (one.side, one.relief, one.depth is None) != (other.side, other.relief, other.depth is None):
        return False
    a, b = _numbers(one), _numbers(other)
    return a.shape == b.shape and bool(np.abs(a - b).max() <= SAME_MM)


def _numbers(slot: Slot) -> FloatArray:
    """All sizes of a slot, mm; its lean in rad."""
    paths = [np.ravel(part) for part in (slot.path, slot.widths) if part is not None]
    return np.concatenate([[slot.at, slot.width, slot.depth or 0.0, slot.lean], *paths])
