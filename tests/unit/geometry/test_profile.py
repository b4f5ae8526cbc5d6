import numpy as np
import pytest
from scipy.interpolate import BSpline

from elastica_cad import InputError, NotConvergedError, PlaneCurve, Profile

pytestmark = pytest.mark.core


def bump(s):
    return 1 + np.exp(-(((s - 150) / 40) ** 2)) + 0.3 * np.sin(s / 30)


@pytest.mark.parametrize("tolerance", [1e-2, 1e-5, 1e-7])
@pytest.mark.parametrize("degree", [3, 4, 5])
def test_a_smooth_function_is_followed(tolerance, degree):
    profile = Profile.fit(bump, 300.0, tolerance=tolerance, degree=degree)
    s = np.linspace(0, 300, 5001)
    assert np.abs(profile(s) - bump(s)).max() < 1.1 * tolerance
    assert profile.length == 300
    assert profile.degree == degree


def test_knots_are_spent_where_they_are_needed():
    def steep(s):
        return np.tanh((s - 20) / 0.5)

    profile = Profile.fit(steep, 100.0, tolerance=1e-6)
    inner = np.unique(profile.knots)
    assert np.count_nonzero(np.abs(inner - 20) < 10) > 0.8 * inner.size
    assert profile.coefficients.size < 250


def test_cubics_are_exact_with_the_fewest_coefficients():
    profile = Profile.fit(lambda s: 1 + s**3 / 1e3, 10.0)
    assert profile.coefficients.size == 4
    np.testing.assert_allclose(profile(np.array([0, 3.0, 10])), [1, 1.027, 2], rtol=1e-13)
    np.testing.assert_allclose(profile(np.array([2.0]), 2), [12e-3], rtol=1e-10)


def test_a_kink_stays_a_kink():
    profile = Profile.fit(lambda s: 2 + np.abs(s - 40) / 10, 100.0, breaks=[(40.0, 0)])
    assert np.count_nonzero(profile.knots == 40) == 3
    assert profile.coefficients.size == 4 + 3
    assert profile(40.0) == pytest.approx(2)
    assert profile.extremes == pytest.approx((2, 8))
    np.testing.assert_allclose(profile(np.array([39.9, 40.1]), 1), [-0.1, 0.1], rtol=1e-9)


def test_a_curvature_kink_takes_a_double_knot():
    def smooth_kink(s):
        return 1 + np.maximum(s - 30, 0) ** 2 / 100

    profile = Profile.fit(smooth_kink, 100.0, breaks=[(30.0, 1)])
    assert np.count_nonzero(profile.knots == 30) == 2
    assert profile.coefficients.size == 4 + 2


def test_a_jump_stays_a_jump_and_both_sides_count():
    def step(s):
        return np.where(s < 60, 1 + s / 60, 0.5 + s / 100)

    profile = Profile.fit(step, 100.0, breaks=[(60.0, -1)])
    assert np.count_nonzero(profile.knots == 60) == 4
    assert profile.extremes == pytest.approx((1, 2))
    assert float(profile(np.nextafter(60.0, 0))) == pytest.approx(2)
    assert profile.extreme_places == pytest.approx((0.0, 60.0))
    assert float(profile(60.0)) == pytest.approx(1.1)


def test_breaks_may_repeat_touch_the_ends_and_be_smooth():
    profile = Profile.fit(
        lambda s: 2 + np.abs(s - 40) / 10,
        100.0,
        breaks=[(40.0, 2), (40.0 + 1e-12, 0), (0.0, -1), (100.0, 0), (70.0, 5), (-3.0, 0)],
    )
    assert np.count_nonzero(np.abs(profile.knots - 40) < 1e-9) == 3
    assert np.count_nonzero(profile.knots == 70) == 1


@pytest.mark.parametrize("apart", [4e-8, 2e-7, 9e-6])
def test_breaks_a_hair_apart_leave_the_rest_alone(apart):
    """Knots of a curve and of a width may all but coincide: the span between them could not be solved for."""
    places = np.linspace(0, 300, 21)[1:-1]
    breaks = [(s + d, 1) for s in places for d in (0.0, apart)]
    profile = Profile.fit(bump, 300.0, breaks=breaks, tolerance=1e-7)
    s = np.linspace(0, 300, 5001)
    assert np.abs(profile(s) - bump(s)).max() < 1.1e-7


