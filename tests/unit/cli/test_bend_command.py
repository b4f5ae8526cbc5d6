"""`elastica bend` as a user meets it: ends that are led, a strip that buckles, messages."""

import re

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad.formats import curves_json
from tests.command_line import run


@pytest.fixture
def drawn(tmp_path):
    path = tmp_path / "bow.json"
    path.write_text(curves_json([ec.PlaneCurve.ellipse((0, 0), (200.0, 100.0), 0.0, 0.2, 2.9)]))
    return path


def test_bend_leads_the_ends(drawn, tmp_path):
    result = run(
        "bend", drawn, "--from", 180, 0, "--to", -170, 30, "--end-angle", 250, "--steps", 3, "-o", tmp_path
    )
    shapes = ec.read_curves(tmp_path / "bow-bent.json")
    assert len(shapes) == 4
    table = np.loadtxt(tmp_path / "bow-bent.csv", delimiter=",", skiprows=1)
    last = table[table[:, 0] == 4]
    assert last[[0, -1], 2:4] == pytest.approx(np.array([[180, 0], [-170, 30]]), abs=1e-5)
    assert last[-1, 4] == pytest.approx(np.radians(250), abs=1e-5)
    rod = ec.optimal_rod(ec.read_curves(drawn)[0])
    bent = ec.bend(rod, (180, 0), (-170, 30), (None, np.radians(250)))
    assert last[:, 2:4] == pytest.approx(bent.position, abs=1e-4)
    assert last[:, 6] == pytest.approx(rod.stiffness, abs=1e-5)
    assert "stable in its plane at every step" in result.output


def test_a_curved_strip_takes_no_side(drawn, tmp_path):
    refused = run("bend", drawn, "--to", 300, 0, "--side", "left", "-o", tmp_path / "out", code=2)
    assert "--side has no effect, because the strip is not straight" in refused.output
    (tmp_path / "line.csv").write_text("x (mm),y (mm)\n0,0\n50,0\n100,0\n")
    run("bend", tmp_path / "line.csv", "--to", 70, 0, "--side", "right", "-o", tmp_path / "out")


def test_a_straight_strip_buckles_to_the_side_requested(tmp_path):
    arguments = ("bend", "--straight", 100, "--to", 70, 0, "--hold-start", "pinned", "--hold-end", "pinned")
    for side, sign in (("left", 1), ("right", -1)):
        run(*arguments, "--side", side, "-o", tmp_path / side)
        table = np.loadtxt(tmp_path / side / "straight-bent.csv", delimiter=",", skiprows=1)
        peak = table[np.argmax(np.abs(table[:, 3])), 3]
        assert sign * peak > 30


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((), "Name a CURVE"),
        (("--straight", 100, "--to", 200, 0), "the ends are 200 mm apart"),
        (("--straight", 100, "--to", 80, 0, "--curve", 2), "--curve has no effect beside --straight"),
        (("--straight", 100, "--to", 80, 0, "--smooth", 0), "--smooth has no effect beside --straight"),
        (("--straight", 100, "--to", 80, 0, "--nearest"), "--nearest has no effect beside --straight"),
        (("--straight", 100, "--gravity"), "--gravity has no effect without --sheet"),
        (
            ("--straight", 100, "--to", 80, 0, "--sheet", "pom-1"),
            "--sheet has no effect without --max-width or --gravity or --set",
        ),
        (
            ("--straight", 100, "--to", 80, 0, "--release"),
            "--release has no effect, because the strip has no rails",
        ),
        (
            ("--straight", 100, "--to", 80, 0, "--set", "samples=99"),
            "--set has no effect beside --straight",
        ),
        (
            ("--straight", 900, "--to", 800, 0, "--sheet", "carbon-rod-4", "--max-width", 4),
            "is a rod, so no",
        ),
        (("--straight", 900, "--to", 800, 0, "--sheet", "glass-rod-2", "--gravity"), "is a rod, so no"),
        (("--straight", 100, "--hold-start", "free", "--hold-end", "free"), "The rod is free to move along"),
        (("--straight", -1), "rod length is -1"),
        (("none.dxf",), "cannot be read"),
    ],
)
def test_bend_refuses_in_words(arguments, message, tmp_path):
    result = run("bend", *arguments, "-o", tmp_path, code=2)
    assert message in result.stderr
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(("distance", "tips"), [(5, True), (200, False)])
def test_a_strip_that_tips_sideways_on_its_way_is_reported(distance, tips, tmp_path):
    """Nearly a loop (an elastica of modulus 0.9) it leaves its plane in CalculiX too: docs/finite_elements.md."""
    result = run(
        "bend --straight 300 --to",
        distance,
        0,
        "--steps",
        3,
        "--side",
        "left",
        "--sheet",
        "birch-plywood-0.8",
        "--max-width",
        5,
        "-o",
        tmp_path,
    )
    text = re.search(r"! Stability at ([\d.]+) mm of travel, the strip tips over sideways", result.stderr)
    assert bool(text) == tips
    assert text is None or float(text[1]) == pytest.approx(295.0)


@pytest.mark.parametrize("end", [820, 820.05])
def test_a_cord_from_end_to_end_may_have_a_rounded_place(end, tmp_path):
    arguments = (
        "bend",
        "--straight",
        820,
        "--sheet",
        "birch-plywood-1.5",
        "--max-width",
        15,
        "--shorten",
        90,
    )
    inside, at_ends = (
        run(*arguments, "--tie", 0, at, "--side", "right", "-o", tmp_path / str(at)) for at in (819.9999, end)
    )
    assert "tie from 0 mm to 820 mm, 730.0 mm long, pulls " in at_ends.stdout
    row = next(line for line in at_ends.stdout.splitlines() if line.startswith("Between"))
    assert row in inside.stdout
    refused = run(*arguments, "--tie", 0, 821, "--side", "right", "-o", tmp_path / "refused", code=2)
    assert (
        "The tie 821 mm from the start is not on the curve. Give a place from 0 to 820 mm" in refused.stderr
    )
    mass = ("--point-mass", end, 4, "--hold-start", "clamped", "--hold-end", "free")
    loaded = run(*arguments[:-2], *mass, "-o", tmp_path / "loaded")
    assert "Load        4 g at 820" in loaded.stdout
