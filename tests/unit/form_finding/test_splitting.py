"""The fewest supports, against exhaustive search, and exact pieces."""

from itertools import combinations, pairwise

import numpy as np
import pytest

from elastica_cad import (
    InputError,
    NotRealizable,
    PlaneCurve,
    Supports,
    check_equilibrium,
    optimal_rod,
    split,
)

pytestmark = pytest.mark.core

TWICE = PlaneCurve.spline([(0, 0), (20, 60), (50, -60), (80, 60), (100, 80), (160, -90), (190, 20)], degree=4)


@pytest.mark.parametrize("more", [0, 1, 4])
def test_a_curve_is_split_into_a_number_of_strips(more):
    """Each piece can be made, and each support is in its range."""
    least = len(split(TWICE).pieces)
    found = split(TWICE, count=least + more)
    assert len(found.pieces) == least + more
    assert sum(piece.length for piece in found.pieces) == pytest.approx(TWICE.length)
    assert all(check_equilibrium(piece).realizable for piece in found.pieces)
    assert all(low <= at <= high for (low, high), at in zip(found.ranges, found.supports, strict=True))
    assert max(found.ratios) <= max(split(TWICE).ratios) * (1 + 1e-6)


def test_a_possible_curve_is_split_equally_and_too_few_strips_are_refused():
    arc = PlaneCurve.arc((0, 0), 100, 0, 2)
    assert split(arc, count=4).supports == pytest.approx((50, 100, 150))
    for count in (0, len(split(TWICE).pieces) - 1, 2.5, 10**400):
        with pytest.raises(InputError, match=r"a whole number of strips, \d to 1000"):
            split(TWICE, count=count)


def random_curve(seed, count=9):
    rng = np.random.default_rng(seed)
    steps = np.column_stack([rng.uniform(10, 30, count), rng.normal(0, 40, count)])
    return PlaneCurve.spline(np.cumsum(steps, axis=0), degree=4)


def fewest_of_grid(curve, count):
    """Least number of supports on a grid of parameters, by trying all sets of them."""
    t = np.linspace(*curve.domain, count + 2)
    fits = {
        (i, j): check_equilibrium(curve.trimmed(t[i], t[j]), tolerance=1e-4).realizable
        for i, j in combinations(range(count + 2), 2)
    }
    for supports in range(count):
        for chosen in combinations(range(1, count + 1), supports):
            if all(fits[pair] for pair in pairwise((0, *chosen, count + 1))):
                return supports
    raise AssertionError


@pytest.mark.parametrize("curve", [random_curve(3), random_curve(5)])
def test_no_fewer_supports_on_a_grid(curve):
    found = split(curve)
    assert len(found.supports) == fewest_of_grid(curve, 10)
    for piece, ratio in zip(found.pieces, found.ratios, strict=True):
        assert check_equilibrium(piece).realizable
        assert optimal_rod(piece).ratio == pytest.approx(ratio, rel=1e-6)


def test_pieces_are_exact_and_supports_within_their_ranges():
    curve = random_curve(5)
    found = split(curve)
    ends = [0.0, *found.supports, curve.length]
    for piece, (a, b) in zip(found.pieces, pairwise(ends), strict=True):
        assert piece.length == pytest.approx(b - a, abs=1e-7)
        s = np.linspace(0, piece.length, 50)
        expected = curve.at(np.clip(a + s, 0, curve.length))
        np.testing.assert_allclose(piece.at(s).position, expected.position, atol=1e-6)
        np.testing.assert_allclose(piece.at(s).angle % (2 * np.pi), expected.angle % (2 * np.pi), atol=1e-6)
    for s, (first, last) in zip(found.supports, found.ranges, strict=True):
        assert first <= s <= last
    assert f"{len(found.supports)} support" in str(found)