def test_the_rougher_of_two_near_breaks_keeps_its_place():
    def kinked(s):
        return 2 + np.abs(s - 40) / 10

    for order in (1, -1):
        breaks = [(40.0, 0), (40.0 + order * 4e-6, 1)]
        profile = Profile.fit(kinked, 100.0, breaks=breaks, tolerance=1e-9)
        assert profile(40.0) == pytest.approx(2, abs=1e-12)
        assert np.count_nonzero(np.abs(profile.knots - 40) < 1e-3) == 3


@pytest.mark.parametrize("place", [37.3, 50.0])
def test_an_undeclared_jump_or_kink_is_refused_with_its_place(place):
    with pytest.raises(NotConvergedError, match=f"near {place:.4g}"):
        Profile.fit(lambda s: np.where(s < place, 1.0, 2.0), 100.0)


def test_an_undeclared_kink_within_the_tolerance_is_followed():
    profile = Profile.fit(lambda s: 1 + np.abs(s - 37.3) / 100, 100.0, tolerance=1e-4)
    assert profile.extremes[0] == pytest.approx(1, abs=1e-4)


def test_extremes_are_those_of_the_spline():
    rng = np.random.default_rng(8)
    for _ in range(20):
        knots = np.concatenate([[0.0] * 4, np.sort(rng.uniform(0, 10, 9)), [10.0] * 4])
        coefficients = rng.normal(size=13)
        profile = Profile(knots, coefficients)
        dense = BSpline(knots, coefficients, 3)(np.linspace(0, 10, 20001))
        low, high = profile.extremes
        assert low <= dense.min() <= low + 1e-3
        assert high >= dense.max() >= high - 1e-3


def test_constant_profiles():
    profile = Profile.fit(lambda s: np.full(s.shape, 3.0), 10.0)
    assert profile.extremes == pytest.approx((3, 3))


def test_interpolation_meets_the_values():
    s = np.array([0.0, 1, 3, 4, 8, 10])
    values = np.array([1.0, 2, 1.5, 1, 4, 3])
    np.testing.assert_allclose(Profile.interpolate(s, values)(s), values)
    line = Profile.interpolate([0, 10], [1, 3])
    assert line.degree == 3
    np.testing.assert_allclose(line(np.array([0, 2.5, 10])), [1, 1.5, 3])
    parabola = Profile.interpolate([0, 5, 10], [0, 25, 100])
    np.testing.assert_allclose(parabola(np.array([1.0, 7])), [1, 49], atol=1e-12)


def test_the_graph_is_a_spline_curve():
    profile = Profile.fit(bump, 300.0, tolerance=1e-5)
    curve = PlaneCurve(profile.knots, np.column_stack([profile.greville, profile.coefficients]), 3)
    t = np.linspace(0, 300, 200)
    np.testing.assert_allclose(curve.evaluate(t), np.column_stack([t, profile(t)]), atol=1e-11)


def test_scaled():
    profile = Profile.fit(bump, 300.0)
    np.testing.assert_allclose(
        profile.scaled(2.5)(np.array([10.0, 200])), 2.5 * bump(np.array([10.0, 200])), rtol=1e-6
    )
    assert profile.scaled(-1.0).extremes == pytest.approx(tuple(-e for e in reversed(profile.extremes)))


