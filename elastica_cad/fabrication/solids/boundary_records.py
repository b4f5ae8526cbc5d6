"""Boundaries of bodies in space, free of any CAD kernel: frames, splines, edges and faces."""

from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.paths.segments import Segment

STRAIGHT = np.eye(2)
QUARTER = np.array([[0.0, -1.0], [1.0, 0.0]])


@dataclass(frozen=True, eq=False)
class SpaceCurve:
    """A B-spline curve in space: full clamped `knots`, `control_points` (m, 3) in mm, `degree`."""

    knots: FloatArray
    control_points: FloatArray
    degree: int


@dataclass(frozen=True, eq=False)
class PlacedSegment:
    """A plane segment put into space by a frame.

    Its parameter is the distance from the start on a `Line`, the angle on an `Arc`, the curve's own on a
    `Spline`.
    """

    segment: Segment
    frame: Frame


@dataclass(frozen=True, eq=False)
class SpaceSurface:
    """A tensor B-spline surface: knots and degrees for u and v, `control_points` (m, n, 3) in mm."""

    knots: tuple[FloatArray, FloatArray]
    control_points: FloatArray
    degree: tuple[int, int]

    def turned(self) -> "SpaceSurface":
        """Return the same surface, seen from the same side, by the parameters (-v, u)."""
        u, v = self.knots
        points = self.control_points[:, ::-1].swapaxes(0, 1)
        return SpaceSurface((-v[::-1], u), points, self.degree[::-1])


@dataclass(frozen=True, eq=False)
class PlaneSurface:
    """The plane of a frame; (u, v) are the frame's x and y."""

    frame: Frame


@dataclass(frozen=True, eq=False)
class CylinderSurface:
    """A cylinder about the frame's z axis; u is the angle from x, v the height, mm."""

    frame: Frame
    radius: float


@dataclass(frozen=True, eq=False)
class ExtrudedSurface:
    """A placed segment drawn along its frame's z axis; u is the segment's parameter, v the height, mm."""

    profile: PlacedSegment


Surface: TypeAlias = SpaceSurface | PlaneSurface | CylinderSurface | ExtrudedSurface


def trace_turn(surface: Surface) -> FloatArray:
    """(2, 2) matrix that takes traces to the parameters in which a kernel gets the surface.

    OpenCASCADE integrates areas and volumes span by span in v but by a single rule in u: a strip with its length
    in u would come out with a volume wrong by tenths. Splines are therefore handed over `turned`.
    """
    return QUARTER if isinstance(surface, SpaceSurface) else STRAIGHT


@dataclass(frozen=True, eq=False)
class StraightTrace:
    """An edge in the (u, v) plane of a surface: origin + parameter * direction, the direction of length 1."""

    origin: tuple[float, float]
    direction: tuple[float, float]


@dataclass(frozen=True, eq=False)
class Edge:
    """A piece `first` <= parameter <= `last` of a curve from vertex `start` to vertex `end`."""

    curve: SpaceCurve | PlacedSegment
    first: float
    last: float
    start: int
    end: int


@dataclass(frozen=True, eq=False)
class EdgeUse:
    """How a loop runs through an edge, and where the edge lies in the (u, v) plane of the face's surface.

    `trace` is a straight line or a segment (parameters as in `PlacedSegment`, equal to the edge's); None on
    planes.
    """

    edge: int
    forward: bool
    trace: StraightTrace | Segment | None = None


@dataclass(frozen=True, eq=False)
class Face:
    """A trimmed surface.

    The first loop is the outer one; loops keep the face to their left as seen from the side to which the
    surface's normal (d/du cross d/dv) points. `outward` is False where that side is the inside of the body.
    """

    surface: Surface
    loops: tuple[tuple[EdgeUse, ...], ...]
    outward: bool = True


@dataclass(frozen=True, eq=False)
class Boundary:
    """Faces that share edges that share vertices.

    Attributes
    ----------
    vertices : (k, 3) array
        mm.
    edges, faces
        Edges name vertices by row, faces name edges by position.
    """

    vertices: FloatArray
    edges: tuple[Edge, ...]
    faces: tuple[Face, ...]

    @property
    def is_closed(self) -> bool:
        """True where every edge is used exactly twice, once each way."""
        ways: list[list[int]] = [[] for _ in self.edges]
        for face in self.faces:
            for loop in face.loops:
                for use in loop:
                    ways[use.edge].append(1 if use.forward == face.outward else -1)
        return all(sorted(way) == [-1, 1] for way in ways)
