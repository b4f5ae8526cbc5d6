"""Bordered tridiagonal matrices against dense linear algebra."""

import numpy as np
import pytest
import scipy.linalg

from elastica_cad.errors import NotConvergedError
from elastica_cad.mechanics.banded import (
    constrained_inertia,
    count_negative,
    lowest_constrained,
    orthonormal_rows,
    solve_bordered,
    solve_tridiagonal,
)


@pytest.fixture(params=[5, 7, 40, 200])
def matrix(request):
    n = request.param
    rng = np.random.default_rng(n)
    diagonal, off = rng.uniform(-1.5, 3, n), rng.uniform(-1, 1, n - 1)
    return diagonal, off, rng.standard_normal((2, n)), rng


def dense(diagonal, off):
    return np.diag(diagonal) + np.diag(off, 1) + np.diag(off, -1)


def test_solves(matrix):
    diagonal, off, rows, rng = matrix
    n = diagonal.size
    A, right, below = dense(diagonal, off), rng.standard_normal(n), rng.standard_normal(2)
    assert A @ solve_tridiagonal(diagonal, off, right) == pytest.approx(right, abs=1e-8)
    columns = rng.standard_normal((n, 2))
    for border in (None, columns):
        x, y = solve_bordered(diagonal, off, rows, right=right, below=below, columns=border)
        assert A @ x + (rows.T if border is None else border) @ y == pytest.approx(right, abs=1e-7)
        assert rows @ x == pytest.approx(below, abs=1e-7)


def test_counts_and_lowest_modes(matrix):
    diagonal, off, rows, _ = matrix
    A = dense(diagonal, off)
    for held in (rows, rows[:1], rows[:0], np.vstack([rows, rows[0] - 2 * rows[1]])):
        free = scipy.linalg.null_space(held) if held.size else np.eye(diagonal.size)
        values = np.linalg.eigvalsh(free.T @ A @ free)
        for shift in (0.0, 0.7, -3.0):
            assert constrained_inertia(diagonal, off, held, shift) == np.count_nonzero(values < shift)
        found, modes = lowest_constrained(diagonal, off, held, 2)
        assert found == pytest.approx(values[:2], abs=1e-9)
        assert held @ modes.T == pytest.approx(np.zeros((held.shape[0], 2)), abs=1e-8)
        assert modes @ modes.T == pytest.approx(np.eye(2), abs=1e-8)
    assert count_negative(diagonal, off) == np.count_nonzero(np.linalg.eigvalsh(A) < 0)


def test_rank_of_dependent_rows():
    row = np.linspace(1.0, 2.0, 9)
    assert orthonormal_rows(np.vstack([row, -3 * row, np.zeros(9)])).shape == (1, 9)


def test_more_modes_than_there_are():
    with pytest.raises(NotConvergedError, match="more samples"):
        lowest_constrained(np.ones(3), np.zeros(2), np.eye(3)[:2], 2)
