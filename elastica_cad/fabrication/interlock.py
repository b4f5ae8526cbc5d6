"""Strips that cross in space are slotted half way each, so that they slide into each other."""

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING, Literal

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.errors import InputError
from elastica_cad.fabrication.crossings import Crossing, strip_crossings
from elastica_cad.fabrication.loci import PARALLEL
from elastica_cad.fabrication.ruled import RuledStrip
from elastica_cad.fabrication.slots import Relief, Slot

if TYPE_CHECKING:
    from elastica_cad.fabrication.model import Model
    from elastica_cad.fabrication.strip import Strip

__all__ = ["Fit", "Joint", "interlocked", "slot_width"]

Fit = Literal["exact", "paper"]

SHALLOW = np.radians(15.0)
"""Below this angle between two strips a slot is so wide that a warning is due."""

TOUCHING = np.radians(1.0)
"""Below this angle strips touch rather than cross."""

FORCED = 0.5
"""Cutting from the other side is out of the question where it costs this much of the crossing's length more."""

PITCH = 1.5
"""Largest distance of the points along a slot's centre line, mm."""


@dataclass(frozen=True, eq=False)
class Joint:
    """Two strips slotted into each other.

    Attributes
    ----------
    members : (int, int)
        Places of the strips in the model.
    slots : (Slot, Slot)
        In the same order.
    angle : (float, float)
        Smallest and largest angle between the strips along the crossing, rad.
    position : (3,) array
        Where the two slots end against each other, mm.
    """

    members: tuple[int, int]
    slots: tuple[Slot, Slot]
    angle: tuple[float, float]
    position: FloatArray


def slot_width(
    angle: FloatArray, *, own: float, other: float, clearance: float, fit: Fit = "exact"
) -> FloatArray:
    """Width of a slot through a sheet of thickness `own` for one of thickness `other` at an angle, mm.

    h_other / sin(phi) + h_own |cot(phi)| + clearance: a cut square to the sheet also lets the other strip pass
    obliquely through the thickness. `fit="paper"` leaves the second term out (paper, section 9.1).
    """
    width = other / np.sin(angle) + clearance
    return width + own * np.abs(np.cos(angle)) / np.sin(angle) if fit == "exact" else width


def interlocked(
    model: "Model",
    *,
    clearance: float = 0.1,
    fit: Fit = "exact",
    relief: Relief = "square",
    pairs: Iterable[tuple[int, int]] | None = None,
    above: ArrayLike | None = None,
) -> tuple[tuple[tuple[Slot, ...], ...], tuple[Joint, ...], tuple[str, ...]]:
    """New slots of every strip of a model, the joints they make, and what to know about them.

    Arguments and refusals are those of `Model.interlock`.
    """
    if fit not in ("exact", "paper"):
        raise InputError(f'fit is "exact" or "paper", not {fit!r}')
    if not (np.isfinite(clearance) and clearance >= 0):
        raise InputError(f"clearance is {clearance}: it must be 0 mm or more")
    up = None if above is None else np.asarray(above, dtype=float)
    if up is not None and not (up.shape == (3,) and np.all(np.isfinite(up)) and np.any(up != 0)):
        raise InputError("above must be a direction of three numbers")
    ruled = [RuledStrip(p.strip.rod.curve, p.frame, p.strip.width) for p in model.placed]
    cutter = _Cutter(model, clearance, fit, relief, up)
    joints: list[Joint] = []
    for i, j in _checked_pairs(model, pairs):
        crossings = strip_crossings(ruled[i], ruled[j])
        cutter.refuse_touching((i, j), (ruled[i], ruled[j]), crossings)
        joints += [cutter.joint((i, j), crossing) for crossing in crossings]
    slots: list[list[Slot]] = [[] for _ in model.placed]
    for joint in joints:
        for member, slot in zip(joint.members, joint.slots, strict=True):
            slots[member].append(slot)
    return tuple(map(tuple, slots)), tuple(joints), _reports(model, joints)


def _checked_pairs(model: "Model", pairs: Iterable[tuple[int, int]] | None) -> list[tuple[int, int]]:
    count = len(model.placed)
    if pairs is None:
        return list(combinations(range(count), 2))
    found = []
    for i, j in pairs:
        if not (0 <= i < count and 0 <= j < count and i != j):
            raise InputError(f"pair ({i}, {j}): name two different strips by their places 0 to {count - 1}")
        found.append((min(i, j), max(i, j)))
    return sorted(set(found))


