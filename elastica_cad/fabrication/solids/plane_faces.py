"""The boundary of one plane face with holes, for kernels to extrude: an edge for every segment of its loops."""

from collections.abc import Sequence

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.solids.boundary_records import (
    Boundary,
    Edge,
    EdgeUse,
    Face,
    PlacedSegment,
    PlaneSurface,
)
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Arc, Segment, Spline


def plane_face(outline: Path, holes: Sequence[Path], frame: Frame, surface: Frame | None = None) -> Boundary:
    """An open boundary of one face in the xy plane of a frame, seen from above.

    Parameters
    ----------
    outline, holes : Path
        Closed loops, run either way; mm in the frame.
    surface : Frame, optional
        The same plane with the axes that its surface is to have.

    Examples
    --------
    >>> face = plane_face(Path.rectangle(4.0, 2.0), [Path.circle((2.0, 1.0), 0.5)], Frame())
    >>> len(face.vertices), len(face.edges), [len(loop) for loop in face.faces[0].loops]
    (5, 5, [4, 1])
    """
    corners: list[FloatArray] = []
    edges: list[Edge] = []
    loops = []
    for path, outer in ((outline, True), *((hole, False) for hole in holes)):
        along = path if (path.area > 0) == outer else path.reversed()
        first = len(corners)
        count = len(along.segments)
        uses = []
        for i, drawn in enumerate(along.segments):
            start, end = first + i, first + (i + 1) % count
            segment, forward = _anticlockwise(drawn)
            low, high = _limits(segment)
            uses.append(EdgeUse(len(edges), forward))
            ends = (start, end) if forward else (end, start)
            edges.append(Edge(PlacedSegment(segment, frame), low, high, *ends))
        corners += [segment.start for segment in along.segments]
        loops.append(tuple(uses))
    face = Face(PlaneSurface(surface or frame), tuple(loops))
    return Boundary(frame.point(np.array(corners)), tuple(edges), (face,))


def _anticlockwise(segment: Segment) -> tuple[Segment, bool]:
    """A segment as a kernel's curve may run, and whether the loop runs with it: arcs turn to the left."""
    if isinstance(segment, Arc) and segment.sweep < 0:
        return segment.reversed(), False
    return segment, True


def _limits(segment: Segment) -> tuple[float, float]:
    """First and last parameter of a placed segment."""
    if isinstance(segment, Arc):
        return segment.start_angle, segment.end_angle
    if isinstance(segment, Spline):
        return segment.curve.domain
    return 0.0, segment.length
