"""Compiled places on curves, asked a few at a time, beside their twins in Python."""

import numpy as np
import pytest

from elastica_cad.geometry.paths import path_intersections
from elastica_cad.geometry.polynomials import spline_function
from elastica_cad.geometry.polynomials.spline_function import SplineFunction
from tests.unit.test_compiled_twins import SEEDS, both

__all__ = ["both"]


@pytest.mark.parametrize("size", [1.0, 30.0])
@pytest.mark.parametrize("seed", SEEDS)
def test_chords_that_may_cross(both, seed, size):
    """Boxes that touch are pairs too; more pairs than there is room for at first, and none."""
    rng = np.random.default_rng(seed)
    p, q = (rng.integers(0, 20, (count, 2)) * size / 7 for count in (40, 1 + 10 * seed))
    for a, b in ((p, q), (p, p), (p, q + 1e3), (p[:, ::-1], q)):
        compiled, plain = both(path_intersections, lambda: path_intersections._candidate_pairs(a, b))  # noqa: B023
        np.testing.assert_array_equal(compiled, plain)


@pytest.mark.parametrize("degree", [1, 2, 3, 5])
@pytest.mark.parametrize("seed", SEEDS)
def test_values_of_a_spline(both, seed, degree):
    """The same digits, at knots and beyond the ends too, of one place, of none and of rows of them."""
    rng = np.random.default_rng(seed)
    inner = np.sort(rng.choice(rng.random(6), 8))
    knots = np.concatenate([np.zeros(degree + 1), inner, np.ones(degree + 1)])
    spline = SplineFunction.of(knots, rng.normal(size=knots.size - degree - 1), degree)
    places = np.concatenate([knots, rng.uniform(-0.5, 1.5, 40)])
    for x in (places, places[:8].reshape(4, 2).T, np.array(0.3), np.zeros((0, 3))):
        compiled, plain = both(spline_function, lambda x=x: spline(x))
        assert compiled.shape == x.shape
        np.testing.assert_array_equal(compiled, plain)
