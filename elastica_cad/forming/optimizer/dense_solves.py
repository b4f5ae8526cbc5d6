"""Small dense products that no BLAS spreads over threads: their start costs more than the product."""

import numpy as np

from elastica_cad._types import FloatArray

_UNTHREADED = 200_000  # multiplications of a product of matrices
_UNTHREADED_ENTRIES = 9_000  # of a matrix times a vector


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
