"""Pieces of segments, cut exactly."""

from itertools import pairwise

from elastica_cad.errors import InputError
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.segments import Arc, Line, Segment, Spline


def trim_segment(segment: Segment, u0: float, u1: float) -> Segment:
    """The part of a segment between 0 <= u0 < u1 <= 1, exact."""
    if not 0 <= u0 < u1 <= 1:
        raise InputError(f"a segment is trimmed between 0 <= u0 < u1 <= 1, got {u0:g} and {u1:g}")
    if (u0, u1) == (0, 1):
        return segment
    if isinstance(segment, Line):
        return Line(segment.at(u0), segment.at(u1))
    if isinstance(segment, Arc):
        a, sweep = segment.start_angle, segment.sweep
        return Arc(segment.center, segment.radius, a + u0 * sweep, a + u1 * sweep)
    return Spline(trim_curve(segment.curve, float(segment.parameter(u0)), float(segment.parameter(u1))))


def clamp_ends(curve: PlaneCurve) -> PlaneCurve:
    """The same curve with its end knots repeated, so that it starts and ends on control points."""
    p, knots = curve.degree, curve.knots
    if knots[0] == knots[p] and knots[-1] == knots[-p - 1]:
        return curve
    return curve.trimmed(*curve.domain)


def trim_curve(curve: PlaneCurve, t0: float, t1: float) -> PlaneCurve:
    """The part of a curve between two parameters as a clamped curve of its own."""
    return curve.trimmed(t0, t1)


def split_at_corners(curve: PlaneCurve) -> tuple[PlaneCurve, ...]:
    """The smooth pieces of a curve, in order; the curve itself where it has no corner.

    Examples
    --------
    >>> roof = PlaneCurve([0, 0, 0, 1, 1, 2, 2, 2], [(0, 0), (15, 20), (30, 40), (45, 20), (60, 0)], 2)
    >>> [round(piece.length, 6) for piece in split_at_corners(roof)]
    [50.0, 50.0]
    """
    low, high = curve.domain
    places = [low, *(corner.t for corner in curve.tangent_breaks), high]
    if len(places) == 2:
        return (curve,)
    return tuple(curve.trimmed(*ends).drawn_as(curve.provenance) for ends in pairwise(places))
