"""Moment-curvature laws: oddness, slope, inverse, injectivity, plasticity."""

import pickle
from dataclasses import dataclass

import numpy as np
import pytest

from elastica_cad import Gravity, InputError, PlaneCurve, Sheet, StripSpec, bend, optimal_rod
from elastica_cad.mechanics import ElasticPlasticLaw, MaterialLaw, PlasticLaw, PolynomialLaw, TabulatedLaw
from tests.refusals import refusal_test

pytestmark = pytest.mark.core

TABLE = np.linspace(0.005, 0.06, 12)
LAWS = [
    PolynomialLaw(0.4, curvature_scale=0.03),
    PolynomialLaw(-0.1, 0.01, curvature_scale=0.03),
    PlasticLaw(0.04),
    ElasticPlasticLaw(0.02),
    TabulatedLaw(TABLE, 3.0 * np.tanh(20 * TABLE)),
]


@pytest.mark.parametrize("law", LAWS, ids=lambda law: type(law).__name__)
def test_law_is_odd_has_slope_one_at_rest_and_its_own_derivative(law):
    kappa = np.array([0.003, 0.012, 0.031, 0.049])
    assert law.effective_curvature(-kappa) == pytest.approx(-law.effective_curvature(kappa), abs=1e-15)
    assert law.slope(0.0) == pytest.approx(1.0)
    step = 1e-7
    slope = (law.effective_curvature(kappa + step) - law.effective_curvature(kappa - step)) / (2 * step)
    assert law.slope(kappa) == pytest.approx(slope, abs=1e-5)
    assert (law.energy(kappa + step) - law.energy(kappa - step)) / (2 * step) == pytest.approx(
        law.effective_curvature(kappa), abs=1e-8
    )
    assert law.energy(0.0) == 0.0
    assert law.energy(-kappa) == pytest.approx(law.energy(kappa))
    assert law.effective_curvature(1e-12) == pytest.approx(1e-12, rel=1e-9)
    assert pickle.loads(pickle.dumps(law)).effective_curvature(kappa) == pytest.approx(
        law.effective_curvature(kappa)
    )


@pytest.mark.parametrize("law", LAWS, ids=lambda law: type(law).__name__)
def test_inverse_returns_the_curvature(law):
    kappa = np.array([-0.038, -0.01, 0.0, 0.02, 0.038])
    found = law.curvature(law.effective_curvature(kappa))
    assert found == pytest.approx(kappa, abs=1e-13)


test_moment_beyond_reach_is_refused = refusal_test(
    [
        (lambda: PlasticLaw(0.03).curvature([0.01, 0.04]), r"reaches only 75 % of the largest moment"),
        (lambda: ElasticPlasticLaw(0.02).curvature(0.031), r"reaches only 96\.77 % of the largest moment"),
    ]
)


def test_the_coefficients_of_a_polynomial_law_are_for_a_curvature_of_1_by_default():
    law = PolynomialLaw(-0.2, 0.1)
    assert law.effective_curvature(1.0) == pytest.approx(1 - 0.2 + 0.1)
    assert law.slope(1.0) == pytest.approx(1 - 3 * 0.2 + 5 * 0.1)


def test_softening_law_is_injective_up_to_the_crest_of_its_moment():
    """m = kappa - 0.3 kappa^3 (unit curvature): m' = 0 at sqrt(1/0.9)."""
    law = PolynomialLaw(-0.3, curvature_scale=1.0)
    crest = np.sqrt(1 / 0.9)
    law.require_injective(crest * 0.9999)
    with pytest.raises(InputError, match=r"of the material law increases only up to a curvature of 1\.054"):
        law.require_injective(crest * 1.0001)
    PolynomialLaw(0.3).require_injective(1e6)
    PolynomialLaw(-0.3, 0.1).require_injective(1e6)


def test_ideal_plasticity_keeps_the_sign_and_leaves_the_excess():
    law = PlasticLaw(0.05)
    kappa = np.array([-0.2, -0.05, 0.01, 0.07])
    assert law.effective_curvature(kappa).tolist() == [-0.05, -0.05, 0.01, 0.05]
    assert law.permanent_curvature(kappa) == pytest.approx([-0.15, 0.0, 0.0, 0.02])
    with pytest.raises(InputError, match="radius 20 mm"):
        law.require_injective(0.06)


