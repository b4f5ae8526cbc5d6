"""Wishes at the border of what rods can do: what can be met is met, and what cannot is refused soon."""

import numpy as np
import pytest

from elastica_cad import Keep, Limits, PlaneCurve, Status, nearest_rod

pytestmark = pytest.mark.core


def tough(seed, number):
    """A spline through random points with a margin that few rods have; length or curvature limited too."""
    rng = np.random.default_rng(seed)
    for i in range(number + 1):
        k = int(rng.integers(5, 9))
        across = np.linspace(0, 200, k) + rng.normal(size=k) * 8
        curve = PlaneCurve.spline(np.column_stack([across, rng.normal(size=k) * rng.uniform(5, 40)]))
        if i % 3 == 0:
            limits = Limits(ratio=rng.uniform(1.05, 2.5), margin=rng.uniform(30, 400))
            keep = Keep(tangents=bool(rng.integers(2)))
        elif i % 3 == 1:
            limits = Limits(ratio=rng.uniform(1.05, 2), margin=rng.uniform(10, 200))
            keep = Keep(tangents=True, length=True)
        else:
            most = np.abs(curve.sample(400).curvature).max()
            ratio, margin, share = rng.uniform(1.05, 3), rng.uniform(0, 60), rng.uniform(0.2, 0.9)
            limits = Limits(ratio=ratio, margin=margin, curvature=most * share)
            keep = Keep(tangents=True, length=True)
    return curve, limits, keep


@pytest.mark.parametrize(
    ("seed", "number", "distance"),
    [
        (3, 6, 14.5), (3, 19, 8.1), (77, 37, 6.0), (77, 75, 2.25),
        *(pytest.param(*one, marks=pytest.mark.campaign) for one in (
            (3, 14, 16.1), (3, 26, 6.1), (3, 55, 8.7), (3, 59, 13.6), (3, 75, 2.1), (3, 77, 22.2), (3, 83, 34.6))),
    ],
)  # fmt: skip
def test_a_wish_that_some_rod_meets_is_not_refused(seed, number, distance):
    """From the drawn curve none was found: a taut rod meets it, or one that nothing loads."""
    near = nearest_rod(*tough(seed, number))
    assert near.met
    assert near.mean_deviation < 1.2 * distance
    assert near.rod.residual < 1e-9


@pytest.mark.parametrize("number", [1, 5, 10, 34, 82])
def test_a_wish_that_no_rod_near_meets_is_refused_soon(number):
    near = nearest_rod(*tough(3, number))
    assert near.status is Status.NOT_MET
    assert near.iterations <= 240
