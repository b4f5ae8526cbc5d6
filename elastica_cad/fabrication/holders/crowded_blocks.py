"""Printed blocks of a model that would stand in each other, or in the way of a strip."""

from collections.abc import Sequence

import numpy as np

from elastica_cad._counts import and_more
from elastica_cad._types import FloatArray
from elastica_cad.fabrication.holders.end_fixtures import EndFixture
from elastica_cad.fabrication.holders.placed_tab import PlacedTab
from elastica_cad.fabrication.placed_strip import Placed, strip_names
from elastica_cad.fabrication.solids.strip_solids import FlatSolid
from elastica_cad.fabrication.strip.tabs import ENDS
from elastica_cad.geometry.boxes import box_about, boxes_meet

TOUCHING_MM = 0.1
"""Blocks may reach so far into each other: a file takes it off."""

RULINGS, PITCH_MM = 401, 1.0
"""Lines across a strip that are looked for in blocks: at least so many, and at most so far apart."""


def crowded_blocks(blocks: Sequence[EndFixture], placed: Sequence[Placed]) -> tuple[str, ...]:
    """Sentences that name the first two blocks that would stand in each other, and the first strip in one's way.

    Examples
    --------
    >>> crowded_blocks([], [])
    ()
    """
    prisms = [[_Prism(solid) for solid in block.solid.added] for block in blocks]
    bounds = np.array([box_about(np.concatenate([one.corners for one in its])) for its in prisms])
    bounds = bounds.reshape(-1, 2, 3)
    pairs = [
        f"{blocks[i].tab.name} and {blocks[j].tab.name}"
        for i, j in np.argwhere(np.triu(boxes_meet(bounds[:, None], bounds[None]), 1)).tolist()
        if any(one.overlaps(other) for one in prisms[i] for other in prisms[j])
    ]
    crossed = [
        f"{name} would run through the printed block of {blocks[k].tab.name}"
        for name, one in zip(strip_names(placed), placed, strict=True)
        for k in _crossed(one, blocks, prisms, bounds)
    ]
    told = []
    if pairs:
        told.append(
            f"the printed blocks of {pairs[0]}{and_more(pairs, 'pair')} would stand in each other: end these "
            "strips farther apart, make wall and foot smaller, or hold fewer of the ends by blocks (strips, ends)"
        )
    if crossed:
        told.append(
            f"{crossed[0]}{and_more(crossed, 'place')}: end them farther apart, or hold fewer of the ends "
            "by blocks (strips, ends)"
        )
    return tuple(told)


def _crossed(
    placed: Placed, blocks: Sequence[EndFixture], prisms: Sequence[Sequence["_Prism"]], bounds: FloatArray
) -> list[int]:
    """The blocks that a strip runs through, but for those that hold it."""
    low, high = _rulings(placed)
    near = np.flatnonzero(boxes_meet(box_about(np.concatenate([low, high])), bounds)).tolist()
    own = {PlacedTab.of(placed.strip, end, placed.frame).key for end in ENDS} if near else set()
    return [k for k in near if blocks[k].tab.key not in own and any(one.cuts(low, high) for one in prisms[k])]


def _rulings(placed: Placed) -> tuple[FloatArray, FloatArray]:
    """Both ends (n, 3) of lines across the free part."""
    rod, frame = placed.strip.rod, placed.frame
    s = np.linspace(0.0, rod.length, max(RULINGS, int(rod.length / PITCH_MM) + 2))
    middle = frame.point(np.column_stack([np.interp(s, rod.s, x) for x in rod.position.T]))
    across = placed.strip.width(s)[:, None] / 2 * frame.z_axis
    return middle - across, middle + across


class _Prism:
    """The corners (n, 3) of a convex prism in space, the directions of its edges and faces, a point of each face.

    Its outline runs anticlockwise, so that sides look outward.
    """

    def __init__(self, solid: FlatSolid) -> None:
        plane = np.array([segment.start for segment in solid.outline.segments])
        flat = np.column_stack([plane, np.zeros(len(plane))])
        up = solid.frame.z_axis
        lower = solid.frame.point(flat)
        self.faces: FloatArray = np.concatenate([lower, lower[:1] + solid.thickness * up, lower[:1]])
        self.corners: FloatArray = np.concatenate([lower, lower + solid.thickness * up])
        sides = np.roll(lower, -1, axis=0) - lower
        self.edges: FloatArray = np.concatenate([sides, up[None]])
        self.normals: FloatArray = np.concatenate([np.cross(sides, up), up[None]])
        outward = np.concatenate([self.normals, -up[None]])
        self.outward: FloatArray = outward / np.linalg.norm(outward, axis=1)[:, None]

    def cuts(self, low: FloatArray, high: FloatArray) -> bool:
        """Does any line between ends (n, 3) run through the inside, and not along the skin?"""
        near = boxes_meet(
            np.stack([np.minimum(low, high), np.maximum(low, high)], axis=1), box_about(self.corners)
        )
        depth, end = (
            ((self.faces - ends[near, None]) * self.outward).sum(axis=2) - TOUCHING_MM for ends in (low, high)
        )
        # a line is inside a face from where its depth there, linear along it, is above 0
        with np.errstate(divide="ignore", invalid="ignore"):
            at = depth / (depth - end)
        enters = np.where(depth > 0, 0.0, np.where(end > 0, at, 2.0)).max(axis=1)
        leaves = np.where(end > 0, 1.0, np.where(depth > 0, at, -1.0)).min(axis=1)
        return bool(np.any(enters < leaves))

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
