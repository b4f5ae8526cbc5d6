"""How the modules import each other: from every statement, at the top, inside functions and for types."""

import ast
import re
from pathlib import Path

import pytest

pytestmark = pytest.mark.core

ROOT = Path(__file__).resolve().parents[2]
IMPORTED = re.compile(r"\bimport (?:\(([^)]*)\)|(.*))")
ATTRIBUTE = re.compile(r"\.(\w+)")
PUBLIC_FUNCTION = re.compile(r"^(?!@).*\n^def ([a-z]\w*)", re.MULTILINE)
"""Not decorated: a decorator may hand it on."""
WORD = re.compile(r"\w+")


def test_circles_and_dots_are_understood(plan):
    assert plan.circles({"a": {"b"}, "b": {"c"}, "c": {"b"}, "d": {"a"}}) == [("b", "c")]
    node = ast.parse("from ..rod import x").body[0]
    assert plan.absolute(node, "p.mechanics.bending.bend", False) == "p.mechanics.rod"
    assert plan.absolute(node, "p.mechanics.bending", True) == "p.mechanics.rod"


def test_every_import_of_the_house_leads_to_a_module(plan, modules):
    """A module that was moved and is still asked for at its old place, in a function that no test enters."""
    lost = [
        f"{name}: {home}"
        for name, file in modules.items()
        for home, _ in plan.imported(name, file)
        if home.startswith(tuple(plan.ROOTS)) and home not in modules
    ]
    assert lost == []


def test_no_module_reaches_itself(plan, imports):
    assert plan.circles(imports) == []


def test_no_room_reaches_itself(plan):
    """Rooms are the modules of a package; the workbench is one package."""
    inside = [f"elastica_cad.{f.name}" for f in plan.ROOTS["elastica_cad"].iterdir() if f.is_dir()]
    found = {floor: plan.circles(plan.parts_of(floor)) for floor in (*plan.ROOTS, *inside)}
    assert {floor: circles for floor, circles in found.items() if circles} == {}


def test_imports_go_to_the_module_that_defines(modules, imports):
    """No module imports from an `__init__`: the names there are for users."""
    doors = {name for name, file in modules.items() if file.with_suffix(".pyi").exists()}
    users = {name: sorted(targets & doors) for name, targets in imports.items() if targets & doors}
    assert users == {}


def test_an_underscore_says_what_is_private(plan, modules):
    """No list of names beside the definitions: what begins with _ stays in its module, other functions are used."""
    crossed = [
        f"{name}: {home}.{what}"
        for name, file in modules.items()
        for home, what in plan.imported(name, file)
        if home in modules and what.startswith("_") and f"{home}.{what}" not in modules
    ]
    assert crossed == []
    users = (*(ROOT / "elastica_cad").rglob("*.pyi"), *(ROOT / "tests").rglob("*.py"), *modules.values())
    texts = {file: file.read_text(encoding="utf-8") for file in users}
    request = set()
    for text in texts.values():
        request |= {name for names in IMPORTED.findall(text) for name in WORD.findall("".join(names))}
        request |= set(ATTRIBUTE.findall(text))
    idle = [
        f"{name}.{function}"
        for name, file in modules.items()
        if name.startswith("elastica_cad.")
        for function in PUBLIC_FUNCTION.findall(texts[file])
        if function not in request
    ]
    assert idle == []


def test_the_drawing_of_the_packages_is_of_these_imports(plan):
    """`make generate` draws it again."""
    assert (ROOT / "docs" / "plan.svg").read_text(encoding="utf-8") == plan.packages()
    architecture = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    assert architecture == plan.with_reading_order(architecture)
