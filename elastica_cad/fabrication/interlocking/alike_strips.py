"""Strips made or cut alike, and placed alike: equal but for rounding, labels and the names of mates."""

from collections.abc import Sequence
from dataclasses import fields, replace

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.slots.slot import Slot
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.frame import Frame

SAME_MM = 1e-9
"""Slots that differ by less are one: crossings of equal strips in different places of a model round differently."""

SAME_TURN = 1e-12
"""Components of unit axes that differ by less are one: over 1 m they part by 1e-9 mm."""

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


def number_made_alike(strips: Sequence[Strip]) -> list[int]:
    """For each strip the place of the first that is made alike, whatever their labels and slots."""
    firsts: dict[int, list[int]] = {}
    found = []
    for i, strip in enumerate(strips):
        known = firsts.setdefault(id(strip.rod), [])
        first = next((k for k in known if _made_alike(strips[k], strip)), i)
        if first == i:
            known.append(i)
        found.append(first)
    return found


def place_between(first: Frame, second: Frame) -> tuple[float, ...]:
    """How the second frame lies in the first, to rounding: of pairs that are placed alike the same."""
    origin = np.round(first.local(second.origin) / SAME_MM)
    axes = np.round(second.axes[:2] @ first.axes.T / SAME_TURN)
    return (*origin.tolist(), *axes.ravel().tolist())


def _alike(one: Strip, other: Strip) -> bool:
    if len(one.slots) != len(other.slots) or not _made_alike(one, other):
        return False
    return all(_slots_alike(a, b) for a, b in zip(one.slots, other.slots, strict=True))


def _made_alike(one: Strip, other: Strip) -> bool:
    """Equal, labels and slots apart?"""
    if one.rod is not other.rod or one.correction is not other.correction or one.plates is not other.plates:
        return False
    return all(
        getattr(one, field.name) == getattr(other, field.name)
        for field in fields(Strip)
        if field.name not in (*ITS_OWN, "rod", "correction", "plates")
    )


def _slots_alike(one: Slot, other: Slot) -> bool:
    if (one.side, one.relief, one.depth is None) != (other.side, other.relief, other.depth is None):
        return False
    a, b = _numbers(one), _numbers(other)
    return a.shape == b.shape and bool(np.abs(a - b).max() <= SAME_MM)


def _numbers(slot: Slot) -> FloatArray:
    """All sizes of a slot, mm; its lean in rad."""
    paths = [np.ravel(part) for part in (slot.path, slot.widths) if part is not None]
    return np.concatenate([[slot.at, slot.width, slot.depth or 0.0, slot.lean], *paths])
