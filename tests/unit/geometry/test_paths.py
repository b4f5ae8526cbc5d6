from itertools import pairwise

import numpy as np
import pytest

from elastica_cad import InputError, Path, PlaneCurve
from elastica_cad.geometry import Arc, Line, Spline
from elastica_cad.geometry.path import trim_segment
from elastica_cad.geometry.path_intersections import clip_across, self_crossing, trim_across
from elastica_cad.geometry.plane_curve import clamp_ends
from elastica_cad.strip.outline import graph

pytestmark = pytest.mark.core


def turned(angle, x=0.0, y=0.0, scale=1.0, mirror=1.0):
    c, s = scale * np.cos(angle), scale * np.sin(angle)
    return np.array([[c, -s * mirror, x], [s, c * mirror, y], [0, 0, 1]])


def wavy(degree=4, weights=None):
    points = np.array([(0, 0), (10, 9), (22, -7), (35, 12), (41, 3), (50, 5)], dtype=float)
    return PlaneCurve(PlaneCurve.spline(points, degree).knots, points, degree, weights)


def green(curve, count=20001):
    """Area by Simpson's rule on the parametric form, independent of the Bezier pieces."""
    t = np.linspace(*curve.domain, count)
    p, d = curve.evaluate(t), curve.evaluate(t, 1)
    f = (p[:, 0] * d[:, 1] - p[:, 1] * d[:, 0]) / 2
    h = t[1] - t[0]
    return h / 3 * (f[0] + f[-1] + 4 * f[1:-1:2].sum() + 2 * f[2:-1:2].sum())


@pytest.mark.parametrize("closed", [True, False])
def test_chords_with_one_between_them_may_cross(closed):
    """A bow tie, whose first chord crosses the third; beside it a hook that turns back without touching."""
    bow = np.array([(0, 0), (10, 10), (10, 0), (0, 10)], dtype=float)
    assert self_crossing(bow, closed=closed) == pytest.approx([5, 5])
    assert self_crossing(bow[[0, 2, 1, 3]], closed=closed) is None


def test_rectangle_and_circle_in_closed_form():
    plate = Path.rectangle(40, 10, corner=(-3, 7))
    assert plate.area == 400
    assert plate.length == 100
    assert plate.bounds.tolist() == [[-3, 7], [37, 17]]
    disc = Path.circle((1000, -2000), 3)
    assert disc.area == pytest.approx(9 * np.pi, rel=1e-14)
    assert disc.length == pytest.approx(6 * np.pi, rel=1e-15)
    assert np.allclose(disc.bounds, [[997, -2003], [1003, -1997]], rtol=0, atol=1e-12)
    assert np.all(disc.start == disc.end)


def test_stadium_with_bulges_runs_either_way():
    stadium = Path.polyline([(0, 0), (20, 0), (20, 8), (0, 8)], [0, 1, 0, 1], closed=True)
    assert stadium.area == pytest.approx(160 + 16 * np.pi, rel=1e-14)
    assert stadium.length == pytest.approx(40 + 8 * np.pi, rel=1e-14)
    assert stadium.reversed().area == pytest.approx(-stadium.area, rel=1e-14)
    assert [s.bulge for s in stadium.segments if isinstance(s, Arc)] == pytest.approx([1, 1])


@pytest.mark.parametrize("turn", [0.3, -1.2, 3.0, -4.5, 6.0])
def test_bulge_is_the_tangent_of_a_quarter_turn(turn):
    arc = Arc((3, 4), 5.0, 0.7, 0.7 + turn)
    again = Arc.from_bulge(arc.start, arc.end, arc.bulge)
    assert np.allclose(again.center, arc.center, atol=1e-11)
    assert again.radius == pytest.approx(5, rel=1e-12)
    assert again.sweep == pytest.approx(turn, rel=1e-12)
    assert np.allclose(again.tangent_at(0.0), arc.tangent_at(0.0), atol=1e-12)


