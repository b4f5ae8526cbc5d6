"""Necks, tongues and bridges: where two cuts of a flat part leave less material than asked."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.running_sums import numbers_in_groups

SAMPLES_PER_WIDTH = 12  # points along a cut in each least width: a width is found to a percent
FACING = 0.9  # cosine between a width and both inward normals: corners blunter than 50 degrees are no necks
FLAT_SHARE = 0.02  # of the least width: chords of the sampled cuts


@dataclass(frozen=True)
class ThinPlace:
    """Too little material: its middle (x, y) and its width, mm; `loops`: the cuts on both sides, outlines first."""

    x: float
    y: float
    width: float
    loops: tuple[int, int] = (0, 0)


def find_thin_places(outlines: Sequence[Path], holes: Sequence[Path], least: float) -> tuple[ThinPlace, ...]:
    """Places where straight across the material the next cut is nearer than `least` mm, the thinnest first.

    Each place is the thinnest of all that lie within `least` of each other.

    Parameters
    ----------
    outlines, holes : sequences of Path
        Closed outer and inner cuts.
    least : float
        mm.

    Examples
    --------
    >>> plate, hole = Path.rectangle(40, 20), Path.rectangle(10, 10, corner=(5, 1))
    >>> [place.width for place in find_thin_places([plate], [hole], 2.0)]
    [1.0]
    """
    chords = _Chords.of(outlines, holes, FLAT_SHARE * least)
    points, chord = chords.middles(least / SAMPLES_PER_WIDTH)
    i, j, width = _widths_across(points, chords.inward[chord], least)
    if not width.size:
        return ()
    middle = (points[i] + points[j]) / 2
    loop = chords.loop[chord]
    places = [
        ThinPlace(
            float(middle[k, 0]), float(middle[k, 1]), float(width[k]), (int(loop[i[k]]), int(loop[j[k]]))
        )
        for k in _thinnest_of_each_group(middle, width, least)
    ]
    return tuple(sorted(places, key=lambda place: place.width))


def _widths_across(
    points: FloatArray, normals: FloatArray, least: float
) -> tuple[IntArray, IntArray, FloatArray]:
    """Pairs of points (k,) that face each other straight across the material, and how far apart they are, mm.

    Of all pairs of a point only the narrowest is kept.
    """
    i, j = _near_pairs(points, least * (1 - 1e-9))
    across = points[j] - points[i]
    width = np.hypot(across[:, 0], across[:, 1])
    with np.errstate(invalid="ignore", divide="ignore"):
        across = across / width[:, None]
    facing = (np.sum(across * normals[i], axis=1) > FACING) & (np.sum(across * normals[j], axis=1) < -FACING)
    i, j, width = i[facing], j[facing], width[facing]
    narrowest = np.unique(np.concatenate([_narrowest(i, width), _narrowest(j, width)]))
    return i[narrowest], j[narrowest], width[narrowest]


def _near_pairs(points: FloatArray, reach: float) -> IntArray:
    """The pairs (2, k) of points (n, 2) no farther apart than `reach`, the smaller number of each first."""
    from scipy.spatial import cKDTree

    return np.asarray(cKDTree(points).query_pairs(reach, output_type="ndarray").T)


def _thinnest_of_each_group(middle: FloatArray, width: FloatArray, least: float) -> IntArray:
    """The thinnest of places (k, 2) that lie within `least` of each other, directly or by others between."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    near = _near_pairs(middle, least)
    links = coo_matrix((np.ones(near.shape[1], dtype=bool), near), shape=(width.size, width.size))
    group = connected_components(links, directed=False)[1]
    order = np.argsort(width, kind="stable")
    return order[np.unique(group[order], return_index=True)[1]]


def _narrowest(point: IntArray, width: FloatArray) -> IntArray:
    """Of all widths (k,) across each point, the place of the least."""
    order = np.lexsort((width, point))
    return order[np.unique(point[order], return_index=True)[1]]


@dataclass(frozen=True, eq=False)
class _Chords:
    """All cuts as chords (m): where each begins, its way, both (m, 2), its length, and the number of its cut.

    The material is on their left; `inward` are unit normals (m, 2) into it.
    """

    start: FloatArray
    way: FloatArray
    length: FloatArray
    loop: IntArray
    inward: FloatArray

    @classmethod
    def of(cls, outlines: Sequence[Path], holes: Sequence[Path], flat: float) -> "_Chords":
        """The chords of closed cuts, to `flat` mm."""
        sided = [*((path, True) for path in outlines), *((path, False) for path in holes)]
        runs = [path if (path.area > 0) == outer else path.reversed() for path, outer in sided]
        lines = [path.points(flat) for path in runs]
        start = np.concatenate(lines)
        way = np.concatenate([np.roll(line, -1, axis=0) - line for line in lines])
        loop = np.repeat(np.arange(len(lines)), [len(line) for line in lines])
        length = np.hypot(way[:, 0], way[:, 1])
        start, way, length, loop = (each[length > 0] for each in (start, way, length, loop))
        inward = np.column_stack([-way[:, 1], way[:, 0]]) / length[:, None]
        return cls(start, way, length, loop, inward)

    def middles(self, longest: float) -> tuple[FloatArray, IntArray]:
        """The middles (n, 2) of equal parts no longer than `longest` mm, and the numbers (n,) of their chords."""
        parts = np.maximum(1, np.ceil(self.length / longest)).astype(np.int64)
        chord = np.repeat(np.arange(len(parts)), parts)
        place = (numbers_in_groups(parts) + 0.5) / parts[chord]
        return self.start[chord] + place[:, None] * self.way[chord], chord
