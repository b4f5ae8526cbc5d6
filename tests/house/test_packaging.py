"""What the wheel and the source archive hold, and what the root of a checkout lets others import."""

import os
import re
import shutil
import subprocess
import sys
import tarfile
import venv
import zipfile
from xml.etree import ElementTree

import pytest

DATA = (
    "cli/templates/arch.toml",
    "py.typed",
    "__init__.pyi",
    "mechanics/sheets.toml",
    "strip/glyphs.toml",
)


PLAIN = "-q --import-mode=importlib --strict-markers"
"""Options of pytest without those of the everyday suite."""


def run(*arguments, cwd, **environment):
    return subprocess.run(
        [sys.executable, *arguments], cwd=cwd, capture_output=True, text=True, check=False,
        env=dict(os.environ) | environment,
    )  # fmt: skip


def test_no_packages_in_tests_and_examples(project_root):
    """The Addon Manager puts the checkout's root on FreeCAD's path: these folders must not be importable."""
    found = [p for folder in ("tests", "examples") for p in (project_root / folder).rglob("__init__.py")]
    assert found == []


def source_archive(project_root, tmp_path):
    """What a checkout's tracked files become."""
    tracked = subprocess.run(
        ["git", "ls-files"], cwd=project_root, capture_output=True, text=True, check=True
    )
    for name in tracked.stdout.split("\n"):
        if name and (project_root / name).is_file():
            (tmp_path / "source" / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(project_root / name, tmp_path / "source" / name)
    code = f"from setuptools import build_meta; build_meta.build_sdist({str(tmp_path)!r})"
    result = run("-c", code, cwd=tmp_path / "source")
    assert result.returncode == 0, result.stderr
    (archive,) = tmp_path.glob("*.tar.gz")
    return archive


@pytest.fixture
def addon(project_root, tmp_path):
    """Function that writes the addon with some options and returns its folder and what was printed."""

    def write(*options):
        script = project_root / "freecad_workbench" / "make_addon.py"
        written = run(str(script), str(tmp_path / "Elastica"), *options, cwd=tmp_path)
        return tmp_path / "Elastica", written.stdout + written.stderr

    return write


def test_addon_for_this_computer(addon):
    folder, printed = addon()
    assert "MAINTAINER is missing" in printed
    assert "REPOSITORY is missing" in printed
    page = (folder / "README.md").read_text(encoding="utf-8")
    assert "](" not in page, "a link into the checkout leads nowhere from Mod"


def test_addon_to_publish(addon, project_root):
    folder, printed = addon(
        "--maintainer", "Ann <ann@example.org>", "--repository", "https://example.org/ann/e.git"
    )
    assert "missing" not in printed
    package = ElementTree.parse(folder / "package.xml").getroot()
    space = {"": "https://wiki.freecad.org/Package_Metadata"}
    maintainer = package.find("maintainer", space)
    assert (maintainer.text, maintainer.get("email")) == ("Ann", "ann@example.org")
    urls = {url.get("type"): url.text for url in package.findall("url", space)}
    assert urls["repository"] == "https://example.org/ann/e"
    assert set(urls) == {"repository", "readme", "documentation", "bugtracker"}
    page = (folder / "README.md").read_text(encoding="utf-8")
    assert all(target.startswith("https://example.org/ann/e/") for target in re.findall(r"\]\(([^)]*)", page))
    pictures = re.findall(r"!\[[^]]*\]\(https://example.org/ann/e/raw/main/([^)]*)", page)
    assert pictures
    assert all((project_root / picture).is_file() for picture in pictures)


@pytest.mark.parametrize("option", [("--maintainer", "Ann"), ("--repository", "elastica")])
def test_addon_with_unusable_names(addon, option):
    folder, printed = addon(*option)
    assert option[1] in printed
    assert "Write " in printed
    assert not folder.exists()


@pytest.mark.campaign
def test_the_source_archive_holds_what_the_readme_names(project_root, tmp_path):
    archive = source_archive(project_root, tmp_path)
    with tarfile.open(archive) as packed:
        held = {name.partition("/")[2] for name in packed.getnames()}
    page = (project_root / "README.md").read_text(encoding="utf-8")
    linked = {target for target in re.findall(r"\]\(([^)#]+)", page) if not target.startswith("http")}
    named = set(re.findall(r"\b(?:examples|docs|tests|freecad_workbench)/[\w./-]+\.\w+", page))
    assert (linked | named) - {name for name in named if "NAME" in name} <= held


def built(project_root, folder, **environment):
    """The wheel that pip makes of what a checkout holds, without the network."""
    source = folder / "source"
    source.mkdir(parents=True)
    leave_out = shutil.ignore_patterns("__pycache__", "*.so")
    for name in ("elastica_cad", "freecad_workbench", "tests", "examples"):
        shutil.copytree(project_root / name, source / name, ignore=leave_out)
    for name in ("pyproject.toml", "setup.py", "README.md", "LICENSE"):
        shutil.copy(project_root / name, source)
    result = run("-m", "pip", "wheel", "--no-deps", "--no-build-isolation", "--disable-pip-version-check",
                 "--wheel-dir", str(folder), ".", cwd=source, **environment)  # fmt: skip
    assert result.returncode == 0, result.stderr
    (wheel,) = folder.glob("*.whl")
    return wheel


def compiled_of(wheel, folder):
    """Whether the package finds its compiled loops where it is unpacked, with no compiler on the path."""
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(folder)
    code = (
        "import elastica_cad as ec; from elastica_cad._native import compiled; "
        "arch = ec.PlaneCurve.spline([(0, 0), (30, 60), (70, 60), (100, 0)], degree=3); "
        "print(compiled is not None, ec.nearest_rod(arch, ec.Limits(ratio=1.5)).met, ec.__file__)"
    )
    result = run("-c", code, cwd=folder, PYTHONPATH=str(folder), PATH="")
    assert result.returncode == 0, result.stderr
    found, met, place = result.stdout.split(maxsplit=2)
    assert place.startswith(str(folder))
    return found, met


@pytest.mark.campaign
def test_wheel_holds_the_package_only(project_root, tmp_path):
    wheel = built(project_root, tmp_path)
    with zipfile.ZipFile(wheel) as archive:
        names = set(archive.namelist())
    assert names >= {f"elastica_cad/{name}" for name in DATA}
    assert {name.split("/")[0] for name in names if ".dist-info/" not in name} == {"elastica_cad"}
    assert not [name for name in names if name.endswith((".c", ".h"))]


@pytest.mark.campaign
def test_wheel_needs_no_compiler_where_it_is_installed(project_root, tmp_path):
    """One wheel for Python 3.11 and later holds the compiled loops."""
    wheel = built(project_root, tmp_path)
    assert "-cp311-abi3-" in wheel.name
    assert compiled_of(wheel, tmp_path / "installed") == ("True", "True")


@pytest.mark.campaign
def test_wheel_is_built_without_a_compiler(project_root, tmp_path):
    """What Python does more slowly is left to it."""
    wheel = built(project_root, tmp_path, CC="/no/compiler/here")
    assert wheel.name.endswith("-py3-none-any.whl")
    assert compiled_of(wheel, tmp_path / "installed") == ("False", "True")


@pytest.mark.campaign
def test_the_contract_holds_where_nothing_else_is_installed(project_root, tmp_path):
    """Source archive, wheel of it, an empty environment with what the wheel asks for: the archive's own tests."""
    archive = source_archive(project_root, tmp_path)
    with tarfile.open(archive) as packed:
        packed.extractall(tmp_path / "unpacked", filter="data")
    (source,) = (tmp_path / "unpacked").iterdir()
    made = run(
        "-m", "pip", "wheel", "--quiet", "--no-deps", "--wheel-dir", str(tmp_path), str(source), cwd=tmp_path
    )
    assert made.returncode == 0, made.stderr
    (wheel,) = tmp_path.glob("*.whl")
    shutil.rmtree(source / "elastica_cad")
    venv.create(tmp_path / "empty", with_pip=True)
    (python,) = (tmp_path / "empty").glob("*/python")
    options = (
        f"{wheel}[plot,build123d,cadquery,studio]",
        "build123d==0.12.0",
        "cadquery==2.8.0",
        "pytest",
        "hypothesis",
    )
    for words in (
        ("pip", "install", "--quiet", *options),
        ("pytest", "-o", f"addopts={PLAIN}", "tests/contract"),
    ):
        done = subprocess.run(
            [python, "-m", *words], cwd=source, capture_output=True, text=True, check=False,
            env={name: value for name, value in os.environ.items() if not name.startswith("PYTHON")},
        )  # fmt: skip
        assert done.returncode == 0, done.stdout + done.stderr
    assert " passed" in done.stdout
