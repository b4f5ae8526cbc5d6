"""The discrete rod converges with the square of its edge length: measured on five problems."""

import numpy as np
import pytest

from elastica_cad import Gravity, Rod, Supports, bend, stability

pytestmark = pytest.mark.core


def arch(n):
    return bend(Rod.straight(1.0, samples=n), end=(0.6, 0.0))


def tilted(n):
    return bend(Rod.straight(1.0, [1.0, 2.0, 1.5], samples=n), end=(0.6, 0.2), angles=(1.0, -0.4))


def hanging(n):
    rod = Rod.straight(1.0, samples=n, supports=Supports("pinned", "pinned"), gravity=Gravity(0.4))
    return bend(rod, end=(0.7, 0.1), side=-1)


def cantilever(n):
    return bend(Rod.straight(1.0, samples=n, supports=Supports("clamped", "free")), force=(0.0, -5.0))


def curled(n):
    rod = Rod.straight(1.0, samples=n, natural_curvature=1.5, supports=Supports("clamped", "slide-x"))
    return bend(rod, end=(0.0, 0.2), gravity=Gravity(0.7, (1.0, -1.0)))


@pytest.mark.parametrize("problem", [arch, tilted, hanging, cantilever, curled], ids=lambda f: f.__name__)
def test_second_order(problem):
    def answer(n):
        rod = problem(n)
        middle = rod.position[(n - 1) // 2]
        return np.array([*middle, rod.moment[(n - 1) // 2], *rod.force[0], stability(rod).margin])

    answers = [answer(n) for n in (41, 81, 161)]
    change = np.abs(answers[1] - answers[0]), np.abs(answers[2] - answers[1])
    felt = change[0] > 1e-9
    order = np.log2(change[0][felt] / change[1][felt])
    assert felt.sum() >= 4
    assert order == pytest.approx(np.full(order.size, 2.0), abs=0.15)
