"""The boundary of a bent strip: faces, edges and vertices of its pieces, sheets and walls."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from math import hypot
from typing import TypeAlias

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.solids.bent_map import BentMap
from elastica_cad.fabrication.solids.boundary_records import (
    Boundary,
    CylinderSurface,
    Edge,
    EdgeUse,
    ExtrudedSurface,
    Face,
    PlacedSegment,
    PlaneSurface,
    SpaceCurve,
    SpaceSurface,
    StraightTrace,
    Surface,
)
from elastica_cad.fabrication.solids.pattern_strips import Piece, Region
from elastica_cad.fabrication.strip.flat_outline import graphs
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.paths.segments import Arc, Line, Segment, Spline
from elastica_cad.geometry.polynomials.splines import knot_runs

ROUNDED_MM = 1e-12
"""Between the x of both ends of a line straight across: two sides reach its station by different sums."""

Map: TypeAlias = Frame | BentMap  # a tab lies in its tangent plane, the free part is bent


@dataclass
class BoundaryMaker:
    """Builds vertices, edges and faces of the flat pattern's regions at one or two heights."""

    corners: FloatArray
    maps: Sequence[Map]
    heights: tuple[float, ...]
    vertices: list[FloatArray] = field(default_factory=list)
    edges: list[Edge] = field(default_factory=list)
    faces: list[Face] = field(default_factory=list)
    at_corner: dict[int, int] = field(default_factory=dict)
    at_piece: dict[int, int] = field(default_factory=dict)
    posts: dict[int, int] = field(default_factory=dict)

    def sheet(self, regions: Sequence[Region]) -> Boundary:
        """The face of every region at the first height."""
        for region in regions:
            self._add_edges(region)
            self._add_faces(region)
        return self._boundary()

    def solid(self, regions: Sequence[Region]) -> Boundary:
        """The closed skin between the two heights."""
        for region in regions:
            self._add_edges(region)
            self._add_faces(region)
            for loop in region.loops:
                for piece in loop:
                    if not piece.seam:
                        self._add_side(piece, self.maps[region.interval])
        return self._boundary()

    def _boundary(self) -> Boundary:
        return Boundary(np.array(self.vertices), tuple(self.edges), tuple(self.faces))

    def _add_edges(self, region: Region) -> None:
        """Vertices and edges at every height, in the order of the heights."""
        shape = self.maps[region.interval]
        pieces = [piece for loop in region.loops for piece in loop]
        fresh = [piece.start for piece in pieces if piece.start not in self.at_corner]
        if fresh:
            for corner, rows in zip(fresh, _points(shape, self.corners[fresh], self.heights), strict=True):
                self.at_corner[corner] = len(self.vertices)
                self.vertices += list(rows)
        new = {piece.number: piece for piece in pieces if piece.number not in self.at_piece}
        for piece, curves in zip(new.values(), _curves(shape, [*new.values()], self.heights), strict=True):
            self.at_piece[piece.number] = len(self.edges)
            start, end = (self.at_corner[i] for i in _ends(piece))
            self.edges += [
                Edge(curve, piece.first, piece.last, start + level, end + level)
                for level, curve in enumerate(curves)
            ]

    def _add_faces(self, region: Region) -> None:
        """The region's face at every height: seen from above it lies to the left of its loops."""
        shape = self.maps[region.interval]
        surfaces: list[Surface]
        if isinstance(shape, Frame):
            surfaces = [PlaneSurface(frame) for frame in _levels(shape, self.heights)]
        else:
            low, high = zip(*(_across(piece.segment) for loop in region.loops for piece in loop), strict=True)
            surfaces = [shape.surface(min(low), max(high), up) for up in self.heights]
        traces = [[_trace_on(shape, piece.segment) for piece in loop] for loop in region.loops]
        for level, surface in enumerate(surfaces):
            loops = tuple(
                tuple(
                    EdgeUse(self.at_piece[piece.number] + level, piece.forward, trace)
                    for piece, trace in zip(loop, along, strict=True)
                )
                for loop, along in zip(region.loops, traces, strict=True)
            )
            self.faces.append(Face(surface, loops, outward=level == len(self.heights) - 1))

    def _add_side(self, piece: Piece, shape: Map) -> None:
        """The wall over one piece of a loop; u follows the piece's parameter, v goes up."""
        low = self.at_piece[piece.number]
        surface = self._wall(piece, shape, self.edges[low], self.edges[low + 1])
        height = self.heights[1] - self.heights[0]
        start, end = (self._post(i, shape) for i in _ends(piece))
        traces: list[StraightTrace | Segment | None] = [None] * 4
        if not isinstance(surface, PlaneSurface):
            below, above = _along(surface, (0.0, height))
            last, first = (StraightTrace((t, 0.0), (0.0, 1.0)) for t in (piece.last, piece.first))
            traces = [below, last, above, first]
        uses = zip((low, end, low + 1, start), (True, True, False, False), traces, strict=True)
        self.faces.append(Face(surface, (tuple(EdgeUse(*use) for use in uses),), outward=piece.forward))

    def _wall(self, piece: Piece, shape: Map, low: Edge, high: Edge) -> Surface:
        segment, up = piece.segment, self.heights[0]
        straight = isinstance(segment, Line)
        if isinstance(shape, BentMap) and not _is_across(segment):
            if straight and segment.start[1] == segment.end[1]:
                side = -1.0 if segment.end[0] > segment.start[0] else 1.0
                frame = shape.frame.shifted(z=float(segment.start[1]))
                return PlaneSurface(Frame(frame.origin, frame.x_axis, side * frame.y_axis))
            if not (isinstance(low.curve, SpaceCurve) and isinstance(high.curve, SpaceCurve)):
                raise TypeError("edges of a bent face are splines")
            return self._ruled(low.curve, high.curve)
        if straight:
            a, b = self.vertices[low.start], self.vertices[low.end]
            return PlaneSurface(_plane_through(a, b - a, self.vertices[high.start] - a))
        if isinstance(shape, BentMap):
            raise TypeError("only lines across stay plane on a bent strip")
        if isinstance(segment, Arc):
            base = shape.shifted(float(segment.center[0]), float(segment.center[1]), up)
            return CylinderSurface(base, segment.radius)
        placed = PlacedSegment(segment, shape.shifted(z=up))
        if not isinstance(segment, Spline) or segment.curve.is_rational:
            return ExtrudedSurface(placed)
        curve, rise = segment.curve, (self.heights[1] - up) * shape.z_axis
        points = placed.frame.point(curve.control_points)
        low_side, high_side = (
            SpaceCurve(curve.knots, rows, curve.degree) for rows in (points, points + rise)
        )
        return self._ruled(low_side, high_side)

    def _ruled(self, low: SpaceCurve, high: SpaceCurve) -> SpaceSurface:
        """Straight across between two splines over the same knots."""
        h = self.heights[1] - self.heights[0]
        points = np.stack([low.control_points, high.control_points], axis=1)
        return SpaceSurface((low.knots, np.array([0.0, 0.0, h, h])), points, (low.degree, 1))

    def _post(self, corner: int, shape: Map) -> int:
        """The straight edge through the thickness at a corner."""
        if corner not in self.posts:
            low = self.at_corner[corner]
            rise = self.vertices[low + 1] - self.vertices[low]
            height = hypot(*rise.tolist())
            across = shape.frame.z_axis if isinstance(shape, BentMap) else shape.y_axis
            upright = Frame(self.vertices[low], rise / height, across)
            line = PlacedSegment(Line((0.0, 0.0), (height, 0.0)), upright)
            self.posts[corner] = len(self.edges)
            self.edges.append(Edge(line, 0.0, height, low, low + 1))
        return self.posts[corner]


