"""Tapered strips, rods, tubes, plates and holes, light and heavy, against an independent boundary-value solver."""

import numpy as np
import pytest

from elastica_cad import (
    Gravity,
    InputError,
    Limits,
    NotConvergedError,
    NotRealizable,
    PlaneCurve,
    PointMass,
    Sheet,
    Weight,
    bend,
    nearest_rod,
    optimal_rod,
    stability,
)
from elastica_cad.mechanics import RoundLaw
from tests.section_designs import LAWS, Design, designs, errors, judged, laminates, perforated

pytestmark = pytest.mark.core

WAVE = PlaneCurve.spline([(0, 0), (120, 180), (270, 210), (420, -30), (570, 30), (690, 180)], degree=4)
ARCH = PlaneCurve.ellipse((0, 0), (250, 150), start=0, end=np.pi)


@pytest.mark.campaign
@pytest.mark.parametrize("law", LAWS)
def test_fifty_designs_rest_where_they_should(law):
    found = np.array([errors(design) for design in designs() if design.law == law])
    shape, place, force = found.max(axis=0)
    assert len(found) == 50
    assert shape < 1e-5  # of the length; asked is 1e-4
    assert place < 1e-5  # of the chord; asked is 5e-3
    assert force < 5e-4  # of the largest end force; asked is 1e-2


def test_fifty_laminates_rest_where_they_should():
    found = np.array([judged(*laminate) for laminate in laminates()])
    shape, place, force = found.max(axis=0)
    assert len(found) == 50
    assert shape < 1e-5
    assert place < 1e-5
    assert force < 5e-4


@pytest.mark.campaign
def test_fifty_perforated_strips_rest_where_they_should():
    """By what is left between the holes as they are cut."""
    found = np.array([judged(*strip) for strip in perforated()])
    shape, place, force = found.max(axis=0)
    assert len(found) == 50
    # as asked; without the level ends of the sides, up to 0.01 mm, they are 3e-6, 1.1e-5 and 3.2e-4
    assert shape < 1e-4  # of the length
    assert place < 5e-3  # of the chord
    assert force < 1e-2  # of the largest end force


def imbalance(rod, section):
    """Of moment and force, by quintic splines through the nodes and the weight that the law gives the section."""
    from scipy.interpolate import make_interp_spline

    B, s, law = rod.bending_stiffness, rod.s, section.bent(rod.curvature)
    weight = law.weight_per_length(law.parameter(B * rod.stiffness))
    load = weight[:, None] * np.array(rod.gravity.direction) / B
    force = rod.force[0] + make_interp_spline(s, load, k=5).antiderivative()(s)
    shear = force[:, 1] * np.cos(rod.angle) - force[:, 0] * np.sin(rod.angle)
    moment = rod.moment[0] + make_interp_spline(s, shear, k=5).antiderivative()(s)
    return max(
        np.abs(moment - rod.stiffness * rod.curvature).max() / np.abs(rod.moment).max(),
        np.abs(force - rod.force).max() / np.abs(rod.force).max(),
    )


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("curve", [ARCH, WAVE], ids=["arch", "wave"])
def test_the_fixed_point_is_in_balance(law, curve):
    section = Design(law, curve, heavy=True, nearest=False).section
    rod = optimal_rod(curve, Gravity(1.0), section=section, samples=4801)
    assert imbalance(rod, section) < 1e-9
    parameter = section.bent(rod.curvature).parameter(rod.bending_stiffness * rod.stiffness)
    assert parameter.max() == pytest.approx(section.limits[1], rel=1e-4)


@pytest.mark.parametrize("law", LAWS)
def test_weight_matters_and_no_small_change_has_a_lesser_ratio(law):
    """A local optimum: rods of the same law, scaled a little, in the same curve."""
    section = Design(law, ARCH, heavy=True, nearest=False).section
    heavy = optimal_rod(ARCH, Gravity(1.0), section=section)
    assert abs(heavy.ratio / optimal_rod(ARCH, section=section).ratio - 1) > 1e-3
    B = heavy.bending_stiffness
    weight = Weight(alpha=heavy.weight.alpha, beta=heavy.weight.beta)
    fixed = optimal_rod(ARCH, Gravity(1.0), weight=weight, bending_stiffness=B)
    assert fixed.ratio == pytest.approx(heavy.ratio, rel=1e-6)


