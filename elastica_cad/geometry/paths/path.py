"""A path: a chain of lines, arcs and splines, open or closed."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import dist

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import is_number, numbers, require_flag, several
from elastica_cad.errors import InputError
from elastica_cad.geometry.boxes import box_around
from elastica_cad.geometry.paths.segments import (
    Arc,
    Line,
    Segment,
    Spline,
    chord_points,
    place,
    point,
    segment_from_bulge,
)
from elastica_cad.geometry.plane_matrices import is_similarity
from elastica_cad.refusals import Length

JOIN = 1e-6
"""Largest gap between the ends of neighbouring segments, mm."""


@dataclass(frozen=True, eq=False)
class Path:
    """A chain of segments whose ends meet to 1e-6 mm.

    Parameters
    ----------
    segments : sequence of Line, Arc, Spline
        Each begins where the one before it ends.
    closed : bool
        True where the last segment ends at the start of the first.

    Raises
    ------
    InputError
        No segments, or ends that do not meet.

    Examples
    --------
    >>> plate = Path.rectangle(40, 10)
    >>> plate.area, plate.length
    (400.0, 100.0)
    """

    segments: tuple[Segment, ...]
    closed: bool = False

    def __init__(self, segments: Sequence[Segment], closed: bool = False) -> None:
        object.__setattr__(
            self, "segments", several("the segments of a path", segments, Segment, "Line, Arc and Spline")
        )
        object.__setattr__(self, "closed", require_flag(closed, "closed"))
        if not self.segments:
            raise InputError("a path needs at least one segment")
        following = self.segments[1:] + (self.segments[:1] if closed else ())
        for segment, after in zip(self.segments, following, strict=False):
            gap = dist(after.start.tolist(), segment.end.tolist())
            if not gap <= JOIN:
                raise InputError(
                    "the path has a gap of {gap} at {end}: the ends must meet",
                    gap=Length(gap),
                    end=place(segment.end),
                )

    @classmethod
    def polyline(cls, points: ArrayLike, bulges: ArrayLike | None = None, *, closed: bool = False) -> "Path":
        """Lines through `points` (n, 2); arcs where the point's bulge, tan(turn / 4) as in DXF, is not 0.

        Repeated points are passed over; a closed path may or may not repeat its first point at the end.
        """
        p = numbers(points, "the points of a polyline")
        if p.ndim != 2 or p.shape[1:] != (2,) or not np.all(np.isfinite(p)):
            raise InputError("a polyline needs finite points as rows (n, 2), in mm")
        b = np.zeros(len(p)) if bulges is None else numbers(bulges, "the bulges of a polyline")
        if b.shape != (len(p),) or not np.all(np.isfinite(b)):
            raise InputError("a polyline needs one finite bulge per point")
        after = np.roll(p, -1, axis=0) if require_flag(closed, "closed") else p[1:]
        segments = [
            segment_from_bulge(start, end, float(bulge))
            for start, end, bulge in zip(p, after, b, strict=False)
            if np.any(start != end)
        ]
        return cls(segments, closed)

    @classmethod
    def polygon(cls, points: ArrayLike) -> "Path":
        """The closed path of lines through `points` (n, 2)."""
        return cls.polyline(points, closed=True)

    @classmethod
    def rectangle(cls, width: float, height: float, *, corner: ArrayLike = (0.0, 0.0)) -> "Path":
        """A closed rectangle, anticlockwise from its lower left `corner`, mm."""
        if not (is_number(width) and is_number(height) and width > 0 and height > 0):
            raise InputError(
                "a rectangle of {width} by {height} mm: both sides must be positive",
                width=width,
                height=height,
            )
        x, y = point(corner, "the corner of a rectangle")
        return cls.polygon([(x, y), (x + width, y), (x + width, y + height), (x, y + height)])

    @classmethod
    def circle(cls, center: ArrayLike, radius: float) -> "Path":
        """A circle, anticlockwise, one arc."""
        return cls((Arc(center, radius, 0.0, 2 * np.pi),), closed=True)

    @property
    def start(self) -> FloatArray:
        """First point (2,), mm."""
        return self.segments[0].start

    @property
    def end(self) -> FloatArray:
        """Last point (2,), mm."""
        return self.segments[-1].end

    @property
    def widest_gap(self) -> float:
        """Between the end of a segment and the start of the next, mm: rounding, `JOIN` at most."""
        following = self.segments[1:] + (self.segments[:1] if self.closed else ())
        pairs = zip(self.segments, following, strict=False)
        return max((dist(one.end.tolist(), after.start.tolist()) for one, after in pairs), default=0.0)

    @cached_property
    def length(self) -> float:
        """Length of the path, mm."""
        return float(sum(segment.length for segment in self.segments))

    @cached_property
    def area(self) -> float:
        """Area inside a closed path, mm2: positive where it runs anticlockwise, negative clockwise.

        Raises
        ------
        InputError
            The path is open.
        """
        if not self.closed:
            raise InputError("an open path has no area: close it first")
        return sum(segment.swept_area(self.start) for segment in self.segments)

    @cached_property
    def bounds(self) -> FloatArray:
        """[[x_min, y_min], [x_max, y_max]], mm, exact."""
        return box_around(np.array([segment.bounds for segment in self.segments]))

    def reversed(self) -> "Path":
        """The path run the other way."""
        return Path([segment.reversed() for segment in reversed(self.segments)], self.closed)

    def transformed(self, matrix: ArrayLike) -> "Path":
        """The path moved by a 3x3 affine matrix; an uneven scaling turns arcs into exact rational splines."""
        m = numbers(matrix, "the matrix that a path is moved by")
        even = is_similarity(m)
        plain = [s.as_spline() if isinstance(s, Arc) and not even else s for s in self.segments]
        return Path([s.transformed(m) for s in plain], self.closed)

    def moved(self, x: float, y: float) -> "Path":
        """The path shifted by (x, y) mm."""
        return self.transformed([[1.0, 0.0, x], [0.0, 1.0, y], [0.0, 0.0, 1.0]])

    def points(self, tolerance: float) -> FloatArray:
        """Points (n, 2) on the path whose polyline stays within `tolerance` mm of it.

        The first point of a closed path is not repeated at the end.
        """
        rows = [chord_points(segment, tolerance)[:-1] for segment in self.segments]
        points = np.concatenate(rows if self.closed else [*rows, self.end[None]])
        if self.closed and len(points) < 3 and not all(isinstance(s, Line) for s in self.segments):
            return self.points(tolerance / 4)  # a thin lens keeps its inside
        return points

    @property
    def has_splines(self) -> bool:
        """True where a segment is a spline."""
        return any(isinstance(segment, Spline) for segment in self.segments)
