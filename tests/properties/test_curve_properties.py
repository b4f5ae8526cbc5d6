"""Move, turn, scale, mirror, project or reverse a curve, and every answer follows."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from elastica_cad import InputError, PlaneCurve
from elastica_cad.geometry import line_crossings

pytestmark = pytest.mark.core

EXAMPLES = settings(max_examples=25, deadline=None)


@st.composite
def curves(draw, rational=None):
    degree = draw(st.integers(2, 5))
    count = draw(st.integers(degree + 1, degree + 6))
    whole = st.integers(-20, 20)
    points = np.array(draw(st.lists(st.tuples(whole, whole), min_size=count, max_size=count)), float)
    steps = draw(st.lists(st.integers(1, 4), min_size=count + degree, max_size=count + degree))
    knots = np.concatenate([[0], np.cumsum(steps)]).astype(float)
    if draw(st.booleans()):
        knots[: degree + 1], knots[-degree - 1 :] = knots[degree], knots[-degree - 1]
    weights = None
    if rational or (rational is None and draw(st.booleans())):
        weights = np.array(draw(st.lists(st.integers(1, 4), min_size=count, max_size=count)), float)
    try:
        curve = PlaneCurve(knots, points, degree, weights)
    except InputError:
        assume(False)
    # leave out curves that all but stand still somewhere: their curvature is beyond any tolerance
    speed = np.hypot(*curve.evaluate(np.linspace(*curve.domain, 2000), 1).T)
    assume(speed.min() > 1e-2 * speed.max())
    return curve


def steady_zeros(curve):
    """Parameters and signs of curvature zeros, of curves whose zeros are no near coincidences."""
    found = curve.curvature_zeros
    assume(all(z.kind == "crossing" for z in found))
    t = np.array([z.t for z in found])
    a, b = curve.domain
    assume(np.all(np.diff([a, *t, b]) > 1e-4 * (b - a)))
    slope = np.abs(curve.curvature_slope_at(t))
    assume(np.all(slope * curve.length**2 > 1e-3))
    return t, [(z.before, z.after) for z in found]


@EXAMPLES
@given(curves(), st.floats(-3, 3), st.integers(-1000, 1000), st.floats(0.01, 100), st.booleans())
def test_similar_curves(curve, turn, shift, scale, mirrored):
    c, s, m = np.cos(turn) * scale, np.sin(turn) * scale, -1 if mirrored else 1
    image = curve.transformed([[c, -s * m, shift], [s, c * m, -shift], [0, 0, 1]])
    tolerance = 1e-9 * (1 + abs(shift) / curve.length / scale)
    np.testing.assert_allclose(image.length, curve.length * scale, rtol=tolerance)
    t = np.linspace(*curve.domain, 30)
    kappa = curve.curvature_at(t)
    np.testing.assert_allclose(
        image.curvature_at(t) * scale * m, kappa, rtol=1e-6, atol=1e-6 * np.abs(kappa).max()
    )
    angle = curve.angle_at(t) - curve.angle_at(t[0])
    np.testing.assert_allclose((image.angle_at(t) - image.angle_at(t[0])) * m, angle, atol=1e-7)
    zeros, signs = steady_zeros(curve)
    found = image.curvature_zeros
    np.testing.assert_allclose([z.t for z in found], zeros, atol=1e-6 * t[-1])
    assert [(z.before * m, z.after * m) for z in found] == signs


@EXAMPLES
@given(curves())
def test_reversed_curves(curve):
    back = curve.reversed()
    np.testing.assert_allclose(back.length, curve.length, rtol=1e-12)
    s = np.linspace(0, curve.length, 21)
    there, again = curve.at(s), back.at(curve.length - s)
    np.testing.assert_allclose(again.position, there.position, atol=1e-8)
    turned = there.angle - there.angle[0]
    np.testing.assert_allclose(again.angle - again.angle[0], turned, atol=1e-6)
    first, _ = steady_zeros(curve)
    mirrored = curve.length - back.inflections[::-1]
    np.testing.assert_allclose(mirrored, curve.arc_length(first), atol=1e-6 * curve.length)


@pytest.mark.campaign
@EXAMPLES
@given(curves(), st.lists(st.floats(-0.3, 0.3), min_size=6, max_size=6))
def test_projective_images_keep_zeros_and_crossings(curve, numbers):
    p, q = np.array(numbers[4:]) / 30
    matrix = np.array([[1 + numbers[0], numbers[1], 3], [numbers[2], 1 + numbers[3], -2], [p, q, 1]])
    assume(np.linalg.det(matrix) > 0.1)
    size = np.abs(curve.control_points).max()
    assume((abs(p) + abs(q)) * size < 0.9)
    image = curve.transformed(matrix)
    zeros, signs = steady_zeros(curve)
    found = image.curvature_zeros
    np.testing.assert_allclose([z.t for z in found], zeros, atol=1e-6 * curve.domain[1])
    assert [(z.before, z.after) for z in found] == signs
    # the line a + <b, x> = 0 is the row (b, a), which maps by the inverse
    line = np.array([0.6, 0.8, -1.234])
    moved = line @ np.linalg.inv(matrix)
    before = line_crossings(curve, line[2], line[:2])
    after = line_crossings(image, moved[2], moved[:2])
    assume(all(c.kind == "crossing" for c in before))
    t = np.array([c.t for c in before])
    slope = curve.evaluate(t, 1) @ line[:2] if t.size else np.ones(1)
    assume(np.all(np.abs(slope) > 1e-3))
    np.testing.assert_allclose([c.t for c in after], t, atol=1e-6 * curve.domain[1])


@EXAMPLES
@given(curves())
def test_arc_length_inverts_and_is_longer_than_the_chord(curve):
    s = np.linspace(0, curve.length, 101)
    np.testing.assert_allclose(curve.arc_length(curve.parameter(s)), s, atol=1e-11 * curve.length)
    points = curve.at(s).position
    chords = np.hypot(*np.diff(points, axis=0).T)
    assert np.all(chords <= curve.length / 100 * (1 + 1e-9))


@EXAMPLES
@given(curves())
def test_no_sign_change_of_curvature_is_missed(curve):
    t = np.linspace(*curve.domain, 3001)
    kappa = curve.curvature_at(t)
    firm = np.abs(kappa) > 1e-9 / curve.length
    sign = np.sign(kappa[firm])
    seen = np.flatnonzero(sign[:-1] != sign[1:])
    changes = [z for z in curve.curvature_zeros if z.changes_sign]
    places = np.array([(z.t + z.t_end) / 2 for z in changes])
    low, high = t[firm][seen], t[firm][seen + 1]
    for a, b in zip(low, high, strict=True):
        inside = (places >= a - 1e-9) & (places <= b + 1e-9)
        assert inside.sum() % 2 == 1
    assert len(changes) >= len(seen)
    # and none is invented: the sign told on either side is the sign that is there
    ends = np.array([z.t for z in curve.curvature_zeros] + [curve.domain[1]])
    for z, following in zip(curve.curvature_zeros, ends[1:], strict=True):
        middle = (z.t_end + following) / 2
        if abs(curve.curvature_at(middle)) > 1e-9 / curve.length:
            assert np.sign(curve.curvature_at(middle)) == z.after


@EXAMPLES
@given(curves())
def test_angle_is_the_direction_of_the_velocity_and_grows_by_curvature(curve):
    t = np.linspace(*curve.domain, 200)
    angle = curve.angle_at(t)
    velocity = curve.evaluate(t, 1)
    direction = np.column_stack([np.cos(angle), np.sin(angle)])
    np.testing.assert_allclose(
        direction * np.hypot(*velocity.T)[:, None], velocity, atol=1e-9 * np.abs(velocity).max()
    )
    assert abs(angle[0]) <= np.pi + 1e-12
    x, w = np.polynomial.legendre.leggauss(40)
    edges = np.unique([*t, *(b.t for b in curve.breaks)])
    at = (edges[:-1, None] + np.diff(edges)[:, None] * (1 + x) / 2).ravel()
    speed = np.hypot(*curve.evaluate(at, 1).T)
    turned = (curve.curvature_at(at) * speed * np.outer(np.diff(edges) / 2, w).ravel()).sum()
    corners = sum(b.angle for b in curve.tangent_breaks)
    np.testing.assert_allclose(angle[-1] - angle[0], turned + corners, atol=1e-5)


@EXAMPLES
@given(curves())
def test_every_self_intersection_is_one_point(curve):
    pairs = curve.self_intersections()
    assert pairs.shape[1:] == (2,)
    if pairs.size:
        assert np.all(pairs[:, 0] < pairs[:, 1])
        p, q = curve.at(pairs[:, 0]).position, curve.at(pairs[:, 1]).position
        np.testing.assert_allclose(p, q, atol=1e-6 * curve.length)


@EXAMPLES
@given(curves())
def test_crossings_of_a_polyline_with_itself_are_found(curve):
    """Wherever a dense polyline crosses itself clearly, the curve does."""
    points = curve.evaluate(np.linspace(*curve.domain, 241))
    a, d = points[:-1], np.diff(points, axis=0)
    i, j = np.triu_indices(len(a), 2)
    cross = d[i, 0] * d[j, 1] - d[i, 1] * d[j, 0]
    sizes = np.hypot(*d[i].T) * np.hypot(*d[j].T)
    with np.errstate(divide="ignore", invalid="ignore"):
        gap = a[j] - a[i]
        u = (gap[:, 0] * d[j, 1] - gap[:, 1] * d[j, 0]) / cross
        v = (gap[:, 0] * d[i, 1] - gap[:, 1] * d[i, 0]) / cross
    clear = (np.abs(cross) > 0.1 * sizes) & (j - i > 4) & (u > 0.3) & (u < 0.7) & (v > 0.3) & (v < 0.7)
    step = (curve.domain[1] - curve.domain[0]) / 240
    found = curve.parameter(curve.self_intersections()) - curve.domain[0]
    for k in np.flatnonzero(clear):
        near = np.abs(found - np.array([i[k] + u[k], j[k] + v[k]]) * step).max(axis=1)
        assert near.size
        assert near.min() < 2 * step


@EXAMPLES
@given(curves(), st.floats(0.05, 0.95))
def test_no_crossing_of_a_curvature_level_is_missed(curve, share):
    t = np.linspace(*curve.domain, 3001)
    kappa = curve.curvature_at(t)
    low, high = np.quantile(kappa, [0.1, 0.9])
    level = float(low + share * (high - low))
    assume(high - low > 1e-6 / curve.length)
    assume(abs(level) * curve.length > 1e-3)
    off = kappa - level
    firm = np.abs(off) > 1e-6 * np.abs(kappa).max()
    sign = np.sign(off[firm])
    seen = np.flatnonzero(sign[:-1] != sign[1:])
    found = curve.curvature_equals(level)
    places = np.array([(z.t + z.t_end) / 2 for z in found if z.changes_sign])
    for a, b in zip(t[firm][seen], t[firm][seen + 1], strict=True):
        assert ((places >= a - 1e-9) & (places <= b + 1e-9)).sum() % 2 == 1
    for z in found:
        if z.kind in ("crossing", "touch", "end"):
            ours = [curve.curvature_at(z.t), curve.curvature_at(z.t, left=True)]
            assert np.abs(np.array(ours) - level).min() < 1e-5 * np.abs(kappa).max()
