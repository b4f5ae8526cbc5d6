"""Noise of measured points, against noise that was put into them."""

import numpy as np
import pytest

from elastica_cad import PlaneCurve, check_equilibrium
from elastica_cad.form_finding import smooth_curve
from elastica_cad.geometry.fairing import round_corners
from elastica_cad.geometry.measured_points import MeasuredPoints, Provenance, estimate_noise

pytestmark = pytest.mark.core


def wave(count, noise=0.0, seed=1):
    x = np.linspace(0.0, 400.0, count)
    points = np.column_stack([x, 40 * np.sin(x / 70)])
    return points + noise * np.random.default_rng(seed).normal(size=points.shape)


@pytest.mark.parametrize("count", [25, 60, 200, 1000])
@pytest.mark.parametrize("noise", [0.05, 0.5, 2.0])
def test_noise_is_estimated(count, noise):
    found = [estimate_noise(wave(count, noise, seed)) / noise for seed in range(12)]
    assert 0.8 < np.median(found) < 1.2
    assert max(found) < 1.9


@pytest.mark.parametrize("count", [5, 12, 25, 60, 200])
def test_a_smooth_curve_has_none(count):
    assert not MeasuredPoints.of(wave(count)).is_noisy


def test_points_follow_their_curve():
    """Moved, turned, enlarged and run backwards; a part and a projective image have none."""
    points = MeasuredPoints(wave(30, 0.5), 0.5)
    drawn = Provenance(measured=points)
    larger = drawn.transformed(np.array([[0.0, -2.0, 5.0], [2.0, 0.0, 7.0], [0.0, 0.0, 1.0]])).measured
    assert larger.noise == pytest.approx(1.0)
    assert larger.points[3] == pytest.approx((5 - 2 * points.points[3, 1], 7 + 2 * points.points[3, 0]))
    assert drawn.reversed().measured.points[0] == pytest.approx(points.points[-1])
    assert drawn.of_part().measured is None
    assert drawn.transformed(np.array([[1.0, 0, 0], [0, 1, 0], [1e-4, 0, 1]])).measured is None


@pytest.mark.parametrize(("decimals", "half"), [(0, 0.5), (2, 0.005), (4, 5e-5)])
def test_the_numbers_show_their_decimals(decimals, half):
    points = MeasuredPoints.of(wave(60).round(decimals))
    assert points.rounding == half
    assert points.resolution == max(1e-3, half * np.sqrt(2))


def test_the_point_at_a_place_and_its_neighbours_turn():
    points = MeasuredPoints.of(np.array([(0, 0), (10, 0), (20, 0), (25, 5), (25, 15), (25, 25.0)]))
    assert np.degrees(points.turns_beside((24, 5))).round(6).tolist() == [45, 45, 0]
    assert np.degrees(points.turns_beside((10, 1))).round(6).tolist() == [0, 0, 45]


FEET = np.array([*range(11), 10.5])
INCHES = np.array([1, 7.625, 13.125, 17.5, 20.625, 22.625, 23.4375, 23.125, 21.625, 19.25, 15.75, 13.625])
"""A table of offsets: half-breadths of a boat."""


def offsets(mistyped=0.0):
    """The table (12, 2) in mm; 2-0-1 was typed for 1-11-1 with `mistyped` 1."""
    return 25.4 * np.column_stack([12 * FEET, INCHES + mistyped * (np.arange(12) == 7)])


@pytest.mark.parametrize("mistyped", [0.0, 1.0])
@pytest.mark.parametrize("smooth", [0.5, 2.0, 3.0, 4.0, 6.0, 10.0, 20.0])
def test_a_smoothed_curve_swings_no_more_between_its_points(smooth, mistyped):
    """A fit with nearly as many control points as points was 500 mm longer at 4 mm, and 0.4 mm off the points."""
    points = MeasuredPoints.of(offsets(mistyped))
    through = PlaneCurve.fit(points.points, tolerance=0.01)
    smoothed, moved = round_corners(through.drawn_as(Provenance(measured=points)), smooth)
    bends = [np.abs(np.diff(one.sample(801).curvature)).sum() for one in (smoothed, through)]
    assert moved <= 1.001 * smooth
    assert bends[0] < bends[1]
    assert smoothed.length < 1.0003 * through.length
    beside = np.interp(smoothed.sample(801).position[:, 0], *through.sample(801).position.T)
    assert np.abs(beside - smoothed.sample(801).position[:, 1]).max() < 3 * smooth + 1


def test_smoothing_within_what_is_reported_takes_all_inflections_out():
    for mistyped in (0.0, 1.0):
        points = MeasuredPoints.of(offsets(mistyped))
        through = PlaneCurve.fit(points.points, tolerance=0.01).drawn_as(Provenance(measured=points))
        assert points.reach < 12
        assert not round_corners(through, points.reach)[0].curvature_zeros


def test_a_check_reports_them_before_all_else():
    """Also where a strip happens to take the curve; nobody smooths by a mistyped point."""
    noisy, mistyped = (PlaneCurve.fit(points, tolerance=0.01) for points in (wave(25, 0.3), offsets(1.0)))
    undecided = check_equilibrium(noisy)
    assert str(undecided).startswith("The points are too few ")
    assert "Set smooth" in str(undecided)
    assert undecided.details[1].endswith("the points have noise of about 0.3 mm.")
    assert noisy.provenance.measured.noise_message.endswith(": set smooth to about 0.77 mm to smooth them")
    message = str(check_equilibrium(mistyped))
    assert "number 8 of 12" in message.split(": ", maxsplit=1)[0]
    assert "smooth" not in message
    smoothed = smooth_curve(noisy, 2.0).curve
    assert "have noise" not in str(check_equilibrium(smoothed))


def test_the_mistyped_point_is_named():
    (message,) = MeasuredPoints.of(offsets(1.0)).outlier
    assert "(2134, 612.8) mm, number 8 of 12, is 27 mm from" in message
    assert MeasuredPoints.of(offsets()).outlier == ()
    assert not any(MeasuredPoints(wave(25, 0.5, seed), 0.5).outlier for seed in range(40))


HEIGHTS = np.array(
    [29.5, 27.75, 26.125, 24.875, 23.875, 23.125, 22.625, 22.375, 22.375, 22.625, 23.125, 24, 25]
)
BREADTHS = np.array([2.25, 7, 11, 14.375, 17.125, 19.375, 21, 22.125, 22.75, 23, 22.75, 22.25, 21.375])


@pytest.mark.parametrize("wrong", [-1.0, 1.0])
@pytest.mark.parametrize("offsets", [HEIGHTS, BREADTHS])
def test_an_inch_wrong_is_named_at_every_station_but_the_ends(offsets, wrong):
    table = 25.4 * np.column_stack([13.0 * np.arange(13), offsets])
    for at in range(1, 12):
        (result,) = MeasuredPoints(
            table + np.outer(np.arange(13) == at, [0.0, 25.4 * wrong]), 0.92, 0.92
        ).outlier
        assert result.values["number"] == at + 1


@pytest.mark.parametrize("count", [13, 24])
def test_none_is_named_of_tables_that_are_only_rounded(count):
    """To eighths of an inch, of the same sheer with some other rise."""
    t = np.linspace(0.0, 1.0, count)
    for rise in np.linspace(0.0, 30.0, 40):
        eighths = np.round(8 * (29.5 + (rise - 23) * t + 18.5 * t**2))
        table = np.column_stack([3962.4 * t, 25.4 / 8 * eighths])
        assert MeasuredPoints(table, 0.92, 0.92).outlier == ()
