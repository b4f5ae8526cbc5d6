"""Optimal rods of many curves: order, failures, executors."""

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from elastica_cad import NotRealizable, PlaneCurve, optimal_rod
from elastica_cad.mechanics import optimal_rods
from tests.refusals import refusal_test

pytestmark = pytest.mark.core

ARCH = PlaneCurve.spline([(0, 0), (30, 60), (70, 60), (100, 0)], degree=3)
WAVE = PlaneCurve.spline([(0, 0), (20, 50), (50, -40), (80, 55), (110, -30), (140, 0)], degree=4)


@pytest.mark.parametrize("threads", [0, 2])
def test_a_curve_that_no_rod_takes_does_not_lose_the_others(threads):
    if threads:
        with ThreadPoolExecutor(threads) as executor:
            first, error, last = optimal_rods([ARCH, WAVE, ARCH.reversed()], executor=executor, samples=50)
    else:
        first, error, last = optimal_rods([ARCH, WAVE, ARCH.reversed()], samples=50)
    assert isinstance(error, NotRealizable)
    np.testing.assert_array_equal(first.stiffness, optimal_rod(ARCH, samples=50).stiffness)
    assert last.ratio == pytest.approx(first.ratio)


REFUSED = [
    (lambda: optimal_rods(ARCH), "give a list of curves"),
    (lambda: optimal_rods([ARCH], executor=2), "give a concurrent.futures.Executor"),
]

test_a_wrong_argument_is_refused = refusal_test(REFUSED)
