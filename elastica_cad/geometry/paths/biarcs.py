"""Paths of arcs and of lines in place of splines, to a stated tolerance."""

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import require_record
from elastica_cad.errors import InputError
from elastica_cad.geometry.curves.curve_derivatives import turn_between
from elastica_cad.geometry.paths.chords import require_tolerance_mm
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.path_cubics import smooth_stretches
from elastica_cad.geometry.paths.point_distance import distances
from elastica_cad.geometry.paths.segments import Segment, Spline, place, segment_from_bulge

_ROUNDING_SHARE = 1e-12
"""A chord no longer than this part of its coordinates has no direction."""

_SHORTEST_SHARE = 1e-6
"""Splines are never cut into pieces shorter than this part of their parameter."""

_SAMPLES = np.linspace(0.0, 1.0, 33)
"""Of a stretch of spline, where a biarc is compared with it."""

_TAKEN = 0.95
"""Of the tolerance: samples may miss the worst place."""

_NEAR, _AIM, _NEAR_SHARE = 0.05, 0.98, 0.88
"""A biarc may be a twentieth shorter than the longest; aimed at a little short, it leaves this share."""


def as_polyline(path: Path, tolerance: float = 0.02) -> Path:
    """The path as lines between points on it, nowhere further than `tolerance` mm from it.

    Examples
    --------
    >>> len(as_polyline(Path.circle((0, 0), 10), 0.1).segments)
    23
    """
    require_record(path, Path, "what becomes lines", "a Path")
    return Path.polyline(path.points(tolerance), closed=path.closed)


def as_arcs(path: Path, tolerance: float = 0.02) -> Path:
    """The path with every spline replaced by tangent arcs (biarcs), nowhere further than `tolerance` mm away.

    Lines and arcs are kept. Each biarc meets the spline's points and directions at its ends.

    Examples
    --------
    >>> from elastica_cad.geometry.paths.segments import Arc
    >>> from elastica_cad.geometry.curves.plane_curve import PlaneCurve
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
    t0, t1 = spline.curve.domain
    pieces: list[Segment] = []
    for stretch in smooth_stretches(spline.curve, 1):
        a, end = (float(t - t0) / (t1 - t0) for t in (stretch[0], stretch[-1]))
        while a < end:
            start = a, spline.tangent_at(a)
            b, found = _longest(spline, start, end, tolerance)
            if end - b < 0.5 * (b - a) and b < end:
                # two pieces of like size rather than a stump at the end
                middle = (a + end) / 2
                shorter, off = _biarc(spline, start, middle)
                b, found = (middle, shorter) if off <= _TAKEN * tolerance else (b, found)
            pieces.extend(found)
            a = b
    return pieces


def _longest(
    spline: Spline, start: tuple[float, FloatArray], end: float, tolerance: float
) -> tuple[float, list[Segment]]:
    """The furthest place b, to a twentieth, and the biarc up to there that stays within the tolerance.

    It leaves the spline by the cube of its length, which tells where to try next.
    """
    allowed = _TAKEN * tolerance
    pieces, off = _biarc(spline, start, end)
    if off <= allowed:
        return end, pieces
    a, _ = start
    good, bad, best, trial = a, end, list[Segment](), end
    while not best or bad - good > _NEAR * (good - a):
        trial = a + (trial - a) * _AIM * float(np.cbrt(allowed / off)) if off > 0 else bad
        if not good + _NEAR * (good - a) / 2 < trial < bad:
            trial = (good + bad) / 2
        pieces, off = _biarc(spline, start, trial)
        if off <= allowed:
            good, best = trial, pieces
            if off > _NEAR_SHARE * allowed:
                break
        else:
            bad = trial
        if bad - a < _SHORTEST_SHARE:
            raise InputError(
                f"the spline at {place(spline.at(a))} can't be followed to {tolerance:g} mm by arcs: "
                "allow a larger tolerance"
            )
    return good, best


def _biarc(spline: Spline, start: tuple[float, FloatArray], b: float) -> tuple[list[Segment], float]:
    """The biarc from a place, with its direction, to u = b with equal tangent lengths, and how far it strays."""
    a, s = start
    samples = spline.at(a + (b - a) * _SAMPLES)
    p, q = samples[0], samples[-1]
    t = spline.tangent_at(b, left=True)
    chord = q - p
    along, bend = float(chord @ (s + t)), float(2 * (1 - s @ t))
    square = float(chord @ chord)
    if along <= _ROUNDING_SHARE * float(np.abs([p, q]).max()):
        return [], np.inf  # backwards, or once round a loop
    # positive root of bend d^2 + 2 along d = square, in the form that holds for bend = 0 too
    d = square / (along + np.sqrt(along**2 + bend * square))
    middle = (p + d * s + q - d * t) / 2
    pieces = [_arc(p, middle, s, 1.0), _arc(middle, q, t, -1.0)]
    off = np.minimum(*(distances(piece, samples[1:-1]) for piece in pieces))
    return pieces, float(off.max())


def _arc(p: FloatArray, q: FloatArray, tangent: FloatArray, end: float) -> Segment:
    """The arc from p to q that has `tangent` at p (end = 1) or at q (end = -1)."""
    half_turn = end * float(turn_between(tangent, q - p))
    return segment_from_bulge(p, q, float(np.tan(half_turn / 2)))
