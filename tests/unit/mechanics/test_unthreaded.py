"""A strip follows its curve on one thread: BLAS that is woken for small numbers waits for other programs."""

import os
import subprocess
import sys

import pytest

FOLLOW = """
from glob import glob
from os import getpid
from time import sleep
from elastica_cad.strip.strip_spec import StripSpec
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.stability import stability

def follow(height):
    curve = PlaneCurve.spline([(0, 0), (30, 60), (70, height), (120, 60), (150, 0)])
    strip = StripSpec(curve, "birch-plywood-0.8", max_width=30).make()
    assert stability(strip.rod).stable
    return strip

def others():
    files = [name for name in glob("/proc/self/task/*/schedstat") if f"/{getpid()}/" not in name]
    return sum(int(open(name).read().split()[0]) for name in files) / 1e6

for height in (76, 77):
    follow(height)
before = -1.0
while before != others():  # what was woken by imports goes to sleep
    before = others()
    sleep(0.2)
for step in range(20):
    follow(80 + step / 10)
print((others() - before) / 20)
"""


@pytest.mark.parametrize("pure", ["", "1"], ids=["compiled loops", "Python alone"])
def test_following_a_curve_wakes_no_thread_of_blas(pure):
    """Milliseconds of processor that other threads took for each strip."""
    threaded = {name: value for name, value in os.environ.items() if not name.endswith("_NUM_THREADS")}
    result = subprocess.run(
        [sys.executable, "-c", FOLLOW], env=threaded | {"ELASTICA_PURE": pure}, capture_output=True, text=True,
        check=True, timeout=120,
    )  # fmt: skip
    assert float(result.stdout) < 0.05
