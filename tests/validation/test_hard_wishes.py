"""Eighty wishes with more wiggles than a rod can follow: the answer is the best one known, within 2 %.

The best known distances are those of an interior point solver (IPOPT through CasADi, from 6 starts each, the rod's
recursion as constraints) and of 40 random starts of our own, whichever is less; the first never was by over 0.5 %.
"""

import json
from pathlib import Path

import numpy as np
import pytest

from elastica_cad import Gravity, Keep, Limits, PlaneCurve, Status, nearest_rod, optimal_rod

pytestmark = pytest.mark.core

BEST = json.loads((Path(__file__).parents[1] / "data/hard_wishes/distances.json").read_text())
EXACT = 1e-5  # lengths: what is nearer follows the wish, and its own distance is rounding


def requests(count):
    """Splines through random points, a quarter of them around a circle; every fifth with weight."""
    rng, found = np.random.default_rng(7), []
    while len(found) < count:
        k = int(rng.integers(6, 12))
        x = np.linspace(0, 1, k)
        points = np.column_stack([x + rng.normal(size=k) * 0.08, rng.normal(size=k) * rng.uniform(0.2, 0.6)])
        if len(found) % 4 == 3:
            turn = np.linspace(0, rng.uniform(2.5, 5.5), k)
            r = 1 + rng.normal(size=k) * 0.22
            points = np.column_stack([r * np.cos(turn), r * np.sin(turn)])
        curve = PlaneCurve.spline(200 * points, degree=4)
        if curve.tangent_breaks or np.abs(curve.sample(400).curvature).max() * curve.length > 150:
            continue
        ratio = float(rng.choice([1.5, 2.0, 2.5, 3.5]))
        heavy = len(found) % 5 == 2
        gravity = Gravity(curve.length / rng.uniform(4, 12) ** (1 / 3)) if heavy else None
        found.append((curve, Limits(ratio=ratio), gravity))
    return found


def test_every_answer_is_within_two_percent_of_the_best_known():
    far = 0
    for (curve, limits, gravity), best in zip(requests(len(BEST)), BEST, strict=True):
        near = nearest_rod(curve, limits, gravity=gravity, measure="mean")
        far += near.status is Status.FAR
        assert near.met
        assert near.mean_deviation / curve.length < max(1.02 * best, best + EXACT)
    assert far >= 25


def test_a_wish_that_can_be_met_is_met_with_the_least_ratio():
    """A distance does not see the ratio: such wishes came back at any ratio below the limit."""
    arch = PlaneCurve.ellipse((0, 0), (200, 100), start=0.2, end=2.8)
    near = nearest_rod(arch, Limits(ratio=4.0))
    assert near.deviation < 1e-5 * arch.length
    assert near.rod.ratio <= optimal_rod(arch).ratio * 1.006


def test_rods_that_are_as_near_are_named():
    """A straight wish whose rod must be longer: it goes to one side or to the other."""
    wish = PlaneCurve.line((0, 0), (100, 0))
    limits = Limits(ratio=2.0, length=(120, 130), margin=2.0)
    near = nearest_rod(wish, limits, Keep(tangents=True))
    assert near.met
    assert near.ties
    mirrored = [1, -1] * near.rod.position
    assert min(np.abs(other.position - mirrored).max() for other in near.ties) < 3.0
    assert "as near to the drawn curve" in near.advice[0]
