"""Stiffness at the nodes of a discrete rod, also where it goes in steps."""

from itertools import pairwise

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.paths.profile import Profile

GAUSS_POINTS, GAUSS_WEIGHTS = np.polynomial.legendre.leggauss(3)


def nodal_stiffness(profile: Profile, s: FloatArray) -> FloatArray:
    """K (n,) at uniform arc lengths (n,), mm; a cell that a step divides counts by the mean of its compliance.

    Its angle is what it turns by, and that is the integral of M / K. So the shape depends on the place of a step
    continuously.

    Examples
    --------
    >>> stepped = Profile([0, 0, 5, 5, 10, 10], [1, 1, 2, 2], 1)
    >>> nodal_stiffness(stepped, np.linspace(0, 10, 3)).round(3).tolist()
    [1.0, 1.333, 2.0]
    """
    K = profile(s)
    steps = np.array([place for place, continuity in profile.breaks if continuity < 0])
    if not steps.size:
        return K
    middles = (s[1:] + s[:-1]) / 2
    edges = np.concatenate([s[:1], middles, s[-1:]])
    for i in np.unique(np.clip(np.searchsorted(edges, steps) - 1, 0, s.size - 1)):
        cuts = np.unique(
            np.concatenate([edges[i : i + 2], steps[(steps > edges[i]) & (steps < edges[i + 1])]])
        )
        turned = 0.0
        for a, b in pairwise(cuts):
            inside = (a + b) / 2 + (b - a) / 2 * GAUSS_POINTS
            turned += (b - a) / 2 * float(GAUSS_WEIGHTS @ (1 / profile(inside)))
        K[i] = (edges[i + 1] - edges[i]) / turned
    return K
