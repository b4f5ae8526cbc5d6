import tracemalloc

import numpy as np
import pytest
from scipy.interpolate import make_interp_spline

from elastica_cad.geometry.plane_curve import PlaneCurve, line_crossings

pytestmark = pytest.mark.core


def graph(coefficients, degree=None, pieces=1, inner=None):
    """The graph y = p(x) over [0, 1] of a polynomial (coefficients, highest first) as a spline."""
    p = np.poly1d(coefficients)
    degree = degree or max(p.order, 2)
    inner = np.linspace(0, 1, pieces + 1)[1:-1] if inner is None else inner
    knots = np.concatenate([[0.0] * (degree + 1), inner, [1.0] * (degree + 1)])
    count = knots.size - degree - 1
    # interpolation at the Greville abscissae is exact for polynomials
    greville = np.array([knots[i + 1 : i + degree + 1].mean() for i in range(count)])
    spline = make_interp_spline(greville, np.column_stack([greville, p(greville)]), k=degree, t=knots)
    return PlaneCurve(knots, spline.c, degree)


def antiderivative2(*roots, scale=1.0):
    """A polynomial whose second derivative has the given roots."""
    return np.polyint(np.poly(roots) * scale, 2)


def kinds(curve):
    return [z.kind for z in curve.curvature_zeros]


def test_three_inflections_of_a_graph_are_its_roots():
    roots = [0.21, 0.5, 0.83]
    curve = graph(antiderivative2(*roots, scale=30.0), degree=5, pieces=4)
    zeros = curve.curvature_zeros
    assert kinds(curve) == ["crossing"] * 3
    np.testing.assert_allclose([z.t for z in zeros], roots, atol=1e-13)
    np.testing.assert_allclose(curve.inflections, curve.arc_length(np.array(roots)), atol=1e-12)
    assert [(z.before, z.after) for z in zeros] == [(-1, 1), (1, -1), (-1, 1)]


@pytest.mark.parametrize("gap", [1e-2, 1e-3, 1e-4, 1e-5])
def test_two_close_inflections_are_both_found(gap):
    roots = [0.37 - gap / 2, 0.37 + gap / 2]
    curve = graph(antiderivative2(*roots, scale=10.0), degree=4)
    assert kinds(curve) == ["crossing"] * 2
    np.testing.assert_allclose([z.t for z in curve.curvature_zeros], roots, rtol=1e-3 * gap + 1e-15 / gap)


def test_a_touch_does_not_change_the_sign():
    curve = graph(antiderivative2(0.37, 0.37, scale=10.0), degree=4, pieces=3)
    (zero,) = curve.curvature_zeros
    assert zero.kind == "touch"
    assert zero.t == pytest.approx(0.37, abs=1e-9)
    assert not zero.changes_sign
    assert (zero.before, zero.after) == (1, 1)
    assert curve.inflections.size == 0


def test_nearly_touching_is_no_zero():
    curve = graph(np.polyadd(antiderivative2(0.37, 0.37, scale=10.0), [1e-8, 0, 0]), degree=4)
    assert curve.curvature_zeros == ()


def test_a_triple_zero_is_one_crossing():
    curve = graph(antiderivative2(0.37, 0.37, 0.37, scale=20.0), degree=5)
    (zero,) = curve.curvature_zeros
    assert zero.kind == "crossing"
    assert zero.t == pytest.approx(0.37, abs=1e-4)
    assert curve.curvature_slope_at(zero.t) == pytest.approx(0, abs=1e-5)


def test_touch_beside_a_crossing():
    curve = graph(antiderivative2(0.3, 0.3, 0.300001, scale=20.0), degree=5)
    changing = [z for z in curve.curvature_zeros if z.changes_sign]
    assert len(changing) == 1
    curve = graph(antiderivative2(0.3, 0.3, 0.6, scale=20.0), degree=5)
    assert kinds(curve) == ["touch", "crossing"]


@pytest.mark.parametrize("pieces", [2, 4, 5, 8])
def test_a_zero_at_a_knot_is_found_once(pieces):
    curve = graph(antiderivative2(0.5, scale=5.0), degree=4, pieces=pieces)
    (zero,) = curve.curvature_zeros
    assert zero.kind == "crossing"
    assert zero.t == pytest.approx(0.5, abs=1e-14)
    touching = graph(antiderivative2(0.5, 0.5, scale=5.0), degree=4, pieces=pieces)
    assert kinds(touching) == ["touch"]


@pytest.mark.parametrize("place", [0.25, 0.3, 0.5, 1 / 3])
@pytest.mark.parametrize("off", [1e-9, 1e-12, 3e-14, 1e-15, 0.0])
def test_a_zero_beside_a_knot_is_found_once(place, off):
    for sign in (1, -1):
        curve = graph(antiderivative2(place + sign * off, scale=5.0), degree=4, inner=[0.1, place, 0.8])
        assert kinds(curve) == ["crossing"]


