"""How the modules import each other: from every statement, at the top, inside functions and for types."""

import ast
from pathlib import Path

import pytest

pytestmark = pytest.mark.core

ROOT = Path(__file__).resolve().parents[2]


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
    """Rooms are the sub-packages of a floor, and single modules beside them; the workbench is one floor."""
    inside = [f"elastica_cad.{f.name}" for f in plan.ROOTS["elastica_cad"].iterdir() if f.is_dir()]
    found = {floor: plan.circles(plan.rooms(floor)) for floor in (*plan.ROOTS, *inside)}
    assert {floor: circles for floor, circles in found.items() if circles} == {}


def test_imports_go_to_the_module_that_defines(modules, imports):
    """No module of the package enters by a front door (`__init__`): doors are for users."""
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
    asked = set()
    for file in (*(ROOT / "elastica_cad").rglob("*.pyi"), *(ROOT / "tests").rglob("*.py"), *modules.values()):
        if file.suffix in (".py", ".pyi"):
            nodes = list(ast.walk(ast.parse(file.read_text(encoding="utf-8"))))
            asked |= {
                alias.name for node in nodes if isinstance(node, ast.ImportFrom) for alias in node.names
            }
            asked |= {node.attr for node in nodes if isinstance(node, ast.Attribute)}
    idle = [
        f"{name}.{node.name}"
        for name, file in modules.items()
        for node in ast.parse(file.read_text(encoding="utf-8")).body
        if name.startswith("elastica_cad.") and isinstance(node, ast.FunctionDef) and not node.decorator_list
        if not node.name.startswith("_") and node.name not in asked
    ]
    assert idle == []


def test_the_drawing_of_the_packages_is_of_these_imports(plan):
    """`make generate` draws it again."""
    assert (ROOT / "docs" / "plan.svg").read_text(encoding="utf-8") == plan.house()
