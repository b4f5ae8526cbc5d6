"""Boundaries of bodies in space, free of any CAD kernel: frames, splines, edges, faces."""

from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.errors import InputError
from elastica_cad.geometry import Segment

__all__ = [
    "Boundary",
    "CylinderSurface",
    "Edge",
    "EdgeUse",
    "ExtrudedSurface",
    "Face",
    "Frame",
    "PlacedSegment",
    "PlaneSurface",
    "SpaceCurve",
    "SpaceSurface",
    "StraightTrace",
]


@dataclass(frozen=True, eq=False)
class Frame:
    """Where a plane lies in space.

    Parameters
    ----------
    origin : (3,) array_like
        mm.
    x_axis, y_axis : (3,) array_like
        Directions at right angles to each other; they are brought to unit length.

    Raises
    ------
    InputError
        Numbers that are not finite, or axes that are not at right angles.

    Examples
    --------
    >>> upright = Frame(x_axis=(1, 0, 0), y_axis=(0, 0, 1))
    >>> upright.point([2.0, 3.0]).tolist()
    [2.0, 0.0, 3.0]
    """

    origin: FloatArray
    x_axis: FloatArray
    y_axis: FloatArray

    def __init__(
        self,
        origin: ArrayLike = (0.0, 0.0, 0.0),
        x_axis: ArrayLike = (1.0, 0.0, 0.0),
        y_axis: ArrayLike = (0.0, 1.0, 0.0),
    ) -> None:
        rows = [np.array(v, dtype=float) for v in (origin, x_axis, y_axis)]
        for name, row in zip(("origin", "x_axis", "y_axis"), rows, strict=True):
            if row.shape != (3,) or not np.all(np.isfinite(row)):
                raise InputError(f"frame {name} must be three finite numbers, got {row.tolist()}")
        sizes = [float(np.linalg.norm(row)) for row in rows[1:]]
        if min(sizes) == 0 or abs(rows[1] @ rows[2]) > 1e-9 * sizes[0] * sizes[1]:
            raise InputError("frame x_axis and y_axis must be two directions at right angles to each other")
        for name, row, size in zip(("origin", "x_axis", "y_axis"), rows, (1.0, *sizes), strict=True):
            scaled = row / size
            scaled.setflags(write=False)
            object.__setattr__(self, name, scaled)

    @property
    def z_axis(self) -> FloatArray:
        """Unit normal of the plane, x_axis cross y_axis."""
        return np.asarray(self.axes[2], dtype=float)

    @cached_property
    def axes(self) -> FloatArray:
        """The three unit axes as rows (3, 3)."""
        a, b, c = self.x_axis
        d, e, f = self.y_axis
        rows = np.array([self.x_axis, self.y_axis, (b * f - c * e, c * d - a * f, a * e - b * d)])
        rows.setflags(write=False)
        return rows

    def point(self, local: ArrayLike) -> FloatArray:
        """Points in space (..., 3) of local coordinates (..., 2) or (..., 3), mm."""
        return self.origin + self.direction(local)

    def direction(self, local: ArrayLike) -> FloatArray:
        """Vectors in space (..., 3) of local components (..., 2) or (..., 3)."""
        local = np.asarray(local, dtype=float)
        return np.asarray(local @ self.axes[: local.shape[-1]], dtype=float)

    def local(self, points: ArrayLike) -> FloatArray:
        """Local coordinates (..., 3) of points in space (..., 3), mm."""
        return np.asarray((np.asarray(points, dtype=float) - self.origin) @ self.axes.T, dtype=float)

    def within(self, outer: "Frame") -> "Frame":
        """This frame, given in the coordinates of `outer`, in space."""
        return Frame(outer.point(self.origin), outer.direction(self.x_axis), outer.direction(self.y_axis))

    def shifted(self, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> "Frame":
        """The frame with its origin moved along its own axes, mm."""
        return Frame(self.point((x, y, z)), self.x_axis, self.y_axis)


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
