"""The rail, pin or tie that makes an impossible curve possible."""

from contextlib import suppress

import pytest

import elastica_cad as ec
from elastica_cad.mechanics import suggest_support
from elastica_cad.mechanics.moment_conditions import RodRequest
from elastica_cad.mechanics.optimal_balance import balance_of, ratio_within

WAVE = [(0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (360, 0)]


def test_the_rail_has_the_least_ratio_of_the_stable_ones():
    curve = ec.PlaneCurve.spline(WAVE, degree=5)
    rail = suggest_support(curve)
    assert isinstance(rail, ec.Rail)
    rod = ec.optimal_rod(curve, between=rail)
    assert ec.stability(rod).stable
    for k in (5, 7):
        with suppress(ec.NotRealizable):
            other = ec.optimal_rod(curve, between=ec.Rail(curve.length * k / 12))
            assert other.ratio > 0.98 * rod.ratio or not ec.stability(other).stable


@pytest.mark.parametrize("at", [100, 330])
def test_a_support_is_added_to_those_that_the_rod_has(at):
    curve, rail = ec.PlaneCurve.spline(WAVE, degree=5), ec.Rail(at)
    with pytest.raises(ec.NotRealizable):
        ec.optimal_rod(curve, between=rail)
    added = suggest_support(curve, between=rail)
    assert ec.stability(ec.optimal_rod(curve, between=(rail, added))).stable


def test_a_straight_curve_needs_no_element():
    assert suggest_support(ec.PlaneCurve.line((0, 0), (100, 20))) is None


@pytest.mark.parametrize("at", [60, 120, 197, 250, 330])
@pytest.mark.parametrize("kind", [ec.Rail, ec.Pin])
def test_a_ratio_within_a_limit_is_that_of_the_rod(at, kind):
    """The search decides as the whole calculation, which words a reason and smooths the stiffness."""
    points = [(0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (360, 0)]
    request = RodRequest(ec.PlaneCurve.spline(points, degree=5), between=(kind(at),))
    try:
        values = balance_of(request).stiffness.extremes
        least = values.max() / values.min()
    except ec.NotRealizable:
        assert ratio_within(request, 1e6) is None
        return
    ratio = ratio_within(request, 1.001 * least)
    assert ratio is not None
    assert ratio <= least <= 1.011 * ratio
    assert ratio_within(request, 0.98 * least) is None
