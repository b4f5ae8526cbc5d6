"""Stiffness of a discrete rod: the profile that is given, its values at the nodes, also where it goes in steps."""

from itertools import pairwise
from math import isclose

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import as_floats
from elastica_cad.errors import InputError
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.mechanics.rod.node_counts import DEFAULT_SAMPLES

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


def scaled_to_least(profile: Profile, s: FloatArray) -> tuple[Profile, FloatArray]:
    """A stiffness and its values at nodes s (n,), mm, over the least of these.

    Raises
    ------
    InputError
        It is not positive.
    """
    if not profile.is_positive:
        raise InputError("rod stiffness must be positive everywhere along the rod")
    K = profile(s)
    return profile.scaled(1 / K.min()), K / K.min()


def stiffness_profile_of(
    stiffness: "ArrayLike | Profile", length: float, samples: int | None
) -> tuple[Profile, int]:
    """A profile over [0, length] and the number of nodes it asks for.

    Parameters
    ----------
    stiffness : float, (n,) array_like or Profile
        One value, values at n uniform stations, or a profile over [0, length].
    length : float
        mm.
    samples : int or None
        Number of nodes; None for one a value, or the usual number.

    Raises
    ------
    InputError
        A profile of another length, or values that are not positive and finite.
    """
    if isinstance(stiffness, Profile):
        if not isclose(stiffness.length, length, rel_tol=1e-9, abs_tol=1e-8):
            raise InputError(
                f"the stiffness profile is {stiffness.length:.6g} mm long, the rod {length:.6g} mm"
            )
        return stiffness, samples or DEFAULT_SAMPLES
    given = as_floats(stiffness)
    values = np.array([]) if given is None else np.atleast_1d(given)
    if not values.size or values.ndim != 1 or not np.all(np.isfinite(values)) or np.any(values <= 0):
        raise InputError("stiffness must be positive, finite numbers: one, or one a node")
    n = samples or (values.size if values.size > 1 else DEFAULT_SAMPLES)
    if values.size == 1:
        values = np.full(2, values[0])
    return Profile.interpolate(np.linspace(0.0, length, values.size), values), n
