"""Paths, offsets and conversions must not care where, how large or which way round things are drawn."""

import numpy as np
import pytest
import shapely
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from elastica_cad import InputError, Path, PlaneCurve
from elastica_cad.geometry import Spline, as_arcs, as_polyline, offset_path

few = settings(max_examples=40, deadline=None)
unit = st.floats(0, 1)


@st.composite
def star_polygons(draw, smallest=3, largest=9):
    """Simple polygons about the origin, convex or not."""
    n = draw(st.integers(smallest, largest))
    steps = np.array(draw(st.lists(st.floats(0.4, 1), min_size=n, max_size=n)))
    radii = np.array(draw(st.lists(st.floats(8, 20), min_size=n, max_size=n)))
    v = 2 * np.pi * np.cumsum(steps) / steps.sum()
    return radii[:, None] * np.column_stack([np.cos(v), np.sin(v)])


@st.composite
def similarities(draw):
    v, scale = draw(st.floats(-7, 7)), draw(st.floats(0.2, 5))
    mirror = draw(st.sampled_from([1, -1]))
    c, s = scale * np.cos(v), scale * np.sin(v)
    x, y = draw(st.floats(-1000, 1000)), draw(st.floats(-1000, 1000))
    return np.array([[c, -s * mirror, x], [s, c * mirror, y], [0, 0, 1]]), scale


@few
@given(star_polygons(), st.floats(-0.8, 1.5))
def test_offset_polygons_agree_with_shapely(points, d):
    polygon = shapely.Polygon(points)
    reference = polygon.buffer(d, quad_segs=256, join_style="round")
    assume(polygon.area > 1 and reference.geom_type == "Polygon" and not reference.is_empty)
    try:
        moved = offset_path(Path.polygon(points), d)
    except InputError:
        # what is refused has lost an edge, which shapely passes over
        assert len(shapely.get_coordinates(polygon.buffer(d, join_style="mitre"))) != len(points) + 1
        return
    assert abs(moved.area - reference.area) < 1e-5 * reference.area + 1e-9
    assert abs(moved.length - reference.length) < 1e-4 * reference.length + 1e-9


@few
@given(star_polygons(), similarities(), st.floats(0.05, 0.3), st.booleans())
def test_offsetting_and_moving_can_be_exchanged(points, moved, d, backwards):
    matrix, scale = moved
    path = Path.polygon(points)
    try:
        first = offset_path(path, d).transformed(matrix)
    except InputError:
        assume(False)
    other = path.reversed() if backwards else path
    second = offset_path(other.transformed(matrix), d * scale)
    assert abs(abs(second.area) - abs(first.area)) < 1e-9 * abs(first.area)
    assert abs(second.length - first.length) < 1e-9 * first.length


@st.composite
def smooth_loops(draw):
    """A closed spline about the origin, C2 but for its start."""
    n = 8
    radii = np.array(draw(st.lists(st.floats(16, 20), min_size=n, max_size=n)))
    v = 2 * np.pi * np.arange(n) / n
    ring = radii[:, None] * np.column_stack([np.cos(v), np.sin(v)])
    # a periodic spline cut open: three points repeated, uniform knots without clamping
    points = np.vstack([ring, ring[:3]])
    return Path([Spline(PlaneCurve(np.arange(len(points) + 4.0), points, 3))], closed=True)


@pytest.mark.campaign
@few
@given(smooth_loops(), st.floats(-1.5, 1.5))
def test_smooth_loops_obey_steiners_formula(loop, d):
    moved = offset_path(loop, d, tolerance=1e-5)
    assert abs(moved.area - (loop.area + d * loop.length + np.pi * d**2)) < 1e-5 * loop.length
    assert len(moved.segments) == (1 if d else len(loop.segments))


@pytest.mark.campaign
@few
@given(smooth_loops(), st.floats(1e-3, 0.3))
def test_conversions_keep_area_and_length(loop, tolerance):
    for convert in (as_arcs, as_polyline):
        rough = convert(loop, tolerance)
        assert rough.closed
        assert abs(rough.area - loop.area) <= tolerance * loop.length
        assert rough.length <= loop.length * 1.01


@few
@given(star_polygons(), similarities(), unit)
def test_area_and_length_scale(points, moved, bulge):
    matrix, scale = moved
    path = Path.polyline(points, np.full(len(points), 0.3 * bulge), closed=True)
    image = path.transformed(matrix)
    assert abs(abs(image.area) - abs(path.area) * scale**2) < 1e-6 * image.length
    assert abs(image.length - path.length * scale) < 1e-6
    low, high = image.bounds
    points = image.points(0.1)
    assert np.all(points >= low - 1e-9)
    assert np.all(points <= high + 1e-9)
