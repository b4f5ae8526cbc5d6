import numpy as np
import pytest

from elastica_cad import InputError, Path, PlaneCurve
from elastica_cad.geometry import Arc, Line, Spline, offset_path

pytestmark = pytest.mark.core


def side(sign):
    """A long side as strips have: the graph of half a width, cubic, with Greville abscissae."""
    knots = np.concatenate([[0] * 3, np.linspace(0, 300, 31), [300] * 3])
    x = np.lib.stride_tricks.sliding_window_view(knots[1:-1], 3).mean(axis=1)
    return Spline(PlaneCurve(knots, np.column_stack([x, sign * (9 + 6 * np.sin(x / 31) + 0.01 * x)]), 3))


def strip():
    """A strip with a rounded tab, a square end and a slot of 1 mm in its lower side's place."""
    low, high = side(-1), side(1).reversed()
    (x1, y1), (_, y0) = low.end, low.start
    tab = Path.polyline(
        [(x1, y1), (x1 + 8, y1), (x1 + 10, y1 + 2), (x1 + 10, -0.5), (x1, -0.5), (x1, 0.5), (x1 + 10, 0.5),
         (x1 + 10, -y1 - 2), (x1 + 8, -y1), (x1, -y1)],
        [0, np.tan(np.pi / 8), 0, 0, 0, 0, 0, np.tan(np.pi / 8), 0, 0],
    )  # fmt: skip
    return Path([low, *tab.segments, high, Line((0, -y0), (0, y0))], closed=True)


def distance_to(path, points, count=10001):
    """Least distance from points to a path by brute force: nearest of many chords."""
    best = np.full(len(points), np.inf)
    for segment in path.segments:
        q = segment.at(np.linspace(0, 1, 2 if isinstance(segment, Line) else count))
        for i, p in enumerate(points):
            k = np.argmin(((q - p) ** 2).sum(axis=1))
            near = q[max(0, k - 1) : k + 2]
            a, d = near[:-1], np.diff(near, axis=0)
            u = np.clip(((p - a) * d).sum(axis=1) / (d**2).sum(axis=1), 0, 1)
            best[i] = min(best[i], np.hypot(*(a + u[:, None] * d - p).T).min())
    return best


def samples(path, count=37):
    return np.concatenate([s.at(np.linspace(0.003, 0.997, count)) for s in path.segments])


@pytest.mark.parametrize("clockwise", [False, True])
@pytest.mark.parametrize("d", [0.075, -0.075, 2.0, -2.0])
def test_rectangle_is_exact(d, clockwise):
    plate = Path.rectangle(40, 10, corner=(3, 4))
    moved = offset_path(plate.reversed() if clockwise else plate, d)
    expected = 400 + 100 * d + (np.pi * d**2 if d > 0 else 4 * d**2)
    assert abs(moved.area) == pytest.approx(expected, rel=1e-13)
    assert (moved.area < 0) == clockwise
    assert moved.bounds == pytest.approx(np.array([[3 - d, 4 - d], [43 + d, 14 + d]]), abs=1e-12)
    assert len(moved.segments) == (8 if d > 0 else 4)


@pytest.mark.parametrize("d", [0.075, -0.075, -4.9])
def test_circle_is_exact(d):
    moved = offset_path(Path.circle((7, -3), 5), d)
    (arc,) = moved.segments
    assert arc.radius == pytest.approx(5 + d, rel=1e-15)
    assert np.all(arc.center == (7, -3))


@pytest.mark.campaign
@pytest.mark.parametrize("d", [0.075, -0.075, 0.4, -0.4])
def test_strip_offset_lies_at_its_distance_everywhere(d):
    path = strip()
    moved = offset_path(path, d, tolerance=1e-4)
    off = np.abs(distance_to(path, samples(moved)) - abs(d))
    assert off.max() < 1e-4 + 1e-6
    assert abs(moved.area) - abs(path.area) == pytest.approx(d * path.length, abs=40 * d**2)
    assert sum(isinstance(s, Spline) for s in moved.segments) == 2
    following = [*moved.segments[1:], moved.segments[0]]
    gaps = [np.hypot(*(b.start - a.end)) for a, b in zip(moved.segments, following, strict=True)]
    assert max(gaps) < 1e-6


def test_tighter_tolerance_is_kept():
    path = Path([side(1)])
    off = np.abs(distance_to(path, samples(offset_path(path, 0.3, tolerance=1e-6), 97), 100001) - 0.3)
    assert off.max() < 1.2e-6


