"""The margin, its derivatives and the adjoint of Z against independent methods."""

import numpy as np
import pytest
import scipy.linalg

from elastica_cad import Gravity, Rod, Supports, bend
from elastica_cad.mechanics import DiscreteRod, conjugate_point, determinant_gradient, stability_determinant
from elastica_cad.mechanics.bending import state_of, system_of
from elastica_cad.mechanics.discrete_rod import edge_forces

pytestmark = pytest.mark.core

SUPPORTS = [
    Supports(), Supports("pinned", "pinned"), Supports("clamped", "free"), Supports("slide-x", "pinned"),
    Supports("guided", "clamped"),
]  # fmt: skip


def arrays(n=120):
    rng = np.random.default_rng(1)
    s = (np.arange(n) + 0.5) / n
    angles = 1.3 * np.sin(4 * s) + s
    K = 1 + 0.7 * np.sin(3 * np.linspace(0, 1, n + 1)) ** 2
    force = np.array([35.0, -20.0]) + 15 * np.column_stack([s, s**2])
    return K, angles, force, 2.5 / n, rng


@pytest.mark.parametrize("supports", SUPPORTS, ids=str)
def test_margin_is_the_dense_constrained_eigenvalue(supports):
    K, angles, force, h, _ = arrays()
    rod = DiscreteRod(K, angles, force, h, supports)
    (diagonal, off), rows = rod.hessian, rod.constraint_rows
    free = scipy.linalg.null_space(rows) if rows.size else np.eye(angles.size)
    H = np.diag(diagonal) + np.diag(off, 1) + np.diag(off, -1)
    lowest = np.linalg.eigvalsh(free.T @ H @ free)[0] / h * (h * angles.size) ** 2
    found = rod.margin
    assert found.value == pytest.approx(lowest, rel=1e-9)
    assert h * found.mode @ found.mode == pytest.approx(1.0)
    assert rows @ found.mode == pytest.approx(np.zeros(len(rows)), abs=1e-9)
    multipliers = found.multipliers[[i for i, both in enumerate(supports.transmits_force) if both]]
    left = H @ found.mode - lowest / (h * angles.size) ** 2 * h * found.mode - rows.T @ multipliers
    assert np.abs(left).max() < 1e-7


@pytest.mark.parametrize("supports", SUPPORTS, ids=str)
def test_margin_derivatives(supports):
    K, angles, force, h, rng = arrays()
    slopes = DiscreteRod(K, angles, force, h, supports).margin_derivatives
    dK, da = rng.standard_normal(K.size), rng.standard_normal(angles.size)
    dl, stretch = rng.standard_normal(force.shape), 0.4

    def value(t):
        return DiscreteRod(
            K + t * dK, angles + t * da, force + t * dl, h * (1 + t * stretch), supports
        ).margin.value

    step = 3e-6
    difference = (value(step) - value(-step)) / (2 * step)
    length = h * angles.size
    formula = (
        slopes.stiffness @ dK
        + slopes.angles @ da
        + np.sum(slopes.force * dl)
        + slopes.length * stretch * length
    )
    assert formula == pytest.approx(difference, rel=1e-6)


@pytest.mark.parametrize(
    ("supports", "end", "force"),
    [
        (Supports(), (0.55, 0.1), None),
        (Supports("pinned", "clamped"), (0.5, 0.1), None),
        (Supports("clamped", "slide-x"), (0.0, 0.3), (-30.0, 0.0)),
        (Supports("slide-y", "clamped"), (0.7, 0.0), None),
    ],
    ids=str,
)
def test_adjoint_of_the_determinant_with_weight(supports, end, force):
    """dF/dK with the equilibrium following, against central differences of `bend`."""
    K = np.array([1.0, 1.6, 1.2, 2.0])
    rod = Rod.straight(1.0, K, samples=61, supports=supports, gravity=Gravity(0.6))
    rod = bend(rod, end=end, force=force)
    n = 60
    weights = np.exp(-(((np.arange(n + 1) - 40) / 6) ** 2))

    def objective(rod):
        return weights @ stability_determinant(rod.discrete).value

    slope = np.outer(rod.node_lengths, rod.gravity.direction) / rod.gravity.length**3
    gradient = determinant_gradient(rod.discrete, weights=weights, moments=rod.moment, load_slope=slope)
    direction = np.cos(np.arange(n + 1) / 7)
    direction[int(np.argmin(rod.stiffness))] = 0.0

    def moved(t):
        from dataclasses import replace

        return bend(replace(rod, stiffness=rod.stiffness + t * direction))

    step = 1e-5
    difference = (objective(moved(step)) - objective(moved(-step))) / (2 * step)
    assert gradient @ direction == pytest.approx(difference, rel=2e-6)


def test_a_discrete_rod_is_what_bend_had():
    rod = bend(Rod.straight(100.0, [1.0, 2.0], samples=51, gravity=Gravity(60.0)), end=(70.0, 10.0))
    state = state_of(rod, system_of(rod, rod))
    assert state.imbalance < 1e-10
    assert state.gap < 1e-12
    assert rod.discrete.position == pytest.approx(rod.position, abs=1e-10)
    assert edge_forces(rod.force[0] + rod.nodal_load[0], rod.nodal_load) == pytest.approx(
        state.discrete.force, abs=1e-12
    )


def test_conjugate_point_of_a_straight_strut():
    """Straight, so one constraint: int h = 0 as well; sigma = 2 pi / sqrt(P) from the clamped start."""
    n, P = 800, 90.0
    place = conjugate_point(DiscreteRod(np.ones(n + 1), np.zeros(n), np.array([P, 0.0]), 1 / n))
    assert place == pytest.approx(2 * np.pi / np.sqrt(P), rel=1e-5)
