"""Tolerance study: each cause by hand, determinism, executors, failures that are counted."""

import pickle
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from dataclasses import replace

import numpy as np
import pytest

from elastica_cad import (
    Gravity,
    InputError,
    NotConvergedError,
    PlaneCurve,
    PointMass,
    Profile,
    Rod,
    Sheet,
    Supports,
    Weight,
    bend,
    optimal_rod,
)
from elastica_cad.mechanics import Imperfection, ToleranceRanges, perturb_rod, tolerance_study
from elastica_cad.mechanics import tolerances as tolerance

pytestmark = pytest.mark.core

STIFFNESS = 1 + np.sin(np.linspace(0, np.pi, 61)) ** 2


@pytest.fixture(scope="module")
def arch():
    return bend(Rod.straight(100.0, STIFFNESS), end=(70.0, 0.0))


@pytest.fixture(scope="module")
def heavy_arch():
    return bend(Rod.straight(100.0, STIFFNESS, gravity=Gravity(90.0)), end=(70.0, 0.0))


def deviation(a, b):
    return float(np.hypot(*(a.position - b.position).T).max())


def test_no_variation_is_no_deviation(arch):
    assert deviation(perturb_rod(arch, Imperfection()), arch) < 1e-9


def test_stiffness_range_scales_what_is_above_the_least(arch):
    changed = perturb_rod(arch, Imperfection(stiffness_range=1.5))
    assert changed.stiffness == pytest.approx(1 + 1.5 * (STIFFNESS - 1))
    assert changed.position == pytest.approx(
        bend(Rod.straight(100.0, 1 + 1.5 * (STIFFNESS - 1)), end=(70.0, 0.0)).position, abs=1e-7
    )


def test_end_angles_are_added(arch):
    changed = perturb_rod(arch, Imperfection(start_angle=0.1, end_angle=-0.05))
    assert changed.angle[[0, -1]] == pytest.approx(arch.angle[[0, -1]] + [0.1, -0.05])


def test_lost_width_counts_most_where_the_strip_is_narrow(arch):
    changed = perturb_rod(arch, Imperfection(width_loss=1.0), max_width=20.0)
    widths = 10 * STIFFNESS - 1.0
    assert changed.stiffness == pytest.approx(widths / widths.min())


def test_weight_over_stiffness(heavy_arch):
    v = Imperfection(youngs_modulus=0.9, density=1.1, thickness=0.95)
    assert perturb_rod(heavy_arch, v).gravity.length == pytest.approx(90.0 * (0.9 * 0.95**2 / 1.1) ** (1 / 3))


def test_weight_in_newtons_says_the_same(heavy_arch):
    """beta K / B = K / l_eg^3: the same rod in other words strays by the same amount."""
    B = 500.0
    in_newtons = replace(heavy_arch, weight=Weight(beta=B / 90.0**3), bending_stiffness=B)
    v = Imperfection(youngs_modulus=0.9, density=1.1, thickness=0.95, width_loss=0.8)
    expected = perturb_rod(heavy_arch, v, max_width=20.0)
    assert perturb_rod(in_newtons, v, max_width=20.0).position == pytest.approx(expected.position, abs=1e-7)


def test_hung_masses_do_not_grow_with_density(heavy_arch):
    B = 500.0
    weight = Weight(alpha=Profile.interpolate([0.0, 100.0], [1e-4, 2e-4]), masses=(PointMass(50.0, 2.0),))
    rod = replace(heavy_arch, weight=weight, bending_stiffness=B)
    changed = perturb_rod(rod, Imperfection(density=1.2))
    expected = Weight(alpha=weight.alpha.scaled(1.2), masses=weight.masses)
    assert changed.nodal_load == pytest.approx(replace(rod, weight=expected).nodal_load, rel=1e-12)


