"""Slots in strips that cross in space.

Slots go half way into each strip, so that the strips slide into each other.
"""

from collections.abc import Hashable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations, product
from typing import Annotated, Literal, TypeAlias
from weakref import WeakKeyDictionary

import numpy as np

from elastica_cad._text import in_runs
from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import direction, is_series, is_whole, numbers, require_number
from elastica_cad.declared import Option, require_declared
from elastica_cad.defaults import CLEARANCE
from elastica_cad.errors import Angle, InputError, Length, Listed, note, sentences
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.plane_points import left_of, norm, unit
from elastica_cad.model.crossings import PARALLEL_RAD, Crossing, RuledStrip, strip_crossings, strips_may_meet
from elastica_cad.strip.pieces import cut_key
from elastica_cad.strip.slots import Relief, Slot
from elastica_cad.strip.strip import (
    Placed,
    Strip,
    distinct_names,
    engraved_labels,
    require_placed,
    strip_names,
)

CLOSE_MM = 1e-6
"""Accuracy, mm, of the points at which faces of two strips meet. Coordinates in files have the same
accuracy."""


def _bent_slot_width(
    ruled: RuledStrip,
    other: RuledStrip,
    rows: FloatArray,
    mates: FloatArray,
    *,
    thickness: tuple[float, float],
) -> FloatArray:
    """Return the widths (n,), mm, of a slot in strip `ruled` through which the bent strip `other` fits.

    For flat strips, this width is `slot_width` without clearance. A strip of curvature kappa deviates from its
    tangent by (w / 2)^2 kappa / 2 at the sides of a slot of width w. If the strips cross at the angle phi, this
    deviation shifts the faces of the other strip by cot(phi) times as much.

    Parameters
    ----------
    ruled, other : RuledStrip
    rows, mates : (n, 2) array
        Centre line of the slot in the flat patterns of `ruled` and of `other`, mm.
    thickness : (float, float)
        Thickness of `ruled` and of `other`, mm.

    Returns
    -------
    (n,) array
        Widths. A width is 0 where the faces do not meet, because the strips curve away from each other near a
        shallow crossing.
    """
    along = unit(np.gradient(rows, np.arange(len(rows)), axis=0, edge_order=2))
    across = left_of(along)
    ways = across[:, :1] * ruled.motion(rows[:, 0])[1] + across[:, 1:] * ruled.axis
    tangents = other.motion(mates[:, 0])[1]
    # derivatives (n, 3, 3) of the distance between points of both strips by the unknowns x below
    slopes = np.stack([ways, -tangents, -np.broadcast_to(other.axis, tangents.shape)], axis=2)
    inverse, rows, mates, across = (
        np.tile(matrix, (4, *[1] * (matrix.ndim - 1)))
        for matrix in (np.linalg.inv(slopes), rows, mates, across)
    )
    # one block of n rows for each pair of a face of `ruled` and a face of `other`
    z = np.repeat(list(product((-0.5, 0.5), repeat=2)), len(along), axis=0) * thickness
    # the unknowns x are the distance across the slot, and the distances along and across strip `other`
    x = np.zeros((len(rows), 3))
    # bound on the unknowns, which would diverge if the faces do not meet
    farthest = ruled.length + other.length
    for _ in range(30):
        here = _points_at_height(ruled, rows + x[:, :1] * across, z[:, :1])
        there = _points_at_height(other, mates + x[:, 1:], z[:, 1:])
        error = np.abs(here - there).max(axis=1)
        if not (error > CLOSE_MM).any():
            break
        x -= (inverse @ (here - there)[:, :, None])[:, :, 0]
        np.clip(x, -farthest, farthest, out=x)
    reach = np.where(error <= CLOSE_MM, np.abs(x[:, 0]), 0.0)
    return np.asarray(2 * reach.reshape(4, -1).max(axis=0), dtype=float)


def _points_at_height(strip: RuledStrip, flat: FloatArray, height: FloatArray) -> FloatArray:
    # points in space (n, 3) at heights (n, 1), mm, above points (n, 2) of the flat pattern
    points, tangents = strip.in_plane(flat[:, 0])
    return strip.frame.point(points + height * left_of(tangents)) + flat[:, 1:] * strip.axis


Fit = Literal["exact", "paper"]

