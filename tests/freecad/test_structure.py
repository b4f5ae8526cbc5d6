"""The house: small folders, no circle of imports, and the names that users' files hold."""

import ast
from collections import Counter
from graphlib import TopologicalSorter
from pathlib import Path

CODE = Path(__file__).resolve().parents[2] / "freecad_workbench" / "freecad"
PACKAGE = "freecad.elastica_wb"
MOST = 12  # modules of a folder, beside its __init__


def module_files():
    found = {}
    for path in CODE.rglob("*.py"):
        name = ".".join(("freecad", *path.relative_to(CODE).with_suffix("").parts))
        found[name.removesuffix(".__init__")] = path
    return found


def imports():
    """Each module of the workbench with those that it imports anywhere, in functions too."""
    files = module_files()
    graph = {}
    for name, path in files.items():
        graph[name] = set()
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Import):
                graph[name] |= {alias.name for alias in node.names if alias.name in files}
            elif isinstance(node, ast.ImportFrom) and (node.module or "").startswith(PACKAGE):
                whole = {f"{node.module}.{alias.name}" for alias in node.names}
                graph[name] |= {one if one in files else node.module for one in whole}
    return graph


def test_no_circle_of_imports():
    graph = imports()
    assert len(graph) > 40
    assert len(list(TopologicalSorter(graph).static_order())) == len(graph)


def test_small_folders():
    sizes = Counter(path.parent.name for path in CODE.rglob("*.py") if path.stem != "__init__")
    assert {folder: size for folder, size in sizes.items() if size > MOST} == {}


def test_what_files_of_users_name_stays():
    for module, names in {
        "strip": "StripFeature create strip_of",
        "flat": "FlatFeature create",
        "model": "ModelFeature create",
        "fixtures": "FixturesFeature create",
        "baseplate": "BasePlateFeature RingsFeature create create_rings",
        "nest": "NestFeature create",
        "flexure": "FlexureFeature create",
        "views": "StripView FlatView ModelView FixturesView BasePlateView RingsView NestView",
    }.items():
        tree = ast.parse((CODE / "elastica_wb" / "features" / f"{module}.py").read_text(encoding="utf-8"))
        held = {n.name for n in tree.body if isinstance(n, (ast.ClassDef, ast.FunctionDef))}
        assert set(names.split()) <= held, module
