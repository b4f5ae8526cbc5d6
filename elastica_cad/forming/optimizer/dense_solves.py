"""Small dense products that no BLAS spreads over threads: their start costs more than the product."""

import numpy as np

from elastica_cad._compiled_scipy import lapack
from elastica_cad._native import kernels
from elastica_cad._types import FloatArray

_UNTHREADED = 200_000  # multiplications of a product of matrices
_UNTHREADED_ENTRIES = 9_000  # of a matrix times a vector
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
    if kernels is None:
        A = J.copy()
        A[:, -1] += added
        return gram(A * np.sqrt(weights)[:, None])
    product = np.empty((J.shape[1],) * 2)
    kernels.weighted_gram(J, added, weights, product)
    return product


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
