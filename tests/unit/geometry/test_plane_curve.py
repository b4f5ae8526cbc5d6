import pickle
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.interpolate import BSpline
from scipy.special import ellipeinc

from elastica_cad import InputError, PlaneCurve
from tests.refusals import refusal_test

pytestmark = pytest.mark.core

POINTS = np.array([(0, 0), (20, 35), (45, 30), (60, -10), (95, -25), (120, 10), (130, 40), (160, 45)], float)


def knot_vectors(count: int, degree: int) -> dict[str, np.ndarray]:
    rng = np.random.default_rng(5)
    inner = np.sort(rng.uniform(0.1, 0.9, count - degree - 1))
    inner[1:3] = inner[1:2]
    return {
        "clamped": np.concatenate([np.zeros(degree + 1), inner, np.ones(degree + 1)]),
        "unclamped": np.arange(count + degree + 1.0),
        "uneven": np.cumsum(rng.uniform(0.2, 3.0, count + degree + 1)),
        "half clamped": np.concatenate([np.arange(degree), [degree] * 2, degree + 1 + np.arange(count - 1)]),
    }


@pytest.mark.parametrize("degree", [2, 3, 4, 5, 6])
@pytest.mark.parametrize("kind", ["clamped", "unclamped", "uneven", "half clamped"])
def test_position_and_derivatives_are_those_of_the_b_spline(degree, kind):
    knots = knot_vectors(len(POINTS), degree)[kind]
    curve = PlaneCurve(knots, POINTS, degree)
    spline = BSpline(knots, POINTS, degree)
    t = np.linspace(*curve.domain, 41)[:-1]
    for order in range(4):
        expected = spline(t, nu=order)
        np.testing.assert_allclose(
            curve.evaluate(t, order), expected, rtol=1e-9, atol=1e-9 * abs(expected).max()
        )


def test_rational_derivatives_agree_with_finite_differences():
    weights = np.array([1, 2, 0.5, 1, 3, 1, 0.7, 1])
    curve = PlaneCurve(knot_vectors(8, 4)["uneven"], POINTS, 4, weights)
    a, b = curve.domain
    edges = np.array([k.t for k in curve.breaks])
    t = np.linspace(a, b, 52)[1:-1]
    t = t[np.abs(t[:, None] - edges).min(axis=1) > 1e-3]
    h = 1e-5
    for order in range(3):
        change = (curve.evaluate(t + h, order) - curve.evaluate(t - h, order)) / (2 * h)
        scale = np.abs(change).max()
        np.testing.assert_allclose(curve.evaluate(t, order + 1), change, atol=2e-8 * scale)


def test_basis_reproduces_the_curve():
    curve = PlaneCurve(knot_vectors(8, 3)["uneven"], POINTS, 3, np.linspace(1, 2, 8))
    t = np.linspace(*curve.domain, 23)
    for order in range(4):
        np.testing.assert_allclose(curve.basis(t, order) @ POINTS, curve.evaluate(t, order), atol=1e-9)
    np.testing.assert_allclose(curve.basis(t).sum(axis=1), 1)


@pytest.mark.parametrize("angles", [(0.3, 7.0), (2.0, -1.0), (0.0, 2 * np.pi), (-0.1, 0.1)])
def test_arc_is_exact(angles):
    curve = PlaneCurve.arc((3, -2), 25.0, *angles)
    turn = angles[1] - angles[0]
    samples = curve.sample(33)
    phase = angles[0] + np.sign(turn) * samples.s / 25
    circle = np.array([3, -2]) + 25 * np.column_stack([np.cos(phase), np.sin(phase)])
    assert curve.length == pytest.approx(25 * abs(turn), rel=1e-14)
    np.testing.assert_allclose(samples.position, circle, atol=1e-12)
    np.testing.assert_allclose(samples.curvature, np.sign(turn) / 25, rtol=1e-12)
    np.testing.assert_allclose(np.diff(samples.angle), turn / 32, rtol=1e-10)
    np.testing.assert_allclose(curve.curvature_slope_at(np.linspace(*curve.domain, 9)), 0, atol=1e-15)
    assert all(knot.continuity >= 3 for knot in curve.breaks)


