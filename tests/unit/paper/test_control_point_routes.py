"""Ratio, stability and constraints by moved control points: promises, statuses, bad input."""

import numpy as np
import pytest

from elastica_cad import (
    NotConvergedError,
    NotRealizable,
    PlaneCurve,
    check_equilibrium,
    optimal_rod,
    stability,
)
from elastica_cad.paper import enforce_constraints, optimize_ratio, recover_stability
from tests.refusals import refusal_test

pytestmark = pytest.mark.core

PHI = np.linspace(0, np.pi, 200)
ARCH = PlaneCurve.fit(np.column_stack([70 * np.cos(PHI), 100 * np.sin(PHI)]), tolerance=0.01)


def wave(bend=0.0):
    """A damped sine with three inflections, on a line but for `bend`."""
    x = np.linspace(-3.7, 4.0, 200)
    y = np.sin(x) * (1 + 0.02 * x)
    return PlaneCurve.fit(np.column_stack([60 * x + 6 * y, 70 * y + bend * x**2]), tolerance=0.5)


def unit_tangents(curve):
    velocity = curve.evaluate(np.array(curve.domain), 1)
    return velocity / np.hypot(*velocity.T)[:, None]


def crossings(curve):
    return np.array([z.t for z in curve.curvature_zeros if z.kind == "crossing"])


def test_enforced_inflections_are_collinear():
    curve = wave(bend=0.5)
    assert not check_equilibrium(curve).realizable
    found = enforce_constraints(curve)
    points = found.curve.evaluate(crossings(found.curve))
    (x0, y0), (x1, y1), (x2, y2) = points
    assert abs((x1 - x0) * (y2 - y0) - (y1 - y0) * (x2 - x0)) < 1e-6
    assert check_equilibrium(found.curve, tolerance=1e-9).realizable
    assert found.curve.length == pytest.approx(curve.length, abs=1e-7)
    np.testing.assert_allclose(unit_tangents(found.curve), unit_tangents(curve), atol=1e-9)
    assert 0 < found.moved < 10
    assert list(found.residuals) == sorted(found.residuals, reverse=True)


def test_enforced_on_a_given_line_and_like_another_curve():
    straight, bent = wave(), wave(bend=0.3)
    line = check_equilibrium(straight, tolerance=1e-3).line
    found = enforce_constraints(bent, line=line, like=straight, tangents=(True, False))
    assert np.abs(line.distance(found.curve.evaluate(crossings(found.curve)))).max() < 1e-7
    assert found.curve.length == pytest.approx(straight.length, abs=1e-7)
    ends = np.array(straight.domain)
    np.testing.assert_allclose(
        found.curve.evaluate(np.array(bent.domain)), straight.evaluate(ends), atol=1e-7
    )
    np.testing.assert_allclose(unit_tangents(found.curve)[0], unit_tangents(straight)[0], atol=1e-9)


def test_an_inflection_that_comes_on_the_way_is_reported():
    """Three are brought onto a line, and a fourth appears beside the start: it had been returned as enforced."""
    points = [(4, 22), (21, 5), (30, -6), (48, -39), (65, 47), (78, -38), (100, 29)]
    with pytest.raises(NotConvergedError, match=r"has 4 inflections \(at .* mm\) instead of 3: switch off"):
        enforce_constraints(PlaneCurve.spline(points, degree=4))


def test_contradicting_constraints():
    tight = PlaneCurve.spline([(70, 0), (60, 90), (-70, 0)], degree=2)
    with pytest.raises(NotConvergedError, match="constraints"):
        enforce_constraints(tight, like=ARCH)


