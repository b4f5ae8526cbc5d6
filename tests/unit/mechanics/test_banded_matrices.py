"""Bordered tridiagonal matrices against dense linear algebra."""

import numpy as np
import pytest
import scipy.linalg

from elastica_cad import NotConvergedError
from elastica_cad.mechanics.discrete_rod import (
    constrained_inertia,
    count_negative,
    lowest_constrained,
    orthonormal_rows,
    solve_bordered,
    solve_tridiagonal,
)

pytestmark = pytest.mark.core


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
    x, y = solve_bordered(diagonal, off, rows, right=right, below=below)
    assert A @ x + rows.T @ y == pytest.approx(right, abs=1e-7)
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


def clamped_rod(stiffness, load):
    """Second variation of a rod with K at the nodes and <lambda, T> on the edges, all of length 1."""
    spring = stiffness * np.concatenate([[2.0], np.ones(stiffness.size - 2), [2.0]])
    return spring[:-1] + spring[1:] - load, -spring[1:-1]


@pytest.mark.parametrize("n", [40, 41, 200])
def test_lowest_mode_of_rods(n):
    s = (np.arange(n) + 0.5) / n
    rows = np.array([np.sin(4 * s), np.cos(4 * s)])
    smooth = 1.5 + np.sin(7 * np.linspace(0, 1, n + 1))
    weak = np.where(np.abs(np.linspace(0, 1, n + 1) - 0.7) < 0.01, 1e-3, 1.0)
    spot = np.exp(-(((s - 0.3) * 60) ** 2))
    cases = [(smooth, 0 * s), (smooth, 90 * np.cos(3 * s) / n**2), (weak, 0 * s), (smooth, 0.3 * spot)]
    for K, load in cases:
        diagonal, off = clamped_rod(K, load)
        for held in (rows, rows[:1], rows[:0]):
            free = scipy.linalg.null_space(held) if held.size else np.eye(n)
            values, vectors = np.linalg.eigh(free.T @ dense(diagonal, off) @ free)
            found, modes = lowest_constrained(diagonal, off, held)
            assert found[0] == pytest.approx(values[0], abs=1e-12)
            assert abs(modes[0] @ (free @ vectors[:, 0])) == pytest.approx(1, abs=1e-9)


def test_a_low_mode_that_no_smooth_function_shows():
    """Two rods side by side, the lower mode of which is a spike."""
    n = 120
    diagonal, off = clamped_rod(np.ones(n + 1), np.where(np.arange(n) == 77, 2.5, 0.0))
    values = np.linalg.eigvalsh(dense(diagonal, off))
    assert values[0] < 0 < values[1]
    assert lowest_constrained(diagonal, off, np.zeros((0, n)))[0][0] == pytest.approx(values[0], abs=1e-12)
