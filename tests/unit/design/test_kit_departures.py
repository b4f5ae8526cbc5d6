"""The report of a kit says how far each strip is from the curve it was made after."""

import json

import pytest

import elastica_cad as ec
from elastica_cad.design import read_design
from elastica_cad.kit.kit_contents import kit_contents
from elastica_cad.kit.model_kit import model_kit
from elastica_cad.strip.summary import strip_rows

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


RODS = """schema = 1
sheet = "{sheet}"
section = {{ kind = "rod", limits = [{diameter}, {diameter}] }}
limits = {{ ratio = 1.0 }}
[[strips]]
label = "hoop"
curve = {{ ellipse = {{ semi_axes = [400, 400], start = 0, end = 3.14159265358979 }} }}
"""


def contents_of(tmp_path, text):
    (tmp_path / "model.toml").write_text(text)
    design = read_design(tmp_path / "model.toml", ec.read_curves)
    return kit_contents(design.model(), design.kit, entries=design.entries)


def test_a_curve_that_the_limits_change_much_needs_thinner_stock(tmp_path):
    """A fibre glass rod of 8 mm withstands a radius of 482 mm, and 6 mm withstands 361 mm."""
    contents = contents_of(tmp_path, RODS.format(sheet="glass-rod-8", diameter=8))
    first = contents.report["reports"][0]
    assert first.severity == "warning"
    assert "change the curves of hoop" in first
    assert "at most 6 mm thick" in first
    assert first.values["percent"] > 3
    thinner = contents_of(tmp_path, RODS.format(sheet="glass-rod-6", diameter=6))
    assert not any("The limits change" in text for text in thinner.report["reports"])


def test_a_model_reports_tipping_and_loads_as_a_strip_does(tmp_path):
    (tmp_path / "model.toml").write_text(RODS.format(sheet="glass-rod-5", diameter=5))
    design = read_design(tmp_path / "model.toml", ec.read_curves)
    contents = kit_contents(design.model(), design.kit, entries=design.entries)
    strip = contents.model.strips[0]
    row = next(row for row in strip_rows(strip) if row.label == "Stability")
    assert "tip" in row.text
    assert f"hoop: {row.text}" in contents.report["reports"]
    part = contents.report["parts"][0]
    assert part["sideways"]["word"] == strip.sideways.word
    assert part["reactions"]["start_force"] == pytest.approx(strip.reactions().start_force.tolist(), rel=1e-3)
    assert part["reactions"]["end_moment"] == pytest.approx(strip.reactions().end_moment, rel=1e-3)


@pytest.mark.parametrize(
    ("sheet", "cut", "told", "value"),
    [
        ("birch-plywood-0.8", "", "parts 0.15 mm narrower and slots wider. ", "sheet"),
        ("pom-3", "", "parts narrower and slots wider. ", "the width of the cut"),
        ("birch-plywood-0.8", "[cut]\nkerf = 0.2\n", None, None),
        ("birch-plywood-0.8", "[cut]\nkerf = 'sheet'\n", None, None),
    ],
)
def test_a_model_reports_a_kerf_that_is_not_compensated(tmp_path, sheet, cut, told, value):
    arch = "curve = { spline = [[0, 0], [400, 300], [900, 500], [1400, 300], [1800, 0]] }"
    nest, strip = "[nest]\nsheet_size = [2500, 400]", f"[[strips]]\nlabel = 'arch'\n{arch}"
    text = f"sheet = '{sheet}'\nmax_width = 40\n{cut}{nest}\n{strip}\n"
    notes = [note for note in contents_of(tmp_path, text).report["reports"] if "kerf" in note]
    assert len(notes) == (told is not None)
    assert all(f"The files do not compensate the kerf, which makes {told}" in note for note in notes)
    assert all(
        f"Accuracy assumes a compensated kerf. Set cut.kerf to {value}, unless" in note for note in notes
    )


def test_rods_that_are_sawn_have_no_kerf(tmp_path):
    text = RODS.format(sheet="glass-rod-4", diameter=4)
    assert not any("kerf" in note for note in contents_of(tmp_path, text).report["reports"])


CROSSED = """schema = 1
sheet = "card-200gsm"
max_width = 45
gravity = true
ends = { length = 18, width = 18 }
interlock = { above = [0, 0, 1] }
[[strips]]
count = 2
label = "S{i}"
let.way = "2.7 * degrees * (i - 1)"
origin = ["600 * cos(way)", "600 * sin(way)", 0]
x_axis = ["cos(way)", "sin(way)", 0]
y_axis = [0, 0, 1]
curve = { ellipse = { center = [0, 20], semi_axes = [75, 112.5], rotation = "(0.4 + 0.1 * i) * pi", above = 0 } }
"""


def notes_on_slots(tmp_path, text):
    (tmp_path / "crossed.toml").write_text(text)
    design = read_design(tmp_path / "crossed.toml", ec.read_curves)
    contents = kit_contents(design.model(), design.kit, entries=design.entries, effects=True)
    said = [str(text) for text in contents.notes if "clearance of slots" in text]
    far = [shape.deviation for shape in contents.held.values() if shape.deviation > 0.1]
    return said, far


def test_strips_that_leave_their_slots_are_told_by_a_range_and_by_what_helps(tmp_path):
    (said,), far = notes_on_slots(tmp_path, CROSSED)
    assert len(far) == 2
    assert f"2 strips deviate from their design by {min(far):.2g} mm to {max(far):.2g} mm" in said
    assert "compensate = true reduces the deviation, of S1" in said
    assert "Tabs as wide as the strip (ends.width) reduce the deviation, of S1" in said
    _, compensated = notes_on_slots(tmp_path, CROSSED.replace("max_width", "compensate = true\nmax_width"))
    _, wide = notes_on_slots(tmp_path, CROSSED.replace(", width = 18", ""))
    assert max(compensated) < 0.9 * max(far)
    assert max(wide) < 0.5 * max(far)
