"""Rods of nonlinear material bent forward, against boundary value problems in the curvature itself."""

import numpy as np
import pytest

from elastica_cad import ElasticaError, Gravity, Rod, Supports, bend, stability
from elastica_cad.mechanics import ElasticPlasticLaw, PlasticLaw, PolynomialLaw

pytestmark = pytest.mark.core

LENGTH, CHORD = 100.0, 70.0
LAWS = {
    "hardening": PolynomialLaw(0.6, curvature_scale=0.06),
    "softening": PolynomialLaw(-0.08, curvature_scale=0.06),
    "yielding": ElasticPlasticLaw(0.04),
}


def clamped_arch_by_bvp(law):
    """K = 1: m(kappa) = a + <b, gamma>, so kappa' = <b, gamma'> / m'(kappa); alpha = 0 at both ends."""
    from scipy.integrate import solve_bvp

    def field(s, y, b):
        alpha, kappa = y[0], y[1]
        c, t = np.cos(alpha), np.sin(alpha)
        return LENGTH * np.array([kappa, (b[0] * c + b[1] * t) / law.slope(kappa), c, t])

    def ends(start, end, b):
        return np.array([start[0], start[2], start[3], end[0], end[2] - CHORD, end[3]])

    s = np.linspace(0, 1, 201)
    alpha = 1.2 * np.sin(2 * np.pi * s)
    x = np.cumsum(np.cos(alpha)) * CHORD / np.cos(alpha).sum()
    guess = np.vstack(
        [alpha, 1.2 * 2 * np.pi / LENGTH * np.cos(2 * np.pi * s), x, 30 * np.sin(np.pi * s) ** 2]
    )
    solved = solve_bvp(field, ends, s, guess, p=[0.0, -0.003], tol=1e-8, max_nodes=20000)
    assert solved.success
    return solved.sol(np.linspace(0, 1, 401))


@pytest.mark.parametrize("name", LAWS)
def test_clamped_arch(name):
    law = LAWS[name]
    expected = clamped_arch_by_bvp(law)
    arch = bend(Rod.straight(LENGTH, law=law, samples=401), end=(CHORD, 0.0))
    assert arch.position == pytest.approx(expected[2:].T, abs=6e-3)
    assert arch.curvature == pytest.approx(expected[1], abs=2e-5)
    assert arch.moment == pytest.approx(law.effective_curvature(arch.curvature))
    plain = bend(Rod.straight(LENGTH, samples=401), end=(CHORD, 0.0))
    assert np.abs(arch.position - plain.position).max() > 0.1
    assert stability(arch).stable


def test_second_order_convergence():
    law = LAWS["hardening"]
    exact = clamped_arch_by_bvp(law)[2:].T
    errors = []
    for n in (51, 101, 201):
        arch = bend(Rod.straight(LENGTH, law=law, samples=n), end=(CHORD, 0.0))
        errors.append(np.abs(arch.position - exact[:: 400 // (n - 1)]).max())
    rates = np.log2(np.array(errors[:-1]) / errors[1:])
    assert rates == pytest.approx([2.0, 2.0], abs=0.1)


def test_cantilever_with_a_hardening_law_by_shooting():
    """Tip load F down: M(s) = -F (L - s) for small angles; m(kappa) = M, integrated twice."""
    law = PolynomialLaw(0.5, curvature_scale=1e-4)
    F = 2e-6
    rod = bend(Rod.straight(LENGTH, law=law, supports=Supports("clamped", "free")), force=(0.0, -F))
    s = rod.s
    moments = -F * (LENGTH - s)
    kappa = law.curvature(moments)
    assert rod.moment == pytest.approx(moments, abs=1e-8)
    assert rod.curvature == pytest.approx(kappa, abs=1e-8)
    assert -rod.position[-1, 1] == pytest.approx(-np.sum(rod.node_lengths * kappa * (LENGTH - s)), rel=1e-4)


def test_weight_and_a_moment_at_a_free_end():
    law = LAWS["yielding"]
    rod = Rod.straight(LENGTH, law=law, supports=Supports("clamped", "free"), gravity=Gravity(90.0))
    bent = bend(rod, moment=0.05)
    assert bent.moment[-1] == pytest.approx(0.05)
    assert bent.curvature[-1] == pytest.approx(law.curvature(0.05))
    assert law.effective_curvature(bent.curvature) == pytest.approx(bent.moment, rel=1e-9)


def test_a_law_that_is_linear_changes_nothing():
    plain = bend(Rod.straight(LENGTH, [1, 2, 1.5], samples=201), end=(CHORD, 5.0))
    lawful = bend(Rod.straight(LENGTH, [1, 2, 1.5], samples=201, law=PolynomialLaw(0.0)), end=(CHORD, 5.0))
    assert lawful.position == pytest.approx(plain.position, abs=1e-9)
    assert stability(lawful).margin == pytest.approx(stability(plain).margin, rel=1e-6)


def test_stability_feels_the_tangent_stiffness():
    """A softening arch gives way more easily than the plain strip of the same shape would."""
    soft = bend(Rod.straight(LENGTH, law=LAWS["softening"]), end=(CHORD, 0.0))
    assert soft.tangent_stiffness == pytest.approx(LAWS["softening"].slope(soft.curvature))
    assert 0 < stability(soft).margin < stability(bend(Rod.straight(LENGTH), end=(CHORD, 0.0))).margin


def test_beyond_the_crest_there_is_no_shape():
    law = PolynomialLaw(-0.3, curvature_scale=0.03)
    with pytest.raises(ElasticaError):
        bend(Rod.straight(LENGTH, law=law), end=(30.0, 0.0))
    with pytest.raises(ElasticaError):
        bend(Rod.straight(LENGTH, law=PlasticLaw(0.02)), end=(50.0, 0.0))
