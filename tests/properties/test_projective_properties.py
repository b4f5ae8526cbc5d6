"""Four handles that are moved: where they land, and what every such edit keeps (paper, section 4.3)."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from elastica_cad import InputError, PlaneCurve, check_equilibrium, four_point_map

pytestmark = pytest.mark.core

SOME = settings(max_examples=60, deadline=None)
place = st.floats(-100, 100)
handles = st.lists(st.tuples(place, place), min_size=4, max_size=4)


def spread(points):
    """Least height of a triangle of three of the points, over their size."""
    p = np.array(points)
    size = np.ptp(p, axis=0).max()
    if size == 0:
        return 0.0
    three = [np.delete(p, k, axis=0) for k in range(4)]
    longest = [max(np.linalg.norm(t[i] - t[j]) for i, j in ((0, 1), (0, 2), (1, 2))) for t in three]
    if min(longest) == 0:
        return 0.0
    sides = [(t[1] - t[0], t[2] - t[0]) for t in three]
    areas = [abs(u[0] * v[1] - u[1] * v[0]) for u, v in sides]
    return min(a / c for a, c in zip(areas, longest, strict=True)) / size


@SOME
@given(handles, handles)
def test_handles_land_and_the_way_back_undoes_it(before, after):
    assume(min(spread(before), spread(after)) > 0.02)
    matrix = four_point_map(before, after)
    image = np.column_stack([before, np.ones(4)]) @ matrix.T
    np.testing.assert_allclose(image[:, :2] / image[:, 2:], after, atol=1e-9 * 100)
    assert image[0, 2] == pytest.approx(1)
    both = four_point_map(after, before) @ matrix
    np.testing.assert_allclose(both / both[2, 2], np.eye(3), atol=1e-6)


@SOME
@given(handles, st.tuples(place, place), st.floats(-3, 3), st.floats(0.1, 10))
def test_similar_handles_give_a_map_that_is_affine(before, shift, turn, scale):
    assume(spread(before) > 0.02)
    c, s = scale * np.cos(turn), scale * np.sin(turn)
    after = np.array(before) @ np.array([[c, s], [-s, c]]) + shift
    matrix = four_point_map(before, after)
    assert matrix[2].tolist() == [0, 0, 1]
    np.testing.assert_allclose(matrix, [[c, -s, shift[0]], [s, c, shift[1]], [0, 0, 1]], atol=1e-9 * 100)


@pytest.mark.campaign
@SOME
@given(st.lists(st.tuples(st.floats(-40, 40), st.floats(-40, 40)), min_size=4, max_size=4))
def test_inflections_stay_on_a_line_in_the_same_order(moves):
    """A sine wave has all its inflections on its axis: moved by handles, it still is a strip's curve."""
    wave = PlaneCurve.fit([(x, 30 * np.sin(x / 40)) for x in np.linspace(60, 440, 181)], tolerance=1e-6)
    low, high = wave.bounds
    corners = np.array([low, (high[0], low[1]), high, (low[0], high[1])])
    moved = corners + moves
    assume(spread(moved) > 0.02)
    try:
        image = wave.transformed(four_point_map(corners, moved))
    except InputError:
        assume(False)
    before, after = (
        curve.evaluate([z.t for z in curve.curvature_zeros if z.changes_sign]) for curve in (wave, image)
    )
    assert len(before) == len(after) == 3
    # each inflection is the image of its forerunner, so their order along the curve is kept
    matrix = four_point_map(corners, moved)
    landed = np.column_stack([before, np.ones(3)]) @ matrix.T
    np.testing.assert_allclose(after, landed[:, :2] / landed[:, 2:], atol=1e-5 * image.length)
    assert np.linalg.matrix_rank(after - after.mean(axis=0), tol=1e-4 * image.length) == 1
    assert check_equilibrium(wave).realizable
    # a map may ask for a stiffness beyond all strips; nothing else keeps its image from being one
    reasons = check_equilibrium(image).reasons
    assert all("times as stiff" in reason for reason in reasons), reasons