@dataclass(frozen=True, eq=False)
class _Cutter:
    """Makes slots of crossings."""

    model: "Model"
    clearance: float
    fit: Fit
    relief: Relief
    above: FloatArray | None

    def joint(self, members: tuple[int, int], crossing: Crossing) -> Joint:
        """Both slots of one crossing, each from the half way point to where its strip ends."""
        names = [self.model.single_name_of(i) for i in members]
        ends = self._ends(members, crossing)
        points = crossing.course[2]
        low, high = float(points.angle.min()), float(points.angle.max())
        if low < TOUCHING:
            s = float(points.first[int(points.angle.argmin()), 0])
            raise InputError(self._touch(names, s))
        slots, middle = [], np.zeros(3)
        for which, end in enumerate(ends):
            last = crossing.beyond(which, end)
            p = crossing.at(crossing.evenly(crossing.middle, float(end if last is None else last), PITCH))
            rows = (p.first, p.second)[which]
            own, other = (_thickness(self.model.placed[i].strip) for i in _turned(members, which))
            widths = slot_width(p.angle, own=own, other=other, clearance=self.clearance, fit=self.fit)
            strip = self.model.placed[members[which]].strip
            if self.clearance >= float(strip.width(rows[0, 0])):
                raise InputError(
                    f"a clearance of {self.clearance:g} mm is larger than {names[which]} is wide at "
                    f"{rows[0, 0]:.6g} mm: make it smaller"
                )
            side: Literal["upper", "lower"] = "upper" if rows[-1, 1] > rows[0, 1] else "lower"
            mate = self.model.placed[members[1 - which]].strip.label
            slots.append(Slot.along(rows, widths, side=side, relief=self.relief, mate=mate))
            middle = p.position[0]
        return Joint(members, (slots[0], slots[1]), (low, high), middle)

    def _ends(self, members: tuple[int, int], crossing: Crossing) -> tuple[int, int]:
        """On which end of the crossing (0 or 1) either strip is cut.

        Each is cut from where it ends anyway; where both ways serve, the earlier strip of the model opens
        towards `above` (its own rulings' direction).
        """
        costs: list[float] = []
        room = crossing.room / crossing.length
        for ends in ((0, 1), (1, 0)):
            least = room[0, ends[0]] + room[1, ends[1]]
            if least > FORCED + min(costs, default=np.inf):
                costs.append(least)
                continue
            exits = [crossing.beyond(which, end) for which, end in enumerate(ends)]
            beyond = [np.inf if x is None else abs(x - end) for x, end in zip(exits, ends, strict=True)]
            costs.append(float(sum(beyond)))
        if not np.isfinite(min(costs)):
            s = crossing.at(np.array([0.5])).first[0, 0]
            names = [self.model.single_name_of(i) for i in members]
            raise InputError(
                f"{names[0]} and {names[1]} cross at {s:.6g} mm of {names[0]}, but one of them ends before the "
                "crossing comes to its edge, so that no slot can open there: shorten, move or turn one of them"
            )
        if abs(costs[0] - costs[1]) > FORCED:
            return ((0, 1), (1, 0))[int(np.argmin(costs))]
        up = crossing.strips[0].axis if self.above is None else self.above
        heights = crossing.course[2].position @ up
        return (0, 1) if heights[0] > heights[-1] else (1, 0)

    def refuse_touching(
        self, members: tuple[int, int], ruled: tuple[RuledStrip, RuledStrip], crossings: Iterable[Crossing]
    ) -> None:
        """Strips with parallel rulings must keep clear of each other but where they cross."""
        a, b = ruled
        if np.linalg.norm(np.cross(a.axis, b.axis)) > PARALLEL or not a.may_meet(b):
            return
        reach = sum(_thickness(self.model.placed[i].strip) for i in members) / 2
        own, other = (a.frame.local(strip.motion(strip.stations)[0]) for strip in (a, b))
        distance = np.hypot(*(own[:, None, :2] - other[None, :, :2]).transpose(2, 0, 1))
        nearest = distance.argmin(axis=1)
        apart = np.abs(other[nearest, 2] - own[:, 2])
        overlap = a.half_width(a.stations) + b.half_width(b.stations)[nearest] > apart
        touch = (distance.min(axis=1) < reach) & overlap
        spacing = float(np.diff(a.stations).max())
        for crossing in crossings:
            p = crossing.at(np.array([0.5]))
            room = reach / np.tan(max(float(p.angle[0]), TOUCHING)) + 2 * spacing
            touch &= np.abs(a.stations - p.first[0, 0]) > 2 * room
        if touch.any():
            names = [self.model.single_name_of(i) for i in members]
            raise InputError(self._touch(names, float(a.stations[int(touch.argmax())])))

    def _touch(self, names: list[str], s: float) -> str:
        return (
            f"{names[0]} and {names[1]} touch along a line at {s:.6g} mm of {names[0]} instead of crossing: move "
            "them apart or turn one of them"
        )


def _thickness(strip: "Strip") -> float:
    """Of all layers, mm."""
    backing = strip.layout.backing
    return strip.sheet.thickness + (0.0 if backing is None else backing.sheet.thickness)


def _turned(pair: tuple[int, int], which: int) -> tuple[int, int]:
    return pair if which == 0 else (pair[1], pair[0])


def _reports(model: "Model", joints: list[Joint]) -> tuple[str, ...]:
    """Shallow angles, and how the model goes together."""
    shallow: dict[tuple[int, int], list[Joint]] = {}
    for joint in joints:
        if joint.angle[0] < SHALLOW:
            shallow.setdefault(joint.members, []).append(joint)
    found = []
    for (i, j), group in shallow.items():
        a, b = model.single_name_of(i), model.single_name_of(j)
        places = ", ".join(f"{joint.slots[0].at:.1f}" for joint in group)
        width = max(
            float(np.max(slot.widths)) for joint in group for slot in joint.slots if slot.widths is not None
        )
        degrees = np.degrees(min(joint.angle[0] for joint in group))
        found.append(
            f"{a} and {b} cross at {degrees:.1f} degrees at {places} mm of {a}: the slots are up to "
            f"{width:.2f} mm wide; a larger angle would hold better"
        )
    told = _assembly(model, joints) if joints else "no two strips cross: interlocking cut no slot"
    return (*found, told)


def _assembly(model: "Model", joints: list[Joint]) -> str:
    """In which order the strips go together, and which cannot simply be pushed on."""
    sides: dict[int, set[str]] = {}
    for joint in joints:
        sides.setdefault(joint.members[1], set()).add(joint.slots[1].side)
    both = [model.single_name_of(i) for i, found in sorted(sides.items()) if len(found) > 1]
    order = ", ".join(dict.fromkeys(model.single_name_of(i) for i in range(len(model.placed))))
    text = f"assembly: {order}; push each strip onto those before it"
    if both:
        text += f"; {', '.join(both)} must be threaded in, being held from both edges"
    return text
