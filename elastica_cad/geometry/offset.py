"""Offset of a path: a closed path becomes larger or smaller by a distance, an open path is moved sideways."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import require_number, require_record
from elastica_cad.errors import InputError, Length
from elastica_cad.geometry.approximations import cubic_through, smooth_stretches
from elastica_cad.geometry.path import (
    JOIN,
    Arc,
    Line,
    Path,
    Segment,
    Spline,
    distances,
    meets,
    require_tolerance_mm,
    trim_segment,
)
from elastica_cad.geometry.path_intersections import segment_crossings, self_crossing
from elastica_cad.geometry.plane_points import angle_of, left_of, norm, place, turn_between, unit


def offset_path(path: Path, distance: float, *, tolerance: float = 1e-4) -> Path:
    """Return the offset of a path by `distance` mm, exact for lines and arcs, within `tolerance` for splines.

    A closed path becomes larger if `distance` is positive and smaller if it is negative, whatever its direction.
    An open path moves to the left of its direction if `distance` is positive. Outer corners become arcs about the
    original corner, and inner corners are trimmed. The offset of a spline is a single cubic spline.

    Parameters
    ----------
    path : Path
        Path that does not cross itself.
    distance : float
        Distance of the offset, mm.
    tolerance : float
        Largest error of an offset spline, mm, measured between its interpolation points.

    Examples
    --------
    >>> grown = offset_path(Path.rectangle(40, 10), 1.0)
    >>> round(grown.area - (400 + 100 * 1.0), 6)  # plus four quarter circles
    3.141593
    """
    require_record(path, Path, "what is offset", "a Path")
    require_number(distance, "the offset", "mm")
    tolerance = require_tolerance_mm(tolerance)
    if distance == 0:
        return path
    left = distance
    if path.closed:
        if path.area == 0:
            raise InputError(
                f"the loop at {place(path.start)} encloses no area, so it has no offset: leave out this loop"
            )
        left = -distance * float(np.sign(path.area))
    moved = Path(_joined(_elements(path, left, tolerance), path.closed, distance), path.closed)
    _refuse_collisions(path, moved, distance, tolerance)
    return moved


@dataclass(frozen=True, eq=False)
class _Element:
    """Piece of the offset path before trimming.

    `piece` is a moved segment, an arc at a corner, or None for a vanished segment. `source_length`, mm, and the
    point `source` (2,) belong to the segment of the original path; at a corner they are 0 and the corner.
    """

    piece: Segment | None
    source_length: float
    source: FloatArray


def _elements(path: Path, left: float, tolerance: float) -> list[_Element]:
    """Return the moved segments of a path in order, with an arc at each corner that opens on this side."""
    segments = [part for segment in path.segments for part in _split_at_corners(segment)]
    following = segments[1:] + (segments[:1] if path.closed else [])
    elements: list[_Element] = []
    for i, segment in enumerate(segments):
        piece = _offset_segment(segment, left, tolerance)
        elements.append(_Element(piece, segment.length, segment.at(0.5)))
        if i < len(following):
            corner = _corner_arc(segment, following[i], left)
            if corner is not None:
                elements.append(_Element(corner, 0.0, segment.end))
    return elements


def _split_at_corners(segment: Segment) -> list[Segment]:
    if not isinstance(segment, Spline):
        return [segment]
    t0, t1 = segment.curve.domain
    corners = [(corner.t - t0) / (t1 - t0) for corner in segment.curve.tangent_breaks]
    return [trim_segment(segment, a, b) for a, b in pairwise([0.0, *corners, 1.0])]


def _offset_segment(segment: Segment, left: float, tolerance: float) -> Segment | None:
    """Return a segment moved by `left` mm to its left, or None for an arc that vanishes."""
    if isinstance(segment, Line):
        normal = left_of(segment.tangent_at(0.0))
        return Line(segment.start + left * normal, segment.end + left * normal)
    if isinstance(segment, Arc):
        radius = segment.radius - left * np.sign(segment.sweep)
        if radius <= JOIN:
            return None
        return Arc(segment.center, radius, segment.start_angle, segment.end_angle)
    return _moved_spline(segment, left, tolerance)


def _moved_spline(spline: Spline, left: float, tolerance: float) -> Spline:
    """Return a spline moved by `left` mm to its left, within `tolerance`.

    A smaller radius of curvature on this side is refused.
    """
    curve = spline.curve
    stretches = smooth_stretches(curve, 2)
    probes = np.concatenate([np.linspace(a, b, 18) for s in stretches for a, b in pairwise(s)])
    kappa = curve.curvature_at(probes)
    sharpest = (left * kappa).argmax()
    if left * kappa[sharpest] >= 1 - 1e-6:
        raise InputError(
            "the curve at {place} has a radius of {given:.4g}, too small for an offset of {left:g}: draw a "
            "gentler curve",
            place=place(curve.evaluate(probes[sharpest])),
            given=Length(1 / abs(kappa[sharpest])),
            left=Length(abs(left)),
        )

    def motion(t: FloatArray, derivative: int, before: bool) -> FloatArray:
        d = curve.evaluate(t, 1, left=before)
        if derivative:
            return (1 - left * curve.curvature_at(t, left=before))[:, None] * d
        return curve.evaluate(t, left=before) + left * left_of(unit(d))

    return Spline(cubic_through(motion, stretches, tolerance))


def _corner_arc(before: Segment, after: Segment, left: float) -> Arc | None:
    """Return the arc between the offsets of two segments, or None at an inner corner."""
    along = before.tangent_at(1.0)
    turn = float(turn_between(along, after.tangent_at(0.0)))
    # no arc at an inner corner, or where the moved segments still meet
    if turn * left >= 0 or abs(turn * left) < JOIN / 4:
        return None
    first = float(angle_of(left_of(along) * np.sign(left)))
    return Arc(before.end, abs(left), first, first + turn)


def _joined(elements: list[_Element], closed: bool, distance: float) -> list[Segment]:
    """Return the pieces of the offset path in order, trimmed at their crossings, without vanished pieces.

    If two neighbours do not meet, the shorter one is removed. A piece without a part between its crossings is
    removed too, the shortest first. The others are then trimmed again.
    """
    alive = {i: element.piece for i, element in enumerate(elements) if element.piece is not None}
    while True:
        lost = _lost_element(elements, alive, closed, distance)
        if lost is not None:
            raise InputError(
                "an offset of {distance:g} removes the path at {at}: make that part larger or the offset smaller",
                distance=Length(distance),
                at=place(lost.source),
            )
        failed = None
        starts, ends = dict.fromkeys(alive, 0.0), dict.fromkeys(alive, 1.0)
        order = [*alive]
        for i, j in pairwise([*order, order[0]] if closed else order):
            cut = _meeting_parameters(alive[i], alive[j])
            if cut is None:
                failed = min(i, j, key=lambda k: alive[k].length)
                break
            ends[i], starts[j] = cut
        if failed is None:
            inverted = [i for i in alive if ends[i] - starts[i] <= 1e-9]
            if not inverted:
                return [trim_segment(piece, starts[i], ends[i]) for i, piece in alive.items()]
            failed = min(inverted, key=lambda k: alive[k].length)
        del alive[failed]


def _lost_element(
    elements: list[_Element], alive: dict[int, Segment], closed: bool, distance: float
) -> _Element | None:
    """Return a vanished element if the vanished part of the path is too long, else None."""
    n, first = len(elements), min(alive, default=0)
    # a single remaining piece of a closed path must be closed, such as a circle
    alone = closed and len(alive) == 1 < n
    if not alive or (alone and not meets(alive[first], alive[first])):
        return elements[0]
    run = 0.0
    for k in range(first, first + n):
        run = 0.0 if k % n in alive else run + elements[k % n].source_length
        # shorter parts may be lost
        if run > 4 * abs(distance):
            return elements[k % n]
    return None


def _meeting_parameters(a: Segment, b: Segment) -> tuple[float, float] | None:
    """Return the parameters (0 to 1) at which a meets b, nearest to the end of a and the start of b, or None."""
    if norm(b.start - a.end) <= JOIN / 2:
        return 1.0, 0.0
    crossings = segment_crossings(a, b)
    if not crossings:
        return None
    return min(crossings, key=lambda uv: (1 - uv[0]) * a.length + uv[1] * b.length)


def _refuse_collisions(path: Path, moved: Path, distance: float, tolerance: float) -> None:
    """Refuse an offset that is too near to another part of the path, or crosses itself."""
    samples = np.concatenate([segment.at(np.array([0.1, 0.35, 0.65, 0.9])) for segment in moved.segments])
    near = np.min([distances(segment, samples) for segment in path.segments], axis=0)
    worst = near.argmin()
    if near[worst] < abs(distance) - 2 * tolerance - JOIN:
        raise InputError(
            "an offset of {distance:g} runs into another part of the path at {place}: widen the "
            "gap there or make the offset smaller",
            distance=Length(distance),
            place=place(samples[worst]),
        )
    crossing = self_crossing(moved.points(tolerance), closed=path.closed)
    if crossing is not None:
        raise InputError(
            "an offset of {distance:g} makes the path cross itself at {crossing}: widen the gap "
            "there or make the offset smaller",
            distance=Length(distance),
            crossing=place(crossing),
        )
