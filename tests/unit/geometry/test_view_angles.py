"""The angle under which a curve is seen from one of its points, against dense sampling and closed forms."""

import numpy as np
import pytest

from elastica_cad import PlaneCurve
from elastica_cad.geometry.self_intersections import find_view_angles

pytestmark = pytest.mark.core


def test_arc_from_its_start():
    """The angle between chord and tangent is half the angle at the centre."""
    curve = PlaneCurve.arc((3, 5), 40, 0.0, 5.0)
    views = find_view_angles(curve, curve.domain[0])
    assert views.low == pytest.approx(np.pi / 2, abs=1e-12)
    assert views.high == pytest.approx(np.pi / 2 + 2.5, abs=1e-12)
    assert (views.low_t, views.high_t) == pytest.approx(curve.domain)


def test_arc_from_its_middle():
    curve = PlaneCurve.arc((3, 5), 40, 0.0, 5.0)
    views = find_view_angles(curve, float(curve.parameter(100.0)))
    assert views.high - views.low == pytest.approx(2.5, abs=1e-9)


@pytest.mark.parametrize("at", [0.0, 0.2, 0.5, 0.5 + 1e-11, 0.5 + 1e-7, 0.83, 1.0])
@pytest.mark.parametrize("weights", [None, (1, 2, 0.5, 1, 1.5, 1)])
def test_wave_agrees_with_samples(at, weights):
    points = [(0, 0), (50, 80), (90, 60), (120, -60), (160, -80), (210, 0)]
    knots = [0, 0, 0, 0, 0, 0.5, 1, 1, 1, 1, 1]
    curve = PlaneCurve(np.array(knots), np.array(points, dtype=float), 4, weights and np.array(weights))
    views = find_view_angles(curve, at)
    t = np.linspace(0, 1, 20001)
    t = t[np.abs(t - at) > 1e-4]
    away = (curve.evaluate(t) - curve.evaluate(at)) * np.sign(t - at)[:, None]
    angle = np.unwrap(np.arctan2(away[:, 1], away[:, 0]))
    tangent = curve.angle_at(at)
    angle += 2 * np.pi * np.round((views.low - angle.min()) / (2 * np.pi))
    assert views.low == pytest.approx(min(angle.min(), tangent), abs=3e-4)
    assert views.high == pytest.approx(max(angle.max(), tangent), abs=3e-4)
    assert views.low <= angle.min() + 1e-9
    assert views.high >= angle.max() - 1e-9


def test_a_spiral_is_followed_through_more_than_a_turn():
    spiral = PlaneCurve.fit_function(lambda v: np.column_stack([v * np.cos(v), v * np.sin(v)]), 1, 30)
    views = find_view_angles(spiral, spiral.domain[0])
    assert views.high - views.low > 8 * np.pi


def test_curve_that_comes_back():
    """A loop that passes its own point again is seen in no direction there."""
    loop = PlaneCurve.spline([(0, 0), (100, 0), (100, 80), (0, 80), (0, 0)])
    assert find_view_angles(loop, loop.domain[0]) is None
