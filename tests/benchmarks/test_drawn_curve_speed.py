"""What a drawn spline costs as it is dragged, against a fixed number of evaluations by scipy, in one run.

Processor seconds; every curve is new, so that nothing is remembered.
"""

from time import process_time

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

from elastica_cad import PlaneCurve, check_equilibrium, optimal_rod

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


def seconds(task, subjects):
    """The least time of a task on one of its subjects."""
    spent = []
    for subject in subjects:
        start = process_time()
        task(subject)
        spent.append(process_time() - start)
    return min(spent)


def evaluated(name):
    """Five hundred times 601 points of a cubic spline, with two derivatives, by scipy: ours may become faster."""
    points = np.array(CURVES[name], dtype=float)
    spline, t = CubicSpline(np.arange(len(points)), points), np.linspace(0, len(points) - 1, 601)
    for _ in range(500):
        for order in range(3):
            spline(t, order)


@pytest.mark.parametrize(
    ("task", "name", "limit"),
    [
        (check_equilibrium, "arch", 0.09),
        (check_equilibrium, "wave", 0.19),
        (optimal_rod, "arch", 0.4),
        (optimal_rod, "wave", 0.6),
    ],
)
def test_drawn_curve_against_its_evaluations(benchmark, task, name, limit):
    curves = dragged(name, 25)
    benchmark.pedantic(task, setup=lambda: ((next(curves),), {}), rounds=25)
    ratio = seconds(task, dragged(name, 15)) / seconds(evaluated, [name] * 5)
    benchmark.extra_info["ratio"] = ratio
    assert ratio <= limit
