"""`elastica pair` as it is typed: two curves or a design file in, files out, refusals as sentences."""

import json
import shutil
from pathlib import Path

import ezdxf
import numpy as np
import pytest

from elastica_cad import InputError, read_curves
from elastica_cad.design.pair_table import read_pair
from elastica_cad.plot.drawing_process import drawing_process
from tests.command_line import run

EXAMPLES = Path(__file__).parents[3] / "examples" / "two_states"


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """The files of the clip, whose curves are the two of one drawing."""
    folder = tmp_path_factory.mktemp("clip")
    drawing = EXAMPLES / "clip.svg"
    with drawing_process(["pair"]) as process:  # as `main` starts it
        return folder, run(
            "pair", drawing, "--sheet", "pom-3", "--label", "CLIP", "--kerf", "0.2", "-o", folder, obj=process
        )


def test_two_curves_become_cutting_files_bodies_picture_and_report(made):
    folder, result = made
    assert result.exit_code == 0, result.output
    assert "bistable" in result.output
    assert "clip.dxf (cut, 0.2 mm kerf included)" in result.output
    assert "clip-holder.dxf (holder, cut, 0.2 mm kerf included)" in result.output
    assert {file.name for file in folder.iterdir()} == {
        *(f"clip{kind}" for kind in (".dxf", ".svg", ".step", ".stl", ".png", ".json", "-force.csv")),
        "clip-up.step", "clip-down.step",
        "clip-holder.dxf", "clip-holder.svg", "clip-holder.stl",
    }  # fmt: skip
    report = json.loads((folder / "clip.json").read_text())
    assert report["states"] == ["up", "down"]
    # the curves are drawn one above the other
    assert report["second_state_turned_deg"] == pytest.approx(0, abs=1e-6)
    assert report["second_state_moved_mm"] == pytest.approx(16, abs=0.1)
    assert "Position" not in result.output
    assert report["force_direction_deg"] == pytest.approx(-90, abs=0.5)
    assert "0.90 % (up) and 0.90 % (down)" in result.output
    assert "bistable: pushed downward at 77.3 mm from the start" in result.output
    assert report["bistable"] is True
    assert report["strain_on_the_way"] <= report["max_strain"]
    assert report["reports"] == []
    drawn = ezdxf.readfile(folder / "clip.dxf").modelspace()
    kinds = [entity.dxftype() for entity in drawn if entity.dxf.layer == "CUT_OUTER"]
    assert kinds.count("SPLINE") == 2
    assert sum(entity.dxf.layer == "CUT_INNER" for entity in drawn) == 4


def test_the_printed_holder_is_the_plate_of_its_drawing(made):
    """Against the area of a rectangle with round corners, less the holes of the drawing without its kerf."""
    data = (made[0] / "clip-holder.stl").read_bytes()[84:]
    corners = np.frombuffer(data, [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])[
        "corners"
    ]
    assert (corners[..., 2].min(), corners[..., 2].max()) == (0, 3)
    volume = np.linalg.det(corners.astype(float)).sum() / 6
    drawn = ezdxf.readfile(made[0] / "clip-holder.dxf").modelspace()
    loops = [entity for entity in drawn if entity.dxf.layer in ("CUT_OUTER", "CUT_INNER")]
    radii = [loop.dxf.radius + 0.1 for loop in loops if loop.dxftype() == "CIRCLE"]  # half of the kerf
    size = np.ptp(corners.reshape(-1, 3), axis=0)
    corner = 3.2  # radius of the corners of the plate, that of a hole's diameter
    area = size[0] * size[1] - (4 - np.pi) * corner**2 - np.pi * sum(r**2 for r in radii)
    assert len(radii) == 4
    assert volume == pytest.approx(3 * area, rel=2e-4)


def test_a_design_file_requests_the_same(made, tmp_path):
    """What a laser takes is told, where no kerf makes up for it."""
    result = run("pair", EXAMPLES / "clip.toml", "-o", tmp_path)
    assert (
        "A laser cut of 0.2 mm makes the thinnest place 0.75 mm wide instead of 0.95 mm and leaves 49 %"
        in result.stderr
    )
    reports = [json.loads((folder / "clip.json").read_text()) for folder in (made[0], tmp_path)]
    assert reports[0]["states"] == reports[1]["states"]
    assert reports[0]["least_thickness_mm"] == pytest.approx(reports[1]["least_thickness_mm"], rel=1e-9)


