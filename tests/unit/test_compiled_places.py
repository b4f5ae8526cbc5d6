"""Compiled places on curves, asked a few at a time, beside their twins in Python."""

import numpy as np
import pytest

from elastica_cad.fabrication.interlocking import flush_strips, ruled_strip
from elastica_cad.fabrication.interlocking.ruled_strip import RuledStrip
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.paths.profile import Profile
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
