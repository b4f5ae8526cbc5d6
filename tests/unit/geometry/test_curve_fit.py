import numpy as np
import pytest

from elastica_cad import PlaneCurve

pytestmark = pytest.mark.core


def sine(count=401):
    x = np.linspace(0, 300, count)
    return np.column_stack([x, 40 * np.sin(x / 40)])


def sine_curvature(x):
    return -np.sin(x / 40) / 40 / (1 + np.cos(x / 40) ** 2) ** 1.5


def ellipse(count=401):
    v = np.linspace(0.2, 2.7, count)
    return np.column_stack([200 * np.cos(v), 100 * np.sin(v)])


def ellipse_curvature(points):
    v = np.arctan2(points[:, 1], points[:, 0] / 2)
    return 2 / 100 / (4 * np.sin(v) ** 2 + np.cos(v) ** 2) ** 1.5


def distances(curve, points):
    """Distances of points to a dense polyline on the curve, by brute force."""
    dense = curve.sample(6001).position
    a, b = dense[:-1], dense[1:]
    ab = b - a
    out = []
    for p in points:
        u = np.clip(((p - a) * ab).sum(axis=1) / (ab**2).sum(axis=1), 0, 1)
        out.append(np.hypot(*(a + u[:, None] * ab - p).T).min())
    return np.array(out)


@pytest.mark.parametrize("degree", [3, 4, 5])
@pytest.mark.parametrize("tolerance", [1.0, 0.05, 1e-3])
def test_points_lie_within_the_tolerance_and_the_ends_are_met(degree, tolerance):
    for points in (sine(201), ellipse(150)):
        curve = PlaneCurve.fit(points, degree=degree, tolerance=tolerance)
        assert curve.degree == degree
        assert distances(curve, points).max() <= tolerance + 3e-5
        ends = curve.evaluate(np.array(curve.domain))
        np.testing.assert_allclose(ends, points[[0, -1]], atol=1e-12)


@pytest.mark.parametrize("tolerance", [60.0, 30.0, 20.0, 10.0, 2.0, 0.5])
def test_a_drawn_shape_is_followed_to_a_third_of_the_tolerance(tolerance):
    """Also where the first curve that is tried lies between a third and the whole of it."""
    curve = PlaneCurve.fit(sine(), tolerance=tolerance)
    assert distances(curve, sine()).max() <= tolerance / 3


def test_few_control_points():
    assert len(PlaneCurve.fit(sine(), tolerance=0.05).control_points) <= 20
    assert len(PlaneCurve.fit(sine(), tolerance=1e-4).control_points) <= 60
    assert len(PlaneCurve.fit(ellipse(), tolerance=0.05).control_points) <= 15
    line = np.column_stack([np.linspace(0, 50, 40), np.linspace(3, 9, 40)])
    fitted = PlaneCurve.fit(line)
    assert len(fitted.control_points) == 5
    assert fitted.is_straight


def test_noise_free_points_give_the_curvature_too():
    curve = PlaneCurve.fit(sine(), tolerance=1e-4)
    places = curve.sample(300)
    wanted = sine_curvature(places.position[:, 0])
    assert np.abs(places.curvature - wanted).max() < 1e-3 * np.abs(wanted).max()
    np.testing.assert_allclose(
        curve.evaluate(curve.parameter(curve.inflections[-2:]))[:, 0],
        40 * np.pi * np.array([1, 2]),
        atol=0.01,
    )
    curve = PlaneCurve.fit(ellipse(), tolerance=1e-4)
    places = curve.sample(300)
    wanted = ellipse_curvature(places.position)
    off = np.abs(places.curvature - wanted) / wanted.max()
    assert off[10:-10].max() < 5e-4
    assert off.max() < 3e-3


