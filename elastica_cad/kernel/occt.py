"""OpenCASCADE: records become its shapes."""

from collections.abc import Iterable, Sequence
from functools import lru_cache
from typing import Any

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.errors import InputError
from elastica_cad.fabrication.solids.boundary_records import (
    Boundary,
    CylinderSurface,
    ExtrudedSurface,
    PlacedSegment,
    PlaneSurface,
    SpaceCurve,
    StraightTrace,
    Surface,
    trace_turn,
)
from elastica_cad.fabrication.solids.strip_solids import BodyRecord, FlatSolid, PrismSolid
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Arc, Line, Segment, Spline
from elastica_cad.geometry.polynomials.knot_runs import knot_runs
from elastica_cad.kernel.ocp_import import Shape, kernel

CONFUSION = 1e-7  # mm: OpenCASCADE's own tolerance of edges
_KEPT_KNOTS = 64  # knot vectors at a time: those of a wall, its edges and their traces
CORNER = 1e-6  # mm: gap that paths may have between segments


def make_wire(path: Path, frame: Frame | None = None) -> Shape:
    """A path as a TopoDS_Wire in the plane of `frame` (the xy plane unless told)."""
    k, frame = kernel(), frame or Frame()
    builder, wire = k.BRep_Builder(), k.TopoDS_Wire()
    builder.MakeWire(wire)
    corners = [_vertex(frame.point(segment.start)) for segment in path.segments]
    corners.append(corners[0] if path.closed else _vertex(frame.point(path.end)))
    for segment, start, end in zip(path.segments, corners[:-1], corners[1:], strict=True):
        forward = not (isinstance(segment, Arc) and segment.sweep < 0)
        drawn = segment if forward else segment.reversed()
        ends = (start, end) if forward else (end, start)
        edge = _edge(PlacedSegment(drawn, frame), *_range(drawn), *ends)
        builder.Add(wire, edge if forward else edge.Reversed())
    wire.Closed(path.closed)
    return wire


def make_face(outline: Path, holes: Sequence[Path] = (), frame: Frame | None = None) -> Shape:
    """A plane TopoDS_Face with holes; its normal is the frame's z axis."""
    k, frame = kernel(), frame or Frame()
    builder, face = k.BRep_Builder(), k.TopoDS_Face()
    builder.MakeFace(face, _surface(PlaneSurface(frame)), CONFUSION)
    builder.Add(face, make_wire(outline if outline.area > 0 else outline.reversed(), frame))
    for hole in holes:
        builder.Add(face, make_wire(hole.reversed() if hole.area > 0 else hole, frame))
    return face


def make_solid(record: BodyRecord | PrismSolid) -> Shape:
    """A record as a TopoDS_Solid."""
    k = kernel()
    if isinstance(record, PrismSolid):
        first, *rest = (make_solid(prism) for prism in record.added)
        whole = _combined(first, rest, k.BOPAlgo_Operation.BOPAlgo_FUSE)
        holes = [make_solid(prism) for prism in record.removed]
        return _only_solid(_with_few_faces(_combined(whole, holes, k.BOPAlgo_Operation.BOPAlgo_CUT)))
    if isinstance(record, FlatSolid) and record.is_prism:
        face = make_face(record.outline, record.holes, record.frame)
        return k.BRepPrimAPI_MakePrism(face, k.gp_Vec(*(record.frame.z_axis * record.thickness))).Shape()
    builder, solid = k.BRep_Builder(), k.TopoDS_Solid()
    builder.MakeSolid(solid)
    builder.Add(solid, make_shell(record.boundary))
    return solid


def with_shared_faces(solids: Sequence[Shape]) -> list[Shape]:
    """Solids that touch, with the faces in common where they do; each stays a solid of its own.

    Boolean operations of OpenCASCADE take for granted that the solids of one shape meet in common faces: cuts of
    two sheets that merely lie on each other lose one of them.
    """
    k = kernel()
    builder = k.BOPAlgo_Builder()
    for solid in solids:
        builder.AddArgument(solid)
    builder.SetGlue(k.BOPAlgo_GlueEnum.BOPAlgo_GlueShift)
    builder.SetRunParallel(True)
    builder.Perform()
    if builder.HasErrors():
        raise InputError("OpenCASCADE could not join the faces in which the sheets of a strip touch")
    return [image for solid in solids for image in _images(builder, solid)]


def _images(builder: Any, solid: Shape) -> list[Shape]:
    """What became of a solid: itself where nothing touches it."""
    return list(builder.Modified(solid)) or [solid]


