"""Crossings of segments and paths, and the parts of a path between two vertical lines."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import hypot
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from elastica_cad._types import FloatArray
from elastica_cad.errors import BareLength, InputError, Length
from elastica_cad.geometry.path import JOIN, Line, Path, Segment, Spline, chords, meets, trim_segment
from elastica_cad.geometry.plane_points import boxes_meet, cross, norm

IndexArray: TypeAlias = NDArray[np.intp]


@dataclass(frozen=True, eq=False)
class Chords:
    """Points (n, 2) at parameters u (n,) of a segment, with chords between them.

    Newton's method starts from crossings of chords.
    """

    segment: Segment
    u: FloatArray
    points: FloatArray

    @classmethod
    def of(cls, segment: Segment) -> "Chords":
        """Return the chords of a segment."""
        # the chords are only starts for Newton's method
        return cls(segment, *chords(segment, 1e-3))


def segment_crossings(a: Segment, b: Segment) -> tuple[tuple[float, float], ...]:
    """Return the parameters (u, v) in [0, 1] at which a(u) = b(v), except for rounding errors.

    The end of `a` and the start of `b` are tried first, so that a crossing close to a shared corner is found.
    """
    return chord_crossings(Chords.of(a), Chords.of(b), corner=True)


def chord_crossings(
    first: Chords, second: Chords, *, corner: bool = False
) -> tuple[tuple[float, float], ...]:
    """Return the parameters (u, v) in [0, 1] at which two segments cross, except for rounding errors.

    Parameters
    ----------
    first, second : Chords
        Segments a and b with their chords; crossings of chords are starting points of Newton's method.
    corner : bool
        True for neighbours that share a corner: the end of the first and the start of the second segment are
        another starting point.

    Examples
    --------
    >>> rising, falling = Line((0, 0), (2, 2)), Line((0, 2), (2, 0))
    >>> chord_crossings(Chords.of(rising), Chords.of(falling))
    ((0.5, 0.5),)
    """
    a, b = first.segment, second.segment
    if isinstance(a, Line) and isinstance(b, Line):
        u, v = (float(x[0]) for x in _line_parameters(a.start[None], a.end[None], b.start[None], b.end[None]))
        return ((u, v),) if 0 <= u <= 1 and 0 <= v <= 1 else ()
    starts = [*([(1.0, 0.0)] if corner else []), *_chord_guesses(first, second)]
    crossings: list[tuple[float, float]] = []
    for guess in starts:
        pair = _newton(a, b, *guess)
        if pair is not None and not any(max(abs(pair[0] - u), abs(pair[1] - v)) < 1e-9 for u, v in crossings):
            crossings.append(pair)
    return tuple(crossings)


def polylines_cross(p: FloatArray, q: FloatArray) -> FloatArray | None:
    """Return a point (2,) at which the polylines through p (n, 2) and q (m, 2) cross or touch, or None."""
    return _first_crossing(p, q, *_candidate_pairs(p, q))


def encloses(loop: FloatArray, point: FloatArray) -> bool:
    """Return True if the polygon with vertices (n, 2) encloses a point (2,)."""
    (x0, y0), (x1, y1) = (loop - point).T, (np.roll(loop, -1, axis=0) - point).T
    rises = (y0 > 0) != (y1 > 0)
    x = x0[rises] - y0[rises] * (x1[rises] - x0[rises]) / (y1[rises] - y0[rises])
    return bool(np.count_nonzero(x > 0) % 2)


def anticlockwise(loop: FloatArray) -> FloatArray:
    """Return the vertices (n, 2) of a polygon in anticlockwise order."""
    return loop if cross(loop, np.roll(loop, -1, axis=0)).sum() > 0 else loop[::-1]


def self_crossing(p: FloatArray, *, closed: bool) -> FloatArray | None:
    """Return a point (2,) at which the polyline through p (n, 2) meets itself, or None.

    Neighbouring chords are not compared. The points of a closed polyline do not repeat its first point.
    """
    q = np.concatenate([p, p[:1]]) if closed else p
    q = q[np.append(True, norm(np.diff(q, axis=0)) > 0)]
    i, j = _candidate_pairs(q, q)
    # this also drops j < i, because each pair occurs in both orders; the last term is the first and last chord
    neighbours = (j - i <= 1) | (closed & (j - i == len(q) - 2))
    return _first_crossing(q, q, i[~neighbours], j[~neighbours])


def _first_crossing(p: FloatArray, q: FloatArray, i: IndexArray, j: IndexArray) -> FloatArray | None:
    """Return the first crossing (2,) of chords i (k,) of a polyline p and j (k,) of a polyline q, or None.

    The pairs are in the order of `_candidate_pairs`, so the crossing is on the first crossed chord of p. Two chords
    on one straight line cross if their boxes overlap, and the result is then the middle of the chord of p.
    """
    a, b, c, d = p[i], p[i + 1], q[j], q[j + 1]
    hit = (_side(a, b, c) * _side(a, b, d) <= 0) & (_side(c, d, a) * _side(c, d, b) <= 0)
    first = np.flatnonzero(hit)[:1]
    if not first.size:
        return None
    a, b, c, d = a[first], b[first], c[first], d[first]
    u = np.nan_to_num(_line_parameters(a, b, c, d)[0], nan=0.5)
    return np.asarray(a[0] + u * (b[0] - a[0]), dtype=float)


def _candidate_pairs(p: FloatArray, q: FloatArray) -> tuple[IndexArray, IndexArray]:
    """Return the index pairs i, j (k,) of chords of p and q whose bounding boxes overlap, ordered by i, then j."""
    first, second = _box_tree(p), _box_tree(q)
    i = j = np.zeros(min(len(p) - 1, len(q) - 1, 1), dtype=np.intp)
    while True:
        (low, high), (other_low, other_high) = first[-1], second[-1]
        overlap = ((low[i] <= other_high[j]) & (high[i] >= other_low[j])).all(axis=1)
        i, j = i[overlap], j[overlap]
        if len(first) == len(second) == 1:
            order = np.lexsort((j, i))
            return i[order], j[order]
        # descend in the taller tree first, so that both reach their chords together
        deepest = max(len(first), len(second))
        if len(first) == deepest:
            first.pop()
            i, j = (_FAN * i[:, None] + np.arange(_FAN)).ravel(), j.repeat(_FAN)
        if len(second) == deepest:
            second.pop()
            i, j = i.repeat(_FAN), (_FAN * j[:, None] + np.arange(_FAN)).ravel()
        inside = (i < len(first[-1][0])) & (j < len(second[-1][0]))
        i, j = i[inside], j[inside]


_FAN = 8
"""Number of boxes in a group: a compromise between many levels and many useless pairs."""


def _box_tree(points: FloatArray) -> list[tuple[FloatArray, FloatArray]]:
    """Return the boxes of the chords, then of groups of boxes, up to a single box around everything.

    Each level has the lower left and the upper right corners, (k, 2) each.
    """
    levels = [(np.minimum(points[:-1], points[1:]), np.maximum(points[:-1], points[1:]))]
    while len(levels[-1][0]) > 1:
        low, high = levels[-1]
        begins = np.arange(0, len(low), _FAN)
        levels.append((np.minimum.reduceat(low, begins), np.maximum.reduceat(high, begins)))
    return levels


def _side(a: FloatArray, b: FloatArray, c: FloatArray) -> FloatArray:
    """Return twice the signed area of triangles abc: positive if c is to the left of the line a b."""
    return cross(b - a, c - a)


def _line_parameters(
    a: FloatArray, b: FloatArray, c: FloatArray, d: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Return the intersections of lines a b with lines c d, as fractions (n,) of a b and of c d.

    The lines are given by points a, b, c, d (n, 2). Parallel lines have the fractions nan.
    """
    p, q, gap = b - a, d - c, c - a
    det = cross(p, q)
    det = np.where(np.abs(det) > 1e-14 * norm(p) * norm(q), det, np.nan)
    return cross(gap, q) / det, cross(gap, p) / det