LOW = """<svg xmlns="http://www.w3.org/2000/svg" width="170mm" height="90mm" viewBox="0 0 170 90">
<path d="M10,40 C38,40 58,18 84,18 C108,18 134,40 160,40"/>
<path d="M10,50 C34,50 54,60 80,60 C108,60 136,50 160,50"/>
</svg>"""


def test_a_curve_that_was_changed_much_is_reported(tmp_path):
    (tmp_path / "low.svg").write_text(LOW)
    result = run(
        "pair", tmp_path / "low.svg", "--sheet", "pom-3", "--kerf", "0.2", "-o", tmp_path / "out", "--json"
    )
    report = json.loads(result.stdout)["pair"]
    (message,) = report["reports"]
    assert "moved by up to" in message
    assert max(report["moved_mm"]) > 0.03 * 151.6  # the diagonal of the box of the larger one


def test_a_part_without_a_second_rest_is_not_called_bistable(tmp_path):
    design = """schema = 1
[pair]
first = { spline = [[0, 0], [27, 0], [53, 6], [105, 6], [123, 0], [150, 0]], degree = 4 }
second = { spline = [[0, 0], [27, 0], [53, -5], [105, -5], [123, 0], [150, 0]], degree = 4 }
sheet = "pom-3"
least_thickness = 2.8
"""
    (tmp_path / "low.toml").write_text(design)
    result = run("pair", tmp_path / "low.toml", "--kerf", "0.2", "-o", tmp_path / "out")
    assert "not bistable: the part keeps one curve (second state) only while" in result.stdout
    assert "snaps" not in result.stdout
    assert "rests near one curve only (second state)" in result.stderr
    report = json.loads((tmp_path / "out" / "low.json").read_text())
    assert (report["bistable"], report["reaches_second_state"]) == (False, False)
    assert max(report["rest_deviation_mm"]) > 3
    assert "largest_force_back_N" not in report


MEETING = """<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="160mm" viewBox="0 0 200 160">
<path d="M20,20 C60,20 110,30 130,110"/><path d="M20,20 C70,10 120,40 100,120"/></svg>"""


HALVES = [f"<path{half}" for half in MEETING.removesuffix("</svg>").split("<path")[1:]]


def test_curves_that_meet_in_their_drawing_begin_where_they_meet(tmp_path):
    """They are as thick as wider pads take."""
    (tmp_path / "finger.svg").write_text(MEETING)
    result = run("pair", tmp_path / "finger.svg", "--sheet", "pom-3", "-o", tmp_path / "out", "--json")
    report = json.loads(result.stdout)["pair"]
    assert report["largest_thickness_mm"] > 5
    assert max(*report["strain"], report["strain_on_the_way"]) <= report["max_strain"] * (1 + 1e-9)


@pytest.mark.parametrize("names", [("", ""), ('id="open"', 'id="shut"')])
@pytest.mark.parametrize("swapped", [False, True])
def test_the_order_in_the_file_decides_first_and_second(tmp_path, names, swapped):
    """Also of curves that meet, whose chain would begin with the second one."""
    paths = [path.replace("<path", f"<path {name}") for path, name in zip(HALVES, names, strict=True)]
    body = "".join(reversed(paths) if swapped else paths)
    (tmp_path / "finger.svg").write_text(f"{MEETING.splitlines()[0]}{body}</svg>")
    text = run("pair", tmp_path / "finger.svg", "--sheet", "pom-3", "--match", "none", code=2).output
    lengths = (159.828, 156.2) if swapped else (156.2, 159.828)  # of both Bezier curves, own sum
    assert "the first curve is {:g} mm long, the second {:g} mm".format(*lengths) in text
    assert "not joined" not in text


@pytest.mark.parametrize("words", [("clip.toml",), pytest.param(
    ("clip.svg", "clip.svg", "--first", "up", "--second", "down", "--sheet", "pom-3"), marks=pytest.mark.campaign,
)])  # fmt: skip
def test_other_keys_are_set(words, tmp_path):
    files = [EXAMPLES / word if word.startswith("clip.") else word for word in words]
    run("pair", *files, "--set", "pad.hole=2", "--kerf", "0", "-o", tmp_path)
    drawn = ezdxf.readfile(tmp_path / "clip.dxf").modelspace()
    holes = [entity for entity in drawn if entity.dxf.layer == "CUT_INNER"]
    assert [hole.dxf.radius for hole in holes] == pytest.approx([1.0] * 4)


