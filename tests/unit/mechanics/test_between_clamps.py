"""The strip between two clamps: against the tables of the elastica, and on the side that is asked for."""

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk

from elastica_cad import Gravity, InputError, optimal_rod
from elastica_cad.mechanics import elastica_between

pytestmark = pytest.mark.core


def pinned(distance, length):
    """Height and end angle of Euler's elastica: distance / length = 2 E / K - 1, height / length = k / K."""
    k = brentq(lambda k: 2 * ellipe(k * k) / ellipk(k * k) - 1 - distance / length, 1e-6, 0.999)
    return length * k / ellipk(k * k), 2 * np.arcsin(k)


@pytest.mark.parametrize("distance", [95.0, 70.0, 30.0])
@pytest.mark.parametrize("side", [1, -1])
def test_pinned_ends(distance, side):
    height, angle = pinned(distance, 100.0)
    found = elastica_between((3, 4), (3, 4 + distance), 100.0, side=side)
    assert found.side == side
    assert found.inflections == 0
    assert np.abs(found.rod.position[:, 0] - 3).max() == pytest.approx(height, rel=1e-4)
    assert abs(found.rod.angle[0] - np.pi / 2) == pytest.approx(angle, rel=1e-4)


def test_clamped_ends_are_four_quarters():
    """Between parallel clamps the elastica is the pinned one of half the length, twice."""
    height, _ = pinned(35.0, 50.0)
    found = elastica_between((0, 0), (70, 0), 100.0, angles=(0.0, 0.0))
    assert found.rod.position[:, 1].max() == pytest.approx(2 * height, rel=2e-4)
    assert found.inflections == 2


def test_angles_length_and_ends():
    found = elastica_between((0, 0), (60, 20), 110.0, angles=(1.0, -1.4))
    curve = found.curve
    assert curve.length == pytest.approx(110, rel=1e-5)
    ends = curve.sample(2)
    assert ends.position == pytest.approx(np.array([(0, 0), (60, 20)]), abs=1e-4)
    assert ends.angle == pytest.approx([1.0, -1.4], abs=1e-3)
    assert "left" in str(found)


def test_taper_and_weight():
    thin = elastica_between((0, 0), (70, 0), 100.0, stiffness=[1.0, 4.0])
    top = thin.rod.position[thin.rod.position[:, 1].argmax(), 0]
    assert top < 30  # the soft end bends
    heavy = elastica_between((0, 0), (70, 0), 100.0, angles=(0.0, 0.0), gravity=Gravity(40.0, (0, -1)))
    assert heavy.rod.position[:, 1].max() < 31.4


@pytest.mark.parametrize(
    ("end", "length", "side", "says"),
    [((70, 0), 60.0, 1, "longer"), ((0, 0), 60.0, 1, "larger than 0"), ((70, 0), 80.0, 2, "side is 2")],
)
def test_refused(end, length, side, says):
    with pytest.raises(InputError, match=says):
        elastica_between((0, 0), end, length, side=side)


@pytest.mark.parametrize(
    "angles", [(0.5, -0.5), (0.0, 0.0), (None, None), (0.5, None), (None, -1.2), (1.6, -2.6)]
)
def test_a_strip_of_even_width_is_drawn(angles):
    """The drawn curve asks for even stiffness, and is as long as the strip."""
    curve = elastica_between((0, 0), (60, 20), 100.0, angles=angles).curve
    assert optimal_rod(curve).ratio == pytest.approx(1, abs=1e-3)
    assert curve.length == pytest.approx(100, rel=1e-8)


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"start": (0, 0, 3)}, "start cannot be .*: give two finite numbers"),
        ({"start": "a"}, "start cannot be .*: give two finite numbers"),
        ({"end": 70}, "end cannot be 70: give two finite numbers"),
        ({"length": "100"}, "length is '100': give a number"),
        ({"angles": 45}, "angles are .*: give two numbers"),
        ({"angles": (10,)}, "angles are .*: give two numbers"),
        ({"angles": ("steep", 0)}, "angles are .*: give two numbers"),
        ({"stiffness": "soft"}, "stiffness cannot be used: give a positive finite number"),
        ({"stiffness": []}, "stiffness cannot be used: give a positive finite number"),
    ],
)
def test_what_is_no_point_length_or_pair_is_named(given, says):
    request = {"start": (0, 0), "end": (70, 0), "length": 100.0} | given
    with pytest.raises(InputError, match=says):
        elastica_between(**request)


class TestFreeEnd:
    """A cantilever: Mattiasson's table (1981) of a dead load across it, Euler's load along it."""

    @pytest.mark.parametrize(("load", "drop", "shortening"), [(1, 0.30172, 0.05643), (10, 0.81061, 0.55500)])
    @pytest.mark.parametrize("turn", [0.0, 2.0])
    def test_a_load_across(self, load, drop, shortening, turn):
        along = np.array([np.cos(turn), np.sin(turn)])
        across = np.array([-along[1], along[0]])
        found = elastica_between((5, -3), None, 100.0, angles=(turn, None), force=load / 100.0**2 * across)
        way = found.rod.position[-1] - (5, -3)
        assert (way @ across, way @ along) == pytest.approx((100 * drop, 100 * (1 - shortening)), abs=2e-3)
        assert found.side == 1
        assert "free end goes to the left" in str(found)
        assert found.curve.length == pytest.approx(100, rel=1e-8)

    @pytest.mark.parametrize("side", [1, -1])
    def test_a_push_buckles_beyond_eulers_load(self, side):
        euler = np.pi**2 / 4 / 100.0**2
        low, high = (
            elastica_between((0, 0), None, 100.0, angles=(0.0, None), force=(-share * euler, 0), side=side)
            for share in (0.99, 1.01)
        )
        assert low.side == 0
        assert str(low) == "the strip is straight"
        assert high.side == side
        assert 100 - high.rod.position[-1, 0] == pytest.approx(
            2.0, rel=0.1
        )  # 2 L (P / P_euler - 1), first order

    @pytest.mark.parametrize("share", [0.02, -0.02, 1e-3])
    @pytest.mark.parametrize("push", [5e-4, 1e-2])
    def test_a_slanted_push_leads_to_the_side_it_points_to(self, share, push):
        force = np.array([-push, share * push])
        found = elastica_between((0, 0), None, 100.0, angles=(0.0, None), force=force)
        assert found.side == np.sign(share)
        # moments about the clamp: what bends it there is the force times its arm
        x, y = found.rod.position[-1]
        assert found.rod.curvature[0] == pytest.approx(x * force[1] - y * force[0], rel=1e-3)

    def test_weight_and_a_guided_end(self):
        drooping = elastica_between((0, 0), None, 100.0, angles=(0.0, None), gravity=Gravity(60.0, (0, -1)))
        assert drooping.rod.position[-1, 1] < -25
        guided = elastica_between((0, 0), None, 100.0, angles=(0.0, 0.0), force=(0, -1e-3))
        assert guided.rod.angle[-1] == pytest.approx(0.0, abs=1e-12)
        assert guided.inflections == 1

    @pytest.mark.parametrize(
        ("end", "options", "says"),
        [
            (None, {}, "give the angle at the start"),
            (None, {"angles": (0, None), "force": "down"}, "force cannot be .*: give two finite numbers"),
            (None, {"angles": (0, None), "force": (1, 2, 3)}, "force cannot be .*: give two finite numbers"),
            ((60, 0), {"force": (0, 1e-4)}, "give None for the end, or no force"),
        ],
    )
    def test_refused(self, end, options, says):
        with pytest.raises(InputError, match=says):
            elastica_between((0, 0), end, 100.0, **options)
