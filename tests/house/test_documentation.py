"""What the documentation names is there: files, functions of the equations, links, commands, public names."""

import re
from importlib import import_module
from operator import attrgetter
from pathlib import Path

import pytest

import elastica_cad as ec

ROOT = Path(__file__).resolve().parents[2]
PAGES = (
    "README.md",
    "CONTRIBUTING.md",
    "CHANGELOG.md",
    "docs/architecture.md",
    "docs/code_cad.md",
    "freecad_workbench/README.md",
)
PLACES = ("elastica_cad", "freecad_workbench", "tests", "docs", "examples")


def read(page):
    return (ROOT / page).read_text(encoding="utf-8")


def quoted(page):
    """What stands between backticks outside of code blocks."""
    return re.findall(r"`([^`\n]+)`", re.sub(r"```.*?```", "", read(page), flags=re.DOTALL))


@pytest.mark.parametrize("page", PAGES)
def test_files_that_are_named_exist(page):
    named = [text for text in quoted(page) if re.match(rf"({'|'.join(PLACES)})/[\w./-]+$", text)]
    missing = [text for text in named if "NAME" not in text and not (ROOT / text).exists()]
    assert missing == []


@pytest.mark.parametrize("page", PAGES)
def test_links_lead_somewhere(page):
    targets = re.findall(r"\]\(([^)#]+)", read(page))
    lost = [t for t in targets if not t.startswith("http") and not ((ROOT / page).parent / t).exists()]
    assert lost == []


@pytest.mark.parametrize("page", PAGES)
def test_make_knows_what_pages_ask_of_it(page):
    makefile = read("Makefile")
    targets = [text.split()[1] for text in quoted(page) if text.startswith("make ")]
    assert [target for target in targets if not re.search(rf"^{target}:", makefile, re.MULTILINE)] == []


@pytest.mark.parametrize("page", PAGES)
def test_names_of_the_front_door_are_there(page):
    for name in re.findall(r"\bec((?:\.\w+)+)", read(page)):
        found = ec
        for part in name[1:].split(".")[:2]:
            assert hasattr(found, part), f"{page} names ec{name}"
            found = getattr(found, part)
            if part not in ec.__all__ or not hasattr(found, "__path__"):
                break


def test_names_in_code_of_the_manual_are_in_the_reference():
    """Names of packages that a page imports, or names as `ec.package.name`, have a section there."""
    shown = re.findall(r"^### (\S+)$", read("docs/reference/python.md"), re.MULTILINE)
    packages, used = "|".join(ec.__all__), set[str]()
    for page in sorted((ROOT / "docs").rglob("*/*.md")):
        text = read(page)
        used |= {".".join(named) for named in re.findall(rf"\bec\.({packages})\.([a-zA-Z]\w+)", text)}
        for package, names in re.findall(rf"from elastica_cad\.({packages}) import ([\w, ]+)", text):
            used |= {f"{package}.{name.strip()}" for name in names.split(",")}
    packaged = {name for name in used if hasattr(getattr(ec, name.split(".")[0]), "__path__")}
    assert len(packaged) > 10
    assert packaged - {*shown} <= {"paper.sampled_stiffness"}  # the algorithm of the paper, for comparison


def rows():
    """File and function of each row of the table of equations."""
    table = read("docs/architecture.md").split("## Equations")[1].split("##")[0]
    return re.findall(r"^\| ([^|]+) \| [^|]+ \| `([^`]+)` \| `(\w+)` \|$", table, re.MULTILINE)


@pytest.mark.parametrize(("equation", "file", "name"), rows())
def test_every_equation_has_its_function(equation, file, name):
    module = import_module(file.removesuffix(".py").replace("/", "."))
    assert getattr(module, name).__module__ == module.__name__, equation


def test_no_equation_is_left_out():
    named = " ".join(equation for equation, _, _ in rows())
    for wanted in ("Eq. 1", "Eq. 2", "Eq. 3", "Eq. 4", "Eq. 5", "Eq. 6", "Eq. 7", "5.3", "6.2", "6.4", "7.1", "7.2",
                   "8.1", "9.4", "Appendix A", "Appendix B", "Appendix C", "Appendix D"):  # fmt: skip
        assert wanted in named


def calls():
    """Module and name of each call in the three ways through the code."""
    ways = re.findall(r"```text\n(.*?)```", read("docs/architecture.md"), re.DOTALL)
    return [line.split()[0].split(".", 1) for way in ways for line in way.splitlines()]


@pytest.mark.parametrize(("module", "name"), calls())
def test_calls_of_the_three_ways_exist(module, name):
    (file,) = (ROOT / "elastica_cad").glob(f"*/{module}.py")
    attrgetter(name)(import_module(f"elastica_cad.{file.parent.name}.{module}"))


def test_the_citation_is_of_this_version():
    version = ec.__version__
    assert f"\nversion: {version}\n" in read("CITATION.cff")
