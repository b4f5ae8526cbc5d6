"""What a hand feels in FreeCAD: the overlay, a recompute and an undo, alone and among a hundred strips."""

import shutil

import numpy as np
import pytest

from tests.freecad import launching

pytestmark = pytest.mark.skipif(
    shutil.which("xvfb-run") is None, reason="FreeCAD is not set up: run tests/freecad/setup.sh"
)


def test_recomputes(benchmark, tmp_path):
    """Of a strip and its flat part, without a window."""
    found = benchmark.pedantic(lambda: launching.run_console("recomputes.py", tmp_path), rounds=1)
    for name, times in found["recomputes"].items():
        benchmark.extra_info[f"recompute of {name}, its flat part too, without a window, ms"] = round(
            1e3 * float(np.median(times)), 1
        )


def test_a_hundred_strips(benchmark, tmp_path):
    found = benchmark.pedantic(lambda: launching.run_window("many_strips.py", tmp_path), rounds=1)
    assert found["strips"] == 100
    for work in ("overlay", "recompute"):
        alone, among = (1e3 * float(np.median(found[f"{work} {where}"])) for where in ("alone", "among many"))
        benchmark.extra_info[f"{work}, ms"] = round(alone, 1)
        benchmark.extra_info[f"{work} among 100 strips, ms"] = round(among, 1)
        assert among <= 2 * alone
    clock, processor = found["undo of a box"]
    benchmark.extra_info["undo of a box, ms by the clock"] = round(1e3 * clock)
    benchmark.extra_info["undo of a box, ms of the processor"] = round(1e3 * processor)