def _combined(shape: Shape, others: Sequence[Shape], operation: Any) -> Shape:
    """A boolean operation of a shape with others."""
    if not others:
        return shape
    builder = kernel().BOPAlgo_BOP()
    builder.AddArgument(shape)
    for other in others:
        builder.AddTool(other)
    builder.SetOperation(operation)
    builder.Perform()
    if builder.HasErrors():
        raise InputError(
            "OpenCASCADE could not combine the prisms of a body: move them so that none just touch"
        )
    return builder.Shape()


def _with_few_faces(shape: Shape) -> Shape:
    """The shape with faces that go on in one plane joined, and edges that go on in one line."""
    joined = kernel().ShapeUpgrade_UnifySameDomain(shape, True, True, False)
    joined.Build()
    return joined.Shape()


def _only_solid(shape: Shape) -> Shape:
    """The one solid in a compound."""
    found = sub_shapes(shape, kernel().TopAbs_ShapeEnum.TopAbs_SOLID)
    if len(found) != 1:
        raise InputError(f"the prisms of a body leave {len(found)} pieces: they must make one")
    return found[0]


def sub_shapes(shape: Shape, *kinds: Any) -> list[Shape]:
    """Sub-shapes of the first kind, in order, without those inside sub-shapes of the second kind."""
    explorer = kernel().TopExp_Explorer(shape, *kinds)
    found = []
    while explorer.More():
        found.append(explorer.Current())
        explorer.Next()
    return found


def make_shell(boundary: Boundary) -> Shape:
    """Faces that share their edges as a TopoDS_Shell."""
    k = kernel()
    builder, shell = k.BRep_Builder(), k.TopoDS_Shell()
    builder.MakeShell(shell)
    vertices = [_vertex(point) for point in boundary.vertices]
    edges = [_edge(e.curve, e.first, e.last, vertices[e.start], vertices[e.end]) for e in boundary.edges]
    for record in boundary.faces:
        face = k.TopoDS_Face()
        builder.MakeFace(face, _surface(record.surface), CONFUSION)
        for loop in record.loops:
            wire = k.TopoDS_Wire()
            builder.MakeWire(wire)
            for use in loop:
                if use.trace is not None:
                    curve = _trace(use.trace, trace_turn(record.surface))
                    builder.UpdateEdge(edges[use.edge], curve, face, CONFUSION)
                builder.Add(wire, edges[use.edge] if use.forward else edges[use.edge].Reversed())
            wire.Closed(True)
            builder.Add(face, wire)
        builder.Add(shell, face if record.outward else face.Reversed())
    shell.Closed(boundary.is_closed)
    return shell


def make_location(frame: Frame) -> Any:
    """The TopLoc_Location that takes the world's axes to those of a frame."""
    k = kernel()
    place = k.gp_Trsf()
    place.SetTransformation(plane_axes_of(frame), k.gp_Ax3())
    return k.TopLoc_Location(place)


def _vertex(point: FloatArray) -> Shape:
    k = kernel()
    vertex = k.TopoDS_Vertex()
    k.BRep_Builder().MakeVertex(vertex, _pnt(point), CORNER)
    return vertex


def _edge(curve: SpaceCurve | PlacedSegment, first: float, last: float, start: Shape, end: Shape) -> Shape:
    k = kernel()
    builder, edge = k.BRep_Builder(), k.TopoDS_Edge()
    builder.MakeEdge(edge, _curve(curve), CONFUSION)
    builder.Add(edge, start.Oriented(k.TopAbs_Orientation.TopAbs_FORWARD))
    builder.Add(edge, end.Oriented(k.TopAbs_Orientation.TopAbs_REVERSED))
    builder.Range(edge, first, last)
    return edge


def _range(segment: Segment) -> tuple[float, float]:
    """The segment's own parameters, as told in `PlacedSegment`."""
    if isinstance(segment, Spline):
        return segment.curve.domain
    return (segment.start_angle, segment.end_angle) if isinstance(segment, Arc) else (0.0, segment.length)


def _curve(curve: SpaceCurve | PlacedSegment) -> Any:
    """A Geom_Curve with the record's parameter."""
    k = kernel()
    if isinstance(curve, SpaceCurve):
        return k.Geom_BSplineCurve(
            _array(k.Points, _pnts(curve.control_points)), *_knots(curve.knots), curve.degree
        )
    segment, frame = curve.segment, curve.frame
    if isinstance(segment, Line):
        return k.Geom_Line(
            _pnt(frame.point(segment.start)), _dir(frame.direction(segment.end - segment.start))
        )
    if isinstance(segment, Arc):
        axes = k.gp_Ax2(_pnt(frame.point(segment.center)), _dir(frame.z_axis), _dir(frame.x_axis))
        return k.Geom_Circle(axes, segment.radius)
    return _spline(
        k.Geom_BSplineCurve, _array(k.Points, _pnts(frame.point(segment.curve.control_points))), segment
    )