@pytest.mark.campaign
def test_smooth_loop_grows_by_steiners_formula():
    loop = Path([Spline(PlaneCurve.ellipse((0, 0), (30, 18)))], closed=True)
    for d in (1.0, -1.0, 5.0):
        moved = offset_path(loop, d, tolerance=1e-6)
        assert len(moved.segments) == 1
        assert moved.area == pytest.approx(loop.area + d * loop.length + np.pi * d**2, abs=2e-4)
        assert moved.length == pytest.approx(loop.length + 2 * np.pi * d, abs=1e-4)


def test_inner_corner_between_line_and_spline_is_trimmed():
    arch = PlaneCurve.spline([(0, 0), (10, 20), (30, 20), (50, 20), (60, 0)])
    dome = Path([Line((0, 0), (60, 0)), Spline(arch.reversed())], closed=True)
    moved = offset_path(dome, -2.0)
    assert [type(s).__name__ for s in moved.segments] == ["Line", "Spline"]
    assert np.abs(distance_to(dome, samples(moved)) - 2).max() < 1.1e-4


def test_open_path_moves_to_its_left():
    path = Path([Line((0, 0), (10, 0)), Line((10, 0), (10, 5))])
    left, right = offset_path(path, 1.0), offset_path(path, -1.0)
    assert np.allclose(left.points(0.1), [(0, 1), (9, 1), (9, 5)])
    assert right.start == pytest.approx([0, -1])
    assert isinstance(right.segments[1], Arc)
    assert right.segments[1].sweep == pytest.approx(np.pi / 2)


def test_fillets_smaller_than_the_offset_vanish():
    rounded = Path.polyline(
        [(1, 0), (9, 0), (10, 1), (10, 5), (9, 6), (1, 6), (0, 5), (0, 1)],
        [0, 0.41421356237] * 4,
        closed=True,
    )
    moved = offset_path(rounded, -1.5)
    assert len(moved.segments) == 4
    assert moved.area == pytest.approx(7 * 3, rel=1e-9)


def test_short_edges_between_inner_corners_vanish():
    bevel = Path.polygon([(0, 0), (20, 0), (20, 20), (10, 20), (10, 10.05), (9.95, 10), (0, 10)])
    moved = offset_path(bevel, 0.5)
    # the bevel of 0.07 mm is gone: the two long edges meet
    assert np.allclose(
        moved.points(10.0)[np.argmin(np.hypot(*(moved.points(10.0) - (9.5, 10.5)).T))], (9.5, 10.5)
    )


def test_corners_inside_a_spline_are_corners():
    points = [(0, 0), (3, 1), (7, -1), (10, 0), (10, 4), (11, 7), (10, 10)]
    kinked = PlaneCurve([0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2], points, 3)
    path = Path([Spline(kinked)])
    for d, kinds in ((0.5, ["Spline", "Spline"]), (-0.5, ["Spline", "Arc", "Spline"])):
        moved = offset_path(path, d)
        assert [type(s).__name__ for s in moved.segments] == kinds
        off = np.abs(distance_to(path, samples(moved)) - 0.5)
        assert off.max() < 1.1e-4


def test_zero_is_no_change():
    path = strip()
    assert offset_path(path, 0.0) is path


@pytest.mark.parametrize(
    ("path", "d", "message"),
    [
        (Path.circle((3, 4), 1), -1.0, r"removes the path at \(2, 4\) mm"),
        (Path.rectangle(10, 10), -5.0, "swallows|runs into"),
        (Path.rectangle(40, 10), -6.0, "removes|runs into|cross"),
        # a slot closed by its walls, a slot closed at its mouth only, a gap between two arms
        (
            Path.polygon([(0, 0), (9, 0), (9, 9), (5, 9), (5, 2), (4.9, 2), (4.9, 9), (0, 9)]),
            0.06,
            "removes the path",
        ),
        (
            Path.polygon([(0, 0), (9, 0), (9, 9), (5, 9), (6, 3), (4, 3), (4.9, 9), (0, 9)]),
            0.06,
            "mm at|path at",
        ),
        (
            Path.polygon([(0, 0), (9, 0), (9, 4), (5, 2.05), (5, 5), (0, 5)]).transformed(np.eye(3)),
            -1.2,
            " at ",
        ),
        (Path([Spline(PlaneCurve.ellipse((0, 0), (30, 3)))], closed=True), -0.31, "radius of 0.3 mm"),
        (Path.rectangle(10, 10), np.nan, "finite"),
    ],
)
def test_what_can_not_be_offset_is_refused_with_its_place(path, d, message):
    with pytest.raises(InputError, match=message):
        offset_path(path, d)
