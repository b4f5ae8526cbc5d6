"""The front door: few names, the fixed ones among them, each with its own documentation."""

import ast
import inspect
from dataclasses import fields, is_dataclass
from enum import Enum
from importlib import import_module
from pathlib import Path
from types import ModuleType

import pytest

import elastica_cad as ec

MOST = 81
ROOMS = (
    "geometry",
    "mechanics",
    "form_finding",
    "strip",
    "formats",
    "model",
    "pairs",
    "design",
    "paper",
    "plot",
)
FIXED = {
    "curves": ("PlaneCurve", "read_curves", "check_equilibrium", "Supports"),
    "sheets": ("Sheet", "sheet_names", "Gravity"),
    "rods": ("optimal_rod", "NotRealizable", "Rod", "bend", "stability"),
    "nearest": ("nearest_rod", "nearest_rods", "Limits", "Keep"),
    "strips": ("StripSpec", "make_strip", "Strip", "Plain", "Tab", "Perforated", "Laminated"),
    "models": ("Model", "Placed", "save"),
    "rooms": ROOMS,
}
"""Names that programs outside rely on."""


def homes(package):
    """Where each name of a package's door is defined, as its stub says."""
    stub = Path(package.__file__).with_suffix(".pyi")
    return {
        alias.name: node.module
        for node in ast.parse(stub.read_text(encoding="utf-8")).body
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }


def test_the_door_is_small():
    assert len(ec.__all__) <= MOST


@pytest.mark.parametrize("name", [name for names in FIXED.values() for name in names])
def test_fixed_names_are_there(name):
    assert name in ec.__all__
    assert getattr(ec, name) is not None


@pytest.mark.parametrize("room", ["", *ROOMS])
def test_doors_lead_to_what_is_defined_there(room):
    package = import_module(f"elastica_cad.{room}".rstrip("."))
    assert package.__doc__
    assert dir(package) == sorted(homes(package)) == package.__all__
    for name, home in homes(package).items():
        value = getattr(package, name)
        if inspect.isclass(value) or inspect.isfunction(value):
            assert value.__module__ == home, name


@pytest.mark.parametrize("room", ["", *ROOMS])
def test_no_name_hides_a_folder(room):
    """`ec.mechanics.stability` is a folder or a function, and one cannot tell which import came first."""
    package = import_module(f"elastica_cad.{room}".rstrip("."))
    inside = {path.stem for path in Path(package.__file__).parent.iterdir() if not path.stem.startswith("_")}
    hidden = {name for name in package.__all__ if name in inside}
    assert {name for name in hidden if not isinstance(getattr(package, name), ModuleType)} == set()


def documented_fields(cls):
    """Fields that the class text speaks of: in its docstring, or in a string under the field."""
    text = inspect.getdoc(cls) or ""
    for base in cls.__mro__:
        if base.__module__.startswith("elastica_cad"):
            text += inspect.getdoc(base) or ""
            for below in zip(
                *(ast.parse(inspect.getsource(base)).body[0].body[i:] for i in (0, 1)), strict=False
            ):
                if isinstance(below[0], ast.AnnAssign) and isinstance(below[1], ast.Expr):
                    text += f" {ast.unparse(below[0].target)} "
    return {field.name for field in fields(cls) if field.name in text.replace("`", " ").replace(",", " ")}


@pytest.mark.parametrize("name", ec.__all__)
def test_every_name_explains_itself(name):
    """A docstring, with an example that runs or, for a record, a word about each field."""
    value = getattr(ec, name)
    text = inspect.getdoc(value) or ""
    assert text
    if isinstance(value, ModuleType) or (inspect.isclass(value) and issubclass(value, (Exception, Enum))):
        return
    if ">>>" in text:
        return
    assert is_dataclass(value), f"{name} has no example"
    unspoken = {field.name for field in fields(value) if not field.name.startswith("_")} - documented_fields(
        value
    )
    assert unspoken == set()
