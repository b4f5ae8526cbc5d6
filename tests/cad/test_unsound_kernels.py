"""OCP that is installed and cannot be used: all but the bodies is written, and a line says what to install."""

import os
import subprocess
import sys

import pytest

ARCH = """<svg xmlns="http://www.w3.org/2000/svg" width="240mm" height="180mm" viewBox="0 0 240 180">
<path d="M 20 160 C 20 40 220 40 220 160" fill="none" stroke="black"/></svg>"""

DESIGN = """schema = 1
sheet = "birch-plywood-0.8"
max_width = 30
[[strips]]
label = "A"
curve = "arch.svg"
"""


def run(folder, *words):
    """The command with the OCP of a folder."""
    way = os.pathsep.join((str(folder / "site"), os.environ.get("PYTHONPATH", "")))
    return subprocess.run(
        [sys.executable, "-m", "elastica_cad", *words],
        cwd=folder, env={**os.environ, "PYTHONPATH": way}, capture_output=True, text=True, check=False,
    )  # fmt: skip


@pytest.fixture
def folder(tmp_path):
    """A drawing, a design, and an OCP of the newer line whose modules the other line has written over."""
    (tmp_path / "arch.svg").write_text(ARCH)
    (tmp_path / "one.toml").write_text(DESIGN)
    ocp = tmp_path / "site" / "OCP"
    ocp.mkdir(parents=True)
    (ocp / "__init__.py").write_text('__version__ = "8.0.1"\n')
    (ocp / "gp.py").write_text("from .OCP.gp import *\n")
    return tmp_path


def installed(folder, **packages):
    for name, version in packages.items():
        about = folder / "site" / f"{name}-{version}.dist-info"
        about.mkdir()
        (about / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n")


@pytest.mark.campaign
def test_two_kernels_in_one_environment(folder):
    installed(folder, cadquery_ocp="7.8.1.1", cadquery_ocp_novtk="8.0.1.1")
    strip = run(folder, "strip", "arch.svg", "--sheet", "birch-plywood-0.8", "--max-width", "30", "-o", "out")
    model = run(folder, "model", "one.toml", "-o", "kit", "--no-pictures")
    for result, written in ((strip, "out/arch.dxf"), (model, "kit/one.json")):
        text = " ".join((result.stdout + result.stderr).split())
        assert result.returncode == 0, text
        assert (folder / written).exists()
        assert (
            "cadquery-ocp 7.8.1.1 and cadquery-ocp-novtk 8.0.1.1 overwrite each other in the same environment"
            in text
        )
        assert "Make separate environments for build123d and CadQuery" in text
    assert not list(folder.glob("*/**/*.step"))


@pytest.mark.campaign
def test_a_library_of_the_system_that_is_missing(folder):
    (folder / "site" / "OCP" / "__init__.py").write_text(
        'raise ImportError("libGL.so.1: cannot open shared object file: No such file or directory")\n'
    )
    result = run(
        folder, "strip", "arch.svg", "--sheet", "birch-plywood-0.8", "--max-width", "30", "-o", "out"
    )
    assert result.returncode == 0, result.stderr
    assert "libGL.so.1" in result.stdout
    assert "Install the named package" in result.stdout
    (folder / "part.step").write_text("ISO-10303-21;\n")
    read = run(folder, "check", "part.step")
    assert read.returncode == 2
    assert "Traceback" not in read.stderr
    assert "libGL.so.1" in read.stderr


@pytest.mark.parametrize("library", ["build123d", "cadquery"])
def test_a_library_that_stands_on_it(library, folder):
    """It had been asked for again: "needs build123d: pip install build123d"."""
    (folder / "site" / "OCP" / "__init__.py").write_text('raise ImportError("libGL.so.1: cannot open")\n')
    (folder / "site" / f"{library}.py").write_text("import OCP\n")  # whichever of the two is installed
    way = os.pathsep.join((str(folder / "site"), os.environ.get("PYTHONPATH", "")))
    result = subprocess.run(
        [sys.executable, "-c", f"import elastica_cad.{library}"],
        cwd=folder, env={**os.environ, "PYTHONPATH": way}, capture_output=True, text=True, check=False,
    )  # fmt: skip
    last = result.stderr.strip().splitlines()[-1]
    assert last.startswith(f"ImportError: elastica_cad.{library} needs ")
    assert "cannot be loaded (libGL.so.1: cannot open). Install the named package" in last
    assert "pip install" not in last
