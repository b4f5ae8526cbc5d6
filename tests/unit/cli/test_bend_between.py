"""`elastica bend` of finished strips on rails, pins and ties: other loads, shorter cords, rails that are moved."""

import json
import re

import numpy as np
import pytest

import elastica_cad as ec
from tests.command_line import run

WAVE = ec.PlaneCurve.spline(
    [(0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (360, 0)], degree=5
)
SHEET = "birch-plywood-0.8"


@pytest.fixture(scope="module")
def desk(tmp_path_factory):
    folder = tmp_path_factory.mktemp("desk")
    ec.write_curves([WAVE], folder / "wave.dxf")
    line = f"strip wave.dxf --sheet {SHEET} --max-width 40 --rail 200 --tie 40 310 --no-step --no-pictures -o out"
    run(line, cwd=folder)
    return folder


@pytest.fixture(autouse=True)
def without_pictures(monkeypatch):
    """As without matplotlib, for speed."""
    monkeypatch.setattr("elastica_cad.cli.bend_command.can_draw", lambda: False)


@pytest.fixture(scope="module")
def strip():
    return ec.make_strip(WAVE, SHEET, max_width=40, between=(ec.Rail(200), ec.Tie(40, 310)))


def test_holes_and_notches_of_pins_and_ties(desk):
    line = f"strip wave.dxf --sheet {SHEET} --max-width 40 --no-step --no-pictures -o"
    run(f"{line} holes --pin 200 --tie 40 310 --hole 0.4cm --json", cwd=desk)
    between = json.loads((desk / "holes" / "wave.json").read_text())["request"]["between"]
    assert [row["hole"] for row in between] == [4.0, 4.0]
    refused = run(f"{line} none --rail 200 --notch 2", cwd=desk, code=2)
    assert "--notch has no effect without --pin or --tie" in refused.stderr
    refused = run(f"{line} none --pin 200 --hole 4 --notch 2", cwd=desk, code=2)
    assert "Leave out --hole or --notch." in refused.stderr


def bent(options, folder):
    made = run(f"bend out/wave.json {options} --json --force", cwd=folder)
    return json.loads(made.stdout)


def test_options_name_the_same_elements_as_set(desk):
    report = json.loads((desk / "out/wave.json").read_text())
    assert [element["kind"] for element in report["between"]] == ["rail", "tie"]
    assert [element["at"] for element in report["between"]] == [[200.0], [40.0, 310.0]]


def test_a_mass_that_the_design_did_not_know(desk, strip):
    shape = bent("--point-mass 250 200", desk)["shapes"][0]
    gravity = ec.Sheet.named(SHEET).gravity((0.0, -1.0))
    own = ec.bend(strip.rod_to_bend, gravity=gravity, loads=ec.PointMass(250, 200))
    assert [element["kind"] for element in shape["between"]] == ["rail", "tie"]
    assert shape["between"][0]["force"][0] == pytest.approx(
        strip.bending_stiffness * own.between_forces[0], rel=0.02, abs=0.01
    )
    assert shape["size"] == pytest.approx(np.ptp(own.position, axis=0), abs=0.05)


def test_a_cord_is_shortened_in_steps(desk, strip):
    report = bent("--shorten 4 --steps 2", desk)
    start, end = strip.rod.between[1].s
    length = np.hypot(*np.diff(strip.rod.curve.at([start, end]).position, axis=0)[0])
    assert report["unit"] == "%"
    assert len(report["shapes"]) == 3
    for part, shape in zip((2, 4), report["shapes"][1:], strict=True):
        rail = ec.Rail(200)
        own = ec.bend(strip.rod_to_bend, between=(rail, ec.Tie(start, end, length=length - part)))
        pull = strip.bending_stiffness * np.hypot(*own.between_forces[1])
        assert np.hypot(*shape["between"][1]["force"][0]) == pytest.approx(pull, rel=0.02)


def test_the_rows_on_a_rail_that_is_moved(desk, strip):
    x, y = strip.rod.curve.at([200.0]).position[0]
    printed = run(f"bend out/wave.json --rail {x:.4f},{y + 2:.4f} --tie 40 310 --force", cwd=desk).stdout
    own = ec.bend(strip.rod_to_bend, between=(ec.Rail((x, y + 2)), ec.Tie(40, 310)))
    far = np.hypot(*(own.position - strip.rod.position).T).max()
    moved = re.search(
        r"Movement +the strip moves by at most ([\d.]+) mm from its design: the point (\d+) mm along", printed
    )
    assert float(moved[1]) == pytest.approx(far, abs=0.06)
    nearest = np.abs(strip.rod.s - float(moved[2])).argmin()
    moves = np.hypot(*(own.position - strip.rod.position).T)
    assert moves[nearest] == pytest.approx(far, rel=0.01)
    assert re.search(r"Between +rail 20\d mm from the start pushes", printed)
    assert re.search(r"Strain +at most [\d.]+ %, safety [\d.]+", printed)


def test_the_distance_of_a_slack_rail(desk, strip):
    point = strip.rod.curve.at([200.0]).position[0]
    x, y = 3 * strip.bending_stiffness * strip.rod.between_forces[0]
    printed = run(f"bend out/wave.json --point-force 200 {x:.4f} {y:.4f} --force", cwd=desk).stdout
    own = ec.bend(strip.rod_to_bend, loads=ec.PointForce(200, (x, y)))
    gap = np.hypot(*(own.position - point).T).min()
    slack = re.search(r"the rail [\d.]+ mm from the start is slack, ([\d.]+) mm away from the strip", printed)
    assert gap > 0.1
    assert float(slack[1]) == pytest.approx(gap, rel=0.05)


SLAT = "bend --straight 850 --hold-start clamped --hold-end slide-x --sheet birch-plywood-6 --max-width 100"


@pytest.mark.parametrize(
    ("options", "side", "warns"),
    [
        ("--rail 290,-3 --point-mass 570 10kg", "above", True),  # slack: the slat sags away from its bar
        ("--rail 290,-30 --point-mass 570 10kg", "above", True),
        ("--rail 290,11 --point-mass 570 10kg", "below", False),
        ("--rail 290,-3", "above", False),
    ],
)
def test_the_side_of_a_bar_is_stated_taut_and_slack(tmp_path, options, side, warns):
    result = run(f"{SLAT} {options}", cwd=tmp_path)
    assert re.search(rf"Between .*rail 29\d mm from the start .*\(bar {side} the strip\)", result.stdout)
    warning = "is on top of the strip and pushes it down"
    assert (warning in result.stderr) == warns


def test_a_slat_that_is_stretched_between_fixed_ends_names_the_sliding_end(tmp_path):
    message = "Let an end slide, with --hold-end slide-x."
    fixed = run(f"{SLAT.replace('slide-x', 'clamped')} --rail 290,18", cwd=tmp_path)
    assert message in fixed.stderr
    stretch = float(re.search(r"stretched by ([\d.]+) mm", fixed.stderr)[1])
    assert stretch > 2 * 18**2 / 850 * 0.9  # two straight pieces would be longer by about this
    assert message not in run(f"{SLAT} --rail 290,18 --force", cwd=tmp_path).stderr


def test_the_rows_on_a_mass_in_kilograms_without_elements(desk):
    printed = run("bend out/wave.json --release --point-mass 250 0.02kg --force", cwd=desk).stdout
    assert re.search(r"Load +20 g at 250 mm \(0.196 N\)", printed)
    sags = r"Movement +without rails, pins and ties, the strip sags by at most [\d.]+ mm under the load"
    far = r"it is at most [\d.]+ mm from its design"
    assert re.search(rf"{sags}: the point \d+ mm along the strip, (up|down)ward; {far}", printed)
    refused = run("bend out/wave.json --point-mass 250 8lb", cwd=desk, code=2)
    assert "'8lb' is not a mass. Give grams, or a mass with its unit such as 8kg." in refused.stderr


def test_the_examples_in_the_help_keep_their_lines():
    lines = run("bend --help").stdout.splitlines()
    assert sum(line.startswith("    elastica bend ") for line in lines) == 9


def test_a_strip_without_its_elements_snaps(desk):
    report = bent("--release", desk)
    assert report["shapes"][0]["between"] == []
    assert report["snaps_at"] == 0.0


@pytest.mark.parametrize("end", ["free", "pinned"])
def test_a_released_strip_that_nothing_holds_is_refused(desk, end):
    line = f"bend out/wave.json --release --hold-start {end} --hold-end free --force"
    refused = " ".join(run(line, cwd=desk, code=2).stderr.split())
    assert "Set --hold-start to pinned and --hold-end to roller-x" in refused


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (
            "--shorten 500",
            "The cord from 40 mm to 310 mm is 254 mm long, so it cannot be shortened by 500 mm.",
        ),
        ("--release --shorten 5", "--shorten needs a cord. Add --tie START END."),
        (
            "--tie 0 394.4 --shorten 5",
            "so the cord between them cannot become shorter. Add --hold-start free --hold-end free.",
        ),
        (
            "--rail 900",
            "The rail 900 mm from the start is not on the curve. Give a place from 0 to 394.424 mm along",
        ),
        ("--rail 10,10,10", "'10,10,10' is not a length"),
    ],
)
def test_refusals(desk, options, message):
    made = run(f"bend out/wave.json {options} --force", cwd=desk, code=2)
    assert message in " ".join(made.stderr.split())


