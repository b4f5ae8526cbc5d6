"""What is shipped beside the code: package.xml, icons, panels, translations."""

import ast
import re
import sys
from pathlib import Path
from xml.etree import ElementTree

import FreeCAD as App
import pytest
from freecad.elastica_wb import libraries

from elastica_cad.errors import MissingDependencyError

ROOT = Path(__file__).resolve().parents[2]
CODE = ROOT / "freecad_workbench" / "freecad" / "elastica_wb"
RESOURCES = ROOT / "freecad_workbench" / "resources"
LANGUAGES = ("de", "zh-CN")


def words_of_code():
    """Context and text of all words that are translated."""
    for path in CODE.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "tr":
                if isinstance(node.args[0], ast.Constant):
                    yield "Elastica", node.args[0].value
            elif isinstance(node, ast.ClassDef) and any(
                getattr(b, "id", "") == "Command" for b in node.bases
            ):
                said = {
                    line.targets[0].id: line.value.value
                    for line in node.body
                    if isinstance(line, ast.Assign) and isinstance(line.value, ast.Constant)
                }
                yield said["name"], said["text"]
                yield said["name"], said["tip"]


def words_of_panels():
    for path in (RESOURCES / "ui").glob("*.ui"):
        tree = ElementTree.parse(path).getroot()
        for text in tree.iter("string"):
            if text.get("notr") != "true" and (text.text or "").strip():
                yield tree.findtext("class"), text.text


def command_names():
    return {context for context, _ in words_of_code() if context.startswith("Elastica_")}


@pytest.mark.parametrize("language", LANGUAGES)
def test_everything_is_translated(language):
    path = RESOURCES / "translations" / f"Elastica_{language}.ts"
    known = {
        (context.findtext("name"), message.findtext("source")): message.findtext("translation")
        for context in ElementTree.parse(path).getroot().iter("context")
        for message in context.iter("message")
    }
    wanted = {*words_of_code(), *words_of_panels()}
    assert len(wanted) > 100
    assert {pair for pair in wanted if not known.get(pair)} == set()
    assert path.with_suffix(".qm").stat().st_size > 5000


def test_every_command_has_an_icon():
    assert len(command_names()) == 16
    for name in command_names():
        icon = ElementTree.parse(RESOURCES / "icons" / f"{name}.svg").getroot()
        assert icon.get("viewBox") == "0 0 64 64"


def test_shortcuts_and_names_are_unique():
    code = "\n".join(path.read_text() for path in (CODE / "commands").glob("*.py"))
    shortcuts = re.findall(r'shortcut = "(.+)"', code)
    assert len(set(shortcuts)) == len(shortcuts) >= 6


def test_panels_name_no_widget_as_qt_does():
    """form.height would be Qt's method, not the field of that name."""
    taken = {
        "height",
        "width",
        "size",
        "pos",
        "x",
        "y",
        "font",
        "style",
        "show",
        "close",
        "update",
        "parent",
        "layout",
    }
    for path in (RESOURCES / "ui").glob("*.ui"):
        names = {widget.get("name") for widget in ElementTree.parse(path).getroot().iter("widget")}
        assert not names & taken, path.name


def test_package_for_the_addon_manager():
    package = App.Metadata(str(ROOT / "package.xml"))
    assert package.Name == "Elastica"
    assert package.supportsCurrentFreeCAD()
    (workbench,) = package.Content["workbench"]
    assert workbench.Classname == "ElasticaWorkbench"
    assert (ROOT / workbench.Subdirectory / "freecad" / "elastica_wb" / "init_gui.py").exists()
    assert (ROOT / workbench.Subdirectory / workbench.Icon).exists()
    assert not (ROOT / workbench.Subdirectory / "freecad" / "__init__.py").exists()
    text = (ROOT / "package.xml").read_text()
    assert "<pythonmin>3.11</pythonmin>" in text
    required = re.findall(r'<depend type="python">(\w+)<', text)
    optional = re.findall(r'<depend type="python" optional="true">(\w+)<', text)
    assert (required, optional) == (["numpy", "scipy"], ["ezdxf", "highspy"])


@pytest.mark.parametrize("code", [0, 1])
def test_libraries_are_installed_beside_freecads_numpy(tmp_path, monkeypatch, code):
    pip = tmp_path / "python"
    pip.write_text(f'#!/bin/sh\necho "$@" > {tmp_path}/asked\necho "no network here" >&2\nexit {code}\n')
    pip.chmod(0o755)
    monkeypatch.setattr(libraries, "_python", lambda: str(pip))
    monkeypatch.setattr(libraries, "folder", lambda: tmp_path / "packages")
    monkeypatch.setattr(sys, "path", list(sys.path))
    if code == 0:
        libraries.install(["highspy"])
        assert str(tmp_path / "packages") in sys.path
    else:
        with pytest.raises(MissingDependencyError, match="could not install highspy: no network here"):
            libraries.install(["highspy"])
    asked = (tmp_path / "asked").read_text().split()
    assert asked[-1] == "highspy"
    assert "--no-deps" in asked
    assert "numpy" not in asked


def test_no_pip_is_a_sentence(tmp_path, monkeypatch):
    monkeypatch.setattr(libraries, "_python", lambda: str(tmp_path / "nothing"))
    monkeypatch.setattr(libraries, "folder", lambda: tmp_path / "packages")
    with pytest.raises(MissingDependencyError, match="no Python with pip"):
        libraries.install(["ezdxf"])