def test_zeros_at_the_ends_are_reported_apart():
    curve = graph(antiderivative2(0.0, 0.4, 1.0, scale=10.0), degree=5, pieces=2)
    assert kinds(curve) == ["end", "crossing", "end"]
    first, _, last = curve.curvature_zeros
    assert (first.t, last.t) == (0.0, 1.0)
    assert (first.before, last.after) == (0, 0)
    assert first.s == 0.0
    assert last.s == curve.length
    assert curve.inflections.size == 1


def test_a_jump_of_curvature_may_change_its_sign():
    left, right = PlaneCurve.arc((0, 10), 10, -np.pi, -np.pi / 2), PlaneCurve.arc((0, -20), 20, np.pi / 2, 0)
    knots = np.concatenate([left.knots[:-1], right.knots[3:] + left.knots[-1]])
    curve = PlaneCurve(
        knots,
        np.concatenate([left.control_points, right.control_points[1:]]),
        2,
        np.concatenate([left.weights, right.weights[1:]]),
    )
    (zero,) = curve.curvature_zeros
    assert zero.kind == "jump"
    assert (zero.before, zero.after) == (1, -1)
    assert zero.s == pytest.approx(5 * np.pi)
    np.testing.assert_allclose(curve.inflections, [5 * np.pi])


def test_flat_pieces_are_stretches():
    # a straight piece between two bends of the same sign, then of different sign
    same = PlaneCurve(
        [0, 0, 0, 1, 1, 2, 2, 3, 3, 3], [(0, 1), (0, 0), (1, 0), (2, 0), (3, 0), (4, 0), (4, 1)], 2
    )
    (zero,) = same.curvature_zeros
    assert (zero.kind, zero.before, zero.after) == ("flat", 1, 1)
    assert zero.s_end - zero.s == pytest.approx(2)
    assert same.inflections.size == 0
    other = PlaneCurve(
        [0, 0, 0, 1, 1, 2, 2, 3, 3, 3], [(0, 1), (0, 0), (1, 0), (2, 0), (3, 0), (4, 0), (4, -1)], 2
    )
    (zero,) = other.curvature_zeros
    assert (zero.before, zero.after) == (1, -1)
    assert other.inflections == pytest.approx((zero.s + zero.s_end) / 2)


def test_a_flat_end_reaches_the_end():
    curve = PlaneCurve([0, 0, 0, 1, 1, 2, 2, 2], [(0, 0), (1, 0), (2, 0), (3, 0), (3, 1)], 2)
    (zero,) = curve.curvature_zeros
    assert (zero.kind, zero.s, zero.before, zero.after) == ("flat", 0.0, 0, 1)


def test_adjoining_flat_pieces_are_one():
    curve = PlaneCurve.line((0, 0), (30, 40), degree=3)
    long = PlaneCurve(
        [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4], np.column_stack([np.arange(7.0), 2 * np.arange(7.0)]), 3
    )
    for straight in (curve, long):
        (zero,) = straight.curvature_zeros
        assert zero.kind == "flat"
        assert (zero.s, zero.s_end) == (0.0, straight.length)


def test_straight_far_from_the_origin_is_straight():
    long = PlaneCurve.line((1e5, 2e5), (1e5 + 30, 2e5 + 41), degree=4)
    assert long.is_straight


def test_zeros_far_from_the_origin():
    curve = graph(antiderivative2(0.2, 0.6, scale=30.0), degree=4, pieces=3)
    moved = PlaneCurve(curve.knots, curve.control_points * 100 + [1e5, -2e5], 4)
    assert kinds(moved) == ["crossing", "crossing"]
    np.testing.assert_allclose([z.t for z in moved.curvature_zeros], [0.2, 0.6], atol=1e-7)


def test_the_published_s_curve_has_three_inflections(reference_data):
    points = np.loadtxt(reference_data / "hafner" / "spline_infl_simple.txt", skiprows=1)
    curve = PlaneCurve(np.arange(len(points) + 5.0), points, 4)
    assert kinds(curve) == ["crossing"] * 3
    positions = curve.evaluate(np.array([z.t for z in curve.curvature_zeros]))
    a, b, c = positions
    off = np.cross([*(c - a), 0], [*(b - a), 0])[2] / np.hypot(*(c - a))
    assert abs(off) < 1e-5
    for z in curve.curvature_zeros:
        assert abs(curve.curvature_at(z.t)) < 1e-12


def test_circles_and_conics_have_no_zeros():
    assert PlaneCurve.arc((0, 0), 10, 0, 6).curvature_zeros == ()
    assert PlaneCurve.ellipse((0, 0), (100, 1), 0.3).curvature_zeros == ()


def test_rational_zeros_are_projective_images():
    curve = graph(antiderivative2(0.2, 0.55, 0.9, scale=30.0), degree=5, pieces=3)
    image = curve.transformed([[1, 0.2, 0], [0.1, 1, 0], [0.3, 0.2, 1]])
    assert image.is_rational
    np.testing.assert_allclose([z.t for z in image.curvature_zeros], [0.2, 0.55, 0.9], atol=1e-11)


