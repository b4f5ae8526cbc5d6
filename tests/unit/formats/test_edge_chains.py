import tracemalloc

import numpy as np
import pytest

from elastica_cad import Frame, InputError
from elastica_cad.formats.chains import curve_from_points, curve_from_run, join_runs, near_ends
from elastica_cad.formats.edges import Edge
from elastica_cad.formats.placed_curve import flatten_run, placed_curve
from tests.refusals import refusal_test

pytestmark = pytest.mark.core


def line(*points):
    return (Edge.polyline(points),)


def test_the_memory_of_points_on_a_long_polyline_does_not_grow_with_the_square_of_its_vertices():
    places = np.arange(2000.0)
    edge = Edge.polyline(np.column_stack([places, places % 2]))
    tracemalloc.start()
    points = edge.at(places)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    np.testing.assert_allclose(points, edge.points, atol=1e-12)
    assert peak < 5e6


def test_ends_within_tolerance_join_and_others_do_not():
    runs = [line((0, 0), (10, 0)), line((20, 5), (10.009, 0)), line((30, 0), (20.02, 5))]
    chains = join_runs(runs, 0.01).chains
    assert [len(c) for c in chains] == [2, 1]
    assert chains[0][-1].end == pytest.approx((20, 5))


def test_ring_is_one_chain_and_dust_is_dropped():
    runs = [line((0, 0), (10, 0)), line((10, 0), (5, 8)), line((0, 0), (5, 8)), line((3, 3), (3.001, 3))]
    (ring,) = join_runs(runs, 0.01).chains
    assert len(ring) == 3
    assert ring[0].start == pytest.approx(ring[-1].end)
    assert curve_from_run(ring).is_closed
    assert join_runs([line((3, 3), (3.001, 3))], 0.01).chains == []
    assert join_runs([], 0.01).chains == []


def test_lines_that_cross_in_their_middles_are_not_one_drawn_twice():
    cross = [line((0, 0), (10, 10)), line((0, 10), (10, 0)), line((10, 10), (0, 0))]
    assert len(join_runs(cross, 0.01).chains) == 2


@pytest.mark.parametrize("tolerance", [0.0, -1.0, float("nan")])
def test_tolerance_must_be_positive(tolerance):
    with pytest.raises(InputError, match="tolerance for joining"):
        join_runs([], tolerance)


def test_nearly_closed_chain_of_arcs_closes():
    half = Edge.arc((0, 0), (10, 0), (0, 10), 0, np.pi)
    other = Edge.arc((0, 0.003), (10, 0), (0, 10), np.pi, 2 * np.pi)
    (ring,) = join_runs([(half,), (other,)], 0.01).chains
    curve = curve_from_run(ring)
    assert curve.is_closed
    assert curve.length == pytest.approx(20 * np.pi, rel=1e-3)


@pytest.mark.parametrize(("turn", "corners"), [(45.0, 0), (49.0, 0), (51.0, 1)])
def test_a_polyline_has_corners_where_it_turns_by_more_than_50_degrees(turn, corners):
    v = np.radians(turn)
    curve = curve_from_points(np.array([(-100, 0), (0, 0), (100 * np.cos(v), 100 * np.sin(v))]))
    assert len(curve.tangent_breaks) == corners


def test_stations_lie_along_the_whole_edge():
    edge = Edge.polyline([(0, 0), (10, 0), (10, 30)])
    first, *_, last = edge.stations(each=5)
    assert edge.at(np.array([first, last])) == pytest.approx(np.array([(0, 0), (10, 30)]))
    assert len(edge.stations(each=5)) == 2 * 5 - 1


def test_polyline_among_true_curves_is_fitted():
    v = np.linspace(0, np.pi / 2, 50)
    sampled = Edge.polyline(np.column_stack([100 * np.cos(v), 100 * np.sin(v)]))
    straight = Edge.polyline([(0, 100), (-40, 100)])
    arc = Edge.arc((-40, 50), (0, 50), (-50, 0), 0, 1.0)
    curve = curve_from_run((sampled, straight, arc), fit_tolerance=1e-4)
    assert curve.length == pytest.approx(50 * np.pi + 40 + 50, abs=0.01)
    assert curve.degree == 4
    end = curve.at(np.array([curve.length - 10]))
    assert end.curvature == pytest.approx([1 / 50], rel=1e-9)