def test_ellipse_has_the_closed_form_length_and_curvature():
    a, b, turn = 75.0, 112.5, 0.7
    curve = PlaneCurve.ellipse((5, 6), (a, b), turn, 0.2, 2.9)
    # the arc length of (a cos v, b sin v) is b E(v | 1 - a^2/b^2)
    expected = b * (ellipeinc(2.9, 1 - (a / b) ** 2) - ellipeinc(0.2, 1 - (a / b) ** 2))
    assert curve.length == pytest.approx(expected, rel=1e-13)
    t = np.linspace(*curve.domain, 51)
    local = (curve.evaluate(t) - [5, 6]) @ np.array(
        [[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]]
    )
    np.testing.assert_allclose((local[:, 0] / a) ** 2 + (local[:, 1] / b) ** 2, 1, rtol=1e-13)
    x, y = local.T
    curvature = 1 / (a * b) ** 2 / ((x / a**2) ** 2 + (y / b**2) ** 2) ** 1.5
    np.testing.assert_allclose(curve.curvature_at(t), curvature, rtol=1e-12)


@pytest.mark.parametrize("degree", [2, 3, 4, 5])
@pytest.mark.parametrize("kind", ["clamped", "unclamped", "uneven"])
def test_length_agrees_with_adaptive_quadrature(degree, kind):
    curve = PlaneCurve(knot_vectors(8, degree)[kind], POINTS, degree)
    knots = [curve.domain[0], *(k.t for k in curve.breaks), curve.domain[1]]
    total = 0.0
    for a, b in pairwise(knots):
        total += quad(lambda t: np.hypot(*curve.evaluate(t, 1)), a, b, epsabs=0, epsrel=1e-12, limit=400)[0]
    assert curve.length == pytest.approx(total, rel=1e-11)


@pytest.mark.parametrize("kind", ["clamped", "unclamped", "uneven", "half clamped"])
def test_arc_length_and_parameter_are_inverse(kind):
    curve = PlaneCurve(knot_vectors(8, 4)[kind], POINTS, 4)
    s = np.linspace(0, curve.length, 1001)
    np.testing.assert_allclose(curve.arc_length(curve.parameter(s)), s, atol=1e-12 * curve.length)
    assert curve.parameter(0.0) == curve.domain[0]
    assert curve.parameter(curve.length) == curve.domain[1]
    for knot in curve.breaks:
        assert curve.parameter(knot.s) == pytest.approx(knot.t, rel=1e-13)
    assert curve.parameter(np.zeros((2, 3))).shape == (2, 3)


def test_arc_length_of_a_near_cusp():
    # (v^2, v^3 + eps v): speed falls to eps at v = 0
    eps = 1e-4
    control = np.array([(1, -1 - eps), (-1 / 3, 1 - eps / 3), (-1 / 3, -1 + eps / 3), (1, 1 + eps)])
    curve = PlaneCurve(np.repeat([-1.0, 1.0], 4), control, 3)
    exact, _ = quad(
        lambda v: np.hypot(2 * v, 3 * v**2 + eps),
        0,
        1,
        points=[1e-4, 1e-3],
        epsabs=0,
        epsrel=1e-13,
        limit=500,
    )
    assert curve.arc_length(1.0) - curve.arc_length(0.0) == pytest.approx(exact, rel=1e-10)


def test_turning_angle_of_a_spiral_is_continuous():
    spiral = PlaneCurve.fit_function(
        lambda v: np.column_stack([v * np.cos(v), v * np.sin(v)]), 3.0, 20.0, tolerance=1e-9
    )
    v = np.linspace(3, 20, 40)
    np.testing.assert_allclose(spiral.angle_at(v) + 2 * np.pi, v + np.arctan(v), atol=1e-7)
    few = spiral.angle_at(np.array([3.0, 20.0]))
    assert few[1] - few[0] == pytest.approx(17 + np.arctan(20) - np.arctan(3), abs=1e-7)