def test_stretched_knows_its_extremes_and_values():
    """What it takes over from the profile before is what it would find for itself."""
    profile = Profile.fit(bump, 300.0)
    profile(0.0)
    stretched = profile.stretched(2.0, 7.0)
    assert stretched.extremes == pytest.approx((2.0, 7.0), rel=1e-14)
    assert stretched.extreme_places == pytest.approx(profile.extreme_places, rel=1e-7)
    anew = Profile(stretched.knots, stretched.coefficients)
    assert anew.extremes == pytest.approx((2.0, 7.0), rel=1e-14)
    s = np.linspace(0, 300, 301)
    np.testing.assert_allclose(stretched(s), anew(s), rtol=1e-14)


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: Profile([0, 0, 0, 0, 1, 1, 1, 1], [1, 2, np.nan, 3]), "coefficients holds NaN"),
        (lambda: Profile([0, 0, 0, 0, 1, 1, 1, 1], [1, 2, 3]), "give 7 knots"),
        (lambda: Profile([0, 0, 0, 1, 0, 1, 1, 1], [1, 2, 3, 4]), "give knots that never decrease"),
        (lambda: Profile(np.arange(8.0), [1, 2, 3, 4]), "clamped"),
        (lambda: Profile([[0, 1]], [1]), "row of numbers"),
        (lambda: Profile.fit(bump, 0.0), "give a number above 0"),
        (lambda: Profile.fit(bump, np.nan), "give a number above 0"),
        (lambda: Profile.fit(lambda s: 1 / (s - s), 10.0), "not finite at"),
        (lambda: Profile.fit(lambda s: 1.0, 10.0), "a value for each"),
        (lambda: Profile.interpolate([0, 0], [1, 2]), "increasing arc lengths"),
        (lambda: Profile.interpolate([0], [1]), "two or more"),
        (lambda: Profile.interpolate([0, 1], [1, np.nan]), "NaN"),
    ],
)
@pytest.mark.filterwarnings("ignore:divide by zero:RuntimeWarning")
def test_bad_input(make, words):
    with pytest.raises(InputError, match=words):
        make()


def test_extremes_inside_are_placed():
    profile = Profile.fit(lambda s: 2 + np.sin(s / 10), 60.0, tolerance=1e-9)
    assert profile.extreme_places == pytest.approx((15 * np.pi, 5 * np.pi), abs=1e-2)
    assert profile.extremes == pytest.approx((1, 3), abs=1e-8)


@pytest.mark.parametrize("tolerance", np.geomspace(1e-6, 1e-3, 30))
def test_every_tolerance_is_reached_beside_kinks(tolerance):
    """A wide span that just meets the tolerance must not spoil narrow ones beside it."""

    def peak(s):
        return 1 / (1 + ((s - 91) / 3) ** 2) + 2e-3 * np.abs(s - 90)

    profile = Profile.fit(peak, 184.0, breaks=[(90.0, 0), (92.18, 1)], tolerance=tolerance)
    s = np.linspace(0.0, 184.0, 4001)
    assert np.abs(profile(s) - peak(s)).max() < 1.5 * tolerance


@pytest.mark.parametrize(
    ("coefficients", "degree", "lowest", "highest"),
    [
        ([0.0, 4.0], 1, (0.0, 0.0), (30.0, 4.0)),
        ([0.0, 4.0, 0.0], 2, (0.0, 0.0), (15.0, 2.0)),
        ([1.0, -1.0, -1.0, 3.0, 1.0], 4, None, None),
    ],
)
def test_extremes_lie_at_ends_and_between_in_every_degree(coefficients, degree, lowest, highest):
    profile = Profile(np.repeat([0.0, 30.0], degree + 1), np.array(coefficients), degree)
    s = np.linspace(0, 30, 30001)
    values = profile(s)
    assert profile.extremes == pytest.approx((values.min(), values.max()), abs=1e-7)
    assert profile.extreme_places == pytest.approx((s[values.argmin()], s[values.argmax()]), abs=1e-2)
    if lowest is not None:
        assert list(zip(profile.extreme_places, profile.extremes, strict=True)) == [lowest, highest]


def test_where_a_function_is_not_finite_is_reported():
    with np.errstate(divide="ignore"), pytest.raises(InputError, match="not finite at") as result:
        Profile.fit(lambda s: 1 / np.maximum(s - 150.0, 0.0), 300.0)
    assert 0 <= float(str(result.value).split(":")[0].split()[-1]) <= 150
    with np.errstate(invalid="ignore"), pytest.raises(InputError, match="not finite at") as result:
        Profile.fit(lambda s: np.sqrt(299.9 - s), 300.0)
    assert float(str(result.value).split(":")[0].split()[-1]) > 299.9