def test_places_where_curvature_equals_a_level():
    curve = PlaneCurve.ellipse((0, 0), (20, 10), 0.4)
    level = 0.05
    places = curve.curvature_equals(level)
    assert len(places) == 4
    assert all(z.kind == "crossing" for z in places)
    np.testing.assert_allclose(curve.curvature_at(np.array([z.t for z in places])), level, rtol=1e-10)
    assert [z.after for z in places] == [-1, 1, -1, 1]
    assert curve.curvature_equals(-level) == ()
    # the vertices touch the extreme curvatures
    assert [z.kind for z in PlaneCurve.ellipse((0, 0), (20, 10), 0.0, -1, 1).curvature_equals(0.2)] == [
        "touch"
    ]


def test_an_arc_has_its_own_curvature_all_along():
    arc = PlaneCurve.arc((0, 0), 25, 0, 4)
    (place,) = arc.curvature_equals(1 / 25)
    assert place.kind == "flat"
    assert (place.s, place.s_end) == (0.0, arc.length)
    assert arc.curvature_equals(1 / 26) == ()
    assert arc.curvature_equals(0.0) == ()


def test_a_curve_with_inflections_meets_a_level_on_one_side_only():
    curve = graph(antiderivative2(0.5, scale=5.0), degree=3)
    high = curve.curvature_at(0.8)
    (place,) = curve.curvature_equals(float(high))
    assert place.t == pytest.approx(0.8, abs=1e-10)
    assert (place.before, place.after) == (-1, 1)
    (mirror,) = curve.curvature_equals(float(curve.curvature_at(0.1)))
    assert mirror.t == pytest.approx(0.1, abs=1e-10)
    assert (mirror.before, mirror.after) == (-1, 1)


def test_line_crossings_of_a_graph():
    roots = [0.1, 0.4, 0.4, 0.9]
    curve = graph(np.poly(roots) * 20, degree=4, pieces=3)
    found = line_crossings(curve, 0.0, (0.0, 1.0))
    assert [c.kind for c in found] == ["crossing", "touch", "crossing"]
    np.testing.assert_allclose([c.t for c in found], [0.1, 0.4, 0.9], atol=1e-8)
    np.testing.assert_allclose([c.s for c in found], curve.arc_length(np.array([0.1, 0.4, 0.9])), atol=1e-7)
    assert [c.before for c in found] == [1, -1, -1]


def test_line_through_the_ends_and_along():
    arch = PlaneCurve.arc((0, 0), 50, 0.0, np.pi)
    assert [c.kind for c in line_crossings(arch, 0.0, (0.0, 1.0))] == ["end", "end"]
    line = PlaneCurve.line((0, 0), (10, 10))
    (along,) = line_crossings(line, 0.0, (1.0, -1.0))
    assert (along.kind, along.s, along.s_end) == ("flat", 0.0, line.length)
    assert line_crossings(line, 1.0, (1.0, -1.0)) == ()


def test_line_crossings_of_a_circle_are_exact():
    circle = PlaneCurve.arc((1, 2), 5, 0.1, 0.1 + 2 * np.pi)
    found = line_crossings(circle, -4.0, (1.0, 0.0))
    points = circle.evaluate(np.array([c.t for c in found]))
    np.testing.assert_allclose(points, [(4, 6), (4, -2)], atol=1e-12)


@pytest.mark.parametrize("uneven", [3.0, 30.0, 300.0])
def test_weights_that_leave_the_shape_leave_the_places_of_a_curvature(uneven):
    points = [(0, 0), (30, 40), (70, -30), (90, 50), (130, 40), (140, -10)]
    plain = PlaneCurve.spline(points, degree=5)
    # weights in geometric progression only change the parameter
    weighted = PlaneCurve(plain.knots, plain.control_points, 5, uneven ** (np.arange(6) / 5))
    sampled = plain.sample(2001).curvature
    for level in np.quantile(sampled, [0.1234, 0.3456, 0.6543, 0.9012]).tolist():
        found, expected = weighted.curvature_equals(level), plain.curvature_equals(level)
        assert [z.kind for z in found] == [z.kind for z in expected]
        assert len(expected) == np.count_nonzero(np.diff(np.sign(sampled - level)))
        np.testing.assert_allclose([z.s for z in found], [z.s for z in expected], atol=1e-7)


def test_places_of_a_small_curvature_on_a_sharply_bent_curve_take_little_memory():
    """The rounding errors in sharp bends are large for a small curvature, so their spans were halved 12 times."""
    points = np.cumsum(np.random.default_rng(7).normal(0, 0.02, (30, 2)), axis=0)
    sharp = PlaneCurve.spline(points, degree=5)
    level = 1e-3 * np.abs(sharp.curvature_at(np.linspace(*sharp.domain, 2001))).max()
    tracemalloc.start()
    places = sharp.curvature_equals(level / 10)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert len(places) > 5
    np.testing.assert_allclose(
        sharp.curvature_at(np.array([place.t for place in places])), level / 10, rtol=1e-6
    )
    assert peak < 10e6