def test_length_of_a_spiral():
    spiral = PlaneCurve.fit_function(
        lambda v: np.column_stack([v * np.cos(v), v * np.sin(v)]), 3.0, 9.0, tolerance=1e-10
    )

    def primitive(v):
        return (v * np.hypot(1, v) + np.arcsinh(v)) / 2

    assert spiral.length == pytest.approx(primitive(9) - primitive(3), rel=1e-10)


def test_samples_are_uniform_in_arc_length():
    curve = PlaneCurve.spline(POINTS)
    samples = curve.sample(101)
    np.testing.assert_allclose(samples.s, np.linspace(0, curve.length, 101))
    np.testing.assert_allclose(samples.position, curve.evaluate(samples.t))
    np.testing.assert_allclose(samples.curvature, curve.curvature_at(samples.t))
    # angle is the integral of curvature
    fine = curve.sample(4001)
    turned = ((fine.curvature[1:] + fine.curvature[:-1]) / 2 * np.diff(fine.s)).sum()
    assert fine.angle[-1] - fine.angle[0] == pytest.approx(turned, abs=1e-6)


def test_one_sided_values_at_a_jump_of_curvature():
    # two arcs, radius 10 then 20, joined with the same tangent
    first, second = PlaneCurve.arc((0, 0), 10, -np.pi / 2, 0), PlaneCurve.arc((-10, 0), 20, 0, np.pi / 2)
    knots = np.concatenate([first.knots[:-1], second.knots[3:] + first.knots[-1]])
    points = np.concatenate([first.control_points, second.control_points[1:]])
    weights = np.concatenate([first.weights, second.weights[1:]])
    curve = PlaneCurve(knots, points, 2, weights)
    (joint,) = curve.breaks
    assert joint.continuity == 1
    assert joint.s == pytest.approx(5 * np.pi)
    assert curve.curvature_at(joint.t) == pytest.approx(1 / 20)
    assert curve.curvature_at(joint.t, left=True) == pytest.approx(1 / 10)
    assert curve.tangent_breaks == ()
    assert curve.inflections.size == 0


def test_continuity_counts_derivatives_by_arc_length():
    curve = PlaneCurve([0, 0, 0, 0, 1, 2, 2, 3, 3, 3, 4, 4, 4, 4], [*POINTS, (170, 80), (200, 85)], 3)
    assert [k.continuity for k in curve.breaks] == [2, 1, 0]
    (corner,) = curve.tangent_breaks
    assert corner.t == 3
    before, after = POINTS[6] - POINTS[5], POINTS[7] - POINTS[6]  # the triple knot is control point 6
    angle = np.arctan2(after[1], after[0]) - np.arctan2(before[1], before[0])
    assert corner.angle == pytest.approx(angle)
    once = PlaneCurve([0, 0, 0, 0.5, 1, 1, 1], [(0, 0), (1, 2), (3, 3), (4, 0)], 2)
    assert [k.continuity for k in once.breaks] == [1]


def test_a_knot_without_effect_is_smooth():
    # the parabola x = t, y = t^2 on [0, 2] with a knot at 1: blossoms of x and y
    curve = PlaneCurve([0, 0, 0, 1, 2, 2, 2], [(0, 0), (0.5, 0), (1.5, 2), (2, 4)], 2)
    assert [k.continuity for k in curve.breaks] == [4]


def test_reversed_runs_the_other_way():
    curve = PlaneCurve(knot_vectors(8, 4)["uneven"], POINTS, 4, np.linspace(1, 3, 8))
    back = curve.reversed()
    there, again = curve.sample(21), back.sample(21)
    np.testing.assert_allclose(again.position, there.position[::-1], atol=1e-10)
    np.testing.assert_allclose(again.curvature, -there.curvature[::-1], atol=1e-10)