def test_weights_of_joined_arcs_fit_together():
    flat = Edge(
        np.repeat([0.0, 1.0], 3), np.array([(0, 0), (10, 0), (10, 10)]), 2, np.array([3, 3 / np.sqrt(2), 3])
    )
    back = Edge.arc((0, 10), (10, 0), (0, 10), 0, np.pi / 2)
    curve = curve_from_run((flat, back))
    assert np.abs(np.hypot(*(curve.sample(101).position - (0, 10)).T) - 10).max() < 1e-12
    assert not curve.tangent_breaks


test_full_stop_for_bad_numbers = refusal_test(
    [
        (lambda: Edge.polyline([(0, 0), (1, np.nan)]), "finite"),
        (lambda: curve_from_points(np.array([(0, 0), (1, np.inf), (2, 3)])), "finite"),
        (
            lambda: Edge(np.repeat([0.0, 1.0], 3), np.eye(3, 2), 2, np.array([1, 0, 1])),
            "positive finite weights",
        ),
        (lambda: Edge(np.array([0.0, 1.0]), np.eye(3, 2), 2), "but needs 6 in increasing order"),
        (lambda: Edge(np.zeros(6), np.eye(3, 2), 2), "so the spline has no length"),
    ]
)


def test_measured_points_are_met_within_the_tolerance():
    rng = np.random.default_rng(5)
    v = np.linspace(0, 3, 80)
    points = np.column_stack([120 * v, 30 * np.sin(2 * v)]) + rng.uniform(-0.02, 0.02, (80, 2))
    curve = curve_from_points(points, tolerance=0.05)
    dense = curve.sample(40001).position
    assert max(np.hypot(*(dense - p).T).min() for p in points) < 0.055
    assert len(curve.control_points) < 40


@pytest.mark.parametrize(("normal", "x_axis", "y_axis"), [
    ((0, -1, 0), (1, 0, 0), (0, 0, 1)),
    ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    ((1, -1, 0), (np.sqrt(0.5), np.sqrt(0.5), 0), (0, 0, 1)),
    ((0, -1, 1), (1, 0, 0), (0, np.sqrt(0.5), np.sqrt(0.5))),
])  # fmt: skip
def test_planes_in_space_are_seen_with_up_up(normal, x_axis, y_axis):
    drawn = np.array([(0, 0), (10, 30), (40, 30), (50, -10)], dtype=float)
    space = drawn @ np.array([x_axis, y_axis]) + 7 * np.array(normal)
    (edge,) = flatten_run((Edge.bezier(space),), 0.01)
    shift = 7 * np.array(normal) @ np.array([x_axis, y_axis]).T
    assert edge.points == pytest.approx(drawn + shift, abs=1e-9)


def test_line_in_space_is_seen_in_its_upright_plane():
    (edge,) = flatten_run(line((0, 0, 0), (3, 4, 12)), 0.01)
    assert edge.end == pytest.approx((5, 12))
    (edge,) = flatten_run(line((3, 0, 0), (3, 0, 12)), 0.01)
    assert edge.end == pytest.approx((3, 12))


TILTED = np.array([(0.0, 1.0, 0.0), (0.6, 0.0, 0.8)])
"""Axes of a plane that leans: what is drawn to the right runs along y, what is drawn up leans over x."""


def drawn(points, axes=TILTED, way=1):
    """One edge of degree 3 through the plane of two axes, by its control points."""
    space = np.array(points, dtype=float)[::way] @ axes
    return Edge([0] * 4 + [1] * 4, space, 3)


@pytest.mark.parametrize("way", [1, -1])
@pytest.mark.parametrize("high", [30, -30])
def test_an_arch_is_seen_from_where_it_turns_anticlockwise(way, high):
    curve, frame = placed_curve([drawn([(0, 0), (10, high), (50, high), (60, 0)], way=way)])
    assert curve.sample(101).angle[-1] > curve.sample(101).angle[0]
    assert frame.y_axis == pytest.approx(TILTED[1])  # up, as far as it can
    assert abs(frame.x_axis @ TILTED[0]) == pytest.approx(1.0)
    ends = [frame.point(p) for p in curve.sample(2).position]
    assert np.array(ends)[::way] == pytest.approx(np.array([(0, 0), (60, 0)]) @ TILTED, abs=1e-9)


@pytest.mark.parametrize("high", [0.3, -0.3])
def test_an_arch_of_half_a_millimetre_is_seen_from_the_same_side(high):
    curve, frame = placed_curve([drawn([(0, 0), (0.1, high), (0.5, high), (0.6, 0)])])
    assert curve.sample(101).angle[-1] > curve.sample(101).angle[0]
    assert frame.y_axis == pytest.approx(TILTED[1])


