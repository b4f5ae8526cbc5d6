"""Sections of CAD solids and NURBS surfaces by planes, through the installed kernel."""

from collections.abc import Sequence

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.formats.chains import chained
from elastica_cad.formats.edges import Edge
from elastica_cad.forming.sections import Section, SectionLine, tidied
from elastica_cad.geometry import Frame
from elastica_cad.occt import Shape, drawn_edges, plane_axes_of

__all__ = ["shape_sections"]

JOIN = 1e-4
"""Ends of edges nearer than this meet, mm."""

POINTS = 120
"""Places on each span of an edge of a section."""


def shape_sections(shape: Shape, planes: Sequence[Frame]) -> tuple[Section, ...]:
    """What planes cut out of a body or a surface of OpenCASCADE, as `mesh_sections` gives it for meshes.

    Parameters
    ----------
    shape : TopoDS_Shape, or a wrapper of one
        Solid, shell or face, mm: a build123d object, or `.val()` of a CadQuery workplane.
    planes : sequence of Frame

    Returns
    -------
    tuple of Section
        Points lie on the surface itself, 120 to a span; a plane that misses gives a section without lines.

    Raises
    ------
    InputError
        No shape.
    """
    from OCP.BRepAlgoAPI import BRepAlgoAPI_Section
    from OCP.gp import gp_Pln

    shape = getattr(shape, "wrapped", shape)
    if shape is None or shape.IsNull():
        raise InputError("there is no shape to cut: give a solid, a shell or a face")
    return tuple(
        _section(BRepAlgoAPI_Section(shape, gp_Pln(plane_axes_of(frame))).Shape(), frame, f"section {number}")
        for number, frame in enumerate(planes, 1)
    )


def _section(cut: Shape, frame: Frame, name: str) -> Section:
    runs = chained([(edge,) for edge in drawn_edges(cut)], JOIN)
    lines = [_points(run, frame) for run in runs]
    lines = [line for line in lines if len(line) > 1]
    x, y, z = frame.origin
    reports: tuple[str, ...] = ()
    if not lines:
        reports = (f"{name} at ({x:.4g}, {y:.4g}, {z:.4g}) mm: the plane misses the shape",)
    elif len(lines) > 1:
        reports = (f"{name} at ({x:.4g}, {y:.4g}, {z:.4g}) mm falls into {len(lines)} lines",)
    names = [name] if len(lines) == 1 else [f"{name}, line {k + 1}" for k in range(len(lines))]
    found = [SectionLine(line, frame, called) for line, called in zip(lines, names, strict=True)]
    return Section(name, frame, tuple(sorted(found, key=lambda line: -line.length)), reports)


def _points(run: Sequence[Edge], frame: Frame) -> FloatArray:
    """The chain's points in the plane, run the agreed way round."""
    parts = [frame.local(edge.at(edge.stations(POINTS)))[:, :2] for edge in run]
    points = np.concatenate([parts[0], *(part[1:] for part in parts[1:])])
    if np.linalg.norm(points[-1] - points[0]) <= JOIN:
        points[-1] = points[0]
    return tidied(points, JOIN)
