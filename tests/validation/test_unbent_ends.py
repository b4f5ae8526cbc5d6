"""Curves whose bending runs out at their ends: under weight, and between ends that are free to turn."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from elastica_cad import Gravity, PlaneCurve, Supports, check_equilibrium, optimal_rod
from elastica_cad.mechanics import RestCurvature

pytestmark = pytest.mark.core


def half_wave(length, height, tolerance=1e-6):
    def points(t):
        return np.column_stack([length * t, height * np.sin(np.pi * t)])

    return PlaneCurve.fit_function(points, 0.0, 1.0, tolerance=tolerance)


def marched_end(rod):
    """Where the rod ends by its equations alone (paper, Eq. 5), from its start with the force and moment there."""
    q = 0.0 if rod.gravity is None else rod.gravity.length**-3

    def slopes(s, state):
        angle, moment, force_x, force_y = state[2:]
        K = rod.profile(np.array(s))
        tangent = np.array([np.cos(angle), np.sin(angle)])
        return [*tangent, moment / K, tangent[0] * force_y - tangent[1] * force_x, 0.0, -q * K]

    start = [*rod.position[0], rod.angle[0], rod.moment[0], *rod.force[0]]
    return solve_ivp(slopes, (0.0, rod.length), start, rtol=1e-10, atol=1e-10).y[:, -1]


@pytest.mark.parametrize("height", [10.0, 35.0, 62.0, 70.0, 84.0, 98.0, 112.0, 126.0, 200.0])
@pytest.mark.parametrize("tolerance", [1e-5, 1e-6, 1e-8])
def test_half_waves_under_weight(height, tolerance):
    rod = optimal_rod(half_wave(200.0, height, tolerance), Gravity(length=500.0))
    assert rod.residual < 1e-8
    assert rod.moved < 1e-3
    assert np.hypot(*(marched_end(rod)[:2] - rod.position[-1])) < 0.01


def test_long_floppy_waves():
    """Rounding grows along them by some hundred thousand times; the width must not show it."""
    for tolerance in (1e-6, 1e-8):
        rod = optimal_rod(half_wave(1814.3, 127.3, tolerance), Gravity(length=412.0))
        assert rod.ratio == pytest.approx(6.68, rel=0.01)


@pytest.mark.parametrize("gravity", [None, Gravity(length=500.0)])
@pytest.mark.parametrize("height", [20.0, 70.0, 150.0])
@pytest.mark.parametrize("tolerance", [1e-3, 1e-4, 1e-6])
def test_ends_that_are_free_to_turn(height, tolerance, gravity):
    """The coarser the fit, the more bend is left in its ends: the curve moves by not much more than the fit did."""
    pinned = Supports("pinned", "pinned")
    rod = optimal_rod(half_wave(200.0, height, tolerance), gravity, pinned)
    assert rod.moved <= 20 * tolerance
    assert np.abs(rod.curvature[[0, -1]]).max() < 1e-12
    assert np.abs(rod.moment[[0, -1]]).max() < 1e-12
    assert np.hypot(*(marched_end(rod)[:2] - rod.position[-1])) < 0.01


def test_blanks_take_waves_too():
    curve = half_wave(200.0, 70.0)
    blank = RestCurvature.linear([0.0, curve.length / 2, curve.length], [0.0, -0.002, 0.0])
    rod = optimal_rod(curve, natural_curvature=blank)
    assert rod.residual < 1e-8


def test_ends_that_are_clearly_bent_are_refused():
    arc = PlaneCurve.ellipse((0, 0), (100, 60), start=0.3, end=2.8)
    check = check_equilibrium(arc, Supports("pinned", "clamped"))
    assert not check.realizable
    assert "free to turn" in check.reasons[0]
    assert check.moved == 0.0
