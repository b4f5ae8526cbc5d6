"""Leaving the plane: lateral buckling in closed form, shooting in space, finite elements of sixteen strips."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from scipy.special import ellipeinc, ellipj, ellipk

from elastica_cad.mechanics.bending.bend_forward import bend
from elastica_cad.mechanics.loads.supports import End, Supports
from elastica_cad.mechanics.rod.rod_record import Rod
from elastica_cad.mechanics.stability.sideways import sideways_margin, sideways_stability

pytestmark = pytest.mark.core

LENGTH = 300.0
NODES = 601
A, C = 900.0, 1.4  # edgewise bending and torsion over bending in the plane
MEASURED = json.loads((Path(__file__).parents[1] / "campaign/finite_elements/measured.json").read_text())


def margin(rod, edgewise=A, torsion=C, nodes=201):
    return sideways_margin(rod, np.full(nodes, edgewise), np.full(nodes, torsion))


def loaded(moment, force, *, free=False):
    """A strip that its load holds straight, with given moments (a share of the length -> 1/mm) and forces."""
    ends = Supports(end=End(x=False, y=False, angle=False)) if free else Supports()
    rod = Rod.straight(1.0, samples=NODES, supports=ends)
    s = rod.s
    return replace(rod, moment=moment(s), force=np.column_stack([force(s)[0] + 0 * s, force(s)[1] + 0 * s]))


LATERAL = {
    "Prandtl 1899: pure bending, held at both ends against turning sideways and twist": (
        2 * np.pi, lambda M: loaded(lambda s: M + 0 * s, lambda s: (0.0, 0.0)),
    ),
    "Michell 1899: a cantilever with a load at its tip": (
        4.01260, lambda P: loaded(lambda s: P * (1 - s), lambda s: (0.0, -P), free=True),
    ),
    "Prandtl 1899: a cantilever under its own weight": (
        12.8527,
        lambda q: loaded(lambda s: q * (1 - s) ** 2 / 2, lambda s: (0.0, -q * (1 - s)), free=True),
    ),
}  # fmt: skip
"""Critical loads over the root of edgewise bending times torsion, and the strip under such a load."""


def critical_load(case):
    """Where the sideways margin is lost, in the same measure."""
    critical, rod = LATERAL[case]
    root = np.sqrt(A * C)
    return brentq(lambda load: margin(rod(load)), critical * root * 0.5, critical * root * 1.4) / root


@pytest.mark.parametrize("case", LATERAL)
def test_lateral_buckling_in_closed_form(case):
    assert critical_load(case) == pytest.approx(LATERAL[case][0], rel=1e-3)


def test_a_column_and_a_shaft():
    """Twist alone: pi^2 GJ between clamps; Euler's column, edgewise: 4 pi^2 EI2."""
    assert abs(margin(Rod.straight(70.0)) - np.pi**2 * C) < 1e-3
    column = brentq(lambda P: margin(loaded(lambda s: 0 * s, lambda s: (P, 0.0)), 2.0, 50.0), 1.0, 200.0)
    assert abs(column - 8 * np.pi**2) < 0.02


def pushed_together(k):
    """A uniform strip clamped in line, its ends pushed together: four quarters of the elastica of modulus k."""
    u = np.linspace(0, 4 * ellipk(k**2), NODES)
    _, cn, _, amplitude = ellipj(u, k**2)
    points = LENGTH / u[-1] * np.column_stack([2 * ellipeinc(amplitude, k**2) - u, -2 * k * cn])
    angle = 2 * np.arcsin(k * ellipj(u, k**2)[0])
    straight = Rod.straight(LENGTH, samples=NODES)
    rod = bend(straight, start=points[0], end=points[-1], angles=(0.0, 0.0), guess=angle)
    assert np.abs(rod.position - points).max() < 0.01
    return rod


def turned_away(rod, edgewise, torsion):
    """How far the end strays sideways for what the start may add: a determinant, zero where the rod buckles.

    Kirchhoff's equations in space, integrated as an initial value problem.
    """
    stiffness = np.array([torsion, edgewise, 1.0])

    def end(extra):
        angle = rod.angle[0]
        frame = np.array([[np.cos(angle), np.sin(angle), 0], [-np.sin(angle), np.cos(angle), 0], [0, 0, 1.0]])
        pull = np.array([*-rod.force[0], extra[2]])
        first = np.concatenate([np.zeros(3), frame.ravel(), [extra[0], extra[1], rod.moment[0]]])

        def slope(_, y):
            d, m = y[3:12].reshape(3, 3), y[12:]
            turning = (d @ m / stiffness) @ d
            return np.concatenate([d[0], np.cross(turning, d).ravel(), -np.cross(d[0], pull)])

        return solve_ivp(slope, (0, rod.length), first, rtol=1e-10, atol=1e-12, method="DOP853").y[:, -1]

    columns = []
    for k, step in enumerate((1e-6, 1e-6, 1e-8)):
        extra = np.zeros(3)
        extra[k] = step
        apart = (end(extra) - end(-extra)) / (2 * step)
        columns.append([apart[2], apart[5], apart[8]])  # z, and the heights of tangent and normal
    return float(np.linalg.det(np.array(columns)))


def test_a_rod_in_space_buckles_where_the_margin_vanishes():
    width = 5.0
    edgewise, torsion = (width / 0.8) ** 2, 2 / 1.3 * (1 - 0.63 * 0.8 / width)
    by_margin = brentq(lambda k: margin(pushed_together(k), edgewise, torsion), 0.83, 0.89, xtol=1e-5)
    by_shooting = brentq(lambda k: turned_away(pushed_together(k), edgewise, torsion), 0.83, 0.89, xtol=1e-4)
    assert abs(by_margin - by_shooting) < 2e-3


def arc(degrees):
    turn = np.radians(degrees)
    angle = np.linspace(0, turn, NODES)
    points = LENGTH / turn * np.column_stack([np.sin(angle), 1 - np.cos(angle)])
    straight = Rod.straight(LENGTH, samples=NODES)
    return bend(straight, start=points[0], end=points[-1], angles=(0.0, turn), guess=angle)


def test_the_sign_is_that_of_finite_elements():
    """Of sixteen strips in CalculiX: where the rod decides, the lowest eigenvalue out of the plane has its sign."""
    decided = 0
    for case in MEASURED["sideways"]:
        name, width = case["name"], case["width"]
        rod = (
            arc(float(name.split()[2]))
            if name.startswith("arc")
            else pushed_together(float(name.split("=")[1]))
        )
        found = sideways_stability(rod, width, 0.8, poisson_ratio=0.3)
        if found.decided:
            decided += 1
            assert (found.margin > 0) == (case["sideways"] > 0), name
    assert decided >= 13


def test_the_word_follows_the_margin_and_wide_strips_are_left_undecided():
    rod = pushed_together(0.9)
    assert sideways_stability(rod, 5.0, 0.8).word == "unstable"
    assert sideways_stability(rod, 80.0, 0.8).word == "undecided"
    assert sideways_stability(pushed_together(0.4), 5.0, 0.8).word == "ample"