def test_arc_bounds_take_the_poles_that_it_passes():
    arc = Arc((0, 0), 2, np.radians(-100), np.radians(100))
    dense = arc.at(np.linspace(0, 1, 100001))
    assert np.allclose(arc.bounds, [dense.min(axis=0), dense.max(axis=0)], atol=1e-8)
    assert np.allclose(arc.reversed().bounds, arc.bounds, atol=1e-15)


def test_area_under_splines_is_exact():
    x = np.linspace(0, 30, 4)
    cubic = Spline(PlaneCurve([0, 0, 0, 0, 1, 1, 1, 1], np.column_stack([x, [0, 3, -2, 5]]), 3))
    loop = Path(
        [cubic, Line(cubic.end, (30, -9)), Line((30, -9), (0, -9)), Line((0, -9), (0, 0))], closed=True
    )
    # a Bezier function's integral is the mean of its coefficients
    assert -loop.area == pytest.approx(30 * (6 / 4 + 9), rel=1e-14)
    for curve in (wavy(), wavy(5), wavy(3, [1, 2, 0.5, 3, 1, 1.5])):
        assert Spline(curve).swept_area() == pytest.approx(green(curve), rel=1e-11)


@pytest.mark.parametrize("backward", [False, True])
def test_area_beside_a_graph_is_that_of_its_function(backward):
    """The integral of a basis function over clamped knots is its support's width over degree + 1."""
    knots = np.concatenate([[0] * 4, np.sort(np.random.default_rng(3).uniform(0, 200, 90)), [200] * 4])
    values = 9 + np.sin(np.arange(94))
    under = values @ (knots[4:] - knots[:-4]) / 4
    side = graph(knots, values, backward=backward)
    ends = np.array([side.start, side.end])
    expected = (ends[0, 0] * ends[1, 1] - ends[1, 0] * ends[0, 1]) / 2
    expected -= np.sign(ends[1, 0] - ends[0, 0]) * (under - 200 * ends[:, 1].mean())
    assert side.swept_area() == pytest.approx(expected, rel=1e-12)
    move = turned(0.4, 3, -2)
    assert side.transformed(move).swept_area(move[:2, 2]) == pytest.approx(expected, rel=1e-12)


def test_ellipse_is_exact_too():
    ellipse = Path([Spline(PlaneCurve.ellipse((500, -300), (40, 3), rotation=0.3))], closed=True)
    assert ellipse.area == pytest.approx(120 * np.pi, rel=1e-12)


@pytest.mark.parametrize(
    "matrix", [turned(0.4, 3, -2), turned(1.0, scale=2.5), turned(-2, 1, 1, mirror=-1.0)]
)
def test_similarities_move_everything(matrix):
    path = Path(
        [Line((0, 0), (10, 0)), Arc((10, 5), 5, -np.pi / 2, np.pi / 2), Line((10, 10), (0, 0))], closed=True
    )
    moved = path.transformed(matrix)
    scale = np.linalg.det(matrix[:2, :2])
    assert moved.area == pytest.approx(path.area * scale, rel=1e-13)
    assert moved.length == pytest.approx(path.length * np.sqrt(abs(scale)), rel=1e-13)
    u = np.linspace(0, 1, 7)
    for before, after in zip(path.segments, moved.segments, strict=True):
        assert np.allclose(after.at(u), before.at(u) @ matrix[:2, :2].T + matrix[:2, 2], atol=1e-12)


def test_a_matrix_counts_over_its_last_number():
    """Also where that is negative: this one moves nothing."""
    path = Path([Arc((1.0, 2.0), 3.0, 0.3, 1.2)])
    moved = path.transformed(-np.eye(3))
    np.testing.assert_allclose(moved.points(0.01), path.points(0.01), atol=1e-12)


def test_a_path_moved_far_away_is_checked_again():
    speck = Path([Spline(PlaneCurve.line((0, 0), (1e-4, 0)))])
    with pytest.raises(InputError):
        speck.transformed(turned(0.0, 1e13))
    with pytest.raises(InputError, match="no length"):
        Path([Line((0, 0), (1e-4, 0))]).transformed(turned(0.0, 1e13))


