import numpy as np
import pytest

from elastica_cad.geometry.path_intersections import polylines_cross, self_crossing

pytestmark = pytest.mark.core


def test_a_long_spiral_meets_itself_only_where_its_end_is_bent_back():
    t = np.linspace(0, 20 * np.pi, 20_000)  # all pairs of chords would need more memory than there is
    spiral = np.column_stack([t * np.cos(t), t * np.sin(t)])
    assert self_crossing(spiral, closed=False) is None
    bent = np.vstack([spiral, [0.0, 0.0]])
    assert self_crossing(bent, closed=False) is not None


@pytest.mark.parametrize("count", [2, 3, 9, 65, 600])
def test_polylines_of_any_number_of_points_cross_where_a_line_cuts_them(count):
    x = np.linspace(-1, 1, count)
    crossing = polylines_cross(np.column_stack([x, 0 * x]), np.array([[0.3, -1.0], [0.3, 1.0]]))
    np.testing.assert_allclose(crossing, [0.3, 0.0], atol=1e-12)
    assert polylines_cross(np.column_stack([x, 0 * x]), np.array([[0.3, 0.5], [0.3, 1.0]])) is None


def test_a_single_point_crosses_nothing():
    assert polylines_cross(np.zeros((1, 2)), np.array([[-1.0, 0.0], [1.0, 0.0]])) is None
