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


@pytest.mark.parametrize("command", [("check", ARCH), STRIP], ids=lambda words: words[0])
def test_check_and_strip_load_no_package_of_scipy(command, project_root, tmp_path):
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
    heavy = ("scipy", "matplotlib", "trimesh", "elastica_cad.pairs", "elastica_cad.published")
    assert [name for name in sorted(loaded) if name.startswith(heavy)] == []
