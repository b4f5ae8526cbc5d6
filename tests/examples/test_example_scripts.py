"""Every script of the gallery, run as a user runs it: it writes its kit and says where."""

import json
import runpy
import sys
from dataclasses import replace

import pytest

import elastica_cad as ec

FOLDERS = {
    "carpet": ["carpet"],
    "facade": ["facade/closed", "facade/half-open", "facade/open"],
    "flower_pot": ["flower_pot"],
    "horse": ["horse"],
    "lamp": ["lamp"],
    "lantern": ["lantern"],
    "projective": ["projective"],
    "revolution": [f"revolution/{label}" for label in "ABCDEF"],
    "robustness": ["robustness"],
    "s_curve": ["s_curve"],
    "shell": ["shell"],
    "spiral": ["spiral"],
    "vase": ["vase"],
}
TOLD = {
    "s_curve": "stable: ratio 3.50, margin 5.0",
    "projective": "before: 395.2 mm, inflections at",
    "robustness": "largest distance from the design, mm",
}
FEW = {"lamp": 3}  # strips of those that take more than 20 s


def fewer(model, count):
    """The first, the last and the longest strips."""
    longest = sorted(model.placed, key=lambda one: -one.strip.rod.length)[: count - 2]
    return replace(model, placed=(model.placed[0], *longest, model.placed[-1]))


@pytest.fixture
def run(project_root, tmp_path, monkeypatch):
    """Run a script as __main__ in an empty folder, without assembly and pictures, which other tests draw."""
    save = ec.save_model

    def once(name):
        def cheap(model, folder, **options):
            model = fewer(model, FEW[name]) if name in FEW else model
            return save(model, folder, step=False, pictures=False, **options)

        monkeypatch.chdir(tmp_path)
        monkeypatch.setattr(ec, "save_model", cheap)
        monkeypatch.setattr(sys, "argv", [f"{name}.py"])
        runpy.run_path(str(project_root / "examples" / name / f"{name}.py"), run_name="__main__")
        return tmp_path / "out"

    return once


def test_every_script_is_run(project_root):
    folders = (project_root / "examples").iterdir()
    scripts = {folder.name for folder in folders if (folder / f"{folder.name}.py").exists()}
    assert scripts == {*FOLDERS, "slat"}  # the slat writes no kit: test_slat.py runs it


LONG = ("carpet", "facade", "flower_pot", "horse", "lamp", "revolution", "shell")
"""Scripts that only `make campaign-galleries` runs."""


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.campaign) if name in LONG else name for name in FOLDERS]
)
def test_a_script_writes_its_kit(name, run, capsys):
    """All files of the report are there, no others; what is printed names every folder."""
    out = run(name)
    message = capsys.readouterr().out
    assert TOLD.get(name, "") in message
    assert {page.parent.relative_to(out).as_posix() for page in out.rglob("index.html")} == set(FOLDERS[name])
    for folder in FOLDERS[name]:
        (report,) = (out / folder).glob("*.json")
        listed = json.loads(report.read_text())["files"]
        kit = out / folder
        names = {path.relative_to(kit).as_posix() for path in kit.rglob("*") if path.is_file()}
        assert set(listed) == names
        assert sum(file.endswith(".dxf") for file in names) >= 2
        assert f"wrote {len(names)} files to out/{folder}" in message
