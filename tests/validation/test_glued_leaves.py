"""Stacks of glued leaves: known ends are found again, shapes hold against shooting, and no small move is better."""

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import root

from elastica_cad.errors import InputError
from elastica_cad.forming.leaf_ends import NODES, LeafedRod, _Search, lay_leaves, nearest_leaves
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads.gravity import Gravity
from elastica_cad.mechanics.loads.supports import Supports
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.material.tapered_sections import LeavesLaw
from elastica_cad.mechanics.stability.stability_verdict import stability
from elastica_cad.mechanics.stiffness.optimal_rod import optimal_rod

pytestmark = pytest.mark.core

LEAF = Sheet("ash leaf", 0.6, 12000.0, density=680.0, max_strain=0.02)
SOFT = Sheet("soft leaf", 0.6, 900.0, density=1150.0, max_strain=0.05)
ARCH = PlaneCurve.spline([(0, 0), (60, 150), (150, 190), (240, 150), (300, 0)], degree=4)
LEANING = PlaneCurve.spline([(0, 0), (10, 150), (120, 220), (240, 120), (300, 0)], degree=4)
WAVE = PlaneCurve.spline([(0, 0), (120, 180), (270, 210), (420, -30), (570, 30), (690, 180)], degree=4)

CASES = {
    "even arch": (ARCH, LeavesLaw(LEAF, 4, 20.0), None, 5e-3),
    "leaning arch": (LEANING, LeavesLaw(LEAF, 8, 20.0), None, 1e-3),
    "heavy arch": (LEANING, LeavesLaw(SOFT, 4, 20.0), Gravity(1.0), 5e-3),
    "wave": (WAVE, LeavesLaw(LEAF, 3, 20.0), None, 2e-3),
}
FOUND: dict[str, LeafedRod] = {}


def found(name):
    if name not in FOUND:
        curve, law, gravity, _ = CASES[name]
        FOUND[name] = nearest_leaves(curve, law, gravity=gravity)
    return FOUND[name]


def shot(stack):
    """The shape at the nodes by shooting through the leaves, from sizes alone: E I = E w (k h)^3 / 12."""
    rod, law, length = stack.rod, stack.law, stack.rod.length
    cuts = sorted({0.0, length, *(s for leaf in stack.leaves for s in (leaf.start, leaf.end))})
    sheet = law.sheet
    down = (0.0, 0.0) if rod.gravity is None else rod.gravity.direction

    def path(x):
        y, shapes = np.array([*rod.position[0], rod.angle[0], *x * scale]), []
        for a, b in pairwise(cuts):
            k = sum(leaf.start <= (a + b) / 2 < leaf.end for leaf in stack.leaves)
            EI = sheet.youngs_modulus * law.width * (k * sheet.thickness) ** 3 / 12
            w = sheet.density * 9.80665e-9 * law.width * k * sheet.thickness

            def slopes(_, y, EI=EI, w=w):
                c, sn = np.cos(y[2]), np.sin(y[2])
                return [c, sn, y[3] / EI, y[4] * sn - y[5] * c, -w * down[0], -w * down[1]]

            ask = rod.s[(rod.s >= a) & (rod.s < b)]
            part = solve_ivp(slopes, (a, b), y, "DOP853", np.append(ask, b), rtol=1e-10, atol=1e-12)
            shapes.append(part.y[:, :-1])
            y = part.y[:, -1]
        return np.column_stack([*shapes, y])

    B = rod.bending_stiffness
    force = np.hypot(*rod.force[0]) * B
    scale = np.array([force * length, force, force])
    begun = np.array([rod.moment[0] * B, *(-rod.force[0] * B)]) / scale
    ends = np.array([*rod.position[-1] / length, rod.angle[-1]])
    answer = root(lambda x: path(x)[:3, -1] / [length, length, 1.0] - ends, begun, tol=1e-11)
    assert answer.success, answer.message
    return path(answer.x)[:2].T


@pytest.mark.parametrize("name", CASES)
def test_the_stack_rests_near_the_curve(name):
    stack, (curve, _, gravity, near) = found(name), CASES[name]
    length = stack.rod.length
    assert stack.settled
    assert stack.deviation < near * length
    assert np.hypot(*(stack.rod.position - curve.sample(NODES).position).T).max() == pytest.approx(
        stack.deviation
    )
    assert np.hypot(*(shot(stack) - stack.rod.position).T).max() < 2e-5 * length
    assert stability(stack.rod).stable
    assert (gravity is None) == (stack.rod.weight is None)


