"""Where two bent strips cross in space: from edge to edge, exactly."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from elastica_cad._types import BoolArray, FloatArray, IntArray
from elastica_cad.fabrication.interlocking.bracketed_zeros import bracketed_zeros
from elastica_cad.fabrication.interlocking.ruled_intersection import (
    IntersectionCurve,
    intersect_surfaces,
    margins,
)
from elastica_cad.fabrication.interlocking.ruled_strip import RuledStrip
from elastica_cad.geometry.running_sums import distinct, lengths_along

NODE_PARTS = 4
"""Parts of each stretch between nodes, among which edges are bracketed."""

ON_EDGE_MM = 1e-8
"""A crossing that ends this near to an edge ends on it: some hundred times what Newton's method leaves."""

LENGTH_POINTS = 33
"""Points by which the length along a crossing is measured: right to a thousandth, to place points evenly."""


@dataclass(frozen=True, eq=False)
class CrossingPoints:
    """Points that both strips share.

    Attributes
    ----------
    first, second : (n, 2) arrays
        In the flat patterns of both strips: arc length, and distance from the centre line, mm.
    position : (n, 3) array
        In space, mm.
    angle : (n,) array
        Between the two surfaces, rad, from 0 to pi / 2.
    """

    first: FloatArray
    second: FloatArray
    position: FloatArray
    angle: FloatArray


@dataclass(frozen=True, eq=False)
class Crossing:
    """One stretch along which both strips have material; both flat patterns show it in its true length.

    Attributes
    ----------
    strips : pair of RuledStrip
    start, end : float
        Range on the locus.
    """

    strips: tuple[RuledStrip, RuledStrip]
    locus: IntersectionCurve
    start: float
    end: float

    def at(self, x: FloatArray) -> CrossingPoints:
        """Points at x (n,): 0 and 1 are where the stretch begins and ends; it goes on beyond."""
        a, b = self.strips
        p = self.locus.at(self.start + x * (self.end - self.start))
        (place, tangent), (_, other) = p.on_curves
        normals = a.normal(tangent), b.normal(other)
        # half the angle between unit vectors has this tangent, to rounding at every angle
        apart, together = np.linalg.norm([normals[0] - normals[1], normals[0] + normals[1]], axis=2)
        return CrossingPoints(
            np.column_stack([p.s_a, p.v]),
            np.column_stack([p.s_b, p.u]),
            a.frame.point(place) + p.v[:, None] * a.axis,
            2 * np.arctan2(np.minimum(apart, together), np.maximum(apart, together)),
        )

    @cached_property
    def course(self) -> tuple[FloatArray, FloatArray, CrossingPoints]:
        """Places x (n,) from 0 to 1, all nodes of the locus among them, lengths up to them, mm, and the points."""
        nodes = (self.locus.nodes - self.start) / (self.end - self.start)
        x = distinct(np.concatenate([np.linspace(0.0, 1.0, LENGTH_POINTS), nodes[(nodes > 0) & (nodes < 1)]]))
        points = self.at(x)
        return x, lengths_along(points.position), points

    @property
    def length(self) -> float:
        """mm."""
        return float(self.course[1][-1])

    @cached_property
    def middle(self) -> float:
        """The x half way along."""
        x, along, _ = self.course
        k = int(np.searchsorted(along, along[-1] / 2)) - 1
        pace = float((x[k + 1] - x[k]) / (along[k + 1] - along[k]))
        middle, half = float(x[k]) + pace * (along[-1] / 2 - along[k]), along[-1] / 2 - along[k]
        for _ in range(2):  # between nodes x is smooth: the secant method takes a few steps
            done = lengths_along(self.at(np.linspace(x[k], middle, 5)).position)[-1]
            middle += (half - done) * pace
        return float(middle)

    def evenly(self, start: float, end: float, pitch: float) -> FloatArray:
        """Places x (n,), at least 6, from start to end at nearly equal distances of at most `pitch` mm."""
        x, along, _ = self.course
        if min(start, end) < 0 or max(start, end) > 1:
            x = np.linspace(min(start, end), max(start, end), LENGTH_POINTS)
            along = lengths_along(self.at(x).position)
        low, high = np.interp([start, end], x, along)
        count = int(np.clip(abs(high - low) / pitch, 5, 64)) + 1
        return np.concatenate([[start], np.interp(np.linspace(low, high, count)[1:-1], along, x), [end]])

    @cached_property
    def room(self) -> FloatArray:
        """How far (2, 2) the first and the second strip go on across themselves, at the start and the end, mm."""
        m = margins(self.strips, self.locus.at(np.array([self.start, self.end])))
        return np.array([m[:, :2].min(axis=1), m[:, 2:].min(axis=1)])

    def beyond(self, which: int, end: int) -> float | None:
        """The x at which strip `which` (0 or 1) itself ends, going on from the start (end 0) or the end (1).

        None where the strip's curve ends before its long edge is reached.
        """
        if self.room[which, end] < ON_EDGE_MM:
            return float(end)
        origin, way = (self.start, -1) if end == 0 else (self.end, 1)
        nodes = self.locus.nodes
        q = np.concatenate([[origin], nodes[(nodes - origin) * way > 0][::way]])
        m = margins(self.strips, self.locus.at(q))[:, 2 * which : 2 * which + 2]
        outside = np.flatnonzero(m.min(axis=1) < 0)
        if not outside.size:
            return None
        i, side = int(outside[0]), int(np.argmin(m[outside[0]]))
        sides, values = np.array([2 * which + side]), (m[[i - 1], side], m[[i], side])
        root = float(_edges(self.strips, self.locus, (q[[i - 1]], q[[i]]), sides, values)[0])
        return (root - self.start) / (self.end - self.start)


