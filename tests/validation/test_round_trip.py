"""A rod made for a drawn curve, bent again by `bend`, returns to the drawn curve within 1e-5 of its length."""

import json

import numpy as np
import pytest

import elastica_cad as ec

pytestmark = pytest.mark.core

CARD = ec.Sheet.named("card-200gsm")


def returns(curve, gravity, **options):
    """Largest distance of the bent rod from the drawn curve, in lengths of the curve."""
    rod = ec.optimal_rod(curve, gravity=gravity, **options)
    bent = ec.bend(rod)
    drawn = rod.curve.at(bent.s)
    return np.abs(bent.position - drawn.position).max() / rod.length


def pavilion_arch(number):
    """Strip `number` of the Pavilion: the part above ground of a turned ellipse, semi-axes 75 and 112.5 mm."""
    turn = 3 * np.pi * (number - 1) / 30
    c, s = np.cos(turn), np.sin(turn)
    t = np.linspace(0, 2 * np.pi, 100001)
    height = 75 * s * np.cos(t) + 112.5 * c * np.sin(t) + 20
    above = height >= 0
    first = t[np.flatnonzero(~above[:-1] & above[1:])[0] + 1]
    last = t[np.flatnonzero(above[:-1] & ~above[1:])[0]]
    return ec.PlaneCurve.ellipse((0, 20), (75.0, 112.5), turn, first, last + 2 * np.pi * (last < first))


def spiral():
    """The published spiral (REFERENCE.md), fitted."""
    x0 = 5 * np.pi / 3
    rows = [[x0**4, x0**3, x0**2], [4 * x0**3, 3 * x0**2, 2 * x0], [12 * x0**2, 6 * x0, 2]]
    c4, c3, c2 = np.linalg.solve(rows, [x0, 1, 0])
    f = np.polynomial.Polynomial([0, -1, c2, c3, c4])
    t0, t1 = 4.5 * np.pi, 9.5 * np.pi
    t = np.linspace(t0, t1, 2001)
    r = t + np.where(t - t0 < x0, f(t - t0), 0) - np.where(t1 - t < x0, f(t1 - t), 0)
    return ec.PlaneCurve.fit(np.column_stack([r * np.cos(t), r * np.sin(t)]), degree=5, tolerance=1e-4)


@pytest.mark.parametrize("number", [1, 4, 16])
def test_pavilion(number):
    curve = pavilion_arch(number)
    assert returns(curve, None) < 1e-5
    assert returns(curve, CARD.gravity()) < 1e-5


def test_spiral():
    curve = spiral()
    rod = ec.optimal_rod(curve)
    assert rod.ratio == pytest.approx(1.84167, abs=5e-4)
    assert ec.optimal_rod(curve, CARD.gravity()).ratio == pytest.approx(2.07087, abs=2e-3)
    assert returns(curve, None) < 1e-5
    assert returns(curve, CARD.gravity()) < 1e-5


def test_flower_pot(reference_data):
    data = json.loads((reference_data / "reference" / "flower_pot.json").read_text())
    e = data["e_gravity"][1] * 1e-9
    gravity = ec.Gravity(e ** (-1 / 3), (0, -1))
    for record in data["curves"][::4]:
        points = 60.0 * np.array(record["cp_final"])
        curve = ec.PlaneCurve(np.arange(-4.0, 11.0), points, 4)
        assert returns(curve, gravity) < 1e-5
