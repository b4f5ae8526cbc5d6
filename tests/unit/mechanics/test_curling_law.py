"""The law of sections that curl across: its slope, energy and inverse, and rods that follow it."""

from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from scipy.integrate import quad

from elastica_cad import Rod, Supports, bend
from elastica_cad.mechanics import PolynomialLaw, anticlastic_factor
from elastica_cad.mechanics.rod import CurlingLaw, as_bent

pytestmark = pytest.mark.core

WIDTH = np.array([5.0, 12.0, 20.0, 40.0, 90.0])
BEND = np.array([0.02, -0.011, 0.0, 0.004, -0.03])
SHEET = {"thickness": 0.5, "poisson_ratio": 0.37}


def law_of(rest=0.0, below=None):
    factor = partial(anticlastic_factor, WIDTH, natural_curvature=rest, **SHEET)
    return CurlingLaw(factor, factor(np.full(5, 0.01)), rest, below)


LAWS = [law_of(), law_of(0.004), law_of(below=PolynomialLaw(-0.1, curvature_scale=0.05))]


@pytest.mark.parametrize("law", LAWS, ids=["flat", "bent before", "softening"])
def test_slope_energy_and_inverse_belong_to_the_moment(law):
    m, slope = law.with_slope(BEND)
    assert m == pytest.approx(law.effective_curvature(BEND), rel=1e-14)
    assert slope == pytest.approx(law.slope(BEND), rel=1e-14)
    d = 1e-6
    central = (law.effective_curvature(BEND + d) - law.effective_curvature(BEND - d)) / (2 * d)
    assert slope == pytest.approx(central, rel=1e-5)
    assert law.curvature(m) == pytest.approx(BEND, abs=1e-14)
    for k, change in enumerate(BEND):
        stored, _ = quad(lambda t, k=k: law.effective_curvature(np.full(5, t))[k], 0.0, change, epsabs=1e-14)
        assert law.energy(BEND)[k] == pytest.approx(stored, rel=1e-3 if law.natural_curvature else 1e-8)


def test_a_strip_turned_at_its_ends_has_the_bend_that_its_moment_requests():
    """Between pins, by equal moments: an even bend up to the very ends, of kappa factor(kappa) = M / E I."""
    factor = partial(anticlastic_factor, np.full(41, 30.0), **SHEET)
    rod = replace(
        Rod.straight(100.0, samples=41, supports=Supports("pinned", "pinned")),
        law=CurlingLaw(factor, np.ones(41)),
    )
    turned = Supports("pinned", replace(Supports("pinned", "pinned").ends[1], x=False))
    request = 0.012
    bent = bend(replace(rod, supports=turned), moment=(-request, request))
    assert np.ptp(bent.curvature) < 1e-10
    assert bent.curvature[0] * factor(bent.curvature)[0] == pytest.approx(request, rel=1e-9)
    assert bent.curvature[0] < 0.95 * request


def test_as_it_is_bent_a_strip_has_a_stiffness_that_holds_it_there():
    s = np.linspace(0.0, 100.0, 61)
    factor = partial(anticlastic_factor, 10 + 0.3 * s, **SHEET)
    rod = replace(
        Rod.straight(100.0, 1 + 0.03 * s, bending_stiffness=7.0), law=CurlingLaw(factor, factor(0 * s))
    )
    rod = bend(rod, end=(70.0, 0.0))
    found = as_bent(rod)
    assert found.law is None
    assert found.stiffness.min() == pytest.approx(1.0)
    assert found.moment == pytest.approx(found.stiffness * found.curvature, rel=1e-9)
    for name in ("moment", "force"):
        newtons = found.bending_stiffness * getattr(found, name)
        assert newtons == pytest.approx(7.0 * getattr(rod, name), rel=1e-12)
    assert bend(found).position == pytest.approx(rod.position, abs=1e-8)
