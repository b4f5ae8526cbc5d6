"""The stiffness programs of the paper (Eqs. 4 and 6), all rows written out for HiGHS: the measure of ours."""

import time

import highspy
import numpy as np

import elastica_cad as ec
from elastica_cad.paper.sampled_lp import sampled_stiffness

TOLERANCE = 1e-10  # of both; HiGHS' own default leaves a ratio uncertain by 1e-7


def light_program(position, curvature):
    """Eq. 4 in a, b, R: the two rows 1 <= K_i <= R of every sample."""
    n = curvature.size
    K = np.column_stack([np.ones(n), position]) / curvature[:, None]
    columns = np.tile(np.arange(4), (n, 1))
    return program(
        np.eye(4)[3], np.full(4, -np.inf), np.full(4, np.inf),
        (columns[:, :3], K, 1.0, np.inf),
        (columns, np.column_stack([K, -np.ones(n)]), -np.inf, 0.0),
    )  # fmt: skip


def heavy_program(position, curvature, weights, e):
    """Eq. 6 with its 3n + 4 variables a, b, R, K_i, F_i, G_i."""
    n = curvature.size
    one, g = np.ones(n), position @ np.array([e[1], -e[0]])
    i = np.arange(n)
    K, F, G = 4 + i, 4 + n + i, 4 + 2 * n + i
    moment = np.column_stack([0 * i, 0 * i + 1, 0 * i + 2, K, F, G])
    lower, upper = np.full(4 + 3 * n, -np.inf), np.full(4 + 3 * n, np.inf)
    lower[K] = 1.0
    return program(
        np.eye(4 + 3 * n)[3], lower, upper,
        (moment, np.column_stack([one, position, -curvature, g, -one]), 0.0, 0.0),
        *running_sum(K, F, weights),
        *running_sum(K, G, weights * g),
        (np.column_stack([0 * i + 3, K]), np.column_stack([-one, one]), -np.inf, 0.0),
    )  # fmt: skip


def running_sum(terms, sums, factors):
    """Rows sum_i = sum_{i+1} + factor_i term_i, where nothing comes after the last."""
    n = terms.size
    columns = np.column_stack([terms, sums, np.roll(sums, -1)])
    values = np.column_stack([factors, -np.ones(n), np.ones(n)])
    return (columns[:-1], values[:-1], 0.0, 0.0), (columns[-1:, :2], values[-1:, :2], 0.0, 0.0)


def program(cost, lower, upper, *blocks):
    """A model for HiGHS from blocks of rows (columns, values, lower, upper)."""
    widths = np.concatenate([np.full(len(values), values.shape[1]) for _, values, _, _ in blocks])
    lp = highspy.HighsLp()
    lp.num_row_, lp.num_col_ = widths.size, cost.size
    lp.col_cost_, lp.col_lower_, lp.col_upper_ = cost, lower, upper
    lp.row_lower_ = np.concatenate([np.full(len(values), low) for _, values, low, _ in blocks])
    lp.row_upper_ = np.concatenate([np.full(len(values), high) for _, values, _, high in blocks])
    lp.a_matrix_.format_ = highspy.MatrixFormat.kRowwise
    lp.a_matrix_.start_ = np.concatenate([[0], np.cumsum(widths)])
    lp.a_matrix_.index_ = np.concatenate([columns.ravel() for columns, _, _, _ in blocks])
    lp.a_matrix_.value_ = np.concatenate([values.ravel() for _, values, _, _ in blocks])
    return lp


def optimum(lp):
    """The least objective, by HiGHS as it comes but for its tolerance."""
    highs = highspy.Highs()
    for name, value in {
        "output_flag": False, "primal_feasibility_tolerance": TOLERANCE, "dual_feasibility_tolerance": TOLERANCE,
    }.items():  # fmt: skip
        highs.setOptionValue(name, value)
    highs.passModel(lp)
    highs.run()
    if highs.getModelStatus() != highspy.HighsModelStatus.kOptimal:
        raise RuntimeError(f"HiGHS stopped with {highs.modelStatusToString(highs.getModelStatus())}")
    return highs.getInfo().objective_function_value


def samples(rod):
    """Position, curvature, Voronoi lengths and gravity of a rod at its nodes, in lengths of the rod."""
    size, n = rod.length, rod.s.size
    weights = np.full(n, 1 / (n - 1))
    weights[[0, -1]] /= 2
    gravity = None
    if rod.gravity is not None:
        gravity = ec.Gravity(rod.gravity.length / size, rod.gravity.direction)
    return rod.position / size, (rod.curvature - rod.natural_curvature) * size, weights, gravity


def ours(position, curvature, weights, gravity):
    """The least ratio by `sampled_stiffness`."""
    return sampled_stiffness(position, curvature, weights, gravity=gravity).ratio


def plain(position, curvature, weights, gravity):
    """The least ratio by all rows at once."""
    if gravity is None:
        return optimum(light_program(position, curvature))
    return optimum(heavy_program(position, curvature, weights, gravity.e))


def race(rods, repeats=1):
    """Processor seconds for the stiffness of all rods by ours and by plain HiGHS, and where the ratios differ most.

    Each rod is solved both ways in turn; the best of the repeats counts.
    """
    spent, apart = np.zeros(2), 0.0
    for rod in rods:
        given = samples(rod)
        best, found = np.full(2, np.inf), [0.0, 0.0]
        for _ in range(repeats):
            for k, solve in enumerate((ours, plain)):
                start = time.process_time()
                found[k] = solve(*given)
                best[k] = min(best[k], time.process_time() - start)
        spent += best
        apart = max(apart, abs(found[0] / found[1] - 1))
    return spent[0], spent[1], apart
