"""What is shipped beside the code: package.xml, icons, panels, translations."""

import ast
import re
from pathlib import Path
from typing import get_args
from xml.etree import ElementTree

import FreeCAD as App
import pytest

from elastica_cad.mechanics.loads import EndName

ROOT = Path(__file__).resolve().parents[2]
CODE = ROOT / "freecad_workbench" / "freecad" / "elastica_wb"
RESOURCES = ROOT / "freecad_workbench" / "resources"
LANGUAGES = ("de", "zh-CN")

LISTS = {
    line.targets[0].id: ast.literal_eval(line.value)
    for path in CODE.rglob("*.py")
    for line in ast.parse(path.read_text(encoding="utf-8")).body
    if isinstance(line, ast.Assign) and isinstance(line.targets[0], ast.Name) and line.targets[0].id.isupper()
    if isinstance(line.value, (ast.List, ast.Tuple))
    and all(isinstance(e, ast.Constant) for e in line.value.elts)
}
"""Constants of the code that are lists of words."""


def words_of_code():
    """Context and text of all words that are translated, as lupdate reads them; property texts too."""
    for path in CODE.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call):
                called = getattr(node.func, "id", getattr(node.func, "attr", ""))
                words = [a.value for a in node.args if isinstance(a, ast.Constant)]
                assert called != "tr", f"{path}: lupdate finds no context for it"
                if called in ("progress", "in_background"):
                    assert not words[:1], f"{path}: lupdate does not find the title {words[0]}"
                if called in ("QT_TRANSLATE_NOOP", "translate") and len(words) == len(node.args) == 2:
                    yield tuple(words)
                elif called == "result" and len(words) > len(("type", "name")):
                    yield "App::Property", words[2]
                elif called == "Property" and len(words) > len(("type", "name", "group")):
                    yield "App::Property", words[3]
                    if words[0] == "Enumeration":
                        yield from (("Elastica", choice) for choice in choices_of(node))


def choices_of(entry):
    """What an enumeration offers: a list there, or the name of one, as panels show it."""
    for node in ast.walk(entry):
        if isinstance(node, ast.Constant) and entry.args[4:] and node in ast.walk(entry.args[4]):
            yield node.value
        elif isinstance(node, ast.Name) and node.id in LISTS:
            yield from LISTS[node.id]


NAMES_OF_CAUSES = (
    *("stiffness range", "weight", "end angles", "plasticity", "thickness", "kerf", "combined"),
    *(
        "ratio",
        "margin",
        "curvature",
        "length",
        "keep-out",
        "stiffness bounds",
        "end position",
        "end tangent",
    ),
    *("start position", "start tangent", "points", "inflection line", "symmetry"),
)
"""What the core calls the rows of a tolerance study, and what holds a nearest curve away."""


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
    named = (*NAMES_OF_CAUSES, *get_args(EndName))
    wanted = {*words_of_code(), *words_of_panels(), *(("Elastica", name) for name in named)}
    assert len(wanted) > 100
    assert {pair for pair in wanted if not known.get(pair)} == set()
    assert path.with_suffix(".qm").stat().st_size > 5000


def test_every_command_has_an_icon():
    assert len(command_names()) == 23
    for name in command_names():
        icon = ElementTree.parse(RESOURCES / "icons" / f"{name}.svg").getroot()
        assert icon.get("viewBox") == "0 0 64 64"


def test_shortcuts_and_names_are_unique():
    code = "\n".join(path.read_text() for path in (CODE / "commands").glob("*.py"))
    shortcuts = re.findall(r'shortcut="(.+)"', code)
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


def test_every_field_has_a_tooltip():
    inputs = ("SpinBox", "ComboBox", "LineEdit", "CheckBox", "PushButton")
    for path in (RESOURCES / "ui").glob("*.ui"):
        for widget in ElementTree.parse(path).getroot().iter("widget"):
            if widget.get("class").endswith(inputs):
                tip = widget.findtext("property[@name='toolTip']/string")
                assert tip, f"{path.name}: {widget.get('name')}"


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
    assert (required, optional) == (["numpy", "scipy"], ["ezdxf"]), "what the Addon Manager may install"
    assert "<url" not in text, "an address that nobody has registered: see docs/publishing.md"


def test_sources_say_their_licence():
    for path in CODE.rglob("*.py"):
        head = path.read_text(encoding="utf-8").splitlines()[:2]
        assert head == [
            "# SPDX-License-Identifier: MIT",
            "# SPDX-FileNotice: Part of the Elastica addon.",
        ], path


def test_names_and_texts_that_every_system_takes():
    for path in [*CODE.rglob("*"), *RESOURCES.rglob("*")]:
        assert re.fullmatch(r"[A-Za-z0-9_.-]+", path.name), path
    for path in CODE.rglob("*.py"):
        text = path.read_text(encoding="utf-8")
        for node in ast.walk(ast.parse(text)):
            if isinstance(node, ast.Call) and getattr(node.func, "attr", "") in ("read_text", "write_text"):
                assert "encoding" in [word.arg for word in node.keywords], path
        assert not re.search(r"import (pip|subprocess)|-m pip", text), path
