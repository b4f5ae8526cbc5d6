"""When two strips are the same part: cut loops that cover each other, turned about or over."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.flat import pace
from elastica_cad.fabrication.strip import Strip
from elastica_cad.geometry import Path, Segment, Spline
from elastica_cad.geometry.nearest import distances

__all__ = ["FlatShape"]

SAME = 1e-6
"""Loops that stay this near to each other (mm) are one."""

ROUGH = 0.02
"""Flatness of the loops whose centroids tell which way round parts may fit, mm."""

STEEP = 100.0
"""No long side rises more than this for each mm along the strip."""

SAMPLES = 6
"""Points a segment by which loops are compared."""

WAYS = ((1, 1), (1, -1), (-1, 1), (-1, -1))
"""Signs of x and y: as it is, turned over along the strip, across it, turned about."""


@dataclass(frozen=True, eq=False)
class FlatShape:
    """A strip's cut loops, ready to be compared with many others."""

    strip: Strip

    def equals(self, other: "FlatShape") -> bool:
        """Would one part serve for both? Sheet, style, label, mates and all loops must be the same."""
        a, b = self.strip, other.strip
        if a is b:
            return True
        mates = [sorted(slot.mate for slot in strip.slots) for strip in (a, b)]
        if a.label != b.label or a.sheet != b.sheet or mates[0] != mates[1] or len(a.layers) != len(b.layers):
            return False
        if any(
            p.sheet != q.sheet or len(p.holes) != len(q.holes)
            for p, q in zip(a.layers, b.layers, strict=True)
        ):
            return False
        if np.abs(self._size - other._size).max() > SAME * self._size[0]:
            return False
        off = np.abs(self._lean - np.array(WAYS) * other._lean).max(axis=1)
        return any(self._covers(other, way) for way, far in zip(WAYS, off, strict=True) if far < ROUGH)

    @cached_property
    def _size(self) -> FloatArray:
        """Length, box and areas of the loops: cheap to compare."""
        layers = self.strip.layers
        width, height = np.diff(layers[0].outline.bounds, axis=0)[0]
        return np.array([layers[0].outline.length, width, height, *(np.sqrt(layer.area) for layer in layers)])

    @cached_property
    def _lean(self) -> FloatArray:
        """From the middle of the box to the centroid (2,), mm: its signs change as the part is turned."""
        x, y = self.strip.outline.points(ROUGH).T
        x1, y1 = np.roll(x, -1), np.roll(y, -1)
        cross = x * y1 - x1 * y
        centroid = np.array([((x + x1) * cross).sum(), ((y + y1) * cross).sum()]) / (3 * cross.sum())
        return np.asarray(centroid - self.strip.outline.bounds.mean(axis=0), dtype=float)

    def _covers(self, other: "FlatShape", way: tuple[int, int]) -> bool:
        """Do the other's loops, turned and laid onto the middle of this one's, run along these?"""
        middles = [shape.strip.outline.bounds.mean(axis=0) for shape in (self, other)]
        shift = middles[0] - way * middles[1]
        for own, others in zip(self.strip.layers, other.strip.layers, strict=True):
            if not _along(own.outline, _samples(others.outline) * way + shift):
                return False
            moved = [(hole.length, _samples(hole) * way + shift) for hole in others.holes]
            for length, points in moved:
                near = [hole for hole in own.holes if abs(hole.length - length) < 10 * SAME]
                if not any(_along(hole, points) for hole in near):
                    return False
        return True


def _samples(path: Path) -> FloatArray:
    """Points along every segment of a path."""
    return np.concatenate([segment.at(np.linspace(0.0, 1.0, SAMPLES + 1)[:-1]) for segment in path.segments])


def _along(path: Path, points: FloatArray) -> bool:
    """Do points lie within 1e-6 mm of a path?"""
    near = np.full(len(points), np.inf)
    for segment in path.segments:
        low, high = _box(segment)
        inside = np.flatnonzero(
            np.all((points > low - SAME) & (points < high + SAME), axis=1) & (near > SAME)
        )
        if inside.size:
            near[inside] = np.minimum(near[inside], _off(segment, points[inside]))
    return bool(near.max() <= SAME)


def _off(segment: Segment, points: FloatArray) -> FloatArray:
    """Distances (n,) of points from a segment; where they are too large to count, no more than that is sure."""
    even = pace(segment) if isinstance(segment, Spline) else None
    if even is None or not isinstance(segment, Spline):
        return distances(segment, points)
    # straight across where x runs evenly: no less than the distance, and the same in the end
    t = np.clip((points[:, 0] - even[0]) / even[1], *segment.curve.domain)
    off = np.asarray(np.hypot(*(segment.curve.evaluate(t) - points).T), dtype=float)
    unsure = (off > SAME) & (off < STEEP * SAME)
    if unsure.any():
        off[unsure] = distances(segment, points[unsure])
    return off


def _box(segment: Segment) -> FloatArray:
    """A box around a segment, of its control points where it is a spline."""
    if not isinstance(segment, Spline):
        return segment.bounds
    p = segment.curve.control_points
    return np.array([p.min(axis=0), p.max(axis=0)])
