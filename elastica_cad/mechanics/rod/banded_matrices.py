"""Tridiagonal matrices bordered by a few rows: solves, inertia and lowest modes, all O(n) (LAPACK)."""

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from elastica_cad import _native
from elastica_cad._compiled_scipy import lapack
from elastica_cad._types import FloatArray
from elastica_cad.errors import NotConvergedError

RANK_TOLERANCE = 1e-9  # rows closer to dependent than this (relative) are one: a straight rod has rank 1
MOST_STEPS = 240  # of Lanczos iteration, which takes a few dozen
_SMOOTH = 10  # polynomials among which a lowest mode is sought first
_ROUGH = 40  # edges, below which ten polynomials are no smooth modes
_REFINEMENTS = 8  # Rayleigh quotients: each triples the digits
_SETTLED = 1e-5  # of a mode's size: a quotient that changes by less has all its digits, as its error is cubed
_UNTHREADED = 5000  # entries, up to which BLAS starts no threads
_EPS = float(np.finfo(float).eps)
_SINGULAR = 16 * _EPS  # of a matrix: an eigenvalue that is rounding
_ASIDE = 64 * _EPS  # of it too: a step clear of that


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
    products = np.array([_along(solved, row) for row in rows])
    schur, gap = products[:, 1:], products[:, 0] - below
    y = _small_solution(schur, gap)
    return solved[0] - _combined(y, solved[1:]), y


def orthonormal_rows(rows: FloatArray) -> FloatArray:
    """An orthonormal basis (r, n) of the span of `rows` (k, n), rank found."""
    basis: list[FloatArray] = []
    for row in rows:
        size = _norm(row)
        if size == 0:
            continue
        rest = row / size
        for _ in range(2):
            for q in basis:
                rest = rest - q.dot(rest) * q
        left = _norm(rest)
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
    if not np.abs(solved).max() * _SINGULAR * reach < 1:
        # an unbent rod between hinges turns freely but for its ends: count and solution must see one sign there
        shift -= _ASIDE * reach
        solved = solve_tridiagonal(diagonal - shift, off, basis.T).T
    negative = count_negative(diagonal, off, shift)
    schur = np.array([_along(solved, row) for row in basis])
    positive = int(np.count_nonzero(np.linalg.eigvalsh((schur + schur.T) / 2) > 0))
    return negative + positive - int(basis.shape[0])


