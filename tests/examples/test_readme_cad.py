"""The CAD snippets of README and of the page for scripts run as they stand there."""

import re

import pytest


def run_snippet(page, kernel):
    """What the page's snippet for this kernel defines."""
    snippets = re.findall(r"```python\n(.*?)```", page.read_text(), re.DOTALL)
    (code,) = [text for text in snippets if f"elastica_cad.{kernel} import" in text]
    names = {}
    exec(compile(code, page.name, "exec"), names)
    return names


@pytest.mark.parametrize("kernel", ["build123d", "cadquery"])
def test_snippet_runs(kernel, project_root, capsys):
    names = run_snippet(project_root / "README.md", kernel)
    rib = names["rib"] if kernel == "build123d" else names["rib"].val()
    assert rib.check.realizable
    assert rib.strip.width.extremes[1] == pytest.approx(40)


def test_readme_in_plain_python(project_root, capsys, monkeypatch, tmp_path):
    first = re.findall(r"```python\n(.*?)```", (project_root / "README.md").read_text(), re.DOTALL)[0]
    (tmp_path / "examples").symlink_to(project_root / "examples")
    monkeypatch.chdir(tmp_path)
    exec(compile(first, "README.md", "exec"), {})
    assert "can take this curve" in capsys.readouterr().out
    assert (tmp_path / "arch.dxf").stat().st_size > 1000


@pytest.mark.campaign
@pytest.mark.parametrize("kernel", ["build123d", "cadquery"])
def test_page_for_scripts(kernel, project_root, capsys, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    names = run_snippet(project_root / "docs" / "code_cad.md", kernel)
    assert names["rib"].rod.length == pytest.approx(100, abs=1e-3)
    assert (tmp_path / "rib-flat.step").stat().st_size > 1000
    if kernel == "build123d":
        assert len(names["lantern"]) == 8
    else:
        assert len(names["three"].vals()) == 3


@pytest.mark.parametrize("kernel", ["build123d", "cadquery"])
def test_page_names_all_that_is_public(kernel, project_root):
    from importlib import import_module

    text = (project_root / "docs" / "code_cad.md").read_text()
    rest = {
        "PlacedStrip",
        "StripFace",
        "StripSolid",
        "StripCompound",
        "FixtureSolid",
    }  # what the others return
    public = set(import_module(f"elastica_cad.{kernel}").__all__) - rest
    assert [name for name in sorted(public) if f"`{name}`" not in text] == []
