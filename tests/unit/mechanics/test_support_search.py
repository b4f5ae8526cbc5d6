"""The rail, pin or tie that makes an impossible curve possible."""

from contextlib import suppress

import elastica_cad as ec
from elastica_cad.mechanics import suggest_support

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


def test_a_straight_curve_needs_no_element():
    assert suggest_support(ec.PlaneCurve.line((0, 0), (100, 20))) is None
