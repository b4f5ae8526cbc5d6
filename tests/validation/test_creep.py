"""Creep: both limits in time of a standard linear solid, marched through time by a solver of its own."""

import json
from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_bvp
from scipy.optimize import root

from elastica_cad import (
    Gravity,
    InputError,
    PlaneCurve,
    PointMass,
    Rod,
    Sheet,
    StripSpec,
    Supports,
    Weight,
    bend,
)
from elastica_cad.mechanics import PolynomialLaw, creep
from elastica_cad.mechanics.rod import CurlingLaw

pytestmark = pytest.mark.core

LENGTH, EDGES, PHI = 200.0, 60, 0.8
HEAVY = Gravity(110.0)
SHARES = np.full(EDGES + 1, 1.0 / EDGES)
SHARES[[0, -1]] /= 2
K = 1 + 0.5 * np.sin(np.linspace(0, 3, EDGES + 1)) ** 2
K /= K.min()


def aged(supports, end, times):
    """Edge angles of a strip under its weight after given times (relaxation times), from the elastic shape on.

    Each node is a spring of share 1 / (1 + phi) beside a spring and dashpot in series; implicit Euler, small steps
    first. What the dashpots hold is a natural curvature to the elastic strip. Unknowns: angles, force at the end.
    """
    slow = PHI / (1 + PHI)
    w, load = LENGTH * SHARES, LENGTH * SHARES * K / HEAVY.length**3
    edge = LENGTH / EDGES
    held = np.zeros(EDGES + 1)  # curvature that the dashpots have taken

    def bend_of(angles):
        kappa = np.zeros(EDGES + 1)
        kappa[:-1] = np.diff(angles, prepend=0.0) / w[:-1]
        kappa[-1] = -angles[-1] / w[-1] if supports == "clamped" else kappa[-1]
        return kappa

    def imbalance(unknown, taken):
        angles, pull = unknown[:EDGES], unknown[EDGES:]
        moment = K * (bend_of(angles) - slow * taken)
        if supports == "free":
            moment[-1] = 0.0
        down = np.cumsum(load[::-1])[::-1][1:]  # weight beyond each edge
        fx, fy = (pull[0], pull[1]) if pull.size else (0.0, 0.0)
        off = np.diff(moment) + edge * ((fy - down) * np.cos(angles) - fx * np.sin(angles))
        if not pull.size:
            return off * LENGTH
        reach = edge * np.array([np.cos(angles).sum(), np.sin(angles).sum()]) - end
        return np.concatenate([off * LENGTH, reach / LENGTH])

    found = []
    unknown = np.zeros(EDGES)
    if supports == "clamped":
        wave = 1.2 * np.sin(2 * np.pi * np.arange(0.5, EDGES) / EDGES)
        unknown = np.concatenate([wave, np.zeros(2)])
    unknown = root(imbalance, unknown, args=(held,), tol=1e-13).x
    now = 0.0
    for until in times:
        while now < until:
            step = max(0.25, 0.3 * now)
            for _ in range(2):  # the strain of this step's end
                kappa = bend_of(unknown[:EDGES])
                taken = (held + step * kappa) / (1 + step)
                unknown = root(imbalance, unknown, args=(taken,), tol=1e-13).x
            held, now = taken, now + step
        found.append(unknown[:EDGES])
    return found


def points(angles):
    return (
        LENGTH
        / EDGES
        * np.concatenate([np.zeros((1, 2)), np.column_stack([np.cos(angles), np.sin(angles)])]).cumsum(axis=0)
    )


@pytest.mark.parametrize("kind", ["free", "clamped"])
def test_both_limits_in_time(kind):
    end = np.array([150.0, 0.0])
    first, last = (points(a) for a in aged(kind, end, (0.0, 1e12)))
    straight = Rod.straight(LENGTH, K, gravity=HEAVY, supports=Supports(end=kind))
    if kind == "free":
        rod = bend(straight, guess=np.zeros(EDGES + 1))
    else:
        rod = bend(straight, end=end)
    found = creep(rod, PHI)
    assert np.abs(found.rod.position - first).max() < 1e-6 * LENGTH
    assert np.abs(found.later.position - last).max() < 1e-6 * LENGTH
    assert found.sag > 5e-4 * LENGTH
    assert found.exact


def test_without_weight_the_shape_stays_and_the_forces_fall():
    rod = bend(Rod.straight(LENGTH, K), end=(140.0, 0.0))
    found = creep(rod, 1.0)
    assert found.sag == 0
    assert np.allclose(found.end_forces, rod.force[[0, -1]] / 2)


def test_let_go_it_keeps_a_share_of_its_bend():
    """A quarter circle held for long: phi / (1 + phi) of its curvature at first, without any moment."""
    turn = np.linspace(0, np.pi / 2, 201)
    arc = 100 * np.column_stack([np.sin(turn), 1 - np.cos(turn)])
    rod = bend(
        Rod.straight(50 * np.pi, samples=201), start=arc[0], end=arc[-1], angles=(0, np.pi / 2), guess=turn
    )
    let_go = creep(rod, 0.8).released()
    assert np.allclose(let_go.curvature[1:-1], 0.8 / 1.8 / 100, rtol=1e-4)
    assert np.abs(let_go.moment).max() < 1e-9


