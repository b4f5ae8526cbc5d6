"""Strips and pieces that are the same part: cut loops that cover each other, turned about or over."""

from collections.abc import Sequence
from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any

import numpy as np

from elastica_cad._equality import value_key
from elastica_cad._types import FloatArray
from elastica_cad.fabrication.drawings.drawing import SAME_MM
from elastica_cad.fabrication.placed_strip import Placed, strip_names
from elastica_cad.fabrication.slots.slot import Slot
from elastica_cad.fabrication.strip.strip_layers import Layer
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.point_distance import distances

SAME_SIZE_MM, SIZE_STATIONS = 1e-3, 65
"""Thickness or diameter, mm, that no plane or lathe tells apart, and at how many places strips are compared."""

SAME_BEND_RAD = 1e-4
"""Over the length of a strip: blanks bent so nearly alike are bent over the same form."""

SLOT_DIGITS = 6
"""Of the sizes of slots, mm, by which strips are cut alike: those of copies in other places differ by rounding."""

SAMPLES = 6
"""Points a segment by which loops are compared: as many as a cubic has coefficients, and two more."""

WAYS = ((1, 1), (1, -1), (-1, 1), (-1, -1))
"""Signs of x and y: as it is, turned over along the strip, across it, turned about."""


def cut_key(strip: Strip) -> Any:
    """The same for strips that are made and cut alike, whatever their labels and the names of their mates."""
    slots = [
        (slot.side, slot.relief, slot.depth is None, *np.round(_sizes(slot), SLOT_DIGITS).tolist())
        for slot in strip.slots
    ]
    own = [getattr(strip, one.name) for one in fields(Strip) if one.name not in ("label", "slots")]
    return value_key((own, slots))


def _sizes(slot: Slot) -> FloatArray:
    """All sizes of a slot, mm; its lean in rad."""
    paths = [np.ravel(part) for part in (slot.path, slot.widths) if part is not None]
    return np.concatenate([[slot.at, slot.width, slot.depth or 0.0, slot.lean], *paths])


@dataclass(frozen=True, eq=False)
class EqualStrips:
    """Equal strips of a model: one part, cut as often as there are `members`.

    Attributes
    ----------
    strip : Strip
        The first of them, whose drawing is cut.
    name : str
        Its label, or "strip 3" after its place in the model.
    members : tuple of int
        Places in the model.
    """

    strip: Strip
    name: str
    members: tuple[int, ...]

    @property
    def count(self) -> int:
        """How many are cut."""
        return len(self.members)


def group_equal_strips(placed: Sequence[Placed]) -> tuple[EqualStrips, ...]:
    """The strips grouped by the part that is cut for them, in order of first appearance.

    Strips are equal where sheet, label and all cut loops are, after turning the part about or over.
    """
    found: list[tuple[FlatShape, Strip, list[int]]] = []
    known: dict[int, list[int]] = {}  # one strip in several places need not be compared again
    for index, strip in enumerate(one.strip for one in placed):
        if id(strip) not in known:
            shape = FlatShape.of(strip)
            alike = next(
                (
                    members
                    for first, other, members in found
                    if _same_marks(other, strip) and first.equals(shape)
                ),
                None,
            )
            if alike is None:
                alike = []
                found.append((shape, strip, alike))
            known[id(strip)] = alike
        known[id(strip)].append(index)
    names = strip_names(placed)
    return tuple(EqualStrips(strip, names[members[0]], tuple(members)) for _, strip, members in found)


def count_shapes(parts: Sequence[EqualStrips]) -> int:
    """How many shapes are cut for these parts, whatever is engraved on them."""
    found: list[FlatShape] = []
    for part in parts:
        shape = FlatShape.of(part.strip)
        if not any(shape.equals(other) for other in found):
            found.append(shape)
    return len(found)


def _same_marks(a: Strip, b: Strip) -> bool:
    """Is the same engraved on both?"""
    mates = [sorted(slot.mate for slot in strip.slots) for strip in (a, b)]
    return a.label == b.label and mates[0] == mates[1]


def _near(a: FloatArray | None, b: FloatArray | None, room: float) -> bool:
    """Are both none, or rows of numbers no farther apart than this?"""
    if a is None or b is None:
        return a is b
    return bool(np.abs(a - b).max() < room)


@dataclass(frozen=True, eq=False)
class FlatShape:
    """The cut loops of a part, of each of its layers, ready to be compared with many others.

    `size` (k,) is the thickness or diameter at even steps along it of one that is planed or turned, and `bent` (k,)
    is how much the blank is bent beforehand there, rad over its length; None for the others.
    """

    layers: tuple[Layer, ...]
    size: FloatArray | None = None
    bent: FloatArray | None = None

    @classmethod
    def of(cls, strip: Strip) -> "FlatShape":
        """That of a strip."""
        rod, size = strip.rod, strip.layout.worked_size
        s = np.linspace(0.0, rod.length, SIZE_STATIONS)
        bent = rod.length * rod.rest_at(s) if np.any(rod.natural_curvature) else None
        return cls(strip.layers, None if size is None else size(s), bent)

    def equals(self, other: "FlatShape") -> bool:
        """Would one part serve for both, but for what is engraved? Sheets and all loops must be the same."""
        if not (_near(self.size, other.size, SAME_SIZE_MM) and _near(self.bent, other.bent, SAME_BEND_RAD)):
            return False
        if len(self.layers) != len(other.layers) or any(
            p.sheet != q.sheet or len(p.holes) != len(q.holes)
            for p, q in zip(self.layers, other.layers, strict=True)
        ):
            return False
        if np.abs(self._size - other._size).max() > SAME_MM * self._size[0]:
            return False
        ways = WAYS if self.bent is None else WAYS[:1]  # a bent blank that is turned is bent another way
        return any(self._covers(other, way) for way in ways)

    @cached_property
    def _size(self) -> FloatArray:
        """Length, box and areas of the loops: cheap to compare."""
        layers = self.layers
        width, height = np.diff(layers[0].outline.bounds, axis=0)[0]
        return np.array([layers[0].outline.length, width, height, *(np.sqrt(layer.area) for layer in layers)])

    def _covers(self, other: "FlatShape", way: tuple[int, int]) -> bool:
        """Do the other's loops, turned and laid onto the middle of this one's, run along these?"""
        middles = [shape.layers[0].outline.bounds.mean(axis=0) for shape in (self, other)]
        shift = middles[0] - way * middles[1]
        for own, others in zip(self.layers, other.layers, strict=True):
            if not _along(own.outline, _samples(others.outline) * way + shift):
                return False
            for hole in others.holes:
                points, middle = _samples(hole) * way + shift, hole.bounds.mean(axis=0) * way + shift
                near = [
                    one for one in own.holes if np.abs(one.bounds.mean(axis=0) - middle).max() < 10 * SAME_MM
                ]
                if not any(_along(one, points) for one in near):
                    return False
        return True


def _samples(path: Path) -> FloatArray:
    """Points along every segment of a path."""
    return np.concatenate([segment.at(np.linspace(0.0, 1.0, SAMPLES + 1)[:-1]) for segment in path.segments])


def _along(path: Path, points: FloatArray) -> bool:
    """Do points lie within `SAME_MM` of a path?"""
    left = points
    for segment in path.segments:
        low, high = segment.bounds
        inside = np.flatnonzero(np.all((left > low - SAME_MM) & (left < high + SAME_MM), axis=1))
        left = np.delete(left, inside[distances(segment, left[inside]) <= SAME_MM], axis=0)
    return not left.size
