"""Solid records that a CAD kernel only translates: flat parts, and strips bent into their curves."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise, product
from typing import TypeAlias

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.fabrication.solids.bent_map import BentMap, bent_maps
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
from elastica_cad.fabrication.solids.joint_places import joint_places, levels, turned, with_faces
from elastica_cad.fabrication.solids.pattern_strips import CutPattern, Piece, Region, cut_across
from elastica_cad.fabrication.solids.smooth_pieces import in_smooth_pieces
from elastica_cad.fabrication.strip.flat_outline import graph
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Arc, Line, Segment, Spline
from elastica_cad.mechanics.rod.rod_record import Rod

Map: TypeAlias = Frame | BentMap  # a tab lies in its tangent plane, the free part is bent

BESIDE_MM = 20.0  # between the flat and the bent strip of a file


@dataclass(frozen=True, eq=False)
class FlatSolid:
    """A plate: closed outline with holes, drawn in a frame and extruded along its z axis.

    Parameters
    ----------
    outline : Path
        Closed, mm.
    holes : tuple of Path
        Closed, inside the outline.
    thickness : float
        mm, from z = 0 to z = thickness of the frame.
    frame : Frame
        Where the drawing's plane lies in space.
    joints : mapping of str to Frame
        Places to join other parts to.

    Raises
    ------
    InputError
        An open loop or a thickness that is not positive.

    Examples
    --------
    >>> plate = FlatSolid(Path.rectangle(30, 20), (), 2.0)
    >>> plate.volume
    1200.0
    """

    outline: Path
    holes: tuple[Path, ...] = ()
    thickness: float = 1.0
    frame: Frame = field(default_factory=Frame)
    joints: Mapping[str, Frame] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if not (np.isfinite(self.thickness) and self.thickness > 0):
            raise InputError(f"plate thickness is {self.thickness}: it must be positive, in mm")
        if not all(path.closed for path in (self.outline, *self.holes)):
            raise InputError("a plate is made of closed loops: one of the paths given is open")

    @classmethod
    def of(cls, strip: Strip, frame: Frame | None = None) -> "FlatSolid":
        """The strip as cut, of a laminate its base: x runs from the start of the free part, z = 0 is below.

        Its joints are called as those of `BentSolid`.
        """
        return cls.layers(strip, frame)[0]

    @classmethod
    def layers(cls, strip: Strip, frame: Frame | None = None) -> tuple["FlatSolid", ...]:
        """Every sheet of the strip as glued flat, one on the other; the base has the joints."""
        frame = frame or Frame()
        heights = levels(strip)
        middle = frame.shifted(z=heights[-1] / 2)
        places = joint_places(strip).items()
        on_middle = {name: turned(middle.shifted(x, y), way) for name, (x, y, way) in places}
        joints = with_faces(on_middle, heights[-1])
        return tuple(
            cls(
                in_smooth_pieces(layer.outline),
                tuple(map(in_smooth_pieces, layer.holes)),
                layer.sheet.thickness,
                frame.shifted(z=low),
                {} if low else joints,
            )
            for layer, low in zip(strip.layers, heights[:-1], strict=True)
        )

    @property
    def area(self) -> float:
        """mm2."""
        return abs(self.outline.area) - sum(abs(hole.area) for hole in self.holes)

    @property
    def volume(self) -> float:
        """mm3."""
        return self.area * self.thickness


@dataclass(frozen=True, eq=False)
class BentSolid:
    """A strip bent into its rod's curve, with its thickness half to either side of the curve.

    The flat pattern's x follows the curve, its y stands across (the frame's z), and its upper side turns to
    the right of the curve. Tabs go on straight along the end tangents.

    Attributes
    ----------
    pattern : CutPattern
        The flat pattern cut where tabs begin and where the curvature jumps.
    maps : tuple
        How each interval of it gets into space: a `BentMap`, or the plane of a tab as a `Frame`.
    heights : (lower, upper)
        Where the two faces lie over the curve, mm.
    frame : Frame
        The plane in which the curve is drawn.
    joints : mapping of str to Frame
        "start" and "end" of the free part, "hole1", "hole2", ...: half way through the thickness, z off the
        strip's upper side, x along the strip (outward at the ends); "hole1:top" and "hole1:bottom" lie on the
        strip's faces, z outward.
    """

    pattern: CutPattern
    maps: tuple[Map, ...]
    heights: tuple[float, float]
    frame: Frame
    joints: Mapping[str, Frame]

    @cached_property
    def boundary(self) -> Boundary:
        """The closed skin: B-spline faces on the free part, planes and cylinders on the tabs."""
        return _Sheets(self.pattern.points, self.maps, self.heights).solid(self.pattern.regions)

    @cached_property
    def middle(self) -> Boundary:
        """The open sheet half way through the thickness; its area is the flat area."""
        half_way = (self.heights[0] + self.heights[1]) / 2
        return _Sheets(self.pattern.points, self.maps, (half_way,)).sheet(self.pattern.regions)

    @classmethod
    def of(cls, strip: Strip, frame: Frame | None = None) -> "BentSolid":
        """Bend a strip, of a laminate its base; the curve is drawn in `frame` (the xy plane unless told).

        Raises
        ------
        InputError
            A radius below half the thickness, or loops of the flat pattern that cross.
        NotConvergedError
            A curve too wild to be followed to 1e-6 mm.
        """
        return next(cls._layers(strip, frame))

    @classmethod
    def layers(cls, strip: Strip, frame: Frame | None = None) -> tuple["BentSolid", ...]:
        """Every sheet of the strip, the whole centred on the curve; the base has the joints. Errors as `of`."""
        return tuple(cls._layers(strip, frame))

    @classmethod
    def _layers(cls, strip: Strip, frame: Frame | None) -> Iterator["BentSolid"]:
        heights = levels(strip)
        joints: Mapping[str, tuple[float, float, int]] = joint_places(strip)
        half = heights[-1] / 2
        for layer, (low, high) in zip(strip.layers, pairwise(heights), strict=True):
            faces = (low - half, high - half)
            yield cls.wrapped(
                strip.rod,
                layer.outline,
                layer.holes,
                heights=faces,
                frame=frame,
                joints=joints,
                between=heights[-1],
            )
            joints = {}

    @classmethod
    def wrapped(
        cls,
        rod: Rod,
        outline: Path,
        holes: Sequence[Path] = (),
        *,
        heights: tuple[float, float],
        frame: Frame | None = None,
        joints: Mapping[str, tuple[float, float, int]] | None = None,
        between: float = 0.0,
    ) -> "BentSolid":
        """Wrap any flat pattern onto a rod's curve.

        Parameters
        ----------
        rod : Rod
            Its curve carries y = 0 of the pattern, x being arc length; beyond its ends the pattern is plane.
        outline, holes : Path
            Closed loops, mm.
        heights : (lower, upper)
            Where the two faces lie over the curve, mm, upward being its right side.
        frame : Frame, optional
            The plane of the curve.
        joints : mapping of str to (x, y, way), optional
            Flat places, on the curve's own height; the x axis of a joint runs along the strip where way is 1,
            against it where it is -1.
        between : float
            Thickness of the strip, mm: holes get joints on both its faces too; 0 for none.

        Raises
        ------
        InputError, NotConvergedError
            As `of`.
        """
        frame = frame or Frame()
        lower, upper = heights
        bent = bent_maps(rod, frame, max(abs(lower), abs(upper)))
        stations = [0.0, *(float(part.knots[-1]) for part in bent[:-1]), rod.length]
        loops = [in_smooth_pieces(loop) for loop in (outline, *holes)]
        pattern = cut_across(loops[0], loops[1:], stations)
        maps: tuple[Map, ...] = (bent[0].frame_at(0.0), *bent, bent[-1].frame_at(rod.length))
        places = {}
        for name, (x, y, way) in (joints or {}).items():
            shape = maps[int(np.searchsorted(stations, x))]
            tangent = shape.frame_at(x) if isinstance(shape, BentMap) else shape
            places[name] = turned(tangent.shifted(x, y), way)
        made = cls(pattern, maps, (lower, upper), frame, with_faces(places, between) if between else places)
        if not made.boundary.is_closed:
            raise InputError("the flat pattern's loops cross or touch: the bent strip has no closed skin")
        return made


@dataclass
class _Sheets:
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
            self._add_face(region, 0)
        return self._boundary()

    def solid(self, regions: Sequence[Region]) -> Boundary:
        """The closed skin between the two heights."""
        for region in regions:
            self._add_edges(region)
            for level in (0, 1):
                self._add_face(region, level)
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
        for piece in pieces:
            if piece.number in self.at_piece:
                continue
            self.at_piece[piece.number] = len(self.edges)
            start, end = (self.at_corner[i] for i in _ends(piece))
            curves = _curves(shape, piece, self.heights)
            self.edges += [
                Edge(curve, piece.first, piece.last, start + level, end + level)
                for level, curve in enumerate(curves)
            ]

    def _add_face(self, region: Region, level: int) -> None:
        """The region's face at a height: seen from above it lies to the left of its loops."""
        shape = self.maps[region.interval]
        loops = tuple(tuple(self._use(piece, shape, level) for piece in loop) for loop in region.loops)
        up = self.heights[level]
        surface: Surface
        if isinstance(shape, Frame):
            surface = PlaneSurface(shape.shifted(z=up))
        else:
            low, high = np.array([_across(piece.segment) for loop in region.loops for piece in loop]).T
            surface = shape.surface(float(low.min()), float(high.max()), up)
        self.faces.append(Face(surface, loops, outward=level == len(self.heights) - 1))

    def _use(self, piece: Piece, shape: Map, level: int) -> EdgeUse:
        """The piece's edge at a height; on a bent face its trace is the flat segment itself."""
        edge, segment = self.at_piece[piece.number] + level, piece.segment
        if isinstance(shape, Frame):
            return EdgeUse(edge, piece.forward)
        if isinstance(segment, Line):
            x, y = map(float, segment.start)
            dx, dy = map(float, (segment.end - segment.start) / segment.length)
            return EdgeUse(edge, piece.forward, StraightTrace((x, y), (dx, dy)))
        return EdgeUse(edge, piece.forward, segment)

    def _add_side(self, piece: Piece, shape: Map) -> None:
        """The wall over one piece of a loop; u follows the piece's parameter, v goes up."""
        low = self.at_piece[piece.number]
        surface = self._wall(piece, shape, self.edges[low], self.edges[low + 1])
        height = self.heights[1] - self.heights[0]
        start, end = (self._post(i, shape) for i in _ends(piece))
        traces: list[StraightTrace | Segment | None] = [None] * 4
        if not isinstance(surface, PlaneSurface):
            traces = [
                _along(surface, 0.0),
                StraightTrace((piece.last, 0.0), (0.0, 1.0)),
                _along(surface, height),
                StraightTrace((piece.first, 0.0), (0.0, 1.0)),
            ]
        uses = zip((low, end, low + 1, start), (True, True, False, False), traces, strict=True)
        self.faces.append(Face(surface, (tuple(EdgeUse(*use) for use in uses),), outward=piece.forward))

    def _wall(self, piece: Piece, shape: Map, low: Edge, high: Edge) -> Surface:
        segment, up = piece.segment, self.heights[0]
        straight = isinstance(segment, Line)
        if isinstance(shape, BentMap) and not (straight and segment.start[0] == segment.end[0]):
            if straight and segment.start[1] == segment.end[1]:
                side = -1.0 if segment.end[0] > segment.start[0] else 1.0
                frame = shape.frame.shifted(z=float(segment.start[1]))
                return PlaneSurface(Frame(frame.origin, frame.x_axis, side * frame.y_axis))
            if not (isinstance(low.curve, SpaceCurve) and isinstance(high.curve, SpaceCurve)):
                raise TypeError("edges of a bent face are splines")
            h = self.heights[1] - self.heights[0]
            points = np.stack([low.curve.control_points, high.curve.control_points], axis=1)
            return SpaceSurface((low.curve.knots, np.array([0.0, 0.0, h, h])), points, (low.curve.degree, 1))
        if straight:
            a, b = self.vertices[low.start], self.vertices[low.end]
            return PlaneSurface(Frame(a, b - a, self.vertices[high.start] - a))
        if isinstance(shape, BentMap):
            raise TypeError("only lines across stay plane on a bent strip")
        if isinstance(segment, Arc):
            base = shape.shifted(float(segment.center[0]), float(segment.center[1]), up)
            return CylinderSurface(base, segment.radius)
        return ExtrudedSurface(PlacedSegment(segment, shape.shifted(z=up)))

    def _post(self, corner: int, shape: Map) -> int:
        """The straight edge through the thickness at a corner."""
        if corner not in self.posts:
            low = self.at_corner[corner]
            rise = self.vertices[low + 1] - self.vertices[low]
            height = float(np.linalg.norm(rise))
            across = shape.frame.z_axis if isinstance(shape, BentMap) else shape.y_axis
            line = PlacedSegment(Line((0.0, 0.0), (height, 0.0)), Frame(self.vertices[low], rise, across))
            self.posts[corner] = len(self.edges)
            self.edges.append(Edge(line, 0.0, height, low, low + 1))
        return self.posts[corner]


