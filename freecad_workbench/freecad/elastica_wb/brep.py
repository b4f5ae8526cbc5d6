"""Boundary records as OpenCASCADE's BREP text: FreeCAD's Part can't build faces with given edges in (u, v).

The text holds what the record holds, digit for digit; nothing is projected, fitted or sewn.
"""

from collections.abc import Iterable, Sequence

import numpy as np

from elastica_cad.fabrication.boundary import (
    Boundary,
    CylinderSurface,
    Frame,
    PlacedSegment,
    PlaneSurface,
    SpaceCurve,
    SpaceSurface,
    StraightTrace,
    Surface,
)
from elastica_cad.geometry import Arc, Line, PlaneCurve, Segment

__all__ = ["brep_text"]

CONFUSION = 1e-7  # mm: OpenCASCADE's own tolerance of edges and faces
CORNER = 1e-6  # mm: gap that records may have between edges

_VERTEX, _EDGE, _OPEN, _CLOSED, _SOLID = "0101101", "0101000", "0101000", "0101100", "1100000"


def brep_text(boundary: Boundary) -> str:
    """A closed boundary as a solid, an open one as a shell."""
    text = _Text()
    vertices = [text.vertex(p) for p in boundary.vertices]
    traces: list[list[str]] = [[] for _ in boundary.edges]
    surfaces = [text.add(text.surfaces, _surface(face.surface)) for face in boundary.faces]
    for face, surface in zip(boundary.faces, surfaces, strict=True):
        for use in (use for loop in face.loops for use in loop if use.trace is not None):
            edge = boundary.edges[use.edge]
            number = text.add(text.traces, _trace(use.trace))
            traces[use.edge].append(f"2 {number} {surface} 0 {_reals((edge.first, edge.last))}")
    edges = [
        text.edge(
            _curve(edge.curve), (edge.first, edge.last), (vertices[edge.start], vertices[edge.end]), lines
        )
        for edge, lines in zip(boundary.edges, traces, strict=True)
    ]
    faces = []
    for face, surface in zip(boundary.faces, surfaces, strict=True):
        wires = [
            text.shape("Wi", (), _CLOSED, [(edges[use.edge], use.forward) for use in loop])
            for loop in face.loops
        ]
        number = text.shape("Fa", (f"0 {CONFUSION!r} {surface} 0",), _OPEN, [(w, True) for w in wires])
        faces.append((number, face.outward))
    closed = boundary.is_closed
    whole = text.shape("Sh", (), _CLOSED if closed else _OPEN, faces)
    if closed:
        whole = text.shape("So", (), _SOLID, [(whole, True)])
    return text.written(whole)


class _Text:
    """The numbered tables of a BREP text."""

    def __init__(self) -> None:
        self.traces: list[str] = []
        self.curves: list[str] = []
        self.surfaces: list[str] = []
        self.shapes: list[tuple[str, Sequence[tuple[int, bool]]]] = []

    @staticmethod
    def add(table: list[str], row: str) -> int:
        table.append(row)
        return len(table)

    def vertex(self, point: Sequence[float]) -> int:
        return self.shape("Ve", (repr(CORNER), _reals(point), "0 0"), _VERTEX, [])

    def edge(
        self, curve: str, limits: tuple[float, float], ends: tuple[int, int], traces: Sequence[str]
    ) -> int:
        number = self.add(self.curves, curve)
        rows = (f" {CONFUSION!r} 1 1 0", f"1 {number} 0 {_reals(limits)}", *traces, "0")
        return self.shape("Ed", rows, _EDGE, [(ends[0], True), (ends[1], False)])

    def shape(self, kind: str, rows: Iterable[str], flags: str, parts: Sequence[tuple[int, bool]]) -> int:
        """Number of a new shape made of earlier ones, each with its orientation."""
        self.shapes.append(("\n".join([kind, *rows, "", flags]), parts))
        return len(self.shapes)

    def written(self, whole: int) -> str:
        count = len(self.shapes)

        def named(number: int, forward: bool) -> str:
            return f"{'+' if forward else '-'}{count - number + 1} 0"

        shapes = [
            f"{head}\n{' '.join([*(named(*part) for part in parts), '*'])}" for head, parts in self.shapes
        ]
        tables = (
            ("Locations", []),
            ("Curve2ds", self.traces),
            ("Curves", self.curves),
            ("Polygon3D", []),
            ("PolygonOnTriangulations", []),
            ("Surfaces", self.surfaces),
            ("Triangulations", []),
            ("\nTShapes", shapes),
        )
        lines = [f"{name} {len(rows)}" + "".join(f"\n{row}" for row in rows) for name, rows in tables]
        head = "DBRep_DrawableShape\n\nCASCADE Topology V1, (c) Matra-Datavision"
        return "\n".join([head, *lines, "", named(whole, True), ""])


