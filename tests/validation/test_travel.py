"""Forces along a travel against closed forms and against the work they do."""

import csv
import io
from dataclasses import replace

import numpy as np
import pytest

from elastica_cad import Rod, Sheet, Strip, Supports, bend, bend_strip

pytestmark = pytest.mark.core

STEEL = Sheet.named("spring-steel-0.5")
LENGTH, WIDTH = 200.0, 12.0


@pytest.fixture(scope="module")
def clip():
    return Strip(Rod.straight(LENGTH, samples=801), STEEL, max_width=WIDTH)


def test_buckling_force_of_the_elastica_table(clip):
    """P / Pcr of the uniform rod with clamped ends, at chords of REFERENCE's table (first mode), bent as a beam."""
    clip = replace(clip, sheet=replace(STEEL, poisson_ratio=0.0))
    table = np.array([(1.01540, 0.96973), (1.15172, 0.74102), (1.51839, 0.34899)])
    moved = bend_strip(clip, np.column_stack([LENGTH * table[:, 1], np.zeros(3)]))
    rigidity = STEEL.youngs_modulus * STEEL.thickness**3 * WIDTH / 12
    critical = 4 * np.pi**2 * rigidity / LENGTH**2
    np.testing.assert_allclose(np.hypot(*moved.end_force.T) / critical, table[:, 0], rtol=2e-4)
    assert np.all(moved.end_force[:, 0] < 0)  # pushed towards the start
    assert moved.stable.all()


def test_the_work_put_in_is_the_energy_stored(clip):
    moved = bend_strip(clip, np.column_stack([np.linspace(180, 60, 41), np.linspace(0, 30, 41)]))
    work = np.cumsum((moved.force_along[1:] + moved.force_along[:-1]) / 2 * np.diff(moved.travel))
    np.testing.assert_allclose(work, moved.energy[1:] - moved.energy[0], rtol=2e-3)


def test_forces_and_moments_balance(clip):
    moved = bend_strip(clip, [(150.0, 20.0), (120.0, 40.0)])
    np.testing.assert_allclose(moved.start_force, -moved.end_force, atol=1e-9)
    x, y = moved.end.T
    turning = x * moved.end_force[:, 1] - y * moved.end_force[:, 0]
    np.testing.assert_allclose(moved.start_moment + moved.end_moment + turning, 0, atol=1e-3)


def test_stress_is_modulus_times_skin_strain(clip):
    (step,) = [bend_strip(clip, [(150.0, 0.0)])]
    kappa = np.abs(step.rods[0].curvature).max()
    assert step.strain[0] == pytest.approx(kappa * STEEL.thickness / 2)
    assert step.stress[0] == pytest.approx(STEEL.youngs_modulus * step.strain[0])
    assert step.safety[0] == pytest.approx(STEEL.max_strain / step.strain[0])


def test_a_leaf_spring_pushed_at_a_free_end():
    """Small deflection of a cantilever: F = 3 E I d / L^3."""
    leaf = Strip(
        Rod.straight(100.0, supports=Supports("clamped", "pinned"), samples=401), STEEL, max_width=10.0
    )
    shortened = 3 * 0.8**2 / (5 * 100)  # of a tip that nothing pulls along the leaf
    deep = bend_strip(leaf, [(100 - shortened, 0.8)], side=1)
    rigidity = STEEL.youngs_modulus * STEEL.thickness**3 * 10 / 12
    assert deep.end_force[0, 1] == pytest.approx(3 * rigidity * 0.8 / 100**3, rel=0.02)


def test_a_weight_runs_away_where_the_energy_curves_down(clip):
    """A dead force adds a line to the energy, so that its potential curves as the energy does."""
    moved = bend_strip(clip, [(x, 40.0) for x in range(80, 20, -5)])
    k = int(np.argmax(np.diff(moved.energy, 2) < 0)) + 1
    assert k > 1
    assert moved.force_falls_at == pytest.approx(moved.travel[k], abs=5.001)
    assert moved.stable.all()
    assert "an end pushed by a weight runs away" in moved.warnings[0]


def test_a_clip_that_is_pressed_together_pushes_back_ever_more(clip):
    assert bend_strip(clip, [(x, 0.0) for x in np.linspace(190, 60, 6)]).force_falls_at is None


def test_a_clip_crosses_itself_where_its_halves_cross_the_middle(clip):
    moved = bend_strip(clip, [(60.0, 0.0), (10.0, 0.0)])
    for shift, crossed in ((-0.2, False), (0.2, True)):
        x = LENGTH - moved.crosses_at - shift
        half = bend(moved.rods[1], end=(x, 0.0)).position[: 801 // 2, 0]
        assert bool(half.max() > x / 2) is crossed
    assert "crosses itself" in moved.warnings[0]


def test_the_table_is_read_back(clip):
    moved = bend_strip(clip, [(150.0, 0.0), (140.0, 0.0)])
    rows = list(csv.DictReader(io.StringIO(moved.csv())))
    assert len(rows) == 2
    assert float(rows[1]["travel_mm"]) == pytest.approx(60.0)
    assert float(rows[1]["energy_Nmm"]) == pytest.approx(moved.energy[1], rel=1e-8)
