"""Distances from points to segments and curves."""

from functools import lru_cache

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.chords import chord_parameters
from elastica_cad.geometry.paths.segments import Arc, Line, Segment, Spline

_BLOCK = 4096
"""Points whose distances from all chords of a spline are held at a time: some ten MB."""

_NEWTON_STEPS = 6
_SETTLED = 1e-12  # of the domain: the distance changes with the square of such a step
_TABLES = 256  # splines of late: parts are compared loop by loop, and each loop with several others


def distances(segment: Segment, points: ArrayLike) -> FloatArray:
    """Least distances (n,) of points (n, 2) from a segment, mm, to rounding error."""
    p = np.asarray(points, dtype=float).reshape(-1, 2)
    if isinstance(segment, Line):
        return _to_chords(p, segment.start[None], segment.end[None])[0][:, 0]
    if isinstance(segment, Arc):
        return _to_arc(p, segment)
    blocks = [p[i : i + _BLOCK] for i in range(0, max(len(p), 1), _BLOCK)]
    return np.concatenate([_to_spline(block, segment) for block in blocks])


def largest_deviation(target: PlaneCurve, found: PlaneCurve) -> float:
    """Largest distance of 401 points of `found` from `target`, mm; 0 where their numbers are the same."""
    numbers = ((curve.knots, curve.control_points, curve.weights) for curve in (target, found))
    if all(np.array_equal(a, b) for a, b in zip(*numbers, strict=True)):
        return 0.0
    return float(distances(Spline(target), found.sample(401).position).max())


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
    """Nearest chord, then Newton on <gamma - p, gamma'> = 0, kept only where it comes nearer."""
    u, q = _table(spline)
    chord, where = _to_chords(p, q[:-1], q[1:])
    i = np.argmin(chord, axis=1)
    rows = np.arange(len(p))
    t = spline.parameter(u[i] + where[rows, i] * np.diff(u)[i])
    curve, (t0, t1) = spline.curve, spline.curve.domain
    best = np.full(len(p), np.inf)
    for _ in range(_NEWTON_STEPS + 1):
        position, d1, d2 = curve.derivatives(t, 2)
        off = position - p
        best = np.minimum(best, np.hypot(off[:, 0], off[:, 1]))
        slope = (d1**2).sum(axis=1) + (off * d2).sum(axis=1)
        step = (off * d1).sum(axis=1) / np.where(slope > 0, slope, (d1**2).sum(axis=1))
        before, t = t, np.clip(t - step, t0, t1)
        if np.abs(t - before).max(initial=0.0) <= _SETTLED * (t1 - t0):
            break
    return np.asarray(best, dtype=float)


@lru_cache(maxsize=_TABLES)
def _table(spline: Spline) -> tuple[FloatArray, FloatArray]:
    """Parameters and points of chords close enough for Newton's method to begin from."""
    u = chord_parameters(spline, 1e-3 * max(1.0, spline.length / 100))
    return u, spline.at(u)