@pytest.mark.parametrize("first", [1, -1])
def test_a_wave_is_seen_from_where_its_first_bend_turns_anticlockwise(first):
    points = [(0, 0), (20, 30 * first), (40, -30 * first), (60, 0)]
    curve, _ = placed_curve([drawn(points)])
    bends = curve.sample(101).curvature
    assert bends[0] > 0 > bends[-1]


def test_a_straight_edge_has_an_upright_plane():
    for end in ((60, 0, 0), (0, 0, 60), (30, 30, 30)):
        curve, frame = placed_curve([Edge.polyline([(0, 0, 0), end])])
        assert frame.point(curve.sample(2).position[-1]) == pytest.approx(end)
        assert np.linalg.norm(frame.axes, axis=1) == pytest.approx([1, 1, 1])


def test_a_plane_that_is_given_is_kept_or_refused():
    arch = drawn([(0, 0), (10, 30), (50, 30), (60, 0)], axes=np.eye(2, 3))
    plane = Frame((5, 6, 0), (0, 1, 0), (-1, 0, 0))
    curve, frame = placed_curve([arch], plane=plane)
    assert frame is plane
    assert curve.sample(2).position == pytest.approx(np.array([(-6, 5), (-6, -55)]))
    with pytest.raises(InputError, match="up to 2 mm away from the plane that was given"):
        placed_curve([arch], plane=Frame((0, 0, 2), (1, 0, 0), (0, 1, 0)))


SIDE, UP = Edge.polyline([(0, 0, 0), (40, 0, 0)]), Edge.polyline([(40, 0, 0), (40, 30, 0)])
DROP = Edge([0] * 4 + [1] * 4, np.array([(0, 0, 0), (60, 40, 0), (60, -40, 0), (0, 0, 0)]), 3)

test_edges_that_do_not_make_one_smooth_chain_are_refused = refusal_test(
    [
        (lambda: placed_curve([SIDE, UP]), r"a corner of 90 degrees at \(40, 0, 0\) mm"),
        (
            lambda: placed_curve([SIDE, Edge.polyline([(0, 9, 0), (40, 9, 0)])]),
            r"form 2 separate chains, the nearest 9 mm apart at \(0, 0, 0\) mm: join their ends, or leave",
        ),
        (
            lambda: placed_curve([SIDE, Edge.polyline([(40.3, 0, 0), (90, 0, 0)])]),
            r"two edges end 0\.3 mm apart at \(40, 0, 0\) mm: join their ends",
        ),
        (
            lambda: placed_curve([SIDE, UP, Edge.polyline([(40, 0, 0), (90, 0, 0)])]),
            r"three or more edges meet at \(40, 0, 0\) mm",
        ),
        (lambda: placed_curve([]), "there is no edge: select at least one"),
        (
            lambda: placed_curve([Edge.polyline([(3, 4, 0), (3, 4, 0)])]),
            "the edge has no length: draw a curve",
        ),
        (lambda: placed_curve([DROP]), r"a corner of 113 degrees at \(0, 0, 0\) mm"),
    ]
)


@pytest.mark.parametrize(
    "knots",
    [
        np.arange(9.0),
        [0, 0, 0, 0, 1, 2, 2, 2, 2],
        [0, 1, 1, 2, 3, 4, 5, 5, 6],
        [0, 0, 1, 2, 3, 4, 5, 6, 6],
        [0, 0, 0, 2, 3, 4, 6, 6, 6],
    ],
)
def test_an_edge_ends_where_its_curve_does(knots):
    edge = Edge(np.array(knots, dtype=float), np.array([(0, 0), (10, 20), (30, 25), (40, 10), (60, 0)]), 3)
    first, last = edge.at(np.array([knots[3], knots[5]]))
    assert edge.start == pytest.approx(first)
    assert edge.end == pytest.approx(last)


def test_ends_that_nearly_meet_are_found():
    first, second = line((0, 0), (100, 0)), line((100.2, 0), (200, 0))
    ((apart, *numbers, place),) = near_ends([first, second], 0.01)
    assert apart == pytest.approx(0.2)
    assert numbers == [0, 1]
    assert place == pytest.approx((100, 0))
    assert near_ends([first, line((102.9, 0), (200, 0))], 0.01)
    assert not near_ends([first, line((103.1, 0), (200, 0))], 0.01)
    assert not near_ends([first, line((100.2, 0), (102, 0))], 0.01)
    assert not near_ends([first, line((0, 2), (100, 2))], 0.01)
    assert not near_ends([first, line((100, 0), (200, 50)), line((100, 0), (200, 9))], 0.01)