def test_card_yields_below_its_least_radius():
    card = Sheet.named("card-200gsm")
    assert PlasticLaw.of(card).curvature_limit == pytest.approx(2 * card.max_strain / card.thickness)
    assert ElasticPlasticLaw.of(card).curvature_limit == PlasticLaw.of(card).curvature_limit


def test_elastic_plastic_moment_is_the_integral_of_the_yielded_stress():
    """Stress min(|E kappa z|, yield) over a unit section: M / M_elastic-limit * kappa_lim."""
    limit, E, h = 0.02, 3.0, 1.5
    law = ElasticPlasticLaw(limit)
    z = (np.arange(200000) + 0.5) / 200000 * h / 2
    for kappa in (0.015, 0.03, 0.2):
        moment = 2 * np.mean(np.minimum(E * kappa * z, E * limit * h / 2) * z) * h / 2
        assert law.effective_curvature(kappa) == pytest.approx(moment / (E * h**3 / 12), rel=1e-6)
    assert law.effective_curvature(1e9) == pytest.approx(1.5 * limit)
    assert law.permanent_curvature(0.015) == 0.0
    law.require_injective(1e9)


def test_table_that_falls_is_refused_only_where_it_falls():
    law = TabulatedLaw([0.01, 0.02, 0.03], [1.0, 1.5, 1.4])
    law.require_injective(0.02)
    with pytest.raises(InputError, match=r"increases only up to a curvature of 0\.02"):
        law.require_injective(0.025)
    with pytest.raises(InputError, match=r"ends at a curvature of 0\.03"):
        law.require_injective(0.04)
    rising = TabulatedLaw([0.01, 0.02], [1.0, 1.5])
    beyond = rising.effective_curvature(0.03) - rising.effective_curvature(0.02)
    assert beyond == pytest.approx(0.01 * rising.slope(0.02))
    assert law.kinks == ((0.01, 1), (0.02, 1), (0.03, 1))


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: PolynomialLaw(np.nan), "quadratic coefficient"),
        (lambda: PolynomialLaw(1.0, curvature_scale=0.0), "curvature scale is 0.0: give a number above 0"),
        (lambda: PlasticLaw(0.0), "curvature limit is 0.0"),
        (lambda: ElasticPlasticLaw(-1.0), "curvature limit is -1.0"),
        (lambda: TabulatedLaw([0.1], [1.0]), "at least two positive"),
        (
            lambda: TabulatedLaw([0.1, 0.2], [1.0, -1.0]),
            "moments of the material law cannot be used: give at least two positive",
        ),
        (lambda: TabulatedLaw([0.1, 0.2, 0.3], [1.0, 2.0]), "3 curvatures and 2 moments"),
        (lambda: TabulatedLaw([0.2, 0.1], [1.0, 2.0]), "do not increase: 0.1 follows 0.2"),
    ],
)
def test_bad_laws_are_refused(make, message):
    with pytest.raises(InputError, match=message):
        make()


@dataclass(frozen=True)
class OwnLaw(MaterialLaw):
    """A law that no list knows: the moment approaches a largest value."""

    most: float
    injective_limit = np.inf

    def effective_curvature(self, curvature):
        return self.most * np.tanh(np.asarray(curvature) / self.most)

    def slope(self, curvature):
        return 1 / np.cosh(np.asarray(curvature) / self.most) ** 2

    def energy(self, curvature):
        return self.most**2 * np.log(np.cosh(np.asarray(curvature) / self.most))


@pytest.mark.parametrize("gravity", [None, Gravity(300.0)])
def test_a_strip_is_made_of_a_rod_with_a_law_of_ones_own(gravity):
    arch, law = PlaneCurve.ellipse((0, 0), (200, 100), start=0, end=np.pi), OwnLaw(0.02)
    rod = optimal_rod(arch, gravity, law=law)
    made = StripSpec(arch, "birch-plywood-0.8", max_width=40.0, smooth=0.0).make(rod)
    bent = made.rod.curvature
    assert made.rod.moment == pytest.approx(made.rod.stiffness * law.effective_curvature(bent), abs=1e-9)
    np.testing.assert_allclose(bend(made.rod).position, rod.position, atol=2e-3)
    assert made.rod.ratio < optimal_rod(arch, gravity).ratio
    spread = float(np.ptp(made.width(made.rod.s)) / made.width.extremes[1])
    assert spread == pytest.approx(1 - 1 / made.rod.ratio, rel=1e-3)
