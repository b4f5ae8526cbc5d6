"""A flat pattern with its holes and slots as trapezoids, to be bent and painted."""

from collections.abc import Sequence
from math import ceil, dist

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Line
from elastica_cad.geometry.running_sums import numbers_in_groups

APART_MM = 1e-7
"""Stations nearer than this are one: slabs between them could not be seen."""

FEWEST, ROUND = 4, 96
"""Sides for a curve, and for a whole loop of one."""


def trapezoids(loops: Sequence[Path], stations: FloatArray, step: float) -> FloatArray:
    """What lies inside an odd number of loops, cut along x at its corners and at `stations`.

    Parameters
    ----------
    loops : sequence of Path
        Closed; outline and holes in any direction.
    stations : (k,) array
        Further places where the trapezoids end, mm.
    step : float
        Between the corners of the polygons that stand for curved loops, mm.

    Returns
    -------
    (n, 2, 3) array
        x, lower y and upper y at the left and at the right side of each, mm.

    Examples
    --------
    >>> plate = [Path.rectangle(10.0, 4.0), Path.rectangle(2.0, 2.0, corner=(4.0, 1.0))]
    >>> found = trapezoids(plate, np.array([]), 1.0)
    >>> width, height = np.diff(found[..., 0], axis=1)[:, 0], (found[..., 2] - found[..., 1]).mean(axis=1)
    >>> len(found), float(width @ height)
    (4, 36.0)
    """
    polygons = [polygon_of(loop, step) for loop in loops]
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


def polygon_of(loop: Path, step: float) -> FloatArray:
    """Points (n, 2) on a closed path, near enough for a picture: at corners, and some `step` mm apart on curves."""
    rows = []
    for segment in loop.segments:
        parts = 1
        if not isinstance(segment, Line):
            fewest = ROUND if len(loop.segments) == 1 else FEWEST
            parts = max(fewest, ceil(dist(segment.start, segment.end) / step))
        rows.append(segment.at(np.linspace(0.0, 1.0, parts, endpoint=False)))
    return np.concatenate(rows)
