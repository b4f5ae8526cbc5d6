"""Writer of bodies in OpenCASCADE's binary BREP format, which OCP and FreeCAD's Part read.

Curves and surfaces are written exactly; nothing is projected, fitted or sewn.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from struct import pack

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.path import Arc, Line, Path, Segment, Spline
from elastica_cad.geometry.splines import knot_runs
from elastica_cad.strip.bent_boundary import (
    Boundary,
    CylinderSurface,
    Edge,
    EdgeUse,
    Face,
    PlacedSegment,
    PlaneSurface,
    SpaceCurve,
    SpaceSurface,
    StraightTrace,
    Surface,
    trace_turn,
)
from elastica_cad.strip.flat_pattern import on_segment, parameter_range

# default tolerance, mm, of edges and faces in OpenCASCADE
EDGE_TOLERANCE_MM = 1e-7

# version 3 is the first that stores the (u, v) coordinates of the ends of edges
_HEAD = b"\nOpen CASCADE Topology V3 (c)\n"
_SOLID, _SHELL, _FACE, _WIRE, _EDGE, _VERTEX = range(2, 8)
_LINE, _CIRCLE, _SPLINE_CURVE = 1, 2, 7
_PLANE, _CYLINDER, _EXTRUSION, _SPLINE_SURFACE = 1, 2, 6, 9
_KNOT = np.dtype([("place", "<f8"), ("count", "<i4")])

# flags of a shape, a byte each: free, modified, checked, orientable, closed, infinite, convex
_FLAGS = {
    (_VERTEX, False): bytes((0, 1, 0, 1, 1, 0, 1)),
    (_EDGE, False): bytes((0, 1, 0, 1, 0, 0, 0)),
    (_WIRE, False): bytes((0, 1, 0, 1, 0, 0, 0)),
    (_WIRE, True): bytes((0, 1, 0, 1, 1, 0, 0)),
    (_FACE, False): bytes((0, 1, 0, 1, 0, 0, 0)),
    (_SHELL, False): bytes((0, 1, 0, 1, 0, 0, 0)),
    (_SHELL, True): bytes((0, 1, 0, 1, 1, 0, 0)),
    (_SOLID, False): bytes((1, 1, 0, 0, 0, 0, 0)),
}


@dataclass(frozen=True)
class BinaryBrep:
    """A shape in the format of OpenCASCADE's BinTools. The last bytes of FreeCAD's files differ.

    Attributes
    ----------
    tables : bytes
        Curves, surfaces and shapes. The last shape contains all others.
    count : int
        Number of shapes.
    """

    tables: bytes
    count: int

    @property
    def for_bintools(self) -> bytes:
        """Return the file for BinTools.

        The file ends with the orientation, index and location of the last shape.
        """
        return self.tables + pack("<B2i", 0, 1, 0)

    @property
    def for_freecad(self) -> bytes:
        """Return the file for `Part.Shape.importBinary`.

        The file ends with the index, location and orientation of the last shape.
        """
        return self.tables + pack("<3i", self.count, 0, 0)


def boundary_brep(boundary: Boundary, gap: float = 1e-6) -> BinaryBrep:
    """Encode a closed boundary as a solid and an open boundary as a shell.

    The tolerance of vertices is `gap`, mm.
    """
    tables = _Tables()
    # for each edge, the records of its curves in the (u, v) planes of the faces
    traces: list[list[bytes]] = [[] for _ in boundary.edges]
    surfaces = [_added(tables.surfaces, _surface(face.surface)) for face in boundary.faces]
    for face, surface in zip(boundary.faces, surfaces, strict=True):
        turn = trace_turn(face.surface)
        for use in (use for loop in face.loops for use in loop):
            if use.trace is None:
                continue
            edge = boundary.edges[use.edge]
            number = _added(tables.traces, _trace(use.trace, turn))
            limits = np.array([edge.first, edge.last])
            ends = (_trace_ends(use.trace, limits) @ turn.T).ravel()
            # 2 is a curve on a surface: trace, surface, location, parameters and (u, v) of both ends
            traces[use.edge].append(pack("<B3i6d", 2, number, surface, 0, *limits, *ends))
    edges = tables.edges(boundary, traces, gap)
    faces = []
    for face, surface in zip(boundary.faces, surfaces, strict=True):
        wires = [tables.wire(loop, edges) for loop in face.loops]
        # no natural restriction, tolerance, surface, location, and 1 for no triangulation
        head = pack("<?d2iB", False, EDGE_TOLERANCE_MM, surface, 0, 1)
        faces.append((tables.shape(_FACE, head, [(wire, True) for wire in wires]), face.outward))
    closed = boundary.is_closed
    whole = tables.shape(_SHELL, b"", faces, closed=closed)
    if closed:
        tables.shape(_SOLID, b"", [(whole, True)])
    return tables.written()


def face_brep(outline: Path, holes: Sequence[Path], frame: Frame, surface: Frame | None = None) -> BinaryBrep:
    """Encode a plane face with holes as a shell. The normal is the z axis of the frame.

    Parameters
    ----------
    outline, holes : Path
        Closed loops in either direction; mm in the frame.
    surface : Frame, optional
        Frame of the face's surface: the same plane with other axes.
    """
    loops = [path if (path.area > 0) == (path is outline) else path.reversed() for path in (outline, *holes)]
    corners, edges, uses = _placed_in_space(loops, frame)
    face = Face(PlaneSurface(surface or frame), tuple(uses))
    return boundary_brep(Boundary(corners, edges, (face,)), _widest_gap(loops))


def wire_brep(path: Path, frame: Frame) -> BinaryBrep:
    """Encode a path, drawn in the xy plane of `frame`, as a wire."""
    corners, edges, (loop,) = _placed_in_space([path], frame)
    tables = _Tables()
    numbers = tables.edges(Boundary(corners, edges, ()), [[] for _ in edges], _widest_gap([path]))
    tables.wire(loop, numbers, closed=path.closed)
    return tables.written()


def _widest_gap(paths: Iterable[Path]) -> float:
    return max(EDGE_TOLERANCE_MM, *(path.widest_gap for path in paths))


def _placed_in_space(
    paths: Sequence[Path], frame: Frame
) -> tuple[FloatArray, tuple[Edge, ...], list[tuple[EdgeUse, ...]]]:
    """Place plane paths in space.

    Return the vertices (k, 3), an edge for every segment, and for each path its edges with their directions.
    """
    corners: list[FloatArray] = []
    edges: list[Edge] = []
    loops = []
    for path in paths:
        first, count = len(corners), len(path.segments)
        corners += [segment.start for segment in path.segments] + ([] if path.closed else [path.end])
        uses = []
        for i, segment in enumerate(path.segments):
            start, end = first + i, first + ((i + 1) % count if path.closed else i + 1)
            # OpenCASCADE stores arcs anticlockwise
            forward = not (isinstance(segment, Arc) and segment.sweep < 0)
            placed = PlacedSegment(segment if forward else segment.reversed(), frame)
            uses.append(EdgeUse(len(edges), forward))
            ends = (start, end) if forward else (end, start)
            edges.append(Edge(placed, *parameter_range(placed.segment), *ends))
        loops.append(tuple(uses))
    return frame.point(np.array(corners)), tuple(edges), loops


class _Tables:
    """Tables of a BREP file: curves, surfaces and shapes, to which other records refer by index."""

    def __init__(self) -> None:
        self.traces: list[bytes] = []
        self.curves: list[bytes] = []
        self.surfaces: list[bytes] = []
        self.shapes: list[tuple[bytes, Sequence[tuple[int, bool]]]] = []

    def shape(
        self, kind: int, geometry: bytes, parts: Sequence[tuple[int, bool]] = (), *, closed: bool = False
    ) -> int:
        """Add a shape, and return its index, from 1. `parts` has the index and orientation of each sub-shape."""
        self.shapes.append((bytes([kind]) + geometry + _FLAGS[kind, closed], parts))
        return len(self.shapes)

    def edges(self, boundary: Boundary, traces: Sequence[Iterable[bytes]], gap: float) -> list[int]:
        """Add the edges of a boundary with their (u, v) curves on the faces. Return the indices of the edges."""
        ends = [self.shape(_VERTEX, pack("<4dB", gap, *point, 0)) for point in boundary.vertices.tolist()]
        numbers = []
        for edge, rows in zip(boundary.edges, traces, strict=True):
            curve, limits = _added(self.curves, _curve(edge.curve)), (edge.first, edge.last)
            # tolerance; same parameter, same range, not degenerate; 1 is a curve in space: curve, location, limits
            head = pack("<d3?B2i2d", EDGE_TOLERANCE_MM, True, True, False, 1, curve, 0, *limits)
            parts = [(ends[edge.start], True), (ends[edge.end], False)]
            numbers.append(self.shape(_EDGE, b"".join([head, *rows, b"\0"]), parts))
        return numbers

    def wire(self, loop: Iterable[EdgeUse], edges: Sequence[int], *, closed: bool = True) -> int:
        return self.shape(_WIRE, b"", [(edges[use.edge], use.forward) for use in loop], closed=closed)

    def written(self) -> BinaryBrep:
        """Return all tables. In the format, indices of sub-shapes are counted backwards from the last shape."""
        count = len(self.shapes)
        shapes = [
            head + b"".join(pack("<B2i", not forward, count - number + 1, 0) for number, forward in parts)
            for head, parts in self.shapes
        ]
        tables: tuple[tuple[bytes, list[bytes]], ...] = (
            (b"Locations", []),
            (b"Curve2ds", self.traces),
            (b"Curves", self.curves),
            (b"Polygon3D", []),
            (b"PolygonOnTriangulations", []),
            (b"Surfaces", self.surfaces),
            (b"Triangulations", []),
            (b"\nTShapes", [row + b"*" for row in shapes]),
        )
        rows = [b"%s %d\n%s" % (name, len(table), b"".join(table)) for name, table in tables]
        return BinaryBrep(b"".join([_HEAD, *rows]), count)


def _added(table: list[bytes], row: bytes) -> int:
    # the index of the new row, from 1
    table.append(row)
    return len(table)


def _reals(*groups: Iterable[float]) -> bytes:
    return b"".join(np.asarray(group, dtype="<f8").tobytes() for group in groups)


def _knots(knots: FloatArray) -> tuple[int, bytes]:
    """Return the number of distinct knots, and bytes with each knot and its multiplicity."""
    places, counts = knot_runs(np.asarray(knots, dtype=float))
    rows = np.empty(places.size, dtype=_KNOT)
    rows["place"], rows["count"] = places, counts
    return rows.size, rows.tobytes()


def _axes(frame: Frame) -> bytes:
    x, y, z = frame.axes.tolist()
    return pack("<12d", *frame.origin.tolist(), *z, *x, *y)


def _spline(knots: FloatArray, degree: int, points: FloatArray, weights: FloatArray | None = None) -> bytes:
    rows = points if weights is None else np.column_stack([points, weights])
    count, written = _knots(knots)
    head = pack("<B2?H2i", _SPLINE_CURVE, weights is not None, False, degree, len(rows), count)
    return head + _reals(rows) + written


def _curve(curve: SpaceCurve | PlacedSegment) -> bytes:
    """Return the record of a curve in space: its type and data."""
    if isinstance(curve, SpaceCurve):
        return _spline(curve.knots, curve.degree, curve.control_points)
    segment, frame = curve.segment, curve.frame
    if isinstance(segment, Line):
        start, along = frame.point(segment.start), frame.direction(np.array(segment.direction))
        return bytes([_LINE]) + _reals(start, along)
    if isinstance(segment, Arc):
        center = Frame(frame.point(segment.center), frame.x_axis, frame.y_axis)
        return bytes([_CIRCLE]) + _axes(center) + _reals([segment.radius])
    spline = segment.curve
    return _spline(spline.knots, spline.degree, frame.point(spline.control_points), spline.weights)


def _surface(surface: Surface) -> bytes:
    """Return the record of a surface: its type and data."""
    if isinstance(surface, PlaneSurface):
        return bytes([_PLANE]) + _axes(surface.frame)
    if isinstance(surface, CylinderSurface):
        return bytes([_CYLINDER]) + _axes(surface.frame) + _reals([surface.radius])
    if not isinstance(surface, SpaceSurface):
        return bytes([_EXTRUSION]) + _reals(surface.profile.frame.z_axis) + _curve(surface.profile)
    surface = surface.turned()
    (u_count, u), (v_count, v) = map(_knots, surface.knots)
    counts = *surface.degree, *surface.control_points.shape[:2], u_count, v_count
    return pack("<B4?2H4i", _SPLINE_SURFACE, *[False] * 4, *counts) + _reals(surface.control_points) + u + v


def _trace(trace: StraightTrace | Segment, turn: FloatArray) -> bytes:
    """Return the record of an edge in the (u, v) plane of a surface, rotated by `turn` (2, 2)."""
    if isinstance(trace, StraightTrace):
        return pack("<B4d", _LINE, *turn @ trace.origin, *turn @ trace.direction)
    if isinstance(trace, Line):
        return pack("<B4d", _LINE, *turn @ trace.start, *turn @ trace.direction)
    if isinstance(trace, Arc):
        return bytes([_CIRCLE]) + _reals(turn @ trace.center, *turn.T, [trace.radius])
    curve = trace.curve
    return _spline(curve.knots, curve.degree, curve.control_points @ turn.T, curve.weights)


def _trace_ends(trace: StraightTrace | Segment, limits: FloatArray) -> FloatArray:
    # (u, v) of both ends (2, 2), at the parameters `limits` (2,); the ends of a whole spline are exact
    if isinstance(trace, StraightTrace):
        return trace.origin + limits[:, None] * trace.direction
    if isinstance(trace, Spline) and tuple(limits) == trace.curve.domain:
        return np.array([trace.start, trace.end])
    return on_segment(trace, limits)
