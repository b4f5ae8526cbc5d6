"""Necks, tongues and bridges: where two cuts of a flat part leave less material than asked."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.fabrication.makeability.near_pairs import near_pairs
from elastica_cad.geometry.paths.many_segments import areas, polylines
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.running_sums import numbers_in_groups

SAMPLES_PER_WIDTH = 12  # points along a cut in each least width: a width is found to a percent
COARSE = 4  # the same for a first look, which most parts pass
FACING = 0.9  # cosine between a width and both inward normals: corners blunter than 50 degrees are no necks
OPPOSED = (
    -0.6
)  # dot product of the normals of cuts that face each other: at most -cos(2 arccos(FACING)) = -0.62
LEANING = (
    0.1  # of the least width: what leaning sides come nearer in half a step of the first look, 0.785 / 8
)
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
    points, normals, _ = _sampled(outlines, holes, least, COARSE)
    i, j = near_pairs(points, least * (1 + 1 / COARSE))
    i, j = np.stack([i, j])[:, np.einsum("ij,ij->i", normals[i], normals[j]) < OPPOSED]
    across = points[j] - points[i]
    # the walls of a slot face each other, too, but there is no material between them
    between = (np.einsum("ij,ij->i", across, normals[i]) > -LEANING * least) & (
        np.einsum("ij,ij->i", across, normals[j]) < LEANING * least
    )
    if not np.any(between):
        return ()
    points, normals, loop = _sampled(outlines, holes, least, SAMPLES_PER_WIDTH)
    i, j = near_pairs(points, least * (1 - 1e-9))
    across = points[j] - points[i]
    width = np.hypot(across[:, 0], across[:, 1])
    with np.errstate(invalid="ignore", divide="ignore"):
        across = across / width[:, None]
    facing = (np.sum(across * normals[i], axis=1) > FACING) & (np.sum(across * normals[j], axis=1) < -FACING)
    i, j, width = i[facing], j[facing], width[facing]
    if not width.size:
        return ()
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    middle = (points[i] + points[j]) / 2
    near = near_pairs(middle, least)
    links = coo_matrix((np.ones(near.shape[1], dtype=bool), near), shape=(width.size, width.size))
    group = connected_components(links, directed=False)[1]
    order = np.argsort(width, kind="stable")
    thinnest = order[np.unique(group[order], return_index=True)[1]]
    places = [
        ThinPlace(
            float(middle[k, 0]), float(middle[k, 1]), float(width[k]), (int(loop[i[k]]), int(loop[j[k]]))
        )
        for k in thinnest
    ]
    return tuple(sorted(places, key=lambda place: place.width))


def _sampled(
    outlines: Sequence[Path], holes: Sequence[Path], least: float, per_width: int
) -> tuple[FloatArray, FloatArray, IntArray]:
    """Points (n, 2) on all cuts, their normals (n, 2) into the material, and the numbers (n,) of their cuts."""
    points: list[FloatArray] = []
    normals: list[FloatArray] = []
    loops: list[IntArray] = []
    sided = [*((path, True) for path in outlines), *((path, False) for path in holes)]
    # the material on the left
    ways = areas([path for path, _ in sided]) > 0
    runs = [path if way == outer else path.reversed() for (path, outer), way in zip(sided, ways, strict=True)]
    for line in polylines(runs, FLAT_SHARE * least):
        sides = np.roll(line, -1, axis=0) - line
        long = np.hypot(sides[:, 0], sides[:, 1])
        corners, sides, long = line[long > 0], sides[long > 0], long[long > 0]
        counts = np.maximum(1, np.ceil(long * per_width / least)).astype(int)
        side = np.repeat(np.arange(len(sides)), counts)
        place = (numbers_in_groups(counts) + 0.5) / counts[side]
        points.append(corners[side] + place[:, None] * sides[side])
        inward = np.column_stack([-sides[:, 1], sides[:, 0]]) / long[:, None]
        normals.append(inward[side])
        loops.append(np.full(side.size, len(loops)))
    return np.concatenate(points), np.concatenate(normals), np.concatenate(loops)