def test_a_printed_stand_has_two_settings(tmp_path):
    result = run("pair", EXAMPLES / "stand.toml", "--set", "first_state=steep", "-o", tmp_path, "--json")
    assert "laser" not in result.stderr
    report = json.loads(result.output)["pair"]
    assert report["states"] == ["steep", "second state"]
    assert {"stand-steep.step", "stand-second-state.step"} <= {file.name for file in tmp_path.iterdir()}
    engraved = ezdxf.readfile(tmp_path / "stand-holder.dxf").modelspace().query('*[layer=="ENGRAVE"]')
    assert len(engraved)
    assert report["bistable"] is False
    assert max(*report["strain"], report["strain_on_the_way"]) <= report["max_strain"]
    assert report["reports"] == []


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("clip.svg",), "The sheet is missing"),
        (("up.svg", "--sheet", "pom-3"), "needs two curves, but up.svg has 1"),
        (("clip.svg", "clip.svg", "--sheet", "pom-3"), "--first 1 .. --first 2"),
        (("clip.svg", "--sheet", "pom-3", "--fillet", "12"), "does not fit"),
        (("clip.toml", "clip.svg", "--sheet", "pom-3"), "Leave out the other arguments"),
        (("clip.svg", "clip.svg", "--first", "up", "--second", "down", "--sheet", "pom-3", "--match", "none"),
         "Set --match to \"ends\""),
        (("clip.svg", "clip.svg", "--first", "up", "--second", "down", "--sheet", "mdf-3"), "Add --scale "),
        (("clip.svg", "--sheet", "pom-3", "--kerf", "sheet"), "The width of the cut is not known for pom-3"),
        (("wrong.toml",), "unknown key 'thickness'"),
        (("clip.svg", "--sheet", "pom-3", "--set", "files.paper=A4"), "the keys here are scale, match"),
        (("clip.toml", "--set", "first_state=down"), "Both states have the name down"),
        (("clip.toml", "--free", "first", "--objective", "ratio"), "objective has no effect beside free"),
        (("clip.toml", "--kerf", "0.1", "--set", "cut.kerf=0.2"), "--kerf and --set cut.kerf set the same value"),
        (("model.toml",), "no table [pair]"),
    ],
)  # fmt: skip
def test_what_cannot_be_made_is_refused_in_one_sentence(words, told, tmp_path, monkeypatch):
    for file in EXAMPLES.iterdir():
        shutil.copy(file, tmp_path)
    drawn = (tmp_path / "clip.svg").read_text()
    (tmp_path / "up.svg").write_text(drawn.replace('id="down"', 'display="none"'))
    wrong = (tmp_path / "clip.toml").read_text().replace("[pair]", "[pair]\nthickness = 2")
    (tmp_path / "wrong.toml").write_text(wrong)
    (tmp_path / "model.toml").write_text("schema = 1\n")
    monkeypatch.chdir(tmp_path)
    result = run("pair", *words, "-o", "out", code=2)
    assert result.exit_code in (1, 2)
    assert told in result.output
    assert not (tmp_path / "out").exists()


def test_a_model_command_names_the_one_that_makes_pairs(tmp_path):
    result = run("model", EXAMPLES / "clip.toml", "-o", tmp_path / "out", code=2)
    assert "elastica pair" in result.output


def test_keys_at_the_top_of_a_design_apply_to_a_pair_or_are_refused(tmp_path):
    states = "".join(
        f"{state} = {{ spline = [[0, 0], [27, 0], [53, {y}], [105, {y}], [123, 0], [150, 0]], degree = 4 }}\n"
        for state, y in (("first", 24), ("second", -20))
    )
    path = tmp_path / "clip.toml"
    path.write_text(f'schema = 1\nsheet = "pom-2"\nsmooth = 0.2\n[pair]\n{states}')
    spec = read_pair(path, read_curves)
    assert (spec.sheet.name, spec.smooth) == ("pom-2", 0.2)
    for key in ("max_width = 9", "limits = { ratio = 3 }", "gravity = true"):
        path.write_text(f'schema = 1\nsheet = "pom-2"\n{key}\n[pair]\n{states}')
        with pytest.raises(InputError, match=f"{key.split()[0]} has no effect on a part with two states"):
            read_pair(path, read_curves)