@pytest.mark.parametrize("count", [20, 50, 100, 400, 2000])
@pytest.mark.parametrize("seed", [1, 2])
def test_noise_well_below_the_tolerance_makes_no_wiggles(count, seed):
    noise = np.random.default_rng(seed).normal(scale=0.01, size=(count, 2))
    curve = PlaneCurve.fit(sine(count) + noise, tolerance=0.1)
    inside = curve.inflections[(curve.inflections > 5) & (curve.inflections < curve.length - 5)]
    assert len(inside) == 2
    x = curve.evaluate(curve.parameter(inside))[:, 0]
    np.testing.assert_allclose(x, 40 * np.pi * np.array([1, 2]), atol=3)


def test_a_noisy_arc_has_no_inflection():
    v = np.linspace(0, 2.5, 200)
    noise = np.random.default_rng(3).normal(scale=0.02, size=(200, 2))
    curve = PlaneCurve.fit(100 * np.column_stack([np.cos(v), np.sin(v)]) + noise, tolerance=0.1)
    assert curve.inflections.size == 0
    np.testing.assert_allclose(curve.sample(50).curvature, 0.01, rtol=0.1)


def test_smoothing_pulls_towards_a_parabola():
    points = sine(60) + np.random.default_rng(4).normal(scale=0.2, size=(60, 2))
    wild = PlaneCurve.fit(points, tolerance=0.05)
    calm = PlaneCurve.fit(points, tolerance=0.05, smoothing=1e-7)
    flat = PlaneCurve.fit(points, tolerance=0.05, smoothing=1e6)

    def bending(curve):
        return (curve.sample(500).curvature ** 2).mean()

    assert bending(wild) > bending(calm) > bending(flat)
    assert flat.inflections.size == 0


@pytest.mark.parametrize("degree", [3, 4, 5])
@pytest.mark.parametrize("count", [2, 3, 4, 5, 6, 7, 9])
def test_few_points_are_all_met(count, degree):
    points = np.random.default_rng(count).uniform(0, 10, (count, 2)) + 12 * np.arange(count)[:, None]
    curve = PlaneCurve.fit(points, degree=degree, tolerance=1e-3)
    assert curve.degree == degree
    assert distances(curve, points).max() < 2e-3
    if count == 2:
        assert curve.is_straight


@pytest.mark.parametrize("seed", range(12))
def test_random_walks_are_followed(seed):
    rng = np.random.default_rng(seed)
    points = np.cumsum(rng.normal(scale=10, size=(rng.integers(5, 30), 2)), axis=0)
    curve = PlaneCurve.fit(points)
    assert distances(curve, points).max() < 0.06


def test_repeated_points_are_taken_once():
    points = np.repeat(sine(50), 2, axis=0)
    np.testing.assert_allclose(PlaneCurve.fit(points).control_points, PlaneCurve.fit(sine(50)).control_points)


def test_points_far_from_the_origin_and_of_any_size():
    near = PlaneCurve.fit(sine(100), tolerance=0.01)
    far = PlaneCurve.fit(sine(100) * 1e3 + [1e6, -1e6], tolerance=10)
    assert len(far.control_points) == len(near.control_points)
    np.testing.assert_allclose(far.control_points, near.control_points * 1e3 + [1e6, -1e6], atol=0.1)


def test_a_function_is_followed_in_its_own_parameter():
    def helix(v):
        return np.column_stack([50 * np.cos(v), 20 * np.sin(2 * v)])

    curve = PlaneCurve.fit_function(helix, 0.5, 5.0, tolerance=1e-8)
    v = np.linspace(0.5, 5, 301)
    assert curve.domain == (0.5, 5.0)
    assert np.abs(curve.evaluate(v) - helix(v)).max() < 1e-8


def test_a_function_with_a_corner():
    def corner(v):
        return np.column_stack([v, np.abs(v)])

    curve = PlaneCurve.fit_function(corner, -10, 10, breaks=[(0.0, 0)])
    assert [round(b.angle, 6) for b in curve.tangent_breaks] == [round(np.pi / 2, 6)]
