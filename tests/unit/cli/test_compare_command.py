"""`elastica compare`, as it is typed: the page and the readings to fill in, then what they say."""

import json
import re
from dataclasses import replace

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad import InputError
from elastica_cad.design import read_design
from elastica_cad.design.measuring_sheet import read_measuring, read_readings
from elastica_cad.formats import curves_json
from elastica_cad.kit.kit_contents import kit_contents
from elastica_cad.kit.model_kit import model_kit
from tests.command_line import run


@pytest.fixture(scope="module")
def report(tmp_path_factory):
    folder = tmp_path_factory.mktemp("compare")
    drawn = folder / "arch.json"
    drawn.write_text(
        curves_json([ec.PlaneCurve.spline([(0, 0), (30, 120), (140, 170), (240, 90), (320, 0)])])
    )
    run(
        "strip",
        drawn,
        "--sheet",
        "birch-plywood-0.8",
        "--max-width",
        30,
        "--no-step",
        "--no-pictures",
        "-o",
        folder / "out",
    )
    return folder / "out" / "arch.json"


def test_a_page_and_readings_to_fill_in(report):
    run("compare", report)
    folder = report.parent
    assert "<svg" in (folder / "arch-measure.svg").read_text()
    readings = folder / "arch-measured.toml"
    assert readings.read_text().count("# height_") == 3
    run("compare", report, code=2)  # they are there
    filled = re.sub(r"^# (\w+ = [\d.]+)", r"\1", readings.read_text(), flags=re.MULTILINE)
    readings.write_text(filled)
    result = run("compare", report, readings)
    verdict, *values = result.output.splitlines()
    assert verdict.startswith("Verdict     All differences are within")
    assert [value[:11].strip() for value in values] == [
        "Readings", "Chord", "Height 1", "Height 2", "Height 3", "Start angle", "End angle"
    ]  # fmt: skip


def test_a_clamp_that_gives_way_is_reported(report, tmp_path):
    record = json.loads(report.read_text())["measuring"]
    turned = record["causes"]["clamp at the end"][0]
    readings = tmp_path / "measured.toml"
    values = {name: value + 4 * turned[name] for name, value in record["expected"].items()}
    readings.write_text("\n".join(f"{name} = {value:.1f}" for name, value in values.items()))
    verdict = "The clamp at the end lets the strip turn by 4 degrees. Tighten it."
    assert run("compare", report, readings).output.startswith(f"! Verdict   {verdict}\n")
    answer = json.loads(run("compare", report, readings, "--json").output)
    assert answer["rows"][0] == {"label": "Verdict", "text": verdict, "severity": "warning"}
    assert answer["notes"] == []


def test_errors_of_the_readings_are_typed_or_stand_in_the_file(report, tmp_path):
    """A difference of 2 mm counts for callipers; the option takes precedence over the file."""
    expected = json.loads(report.read_text())["measuring"]["expected"]
    readings = tmp_path / "measured.toml"
    text = f"height_2 = {expected['height_2'] - 2.0}\nheight_1 = {expected['height_1'] + 2.0}\n"
    readings.write_text(text)
    assert (
        "Measured values are assumed to be exact to 2 mm and 1 degree."
        in run("compare", report, readings).output
    )
    readings.write_text("reading_error = 0.1\nangle_error = 0.5\n" + text)
    output = run("compare", report, readings).output
    assert output.startswith("! Verdict")
    assert "Readings    Measured values are assumed to be exact to 0.1 mm and 0.5 degrees." in output
    output = run("compare", report, readings, "--reading-error", "2mm").output
    assert output.startswith("Verdict     All differences are within")
    assert "Readings    Measured values are assumed to be exact to 2 mm and 0.5 degrees." in output
    readings.write_text("reading_error = 'small'\n" + text)
    assert "reading_error is not a number" in run("compare", report, readings, code=2).output
    readings.write_text(text)
    assert "reading_error is 0" in run("compare", report, readings, "--reading-error", 0, code=2).output


