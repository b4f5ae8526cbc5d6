"""Approximation of splines in a path by cubics, arcs or lines within a tolerance."""

from collections.abc import Callable
from itertools import pairwise
from operator import is_

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import require_record
from elastica_cad.errors import InputError, Length
from elastica_cad.geometry.path import (
    Path,
    Segment,
    Spline,
    distances,
    require_tolerance_mm,
    segment_from_bulge,
)
from elastica_cad.geometry.plane_curve import PlaneCurve, clamp_ends
from elastica_cad.geometry.plane_points import norm, place, project, turn_between
from elastica_cad.geometry.polynomials import raise_degree
from elastica_cad.geometry.splines import SplineFunction, bezier_spans, clamped_knots, kinks, solved

# function of parameters (n,), order of derivative and left-limit flag that returns (n, 2); see `cubic_through`
Motion = Callable[[FloatArray, int, bool], FloatArray]

_PROBES = np.array([0.06, 0.2, 0.36, 0.5, 0.64, 0.8, 0.94])
"""Fractions of a knot span at which the error is measured."""

_MOST_SPANS = 20_000


def as_cubics(path: Path, tolerance: float = 0.02, *, rational: bool = True) -> Path:
    """Return the path with all splines as clamped splines of degree 3 at most.

    Parameters
    ----------
    path : Path
        Path to convert; lines, arcs and clamped splines of degree 3 at most are not changed.
    tolerance : float
        Largest distance, mm, between a spline and its approximation, measured between the interpolation points.
    rational : bool
        If False, splines with weights are approximated too, for file formats that have only polynomial pieces.

    Examples
    --------
    >>> from elastica_cad.geometry.plane_curve import PlaneCurve
    >>> quintic = PlaneCurve.spline([(0, 0), (2, 3), (5, -4), (8, 3), (10, 0), (12, 1)], degree=5)
    >>> as_cubics(Path([Spline(quintic)]), 1e-3).segments[0].curve.degree
    3
    """
    require_record(path, Path, "what becomes cubics", "a Path")
    tolerance = require_tolerance_mm(tolerance)
    cubics = [_as_cubic(segment, tolerance, rational) for segment in path.segments]
    return path if all(map(is_, cubics, path.segments)) else Path(cubics, path.closed)


def _as_cubic(segment: Segment, tolerance: float, rational: bool) -> Segment:
    """Return the segment as a cubic within `tolerance`, mm.

    Splines of degree 3 or less stay, with their weights only if `rational`.
    """
    if not isinstance(segment, Spline):
        return segment
    curve = segment.curve
    if curve.degree <= 3 and (rational or not curve.is_rational):
        clamped = clamp_ends(curve)
        return segment if clamped is curve else Spline(clamped)

    def motion(t: FloatArray, derivative: int, left: bool) -> FloatArray:
        return curve.evaluate(t, derivative, left=left)

    return Spline(cubic_through(motion, smooth_stretches(curve, 1), tolerance))


def as_beziers(path: Path) -> Path:
    """Return the same path with every spline as joined cubic Bezier curves, with threefold interior knots.

    The splines must have degree 3 at most, such as the result of `as_cubics`.

    Examples
    --------
    >>> from elastica_cad.geometry.plane_curve import PlaneCurve
    >>> arch = PlaneCurve.spline([(0, 0), (10, 20), (30, 20), (50, 20), (60, 0)], degree=3)
    >>> as_beziers(Path([Spline(arch)])).segments[0].curve.knots.tolist()
    [0.0, 0.0, 0.0, 0.0, 0.5, 0.5, 0.5, 1.0, 1.0, 1.0, 1.0]
    """
    if not path.has_splines:
        return path
    segments = [
        Spline(_joined_beziers(segment.curve)) if isinstance(segment, Spline) else segment
        for segment in path.segments
    ]
    return Path(segments, path.closed)


def _joined_beziers(curve: PlaneCurve) -> PlaneCurve:
    """Return the curve as cubic Bezier pieces, each knot repeated so that pieces may meet with a corner."""
    edges, pieces = curve.bezier_table
    while pieces.shape[1] < 4:
        pieces = raise_degree(pieces.swapaxes(1, 2)).swapaxes(1, 2)
    rows = np.concatenate([pieces[0, :1], *pieces[:, 1:]])
    knots = np.pad(edges.repeat(3), 1, mode="edge")
    return PlaneCurve(knots, project(rows), 3, rows[:, 2] if curve.is_rational else None)


