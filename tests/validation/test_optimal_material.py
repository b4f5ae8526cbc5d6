"""Optimal stiffness of nonlinear materials: against a dense linear program, and bent forward again."""

from dataclasses import replace

import numpy as np
import pytest

from elastica_cad import Gravity, PlaneCurve, Supports, bend, optimal_rod
from elastica_cad.mechanics import ElasticPlasticLaw, PlasticLaw, PolynomialLaw, TabulatedLaw
from tests.refusals import refusal_test

pytestmark = pytest.mark.core


def arch():
    """Largest curvature 100 / 60^2 = 1/36 mm at the crown."""
    return PlaneCurve.ellipse((0, 0), (60, 100), start=0.0, end=np.pi)


def wave():
    """One inflection, largest curvature 0.0247 1/mm."""
    return PlaneCurve.spline([(0, 0), (40, 60), (90, 70), (140, -10), (190, 10), (230, 60)], degree=4)


TABLE = np.linspace(0.004, 0.06, 8)
LAWS = {
    "hardening": PolynomialLaw(0.5, curvature_scale=0.03),
    "softening": PolynomialLaw(-0.2, curvature_scale=0.03),
    "yielding": ElasticPlasticLaw(0.018),
    "measured": TabulatedLaw(TABLE, np.tanh(25 * TABLE)),
    "ideally plastic": PlasticLaw(0.018),
}


def least_ratio_of_samples(curve, law, samples):
    """min R with 1 <= (a + <b, gamma>) / m(kappa) <= R at uniform samples (Eq. 4 with Appendix D)."""
    from scipy.optimize import linprog

    c = curve.sample(samples)
    rows = np.column_stack([np.ones(samples), c.position / curve.length])
    rows /= law.effective_curvature(c.curvature)[:, None]
    upper = np.vstack(
        [np.column_stack([-rows, np.zeros(samples)]), np.column_stack([rows, -np.ones(samples)])]
    )
    bound = np.concatenate([-np.ones(samples), np.zeros(samples)])
    solved = linprog([0, 0, 0, 1], A_ub=upper, b_ub=bound, bounds=[(None, None)] * 4, method="highs")
    assert solved.success
    return solved.fun


@pytest.mark.parametrize("name", LAWS)
def test_least_ratio_of_the_dense_program(name):
    law = LAWS[name]
    rod = optimal_rod(arch(), law=law)
    assert rod.law == law
    assert rod.residual < 1e-9
    expected = least_ratio_of_samples(arch(), law, 4001)
    # ideal plasticity has its largest stiffness in a kink, between samples
    missed = 3e-4 if law.kinks and law.kinks[0][1] == 0 else 2e-6
    assert expected * (1 - 1e-9) <= rod.ratio <= expected * (1 + missed)
    assert rod.ratio != pytest.approx(optimal_rod(arch()).ratio, rel=1e-3)
    at_samples = optimal_rod(arch(), law=law, samples=301)
    assert at_samples.stiffness.max() == pytest.approx(least_ratio_of_samples(arch(), law, 301), rel=1e-8)


@pytest.mark.parametrize("gravity", [None, Gravity(120.0)], ids=["weightless", "heavy"])
@pytest.mark.parametrize("curve", [arch(), wave()], ids=["arch", "wave"])
@pytest.mark.parametrize("name", ["hardening", "softening", "yielding", "measured"])
def test_rod_bends_back_into_the_curve(name, curve, gravity):
    rod = optimal_rod(curve, gravity, law=LAWS[name])
    bent = bend(rod)
    assert np.hypot(*(bent.position - rod.position).T).max() < 1e-5 * curve.length
    assert bent.moment == pytest.approx(
        rod.stiffness * LAWS[name].effective_curvature(bent.curvature), rel=1e-9, abs=1e-12
    )
    # between the nodes too: the profile that strips are cut from
    assert rod.profile(rod.s) == pytest.approx(rod.stiffness, abs=2e-6 * rod.stiffness.max())


def test_ideal_plasticity_is_a_strip_with_a_lasting_bend():
    """M = K kappa_eff is Hooke's law about the curvature that stays: bent linearly, it rests in the curve."""
    law = LAWS["ideally plastic"]
    rod = optimal_rod(arch(), Gravity(120.0), law=law)
    assert np.abs(rod.curvature).max() > law.curvature_limit
    hooke = replace(rod, law=None, natural_curvature=law.permanent_curvature(rod.curvature))
    bent = bend(hooke)
    assert np.hypot(*(bent.position - rod.position).T).max() < 2e-5 * arch().length


def test_plasticity_beyond_the_curve_changes_nothing():
    rod = optimal_rod(wave(), law=PlasticLaw(0.05))
    assert rod.stiffness == pytest.approx(optimal_rod(wave()).stiffness, rel=1e-9)


def test_pinned_ends_keep_their_limit():
    """M and kappa vanish together there; a law of slope 1 at rest has the limit <b, gamma'> / kappa'."""
    points = [(0, 0), (20, 15), (40, 30), (80, 45), (120, 30), (140, 15), (160, 0)]
    curve = PlaneCurve.spline(points, degree=4)
    rod = optimal_rod(curve, supports=Supports("pinned", "pinned"), law=LAWS["hardening"])
    b = np.array([rod.force[0, 1], -rod.force[0, 0]])
    tangent = np.array([np.cos(rod.angle[0]), np.sin(rod.angle[0])])
    slope = float(curve.curvature_slope_at(np.array(curve.domain[0])))
    assert rod.stiffness[0] == pytest.approx(b @ tangent / slope, rel=1e-9)
    bent = bend(rod)
    assert np.hypot(*(bent.position - rod.position).T).max() < 1e-5 * curve.length


def test_natural_curvature_is_taken_off_first():
    law, kappa_0 = LAWS["hardening"], 0.004
    rod = optimal_rod(arch(), natural_curvature=kappa_0, law=law)
    assert rod.moment == pytest.approx(rod.stiffness * law.effective_curvature(rod.curvature - kappa_0))


test_laws_that_are_not_injective_are_refused = refusal_test(
    [
        (
            lambda: optimal_rod(arch(), law=PolynomialLaw(-0.6, curvature_scale=0.03)),
            r"of the material law increases only up to .* 0\.02778 1/mm",
        ),
        (
            lambda: optimal_rod(arch(), law=TabulatedLaw([0.01, 0.02], [1.0, 1.9])),
            "ends at a curvature of",
        ),
    ]
)
