"""Asks the rows of the tables about the code: floors, names, commands of make and of FreeCAD, what is installed."""

import ast
import importlib.metadata
import inspect
import json
import re
import tomllib
from functools import cache

import pytest
from packaging.requirements import Requirement

from tests.manual.found_in_pages import ROOT, quoted, tables
from tests.manual.proofs import asks, proved_by
from tests.manual.test_freecad_pages import COMMANDS

WORKBENCH = "docs/freecad.md"
TREES = ROOT / "elastica_cad", ROOT / "freecad_workbench" / "freecad"
LIBRARIES = {"highspy", "numpy", "scipy", "ezdxf", "tinycss2", "cssselect2", "trimesh", "OCP", "matplotlib",
             "build123d", "cadquery", "click", "FreeCAD"}  # fmt: skip


@asks("docs/architecture.md", "package", "what it holds", "libraries")
def _floors(row, _):
    """A floor imports the libraries that its row or a row above names, and those of its own row."""
    (floors,) = [t for t in tables() if t.page == "docs/architecture.md" and t.head[0] == "package"]
    above = floors.rows[: floors.rows.index(row)]
    named = {word for one in (*above, row) for word in LIBRARIES if word.lower() in one[2].lower()}
    found = set().union(
        *(imported(place) for place in quoted(row[0]) if "." not in place or place.endswith(".py"))
    )
    assert found & LIBRARIES <= named | ({"FreeCAD"} if "FreeCAD" in row[2] else set())
    own = {word for word in LIBRARIES if word.lower() in row[2].lower()}
    assert own <= found | {"FreeCAD"}


def imported(place):
    """The libraries that the files of a place import, at the top or inside functions."""
    path = ROOT / place
    files = [path] if path.suffix == ".py" else path.rglob("*.py")
    found = set()
    for file in files:
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Import):
                found |= {name.name.split(".")[0] for name in node.names}
            elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
                found.add(node.module.split(".")[0])
    return found


@asks("docs/architecture.md", "paper", "what", "file", "function")
def _equations(row, _):
    proved_by("tests/house/test_documentation.py::test_every_equation_has_its_function")


@asks("docs/architecture.md", "module", "what it holds")
def _modules(row, _):
    """The test compares the tables with what `docs/plan.py` writes."""
    proved_by("tests/house/test_imports.py::test_the_drawing_of_the_packages_is_of_these_imports")
    (name,) = quoted(row[0])
    assert [file for tree in TREES for file in tree.rglob(f"{name}.*") if file.suffix in (".py", ".js")]


@asks("docs/architecture.md", "door", "where it checks")
def _doors(row, _):
    """Each file is in the package or the workbench; each class and function is defined in the package."""
    for name in quoted(row[1]):
        if name.endswith(".py"):
            (file,) = (
                path for tree in TREES for path in tree.rglob(name.rsplit("/")[-1]) if path.match(name)
            )
            assert file
        elif not name.startswith("-"):
            defined = re.compile(rf"^ *(class|def) {name.split('.')[-1]}\b", re.MULTILINE)
            assert any(defined.search(path.read_text(encoding="utf-8")) for path in TREES[0].rglob("*.py"))


@asks("CONTRIBUTING.md", "folder", "what it tests")
def _folders(row, _):
    for name in quoted(row[0]):
        assert (ROOT / name).is_dir(), name


@asks("CONTRIBUTING.md", "campaign", "what it tests", "minutes")
def _campaigns(row, _):
    (name,) = quoted(row[0])
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    assert re.search(rf"^campaign-{name}:", makefile, re.MULTILINE)


@asks("docs/how_to/install.md", "extra", "gives", "size on disk, about")
def _extras(row, _):
    """What is installed here weighs what the row says, within a third: versions differ."""
    extra = "" if row[0] == "(none)" else quoted(row[0])[0]
    known = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"][
        "optional-dependencies"
    ]
    assert extra == "" or extra in known
    number, unit = re.match(r"([\d.]+) (MB|GB)", row[2]).groups()
    result = float(number) * {"MB": 1, "GB": 1000}[unit]
    base = weights("")
    more = base if not extra else {name: size for name, size in weights(extra).items() if name not in base}
    assert sum(more.values()) == pytest.approx(result, rel=1 / 3, abs=3)


