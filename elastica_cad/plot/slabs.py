"""A flat pattern with its holes and slots as trapezoids, to be bent and painted."""

from collections.abc import Sequence

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import chord_errors
from elastica_cad.geometry.running_sums import numbers_in_groups

APART_MM = 1e-7
"""Stations nearer than this are one: slabs between them could not be seen."""


def trapezoids(
    loops: Sequence[Path], stations: FloatArray, tolerance: float, *, blur: float = 0.0
) -> FloatArray:
    """What lies inside an odd number of loops, cut along x at its corners and at `stations`.

    Parameters
    ----------
    loops : sequence of Path
        Closed; outline and holes in any direction.
    stations : (k,) array
        Further places where the trapezoids end, mm.
    tolerance : float
        Of the polygons that stand for curved loops, mm.
    blur : float
        How far their sides may leave corners out besides, mm: there are fewer trapezoids then.

    Returns
    -------
    (n, 2, 3) array
        x, lower y and upper y at the left and at the right side of each, mm.

    Examples
    --------
    >>> plate = [Path.rectangle(10.0, 4.0), Path.rectangle(2.0, 2.0, corner=(4.0, 1.0))]
    >>> found = trapezoids(plate, np.array([]), 0.1)
    >>> width, height = np.diff(found[..., 0], axis=1)[:, 0], (found[..., 2] - found[..., 1]).mean(axis=1)
    >>> len(found), float(width @ height)
    (4, 36.0)
    """
    polygons = [loop.points(tolerance) for loop in loops]
    if blur > 0:
        polygons = _blurred(polygons, blur)
    ends = np.concatenate([np.stack([p, np.roll(p, -1, axis=0)], axis=1) for p in polygons])
    ends = ends[np.abs(ends[:, 1, 0] - ends[:, 0, 0]) > APART_MM]
    order = np.argsort(ends[..., 0], axis=1)
    left, right = np.moveaxis(np.take_along_axis(ends, order[..., None], axis=1), 1, 0)
    slope = (right[:, 1] - left[:, 1]) / (right[:, 0] - left[:, 0])
    low, high = left[:, 0].min(), right[:, 0].max()
    cuts = np.unique(
        np.concatenate([left[:, 0], right[:, 0], stations[(stations > low) & (stations < high)]])
    )
    cuts = cuts[np.concatenate([[True], np.diff(cuts) > APART_MM])]
    middles = (cuts[:-1] + cuts[1:]) / 2
    # each line goes through all slabs from one to another
    first = np.searchsorted(middles, left[:, 0], side="right")
    count = np.searchsorted(middles, right[:, 0], side="left") - first
    line = np.repeat(np.arange(len(left)), count)
    slab = numbers_in_groups(count) + np.repeat(first, count)
    order = np.lexsort((left[line, 1] + slope[line] * (middles[slab] - left[line, 0]), slab))
    # loops are closed: every slab has its lines in pairs, below and above what lies inside
    below, above, slab = line[order[0::2]], line[order[1::2]], slab[order[0::2]]
    # between the same two lines it is one trapezoid, up to the next station
    ends_here = np.zeros(len(cuts), dtype=bool)
    ends_here[np.searchsorted(cuts, stations, side="right") - 1] = True
    along = np.lexsort((slab, above, below))
    below, above, slab = below[along], above[along], slab[along]
    goes_on = (np.diff(below) == 0) & (np.diff(above) == 0) & (np.diff(slab) == 1) & ~ends_here[slab[1:]]
    begin = np.flatnonzero(np.concatenate([[True], ~goes_on]))
    end = np.append(begin[1:], len(slab)) - 1
    below, above, x = below[begin], above[begin], np.stack([cuts[slab[begin]], cuts[slab[end] + 1]], axis=1)
    heights = (left[k, 1:] + slope[k, None] * (x - left[k, :1]) for k in (below, above))
    return np.stack([x, *heights], axis=-1)


def _blurred(polygons: Sequence[FloatArray], most: float) -> list[FloatArray]:
    """Closed polygons (n, 2) without corners that lie within `most` mm of the sides that are left.

    Every other corner is looked at, of all polygons at one go, until none goes any more; three always stay.
    """
    points, sizes = np.concatenate(polygons), np.array([len(polygon) for polygon in polygons])
    # how far at most corners that are gone lie from the side behind each point
    left_out = np.zeros(len(points))
    turn = idle = 0
    while idle < 2:
        start, size = np.repeat(np.cumsum(sizes) - sizes, sizes), np.repeat(sizes, sizes)
        place = numbers_in_groups(sizes)
        number = (place + turn) % size
        asked = np.flatnonzero((number % 2 == 1) & (number <= 2 * (size - 3)))
        before, behind = (start[asked] + (place[asked] + step) % size[asked] for step in (-1, 1))
        off = np.maximum(left_out[before], left_out[asked])
        off += chord_errors(points[before], points[behind], points[asked, None])
        gone = off <= most
        left_out[before[gone]] = off[gone]
        kept = np.ones(len(points), dtype=bool)
        kept[asked[gone]] = False
        sizes = np.add.reduceat(kept, np.cumsum(sizes) - sizes, dtype=int)
        points, left_out = points[kept], left_out[kept]
        turn, idle = 1 - turn, 0 if gone.any() else idle + 1
    return np.split(points, np.cumsum(sizes)[:-1])
