"""What README and the page for scripts show is run as it stands there."""

import re
from importlib import import_module

import pytest
from click.testing import CliRunner

from elastica_cad.cli.commands import elastica


@pytest.fixture
def desk(project_root, monkeypatch, tmp_path):
    """An empty folder to work in, with the examples in it."""
    (tmp_path / "examples").symlink_to(project_root / "examples")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def blocks(page, kind):
    return re.findall(rf"```{kind}\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)


def run(code):
    """What a block of Python defines."""
    names = {}
    exec(compile(code, "snippet", "exec"), names)
    return names


def test_python_of_readme(project_root, desk, capsys):
    plain, *kernels = blocks(project_root / "README.md", "python")
    run(plain)
    assert "can take this curve" in capsys.readouterr().out
    assert (desk / "arch.dxf").stat().st_size > 1000
    build123d, cadquery = map(run, kernels)
    for rib in (build123d["rib"], cadquery["rib"].val()):
        assert rib.check.realizable
        assert rib.strip.width.extremes[1] == pytest.approx(40)


def test_commands_of_readme(project_root, desk):
    made, typed, _ = blocks(project_root / "README.md", "sh")
    makefile = (project_root / "Makefile").read_text(encoding="utf-8")
    for line in made.strip().split("\n"):
        assert re.search(rf"^{line.split()[1]}:", makefile, re.MULTILINE)
    (desk / "my-curve.dxf").write_bytes((desk / "examples" / "arch" / "arch.dxf").read_bytes())
    for line in typed.strip().split("\n"):
        program, *words = line.split("#")[0].split()
        assert program == ".venv/bin/elastica"
        done = CliRunner().invoke(elastica, words)
        assert done.exit_code == 0, done.output
    assert (desk / "out" / "my-curve.dxf").is_file()


@pytest.mark.parametrize("kernel", ["build123d", "cadquery"])
def test_page_for_scripts(kernel, project_root, desk, capsys):
    snippets = blocks(project_root / "docs" / "code_cad.md", "python")
    (code,) = [text for text in snippets if f"elastica_cad.{kernel} import" in text]
    names = run(code)
    assert names["rib"].rod.length == pytest.approx(100, abs=1e-3)
    assert (desk / "rib-flat.step").stat().st_size > 1000
    if kernel == "build123d":
        assert len(names["rosette"]) == 8
    else:
        assert len(names["three"].vals()) == 3


@pytest.mark.parametrize("kernel", ["build123d", "cadquery"])
def test_page_names_all_that_is_public(kernel, project_root):
    text = (project_root / "docs" / "code_cad.md").read_text(encoding="utf-8")
    # what the others return
    rest = {"PlacedStrip", "StripFace", "StripSolid", "StripCompound", "FixtureSolid", "FlexureSolid"}
    public = set(import_module(f"elastica_cad.{kernel}").__all__) - rest
    assert [name for name in sorted(public) if f"`{name}`" not in text] == []
