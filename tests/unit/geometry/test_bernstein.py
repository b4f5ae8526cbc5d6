from math import comb

import numpy as np
import pytest

from elastica_cad.geometry import polynomials as bernstein

pytestmark = pytest.mark.core


def from_roots(roots, scale=1.0):
    """Bernstein coefficients of scale times the product of (u - root)."""
    c = np.array([scale])
    for root in roots:
        c = bernstein.product(c, np.array([-root, 1.0 - root]))
    return c


def value(c, u):
    n = len(c) - 1
    return sum(c[i] * comb(n, i) * u**i * (1 - u) ** (n - i) for i in range(n + 1))


def test_product_elevation_and_split_keep_the_polynomial():
    rng = np.random.default_rng(1)
    a, b = rng.normal(size=5), rng.normal(size=4)
    u = np.linspace(0, 1, 9)
    np.testing.assert_allclose(value(bernstein.product(a, b), u), value(a, u) * value(b, u))
    np.testing.assert_allclose(value(bernstein.raise_degree(a), u), value(a, u))
    left, right = bernstein.subdivide(a, 0.3)
    np.testing.assert_allclose(value(left, u), value(a, 0.3 * u))
    np.testing.assert_allclose(value(right, u), value(a, 0.3 + 0.7 * u))


def test_value_and_slope():
    rng = np.random.default_rng(2)
    c, u = rng.normal(size=(6, 5)), rng.uniform(size=6)
    values, slopes = bernstein.value_and_slope(c, u)
    h = 1e-6
    for k in range(6):
        assert values[k] == pytest.approx(value(c[k], u[k]))
        assert slopes[k] == pytest.approx((value(c[k], u[k] + h) - value(c[k], u[k] - h)) / (2 * h), abs=1e-7)


def test_a_root_at_an_end_is_divided_out():
    c = from_roots([0.0, 0.3, 1.0])
    inner = bernstein.divide_out_end_root(bernstein.divide_out_end_root(c, at_end=False), at_end=True)
    u = np.linspace(0.1, 0.9, 5)
    np.testing.assert_allclose(value(inner, u), -(u - 0.3), atol=1e-15)


@pytest.mark.parametrize("seed", range(20))
def test_all_roots_of_random_products(seed):
    rng = np.random.default_rng(seed)
    wanted = np.sort(rng.uniform(0.02, 0.98, rng.integers(0, 6)))
    wanted = wanted[np.concatenate([[True], np.diff(wanted) > 0.02])[: wanted.size]]
    outside = [*rng.uniform(1.1, 3, 2), *rng.uniform(-2, -0.1, 1)]
    c = from_roots([*wanted, *outside], scale=rng.normal())
    found = bernstein.roots(c[None], np.array([1e-15 * np.abs(c).max()]))
    np.testing.assert_allclose([r.u for r in found], wanted, atol=1e-11)
    assert all(r.crossing for r in found)


def test_multiple_roots():
    for roots, crossing in (([0.4, 0.4], False), ([0.4] * 3, True), ([0.4] * 4, False)):
        c = from_roots([*roots, 1.5])
        (root,) = bernstein.roots(c[None], np.array([1e-15]))
        assert root.crossing is crossing
        assert root.u == pytest.approx(0.4, abs=1e-3)


def test_several_polynomials_at_once():
    c = np.array([from_roots([0.2, 0.7]), from_roots([1.2, 0.5]), from_roots([-1, 2])])
    found = bernstein.roots(c, np.full(3, 1e-15))
    assert [r.piece for r in found] == [0, 0, 1]
    np.testing.assert_allclose([r.u for r in found], [0.2, 0.7, 0.5])


def test_interior_roots_leave_out_the_ends():
    c = np.array([from_roots([0.0, 0.5, 1.0]), np.zeros(4)])
    (root,) = bernstein.interior_roots(c)
    assert (root.piece, root.u) == (0, pytest.approx(0.5))
