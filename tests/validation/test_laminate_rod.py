"""A laminate under its own weight: the fixed point of stiffness, scale and weight, bent forward again."""

import numpy as np
import pytest

from elastica_cad import (
    NotConvergedError,
    PlaneCurve,
    PointMass,
    Profile,
    Sheet,
    bend,
    optimal_rod,
)
from elastica_cad.mechanics import LaminatedSection, optimal_laminate
from tests.refusals import refusal_test

pytestmark = pytest.mark.core

BASE = Sheet("card", 0.2, 2300.0, density=900.0, max_strain=0.005)
SECTION = LaminatedSection(BASE, Sheet("other card", 0.22, 2000.0, density=800.0, max_strain=0.005))


def arch():
    return PlaneCurve.ellipse((0, 0), (100, 70), start=0.0, end=np.pi)


def wave():
    """One inflection in the middle."""
    return PlaneCurve.spline([(0, 0), (40, 60), (90, 70), (140, -10), (190, 10), (230, 60)], degree=4)


@pytest.mark.parametrize("curve", [arch(), wave()], ids=["arch", "wave"])
def test_the_laminate_rests_in_the_curve_under_the_weight_of_its_layers(curve):
    width = Profile.interpolate([0.0, curve.length / 2, curve.length], [20.0, 22.0, 21.0])
    laminate = optimal_laminate(curve, SECTION, width, direction=(0, -1))
    rod = laminate.rod
    EI = laminate.section.bending_stiffness(laminate.backing_width)
    assert rod.bending_stiffness * rod.stiffness == pytest.approx(EI, rel=1e-7)
    newtons = rod.node_lengths * laminate.section.weight_per_length(laminate.backing_width)
    assert -rod.nodal_load[:, 1] * rod.bending_stiffness == pytest.approx(newtons, rel=2e-4)
    assert laminate.backing_width.max() <= 22.0
    assert np.max(laminate.backing_width / laminate.base_width) == pytest.approx(1.0, abs=1e-4)
    bent = bend(rod)
    assert np.hypot(*(bent.position - rod.position).T).max() < 1e-5 * curve.length


def test_weight_matters_and_so_does_the_true_law():
    """Taking the weight as ~ K, as for a plain strip, would leave the curve."""
    weightless = optimal_laminate(arch(), SECTION, 20.0)
    heavy = optimal_laminate(arch(), SECTION, 20.0, direction=(0, -1))
    assert weightless.rounds == 1 < heavy.rounds
    assert weightless.rod.stiffness == pytest.approx(optimal_rod(arch()).stiffness)
    assert np.abs(heavy.rod.stiffness / weightless.rod.stiffness - 1).max() > 0.02


@pytest.mark.parametrize("size", [1270.0, 1280.0, 1290.0])
def test_a_search_that_requests_more_than_two_layers_on_its_way_comes_to_a_laminate(size):
    """A heavy arch of soft card: the scale is extrapolated past what two full layers have, and comes back."""
    points = size * np.array([(0, 0), (0.1, 0.35), (0.5, 0.5), (0.9, 0.3), (1, 0)])
    thin, thick = (Sheet("soft", h, 1000.0, density=700.0, max_strain=0.02) for h in (0.5, 1.0))
    laminate = optimal_laminate(
        PlaneCurve.spline(points, degree=4), LaminatedSection(thin, thick), 20.0, direction=(0, -1)
    )
    assert laminate.backing_width.max() == pytest.approx(20.0, rel=1e-4)
    rod, A1, A2 = laminate.rod, 500.0 * laminate.base_width, 1000.0 * laminate.backing_width
    EI = (A1 * 0.25 + A2) / 12 + 0.75**2 * A1 * A2 / (A1 + A2)
    assert rod.bending_stiffness * rod.stiffness == pytest.approx(EI, rel=1e-6)
    newtons = 700 * 9.80665e-9 * rod.node_lengths * (0.5 * laminate.base_width + laminate.backing_width)
    assert -rod.nodal_load[:, 1] * rod.bending_stiffness == pytest.approx(newtons, rel=5e-4)
    bent = bend(rod)
    assert np.hypot(*(bent.position - rod.position).T).max() < 1e-4 * rod.length


