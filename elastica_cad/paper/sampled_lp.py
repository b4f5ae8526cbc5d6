"""Linear programs of the paper's Eqs. 4 and 6 with three unknowns, for all samples of a curve."""

from dataclasses import dataclass

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.errors import InputError
from elastica_cad.geometry.plane_points import left_of
from elastica_cad.mechanics.loads import Gravity
from elastica_cad.mechanics.minimax_lp import minimax_ratio


@dataclass(frozen=True, eq=False)
class SampledStiffness:
    """Optimal stiffness at given samples.

    Attributes
    ----------
    stiffness : (n,) array
        Relative stiffness K; its least value is 1.
    ratio : float
        Ratio of largest to least stiffness.
    a : float
    b : (2,) array
        Numbers a, 1/mm, and b, 1/mm2, of the paper's Eqs. 3 and 5: moment about the origin, and force, at the last
        sample.
    """

    stiffness: FloatArray
    ratio: float
    a: float
    b: FloatArray


def sampled_stiffness(
    position: ArrayLike,
    curvature: ArrayLike,
    weights: ArrayLike | None = None,
    *,
    gravity: Gravity | None = None,
) -> SampledStiffness | None:
    """Return the optimal stiffness at given samples, by the linear program of Eq. 4, or with gravity of Eq. 6.

    `optimal_rod` solves the same problem on the continuous curve.

    Parameters
    ----------
    position : (n, 2) array_like
        Positions of the samples, mm.
    curvature : (n,) array_like
        Curvatures minus the natural curvature, 1/mm; none is zero.
    weights : (n,) array_like, optional
        Voronoi lengths of the samples, mm; needed with gravity.

    Returns
    -------
    SampledStiffness or None
        None if no admissible stiffness exists.

    Raises
    ------
    InputError
        Array shapes differ, a sample is on an inflection, or gravity has no weights.

    References
    ----------
    Paper, Eqs. 4 and 6.

    Examples
    --------
    >>> import numpy as np
    >>> u = np.linspace(0, np.pi, 100)
    >>> position = np.column_stack([0.5 * np.cos(u), np.sin(u)])
    >>> curvature = 0.5 / (0.25 * np.sin(u) ** 2 + np.cos(u) ** 2) ** 1.5
    >>> round(sampled_stiffness(position, curvature).ratio, 4)
    3.2984
    """
    position, curvature = np.asarray(position, dtype=float), np.asarray(curvature, dtype=float)
    n = curvature.size
    if position.shape != (n, 2) or curvature.shape != (n,) or n < 2:
        raise InputError(
            f"the samples have the shapes {position.shape} and {curvature.shape}: give positions (n, 2) and "
            "curvatures (n,)"
        )
    if not (np.all(np.isfinite(position)) and np.all(np.isfinite(curvature)) and np.all(curvature != 0)):
        raise InputError(
            "each sample needs a finite position and a finite curvature that is not 0: leave out samples at "
            "inflections"
        )
    centre = (position.max(axis=0) + position.min(axis=0)) / 2
    if gravity is not None and weights is None:
        raise InputError(
            "with gravity, `weights` is missing: give the length of curve (mm) that each sample represents"
        )
    rows = sampled_rows(position - centre, curvature, weights, None if gravity is None else gravity.e)
    solution = minimax_ratio(rows)
    if solution is None:
        return None
    least = solution.values.min()
    a, *b = solution.x / least
    force = np.array(b)
    return SampledStiffness(
        stiffness=solution.values / least,
        ratio=float(solution.values.max() / least),
        a=float(a - force @ centre),
        b=force,
    )


def sampled_rows(
    position: FloatArray,
    curvature: FloatArray,
    weights: ArrayLike | None = None,
    e: FloatArray | None = None,
) -> FloatArray:
    """Return rows (n, 3) that give the stiffness K = rows @ (a, b_x, b_y) at the samples.

    In Eq. 6 of the paper the terms of sample i in F_i and G_i cancel. Therefore K_i kappa_i = a + <b, gamma_i> +
    <R^t e, gamma_i> F_{i+1} - G_{i+1}, with F_i = F_{i+1} + w_i K_i and G_i = G_{i+1} + w_i <R^t e, gamma_i> K_i.
    Here gamma_i, kappa_i and w_i are position, curvature and Voronoi length of a sample, e the vector of gravity,
    and R a rotation by 90 degrees to the left. In reverse order this is a banded triangular system with three
    right-hand sides.
    """
    affine = np.column_stack([np.ones(len(position)), position])
    if weights is None or e is None:
        return affine / curvature[:, None]
    from scipy.linalg import solve_banded

    n = curvature.size
    g = (position @ -left_of(e))[::-1]
    w, kappa = np.asarray(weights, dtype=float)[::-1], curvature[::-1]
    # unknowns K_n, F_n, G_n, K_{n-1}, ...; band[d, j] is the entry of column j, d rows below the diagonal
    band = np.zeros((4, 3 * n))
    band[0, 0::3], band[0, 1::3], band[0, 2::3] = kappa, 1.0, 1.0
    band[1, 0::3], band[2, 0::3] = -w, -w * g
    band[2, 1:-3:3], band[1, 2:-3:3] = -g[1:], 1.0
    band[3, 1::3], band[3, 2::3] = -1.0, -1.0
    right_sides = np.zeros((3 * n, 3))
    right_sides[0::3] = affine[::-1]
    return np.asarray(solve_banded((3, 0), band, right_sides)[0::3][::-1])
