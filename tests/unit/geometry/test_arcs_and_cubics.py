import numpy as np
import pytest

from elastica_cad import InputError, Path, PlaneCurve
from elastica_cad.geometry import Arc, Line, Spline, as_arcs, as_cubics, as_polyline

pytestmark = pytest.mark.core


def nearest(points, line):
    """Largest distance of points from a dense polyline, in blocks."""
    line = line[np.append(True, np.any(np.diff(line, axis=0) != 0, axis=1))]
    a, d = line[:-1], np.diff(line, axis=0)
    worst = 0.0
    for p in np.array_split(points, 20):
        u = np.clip(((p[:, None] - a) * d).sum(axis=2) / (d**2).sum(axis=1), 0, 1)
        off = a + u[..., None] * d - p[:, None]
        worst = max(worst, np.hypot(off[..., 0], off[..., 1]).min(axis=1).max())
    return worst


def dense(path, count=2001):
    return np.concatenate([s.at(np.linspace(0, 1, count)) for s in path.segments])


def s_curve(degree=4):
    return PlaneCurve.spline([(0, 0), (30, 60), (55, -70), (90, 50), (120, 10), (150, 0)], degree)


@pytest.mark.campaign
@pytest.mark.parametrize("tolerance", [0.5, 0.02, 1e-3])
def test_arcs_stay_within_the_tolerance_and_are_tangent(tolerance):
    path = Path([Spline(s_curve())])
    arcs = as_arcs(path, tolerance)
    assert all(isinstance(s, (Arc, Line)) for s in arcs.segments)
    chord_error = 1e-5
    assert nearest(dense(path, 1501), dense(arcs, 400)) < tolerance + chord_error
    assert nearest(dense(arcs, 60), dense(path, 3001)) < tolerance + chord_error
    for before, after in zip(arcs.segments[:-1], arcs.segments[1:], strict=True):
        assert before.tangent_at(1.0) @ after.tangent_at(0.0) > np.cos(1e-6)
    assert arcs.start == pytest.approx(path.start, abs=1e-9)
    assert arcs.end == pytest.approx(path.end, abs=1e-9)


def test_number_of_arcs_grows_as_the_cube_root_of_the_tolerance():
    path = Path([Spline(s_curve())])
    counts = [len(as_arcs(path, tolerance).segments) for tolerance in (0.1, 1e-4)]
    assert 5 < counts[1] / counts[0] < 16


def test_a_circle_as_a_spline_becomes_arcs_of_that_circle():
    path = Path([Spline(PlaneCurve.arc((3, 4), 10, 0.0, 5.0))])
    arcs = as_arcs(path, 0.01).segments
    assert all(s.radius == pytest.approx(10, rel=1e-6) for s in arcs)
    assert sum(s.length for s in arcs) == pytest.approx(50, rel=1e-6)


def test_straight_splines_become_lines():
    path = Path([Spline(PlaneCurve.line((0, 0), (30, 10)))])
    assert all(isinstance(s, Line) for s in as_arcs(path, 0.01).segments)


@pytest.mark.campaign
def test_a_corner_inside_a_spline_survives():
    points = [(0, 0), (3, 1), (7, -1), (10, 0), (10, 4), (11, 7), (10, 10)]
    path = Path([Spline(PlaneCurve([0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2], points, 3))])
    for approximate in (as_arcs, as_polyline):
        ends = np.array([s.end for s in approximate(path, 0.01).segments])
        assert np.hypot(*(ends - (10, 0)).T).min() < 1e-9
    quartic = PlaneCurve(
        np.repeat([0.0, 1, 2], [5, 4, 5]),
        np.vstack([s_curve().control_points, [(160, 40), (170, 0), (180, 9)]]),
        4,
    )
    assert (
        nearest(dense(as_cubics(Path([Spline(quartic)]), 1e-3)), dense(Path([Spline(quartic)]), 8001))
        < 1.01e-3
    )


def test_lines_and_arcs_are_kept_as_they_are():
    path = Path.polyline([(0, 0), (20, 0), (20, 8), (0, 8)], [0, 1, 0, 1], closed=True)
    assert as_arcs(path, 0.1).segments == path.segments
    assert as_cubics(path, 0.1).segments == path.segments


@pytest.mark.parametrize("tolerance", [0.3, 0.01])
def test_polyline_has_its_corners_on_the_path(tolerance):
    path = Path([Spline(s_curve()), Line((150, 0), (0, 0))], closed=True)
    lines = as_polyline(path, tolerance)
    assert lines.closed
    assert nearest(dense(path), dense(lines, 2)) <= tolerance
    assert nearest(np.array([s.start for s in lines.segments]), dense(path, 20001)) < 1e-5
    assert lines.area == pytest.approx(path.area, abs=tolerance * path.length)


@pytest.mark.parametrize("degree", [4, 5])
def test_high_degrees_become_cubics_within_the_tolerance(degree):
    path = Path([Spline(s_curve(degree))])
    for tolerance in (0.05, 1e-4):
        (cubic,) = as_cubics(path, tolerance).segments
        assert cubic.curve.degree == 3
        t = np.linspace(*cubic.curve.domain, 4001)
        off = np.hypot(*(cubic.curve.evaluate(t) - path.segments[0].curve.evaluate(t)).T)
        assert off.max() < tolerance
        assert np.allclose(cubic.start, path.start, atol=1e-12)
        assert np.allclose(cubic.tangent_at(1.0), path.segments[0].tangent_at(1.0), atol=1e-9)


def test_low_degrees_stay_exact_and_are_clamped():
    floating = PlaneCurve(np.arange(10.0), s_curve().control_points, 3)
    (kept,) = as_cubics(Path([Spline(floating)]), 1.0).segments
    assert kept.length == pytest.approx(floating.length, rel=1e-12)
    assert np.allclose(kept.curve.control_points[0], floating.evaluate(floating.domain[0]), atol=1e-12)
    ellipse = Path([Spline(PlaneCurve.ellipse((0, 0), (8, 4)))], closed=True)
    assert as_cubics(ellipse).segments[0].curve.is_rational
    plain = as_cubics(ellipse, 1e-5, rational=False)
    assert not plain.segments[0].curve.is_rational
    assert plain.area == pytest.approx(32 * np.pi, abs=1e-5 * ellipse.length)


@pytest.mark.parametrize("turn", np.linspace(0.0, 1.5, 8))
def test_loops_that_close_up_to_rounding(turn):
    """Whatever the last digit of the gap, it gives the arcs no direction."""
    v = np.arange(11) * np.pi / 4 + turn
    ring = 16 * np.column_stack([np.cos(v), np.sin(v)])
    loop = Path([Spline(PlaneCurve(np.arange(15.0), ring, 3))], closed=True)
    arcs = as_arcs(loop, 0.3)
    assert len(arcs.segments) >= 2
    assert arcs.area == pytest.approx(loop.area, abs=0.3 * loop.length)


@pytest.mark.parametrize("tolerance", [0, -1, np.nan, np.inf])
@pytest.mark.parametrize("convert", [as_arcs, as_cubics, as_polyline])
def test_tolerances_must_be_positive(convert, tolerance):
    with pytest.raises(InputError, match="tolerance is"):
        convert(Path([Spline(s_curve())]), tolerance)
