"""Distances from points to segments and curves."""

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.segments import Arc, Line, Segment, Spline, chords

_BLOCK = 4096
"""Number of points whose distances from all chords of a spline are in memory at a time (some ten MB)."""

_NEWTON_STEPS = 6
_ROUNDING_SHARE = 1e-12  # of a length
_SETTLED = 1e-12  # of the domain: the distance changes with the square of such a step
_UNSETTLED = 1e-7  # of the domain, after Newton's last step: it goes round in circles
_SEARCHES = 20  # each leaves a quarter of the span, or less


def distances(segment: Segment, points: ArrayLike) -> FloatArray:
    """Least distances (n,) of points (n, 2) from a segment, mm, to rounding error."""
    p = np.asarray(points, dtype=float).reshape(-1, 2)
    if isinstance(segment, Line):
        return _to_chords(p, segment.start[None], segment.end[None])[0][:, 0]
    if isinstance(segment, Arc):
        return _to_arc(p, segment)
    blocks = [p[i : i + _BLOCK] for i in range(0, max(len(p), 1), _BLOCK)]
    return np.concatenate([_to_spline(block, segment) for block in blocks])


def polyline_distances(line: FloatArray, points: FloatArray) -> FloatArray:
    """Least distances (n,) of points (n, 2) from a polyline (m, 2), mm."""
    rows = max(1, _BLOCK * _BLOCK // (16 * len(line)))
    return np.concatenate(
        [
            _to_chords(points[i : i + rows], line[:-1], line[1:])[0].min(axis=1)
            for i in range(0, len(points), rows)
        ]
    )


def largest_deviation(target: PlaneCurve, found: PlaneCurve) -> float:
    """Largest distance of 401 points of `found` from `target`, mm; 0 where it is rounding."""
    points, rounding = found.sample(401).position, _ROUNDING_SHARE * found.length
    if np.abs(points - target.sample(401).position).max() <= rounding:
        return 0.0
    off = float(distances(Spline(target), points).max())
    return off if off > rounding else 0.0


def _to_chords(p: FloatArray, a: FloatArray, b: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Distances (n, m) of points from chords a[j] b[j], and where on the chord (0 to 1) they are taken."""
    (x, y), (dx, dy) = a.T, (b - a).T
    left, down = p[:, :1] - x, p[:, 1:] - y  # x and y apart: sums over an axis of two are slow
    square = dx**2 + dy**2
    where = left * dx
    where += down * dy
    where /= np.where(square > 0, square, 1.0)
    np.clip(where, 0.0, 1.0, out=where)
    return np.hypot(where * dx - left, where * dy - down), where


def _to_arc(p: FloatArray, arc: Arc) -> FloatArray:
    off = p - arc.center
    turn = np.sign(arc.sweep) * (np.arctan2(off[:, 1], off[:, 0]) - arc.start_angle)
    on = np.mod(turn, 2 * np.pi) <= abs(arc.sweep)
    ends = [np.hypot(*(p - end).T) for end in (arc.start, arc.end)]
    return np.where(on, np.abs(np.hypot(off[:, 0], off[:, 1]) - arc.radius), np.minimum(*ends))


def _to_spline(p: FloatArray, spline: Spline) -> FloatArray:
    """Nearest chords, then Newton on <gamma - p, gamma'> = 0, kept only where it comes nearer."""
    u, q = chords(spline, _chord_tolerance(spline))
    chord, where = _to_chords(p, q[:-1], q[1:])
    # the nearest chord, and those of other branches that may be nearer but for what chords leave out
    close = chord <= chord.min(axis=1, keepdims=True) + 2 * _chord_tolerance(spline)
    close[:, 1:] &= chord[:, 1:] < chord[:, :-1]
    close[:, :-1] &= chord[:, :-1] <= chord[:, 1:]
    rows, i = np.nonzero(close)
    t = spline.parameter(u[i] + where[rows, i] * np.diff(u)[i])
    curve, (t0, t1) = spline.curve, spline.curve.domain
    count, p = len(p), p[rows]
    best = np.full(rows.size, np.inf)
    for _ in range(_NEWTON_STEPS + 1):
        position, d1, d2 = curve.derivatives(t, 2)
        off = position - p
        best = np.minimum(best, np.hypot(off[:, 0], off[:, 1]))
        slope = (d1**2).sum(axis=1) + (off * d2).sum(axis=1)
        step = (off * d1).sum(axis=1) / np.where(slope > 0, slope, (d1**2).sum(axis=1))
        before, t = t, np.clip(t - step, t0, t1)
        if np.abs(t - before).max(initial=0.0) <= _SETTLED * (t1 - t0):
            break
    low, high = spans = spline.parameter(np.stack([u[i], u[i + 1]]))
    strayed = (np.abs(t - (low + high) / 2) > high - low) | (np.abs(t - before) > _UNSETTLED * (t1 - t0))
    strayed |= best > chord[rows, i] + _chord_tolerance(spline)
    if strayed.any():
        best[strayed] = np.minimum(best[strayed], _searched(p[strayed], curve, *spans[:, strayed]))
    least = np.full(count, np.inf)
    np.minimum.at(least, rows, best)
    return least


def _searched(p: FloatArray, curve: PlaneCurve, low: FloatArray, high: FloatArray) -> FloatArray:
    """Least distances (n,) of points from spans low to high of a curve, by ever finer samples.

    For spans that are run through so unevenly that Newton's method strays from where their chords say.
    """
    rows, least = np.arange(len(p)), np.full(len(p), np.inf)
    for _ in range(_SEARCHES):
        t = low[:, None] + (high - low)[:, None] * np.linspace(0.0, 1.0, 9)
        off = curve.evaluate(np.clip(t, *curve.domain)) - p[:, None, :]
        gap = np.hypot(off[..., 0], off[..., 1])
        k = gap.argmin(axis=1)
        least = np.minimum(least, gap[rows, k])
        low, high = t[rows, np.maximum(k - 1, 0)], t[rows, np.minimum(k + 1, 8)]
    return least


def _chord_tolerance(spline: Spline) -> float:
    """Largest distance of chords from a spline, mm, with which Newton's method can start from them."""
    return 1e-3 * max(1.0, spline.length / 100)