@pytest.mark.parametrize("law", ["thickness", "rod", "tube"])
def test_nearest_rods_keep_the_limits_of_size_and_strain_under_their_weight(law):
    design = Design(law, ARCH, heavy=True, nearest=True)
    section = design.section
    limits = Limits(sheet=design.material, strain=0.006, margin=5.0)
    near = nearest_rod(ARCH, limits, gravity=Gravity(1.0), section=section)
    rod = near.rod
    parameter = section.parameter(rod.bending_stiffness * rod.stiffness)
    low, high = section.limits
    assert near.met
    assert low * (1 - 1e-9) <= parameter.min() < parameter.max() <= high * (1 + 1e-9)
    assert section.strains(rod.curvature, parameter)[0].largest <= 0.006 * (1 + 1e-5)
    free = nearest_rod(ARCH, Limits(margin=5.0), gravity=Gravity(1.0), section=section).rod
    freely = section.parameter(free.bending_stiffness * free.stiffness)
    assert section.strains(free.curvature, freely)[0].largest > 0.0065
    assert stability(rod).margin >= 5.0 - 1e-6
    weight = section.weight_per_length(parameter) * rod.node_lengths
    assert -rod.nodal_load[:, 1] * rod.bending_stiffness == pytest.approx(weight, rel=1e-9)
    bent = bend(rod)
    assert np.hypot(*(bent.position - rod.position).T).max() < 1e-9 * rod.length
    assert near.curve.length == pytest.approx(rod.length, rel=1e-3)


def test_a_mass_hangs_on_a_tapered_rod():
    section = Design("rod", ARCH, heavy=True, nearest=False).section
    hung = Weight(masses=(PointMass(200.0, 30.0),), own=True)
    rod = optimal_rod(ARCH, Gravity(1.0), section=section, weight=hung)
    assert rod.weight.masses == hung.masses
    bent = bend(rod)
    assert np.hypot(*(bent.position - rod.position).T).max() < 1e-4 * rod.length


def test_a_curve_beyond_the_limits_is_refused_with_the_size_it_requests():
    design = Design("thickness", WAVE, heavy=False, nearest=False)
    tight = type(design.section)(design.material, 6.0, 8.0, width=25.0)
    with pytest.raises(
        InputError,
        match=r"with the largest thickness of 8 mm, the curve requires a thickness of \d\.\d+ mm at",
    ):
        optimal_rod(WAVE, section=tight)
    with pytest.raises(InputError, match="leave out `bending_stiffness`, `largest_stiffness` and `law`"):
        optimal_rod(WAVE, Gravity(1.0), section=tight, weight=Weight(alpha=1.0), bending_stiffness=1.0)
    with pytest.raises(InputError, match="give a record with limits"):
        optimal_rod(WAVE, section=3.0)


def test_a_straight_rod_hangs_with_its_own_section():
    section = Design("rod", ARCH, heavy=True, nearest=False).section
    line = PlaneCurve.line((0, 0), (0, -300))
    rod = optimal_rod(line, Gravity(1.0), section=section)
    newtons = 300 * section.weight_per_length(8.0)
    assert np.abs(np.diff(rod.force[[0, -1], 1])) * rod.bending_stiffness == pytest.approx(newtons)


ACRYLIC = Sheet("acrylic", 3.0, 3200.0, density=1190.0, max_strain=0.01)


@pytest.mark.parametrize(("diameter", "grams"), [(4.0, 14.4), (6.0, 90.0)])
def test_a_mass_near_the_most_a_rod_bears_is_borne(diameter, grams):
    """Weight and size settle the more slowly the nearer the mass is to the one for which they never do."""
    section = RoundLaw(ACRYLIC, diameter / 10, diameter)
    hung = Weight(masses=(PointMass(0.65 * WAVE.length, grams),), own=True)
    rod = optimal_rod(WAVE, Gravity(1.0), section=section, weight=hung)
    sizes = section.parameter(rod.bending_stiffness * rod.stiffness)
    assert sizes.max() == pytest.approx(diameter, rel=1e-3)
    own = ACRYLIC.density * 9.80665e-9 * np.pi * sizes**2 / 4 * rod.node_lengths
    newtons = -rod.nodal_load[:, 1].sum() * rod.bending_stiffness
    assert newtons == pytest.approx(own.sum() + grams * 9.80665e-3, rel=1e-6)
    bent = bend(rod)
    assert np.hypot(*(bent.position - rod.position).T).max() < 1e-3 * rod.length


@pytest.mark.parametrize("grams", [30.0, 100.0, 265.0, 550.0])
def test_a_mass_that_no_rod_of_the_section_bears_is_reported_as_too_heavy(grams):
    """Not as the status of a library in which the numbers have run off."""
    hung = Weight(masses=(PointMass(0.65 * WAVE.length, grams),), own=True)
    result = r"Without weight the rod takes this curve. Use|Use a lighter or stiffer sheet|clamp the ends"
    with pytest.raises((NotConvergedError, NotRealizable), match=result):
        optimal_rod(WAVE, Gravity(1.0), section=RoundLaw(ACRYLIC, 0.4, 4.0), weight=hung)


def test_a_hair_that_is_too_heavy_from_the_first_is_reported_so_without_a_number():
    """0.1 mm over half a metre: no program comes to an answer at all."""
    hair = RoundLaw(ACRYLIC, 0.1035e-2, 0.10354824746533017)
    with pytest.raises((NotConvergedError, NotRealizable), match=r"stiffer or lighter material") as result:
        optimal_rod(ARCH, Gravity(1.0), section=hair)
    assert "inf" not in str(result.value)