def strip_crossings(a: RuledStrip, b: RuledStrip) -> tuple[Crossing, ...]:
    """All stretches along which two bent strips cross.

    Solved by Newton's method to rounding error; both ends of a stretch are where it leaves one of the strips. Of
    strips that are clearly apart (`strips_may_meet`) there is none.
    """
    found = []
    for locus in intersect_surfaces(a, b):
        found += [Crossing((a, b), locus, *run) for run in _runs((a, b), locus)]
    return tuple(found)


def _runs(strips: tuple[RuledStrip, RuledStrip], locus: IntersectionCurve) -> list[tuple[float, float]]:
    """Ranges of q inside both strips."""
    nodes = locus.nodes
    fine = (nodes[:-1, None] + np.diff(nodes)[:, None] * np.arange(NODE_PARTS) / NODE_PARTS).ravel()
    q = np.append(fine, nodes[-1])
    m = margins(strips, locus.at(q))
    i, side = np.nonzero(np.sign(m[:-1]) * np.sign(m[1:]) < 0)
    on_edge = q[(m == 0).any(axis=1)]
    edges = _edges(strips, locus, (q[i], q[i + 1]), side, (m[i, side], m[i + 1, side]))
    cuts = distinct(np.concatenate([q[[0, -1]], on_edge, edges]))
    inside = margins(strips, locus.at((cuts[:-1] + cuts[1:]) / 2)).min(axis=1) > 0
    return [(float(cuts[first]), float(cuts[last])) for first, last in _blocks(inside)]


def _edges(
    strips: tuple[RuledStrip, RuledStrip],
    locus: IntersectionCurve,
    between: tuple[FloatArray, FloatArray],
    sides: IntArray,
    values: tuple[FloatArray, FloatArray],
) -> FloatArray:
    """Where on the locus the margins' columns `sides` (n,) vanish, between places (n,) where they have `values`."""
    rows = np.arange(sides.size)
    return bracketed_zeros(lambda q: margins(strips, locus.at(q))[rows, sides], *between, values=values)


def _blocks(flags: BoolArray) -> list[tuple[int, int]]:
    """(first, last + 1) of the runs of True."""
    steps = np.diff(np.concatenate([[0], flags.astype(int), [0]]))
    return list(zip(np.flatnonzero(steps > 0).tolist(), np.flatnonzero(steps < 0).tolist(), strict=True))