SHALLOW_RAD = np.radians(15.0)
"""Angle between strips, rad, below which a warning is added, because slots are over 7 sheet thicknesses wide."""

TOUCHING_RAD = np.radians(1.0)
"""Least angle between slotted strips, rad. At smaller angles, slots are over 100 sheet thicknesses wide."""

Members: TypeAlias = tuple[int, int]
"""Indices of two strips of a model."""

PLACE_DIGITS, TURN_DIGITS = 9, 12
"""Decimals to which positions (mm) and unit vectors are compared, because copies differ by rounding."""


@dataclass(frozen=True, eq=False)
class Joint:
    """Two strips slotted into each other.

    Attributes
    ----------
    members : (int, int)
        Indices of the strips in the model.
    slots : (Slot, Slot)
        Slots of the strips, in the order of `members`.
    angle : (float, float)
        Smallest and largest angle between the strips along the crossing, rad.
    position : (3,) array
        Common inner end of both slots, mm.
    fit : "exact" or "paper"
        Formula that was used for the width of the slots.
    """

    members: tuple[int, int]
    slots: tuple[Slot, Slot]
    angle: tuple[float, float]
    position: FloatArray
    fit: Fit = "exact"


def slot_width(
    angle: FloatArray, *, own: float, other: float, clearance: float, fit: Fit = "exact"
) -> FloatArray:
    """Return the width, mm, of a slot in a sheet of thickness `own` for a sheet of thickness `other`.

    At the angle phi (rad), the width is other / sin(phi) + own |cot(phi)| + clearance. The second term is
    needed because the slot is cut perpendicular to the sheet. `fit="paper"` omits the second term (paper,
    section 9.1).
    """
    angle = numbers(angle, "slot angle")
    for what, size in (("own", own), ("other", other), ("clearance", clearance)):
        require_number(size, f"slot {what}", "mm")
    if not np.all(np.sin(angle) > 0):
        raise InputError(
            "the angle between strips at a slot is not between 0 and pi rad: leave out slots of parallel strips"
        )
    width = other / np.sin(angle) + clearance
    return width + own * np.abs(np.cos(angle)) / np.sin(angle) if fit == "exact" else width


@dataclass(frozen=True, eq=False)
class InterlockedStrips:
    """Result of `interlock`: the placed strips with their slots, the joints, and messages."""

    placed: tuple[Placed, ...]
    joints: tuple[Joint, ...]
    reports: tuple[str, ...]


def interlock(
    placed: Sequence[Placed],
    *,
    clearance: Annotated[float, Option("Allowance added to the width of slots.", "mm", least=0)] = CLEARANCE,
    fit: Annotated[Fit, Option("Width of slots: for the exact angle, or as in the paper.")] = "exact",
    relief: Annotated[Relief, Option("Shape of the inner ends of slots.")] = "square",
    pairs: Iterable[tuple[int, int]] | None = None,
    above: Annotated[
        ArrayLike | None,
        Option("Direction from which strips are pushed on.", written=tuple[float, float, float]),
    ] = None,
) -> InterlockedStrips:
    """Cut slots where bent strips cross, half way into each strip and from opposite sides.

    The crossings of the strips are computed exactly, as intersections of ruled surfaces. The width of a slot
    follows the angle between the strips along the crossing. Each strip is cut from the edge that the crossing
    reaches. If both edges are about equally near, the slot of the earlier strip opens towards `above`, and the
    later strip is pushed on from there. Both slots end in the middle of the crossing, where the strips rest on
    each other. Tabs are not checked, so keep other strips away from tabs. A crossing that reaches the end of a
    strip instead of an edge is an error.

    Parameters
    ----------
    placed : sequence of Placed
        In the order of assembly.
    clearance : float
        Amount added to the width of every slot, mm.
    fit : "exact" or "paper"
        "paper" is the smaller width h / sin(phi), which is too narrow at angles below 60 degrees.
    relief : "square" or "round"
        Shape of the inner ends of the slots.
    pairs : iterable of (int, int), optional
        Pairs of strips to slot, by index; by default all strips that cross.
    above : (3,) array_like, optional
        Direction in space. The default is the direction of the earlier strip's rulings.
    """
    require_declared(interlock, locals())
    placed = require_placed(placed)
    up = None if above is None else direction(above, "above")
    ruled = [RuledStrip(p.strip.rod.curve, p.frame, p.strip.width) for p in placed]
    names = distinct_names(placed)
    cutter = _Cutter(placed, ruled, names, engraved_labels(placed), clearance, fit, relief, up)
    joints: list[Joint] = []
    meeting = strips_may_meet(ruled)
    for i, j in _checked_pairs(len(placed), pairs):
        if meeting[i, j]:
            joints += cutter.joints((i, j))
    slots: list[list[Slot]] = [[] for _ in placed]
    for joint in joints:
        for member, slot in zip(joint.members, joint.slots, strict=True):
            slots[member].append(slot)
    drawn: dict[Hashable, Strip] = {}
    slotted = (
        _with_slots(*each, drawn) for each in zip(placed, map(tuple, slots), strip_names(placed), strict=True)
    )
    return InterlockedStrips(tuple(slotted), tuple(joints), _messages(names, joints))


