"""A path: a chain of lines, arcs and splines, open or closed."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import islice
from math import dist

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import is_number, numbers, require_flag, several
from elastica_cad.errors import InputError
from elastica_cad.geometry.boxes import box_around, boxes_about
from elastica_cad.geometry.curves.nurbs_curve import FAR_SIZES
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.chords import chord_points
from elastica_cad.geometry.paths.segments import (
    Arc,
    Line,
    Segment,
    Spline,
    place,
    point,
    segment_from_bulge,
)
from elastica_cad.geometry.paths.spline_table import SplineTable
from elastica_cad.geometry.plane_matrices import is_similarity, similarity_of
from elastica_cad.geometry.polynomials.circles import points_on_circles

JOIN = 1e-6
"""Largest gap between the ends of neighbouring segments, mm."""

NEAR_MM = 1e6
"""Shifted by less, rounding opens no gap."""

MOST_OF_A_TURN = 6.28
"""rad: arcs that turn by more may be circles, which end exactly where they begin."""


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
                    f"the path has a gap of {gap:.3g} mm at {place(segment.end)}: the ends must meet"
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
            raise InputError(f"a rectangle of {width} by {height} mm: both sides must be positive")
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
        """mm."""
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
        total, alike = 0.0, dict[int, list[PlaneCurve]]()
        for segment in self.segments:
            if isinstance(segment, Spline) and not segment.curve.is_rational:
                alike.setdefault(segment.curve.degree, []).append(segment.curve)
            else:
                total += segment.swept_area(self.start)
        return total + sum(
            float(SplineTable(curves).swept_areas(self.start).sum()) for curves in alike.values()
        )

    @cached_property
    def bounds(self) -> FloatArray:
        """[[x_min, y_min], [x_max, y_max]], mm, exact."""
        ends = np.array([point for segment in self.segments for point in (segment.start, segment.end)])
        low, high = ends.min(axis=0), ends.max(axis=0)
        boxes = [segment.bounds for segment in self.segments if isinstance(segment, Arc)]
        if boxes:
            least, most = box_around(np.array(boxes))
            low, high = np.minimum(low, least), np.maximum(high, most)
        splines = [segment for segment in self.segments if isinstance(segment, Spline)]
        if not splines:
            return np.array([low, high])
        hulls = np.concatenate([spline.curve.control_points for spline in splines])
        begins = np.cumsum([0, *(len(spline.curve.control_points) for spline in splines[:-1])])
        least, most = np.minimum.reduceat(hulls, begins), np.maximum.reduceat(hulls, begins)
        # a spline lies within the hull of its control points: the one that reaches out farthest is asked
        while (beyond := np.maximum(low - least, most - high).max(axis=1)).max() > 0:
            k = int(beyond.argmax())
            box = splines[k].bounds
            low, high = np.minimum(low, box[0]), np.maximum(high, box[1])
            least[k], most[k] = low, high
        return np.array([low, high])

    def reversed(self) -> "Path":
        """The path run the other way."""
        return Path([segment.reversed() for segment in reversed(self.segments)], self.closed)

    @classmethod
    def of_sound(cls, segments: tuple[Segment, ...], closed: bool) -> "Path":
        """The path of segments that need no check: those of another one, moved."""
        made = object.__new__(cls)
        object.__setattr__(made, "segments", segments)
        object.__setattr__(made, "closed", closed)
        return made

    def transformed(self, matrix: ArrayLike) -> "Path":
        """The path moved by a 3x3 affine matrix; an uneven scaling turns arcs into exact rational splines."""
        m = numbers(matrix, "the matrix that a path is moved by")
        if not is_similarity(m):
            plain = [s.as_spline() if isinstance(s, Arc) else s for s in self.segments]
            return Path([s.transformed(m) for s in plain], self.closed)
        return move_paths([self], m)[0]

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


def move_paths(
    paths: Sequence[Path], matrix: FloatArray, shifts: FloatArray | None = None
) -> tuple[Path, ...]:
    """Paths moved by a 3x3 similarity, all at one go.

    Parameters
    ----------
    paths : sequence of Path
    matrix : (3, 3) array
    shifts : (n, 2) array, optional
        How far each is shifted, mm, in place of what the matrix says.

    Examples
    --------
    >>> squares = [Path.rectangle(1, 1)] * 2
    >>> moved = move_paths(squares, np.diag([2.0, 2.0, 1.0]), np.array([[0.0, 0.0], [5.0, 0.0]]))
    >>> [path.bounds.tolist() for path in moved]
    [[[0.0, 0.0], [2.0, 2.0]], [[5.0, 0.0], [7.0, 2.0]]]
    """
    if not paths:
        return ()
    counts = [len(path.segments) for path in paths]
    shifts = np.broadcast_to(matrix[:2, 2], (len(paths), 2)) if shifts is None else shifts
    segments = [segment for path in paths for segment in path.segments]
    moved = iter(_move_segments(segments, matrix, np.repeat(shifts, counts, axis=0)))
    scale, *_ = similarity_of(matrix)
    # gaps do not grow, nor does rounding count
    sound = scale <= 1 and float(np.abs(shifts).max()) < NEAR_MM
    found = []
    for path, count in zip(paths, counts, strict=True):
        own = tuple(islice(moved, count))
        found.append(Path.of_sound(own, path.closed) if sound else Path(own, path.closed))
    # a box along the axes stays one
    keeps_boxes = not (matrix[[0, 1], [1, 0]].any() and matrix[[0, 1], [0, 1]].any())
    if keeps_boxes and (known := [k for k, path in enumerate(paths) if "bounds" in vars(path)]):
        corners = _placed(np.array([paths[k].bounds for k in known]), matrix, shifts[known])
        for k, box in zip(known, boxes_about(corners), strict=True):
            vars(found[k])["bounds"] = box
    return tuple(found)


def _move_segments(segments: Sequence[Segment], matrix: FloatArray, shifts: FloatArray) -> list[Segment]:
    """The segments moved by a 3x3 similarity and shifts (n, 2), each as its own `transformed` has it."""
    moved: list[Segment] = list(segments)
    if lines := [(i, segment) for i, segment in enumerate(segments) if isinstance(segment, Line)]:
        _move_lines(moved, lines, matrix, shifts)
    if arcs := [(i, segment) for i, segment in enumerate(segments) if isinstance(segment, Arc)]:
        _move_arcs(moved, arcs, matrix, shifts)
    if curves := [(i, segment.curve) for i, segment in enumerate(segments) if isinstance(segment, Spline)]:
        _move_splines(moved, curves, matrix, shifts)
    return moved


def _placed(points: FloatArray, matrix: FloatArray, shifts: FloatArray) -> FloatArray:
    """Points (n, k, 2), each row shifted by its own way (n, 2)."""
    return np.asarray((points @ matrix[:2, :2].T + shifts[:, None]) / matrix[2, 2], dtype=float)


def _move_lines(
    moved: list[Segment], lines: Sequence[tuple[int, Line]], matrix: FloatArray, shifts: FloatArray
) -> None:
    """Put moved lines in the places of the old ones."""
    ends = np.array([(line.start, line.end) for _, line in lines])
    places = _placed(ends, matrix, shifts[[i for i, _ in lines]])
    places.setflags(write=False)
    sound = (places[:, 0] != places[:, 1]).any(axis=1) & np.isfinite(places).all(axis=(1, 2))
    for (i, _), (start, end), is_sound in zip(lines, places, sound.tolist(), strict=True):
        moved[i] = Line.of_sound(start, end) if is_sound else Line(start, end)


def _move_arcs(
    moved: list[Segment], arcs: Sequence[tuple[int, Arc]], matrix: FloatArray, shifts: FloatArray
) -> None:
    """Put moved arcs in the places of the old ones."""
    scale, turn, sign = similarity_of(matrix)
    centers = _placed(np.array([[arc.center] for _, arc in arcs]), matrix, shifts[[i for i, _ in arcs]])
    radii = np.array([arc.radius for _, arc in arcs]) * scale
    angles = turn + sign * np.array([(arc.start_angle, arc.end_angle) for _, arc in arcs])
    ends = points_on_circles(centers, radii[:, None], angles)
    for row in (centers, ends):
        row.setflags(write=False)
    sweeps = np.abs(angles[:, 1] - angles[:, 0])
    sound = np.isfinite(ends).all(axis=(1, 2)) & (radii > 0) & (sweeps > 0) & (sweeps < MOST_OF_A_TURN)
    rows = zip(arcs, centers[:, 0], radii.tolist(), angles.tolist(), ends, sound.tolist(), strict=True)
    for (i, _), center, radius, (first, last), own, is_sound in rows:
        moved[i] = (
            Arc.of_sound(center, radius, first, last, own) if is_sound else Arc(center, radius, first, last)
        )


def _move_splines(
    moved: list[Segment], curves: Sequence[tuple[int, PlaneCurve]], matrix: FloatArray, shifts: FloatArray
) -> None:
    """Put moved splines in the places of the old ones."""
    counts = np.array([len(curve.control_points) for _, curve in curves])
    begins = np.cumsum(counts) - counts
    rows = np.ones((int(counts.sum()), 3))
    for begin, (_, curve) in zip(begins.tolist(), curves, strict=True):
        own = rows[begin : begin + len(curve.control_points)]
        own[:, :2] = curve.control_points
        if curve.weights is not None:
            own *= curve.weights[:, None]
    linear = matrix.copy()
    linear[:2, 2] = 0.0
    image = rows @ linear.T
    image[:, :2] += rows[:, 2:] * np.repeat(shifts[[i for i, _ in curves]], counts, axis=0)
    points = image[:, :2] / image[:, 2:]
    low, high = np.minimum.reduceat(points, begins), np.maximum.reduceat(points, begins)
    # what lies much farther away than it is large loses digits, and is checked again
    sound = np.maximum(-low, high).max(axis=1) < FAR_SIZES * (high - low).max(axis=1)
    ends = [*begins[1:].tolist(), len(points)]
    for (i, curve), begin, end, is_sound in zip(curves, begins.tolist(), ends, sound.tolist(), strict=True):
        if is_sound and curve.provenance is None:
            own = points[begin:end]
            moved[i] = Spline(PlaneCurve.of_sound(curve.knots, own, curve.degree, curve.weights))
        else:
            linear[:2, 2] = shifts[i]
            moved[i] = Spline(curve.transformed(linear))
