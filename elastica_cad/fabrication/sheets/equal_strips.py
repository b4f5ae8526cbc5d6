"""Strips and pieces that are the same part: cut loops that cover each other, turned about or over."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.drawings.drawing import SAME_MM
from elastica_cad.fabrication.placed_strip import Placed, strip_names
from elastica_cad.fabrication.strip.flat_outline import pace
from elastica_cad.fabrication.strip.strip_layers import Layer
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.boxes import box_about
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.point_distance import distances
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.geometry.paths.segments import Segment, Spline

CENTROID_MM = 0.02
"""Flatness of the loops whose centroids tell which way round parts may fit."""

SAME_SIZE_MM, SIZE_STATIONS = 1e-3, 65
"""Thickness or diameter, mm, that no plane or lathe tells apart, and at how many places strips are compared."""

SAME_BEND_RAD = 1e-4
"""Over the length of a strip: blanks bent so nearly alike are bent over the same form."""

STEEPEST_SLOPE = 100.0
"""No long side rises more than this for each mm along the strip."""

SAMPLES = 6
"""Points a segment by which loops are compared: as many as a cubic has coefficients, and two more."""

_LEANS = 256  # outlines whose leans are kept: parts, shapes and the cut list ask for the same ones

WAYS = ((1, 1), (1, -1), (-1, 1), (-1, -1))
"""Signs of x and y: as it is, turned over along the strip, across it, turned about."""


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


def _same_size(a: Profile | None, b: Profile | None) -> bool:
    """Are both planed or turned alike, or neither?"""
    if a is None or b is None:
        return a is b
    s = np.linspace(0.0, a.length, SIZE_STATIONS)
    return abs(a.length - b.length) < SAME_SIZE_MM and bool(
        np.abs(a(s) - b(np.minimum(s, b.length))).max() < SAME_SIZE_MM
    )


def _same_blank(a: FloatArray | None, b: FloatArray | None) -> bool:
    """Are both flat before they are mounted, or bent beforehand alike?"""
    if a is None or b is None:
        return a is b
    return bool(np.abs(a - b).max() < SAME_BEND_RAD)


@dataclass(frozen=True, eq=False)
class FlatShape:
    """The cut loops of a part, of each of its layers, ready to be compared with many others.

    `size` is the thickness or diameter, along its free part, of one that is planed or turned; `bent` (k,) by how
    much the blank of one is bent beforehand at even steps along it, rad over its length, None where it is flat.
    """

    layers: tuple[Layer, ...]
    size: Profile | None = None
    bent: FloatArray | None = None

    @classmethod
    def of(cls, strip: Strip) -> "FlatShape":
        """That of a strip."""
        rod, bent = strip.rod, None
        if np.any(rod.natural_curvature):
            bent = rod.length * rod.rest_at(np.linspace(0.0, rod.length, SIZE_STATIONS))
        return cls(strip.layers, strip.layout.worked_size, bent)

    def equals(self, other: "FlatShape") -> bool:
        """Would one part serve for both, but for what is engraved? Sheets and all loops must be the same."""
        if not _same_size(self.size, other.size) or not _same_blank(self.bent, other.bent):
            return False
        if len(self.layers) != len(other.layers) or any(
            p.sheet != q.sheet or len(p.holes) != len(q.holes)
            for p, q in zip(self.layers, other.layers, strict=True)
        ):
            return False
        if all(p.runs_as(q) for p, q in zip(self.layers, other.layers, strict=True)):
            return True
        if np.abs(self._size - other._size).max() > SAME_MM * self._size[0]:
            return False
        off = np.abs(self._lean - np.array(WAYS) * other._lean).max(axis=1)
        ways = WAYS if self.bent is None else WAYS[:1]  # a bent blank that is turned is bent another way
        return any(self._covers(other, way) for way, far in zip(ways, off, strict=False) if far < CENTROID_MM)

    @cached_property
    def _size(self) -> FloatArray:
        """Length, box and areas of the loops: cheap to compare."""
        layers = self.layers
        width, height = np.diff(layers[0].outline.bounds, axis=0)[0]
        return np.array([layers[0].outline.length, width, height, *(np.sqrt(layer.area) for layer in layers)])

    @cached_property
    def _lean(self) -> FloatArray:
        """From the middle of the box to the centroid (2,), mm: its signs change as the part is turned."""
        return _lean(self.layers[0].outline)

    def _covers(self, other: "FlatShape", way: tuple[int, int]) -> bool:
        """Do the other's loops, turned and laid onto the middle of this one's, run along these?"""
        middles = [shape.layers[0].outline.bounds.mean(axis=0) for shape in (self, other)]
        shift = middles[0] - way * middles[1]
        for own, others in zip(self.layers, other.layers, strict=True):
            if not _along(own.outline, _samples(others.outline) * way + shift):
                return False
            moved = [(hole.length, _samples(hole) * way + shift) for hole in others.holes]
            for length, points in moved:
                near = [hole for hole in own.holes if abs(hole.length - length) < 10 * SAME_MM]
                if not any(_along(hole, points) for hole in near):
                    return False
        return True


@lru_cache(maxsize=_LEANS)
def _lean(outline: Path) -> FloatArray:
    """From the middle of its box to its centroid (2,), mm."""
    x, y = outline.points(CENTROID_MM).T
    x1, y1 = np.roll(x, -1), np.roll(y, -1)
    cross = x * y1 - x1 * y
    centroid = np.array([((x + x1) * cross).sum(), ((y + y1) * cross).sum()]) / (3 * cross.sum())
    return np.asarray(centroid - outline.bounds.mean(axis=0), dtype=float)


def _samples(path: Path) -> FloatArray:
    """Points along every segment of a path."""
    return np.concatenate([segment.at(np.linspace(0.0, 1.0, SAMPLES + 1)[:-1]) for segment in path.segments])


def _along(path: Path, points: FloatArray) -> bool:
    """Do points lie within `SAME_MM` of a path?"""
    near = np.full(len(points), np.inf)
    for segment in path.segments:
        low, high = _box(segment)
        inside = np.flatnonzero(
            np.all((points > low - SAME_MM) & (points < high + SAME_MM), axis=1) & (near > SAME_MM)
        )
        if inside.size:
            near[inside] = np.minimum(near[inside], _off(segment, points[inside]))
    return bool(near.max() <= SAME_MM)


def _off(segment: Segment, points: FloatArray) -> FloatArray:
    """Distances (n,) of points from a segment; where they are too large to count, no more than that is sure."""
    even = pace(segment) if isinstance(segment, Spline) else None
    if even is None or not isinstance(segment, Spline):
        return distances(segment, points)
    # straight across where x runs evenly: no less than the distance, and the same in the end
    t = np.clip((points[:, 0] - even[0]) / even[1], *segment.curve.domain)
    off = np.asarray(np.hypot(*(segment.curve.evaluate(t) - points).T), dtype=float)
    unsure = (off > SAME_MM) & (off < STEEPEST_SLOPE * SAME_MM)
    if unsure.any():
        off[unsure] = distances(segment, points[unsure])
    return off


def _box(segment: Segment) -> FloatArray:
    """A box around a segment, of its control points where it is a spline."""
    return box_about(segment.curve.control_points) if isinstance(segment, Spline) else segment.bounds
