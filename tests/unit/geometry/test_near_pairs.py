"""Pairs of near points are those that scipy's tree finds."""

import numpy as np
import pytest

from elastica_cad.geometry.plane_points import near_pairs

pytestmark = pytest.mark.core


@pytest.mark.parametrize(
    ("count", "others", "dimensions", "reach", "wide"),
    [
        (300, 200, 2, 0.05, 1),
        (300, 200, 2, 5.0, 1e3),
        (400, 400, 4, 0.4, 1),
        (99, 60, 2, 1e-9, 1e6),
        (0, 5, 2, 1.0, 1),
    ],
)
def test_near_pairs_are_those_of_a_tree(count, others, dimensions, reach, wide):
    from scipy.spatial import cKDTree

    random = np.random.default_rng(count)
    points, near = (random.normal(size=(n, dimensions)) for n in (count, others))
    points[:, 1] *= wide
    near[:, 1] *= wide
    points[:50] = near[: len(points[:50])]
    i, j = near_pairs(points, near, reach)
    found = cKDTree(near).query_ball_point(points, reach) if count else []
    expected = [(a, b) for a, row in enumerate(found) for b in sorted(row)]
    assert sorted(zip(i.tolist(), j.tolist(), strict=True)) == expected
