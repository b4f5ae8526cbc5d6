"""The floors of the house as a contract, and what the wheel holds."""

import re
import shutil
import subprocess
import sys
import tarfile
import zipfile

DATA = (
    "cli/templates/arch.toml",
    "py.typed",
    "__init__.pyi",
    "mechanics/material/sheets.toml",
    "fabrication/drawings/glyphs.toml",
)


def run(*arguments, cwd):
    return subprocess.run([sys.executable, *arguments], cwd=cwd, capture_output=True, text=True, check=False)


def test_floors_are_kept(project_root):
    code = "from importlinter.cli import lint_imports; raise SystemExit(lint_imports())"
    result = run("-c", code, cwd=project_root)
    assert result.returncode == 0, result.stdout + result.stderr


def test_no_packages_in_tests_and_examples(project_root):
    """The Addon Manager puts the checkout's root on FreeCAD's path: these folders must not be importable."""
    found = [p for folder in ("tests", "examples") for p in (project_root / folder).rglob("__init__.py")]
    assert found == []


def test_the_source_archive_holds_what_the_readme_names(project_root, tmp_path):
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
    with tarfile.open(archive) as packed:
        held = {name.partition("/")[2] for name in packed.getnames()}
    page = (project_root / "README.md").read_text(encoding="utf-8")
    linked = {target for target in re.findall(r"\]\(([^)#]+)", page) if not target.startswith("http")}
    named = set(re.findall(r"\b(?:examples|docs|tests|freecad_workbench)/[\w./-]+\.\w+", page))
    assert (linked | named) - {name for name in named if "NAME" in name} <= held


def test_wheel_holds_the_package_only(project_root, tmp_path):
    source = tmp_path / "source"
    source.mkdir()
    for name in ("elastica_cad", "freecad_workbench", "tests", "examples"):
        shutil.copytree(project_root / name, source / name, ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(project_root / name, source)
    result = run("-m", "pip", "wheel", "--no-deps", "--no-build-isolation", "--disable-pip-version-check",
                 "--wheel-dir", str(tmp_path), ".", cwd=source)  # fmt: skip
    assert result.returncode == 0, result.stderr
    (wheel,) = tmp_path.glob("*.whl")
    with zipfile.ZipFile(wheel) as archive:
        tops = {name.split("/")[0] for name in archive.namelist()}
        assert set(archive.namelist()) >= {f"elastica_cad/{name}" for name in DATA}
    assert {top for top in tops if not top.endswith(".dist-info")} == {"elastica_cad"}