def test_bounds_ask_the_splines_that_reach_out():
    """Pieces of a wavy line: some lie within the ends of the others, some reach out by a hump."""
    humps = PlaneCurve.spline([(0, 0), (10, 30), (20, -30), (30, 30), (40, -12), (50, 5), (60, 0)], 3)
    edges = np.linspace(0, 1, 8)
    pieces = [trim_segment(Spline(humps), a, b) for a, b in pairwise(edges.tolist())]
    dense = humps.evaluate(np.linspace(*humps.domain, 200_001))
    expected = [dense.min(axis=0), dense.max(axis=0)]
    assert np.abs(Path(pieces).bounds - expected).max() < 1e-7
    assert np.abs(Path(pieces).reversed().bounds - expected).max() < 1e-7


def test_uneven_scaling_makes_splines_of_arcs():
    squeezed = Path.circle((1, 2), 5).transformed(np.diag([2.0, 0.5, 1.0]))
    assert squeezed.has_splines
    assert squeezed.area == pytest.approx(25 * np.pi, rel=1e-12)
    with pytest.raises(InputError, match="evenly"):
        Arc((0, 0), 1, 0, 1).transformed(np.diag([2.0, 0.5, 1.0]))


@pytest.mark.parametrize("tolerance", [0.5, 0.02, 1e-4])
def test_points_stay_within_the_tolerance(tolerance):
    curve = wavy()
    for path in (Path.circle((0, 0), 7), Path([Spline(curve)])):
        points = path.points(tolerance)
        chords = np.vstack([points, points[:1]]) if path.closed else points
        dense = np.concatenate([s.at(np.linspace(0, 1, 3001)) for s in path.segments])
        a, d = chords[:-1], np.diff(chords, axis=0)
        u = np.clip(((dense[:, None] - a) * d).sum(axis=2) / (d**2).sum(axis=1), 0, 1)
        off = np.hypot(*np.moveaxis(a + u[..., None] * d - dense[:, None], 2, 0)).min(axis=1)
        assert off.max() <= tolerance
        assert off.max() > tolerance / 30


def test_a_thin_lens_keeps_its_inside():
    lens = Path.polyline([(0, 0), (10, 0)], [0.1, 0.0], closed=True)
    assert len(lens.points(5.0)) >= 3
    assert Path.polygon(lens.points(5.0)).area > 0.5 * lens.area


def test_trimmed_pieces_are_the_same_curve():
    unclamped = PlaneCurve(np.arange(10.0), wavy().control_points[:5], 4)
    rational = wavy(3, [1, 2, 0.5, 3, 1, 1.5])
    for segment in (Spline(unclamped), Spline(rational), Arc((1, 1), 3, 2, -1), Line((0, 0), (4, 1))):
        part = trim_segment(segment, 0.21, 0.83)
        u = np.linspace(0, 1, 41)
        assert np.allclose(part.at(u), segment.at(0.21 + 0.62 * u), atol=1e-12)
        assert trim_segment(segment, 0.0, 1.0).length == pytest.approx(segment.length, rel=1e-12)
    whole = clamp_ends(unclamped)
    assert np.allclose(
        whole.control_points[[0, -1]], unclamped.evaluate(np.array(unclamped.domain)), atol=1e-13
    )
    assert whole.length == pytest.approx(unclamped.length, rel=1e-12)


def test_trimming_next_to_a_knot_makes_no_rounding_span():
    curve = wavy(3)
    knot = curve.knots[4]
    part = trim_segment(Spline(curve), 0.0, knot * (1 + 1e-15))
    assert np.diff(np.unique(part.curve.knots)).min() > 1e-3


@pytest.mark.parametrize("scale", [1.0, 7.0])
def test_velocities_are_those_of_the_points(scale):
    curve = PlaneCurve(scale * wavy().knots, wavy().control_points, 4)
    for segment in (Spline(curve), Arc((1, 1), 3, 2, -1), Line((0, 0), (4, 1))):
        u, h = np.linspace(0.1, 0.9, 7), 1e-5
        wanted = (segment.at(u + h) - segment.at(u - h)) / (2 * h)
        assert segment.velocity_at(u) == pytest.approx(wanted, rel=1e-6, abs=1e-6)