def lowest_constrained(
    diagonal: FloatArray, off: FloatArray, rows: FloatArray, count: int = 1, *, rough: bool = False
) -> tuple[FloatArray, FloatArray]:
    """Lowest eigenpairs of the symmetric tridiagonal matrix A on the null space of `rows` (k, n).

    The lowest mode alone is sought among smooth ones, refined by Rayleigh quotients, and proved the lowest by
    the inertia just below it; several modes, or a rough one, by shifted inverse Lanczos iteration, every step
    one positive definite tridiagonal solve: O(n). Where the mode is known to be `rough`, at once.

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
        raise NotConvergedError(f"a rod of {n} edges has fewer than {count} free modes: use more samples")
    if n <= 6:
        return _dense(diagonal, off, basis, count)
    reach = _reach(diagonal, off)
    if count == 1 and n >= _ROUGH and not rough:
        found = _smooth_mode(diagonal, off, basis, reach)
        if found is not None:
            return found
    d, e, shift = _factored_below(diagonal, off, min(n, rank + count), reach)
    return _lanczos(d, e, shift, basis, count)


def _factored_below(
    diagonal: FloatArray, off: FloatArray, last: int, reach: float
) -> tuple[FloatArray, FloatArray, float]:
    """D and L of L D L^T, of the matrix less a shift below its lowest eigenvalues, and the shift.

    The first `last` eigenvalues tell how far below.
    """
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


def _lanczos(
    d: FloatArray, e: FloatArray, shift: float, basis: FloatArray, count: int
) -> tuple[FloatArray, FloatArray]:
    """Eigenpairs next to the shift, of a matrix factored there, orthogonal to an orthonormal `basis` (rank, n)."""
    n, rank = d.size, basis.shape[0]
    solved = np.ascontiguousarray(lapack().dpttrs(d, e, basis.T)[0].T) if rank else basis
    inner = np.linalg.inv([_along(solved, row) for row in basis]) if rank else np.zeros((0, 0))

    most = min(MOST_STEPS, n - rank)
    V = np.zeros((most + 1, n))
    start = _START[np.arange(n) % _START.size] + np.linspace(0.5, 1.5, n)
    start = start - _combined(_along(basis, start), basis)
    V[0] = start / _norm(start)
    alpha, beta = np.zeros(most), np.zeros(most)
    for j in range(most):
        x = lapack().dpttrs(d, e, V[j])[0]
        if rank:
            x = x - _combined(inner @ _along(basis, x), solved)
            x -= _combined(_along(basis, x), basis)
        alpha[j] = _along(V[j : j + 1], x)[0]
        for _ in range(2):
            x -= _combined(_along(V[: j + 1], x), V[: j + 1])
        beta[j] = _norm(x)
        exhausted = j + 1 == most or beta[j] <= 1e-15 * alpha[0]
        if exhausted or (j >= 8 + 2 * count and j % 3 == 0):
            theta, S = np.linalg.eigh(np.diag(alpha[: j + 1]) + np.diag(beta[:j], 1) + np.diag(beta[:j], -1))
            wanted = slice(-1, -count - 1, -1)
            left = np.abs(beta[j] * S[-1, wanted])
            if exhausted or np.all(left < 1e-12 * theta[wanted]):
                vectors = S[:, wanted].T @ V[: j + 1]
                return shift + 1 / theta[wanted], vectors
        V[j + 1] = x / beta[j]
    raise NotConvergedError("the lowest mode of the rod was not found")


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
    rough = False
    if _native.compiled is not None and diagonal.size >= _ROUGH:
        found = _native.lowest_mode(diagonal, off, lengths, rows, _polynomials(diagonal.size))
        if found is not None:
            return ConstrainedMode(*found)
        rough = len(orthonormal_rows(rows / np.sqrt(lengths))) == len(
            rows
        )  # dependent rows are left to Python
    root = np.sqrt(lengths)
    values, vectors = lowest_constrained(
        diagonal / lengths, off / (root[:-1] * root[1:]), rows / root, rough=rough
    )
    v = vectors[0] / root
    v = v if v[np.argmax(np.abs(v))] > 0 else -v
    if not len(rows):
        return ConstrainedMode(float(values[0]), v, np.zeros(0))
    left = diagonal * v - values[0] * lengths * v
    left[1:] += off * v[:-1]
    left[:-1] += off * v[1:]
    per_length = rows / lengths
    nu = _small_solution(np.einsum("in,jn->ij", per_length, rows), np.einsum("in,n->i", per_length, left))
    return ConstrainedMode(float(values[0]), v, nu)


def _smooth_mode(
    diagonal: FloatArray, off: FloatArray, basis: FloatArray, reach: float
) -> tuple[FloatArray, FloatArray] | None:
    """The lowest eigenpair by Rayleigh quotient iteration (cubic) from the best polynomial; None if not sure."""
    n, k = diagonal.size, basis.shape[0]
    V = _polynomials(n)
    turned = diagonal[:, None] * V
    turned[1:] += off[:, None] * V[:-1]
    turned[:-1] += off[:, None] * V[1:]
    energy = V.T @ turned
    free = np.eye(_SMOOTH)
    if k:
        free = np.linalg.qr((basis @ V).T, mode="complete")[0][:, k:]
    value, mode = _lowest_of_small(free.T @ energy @ free)
    x = V @ (free @ mode)
    scale = abs(value) + reach / n**2
    right = np.empty((n, k + 1), order="F")
    right[:, 1:] = basis.T
    for _ in range(_REFINEMENTS):
        right[:, 0] = x
        solved = solve_tridiagonal(diagonal - value, off, right).T
        x = solved[0]
        if k:
            schur = np.array([_along(solved, row) for row in basis])
            x = x - _combined(_small_solution(schur[:, 1:], schur[:, 0]), solved[1:])
            x -= _combined(_along(basis, x), basis)
        size = _norm(x)
        if not (np.isfinite(size) and size > 0):
            return None
        x /= size
        change = float(_along(x[None], right[:, 0])[0]) / size
        value += change
        if abs(change) < _SETTLED * scale:
            below = value - max(1e-9 / n**2, 64 * np.finfo(float).eps) * reach
            sure = _inertia(diagonal, off, basis, below) == 0
            return (np.array([value]), x[None]) if sure else None
    return None


def _lowest_of_small(matrix: FloatArray) -> tuple[float, FloatArray]:
    """The lowest eigenvalue of a small symmetric matrix, to rounding of its largest, and its eigenvector.

    Lifted above zero it has its eigenvalues for singular values. For these OpenBLAS wakes no threads. For the
    eigenvalues of more than five rows it does, which takes ten times as long, and where others compute too
    milliseconds.
    """
    lift = float(np.abs(matrix).sum(axis=1).max())
    modes, sizes, _ = np.linalg.svd(matrix + lift * np.eye(len(matrix)))
    return float(sizes[-1]) - lift, modes[:, -1]


@lru_cache(maxsize=16)
def _polynomials(n: int) -> FloatArray:
    """Orthonormal polynomials (n, _SMOOTH) on n equal steps."""
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


def _small_solution(matrix: FloatArray, right: FloatArray) -> FloatArray:
    """Solution of a small system, in the least-squares sense where it is singular."""
    if right.size == 2:  # the usual case, ten times faster than a general solver
        (a, b), (c, d) = matrix.tolist()
        determinant = a * d - b * c
        if abs(determinant) > 1e-12 * (abs(a * d) + abs(b * c)):
            x, y = right.tolist()
            return np.array([(d * x - b * y) / determinant, (a * y - c * x) / determinant])
    return np.asarray(np.linalg.lstsq(matrix, right, rcond=1e-14)[0], dtype=float)


# BLAS is faster up to the size at which it starts threads, which cost more than these products
def _along(rows: FloatArray, vector: FloatArray) -> FloatArray:
    if rows.size <= _UNTHREADED:
        return np.asarray(rows.dot(vector))
    return np.asarray(np.einsum("kn,n->k", rows, vector))


def _combined(factors: FloatArray, rows: FloatArray) -> FloatArray:
    if rows.size <= _UNTHREADED:
        return np.asarray(factors.dot(rows))
    return np.asarray(np.einsum("k,kn->n", factors, rows))


def _norm(vector: FloatArray) -> float:
    if vector.size <= _UNTHREADED:
        return math.sqrt(vector.dot(vector))
    return math.sqrt(np.einsum("n,n->", vector, vector))


# a start without symmetry, the same in every run: it has a part along every mode
_START = np.array([0.31, -0.27, 0.83, 0.12, -0.55, 0.71, 0.44, -0.93, 0.08, 0.62, -0.38])
