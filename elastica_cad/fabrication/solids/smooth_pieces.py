"""Loops of a flat pattern with an edge of its own for every smooth piece, as the tools of CAD kernels need them."""

from itertools import pairwise
from weakref import WeakKeyDictionary

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.strip.flat_outline import pace
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Line, Segment, Spline
from elastica_cad.geometry.paths.trim import clamp_ends, trim_curves
from elastica_cad.geometry.polynomials.knot_runs import knot_runs
from elastica_cad.geometry.polynomials.spline_function import interpolated, interpolation_sites

SMOOTH = 2
"""Continuous derivatives inside an edge: kernels offset faces, which takes one of them away."""

RAMP = 2e-5
"""A piece between two kinks that is shorter than this part of the loop is the ramp of a width that steps."""

NO_JUMP = 1e-4
"""mm: a jump of the second derivative worth less than this over a span is smoothed, which costs a hundredth."""

NO_STEP = 1e-5
"""mm: sides that end nearer than this to each other are made to meet."""


_smooth: WeakKeyDictionary[Path, Path] = WeakKeyDictionary()
"""Loops in smooth pieces by the drawn ones: the flat and the bent body of a strip share them."""


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
    if path not in _smooth:
        if not any(_kinks(segment).size for segment in path.segments):
            return path
        ramp = RAMP * _reach(path)
        pieces = [piece for segment in path.segments for piece in _pieces(_smoothed(segment), ramp)]
        _smooth[path] = Path(pieces, path.closed)
    return _smooth[path]


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
    reach = np.minimum(np.diff(knots, prepend=first), np.diff(knots, append=last))[double]
    sides = [knots[double] - 1e-6 * reach, knots[double] + 1e-6 * reach]
    jump = np.abs(rows(sides[1], SMOOTH) - rows(sides[0], SMOOTH)).max(axis=1)
    slight = jump * reach**2 < NO_JUMP
    if not slight.any():
        return segment
    counts[double] -= slight
    whole = np.repeat(knots, counts)
    sites = interpolation_sites(whole, degree)
    points = interpolated(sites, rows(sites), whole, degree)
    points[[0, -1]] = curve.control_points[[0, -1]]
    return Spline(PlaneCurve.of_sound(whole, points, degree, None))


def _joints(curve: PlaneCurve, ramp: float) -> list[tuple[float, float, float]]:
    """Where the smooth parts of a graph meet, and where the part before ends and the part after begins."""
    kinks = _kinks(Spline(curve)).tolist()
    joints: list[tuple[float, float, float]] = []
    speed = abs(float(curve.control_points[-1, 0] - curve.control_points[0, 0]) / np.ptp(curve.domain))
    while kinks:
        first = last = kinks.pop(0)
        while kinks and (kinks[0] - last) * speed < ramp:
            last = kinks.pop(0)
        joints.append(((first + last) / 2, first, last))
    return joints


def _pieces(segment: Segment, ramp: float) -> list[Segment]:
    """The smooth parts of a segment, with lines across in place of ramps."""
    kinks = _kinks(segment)
    if not isinstance(segment, Spline) or not kinks.size:
        return [segment]
    curve = clamp_ends(segment.curve)
    first, last = curve.domain
    if pace(segment) is None:
        return [Spline(part) for part in trim_curves(curve, pairwise([first, *kinks.tolist(), last]))]
    joints = [(first, first, first), *_joints(curve, ramp), (last, last, last)]
    ends = [((a, b), (low, high)) for (a, _, low), (b, high, _) in pairwise(joints)]
    cut = trim_curves(curve, [smooth for _, smooth in ends])
    parts = [_extended(part, a, b) for part, ((a, b), _) in zip(cut, ends, strict=True)]
    pieces: list[Segment] = [Spline(parts[0])]
    for part in parts[1:]:
        meeting = pieces[-1].end
        step = float(np.hypot(*(part.control_points[0] - meeting)))
        if step > NO_STEP:
            pieces += [Line(meeting, part.control_points[0]), Spline(part)]
        else:
            met = np.vstack([meeting, part.control_points[1:]])
            pieces.append(Spline(PlaneCurve.of_sound(part.knots, met, part.degree, part.weights)))
    return pieces


def _extended(curve: PlaneCurve, first: float, last: float) -> PlaneCurve:
    """A clamped graph with its end spans carried on, or cut back, to a domain that differs a little."""
    if (first, last) == curve.domain:
        return curve
    from scipy.interpolate import BSpline

    degree, knots = curve.degree, curve.knots.copy()
    knots[: degree + 1], knots[-degree - 1 :] = first, last
    sites = interpolation_sites(knots, degree)
    values = BSpline(np.array(curve.knots), np.array(curve.control_points), degree)(sites)
    return PlaneCurve.of_sound(knots, interpolated(sites, values, knots, degree), degree, None)
