"""Where segments and paths cross."""

from dataclasses import dataclass
from math import hypot
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from elastica_cad._types import FloatArray
from elastica_cad.geometry.curves.curve_derivatives import cross
from elastica_cad.geometry.paths.chords import chords
from elastica_cad.geometry.paths.segments import Line, Segment

IndexArray: TypeAlias = NDArray[np.intp]

_CHORD_TOLERANCE_MM = 1e-3
"""Chords this near to a segment (mm) are good enough to start Newton's method from."""


@dataclass(frozen=True, eq=False)
class Chords:
    """Points (n, 2) along a segment at its u (n,), close enough to start Newton's method from.

    Made once for a segment that is crossed many times.
    """

    segment: Segment
    u: FloatArray
    points: FloatArray

    @classmethod
    def of(cls, segment: Segment) -> "Chords":
        """The chords of a segment."""
        return cls(segment, *chords(segment, _CHORD_TOLERANCE_MM))


def segment_crossings(a: Segment, b: Segment) -> tuple[tuple[float, float], ...]:
    """Parameters (u, v) in [0, 1] where a(u) = b(v), to rounding error.

    The end of `a` and the start of `b` are tried first, so that a crossing close to a shared corner is found.
    """
    return chord_crossings(Chords.of(a), Chords.of(b), corner=True)


def chord_crossings(
    first: Chords, second: Chords, *, corner: bool = False
) -> tuple[tuple[float, float], ...]:
    """As `segment_crossings`, for segments whose chords are known; the shared `corner` is tried on request."""
    a, b = first.segment, second.segment
    if isinstance(a, Line) and isinstance(b, Line):
        u, v = (float(x[0]) for x in _line_parameters(a.start[None], a.end[None], b.start[None], b.end[None]))
        return ((u, v),) if 0 <= u <= 1 and 0 <= v <= 1 else ()
    starts = [*([(1.0, 0.0)] if corner else []), *_chord_guesses(first, second)]
    found: list[tuple[float, float]] = []
    for guess in starts:
        pair = _newton(a, b, *guess)
        if pair is not None and not any(max(abs(pair[0] - u), abs(pair[1] - v)) < 1e-9 for u, v in found):
            found.append(pair)
    return tuple(found)


def polylines_cross(p: FloatArray, q: FloatArray) -> FloatArray | None:
    """A point (2,) where the polylines through p (n, 2) and q (m, 2) cross or touch, or None."""
    return _first_crossing(p, q, *_candidate_pairs(p, q))


def encloses(loop: FloatArray, point: FloatArray) -> bool:
    """Does the polyline through (n, 2), closed from its last point to its first, run about a point (2,)?"""
    (x0, y0), (x1, y1) = (loop - point).T, (np.roll(loop, -1, axis=0) - point).T
    rises = (y0 > 0) != (y1 > 0)
    x = x0[rises] - y0[rises] * (x1[rises] - x0[rises]) / (y1[rises] - y0[rises])
    return bool(np.count_nonzero(x > 0) % 2)


def self_crossing(p: FloatArray, *, closed: bool) -> FloatArray | None:
    """A point (2,) where the polyline through p (n, 2) meets itself, or None.

    Neighbouring chords do not count. A closed polyline does not repeat its first point.
    """
    q = np.concatenate([p, p[:1]]) if closed else p
    q = q[np.append(True, np.hypot(*np.diff(q, axis=0).T) > 0)]
    i, j = _candidate_pairs(q, q)
    neighbours = (j - i <= 1) | (closed & (j - i == len(q) - 2))
    return _first_crossing(q, q, i[~neighbours], j[~neighbours])


def _first_crossing(p: FloatArray, q: FloatArray, i: IndexArray, j: IndexArray) -> FloatArray | None:
    a, b, c, d = p[i], p[i + 1], q[j], q[j + 1]
    hit = (_side(a, b, c) * _side(a, b, d) <= 0) & (_side(c, d, a) * _side(c, d, b) <= 0)
    if not hit.any():
        return None
    k = int(np.flatnonzero(hit)[0])
    u = float(_line_parameters(a[k : k + 1], b[k : k + 1], c[k : k + 1], d[k : k + 1])[0][0])
    return np.asarray(a[k] + (u if np.isfinite(u) else 0.5) * (b[k] - a[k]), dtype=float)