def smooth_stretches(curve: PlaneCurve, continuity: int) -> tuple[FloatArray, ...]:
    """Return the distinct knots (k,) of each part of a curve with `continuity` continuous derivatives.

    The last knot of a part is the first knot of the next part.

    Examples
    --------
    >>> arch = PlaneCurve.spline([(0, 0), (1, 1), (2, 1), (3, 0)], degree=2)
    >>> [[knots.tolist() for knots in smooth_stretches(arch, order)] for order in (1, 2)]
    [[[0.0, 0.5, 1.0]], [[0.0, 0.5], [0.5, 1.0]]]
    """
    sites, _ = curve.bezier_table
    cuts = kinks(curve.knots, curve.degree, continuity)
    ends = pairwise([sites[0], *cuts, sites[-1]])
    return tuple(sites[(sites >= a) & (sites <= b)] for a, b in ends)


def cubic_through(motion: Motion, stretches: tuple[FloatArray, ...], tolerance: float) -> PlaneCurve:
    """Return a clamped cubic B-spline within `tolerance` mm of `motion` at every parameter.

    The spline has the positions of `motion` at the knots, and the derivatives of `motion` at the ends of every
    smooth part.

    Parameters
    ----------
    motion : callable
        Function of parameters (n,), an order and a flag. For the order 0, the function returns positions (n, 2).
        For the order 1, it returns their derivatives. If the flag is True, values at knots are left limits.
    stretches : tuple of arrays
        Initial interpolation parameters of each part on which `motion` is smooth. The last parameter of a part is
        the first of the next part.
    """
    knots: list[FloatArray] = []
    points: list[FloatArray] = []
    for sites in stretches:
        t, c = _complete_spline(motion, sites, tolerance)
        last = sites is stretches[-1]
        # neighbouring parts share a control point, and the knot there occurs three times
        knots.append(t[: None if last else -4] if not knots else t[1 : None if last else -4])
        points.append(c if not points else c[1:])
    return PlaneCurve(np.concatenate(knots), np.concatenate(points), 3)


def _complete_spline(motion: Motion, sites: FloatArray, tolerance: float) -> tuple[FloatArray, FloatArray]:
    """Return knots and coefficients of the cubic spline within `tolerance` of a motion, with its end tangents.

    Spans are halved until the spline is near enough at probes between its knots.
    """
    ends = np.concatenate([motion(sites[:1], 1, False), motion(sites[-1:], 1, True)])
    while sites.size <= _MOST_SPANS:
        knots = clamped_knots(sites, {}, 3)
        spans = bezier_spans(knots, 3)
        basis, index = spans.local_basis(sites)
        slopes, _ = spans.local_basis(sites[[0, -1]], 1)
        # the two tangent equations are next to those of the end points, so that the matrix remains banded
        beside = [1, sites.size - 1]
        rows = np.insert(basis, beside, slopes, axis=0)
        values = np.insert(motion(sites, 0, False), beside, ends, axis=0)
        spline = SplineFunction(knots, solved(spans, rows, np.pad(index, 1, mode="edge"), values), 3)
        probes = sites[:-1, None] + np.diff(sites)[:, None] * _PROBES
        off = spline(probes.ravel()) - motion(probes.ravel(), 0, False)
        bad = norm(off).reshape(probes.shape).max(axis=1) > 0.9 * tolerance
        if not bad.any():
            return knots, spline.coefficients
        sites = np.sort(np.concatenate([sites, (sites[:-1] + np.diff(sites) / 2)[bad]]))
    raise InputError(
        "the spline from {place} cannot be approximated within {tolerance:g} by a cubic: set a larger tolerance",
        place=place(motion(sites[:1], 0, False)[0]),
        tolerance=Length(tolerance),
    )


_ROUNDING_SHARE = 1e-12
"""A chord shorter than this fraction of its coordinates may have a wrong direction due to rounding."""

_SHORTEST_SHARE = 1e-6
"""Shortest parameter interval that a biarc replaces, as a fraction of the parameter range of the spline."""

_SAMPLES = np.linspace(0.0, 1.0, 33)
"""Fractions of a spline piece at which a biarc is compared with it."""

_USED_SHARE = 0.95
"""Fraction of the tolerance that samples may use, because samples may miss the largest error."""

_NEAR = 0.05
"""Relative accuracy of the search for the longest biarc within the tolerance."""


def as_polyline(path: Path, tolerance: float = 0.02) -> Path:
    """Return the path as lines between its points, within `tolerance` mm of the path.

    Examples
    --------
    >>> len(as_polyline(Path.circle((0, 0), 10), 0.1).segments)
    23
    """
    require_record(path, Path, "what becomes lines", "a Path")
    return Path.polyline(path.points(tolerance), closed=path.closed)


