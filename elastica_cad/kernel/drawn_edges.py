"""Conversion of edges and wires of OpenCASCADE to plane curves."""

from collections import Counter
from collections.abc import Iterable, Sequence

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import is_series
from elastica_cad.errors import InputError
from elastica_cad.formats.edges import Edge as DrawnEdge
from elastica_cad.formats.edges import Run
from elastica_cad.formats.placed_curve import edge_chains, placed_curve
from elastica_cad.formats.source_file import check_places
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.kernel.occt import coordinates, sub_shapes
from elastica_cad.kernel.ocp_import import Shape, bare, kernel

OFFSET = 1e-6  # tolerance for offset curves, mm


def plane_curve(
    shape: Shape | Iterable[Shape], plane: Frame | None = None, *, turned: FloatArray | None = None
) -> tuple[PlaneCurve, Frame]:
    """Return the curve of an edge, a wire, or several consecutive edges, and the plane of the curve.

    NURBS, lines and conics are converted exactly. Offset curves are approximated to 1e-6 mm. `placed_curve`
    describes how the direction of the curve and the axes of the plane are chosen. Without `plane`, the axes are
    chosen for the edges before their rotation `turned` (3, 3), and rotate with the edges.
    """
    if _has_faces(shape):
        raise InputError(
            "A face or a body is not a curve. Use one of its edges, or cut it by planes with section_strips."
        )
    edges = _edges(shape)
    turned = _turned(edges) if turned is None else turned
    return placed_curve(list(map(_drawn_edge, edges)), plane=plane, turned=turned)


def _has_faces(shape: Shape | Iterable[Shape]) -> bool:
    shape = bare(shape)
    if isinstance(shape, kernel().TopoDS_Shape):
        return bool(sub_shapes(shape, "face"))
    return isinstance(shape, list | tuple) and any(map(_has_faces, shape))


def _turned(edges: Sequence[Shape]) -> FloatArray | None:
    """Return the rotation (3, 3) of the first edge since it was drawn, or None without rotation."""
    if not edges or edges[0].Location().IsIdentity():
        return None
    place = edges[0].Location().Transformation()
    rows = [[place.Value(i, j) for j in (1, 2, 3)] for i in (1, 2, 3)]
    return np.array(rows) / float(place.ScaleFactor())


def free_chains(shape: Shape) -> tuple[list[Run], dict[str, int]]:
    """Return the chains of edges that belong to no face, and how many other items of each kind were omitted."""
    edges, skipped = [], Counter[str]()
    for edge in sub_shapes(shape, "edge", "face"):
        try:
            edges.append(_drawn_edge(edge))
        except InputError as error:
            skipped[f"edge that cannot be read ({error})"] += 1
    faces = len(sub_shapes(shape, "face"))
    if faces:
        skipped["face with its edges"] = faces
    return edge_chains(edges), dict(skipped)


def drawn_edges(shape: Shape | Iterable[Shape]) -> list[DrawnEdge]:
    """Return all edges of a shape, or of several shapes, in order."""
    return list(map(_drawn_edge, _edges(shape)))


def _edges(shape: Shape | Iterable[Shape]) -> list[Shape]:
    """Return the edges of a shape, or of shapes nested in sequences."""
    shape = bare(shape)
    if not isinstance(shape, kernel().TopoDS_Shape):
        if not is_series(shape):
            raise InputError(
                f"an object of type {type(shape).__name__} is not an edge or wire of a CAD kernel. Pass a "
                "spline through the points, or the `line` of a builder."
            )
        return [edge for item in shape for edge in _edges(item)]
    return sub_shapes(shape, "edge")


def _drawn_edge(edge: Shape) -> DrawnEdge:
    """Return an edge of the kernel as a NURBS in its direction. Only offset curves are approximated."""
    k = kernel()
    curve = None if k.BRep_Tool.Degenerated_s(edge) else k.BRep_Tool.Curve_s(edge, 0.0, 1.0)
    if curve is None:
        raise InputError("An edge is degenerate because it has no curve in space. Choose another edge.")
    limits = k.BRepAdaptor_Curve(edge)
    first, last = limits.FirstParameter(), limits.LastParameter()
    if not (abs(first) < 1e100 and abs(last) < 1e100):
        raise InputError("An edge is infinitely long. Trim it.")
    basis = curve
    while isinstance(basis, k.Geom_TrimmedCurve):
        basis = basis.BasisCurve()
    try:
        trimmed = k.Geom_TrimmedCurve(curve, first, last)
        spline = (
            None if isinstance(basis, k.Geom_OffsetCurve) else k.GeomConvert.CurveToBSplineCurve_s(trimmed)
        )
    except Exception as error:  # the class of Standard_Failure depends on the Python binding
        raise InputError("The kernel cannot evaluate the curve of an edge. Draw the edge again.") from error
    if spline is None:
        followed = k.GeomConvert_ApproxCurve(trimmed, OFFSET, k.GeomAbs_Shape.GeomAbs_C2, 1000, 9)
        if not followed.HasResult() or followed.MaxError() > 10 * OFFSET:
            raise InputError(
                "An edge that was made by an offset has a kink or a cusp. Draw the wanted curve without an offset."
            )
        spline = followed.Curve()
    if spline.IsPeriodic():
        spline.SetNotPeriodic()
    places = range(1, spline.NbPoles() + 1)
    points = check_places(np.array([coordinates(spline.Pole(i)) for i in places]))
    weights = np.array([spline.Weight(i) for i in places]) if spline.IsRational() else None
    knots = [np.full(spline.Multiplicity(i), spline.Knot(i)) for i in range(1, spline.NbKnots() + 1)]
    drawn = DrawnEdge(np.concatenate(knots), points, spline.Degree(), weights)
    return drawn.reversed() if edge.Orientation() == k.TopAbs_Orientation.TopAbs_REVERSED else drawn