_joined: WeakKeyDictionary[Placed, WeakKeyDictionary[Placed, tuple[object, tuple[Joint, ...]]]] = (
    WeakKeyDictionary()
)
"""Cache of joints for pairs of placed strips, with the options that were used."""

_slotted: WeakKeyDictionary[Placed, tuple[tuple[Slot, ...], Placed]] = WeakKeyDictionary()
"""Cache of slotted strips. An unchanged strip stays the same object and keeps its results."""


def _with_slots(placed: Placed, slots: tuple[Slot, ...], name: str, drawn: dict[Hashable, Strip]) -> Placed:
    """Return the strip with its slots. `drawn` has the first strip of each cut pattern, whose outline is shared."""
    # slots with which the strip was last cut, and the result
    known, slotted = _slotted.get(placed, (None, placed))
    if known != slots:
        strip = replace(placed.strip, slots=(*placed.strip.slots, *slots)) if slots else placed.strip
        first = drawn.setdefault(cut_key(strip), strip)
        try:
            if not first.outline.closed:
                raise InputError(
                    "the slots cut the strip in two. Move the slots apart, or make the strip wider"
                )
        except InputError as error:
            raise error.at(strip=name) from None
        slotted = placed.with_strip(strip.cut_as(first)) if slots else placed
        _slotted[placed] = slots, slotted
    return slotted


def _checked_pairs(count: int, pairs: Iterable[Members] | None) -> list[Members]:
    """Return the pairs of indices i < j without duplicates; all pairs by default."""
    if pairs is None:
        return list(combinations(range(count), 2))
    checked = set[Members]()
    for pair in tuple(pairs) if is_series(pairs) else (pairs,):
        two = isinstance(pair, Sequence) and len(pair) == 2 and all(map(is_whole, pair))
        if not two or pair[0] == pair[1] or not all(0 <= place < count for place in pair):
            raise InputError(
                f"the pair of strips is {pair!r}: give the numbers of two different strips, 0 to {count - 1}"
            )
        checked.add((min(pair), max(pair)))
    return sorted(checked)


def place_between(first: Frame, second: Frame) -> tuple[float, ...]:
    """Return the rounded position of a frame relative to another frame, for comparing pairs of strips."""
    origin = np.round(first.local(second.origin), PLACE_DIGITS) + 0.0
    axes = np.round(second.axes[:2] @ first.axes.T, TURN_DIGITS) + 0.0
    return (*origin.tolist(), *axes.ravel().tolist())


