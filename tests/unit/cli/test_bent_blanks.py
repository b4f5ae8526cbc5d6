"""Strips bent beforehand, on the command line and in design files: a table of curvatures, or the blank drawn."""

import json

import pytest

from elastica_cad import PlaneCurve, make_strip, read_curves
from elastica_cad.design import read_design
from elastica_cad.formats import curves_json
from elastica_cad.mechanics import RestCurvature
from tests.command_line import run

ARCH = PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)], degree=4)
FLATTER = PlaneCurve.spline([(0, 0), (40, 30), (90, 42), (140, 30), (184, 0)], degree=4)
LENGTHS = ARCH.length / FLATTER.length
BLANK = FLATTER.transformed([[LENGTHS, 0, 0], [0, LENGTHS, 0], [0, 0, 1]])


@pytest.fixture
def drawn(tmp_path):
    for name, curve in (("arch", ARCH), ("blank", BLANK)):
        (tmp_path / f"{name}.json").write_text(curves_json([curve]))
    return tmp_path


def ratio_of(folder):
    return json.loads((folder / "arch.json").read_text())["ratio"]


def test_a_strip_of_a_drawn_blank(drawn, monkeypatch):
    monkeypatch.chdir(drawn)
    options = ("arch.json", "--natural-curvature", "blank.json")
    result = run("strip", *options, "--sheet", "birch-plywood-0.8", "--max-width", 20, "-o", "out")
    strip = make_strip(ARCH, "birch-plywood-0.8", natural_curvature=RestCurvature.of(BLANK), max_width=20.0)
    assert ratio_of(drawn / "out") == pytest.approx(strip.rod.ratio, rel=1e-6)
    assert "the smallest radius is" in result.output
    assert json.loads((drawn / "out" / "arch.json").read_text())["blank"]["curvature"]
    run("check", *options)


def test_the_unloaded_curve_of_many_strips_is_read_once(drawn, monkeypatch):
    monkeypatch.chdir(drawn)
    (drawn / "two.json").write_text(curves_json([ARCH, ARCH.transformed([[1, 0, 0], [0, 1, 90], [0, 0, 1]])]))
    options = ("two.json", "--all", "--natural-curvature", "blank.json", "--sheet", "birch-plywood-0.8")
    result = run("strip", *options, "--max-width", 20, "-o", "out")
    assert len([line for line in result.output.splitlines() if line.startswith("Read")]) == 2


def test_a_design_file_draws_the_blank(drawn):
    text = (
        'schema = 1\n[[strips]]\nlabel = "A"\nsheet = "birch-plywood-0.8"\nmax_width = 20\ncurve = "arch.json"\n'
        'natural_curvature = { curve = "blank.json" }\n'
    )
    (drawn / "design.toml").write_text(text)
    (entry,) = read_design(drawn / "design.toml", read_curves).entries
    assert entry.spec.natural_curvature == RestCurvature.of(BLANK)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ("nowhere.dxf", "is not a number or file"),
        ("nan", "not finite"),
        ("stations = [0, 100], curvatures = [0, 0]", "the pre-bent strip is 100 mm long"),
        ("stations = [0, 202]", "curvatures is missing"),
        ("stations = [5, 202], curvatures = [0, 0]", "Begin at 0 mm"),
    ],
)
def test_no_blank_is_refused_in_a_sentence(drawn, given, words):
    result = run(
        "strip",
        drawn / "arch.json",
        "--sheet",
        "birch-plywood-0.8",
        "--max-width",
        20,
        "--natural-curvature",
        given,
        "-o",
        drawn / "out",
        code=2,
    )
    assert result.exit_code != 0
    assert words in " ".join(result.output.split())
    assert not (drawn / "out").exists()
