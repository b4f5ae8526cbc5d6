"""The map of four handles, and the sentences it refuses handles with."""

import numpy as np
import pytest

from elastica_cad import InputError, PlaneCurve, four_point_map

pytestmark = pytest.mark.core

SQUARE = [(0, 0), (100, 0), (100, 100), (0, 100)]


def test_a_map_known_in_closed_form():
    """(x, y) -> (x, y) / (1 + x / 100) leaves the axis x = 0 and squeezes what lies right of it."""
    after = [(x / (1 + x / 100), y / (1 + x / 100)) for x, y in SQUARE]
    np.testing.assert_allclose(
        four_point_map(SQUARE, after), [[1, 0, 0], [0, 1, 0], [0.01, 0, 1]], atol=1e-12
    )


def test_handles_that_stay_change_nothing():
    np.testing.assert_allclose(four_point_map(SQUARE, SQUARE), np.eye(3), atol=1e-13)
    assert PlaneCurve.arc((0, 0), 5, 0, 2).transformed(
        four_point_map(SQUARE, SQUARE)
    ).length == pytest.approx(10)


def test_handles_far_from_the_origin():
    far = np.add(SQUARE, (1e5, -3e5))
    moved = np.add(far, [(0, 0), (0, 0), (30, 10), (0, 0)])
    image = np.column_stack([far, np.ones(4)]) @ four_point_map(far, moved).T
    np.testing.assert_allclose(image[:, :2] / image[:, 2:], moved, atol=1e-5)


@pytest.mark.parametrize(
    ("before", "after", "sentence"),
    [
        (
            SQUARE[:3],
            SQUARE[:3],
            r"before has the shape \(3, 2\): give four handles \(x, y\), shape \(4, 2\)",
        ),
        (SQUARE, [*SQUARE[:3], (0, np.nan)], "after holds NaN"),
        (SQUARE, [(5, 6)] * 4, r"after: all four handles are at \(5, 6\) mm"),
        (SQUARE, [*SQUARE[:3], (100, 0)], r"after: handles 2 and 4 are both at \(100, 0\) mm"),
        (
            SQUARE,
            [*SQUARE[:2], (1e12, 1e12), SQUARE[3]],
            r"handles 1 and 2 are only 100 mm apart, but all four extend over 1e\+12",
        ),
        ([(0, 0), (50, 50), (100, 100), (0, 100)], SQUARE, "before: handles 1, 2, 3 are on one line"),
        (SQUARE, "abcd", "after cannot be read: give numbers"),
    ],
)
def test_handles_that_make_no_map(before, after, sentence):
    with pytest.raises(InputError, match=sentence):
        four_point_map(before, after)


def test_a_curve_sent_through_infinity_is_refused_with_the_place():
    """Handles pushed into an arrow's shape send the line from (18, 0) to (0, 18) to infinity."""
    curve = PlaneCurve.spline([(2, 2), (60, 20), (90, 60), (90, 90), (80, 95)])
    arrow = [(0, 0), (100, 0), (45, 45), (0, 100)]
    with pytest.raises(InputError, match=r"the curve near \(1.*\) mm to infinity: move the handles less"):
        curve.transformed(four_point_map(SQUARE, arrow))