def test_ranges_are_where_a_single_support_can_stand():
    curve = random_curve(7)
    found = split(curve)
    assert len(found.supports) == 1
    (first, last), slack = found.ranges[0], 1e-3 * curve.length

    def fits(s):
        t = float(curve.parameter(np.array(s)))
        low, high = curve.domain
        return all(check_equilibrium(curve.trimmed(*ends)).realizable for ends in ((low, t), (t, high)))

    assert fits(first + slack)
    assert fits(last - slack)
    assert not fits(first - slack)
    assert not fits(last + slack)


def test_realizable_curves_need_none():
    found = split(PlaneCurve.ellipse((0, 0), (200, 100), start=0, end=np.pi))
    assert found.supports == ()
    assert found.ratios == pytest.approx([1.569936], abs=1e-5)
    assert "needs no support" in str(found)


def test_a_ratio_limit_requests_more():
    arch = PlaneCurve.ellipse((0, 0), (100, 200), start=0, end=np.pi)
    found = split(arch, ratio=1.8)
    assert optimal_rod(arch).ratio > 3.3
    assert 1 <= len(found.supports) <= 2
    assert max(found.ratios) <= 1.8


def test_a_closed_curve_needs_one_anywhere():
    found = split(PlaneCurve.ellipse((0, 0), (30, 20)))
    assert len(found.supports) == 1
    assert found.ranges[0][0] < 0.01 * found.ranges[0][1]
    assert max(found.ratios) < 4


def test_straight_pieces_and_corners_are_cut_where_they_end():
    knots = np.concatenate([np.zeros(5), np.full(4, 1.0), np.full(5, 2.0)])
    x = np.linspace(0, 40, 5)
    bent = [(50, 0), (60, 3), (80, 30), (90, 60)]
    curve = PlaneCurve(knots, [*((v, 0.0) for v in x), *bent], 4)
    found = split(curve)
    assert found.supports == pytest.approx([40.0], abs=1e-9)
    assert found.pieces[0].is_straight
    corner = PlaneCurve(
        np.array([0, 0, 0, 1, 1, 2, 2, 2.0]), [(0, 0), (20, 20), (40, 0), (60, 25), (80, 0)], 2
    )
    assert split(corner).supports == pytest.approx([corner.tangent_breaks[0].s])


def test_offered_places():
    curve = random_curve(7)
    (first, last) = split(curve).ranges[0]
    places = [first - 20, (first + last) / 2, last + 1]
    assert split(curve, places=places).supports == pytest.approx([(first + last) / 2])
    with pytest.raises(NotRealizable, match="Give another place between them"):
        split(curve, places=[first / 2])


def test_supports_of_the_ends():
    curve = random_curve(7)
    with pytest.raises(NotRealizable, match="free to turn"):
        split(curve, supports=Supports("pinned", "clamped"))
    zero = next(z.t for z in curve.curvature_zeros if z.kind == "crossing")
    rest = curve.trimmed(zero, curve.domain[1])
    found = split(rest, supports=Supports("pinned", "clamped"))
    assert check_equilibrium(found.pieces[0], Supports("pinned", "clamped")).realizable


def test_bad_input():
    touching = PlaneCurve(np.repeat([0.0, 1.0], 5), [(0, 40), (25, -40), (50, 40), (75, -40), (100, 40)], 4)
    for ratio in (0.5, np.nan, "2"):
        with pytest.raises(InputError, match="ratio"):
            split(touching, ratio=ratio)
    with pytest.raises(InputError, match="arc length"):
        split(touching, places=[1000.0])
    with pytest.raises(NotRealizable, match=r"Supports do not help .* from the start"):
        split(touching)


def test_a_curve_no_supports_help_says_so_where_large_terms_cancel():
    """Almost straight behind its bow: stiffnesses of 1e11 are taken from each other, which leaves rounding."""
    points = [(0, 0), (30, 60), (70, 60), (100, 0)]
    with pytest.raises(NotRealizable, match="curvature becomes 0 at 124"):
        split(PlaneCurve([0] * 4 + [1] * 4, points, 3, [1, 1e3, 1e-3, 1]), ratio=3.0)
