"""Whole processes, as a person waits for them: wall time from the command to its end, the files being warm.

Warm as pip leaves them: with the compiled modules on disk, wherever this run itself may write.
"""

import os
import subprocess
import sys
from time import perf_counter

import pytest

PLY = ("--sheet", "birch-plywood-0.8", "--max-width", "40")
QUICK = ("--no-step", "--no-parts", "--no-effects", "--no-pictures")
ELASTICA = (sys.executable, "-m", "elastica_cad")
WITHOUT_A_KERNEL = (
    sys.executable, "-c",
    "import sys; sys.modules['OCP'] = None; from elastica_cad.cli import main; main()",
)  # fmt: skip
PROCESSES = {
    "import": lambda examples, out: (sys.executable, "-c", "import elastica_cad"),
    "check": lambda examples, out: (*ELASTICA, "check", examples / "arch" / "arch.dxf"),
    "strip without STEP": lambda examples, out: (
        *WITHOUT_A_KERNEL, "strip", examples / "arch" / "arch.dxf", *PLY, "--output", out / "arch", "--force"
    ),
    "pavilion": lambda examples, out: (
        *ELASTICA, "model", examples / "pavilion" / "pavilion.toml", *QUICK, "--output", out, "--force"
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", list(PROCESSES))
def test_whole_process(benchmark, project_root, tmp_path, name):
    words = PROCESSES[name](project_root / "examples", tmp_path)
    compiled = {"PYTHONDONTWRITEBYTECODE": "", "PYTHONPYCACHEPREFIX": str(tmp_path / "compiled")}

    def run():
        return subprocess.run(
            words, check=True, capture_output=True, cwd=tmp_path, env=dict(os.environ) | compiled
        )

    benchmark.pedantic(run, rounds=5, warmup_rounds=1)
    start = perf_counter()
    subprocess.run([sys.executable, "-c", "import numpy"], check=True, env=dict(os.environ) | compiled)
    benchmark.extra_info["ratio"] = benchmark.stats.stats.median / (perf_counter() - start)
