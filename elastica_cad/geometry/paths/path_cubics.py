"""Cubic B-splines through a given motion of a point, to a stated tolerance."""

from collections.abc import Callable
from itertools import pairwise
from operator import is_

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import require_record
from elastica_cad.errors import InputError
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.chords import require_tolerance_mm
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Segment, Spline, place
from elastica_cad.geometry.paths.trim import clamp_ends
from elastica_cad.geometry.polynomials.splines import knot_runs

Motion = Callable[[FloatArray, int, bool], FloatArray]

_PROBES = np.array([0.06, 0.2, 0.36, 0.5, 0.64, 0.8, 0.94])
"""Places of a span at which the error is measured, in shares of the span: unlike the sites, unevenly spaced."""

_MOST_SPANS = 20_000
"""A tolerance that needs more cannot be met."""


def as_cubics(path: Path, tolerance: float = 0.02, *, rational: bool = True) -> Path:
    """The path with every spline of degree 3 at most and clamped; what already is stays exact.

    Parameters
    ----------
    path : Path
        Lines and arcs are kept.
    tolerance : float
        Largest distance, mm, of a replaced spline from its original; checked between the samples.
    rational : bool
        False replaces weighted splines too, for writers of polynomial pieces.

    Examples
    --------
    >>> from elastica_cad.geometry.curves.plane_curve import PlaneCurve
    >>> quintic = PlaneCurve.spline([(0, 0), (2, 3), (5, -4), (8, 3), (10, 0), (12, 1)], degree=5)
    >>> as_cubics(Path([Spline(quintic)]), 1e-3).segments[0].curve.degree
    3
    """
    require_record(path, Path, "what becomes cubics", "a Path")
    tolerance = require_tolerance_mm(tolerance)
    cubics = [_as_cubic(segment, tolerance, rational) for segment in path.segments]
    return path if all(map(is_, cubics, path.segments)) else Path(cubics, path.closed)


def _as_cubic(segment: Segment, tolerance: float, rational: bool) -> Segment:
    if not isinstance(segment, Spline):
        return segment
    curve = segment.curve
    if curve.degree <= 3 and (rational or not curve.is_rational):
        clamped = clamp_ends(curve)
        return segment if clamped is curve else Spline(clamped)

    def motion(t: FloatArray, derivative: int, left: bool) -> FloatArray:
        return curve.evaluate(t, derivative, left=left)

    return Spline(cubic_through(motion, smooth_stretches(curve, 1), tolerance))


def smooth_stretches(curve: PlaneCurve, continuity: int) -> tuple[FloatArray, ...]:
    """The distinct knots of the curve, cut where it is less than C^`continuity`; neighbours share the cut."""
    t0, t1 = curve.domain
    knots, counts = knot_runs(curve.knots)
    inside = (knots > t0) & (knots < t1)
    cuts = knots[inside & (curve.degree - counts < continuity)]
    sites = np.concatenate([[t0], knots[inside], [t1]])
    edges = [t0, *cuts, t1]
    return tuple(sites[(sites >= a) & (sites <= b)] for a, b in pairwise(edges))


def cubic_through(motion: Motion, stretches: tuple[FloatArray, ...], tolerance: float) -> PlaneCurve:
    """The clamped cubic B-spline that follows `motion` to `tolerance` mm at equal parameters.

    It passes through the motion at the knots and has its direction at the ends of every stretch.

    Parameters
    ----------
    motion : callable
        Maps parameters (n,), order (0 or 1) and side (True: the left limit) to positions or derivatives
        (n, 2); smooth inside each stretch.
    stretches : tuple of arrays
        Sites from which each stretch is refined; the end of one is the start of the next.
    """
    knots: list[FloatArray] = []
    points: list[FloatArray] = []
    for sites in stretches:
        t, c = _complete_spline(motion, sites, tolerance)
        last = sites is stretches[-1]
        knots.append(t[: None if last else -4] if not knots else t[1 : None if last else -4])
        points.append(c if not points else c[1:])
    return PlaneCurve(np.concatenate(knots), np.concatenate(points), 3)


def _complete_spline(motion: Motion, sites: FloatArray, tolerance: float) -> tuple[FloatArray, FloatArray]:
    """Knots and control points of one stretch: interpolating, with end slopes, refined as needed."""
    from scipy.interpolate import make_interp_spline

    ends = ([(1, motion(sites[:1], 1, False)[0])], [(1, motion(sites[-1:], 1, True)[0])])
    while sites.size <= _MOST_SPANS:
        spline = make_interp_spline(sites, motion(sites, 0, False), k=3, bc_type=ends)
        probes = sites[:-1, None] + np.diff(sites)[:, None] * _PROBES
        off = spline(probes.ravel()) - motion(probes.ravel(), 0, False)
        error = np.hypot(off[:, 0], off[:, 1]).reshape(probes.shape).max(axis=1)
        bad = error > 0.9 * tolerance
        if not bad.any():
            return spline.t, spline.c
        sites = np.sort(np.concatenate([sites, (sites[:-1] + np.diff(sites) / 2)[bad]]))
    raise InputError(
        f"the spline from {place(motion(sites[:1], 0, False)[0])} can't be followed to {tolerance:g} mm by a "
        "cubic: allow a larger tolerance"
    )
