"""First-order changes of curvature, stiffness and stability with the control points, against differences."""

import numpy as np
import pytest

from elastica_cad import PlaneCurve, optimal_rod, stability
from elastica_cad.form_finding.equilibrium_curve import EquilibriumCurve, collinear, kept
from elastica_cad.geometry import least_norm_newton
from elastica_cad.geometry.control_point_constraints import curvature_rows
from elastica_cad.paper.control_points import CurveChanges

pytestmark = pytest.mark.core


def s_curve():
    """Three inflections on a line, unstable; not symmetric."""
    x = np.linspace(-3.9, 4.2, 200)
    y = 100 * np.sin(x) * (1 + 0.03 * x)
    curve = PlaneCurve.fit(np.column_stack([55 * x + 0.2 * y, y]), tolerance=0.5)
    return enforced(curve, ())


def enforced(curve, constraints):
    return least_norm_newton(curve, [*constraints, *collinear(curve)], tolerance=1e-14)[0]


def rational():
    """Two inflections."""
    points = [(0, 0), (35, -4), (55, 60), (80, 85), (110, 50), (130, -8), (170, 10)]
    curve = PlaneCurve.spline(points, degree=4)
    return PlaneCurve(curve.knots, curve.control_points, 4, [1.0, 1.4, 0.8, 1.2, 0.7, 1.1, 1.0])


@pytest.mark.parametrize("make", [s_curve, rational])
def test_curvature_rows(make):
    curve = make()
    t = np.linspace(*curve.domain, 23)[1:-1]
    move = np.random.default_rng(1).normal(size=curve.control_points.shape)
    rows = curvature_rows(curve, t) @ move.ravel()

    def difference(h):
        ahead, behind = (curve.with_control_points(curve.control_points + e * move) for e in (h, -h))
        return (ahead.curvature_at(t) - behind.curvature_at(t)) / (2 * h)

    expected = (4 * difference(5e-4) - difference(1e-3)) / 3
    np.testing.assert_allclose(rows, expected, atol=1e-8 * np.abs(expected).max())


@pytest.mark.parametrize("make", [s_curve, rational])
@pytest.mark.parametrize("seed", [0, 1])
def test_stiffness_and_margin_along_equilibrium_curves(make, seed):
    """Moves that keep ends, tangents and length, against differences of restored curves."""
    curve = make()
    constraints = kept(curve, ends=True, tangents=(True, False), length=True)
    state = EquilibriumCurve.of(curve)
    changes = CurveChanges(state, constraints)
    u = np.random.default_rng(seed).normal(size=changes.basis.shape[1])
    move = (changes.basis[:-3] @ u).reshape(-1, 2)
    t = np.linspace(*curve.domain, 29)[1:-1]
    first = state.balance.panels.locate(t[:1])

    def at(h):
        """log K and the margin, both with K = 1 at the first place."""
        moved = EquilibriumCurve.of(
            enforced(curve.with_control_points(curve.control_points + h * move), constraints)
        )
        K = moved.balance.stiffness.at(*moved.balance.panels.locate(t))
        return np.append(np.log(K / K[0]), moved.rod.margin.value * moved.scale / K[0])

    def difference(h):
        return (at(h) - at(-h)) / (2 * h)

    size = curve.length * 1e-4 / np.abs(move).max()
    expected = (4 * difference(size / 2) - difference(size)) / 3
    places = state.balance.panels.locate(t)
    K = state.balance.stiffness.at(*places) / state.scale
    growth = -K * (changes.compliance.at(*places) @ u)
    K0 = float(state.balance.stiffness.at(*first)[0]) / state.scale
    np.testing.assert_allclose(growth - growth[0], expected[:-1], atol=1e-7 * np.abs(growth).max())
    margin = (changes.margin @ u - state.rod.margin.value * growth[0]) / K0
    assert margin == pytest.approx(expected[-1], rel=1e-7, abs=1e-7 * abs(state.rod.margin.value / K0))


@pytest.mark.parametrize("make", [s_curve, rational])
def test_state_is_that_of_the_optimal_rod(make):
    curve = make()
    state, rod = EquilibriumCurve.of(curve), optimal_rod(curve)
    assert state.ratio == pytest.approx(rod.ratio, rel=1e-7)
    assert state.margin == pytest.approx(stability(rod).margin, rel=1e-6)
    a, b = state.line
    moment = (a + rod.position @ b) / state.rod.stiffness.min()
    np.testing.assert_allclose(moment, rod.moment, atol=1e-9 * np.abs(rod.moment).max())
