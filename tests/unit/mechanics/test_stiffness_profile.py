"""Stiffness along the strip as a spline: its error, its knots, and inflections a hair from a knot."""

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad import Profile
from elastica_cad._compiled_scipy import lapack
from elastica_cad.geometry import splines
from elastica_cad.mechanics.moment_conditions import RodRequest
from elastica_cad.mechanics.optimal_balance import balance_without_weight

pytestmark = pytest.mark.core

ARCH = [(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)]
WAVE = [(0, 0), (50, 80), (90, 60), (120, -60), (160, -80), (210, 0)]


def exact_stiffness(curve, s):
    """K at arc lengths, from the balance itself, least value 1 at the nodes of a rod."""
    balance = balance_without_weight(RodRequest(curve))
    nodes = np.linspace(0, curve.length, 601)
    at_nodes, K = (balance.stiffness.at(*balance.panels.locate(curve.parameter(x))) for x in (nodes, s))
    return K / at_nodes.min()


@pytest.mark.parametrize(("points", "most"), [(ARCH, 55), (WAVE, 130)])
def test_one_fit_with_few_knots_is_enough(points, most, monkeypatch):
    """Against the balance at many places; the knots are known before the first fit."""
    fits = []
    monkeypatch.setattr(splines, "lapack", lambda: fits.append(1) or lapack())
    curve = ec.PlaneCurve.spline(points)
    profile = ec.optimal_rod(curve).profile
    s = np.linspace(0, curve.length, 5001)
    K = exact_stiffness(curve, s)
    assert np.abs(profile(s) - K).max() < 1e-6 * K.max()
    assert profile.coefficients.size <= most
    assert len(fits) == 1


def test_inflection_a_hair_from_a_knot():
    """0.1 micrometre from it, where the rounding of the line through the inflections would show."""
    half = np.array([(-220.0, 10), (-190, -30), (-150, -60), (-100, -20), (-60, 60), (-20, 40)])
    points = np.concatenate([half, -half[::-1]])
    points[2:4] += [(1e-3, 0), (0, 1e-3)]
    curve = ec.PlaneCurve.spline(points)
    check = ec.check_equilibrium(curve)
    assert check.moved > 0
    s = np.array([b.s for b in check.curve.breaks])
    knot = s[np.argmin(np.abs(s - curve.length / 2))]
    assert min(abs(z.s - knot) for z in check.zeros) == pytest.approx(1e-4, rel=0.2)
    balance = balance_without_weight(RodRequest(check.curve, known_check=check))
    panel = int(np.argmin(np.abs(balance.panels.edge_s - knot)))
    before, after = balance.stiffness.at(np.array([panel - 1, panel]), np.array([1.0, -1.0]))
    assert before == pytest.approx(after, rel=1e-5)
    assert ec.optimal_rod(curve).ratio == pytest.approx(11.4905, rel=1e-4)


def test_knots_to_begin_with():
    """They are used as far as they lie apart from breaks and ends."""

    def kinked(s):
        return 2 + np.abs(s - 40) / 10

    profile = Profile.fit(
        kinked, 100.0, breaks=[(40.0, 0)], knots=[-5, 0, 20, 40, 40 + 1e-12, 70, 100, 120], tolerance=1e-9
    )
    assert profile.breaks == ((20.0, 2), (40.0, 0), (70.0, 2))
    assert profile(np.array([10.0, 40.0, 90.0])) == pytest.approx([5.0, 2.0, 7.0])
