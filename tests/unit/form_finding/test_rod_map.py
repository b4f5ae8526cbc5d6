"""Shot rods and their sensitivities against the discrete energy, finite differences and closed forms."""

import numpy as np
import pytest

from elastica_cad.form_finding.rod_map import StiffnessBasis, StripGrid
from elastica_cad.mechanics.discrete_rod import bending_moments, edge_forces, node_weights, shoot

pytestmark = pytest.mark.core

EDGES = 60


def grid(e=(0.0, 0.0), count=9, kappa_0=0.0):
    return StripGrid(StiffnessBasis(count).at(np.linspace(0, 1, EDGES + 1)), np.array(e), kappa_0)


def unknowns(g, seed=1):
    rng = np.random.default_rng(seed)
    z = np.zeros(g.unknowns.count)
    z[g.unknowns.stiffness] = 1 + 2 * rng.random(g.unknowns.coefficients)
    z[g.unknowns.moment], z[g.unknowns.force] = 4.0, (11.0, -8.0)
    z[g.unknowns.position], z[g.unknowns.angle], z[g.unknowns.length] = (0.3, -0.2), 0.4, 1.2
    return z


def test_a_circle_is_shot_exactly():
    w = node_weights(0.1, 20)
    angles, moments = shoot(np.full(21, 2.0), w, np.zeros((20, 2)), 0.1, moment=3.0, angle=0.2)
    np.testing.assert_allclose(moments, 3.0)
    np.testing.assert_allclose(angles[-1], 0.2 + 2.0 * 1.5)


@pytest.mark.parametrize("e", [(0.0, 0.0), (3.0, -7.0)])
def test_every_shot_rod_is_stationary(e):
    g = grid(e, kappa_0=0.7)
    rod = g.shoot(unknowns(g))
    w = node_weights(rod.edge_length, EDGES)
    load = -(w * rod.stiffness)[:, None] * np.array(e)
    np.testing.assert_allclose(rod.force, edge_forces(rod.all_forces[0] + load[0], load), atol=1e-12)
    moments = bending_moments(
        rod.stiffness, rod.angles, w, ends=(rod.all_angles[0], rod.all_angles[-1]), natural_curvature=0.7
    )
    residual = rod.moment_imbalance(moments)
    assert np.abs(residual).max() < 1e-11 * np.abs(moments).max()


@pytest.mark.parametrize("e", [(0.0, 0.0), (3.0, -7.0)])
@pytest.mark.parametrize("field", ["all_angles", "moments", "position"])
def test_sensitivities_are_derivatives(e, field):
    g = grid(e, kappa_0=0.3)
    z = unknowns(g)
    exact = getattr(g.sensitivities(g.shoot(z)), field.removeprefix("all_"))
    for j in range(z.size):
        h = 1e-5 * np.eye(z.size)[j]
        numeric = (getattr(g.shoot(z + h), field) - getattr(g.shoot(z - h), field)) / 2e-5
        np.testing.assert_allclose(exact[..., j], numeric, atol=1e-7 * max(1, np.abs(numeric).max()))


def test_forces_have_gradients():
    g = grid((3.0, -7.0))
    z = unknowns(g)
    weights = np.random.default_rng(0).normal(size=(EDGES, 2))
    d = g.sensitivities(g.shoot(z))
    for j in range(z.size):
        h = 1e-5 * np.eye(z.size)[j]
        edge = (np.sum(weights * g.shoot(z + h).force) - np.sum(weights * g.shoot(z - h).force)) / 2e-5
        np.testing.assert_allclose(d.of_weighted_forces(weights)[j], edge, atol=1e-6)
        one = np.zeros((EDGES, 2))
        one[-1, 1] = 1
        last = (g.shoot(z + h).all_forces[-1, 1] - g.shoot(z - h).all_forces[-1, 1]) / 2e-5
        np.testing.assert_allclose((d.of_weighted_forces(one) + d.last_load_row(1))[j], last, atol=1e-6)


@pytest.mark.parametrize("e", [(0.0, 0.0), (3.0, -7.0)])
def test_closing_column_leads_to_balance(e):
    g = grid(e)
    z = unknowns(g)
    rod = g.shoot(z)
    rng = np.random.default_rng(3)
    angles, moments = (
        rod.all_angles + 1e-3 * rng.normal(size=EDGES + 2),
        rod.moments + 1e-3 * rng.normal(size=EDGES + 1),
    )
    for _ in range(5):
        d = g.sensitivities(g.assemble(z, angles, moments), to_equilibrium=True)
        angles, moments = angles + d.angles[:, -1], moments + d.moments[:, -1]
    np.testing.assert_allclose(angles, rod.all_angles, atol=1e-12)
    np.testing.assert_allclose(moments, rod.moments, atol=1e-10)


def test_a_rod_that_winds_up_says_so():
    g = grid()
    z = unknowns(g)
    z[g.unknowns.force] = (1e300, 1e300)
    assert np.isnan(g.shoot(z).moments[-1])


def test_a_start_that_winds_up_is_left():
    from elastica_cad.form_finding.curve_distance import MeanDistance
    from elastica_cad.form_finding.rod_problem import RodProblem
    from elastica_cad.form_finding.sqp import minimize

    g = grid()
    u = g.unknowns
    lower, upper = np.full(u.count, -np.inf), np.full(u.count, np.inf)
    lower[u.stiffness], upper[u.stiffness] = 1.0, 2.0
    lower[u.length], upper[u.length] = 0.5, 2.0
    targets = np.column_stack([np.linspace(0, 1, EDGES + 1), np.zeros(EDGES + 1)])
    distance = MeanDistance(targets, np.full(EDGES + 1, 1 / (EDGES + 1)))
    problem = RodProblem(lower, upper, np.ones(u.count), grid=g, distance=distance, constraints=())
    z = unknowns(g)
    z[u.force] = (1e300, 1e300)
    assert minimize(problem, g.shoot(z)).objective < 1e-8
