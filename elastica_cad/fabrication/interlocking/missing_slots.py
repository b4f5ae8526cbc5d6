"""Strips of a model that run through each other where no slot lets them."""

from collections.abc import Sequence
from itertools import combinations

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.interlocking.interlock import TOUCHING_RAD, strip_thickness
from elastica_cad.fabrication.interlocking.ruled_strip import RuledStrip
from elastica_cad.fabrication.interlocking.strip_crossings import strip_crossings
from elastica_cad.fabrication.placed_strip import Placed, strip_names
from elastica_cad.fabrication.strip.strip_record import Strip


def missing_slots(placed: Sequence[Placed]) -> tuple[str, ...]:
    """A sentence for every two strips that cross and are not slotted there, on the first place; tabs are left out.

    Examples
    --------
    >>> missing_slots([])
    ()
    """
    names = strip_names(placed)
    ruled = [RuledStrip(one.strip.rod.curve, one.frame, one.strip.width) for one in placed]
    found = []
    for i, j in combinations(range(len(placed)), 2):
        for crossing in strip_crossings(ruled[i], ruled[j]):
            _, _, points = crossing.course
            if points.angle.max() < TOUCHING_RAD or crossing.length < strip_thickness(placed[i].strip):
                continue
            if _has_slot(placed[i].strip, points.first[:, 0]) or _has_slot(
                placed[j].strip, points.second[:, 0]
            ):
                continue
            first, second = points.first[:, 0].mean(), points.second[:, 0].mean()
            found.append(
                f"{names[i]} at {first:.1f} mm runs through {names[j]} at {second:.1f} mm: slot them "
                "(Model.interlock) or place them apart"
            )
            break
    return tuple(found)


def _has_slot(strip: Strip, stations: FloatArray) -> bool:
    room = strip_thickness(strip)
    return any(
        stations.min() - slot.width - room < slot.at < stations.max() + slot.width + room
        for slot in strip.slots
    )
