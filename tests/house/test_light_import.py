"""`import elastica_cad` costs a moment: no library is loaded before it is used."""

import subprocess
import sys

import pytest

pytestmark = pytest.mark.core

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
        "heavy = {'scipy', 'highspy', 'ezdxf', 'svgelements', 'click', 'matplotlib', 'OCP', 'shapely'}\n"
        "print(sorted(heavy & {name.split('.')[0] for name in sys.modules}))"
    )
    result = subprocess.run(
        [sys.executable, "-c", code], cwd=project_root, capture_output=True, text=True, check=False
    )
    assert result.stdout.strip() == "[]", result.stderr


COMPILED = {"scipy.linalg._flapack", "scipy.optimize._zeros"}
"""Files of scipy that are loaded without their packages."""


HEAVY = (
    "scipy",
    "numpy.ma.",
    "numpy.random.",
    "matplotlib",
    "trimesh",
    "elastica_cad.design.revolution_table",
    "elastica_cad.design.sections_table",
    "elastica_cad.forming.nearest_task",
    "elastica_cad.model.batten",
    "elastica_cad.pairs",
    "elastica_cad.published",
)


@pytest.mark.parametrize("command", [("check", ARCH), STRIP, PAVILION], ids=lambda words: words[0])
def test_commands_load_no_module_of_other_requests(command, project_root, tmp_path):
    code = (
        "import sys\n"
        "from elastica_cad.cli.commands import elastica\n"
        "elastica(sys.argv[1:], standalone_mode=False)\n"
        "print(*sys.modules)"
    )
    words = [*command, *([str(tmp_path)] if command[-1] == "-o" else [])]
    result = subprocess.run(
        [sys.executable, "-c", code, *words], cwd=project_root, capture_output=True, text=True, check=False
    )
    assert result.returncode == 0, result.stderr
    loaded = set(result.stdout.splitlines()[-1].split()) - COMPILED
    assert "ezdxf" in loaded
    assert [name for name in sorted(loaded) if name.startswith(HEAVY)] == []
