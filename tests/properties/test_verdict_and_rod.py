"""Whoever asks: what `check_equilibrium` calls realizable gets a rod, on the very border too."""

from math import comb

import numpy as np
import pytest
from hypothesis import given, reject, settings
from hypothesis import strategies as st

from elastica_cad import NotRealizable, PlaneCurve, check_equilibrium, optimal_rod

pytestmark = pytest.mark.core

HALVINGS = 36
TRIES = 60  # for a curve of either kind


def graph(*powers, low=-1.0, high=1.0):
    """y = sum of powers[k] x^k, exactly, 100 mm a unit."""
    degree = len(powers) - 1
    shifted = np.polynomial.Polynomial(powers)(np.polynomial.Polynomial([low, high - low])).coef
    shifted = np.pad(shifted, (0, degree + 1 - shifted.size))
    y = [sum(comb(j, k) / comb(degree, k) * shifted[k] for k in range(j + 1)) for j in range(degree + 1)]
    return PlaneCurve.spline(100 * np.column_stack([np.linspace(low, high, degree + 1), y]), degree=degree)


def agreed(curve):
    """The verdict, after the rod has been asked too."""
    realizable = check_equilibrium(curve).realizable
    try:
        found = optimal_rod(curve).ratio >= 1
    except NotRealizable:
        found = False
    assert realizable == found
    return realizable


@pytest.mark.parametrize("slight", [0.0, *(10.0**-k for k in range(16))])
@pytest.mark.parametrize("sign", [1, -1])
def test_nearly_flat_curves(slight, sign):
    agreed(graph(0, 0, sign * slight, 0, 1))
    agreed(graph(0, 0, 0, sign * slight, 0, 1))


def test_a_dip_that_no_strip_can_take_is_refused_and_a_shallower_one_taken():
    refused = check_equilibrium(graph(0, 0, 1e-10, 0, 1))
    assert not refused.realizable
    assert abs(refused.curvature_touches[0] - refused.length / 2) < 0.1
    assert not agreed(graph(0, 0, 0, 1e-6, 0, 1))
    assert agreed(graph(0, 0, 1e-5, 0, 1))
    assert agreed(graph(0, 0, 0, 1e-4, 0, 1))


@pytest.mark.campaign
@settings(max_examples=3, deadline=None)
@given(st.integers(0, 10**6))
def test_on_the_border_between_a_curve_that_can_be_bent_and_one_that_cannot(seed):
    rng = np.random.default_rng(seed)
    degree = int(rng.integers(3, 6))
    count = degree + 1 + int(rng.integers(0, 2))
    ends = {}
    for _ in range(TRIES):
        points = np.column_stack([np.linspace(0, 1, count), rng.normal(size=count) * 0.3])
        points[:, 0] += rng.normal(size=count) * 0.05
        if seed % 2:
            points = (points - points[::-1]) / 2
        ends.setdefault(agreed(PlaneCurve.spline(200 * points, degree=degree)), points)
        if len(ends) == 2:
            break
    else:
        reject()
    low, high = 0.0, 1.0
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        points = ends[True] + (ends[False] - ends[True]) * middle
        low, high = (
            (middle, high) if agreed(PlaneCurve.spline(200 * points, degree=degree)) else (low, middle)
        )