def _chord_guesses(a: Chords, b: Chords) -> list[tuple[float, float]]:
    """Return the parameters (u, v) at crossings of chords. Each chord is extended by a tenth beyond its ends."""
    u, v, p, q = a.u, b.u, a.points, b.points
    i, j = _candidate_pairs(p, q)
    f, g = _line_parameters(p[i], p[i + 1], q[j], q[j + 1])
    hit = (np.abs(f - 0.5) <= 0.6) & (np.abs(g - 0.5) <= 0.6)
    pairs = np.column_stack([u[i] + f * np.diff(u)[i], v[j] + g * np.diff(v)[j]])[hit]
    return [(x, y) for x, y in pairs.tolist()]


def _newton(a: Segment, b: Segment, u: float, v: float) -> tuple[float, float] | None:
    """Return the parameters (0 to 1) of a crossing of two segments by Newton's method from u and v, or None."""
    for _ in range(30):
        inside_u, inside_v = min(max(u, 0.0), 1.0), min(max(v, 0.0), 1.0)
        (ax, ay, adx, ady), (bx, by, bdx, bdy) = (
            _point_and_velocity(a, inside_u),
            _point_and_velocity(b, inside_v),
        )
        # extend both segments along their tangents, so that Newton's method can leave the segments and return
        gx = bx + (v - inside_v) * bdx - ax - (u - inside_u) * adx
        gy = by + (v - inside_v) * bdy - ay - (u - inside_u) * ady
        det = adx * bdy - ady * bdx
        if abs(det) <= 1e-13 * hypot(adx, ady) * hypot(bdx, bdy):
            return None
        du, dv = (gx * bdy - gy * bdx) / det, (gx * ady - gy * adx) / det
        u, v = u + du, v + dv
        if max(abs(u), abs(v)) > 4:
            return None
        if max(abs(du), abs(dv)) < 1e-14:
            break
    if max(abs(u - 0.5), abs(v - 0.5)) > 0.5 + 1e-12:
        return None
    u, v = min(max(u, 0.0), 1.0), min(max(v, 0.0), 1.0)
    return (float(u), float(v)) if norm(a.at(u) - b.at(v)) < 1e-7 else None


