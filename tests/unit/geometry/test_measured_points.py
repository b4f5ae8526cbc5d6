"""Noise of measured points, against noise that was put into them."""

import numpy as np
import pytest

from elastica_cad.geometry.pen_curves.measured_points import MeasuredPoints, estimate_waver
from elastica_cad.geometry.pen_curves.provenance import Provenance

pytestmark = pytest.mark.core


def wave(count, noise=0.0, seed=1):
    x = np.linspace(0.0, 400.0, count)
    points = np.column_stack([x, 40 * np.sin(x / 70)])
    return points + noise * np.random.default_rng(seed).normal(size=points.shape)


@pytest.mark.parametrize("count", [25, 60, 200, 1000])
@pytest.mark.parametrize("noise", [0.05, 0.5, 2.0])
def test_noise_is_estimated(count, noise):
    found = [estimate_waver(wave(count, noise, seed)) / noise for seed in range(12)]
    assert 0.8 < np.median(found) < 1.2
    assert max(found) < 1.9


@pytest.mark.parametrize("count", [5, 12, 25, 60, 200])
def test_a_smooth_curve_has_none(count):
    assert MeasuredPoints.of(wave(count)) is None


def test_points_follow_their_curve():
    """Moved, turned, enlarged and run backwards; a part and a projective image have none."""
    points = MeasuredPoints(wave(30, 0.5), 0.5)
    drawn = Provenance(measured=points)
    larger = drawn.transformed(np.array([[0.0, -2.0, 5.0], [2.0, 0.0, 7.0], [0.0, 0.0, 1.0]])).measured
    assert larger.waver == pytest.approx(1.0)
    assert larger.points[3] == pytest.approx((5 - 2 * points.points[3, 1], 7 + 2 * points.points[3, 0]))
    assert drawn.reversed().measured.points[0] == pytest.approx(points.points[-1])
    assert drawn.of_part().measured is None
    assert drawn.transformed(np.array([[1.0, 0, 0], [0, 1, 0], [1e-4, 0, 1]])).measured is None