@cache
def weights(extra):
    """MB of every distribution that the package needs with an extra."""
    found, waiting = {}, [("elastica-cad", extra)]
    while waiting:
        name, request = waiting.pop()
        there = importlib.metadata.distribution(name)
        found[name] = sum(f.locate().stat().st_size for f in there.files or () if f.locate().exists()) / 1e6
        for line in there.requires or ():
            needed = Requirement(line)
            plain = needed.name.lower().replace("_", "-")
            if plain not in found and (needed.marker is None or needed.marker.evaluate({"extra": request})):
                waiting.append((plain, ",".join(needed.extras)))
    return found


@asks("docs/code_cad.md", "name", "what it is", "base")
def _build123d(row, _):
    import build123d as bd

    from elastica_cad import build123d as ours

    made = getattr(ours, quoted(row[0])[0])
    bases = {"sketch object": bd.BaseSketchObject, "part object": bd.BasePartObject,
             "line object": bd.BaseLineObject, "linear joint": bd.LinearJoint,
             "revolute joint": bd.RevoluteJoint}  # fmt: skip
    if row[2] in bases:
        assert issubclass(made, bases[row[2]])
    else:
        returned = str(inspect.signature(made).return_annotation)
        wanted = {
            "operation": "",
            "compound with children": "Compound",
            "`BentStrip`s": "ShapeList[BentStrip]",
        }[row[2]]
        assert inspect.isfunction(made)
        assert wanted in returned
    for form in re.findall(r'"(\w+)"', row[1]):
        assert form in inspect.getsource(made)


@asks("docs/code_cad.md", "name", "what it is", "returns")
def _cadquery(row, _):
    import cadquery as cq

    from elastica_cad import cadquery as ours

    made = getattr(ours, quoted(row[0])[0])
    if quoted(row[0]) == ["register"]:
        made()
        assert hasattr(cq.Workplane, "elasticStrip")
        assert hasattr(cq.Sketch, "elasticStrip")
    elif inspect.isclass(made):
        assert all(hasattr(made, name) for name in quoted(row[2]))
    else:
        returned = str(inspect.signature(made).return_annotation)
        assert all(name in returned for name in quoted(row[2])), returned
        assert row[2].startswith("list") == returned.startswith("list")


@asks("docs/code_cad.md", "attribute", "what it is")
def _attributes(row, _):
    for rib in ribs()[:1] if "(build123d)" in row[0] else ribs():
        for name in quoted(row[0]):
            assert name.split("(")[0] in dir(rib), name
        if "joints" in row[0]:
            assert {"start", "end"} <= set(rib.joints)
            assert set(quoted(row[1])) - {"hole1", "hole1:top", "hole1:bottom"} <= set(rib.joints)


@cache
def ribs():
    """One bent strip of either kernel."""
    import cadquery as cq

    from elastica_cad.build123d import BentStrip, Elastica
    from elastica_cad.cadquery import bent_strip, elastica

    line = Elastica((0, 0), (70, 0), 100, angles=(80, -80))
    edge = elastica((0, 0), (70, 0), 100, angles=(80, -80))
    assert isinstance(edge, cq.Edge)
    return (
        BentStrip(line.edge(), "polypropylene-0.8", max_width=20),
        bent_strip(edge, "polypropylene-0.8", max_width=20),
    )


@asks("docs/json.md", "schema", "further keys", "meaning")
def _records(row, _):
    """Each command is typed and its keys are compared there."""
    proved_by(
        "tests/unit/cli/test_every_command.py::test_a_command_prints_one_record_with_the_documented_keys"
    )
    proved_by("tests/unit/cli/test_every_command.py::test_a_refusal_is_a_record_too")
    assert re.fullmatch(r"`elastica-\w+/\d`", row[0])


@asks("docs/gallery.md", "", "", "")
def _gallery(row, _):
    """Pictures and scripts are there; what a script draws, it says."""
    for cell in row:
        for target in re.findall(r"\]\(([^)]+)\)", cell):
            path = target.removeprefix("../")
            assert (ROOT / path).is_file(), path