def test_loads_need_the_size_of_a_strip(desk):
    ec.write_curves([ec.PlaneCurve.spline([(0, 0), (50, 60), (100, 0)], degree=2)], desk / "arch.dxf")
    made = run("bend arch.dxf --point-force 50 0 -1", cwd=desk, code=2)
    assert "Add --sheet, and --max-width or --rod" in made.stderr


def test_a_cord_on_a_straight_batten(tmp_path):
    line = "bend --straight 1200 --sheet gfrp-2 --max-width 30 --tie 240 960 --shorten 100 --json -o ."
    refused = run(line, cwd=tmp_path, code=2)
    assert "Set --side to the side to which it bulges." in refused.stderr
    made = json.loads(run(f"{line} --side left", cwd=tmp_path).stdout)
    (shape,) = made["shapes"]
    assert shape["stable"]
    assert np.hypot(*shape["between"][0]["force"][0]) == pytest.approx(7.37, abs=0.01)


def test_a_place_in_percent_is_refused(desk):
    refused = run(f"strip wave.dxf --sheet {SHEET} --tie 20% 80%", cwd=desk, code=2)
    assert "'20%' is a percentage. Give the distance from the start of the curve, in mm." in refused.stderr


def test_the_end_that_slides_loads_a_rail_that_is_not_in_the_middle(tmp_path):
    size = 'width="700mm" height="40mm" viewBox="0 0 700 40"'
    path = '<path d="M 20 30 C 135 30 220 16 330 16 C 452 16 560 30 680 30"/>'
    (tmp_path / "shelf.svg").write_text(f'<svg xmlns="http://www.w3.org/2000/svg" {size}>{path}</svg>')
    line = "strip shelf.svg --sheet birch-plywood-6 --max-width 100 --rail 311 --no-step --no-pictures -o"
    warned = run(f"{line} clamped", cwd=tmp_path).stderr
    result = r"so it may become slack .* Let the end slide \(set (.*) to (slide-x)\)"
    option, support = re.search(result, " ".join(warned.split())).groups()
    printed = run(f"{line} sliding {option} {support}", cwd=tmp_path).stdout
    assert "become slack" not in printed
    assert re.search(r"rail 311 mm from the start pushes the strip upward with 1\d0 N", printed)
    design = tmp_path / "shelf.toml"
    table = "schema = 1\nnest.sheet_size = [800, 400]\n[[strips]]\ncurve = 'shelf.svg'\nsheet = 'birch-plywood-6'\n"
    table += "max_width = 100\nbetween = [{ kind = 'rail', at = 311 }]\n"
    design.write_text(table)
    line = "model shelf.toml --no-step --no-pictures -o"
    warned = run(f"{line} clamped-model", cwd=tmp_path).stderr
    assert re.search(result, " ".join(warned.split())).groups() == ("the second value of supports", support)
    design.write_text(f"{table}supports = ['clamped', '{support}']\n")
    assert "become slack" not in run(f"{line} sliding-model", cwd=tmp_path).stderr


