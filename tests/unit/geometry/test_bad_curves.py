import numpy as np
import pytest

from elastica_cad import InputError, PlaneCurve
from elastica_cad.geometry import line_crossings
from tests.refusals import refusal_test

pytestmark = pytest.mark.core

GOOD = [(0, 0), (1, 2), (3, 2), (4, 0)]
KNOTS = [0, 0, 0, 0, 1, 1, 1, 1]


@pytest.mark.parametrize(
    ("knots", "points", "degree", "weights", "words"),
    [
        (KNOTS, [(0, 0), (1, np.nan), (3, 2), (4, 0)], 3, None, "control_points holds NaN or infinite"),
        (KNOTS, [(0, 0), (1, np.inf), (3, 2), (4, 0)], 3, None, "NaN or infinite values, the first at index"),
        (KNOTS, [(0, 0, 0)] * 4, 3, None, r"shape \(m, 2\)"),
        (KNOTS, "abc", 3, None, "give numbers"),
        ([0, 0, 0, 1, 1, 1], GOOD[:2], 3, None, "2 control points are too few for degree 3"),
        (KNOTS[:-1], GOOD, 3, None, "give 8 knots"),
        ([0, 0, 0, 0, 1, 1, np.nan, 1], GOOD, 3, None, "knots holds NaN"),
        ([0, 0, 0, 0, 1, 1, 0.5, 1], GOOD, 3, None, "knot 6 is less than knot"),
        ([0] * 8, GOOD, 3, None, "has no length"),
        ([0, 0, 0, 0, 1e92, 1e92, 1e92, 1e92], GOOD, 3, None, r"from 0 to 1e\+92, .* scale them to 0..1"),
        ([1e15] * 4 + [1e15 + 2] * 4, GOOD, 3, None, "scale them to 0..1"),
        ([0] * 4 + [1e-20] * 4, GOOD, 3, None, "scale them to 0..1"),
        (KNOTS, GOOD, 1, None, "use a whole number, 2 or more"),
        (KNOTS, GOOD, 2.5, None, "use a whole number, 2 or more"),
        (KNOTS, GOOD, np.nan, None, "use a whole number, 2 or more"),
        (KNOTS, GOOD, None, None, "use 2 or more"),
        (KNOTS, [(0, 0), (1, 2), (3,)], 3, None, "give numbers"),
        (KNOTS, GOOD, 3, [1, 1, 1], "give a weight for each point"),
        (KNOTS, GOOD, 3, [1, 1, 0, 1], r"weight of control point 2 \(from 0\) is 0: give positive weights"),
        (
            KNOTS,
            GOOD,
            3,
            [1, 1e200, 1, 1],
            r"are 1 to 1e\+200, a ratio above the limit of 1e\+08",
        ),
        (KNOTS, GOOD, 3, [1, 1, np.inf, 1], "weights holds NaN or infinite"),
        (KNOTS, [(2, 2)] * 4, 3, None, "all control points coincide, so the curve has no length"),
        (KNOTS, [(0, 0), (0, 0), (3, 2), (4, 0)], 3, None, "control points 0 and 1 coincide"),
        ([0, 0, 0, 1, 1, 1, 2, 2, 2], [*GOOD, (5, 5), (6, 6)], 2, None, "breaks the curve apart"),
        ([0, 0, 0, 0, 0, 1, 1, 1, 1], [*GOOD, (5, 5)], 3, None, "repeat it at most 4 times"),
    ],
)
def test_bad_numbers_get_one_sentence(knots, points, degree, weights, words):
    with pytest.raises(InputError, match=words):
        PlaneCurve(knots, points, degree, weights)


def test_a_cusp_is_refused_with_its_place():
    # (v^2, v^3) on [-1, 1]: each half is (13^1.5 - 8) / 27 long
    points = [(1, -1), (-1 / 3, 1), (-1 / 3, -1), (1, 1)]
    with pytest.raises(
        InputError,
        match=r"the curve has a cusp, and the curve has no tangent at \(.*\) mm, 1.44 mm from its start",
    ):
        PlaneCurve(KNOTS, points, 3)


test_refusals = refusal_test(
    [
        (lambda: PlaneCurve([0, 0, 0, 1, 1, 1], [(0, 0), (10, 0), (5, 0)], 2), "no tangent"),
        (
            lambda: PlaneCurve.spline(
                [(0, 0), (10, 10), (20, 0), (20, 0), (20, 0), (20, 0), (30, 10), (40, 0)], degree=3
            ),
            "control points 2 and 3 coincide",
        ),
    ]
)


def test_a_near_cusp_is_a_curve():
    points = [(1, -1), (-1 / 3, 1 - 1e-3), (-1 / 3, -1 + 1e-3), (1, 1)]
    assert PlaneCurve(KNOTS, points, 3).length > 2.8


def test_coincident_control_points_without_standstill_are_allowed():
    curve = PlaneCurve.spline([(0, 0), (10, 10), (20, 0), (20, 0), (30, 10), (40, 0)], degree=3)
    assert curve.length > 40


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: PlaneCurve.spline(GOOD, degree=4), "4 control points are too few for degree 4"),
        (lambda: PlaneCurve.spline([], degree=4), "0 control points are too few"),
        (lambda: PlaneCurve.spline("no"), "give numbers"),
        (lambda: PlaneCurve.spline(GOOD, degree="2"), "use 2 or more"),
        (lambda: PlaneCurve.line((1, 1), (1, 1)), "no length"),
        (lambda: PlaneCurve.arc((0, 0), -3, 0, 1), "give positive numbers"),
        (lambda: PlaneCurve.arc((0, 0), 3, 1, 1), "no length"),
        (lambda: PlaneCurve.ellipse((0, 0), (1, np.nan)), "NaN"),
        (lambda: PlaneCurve.spline(GOOD, 3).transformed(np.ones((3, 3))), "singular"),
        (lambda: PlaneCurve.spline(GOOD, 3).transformed(np.eye(2)), "3 x 3"),
        (lambda: line_crossings(PlaneCurve.spline(GOOD, 3), 1.0, (0, 0)), "normal of a line"),
        (lambda: line_crossings(PlaneCurve.spline(GOOD, 3), np.nan, (0, 1)), "NaN"),
        (lambda: PlaneCurve.fit([(0, 0), (0, 0)]), "fewer than two different points"),
        (lambda: PlaneCurve.fit([]), r"shape \(n, 2\)"),
        (lambda: PlaneCurve.fit(GOOD, degree=2), "use 3, 4 or 5"),
        (lambda: PlaneCurve.fit(GOOD, tolerance=0), "tolerance of a fit is 0: give a number above 0"),
        (lambda: PlaneCurve.fit(GOOD, smoothing=-1), "smoothing of a fit is -1: use 0 or more"),
        (lambda: PlaneCurve.fit([(0, 0), (np.nan, 1), (2, 2)]), "points holds NaN"),
    ],
)
def test_constructors_and_methods_explain_themselves(make, words):
    with pytest.raises(InputError, match=words):
        make()


def test_arrays_of_a_curve_cannot_be_changed():
    points = np.array(GOOD, dtype=float)
    curve = PlaneCurve.spline(points, degree=3)
    points[0] = 99
    assert curve.control_points[0, 0] == 0
    with pytest.raises(ValueError, match="read-only"):
        curve.control_points[0] = 1
