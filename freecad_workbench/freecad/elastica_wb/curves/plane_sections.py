# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Plane sections of bodies, surfaces and meshes, converted to smooth curves in sketches that strips can follow."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache, partial
from typing import Any

import FreeCAD as App
import numpy as np
import Part
from freecad.elastica_wb.curves.part_shapes import is_bounded, spline_geometry
from freecad.elastica_wb.curves.sketch_curves import container, placement_of
from freecad.elastica_wb.host.progress import Step, go_on, in_background
from freecad.elastica_wb.host.resources import QT_TRANSLATE_NOOP

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError, Length, Refusal, note
from elastica_cad.form_finding.plane_sections import mesh_sections
from elastica_cad.form_finding.section_lines import (
    PlaneSection,
    SectionCurve,
    SectionLine,
    collect_section,
    section_curves,
)
from elastica_cad.form_finding.section_spec import parallel_planes, planes_along, radial_planes
from elastica_cad.formats.chains import join_runs
from elastica_cad.formats.edges import Edge
from elastica_cad.formats.source_file import check_places
from elastica_cad.geometry.frame import Frame

AXES = {"X": (1.0, 0.0, 0.0), "Y": (0.0, 1.0, 0.0), "Z": (0.0, 0.0, 1.0)}
FAMILIES = ("parallel", "about an axis", "along a path")
CLOSED = ("left out", "left and right", "above and below")

# number of points along a wire of a section, divided equally among its edges; each edge has at least a quarter
# of this number
SECTION_POINTS = 240
# number of points along a path, so that planes are perpendicular within a fraction of a degree
PATH_POINTS = 400
# largest gap, mm, that is closed, because OpenCASCADE's sections have gaps of up to 1e-5 mm
JOIN_MM = 1e-4

STOPPED = "nothing was changed; take fewer planes, or try again"


@dataclass(frozen=True, eq=False)
class Family:
    """Planes that cut an object.

    Parameters
    ----------
    kind : str
        One of `FAMILIES`.
    count : int
        Number of planes.
    axis : str
        Normal of parallel planes, or line at which radial half planes end: X, Y or Z.
    through : (3,) sequence, optional
        A point on the axis of radial planes, mm. The default is the middle of the object.
    sweep : float
        Angle, degrees, over which radial planes are distributed.
    path : (n, 3) array, optional
        Points, mm, of a path to which the planes are perpendicular.
    """

    kind: str = "parallel"
    count: int = 5
    axis: str = "X"
    through: Sequence[float] | None = None
    sweep: float = 360.0
    path: FloatArray | None = None

    @property
    def half(self) -> bool:
        """True for half planes that end at an axis."""
        return self.kind == "about an axis"

    def planes(self, box: Any) -> list[tuple[str, Frame]]:
        """Return the name and plane of each cut through an object with bounding box `box`."""
        if self.kind not in FAMILIES or self.axis not in AXES or self.count < 1:
            raise InputError(
                "the cutting planes are not defined: choose their kind, an axis (X, Y or Z) and at least 1 plane"
            )
        axis, middle = AXES[self.axis], np.array(tuple(box.Center))
        fractions = (np.arange(self.count) + 0.5) / self.count
        if self.kind == "parallel":
            low, high = (getattr(box, f"{self.axis}{side}") for side in ("Min", "Max"))
            places = low + (high - low) * fractions
            up = (0.0, 1.0, 0.0) if self.axis == "Z" else (0.0, 0.0, 1.0)
            frames = parallel_planes((0.0, 0.0, 0.0), axis, places, up=up)
            names = [note("{axis} = {place}", axis=self.axis, place=Length(v)) for v in places]
        elif self.half:
            whole = self.sweep >= 360
            turns = np.linspace(0.0, self.sweep, self.count, endpoint=not whole)
            point = middle if self.through is None else self.through
            zero = (0.0, 1.0, 0.0) if self.axis == "X" else (1.0, 0.0, 0.0)
            frames = radial_planes(point, axis, np.radians(turns), zero=zero)
            names = [f"{v:.4g}°" for v in turns]
        elif self.path is None:
            raise InputError(
                "the path is missing: choose a sketch or a wire that is perpendicular to the planes"
            )
        else:
            along = np.abs(self.path[-1] - self.path[0])
            up = (0.0, 1.0, 0.0) if along[2] > 0.9 * np.linalg.norm(along) else (0.0, 0.0, 1.0)
            frames = planes_along(self.path, self.count, up=up)
            length = float(np.linalg.norm(np.diff(self.path, axis=0), axis=1).sum())
            names = [note("{s} along the path", s=Length(v)) for v in length * fractions]
        return list(zip(names, frames, strict=True))