def commands_by_text():
    """Shortcuts of the workbench's commands by what is written on their buttons."""
    return {answer["text"]: answer.get("shortcut") or "" for answer in COMMANDS.values()}


@asks("docs/freecad_tools/rails.md", "kind", "meaning")
def _kinds(row, _):
    panels = ROOT / "freecad_workbench" / "freecad" / "elastica_wb" / "panels"
    panel = (panels / "rails.py").read_text(encoding="utf-8")
    kinds = re.findall(r'QT_TRANSLATE_NOOP\("Elastica", "([^"(]+?)(?: \([^"]*)?"\): Kind\(', panel)
    (table,) = [table for table in tables() if table.page == "docs/freecad_tools/rails.md"]
    assert [kind for kind, _ in table.rows] == kinds
    assert row[0] in kinds


@asks("docs/freecad_tools/strip.md", "button", "change")
def _changes(row, _):
    """Each button is a text of the workbench, with a value in place of each gap."""
    texts = json.loads((ROOT / "elastica_cad" / "translations" / "de.json").read_text(encoding="utf-8"))
    patterns = (
        re.sub(r"\\\{[^}]*\\\}", r"\\S.*", re.escape(text)) for text in texts if re.match(r"\w{3}", text)
    )
    assert any(re.fullmatch(pattern, row[0].strip("*")) for pattern in patterns)


@asks(WORKBENCH, "command", "keys", "purpose")
def _tools(row, _):
    known = commands_by_text()
    if row[0] == "New sketch":  # FreeCAD's own
        proved_by("tests/freecad/test_real_freecad.py::test_first_use_by_mouse_and_keyboard")
        return
    names = ["Perforate", "Laminate"] if row[0] == "Perforate, Laminate" else [row[0]]
    for name in names:
        assert known[name] == row[1]


@asks("docs/publishing.md", "asked of an addon", "here")
def _qualities(row, _):
    """Of our answers all that a file can tell; the rest is what people promise."""
    package = (ROOT / "package.xml").read_text(encoding="utf-8")
    sources = [path.read_text(encoding="utf-8") for path in (ROOT / "freecad_workbench").rglob("*.py")]
    request = row[0]
    if request.startswith("an active maintainer"):
        assert "<maintainer" in package
    elif request.startswith("no user data"):
        assert not [
            text
            for text in sources
            if re.search(r"^\s*(import|from) (urllib|socket|http|requests)", text, re.M)
        ]
    elif request.startswith("safe storage"):
        assert any("ParamGet" in text for text in sources)
    elif request.startswith("security reports"):
        assert (ROOT / "SECURITY.md").is_file()
        assert (ROOT / "CHANGELOG.md").is_file()
    elif request.startswith("a fitting licence"):
        assert "MIT" in (ROOT / "LICENSE").read_text(encoding="utf-8")
        proved_by("tests/freecad/test_resources.py::test_sources_say_their_licence")
    elif request.startswith("Python 3"):
        assert "<pythonmin>3.11</pythonmin>" in package
    elif request.startswith("FreeCAD's own Qt"):
        package = ROOT / "freecad_workbench" / "freecad"
        asking = [p for p in package.rglob("*.py") if re.search(r"from PySide\d? import", p.read_text())]
        assert {path.name for path in asking} == {"qt.py"}
    elif request.startswith("a valid manifest"):
        proved_by("tests/freecad/test_resources.py::test_package_for_the_addon_manager")
    elif request.startswith("no other files"):
        proved_by("tests/freecad/test_real_freecad.py::test_the_addon_that_users_install")
    elif request.startswith("the latest FreeCAD"):
        assert (ROOT / "tests" / "freecad" / "release.sh").is_file()
    else:
        assert request.startswith(("no dependencies", "nothing vendored"))
        needed = re.findall(r'<depend type="python"( optional="true")?>(\w+)<', package)
        assert needed == [("", "numpy"), ("", "scipy"), (' optional="true"', "ezdxf")]
        assert not [text for text in sources if re.search(r"\bpip\b.*install|ensurepip", text)]
