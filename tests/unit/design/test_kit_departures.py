"""The report of a kit says how far each strip is from the curve it was made after."""

import json

import pytest

import elastica_cad as ec
from elastica_cad.design import read_design
from elastica_cad.kit.kit_contents import kit_contents
from elastica_cad.kit.model_kit import model_kit

DESIGN = """schema = 1
sheet = "card-200gsm"
max_width = 20
[[strips]]
label = "near"
curve = { spline = [[0, 0], [40, 60], [90, -30], [140, 50], [190, 0]] }
limits = { ratio = 1.5 }
[[strips]]
label = "exact"
curve = { spline = [[0, 0], [40, 60], [90, 80], [140, 50], [190, 0]] }
[[patterns]]
mirror = { normal = [0, 1, 0] }
"""


def test_departures_from_drawn_curves(tmp_path):
    (tmp_path / "two.toml").write_text(DESIGN)
    design = read_design(tmp_path / "two.toml", ec.read_curves)
    kit = kit_contents(design.model(), design.kit, entries=design.entries)
    model_kit(kit, step=False, pictures=False, parts=False).write(tmp_path / "kit")
    parts = {part["name"]: part for part in json.loads((tmp_path / "kit" / "two.json").read_text())["parts"]}
    wanted = ec.nearest_rod(
        design.entries[0].curve, ec.Limits(ratio=1.5, sheet=ec.Sheet.named("card-200gsm"))
    ).deviation
    assert wanted > 1.0
    assert parts["near"]["deviation"] == pytest.approx(wanted, rel=1e-2)
    assert parts["exact"]["deviation"] == pytest.approx(0.0, abs=1e-6)
    assert "section" not in parts["near"]
