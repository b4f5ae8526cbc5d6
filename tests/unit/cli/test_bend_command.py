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
    assert len(shapes) == 3
    table = np.loadtxt(tmp_path / "bow-bent.csv", delimiter=",", skiprows=1)
    last = table[table[:, 0] == 3]
    assert last[[0, -1], 2:4] == pytest.approx(np.array([[180, 0], [-170, 30]]), abs=1e-5)
    assert last[-1, 4] == pytest.approx(np.radians(250), abs=1e-5)
    rod = ec.optimal_rod(ec.read_curves(drawn)[0])
    bent = ec.bend(rod, (180, 0), (-170, 30), (None, np.radians(250)))
    assert last[:, 2:4] == pytest.approx(bent.position, abs=1e-4)
    assert last[:, 6] == pytest.approx(rod.stiffness, abs=1e-5)
    assert "stable in its plane at every step" in result.output


def test_a_straight_strip_buckles_to_the_side_asked_for(tmp_path):
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
        (("--straight", 100, "--to", 80, 0, "--curve", 2), "--curve applies to a drawn CURVE"),
        (("--straight", 100, "--to", 80, 0, "--smooth", 0), "--smooth applies to a drawn CURVE"),
        (("--straight", 100, "--to", 80, 0, "--nearest"), "--nearest applies to a drawn CURVE"),
        (("--straight", 100, "--gravity"), "--gravity needs a material"),
        (
            ("--straight", 900, "--to", 800, 0, "--sheet", "carbon-rod-4", "--max-width", 4),
            "is a rod, so no flat",
        ),
        (("--straight", 900, "--to", 800, 0, "--sheet", "glass-rod-2", "--gravity"), "is a rod, so no flat"),
        (("--straight", 100, "--hold-start", "free", "--hold-end", "free"), "the rod is free to move along"),
        (("--straight", -1), "rod length is -1"),
        (("none.dxf",), "cannot be read"),
    ],
)
def test_bend_refuses_in_words(arguments, message, tmp_path):
    result = run("bend", *arguments, "-o", tmp_path, code=2)
    assert message in result.stderr
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(("distance", "tips"), [(5, True), (200, False)])
def test_a_strip_that_tips_sideways_on_its_way_is_told(distance, tips, tmp_path):
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
    said = re.search(r"! Stability at ([\d.]+) mm of travel, the strip tips over sideways", result.stderr)
    assert bool(said) == tips
    assert said is None or float(said[1]) == pytest.approx(295.0)
