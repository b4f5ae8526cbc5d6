"""Boundary of a bent strip in space, independent of CAD kernels."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from math import hypot
from typing import TypeAlias

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError, Length, NotConvergedError
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.path import Arc, Line, Segment, Spline
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import left_of, norm, numbers_in_groups, turns_along
from elastica_cad.geometry.splines import (
    SplineFunction,
    clamped_knots,
    interpolated,
    interpolation_sites,
    knot_runs,
)
from elastica_cad.mechanics.rod import Rod
from elastica_cad.strip.flat_pattern import Region, SegmentPart, on_segment
from elastica_cad.strip.outline import graphs, pace


@dataclass(frozen=True, eq=False)
class SpaceCurve:
    """A B-spline curve in space, with clamped `knots` (m + degree + 1,) and `control_points` (m, 3) in mm."""

    knots: FloatArray
    control_points: FloatArray
    degree: int


@dataclass(frozen=True, eq=False)
class PlacedSegment:
    """A plane segment with its frame in space.

    Its parameter is the distance (mm) along a `Line`, the angle (rad) of an `Arc`, or the parameter of a
    `Spline`.
    """

    segment: Segment
    frame: Frame


@dataclass(frozen=True, eq=False)
class SpaceSurface:
    """A tensor B-spline surface: knots and degrees for u and v, `control_points` (m, n, 3) in mm."""

    knots: tuple[FloatArray, FloatArray]
    control_points: FloatArray
    degree: tuple[int, int]

    def turned(self) -> "SpaceSurface":
        """Return the same surface with the parameters (-v, u) and the same direction of its normal."""
        u, v = self.knots
        return SpaceSurface((-v[::-1], u), self.control_points[:, ::-1].swapaxes(0, 1), self.degree[::-1])


@dataclass(frozen=True, eq=False)
class PlaneSurface:
    """Plane, whose parameters (u, v) are the coordinates x and y of its frame."""

    frame: Frame


@dataclass(frozen=True, eq=False)
class CylinderSurface:
    """A cylinder about the z axis of the frame; u is the angle from the x axis, and v is the height, mm."""

    frame: Frame
    radius: float


@dataclass(frozen=True, eq=False)
class ExtrudedSurface:
    """A plane segment extruded along the z axis of its frame.

    The parameter u is that of the segment, and v is the height, mm.
    """

    profile: PlacedSegment


Surface: TypeAlias = SpaceSurface | PlaneSurface | CylinderSurface | ExtrudedSurface


def trace_turn(surface: Surface) -> FloatArray:
    """Return the (2, 2) matrix that maps (u, v) to the parameters of the surface in a CAD kernel.

    OpenCASCADE integrates areas and volumes span by span in v, but with a single quadrature rule in u. If u
    were along the strip, the error of the volume could exceed 10 %. B-spline surfaces are therefore passed
    with exchanged parameters (`SpaceSurface.turned`).
    """
    return np.array([[0.0, -1.0], [1.0, 0.0]]) if isinstance(surface, SpaceSurface) else np.eye(2)


@dataclass(frozen=True, eq=False)
class StraightTrace:
    """A straight edge in the (u, v) plane of a surface: origin + parameter * direction (a unit vector)."""

    origin: tuple[float, float]
    direction: tuple[float, float]


@dataclass(frozen=True, eq=False)
class Edge:
    """Part of a curve from vertex `start` to vertex `end`, with `first` <= parameter <= `last`."""

    curve: SpaceCurve | PlacedSegment
    first: float
    last: float
    start: int
    end: int


@dataclass(frozen=True, eq=False)
class EdgeUse:
    """Edge in a loop of a face, with its direction and its trace in the (u, v) plane of the face's surface.

    `edge` is the index of the edge. `forward` is True if the loop follows increasing parameters of the edge.
    `trace` has the same parameter as the edge, and is None on planes.
    """

    edge: int
    forward: bool
    trace: StraightTrace | Segment | None = None


@dataclass(frozen=True, eq=False)
class Face:
    """Trimmed surface.

    The first loop is the outer loop. The normal of the surface is d/du cross d/dv. The face is to the left of
    its loops when the normal points to the viewer. `outward` is False if the normal points into the body.
    """

    surface: Surface
    loops: tuple[tuple[EdgeUse, ...], ...]
    outward: bool = True


@dataclass(frozen=True, eq=False)
class Boundary:
    """Faces with common edges and vertices.

    Attributes
    ----------
    vertices : (k, 3) array
        Positions of the vertices, mm.
    edges, faces
        `start` and `end` of an edge are rows of `vertices`. Faces refer to edges by index.
    """

    vertices: FloatArray
    edges: tuple[Edge, ...]
    faces: tuple[Face, ...]

    @property
    def is_closed(self) -> bool:
        """True if every edge is used exactly twice, once in each direction."""
        ways: list[list[int]] = [[] for _ in self.edges]
        for face in self.faces:
            for loop in face.loops:
                for use in loop:
                    ways[use.edge].append(1 if use.forward == face.outward else -1)
        return all(sorted(directions) == [-1, 1] for directions in ways)


DEGREE = 5
SURFACE_TOLERANCE = 5e-8  # largest error of edges on the bent faces, mm


@dataclass(frozen=True, eq=False)
class BentMap:
    """Map from the flat to the bent strip, for a part without jumps of the curvature.

    The point (x, y) of the flat strip at the height `up` above mid-thickness is mapped to C(x) - up N(x) + y
    Z. C is the centre line, N is its left normal, and Z is the direction across the strip. C and N have the
    same B-spline basis, so the faces and the ruled sides between them are exact.

    Attributes
    ----------
    knots : (m + 6,) array
        Clamped knots of the B-spline of degree 5 over arc length, mm.
    coefficients : (m, 4) array
        Control points of C (columns 0 and 1, mm) and N (columns 2 and 3), in the coordinates of the curve's plane.
    frame : Frame
        Plane of the curve in space.
    """

    knots: FloatArray
    coefficients: FloatArray
    frame: Frame

    def frame_at(self, x: float) -> Frame:
        """Return the tangent plane at arc length x, as a frame whose x coordinate is the arc length."""
        row = self._spline(np.array(x))
        # the tangent is to the right of the left normal N
        tangent = self.frame.direction(-left_of(row[2:]))
        return Frame(self.frame.point(row[:2]), tangent, self.frame.z_axis).shifted(x=-x)

    def points(self, flat: FloatArray, heights: Sequence[float]) -> FloatArray:
        """Return points in space (k, levels, 3) for points (k, 2) of the flat strip.

        `heights` (levels,), mm, are measured from mid-thickness.
        """
        rows = self._spline(flat[:, 0])
        local = np.empty((len(flat), len(heights), 3))
        local[:, :, :2] = rows[:, None, :2] - np.reshape(heights, (-1, 1)) * rows[:, None, 2:]
        local[:, :, 2] = flat[:, 1:]
        return self.frame.point(local)

    def curves(
        self, parts: Sequence[tuple[Segment, float, float]], heights: Sequence[float]
    ) -> list[list[SpaceCurve]]:
        """Return the curves in space of bent parts of flat segments, at every height.

        Each part is a segment with its first and last parameter. Its curves have the same B-spline basis at
        all heights.

        Lines and long sides are exact, because x is linear in their parameter. Other curves are fitted to
        5e-8 mm.
        """
        curves = []
        for segment, first, last in parts:
            even = pace(segment)

            def values(t: FloatArray, segment: Segment = segment) -> FloatArray:
                # three columns, x, y and z in space, for each height
                return self.points(on_segment(segment, t), heights).reshape(len(t), -1)

            if even is None:
                spans, degree = np.linspace(first, last, 9), DEGREE
                knots, rows = _fit_spline(values, spans, {}, np.full(3 * len(heights), SURFACE_TOLERANCE))
            else:
                knots, degree = self._common_knots(segment, even, (first, last))
                sites = interpolation_sites(knots, degree)
                rows = interpolated(sites, values(sites), knots, degree)
            curves.append(
                [SpaceCurve(knots, rows[:, k : k + 3], degree) for k in range(0, 3 * len(heights), 3)]
            )
        return curves

    def surface(self, low: float, high: float, up: float) -> SpaceSurface:
        """Return the bent face at the height `up`, from y = `low` to `high`.

        The parameters (u, v) of the face are (x, y) of the flat strip. The face is straight across the strip.
        """
        # the control points (m, 2, 3) are those of C - up N, once at y = `low` and once at y = `high`
        plane = self.coefficients[:, :2] - up * self.coefficients[:, 2:]
        local = np.empty((len(plane), 2, 3))
        local[:, :, :2] = plane[:, None]
        local[:, :, 2] = low, high
        return SpaceSurface(
            (self.knots, np.array([low, low, high, high])), self.frame.point(local), (DEGREE, 1)
        )

    @property
    def curvature(self) -> tuple[FloatArray, FloatArray]:
        """Arc lengths, mm, and curvatures of the centre line, 1/mm, at nine points of each span."""
        edges = np.unique(self.knots)
        s = np.linspace(edges[:-1], edges[1:], 9).ravel()
        # N' = -kappa C'
        along, turn = np.split(self._spline(s, 1), 2, axis=1)
        return s, -(turn * along).sum(axis=1) / (along**2).sum(axis=1)

    @cached_property
    def _spline(self) -> SplineFunction:
        return SplineFunction(self.knots, self.coefficients, DEGREE)

    def _common_knots(
        self, segment: Segment, even: tuple[float, float], limits: tuple[float, float]
    ) -> tuple[FloatArray, int]:
        """Return knots and degree of a basis for a segment and its bent image.

        `even` is (offset, speed): on the segment, x = offset + speed * parameter. `limits` are the first and the
        last parameter of the bent part of the segment.
        """
        (offset, speed), (first, last) = even, limits
        knots, counts = knot_runs(self.knots)
        # parameters of the inner knots of map and segment, and numbers of continuous derivatives there
        t, continuity, degree = (knots[1:-1] - offset) / speed, DEGREE - counts[1:-1], DEGREE
        if isinstance(segment, Spline):
            knots, counts = knot_runs(segment.curve.knots)
            degree = max(degree, segment.curve.degree)
            t = np.concatenate([t, knots])
            continuity = np.concatenate([continuity, segment.curve.degree - counts])
        near = 1e-9 * (last - first)
        order = t.argsort()
        order = order[(t[order] > first + near) & (t[order] < last - near)]
        t, continuity = t[order], continuity[order]
        if t.size:
            # knots that coincide become one knot with the least continuity
            apart = np.flatnonzero(np.diff(t, prepend=first) >= near)
            t, continuity = t[apart], np.minimum.reduceat(continuity, apart)
        # kernels fail to fillet edges of one or two spans
        if t.size < 2:
            edges = np.array([first, *t, last])
            # divide each span in three
            thirds = edges[:-1, None] + np.diff(edges)[:, None] * [0, 1 / 3, 2 / 3]
            smoothness = np.full(thirds.shape, degree - 1)
            smoothness[1:, 0] = continuity
            t, continuity = thirds.ravel()[1:], smoothness.ravel()[1:]
        inner = t.repeat(np.minimum(degree - continuity, degree))
        return np.pad([first, *inner, last], degree, mode="edge"), degree


def bent_maps(rod: Rod, frame: Frame, reach: float) -> tuple[BentMap, ...]:
    """Return a `BentMap` for each part of a rod between jumps of its curvature, from start to end.

    `reach` is the largest distance of a face from the centre line, mm.

    Raises
    ------
    NotConvergedError
        The curve could not be approximated to 1e-6 mm.
    """
    # the curve of a rod may be slightly longer or shorter than the rod
    curve, scale = rod.curve, rod.curve.length / rod.length
    every = [(place.s / scale, place.continuity) for place in curve.breaks]
    # (arc length, number c of continuous derivatives) of the breaks that are not too smooth to matter; N has c - 1
    breaks = [(s, c) for s, c in every if 0 < s < rod.length and c < DEGREE - 1]
    cuts = [0.0, *(s for s, continuity in breaks if continuity < 2), rod.length]
    # the centre line may be off by 1e-6 mm; an error of N is multiplied by the distance from the centre line
    tolerance = np.array([1e-6] * 2 + [SURFACE_TOLERANCE / reach] * 2)

    def values(s: FloatArray) -> FloatArray:
        position, velocity = curve.derivatives(curve.parameter(s * scale), 1)
        return np.hstack([position, left_of(velocity) / norm(velocity)[:, None]])

    maps = []
    for a, b in pairwise(cuts):
        inner = {s: c for s, c in breaks if a < s < b}
        edges = np.array([a, *inner, b])
        turns = np.diff(np.interp(edges, rod.s, turns_along(rod.angle)))
        # in an initial span, the direction changes by at most 0.2 rad
        spans = _divide_spans(edges, np.maximum(np.ceil(turns / 0.2), 2))
        knots, rows = _fit_spline(values, spans, {s: c - 1 for s, c in inner.items()}, tolerance)
        maps.append(BentMap(knots, rows, frame))
        s, kappa = maps[-1].curvature
        i = np.abs(kappa).argmax()
        if abs(kappa[i]) * reach >= 1:
            raise InputError(
                "the radius of the curve {s:.4g} from its start is {given:.4g}. The surface of the strip "
                "is {reach:g} from the curve and would fold there. Use a thinner sheet or a gentler curve",
                s=Length(s[i]),
                given=Length(1 / abs(kappa[i])),
                reach=Length(reach),
            )
    return tuple(maps)


def _fit_spline(
    function: Callable[[FloatArray], FloatArray],
    edges: FloatArray,
    smooth: Mapping[float, int],
    tolerance: FloatArray,
) -> tuple[FloatArray, FloatArray]:
    """Return knots and coefficients of a spline that approximates a function within `tolerance`.

    `edges` are the ends of the first spans. `tolerance` has a limit for each column of the function. `smooth` has
    the number of continuous derivatives at each kink, by its position. Spans are divided until the error at five
    places of each span is within the tolerance.
    """
    while True:
        knots = clamped_knots(edges, smooth, DEGREE)
        sites = interpolation_sites(knots, DEGREE)
        # the error is measured at these positions in each span
        probes = (edges[:-1, None] + np.diff(edges)[:, None] * [0.06, 0.27, 0.5, 0.73, 0.94]).ravel()
        values = function(np.concatenate([sites, probes]))
        rows = interpolated(sites, values[: sites.size], knots, DEGREE)
        excess = np.abs(SplineFunction(knots, rows, DEGREE)(probes) - values[sites.size :]) / tolerance
        excess = excess.reshape(edges.size - 1, -1).max(axis=1)
        bad = excess > 1
        if not bad.any():
            return knots, rows
        # a curve that needs more spans in a face is refused
        if edges.size > 4000:
            raise NotConvergedError(
                "the bent strip cannot follow its curve {at:.6g} from the start, because the curvature "
                "changes too fast there: smooth the curve",
                at=Length(edges[:-1][bad][0]),
            )
        # the error is proportional to (length of the span) ** (DEGREE + 1), with a margin of 10 %
        parts = np.where(bad, np.ceil(1.1 * excess ** (1 / (DEGREE + 1))).clip(2, 4), 1)
        edges = _divide_spans(edges, parts)


def _divide_spans(edges: FloatArray, counts: FloatArray) -> FloatArray:
    # return the ends of spans (n + 1,) after span k is divided into `counts[k]` equal parts
    parts = counts.astype(int)
    width = (np.diff(edges) / parts).repeat(parts)
    return np.append(edges[:-1].repeat(parts) + numbers_in_groups(parts) * width, edges[-1])


Map: TypeAlias = Frame | BentMap


@dataclass
class BoundaryMaker:
    """Builder of the boundary of a strip from the regions of its flat pattern.

    The boundary is a surface at one height, or a solid between two heights. A corner has one vertex at each height,
    and a piece has one edge at each height, with successive indices from the lowest height.

    Attributes
    ----------
    corners : (k, 2) array
        Corners of the flat pattern, mm.
    maps : sequence of Frame or BentMap
        Map of each interval of the pattern: a frame for a plane part such as a tab, or a `BentMap`.
    heights : (low,) or (low, high)
        Heights above mid-thickness or above the frame, mm.
    vertices, edges, faces
        Parts of the boundary that are added so far.
    at_corner : dict of int to int
        Index of the lowest vertex of each corner.
    at_piece : dict of int to int
        Index of the lowest edge of each piece, by the number of the piece.
    posts : dict of int to int
        Index of the edge through the thickness at each corner.
    """

    corners: FloatArray
    maps: Sequence[Map]
    heights: tuple[float, ...]
    vertices: list[FloatArray] = field(default_factory=list)
    edges: list[Edge] = field(default_factory=list)
    faces: list[Face] = field(default_factory=list)
    at_corner: dict[int, int] = field(default_factory=dict)
    at_piece: dict[int, int] = field(default_factory=dict)
    posts: dict[int, int] = field(default_factory=dict)

    def boundary(self, regions: Sequence[Region]) -> Boundary:
        """Return a face for every region at the only height, or the closed surface between the two heights."""
        for region in regions:
            self._add_faces(region)
            rim = (piece for loop in region.loops for piece in loop if not piece.seam)
            for piece in rim if len(self.heights) > 1 else ():
                self._add_side(piece, self.maps[region.interval])
        return Boundary(np.array(self.vertices), tuple(self.edges), tuple(self.faces))

    def _add_edges(self, region: Region) -> None:
        """Add the vertices and edges of a region at every height, unless an adjacent region has added them."""
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
            start, end = (self.at_corner[i] for i in _corners_at_ends(piece))
            self.edges += [
                Edge(curve, piece.first, piece.last, start + level, end + level)
                for level, curve in enumerate(curves)
            ]

    def _add_faces(self, region: Region) -> None:
        """Add the faces at every height. Seen from above, each face is to the left of its loops."""
        self._add_edges(region)
        shape = self.maps[region.interval]
        surfaces: list[Surface]
        if isinstance(shape, Frame):
            surfaces = [PlaneSurface(frame) for frame in _levels(shape, self.heights)]
        else:
            low, high = zip(
                *(_y_limits(piece.segment) for loop in region.loops for piece in loop), strict=True
            )
            surfaces = [shape.surface(min(low), max(high), up) for up in self.heights]
        for level, surface in enumerate(surfaces):
            loops = tuple(
                tuple(
                    EdgeUse(
                        self.at_piece[piece.number] + level, piece.forward, _trace_on(shape, piece.segment)
                    )
                    for piece in loop
                )
                for loop in region.loops
            )
            self.faces.append(Face(surface, loops, outward=level == len(self.heights) - 1))

    def _add_side(self, piece: SegmentPart, shape: Map) -> None:
        """Add a side wall. Its parameters are u, the parameter of the piece, and v, the height."""
        low = self.at_piece[piece.number]
        surface = self._wall(piece, shape, self.edges[low], self.edges[low + 1])
        start, end = (self._edge_through_thickness(i, shape) for i in _corners_at_ends(piece))
        traces: list[StraightTrace | Segment | None] = [None] * 4
        if not isinstance(surface, PlaneSurface):
            below, above = _along(surface, (0.0, self.heights[1] - self.heights[0]))
            last, first = (StraightTrace((t, 0.0), (0.0, 1.0)) for t in (piece.last, piece.first))
            traces = [below, last, above, first]
        # around the wall: along the lower edge, up, back along the upper edge (`low + 1`), and down
        uses = zip((low, end, low + 1, start), (True, True, False, False), traces, strict=True)
        self.faces.append(Face(surface, (tuple(EdgeUse(*use) for use in uses),), outward=piece.forward))

    def _wall(self, piece: SegmentPart, shape: Map, low: Edge, high: Edge) -> Surface:
        """Return the surface of the side wall between the edges at both heights.

        Its parameters are u, the parameter of the piece, and v, the height.
        """
        segment, up = piece.segment, self.heights[0]
        if isinstance(shape, BentMap) and not _is_perpendicular(segment):
            least, most = _y_limits(segment)
            # straight walls (to 1e-9 mm) are planes, because CAD kernels can fuse coplanar walls of adjacent strips
            if most - least < 1e-9:
                # the normal is d/du cross d/dv, with u along the segment and v to the right of the curve
                side = -1.0 if segment.end[0] > segment.start[0] else 1.0
                frame = shape.frame.shifted(z=(least + most) / 2)
                return PlaneSurface(Frame(frame.origin, frame.x_axis, side * frame.y_axis))
            assert isinstance(low.curve, SpaceCurve)
            assert isinstance(high.curve, SpaceCurve)
            return self._ruled_surface(low.curve, low.curve.control_points, high.curve.control_points)
        if isinstance(segment, Line):
            a, b = self.vertices[low.start], self.vertices[low.end]
            return PlaneSurface(Frame(a, b - a, self.vertices[high.start] - a))
        assert isinstance(shape, Frame)  # edges across a bent part are lines
        if isinstance(segment, Arc):
            base = shape.shifted(float(segment.center[0]), float(segment.center[1]), up)
            return CylinderSurface(base, segment.radius)
        placed = PlacedSegment(segment, shape.shifted(z=up))
        if not isinstance(segment, Spline) or segment.curve.is_rational:
            return ExtrudedSurface(placed)
        points = placed.frame.point(segment.curve.control_points)
        return self._ruled_surface(segment.curve, points, points + (self.heights[1] - up) * shape.z_axis)

    def _ruled_surface(
        self, curve: SpaceCurve | PlaneCurve, low: FloatArray, high: FloatArray
    ) -> SpaceSurface:
        """Return the surface between two curves with control points (m, 3) and the knots of `curve`."""
        h = self.heights[1] - self.heights[0]
        knots = (curve.knots, np.array([0.0, 0.0, h, h]))
        return SpaceSurface(knots, np.stack([low, high], axis=1), (curve.degree, 1))

    def _edge_through_thickness(self, corner: int, shape: Map) -> int:
        """Return the index of the edge through the thickness at a corner, and add the edge if it is new."""
        if corner not in self.posts:
            low = self.at_corner[corner]
            rise = self.vertices[low + 1] - self.vertices[low]
            height = hypot(*rise.tolist())
            across = shape.frame.z_axis if isinstance(shape, BentMap) else shape.y_axis
            upright = Frame(self.vertices[low], rise, across)
            line = PlacedSegment(Line(np.zeros(2), np.array([height, 0.0])), upright)
            self.posts[corner] = len(self.edges)
            self.edges.append(Edge(line, 0.0, height, low, low + 1))
        return self.posts[corner]


def _along(wall: Surface, heights: tuple[float, ...]) -> Sequence[StraightTrace | Segment]:
    """Return the edges of a side wall at `heights`, in the parameters of the wall's surface.

    The edges get the knots of the wall, because CAD kernels integrate edges from knot to knot.
    """
    if not isinstance(wall, SpaceSurface):
        return [StraightTrace((0.0, height), (1.0, 0.0)) for height in heights]
    edges, _ = knot_runs(wall.knots[0])
    knots = np.pad(edges, 2, mode="edge")
    return graphs(knots, np.repeat(heights, edges.size + 1).reshape(len(heights), -1), degree=2)


def _trace_on(shape: Map, segment: Segment) -> StraightTrace | Segment | None:
    """Return the edge in the plane of the flat pattern, or None on a plane face, which needs no trace."""
    if isinstance(shape, Frame):
        return None
    if not isinstance(segment, Line):
        return segment
    x, y = segment.start.tolist()
    return StraightTrace((x, y), segment.direction)


def _levels(frame: Frame, heights: Sequence[float]) -> list[Frame]:
    return [frame.shifted(z=up) for up in heights]


def _y_limits(segment: Segment) -> tuple[float, float]:
    # return a range of y that contains the segment; that of a spline's control points may be too wide
    if isinstance(segment, Line):
        (_, y), (_, to_y) = segment.start.tolist(), segment.end.tolist()
        return min(y, to_y), max(y, to_y)
    rows = segment.curve.control_points if isinstance(segment, Spline) else segment.bounds
    return float(rows[:, 1].min()), float(rows[:, 1].max())


def _corners_at_ends(piece: SegmentPart) -> tuple[int, int]:
    """Return the start and end corners of a piece, in the direction of increasing parameter."""
    return (piece.start, piece.end) if piece.forward else (piece.end, piece.start)


def _points(shape: Map, flat: FloatArray, heights: Sequence[float]) -> FloatArray:
    # return points in space (k, levels, 3), mm: see `BentMap.points`
    if isinstance(shape, BentMap):
        return shape.points(flat, heights)
    return shape.point(flat)[:, None] + np.outer(heights, shape.z_axis)


def _curves(
    shape: Map, pieces: Sequence[SegmentPart], heights: Sequence[float]
) -> Iterator[Sequence[SpaceCurve | PlacedSegment]]:
    """Yield for each piece its curves in space, one at each height."""
    if not isinstance(shape, BentMap):
        frames = _levels(shape, heights)
        yield from ([PlacedSegment(piece.segment, frame) for frame in frames] for piece in pieces)
        return
    along = [(p.segment, p.first, p.last) for p in pieces if not _is_perpendicular(p.segment)]
    curves = iter(shape.curves(along, heights))
    for segment in (piece.segment for piece in pieces):
        if _is_perpendicular(segment):
            frames = _levels(shape.frame_at(float(segment.start[0])), heights)
            yield [PlacedSegment(segment, frame) for frame in frames]
        else:
            yield next(curves)


def _is_perpendicular(segment: Segment) -> bool:
    # the ends of such a line have equal x, except for rounding
    return isinstance(segment, Line) and abs(float(segment.start[0] - segment.end[0])) < 1e-12
