"""Commands load what they use: a person waits for every library."""

import subprocess
import sys

SCIPY = {f"scipy.{name}" for name in ("linalg", "optimize", "interpolate", "special", "sparse", "spatial")}

NOT_FOR_A_STRIP = (
    "forming.nearest.nearest_rod", "forming.nearest.advice", "fabrication.model.strip_model",
    "fabrication.holders.base_plate", "fabrication.interlocking.interlock", "fabrication.sheets.nesting",
    "fabrication.solids.strip_solids",
)  # fmt: skip
"""Rooms that a strip which follows its curve, without bodies, never enters."""


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
