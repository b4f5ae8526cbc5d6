"""Cost of the stiffness programs as ratios, in one run, against one plain HiGHS solve of all their rows."""

import runpy

import numpy as np
import pytest

from elastica_cad import Gravity, PlaneCurve
from elastica_cad.mechanics.minimax_lp import minimax_ratio
from elastica_cad.paper.sampled_lp import sampled_rows, sampled_stiffness
from tests.benchmarks.timing import seconds


@pytest.fixture(scope="module")
def plain(project_root):
    """The names of docs/plain_highs.py: the programs of the paper, all rows written out."""
    return runpy.run_path(str(project_root / "docs" / "plain_highs.py"))


def half_ellipse(n):
    curve = PlaneCurve.ellipse((0, 0), (2.0, 1.0), start=0, end=np.pi)
    samples = curve.sample(n)
    return samples.position, samples.curvature


@pytest.mark.parametrize(("n", "limit"), [(200, 0.7), (2000, 0.2)])
def test_row_generation_against_all_rows(benchmark, plain, n, limit):
    position, curvature = half_ellipse(n)
    rows = sampled_rows(position, curvature)

    def at_once():
        return plain["optimum"](plain["light_program"](position, curvature))

    assert minimax_ratio(rows).ratio == pytest.approx(at_once(), rel=1e-8)
    benchmark(minimax_ratio, rows)
    ratio = seconds(lambda: minimax_ratio(rows)) / seconds(at_once)
    benchmark.extra_info["ratio"] = ratio
    assert ratio <= limit


def test_gravity_against_the_full_program(benchmark, plain):
    n = 500
    curve = PlaneCurve.spline([(-90, 0), (-70, 80), (0, 130), (70, 80), (90, 0)])
    samples = curve.sample(n)
    # lengths of order one, or the full program is badly scaled
    position, curvature, gravity = samples.position / 100, samples.curvature * 100, Gravity(0.96)
    weights = np.full(n, curve.length / 100 / (n - 1))
    weights[[0, -1]] /= 2

    def ours():
        return sampled_stiffness(position, curvature, weights, gravity=gravity)

    lp = plain["heavy_program"](position, curvature, weights, gravity.e)
    assert ours().ratio == pytest.approx(plain["optimum"](lp), rel=1e-8)
    benchmark(ours)
    ratio = seconds(ours) / seconds(lambda: plain["optimum"](lp), 5)
    benchmark.extra_info["ratio"] = ratio
    assert ratio <= 0.1


def test_cost_hardly_grows_with_the_samples(benchmark):
    small, large = (sampled_rows(*half_ellipse(n)) for n in (200, 20000))
    benchmark(minimax_ratio, large)
    ratio = seconds(lambda: minimax_ratio(large)) / seconds(lambda: minimax_ratio(small))
    benchmark.extra_info["ratio"] = ratio
    assert ratio <= 5


def test_all_strips_of_the_gallery(benchmark, plain, project_root):
    """The nine models of the paper: the same ratios from both, in a fraction of the seconds."""
    gallery = runpy.run_path(str(project_root / "docs" / "gallery.py"))
    models = {
        name: [part.strip.rod for part in gallery["built"](name)[0].parts]
        for name, seconds_of_the_paper in gallery["PAPER"].items()
        if seconds_of_the_paper
    }
    assert len(models) == 9
    spent = np.zeros(2)
    for name, rods in models.items():
        ours, plainly, apart = plain["race"](rods, repeats=3)
        assert apart <= 1e-8, name
        benchmark.extra_info[name] = ours / plainly
        spent += ours, plainly
    ratio = spent[0] / spent[1]
    benchmark.extra_info["ratio"] = ratio
    every = [plain["samples"](rod) for rods in models.values() for rod in rods]
    benchmark.pedantic(lambda: [plain["ours"](*given) for given in every], rounds=3)
    assert ratio <= 0.2