@pytest.mark.campaign
def test_the_force_is_the_larger_of_both_ends(desk):
    options = "--point-mass 100 200"
    report = bent(options, desk)
    travel, (shape,) = report["travel"], report["shapes"]
    start, end = ([travel[f"{which}_force_{axis}_N"][0] for axis in "xy"] for which in ("start", "end"))
    mass = json.loads((desk / "out/wave.json").read_text())["mass"]
    # supports, rail and tie carry the load and the strip, whose tabs are 5 % of its mass
    rail, tie = (np.sum(element["force"], axis=0) for element in shape["between"])
    carried = np.sum([start, end, rail, tie], axis=0)
    assert carried == pytest.approx([0.0, 9.80665e-3 * (200 + 0.95 * mass)], abs=2e-3)
    sizes = np.hypot(*np.transpose([start, end]))
    assert abs(sizes[0] - sizes[1]) > 0.1 * sizes.max()
    rows = run(f"bend out/wave.json {options} --force", cwd=desk).stdout
    assert float(re.search(r"Force +at most ([\d.]+) N", rows)[1]) == pytest.approx(sizes.max(), rel=6e-3)
    assert "start force x N" in rows


@pytest.mark.parametrize(
    ("load", "expected"),
    [
        ("--point-mass 250 3000", r"beyond a load of [\d.]+ N .*: use another sheet or a smaller change"),
        ("--set loads=[{at=250,mass=3000}] --gravity", r"already before the change .* or smaller loads"),
    ],
)
def test_a_load_that_strains_the_strip_too_much_is_not_called_travel(desk, load, expected):
    printed = run(f"bend out/wave.json {load} -o loaded --force", cwd=desk).stderr
    assert re.search(f"the strain exceeds the limit of the material {expected}", printed)
    assert "travel" not in printed