@pytest.mark.parametrize("keep", [{}, {"tangents": True}, {"tangents": True, "length": True}])
def test_ratio_of_an_arch(keep):
    assert optimal_rod(ARCH).ratio > 1.5
    found = optimize_ratio(ARCH, 1.3, **keep)
    assert found.status.name == "REACHED"
    assert optimal_rod(found.curve).ratio <= 1.3
    np.testing.assert_allclose(
        found.curve.evaluate(np.array(ARCH.domain)), ARCH.evaluate(np.array(ARCH.domain)), atol=1e-8
    )
    if "tangents" in keep:
        np.testing.assert_allclose(unit_tangents(found.curve), unit_tangents(ARCH), atol=1e-9)
    if "length" in keep:
        assert found.curve.length == pytest.approx(ARCH.length, abs=1e-7)
    assert found.history[0].ratio == pytest.approx(optimal_rod(ARCH).ratio, rel=1e-6)
    assert found.history[-1].ratio == pytest.approx(found.ratio)


def test_what_is_kept_costs_distance():
    free, held = (optimize_ratio(ARCH, 1.3, tangents=t, length=t) for t in (False, True))
    assert 0 < free.history[-1].distance < held.history[-1].distance


def test_nothing_to_do():
    found = optimize_ratio(ARCH, 10.0)
    np.testing.assert_array_equal(found.curve.control_points, ARCH.control_points)
    assert found.deviation < 1e-9


def test_unreachable_ratio():
    short = PlaneCurve.spline([(0, 0), (10, 60), (90, -20), (100, 0)], degree=3)
    found = optimize_ratio(short, 1.01, tangents=True, length=True)
    assert found.status.name == "UNREACHABLE"
    assert "give up the tangents" in found.status.value
    assert found.ratio <= optimal_rod(short).ratio * (1 + 1e-9)
    assert check_equilibrium(found.curve).realizable


def test_scale_does_not_matter():
    curve = wave()
    small = curve.with_control_points(curve.control_points / 100)
    large, tiny = optimize_ratio(curve, 8.0), optimize_ratio(small, 8.0)
    assert tiny.iterations == large.iterations
    assert tiny.deviation * 100 == pytest.approx(large.deviation, rel=1e-3)


def test_an_unstable_wave_becomes_stable():
    x = np.linspace(-4.4, 4.4, 200)
    curve = PlaneCurve.fit(np.column_stack([50 * x, 60 * np.sin(x)]), tolerance=0.5)
    before = stability(optimal_rod(curve))
    assert not before.stable
    found = recover_stability(curve, R_max=4.0, margin=2.0)
    rod = optimal_rod(found.curve)
    after = stability(rod)
    assert found.status.name == "STABLE"
    assert after.stable
    assert after.margin >= 2.0 * (1 - 1e-6)
    assert after.margin == pytest.approx(found.margin, rel=1e-4)
    assert rod.ratio <= 4.0
    assert found.curve.length == pytest.approx(curve.length, abs=1e-6)
    assert found.history[0].margin == pytest.approx(before.margin, rel=1e-3)


test_bad_input = refusal_test(
    [
        (lambda: optimize_ratio(ARCH, 0.9), "give a larger number"),
        (lambda: recover_stability(ARCH, R_max=float("nan")), "give a larger number"),
        (lambda: recover_stability(ARCH, margin=float("inf")), "limit of stability"),
        (lambda: optimize_ratio(PlaneCurve.line((0, 0), (100, 0), degree=4), 2.0), "straight"),
        (lambda: optimize_ratio(ARCH, 2.0, max_steps=0), "max_steps"),
        (lambda: optimize_ratio(PlaneCurve.ellipse((0, 0), (30, 20)), 2.0), "closed"),
    ]
)


def test_a_spiral_with_a_tail_is_not_realizable():
    spiral = np.linspace(0.5, 9, 200)[:, None] * np.column_stack(
        [np.cos(np.linspace(0, 14, 200)), np.sin(np.linspace(0, 14, 200))]
    )
    tail = (
        spiral[-1]
        + np.cumsum(np.ones((60, 1)) * np.array([[0.2, 0.1]]), axis=0) * np.linspace(1, 1.4, 60)[:, None]
    )
    with pytest.raises(NotRealizable):
        recover_stability(PlaneCurve.fit(np.concatenate([spiral, tail]), tolerance=0.2))