@pytest.mark.parametrize(
    ("text", "idle"),
    [
        ("start_angle = 30", ["reading_error"]),
        ("chord = 300\nangle_error = 2", ["angle_error"]),
        ("chord = 300\nend_angle = 3\nangle_error = 2", []),
    ],
)
def test_a_note_names_the_error_of_readings_that_were_not_taken(report, tmp_path, text, idle):
    readings = tmp_path / "measured.toml"
    readings.write_text(text)
    output = run("compare", report, readings, "--reading-error", 1).output
    assert re.findall(r"^Note +(\w+) has no effect", output, re.MULTILINE) == idle


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("chord = 'wide'", "chord is not a number"),
        ("chord = ", "cannot be read"),
        ("chord = 37,5", "write decimals with a point, 37.5"),
        ("chord = 261.3\nheight_1 = -26,7", "(at line 2, column 15); write decimals with a point, -26.7"),
        ("", "an empty file is not among the expected"),
    ],
)
def test_readings_that_are_none(report, tmp_path, text, said):
    readings = tmp_path / "measured.toml"
    readings.write_text(text)
    result = run("compare", report, readings, code=2)
    assert said in result.output


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--reading-error", 1), "--reading-error has no effect without MEASURED"),
        (("measured.toml", "--force"), "--force has no effect beside MEASURED"),
    ],
)
def test_options_of_the_other_use_are_refused(report, tmp_path, words, said):
    (tmp_path / "measured.toml").write_text("chord = 300")
    assert said in run("compare", report, *words, cwd=tmp_path, code=2).output


def test_a_file_that_is_no_report(tmp_path):
    path = tmp_path / "other.json"
    path.write_text("{}")
    result = run("compare", path, code=2)
    assert "is not a report with quantities to measure" in result.output


def test_a_strip_with_a_rail_names_the_reason(tmp_path):
    (tmp_path / "bow.csv").write_text("0,0\n100,14\n200,20\n300,14\n400,0\n")
    options = "--sheet birch-plywood-1.5 --max-width 40 --rail 200 --no-step --no-pictures"
    run("strip", tmp_path / "bow.csv", *options.split(), "-o", tmp_path)
    refused = run("compare", tmp_path / "bow.json", code=2)
    assert "is the report of a strip with rails, pins, ties or point forces" in refused.output


def changed_records():
    """What is wrong in the record of a report: its path of keys, and the value there."""
    yield ("causes", "a clamp of none"), [dict.fromkeys(("chord",), 1.0)]
    yield ("causes", "ends apart"), []
    yield ("causes",), []
    yield ("shape", 3), 7
    yield ("shape",), [[1, 2]] * 9
    yield ("marks", 1), "1"
    yield ("expected", "chord"), True
    for wrong in (float("nan"), float("inf"), -1e308, 10**400, None, [], "x"):
        yield ("shape", 2, 1), wrong
        yield ("uncertain", "height_1"), wrong
        yield ("causes", "ends apart", 0, "chord"), wrong
    yield ("uncertain", "chord"), 0
    yield ("tips",), "far"


@pytest.mark.parametrize(("keys", "value"), list(changed_records()))
def test_a_damaged_report(report, tmp_path, keys, value):
    record = json.loads(report.read_text())
    *way, last = keys
    table = record["measuring"]
    for key in way:
        table = table[key]
    table[last] = value
    damaged = tmp_path / "damaged.json"
    damaged.write_text(json.dumps(record))
    with pytest.raises(InputError, match="not a report with quantities to measure"):
        read_measuring(damaged)


@pytest.mark.parametrize("text", ["[" * 20_000, '{"measuring": 7}', "7", '{"measuring": []}'])
def test_a_report_of_another_kind(tmp_path, text):
    file = tmp_path / "other.json"
    file.write_text(text)
    with pytest.raises(InputError, match="not a report with quantities to measure"):
        read_measuring(file)


@pytest.mark.parametrize(
    "text", ["chord = nan", "chord = inf", "chord = 1e300", f"chord = {10**400}", "chord = " + "[" * 20_000]
)
def test_readings_that_nobody_can_have_measured(tmp_path, text):
    file = tmp_path / "readings.toml"
    file.write_text(text)
    with pytest.raises(InputError, match=r"readings\.toml"):
        read_readings(file)


@pytest.fixture(scope="module")
def lesson(tmp_path_factory):
    """Return the report of a model of three strips of one length."""
    folder = tmp_path_factory.mktemp("lesson")
    (folder / "lesson.toml").write_text(LESSON)
    run("model", folder / "lesson.toml", "-o", folder / "out", "--no-step", "--no-parts", "--no-pictures")
    return folder / "out" / "lesson.json"


LESSON = """
sheet = "card-200gsm"
max_width = 25
length = 180
[[strips]]
label = "hill"
curve = { spline = [[0, 0], [40, 70], [140, 70], [180, 0]], degree = 3 }
[[strips]]
label = "wave"
origin = [0, 100, 0]
curve = { spline = [[0, 0], [60, 70], [80, -70], [140, 0]], degree = 3 }
[[strips]]
count = 2
label = "rainbow {i}"
origin = [0, "200 * i", 0]
curve = { ellipse = { semi_axes = [90, 60], start = 0.3, end = 2.8 } }
"""


