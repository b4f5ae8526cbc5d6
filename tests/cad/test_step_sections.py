"""`elastica sections` on STEP bodies: through to strips, by the command line alone."""

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad.kernel.step_files import NamedShape, write_step
from tests.command_line import run


@pytest.fixture
def torus(tmp_path):
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeTorus

    write_step([NamedShape("ring", BRepPrimAPI_MakeTorus(120.0, 40.0).Shape())], tmp_path / "ring.step")
    return tmp_path / "ring.step"


@pytest.mark.campaign
def test_a_body_becomes_strips(torus, tmp_path):
    run(
        "sections",
        torus,
        "--radial",
        3,
        "--split",
        0,
        0,
        0,
        0,
        0,
        1,
        "--sheet",
        "card-200gsm",
        "-o",
        tmp_path,
    )
    curves = ec.read_curves(tmp_path / "ring-sections.json")
    assert [curve.length for curve in curves] == pytest.approx(6 * [40 * np.pi], rel=1e-3)
    kit = run(
        "model",
        tmp_path / "ring-sections.toml",
        "-o",
        tmp_path / "kit",
        "--no-step",
        "--no-pictures",
        "--no-effects",
    )
    assert "ring-sections: 6 strips" in kit.output


def test_units_and_scales_of_a_body(torus, tmp_path):
    """STEP files say their unit; a scale makes a model of it."""
    cut = ("--offset", 0, "--axis", 0, 1, 0, "--point", 0, 0, 0, "--split", 0, 0, 0, 0, 0, 1, "-o", tmp_path)
    run("sections", torus, *cut, "--scale", 0.5)
    lengths = [curve.length for curve in ec.read_curves(tmp_path / "ring-sections.json")]
    assert lengths == pytest.approx(4 * [20 * np.pi], rel=1e-3)
    tiny = run("sections", torus, *cut, "--scale", 1e-6, "--force", code=2)
    assert "too small or too large for strips" in tiny.stderr


def test_files_without_a_surface(tmp_path):
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge
    from OCP.gp import gp_Pnt

    write_step(
        [NamedShape("edge", BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(90, 0, 0)).Shape())],
        tmp_path / "e.step",
    )
    (tmp_path / "bad.step").write_text("nonsense")
    for name, sentence in (
        ("e.step", "The shape has no faces to cut"),
        ("bad.step", "OpenCASCADE cannot read this file as STEP"),
    ):
        result = run("sections", tmp_path / name, "--radial", 3, code=2)
        assert sentence in result.stderr
        assert result.stderr.count("\n") == 1