@pytest.mark.parametrize(
    ("points", "base", "backing", "ratio"),
    [
        ([(0, 0), (140, -84), (280, -95.2), (420, -112), (560, 0)], (0.25, 890, 950), (0.48, 1020, 910), 2.6651),
        ([(0, 0), (187.5, -300), (375, -442.5), (562.5, -247.5), (750, 0)], (0.23, 3270, 1250), (0.68, 3350, 1440),
         7.8602),
        ([(0, 0), (399.3, -266.2), (810.7, -302.5), (1210, 0)], (0.5, 2060, 760), (0.46, 1840, 430), 2.4277),
    ],
)  # fmt: skip
def test_a_heavy_laminate_whose_programs_go_to_and_fro_is_found(points, base, backing, ratio):
    """Hung curves whose own weight bends them: they had been refused as too heavy.

    The ratios are those of a march of our own: moment and force integrated along the curve, the weight from
    M / kappa, and the three numbers at the start moved until the softest place is as stiff as can be.
    """
    sheets = [
        Sheet(name, h, E, density=rho, max_strain=0.02)
        for name, (h, E, rho) in zip(("base", "backing"), (base, backing), strict=True)
    ]
    curve = PlaneCurve.spline(points, degree=min(4, len(points) - 1))
    laminate = optimal_laminate(curve, LaminatedSection(*sheets), 20.0, direction=(0, -1))
    rod, (h1, h2), d = laminate.rod, (base[0], backing[0]), (base[0] + backing[0]) / 2
    assert rod.ratio == pytest.approx(ratio, rel=1.5e-3)
    assert laminate.backing_width.max() == pytest.approx(20.0, rel=1e-4)
    A1, A2 = base[1] * h1 * laminate.base_width, backing[1] * h2 * laminate.backing_width
    EI = (A1 * h1**2 + A2 * h2**2) / 12 + d**2 * A1 * A2 / (A1 + A2)
    assert rod.bending_stiffness * rod.stiffness == pytest.approx(EI, rel=1e-6)
    areal = base[2] * h1 * laminate.base_width + backing[2] * h2 * laminate.backing_width
    newtons = 9.80665e-9 * rod.node_lengths * areal
    assert -rod.nodal_load[:, 1] * rod.bending_stiffness == pytest.approx(newtons, rel=1e-5)
    bent = bend(rod)
    assert np.hypot(*(bent.position - rod.position).T).max() < 1e-5 * rod.length


def test_a_base_of_varying_width_that_does_not_settle_is_found_with_one_width():
    """A base of 19.6 to 20.4 mm: what the sentence says to do gives a strip that rests in the curve."""
    points = [(0, 0), (140, -84), (280, -95.2), (420, -112), (560, 0)]
    curve = PlaneCurve.spline(points, degree=4)
    base, backing = (
        Sheet(name, h, E, density=rho, max_strain=0.02)
        for name, h, E, rho in (("base", 0.25, 890, 950), ("backing", 0.48, 1020, 910))
    )
    section = LaminatedSection(base, backing)
    varying = Profile.interpolate([0.0, curve.length / 2, curve.length], [19.6, 20.4, 19.6])
    with pytest.raises(NotConvergedError, match=r"did not converge .*: give the base a constant width, for"):
        optimal_laminate(curve, section, varying, direction=(0, -1))
    laminate = optimal_laminate(curve, section, 20.0, direction=(0, -1))
    assert laminate.base_width == pytest.approx(20.0)
    bent = bend(laminate.rod)
    assert np.hypot(*(bent.position - laminate.rod.position).T).max() < 1e-5 * curve.length


def test_a_hung_mass_is_carried():
    mass = (PointMass(60.0, 3.0),)
    laminate = optimal_laminate(arch(), SECTION, 20.0, direction=(0, -1), masses=mass)
    assert laminate.rod.weight.masses == mass
    bent = bend(laminate.rod)
    assert np.hypot(*(bent.position - laminate.rod.position).T).max() < 2e-5 * arch().length


test_bad_laminates = refusal_test(
    [
        (
            lambda: optimal_laminate(
                arch(),
                LaminatedSection(BASE, Sheet("foil", 0.01, 2000.0, density=800.0, max_strain=0.005)),
                Profile.interpolate([0.0, arch().length], [10.0, 30.0]),
            ),
            r"backing \d.* times as thick as the base, or thicker \(now 0\.05 times\)",
        ),
        (
            lambda: optimal_laminate(arch(), SECTION, Profile.interpolate([0.0, 50.0], [10.0, 30.0])),
            "base width is given over 50 mm",
        ),
        (lambda: optimal_laminate(arch(), SECTION, 0.0), "base width is 0"),
    ]
)