def _along(wall: Surface, height: float) -> StraightTrace | Segment:
    """The trace of a wall's edge at a height.

    On a spline it has the spline's knots: kernels measure a face from knot to knot of its traces, and miss what
    bends between.
    """
    if not isinstance(wall, SpaceSurface):
        return StraightTrace((0.0, height), (1.0, 0.0))
    edges = np.unique(wall.knots[0])
    knots = np.concatenate([edges[:1], edges[:1], edges, edges[-1:], edges[-1:]])
    return graph(knots, np.full(edges.size + 1, height), degree=2)


def _across(segment: Segment) -> tuple[float, float]:
    """Bounds of y along a segment; of a spline those of its control points."""
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


def _curves(shape: Map, piece: Piece, heights: Sequence[float]) -> Sequence[SpaceCurve | PlacedSegment]:
    """The piece's segment in space at every height."""
    segment = piece.segment
    if isinstance(shape, BentMap):
        if not (isinstance(segment, Line) and segment.start[0] == segment.end[0]):
            return shape.curves(segment, piece.first, piece.last, heights)
        shape = shape.frame_at(float(segment.start[0]))
    return [PlacedSegment(segment, shape.shifted(z=up)) for up in heights]


def frame_beside(strip: Strip, frame: Frame) -> Frame:
    """Where the flat strip lies on the xy plane, clear of the one that is bent in `frame`."""
    outline = strip.outline.bounds
    reach = max(tab.length for tab in strip.ends) + sum(layer.sheet.thickness for layer in strip.layers)
    low, high = strip.rod.position.min(axis=0) - reach, strip.rod.position.max(axis=0) + reach
    corners = product((low[0], high[0]), (low[1], high[1]), outline[:, 1])
    lowest = float(frame.point(np.array(list(corners)))[:, 1].min())
    return Frame((0.0, lowest - BESIDE_MM - float(outline[1, 1]), 0.0))
