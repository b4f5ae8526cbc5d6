"""What a workshop is told of strips whose blanks are bent beforehand: no cut pattern shows it."""

import json

import numpy as np
import pytest

from elastica_cad import PlaneCurve, make_strip, read_curves
from elastica_cad.design import read_design
from elastica_cad.design.reports import pre_bend_message, report_blank
from elastica_cad.kit.kit_contents import kit_contents
from elastica_cad.kit.model_kit import model_kit
from elastica_cad.mechanics import RestCurvature

LEFT = PlaneCurve.arc((0, 0), 100, 0, 1)
DESIGN = """schema = 1
sheet = "birch-plywood-0.8"
max_width = 20
[[strips]]
label = "bent"
curve = { spline = [[0, 0], [40, 60], [90, 80], [140, 50], [190, 0]] }
natural_curvature = -0.004
[[strips]]
label = "like{i}"
count = 2
curve = { spline = [[0, 0], [40, 60], [90, 80], [140, 50], [190, 0]] }
natural_curvature = -0.004
slots = [{ at = "40 + 20 * i", width = 1 }]
[[strips]]
label = "flat"
curve = { spline = [[0, 0], [40, 60], [90, 80], [140, 50], [190, 0]] }
"""


def made(rest, curve=LEFT):
    return make_strip(curve, "birch-plywood-0.8", max_width=20, natural_curvature=rest)


def test_a_flat_blank_is_not_reported():
    assert report_blank(made(0.0)) is None
    assert pre_bend_message(made(0.0)) == ""


@pytest.mark.parametrize(
    ("rest", "way"), [(0.004, "is also the inner face at"), (-0.004, "is the outer face at")]
)
def test_an_even_blank_is_named_by_its_radius_and_by_how_the_strip_stands(rest, way):
    assert report_blank(made(rest)) == {"s": [0.0, 100.0], "curvature": [rest, rest]}
    message = pre_bend_message(made(rest))
    assert "to a radius of 250 mm along its whole length" in message
    assert way in message


def test_a_blank_that_varies_is_listed_along_the_strip():
    found = made(RestCurvature.linear([0, LEFT.length / 2, LEFT.length], [0, -0.008, 0.004]))
    record = report_blank(found)
    assert np.interp([0, 25, 50, 75, 100], record["s"], record["curvature"]) == pytest.approx(
        [0, -0.004, -0.008, -0.002, 0.004], abs=1e-4
    )
    there = "125 mm, at 50 mm from the start. There, the inner face of this bend is the outer face after"
    assert there in pre_bend_message(found)


def test_kits_report_which_parts_are_bent_beforehand(tmp_path):
    (tmp_path / "two.toml").write_text(DESIGN)
    design = read_design(tmp_path / "two.toml", read_curves)
    kit = kit_contents(design.model(), design.kit, entries=design.entries)
    model_kit(kit, step=False, pictures=False, parts=False).write(tmp_path / "kit")
    report = json.loads((tmp_path / "kit" / "two.json").read_text())
    blanks = {part["name"]: part["blank"] for part in report["parts"]}
    assert blanks["flat"] is None
    assert blanks["bent"]["curvature"] == [-0.004, -0.004]
    (message,) = [line for line in report["reports"] if "Before assembly" in line]
    assert blanks["like2"] == blanks["bent"]
    assert message.startswith(
        "bent (and 2 more): Before assembly, bend the strip to a radius of 250 mm along its whole length. "
    )
    assert message in (tmp_path / "kit" / "index.html").read_text()
