"""Printed blocks of a model that would stand in each other, or in the way of a strip."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from elastica_cad._counts import and_more
from elastica_cad._types import FloatArray
from elastica_cad.fabrication.holders.end_fixtures import EndFixture
from elastica_cad.fabrication.holders.placed_tab import PlacedTab
from elastica_cad.fabrication.placed_strip import Placed, strip_names
from elastica_cad.fabrication.solids.strip_solids import FlatSolid
from elastica_cad.fabrication.strip.tabs import ENDS

TOUCHING_MM = 0.1
"""Blocks may reach so far into each other: a file takes it off."""

PITCH_MM = 0.5
"""Between the points of strips and of the edges of blocks that are looked for in blocks."""


def crowded_blocks(blocks: Sequence[EndFixture], placed: Sequence[Placed]) -> tuple[str, ...]:
    """Sentences that name the first two blocks that would stand in each other, and the first strip in one's way.

    Examples
    --------
    >>> crowded_blocks([], [])
    ()
    """
    parts = [[_Prism.of(solid) for solid in block.solid.added] for block in blocks]
    edges = [np.concatenate([part.edges for part in its]) for its in parts]
    pairs = [
        f"{blocks[i].tab.name} and {blocks[j].tab.name}"
        for i, j in combinations(range(len(blocks)), 2)
        if _reach_into(edges[i], parts[j]) or _reach_into(edges[j], parts[i])
    ]
    crossed = [
        f"{name} would run through the printed block of {blocks[k].tab.name}"
        for name, one in zip(strip_names(placed), placed, strict=True)
        for k in _crossed(one, blocks, parts)
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


def _crossed(placed: Placed, blocks: Sequence[EndFixture], parts: Sequence[Sequence["_Prism"]]) -> list[int]:
    """The blocks that a strip runs through, but for those that hold it."""
    own = {PlacedTab.of(placed.strip, end, placed.frame).key for end in ENDS}
    rod, frame = placed.strip.rod, placed.frame
    s = np.linspace(0.0, rod.length, int(rod.length / PITCH_MM) + 2)
    half = placed.strip.width(s) / 2
    across = np.linspace(-1.0, 1.0, int(2 * half.max() / PITCH_MM) + 2)
    middle = frame.point(np.column_stack([np.interp(s, rod.s, x) for x in rod.position.T]))
    points = (middle[:, None] + np.multiply.outer(half, across)[..., None] * frame.z_axis).reshape(-1, 3)
    return [k for k, block in enumerate(blocks) if block.tab.key not in own and _reach_into(points, parts[k])]


def _reach_into(points: FloatArray, parts: Sequence["_Prism"]) -> bool:
    """Is any of the points (n, 3) deep enough within one of the parts?"""
    return any(bool((part.depths(points) > TOUCHING_MM).any()) for part in parts)


@dataclass(frozen=True, eq=False)
class _Prism:
    """A convex prism in space: points (n, 3) along its edges, and of its faces points and normals (k, 3)."""

    edges: FloatArray
    faces: FloatArray
    outward: FloatArray

    @classmethod
    def of(cls, solid: FlatSolid) -> "_Prism":
        """That of a solid, whose outline of lines runs anticlockwise."""
        up = solid.frame.z_axis
        lower = solid.frame.point([segment.start for segment in solid.outline.segments])
        upper, after = lower + solid.thickness * up, np.roll(lower, -1, axis=0)
        ends = [(lower, after), (upper, after + solid.thickness * up), (lower, upper)]
        starts, ways = (np.concatenate(rows) for rows in zip(*((a, b - a) for a, b in ends), strict=True))
        count = int(np.linalg.norm(ways, axis=1).max() / PITCH_MM) + 2
        edges = starts + np.linspace(0.0, 1.0, count)[:, None, None] * ways
        outward = np.concatenate([np.cross(after - lower, up), up[None], -up[None]])
        outward /= np.linalg.norm(outward, axis=1)[:, None]
        return cls(edges.reshape(-1, 3), np.concatenate([lower, upper[:1], lower[:1]]), outward)

    def depths(self, points: FloatArray) -> FloatArray:
        """How deep points (n, 3) lie within it, mm: negative outside."""
        heights = (self.faces * self.outward).sum(axis=1)
        return np.asarray((heights - points @ self.outward.T).min(axis=1))