def chosen_bodies(objects: Iterable[Any]) -> list[Any]:
    """Return the objects with faces or triangles, except datum planes."""
    bodies = [obj for obj in objects if _has_faces(obj)]
    if not bodies:
        raise InputError("nothing to cut is selected: select a body, a surface or a mesh")
    return bodies


def is_path(obj: Any) -> bool:
    """Return True if an object has edges but no faces, so that it can be the path of cutting planes."""
    shape = _shape(obj)
    return bool(shape.Edges) and not shape.Faces


def path_points(source: Any, names: Iterable[str] = ()) -> FloatArray:
    """Return points (n, 3) in document coordinates along the connected edges of an object.

    Raises
    ------
    InputError
        The object has no edges, several chains of edges, or infinite edges.
    """
    shape = _shape(source)
    edges = [shape.getElement(name) for name in names] or shape.Edges
    if not all(is_bounded(edge.BoundBox) for edge in edges):
        raise InputError("An edge is infinitely long. Trim this edge.")
    chains = Part.sortEdges(edges) if edges else []
    if len(chains) != 1:
        raise InputError(
            "{source} has {count} chains of edges. Choose the edges of a single chain as the path.",
            source=source.Label,
            count=len(chains),
        )
    return np.array([tuple(p) for p in Part.Wire(chains[0]).discretize(Number=PATH_POINTS)])


def box_of(source: Any) -> Any:
    """Return the bounding box of an object in document coordinates."""
    mesh = _mesh(source)
    if mesh is None:
        # `BoundBox` also contains the poles of splines
        return _shape(source).optimalBoundingBox(False)
    box = App.BoundBox()
    for point in mesh[0][[*np.argmin(mesh[0], axis=0), *np.argmax(mesh[0], axis=0)]]:
        box.add(App.Vector(*point.tolist()))
    return box


def cut(source: Any, family: Family, step: Step | None = None) -> list[PlaneSection]:
    """Cut a body, a surface or a mesh by the planes of a family, in document coordinates.

    Raises
    ------
    NotConvergedError
        The user stopped the computation: `step(finished planes)` returned False.
    """
    planes = family.planes(box_of(source))
    mesh = _mesh(source)
    if mesh is not None:
        frames = [frame for _, frame in planes]
        cut = partial(mesh_sections, *mesh, frames, half=family.half)
        sections = list(in_background(QT_TRANSLATE_NOOP("Elastica", "Cutting the mesh"), cut))
    else:
        shape, sections = _shape(source), []
        for i, (_, frame) in enumerate(planes):
            go_on(step, i, STOPPED)
            sections.append(_shape_section(shape, frame, f"section {i + 1}", family.half))
    return [
        _with_names(section, source.Label, place)
        for section, (place, _) in zip(sections, planes, strict=True)
    ]


def curves_of(
    sections: Iterable[PlaneSection],
    *,
    tolerance: float = 0.05,
    waves: float = 0.0,
    closed: str = CLOSED[0],
    step: Step | None = None,
) -> tuple[list[SectionCurve], list[str]]:
    """Return smooth curves along section lines, and messages on lines without a curve.

    `closed`, a value of `CLOSED`, selects whether closed lines are left out or cut by a plane through their
    middle. Waves shorter than `waves` mm are smoothed. A curve is at most `tolerance` mm from the smoothed
    points.
    """
    curves: list[SectionCurve] = []
    remarks: list[str] = []
    for i, section in enumerate(sections):
        go_on(step, i, STOPPED)
        lines = [part for line in section.lines for part in _split_if_closed(line, closed)]
        smooth, messages = section_curves(
            [replace(section, lines=tuple(lines))], tolerance=tolerance, wavelength=waves
        )
        curves += smooth
        remarks += messages
    return curves, remarks


def section_sketches(document: Any, source: Any, curves: Sequence[SectionCurve]) -> list[Any]:
    """Make a sketch for every curve. Several sketches are placed in a group."""
    sketches = []
    for curve in curves:
        sketch = document.addObject("Sketcher::SketchObject", "Section")
        sketch.Label = curve.name
        sketch.Placement = placement_of(curve.frame)
        number = sketch.addGeometry(spline_geometry(curve.curve), False)
        sketch.exposeInternalGeometry(number)
        sketches.append(sketch)
    if len(sketches) > 1:
        group = document.addObject("App::DocumentObjectGroup", "Curves")
        group.Label = f"{source.Label} curves"
        group.Group = sketches
    return sketches