def _along(wall: Surface, heights: tuple[float, ...]) -> Sequence[StraightTrace | Segment]:
    """The traces of a wall's edges at these heights.

    On a spline they have the spline's knots: kernels measure a face from knot to knot of its traces, and miss what
    bends between.
    """
    if not isinstance(wall, SpaceSurface):
        return [StraightTrace((0.0, height), (1.0, 0.0)) for height in heights]
    edges, _ = knot_runs(wall.knots[0])
    knots = np.concatenate([edges[:1], edges[:1], edges, edges[-1:], edges[-1:]])
    return graphs(knots, np.repeat(heights, edges.size + 1).reshape(len(heights), -1), degree=2)


def _trace_on(shape: Map, segment: Segment) -> StraightTrace | Segment | None:
    """A segment on the face that its pattern becomes: on a bent one it is itself, planes ask for none."""
    if isinstance(shape, Frame):
        return None
    if not isinstance(segment, Line):
        return segment
    x, y = segment.start.tolist()
    return StraightTrace((x, y), segment.direction)


def _levels(frame: Frame, heights: Sequence[float]) -> list[Frame]:
    """The frame at every height."""
    return [frame.shifted(z=up) for up in heights]


def _plane_through(origin: FloatArray, along: FloatArray, up: FloatArray) -> Frame:
    """The plane of a wall, which stands upright on what it runs along."""
    return Frame(origin, along / hypot(*along.tolist()), up / hypot(*up.tolist()))


def _across(segment: Segment) -> tuple[float, float]:
    """Bounds of y along a segment; of a spline those of its control points."""
    if isinstance(segment, Line):
        (_, y), (_, to_y) = segment.start.tolist(), segment.end.tolist()
        return min(y, to_y), max(y, to_y)
    rows = segment.curve.control_points if isinstance(segment, Spline) else segment.bounds
    return float(rows[:, 1].min()), float(rows[:, 1].max())


def _ends(piece: Piece) -> tuple[int, int]:
    """Corners in the direction of the parameter."""
    return (piece.start, piece.end) if piece.forward else (piece.end, piece.start)


def _points(shape: Map, flat: FloatArray, heights: Sequence[float]) -> FloatArray:
    """Points in space (k, levels, 3) of flat points (k, 2) at several heights."""
    if isinstance(shape, BentMap):
        return shape.points(flat, heights)
    return shape.point(flat)[:, None] + np.outer(heights, shape.z_axis)


def _curves(
    shape: Map, pieces: Sequence[Piece], heights: Sequence[float]
) -> Iterator[Sequence[SpaceCurve | PlacedSegment]]:
    """The segment of each piece in space at every height."""
    if not isinstance(shape, BentMap):
        frames = _levels(shape, heights)
        yield from ([PlacedSegment(piece.segment, frame) for frame in frames] for piece in pieces)
        return
    along = [(p.segment, p.first, p.last) for p in pieces if not _is_across(p.segment)]
    curves = iter(shape.curves(along, heights))
    for segment in (piece.segment for piece in pieces):
        if _is_across(segment):
            frames = _levels(shape.frame_at(float(segment.start[0])), heights)
            yield [PlacedSegment(segment, frame) for frame in frames]
        else:
            yield next(curves)


def _is_across(segment: Segment) -> bool:
    """Is it a line straight across, which stays one on a bent strip?"""
    return isinstance(segment, Line) and abs(float(segment.start[0] - segment.end[0])) < ROUNDED_MM
