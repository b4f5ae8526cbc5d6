"""Whole processes, as a person waits for them: wall time from the command to its end, the files being warm.

Warm as pip leaves them: with the compiled modules on disk, wherever this run itself may write.
"""

import os
import subprocess
import sys
from time import perf_counter

import pytest

ARCH = [(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)]
PLY = ("--sheet", "birch-plywood-0.8", "--max-width", "40")
QUICK = ("--no-step", "--no-parts", "--no-effects", "--no-pictures")
ELASTICA = (sys.executable, "-m", "elastica_cad")
WITHOUT_A_KERNEL = (
    sys.executable, "-c",
    "import sys; sys.modules['OCP'] = None; from elastica_cad.cli import main; main()",
)  # fmt: skip
PERFORATED = ("--style", "perforated", "--outer-width", "60", "--set", "style.columns=4", "--set",
              "style.rows=135", "--no-step")  # fmt: skip
"""1220 holes."""

LAMP = """
import runpy, sys
import elastica_cad as ec
model = runpy.run_path(sys.argv[1])["build"]()
ec.save_model(model, sys.argv[2], sheet_size=(1250.0, 1250.0), step=False, force=True)
"""
PROCESSES = {
    "import": lambda examples, out: (sys.executable, "-c", "import elastica_cad"),
    "check": lambda examples, out: (*ELASTICA, "check", examples / "arch" / "arch.dxf"),
    "strip without STEP": lambda examples, out: (
        *WITHOUT_A_KERNEL, "strip", examples / "arch" / "arch.dxf", *PLY, "--output", out / "arch", "--force"
    ),
    "pavilion": lambda examples, out: (
        *ELASTICA, "model", examples / "pavilion" / "pavilion.toml", *QUICK, "--output", out, "--force"
    ),
    "perforated": lambda examples, out: (
        *ELASTICA, "strip", drawn_large(out), *PLY[:2], *PERFORATED, "--output", out / "holes", "--force"
    ),
    "lamp": lambda examples, out: (
        sys.executable, "-c", LAMP, examples / "lamp" / "lamp.py", out / "lamp"
    ),
}  # fmt: skip


def drawn_large(folder):
    """A file of an arch of 2.9 m."""
    path = folder / "arch.csv"
    path.write_text("x,y\n" + "".join(f"{12 * x},{12 * y}\n" for x, y in ARCH))
    return path


@pytest.mark.parametrize("name", list(PROCESSES))
def test_whole_process(benchmark, project_root, tmp_path, name):
    words = PROCESSES[name](project_root / "examples", tmp_path)
    compiled = {"PYTHONDONTWRITEBYTECODE": "", "PYTHONPYCACHEPREFIX": str(tmp_path / "compiled")}

    def run():
        return subprocess.run(
            words, check=True, capture_output=True, cwd=tmp_path, env=dict(os.environ) | compiled
        )

    def seconds_of_numpy():
        start = perf_counter()
        subprocess.run([sys.executable, "-c", "import numpy"], check=True, env=dict(os.environ) | compiled)
        return perf_counter() - start

    benchmark.pedantic(run, rounds=5, warmup_rounds=1)
    seconds_of_numpy()  # compiles its modules, if the process above did not import them
    benchmark.extra_info["ratio"] = benchmark.stats.stats.median / seconds_of_numpy()
