"""Files that users stored with earlier versions are opened and used, by the command that a user types."""

import json
import shutil

import pytest

from elastica_cad import read_curves
from elastica_cad.design import read_design
from elastica_cad.web.answers import answer
from tests.command_line import run
from tests.house.stored_files import DESIGNS, STORED, unlinked

VERSIONS = sorted(path.name for path in STORED.iterdir())


@pytest.fixture(params=VERSIONS)
def stored(request, tmp_path):
    """The folder of a version, copied, as reports are written beside their files."""
    return shutil.copytree(STORED / request.param, tmp_path / request.param)


@pytest.mark.parametrize("name", DESIGNS)
def test_a_stored_design_is_read(name, stored):
    design = read_design(stored / f"{name}.toml", read_curves)
    assert design.entries or design.patterns or design.revolution


@pytest.mark.campaign
@pytest.mark.parametrize("name", DESIGNS)
def test_a_stored_design_makes_its_strips(name, stored):
    assert read_design(stored / f"{name}.toml", read_curves).model().parts


def test_a_stored_design_is_made_and_written(stored):
    run("model", "arch.toml", "-o", "kit", "--no-step", "--no-pictures", cwd=stored)
    assert (stored / "kit" / "arch.json").exists()


@pytest.mark.campaign
def test_a_stored_two_state_part_is_made(stored):
    run("pair clip.toml -o pair --no-printed", cwd=stored)
    assert list((stored / "pair").glob("*.dxf"))


def test_a_stored_report_is_bent(stored):
    report = json.loads((stored / "arch.json").read_text())
    bent = json.loads(run("bend arch.json --to 390 0 --json", cwd=stored).stdout)
    assert bent["length"] == pytest.approx(report["length"], rel=1e-3)


def test_stored_readings_are_compared(stored):
    assert "within" in run("compare arch.json arch-measured.toml", cwd=stored).stdout


def test_a_stored_sheet_is_read(stored):
    assert "12 MPa" in run("sheets felt.toml", cwd=stored).stdout


def test_a_stored_link_makes_its_strips(stored):
    design = unlinked((stored / "link.txt").read_text().strip())
    assert "length" in answer({"do": "strip", "design": design})
