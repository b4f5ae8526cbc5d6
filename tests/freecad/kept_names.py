"""Names of FreeCAD's properties and commands: python -m tests.freecad.kept_names writes the list of this version.

Documents store the properties, macros type both. `test_kept_names.py` compares later versions with the lists.
"""

import ast
import json
import tomllib
from importlib import import_module

from tests.freecad.conftest import ROOT

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


def main() -> None:
    """Write the list of the version in pyproject.toml."""
    version = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["version"]
    LISTS.mkdir(exist_ok=True)
    text = json.dumps({place: sorted(listed) for place, listed in names().items()}, indent=0)
    (LISTS / f"{version}.json").write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
