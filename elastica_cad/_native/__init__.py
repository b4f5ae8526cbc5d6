"""Choice between compiled code and Python for the inner loops of rods.

`compiled` is None if the package was built without a C compiler, or if the environment variable ELASTICA_PURE is
set. Each caller then computes the same result in Python. The compiled code checks the sizes of all arrays.
"""

import os
from importlib import import_module
from types import ModuleType

import numpy as np

from elastica_cad._types import ArrayLike, BoolArray, FloatArray


def _found() -> ModuleType | None:
    if os.environ.get("ELASTICA_PURE"):
        return None
    try:
        return import_module("elastica_cad._native.loops")
    except ImportError:
        return None


compiled = _found()


def _loops() -> ModuleType:
    assert compiled is not None
    return compiled


def _plain(values: ArrayLike) -> FloatArray:
    return np.ascontiguousarray(values, dtype=float)


def shoot(
    bend: FloatArray, rest: FloatArray, pull_x: FloatArray, pull_y: FloatArray, moment: float, angle: float,
    most_angle: float,
) -> tuple[FloatArray, FloatArray]:  # fmt: skip
    """Return angles (n + 1,) and moments (n,) by the recursion of `mechanics.discrete_rod.shoot`."""
    nodes = bend.size
    angles, moments = np.empty(nodes + 1), np.empty(nodes)
    given = map(_plain, (bend, rest, pull_x, pull_y))
    _loops().shoot(nodes, *given, moment, angle, most_angle, angles, moments)
    return angles, moments


def shape(
    angles: FloatArray, force: FloatArray, start: FloatArray, edge_length: float
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """Return `tangents`, `position`, `pull` and `shear` of a `DiscreteRod` with edges of equal length."""
    n = angles.size
    out = np.empty((n, 2)), np.empty((n + 1, 2)), np.empty(n), np.empty(n)
    _loops().shape(n, *map(_plain, (angles, force, start)), edge_length, *out)
    return out


def second_variation(
    stiffness: FloatArray, node_lengths: FloatArray, edge_lengths: FloatArray, pull: FloatArray,
    tangents: FloatArray, *, free_ends: tuple[bool, bool], held: tuple[bool, bool], straight: float,
) -> tuple[FloatArray, FloatArray, FloatArray]:  # fmt: skip
    """Return the diagonal and off-diagonal of `DiscreteRod.hessian`, and `DiscreteRod.constraint_rows`."""
    n = edge_lengths.size
    out = np.empty(n), np.empty(n - 1), np.empty((sum(held), n))
    given = map(_plain, (stiffness, node_lengths, edge_lengths, pull, tangents))
    _loops().second_variation(n, *given, *free_ends, *held, straight, *out)
    return out


def sensitivities(
    *, stiffness: FloatArray, moments: FloatArray, all_angles: FloatArray, tangents: FloatArray,
    pull: FloatArray, shear: FloatArray, shares: FloatArray, rest: FloatArray, basis: FloatArray, e: FloatArray,
    carried: tuple[FloatArray, FloatArray] | None, length: float, start_moment: float, start_angle: float,
    to_equilibrium: bool,
) -> tuple[FloatArray, FloatArray, FloatArray]:  # fmt: skip
    """Return the derivatives of angles, moments and positions with respect to the unknowns of
    `form_finding.rod_map.StripGrid.sensitivities`.
    """
    nodes, coefficients = basis.shape
    columns = coefficients + 7 + to_equilibrium
    out = np.empty((nodes + 1, columns)), np.empty((nodes, columns)), np.empty((nodes, 2, columns))
    sums, slopes = (None, None) if carried is None else map(_plain, carried)
    given = map(_plain, (stiffness, moments, all_angles, tangents, pull, shear, shares, rest, basis, e))
    _loops().sensitivities(
        nodes, coefficients, *given, sums, slopes, length, start_moment, start_angle, carried is not None,
        to_equilibrium, *out,
    )  # fmt: skip
    return out


def lowest_mode(
    diagonal: FloatArray, off: FloatArray, lengths: FloatArray, rows: FloatArray, polynomials: FloatArray
) -> tuple[float, FloatArray, FloatArray] | None:
    """Return the result of `mechanics.discrete_rod.lowest_weighted`: value, mode and multipliers.

    The result is None if the search fails.
    """
    mode, multipliers = np.empty(diagonal.size), np.empty(len(rows))
    given = map(_plain, (diagonal, off, lengths, rows, polynomials))
    sizes = diagonal.size, len(rows), polynomials.shape[1]
    value = _loops().lowest_mode(*sizes, *given, mode, multipliers)
    return None if value is None else (float(value), mode, multipliers)


def interior_points(
    hessian: FloatArray, gradient: FloatArray, lower: FloatArray, upper: FloatArray, rows: FloatArray,
    right: FloatArray, penalty: FloatArray, one_sided: BoolArray, accuracy: float,
) -> tuple[tuple[FloatArray, FloatArray, FloatArray, FloatArray], bool, int]:  # fmt: skip
    """Solve a quadratic program of `form_finding.quadratic_program`.

    Return the solution, True if the iteration converged, and the number of factorisations. The solution is x and
    the multipliers of the rows, lower bounds and upper bounds.
    """
    n, m = gradient.size, right.size
    out = np.empty(n), np.empty(m), np.empty(n), np.empty(n)
    given = map(_plain, (hessian, gradient, lower, upper, rows, right, penalty, one_sided))
    converged, iterations = _loops().interior_points(n, m, *given, accuracy, *out)
    return out, bool(converged), int(iterations)
