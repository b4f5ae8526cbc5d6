"""Tridiagonal matrices bordered by a few rows: solves, inertia and lowest modes, all O(n) (LAPACK)."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from elastica_cad import _native
from elastica_cad._compiled_scipy import lapack
from elastica_cad._types import FloatArray
from elastica_cad.errors import NotConvergedError

RANK_TOLERANCE = 1e-9
"""Relative tolerance below which two rows count as dependent: a straight rod has rank 1."""

_FEW = 40
"""Number of edges below which a mode is found by dense algebra."""

_SMOOTH = 10
"""Number of polynomials in which compiled code looks for a lowest mode first."""

_EPS = float(np.finfo(float).eps)


def solve_tridiagonal(diagonal: FloatArray, off: FloatArray, right: FloatArray) -> FloatArray:
    """Solve the symmetric tridiagonal system with pivoting; `right` is (n,) or (n, k)."""
    if diagonal.size == 1:
        return np.asarray(right / diagonal[0])
    solution, info = lapack().dgtsv(off, diagonal, off, right)[-2:]
    if info != 0:
        nudge = np.spacing(np.abs(diagonal).max())
        solution, info = lapack().dgtsv(off, diagonal + nudge, off, right)[-2:]
    if info != 0:
        raise NotConvergedError("the rod's stiffness matrix is singular: its shape is not isolated")
    return np.asarray(solution)


def solve_bordered(
    diagonal: FloatArray,
    off: FloatArray,
    rows: FloatArray,
    *,
    right: FloatArray,
    below: FloatArray,
    columns: FloatArray | None = None,
) -> tuple[FloatArray, FloatArray]:
    """Solve [[A, columns], [rows, 0]] (x, y) = (right, below) with A symmetric tridiagonal.

    Parameters
    ----------
    rows : (k, n) array
    right : (n,) array
    below : (k,) array
    columns : (n, k) array, optional
        The transposed rows unless given.

    Returns
    -------
    x : (n,) array
    y : (k,) array
        Dependent rows are solved in the least-squares sense with the least y.
    """
    k = below.size
    if k == 0:
        return solve_tridiagonal(diagonal, off, right), np.zeros(0)
    both = np.empty((right.size, k + 1), order="F")
    both[:, 0] = right
    both[:, 1:] = rows.T if columns is None else columns
    solved = solve_tridiagonal(diagonal, off, both).T
    products = rows @ solved.T
    y = np.linalg.lstsq(products[:, 1:], products[:, 0] - below, rcond=1e-14)[0]
    return solved[0] - y @ solved[1:], np.asarray(y)


def orthonormal_rows(rows: FloatArray) -> FloatArray:
    """An orthonormal basis (r, n) of the span of `rows` (k, n), rank found."""
    basis: list[FloatArray] = []
    for row in rows:
        size = float(np.linalg.norm(row))
        if size == 0:
            continue
        rest = row / size
        for _ in range(2):
            for q in basis:
                rest = rest - q.dot(rest) * q
        left = float(np.linalg.norm(rest))
        if left > RANK_TOLERANCE:
            basis.append(rest / left)
    return np.array(basis).reshape(len(basis), rows.shape[1])


def count_negative(diagonal: FloatArray, off: FloatArray, shift: float = 0.0) -> int:
    """Number of eigenvalues at or below `shift` of the symmetric tridiagonal matrix (Sturm count)."""
    if diagonal.size == 1:
        return int(diagonal[0] <= shift)
    reach = _reach(diagonal, off)
    if shift < -reach:
        return 0
    count, _, _, _, info = lapack().dstebz(
        diagonal, off, 1, -2 * reach - 1, shift, 1, 1, 8 * reach + 8 + abs(shift), b"E"
    )
    if info != 0:
        raise NotConvergedError("the Sturm count of the rod's second variation failed: its entries overflow")
    return int(count)


def constrained_inertia(diagonal: FloatArray, off: FloatArray, rows: FloatArray, shift: float = 0.0) -> int:
    """Number of eigenvalues below `shift` of the tridiagonal matrix A on the null space of `rows` (k, n).

    Sylvester's law on the bordered matrix: neg = neg(A - shift) + pos(S) - rank, S = C (A - shift)^-1 C^t.
    """
    return _inertia(diagonal, off, orthonormal_rows(rows), shift)


def _inertia(diagonal: FloatArray, off: FloatArray, basis: FloatArray, shift: float) -> int:
    if basis.shape[0] == 0:
        return count_negative(diagonal, off, shift)
    solved = solve_tridiagonal(diagonal - shift, off, basis.T).T
    reach = _reach(diagonal, off)
    if not np.abs(solved).max() * 16 * _EPS * reach < 1:
        # an unbent rod between hinges turns freely but for its ends: count and solution must see one sign there
        shift -= 64 * _EPS * reach
        solved = solve_tridiagonal(diagonal - shift, off, basis.T).T
    negative = count_negative(diagonal, off, shift)
    schur = basis @ solved.T
    positive = int(np.count_nonzero(np.linalg.eigvalsh((schur + schur.T) / 2) > 0))
    return negative + positive - int(basis.shape[0])


def lowest_constrained(
    diagonal: FloatArray, off: FloatArray, rows: FloatArray, count: int = 1
) -> tuple[FloatArray, FloatArray]:
    """Lowest eigenpairs of the symmetric tridiagonal matrix A on the null space of `rows` (k, n).

    By Lanczos iteration on the inverse below the lowest eigenvalue: each step is one positive definite tridiagonal
    solve.

    Returns
    -------
    values : (count,) array
    vectors : (count, n) array
        Orthonormal, orthogonal to `rows`.
    """
    n = diagonal.size
    basis = orthonormal_rows(rows)
    rank = basis.shape[0]
    if n - rank < count:
        raise NotConvergedError(
            "a rod of {n} edges has fewer than {count} free modes: use more samples", n=n, count=count
        )
    if n < _FEW:
        return _dense(diagonal, off, basis, count)
    from scipy.sparse.linalg import LinearOperator, eigsh

    d, e, shift = _factored_below(diagonal, off, min(n, rank + count))
    solved = lapack().dpttrs(d, e, basis.T)[0] if rank else basis.T
    inner = np.linalg.inv(basis @ solved)

    def inverse(x: FloatArray) -> FloatArray:
        x = lapack().dpttrs(d, e, x - basis.T @ (basis @ x))[0]
        x = x - solved @ (inner @ (basis @ x))
        return np.asarray(x - basis.T @ (basis @ x))

    # a start without symmetry, the same in every run: it has a part along every mode
    start = inverse(np.random.default_rng(0).normal(size=n))
    theta, vectors = eigsh(LinearOperator((n, n), inverse, dtype=float), count, which="LA", v0=start)
    return shift + 1 / theta[::-1], vectors.T[::-1]


def _factored_below(diagonal: FloatArray, off: FloatArray, last: int) -> tuple[FloatArray, FloatArray, float]:
    """D and L of L D L^T, of the matrix less a shift below its lowest eigenvalues, and the shift.

    The first `last` eigenvalues tell how far below.
    """
    reach = _reach(diagonal, off)
    tolerance = 0.01 * reach / diagonal.size**2
    lowest = lapack().dstebz(diagonal, off, 2, 0.0, 0.0, 1, last, tolerance, b"E")[1]
    step = 0.3 * (lowest[last - 1] - lowest[0]) + 10 * tolerance
    shift = lowest[0] - step
    d, e, info = lapack().dpttrf(diagonal - shift, off)
    while info != 0 and shift > -2 * reach - step:  # a shift too close by rounding: go further down
        step *= 2
        shift -= step
        d, e, info = lapack().dpttrf(diagonal - shift, off)
    if info != 0:
        raise NotConvergedError("no lower bound of the rod's second variation: its entries are not finite")
    return d, e, shift


class ConstrainedMode(NamedTuple):
    """The lowest eigenvalue of A v = mu W v on C v = 0, its v (n,), and nu (k,) of A v - mu W v = C^t nu."""

    value: float
    mode: FloatArray
    multipliers: FloatArray


def lowest_weighted(
    diagonal: FloatArray, off: FloatArray, lengths: FloatArray, rows: FloatArray
) -> ConstrainedMode:
    """The lowest mode of a tridiagonal matrix A against the weights `lengths` (n,) where `rows` (k, n) vanish.

    v^t W v = 1, its largest entry positive.
    """
    if _native.compiled is not None and diagonal.size >= _FEW:
        found = _native.lowest_mode(diagonal, off, lengths, rows, _polynomials(diagonal.size))
        if found is not None:
            return ConstrainedMode(*found)
    root = np.sqrt(lengths)
    values, vectors = lowest_constrained(diagonal / lengths, off / (root[:-1] * root[1:]), rows / root)
    v = vectors[0] / root
    v = v if v[np.argmax(np.abs(v))] > 0 else -v
    if not len(rows):
        return ConstrainedMode(float(values[0]), v, np.zeros(0))
    left = diagonal * v - values[0] * lengths * v
    left[1:] += off * v[:-1]
    left[:-1] += off * v[1:]
    per_length = rows / lengths
    nu = np.linalg.lstsq(per_length @ rows.T, per_length @ left, rcond=1e-14)[0]
    return ConstrainedMode(float(values[0]), v, nu)


@lru_cache(maxsize=4)
def _polynomials(n: int) -> FloatArray:
    """Orthonormal polynomials (n, _SMOOTH) on n equal steps; kept, as they take as long as the mode itself."""
    powers = np.polynomial.legendre.legvander(np.linspace(-1, 1, n), _SMOOTH - 1)
    return np.asarray(np.linalg.qr(powers)[0])


def _dense(
    diagonal: FloatArray, off: FloatArray, basis: FloatArray, count: int
) -> tuple[FloatArray, FloatArray]:
    full = np.diag(diagonal) + np.diag(off, 1) + np.diag(off, -1)
    free = (
        np.linalg.svd(basis, full_matrices=True)[2][basis.shape[0] :] if basis.size else np.eye(diagonal.size)
    )
    values, vectors = np.linalg.eigh(free @ full @ free.T)
    return values[:count], (free.T @ vectors[:, :count]).T


def _reach(diagonal: FloatArray, off: FloatArray) -> float:
    return float(np.abs(diagonal).max() + 2 * np.abs(off).max(initial=0.0))
