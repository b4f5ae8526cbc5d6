# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Boundary records as OpenCASCADE's binary BREP: FreeCAD's Part can't build faces with given edges in (u, v).

The bytes hold what the record holds, bit for bit; nothing is projected, fitted or sewn.
"""

from collections.abc import Iterable, Sequence
from functools import lru_cache
from struct import pack

import numpy as np
from freecad.elastica_wb.shapes.drawn_meshes import FaceMesh, Mesh

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.fabrication.solids.boundary_records import (
    Boundary,
    CylinderSurface,
    Edge,
    PlacedSegment,
    PlaneSurface,
    SpaceCurve,
    SpaceSurface,
    StraightTrace,
    Surface,
    trace_turn,
)
from elastica_cad.fabrication.solids.flat_pattern import on_segment
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.paths.segments import Arc, Line, Segment, Spline
from elastica_cad.geometry.polynomials.knot_runs import knot_runs

EDGE_TOLERANCE_MM = 1e-7  # mm: OpenCASCADE's own tolerance of edges and faces
VERTEX_TOLERANCE_MM = 1e-6  # mm: gap that records may have between edges

_HEAD = b"\nOpen CASCADE Topology V3 (c)\n"  # the first that says where edges end in (u, v)
_SOLID, _SHELL, _FACE, _WIRE, _EDGE, _VERTEX = range(2, 8)
_LINE, _CIRCLE, _SPLINE_CURVE = 1, 2, 7
_PLANE, _CYLINDER, _EXTRUSION, _SPLINE_SURFACE = 1, 2, 6, 9
_KNOT = np.dtype([("place", "<f8"), ("count", "<i4")])

# free, modified, checked, orientable, closed, infinite, convex
_FLAGS = {
    (_VERTEX, False): bytes((0, 1, 0, 1, 1, 0, 1)),
    (_EDGE, False): bytes((0, 1, 0, 1, 0, 0, 0)),
    (_WIRE, False): bytes((0, 1, 0, 1, 1, 0, 0)),
    (_FACE, False): bytes((0, 1, 0, 1, 0, 0, 0)),
    (_SHELL, False): bytes((0, 1, 0, 1, 0, 0, 0)),
    (_SHELL, True): bytes((0, 1, 0, 1, 1, 0, 0)),
    (_SOLID, False): bytes((1, 1, 0, 0, 0, 0, 0)),
}
_KINDS = [bytes([kind]) for kind in range(_VERTEX + 1)]


def brep_bytes(boundary: Boundary, gap: float = VERTEX_TOLERANCE_MM, mesh: Mesh | None = None) -> bytes:
    """A closed boundary as a solid, an open one as a shell, with the triangles of a mesh.

    Edges end within `gap` mm of their vertices.
    """
    tables = _Tables()
    vertices = [tables.shape(_VERTEX, pack("<4dB", gap, *point, 0)) for point in boundary.vertices.tolist()]
    traces: list[list[bytes]] = [[] for _ in boundary.edges]
    surfaces = [_added(tables.surfaces, _surface(face.surface)) for face in boundary.faces]
    for face, surface in zip(boundary.faces, surfaces, strict=True):
        turn = trace_turn(face.surface)
        for use in (use for loop in face.loops for use in loop if use.trace is not None):
            edge = boundary.edges[use.edge]
            number = _added(tables.traces, _trace(use.trace, turn))
            limits = edge.first, edge.last
            start, end = _trace_ends(use.trace, *limits)
            ends = *_turned(turn, start), *_turned(turn, end)
            traces[use.edge].append(pack("<B3i6d", 2, number, surface, 0, *limits, *ends))
    for number, face in enumerate(mesh.faces if mesh is not None else (), start=1):
        tables.triangulations.append(_triangulation(face, mesh.off))
        for edge, nodes in face.edges:
            polygon = _added(tables.polygons, _polygon(nodes, mesh.parameters[edge], mesh.off))
            traces[edge].append(pack("<B3i", 6, polygon, number, 0))
    edges = [
        tables.edge(edge, (vertices[edge.start], vertices[edge.end]), rows)
        for edge, rows in zip(boundary.edges, traces, strict=True)
    ]
    faces = []
    for number, (face, surface) in enumerate(zip(boundary.faces, surfaces, strict=True), start=1):
        wires = [
            tables.shape(_WIRE, b"", [(edges[use.edge], use.forward) for use in loop]) for loop in face.loops
        ]
        drawn = b"\1" if mesh is None else pack("<Bi", 2, number)
        head = pack("<?d2i", False, EDGE_TOLERANCE_MM, surface, 0) + drawn
        faces.append((tables.shape(_FACE, head, [(wire, True) for wire in wires]), face.outward))
    closed = boundary.is_closed
    whole = tables.shape(_SHELL, b"", faces, closed=closed)
    if closed:
        whole = tables.shape(_SOLID, b"", [(whole, True)])
    return tables.written(whole)


class _Tables:
    """The numbered tables of a BREP."""

    def __init__(self) -> None:
        self.traces: list[bytes] = []
        self.curves: list[bytes] = []
        self.surfaces: list[bytes] = []
        self.polygons: list[bytes] = []
        self.triangulations: list[bytes] = []
        self.shapes: list[tuple[bytes, Sequence[tuple[int, bool]]]] = []

    def shape(
        self, kind: int, geometry: bytes, parts: Sequence[tuple[int, bool]] = (), *, closed: bool = False
    ) -> int:
        """Number of a new shape made of earlier ones, each with its orientation."""
        self.shapes.append((_KINDS[kind] + geometry + _FLAGS[kind, closed], parts))
        return len(self.shapes)

    def edge(self, edge: Edge, ends: tuple[int, int], traces: Iterable[bytes]) -> int:
        number = _added(self.curves, _curve(edge.curve))
        head = pack("<d3?B2i2d", EDGE_TOLERANCE_MM, True, True, False, 1, number, 0, edge.first, edge.last)
        return self.shape(_EDGE, b"".join([head, *traces, b"\0"]), [(ends[0], True), (ends[1], False)])

    def written(self, whole: int) -> bytes:
        """All tables; shapes name each other from the last one backwards."""
        count = len(self.shapes)
        shapes = [
            head + b"".join(pack("<B2i", not forward, count - number + 1, 0) for number, forward in parts)
            for head, parts in self.shapes
        ]
        tables = (
            (b"Locations", []),
            (b"Curve2ds", self.traces),
            (b"Curves", self.curves),
            (b"Polygon3D", []),
            (b"PolygonOnTriangulations", self.polygons),
            (b"Surfaces", self.surfaces),
            (b"Triangulations", self.triangulations),
            (b"\nTShapes", [row + b"*" for row in shapes]),
        )
        rows = [b"%s %d\n%s" % (name, len(table), b"".join(table)) for name, table in tables]
        return b"".join([_HEAD, *rows, pack("<3i", whole, 0, 0)])


def _triangulation(face: FaceMesh, off: float) -> bytes:
    head = pack("<2i?d", len(face.points), len(face.triangles), False, off)
    return head + _reals(face.points) + (face.triangles + 1).astype("<i4").tobytes()


def _polygon(nodes: IntArray, parameters: FloatArray, off: float) -> bytes:
    count = nodes.size
    numbers = [node + 1 for node in nodes.tolist()]
    return pack(f"<{count + 1}id?{count}d", count, *numbers, off, True, *parameters.tolist())


def _added(table: list[bytes], row: bytes) -> int:
    table.append(row)
    return len(table)


def _reals(*groups: Iterable[float]) -> bytes:
    return b"".join(np.asarray(group, dtype="<f8").tobytes() for group in groups)


def _knots(knots: FloatArray) -> tuple[int, bytes]:
    """Number of distinct knots, and each with its multiplicity."""
    return _written_knots(np.asarray(knots, dtype=float).tobytes())


@lru_cache(maxsize=64)
def _written_knots(knots: bytes) -> tuple[int, bytes]:
    """The same of knots as bytes: edges and faces side by side share theirs."""
    places, counts = knot_runs(np.frombuffer(knots))
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
    if isinstance(curve, SpaceCurve):
        return _spline(curve.knots, curve.degree, curve.control_points)
    segment, frame = curve.segment, curve.frame
    if isinstance(segment, Line):
        return _straight(segment, frame)
    if isinstance(segment, Arc):
        center = Frame(frame.point(segment.center), frame.x_axis, frame.y_axis)
        return bytes([_CIRCLE]) + _axes(center) + _reals([segment.radius])
    return _placed(segment.curve, frame.point(segment.curve.control_points))


def _straight(line: Line, frame: Frame) -> bytes:
    """A line in space: most edges are, so its numbers are plain ones, not arrays."""
    (a, b, c), (u, v, w), _ = frame.axes.tolist()
    (at_x, at_y, at_z), (x, y), (dx, dy) = frame.origin.tolist(), line.start.tolist(), line.direction
    start = at_x + (x * a + y * u), at_y + (x * b + y * v), at_z + (x * c + y * w)
    return pack("<B6d", _LINE, *start, dx * a + dy * u, dx * b + dy * v, dx * c + dy * w)


def _placed(curve: PlaneCurve, points: FloatArray) -> bytes:
    return _spline(curve.knots, curve.degree, points, curve.weights)


def _surface(surface: Surface) -> bytes:
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
    if isinstance(trace, StraightTrace):
        return pack("<B4d", _LINE, *_turned(turn, trace.origin), *_turned(turn, trace.direction))
    if isinstance(trace, Line):
        return pack("<B4d", _LINE, *_turned(turn, trace.start.tolist()), *_turned(turn, trace.direction))
    if isinstance(trace, Arc):
        return bytes([_CIRCLE]) + _reals(turn @ trace.center, *turn.T, [trace.radius])
    return _placed(trace.curve, trace.curve.control_points @ turn.T)


def _turned(turn: FloatArray, place: Sequence[float]) -> tuple[float, float]:
    (a, b), (c, d) = turn.tolist()
    x, y = place
    return a * x + b * y, c * x + d * y


def _trace_ends(trace: StraightTrace | Segment, first: float, last: float) -> Sequence[Sequence[float]]:
    """Where an edge begins and where it ends."""
    if isinstance(trace, StraightTrace):
        (x, y), (dx, dy) = trace.origin, trace.direction
        return (x + first * dx, y + first * dy), (x + last * dx, y + last * dy)
    if isinstance(trace, Spline) and (first, last) == trace.curve.domain:
        return trace.start.tolist(), trace.end.tolist()
    ends: list[list[float]] = on_segment(trace, np.array((first, last))).tolist()
    return ends