def test_plastic_excess_stays_as_natural_curvature(arch):
    limit = 0.8 * float(np.abs(arch.curvature).max())
    changed = perturb_rod(arch, Imperfection(yield_curvature=limit))
    excess = np.sign(arch.curvature) * np.maximum(np.abs(arch.curvature) - limit, 0)
    assert changed.natural_curvature == pytest.approx(excess)
    assert changed.moment == pytest.approx(STIFFNESS * (changed.curvature - excess))
    assert deviation(changed, arch) > 0.1
    # half the thickness yields at twice the curvature
    assert perturb_rod(arch, Imperfection(yield_curvature=limit, thickness=0.5)).natural_curvature == 0.0


@pytest.mark.campaign
def test_study_is_the_same_for_the_same_seed_and_any_executor(heavy_arch):
    sheet = Sheet.named("card-200gsm")
    options = {"sheet": sheet, "max_width": 30.0, "samples": 20, "seed": 5}
    alone = tolerance_study(heavy_arch, **options)
    with ThreadPoolExecutor(2) as threads:
        assert tolerance_study(heavy_arch, executor=threads, **options) == alone
    assert tolerance_study(heavy_arch, **{**options, "seed": 6}) != alone
    assert [effect.name for effect in alone.effects] == [
        "stiffness range", "weight", "end angles", "plasticity", "thickness", "kerf", "thickness along the strip",
    ]  # fmt: skip
    for effect in (*alone.effects, alone.combined):
        assert effect.worst >= effect.percentile_95 >= 0
        assert effect.failed == 0
        assert effect.name in str(alone)
    assert alone["combined"].percentile_95 > alone["kerf"].percentile_95 > 0


class PicklingExecutor(Executor):
    """Sends every call through pickle, as a pool of processes does."""

    def submit(self, fn, /, *args, **kwargs):
        future = Future()
        call, given, named = pickle.loads(pickle.dumps((fn, args, kwargs)))
        future.set_result(pickle.loads(pickle.dumps(call(*given, **named))))
        return future


def test_processes_could_share_the_work(arch):
    with PicklingExecutor() as pool:
        assert tolerance_study(arch, samples=4, executor=pool) == tolerance_study(arch, samples=4)


def test_worst_of_a_cause_holds_its_extremes(arch):
    ranges = ToleranceRanges(stiffness_range=(0.7, 1.4), angle=(0.0, 0.0))
    study = tolerance_study(arch, ranges=ranges, samples=5)
    ends = [deviation(perturb_rod(arch, Imperfection(stiffness_range=m)), arch) for m in (0.7, 1.4)]
    assert study["stiffness range"].worst == pytest.approx(max(ends), abs=1e-9)
    assert study["stiffness range"].samples == 7
    assert study["end angles"].worst == study["weight"].worst == study["thickness"].worst == 0.0
    assert study["combined"].worst == pytest.approx(study["stiffness range"].percentile_95, rel=0.5)


def test_a_moment_on_a_free_end_bends_a_softer_strip_more():
    """To a circle of curvature m / (E t^3), wherever the ranges put E and t."""
    circle = bend(Rod.straight(100.0, supports=Supports(end="free"), samples=201), moment=0.01)
    ranges = ToleranceRanges(youngs_modulus=(0.8, 1.0), thickness=(0.9, 1.0))
    study = tolerance_study(circle, ranges=ranges, samples=3)
    for name, soft in (("weight", 0.8), ("thickness", 0.9**3)):
        rolled = bend(circle, moment=0.01 / soft)
        assert np.allclose(rolled.curvature, 0.01 / soft, rtol=1e-9)
        assert study[name].worst == pytest.approx(deviation(rolled, circle), rel=1e-6)
    thin = perturb_rod(circle, Imperfection(width_loss=2.0), max_width=10.0)
    assert np.allclose(thin.curvature, 0.01 / 0.8, rtol=1e-9)


def test_a_design_with_a_warning_of_its_own_does_not_snap():
    kinked = PlaneCurve.spline([(0, 0), (120, 180), (270, 210), (420, -30), (570, 30), (690, 180)], degree=3)
    rod = optimal_rod(kinked, samples=101)
    assert rod.warnings
    study = tolerance_study(rod, ranges=ToleranceRanges(angle=(-0.01, 0.01)), samples=3)
    assert study["end angles"].worst > 0
    assert study["end angles"].snapped == study["combined"].snapped == 0


