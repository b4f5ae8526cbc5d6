"""Cost of the stiffness programs as ratios, in one run, against one plain HiGHS solve of all their rows."""

from time import perf_counter

import highspy
import numpy as np
import pytest

from elastica_cad.geometry import PlaneCurve
from elastica_cad.mechanics import Gravity, sampled_stiffness
from elastica_cad.mechanics.gravity_lp import sampled_rows
from elastica_cad.mechanics.minimax_lp import minimax_ratio

CARD = Gravity(96.0)


def seconds(function, repeats=15):
    best = np.inf
    for _ in range(repeats):
        start = perf_counter()
        function()
        best = min(best, perf_counter() - start)
    return best


def solved(program):
    highs = highspy.Highs()
    highs.setOptionValue("output_flag", False)
    highs.passModel(program)
    highs.run()
    assert highs.getModelStatus() == highspy.HighsModelStatus.kOptimal
    return highs.getInfo().objective_function_value


def program(cost, column_bounds, matrix, row_bounds):
    """A HiGHS model from a sparse or dense row-wise matrix."""
    from scipy.sparse import csr_matrix

    matrix = csr_matrix(matrix)
    lp = highspy.HighsLp()
    lp.num_row_, lp.num_col_ = matrix.shape
    lp.col_cost_, (lp.col_lower_, lp.col_upper_) = cost, column_bounds
    lp.row_lower_, lp.row_upper_ = row_bounds
    lp.a_matrix_.format_ = highspy.MatrixFormat.kRowwise
    lp.a_matrix_.start_ = matrix.indptr
    lp.a_matrix_.index_ = matrix.indices
    lp.a_matrix_.value_ = matrix.data
    return lp


def all_rows(rows):
    """Eq. 4 with every sample's two rows."""
    n, m = rows.shape
    matrix = np.block([[rows, np.zeros((n, 1))], [rows, -np.ones((n, 1))]])
    free = np.full(m + 1, np.inf)
    low, high = np.repeat([1.0, -np.inf], n), np.repeat([np.inf, 0.0], n)
    return program(np.eye(m + 1)[-1], (-free, free), matrix, (low, high))


def full_gravity_program(position, curvature, weights, e):
    """Eq. 6 with its 3n + 4 variables a, b, R, K_i, F_i, G_i."""
    from scipy.sparse import bmat, diags, identity

    n = curvature.size
    g = position @ np.array([e[1], -e[0]])
    one, after = identity(n), diags([np.ones(n - 1)], [1])
    affine = np.column_stack([np.ones(n), position, np.zeros(n)])
    ratio = np.zeros((n, 4))
    ratio[:, 3] = -1.0
    matrix = bmat([
        [affine, diags(-curvature), diags(g), -one],
        [None, diags(weights), after - one, None],
        [None, diags(weights * g), None, after - one],
        [ratio, one, None, None],
    ], format="csr")  # fmt: skip
    low = np.concatenate([np.full(4, -np.inf), np.ones(n), np.full(2 * n, -np.inf)])
    high = np.full(4 + 3 * n, np.inf)
    rows = np.zeros(3 * n), np.zeros(3 * n)
    bounds = np.concatenate([rows[0], np.full(n, -np.inf)]), np.concatenate([rows[1], np.zeros(n)])
    return program(np.eye(4 + 3 * n)[3], (low, high), matrix, bounds)


def half_ellipse(n):
    curve = PlaneCurve.ellipse((0, 0), (2.0, 1.0), start=0, end=np.pi)
    samples = curve.sample(n)
    return samples.position, samples.curvature


@pytest.mark.parametrize(("n", "limit"), [(200, 0.5), (2000, 0.08)])
def test_row_generation_against_all_rows(benchmark, n, limit):
    rows = sampled_rows(*half_ellipse(n))
    lp = all_rows(rows)
    assert minimax_ratio(rows).ratio == pytest.approx(solved(lp), rel=1e-8)
    benchmark(minimax_ratio, rows)
    ratio = seconds(lambda: minimax_ratio(rows)) / seconds(lambda: solved(all_rows(rows)))
    benchmark.extra_info["ratio"] = ratio
    assert ratio <= limit


def test_gravity_against_the_full_program(benchmark):
    n = 500
    curve = PlaneCurve.spline([(-90, 0), (-70, 80), (0, 130), (70, 80), (90, 0)])
    samples = curve.sample(n)
    # lengths of order one, or the full program is badly scaled
    position, curvature, e = samples.position / 100, samples.curvature * 100, CARD.e * 1e6
    weights = np.full(n, curve.length / 100 / (n - 1))
    weights[[0, -1]] /= 2
    gravity = Gravity(0.96)

    def ours():
        return sampled_stiffness(position, curvature, weights, gravity=gravity)

    lp = full_gravity_program(position, curvature, weights, e)
    assert ours().ratio == pytest.approx(solved(lp), rel=1e-6)
    benchmark(ours)
    ratio = seconds(ours) / seconds(lambda: solved(lp), 5)
    benchmark.extra_info["ratio"] = ratio
    assert ratio <= 0.1


def test_cost_hardly_grows_with_the_samples(benchmark):
    small, large = (sampled_rows(*half_ellipse(n)) for n in (200, 20000))
    benchmark(minimax_ratio, large)
    assert seconds(lambda: minimax_ratio(large)) <= 5 * seconds(lambda: minimax_ratio(small))
