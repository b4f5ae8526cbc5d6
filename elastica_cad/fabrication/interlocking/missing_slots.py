"""Strips of a model that run through each other where no slot lets them."""

from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import combinations

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.interlocking.interlock import TOUCHING_RAD, Joint, strip_thickness
from elastica_cad.fabrication.interlocking.ruled_strip import RuledStrip
from elastica_cad.fabrication.interlocking.strip_crossings import strip_crossings
from elastica_cad.fabrication.placed_strip import Placed, strip_names
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.paths.profile import Profile

EDGES_TOUCH_MM = 0.1
"""Strips that lie edge to edge may reach so far into each other, either of them: a file takes it off."""

CURE = "slot them (interlock), place them apart, or make them narrower there"


def missing_slots(placed: Sequence[Placed], joints: Iterable[Joint] = ()) -> tuple[str, ...]:
    """A sentence for every two strips that cross and are not slotted there, on the first place; tabs are left out.

    Strips that `joints` slot into each other are not asked again.

    Examples
    --------
    >>> missing_slots([])
    ()
    """
    return tuple(f"{meeting}: {CURE}" for meeting in _meetings(placed, joints))


def tell_missing_slots(placed: Sequence[Placed], joints: Iterable[Joint] = ()) -> tuple[str, ...]:
    """The same in one sentence, on the first two strips; none where all are slotted or apart.

    Examples
    --------
    >>> tell_missing_slots([])
    ()
    """
    meetings = _meetings(placed, joints)
    if not meetings:
        return ()
    others = len(meetings) - 1
    more = f" (and {others} more pair{'' if others == 1 else 's'})" if others else ""
    return (f"{meetings[0]}{more}: {CURE}",)


def _meetings(placed: Sequence[Placed], joints: Iterable[Joint]) -> list[str]:
    """Of every two strips that run through each other where no slot lets them, the first place."""
    names = strip_names(placed)
    ruled = [RuledStrip(one.strip.rod.curve, one.frame, _within_edges(one.strip.width)) for one in placed]
    slotted = {joint.members for joint in joints}
    found = []
    for i, j in combinations(range(len(placed)), 2):
        if (i, j) in slotted:
            continue
        for crossing in strip_crossings(ruled[i], ruled[j]):
            _, _, points = crossing.course
            if points.angle.max() < TOUCHING_RAD or crossing.length < strip_thickness(placed[i].strip):
                continue
            if _has_slot(placed[i].strip, points.first[:, 0]) or _has_slot(
                placed[j].strip, points.second[:, 0]
            ):
                continue
            first, second = points.first[:, 0].mean(), points.second[:, 0].mean()
            found.append(f"{names[i]} at {first:.1f} mm runs through {names[j]} at {second:.1f} mm")
            break
    return found


def _within_edges(width: Profile) -> Profile:
    """The width without what a file takes off: strips that lie edge to edge then keep apart."""
    return replace(width, coefficients=width.coefficients - 2 * EDGES_TOUCH_MM)


def _has_slot(strip: Strip, stations: FloatArray) -> bool:
    room = strip_thickness(strip)
    return any(
        stations.min() - slot.width - room < slot.at < stations.max() + slot.width + room
        for slot in strip.slots
    )