def _candidate_pairs(p: FloatArray, q: FloatArray) -> tuple[IndexArray, IndexArray]:
    """Index pairs (i, j) of chords of p and q whose bounding boxes overlap."""
    plow, phigh = np.minimum(p[:-1], p[1:]), np.maximum(p[:-1], p[1:])
    qlow, qhigh = np.minimum(q[:-1], q[1:]), np.maximum(q[:-1], q[1:])
    (near_p,) = ((plow <= q.max(axis=0)) & (phigh >= q.min(axis=0))).all(axis=1).nonzero()
    (near_q,) = ((qlow <= p.max(axis=0)) & (qhigh >= p.min(axis=0))).all(axis=1).nonzero()
    rows: list[tuple[IndexArray, IndexArray]] = []
    block = max(1, 2_000_000 // max(1, near_q.size))
    for first in range(0, near_p.size, block):
        i = near_p[first : first + block]
        overlap = (plow[i, None, 0] <= qhigh[None, near_q, 0]) & (phigh[i, None, 0] >= qlow[None, near_q, 0])
        overlap &= (plow[i, None, 1] <= qhigh[None, near_q, 1]) & (phigh[i, None, 1] >= qlow[None, near_q, 1])
        a, b = np.nonzero(overlap)
        rows.append((i[a], near_q[b]))
    if len(rows) == 1:
        return rows[0]
    none = np.zeros(0, int)
    return np.concatenate([none, *[r[0] for r in rows]]), np.concatenate([none, *[r[1] for r in rows]])


def _side(a: FloatArray, b: FloatArray, c: FloatArray) -> FloatArray:
    """Twice the area of the triangles a b c: on which side of a b the points c lie."""
    return cross(b - a, c - a)


def _line_parameters(
    a: FloatArray, b: FloatArray, c: FloatArray, d: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Where the lines a b and c d (n, 2 each) meet, as fractions of a b and of c d; nan where parallel."""
    p, q, gap = b - a, d - c, c - a
    det = cross(p, q)
    det = np.where(np.abs(det) > 1e-14 * np.hypot(*p.T) * np.hypot(*q.T), det, np.nan)
    return cross(gap, q) / det, cross(gap, p) / det


def _chord_guesses(a: Chords, b: Chords) -> list[tuple[float, float]]:
    """Crossings of chords of the two segments, a little beyond their ends too."""
    u, v, p, q = a.u, b.u, a.points, b.points
    i, j = _candidate_pairs(p, q)
    f, g = _line_parameters(p[i], p[i + 1], q[j], q[j + 1])
    hit = (np.abs(f - 0.5) <= 0.6) & (np.abs(g - 0.5) <= 0.6)
    pairs = np.column_stack([u[i] + f * np.diff(u)[i], v[j] + g * np.diff(v)[j]])[hit]
    return [(float(x), float(y)) for x, y in pairs]


def _newton(a: Segment, b: Segment, u: float, v: float) -> tuple[float, float] | None:
    """The crossing that Newton's method reaches from (u, v), or None where there is none on the segments."""
    for _ in range(30):
        inside_u, inside_v = min(max(u, 0.0), 1.0), min(max(v, 0.0), 1.0)
        (ax, ay, adx, ady), (bx, by, bdx, bdy) = _motion(a, inside_u), _motion(b, inside_v)
        # beyond their ends the segments go on straight, so that a step may leave them and come back
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
    return (float(u), float(v)) if np.hypot(*(a.at(u) - b.at(v))) < 1e-7 else None


def _motion(segment: Segment, u: float) -> tuple[float, float, float, float]:
    """x and y of the point at u, and their derivatives by u, as plain numbers: few of them are fastest so."""
    point, velocity = segment.motion_at(u)
    x, y = point.tolist()
    dx, dy = velocity.tolist()
    return x, y, dx, dy
