"""Distances of rods from the drawn curve, against brute force."""

from itertools import pairwise

import numpy as np
import pytest

from elastica_cad import PlaneCurve
from elastica_cad.form_finding.curve_distance import SPANS, TargetCurve, measure_deviation

pytestmark = pytest.mark.core

DRAWN = PlaneCurve.spline([(0, 0), (40, 60), (70, -60), (110, 70), (150, -40), (190, 10)], degree=4)


def farthest(points, chain):
    """Largest distance of points from the chords of a chain, one chord after the other."""
    best = np.full(len(points), np.inf)
    for a, b in pairwise(chain):
        off = points - a
        off = off - np.clip(off @ (b - a) / ((b - a) @ (b - a)), 0, 1)[:, None] * (b - a)
        best = np.minimum(best, np.hypot(*off.T))
    return best.max()


@pytest.mark.parametrize("size", [1e-6, 1e-3, 0.03, 0.4])
@pytest.mark.parametrize("stretch", [1.0, 0.8])
def test_deviation_is_exact(size, stretch):
    """Either way, near or far, shifted along the curve or not."""
    wish = TargetCurve.of(DRAWN)
    s = np.linspace(0, 1, SPANS + 1)
    nodes = stretch * wish.position + size * np.column_stack([np.sin(7 * s), np.cos(4 * s)])
    exact = max(farthest(wish.position, nodes), farthest(nodes, wish.position))
    points = nodes * wish.size + wish.origin
    assert measure_deviation(wish, points) == pytest.approx(exact * wish.size, rel=1e-9)
