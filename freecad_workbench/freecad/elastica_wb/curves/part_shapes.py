# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Conversion of the core's records to shapes of FreeCAD's Part module, and of Part's edges to plane curves."""

import os
import re
import tempfile
from collections import Counter
from collections.abc import Iterable, Sequence
from functools import lru_cache, partial
from typing import Any

import FreeCAD as App
import numpy as np
import Part

from elastica_cad.errors import InputError
from elastica_cad.formats.brep_writer import BinaryBrep, boundary_brep, face_brep, wire_brep
from elastica_cad.formats.chains import holes_on_chains
from elastica_cad.formats.drawn_file import DrawnCurve, ReadReport, ReadUnit, report_on
from elastica_cad.formats.edges import Edge
from elastica_cad.formats.placed_curve import JOIN, edge_chains, in_plane, placed_curve
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.path import Path
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.splines import knot_runs
from elastica_cad.strip.solids import BodyRecord, FlatSolid, PrismSolid

# largest distance, mm, between an offset curve and its NURBS approximation
OFFSET_TOLERANCE_MM = 1e-6
# boxes larger than this, mm, count as infinite: datum planes and axes have boxes of 1e100 mm
ENDLESS_MM = 1e99


def make_wire(path: Path, frame: Frame | None = None) -> Part.Wire:
    """Make a wire of a path in the plane of `frame`, by default the xy plane."""
    return _read(wire_brep(path, frame or Frame())).Wires[0]


def spline_geometry(curve: PlaneCurve, frame: Frame | None = None) -> Part.BSplineCurve:
    """Convert a plane curve to Part geometry with the same poles, knots and weights."""
    spline = Part.BSplineCurve()
    knots, counts = knot_runs(curve.knots)
    points = [App.Vector(*p) for p in (frame or Frame()).point(curve.control_points).tolist()]
    weights = [1.0] * len(points) if curve.weights is None else curve.weights.tolist()
    spline.buildFromPolesMultsKnots(points, counts.tolist(), knots.tolist(), False, curve.degree, weights)
    return spline


def make_face(outline: Path, holes: Sequence[Path] = (), frame: Frame | None = None) -> Part.Face:
    """Make a plane face with holes."""
    frame = frame or Frame()
    about = _frame_about(tuple(frame.z_axis.tolist()))
    plane = Frame(frame.origin, about.x_axis, about.y_axis)
    return _read(face_brep(outline, holes, frame, plane)).Faces[0]


@lru_cache(maxsize=16)
def _frame_about(normal: tuple[float, float, float]) -> Frame:
    """Return a plane with the axes that OpenCASCADE would choose, which give the most accurate areas."""
    turn = Part.Plane(App.Vector(), App.Vector(*normal)).Rotation
    x, y = (tuple(turn.multVec(App.Vector(*axis))) for axis in ((1, 0, 0), (0, 1, 0)))
    return Frame(x_axis=x, y_axis=y)


def make_solid(record: BodyRecord | PrismSolid) -> Part.Shape:
    """Make the solid that a record describes."""
    if isinstance(record, PrismSolid):
        first, *rest = (make_solid(prism) for prism in record.added)
        whole = first.multiFuse(rest) if rest else first
        holes = [make_solid(prism) for prism in record.removed]
        return (whole.cut(holes) if holes else whole).removeSplitter()
    if isinstance(record, FlatSolid) and record.is_prism:
        face = make_face(record.outline, record.holes, record.frame)
        return face.extrude(App.Vector(*map(float, record.frame.z_axis * record.thickness)))
    return _read(boundary_brep(record.boundary))


def _read(brep: BinaryBrep) -> Part.Shape:
    """Return the shape of a binary BREP, which FreeCAD reads only from a file."""
    shape = Part.Shape()
    try:
        handle, name = tempfile.mkstemp(suffix=".bin", dir=_folder())
        try:
            with os.fdopen(handle, "wb") as file:
                file.write(brep.for_freecad)
            shape.importBinary(name)
        finally:
            os.unlink(name)
    except OSError as error:
        raise InputError(
            "The temporary file for the shape cannot be written ({why}). Make its folder writable and free "
            "some space.",
            why=error,
        ) from error
    return shape