def _point_and_velocity(segment: Segment, u: float) -> tuple[float, float, float, float]:
    """Return x, y and their derivatives by the parameter (0 to 1) of a segment."""
    if isinstance(segment, Spline):  # one evaluation of the curve for both
        t0, t1 = segment.curve.domain
        position, velocity = segment.curve.derivatives(segment.parameter([u]), 1)
        (x, y), (dx, dy) = position[0], velocity[0] * (t1 - t0)
    else:
        (x, y), (dx, dy) = segment.at(u), segment.velocity_at(u)
    return float(x), float(y), float(dx), float(dy)


FLAT_MM = 0.002
"""Largest distance, mm, between a closed path and the polygon that replaces it to find points inside."""


def clip_across(path: Path, low: float, high: float) -> Path:
    """Return the exact part of a closed path with low <= x <= high, closed by straight lines.

    Examples
    --------
    >>> clip_across(Path.rectangle(40, 10), 5, 25).area
    200.0
    """
    runs = _runs_between(path, low, high)
    if not runs:
        raise InputError(
            "the path has no part between x = {low:g} and {high:g}: give places from {least:g} to {most:g}",
            low=BareLength(low),
            high=Length(high),
            least=BareLength(path.bounds[0, 0]),
            most=Length(path.bounds[1, 0]),
        )
    # the closed path may start inside a part, whose two runs are joined here
    if len(runs) > 1 and meets(runs[-1][-1], runs[0][0]):
        runs[0] = runs.pop() + runs[0]
    chain: list[Segment] = []
    for run, following in zip(runs, [*runs[1:], runs[0]], strict=True):
        chain += run
        if not meets(run[-1], following[0]):
            if abs(run[-1].end[0] - following[0].start[0]) > JOIN:
                raise InputError(
                    "the part between x = {low:g} and {high:g} is not in one piece: give another range",
                    low=BareLength(low),
                    high=Length(high),
                )
            chain.append(Line(run[-1].end, following[0].start))
    return Path(chain, closed=True)


def trim_across(path: Path, low: float, high: float) -> tuple[Path, ...]:
    """Return the parts of an open path with low <= x <= high, in order.

    Examples
    --------
    >>> (part,) = trim_across(Path.polyline([(0, 0), (40, 10)]), 10, 30)
    >>> part.bounds.tolist()
    [[10.0, 2.5], [30.0, 7.5]]
    """
    return tuple(map(Path, _runs_between(path, low, high)))


def trim_off(path: Path, loops: Sequence[Path]) -> tuple[Path, ...]:
    """Return the parts of an open path that are outside of closed paths, in order.

    Examples
    --------
    >>> parts = trim_off(Path.polyline([(-10, 5), (60, 5)]), [Path.rectangle(40, 10)])
    >>> [round(part.length, 9) for part in parts]
    [10.0, 20.0]
    """
    met = [loop for loop in loops if boxes_meet(loop.bounds, path.bounds)]
    if not met:
        return (path,)
    walls = [segment for loop in met for segment in loop.segments]
    rims = [loop.points(FLAT_MM) for loop in met]
    parts = _runs(path, walls, lambda place: not any(encloses(rim, place) for rim in rims))
    return tuple(map(Path, parts))


def _runs_between(path: Path, low: float, high: float) -> list[list[Segment]]:
    # a wall at an end of the path would cut off parts of no length
    (left, bottom), (right, top) = path.bounds
    walls = [Line((x, bottom - 1), (x, top + 1)) for x in (low, high) if left + JOIN < x < right - JOIN]
    return _runs(path, walls, lambda place: low <= float(place[0]) <= high)


def _runs(path: Path, walls: Sequence[Segment], keeps: Callable[[FloatArray], bool]) -> list[list[Segment]]:
    """Cut a path at segments `walls`. Return the parts whose midpoints satisfy `keeps`, as lists of segments."""
    runs: list[list[Segment]] = [[]]
    for segment in path.segments:
        cuts = {u for wall in walls for u, _ in segment_crossings(segment, wall)}
        # a cut at an end of the segment would leave a part of no length
        tips = np.array([segment.start, segment.end])
        inside = (u for u in cuts if 0 < u < 1 and norm(tips - segment.at(u)).min() > JOIN)
        edges = np.unique([0.0, *inside, 1.0])
        for u0, u1 in pairwise(edges.tolist()):
            if keeps(segment.at((u0 + u1) / 2)):
                runs[-1].append(trim_segment(segment, u0, u1))
            elif runs[-1]:
                runs.append([])
    return runs if runs[-1] else runs[:-1]
