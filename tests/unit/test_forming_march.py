"""The march and its sensitivities against the discrete energy, finite differences and closed forms."""

import numpy as np
import pytest

from elastica_cad.forming.march import StripGrid
from elastica_cad.forming.setting import spline_basis
from elastica_cad.mechanics.discrete import bending_moments, edge_forces, moment_imbalance, node_weights
from elastica_cad.mechanics.march import march

EDGES = 60


def grid(e=(0.0, 0.0), count=9, kappa_0=0.0):
    return StripGrid(spline_basis(np.linspace(0, 1, EDGES + 1), count), np.array(e), kappa_0)


def unknowns(g, seed=1):
    rng = np.random.default_rng(seed)
    z = np.zeros(g.unknowns.count)
    z[g.unknowns.stiffness] = 1 + 2 * rng.random(g.unknowns.coefficients)
    z[g.unknowns.moment], z[g.unknowns.force] = 4.0, (11.0, -8.0)
    z[g.unknowns.position], z[g.unknowns.angle], z[g.unknowns.length] = (0.3, -0.2), 0.4, 1.2
    return z


def test_a_circle_is_marched_exactly():
    w = node_weights(0.1, 20)
    angles, moments = march(np.full(21, 2.0), w, np.zeros((20, 2)), 0.1, moment=3.0, angle=0.2)
    np.testing.assert_allclose(moments, 3.0)
    np.testing.assert_allclose(angles[-1], 0.2 + 2.0 * 1.5)


@pytest.mark.parametrize("e", [(0.0, 0.0), (3.0, -7.0)])
def test_every_marched_rod_is_stationary(e):
    g = grid(e, kappa_0=0.7)
    rod = g.rod(unknowns(g))
    w = node_weights(rod.edge_length, EDGES)
    load = -(w * rod.stiffness)[:, None] * np.array(e)
    np.testing.assert_allclose(rod.edge_force, edge_forces(rod.force[0] + load[0], load), atol=1e-12)
    moments = bending_moments(
        rod.stiffness, rod.edge_angles, w, ends=(rod.angles[0], rod.angles[-1]), natural_curvature=0.7
    )
    residual = moment_imbalance(moments, rod.edge_angles, rod.edge_force, rod.edge_length)
    assert np.abs(residual).max() < 1e-11 * np.abs(moments).max()


@pytest.mark.parametrize("e", [(0.0, 0.0), (3.0, -7.0)])
@pytest.mark.parametrize("field", ["angles", "moments", "position"])
def test_sensitivities_are_derivatives(e, field):
    g = grid(e, kappa_0=0.3)
    z = unknowns(g)
    exact = getattr(g.sensitivities(g.rod(z)), field)
    for j in range(z.size):
        h = 1e-5 * np.eye(z.size)[j]
        numeric = (getattr(g.rod(z + h), field) - getattr(g.rod(z - h), field)) / 2e-5
        np.testing.assert_allclose(exact[..., j], numeric, atol=1e-7 * max(1, np.abs(numeric).max()))


def test_forces_have_gradients():
    g = grid((3.0, -7.0))
    z = unknowns(g)
    weights = np.random.default_rng(0).normal(size=(EDGES, 2))
    d = g.sensitivities(g.rod(z))
    for j in range(z.size):
        h = 1e-5 * np.eye(z.size)[j]
        edge = (np.sum(weights * g.rod(z + h).edge_force) - np.sum(weights * g.rod(z - h).edge_force)) / 2e-5
        np.testing.assert_allclose(d.along_forces(weights)[j], edge, atol=1e-6)
        one = np.zeros((EDGES, 2))
        one[-1, 1] = 1
        last = (g.rod(z + h).force[-1, 1] - g.rod(z - h).force[-1, 1]) / 2e-5
        np.testing.assert_allclose((d.along_forces(one) + d.last_load_row(1))[j], last, atol=1e-6)


@pytest.mark.parametrize("e", [(0.0, 0.0), (3.0, -7.0)])
def test_closing_column_leads_to_balance(e):
    g = grid(e)
    z = unknowns(g)
    rod = g.rod(z)
    rng = np.random.default_rng(3)
    angles, moments = (
        rod.angles + 1e-3 * rng.normal(size=EDGES + 2),
        rod.moments + 1e-3 * rng.normal(size=EDGES + 1),
    )
    for _ in range(5):
        d = g.sensitivities(g.guessed(z, angles, moments), closing=True)
        angles, moments = angles + d.angles[:, -1], moments + d.moments[:, -1]
    np.testing.assert_allclose(angles, rod.angles, atol=1e-12)
    np.testing.assert_allclose(moments, rod.moments, atol=1e-10)
