"""Verdict on a curve that was fitted to points, compared with those on other curves through the same points."""

from collections.abc import Callable, Iterator
from contextlib import suppress

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import ElasticaError
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.point_distance import distances
from elastica_cad.geometry.paths.segments import Spline
from elastica_cad.geometry.pen_curves.measured_points import MeasuredPoints
from elastica_cad.geometry.polynomials.spline_fits import fit_spline, smoothest_spline
from elastica_cad.mechanics.theorem1.verdict import EquilibriumCheck, FittedVerdict, Undecided

MOST_POINTS = 400
"""Number of points that the other curves are fitted to; of more points some are left out."""


def compare_fits(
    check: EquilibriumCheck, drawn: PlaneCurve, judge: Callable[[PlaneCurve], EquilibriumCheck]
) -> Undecided | None:
    """Return both verdicts if another curve through the points has another one; None of a curve without points.

    Parameters
    ----------
    check : EquilibriumCheck
        Verdict on the `drawn` curve.
    judge : callable
        Verdict on another curve.
    """
    points = None if drawn.provenance is None else drawn.provenance.measured
    if (
        points is None or check.any_stiffness or (points.wavers and points.stray)
    ):  # which is to be mended first
        return None
    distance = _distance(points, drawn)
    for curve in _other_curves(points, distance):
        with suppress(ElasticaError):
            other = judge(curve)
            if other.realizable != check.realizable:
                fits = ((check, distance), (other, _distance(points, curve)))
                return Undecided(points.resolution, *(
                    FittedVerdict(one.realizable, far, len(one.inflections)) for one, far in fits
                ))  # fmt: skip
    return None


def _other_curves(points: MeasuredPoints, distance: float) -> Iterator[PlaneCurve]:
    """Yield fits within the resolution of the points, a fit to every other point, and a smoother one.

    The smoother one may leave the points by half as much as the fit to every other point does.
    """
    step = -(-len(points.points) // MOST_POINTS)
    some, half = _thinned(points.points, step), _thinned(points.points, 2 * step)
    loose = max(distance, points.resolution)
    for degree in (4, 5, 3):
        with suppress(ElasticaError):
            yield PlaneCurve(*fit_spline(some, degree, points.resolution), degree)
    smoother = max(points.reach, loose)
    with suppress(ElasticaError):
        coarse = PlaneCurve(*fit_spline(half, 4, loose), 4)
        smoother = max(smoother, _distance(points, coarse) / 2)
        yield coarse
    with suppress(ElasticaError):
        yield PlaneCurve(*smoothest_spline(some, 4, smoother), 4)


def _thinned(points: FloatArray, step: int) -> FloatArray:
    """Every `step`-th point and the last."""
    return np.concatenate([points[:-1:step], points[-1:]])


def _distance(points: MeasuredPoints, curve: PlaneCurve) -> float:
    """Largest distance of the points from a curve, mm."""
    return float(distances(Spline(curve), points.points).max())
