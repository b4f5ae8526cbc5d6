"""Where to cut a segment so that its chords stay within a tolerance."""

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.geometry.paths.segments import Arc, Line, Segment, Spline

_PROBES = np.array([0.25, 0.5, 0.75])
"""Places of a span at which its distance from the chord is measured, in shares of the span."""


def require_tolerance_mm(tolerance: float) -> float:
    """The tolerance, mm, refused unless it is positive and finite."""
    if not (np.isfinite(tolerance) and tolerance > 0):
        raise InputError(f"the tolerance is {tolerance}: it must be positive, in mm")
    return float(tolerance)


def chord_parameters(segment: Segment, tolerance: float) -> FloatArray:
    """Parameters u (n,) from 0 to 1 whose chords stay within `tolerance` mm of the segment."""
    tolerance = require_tolerance_mm(tolerance)
    if isinstance(segment, Line):
        return np.array([0.0, 1.0])
    if isinstance(segment, Arc):
        # a third of a turn at most, so that a circle keeps an inside
        half = np.arccos(np.clip(1 - tolerance / segment.radius, 0.5, 1 - 1e-15))
        return np.linspace(0.0, 1.0, int(np.ceil(abs(segment.sweep) / (2 * half) - 1e-9)) + 1)
    return _spline_parameters(segment, tolerance)


def _spline_parameters(segment: Spline, tolerance: float) -> FloatArray:
    t0, t1 = segment.curve.domain
    knots = np.unique(segment.curve.knots)
    u = np.unique(np.concatenate([[0.0], (knots[(knots > t0) & (knots < t1)] - t0) / (t1 - t0), [0.5, 1.0]]))
    for _ in range(40):
        bad = _chord_errors(segment, u) > 0.95 * tolerance
        if not bad.any():
            break
        u = np.sort(np.concatenate([u, (u[:-1] + np.diff(u) / 2)[bad]]))
    return u


def _chord_errors(segment: Spline, u: FloatArray) -> FloatArray:
    """Largest distance (n - 1,) of the probes in each span from its chord."""
    ends = segment.at(u)
    chord = np.diff(ends, axis=0)
    size = np.hypot(chord[:, 0], chord[:, 1])
    off = segment.at(u[:-1, None] + np.diff(u)[:, None] * _PROBES) - ends[:-1, None, :]
    cross = np.abs(chord[:, None, 0] * off[..., 1] - chord[:, None, 1] * off[..., 0])
    straight = np.divide(cross, size[:, None], out=np.full_like(cross, np.inf), where=size[:, None] > 0)
    error = np.where(size[:, None] > 0, straight, np.hypot(off[..., 0], off[..., 1]))
    return np.asarray(error.max(axis=1), dtype=float)
