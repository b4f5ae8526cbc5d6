"""Names that users type or store: python -m tests.house.kept_names writes the list of this version.

Names may be added. One that is gone would break a script, a design file, a shell history or a program that reads
our reports, so `test_kept_names.py` compares every later version with the lists of earlier ones.
"""

import ast
import inspect
import re
from importlib import import_module
from pathlib import Path

import click

from elastica_cad.cli.commands import elastica
from elastica_cad.design.design_schema import tables
from tests.house.name_lists import write_list

ROOT = Path(__file__).resolve().parents[2]
LISTS = ROOT / "tests" / "data" / "names"
PACKAGES = (
    "", ".geometry", ".mechanics", ".form_finding", ".strip", ".formats", ".model", ".pairs", ".design", ".plot",
)  # fmt: skip


def python_names() -> set[str]:
    """Public names of the packages, with the parameters of functions and classes."""
    names = set()
    for package in PACKAGES:
        module = import_module(f"elastica_cad{package}")
        for name in module.__all__:
            value = getattr(module, name)
            names.add(f"{module.__name__}.{name}")
            if inspect.isfunction(value) or inspect.isclass(value):
                try:
                    parameters = inspect.signature(value).parameters
                except ValueError:  # a class made in C
                    continue
                names |= {f"{module.__name__}.{name}({key})" for key in parameters if not key.startswith("_")}
    return names


def library_names() -> set[str]:
    """Public names for the CAD libraries, read from the source without importing a kernel."""
    names = set()
    for library in ("build123d", "cadquery"):
        source = ast.parse((ROOT / "elastica_cad" / library / "__init__.py").read_text(encoding="utf-8"))
        (listed,) = (
            node.value for node in source.body
            if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "__all__"
        )  # fmt: skip
        names |= {f"{library}.{name}" for name in ast.literal_eval(listed)}
    return names


def option_names() -> set[str]:
    """Commands of the command line with their options."""
    names = _options(elastica)
    context = click.Context(elastica)
    for name in elastica.list_commands(context):
        command = elastica.get_command(context, name)
        assert command is not None
        names |= {f"{name} {option}" for option in _options(command)} | {name}
    return names


def _options(command: click.Command) -> set[str]:
    return {
        word
        for parameter in command.params
        for word in (*parameter.opts, *parameter.secondary_opts)
        if word[0] == "-"
    }


def design_names() -> set[str]:
    """Keys of the tables of design files."""
    return {f"{table}.{key}" for table, keys in tables().items() for key in keys}


def report_names() -> set[str]:
    """Keys of the JSON output that docs/json.md lists."""
    page = (ROOT / "docs" / "json.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| `([\w/-]+)` \| ([^|]*)\|", page, re.M)
    return {f"{kind} {key}" for kind, keys in rows for key in re.findall(r"`([^`]+)`", keys)}


def names() -> dict[str, set[str]]:
    """Names by the place where they are typed or stored."""
    return {
        "Python": python_names(),
        "CAD libraries": library_names(),
        "command line": option_names(),
        "design files": design_names(),
        "JSON": report_names(),
    }


if __name__ == "__main__":
    write_list(LISTS, names())
