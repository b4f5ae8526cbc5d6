"""Where to cut a segment so that its chords stay within a tolerance."""

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import is_number
from elastica_cad.errors import InputError
from elastica_cad.geometry.paths.segments import Arc, Line, Segment, Spline
from elastica_cad.geometry.running_sums import distinct

PROBES = np.array([0.25, 0.5, 0.75])
"""Places of a span at which its distance from the chord is measured, in shares of the span."""

MOST_ROUNDS = 40
"""Of halving: a span is then as short as rounding."""


def require_tolerance_mm(tolerance: float) -> float:
    """The tolerance, mm, refused unless it is positive and finite."""
    if not (is_number(tolerance) and tolerance > 0):
        raise InputError(f"the tolerance is {tolerance}: it must be positive, in mm")
    return float(tolerance)


def chords(segment: Segment, tolerance: float) -> tuple[FloatArray, FloatArray]:
    """Parameters u (n,) from 0 to 1 whose chords stay within `tolerance` mm of a segment, and its points there."""
    if isinstance(segment, Spline):
        return _spline_chords(segment, tolerance)
    u = _even(segment, tolerance)
    return u, segment.at(u)


def chord_points(segment: Segment, tolerance: float) -> FloatArray:
    """The points of `chords` alone, (n, 2), mm."""
    return chords(segment, tolerance)[1]


def _even(segment: Line | Arc, tolerance: float) -> FloatArray:
    tolerance = require_tolerance_mm(tolerance)
    if isinstance(segment, Line):
        return np.array([0.0, 1.0])
    return np.linspace(0.0, 1.0, int(arc_parts(segment.radius, segment.sweep, tolerance)) + 1)


def arc_parts(radius: float | FloatArray, sweep: float | FloatArray, tolerance: float) -> FloatArray:
    """In how many even parts (...) arcs of these radii (...), mm, and turns (...), rad, are cut."""
    # a third of a turn at most, so that a circle keeps an inside
    half = np.arccos(np.clip(1 - tolerance / radius, 0.5, 1 - 1e-15))
    return np.asarray(np.ceil(np.abs(sweep) / (2 * half) - 1e-9))


def _spline_chords(segment: Spline, tolerance: float) -> tuple[FloatArray, FloatArray]:
    """Parameters and points."""
    tolerance, (t0, t1) = require_tolerance_mm(tolerance), segment.curve.domain
    knots = segment.curve.knots
    u = distinct(np.concatenate([[0.0], (knots[(knots > t0) & (knots < t1)] - t0) / (t1 - t0), [0.5, 1.0]]))
    for _ in range(MOST_ROUNDS):
        inner = u[:-1, None] + np.diff(u)[:, None] * PROBES
        points = segment.at(np.concatenate([u, inner.ravel()]))
        ends = points[: u.size]
        bad = chord_errors(ends[:-1], ends[1:], points[u.size :].reshape(*inner.shape, 2)) > 0.95 * tolerance
        if not bad.any():
            return u, ends
        u = np.sort(np.concatenate([u, (u[:-1] + np.diff(u) / 2)[bad]]))
    return u, segment.at(u)


def chord_errors(begins: FloatArray, ends: FloatArray, probes: FloatArray) -> FloatArray:
    """Largest distance (n,) of the probes (n, k, 2) of each span from the chord between its ends (n, 2)."""
    chord, off = ends - begins, probes - begins[:, None, :]
    size = (chord**2).sum(axis=1)[:, None]
    # beyond an end of the chord that end is nearest: hairpins reach out there
    along = np.divide((off * chord[:, None]).sum(axis=2), size, out=np.zeros(off.shape[:2]), where=size > 0)
    away = off - np.clip(along, 0.0, 1.0)[..., None] * chord[:, None]
    return np.asarray(np.hypot(away[..., 0], away[..., 1]).max(axis=1), dtype=float)
