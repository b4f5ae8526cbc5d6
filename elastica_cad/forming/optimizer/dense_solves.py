"""Small dense products and solves that no BLAS spreads over threads: their start costs more than the work."""

import numpy as np

from elastica_cad._compiled_scipy import lapack
from elastica_cad._types import FloatArray

_UNTHREADED = 200_000  # multiplications of a product of matrices
_UNTHREADED_ENTRIES = 9_000  # of a matrix times a vector
SINGULAR_SHARE = 1e-15  # added to a diagonal: rows that say nearly the same may not make the system singular
_WELL_APART = 1e-3  # least pivot of unit rows that a Cholesky factor tells apart to ten digits


def matvec(A: FloatArray, x: FloatArray) -> FloatArray:
    """A x in blocks of rows."""
    block = max(1, _UNTHREADED_ENTRIES // A.shape[1])
    if A.shape[0] <= block:
        return np.asarray(A @ x)
    return np.concatenate([A[first : first + block] @ x for first in range(0, A.shape[0], block)])


def gram(A: FloatArray) -> FloatArray:
    """A^T A in blocks of rows."""
    block = max(1, _UNTHREADED // A.shape[1] ** 2)
    total = np.zeros((A.shape[1], A.shape[1]))
    for first in range(0, A.shape[0], block):
        part = A[first : first + block]
        total += part.T @ part
    return total


def weighted_gram(J: FloatArray, added: FloatArray, weights: FloatArray) -> FloatArray:
    """A^T W A of A, which is J (k, p) with `added` (k,) in its last column; weights (k,) are 0 or more.

    J is contiguous.
    """
    A = J.copy()
    A[:, -1] += added
    return gram(A * np.sqrt(weights)[:, None])


def least_step(J: FloatArray, gap: FloatArray) -> FloatArray:
    """The least x (p,) with J x = gap (k,), in the sense of least squares where rows of J (k, p) are dependent."""
    if not gap.size:
        return np.zeros(J.shape[1])
    size = np.maximum(np.sqrt(np.einsum("kp,kp->k", J, J)), 1e-300)
    rows = J / size[:, None]
    factor, step, info = lapack().dposv(rows @ rows.T, gap / size, lower=1)
    if info == 0 and factor.diagonal().min() > _WELL_APART:
        return np.asarray(step @ rows)
    return np.asarray(np.linalg.lstsq(J, gap, rcond=1e-10)[0])


def factor_kkt(
    H: FloatArray, diagonal: FloatArray, A: FloatArray, D: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray] | None:
    """The factors of [[G, -A^T], [A, D]] with G = H + diagonal: L^-1 of L L^T = G, W = L^-1 A^T, and the Cholesky
    factor of W^T W + D; None where G is not positive definite, or rows are dependent.

    L is inverted because LAPACK's triangular solves with several right-hand sides start threads, which on a
    busy machine costs a thousand times the work.
    """
    G = H.copy()
    G.flat[:: G.shape[0] + 1] += diagonal
    L, info = lapack().dpotrf(G, lower=1)
    if info != 0:
        return None
    inverse, _ = lapack().dtrtri(L, lower=1)
    W = inverse @ A.T
    S = gram(W) if W.size else np.zeros((0, 0))
    if not S.size:
        return inverse, W, S
    diagonals = S.reshape(-1)[:: S.shape[0] + 1]
    diagonals += D
    C, info = lapack().dpotrf(S, lower=1)
    if info != 0:
        diagonals += SINGULAR_SHARE * diagonals.max()
        C, info = lapack().dpotrf(S, lower=1)
    return None if info != 0 else (inverse, W, C)


def solve_kkt(
    system: tuple[FloatArray, FloatArray, FloatArray], a: FloatArray, b: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """(dx, dy) with G dx - A^T dy = a and A dx + D dy = b, from what `factor_kkt` gave."""
    inverse, W, C = system
    half = inverse @ a
    dy = np.zeros(0)
    if C.size:
        dy, _ = lapack().dpotrs(C, b - half @ W, lower=1)
        half = half + W @ dy
    return half @ inverse, dy
