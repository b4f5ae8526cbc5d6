"""Strips of sheets whose Poisson ratio is known take their curve as they are made, light and heavy."""

from dataclasses import replace

import numpy as np
import pytest

from elastica_cad import (
    FabricationLimits,
    Gravity,
    Keep,
    Limits,
    PlaneCurve,
    PointMass,
    Sheet,
    StripSpec,
    make_strip,
)
from elastica_cad.mechanics import ThicknessLaw, anticlastic_factor
from elastica_cad.strip.held_shape import LEAST_REPORTED_MM

pytestmark = pytest.mark.core

LENGTH = 300.0
STRAYS = 5e-5
"""Of the length, by default."""

CARD = replace(Sheet.named("card-200gsm"), poisson_ratio=0.3)


def curve(points, degree=4):
    drawn = PlaneCurve.spline(points, degree=degree)
    return drawn.transformed(np.diag([1.0, 1.0, drawn.length / LENGTH]))


ARCH = curve([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])
CURVES = {
    "arch": ARCH,
    "S": curve([(0, 0), (50, 60), (100, 10), (150, -40), (200, 20)]),
    "hook": curve([(0, 0), (80, 0), (120, 40), (90, 90), (50, 70)], 3),
}
WIDE = {"max_width": 45.0, "ignore_limits": True}
ASKED = {
    "light": WIDE,
    "narrowest": {"min_width": 12.0, "ignore_limits": True},
    "heavy": WIDE | {"gravity": True},
    "heavy, narrowest": {"min_width": 12.0, "gravity": True, "ignore_limits": True},
    "askew": WIDE | {"gravity": (0.6, -0.8)},
    "gravity of its own": WIDE | {"gravity": Gravity(150.0)},
    "bent before": WIDE | {"natural_curvature": 0.004},
    "near": WIDE | {"limits": Limits(ratio=3.0)},
    "near, heavy": WIDE | {"limits": Limits(ratio=3.0), "gravity": True},
    "near, heavy, narrowest": {"min_width": 12.0, "limits": Limits(), "gravity": True, "ignore_limits": True},
}


@pytest.mark.parametrize("options", ASKED)
@pytest.mark.parametrize("name", CURVES)
def test_a_strip_takes_its_curve_by_default_where_nu_is_known(name, options):
    made = make_strip(CURVES[name], CARD, **ASKED[options])
    held = made.held()
    assert held.deviation < STRAYS * LENGTH
    assert held.parts == {}
    beam = make_strip(CURVES[name], CARD, **ASKED[options], compensate=False)
    needed = beam.held_deviation > LEAST_REPORTED_MM
    assert held.made_up_for == (("anticlastic bending",) if needed else ())
    assert ("with widths that compensate anticlastic bending" in str(held)) == needed
    narrow, wide = made.width.extremes
    assert (narrow if "narrowest" in options else wide) == pytest.approx(
        ASKED[options].get("max_width", 12.0), rel=0.025 if "near" in options else 5e-3
    )
    assert beam.held_deviation > 5 * made.held_deviation
    assert beam.width(beam.rod.s) == pytest.approx(
        beam.rod.stiffness * beam.width.extremes[1] / beam.rod.profile.extremes[1], rel=1e-5
    )


def test_widths_are_as_stiff_as_the_design_station_by_station():
    """E I by Ashwell's factor of the width that is cut, checked outside the law; light strips keep their rod."""
    made, beam = (make_strip(ARCH, CARD, max_width=45.0, compensate=how) for how in (None, False))
    s = made.rod.s
    factor = anticlastic_factor(made.width(s), made.rod.curvature, thickness=0.2, poisson_ratio=0.3)
    EI = made.width(s) * factor
    assert factor.max() > 1.03
    assert EI / EI.max() == pytest.approx(made.rod.stiffness / made.rod.ratio, rel=1e-5)
    assert made.rod.ratio == beam.rod.ratio
    assert StripSpec(ARCH, CARD, max_width=45.0).rod_spec == StripSpec(ARCH, CARD, max_width=30.0).rod_spec


@pytest.mark.parametrize(
    ("sheet", "asked"),
    [
        (Sheet.named("card-200gsm"), WIDE),  # nobody vouches for its nu
        (replace(CARD, poisson_ratio=0.0), WIDE),  # E measured on a wide coupon
        (CARD, {"gravity": True, "loads": (PointMass(100.0, 0.5),), "ignore_limits": True}),
    ],
    ids=["nominal", "coupon", "loads"],
)
def test_widths_are_proportional_to_the_stiffness_otherwise(sheet, asked):
    made = make_strip(ARCH, sheet, **asked)
    assert made.rod.section is None
    assert made.held().made_up_for == ()
    share = made.width(made.rod.s) / made.rod.stiffness
    assert share == pytest.approx(np.full(share.size, share[0]), rel=1e-6)


def test_all_that_can_be_made_up_for_is_when_requested():
    made = make_strip(ARCH, CARD, max_width=45.0, compensate=True)
    assert made.held().made_up_for == ("anticlastic bending",)
    assert made.correction is not None


def test_a_long_strip_that_bends_as_a_plate_is_cut_in_pieces():
    long = ARCH.transformed(np.diag([1.0, 1.0, 0.25]))
    made = make_strip(long, CARD, max_width=60.0, shop=FabricationLimits(stock=(700.0, 500.0), lap=40.0))
    assert made.plates is not None
    assert made.held().as_plate


@pytest.mark.parametrize("ratio", [None, 8.0])
@pytest.mark.parametrize("name", CURVES)
def test_a_taper_near_a_curve_weighs_what_it_is_made_of(name, ratio):
    """Where no limit binds it may be thinner than it is allowed to be; it was made thicker than solved for."""
    sheet = Sheet("rubbery", 2.0, 900.0, density=1150.0, max_strain=0.05)
    law = ThicknessLaw(sheet, 0.8, 2.0, width=20.0)
    made = make_strip(
        CURVES[name],
        sheet,
        section=law,
        gravity=True,
        limits=Limits(ratio=ratio),
        keep=Keep(),
        ignore_limits=True,
    )
    assert made.held_deviation < 1e-5 * LENGTH
    assert made.tapered["thickness"].extremes[1] <= 2.0 * (1 + 1e-4)
