"""The quadratic programs against scipy's general solver and against optimality conditions."""

import numpy as np
import pytest
from scipy.optimize import minimize

from elastica_cad.form_finding.quadratic_program import QuadraticProgram, solve_quadratic

pytestmark = pytest.mark.core


def program(seed, p=8, m=4, penalty=50.0):
    rng = np.random.default_rng(seed)
    J = rng.normal(size=(2 * p, p)) * np.logspace(0, -2, p)
    return QuadraticProgram(
        J.T @ J, rng.normal(size=p), -rng.random(p), rng.random(p), rng.normal(size=(m, p)),
        0.3 * rng.normal(size=m), np.full(m, penalty), rng.random(m) < 0.5,
    )  # fmt: skip


def cost(q, x):
    gap = q.rows @ x - q.right
    broken = np.where(q.one_sided, np.maximum(-gap, 0), np.abs(gap))
    return 0.5 * x @ q.hessian @ x + q.gradient @ x + q.penalty @ broken


@pytest.mark.parametrize("seed", range(12))
def test_agrees_with_a_general_solver(seed):
    q = program(seed)
    s = solve_quadratic(q)
    assert s.converged
    p, m = q.gradient.size, q.right.size

    def smooth(v):
        return (
            0.5 * v[:p] @ q.hessian @ v[:p]
            + q.gradient @ v[:p]
            + q.penalty @ v[p : p + m]
            + q.penalty @ v[p + m :]
        )

    rows = np.hstack([q.rows, np.eye(m), -np.eye(m)])
    kinds = [
        {"type": kind, "fun": lambda v, pick=pick: rows[pick] @ v - q.right[pick]}
        for kind, pick in (("ineq", q.one_sided), ("eq", ~q.one_sided))
        if pick.any()
    ]
    bounds = [*zip(q.lower, q.upper, strict=True), *[(0, None)] * (2 * m)]
    other = minimize(smooth, np.zeros(p + 2 * m), method="SLSQP", bounds=bounds, constraints=kinds,
                     options={"ftol": 1e-14, "maxiter": 500})  # fmt: skip
    assert cost(q, s.x) <= other.fun + 1e-6 * (1 + abs(other.fun))


@pytest.mark.parametrize("seed", range(6))
def test_conditions_of_optimality(seed):
    q = program(seed, p=30, m=10)
    s = solve_quadratic(q)
    balance = (
        q.hessian @ s.x + q.gradient - s.row_multipliers @ q.rows - s.lower_multipliers + s.upper_multipliers
    )
    scale = np.abs(q.gradient).max()
    assert np.abs(balance).max() < 1e-7 * scale
    assert np.all(s.x >= q.lower)
    assert np.all(s.x <= q.upper)
    gap = q.rows @ s.x - q.right
    met = np.where(q.one_sided, gap > -1e-7, np.abs(gap) < 1e-7)
    at_price = np.abs(np.abs(s.row_multipliers) - q.penalty) < 1e-4 * q.penalty
    assert np.all(met | at_price)


@pytest.mark.parametrize("penalty", [0.1, 1.0, 10.0])
def test_inequalities_never_pull(penalty):
    for seed in range(60):
        q = program(seed, m=8, penalty=penalty)
        s = solve_quadratic(q)
        y, gap = s.row_multipliers, q.rows @ s.x - q.right
        assert y[q.one_sided].min(initial=0.0) > -1e-6
        assert np.all(y[gap < -1e-5] == pytest.approx(penalty, rel=1e-5))
        assert np.all(np.abs(y[(gap > 1e-5) & q.one_sided]) < 1e-6)


def test_a_program_in_which_predictor_and_corrector_go_round_in_circles_is_solved():
    H = np.array([[3.07600762, -1.80433267], [-1.80433267, 1.47025114]])
    one = np.ones(2)
    q = QuadraticProgram(
        H, np.array([51.6268293, -6.31941361]), -0.42615301 * one, 6.29029932 * one,
        np.array([[-0.20562681, -0.12936378]]), np.array([-0.2691701]), np.array([1.10023347]), np.array([True]),
    )  # fmt: skip
    s = solve_quadratic(q)
    assert s.converged
    other = minimize(
        lambda x: cost(q, x),
        np.zeros(2),
        method="Nelder-Mead",
        bounds=[*zip(q.lower, q.upper, strict=True)],
        options={"xatol": 1e-9, "fatol": 1e-12},
    )
    assert s.x == pytest.approx(other.x, abs=1e-5)


def test_a_row_that_cannot_be_met_is_broken_at_its_price():
    one = np.ones(1)
    q = QuadraticProgram(np.eye(1), 0 * one, -one, one, np.eye(1), 3 * one, 0.5 * one, one > 2)
    assert solve_quadratic(q).x[0] == pytest.approx(0.5, abs=1e-6)


def test_without_unknowns_broken_rows_cost_their_price():
    penalty, none = np.array([2.0, 3.0, 4.0, 5.0]), np.zeros(0)
    q = QuadraticProgram(
        np.zeros((0, 0)), none, none, none, np.zeros((4, 0)), np.array([1.0, -1.0, 1.0, -1.0]), penalty,
        np.array([True, True, False, False]),
    )  # fmt: skip
    assert solve_quadratic(q).row_multipliers.tolist() == [2.0, 0.0, 4.0, -5.0]


def test_fixed_unknowns_stay():
    q = program(3)
    lower, upper = q.lower.copy(), q.upper.copy()
    lower[2] = upper[2] = 0.1
    fixed = QuadraticProgram(q.hessian, q.gradient, lower, upper, q.rows, q.right, q.penalty, q.one_sided)
    s = solve_quadratic(fixed)
    assert s.x[2] == 0.1
    assert cost(fixed, s.x) >= cost(q, solve_quadratic(q).x) - 1e-9


def test_no_rows_at_all():
    none = np.zeros(0)
    q = QuadraticProgram(
        np.diag([1.0, 2.0]),
        np.array([-3.0, 1.0]),
        -np.ones(2),
        np.ones(2),
        np.zeros((0, 2)),
        none,
        none,
        none > 0,
    )
    np.testing.assert_allclose(solve_quadratic(q).x, [1.0, -0.5], atol=1e-8)


@pytest.mark.parametrize("size", [1e-70, 1e-140, 1e-200])
@pytest.mark.parametrize("seed", range(4))
def test_rows_that_vanish_or_repeat_leave_the_minimum_and_no_warning(seed, size):
    """Their system is singular; LAPACK may divide by what is left of a pivot."""
    q = program(seed)
    one_sided = np.concatenate([q.one_sided, [False, False, False]])
    rows = np.vstack([q.rows, size * q.rows[:1], size * q.rows[:1], q.rows[:1]])
    right = np.concatenate([q.right, [0.0, 0.0], q.right[:1]])
    penalty = np.concatenate([q.penalty, [50.0] * 3])
    again = QuadraticProgram(q.hessian, q.gradient, q.lower, q.upper, rows, right, penalty, one_sided)
    alone = QuadraticProgram(
        q.hessian, q.gradient, q.lower, q.upper, np.vstack([q.rows, q.rows[:1]]), np.append(q.right, q.right[:1]),
        np.append(q.penalty, 50.0), np.append(q.one_sided, False),
    )  # fmt: skip
    assert cost(alone, solve_quadratic(again).x) == pytest.approx(
        cost(alone, solve_quadratic(alone).x), abs=1e-6
    )