def test_a_path_is_cut_where_two_of_its_curves_meet():
    for k in range(1, 30):  # of these every fourth ends a rounding off the line
        x, y = 10 + 0.1 * k, k / 7
        first = PlaneCurve.spline([(0, 0), (x / 3, 5), (2 * x / 3, 3), (x, y)], degree=3)
        second = PlaneCurve.spline([(x, y), (x + 9, 5), (x + 15, 3), (x + 30, 1)], degree=3)
        path = Path([Spline(first), Spline(second)])
        (left,), (right,) = trim_across(path, -1, x), trim_across(path, x, x + 50)
        assert left.length == pytest.approx(first.length, abs=1e-6)
        assert right.length == pytest.approx(second.length, abs=1e-6)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Path([]), "at least one segment"),
        (lambda: Path([Line((0, 0), (1, 0)), Line((1, 1), (0, 0))]), r"gap of 1 mm at \(1, 0\) mm"),
        (lambda: Path([Line((0, 0), (1, 0))], closed=True), "gap of 1 mm"),
        (lambda: Path([Line((0, 0), (1, 0)), Line((1, 2e-6), (0, 0))]), "gap of 0.000002 mm"),
        (lambda: Line((1, 2), (1, 2)), r"line at \(1, 2\) mm has no length"),
        (lambda: Line((1, np.nan), (1, 2)), "finite"),
        (lambda: Arc((0, 0), -1, 0, 1), "radius is -1"),
        (lambda: Arc((0, 0), 1, 0, 7), "at most 2 pi"),
        (lambda: Arc((0, 0), 1, 0, 2 * np.pi * 1.0001), "at most 2 pi"),
        (lambda: Arc((0, 0), 1, 1, 1), "more than 0"),
        (lambda: Path.rectangle(3, 0), "give positive sides"),
        (lambda: Path([Line((0, 0), (1, 0))]).area, "open path has no area"),
        (lambda: Path.circle((0, 0), 1).points(0), "tolerance is 0"),
        (lambda: Path.circle((0, 0), 1).transformed(np.ones((3, 3))), "last row"),
        (lambda: Path.polyline([(0, 0), (1, np.inf)]), "finite numbers"),
        (lambda: Path.polyline([(0, 0), (1, 1)], [1]), "one finite bulge"),
        (lambda: trim_segment(Line((0, 0), (1, 0)), 0.5, 0.5), "0 <= u0 < u1 <= 1"),
    ],
)
def test_bad_input_is_one_sentence(make, message):
    with pytest.raises(InputError, match=message):
        make()


@pytest.mark.parametrize("ends", [(50.0, 60.0), (-20.0, -10.0)])
def test_lines_beside_a_path_leave_no_part_of_it(ends):
    with pytest.raises(InputError, match=r"the path has no part .* from 0 to 40 mm"):
        clip_across(Path.rectangle(40, 10), *ends)


@pytest.mark.campaign
@pytest.mark.parametrize("tolerance", [0.1, 0.01])
def test_chords_follow_hairpins_and_other_sharp_splines(tolerance):
    """A hairpin reaches far beyond the chord of its ends, which lies on the line of that chord all the way."""
    ways = [np.array([(0, 0), (12, 0), (12, 1e-4), (1, 0)], dtype=float)]
    rng = np.random.default_rng(4)
    ways += [30 * rng.normal(size=(int(rng.integers(5, 11)), 2)) for _ in range(60)]
    for points in ways:
        curve = PlaneCurve.spline(points, 3)
        chords = np.array(Path([Spline(curve)]).points(tolerance))
        drawn = curve.evaluate(np.linspace(*curve.domain, 4001))
        assert point_polyline_distances(drawn, chords).max() < 1.05 * tolerance


def point_polyline_distances(points, corners):
    """Distance of each point from the nearest chord, by brute force."""
    begins, ways = corners[:-1], np.diff(corners, axis=0)
    best = np.full(len(points), np.inf)
    for begin, way in zip(begins, ways, strict=True):
        along = np.clip((points - begin) @ way / max(way @ way, 1e-300), 0, 1)
        best = np.minimum(best, np.hypot(*(points - begin - along[:, None] * way).T))
    return best
