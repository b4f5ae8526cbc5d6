"""Compiled places on curves, asked a few at a time, beside their twins in Python."""

import numpy as np
import pytest

from elastica_cad.fabrication.interlocking import flush_strips, ruled_strip, slotted_collisions
from elastica_cad.fabrication.interlocking.ruled_strip import RuledStrip
from elastica_cad.fabrication.interlocking.slotted_collisions import SlotRims
from elastica_cad.fabrication.makeability import near_pairs
from elastica_cad.fabrication.slots.slot import Slot
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.paths import path_intersections
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.geometry.polynomials import spline_function
from elastica_cad.geometry.polynomials.spline_function import SplineFunction
from tests.unit.test_compiled_polynomials import drawn, ellipses
from tests.unit.test_compiled_twins import CLOSE, SEEDS, both, distance

__all__ = ["both"]


def ruled(curve):
    width = Profile.interpolate([0.0, curve.length], [10.0, 20.0])
    return RuledStrip(curve, Frame((1.0, 2.0, 3.0)), width)


@pytest.mark.parametrize("curve", [drawn, ellipses])
@pytest.mark.parametrize("seed", SEEDS)
def test_places_of_a_strip(both, seed, curve):
    """The same digits: at its nodes, between them, at both ends and a little beyond."""
    strip = ruled(curve(seed % 7))  # ellipses beyond are too far from their origin to be followed
    nodes, _ = strip.quintics
    between = np.random.default_rng(seed).uniform(-0.1, strip.length + 0.1, 300)
    s = np.concatenate([nodes, between, [-1.0, strip.length + 1.0]])
    compiled, plain = both(ruled_strip, lambda: strip.in_plane(s))
    np.testing.assert_array_equal(compiled, plain)
    both(ruled_strip, lambda: strip.in_plane(np.zeros(0)))


@pytest.mark.parametrize("count", [1, 7, 8, 200])
@pytest.mark.parametrize("seed", SEEDS)
def test_places_nearest_to_points(both, seed, count):
    """On the curve, beside it, far off and beyond its ends."""
    strip = ruled(drawn(seed))
    stations = np.sort(np.random.default_rng(seed).uniform(0, strip.length, count))
    chain, tangents = strip.in_plane(stations)
    away = np.random.default_rng(seed).choice([0.0, 0.1, -0.3], count)[:, None]
    points = np.concatenate([chain + away * tangents[:, ::-1] * (-1, 1), 2 * chain - chain.mean(axis=0)])
    compiled, plain = both(
        flush_strips, lambda: flush_strips.nearest_places(strip, (stations, chain), points)
    )
    foot, (place, tangent) = compiled
    assert distance(foot, plain[0]) < CLOSE
    assert distance(place, plain[1][0]) < CLOSE
    assert distance(tangent, plain[1][1]) < CLOSE


@pytest.mark.parametrize("size", [0.3, 1.0, 40.0])
@pytest.mark.parametrize("seed", SEEDS)
def test_points_near_each_other(both, seed, size):
    """Sparse and crowded, some in one place, and many at the very reach."""
    rng = np.random.default_rng(seed)
    points = np.concatenate([rng.uniform(0, size, (200, 2)), rng.integers(0, size + 1, (60, 2)) / 1.0])
    compiled, plain = both(near_pairs, lambda: near_pairs.near_pairs(points, 1.0))
    np.testing.assert_array_equal(compiled, plain)
    one, alike = both(near_pairs, lambda: near_pairs.near_pairs(points[:1], 1.0))
    assert one.shape == alike.shape == (2, 0)


@pytest.mark.parametrize("relief", ["square", "round"])
@pytest.mark.parametrize("seed", SEEDS)
def test_places_beside_slots(both, seed, relief):
    """In slots from either side, beside them, on their sides and far off."""
    rng = np.random.default_rng(seed)
    width = Profile.interpolate([0.0, 60.0, 120.0], [20.0, 30.0, 24.0])
    slots = [
        Slot(at, 3.0, lean=lean, side=side, relief=relief)
        for at, lean, side in ((30.0, 0.3, "upper"), (70.0, 0.0, "lower"))
    ]
    rims = SlotRims(tuple(slots), width)
    s, across = rng.uniform(0, 120, 400), rng.uniform(-15, 15, 400)
    s[:50], across[:50] = rims._rims[0][rng.integers(0, len(rims._rims[0]), 50)].T
    compiled, plain = both(slotted_collisions, lambda: rims.uncut(s, across))
    np.testing.assert_array_equal(compiled, plain)
    assert compiled.min() < -0.5 < 5 < compiled.max()


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