def test_ranges_of_a_sheet():
    sheet = Sheet(
        "ply", 0.8, 9000.0, density=680.0, max_strain=0.008, kerf=0.2, youngs_modulus_range=(8100.0, 9900.0),
        thickness_range=(0.76, 0.84), max_strain_range=(0.006, 0.01), kerf_range=(0.15, 0.3),
    )  # fmt: skip
    ranges = ToleranceRanges.of(sheet, angle=(-0.01, 0.01))
    assert ranges.youngs_modulus == pytest.approx((0.9, 1.1))
    assert ranges.density == (1.0, 1.0)
    assert ranges.thickness == pytest.approx((0.95, 1.05))
    assert ranges.yield_curvature == pytest.approx((0.015, 0.025))
    assert ranges.width_loss == pytest.approx((-0.05, 0.1))
    assert ranges.angle == (-0.01, 0.01)


def test_bends_that_fail_are_counted(arch, monkeypatch):
    real = tolerance.perturb_rod

    def sometimes(rod, variation, **options):
        if variation.stiffness_range > 1.05:
            raise NotConvergedError("lost")
        return real(rod, variation, **options)

    monkeypatch.setattr(tolerance, "perturb_rod", sometimes)
    study = tolerance_study(arch, samples=10)
    effect = study["stiffness range"]
    assert 1 <= effect.failed < effect.samples
    assert study.failed == effect.failed + study["combined"].failed
    assert f"{effect.failed} of 12 found no rest shape" in str(study)
    assert np.isfinite(effect.worst)


def test_a_snap_is_reported(arch):
    study = tolerance_study(arch, ranges=ToleranceRanges(angle=(1.9, 2.0)), samples=2)
    assert study["end angles"].snapped + study["end angles"].failed > 0
    assert "snapped" in str(study) or "no equilibrium" in str(study)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"samples": 0}, "samples is 0"),
        ({"max_width": -1.0, "ranges": ToleranceRanges(width_loss=(0.0, 0.1))}, "max_width is -1.0"),
        (
            {"max_width": 0.1, "ranges": ToleranceRanges(width_loss=(0.0, 0.1))},
            "is more than the least width",
        ),
    ],
)
def test_bad_options(arch, options, message):
    with pytest.raises(InputError, match=message):
        tolerance_study(arch, **options)


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        ({"angle": (0.1, -0.1)}, "give the lowest first"),
        ({"density": (0.0, 1.0)}, "give numbers above 0"),
        ({"width_loss": (0.0, np.inf)}, "give finite numbers"),
    ],
)
def test_bad_ranges(fields, message):
    with pytest.raises(InputError, match=message):
        ToleranceRanges(**fields)


def test_lost_width_needs_a_width(arch):
    with pytest.raises(InputError, match="set `max_width`"):
        perturb_rod(arch, Imperfection(width_loss=0.1))


def test_unknown_effect(arch):
    with pytest.raises(InputError, match="unknown effect 'wind'"):
        tolerance_study(arch, samples=1)["wind"]


def test_a_wave_of_thickness_along_the_strip_moves_it_without_any_load(arch):
    """As a whole the sheet's thickness leaves the shape alone."""
    wave = perturb_rod(arch, Imperfection(thickness_wave=0.02, wave_phase=0.7))
    K = arch.stiffness * (1 + 0.02 * np.cos(2 * np.pi * arch.s / arch.length + 0.7)) ** 3
    assert wave.position == pytest.approx(bend(arch.with_stiffness(K)).position, abs=1e-9 * arch.length)
    assert deviation(wave, arch) > 1e-4 * arch.length
    study = tolerance_study(arch, samples=4)
    assert study["thickness along the strip"].worst > study["thickness"].worst == 0.0