def _folder() -> str:
    """Return a folder for temporary files. On Windows, FreeCAD opens only ASCII paths."""
    usual = tempfile.gettempdir()
    return usual if os.name != "nt" or usual.isascii() else os.environ["PROGRAMDATA"]


def is_bounded(box: App.BoundBox) -> bool:
    """Return True if a bounding box is neither empty nor infinite.

    In FreeCAD 1.1, the box of a body with datum planes is infinite.
    """
    return bool(box.isValid()) and bool(box.DiagonalLength < ENDLESS_MM)


def plane_curve(
    geometry: Iterable[Any], plane: Frame | None = None, gap: float = 0.0
) -> tuple[PlaneCurve, Frame]:
    """Return the single curve that edges or Part geometry form, and its plane.

    `plane` is the plane of the edges, if known. Gaps between edges of at most `gap` mm are closed.

    Raises
    ------
    InputError
        The edges form no curve or several curves, have corners, or are not in a plane.
    """
    return placed_curve(_exact_edges(geometry), plane=plane, join=max(JOIN, gap))


def report_on_edges(geometry: Iterable[Any], gap: float = 0.0) -> ReadReport | None:
    """Return the report on the curve that `plane_curve` returns for edges or Part geometry."""
    geometry = list(geometry)
    edges = _exact_edges(geometry)
    join = max(JOIN, gap)
    curve, frame = placed_curve(edges, join=join)
    ((chain,), _) = holes_on_chains(edge_chains(edges, join))
    flatten = partial(in_plane, frame=frame)
    read = DrawnCurve(1, lambda: curve, kinds=Counter(map(_kind, geometry)), chain=chain, flatten=flatten)
    return report_on([read], ReadUnit("mm", "stated", "the document"))


def _kind(item: Any) -> str:
    name = (item.Curve if isinstance(item, Part.Edge) else item).TypeId
    return "line" if "Line" in name else "arc" if re.search("Circle|Ellipse", name) else "spline"


def _exact_edges(geometry: Iterable[Any]) -> list[Edge]:
    edges = [_exact_edge(item) for item in geometry]
    if not edges:
        raise InputError("there is no curve: draw a spline for the strip to follow")
    return edges


def _exact_edge(item: Any) -> Edge:
    if isinstance(item, Part.Edge):
        if item.Degenerated:
            raise InputError("An edge is degenerate because it has no curve in space. Choose another edge.")
        edge = _spline_edge(_as_spline(item.Curve, *item.ParameterRange))
        return edge.reversed() if item.Orientation == "Reversed" else edge
    return _spline_edge(_as_spline(item, item.FirstParameter, item.LastParameter))


def _as_spline(curve: Any, first: float, last: float) -> Any:
    if isinstance(curve, Part.BSplineCurve):
        whole = abs(first - curve.FirstParameter) + abs(last - curve.LastParameter) < 1e-12 * (last - first)
        if whole and min(curve.getMultiplicities()[:: curve.NbKnots - 1]) > curve.Degree:
            return curve
        spline = curve.copy()
        # the method `segment` also converts a periodic spline to an open spline
        spline.segment(first, last)
        return spline
    if not (abs(first) < 1e100 and abs(last) < 1e100):
        raise InputError("An edge is infinitely long. Trim this edge.")
    if isinstance(curve, Part.OffsetCurve):
        return curve.approximateBSpline(OFFSET_TOLERANCE_MM, 1000, 9)
    return curve.toBSpline(first, last)


def _spline_edge(spline: Any) -> Edge:
    points = np.array([(p.x, p.y, p.z) for p in spline.getPoles()])
    weights = np.array(spline.getWeights()) if spline.isRational() else None
    return Edge(np.repeat(spline.getKnots(), spline.getMultiplicities()), points, spline.Degree, weights)
