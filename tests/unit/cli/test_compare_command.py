"""`elastica compare`, as it is typed: the page and the readings to fill in, then what they say."""

import json
import re

import pytest

import elastica_cad as ec
from elastica_cad import InputError
from elastica_cad.design.measuring_sheet import read_measuring, read_readings
from elastica_cad.formats import curves_json
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
    told = run("compare", report, readings)
    verdict, *values = told.output.splitlines()
    assert verdict.startswith("Verdict     All differences are within")
    assert [value[:11].strip() for value in values] == [
        "Chord", "Height 1", "Height 2", "Height 3", "Start angle", "End angle"
    ]  # fmt: skip


def test_a_clamp_that_gives_way_is_told(report, tmp_path):
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


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("chord = 'wide'", "chord is not a number"),
        ("chord = ", "cannot be read"),
        ("", "an empty file is not among the expected"),
    ],
)
def test_readings_that_are_none(report, tmp_path, text, said):
    readings = tmp_path / "measured.toml"
    readings.write_text(text)
    told = run("compare", report, readings, code=2)
    assert said in told.output


def test_a_file_that_is_no_report(tmp_path):
    path = tmp_path / "other.json"
    path.write_text("{}")
    told = run("compare", path, code=2)
    assert "is not the report of an open strip" in told.output


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
    with pytest.raises(InputError, match="not the report of an open strip"):
        read_measuring(damaged)


@pytest.mark.parametrize("text", ["[" * 20_000, '{"measuring": 7}', "7", '{"measuring": []}'])
def test_a_report_of_another_kind(tmp_path, text):
    file = tmp_path / "other.json"
    file.write_text(text)
    with pytest.raises(InputError, match="not the report of an open strip"):
        read_measuring(file)


@pytest.mark.parametrize(
    "text", ["chord = nan", "chord = inf", "chord = 1e300", f"chord = {10**400}", "chord = " + "[" * 20_000]
)
def test_readings_that_nobody_can_have_measured(tmp_path, text):
    file = tmp_path / "readings.toml"
    file.write_text(text)
    with pytest.raises(InputError, match=r"readings\.toml"):
        read_readings(file)
