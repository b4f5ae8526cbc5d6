"""The oldest version of every dependency that pyproject.toml allows: files in, a strip, files out.

`make test` runs this folder in an environment of its own, which requirements.txt beside this file describes.
"""

import os
import re
import subprocess
import sys
import tomllib
from importlib.metadata import version
from pathlib import Path

import ezdxf
import numpy as np
import pytest

import elastica_cad as ec

ROOT = Path(__file__).resolve().parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
EXTRAS = PROJECT["optional-dependencies"]
ARCH = ROOT / "examples" / "arch" / "arch.dxf"


def typed(*words, folder):
    """A command in a process of its own, which must succeed."""
    done = subprocess.run(
        [sys.executable, "-m", "elastica_cad", *words],
        cwd=folder, env=os.environ | {"PYTHONPATH": str(ROOT)}, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("requirement", [*PROJECT["dependencies"], *EXTRAS["plot"], *EXTRAS["mesh"]])
def test_the_version_here_is_the_lower_bound(requirement):
    name, bound = re.fullmatch(r"([\w-]+)>=([\d.]+)", requirement).groups()
    here, wanted = version(name).split("."), bound.split(".")
    assert here == wanted + ["0"] * (len(here) - len(wanted))


# SVG holds no spline of degree 4
@pytest.mark.filterwarnings("ignore::elastica_cad.formats.curve_writer.FitWarning")
@pytest.mark.parametrize("drawn", ["arch.dxf", "arch.svg"])
def test_a_drawn_curve_becomes_files(drawn, tmp_path):
    (curve,) = ec.read_curves(ARCH)
    strip = ec.make_strip(curve, "birch-plywood-0.8", max_width=40)
    ec.formats.write_curves([curve], tmp_path / drawn)
    typed("strip", drawn, "--sheet", "birch-plywood-0.8", "--max-width", "40", "-o", "out", folder=tmp_path)
    written = {path.suffix for path in (tmp_path / "out").iterdir()}
    assert written >= {".dxf", ".svg", ".json", ".png"}
    outline = ezdxf.readfile(tmp_path / "out" / "arch.dxf").modelspace().query('*[layer=="CUT_OUTER"]')
    assert len(outline) >= 4
    (again,) = ec.read_curves(tmp_path / drawn)
    assert again.length == pytest.approx(curve.length, abs=1e-3)
    assert strip.rod.residual < 1e-8


def test_a_nearest_rod_by_linear_programs_and_a_search():
    wave = ec.PlaneCurve.spline([(0, 0), (20, 90), (60, -60), (90, 95), (120, -20), (150, 0)], degree=5)
    near = ec.nearest_rod(wave, ec.Limits(ratio=3.0, margin=2.0))
    assert near.met
    assert ec.stability(near.rod).margin > 1.99


def test_sections_of_a_mesh(tmp_path):
    pot = ROOT / "tests" / "data" / "hafner" / "flower-pot" / "flower-pot.obj"
    typed("sections", str(pot), "--unit", "cm", "--radial", "4", "-o", "out", folder=tmp_path)
    lengths = [curve.length for curve in ec.read_curves(tmp_path / "out" / "flower-pot-sections.json")]
    assert len(lengths) == 4
    assert np.ptp(lengths) < 0.1 * min(lengths)