def test_bounds_are_exact():
    np.testing.assert_allclose(
        PlaneCurve.ellipse((1, 2), (30, 20), np.pi / 6).bounds,
        [
            [1 - np.hypot(30 * np.cos(np.pi / 6), 10), 2 - np.hypot(15, 20 * np.cos(np.pi / 6))],
            [1 + np.hypot(30 * np.cos(np.pi / 6), 10), 2 + np.hypot(15, 20 * np.cos(np.pi / 6))],
        ],
    )
    curve = PlaneCurve.spline(POINTS)
    dense = curve.evaluate(np.linspace(*curve.domain, 20001))
    np.testing.assert_allclose(curve.bounds, [dense.min(axis=0), dense.max(axis=0)], atol=1e-5)
    assert np.all(curve.bounds[0] <= dense.min(axis=0) + 1e-12)


def test_projective_image_is_exact():
    matrix = np.array([[1.1, 0.2, 5], [-0.1, 0.9, 3], [0.002, 0.001, 1]])
    for curve in (PlaneCurve.spline(POINTS), PlaneCurve.ellipse((50, 20), (40, 30), 0.3, 0.1, 4)):
        image = curve.transformed(matrix)
        t = np.linspace(*curve.domain, 31)
        mapped = np.column_stack([curve.evaluate(t), np.ones(31)]) @ matrix.T
        np.testing.assert_allclose(image.evaluate(t), mapped[:, :2] / mapped[:, 2:], atol=1e-11)


def test_projective_image_where_a_control_point_goes_beyond_infinity():
    curve = PlaneCurve.spline([(0, 0), (20, 100), (40, 0), (60, 0), (80, 20)], degree=3)
    top = curve.bounds[1, 1]
    matrix = np.array([[1, 0, 0], [0, 1, 0], [0, -1 / (top * 1.05), 1]])
    assert (np.column_stack([curve.control_points, np.ones(5)]) @ matrix[2]).min() < 0
    image = curve.transformed(matrix)
    t = np.linspace(*curve.domain, 31)
    mapped = np.column_stack([curve.evaluate(t), np.ones(31)]) @ matrix.T
    expected = mapped[:, :2] / mapped[:, 2:]
    np.testing.assert_allclose(image.evaluate(t), expected, atol=1e-9 * np.abs(expected).max())
    with pytest.raises(InputError, match="infinity"):
        curve.transformed([[1, 0, 0], [0, 1, 0], [0, -1 / (top * 0.95), 1]])


def test_straight_and_closed_are_reported():
    line = PlaneCurve.line((1, 2), (31, 42))
    assert line.is_straight
    bent_then = PlaneCurve([0, 0, 0, 2, 2, 6, 6, 6], [(0, 0), (1, 0), (2, 0), (4, 0), (5, 2)], 2)
    assert not bent_then.is_straight, "it begins straight"
    assert line.length == pytest.approx(50)
    assert [z.kind for z in line.curvature_zeros] == ["flat"]
    assert not line.is_closed
    assert not PlaneCurve.spline(POINTS).is_straight
    assert PlaneCurve.arc((0, 0), 10, 0, 2 * np.pi).is_closed
    bent = PlaneCurve([0, 0, 0, 1, 1, 2, 2, 2], [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2)], 2)
    assert not bent.is_straight
    assert bent.tangent_breaks[0].angle == pytest.approx(np.pi / 2)


def test_bezier_pieces_are_the_curve():
    curve = PlaneCurve(knot_vectors(8, 4)["uneven"], POINTS, 4, np.linspace(1, 3, 8))
    edges, pieces = curve.bezier_table
    for t0, t1, rows in zip(edges[:-1], edges[1:], pieces, strict=True):
        np.testing.assert_allclose(rows[0, :2] / rows[0, 2], curve.evaluate(t0), atol=1e-12)
        np.testing.assert_allclose(rows[-1, :2] / rows[-1, 2], curve.evaluate(t1), atol=1e-12)
        middle = np.array([1, 4, 6, 4, 1]) / 16 @ rows
        np.testing.assert_allclose(middle[:2] / middle[2], curve.evaluate((t0 + t1) / 2), atol=1e-12)
    assert t1 == curve.domain[1]


OPEN = PlaneCurve.spline(POINTS)

