"""Masses hung on a strip of a given width: the least ratio that carries them, by statics and linprog."""

import numpy as np
import pytest
from scipy.optimize import linprog

from elastica_cad.errors import InputError
from elastica_cad.fabrication.strip_spec import make_strip
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.bending.bend_forward import bend
from elastica_cad.mechanics.loads.weight import STANDARD_GRAVITY_M_S2, PointMass, Weight
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.material.stiffness_law import ThicknessLaw
from elastica_cad.mechanics.stiffness.optimal_rod import optimal_rod

pytestmark = pytest.mark.core

BIRCH = Sheet.named("birch-plywood-0.8")
ARCH = PlaneCurve.fit([(0, 0), (60, 62), (120, 95), (180, 105), (240, 95), (300, 62), (360, 0)])
SKEW = PlaneCurve.fit([(0, 0), (60, 90), (150, 120), (240, 80), (320, 0)])
WIDTH, PLACE = 40.0, 200.0


def ratio_by_statics(curve, grams, most):
    """Least ratio of E I at 4001 places below `most`: moments of a clamped arch with a load, weightless itself."""
    s = np.linspace(0, curve.length, 4001)
    x, y = curve.evaluate(curve.parameter(s)).T
    x_load = float(np.interp(PLACE, s, x))
    newtons = grams * 1e-3 * STANDARD_GRAVITY_M_S2
    kappa = curve.curvature_at(curve.parameter(s))
    free = np.column_stack([np.ones(s.size), x, y]) / kappa[:, None]
    loaded = -newtons * np.maximum(x - x_load, 0.0) / kappa
    # E I = free @ numbers + loaded lies between the least, which is made large, and the most
    rows = np.block([[free, np.zeros((s.size, 1))], [-free, np.ones((s.size, 1))]])
    found = linprog([0, 0, 0, -1], rows, np.concatenate([most - loaded, loaded]), bounds=(None, None))
    assert found.status == 0, found.message
    return most / found.x[3]


@pytest.mark.parametrize(("curve", "grams"), [(ARCH, 16), (ARCH, 97), (ARCH, 150), (SKEW, 16), (SKEW, 56)])
def test_the_least_ratio_that_carries_a_mass_within_a_width(curve, grams):
    most = BIRCH.bending_stiffness(WIDTH)
    weight = Weight(masses=(PointMass(PLACE, grams),), own=False)
    free = optimal_rod(curve, BIRCH.gravity(), weight=weight)
    assert free.bending_stiffness * free.ratio > 1.3 * most, "it asks for more width"
    rod = optimal_rod(curve, BIRCH.gravity(), weight=weight, largest_stiffness=most)
    assert 0.985 * most < rod.bending_stiffness * rod.ratio <= most
    expected = ratio_by_statics(curve, grams, most)
    assert rod.ratio == pytest.approx(expected, rel=5e-3)
    assert rod.ratio > 0.999 * expected
    assert rod.ratio > free.ratio


@pytest.mark.parametrize("curve", [ARCH, SKEW])
def test_a_strip_with_its_mass_comes_to_rest_in_its_curve(curve):
    strip = make_strip(curve, BIRCH, max_width=WIDTH, gravity=True, loads=[PointMass(PLACE, 16)])
    assert strip.width.extremes[1] <= WIDTH
    assert strip.width.extremes[1] > 0.98 * WIDTH
    rod = strip.rod
    rest = bend(rod, start=rod.position[0], end=rod.position[-1])
    assert np.abs(rest.position - rod.position).max() < 0.02


def test_a_mass_that_no_width_carries_is_told_the_least_that_would():
    with pytest.raises(InputError, match=r"asks for a width of 4\d\.\d+ mm, above max_width 40 mm"):
        make_strip(ARCH, BIRCH, max_width=WIDTH, gravity=True, loads=[PointMass(PLACE, 300)])
    assert make_strip(ARCH, BIRCH, max_width=80, gravity=True, loads=[PointMass(PLACE, 300)])


@pytest.mark.parametrize("given", [0.0, -1.0, np.nan])
def test_a_largest_stiffness_is_positive(given):
    weight = Weight(masses=(PointMass(PLACE, 16),), own=False)
    with pytest.raises(InputError, match=r"largest stiffness is .*: it must be positive, in N mm2"):
        optimal_rod(ARCH, BIRCH.gravity(), weight=weight, largest_stiffness=given)
    with pytest.raises(InputError, match="largest_stiffness is for rods with a weight in newtons"):
        optimal_rod(ARCH, BIRCH.gravity(), largest_stiffness=100.0)


def test_a_largest_stiffness_beside_what_settles_the_stiffness_is_refused():
    """It had been taken, and ignored."""
    asked = {"weight": Weight(masses=(PointMass(PLACE, 16),), own=True), "largest_stiffness": 1e4}
    with pytest.raises(
        InputError, match="bending_stiffness settles how stiff the rod is, and leaves largest_st"
    ):
        optimal_rod(ARCH, BIRCH.gravity(), bending_stiffness=1e3, **asked)
    with pytest.raises(InputError, match="leave out bending_stiffness, largest_stiffness and law"):
        optimal_rod(ARCH, BIRCH.gravity(), section=ThicknessLaw(BIRCH, 2, 8, width=20), **asked)
