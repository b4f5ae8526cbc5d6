"""Many paths at one go say what each path says by itself."""

import numpy as np
import pytest

from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.many_segments import (
    areas,
    bezier_points,
    bounds_of,
    chords_of,
    points_of,
    polylines,
    total_length,
)
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Arc, Line, Spline

pytestmark = pytest.mark.core


@pytest.fixture(scope="module")
def paths():
    """Splines of two degrees with few and many knots, some rational, among lines and arcs; open and closed."""
    rng = np.random.default_rng(18)
    made = [Path.rectangle(40.0, 20.0), Path.circle((3.0, 4.0), 5.0)]
    for count, degree in ((4, 3), (5, 3), (7, 3), (12, 3), (30, 3), (6, 4), (9, 4), (5, 2), (8, 2)):
        points = np.column_stack([np.linspace(0.0, 60.0, count), rng.uniform(-9.0, 9.0, count)])
        curve = PlaneCurve.spline(points, degree)
        start, end = points[0], points[-1]
        made.append(Path([Spline(curve)]))
        below = [end - np.array([0.0, 30.0]), start - np.array([0.0, 30.0])]
        made.append(
            Path([Spline(curve), Line(end, below[0]), Line(*below), Line(below[1], start)], closed=True)
        )
    made.append(Path([Spline(PlaneCurve.arc((0.0, 0.0), 7.0, 0.2, 2.9))]))
    made.append(Path([Arc((0.0, 0.0), 7.0, 2.9, 0.2)]))
    return made


def afresh(paths):
    """The same paths, which know nothing of themselves yet."""
    return [Path(path.segments, path.closed) for path in paths]


def test_lengths_sum_to_rounding_error(paths):
    asked = afresh(paths)
    alone = [sum(segment.length for segment in path.segments) for path in paths]
    assert total_length(asked) == pytest.approx(sum(alone), rel=1e-13)
    assert [path.length for path in asked] == pytest.approx(alone, rel=1e-13)
    assert total_length(asked) == sum(path.length for path in asked)
    assert total_length(afresh(paths[:3])) == pytest.approx(sum(alone[:3]), rel=1e-15)


@pytest.mark.parametrize("tolerance", [1.0, 1e-2, 1e-4])
def test_polylines_have_the_same_points(paths, tolerance):
    for path, points in zip(paths, polylines(paths, tolerance), strict=True):
        expected = path.points(tolerance)
        assert points.shape == expected.shape
        assert np.abs(points - expected).max() < 1e-11


def test_points_of_splines_are_their_own(paths):
    curves = [s.curve for path in paths for s in path.segments if isinstance(s, Spline)]
    which = np.tile(np.arange(len(curves)), 20)
    share = np.linspace(0.0, 1.0, which.size)
    low, high = np.array([curve.domain for curve in curves])[which].T
    t = low + share * (high - low)
    expected = [curves[k].evaluate(np.array([at]))[0] for k, at in zip(which, t, strict=True)]
    assert np.abs(points_of(curves, which, t) - expected).max() < 1e-11
    few = points_of(curves[:2], np.array([1, 0]), np.full(2, 0.5))
    assert np.abs(few - [curve.evaluate(0.5) for curve in curves[1::-1]]).max() < 1e-11


def test_areas_are_those_of_each_path(paths):
    closed = [path for path in paths if path.closed]
    closed += [path.reversed() for path in closed]
    alone = np.array([path.area for path in afresh(closed)])
    assert len(closed) > 16
    asked = afresh(closed)
    assert areas(asked) == pytest.approx(alone, rel=1e-12)
    assert [path.area for path in asked] == areas(asked).tolist()
    assert areas(closed[:1]).tolist() == [closed[0].area]


def test_bounds_are_those_of_each_path(paths):
    rng = np.random.default_rng(5)
    arcs = [
        Path((Arc(rng.normal(size=2), 2.0, start, start + turn),), closed=False)
        for start, turn in zip(rng.uniform(-9, 9, 200), rng.uniform(-2 * np.pi, 2 * np.pi, 200), strict=True)
    ]
    paths = [*paths, *arcs, Path.circle((1.0, 2.0), 3.0)]
    alone = np.array([path.bounds for path in afresh(paths)])
    asked = afresh(paths)
    assert bounds_of(asked) == pytest.approx(alone, abs=1e-12)
    assert np.array_equal([path.bounds for path in asked], bounds_of(asked))
    assert sum("bounds" in vars(path) for path in asked) == len(asked)
    assert np.array_equal(bounds_of(afresh(paths[:1])), alone[:1])
    assert bounds_of([]).shape == (0, 2, 2)


def test_bezier_points_of_splines_are_their_own(paths):
    """The same numbers: files of thousands of splines do not change with how many are asked for."""
    curves = [
        s.curve for path in paths for s in path.segments if isinstance(s, Spline) and s.curve.degree == 3
    ]
    counts, points = bezier_points(curves)
    alone = [[piece[:, :2] / piece[:, 2:] for _, _, piece in curve.bezier_pieces()] for curve in curves]
    assert counts.tolist() == [len(pieces) for pieces in alone]
    assert np.array_equal(points, np.concatenate(alone))


def test_chords_of_segments_go_on_where_the_one_before_ends(paths):
    segments = [segment for path in paths for segment in path.segments]
    counts, points = chords_of(segments, 1e-3)
    begins = points[np.cumsum(counts) - counts]
    assert np.abs(begins - [segment.start for segment in segments]).max() < 1e-12
    few, same = chords_of(segments[:5], 1e-3)
    assert few.tolist() == counts[:5].tolist()
    assert np.abs(same - points[: len(same)]).max() < 1e-12


def test_arcs_of_bulges_are_those_of_each_to_the_last_digit():
    rng = np.random.default_rng(7)
    starts, ends = rng.uniform(-500, 500, (2, 400, 2))
    bulges = rng.choice([-1, 1], 400) * rng.uniform(1e-3, 3.0, 400)
    for arc, *of in zip(Arc.all_of_bulges(starts, ends, bulges), starts, ends, bulges, strict=True):
        alone = Arc.from_bulge(*of)
        found, expected = (
            (a.radius, a.start_angle, a.end_angle, *a.center, *a.start, *a.end) for a in (arc, alone)
        )
        assert found == expected
