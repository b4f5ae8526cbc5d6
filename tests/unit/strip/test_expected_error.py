"""What a real strip strays by: the linear answer to a sheet that is off, beside strips bent forward."""

from dataclasses import replace

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad import InputError, Profile, Slot, Strip
from elastica_cad.mechanics import Imperfection, perturb_rod
from elastica_cad.strip import HeldShape, MakingTolerance
from elastica_cad.strip.held_shape import about
from elastica_cad.strip.summary import accuracy_row

pytestmark = pytest.mark.core

ARCH = ec.PlaneCurve.spline([(0, 0), (60, 120), (140, 160), (240, 120), (300, 0)])
PLY = replace(ec.Sheet.named("birch-plywood-0.8"), poisson_ratio=0.0)
NOTHING = MakingTolerance(0.0, 0.0, 0.0, 0.0, 0.0)


@pytest.fixture(scope="module")
def strip():
    return Strip(ec.optimal_rod(ARCH, samples=241), PLY, max_width=30.0)


def shifted(rod, changed, angles=None):
    bent = ec.bend(changed, angles=angles)
    return float(np.hypot(*(bent.position - rod.position).T).max())


def softened(rod, share):
    return rod.with_stiffness(Profile.interpolate(rod.s, rod.stiffness * share))


def test_a_wave_of_thickness_moves_it_as_far_as_when_it_is_bent(strip):
    rod = strip.rod
    answer = replace(strip, tolerance=replace(NOTHING, thickness_wave=0.003)).held().sheet
    turns = 2 * np.pi * rod.s / rod.length
    waves = (np.cos(turns + phase) for phase in np.pi * np.arange(8) / 8)
    found = max(shifted(rod, softened(rod, (1 + 0.003 * wave) ** 3)) for wave in waves)
    assert answer["thickness"] == pytest.approx(found, rel=0.03)
    assert sum(answer.values()) == answer["thickness"]


def test_clamps_and_kerf_do_too(strip):
    rod = strip.rod
    answer = replace(strip, tolerance=MakingTolerance(0.0, 0.0, 0.004, 0.5)).held().sheet
    angles = (float(rod.angle[0]) + 0.004, float(rod.angle[-1]))
    assert answer["clamp at the start"] == pytest.approx(shifted(rod, rod, angles), rel=0.02)
    narrower = softened(rod, 1 - 0.5 / strip.width(rod.s))
    assert answer["kerf"] == pytest.approx(shifted(rod, narrower), rel=0.05)


@pytest.mark.parametrize("softer", [0.02, 0.1])
def test_a_smaller_modulus_moves_strips_that_carry_something(softer):
    """Against a strip of that modulus, bent anew; a strip without weight does not depend on it."""
    card = ec.Sheet.named("card-200gsm")
    curve = ec.PlaneCurve.spline([(0, 0), (50, 60), (100, 10), (150, -40), (200, 20)])
    heavy = Strip(
        ec.optimal_rod(curve, card.gravity(), samples=241),
        replace(card, poisson_ratio=0.0),
        max_width=20.0,
        tolerance=replace(NOTHING, modulus=softer),
    )
    bent = perturb_rod(heavy.rod, Imperfection(youngs_modulus=1 - softer))
    found = float(np.hypot(*(bent.position - heavy.rod.position).T).max())
    assert heavy.held().sheet["modulus"] == pytest.approx(found, rel=0.05)
    assert heavy.held().sheet_adds == heavy.held().sheet["modulus"]


def test_a_strip_without_weight_does_not_depend_on_the_modulus(strip):
    assert "modulus" not in strip.held().sheet


def test_only_sheets_with_a_grain_feel_it(strip):
    assert "grain" in strip.held().sheet
    even = replace(strip, sheet=replace(PLY, grain="none"))
    assert "grain" not in even.held().sheet
    unknown = replace(strip, sheet=replace(PLY, shear_modulus=None), slots=(Slot(150.0, width=1.0),))
    assert "grain" not in unknown.held().sheet
    assert "The shear modulus of birch-plywood-0.8 is unknown" in str(unknown.held())


