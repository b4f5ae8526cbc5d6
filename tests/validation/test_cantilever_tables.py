"""Cantilevers under a tip load and under their own weight against published numbers."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import pytest

from elastica_cad import Gravity, Rod, Supports, bend, stability, stability_limit

pytestmark = pytest.mark.core

CANTILEVER = Supports("clamped", "free")


@dataclass(frozen=True)
class Tip:
    """Load and what the tip does: drop/L, shortening/L, angle (rad); `ratio` of tip width to root width."""

    load: float
    drop: float
    shortening: float
    angle: float
    ratio: float = 1.0


def tip_of(solve):
    """Drop, shortening and angle of the tip of a unit cantilever, extrapolated from two grids."""
    answers = []
    for samples in (401, 801):
        rod = solve(samples)
        answers.append((-rod.position[-1, 1], 1 - rod.position[-1, 0], -rod.angle[-1]))
        assert stability(rod).stable
    return (4 * np.array(answers[1]) - np.array(answers[0])) / 3


MATTIASSON = (
    Tip(0.5, 0.162144, 0.015919, 0.244534),
    Tip(2.0, 0.493457, 0.160642, 0.781750),
    Tip(10.0, 0.810609, 0.554996, 1.430286),
)
"""Mattiasson 1981, Int. J. Numer. Meth. Eng. 17, 145-153: cantilever under a vertical tip load."""


@pytest.fixture(params=MATTIASSON, ids=lambda tip: f"PL2/EI={tip.load:g}")
def mattiasson(request) -> Tip:
    return request.param


def under_tip_load(load):
    """Drop, shortening and angle of the tip."""
    return tip_of(lambda n: bend(Rod.straight(1.0, samples=n, supports=CANTILEVER), force=(0.0, -load)))


def test_dead_tip_load(mattiasson):
    found = under_tip_load(mattiasson.load)
    assert found == pytest.approx([mattiasson.drop, mattiasson.shortening, mattiasson.angle], abs=6e-7)


@pytest.fixture(
    params=[
        Tip(1.0, 0.123471, 0.008754, 0.165116),
        Tip(5.0, 0.495905, 0.153343, 0.697005),
        Tip(20.0, 0.829881, 0.554768, 1.339502),
        Tip(5.0, 0.387645, 0.091102, 0.542201, ratio=0.5),
    ],
    ids=lambda tip: f"q={tip.load:g},r={tip.ratio:g}",
)
def heavy(request) -> Tip:
    """q = w L^3 / EI at the root, width tapering as 1 + (r - 1) s; computed to integration tolerance."""
    return request.param


def test_own_weight(heavy):
    gravity = Gravity(heavy.load ** (-1 / 3))
    found = tip_of(
        lambda n: bend(Rod.straight(1.0, [1.0, heavy.ratio], samples=n, supports=CANTILEVER), gravity=gravity)
    )
    assert found == pytest.approx([heavy.drop, heavy.shortening, heavy.angle], abs=6e-7)


def test_tip_load_on_a_tapered_strip():
    """P L^2 / K0 = 1, width and stiffness to one half at the tip: .337280 .073235 .548740 (computed)."""
    found = tip_of(
        lambda n: bend(Rod.straight(1.0, [1.0, 0.5], samples=n, supports=CANTILEVER), force=(0.0, -2.0))
    )
    assert found == pytest.approx([0.337280, 0.073235, 0.548740], abs=6e-7)


def test_upright_column_under_its_own_weight():
    """q = 7.83734744: the first zero of J_{-1/3} (Greenhill 1881)."""
    critical = []
    for samples in (101, 201, 401):
        column = Rod.straight(
            1.0, samples=samples, angle=np.pi / 2, supports=CANTILEVER, gravity=Gravity(1.0)
        )
        limit = stability_limit(column, [8.0])
        assert limit.kind == "bifurcation"
        critical.append(limit.at["load"])
    first = [(4 * b - a) / 3 for a, b in pairwise(critical)]
    assert (16 * first[1] - first[0]) / 15 == pytest.approx(7.83734744, abs=3e-8)


def test_column_beyond_its_load_leans_to_the_chosen_side():
    column = Rod.straight(1.0, samples=201, angle=np.pi / 2, supports=CANTILEVER)
    upright = bend(column, gravity=Gravity(12.0 ** (-1 / 3)))
    assert not stability(upright).stable
    left, right = (bend(column, gravity=Gravity(12.0 ** (-1 / 3)), side=side) for side in (1, -1))
    assert stability(left).stable
    assert left.position[-1, 0] < -0.5
    assert left.position[-1] == pytest.approx(right.position[-1] * [-1, 1], abs=1e-9)
