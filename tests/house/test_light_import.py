"""`import elastica_cad` costs a moment: no library is loaded before it is used."""

import os
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

import numpy
import pytest

import elastica_cad as ec

ARCH = "examples/arch/arch.dxf"
STRIP = (
    "strip",
    ARCH,
    "--sheet",
    "birch-plywood-0.8",
    "--max-width",
    "40",
    "--no-step",
    "--no-pictures",
    "-o",
)
PAVILION = (
    "model",
    "examples/pavilion/pavilion.toml",
    "--no-step",
    "--no-parts",
    "--no-effects",
    "--no-pictures",
    "-o",
)


def test_import_needs_numpy_only(project_root):
    code = (
        "import sys, elastica_cad\n"
        "heavy = {'scipy', 'highspy', 'ezdxf', 'cssselect2', 'tinycss2', 'click', 'matplotlib', 'OCP', 'shapely'}\n"
        "print(sorted(heavy & {name.split('.')[0] for name in sys.modules}))"
    )
    result = subprocess.run(
        [sys.executable, "-c", code], cwd=project_root, capture_output=True, text=True, check=False
    )
    assert result.stdout.strip() == "[]", result.stderr


COMPILED = {"scipy.linalg._flapack"}
"""Files of scipy that are loaded without their packages."""


HEAVY = (
    "scipy",
    "numpy.ma.",
    "numpy.random.",
    "matplotlib",
    "trimesh",
    "elastica_cad.design.revolution_table",
    "elastica_cad.design.sections_table",
    "elastica_cad.form_finding.nearest_task",
    "elastica_cad.model.batten",
    "elastica_cad.pairs",
    "elastica_cad.paper",
)
OF_STRIPS = (
    "elastica_cad.geometry.control_point_constraints",
    "elastica_cad.strip.strip",
    "elastica_cad.strip.suggestions",
)
"""Modules that a check needs only for a curve that has to be moved, or for a change that it suggests."""


TWO_EDGES = b"""0
SECTION
2
ENTITIES
0
ARC
8
0
10
0
20
0
40
100
50
30
51
90
0
ARC
8
0
10
0
20
0
40
100
50
90
51
150
0
ENDSEC
0
EOF
"""
"""A drawing of half an arch twice, so that its edges have to be joined."""


@pytest.mark.parametrize("pure", ["", "1"], ids=["compiled loops", "Python alone"])
@pytest.mark.parametrize(
    "command",
    [("check", ARCH), ("check", "two-edges.dxf"), STRIP, PAVILION],
    ids=["check", "two edges", "strip", "model"],
)
def test_commands_load_no_module_of_other_requests(command, pure, project_root, tmp_path):
    (tmp_path / "two-edges.dxf").write_bytes(TWO_EDGES)
    command = [word.replace("two-edges.dxf", str(tmp_path / "two-edges.dxf")) for word in command]
    code = (
        "import sys\n"
        "from elastica_cad.cli.commands import elastica\n"
        "elastica(sys.argv[1:], standalone_mode=False)\n"
        "print(*sys.modules)"
    )
    words = [*command, *([str(tmp_path)] if command[-1] == "-o" else [])]
    result = subprocess.run(
        [sys.executable, "-c", code, *words], cwd=project_root, capture_output=True, text=True, check=False,
        env=os.environ | {"ELASTICA_PURE": pure},
    )  # fmt: skip
    assert result.returncode == 0, result.stderr
    loaded = set(result.stdout.splitlines()[-1].split()) - COMPILED
    assert "ezdxf" in loaded
    assert not (pure and "elastica_cad._native.loops" in loaded)
    others = HEAVY + OF_STRIPS if command[0] == "check" else HEAVY
    assert [name for name in sorted(loaded) if name.startswith(others)] == []


def test_a_missing_scipy_is_named_with_its_installation(tmp_path, project_root):
    for installed in Path(numpy.__file__).parents[1].iterdir():
        if not installed.name.startswith("scipy"):
            (tmp_path / installed.name).symlink_to(installed)
    places = [str(project_root), str(tmp_path)]
    command = f"import sys; sys.path[:0] = {places!r}; from elastica_cad.cli import main; main()"
    done = subprocess.run(
        [sys.executable, "-S", "-c", command, "check", project_root / ARCH],
        capture_output=True,
        text=True,
        check=False,
    )
    assert "! Error     elastica_cad computes with scipy: " in done.stderr
    assert "pip install scipy" in done.stderr
    assert "Traceback" not in done.stderr


def test_the_version_is_a_name_of_the_package():
    assert ec.__version__ == version("elastica-cad")