@dataclass(frozen=True, eq=False)
class _Cutter:
    """Makes the joints of pairs of strips. `marks` are the names engraved beside slots, by label."""

    placed: tuple[Placed, ...]
    ruled: Sequence[RuledStrip]
    names: tuple[str, ...]
    marks: Mapping[str, str]
    clearance: float
    fit: Fit
    relief: Relief
    above: FloatArray | None
    crossed: dict[Hashable, tuple[list[Joint], Frame]] = field(default_factory=dict)
    """Joints already made for equal pairs of strips, with the frame of the earlier strip."""

    def joints(self, members: Members) -> tuple[Joint, ...]:
        """Return the joints of a pair, which are stored for each request.

        Equal strips in the same relative position have the same crossings, which are then only moved.
        """
        above = None if self.above is None else tuple(self.above.tolist())
        request = members, [self.names[i] for i in members], self.clearance, self.fit, self.relief, above
        first, second = (self.placed[i] for i in members)
        known = _joined.setdefault(first, WeakKeyDictionary())
        before, joints_of_pair = known.get(second, (None, ()))
        if before != request:
            frame = first.frame
            up = (
                None if self.above is None else tuple(np.round(frame.axes @ self.above, TURN_DIGITS).tolist())
            )
            alike = cut_key(first.strip), cut_key(second.strip), *place_between(frame, second.frame), up
            if alike not in self.crossed:
                crossings = strip_crossings(*(self.ruled[i] for i in members))
                self.refuse_touching(members, crossings)
                self.crossed[alike] = [self.joint(members, crossing) for crossing in crossings], frame
            joints, drawn = self.crossed[alike]
            joints_of_pair = tuple(self.repeated(joint, members, drawn, frame) for joint in joints)
            known[second] = request, joints_of_pair
        return joints_of_pair

    def repeated(self, joint: Joint, members: Members, drawn: Frame, frame: Frame) -> Joint:
        """Copy a joint to the strips with the indices `members`, which cross like the strips of the joint.

        `drawn` and `frame` are the frames of the joint's first strip and of the first strip of `members`.
        """
        first, second = (
            replace(slot, mate=self.marks[self.placed[mate].strip.label])
            for slot, mate in zip(joint.slots, members[::-1], strict=True)
        )
        position = frame.point(drawn.local(joint.position))
        return replace(joint, members=members, slots=(first, second), position=position)

    def joint(self, members: Members, crossing: Crossing) -> Joint:
        """Return the joint at a crossing, with a slot in each strip from its edge to the middle.

        `repeated` adds the names of the mates. Strips that only touch are refused.
        """
        points = crossing.course[2]
        low, high = float(points.angle.min()), float(points.angle.max())
        if low < TOUCHING_RAD:
            raise InputError(self._touch(members, float(points.first[points.angle.argmin(), 0])))
        slots = []
        for which, last in enumerate(self._cut_ends(members, crossing)):
            # points of the slot from its inner end to the edge, at most 1.5 mm apart if possible
            p = crossing.at(crossing.evenly(crossing.middle, last, 1.5))
            # first this strip, then its mate
            way = 1 - 2 * which
            rows, mates = (p.first, p.second)[::way]
            thickness, other = (strip_thickness(self.placed[i].strip) for i in members[::way])
            widths = slot_width(p.angle, own=thickness, other=other, clearance=self.clearance, fit=self.fit)
            if self.fit == "exact":
                sheet, mate = crossing.strips[::way]
                bent = _bent_slot_width(sheet, mate, rows, mates, thickness=(thickness, other))
                widths = np.maximum(widths, bent + self.clearance)
            if self.clearance >= float(self.placed[members[which]].strip.width(rows[0, 0])):
                raise InputError(
                    "a clearance of {clearance:g} is more than the width of {names} at {rows:.6g} from its "
                    "start: reduce the clearance",
                    clearance=Length(self.clearance),
                    names=self.names[members[which]],
                    rows=Length(rows[0, 0]),
                )
            side: Literal["upper", "lower"] = "upper" if rows[-1, 1] > rows[0, 1] else "lower"
            slots.append(Slot.along(rows, widths, side=side, relief=self.relief))
            middle = p.position[0]
        return Joint(members, (slots[0], slots[1]), (low, high), middle, self.fit)

    def _cut_ends(self, members: Members, crossing: Crossing) -> list[float]:
        """Return the parameter of the crossing at the edge from which each strip is cut.

        If both ends of the crossing are possible, the slot of the earlier strip opens towards `above` or, by
        default, along its rulings, unless both slots together are much shorter otherwise.
        """
        # the earlier strip is cut from the start of the crossing and the later one from its end, or vice versa
        # the cost of a way is the length of both slots beyond the crossing
        ways, costs = [], []
        for ends in ((0, 1), (1, 0)):
            exits = [crossing.beyond(which, end) for which, end in enumerate(ends)]
            ways.append([np.inf if x is None else x for x in exits])
            costs.append(sum(abs(x - end) for x, end in zip(ways[-1], ends, strict=True)))
        if not np.isfinite(min(costs)):
            raise InputError(
                "{names} and {names_2} cross {s:.6g} from the start of {names}, but one of these strips ends too "
                "close to the crossing for a slot. Shorten, move or turn one of the strips",
                names=self.names[members[0]],
                names_2=self.names[members[1]],
                s=Length(crossing.at(np.array([0.5])).first[0, 0]),
            )
        # the costs are fractions of the length of the crossing
        if abs(costs[0] - costs[1]) > 0.5:
            return ways[np.argmin(costs)]
        up = crossing.strips[0].axis if self.above is None else self.above
        heights = crossing.course[2].position @ up
        return ways[0 if heights[0] > heights[-1] else 1]

    def refuse_touching(self, members: Members, crossings: Iterable[Crossing]) -> None:
        """Refuse strips with parallel rulings that touch anywhere except at their crossings."""
        a, b = (self.ruled[i] for i in members)
        if np.linalg.norm(np.cross(a.axis, b.axis)) > PARALLEL_RAD:
            return
        # closer middle surfaces touch; points (n, 3) are in the frame of `a`, whose z axis is along the rulings
        reach = sum(strip_thickness(self.placed[i].strip) for i in members) / 2
        nodes, other = (a.frame.local(strip.motion(strip.stations)[0]) for strip in (a, b))
        distance = norm(nodes[:, None, :2] - other[None, :, :2])
        nearest = distance.argmin(axis=1)
        apart = np.abs(other[nearest, 2] - nodes[:, 2])
        overlap = a.half_width(a.stations) + b.half_width(b.stations)[nearest] > apart
        touch = (distance.min(axis=1) < reach) & overlap
        spacing = float(np.diff(a.stations).max())
        for crossing in crossings:
            # strips that cross at a small angle are close to each other over a long distance
            p = crossing.at(np.array([0.5]))
            room = reach / np.tan(max(float(p.angle[0]), TOUCHING_RAD)) + 2 * spacing
            touch &= np.abs(a.stations - p.first[0, 0]) > 2 * room
        if touch.any():
            raise InputError(self._touch(members, float(a.stations[touch.argmax()])))

    def _touch(self, members: Members, s: float) -> str:
        return note(
            "{a} and {b} do not cross {s} from the start of {a}, but touch along a line: move the strips "
            "apart, or turn one of them",
            a=self.names[members[0]], b=self.names[members[1]], s=Length(s),
        )  # fmt: skip