@pytest.mark.parametrize("name", CASES)
def test_leaves_are_whole_and_lie_on_each_other(name):
    stack, (_, law, _, _) = found(name), CASES[name]
    first, *_ = stack.leaves
    assert (first.number, first.start, first.end) == (1, 0.0, stack.rod.length)
    for leaf in stack.leaves:
        assert 0 <= leaf.start < leaf.end <= stack.rod.length
        below = [one for one in stack.leaves if one.number == leaf.number - 1]
        assert leaf.number == 1 or any(one.start <= leaf.start and leaf.end <= one.end for one in below)
    counts = stack.counts(stack.rod.s)
    assert 1 <= counts.min() <= counts.max() <= law.leaves
    inside = (
        np.abs(stack.rod.s[:, None] - [s for one in stack.leaves for s in (one.start, one.end)]).min(axis=1)
        > 2
    )
    (strain,) = law.strains(stack.rod.curvature[inside], counts[inside])
    assert stack.strain.largest == pytest.approx(strain.largest, rel=0.03)


@pytest.mark.parametrize("name", ["even arch", "leaning arch"])
def test_no_small_move_of_an_end_comes_nearer(name):
    """The claim of a local optimum, end by end."""
    stack, (curve, law, *_) = found(name), CASES[name]
    rounds = [_Search.of(stack.relaxed, law, curve.sample(NODES).position, r) for r in (0.35, 0.5, 0.65)]
    ends = sorted(s for leaf in stack.leaves for s in (leaf.start, leaf.end) if 0 < s < stack.rod.length)
    (search,) = [
        one for one in rounds if one.answer().mean_deviation == pytest.approx(stack.mean_deviation, rel=1e-6)
    ][:1]
    x = np.concatenate([np.array(ends) / stack.rod.length, stack.rod.angle[[0, -1]]])

    def distance(x):
        rod = search._bent(x, stack.rod)
        return np.sqrt(np.mean((rod.position - search.drawn) ** 2) * 2)

    best = distance(x)
    assert best == pytest.approx(stack.mean_deviation, rel=1e-3)
    for i in range(x.size):
        for step in (-2e-3, 2e-3):
            assert distance(x + step * np.eye(x.size)[i]) > best * (1 - 1e-4)


def test_known_ends_are_found_again():
    """A stack of three, bent; then only its shape is told."""
    law = LeavesLaw(LEAF, 3, 20.0)
    relaxed = optimal_rod(LEANING, section=law.relaxed)
    search = _Search(
        relaxed, law, LEANING.sample(NODES).position, np.array([[3, -1], [2, -1]]), np.zeros(2), (1, 2, 3)
    )
    told = np.array([0.31, 0.68])
    rod = search._bent(np.concatenate([told, relaxed.angle[[0, -1]]]), relaxed)
    begun = _Search(relaxed, law, rod.position, search.steps, np.array([0.4, 0.6]), search.first)
    stack = begun.answer()
    assert stack.deviation < 1e-4 * rod.length
    ends = sorted(leaf.end for leaf in stack.leaves if leaf.end < rod.length)
    assert np.array(ends) / rod.length == pytest.approx(told, abs=2e-3)


def test_hinges_turn_freely():
    """Between hinges no angle is held, so no moment is left at the ends."""
    curve = PlaneCurve.spline([(0, 0), (50, 60), (100, 120), (200, 120), (250, 60), (300, 0)], degree=5)
    supports = Supports("pinned", "pinned")
    law = LeavesLaw(LEAF, 3, 20.0)
    stack = lay_leaves(optimal_rod(curve, supports=supports, section=law.relaxed), law)
    assert np.abs(stack.rod.moment[[0, -1]]).max() < 1e-9 * np.abs(stack.rod.moment).max()


@pytest.mark.parametrize(
    ("made", "words"),
    [
        (lambda: LeavesLaw(LEAF, 1, 20.0), "a whole number from 2 to 50"),
        (lambda: LeavesLaw(LEAF, 2.5, 20.0), "a whole number from 2 to 50"),
        (lambda: LeavesLaw(LEAF, 3, -1.0), "width is -1: it must be positive"),
        (lambda: LeavesLaw("ash", 3, 20.0), "a Sheet is needed for the leaves"),
        (lambda: nearest_leaves(ARCH, 4), "give a LeavesLaw"),
    ],
)
def test_what_is_no_stack_is_refused_in_a_sentence(made, words):
    with pytest.raises(InputError, match=words):
        made()
