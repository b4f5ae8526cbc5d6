"""Edges of a drawing as stored in its file: NURBS of any degree from 1, in the plane or in space."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.errors import InputError
from elastica_cad.geometry.plane_points import homogeneous, lengths_along, project
from elastica_cad.geometry.splines import Spans, bezier_spans, is_clamped, knot_runs, unit_circle_arc


@dataclass(frozen=True, eq=False)
class Source:
    """The shape in a file to which edges belong. Edges with equal sources belong to the same shape.

    Attributes
    ----------
    name : str
        Label, id or handle of the shape, as displayed by the drawing program.
    layer : str
    rounding : float
        Half a unit of the last digit of the coordinates, mm.
    id : str
        Id or handle of the shape.
    is_named : bool
        True if a person chose the name, False if a program made it.
    """

    name: str = ""
    layer: str = ""
    rounding: float = 0.0
    id: str = ""
    is_named: bool = False


@dataclass(frozen=True, eq=False)
class Edge:
    """A line, polyline, arc or spline of a drawing, as a B-spline.

    Parameters
    ----------
    knots : (m + degree + 1,) array
        Full knot vector, clamped or not.
    points : (m, 2) or (m, 3) array
        Control points; for degree 1 the vertices of a polyline.
    degree : int
        1 or more.
    weights : (m,) array, optional
        Rational weights, positive.
    source : Source, optional
        The shape in the file to which the edge belongs.
    """

    knots: FloatArray
    points: FloatArray
    degree: int
    weights: FloatArray | None = None
    source: Source | None = None

    def __post_init__(self) -> None:
        knots, points = np.array(self.knots, dtype=float), np.array(self.points, dtype=float)
        if not (np.all(np.isfinite(points)) and np.all(np.isfinite(knots))):
            raise InputError(
                "a curve has a coordinate or knot that is not a finite number: export the file again"
            )
        count = len(points)
        if self.degree < 1 or count <= self.degree:
            raise InputError(
                (
                    "a spline of degree {degree} has {count} control points but needs at least {degree_2}: draw "
                    "the spline again"
                ),
                degree=self.degree,
                count=count,
                degree_2=self.degree + 1,
            )
        if knots.shape != (count + self.degree + 1,) or np.any(np.diff(knots) < 0):
            raise InputError(
                "a spline of degree {degree} with {count} control points has {size} knots, but needs "
                "{given} in increasing order: draw the spline again",
                degree=self.degree,
                count=count,
                size=knots.size,
                given=count + self.degree + 1,
            )
        if not knots[self.degree] < knots[count]:
            raise InputError(
                "all knots of a spline are {knots:g}, so the spline has no length: draw the spline again",
                knots=knots[count],
            )
        vars(self).update(knots=knots, points=points)
        if self.weights is not None:
            weights = np.array(self.weights, dtype=float)
            if weights.shape != (count,) or not np.all(np.isfinite(weights)) or not np.all(weights > 0):
                raise InputError(
                    "a spline of {count} control points needs {count} positive finite weights, or none: "
                    "draw the spline again",
                    count=count,
                )
            same = np.ptp(weights) <= 1e-14 * weights[0]
            object.__setattr__(self, "weights", None if same else weights)

    @classmethod
    def polyline(cls, vertices: ArrayLike) -> "Edge":
        """Make a polyline through vertices (n, d), mm. Two vertices make a line."""
        vertices = np.asarray(vertices, dtype=float)
        inner = np.arange(len(vertices), dtype=float)
        return cls(np.concatenate([inner[:1], inner, inner[-1:]]), vertices, 1)

    @classmethod
    def bezier(cls, points: ArrayLike) -> "Edge":
        """Make an edge of a polynomial Bezier piece from its control points (degree + 1, d), mm."""
        points = np.asarray(points, dtype=float)
        degree = len(points) - 1
        return cls(np.repeat([0.0, 1.0], degree + 1), points, degree)

    @classmethod
    def arc(cls, center: ArrayLike, x_axis: ArrayLike, y_axis: ArrayLike, start: float, end: float) -> "Edge":
        """Make the exact rational arc center + x_axis cos(t) + y_axis sin(t), t from `start` to `end` (rad)."""
        knots, unit, weights = unit_circle_arc(start, end)
        return cls(
            knots,
            np.asarray(center, dtype=float) + unit @ np.array([x_axis, y_axis], dtype=float),
            2,
            weights,
        )

    @cached_property
    def spans(self) -> Spans:
        """Bezier pieces of the edge."""
        return bezier_spans(self.knots, self.degree)

    @cached_property
    def homogeneous(self) -> FloatArray:
        """Homogeneous control points (m, d + 1): coordinates times weight, then the weight."""
        return homogeneous(self.points, self.weights)

    def at(self, t: ArrayLike) -> FloatArray:
        """Return the points (n, d), mm, at parameters (n,) of the edge's knots."""
        # without the whole matrix of basis functions, which is large for a long polyline
        local, index = self.spans.local_basis(np.atleast_1d(np.asarray(t, dtype=float)))
        near = self.homogeneous[self.spans.first[index][:, None] + np.arange(self.degree + 1)]
        return project(np.einsum("nj,njd->nd", local, near))

    @property
    def start(self) -> FloatArray:
        """First point (d,)."""
        return self._ends[0]

    @property
    def end(self) -> FloatArray:
        """Last point (d,)."""
        return self._ends[1]

    @cached_property
    def _ends(self) -> tuple[FloatArray, FloatArray]:
        clamped = is_clamped(self.knots, self.degree)
        start, end = self.points[[0, -1]] if clamped else self.at(self.spans.edges[[0, -1]])
        return start, end

    @cached_property
    def size(self) -> float:
        """Length of the control polygon, mm, which is an upper bound of the length of the curve."""
        return float(lengths_along(self.points)[-1])

    @cached_property
    def length(self) -> float:
        """Length of the curve, mm, extrapolated from the chords of two divisions."""
        if self.degree == 1:
            return self.size
        points = self.at(self.stations())
        fine, coarse = (lengths_along(points[::k])[-1] for k in (1, 2))
        return float(4 * fine - coarse) / 3

    def stations(self, each: int = 17) -> FloatArray:
        """Return parameters along the edge: `each` in every span, including the ends of the span."""
        edges = self.spans.edges
        places = edges[:-1, None] + np.diff(edges)[:, None] * np.linspace(0, 1, each)
        # `np.unique` would load all of numpy.ma
        return knot_runs(np.sort(places, axis=None))[0]

    def reversed(self) -> "Edge":
        """Return the reversed edge."""
        return replace(
            self,
            knots=self.knots[0] + self.knots[-1] - self.knots[::-1],
            points=self.points[::-1],
            weights=None if self.weights is None else self.weights[::-1],
        )

    def mapped(self, matrix: ArrayLike, offset: ArrayLike, source: Source | None = None) -> "Edge":
        """Return the edge with every point p moved to matrix @ p + offset. The matrix may drop a dimension."""
        points = self.points @ np.asarray(matrix, dtype=float).T + np.asarray(offset, dtype=float)
        source = source or self.source
        if not np.isfinite(points).all():
            return Edge(self.knots, points, self.degree, self.weights, source)
        # skip the checks that the original edge has passed
        edge = object.__new__(Edge)
        parts = {"knots": self.knots, "points": points, "degree": self.degree, "weights": self.weights}
        vars(edge).update(parts, source=source)
        return edge


Run = tuple[Edge, ...]
"""Consecutive edges, end to end."""


def size_of(run: Sequence[Edge]) -> float:
    """Return the sum of the sizes of the edges, mm."""
    return sum(edge.size for edge in run)


def sample_run(run: Iterable[Edge], each: int = 17) -> FloatArray:
    """Return points (n, d), mm, along all edges: `each` in every span."""
    return np.concatenate([edge.at(edge.stations(each)) for edge in run])


def reverse_run(run: Sequence[Edge]) -> Run:
    """Return the run in the other direction: edges in reverse order, each reversed."""
    return tuple(edge.reversed() for edge in reversed(run))
