"""`elastica new KIND`: every file it writes runs as it is."""

import json
import re
import shlex
import subprocess
import sys

import pytest

from tests.command_line import run

KINDS = ("arch", "lamp", "pavilion", "revolution", "sections")


@pytest.mark.campaign
@pytest.mark.parametrize("kind", KINDS)
def test_written_and_made(kind, tmp_path):
    command = [sys.executable, "-m", "elastica_cad", "new", kind]
    wrote = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert wrote.returncode == 0, wrote.stderr
    command = shlex.split(wrote.stdout.splitlines()[-1].removeprefix("Next        "))
    command += ["--no-step", "--no-pictures", "--no-effects"]
    made = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert made.returncode == 0, made.stderr
    report = json.loads((tmp_path / f"{kind}-kit" / f"{kind}.json").read_text())
    assert report["name"] == kind
    assert list((tmp_path / f"{kind}-kit").glob("sheets/*nest*.dxf"))


@pytest.mark.parametrize("kind", KINDS)
def test_the_material_it_speaks_of_is_that_of_its_sheet(kind, tmp_path):
    """The lamp of polypropylene was said to be of plywood."""
    run("new", kind, cwd=tmp_path)
    design = (tmp_path / f"{kind}.toml").read_text()
    sheets = re.findall(r'^(?:sheet|rings) = "([a-z-]+)', design, re.MULTILINE)
    names = {"plywood": "birch-plywood-", "card": "card-", "plastic": "polypropylene-"}
    for word in re.findall(r"of (plywood|card|plastic)\b", design):
        assert names[word] in sheets


def test_the_command_that_comes_next_can_be_typed_as_reported(tmp_path):
    wrote = run("new", "arch", "-o", "my lamp's files", cwd=tmp_path)
    result = wrote.stdout.splitlines()[-1].removeprefix("Next        ")
    words = shlex.split(result)
    assert words[-4:] == ["model", "my lamp's files/arch.toml", "-o", "my lamp's files/arch-kit"]


def test_nothing_is_overwritten_unasked(tmp_path):
    run("new", "arch", cwd=tmp_path)
    (tmp_path / "arch.toml").write_text("mine")
    again = run("new", "arch", cwd=tmp_path, code=2)
    assert "exists already" in again.stderr
    assert (tmp_path / "arch.toml").read_text() == "mine"


@pytest.mark.campaign
def test_the_schema_comes_beside_and_alone(tmp_path):
    for kind in ("arch", "lamp"):  # the same schema serves both
        run("new", kind, cwd=tmp_path)
    (tmp_path / "elastica.schema.json").write_text("mine")
    assert "exists already" in run("new", "schema", cwd=tmp_path, code=2).stderr
    assert "exists already" in run("new", "pavilion", cwd=tmp_path, code=2).stderr
    assert run("new", "schema", "--force", cwd=tmp_path).stdout == "Files       elastica.schema.json\n"
    keys = json.loads((tmp_path / "elastica.schema.json").read_text())["properties"]
    assert keys["max_width"]["description"].endswith("(mm).")


@pytest.mark.campaign
def test_the_kit_of_sections_stands(tmp_path):
    """No tab rocks in its rings, and the strips as made follow the surface by hundredths of a millimetre."""
    run("new", "sections", cwd=tmp_path)
    made = run("model", "sections.toml", "-o", "kit", "--no-step", "--no-pictures", "-v", cwd=tmp_path)
    assert "rocks" not in made.stdout + made.stderr
    report = json.loads((tmp_path / "kit" / "sections.json").read_text())
    assert len(report["held"]) == 8
    assert all(part["ratio"] < 1.5 for part in report["parts"])  # nor do widths follow the facets of the mesh
    assert all(held["deviation"] < 0.1 for held in report["held"].values())


@pytest.mark.campaign
def test_the_pavilion_stands_as_drawn(tmp_path):
    """Wide tabs between two plates and widths made up for: no strip strays by a thousandth of its length."""
    run("new", "pavilion", cwd=tmp_path)
    made = run("model", "pavilion.toml", "-o", "kit", "--no-step", "--no-pictures", "-v", cwd=tmp_path)
    report = json.loads((tmp_path / "kit" / "pavilion.json").read_text())
    assert max(held["deviation"] for held in report["held"].values()) < 0.4
    joints = re.search(r"(\d+) joints", made.stdout)
    assert int(joints[1]) >= 8
