"""Loops of a flat pattern with an edge of its own for every smooth piece, as the tools of CAD kernels need them."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import islice, pairwise

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.strip.flat_outline import pace
from elastica_cad.geometry.curves.plane_curve import PlaneCurve, clamp_ends, trim_curve
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Line, Segment, Spline
from elastica_cad.geometry.polynomials.splines import interpolated, interpolation_sites, knot_runs

SMOOTH = 2
"""Continuous derivatives inside an edge: kernels offset faces, which takes one of them away."""

RAMP = 2e-5
"""A piece between two kinks that is shorter than this part of the loop is the ramp of a width that steps."""

NO_JUMP = 1e-4
"""mm: a jump of the second derivative worth less than this over a span is smoothed, which costs a hundredth."""

NO_STEP = 1e-5
"""mm: sides that end nearer than this to each other are made to meet."""


def in_smooth_pieces(path: Path) -> Path:
    """The loop with its splines cut where they kink, and a line straight across for every step of the width.

    A drawn side is one spline, which a laser follows in one go: it may have corners at its knots, and ramps over
    which a width that jumps gets from one value to the other. Kernels fillet, offset and hollow only what is
    smooth inside its edges. No point moves by more than half a ramp, 5e-6 of the length, and areas stay.

    Examples
    --------
    >>> knots = [0, 0, 0, 20, 20, 40, 40, 40]
    >>> side = Spline(PlaneCurve(knots, [(0, 0), (10, 0), (20, 0), (30, 2), (40, 4)], 2))
    >>> loop = Path([side, Line((40, 4), (0, 9)), Line((0, 9), (0, 0))], closed=True)
    >>> len(in_smooth_pieces(loop).segments)
    4
    """
    if not any(_kinks(segment).size for segment in path.segments):
        return path
    ramp = RAMP * _reach(path)
    smooth = [_smoothed(segment) for segment in path.segments]
    cuts = [_cut(segment, ramp) for segment in smooth]
    parts = iter([trim_curve(cut.curve, *ends) for cut in cuts if cut is not None for ends in cut.kept])
    pieces: list[Segment] = []
    for segment, cut in zip(smooth, cuts, strict=True):
        pieces += [segment] if cut is None else cut.pieces(list(islice(parts, len(cut.kept))))
    return Path(pieces, path.closed)


def _reach(path: Path) -> float:
    """How far the loop extends along the strip, mm; of splines their control points, which is as good here."""
    rows = [
        segment.curve.control_points if isinstance(segment, Spline) else segment.bounds
        for segment in path.segments
    ]
    return float(np.ptp(np.concatenate(rows)[:, 0]))


def _kinks(segment: Segment) -> FloatArray:
    """Parameters (k,) inside a segment where its tangent may turn or its curvature jump."""
    if not isinstance(segment, Spline):
        return np.empty(0)
    curve = segment.curve
    knots, counts = knot_runs(curve.knots)
    first, last = curve.domain
    return np.asarray(knots[(counts > curve.degree - SMOOTH) & (knots > first) & (knots < last)], dtype=float)


def _smoothed(segment: Segment) -> Segment:
    """The segment with single knots in place of double ones at which its curvature does not really jump."""
    if not isinstance(segment, Spline) or segment.curve.weights is not None:
        return segment
    from scipy.interpolate import BSpline

    curve = clamp_ends(segment.curve)
    degree, first, last = curve.degree, *curve.domain
    knots, counts = knot_runs(curve.knots)
    double = (counts == degree + 1 - SMOOTH) & (knots > first) & (knots < last)
    if not double.any():
        return segment
    rows = BSpline.construct_fast(np.array(curve.knots), np.array(curve.control_points), degree)
    at, gaps = double.nonzero()[0], knots[1:] - knots[:-1]
    reach = np.minimum(gaps[at - 1], gaps[at])
    before, after = rows(np.array([knots[at] - 1e-6 * reach, knots[at] + 1e-6 * reach]), SMOOTH)
    jump = np.abs(after - before).max(axis=1)
    slight = jump * reach**2 < NO_JUMP
    if not slight.any():
        return segment
    counts[double] -= slight
    whole = np.repeat(knots, counts)
    sites = interpolation_sites(whole, degree)
    points = interpolated(sites, rows(sites), whole, degree)
    points[[0, -1]] = curve.control_points[[0, -1]]
    return Spline(PlaneCurve(whole, points, degree, None))


@dataclass(frozen=True, eq=False)
class _Cut:
    """A spline, the ranges of its parameter that are kept, and those that the pieces made of them are over."""

    curve: PlaneCurve
    kept: list[tuple[float, float]]
    over: list[tuple[float, float]] | None

    def pieces(self, parts: Sequence[PlaneCurve]) -> list[Segment]:
        """The trimmed parts, of a graph with lines across in place of ramps."""
        if self.over is None:
            return [Spline(part) for part in parts]
        parts = [_extended(part, *ends) for part, ends in zip(parts, self.over, strict=True)]
        pieces: list[Segment] = [Spline(parts[0])]
        for part in parts[1:]:
            meeting = pieces[-1].end
            step = float(np.hypot(*(part.control_points[0] - meeting)))
            if step > NO_STEP:
                pieces += [Line(meeting, part.control_points[0]), Spline(part)]
            else:
                met = np.vstack([meeting, part.control_points[1:]])
                pieces.append(Spline(PlaneCurve(part.knots, met, part.degree, part.weights)))
        return pieces


def _cut(segment: Segment, ramp: float) -> _Cut | None:
    """Where a segment is cut into its smooth parts; None where it has no kink."""
    kinks = _kinks(segment).tolist()
    if not isinstance(segment, Spline) or not kinks:
        return None
    curve = clamp_ends(segment.curve)
    first, last = curve.domain
    if pace(segment) is None:
        return _Cut(curve, list(pairwise([first, *kinks, last])), None)
    joints = [(first, first, first), *_joints(curve, kinks, ramp), (last, last, last)]
    kept = [(low, high) for (_, _, low), (_, high, _) in pairwise(joints)]
    return _Cut(curve, kept, [(a, b) for (a, _, _), (b, _, _) in pairwise(joints)])


def _joints(curve: PlaneCurve, kinks: list[float], ramp: float) -> Iterator[tuple[float, float, float]]:
    """Where the smooth parts of a graph meet, and where the part before ends and the part after begins."""
    speed = abs(float(curve.control_points[-1, 0] - curve.control_points[0, 0]) / np.ptp(curve.domain))
    while kinks:
        first = last = kinks.pop(0)
        while kinks and (kinks[0] - last) * speed < ramp:
            last = kinks.pop(0)
        yield (first + last) / 2, first, last


def _extended(curve: PlaneCurve, first: float, last: float) -> PlaneCurve:
    """A clamped graph with its end spans carried on, or cut back, to a domain that differs a little."""
    if (first, last) == curve.domain:
        return curve
    from scipy.interpolate import BSpline

    degree, knots = curve.degree, curve.knots.copy()
    knots[: degree + 1], knots[-degree - 1 :] = first, last
    sites = interpolation_sites(knots, degree)
    values = BSpline(np.array(curve.knots), np.array(curve.control_points), degree)(sites)
    return PlaneCurve(knots, interpolated(sites, values, knots, degree), degree, None)
