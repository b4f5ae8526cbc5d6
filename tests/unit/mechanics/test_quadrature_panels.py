"""Panels integrate and interpolate to rounding error, also beside zeros of the curvature."""

import tracemalloc

import numpy as np
import pytest

from elastica_cad import PlaneCurve
from elastica_cad.geometry.polynomials import LEFT, NODES, RIGHT, WEIGHTS, PanelFunction
from elastica_cad.mechanics.quadrature_panels import cut_into_panels

pytestmark = pytest.mark.core

WAVE = PlaneCurve.spline([(0, 0), (30, 40), (60, 5), (90, -40), (130, 0), (160, 30)], degree=4)
ARC = PlaneCurve.arc((0, 0), 100.0, 0.0, 2.0)


def test_integration_matrices_are_exact_for_polynomials():
    for n in range(NODES.size):
        whole = (1 - (-1) ** (n + 1)) / (n + 1)
        assert WEIGHTS @ NODES**n == pytest.approx(whole, abs=1e-14)
        np.testing.assert_allclose(
            LEFT @ NODES**n, (NODES ** (n + 1) - (-1) ** (n + 1)) / (n + 1), atol=1e-13
        )
        np.testing.assert_allclose(RIGHT @ NODES**n, (1 - NODES ** (n + 1)) / (n + 1), atol=1e-13)


@pytest.mark.parametrize("curve", [WAVE, ARC, PlaneCurve.ellipse((3, 4), (200, 50), 0.3, 0.1, 4.0)])
def test_arc_length_and_positions(curve):
    panels = cut_into_panels(curve, [z.t for z in curve.curvature_zeros])
    assert panels.edge_s[-1] == pytest.approx(curve.length, rel=1e-12)
    np.testing.assert_allclose(panels.s, curve.arc_length(panels.t), rtol=1e-10, atol=1e-9)
    start = panels.edge_position[:-1, None] + panels.from_left
    end = panels.edge_position[1:, None] + panels.from_right
    np.testing.assert_allclose(start, curve.evaluate(panels.t), atol=1e-10)
    np.testing.assert_allclose(end, curve.evaluate(panels.t), atol=1e-10)


def test_zeros_are_panel_ends_and_no_panel_has_two():
    zeros = [z.t for z in WAVE.curvature_zeros]
    panels = cut_into_panels(WAVE, zeros)
    for zero in zeros:
        assert np.abs(panels.edges - zero).min() < 1e-12
    assert not np.any(panels.zero_left & panels.zero_right)
    # one zero is the end of the curve
    assert [z.kind for z in WAVE.curvature_zeros] == ["crossing", "end"]
    assert (panels.zero_left.sum(), panels.zero_right.sum()) == (1, 2)
    assert np.all(panels.curvature != 0)


def test_quotient_is_interpolated_through_the_inflection():
    """(t - t0) / kappa has the limit 1 / kappa'(t0) there."""
    zeros = [z.t for z in WAVE.curvature_zeros]
    zero = zeros[len(zeros) // 2]
    panels = cut_into_panels(WAVE, zeros)
    quotient = PanelFunction.through((panels.t - zero) / panels.curvature)
    at = np.array([zero])
    speed = np.hypot(*WAVE.evaluate(at, 1)[0])
    limit = 1 / (WAVE.curvature_slope_at(at)[0] * speed)
    np.testing.assert_allclose(quotient.at(*panels.locate(at)), limit, rtol=1e-9)
    near = zero + np.array([-1e-9, 1e-9, 1e-6])
    np.testing.assert_allclose(quotient.at(*panels.locate(near)), limit, rtol=1e-4)


def test_knots_and_cuts_are_panel_ends():
    panels = cut_into_panels(WAVE, [], cuts=[0.123])
    for t in (0.123, *(b.t for b in WAVE.breaks)):
        assert np.abs(panels.edges - t).min() < 1e-12


def test_easy_curves_need_few_panels():
    assert cut_into_panels(ARC, []).count <= 4


def test_curves_far_from_the_origin_do_not_end_in_ever_smaller_panels():
    far = PlaneCurve(WAVE.knots, WAVE.control_points + 1e6, WAVE.degree)
    zeros = [z.t for z in far.curvature_zeros]
    assert cut_into_panels(far, zeros).count < 200


def test_a_piece_far_shorter_than_its_coordinates_is_one_smooth_panel():
    piece = PlaneCurve.spline([(40, 20), (70, 35), (90, 80), (150, 60)], degree=3).trimmed(0.3, 0.3 + 1e-7)
    assert cut_into_panels(piece, []).count < 8


def test_a_zero_beside_a_knot_requests_a_few_panels_on_its_other_side():
    curve = PlaneCurve.spline([(0, 0), (50, 80), (90.1, 60), (120, -60), (160, -80), (210, 0)])
    zero, knot = curve.curvature_zeros[0].t, 0.5
    assert 0 < zero - knot < 1e-3
    panels = cut_into_panels(curve, [zero])
    assert panels.count < 50
    # what is left of the pole there is resolved all the same: the moment about any line through the zero
    point, normal = curve.evaluate(zero), np.array([0.3, 1.0])
    moment = (panels.edge_position[:-1, None] + panels.from_left - point) @ normal
    quotient = PanelFunction.through(moment / panels.curvature)
    t = knot - np.geomspace(1e-6, 0.3, 200)
    exact = (curve.evaluate(t) - point) @ normal / curve.curvature_at(t)
    np.testing.assert_allclose(quotient.at(*panels.locate(t)), exact, rtol=1e-8)


def test_the_memory_of_panels_does_not_grow_with_the_square_of_the_inflections():
    zigzag = PlaneCurve.spline([(3 * k, 60 * (k % 2)) for k in range(1500)], degree=4)
    zeros = [zero.t for zero in zigzag.curvature_zeros]
    tracemalloc.start()
    panels = cut_into_panels(zigzag, zeros)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert panels.count > len(zeros) > 1400
    assert peak < 2e4 * panels.count
