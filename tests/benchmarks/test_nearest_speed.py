"""Speed of `nearest_rod` in seconds of the processor: what the user waits, whoever else is at work."""

import json
import time

import numpy as np
import pytest

from elastica_cad import Gravity, Keep, Limits, PlaneCurve, Status, _native, nearest_rod

pytestmark = pytest.mark.benchmark(timer=time.process_time)


def unclamped(control_points):
    return PlaneCurve(np.arange(-4.0, len(control_points) + 1), np.asarray(control_points, dtype=float), 4)


@pytest.fixture(scope="module")
def flower_pot(reference_data):
    data = json.loads((reference_data / "reference" / "flower_pot.json").read_text())
    e = np.array(data["e_gravity"]) * 1e-9
    points = [np.array(c["cp_initial"]) * 1000 * data["scale_m_per_unit"] for c in data["curves"]]
    return points, Gravity(np.hypot(*e) ** (-1 / 3), tuple(-e))


def test_sixteen_light_curves(benchmark, flower_pot):
    points, _ = flower_pot
    found = benchmark.pedantic(
        lambda: [nearest_rod(unclamped(p), Limits(ratio=2.5)) for p in points], rounds=5, warmup_rounds=1
    )
    assert all(near.met for near in found)
    assert benchmark.stats.stats.min / 16 <= 0.025


def test_sixteen_heavy_stable_curves(benchmark, flower_pot):
    points, gravity = flower_pot
    limits = Limits(ratio=3.3, margin=5.0)
    found = benchmark.pedantic(
        lambda: [nearest_rod(unclamped(p), limits, gravity=gravity) for p in points],
        rounds=5,
        warmup_rounds=1,
    )
    assert all(near.met for near in found)
    assert benchmark.stats.stats.min <= 1.5
    assert benchmark.stats.stats.min / 16 <= 0.060


def test_second_solves_after_a_small_move(benchmark, flower_pot):
    points, _ = flower_pot
    limits = Limits(ratio=2.5)
    before = [nearest_rod(unclamped(p), limits) for p in points]
    after = [p + 0.002 * np.ptp(p) * (np.arange(len(p)) == 3)[:, None] for p in points]

    def solved(starts):
        return [
            nearest_rod(unclamped(p), limits, start=start) for p, start in zip(after, starts, strict=True)
        ]

    def seconds(starts):
        began = time.process_time()
        solved(starts)
        return time.process_time() - began

    found = benchmark.pedantic(lambda: solved(before), rounds=5, warmup_rounds=1)
    assert all(near.met for near in found)
    afresh = [None] * len(points)
    ratio = min(seconds(before) for _ in range(5)) / min(seconds(afresh) for _ in range(5))
    benchmark.extra_info["ratio"] = ratio
    assert ratio <= 0.9


def test_compiled_beside_python(benchmark, flower_pot, monkeypatch):
    """The compiled loops against Python, on the heavy curves."""
    assert _native.compiled is not None
    points, gravity = flower_pot
    limits = Limits(ratio=3.3, margin=5.0)

    def solved():
        return [nearest_rod(unclamped(p), limits, gravity=gravity) for p in points]

    def seconds():
        began = time.process_time()
        solved()
        return time.process_time() - began

    benchmark.pedantic(solved, rounds=5, warmup_rounds=1)
    compiled, plain = [], []
    for _ in range(5):
        compiled.append(seconds())
        with monkeypatch.context() as patch:
            patch.setattr(_native, "compiled", None)
            plain.append(seconds())
    ratio = min(compiled) / min(plain)
    benchmark.extra_info["ratio"] = ratio
    assert ratio <= 0.75


def test_wishes_that_no_rod_meets(benchmark, flower_pot):
    """To the verdict, which may be that only a rod drawn taut between the ends does: advice comes after it."""
    points, _ = flower_pot
    curves = iter([unclamped(p) for p in points] * 2)
    near = benchmark.pedantic(lambda: nearest_rod(next(curves), Limits(ratio=1.3, margin=500.0)), rounds=8)
    assert near.status in (Status.NOT_MET, Status.FAR)


def test_unstable_s(benchmark, reference_data):
    points = np.loadtxt(reference_data / "hafner" / "spline_infl_simple.txt", skiprows=1) * 30
    near = benchmark.pedantic(
        lambda: nearest_rod(unclamped(points), Limits(ratio=2.954, margin=5.0), Keep(tangents=True)),
        rounds=5,
        warmup_rounds=1,
    )
    assert near.met
    assert benchmark.stats.stats.min <= 0.25


def test_march_with_sensitivities(benchmark):
    from elastica_cad.form_finding.rod_map import StiffnessBasis, StripGrid

    grid = StripGrid(StiffnessBasis(38).at(np.linspace(0, 1, 201)), np.array([1.0, 2.0]))
    z = np.concatenate([np.full(38, 1.5), [4.0, 9.0, -7.0, 0.0, 0.0, 0.3, 1.0]])
    benchmark(lambda: grid.sensitivities(grid.shoot(z)))
    assert benchmark.stats.stats.min <= 1e-3
