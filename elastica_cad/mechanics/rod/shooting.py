"""The rod as an initial value problem: stiffness and what happens at the start give every angle and moment."""

from math import cos, nan, sin

import numpy as np

from elastica_cad import _native
from elastica_cad._types import FloatArray

_WOUND_UP_RAD = 1e6  # no strip winds up so far, and cos and sin lose ten digits there


def shoot(
    stiffness: FloatArray,
    w: FloatArray,
    force: FloatArray,
    edge_length: float,
    *,
    moment: float,
    angle: float,
    natural_curvature: float | FloatArray = 0.0,
) -> tuple[FloatArray, FloatArray]:
    """Angles and moments of the discrete rod in balance that starts with `moment` and `angle`.

    alpha_{i+1} = alpha_i + w_i (M_i / K_i + kappa_0),  M_{i+1} = M_i + l <b_{i+1}, T(alpha_{i+1})>: the
    stationarity of the discrete energy (paper, section 7.1) read from left to right, so the moment imbalance
    of `DiscreteRod.moment_imbalance` vanishes to rounding error.

    Parameters
    ----------
    stiffness, w : (n+1,) arrays
        K and Voronoi lengths (mm) of the nodes.
    force : (n, 2) array
        lambda of the edges, 1/mm2; b = R^t lambda.
    edge_length : float
        mm.
    moment, angle : float
        M_0, 1/mm, and the angle alpha_0 that the start holds, rad.
    natural_curvature : float or (n+1,) array
        kappa_0, 1/mm.

    Returns
    -------
    angles : (n+2,) array
        alpha_0, the n edge angles, and the angle at the end; not a number from where the rod winds up beyond
        all measure.
    moments : (n+1,) array

    Examples
    --------
    A quarter circle: a constant moment and no force.

    >>> from elastica_cad.mechanics.rod.discrete_rod import node_weights
    >>> angles, moments = shoot(
    ...     np.ones(5), node_weights(0.25, 4), np.zeros((4, 2)), 0.25, moment=np.pi / 2, angle=0.0
    ... )
    >>> round(float(angles[-1]), 6)
    1.570796
    """
    bends, rests = w / stiffness, np.ascontiguousarray(np.broadcast_to(w * natural_curvature, w.shape))
    across, along = edge_length * force[:, 1], -edge_length * force[:, 0]
    if _native.compiled is None:
        return _shoot_in_python(bends, rests, across, along, float(moment), float(angle))
    return _native.shoot(bends, rests, across, along, float(moment), float(angle), _WOUND_UP_RAD)


def _shoot_in_python(
    bends: FloatArray, rests: FloatArray, across: FloatArray, along: FloatArray, M: float, alpha: float
) -> tuple[FloatArray, FloatArray]:
    n, (bend, rest) = bends.size - 1, (bends.tolist(), rests.tolist())
    pull_x, pull_y = across.tolist(), along.tolist()
    angles, moments = [alpha], [M]
    for i in range(n):  # plain floats: an array expression a step would cost twenty times as much
        alpha += bend[i] * M + rest[i]
        if not -_WOUND_UP_RAD < alpha < _WOUND_UP_RAD:
            alpha = M = nan
        M += pull_x[i] * cos(alpha) + pull_y[i] * sin(alpha)
        angles.append(alpha)
        moments.append(M)
    angles.append(alpha + bend[n] * M + rest[n])
    return np.array(angles), np.array(moments)
