"""Names of FreeCAD's properties and commands: python -m tests.freecad.kept_names writes the list of this version.

Documents store the properties, macros type both. `test_kept_names.py` compares later versions with the lists.
"""

import ast
from importlib import import_module

from tests.freecad.conftest import ROOT
from tests.house.name_lists import write_list

LISTS = ROOT / "tests" / "freecad" / "data" / "names"
WORKBENCH = ROOT / "freecad_workbench" / "freecad" / "elastica_wb"


def property_names() -> set[str]:
    """Properties of all features with their types."""
    for path in sorted((WORKBENCH / "features").glob("[a-z]*.py")):
        if path.stem != "views":
            import_module(f"freecad.elastica_wb.features.{path.stem}")
    from freecad.elastica_wb.features.proxy import Feature

    return {
        f"{kind.__name__}.{entry.name} ({entry.type_id})"
        for kind in Feature.__subclasses__()
        for entry in kind.properties
    }


def command_names() -> set[str]:
    """Names of the commands, read from the source because commands need FreeCAD's window."""
    names = set()
    for path in (WORKBENCH / "command.py", WORKBENCH / "commands" / "__init__.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Constant) and str(node.value).startswith("Elastica_"):
                names.add(str(node.value))
    return names


def names() -> dict[str, set[str]]:
    """Names by the place where they are stored or typed."""
    return {"properties": property_names(), "commands": command_names()}


if __name__ == "__main__":
    write_list(LISTS, names())