def _reals(*groups: Iterable[float]) -> str:
    return " ".join(" ".join(map(repr, np.asarray(group, dtype=float).ravel().tolist())) for group in groups)


def _knots(knots: Iterable[float]) -> tuple[int, str]:
    """Number of distinct knots, and each with its multiplicity."""
    values, counts = np.unique(knots, return_counts=True)
    pairs = zip(values.tolist(), counts.tolist(), strict=True)
    return len(values), " ".join(f"{value!r} {count}" for value, count in pairs)


def _axes(frame: Frame) -> str:
    return _reals(frame.origin, frame.z_axis, frame.x_axis, frame.y_axis)


def _spline(
    knots: Iterable[float], degree: int, points: Sequence[Sequence[float]], weights: object = None
) -> str:
    rows = np.asarray(points) if weights is None else np.column_stack([points, weights])
    count, text = _knots(knots)
    return f"7 {int(weights is not None)} 0 {degree} {len(rows)} {count} {_reals(rows)} {text}"


def _curve(curve: SpaceCurve | PlacedSegment) -> str:
    if isinstance(curve, SpaceCurve):
        return _spline(curve.knots, curve.degree, curve.control_points)
    segment, frame = curve.segment, curve.frame
    if isinstance(segment, Line):
        along = frame.direction(segment.end - segment.start)
        return f"1 {_reals(frame.point(segment.start), along / np.linalg.norm(along))}"
    if isinstance(segment, Arc):
        return f"2 {_axes(Frame(frame.point(segment.center), frame.x_axis, frame.y_axis))} {segment.radius!r}"
    return _placed(segment.curve, frame.point(segment.curve.control_points))


def _placed(curve: PlaneCurve, points: Sequence[Sequence[float]]) -> str:
    return _spline(curve.knots, curve.degree, points, curve.weights)


def _surface(surface: Surface) -> str:
    if isinstance(surface, PlaneSurface):
        return f"1 {_axes(surface.frame)}"
    if isinstance(surface, CylinderSurface):
        return f"2 {_axes(surface.frame)} {surface.radius!r}"
    if not isinstance(surface, SpaceSurface):
        return f"6 {_reals(surface.profile.frame.z_axis)}\n{_curve(surface.profile)}"
    rows, columns, _ = surface.control_points.shape
    (u_count, u), (v_count, v) = map(_knots, surface.knots)
    counts = f"9 0 0 0 0 {surface.degree[0]} {surface.degree[1]} {rows} {columns} {u_count} {v_count}"
    return f"{counts} {_reals(surface.control_points)} {u} {v}"


def _trace(trace: StraightTrace | Segment) -> str:
    if isinstance(trace, StraightTrace):
        return f"1 {_reals(trace.origin, trace.direction)}"
    if isinstance(trace, Line):
        along = trace.end - trace.start
        return f"1 {_reals(trace.start, along / np.linalg.norm(along))}"
    if isinstance(trace, Arc):
        return f"2 {_reals(trace.center, (1.0, 0.0), (0.0, 1.0))} {float(trace.radius)!r}"
    return _placed(trace.curve, trace.curve.control_points)
