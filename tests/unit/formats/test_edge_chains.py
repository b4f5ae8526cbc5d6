import numpy as np
import pytest

from elastica_cad.errors import InputError
from elastica_cad.formats.curve_files.chains import curve_from_points, curve_from_run, join_runs
from elastica_cad.formats.curve_files.edge_plane import flatten_run
from elastica_cad.formats.curve_files.edges import Edge

pytestmark = pytest.mark.core


def line(*points):
    return (Edge.polyline(points),)


def test_ends_within_tolerance_join_and_others_do_not():
    runs = [line((0, 0), (10, 0)), line((20, 5), (10.009, 0)), line((30, 0), (20.02, 5))]
    chains = join_runs(runs, 0.01)
    assert [len(c) for c in chains] == [2, 1]
    assert chains[0][-1].end == pytest.approx((20, 5))


def test_ring_is_one_chain_and_dust_is_dropped():
    runs = [line((0, 0), (10, 0)), line((10, 0), (5, 8)), line((0, 0), (5, 8)), line((3, 3), (3.001, 3))]
    (ring,) = join_runs(runs, 0.01)
    assert len(ring) == 3
    assert ring[0].start == pytest.approx(ring[-1].end)
    assert curve_from_run(ring).is_closed
    assert join_runs([line((3, 3), (3.001, 3))], 0.01) == []
    assert join_runs([], 0.01) == []


def test_lines_that_cross_in_their_middles_are_not_one_drawn_twice():
    cross = [line((0, 0), (10, 10)), line((0, 10), (10, 0)), line((10, 10), (0, 0))]
    assert len(join_runs(cross, 0.01)) == 2


@pytest.mark.parametrize("tolerance", [0.0, -1.0, float("nan")])
def test_tolerance_must_be_positive(tolerance):
    with pytest.raises(InputError, match="tolerance for joining"):
        join_runs([], tolerance)


def test_nearly_closed_chain_of_arcs_closes():
    half = Edge.arc((0, 0), (10, 0), (0, 10), 0, np.pi)
    other = Edge.arc((0, 0.003), (10, 0), (0, 10), np.pi, 2 * np.pi)
    (ring,) = join_runs([(half,), (other,)], 0.01)
    curve = curve_from_run(ring)
    assert curve.is_closed
    assert curve.length == pytest.approx(20 * np.pi, rel=1e-3)


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


def test_full_stop_for_bad_numbers():
    with pytest.raises(InputError, match="finite"):
        Edge.polyline([(0, 0), (1, np.nan)])
    with pytest.raises(InputError, match="finite"):
        curve_from_points(np.array([(0, 0), (1, np.inf), (2, 3)]))
    with pytest.raises(InputError, match="weights, all positive"):
        Edge(np.repeat([0.0, 1.0], 3), np.eye(3, 2), 2, np.array([1, 0, 1]))
    with pytest.raises(InputError, match="it needs 6, never decreasing"):
        Edge(np.array([0.0, 1.0]), np.eye(3, 2), 2)
    with pytest.raises(InputError, match="must run over an interval"):
        Edge(np.zeros(6), np.eye(3, 2), 2)


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
