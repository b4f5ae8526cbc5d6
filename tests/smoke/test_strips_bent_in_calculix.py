"""Cut files bent in CalculiX: what leaves the laser, held as designed, takes the drawn curve.

One strip is bent in the everyday suite, the others in `make campaign-programs`.
The whole campaign is `make campaign-elements`; `tests/setup.sh` installs ccx from Debian.
"""

from dataclasses import replace
from functools import partial

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad.strip.strip import corner_factor
from tests.campaign.finite_elements.bent_strip import bend_cut_strip
from tests.campaign.finite_elements.between import even_bow, slat_on_a_rail, solved, tied_strip
from tests.campaign.finite_elements.calculix import Material
from tests.campaign.finite_elements.cases import CASES
from tests.campaign.finite_elements.closed_forms import LENGTH, elastica, uniform_strip
from tests.campaign.finite_elements.shoulders import corner_strain
from tests.campaign.finite_elements.sideways import pushed_together
from tests.campaign.finite_elements.strips_in_pockets import held_in_pockets
from tests.campaign.finite_elements.tapered import TAPERED, bend_tapered


@pytest.mark.campaign
def test_a_rectangle_bends_into_the_elastica_of_elliptic_functions(tmp_path):
    bent = bend_cut_strip(uniform_strip(), tmp_path, size=10.0, curve=elastica(0.8, -1.2, 1.6))
    assert bent.deviation < 5e-5 * LENGTH


@pytest.mark.campaign
def test_a_clamped_strip_swings_as_a_beam(tmp_path):
    """The square of the lowest frequency is 22.373^2 E h^2 / (12 rho L^4)."""
    strip = uniform_strip()
    straight = ec.PlaneCurve.spline([(0, 0), (LENGTH / 2, 0), (LENGTH, 0)], degree=2)
    found = bend_cut_strip(strip, tmp_path, size=10.0, curve=straight, modes=1).eigenvalues[0]
    E, h, rho = strip.sheet.youngs_modulus, strip.sheet.thickness, 1e-12 * strip.sheet.density
    assert found == pytest.approx(22.373285**2 * E * h**2 / (12 * rho * LENGTH**4), rel=1e-3)


@pytest.mark.parametrize(
    ("poisson_ratio", "share"), [pytest.param(0.0, 5e-5, marks=pytest.mark.campaign), (0.3, 3e-4)]
)
def test_a_strip_takes_the_drawn_curve_but_for_its_curl(poisson_ratio, share, tmp_path):
    curve = ec.PlaneCurve.spline([(0, 0), (40, 80), (110, 100), (190, 50), (240, 0)], degree=4)
    sheet = replace(ec.Sheet.named("birch-plywood-0.8"), poisson_ratio=poisson_ratio)
    strip = ec.Strip(ec.optimal_rod(curve), sheet, max_width=30.0)
    bent = bend_cut_strip(strip, tmp_path, size=6.0, modes=4)
    assert bent.deviation < share * strip.rod.length
    assert bent.eigenvalues[0] > 0
    assert np.ptp(bent.body.nodes[:, 0]) == pytest.approx(strip.rod.length + 20.0, abs=1e-6)  # both tabs


@pytest.mark.campaign
def test_a_strip_of_the_wrong_width_strays_as_far_as_its_rod(tmp_path):
    """A rectangle in place of the strip: off by a hundredth of its length, in both theories alike."""
    curve = ec.PlaneCurve.spline([(0, 0), (40, 80), (110, 100), (190, 50), (240, 0)], degree=4)
    rod = ec.optimal_rod(curve)
    sheet = replace(ec.Sheet.named("birch-plywood-0.8"), poisson_ratio=0.0)
    wrong = ec.Strip(ec.Rod.straight(rod.length, 1.0), sheet, max_width=24.0)
    found = bend_cut_strip(wrong, tmp_path, size=8.0, curve=curve).deviation
    strayed = ec.bend(rod.with_stiffness(np.ones(rod.s.size))).position - rod.position
    assert found == pytest.approx(np.hypot(*strayed.T).max(), rel=0.01)


@pytest.mark.campaign
def test_a_laminate_whose_borders_curl_strays_as_far_as_it_says(tmp_path):
    (case,) = (one for one in CASES if one.group == "laminated, nu 0.3" and one.curve == "S")
    strip = case.spec.make()
    found = bend_cut_strip(strip, tmp_path, size=6.0).deviation
    assert found == pytest.approx(strip.held_deviation, rel=0.1)
    assert found > 4e-3 * strip.rod.length


@pytest.mark.campaign
@pytest.mark.parametrize(("k", "stays"), [(0.7, True), (0.9, False)])
def test_a_narrow_strip_pushed_together_leaves_its_plane_when_it_nearly_loops(k, stays, tmp_path):
    strip = uniform_strip(width=5.0, poisson_ratio=0.3)
    bent = bend_cut_strip(strip, tmp_path, size=5.0, curve=pushed_together(k), modes=3)
    assert (bent.eigenvalues[bent.sideways].min() > 0) == stays


@pytest.mark.campaign
def test_pockets_with_play_move_a_strip_as_far_as_it_says(tmp_path):
    curve = ec.PlaneCurve.spline([(0, 0), (60, 120), (140, 160), (240, 120), (300, 0)], degree=4)
    sheet = replace(ec.Sheet.named("birch-plywood-0.8"), poisson_ratio=0.0)
    strip = ec.Strip(ec.optimal_rod(curve), sheet, max_width=9.0)
    found = held_in_pockets(strip, tmp_path, name="arch", size=5.0)
    assert found.strayed == pytest.approx(found.told, rel=0.03)
    assert found.strayed > 0.5


@pytest.mark.campaign
def test_a_tapered_strip_takes_the_drawn_curve(tmp_path):
    """Its side view, meshed coarsely; the bank of five is the campaign's."""
    name = "tall ellipse, nu 0"
    bent = bend_tapered(name, TAPERED[name], tmp_path, size=8.0)
    assert bent.strayed < 1e-3
    assert bent.thickness[0] < 0.75 * bent.thickness[1]


@pytest.mark.campaign
@pytest.mark.parametrize("shear_modulus", [None, 800.0])
@pytest.mark.parametrize(("width", "tab"), [(14.0, 10.0), (20.0, 10.0)])
def test_corners_beside_a_tab_are_strained_as_the_rule_has_it(width, tab, shear_modulus, tmp_path):
    """Rounded by the thickness, as `corner_factor` takes them; with the grain of plywood and without."""
    nu = 0.3 if shear_modulus is None else 0.1
    sheet = ec.Sheet(
        "bar", 1.0, 12000.0, density=700.0, max_strain=0.01, poisson_ratio=nu, shear_modulus=shear_modulus
    )
    solid = Material(12000.0, nu, 700.0, shear_modulus, shear_modulus and 6000.0)
    found = corner_strain(width, tab, 1.0, solid, tmp_path)
    assert corner_factor(sheet, width, tab) == pytest.approx(found, rel=0.15)


@pytest.mark.campaign
@pytest.mark.parametrize("make", [partial(slat_on_a_rail, "slat"), tied_strip, even_bow])
def test_forces_between_the_ends_hold_the_drawn_curve(make, tmp_path):
    found = solved(make(), tmp_path, 6.0)
    assert found.deviation < 3e-3
    assert found.found == pytest.approx(found.computed, rel=0.03)