test_parameters_and_arc_lengths_outside_are_refused = refusal_test(
    [
        (lambda: OPEN.evaluate(1.1), "1.1 is outside the curve"),
        (lambda: OPEN.parameter([0.0, 1.01 * OPEN.length]), "outside the curve"),
        (lambda: OPEN.at(np.nan), "nan mm is outside the curve"),
        (lambda: OPEN.evaluate(0.5, 4), "is 4: use 0 to 3"),
        (lambda: OPEN.sample(1), "use 2 or more"),
    ]
)


@pytest.mark.parametrize("size", [1e-7, 1e-3, 1e5, 1e9])
def test_any_size_of_drawing(size):
    curve, scaled = PlaneCurve.spline(POINTS), PlaneCurve.spline(POINTS * size)
    assert scaled.length == pytest.approx(curve.length * size, rel=1e-12)
    np.testing.assert_allclose(scaled.inflections, curve.inflections * size, rtol=1e-9)
    np.testing.assert_allclose(scaled.sample(9).curvature * size, curve.sample(9).curvature, rtol=1e-9)
    assert scaled.tangent_breaks == ()
    assert [k.continuity for k in scaled.breaks] == [k.continuity for k in curve.breaks]
    fitted = PlaneCurve.fit(scaled.sample(200).position, tolerance=1e-3 * size)
    assert fitted.length == pytest.approx(scaled.length, rel=1e-5)


@pytest.mark.parametrize("part", [1e-4, 1e-6, 1e-7])
def test_a_short_piece_keeps_its_shape_and_few_panels(part):
    """Derivatives of a short piece carry no rounding of its coordinates, which are large beside it."""
    points = np.array([(40.0, 20.0), (70.0, 35.0), (90.0, 80.0), (150.0, 60.0)])
    whole = PlaneCurve.spline(points, degree=3)
    piece = whole.trimmed(0.3, 0.3 + part)
    t = np.linspace(*piece.domain, 7)
    np.testing.assert_allclose(piece.evaluate(t), whole.evaluate(t), atol=1e-13)
    # what is left is the rounding of its control points
    rounding = 1e-15 * 100 / piece.length
    np.testing.assert_allclose(piece.angle_at(t), whole.angle_at(t), atol=20 * rounding)
    assert np.ptp(piece.curvature_at(t)) < 1e-3 + 20 * rounding / piece.length
    assert piece.length == pytest.approx(whole.arc_length(0.3 + part) - whole.arc_length(0.3), abs=1e-12)
    assert piece.smooth_panels.size <= 5
    moved = PlaneCurve(piece.knots, piece.control_points + 2.0**20, 3)
    assert moved.smooth_panels.size <= 5


@pytest.mark.parametrize("shift", [1e3, 1e5, 1e7])
def test_parameters_large_beside_their_domain(shift):
    curve = PlaneCurve.spline(POINTS, degree=4)
    shifted = PlaneCurve(np.asarray(curve.knots) + shift, POINTS, 4)
    assert shifted.length == pytest.approx(curve.length, rel=1e-10)
    assert shifted.smooth_panels.size < 4 * curve.smooth_panels.size


def test_a_curve_travels_as_its_numbers():
    """What was computed from it stays behind: an answer sent by a worker would be three times as large."""
    curve = PlaneCurve.spline(POINTS, degree=3)
    fresh = pickle.dumps(curve)
    sampled = curve.sample(7)
    assert curve.survey.s.size > 7
    assert pickle.dumps(curve) == fresh
    again = pickle.loads(fresh)
    assert pickle.dumps(again) == fresh
    np.testing.assert_array_equal(again.sample(7).position, sampled.position)


def test_a_rounded_arc_length_at_an_end_is_the_end():
    ends = OPEN.at([-4e-4 * OPEN.length, 1.0004 * OPEN.length])
    assert ends.t == pytest.approx(OPEN.domain, abs=1e-12)
    with pytest.raises(InputError, match="outside the curve"):
        OPEN.parameter(1.001 * OPEN.length)
