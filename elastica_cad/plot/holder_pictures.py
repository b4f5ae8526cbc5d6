"""What holds strips, as patches to be painted: plates, rings, ribs and printed blocks in their places."""

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import TypeAlias

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.drawings.sheet_colors import FIXTURE_COLOR, Color, sheet_color
from elastica_cad.fabrication.holders.end_fixtures import EndFixture
from elastica_cad.fabrication.holders.plates import BasePlate, Ring
from elastica_cad.fabrication.holders.slotted_frame import Rib
from elastica_cad.fabrication.model.assembly import Holder, single_holders
from elastica_cad.fabrication.solids.strip_solids import FlatSolid
from elastica_cad.geometry.paths.path import Path
from elastica_cad.plot.slabs import trapezoids

Plate: TypeAlias = BasePlate | Ring | Rib

EDGE_SHARE = 0.01
"""Of a patch: how closely polygons follow the loops of a plate."""


def level_plates(holders: Sequence[Holder]) -> tuple[BasePlate | Ring, ...]:
    """The plates that tabs go through, which part what is drawn before them from what is drawn after."""
    return tuple(holder for holder in single_holders(holders) if isinstance(holder, BasePlate | Ring))


def holder_patches(holders: Sequence[Holder], size: float) -> Iterator[tuple[FloatArray, FloatArray]]:
    """Patches (n, 4, 3) of `size` mm or less and their colours (n, 3), unlit, of each body that holds strips.

    Slots that tabs fill are drawn as if they were not cut.
    """
    for holder in single_holders(holders):
        if isinstance(holder, EndFixture):
            for prism in holder.solid.added:
                yield _patches(prism, (prism.outline, *prism.holes), FIXTURE_COLOR, size)
        else:
            yield _patches(holder.solid, _loops(holder), sheet_color(holder.sheet), size)


def _loops(holder: Plate) -> tuple[Path, ...]:
    """Outline and opening, without slots."""
    opening = None if isinstance(holder, Rib) else holder.opening
    return (holder.outline, *(() if opening is None else (opening,)))


def _patches(
    solid: FlatSolid, loops: Sequence[Path], color: Color, size: float
) -> tuple[FloatArray, FloatArray]:
    """Both faces and the rims of a plate."""
    tolerance = EDGE_SHARE * size
    low, high = np.array([loop.bounds for loop in loops[:1]])[0]
    stations = np.linspace(low[0], high[0], int(np.ceil((high[0] - low[0]) / size)) + 1)
    flat = [part for slab in trapezoids(loops, stations, tolerance) for part in _split(slab, size)]
    corners = np.array([[(a[0], a[1]), (b[0], b[1]), (b[0], b[2]), (a[0], a[2])] for a, b in flat])
    found = []
    for z in (0.0, solid.thickness):
        level = np.concatenate([corners, np.full((*corners.shape[:2], 1), z)], axis=2)
        found.append(solid.frame.point(level.reshape(-1, 3)).reshape(-1, 4, 3))
    for loop in loops:
        points = _fine(loop.points(tolerance), size)
        under, over = (
            solid.frame.point(np.column_stack([points, np.full(len(points), z)]))
            for z in (0.0, solid.thickness)
        )
        found.append(np.stack([under, np.roll(under, -1, axis=0), np.roll(over, -1, axis=0), over], axis=1))
    patches = np.concatenate(found)
    return patches, np.tile(np.asarray(color, dtype=float), (len(patches), 1))


def _split(slab: FloatArray, size: float) -> Iterator[FloatArray]:
    """A trapezoid (2, 3) of x, lower and upper y, cut across y into parts no higher than `size`."""
    count = max(1, int(np.ceil((slab[:, 2] - slab[:, 1]).max() / size)))
    heights = slab[:, 1:2] + (slab[:, 2:] - slab[:, 1:2]) * np.linspace(0.0, 1.0, count + 1)
    for k, _ in pairwise(range(count + 1)):
        yield np.column_stack([slab[:, 0], heights[:, k], heights[:, k + 1]])


def _fine(points: FloatArray, size: float) -> FloatArray:
    """A closed polygon with no side longer than `size`."""
    found = []
    for a, b in zip(points, np.roll(points, -1, axis=0), strict=True):
        count = max(1, int(np.ceil(np.hypot(*(b - a)) / size)))
        found.append(a + (b - a) * (np.arange(count) / count)[:, None])
    return np.concatenate(found)