def strip_thickness(strip: Strip) -> float:
    """Return the total thickness of all layers, mm."""
    backing = strip.layout.backing
    return strip.sheet.thickness + (0.0 if backing is None else backing.sheet.thickness)


def _messages(names: Sequence[str], joints: list[Joint]) -> tuple[str, ...]:
    """Return messages on crossings at small angles, and on the order of assembly."""
    if not joints:
        return (note("no strips cross, so no slots were cut"),)
    shallow: dict[Members, list[Joint]] = {}
    # edges from which the slots of each later strip enter
    sides: dict[int, set[str]] = {}
    for joint in joints:
        sides.setdefault(joint.members[1], set()).add(joint.slots[1].side)
        if joint.angle[0] < SHALLOW_RAD:
            shallow.setdefault(joint.members, []).append(joint)
    messages = []
    for (i, j), group in shallow.items():
        a, b = names[i], names[j]
        places = Listed(Length(joint.slots[0].at) for joint in group)
        width = max(
            float(np.max(slot.widths)) for joint in group for slot in joint.slots if slot.widths is not None
        )
        messages.append(note(
            "{a} and {b} cross at an angle of {degrees:.3g}, {places} from the start of {a}, so the slots "
            "are up to {width} wide: increase the angle for a better hold",
            a=a, b=b, degrees=Angle(min(joint.angle[0] for joint in group)), places=places, width=Length(width),
        ))  # fmt: skip
    order = [
        note(
            "assemble in the order {order}: push each strip onto the strips before it",
            order=", ".join(in_runs(names)),
        )
    ]
    if both := [names[i] for i, edges in sorted(sides.items()) if len(edges) > 1]:
        order.append(note(
            "thread {strips} into place, because their slots enter from both edges", strips=", ".join(in_runs(both))
        ))  # fmt: skip
    return (*messages, sentences(order))
