"""What a drawn spline costs as it is dragged, against a fixed number of evaluations of it, in one run.

Processor seconds; every curve is new, so that nothing is remembered.
"""

from time import process_time

import numpy as np
import pytest

from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.stiffness.optimal_rod import optimal_rod
from elastica_cad.mechanics.theorem1.equilibrium_check import check_equilibrium

pytestmark = pytest.mark.benchmark(timer=process_time)

CURVES = {
    "arch": [(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)],
    "wave": [(0, 0), (50, 80), (90, 60), (120, -60), (160, -80), (210, 0)],
}


def dragged(name, count):
    """The curve with its third pole on the way."""
    for step in range(count):
        points = np.array(CURVES[name], dtype=float)
        points[2] += (0.1 * (step + 1), 0.03 * step)
        yield PlaneCurve.spline(points)


def seconds(task, curves):
    """The least time of a task on one of the curves."""
    spent = []
    for curve in curves:
        start = process_time()
        task(curve)
        spent.append(process_time() - start)
    return min(spent)


def evaluated(curve):
    """A hundred times 601 points with two derivatives."""
    t = np.linspace(*curve.domain, 601)
    for _ in range(100):
        curve.derivatives(t, 2)


@pytest.mark.parametrize(
    ("task", "name", "limit"),
    [
        (check_equilibrium, "arch", 0.15),
        (check_equilibrium, "wave", 0.3),
        (optimal_rod, "arch", 0.75),
        (optimal_rod, "wave", 1.1),
    ],
)
def test_drawn_curve_against_its_evaluations(benchmark, task, name, limit):
    benchmark.pedantic(task, setup=lambda: ((next(dragged(name, 1)),), {}), rounds=5)
    ratio = seconds(task, dragged(name, 15)) / seconds(evaluated, dragged(name, 5))
    benchmark.extra_info["ratio"] = ratio
    assert ratio <= limit