def test_strips_of_a_model_are_compared_by_name(lesson):
    parts = {part["name"]: part for part in json.loads(lesson.read_text())["parts"]}
    assert {part["length"] for part in parts.values()} == {180.0}
    run("compare", lesson)
    folder = lesson.parent
    pages = {f"lesson-{name}-measure.svg" for name in ("hill", "wave", "rainbow-1", "rainbow-2")}
    assert {path.name for path in folder.glob("*-measure.svg")} == pages
    readings = folder / "lesson-measured.toml"
    assert re.findall(r"^\[(.*)\]$", readings.read_text(), flags=re.MULTILINE) == [
        "hill", "wave", '"rainbow 1"', '"rainbow 2"',
    ]  # fmt: skip
    apart = parts["rainbow 2"]["measuring"]["causes"]["ends apart"][0]
    expected = parts["rainbow 2"]["measuring"]["expected"]
    off = "\n".join(f"{name} = {value + 4 * apart[name]:.2f}" for name, value in expected.items())
    measured = folder / "readings.toml"
    measured.write_text(
        f'hill.chord = {parts["hill"]["measuring"]["expected"]["chord"]:.1f}\n["rainbow 2"]\n{off}\n'
    )
    lines = run("compare", lesson, measured).output.splitlines()
    assert [line for line in lines if line.startswith("Strip")] == [
        "Strip       hill",
        "Strip       rainbow 2",
    ]
    assert lines[1].startswith("Verdict     All differences are within")
    assert lines[6].startswith("! Verdict   The distance between the ends is 4 mm off.")
    assert set(json.loads(run("compare", lesson, measured, "--json").output)["expected"]) == {*parts}


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("chord = 3", "'' is not a strip of the model. Write the readings below the lines [hill]"),
        ("[hil]\nchord = 3", "'hil' is not a strip of the model"),
        ("[hill]\ncord = 3", "cord is not among the expected"),
        ("[hill.wave]\nchord = 3", "wave is not a number"),
    ],
)
def test_readings_of_no_strip(lesson, tmp_path, text, said):
    readings = tmp_path / "measured.toml"
    readings.write_text(text)
    assert said in run("compare", lesson, readings, code=2).output


def test_a_table_in_the_readings_of_one_strip(report, tmp_path):
    readings = tmp_path / "measured.toml"
    readings.write_text("[arch]\nchord = 3")
    assert "the report is of a single strip" in run("compare", report, readings, code=2).output


def test_templates_and_pages_to_measure_are_one_file(tmp_path, monkeypatch):
    """The PDF of a model without holders has strips, holding templates, and a page to measure each strip."""
    (tmp_path / "lesson.toml").write_text(LESSON.replace("count = 2", "count = 1"))
    read = read_design(tmp_path / "lesson.toml", ec.read_curves)
    contents = kit_contents(read.model(), replace(read.kit, pages="A4"), effects=True)
    drawings = []
    monkeypatch.setattr(
        "elastica_cad.plot.template_pages.save_templates", lambda drawn, *_, **__: drawings.extend(drawn)
    )
    (pages,) = (file for file in model_kit(contents, step=False).files if file.name.endswith("pages.pdf"))
    pages.write(tmp_path / pages.name)
    measuring = {drawing.name: drawing for drawing in drawings if drawing.name.endswith("-measure")}
    assert [*measuring] == ["hill-measure", "wave-measure", "rainbow 1-measure"]
    for drawing in measuring.values():
        width, height = np.ptp(drawing.bounds, axis=0)
        assert width < 277
        assert height < 190
        chord = next(item.path for item in drawing.paths if item.layer == "MARK")
        assert np.ptp(chord.points(0.1)[:, 1]) < 1e-9
    names = " ".join(drawing.name for drawing in drawings)
    assert all(f"{name} template" in names for name in ("hill", "wave", "rainbow 1"))


def test_without_effects_there_is_nothing_to_compare(lesson, tmp_path):
    report = json.loads(lesson.read_text())
    for part in report["parts"]:
        part["measuring"] = None
    (tmp_path / "lesson.json").write_text(json.dumps(report))
    assert "without --no-effects" in run("compare", tmp_path / "lesson.json", code=2).output