def as_arcs(path: Path, tolerance: float = 0.02) -> Path:
    """Return the path with every spline approximated by tangent arcs (biarcs) within `tolerance` mm.

    Lines and arcs are not changed. Each biarc has the same ends and end directions as its part of the spline.

    Examples
    --------
    >>> from elastica_cad.geometry.path import Arc
    >>> from elastica_cad.geometry.plane_curve import PlaneCurve
    >>> arch = Path([Spline(PlaneCurve.spline([(0, 0), (10, 20), (30, 20), (50, 20), (60, 0)]))])
    >>> all(isinstance(piece, Arc) for piece in as_arcs(arch, 0.05).segments)
    True
    """
    require_record(path, Path, "what becomes arcs", "a Path")
    tolerance = require_tolerance_mm(tolerance)
    pieces: list[Segment] = []
    for segment in path.segments:
        pieces.extend(_biarcs(segment, tolerance) if isinstance(segment, Spline) else [segment])
    return Path(pieces, path.closed)


def _biarcs(spline: Spline, tolerance: float) -> list[Segment]:
    """Return a chain of arcs within `tolerance` of a spline. Each biarc is as long as possible.

    If the rest is shorter than half of the last biarc, both get the same length.
    """
    t0, t1 = spline.curve.domain
    pieces: list[Segment] = []
    for stretch in smooth_stretches(spline.curve, 1):
        a, end = (float(t - t0) / (t1 - t0) for t in (stretch[0], stretch[-1]))
        while a < end:
            start = a, spline.tangent_at(a)
            b, biarc = _longest_biarc(spline, start, end, tolerance)
            if end - b < 0.5 * (b - a) and b < end:
                middle = (a + end) / 2
                shorter, off = _biarc(spline, start, middle)
                b, biarc = (middle, shorter) if off <= _USED_SHARE * tolerance else (b, biarc)
            pieces.extend(biarc)
            a = b
    return pieces


def _longest_biarc(
    spline: Spline, start: tuple[float, FloatArray], end: float, tolerance: float
) -> tuple[float, list[Segment]]:
    """Return the end parameter and the segments of the longest biarc within the tolerance.

    The biarc begins at `start`, a parameter u with its unit tangent, and ends at the parameter `end` or before.
    """
    allowed = _USED_SHARE * tolerance
    pieces, off = _biarc(spline, start, end)
    if off <= allowed:
        return end, pieces
    a, _ = start
    good, bad, best = a, end, list[Segment]()
    while not best or bad - good > _NEAR * (good - a):
        trial = (good + bad) / 2
        pieces, off = _biarc(spline, start, trial)
        if off <= allowed:
            good, best = trial, pieces
        else:
            bad = trial
        if bad - a < _SHORTEST_SHARE:
            raise InputError(
                (
                    "the spline at {place} cannot be approximated within {tolerance:g} by arcs: set a larger "
                    "tolerance"
                ),
                place=place(spline.at(a)),
                tolerance=Length(tolerance),
            )
    return good, best


def _biarc(spline: Spline, start: tuple[float, FloatArray], b: float) -> tuple[list[Segment], float]:
    """Return the biarc from `start` (parameter and unit tangent) to parameter b, and its largest error, mm."""
    a, s = start
    samples = spline.at(a + (b - a) * _SAMPLES)
    p, q = samples[0], samples[-1]
    t = spline.tangent_at(b, left=True)
    chord = q - p
    along, bend = float(chord @ (s + t)), float(2 * (1 - s @ t))
    square = float(chord @ chord)
    if along <= _ROUNDING_SHARE * np.abs([p, q]).max():
        return [], np.inf  # no biarc: the chord points backwards, or the ends coincide
    # d is the positive root of bend d^2 + 2 along d = square, also for bend = 0
    d = square / (along + np.sqrt(along**2 + bend * square))
    middle = (p + d * s + q - d * t) / 2
    pieces = [_arc(p, middle, s, 1.0), _arc(middle, q, t, -1.0)]
    off = np.minimum(*(distances(piece, samples[1:-1]) for piece in pieces))
    return pieces, float(off.max())


def _arc(p: FloatArray, q: FloatArray, tangent: FloatArray, end: float) -> Segment:
    """Return the arc from p to q with the given tangent at p (`end` = 1) or at q (`end` = -1)."""
    half_turn = end * float(turn_between(tangent, q - p))
    return segment_from_bulge(p, q, float(np.tan(half_turn / 2)))