def test_what_is_expected_says_where_it_comes_from(strip):
    shape = strip.held()
    assert shape.expected == pytest.approx(np.hypot(np.hypot(shape.deviation, shape.open), shape.sheet_adds))
    assert "Contributions: 0.42 mm due to thickness (tolerance.thickness_wave); " in str(shape)
    slotted = replace(strip, slots=(Slot(150.0, width=1.0),), tolerance=NOTHING).held()
    assert slotted.sheet_adds == 0.0
    assert slotted.contributions[0].cause == "slots"
    assert slotted.contributions[0].key == "compensate"
    assert slotted.open > 0.1 * slotted.parts["slots"]


@pytest.mark.parametrize(
    ("name", "value", "cause"),
    [("thickness_wave", 0.02, "thickness"), ("clamps", 0.03, "clamp at the start"), ("kerf", 1.0, "kerf")],
)
def test_the_largest_contribution_is_named_with_its_key(strip, name, value, cause):
    shape = replace(strip, tolerance=replace(NOTHING, **{name: value})).held()
    assert shape.contributions[0].mm == max(part.mm for part in shape.contributions)
    assert shape.contributions[0].mm == shape.sheet[cause]
    message = accuracy_row(shape).text
    assert f"Largest contribution: {about(shape.sheet[cause])} due to " in message
    assert f"(tolerance.{name})" in message
    assert " due to uncertainty of the model" in accuracy_row(replace(strip, tolerance=NOTHING).held()).text


def test_no_computed_effect_is_larger_than_the_deviation(strip):
    slotted = replace(strip, slots=(Slot(150.0, width=1.0),), tolerance=NOTHING)
    held = slotted.held()
    assert all(part.mm <= max(held.deviation, held.open) for part in held.contributions)


def test_slots_in_plywood_soften_it_more_than_in_an_even_sheet(strip):
    """By finite elements 1.7 times (E / G = 15, nu = 0.1)."""
    slots = (Slot(150.0, width=1.0),)
    even = replace(strip, sheet=replace(PLY, shear_modulus=None), slots=slots)
    grained = replace(strip, slots=slots)
    assert grained.held().parts["slots"] / even.held().parts["slots"] == pytest.approx(1.9, rel=0.1)


@pytest.mark.parametrize(
    ("value", "text"), [(0.8312, "0.83 mm"), (0.00123, "0.001 mm"), (191.0, "190 mm"), (9.96, "10 mm")]
)
def test_numbers_have_two_digits_and_end_at_a_micrometre(value, text):
    assert str(about(value)) == text


def test_slips_are_refused(strip):
    with pytest.raises(InputError, match="tolerance kerf is -1: give a number from 0, in mm"):
        MakingTolerance(kerf=-1)
    with pytest.raises(InputError, match=r"tolerance modulus is 0\.6: give a number from 0 up to 0\.5"):
        MakingTolerance(modulus=0.6)
    with pytest.raises(InputError, match="MakingTolerance"):
        replace(strip, tolerance=0.01)


def test_a_shape_knows_no_sheet_unless_it_is_reported(strip):
    held = strip.held()
    assert HeldShape(held.rod, 1.0, {}, held.start, held.end).expected == 1.0


def test_slots_beside_each_other_are_left_open(strip):
    beside = replace(strip, slots=(Slot(198.0, width=1.0), Slot(204.0, width=1.0, side="lower"))).held()
    apart = replace(strip, slots=(Slot(150.0, width=1.0), Slot(204.0, width=1.0, side="lower"))).held()
    assert beside.open > beside.parts["slots"]
    assert "The slots 198 mm and 204 mm from the start are closer together than they are deep" in str(beside)
    assert apart.open < 0.3 * apart.parts["slots"]
