"""`elastica bend` of even rods and strips: straight ones, and the even bow of a drawn curve."""

import json

import numpy as np
import pytest

from elastica_cad import PlaneCurve, Sheet, write_curves
from elastica_cad.mechanics import RoundLaw
from elastica_cad.mechanics.loads import STANDARD_GRAVITY_M_S2
from elastica_cad.model.bows import bow
from tests.command_line import run

SHEET = Sheet.named("gfrp-1")
ROD = RoundLaw(SHEET, 8.0, 8.0)
EI = ROD.bending_stiffness(8.0).item()
WEIGHT = np.pi / 4 * 8**2 * SHEET.density * 1e-9 * STANDARD_GRAVITY_M_S2
ARCH = PlaneCurve.arc((0, 0), 300, 0.8 * np.pi, 0.2 * np.pi)


@pytest.fixture(scope="module")
def desk(tmp_path_factory):
    folder = tmp_path_factory.mktemp("desk")
    write_curves([ARCH], folder / "arch.dxf")
    return folder


@pytest.fixture(autouse=True)
def without_pictures(monkeypatch):
    """As without matplotlib, for speed."""
    monkeypatch.setattr("elastica_cad.cli.bend_command.can_draw", lambda: False)


def bent(line, cwd):
    return json.loads(run(f"bend {line} -o out --json --force", cwd=cwd).stdout)


@pytest.mark.parametrize(
    ("load", "sag", "force"),
    [
        ("--gravity", 5 / 384 * WEIGHT * 600**4, 600 * WEIGHT),
        ("--point-force 300 0 -1", 600**3 / 48 + 5 / 384 * WEIGHT * 600**4, 1 + 600 * WEIGHT),
        ("--point-mass 300 200", 0.2 * 9.80665 * 600**3 / 48 + 5 / 384 * WEIGHT * 600**4,
         0.2 * 9.80665 + 600 * WEIGHT),
    ],
)  # fmt: skip
def test_the_sag_of_a_rod_on_two_supports(desk, load, sag, force):
    """As in every handbook; with a load, its weight acts too."""
    line = f"--straight 600 --rod 8 --sheet gfrp-1 --hold-start pinned --hold-end roller-x {load}"
    travel = bent(line, desk)["travel"]
    assert travel["displacement_mm"] == pytest.approx([sag / EI], rel=2e-3)
    assert travel["start_force_y_N"][0] + travel["end_force_y_N"][0] == pytest.approx(force, rel=1e-6)


@pytest.mark.parametrize(
    ("size", "fields"),
    [
        ("--sheet gfrp-1 --rod 8", {"section": ROD}),
        ("--sheet gfrp-1 --max-width 20 --even", {"max_width": 20.0, "min_width": 20.0}),
    ],
)
def test_an_even_strip_of_a_curve_is_its_even_bow(desk, size, fields):
    answer, kite = bent(f"arch.dxf {size}", desk), bow(ARCH, SHEET, **fields)
    assert answer["ratio"] == 1
    assert answer["travel"]["end_force_x_N"] == pytest.approx([-kite.pull], rel=1e-4)
    assert answer["travel"]["end_moment_Nmm"] == pytest.approx([0.0], abs=1e-9)
    safety = kite.strip.strain_limit / kite.strip.max_strain
    assert answer["travel"]["safety"] == pytest.approx([safety], rel=1e-3)


def test_the_shape_of_an_even_strip_needs_no_material(desk):
    shapes = [
        bent(f"arch.dxf {even} --to 200 {y}", desk)["shapes"]
        for y in (ARCH.at(0.0).position[0, 1],)
        for even in ("--even", "--rod 8")
    ]
    assert shapes[0] == shapes[1]
    assert bent("--straight 300 --rod 8 --to 200 0", desk)["travel"] is None


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("--straight 300 --even --to 200 0", "--even has no effect beside --straight"),
        ("arch.dxf --rod 8 --even", "--even has no effect beside --rod"),
        ("arch.dxf --rod 8 --sheet gfrp-1 --max-width 20", "--max-width has no effect beside --rod"),
        ("arch.dxf --even --nearest", "--nearest has no effect beside --even"),
        ("--straight 300 --rod 8 --point-mass 150 20", "Add --sheet, and --max-width or --rod"),
        ("--straight 300 --max-width 8 --sheet glass-rod-2", "Use --rod DIAMETER instead of --max-width"),
        ("arch.dxf --rod 8 --gravity", "--gravity has no effect without --sheet"),
    ],
)
def test_options_of_even_strips_are_refused_in_a_sentence(desk, line, says):
    assert says in run(f"bend {line} -o out", cwd=desk, code=2).stderr
