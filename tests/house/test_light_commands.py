"""Commands load what they use: a person waits for every library."""

import os
import subprocess
import sys
from shutil import copy

import pytest

SCIPY = {f"scipy.{name}" for name in ("linalg", "optimize", "interpolate", "special", "sparse", "spatial")}

NOT_FOR_A_STRIP = (
    "forming.nearest.nearest_rod", "forming.nearest.advice", "fabrication.model.strip_model",
    "fabrication.holders.base_plate", "fabrication.interlocking.interlock", "fabrication.sheets.nesting",
    "fabrication.solids.strip_solids",
)  # fmt: skip
"""Rooms that a strip which follows its curve, without bodies, never enters."""

NOT_FOR_STRIPS_IN_A_BASE = (
    "forming.plane_sections.section_spec", "forming.revolution.meridian", "fabrication.model.revolution_model",
)  # fmt: skip
"""Rooms for sections of surfaces, and for surfaces of revolution."""

NOT_FOR_A_CHECK = (
    "mechanics.stiffness.optimal_rod", "mechanics.rod.rod_record", "fabrication.strip_spec",
    "mechanics.material.sheet",
)  # fmt: skip


def _loaded(words, absent, folder):
    """The modules that a command has loaded at its end, where some libraries are not installed."""
    code = (
        "import sys\n"
        f"sys.modules.update(dict.fromkeys({absent!r}))\n"
        "from elastica_cad.cli import main\n"
        "try:\n    main()\nexcept SystemExit as end:\n    assert not end.code\n"
        "print(*sys.modules)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, *words], cwd=folder, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    return set(done.stdout.splitlines()[-1].split())


def test_a_strip_needs_no_package_of_scipy(project_root, tmp_path):
    arch = project_root / "examples" / "arch" / "arch.dxf"
    words = ["strip", str(arch), "--sheet", "birch-plywood-0.8", "--max-width", "40", "-o", str(tmp_path)]
    loaded = _loaded(words, ("OCP", "matplotlib"), tmp_path)
    assert "elastica_cad.fabrication.strip.strip_record" in loaded
    assert not SCIPY & loaded
    assert not {f"elastica_cad.{name}" for name in NOT_FOR_A_STRIP} & loaded


def test_a_model_s_sheets_need_no_library_beyond_numpy_and_ezdxf(project_root, tmp_path):
    pavilion = project_root / "examples" / "pavilion" / "pavilion.toml"
    less = [f"--no-{what}" for what in ("step", "parts", "effects", "pictures")]
    loaded = _loaded(["model", str(pavilion), *less, "-o", str(tmp_path / "kit")], (), tmp_path)
    assert "elastica_cad.formats.drawing_files.dxf_drawing" in loaded
    assert not {"scipy", "matplotlib", "OCP"} & loaded
    assert not {f"elastica_cad.{name}" for name in NOT_FOR_STRIPS_IN_A_BASE} & loaded


@pytest.mark.parametrize("drawn", ["arch.dxf", "arch.svg"])
def test_a_check_loads_no_solver_and_no_reader_of_another_format(drawn, project_root, tmp_path):
    (tmp_path / "arch.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg"><path d="M 0 90 C 40 10 120 0 190 90"/></svg>'
    )
    copy(project_root / "examples" / "arch" / "arch.dxf", tmp_path)
    loaded = _loaded(["check", drawn], (), tmp_path)
    assert "elastica_cad.mechanics.theorem1.equilibrium_check" in loaded
    other = {"arch.dxf": "svgelements", "arch.svg": "ezdxf"}[drawn]
    assert not {"scipy", "highspy", "matplotlib", "OCP", other} & loaded
    assert not {f"elastica_cad.{name}" for name in (*NOT_FOR_A_STRIP, *NOT_FOR_A_CHECK)} & loaded


@pytest.mark.skipif(not os.path.isdir("/proc/self/task"), reason="the system tells no threads")
@pytest.mark.parametrize("asked", [None, "2"])
def test_a_command_begins_no_threads_for_small_matrices(asked, project_root):
    """Each spins for a while when numpy is loaded; whoever asks for them gets them.

    The one that watches the time goes with the command, but the system may still list it for a moment.
    """
    code = (
        "import os, time\nfrom elastica_cad.cli import main\n"
        "def count():\n    time.sleep(0.02)\n    return len(os.listdir('/proc/self/task'))\n"
        "try:\n    main()\nexcept SystemExit:\n    print(min(count() for _ in range(20)))"
    )
    env = {key: value for key, value in os.environ.items() if key != "OPENBLAS_NUM_THREADS"}
    done = subprocess.run(
        [sys.executable, "-c", code, "check", project_root / "examples" / "arch" / "arch.dxf"],
        capture_output=True, text=True, check=True, env=env | ({"OPENBLAS_NUM_THREADS": asked} if asked else {}),
    )  # fmt: skip
    threads = int(done.stdout.splitlines()[-1])
    assert threads == 1 if asked is None else threads <= int(asked)
