"""`elastica check` of curves on rails, pins and ties."""

import json
import re
import shlex
import shutil

import pytest

import elastica_cad as ec
from tests.command_line import run, suggested_commands

WAVE = ec.PlaneCurve.spline(
    [(0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (360, 0)], degree=5
)


@pytest.fixture(scope="module")
def desk(tmp_path_factory):
    folder = tmp_path_factory.mktemp("desk")
    ec.write_curves([WAVE], folder / "wave.dxf")
    return folder


def test_a_rail_makes_the_curve_possible(desk):
    assert "cannot take this curve" in run("check wave.dxf", cwd=desk, code=1).output
    (report,) = json.loads(run("check wave.dxf --rail 200 --json", cwd=desk).stdout)
    rod = ec.optimal_rod(WAVE, between=ec.Rail(200))
    assert report["realizable"]
    assert report["ratio"] == pytest.approx(rod.ratio, rel=1e-6)
    assert report["stability"]["margin"] == pytest.approx(ec.stability(rod).margin, rel=1e-6)
    # the rail pushes the strip down, to the right, so its bar is on the left
    assert rod.between_forces[0][1] < 0
    assert report["bars"] == [{"at": 200.0, "side": "left"}]


def test_a_pin_at_a_point_and_a_tie(desk):
    printed = run("check wave.dxf --pin 182.5,-3.8 --tie 40 310", cwd=desk).stdout
    ratio = ec.optimal_rod(WAVE, between=(ec.Pin((182.5, -3.8)), ec.Tie(40, 310))).ratio
    assert f"{ratio:.3g} times as wide" in printed
    assert "Stability   stable in its plane" in printed


def test_the_reasons_have_places(desk):
    printed = run("check wave.dxf --rail 60", cwd=desk, code=1).output
    assert "the moment near 60 and 371 mm would bend the strip to the other side" in printed


@pytest.mark.parametrize("given", ["--rail 60", "--rail 320 --pin 350"])
def test_a_support_is_suggested_beside_those_that_the_curve_has(given, desk, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "wave.dxf").write_bytes((desk / "wave.dxf").read_bytes())
    for words in (f"check wave.dxf {given}", f"strip wave.dxf --sheet pom-0.5 --max-width 30 {given} -o out"):
        (command,) = suggested_commands(run(words, code=1).output)
        assert f"{given} " in command
        made = run(*shlex.split(command), "--no-step", "--no-pictures").output
        (between,) = re.findall(r"^Between +(.*)", made, re.MULTILINE)
        assert between.count("from the start") == given.count("--") + 1
        assert "unstable" not in made
        shutil.rmtree("out")


def test_two_free_ends_need_an_element(desk):
    assert "free" in run("check wave.dxf --start free --end free", cwd=desk, code=2).output
    run("check wave.dxf --start free --end free --tie 0 394", cwd=desk, code=1)


def test_no_kink_is_reported_at_a_rail(desk, project_root):
    slat = project_root / "examples" / "slat" / "slat.svg"
    (desk / "slat.svg").write_bytes(slat.read_bytes())
    assert "corner" in run("check slat.svg --smooth 0", cwd=desk).stdout
    assert "corner" not in run("check slat.svg --rail 400", cwd=desk).stdout


@pytest.mark.parametrize(("smooth", "marked"), [("10", True), ("12", False)])
def test_widths_that_no_strip_can_have_are_marked(smooth, marked, tmp_path):
    points = "0,0 60,90 110,200 90,320 45,430 55,550 45,650 120,730"
    (tmp_path / "back.csv").write_text("\n".join(["x,y", *points.split()]))
    printed = run(f"check back.csv --smooth {smooth}", cwd=tmp_path).output
    assert ("! Widths" in printed) == marked
    assert ("too narrow to cut" in printed) == marked
