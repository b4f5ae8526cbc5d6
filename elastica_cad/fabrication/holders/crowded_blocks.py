"""Printed blocks of a model that would stand in each other, or in the way of a strip."""

from collections.abc import Sequence
from itertools import combinations

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.holders.end_fixtures import EndFixture
from elastica_cad.fabrication.holders.placed_tab import PlacedTab
from elastica_cad.fabrication.holders.tab_seats import tab_key
from elastica_cad.fabrication.placed_strip import Placed, strip_names
from elastica_cad.fabrication.solids.strip_solids import FlatSolid
from elastica_cad.fabrication.strip.tabs import ENDS

TOUCHING_MM = 0.1
"""Blocks may reach so far into each other: a file takes it off."""

STATIONS, ACROSS = 401, (-0.95, -0.5, 0.0, 0.5, 0.95)
"""Along a strip and, in half widths, across it: the points that are looked for in blocks."""


def crowded_blocks(blocks: Sequence[EndFixture], placed: Sequence[Placed]) -> tuple[str, ...]:
    """Sentences that name the first two blocks that would stand in each other, and the first strip in one's way.

    Examples
    --------
    >>> crowded_blocks([], [])
    ()
    """
    prisms = [[_Prism(solid) for solid in block.solid.added] for block in blocks]
    pairs = [
        f"{first.tab.name} and {second.tab.name}"
        for (first, its), (second, others) in combinations(zip(blocks, prisms, strict=True), 2)
        if any(one.overlaps(other) for one in its for other in others)
    ]
    strips = [_surface(one) for one in placed]
    tabs = [{tab_key(PlacedTab.of(one.strip, end, one.frame)) for end in ENDS} for one in placed]
    crossed = [
        f"{name} would run through the printed block of {block.tab.name}"
        for name, own, points in zip(strip_names(placed), tabs, strips, strict=True)
        for block, its in zip(blocks, prisms, strict=True)
        if tab_key(block.tab) not in own and any(part.hold(points) for part in its)
    ]
    told = []
    if pairs:
        told.append(
            f"the printed blocks of {pairs[0]}{_more(pairs, 'pair')} would stand in each other: end these strips "
            "farther apart, make wall and foot smaller, or hold fewer of the ends by blocks (strips, ends)"
        )
    if crossed:
        told.append(
            f"{crossed[0]}{_more(crossed, 'place')}: end them farther apart, or hold fewer of the ends by blocks "
            "(strips, ends)"
        )
    return tuple(told)


def _more(found: Sequence[str], what: str) -> str:
    others = len(found) - 1
    return f" (and {others} more {what}{'' if others == 1 else 's'})" if others else ""


def _surface(placed: Placed) -> FloatArray:
    """Points (n, 3) of the free part."""
    rod, frame = placed.strip.rod, placed.frame
    s = np.linspace(0.0, rod.length, STATIONS)
    middle = np.column_stack([np.interp(s, rod.s, x) for x in rod.position.T])
    half = placed.strip.width(s)[:, None] / 2 * np.array(ACROSS)
    return np.asarray((frame.point(middle)[:, None] + half[..., None] * frame.z_axis).reshape(-1, 3))


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

    def hold(self, points: FloatArray) -> bool:
        """Does any of the points (n, 3) lie inside, and not at the skin?"""
        depth = ((self.faces - points[:, None]) * self.outward).sum(axis=2).min(axis=1)
        return float(depth.max()) > TOUCHING_MM

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