def _spline(kind: Any, points: Any, segment: Spline) -> Any:
    """A B-spline curve of OpenCASCADE, in the plane or in space."""
    curve = segment.curve
    if curve.weights is None:
        return kind(points, *_knots(curve.knots), curve.degree)
    weights = _array(kernel().Reals, map(float, curve.weights))
    return kind(points, weights, *_knots(curve.knots), curve.degree)


def _surface(surface: Surface) -> Any:
    k = kernel()
    if isinstance(surface, PlaneSurface):
        return k.Geom_Plane(plane_axes_of(surface.frame))
    if isinstance(surface, CylinderSurface):
        return k.Geom_CylindricalSurface(plane_axes_of(surface.frame), surface.radius)
    if isinstance(surface, ExtrudedSurface):
        return k.Geom_SurfaceOfLinearExtrusion(_curve(surface.profile), _dir(surface.profile.frame.z_axis))
    surface = surface.turned()
    rows, columns, _ = surface.control_points.shape
    grid = k.Grid(1, rows, 1, columns)
    for i, row in enumerate(surface.control_points, start=1):
        for j, point in enumerate(_pnts(row), start=1):
            grid.SetValue(i, j, point)
    (u, u_count), (v, v_count) = map(_knots, surface.knots)
    return k.Geom_BSplineSurface(grid, u, v, u_count, v_count, *surface.degree)


def _trace(trace: StraightTrace | Segment, turn: FloatArray) -> Any:
    """A Geom2d_Curve in the (u, v) plane of a surface."""
    k = kernel()

    def axis(origin: ArrayLike, direction: ArrayLike) -> Any:
        place, along = (np.array((origin, direction)) @ turn.T).tolist()
        return k.gp_Ax2d(k.gp_Pnt2d(*place), k.gp_Dir2d(*along))

    if isinstance(trace, StraightTrace):
        return k.Geom2d_Line(axis(trace.origin, trace.direction))
    if isinstance(trace, Line):
        return k.Geom2d_Line(axis(trace.start, trace.end - trace.start))
    if isinstance(trace, Arc):
        return k.Geom2d_Circle(axis(trace.center, (1.0, 0.0)), trace.radius)
    points = (k.gp_Pnt2d(*row) for row in (trace.curve.control_points @ turn.T).tolist())
    return _spline(k.Geom2d_BSplineCurve, _array(k.Points2d, points), trace)


def _array(kind: Any, values: Iterable[Any]) -> Any:
    """An OpenCASCADE array, counted from 1."""
    items = list(values)
    array = kind(1, len(items))
    for i, item in enumerate(items, start=1):
        array.SetValue(i, item)
    return array


def _knots(knots: FloatArray) -> tuple[Any, Any]:
    """Distinct knots and their multiplicities."""
    return _written_knots(knots.tobytes())


@lru_cache(maxsize=_KEPT_KNOTS)
def _written_knots(written: bytes) -> tuple[Any, Any]:
    """The same of knots as bytes; OpenCASCADE copies what its curves and faces are given."""
    k = kernel()
    values, counts = knot_runs(np.frombuffer(written))
    return _array(k.Reals, values.tolist()), _array(k.Integers, counts.tolist())


def _pnt(point: FloatArray) -> Any:
    return kernel().gp_Pnt(*point.tolist())


def _pnts(points: FloatArray) -> list[Any]:
    make = kernel().gp_Pnt
    return [make(*row) for row in points.tolist()]


def _dir(direction: FloatArray) -> Any:
    return kernel().gp_Dir(*direction.tolist())


def moved_frame(frame: Frame, motion: Any) -> Frame:
    """The frame after a gp_Trsf that moves, turns or mirrors; of an image x and z are kept, as frames are
    right-handed.
    """
    axes = plane_axes_of(frame).Transformed(motion)
    x, z = (np.array([d.X(), d.Y(), d.Z()]) for d in (axes.XDirection(), axes.Direction()))
    at = axes.Location()
    return Frame((at.X(), at.Y(), at.Z()), x, np.cross(z, x))


def plane_axes_of(frame: Frame) -> Any:
    """The frame's origin, normal and x axis for the kernel."""
    return kernel().gp_Ax3(_pnt(frame.origin), _dir(frame.z_axis), _dir(frame.x_axis))
