"""Strips of a model that run through each other, lie in each other, or collide beside the slots that join them."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from elastica_cad._counts import and_more
from elastica_cad._types import FloatArray
from elastica_cad.fabrication.interlocking.alike_strips import place_between
from elastica_cad.fabrication.interlocking.flush_strips import Slab, flush_overlap
from elastica_cad.fabrication.interlocking.interlock import TOUCHING_RAD, Joint, slot_width, strip_thickness
from elastica_cad.fabrication.interlocking.ruled_strip import RuledStrip, strips_may_meet
from elastica_cad.fabrication.interlocking.slotted_collisions import (
    Collision,
    SlotRims,
    SlottedSlab,
    deepest_collision,
)
from elastica_cad.fabrication.interlocking.strip_crossings import strip_crossings
from elastica_cad.fabrication.placed_strip import Placed, strip_names
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.paths.profile import Profile

EDGES_TOUCH_MM = 0.1
"""Strips that lie edge to edge may reach so far into each other, either of them: a file takes it off."""

Pair = tuple[Strip, Strip]
Places = tuple[float, float]


@dataclass(frozen=True, eq=False)
class _Meeting:
    """Where two strips overlap: side by side, beside the slots that join them, or else at an angle."""

    names: tuple[str, str]
    places: Places
    is_flush: bool = False
    beside_slots: Collision | None = None

    def told(self, more: str = "") -> str:
        """A sentence; `more` counts the other pairs."""
        (a, b), (s, r) = self.names, self.places
        if self.beside_slots is not None:
            depth, (x, y, z) = self.beside_slots.depth, self.beside_slots.position
            return (
                f"{a} at {s:.1f} mm also runs {depth:.2g} mm deep into {b} at {r:.1f} mm, beside the slots that "
                f"join them, near ({x:.1f}, {y:.1f}, {z:.1f}) mm{more}: turn or shift one of them, or make them "
                "narrower there"
            )
        if self.is_flush:
            return (
                f"{a} at {s:.1f} mm lies in the thickness of {b} at {r:.1f} mm{more}: place them apart, or make "
                "them narrower there"
            )
        return (
            f"{a} at {s:.1f} mm runs through {b} at {r:.1f} mm{more}: slot them (interlock), place them apart, or "
            "make them narrower there"
        )


def missing_slots(placed: Sequence[Placed], joints: Iterable[Joint] = ()) -> tuple[str, ...]:
    """A sentence for every two strips that overlap and are not slotted there, on one place; tabs are left out.

    Of strips that cross it is the first crossing, of strips that lie side by side where they lie deepest. Of strips
    that `joints` slot into each other it is where they reach deepest into each other beside their slots.

    Examples
    --------
    >>> missing_slots([])
    ()
    """
    return tuple(meeting.told() for meeting in _meetings(placed, joints))


def tell_missing_slots(placed: Sequence[Placed], joints: Iterable[Joint] = ()) -> tuple[str, ...]:
    """The same in one sentence, on the first two strips; none where all are slotted or apart.

    Examples
    --------
    >>> tell_missing_slots([])
    ()
    """
    meetings = _meetings(placed, joints)
    return tuple(meeting.told(and_more(meetings, "pair")) for meeting in meetings[:1])


def _meetings(placed: Sequence[Placed], joints: Iterable[Joint]) -> list[_Meeting]:
    """Of every two strips that overlap where no slot lets them, a place."""
    names = strip_names(placed)
    ruled = [RuledStrip(one.strip.rod.curve, one.frame, _within_edges(one.strip.width)) for one in placed]
    meeting = strips_may_meet(ruled, np.array([strip_thickness(one.strip) / 2 for one in placed]))
    slotted = _rooms(placed, joints)
    found = []
    bodies = _bodies(placed, slotted)
    clear = set[tuple[float, ...]]()
    for i, j in combinations(range(len(placed)), 2):
        pair = names[i], names[j]
        if (i, j) in slotted:
            # strips that are cut alike share their layers
            cut = (id(placed[k].strip.layers) for k in (i, j))
            alike = *cut, slotted[i, j], *place_between(placed[i].frame, placed[j].frame)
            if alike in clear:
                continue
            hit = deepest_collision(bodies[i], bodies[j], slotted[i, j])
            if hit is None:
                clear.add(alike)
            else:
                found.append(_Meeting(pair, hit.places, beside_slots=hit))
        elif meeting[i, j]:
            strips, surfaces = (placed[i].strip, placed[j].strip), (ruled[i], ruled[j])
            if (places := _crossing(strips, surfaces)) is not None:
                found.append(_Meeting(pair, places))
            elif (places := _overlap(strips, surfaces)) is not None:
                found.append(_Meeting(pair, places, is_flush=True))
    return found


def _rooms(placed: Sequence[Placed], joints: Iterable[Joint]) -> dict[tuple[int, int], float]:
    """For pairs that are slotted together, how far beside their slots they are asked, mm.

    Slots of the paper's width are too narrow: there strips are asked only where they are clear of what an exact
    slot takes away.
    """
    rooms: dict[tuple[int, int], float] = {}
    for joint in joints:
        room = 0.0
        if joint.fit == "paper":
            thick = max(strip_thickness(placed[i].strip) for i in joint.members)
            room = float(slot_width(np.array(joint.angle[0]), own=thick, other=thick, clearance=0.0))
        rooms[joint.members] = max(room, rooms.get(joint.members, 0.0))
    return rooms


def _bodies(placed: Sequence[Placed], slotted: Iterable[tuple[int, int]]) -> dict[int, SlottedSlab]:
    """By their places, the strips that are slotted into others."""
    bodies, shared = dict[int, SlottedSlab](), dict[int, SlotRims]()
    for i in sorted({i for pair in slotted for i in pair}):
        strip, frame = placed[i].strip, placed[i].frame
        # strips that are cut alike share their layers
        rims = shared.setdefault(id(strip.layers), SlotRims(strip.slots, strip.width))
        bodies[i] = SlottedSlab.of(RuledStrip(strip.rod.curve, frame, strip.width), strip, rims)
    return bodies


def _crossing(strips: Pair, surfaces: tuple[RuledStrip, RuledStrip]) -> Places | None:
    """Arc lengths of both strips where they first run through each other at an angle."""
    for crossing in strip_crossings(*surfaces):
        _, _, points = crossing.course
        if points.angle.max() < TOUCHING_RAD or crossing.length < strip_thickness(strips[0]):
            continue
        if not _slotted(strips, points.first[:, 0], points.second[:, 0]):
            return float(points.first[:, 0].mean()), float(points.second[:, 0].mean())
    return None


def _overlap(strips: Pair, surfaces: tuple[RuledStrip, RuledStrip]) -> Places | None:
    """Arc lengths of both strips where they lie side by side in each other's thickness."""
    first, second = (Slab.of(surface, strip) for surface, strip in zip(surfaces, strips, strict=True))
    places = flush_overlap(first, second, EDGES_TOUCH_MM)
    if places is None or _slotted(strips, *(np.array([place]) for place in places)):
        return None
    return places


def _within_edges(width: Profile) -> Profile:
    """The width without what a file takes off: strips that lie edge to edge then keep apart."""
    return replace(width, coefficients=width.coefficients - 2 * EDGES_TOUCH_MM)


def _slotted(strips: Pair, first: FloatArray, second: FloatArray) -> bool:
    """Has either strip a slot at these stations?"""
    return any(_has_slot(strip, at) for strip, at in zip(strips, (first, second), strict=True))


def _has_slot(strip: Strip, stations: FloatArray) -> bool:
    room = strip_thickness(strip)
    return any(
        stations.min() - slot.width - room < slot.at < stations.max() + slot.width + room
        for slot in strip.slots
    )
