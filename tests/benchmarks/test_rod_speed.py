"""Speed as ratios within one run: bend and stability against dense and adaptive methods."""

from dataclasses import replace

import numpy as np
import pytest
import scipy.linalg
from scipy.integrate import solve_bvp

from elastica_cad import Rod, bend, stability
from tests.benchmarks.timing import seconds


def arch(samples):
    """A rod; `replace` copies it without its cached results."""
    return bend(Rod.straight(1.0, [1.0, 2.0, 1.5], samples=samples), end=(0.7, 0.1))


def test_stability_against_the_dense_constrained_eigenproblem(benchmark):
    rod = arch(1001)
    (diagonal, off), rows = rod.discrete.hessian, rod.discrete.constraint_rows

    def dense():
        free = scipy.linalg.null_space(rows)
        H = np.diag(diagonal) + np.diag(off, 1) + np.diag(off, -1)
        return np.linalg.eigvalsh(free.T @ H @ free)

    reference = seconds(dense, 1)
    benchmark(lambda: stability(replace(rod)))
    ratio = seconds(lambda: stability(replace(rod))) / reference
    benchmark.extra_info["ratio"] = ratio
    assert ratio <= 0.02


def test_bend_against_solve_bvp(benchmark):
    """`bend` follows the rod from straight, past its buckling; solve_bvp begins beside the solution."""
    rod = Rod.straight(1.0, [1.0, 2.0, 1.5], samples=201)
    profile = rod.profile

    def slopes(s, y, p):
        angle, moment = y[0], y[1]
        return np.vstack([
            moment / profile(s), p[1] * np.cos(angle) - p[0] * np.sin(angle), np.cos(angle), np.sin(angle)
        ])  # fmt: skip

    def ends(a, b, p):
        return np.array([a[0], a[2], a[3], b[0], b[2] - 0.7, b[3] - 0.1])

    s = np.linspace(0.0, 1.0, 41)
    guess = np.vstack([1.2 * np.sin(2 * np.pi * s), np.zeros_like(s), 0.7 * s, 0.3 * np.sin(np.pi * s)])

    def adaptive():
        return solve_bvp(slopes, ends, s, guess, p=[40.0, 0.0], tol=1e-6)

    solved = adaptive()
    assert solved.success
    bent = benchmark(lambda: bend(rod, end=(0.7, 0.1)))
    assert bent.position == pytest.approx(solved.sol(bent.s)[2:].T, abs=1e-3)
    ratio = seconds(lambda: bend(rod, end=(0.7, 0.1))) / seconds(adaptive)
    benchmark.extra_info["ratio"] = ratio
    assert ratio <= 2.0


@pytest.mark.parametrize("what", ["bend", "stability"])
def test_cost_is_linear_up_to_20000(benchmark, what):
    """Four times the nodes: a factor 4 if linear, 16 if quadratic."""

    def task(samples):
        rod = arch(samples)
        again = rod.with_stiffness(1.0 + 0.1 * rod.s)
        return (lambda: bend(again)) if what == "bend" else (lambda: stability(replace(rod)))

    few, many = task(5001), task(20001)
    benchmark.pedantic(many, rounds=7)
    ratio = seconds(many, 7) / seconds(few, 7)
    benchmark.extra_info["ratio"] = ratio
    assert ratio <= 8
