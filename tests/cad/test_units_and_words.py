"""Units of these front ends, numbers in other units, and words that users type for an option."""

import math
from pathlib import Path

import numpy as np
import pytest

from elastica_cad import InputError, Sheet, Slot, Strip, Tab, optimal_rod
from elastica_cad.kernel.strip_body import StripWarning
from tests.cad.conftest import CURVES
from tests.cad.libraries import bd, bd_strips, cq_strips

CURVE = CURVES["cubic arch"]
GIVEN = {"max_width": 20.0, "ends": Tab(10)}
FIGURES = {"thickness": 0.8, "youngs_modulus": 9200.0, "density": 680.0, "max_strain": 0.08}


@pytest.fixture(
    params=[
        pytest.param("build123d", marks=pytest.mark.build123d),
        pytest.param("cadquery", marks=pytest.mark.cadquery),
    ]
)
def make(request):
    return bd_strips.FlatStrip if request.param == "build123d" else cq_strips.flat_strip


def test_the_lean_of_a_slot_is_in_degrees(make):
    arc = CURVES["circle"]  # of constant width
    slotted = make(arc, "pom-0.5", slots=Slot(60, width=1.2, depth=4, lean=20), **GIVEN)
    whole = make(arc, "pom-0.5", **GIVEN)
    removed = whole.strip.outline.area - slotted.strip.outline.area
    assert removed == pytest.approx(1.2 * 4 / math.cos(math.radians(20)), rel=0.01)


def test_a_lean_in_radians_is_reported(make):
    with pytest.warns(StripWarning, match=r"Angles are in degrees, and 0\.35 is small"):
        make(CURVE, "pom-0.5", slots=(Slot(60, width=1.2, depth=4, lean=0.35),), **GIVEN)


def test_a_lean_in_degrees_is_refused_in_python():
    with pytest.raises(
        InputError, match=r"lean of the slot 60 mm from the start is 20 rad.*numpy\.radians\(20\)"
    ):
        Strip(optimal_rod(CURVE), "pom-0.5", slots=Slot(60, width=1.2, lean=20), **GIVEN)


@pytest.mark.parametrize(
    ("figure", "number"),
    [("max_strain", 2), ("youngs_modulus", 9.2e9), ("density", 0.68), ("thickness", 0.0008)],
)
def test_sheets_in_another_unit_are_refused(make, figure, number):
    with pytest.raises(InputError, match=f"{figure} = .* looks like the wrong unit") as result:
        make(CURVE, Sheet("mine", **FIGURES | {figure: number}), **GIVEN)
    assert "_mm" not in str(result.value)


@pytest.mark.parametrize(
    ("options", "instruction"),
    [
        ({"material": "pom-0.5"}, "sheet="), ({"thickness": 0.5}, "Sheet"), ({"name": "A"}, "label="),
        ({"tab": 12}, r"ends=ec\.Tab"), ({"holes": 3}, r"Hole"), ({"kerf": 0.1}, r"ec\.save"),
        ({"ends": 12}, r"Pass ec\.Tab\(12\)"), ({"ends": (Tab(10), 15)}, r"Pass ec\.Tab\(15\)"),
        ({"notch": 3}, "slots="), ({"width": 3}, "max_width="), ({"colour": "red"}, "did you mean color"),
    ],
)  # fmt: skip
def test_words_that_users_type_lead_to_the_option(make, options, instruction):
    with pytest.raises((InputError, TypeError), match=instruction):
        make(CURVE, "pom-0.5", **{"max_width": 12.0} | options)


@pytest.mark.parametrize("path", ["arch.dxf", Path("arch.dxf")])
def test_a_file_name_is_not_a_curve(make, path):
    with pytest.raises(InputError, match=r"'arch\.dxf' is not a curve.*read_curves"):
        make(path, "pom-0.5", **GIVEN)


POINTS = [(0, 0), (60, 50), (120, 0)]


@pytest.mark.parametrize("points", [POINTS, np.array(POINTS), tuple(map(tuple, POINTS))])
def test_points_are_not_a_curve(make, points):
    with pytest.raises(InputError, match=r"list of 3 points.*PlaneCurve\.fit\(points\)"):
        make(points, "pom-0.5", **GIVEN)


@pytest.mark.build123d
def test_vectors_are_not_a_curve():
    with pytest.raises(InputError, match="list of 3 points"):
        bd_strips.BentStrip([bd.Vector(*point) for point in POINTS], "pom-0.5", **GIVEN)
