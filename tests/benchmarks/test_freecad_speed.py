"""What a hand feels in FreeCAD: the overlay, a recompute and an undo, alone and among a hundred strips."""

import shutil

import numpy as np
import pytest

from tests.freecad import launching

pytestmark = pytest.mark.skipif(
    shutil.which("xvfb-run") is None, reason="FreeCAD is not set up: run tests/setup.sh"
)


WORK = {
    "overlay": "preview in a sketch after each move of the mouse",
    "recompute": "recompute of a bent strip, with a window",
}
"""Words of the page for the figures of `many_strips.py`."""


def test_recomputes(benchmark, tmp_path):
    """Of a strip and its flat part, without a window."""
    found = benchmark.pedantic(lambda: launching.run_console("recomputes.py", tmp_path), rounds=1)
    for name, times in found["recomputes"].items():
        benchmark.extra_info[f"recompute of {name} with its flat part, without a window, ms"] = round(
            1e3 * float(np.median(times)), 1
        )


def test_a_hundred_strips(benchmark, tmp_path):
    found = benchmark.pedantic(lambda: launching.run_window("many_strips.py", tmp_path), rounds=1)
    assert found["strips"] == 100
    for work in ("overlay", "recompute"):
        alone, among = (1e3 * float(np.median(found[f"{work} {where}"])) for where in ("alone", "among many"))
        benchmark.extra_info[f"{WORK[work]}, ms"] = round(alone, 1)
        benchmark.extra_info[f"{WORK[work]}, 100 strips in the document, ms"] = round(among, 1)
        assert among <= 2 * alone
    clock, processor = found["undo of a box"]
    benchmark.extra_info["undo of the move of a box, 100 strips in the document, ms by the clock"] = round(
        1e3 * clock
    )
    benchmark.extra_info["undo of the move of a box, 100 strips in the document, ms of processor time"] = (
        round(1e3 * processor)
    )
