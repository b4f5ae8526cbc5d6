"""Move, turn, mirror, scale or reverse the wish, and the nearest rod follows."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from elastica_cad import Gravity, Limits, PlaneCurve, nearest_rod

pytestmark = pytest.mark.core

POINTS = np.array([(0, 0), (30, 55), (60, 60), (80, -10), (130, 5)], dtype=float)
LIMITS = Limits(ratio=2.0, margin=3.0)


@pytest.fixture(scope="module")
def plain():
    return nearest_rod(PlaneCurve.spline(POINTS), LIMITS)


@pytest.fixture(scope="module")
def heavy():
    return nearest_rod(PlaneCurve.spline(POINTS), LIMITS, gravity=Gravity(80.0))


def same_shape(near, expected, scale=1.0):
    assert near.met
    assert near.deviation == pytest.approx(scale * expected.deviation, rel=0.02)
    return near.rod.position / scale


def close(positions, expected):
    # between its farthest points, a rod may move a little without a larger distance
    assert np.abs(positions - expected.rod.position).max() < 0.02 * expected.rod.length


@settings(max_examples=8, deadline=None)
@given(angle=st.floats(-3, 3), shift=st.tuples(st.floats(-1e3, 1e3), st.floats(-1e3, 1e3)))
def test_motions(plain, angle, shift):
    c, s = np.cos(angle), np.sin(angle)
    Q = np.array([[c, -s], [s, c]])
    near = nearest_rod(PlaneCurve.spline(POINTS @ Q.T + shift), LIMITS)
    close((same_shape(near, plain) - shift) @ Q, plain)


@settings(max_examples=8, deadline=None)
@given(exponent=st.floats(-2, 2), weight=st.booleans())
def test_scales(plain, heavy, exponent, weight):
    factor = 10.0**exponent
    expected = heavy if weight else plain
    gravity = Gravity(80.0 * factor) if weight else None
    near = nearest_rod(PlaneCurve.spline(POINTS * factor), LIMITS, gravity=gravity)
    close(same_shape(near, expected, factor), expected)
    assert near.rod.ratio == pytest.approx(expected.rod.ratio, rel=0.02)


@pytest.mark.parametrize("weight", [False, True])
def test_mirror_and_reverse(plain, heavy, weight):
    expected, gravity = (heavy, Gravity(80.0)) if weight else (plain, None)
    mirrored = nearest_rod(PlaneCurve.spline(POINTS * [-1, 1]), LIMITS, gravity=gravity)
    close(same_shape(mirrored, expected) * [-1, 1], expected)
    reversed_ = nearest_rod(PlaneCurve.spline(POINTS).reversed(), LIMITS, gravity=gravity)
    close(same_shape(reversed_, expected)[::-1], expected)


def test_a_turned_plane_turns_gravity(heavy):
    turned = nearest_rod(PlaneCurve.spline(POINTS @ [[0, 1], [-1, 0]]), LIMITS, gravity=Gravity(80.0, (1, 0)))
    close(same_shape(turned, heavy) @ [[0, -1], [1, 0]], heavy)


@pytest.mark.campaign
@settings(max_examples=6, deadline=None)
@given(seed=st.integers(0, 10**6))
def test_a_looser_ratio_is_never_farther(seed):
    rng = np.random.default_rng(seed)
    wish = PlaneCurve.spline(np.column_stack([np.linspace(0, 150, 6), 30 * rng.normal(size=6)]))
    tight, loose = (nearest_rod(wish, Limits(ratio=r)) for r in (1.4, 2.2))
    assert loose.deviation <= tight.deviation * 1.02 + 1e-6 * wish.length
