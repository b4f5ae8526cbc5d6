"""Nearly collinear inflections are brought onto one line, and little else moves."""

import numpy as np
import pytest

from elastica_cad import NotConvergedError, PlaneCurve, Supports, check_equilibrium, optimal_rod
from elastica_cad.geometry.fairing import fair_curve
from elastica_cad.mechanics.equilibrium_check import fit_inflection_line, project_inflections

pytestmark = pytest.mark.core


def sine(bend, start=-1.0, stop=7.2):
    x = np.linspace(start, stop, 300)
    return PlaneCurve.fit(np.column_stack([100 * x, 40 * np.sin(x) + bend * x**2]), degree=5, tolerance=1e-4)


def off_line(curve, zeros, normal=None):
    points = curve.evaluate(np.array([z.t for z in zeros]))
    return np.abs(fit_inflection_line(points, normal).distance(points)).max()


def projected(curve, zeros, normal=None, kappa_0=0.0):
    line = fit_inflection_line(curve.evaluate(np.array([z.t for z in zeros])), normal)
    return project_inflections(curve, zeros, line, kappa_0)


@pytest.mark.parametrize("bend", [0.001, 0.02, 0.2])
def test_inflections_are_collinear_afterwards_and_ends_stay(bend):
    curve = sine(bend)
    moved = projected(curve, curve.curvature_zeros)
    before = off_line(curve, curve.curvature_zeros)
    assert before > 1e-5 * bend * curve.length
    assert off_line(moved, moved.curvature_zeros) < 1e-10 * curve.length
    ends = np.array(curve.domain)
    np.testing.assert_allclose(moved.evaluate(ends), curve.evaluate(ends), atol=1e-9)
    tangents = [c.evaluate(ends, 1) / np.hypot(*c.evaluate(ends, 1).T)[:, None] for c in (curve, moved)]
    np.testing.assert_allclose(*tangents, atol=1e-9)
    t = np.linspace(*ends, 500)
    assert np.hypot(*(moved.evaluate(t) - curve.evaluate(t)).T).max() < 5 * before


@pytest.mark.parametrize(("points", "digits"), [(40, 3), (80, 4), (80, 6), (150, 4), (150, 6)])
def test_a_wave_of_a_pen_made_fair_is_a_strip(points, digits):
    """With hundreds of control points, rounding of these alone moves inflections by nanometres."""
    rng = np.random.default_rng(points + digits)
    for _ in range(2):
        x = np.linspace(0, 300, points)
        wave = np.column_stack([x, rng.uniform(25, 30) * np.sin(3.4 * np.pi * x / 300 + 0.3)])
        turn = rng.uniform(0, 2 * np.pi)
        wave = wave @ [[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]]
        drawn = PlaneCurve.spline(np.round(wave, digits))
        fair = fair_curve(drawn, 0.02).curve
        zeros = fair.curvature_zeros
        assert len(zeros) == 3
        assert off_line(fair, zeros) < 0.03
        check = check_equilibrium(fair)
        assert check.realizable, check.reasons
        assert off_line(check.curve, check.curve.curvature_zeros) < 1e-10 * fair.length
        assert optimal_rod(fair).residual < 1e-9


def test_rational_weights_are_kept():
    curve = sine(0.05)
    weights = 1 + 0.1 * np.sin(np.arange(len(curve.control_points)))
    curve = PlaneCurve(curve.knots, curve.control_points, curve.degree, weights)
    zeros = [z for z in curve.curvature_zeros if z.kind == "crossing"]
    moved = projected(curve, zeros)
    np.testing.assert_array_equal(moved.weights, weights)
    assert off_line(moved, moved.curvature_zeros) < 1e-10 * curve.length


def test_given_direction():
    curve = sine(0.02)
    moved = projected(curve, curve.curvature_zeros, normal=np.array([0.0, 1.0]))
    assert off_line(moved, moved.curvature_zeros, np.array([0.0, 1.0])) < 1e-10 * curve.length


def test_natural_curvature():
    curve, kappa_0 = sine(0.02), 2e-4
    moved = projected(curve, curve.curvature_equals(kappa_0), kappa_0=kappa_0)
    assert off_line(moved, moved.curvature_equals(kappa_0)) < 1e-10 * curve.length


def test_pinned_ends_keep_no_curvature():
    points = sine(0.02, 0.0, 2 * np.pi).control_points.copy()
    knots = sine(0.02, 0.0, 2 * np.pi).knots
    # no curvature at the ends: the first three control points on one line
    for a, b, c in ((0, 1, 2), (-1, -2, -3)):
        points[b] = (points[a] + points[c]) / 2
    curve = PlaneCurve(knots, points, 5)
    check = check_equilibrium(curve, Supports("pinned", "pinned"), tolerance=1e-2)
    assert [z.kind for z in check.zeros] == ["end", "crossing", "end"]
    assert max(abs(d) for _, d in check.off_line) > 1e-5 * curve.length
    assert check.realizable
    assert check.moved > 0
    assert np.abs(check.curve.curvature_at(np.array(curve.domain))).max() < 1e-12
    assert off_line(check.curve, check.zeros) < 1e-10 * curve.length


def test_check_and_rod_speak_of_the_moved_curve():
    curve = sine(0.004)
    check = check_equilibrium(curve)
    assert check.realizable
    assert 0 < check.moved < 0.2
    assert check.curve is not curve
    rod = optimal_rod(curve)
    assert rod.moved == check.moved
    assert rod.shape is not curve
    assert "moved by at most" in " ".join(rod.warnings)
    t = np.linspace(*curve.domain, 2001)
    assert np.hypot(*(rod.shape.evaluate(t) - curve.evaluate(t)).T).max() == pytest.approx(
        rod.moved, rel=1e-3
    )
    assert rod.residual < 1e-9


def test_tolerance_decides():
    curve = sine(0.004)
    assert not check_equilibrium(curve, tolerance=1e-7).realizable
    assert check_equilibrium(sine(0.5)).realizable is False
    assert check_equilibrium(sine(0.5), tolerance=0.05).realizable


def test_collinear_inflections_are_left_alone():
    two = sine(0.0, -0.9, 3.8)
    check = check_equilibrium(two)
    assert check.curve is two
    assert check.moved == 0.0
    assert check_equilibrium(two, Supports("clamped", "slide-y")).realizable


def test_a_move_too_far_says_so():
    curve = sine(0.2)
    zeros = curve.curvature_zeros
    with pytest.raises(NotConvergedError, match="control points"):
        projected(curve, zeros, normal=np.array([1.0, 0.0]))
