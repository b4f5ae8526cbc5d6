"""Corners that the rounding of coordinates made are taken out; real ones stay."""

import numpy as np
import pytest

from elastica_cad import PlaneCurve
from elastica_cad.geometry.splines import elevate_degree
from elastica_cad.geometry.tangent_healing import LARGEST_REMOVED_RAD, heal_tangents

pytestmark = pytest.mark.core

KNOTS = np.repeat([0.0, 1.0, 2.0], [4, 3, 4])


def smooth_pair(handle_in, handle_out, at=37.0):
    """Two cubics that share their tangent, with handles of these lengths at the node."""
    along = np.array([np.cos(np.radians(at)), np.sin(np.radians(at))])
    node = np.array([61.2345, 48.7654])
    return np.array(
        [
            (0, 0),
            (5.1, 40.2),
            node - handle_in * along,
            node,
            node + handle_out * along,
            (130.3, 60.4),
            (150, 0),
        ]
    )


@pytest.mark.parametrize("decimals", range(7))
@pytest.mark.parametrize(("handle_in", "handle_out"), [(30.0, 30.0), (25.0, 60.0), (12.0, 8.0)])
def test_rounded_handles_come_back_to_one_line(decimals, handle_in, handle_out):
    points = smooth_pair(handle_in, handle_out)
    rounding = 0.5 * 10.0**-decimals
    rounded = np.round(points, decimals)
    healing = heal_tangents(KNOTS, rounded, 3, rounding=rounding)
    curve = PlaneCurve(healing.knots, healing.control_points, healing.degree)
    explained = healing.undecided[0].angle if healing.undecided else 0.0
    assert explained == 0 or explained > LARGEST_REMOVED_RAD
    if not healing.undecided:
        assert not curve.tangent_breaks
        assert healing.moved <= 2 * np.sqrt(2) * rounding
        assert np.abs(healing.control_points[[0, 3, -1]] - rounded[[0, 3, -1]]).max() == 0


def test_the_bounds_of_two_handles_known_by_hand():
    """30 mm at two decimals: 0.027 degrees a handle; 1 mm at one decimal: 8 degrees a handle."""
    for handle, rounding, degrees in ((30.0, 0.005, 0.0270), (1.0, 0.05, 8.13)):
        points = smooth_pair(handle, handle)
        points[4] += (0.0, 1e-4 * handle)
        healing = heal_tangents(KNOTS, points, 3, rounding=rounding)
        (turn,) = healing.healed
        assert np.degrees(turn.bound) == pytest.approx(2 * degrees, rel=2e-3)


def test_a_corner_larger_than_rounding_explains_stays_to_the_bit():
    points = smooth_pair(30.0, 30.0)
    points[4] += (0.0, 0.2)
    healing = heal_tangents(KNOTS, points, 3, rounding=0.005)
    assert healing.control_points is points
    assert healing.moved == 0
    assert not healing.undecided


def test_a_large_turn_that_rounding_explains_is_left_and_reported():
    points = smooth_pair(1.0, 1.0)
    points[4] = points[3] + np.array([np.cos(np.radians(45)), np.sin(np.radians(45))])
    healing = heal_tangents(KNOTS, points, 3, rounding=0.05)
    (turn,) = healing.undecided
    assert np.degrees(turn.angle) == pytest.approx(8.0)
    assert healing.moved == 0


def test_the_longer_handle_turns_less_and_both_ends_move_equally():
    points = smooth_pair(10.0, 40.0)
    points[4] += (0.0, 0.01)
    healing = heal_tangents(KNOTS, points, 3, rounding=0.01)
    moves = np.hypot(*(healing.control_points - points).T)
    assert moves[2] == pytest.approx(moves[4], rel=1e-3)
    assert np.flatnonzero(moves).tolist() == [2, 4]


def test_a_straight_piece_is_kept_where_its_neighbour_can_turn():
    line = np.array([(-30.0, 0.0), (-20.0, 0.0), (-10.0, 0.0), (0.0, 0.0)])
    points = np.vstack([line, [(20.0, 0.02), (40.0, 20.0), (50.0, 50.0)]])
    healing = heal_tangents(KNOTS, points, 3, rounding=0.01)
    assert healing.control_points[:4] == pytest.approx(line, abs=0)
    assert healing.control_points[4, 1] == pytest.approx(0.0, abs=1e-14)


def test_quadratic_pieces_are_raised_so_that_nodes_heal_apart():
    knots = np.repeat([0.0, 1.0, 2.0, 3.0], [3, 2, 2, 3])
    points = np.array(
        [(0, 0), (10, 20), (30, 30.004), (50, 40), (70, 30.003), (90, 20), (100, 0)], dtype=float
    )
    healing = heal_tangents(knots, points, 2, rounding=0.005)
    healed = PlaneCurve(healing.knots, healing.control_points, healing.degree)
    assert healing.degree == 3
    assert not healed.tangent_breaks
    drawn = PlaneCurve(knots, points, 2)
    assert (
        np.hypot(*(healed.sample(300).position - drawn.sample(300).position).T).max() < healing.moved + 1e-9
    )


def test_elevation_changes_nothing():
    knots = np.array([0, 0, 0, 0, 1, 2, 2, 3, 3, 3, 3], dtype=float)
    points = np.array([(0, 0), (1, 4), (4, 5), (7, 1), (9, 3), (10, 8), (14, 9)], dtype=float)
    weights = np.array([1, 2, 1, 0.5, 1, 1, 3], dtype=float)
    before = PlaneCurve(knots, points, 3, weights)
    raised_knots, raised, raised_weights = elevate_degree(knots, points, 3, weights)
    after = PlaneCurve(raised_knots, raised, 4, raised_weights)
    t = np.linspace(0, 3, 50)
    assert after.evaluate(t) == pytest.approx(before.evaluate(t), abs=1e-12)


def test_where_a_closed_path_closes_rounding_is_healed_as_elsewhere():
    along = np.array([np.cos(0.3), np.sin(0.3)])
    node = np.array([50.0, 20.0])
    round_path = [
        node,
        node + 31.7 * along,
        (120, 60),
        (120, 100),
        (120, 140),
        (20, 150),
        (10, 100),
        node - 28.3 * along,
    ]
    points = np.round(np.array([*round_path[:-1], (5, 60), round_path[-1], node]), 1)
    points = points[[0, 1, 2, 3, 4, 5, 6, 7, 8, 9]]
    knots = np.repeat([0.0, 1.0, 2.0, 3.0], [4, 3, 3, 4])
    before = PlaneCurve(knots, points, 3)
    assert abs(before.seam_turn) > 1e-4
    healing = heal_tangents(knots, points, 3, rounding=0.05)
    after = PlaneCurve(healing.knots, healing.control_points, 3)
    assert healing.healed[-1].t == 0.0
    assert after.is_closed
    assert abs(after.seam_turn) < 1e-9
    assert 0 < healing.moved <= 2 * np.sqrt(2) * 0.05
    sharp = points.copy()
    sharp[1] += (0.0, 3.0)
    assert heal_tangents(knots, sharp, 3, rounding=0.05).healed == healing.healed[:-1]
    loop = np.array([(0, 0), (100, 80), (-100, 80), (0, 0)], dtype=float)
    alone = heal_tangents(np.repeat([0.0, 1.0], 4), loop, 3, rounding=0.05)
    assert alone.healed == (), "one piece that closes has a corner"
