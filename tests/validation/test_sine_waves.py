"""Sine waves as one types them: of whole and half periods, with inflections at their ends.

The moment vanishes along y = 0, so the stiffness is y over the curvature: K = (1 + (A w cos)^2)^(3/2). Its largest
is (1 + (A w)^2)^(3/2) times the least.
"""

import numpy as np
import pytest

from elastica_cad import PlaneCurve, check_equilibrium, optimal_rod

pytestmark = pytest.mark.core

NEAR = 0.1
"""Of the ratio: an end that the fit has 1e-4 mm off the line moves there within the last knots, where the stiffness
changes with it."""


def sine(amplitude, length, periods, tolerance=1e-6):
    def points(t):
        return np.column_stack([length * t, amplitude * np.sin(2 * np.pi * periods * t)])

    return PlaneCurve.fit_function(points, 0.0, 1.0, tolerance=tolerance)


@pytest.mark.parametrize(
    ("amplitude", "length", "periods"),
    [
        # these were refused
        (59.0, 302.0, 2.0), (33.0, 238.0, 1.5), (20.7, 319.43, 1.5), (12.92, 168.42, 1.5), (30.63, 282.0, 1.5),
        (33.15, 126.13, 1.0), (39.0, 328.5, 2.0), (16.2, 164.0, 2.0),
        (20.0, 100.0, 0.5), (0.6, 10.0, 1.0), (500.0, 4000.0, 1.5),
    ],
)  # fmt: skip
@pytest.mark.parametrize("tolerance", [1e-6, 1e-7, 1e-8, 1e-9])
def test_waves_of_half_periods(amplitude, length, periods, tolerance):
    curve = sine(amplitude, length, periods, tolerance)
    check = check_equilibrium(curve)
    assert check.realizable, str(check)
    assert len(check.zeros) == 2 * periods + 1
    assert optimal_rod(curve).length == pytest.approx(curve.length, rel=1e-5)


def test_any_wave():
    rng = np.random.default_rng(20261122)
    for _ in range(25):
        decimals = int(rng.integers(0, 3))
        amplitude, length = round(rng.uniform(5, 60), decimals), round(rng.uniform(80, 400), decimals)
        periods = float(rng.choice([0.5, 1.0, 1.5, 2.0]))
        ratio = (1 + (amplitude * 2 * np.pi * periods / length) ** 2) ** 1.5
        curve = sine(amplitude, length, periods)
        assert optimal_rod(curve).ratio == pytest.approx(ratio, rel=NEAR), (amplitude, length, periods)


@pytest.mark.parametrize("periods", [0.25, 0.75, 0.7])
@pytest.mark.parametrize("tolerance", [1e-6, 1e-8])
def test_waves_with_one_end_bent(periods, tolerance):
    rod = optimal_rod(sine(20.0, 120.0, periods, tolerance))
    assert np.isfinite(rod.ratio)
    assert rod.ratio <= (1 + (20.0 * 2 * np.pi * periods / 120.0) ** 2) ** 1.5 * (1 + NEAR)