def test_what_is_kept_is_a_share_of_the_bend_that_it_sagged_to():
    """Dashpots that have come to rest hold the bend of the shape then, not of the first one."""
    angles = aged("free", None, (1e12,))[0]
    reached = np.diff(angles) / (LENGTH / EDGES)
    cantilever = bend(
        Rod.straight(LENGTH, K, gravity=HEAVY, supports=Supports(end="free")), guess=np.zeros(EDGES + 1)
    )
    let_go = creep(cantilever, PHI).released()
    assert np.allclose(let_go.curvature[1:-1], PHI / (1 + PHI) * reached, atol=1e-6 * np.abs(reached).max())


def test_a_force_and_a_moment_on_a_free_end_go_on_pulling():
    free = Rod.straight(LENGTH, supports=Supports(end="free"), samples=1001)
    turned = creep(bend(free, moment=2e-3), PHI)
    assert np.allclose(turned.later.curvature, (1 + PHI) * 2e-3, rtol=1e-9)  # a circle, by its closed form
    assert np.allclose(turned.later.moment * turned.force_share, 2e-3, rtol=1e-9)
    force = -1e-5
    pulled = creep(bend(free, force=(0.0, force)), PHI)

    def slopes(s, y):
        return np.array([y[1], -(1 + PHI) * force * LENGTH**2 * np.cos(y[0])])

    found = solve_bvp(
        slopes, lambda a, b: np.array([a[0], b[1]]), np.linspace(0, 1, 51), np.zeros((2, 51)), tol=1e-9
    )
    assert pulled.later.angle[1:-1] == pytest.approx(found.sol(pulled.later.s / LENGTH)[0][1:-1], abs=1e-5)
    assert pulled.end_forces[1] == pytest.approx([0.0, -force], abs=1e-12)


def test_an_arch_that_falls_through_as_it_creeps_says_so():
    low = bend(Rod.straight(300.0, samples=201), end=(285.0, 0.0), side=1)
    found = creep(bend(low, gravity=Gravity(83.0)), 1.0)
    assert found.rod.position[:, 1].max() > 30
    assert found.later.position[:, 1].min() < -30
    assert found.stability.stable
    assert not found.stays
    assert "snaps into another shape under its load" in str(found)


@pytest.mark.parametrize(
    ("length", "factor", "warned"),
    [(88.0, 0.3, True), (95.0, 0.3, False), (80.5, 0.01, False)],
    ids=["after creep", "never", "before creep too"],
)
def test_an_arch_that_creeps_close_to_snapping_says_so(length, factor, warned):
    low = bend(Rod.straight(300.0, samples=201), end=(285.0, 0.0), side=1)
    found = creep(bend(low, gravity=Gravity(length)), factor)
    assert found.stays
    close = f"After creep the strip is close to snapping (stability margin {found.stability.margin:.3g}; at"
    assert (close in str(found)) is warned


ONES = np.ones(41)


@pytest.mark.parametrize(
    ("law", "exact"),
    [
        (None, True),
        (PolynomialLaw(-0.1, curvature_scale=0.05), False),
        (CurlingLaw(np.ones_like, ONES), True),
        (CurlingLaw(np.ones_like, ONES, below=PolynomialLaw(-0.1, curvature_scale=0.05)), False),
    ],
    ids=["linear", "softening", "curling", "curling and softening"],
)
def test_creep_is_exact_for_linear_sheets_only(law, exact):
    """A section that curls across changes with its bend, but its sheet is linear."""
    found = creep(replace(Rod.straight(100.0, samples=41), law=law), PHI)
    assert found.exact is exact
    words = "exact for a linear homogeneous sheet" if exact else "an approximation by the effective modulus"
    assert words in str(found)


def test_hung_masses_weigh_the_same_on_a_softer_strip():
    """Twice as soft is as if everything weighed twice as much."""
    load = Weight(alpha=2e-4, masses=(PointMass(90.0, 3.0),))
    heavy = Weight(alpha=4e-4, masses=(PointMass(90.0, 6.0),))
    rods = [Rod.straight(LENGTH, gravity=HEAVY, weight=one, bending_stiffness=2e3) for one in (load, heavy)]
    light, weighty = (bend(rod, end=(160.0, 0.0)) for rod in rods)
    assert np.abs(creep(light, 1.0).later.position - weighty.position).max() < 1e-7


def test_what_creep_reports_a_strip():
    arch = PlaneCurve.ellipse((0, 0), (300, 150), start=0, end=np.pi)
    sheet = Sheet("thin", 1.0, 9000.0, 700.0, max_strain=0.02)
    spec = StripSpec(arch, sheet, max_width=30.0, gravity=True, creep=PHI)
    strip = spec.make()
    assert strip.crept.sag > 0
    assert "sags" in str(strip.crept)
    assert "keeps 44 % of its bend" in str(strip.crept)
    tight = spec.changed(sheet=Sheet("tight", 1.0, 9000.0, 700.0, max_strain=0.008)).make()
    assert any("creep there is larger than computed" in warning for warning in tight.warnings)
    from elastica_cad.design import report_strip

    record = report_strip(strip, name="arch", files={})["creep"]
    assert record["basis"] == "exact"
    assert record["sag"] == pytest.approx(strip.crept.sag, rel=1e-9)
    assert json.dumps(record)


@pytest.mark.parametrize("wrong", [-0.1, np.nan, "much", True])
def test_a_factor_that_makes_no_sense(wrong):
    with pytest.raises(InputError, match="creep is"):
        creep(Rod.straight(10.0), wrong)


def test_a_strip_that_collapses_says_so():
    column = Rod.straight(300.0, angle=np.pi / 2, gravity=Gravity(160.0), supports=Supports(end="free"))
    found = creep(bend(column), 1.0)
    assert not found.stability.stable
    assert "snaps into another shape under its load" in str(found)
