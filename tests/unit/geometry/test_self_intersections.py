import numpy as np
import pytest

from elastica_cad import PlaneCurve

pytestmark = pytest.mark.core


def test_a_loop_crosses_once():
    curve = PlaneCurve.spline([(0, 0), (100, 100), (-50, 100), (50, 0)], degree=3)
    ((first, second),) = curve.self_intersections()
    p, q = curve.at([first, second]).position
    np.testing.assert_allclose(p, q, atol=1e-9)
    assert 0 < first < second < curve.length


@pytest.mark.parametrize("slower", [30.0, 1e3, 1e5])
def test_a_loop_whose_halves_are_drawn_at_unlike_speeds_crosses_once(slower):
    whole = PlaneCurve.spline([(0, 0), (100, 100), (-50, 100), (50, 0)], degree=3)
    first_half = [(0, 0), (50, 50), (37.5, 75), (25, 75)]  # halves of de Casteljau: the same loop
    second_half = [(12.5, 75), (0, 50), (50, 0)]
    knots = [0, 0, 0, 0, 1, 1, 1, *[1 + slower] * 4]
    halves = PlaneCurve(knots, first_half + second_half, 3)
    np.testing.assert_allclose(halves.self_intersections(), whole.self_intersections(), atol=1e-7)


def test_a_lissajous_figure_crosses_where_it_must():
    curve = PlaneCurve.fit_function(
        lambda v: np.column_stack([np.sin(3 * v), np.sin(4 * v)]), 0.1, 0.1 + 2 * np.pi, tolerance=1e-8
    )
    pairs = curve.self_intersections()
    # 2 p q - p - q double points for coprime frequencies p, q
    assert len(pairs) == 2 * 3 * 4 - 3 - 4
    p, q = curve.at(pairs[:, 0]).position, curve.at(pairs[:, 1]).position
    np.testing.assert_allclose(p, q, atol=1e-9)


@pytest.mark.parametrize(
    "curve",
    [
        PlaneCurve.arc((0, 0), 10, 0, 2 * np.pi),
        PlaneCurve.arc((0, 0), 10, 0, 6.2),
        PlaneCurve.line((0, 0), (10, 3)),
        PlaneCurve.spline([(0, 0), (10, 20), (20, -20), (30, 20), (40, 0)]),
        PlaneCurve.fit_function(lambda v: np.column_stack([v * np.cos(v), v * np.sin(v)]), 3, 30),
    ],
)
def test_simple_curves_do_not_meet_themselves(curve):
    assert curve.self_intersections().shape == (0, 2)


def test_an_end_that_lies_on_the_curve_is_a_meeting():
    # one and a quarter turns of a shrinking loop, bent so that its end touches the first straight piece
    straight = [(0, 0), (10, 0), (20, 0)]
    curve = PlaneCurve([0, 0, 0, 1, 1, 2, 2, 3, 3, 3], [*straight, (30, 0), (20, 20), (10, 40), (10, 0)], 2)
    ((first, second),) = curve.self_intersections()
    assert first == pytest.approx(10, abs=1e-9)
    assert second == pytest.approx(curve.length, abs=1e-9)


def test_a_circle_run_twice_meets_itself_all_along():
    pairs = PlaneCurve.arc((0, 0), 10, 0, 9).self_intersections()
    assert len(pairs) > 3
    np.testing.assert_allclose(pairs[:, 1] - pairs[:, 0], 20 * np.pi, atol=1e-6)