def _shape(obj: Any) -> Part.Shape:
    shape = Part.getShape(obj)
    if not shape.isNull():
        shape.Placement = container(obj) * shape.Placement
    return shape


def _mesh(obj: Any) -> tuple[FloatArray, Any] | None:
    """Return the vertices, in document coordinates, and triangles of a mesh or linked mesh, or None."""
    source = _mesh_object(obj)
    if source is None:
        return None
    mesh, placement = source.Mesh, source.Placement.toMatrix().A
    fingerprint = mesh.CountPoints, mesh.CountFacets, mesh.Area, mesh.Volume, *placement
    vertices, faces = _arrays(source.Document.Name, source.Name, *fingerprint)
    place = container(obj) * obj.Placement
    if source is not obj and getattr(obj, "LinkTransform", False):
        place = place * source.Placement
    matrix = (place * source.Placement.inverse()).toMatrix()
    rows = np.array(matrix.A, dtype=float).reshape(4, 4)
    return vertices @ rows[:3, :3].T + rows[:3, 3], faces


@lru_cache(maxsize=4)
def _arrays(document: str, name: str, *_fingerprint: float) -> tuple[FloatArray, Any]:
    """Return the vertices and triangles of a mesh object.

    They are cached until the fingerprint of the mesh changes, because FreeCAD takes a second for a million
    points.
    """
    points, faces = App.getDocument(document).getObject(name).Mesh.Topology
    vertices = check_places(np.array([tuple(p) for p in points]).reshape(-1, 3))
    return vertices, np.array(faces, dtype=int).reshape(-1, 3)


def _mesh_object(obj: Any) -> Any:
    source = obj.getLinkedObject() if hasattr(obj, "getLinkedObject") else obj
    return source if source is not None and source.isDerivedFrom("Mesh::Feature") else None


def _has_faces(obj: Any) -> bool:
    source, shape = _mesh_object(obj), _shape(obj)
    if source is not None and source.Mesh.CountFacets > 0:
        return True
    return bool(shape.Faces) and is_bounded(shape.BoundBox)  # a datum plane has an infinite face


def _shape_section(shape: Part.Shape, frame: Frame, name: str, half: bool) -> PlaneSection:
    wires = shape.slice(App.Vector(*frame.z_axis), float(frame.z_axis @ frame.origin))
    chains = [chain for wire in wires for chain in _joined(_edge_points(wire.OrderedEdges))]
    closed = [points for points in chains if np.all(points[0] == points[-1])]
    whole = closed + _joined(points for points in chains if not np.all(points[0] == points[-1]))
    flat = [frame.local(points)[:, :2] for points in whole]
    return collect_section(name, frame, flat, half=half, apart=JOIN_MM)


def _edge_points(edges: Sequence[Part.Edge]) -> list[FloatArray]:
    """Return points along each edge alone, because FreeCAD crashes for some wires through a sphere's pole."""
    count = max(SECTION_POINTS // len(edges), SECTION_POINTS // 4)
    return [np.array([tuple(p) for p in edge.discretize(Number=count)]) for edge in edges]


def _joined(lines: Iterable[FloatArray]) -> list[FloatArray]:
    joined = []
    for run in join_runs([(Edge.polyline(line),) for line in lines], JOIN_MM).chains:
        points = np.concatenate([run[0].points, *(edge.points[1:] for edge in run[1:])])
        if np.linalg.norm(points[-1] - points[0]) <= JOIN_MM:
            points[-1] = points[0]
        joined.append(points)
    return joined


def _split_if_closed(line: SectionLine, closed: str) -> tuple[SectionLine, ...]:
    if not line.is_closed or closed == CLOSED[0]:
        return (line,)
    middle = (line.points.min(axis=0) + line.points.max(axis=0)) / 2
    across = line.frame.x_axis if closed == CLOSED[1] else line.frame.y_axis
    return line.split_by(line.frame.point(middle), across)


def _with_names(section: PlaneSection, label: str, place: str) -> PlaneSection:
    name = note("{source}, {section} ({place})", source=label, section=section.name, place=place)
    lines = tuple(
        replace(
            line, name=name if len(section.lines) == 1 else note("{name}, line {number}", name=name, number=k)
        )
        for k, line in enumerate(section.lines, start=1)
    )
    reports = tuple(
        note(report.text, **{**report.values, "name": name})
        if "name" in report.values
        else report.at(strip=label)
        for report in section.reports
        if isinstance(report, Refusal)
    )
    return replace(section, name=name, lines=lines, reports=reports)