STRAIGHT = "bend --straight 500 --sheet birch-plywood-1.5 --max-width 20 --json -o ."


def test_a_loaded_bow_needs_the_supports_that_the_refusal_names(tmp_path):
    line = f"{STRAIGHT} --side left --tie 0 500 --shorten 20 --point-force 250 0 -1"
    refused = run(line, cwd=tmp_path, code=2).stderr
    option = re.search(
        r"free to move along x.* Set (\S+) to (\S+) and (\S+) to (\S+)\.", " ".join(refused.split())
    )
    printed = json.loads(run(f"{line} {' '.join(option.groups())}", cwd=tmp_path).stdout)
    assert option.group(4) == "roller-x"
    weight = ec.Sheet.named("birch-plywood-1.5").specific_weight * 1.5 * 20 * 500
    assert printed["travel"]["start_force_y_N"][-1] == pytest.approx((1 + weight) / 2)
    cord = np.array(printed["shapes"][-1]["between"][0]["force"])
    assert np.abs(cord[:, 1]).max() < 1e-9 * np.abs(cord[:, 0]).max()


def test_a_slider_under_a_cord_buckles_in_its_first_mode(tmp_path):
    """The moment at the slider holds the force across the cord."""
    line = f"{STRAIGHT} --side left --tie 0 500 --shorten 20 --hold-start pinned --hold-end slide-x"
    printed = json.loads(run(line, cwd=tmp_path).stdout)
    travel = printed["travel"]
    assert printed["shapes"][0]["stable"]
    assert travel["end_moment_Nmm"][0] == pytest.approx(-480 * travel["end_force_y_N"][0], rel=1e-6)


def test_a_pin_holds_a_strip_with_a_hinge_at_its_start(tmp_path):
    line = f"{STRAIGHT} --hold-end free --point-force 200 0 -1 --pin 400"
    hinged, pinned = (
        json.loads(run(f"{line} {ends} --force", cwd=tmp_path).stdout)["shapes"][0]
        for ends in ("--hold-start pinned", "--hold-start free --pin 0")
    )
    assert hinged["end"] == pytest.approx(pinned["end"], abs=1e-6)
