"""Printed blocks of a model that would stand in each other."""

from collections.abc import Sequence
from itertools import combinations

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.holders.end_fixtures import EndFixture
from elastica_cad.fabrication.solids.strip_solids import FlatSolid

TOUCHING_MM = 0.1
"""Blocks may reach so far into each other: a file takes it off."""


def crowded_blocks(blocks: Sequence[EndFixture]) -> tuple[str, ...]:
    """A sentence that names the first two blocks that would stand in each other, and how many more pairs do.

    Examples
    --------
    >>> crowded_blocks([])
    ()
    """
    prisms = [[_Prism(solid) for solid in block.solid.added] for block in blocks]
    pairs = [
        (first.tab.name, second.tab.name)
        for (first, its), (second, others) in combinations(zip(blocks, prisms, strict=True), 2)
        if any(one.overlaps(other) for one in its for other in others)
    ]
    if not pairs:
        return ()
    others = len(pairs) - 1
    more = f" (and {others} more {'pair' if others == 1 else 'pairs'})" if others else ""
    return (
        f"the printed blocks of {pairs[0][0]} and {pairs[0][1]}{more} would stand in each other: end these strips "
        "farther apart, make wall and foot smaller, or hold fewer of the ends by blocks (strips, ends)",
    )


class _Prism:
    """The corners (n, 3) of a convex prism in space, and the directions of its edges and of its faces."""

    def __init__(self, solid: FlatSolid) -> None:
        plane = np.array([segment.start for segment in solid.outline.segments])
        flat = np.column_stack([plane, np.zeros(len(plane))])
        up = solid.frame.z_axis
        lower = solid.frame.point(flat)
        self.corners: FloatArray = np.concatenate([lower, lower + solid.thickness * up])
        sides = np.roll(lower, -1, axis=0) - lower
        self.edges: FloatArray = np.concatenate([sides, up[None]])
        self.normals: FloatArray = np.concatenate([np.cross(sides, up), up[None]])

    def overlaps(self, other: "_Prism") -> bool:
        """Is there no plane between the two? It would be along a face of one, or along an edge of each."""
        between = np.cross(self.edges[:, None], other.edges[None]).reshape(-1, 3)
        axes = np.concatenate([self.normals, other.normals, between])
        sizes = np.linalg.norm(axes, axis=1)
        axes = axes[sizes > 1e-9 * sizes.max()]
        axes /= np.linalg.norm(axes, axis=1)[:, None]
        mine, its = self.corners @ axes.T, other.corners @ axes.T
        depth = np.minimum(mine.max(axis=0), its.max(axis=0)) - np.maximum(mine.min(axis=0), its.min(axis=0))
        return float(depth.min()) > TOUCHING_MM
