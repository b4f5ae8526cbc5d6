"""Distances from points to splines are those of the nearest of very many points."""

import numpy as np
import pytest

from elastica_cad import PlaneCurve
from elastica_cad.geometry import Spline
from elastica_cad.geometry.path import distances, largest_deviation

pytestmark = pytest.mark.core

WAVE = PlaneCurve.spline([(0, 0), (40, 90), (80, -90), (120, 90), (160, 0)], degree=3)
ROUND = PlaneCurve.arc((3.0, -2.0), 25.0, 0.3, 5.0)


@pytest.mark.parametrize("curve", [WAVE, ROUND])
@pytest.mark.parametrize("reach", [1e-9, 1e-3, 1.0, 60.0])
def test_distances_are_those_of_the_nearest_point(curve, reach):
    random = np.random.default_rng(5)
    points = curve.sample(60).position + reach * random.normal(size=(60, 2))
    dense = curve.evaluate(np.linspace(*curve.domain, 200_001))
    nearest = np.array([np.hypot(*(dense - point).T).min() for point in points])
    found = distances(Spline(curve), points)
    assert np.all(found <= nearest + 1e-12)
    half = np.hypot(*np.diff(dense, axis=0).T).max() / 2
    assert np.all(nearest <= np.hypot(found, 3 * half) + 1e-12)  # outside a bend points spread


def test_points_of_a_curve_lie_on_it():
    assert distances(Spline(WAVE), WAVE.sample(500).position).max() < 1e-12
    assert distances(Spline(WAVE), np.zeros((0, 2))).shape == (0,)
    assert largest_deviation(WAVE, WAVE.reversed()) < 1e-12
    assert largest_deviation(WAVE, WAVE.transformed(np.eye(3))) == 0.0


@pytest.mark.parametrize("curve", [WAVE, ROUND])
def test_curves_that_differ_by_rounding_are_as_near_as_the_same(curve):
    points = curve.control_points
    assert largest_deviation(curve, curve.with_control_points(points * (1 + 2e-16))) == 0.0
    off = largest_deviation(curve, curve.with_control_points(points + 1e-9))
    assert 1e-10 < off < 2e-9
    assert largest_deviation(curve, PlaneCurve.line(points[0], points[-1], degree=curve.degree)) > 1.0


def test_distances_do_not_hang_on_how_fast_a_curve_is_run_through():
    points = np.random.default_rng(8).normal((20, 10), 15, size=(200, 2))
    sharp = PlaneCurve([0, 0, 0, 1, 1, 1], [(0, 0), (20, 30), (40, 0)], 2, [1.0, 300.0, 1.0])
    dense = sharp.evaluate(sharp.parameter(np.linspace(0, sharp.length, 100_001)))
    nearest = np.array([np.hypot(*(dense - point).T).min() for point in points])
    found = distances(Spline(sharp), points)
    assert np.all(found <= nearest + 1e-6)
    assert np.all(nearest <= found + 1e-3)


@pytest.mark.parametrize(
    ("points", "place"),
    [
        (
            [(-1700, -700), (2400, 700), (-400, 2700), (1700, 3000), (-100, -1000), (-1500, 2500)],
            (792.5195014258, 876.3754669579),
        ),
        (
            [(-1100, -200), (2600, 2800), (-2600, -2500), (1600, -1600), (3000, 500), (-1100, 2200)],
            (360.3375943054, -873.8470765389),
        ),
    ],
)
def test_of_two_branches_about_as_far_the_nearer_one_is_taken(points, place):
    curve = PlaneCurve.spline(points, degree=3)
    dense = curve.evaluate(np.linspace(*curve.domain, 400_001))
    nearest = np.hypot(*(dense - np.array(place)).T).min()
    assert distances(Spline(curve), [place])[0] == pytest.approx(nearest, abs=1e-6)
