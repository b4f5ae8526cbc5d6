"""The curve of a discrete rod has its length, ends and end angles, and follows it as the square of the step."""

import numpy as np
import pytest

from elastica_cad import PlaneCurve, Profile, Rod, bend, optimal_rod
from elastica_cad.mechanics.rod import has_even_edges

pytestmark = pytest.mark.core

KINKED = Profile.interpolate([0, 75, 150], [1, 1.6, 1])
STEPPED = np.where(np.linspace(0, 1, 301) < 0.4, 1.0, 3.0)
S = PlaneCurve.spline([(0, 0), (50, 60), (100, 10), (150, -40), (200, 20)])
RODS = {
    "kinked width": lambda: bent(KINKED),
    "coarse": lambda: bent(KINKED, 31),
    "step of the width": lambda: bent(STEPPED),
    "loop": lambda: bend(Rod.straight(150.0), start=(0, 0), end=(20, 0), angles=(2.9, -2.9)),
    "S with another width": lambda: bend(optimal_rod(S).with_stiffness(np.linspace(1, 2, 601))),
    "straight": lambda: Rod.straight(80.0, start=(3, 4), angle=0.7),
    "few nodes": lambda: Rod.straight(80.0, samples=4),
    "two nodes": lambda: Rod.straight(80.0, [1, 2], start=(3, 4), angle=0.7),
}


def bent(stiffness, samples=None):
    rod = Rod.straight(150.0, stiffness, samples=samples)
    return bend(rod, start=(0, 0), end=(120, 0), angles=(0.9, -0.9))


@pytest.mark.parametrize("name", sorted(RODS))
def test_length_ends_angles_and_nodes(name):
    rod = RODS[name]()
    curve = rod.curve
    assert curve.length == pytest.approx(rod.length, rel=1e-9)
    assert curve.domain == pytest.approx((0, rod.length))
    samples = curve.at(np.minimum(rod.s, curve.length))
    assert samples.position[[0, -1]] == pytest.approx(rod.position[[0, -1]], abs=1e-7)
    assert samples.angle[[0, -1]] == pytest.approx(rod.angle[[0, -1]], abs=2e-8)
    step, kappa = rod.s[1], np.abs(rod.curvature).max()
    off = np.hypot(*(samples.position - rod.position).T)
    assert off.max() < 2 * step**2 * kappa / 24 + 1e-9
    assert (
        np.abs(samples.angle - rod.angle).max()
        < step**2 * np.abs(np.gradient(rod.curvature, rod.s)).max() + 2e-8
    )


@pytest.mark.parametrize("angle", np.arange(0.017, 3.1, 0.3))
def test_a_straight_rod_has_a_straight_curve(angle):
    for length in (20.0, 57.3, 760.0):
        rod = Rod.straight(length, start=(3, 4), angle=angle)
        assert rod.curve.at(rod.s).position == pytest.approx(rod.position, abs=1e-9 * length)


def test_speed_is_one():
    curve = bent(KINKED).curve
    speed = np.hypot(*curve.evaluate(np.linspace(*curve.domain, 999), 1).T)
    assert speed == pytest.approx(1, abs=2e-8)


def test_a_tenth_of_a_micrometre_from_the_rod():
    """601 nodes follow a strip of 150 mm with a radius of 40 mm within 1e-4 mm."""
    rod = bent(KINKED)
    assert np.hypot(*(rod.curve.at(rod.s).position - rod.position).T).max() < 1e-4


def test_it_converges_to_the_drawn_curve():
    """The optimal rod of a curve, bent on ever more nodes: its curve comes closer with the square of the step."""
    rod = optimal_rod(S)
    places = np.linspace(0, S.length, 41)

    def error(samples):
        found = bend(optimal_rod(S, samples=samples).with_stiffness(rod.profile))
        return np.hypot(*(found.curve.at(places).position - S.at(places).position).T).max()

    errors = np.array([error(n) for n in (101, 201, 401)])
    assert errors[1:] / errors[:-1] == pytest.approx(0.25, rel=0.1)


def test_samples_of_a_curve_are_no_marched_rod():
    """Nodes of a circle are closer than their arc lengths: the curve goes through them."""
    from dataclasses import replace

    rod = replace(optimal_rod(PlaneCurve.arc((0, 0), 50, 0, 2)), shape=None)
    assert not has_even_edges(rod.s, rod.position)
    assert np.hypot(*rod.curve.at(np.linspace(0, 99, 20)).position.T) == pytest.approx(50, abs=1e-4)
