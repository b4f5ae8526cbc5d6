"""Rods that are not yet in balance: what is told about them before they are closed, and where they close."""

import numpy as np
import pytest

from elastica_cad import Limits, PlaneCurve, nearest_rod
from elastica_cad.form_finding.constraints import EndPosition
from elastica_cad.form_finding.curve_distance import LargestDistance, MeanDistance, TargetCurve
from elastica_cad.form_finding.rod_map import StiffnessBasis, StripGrid
from elastica_cad.form_finding.rod_problem import RodProblem
from elastica_cad.form_finding.sqp import close_iterate, follow_step, iterate_at, meet_equalities

pytestmark = pytest.mark.core

EDGES = 100


def arch(distance="mean"):
    """A rod in balance with its end kept, and a problem around it."""
    grid = StripGrid(StiffnessBasis(8).at(np.linspace(0, 1, EDGES + 1)), np.array([0.5, 2.0]))
    u = grid.unknowns
    z = np.ones(u.count)
    z[u.stiffness] = np.linspace(1, 2, 8)
    z[u.moment], z[u.force], z[u.angle] = -3.0, (4.0, -7.0), 1.2
    z[u.position] -= grid.shoot(z).position.mean(axis=0)
    rod = grid.shoot(z)
    off = 0.02 * np.sin(np.linspace(0, 9, 2 * (EDGES + 1))).reshape(-1, 2)
    lower, upper = np.full(u.count, -np.inf), np.full(u.count, np.inf)
    lower[u.stiffness], upper[u.stiffness] = 1.0, 3.0
    lower[u.position] = upper[u.position] = rod.position[0]
    lower[u.length] = upper[u.length] = 1.0
    if distance == "mean":
        measure = MeanDistance(rod.position + off, np.full(EDGES + 1, 1 / (EDGES + 1)))
    else:
        wish = PlaneCurve.fit(100 * (rod.position + off[::-1, :1]), degree=4, tolerance=0.1)
        measure = LargestDistance(TargetCurve.of(wish), np.ones(EDGES + 1))
    end = EndPosition(target=tuple(rod.position[-1].tolist()))
    scale = np.ones(u.count)
    return RodProblem(lower, upper, scale, grid=grid, distance=measure, constraints=(end,)), rod


def disturbed(problem, rod, size):
    """The rod out of balance by `size` radians."""
    s = np.linspace(0, 1, EDGES + 2)
    return problem.grid.assemble(
        rod.z, rod.all_angles + size * np.sin(5 * s), rod.moments + size * np.cos(7 * s[1:])
    )


@pytest.mark.parametrize("measure", ["mean", "max"])
def test_a_place_reports_the_closed_rod_to_second_order(measure):
    problem, rod = arch(measure)
    errors = []
    for size in (1e-2, 1e-3):
        here = meet_equalities(iterate_at(problem, disturbed(problem, rod, size)))
        closed = close_iterate(here, here.equalities)
        assert np.abs(closed.position[-1] - rod.position[-1]).max() < 1e-9
        assert 0.5 * size < here.defect < 20 * size
        errors.append(abs(here.objective - problem.distance.value(closed)))
    assert errors[1] < errors[0] / 50 + 1e-12


def test_closed_rods_are_marched_ones():
    problem, rod = arch()
    here = meet_equalities(iterate_at(problem, disturbed(problem, rod, 0.05)))
    closed = close_iterate(here, here.equalities)
    again = problem.grid.shoot(closed.z)
    np.testing.assert_array_equal(closed.all_angles, again.all_angles)
    np.testing.assert_array_equal(closed.z[problem.grid.unknowns.position], rod.position[0])


def test_what_follows_a_step_holds_what_is_held():
    problem, rod = arch()
    here = iterate_at(problem, rod)
    step = np.zeros(rod.z.size + 1)
    step[problem.grid.unknowns.stiffness], step[-1] = 0.3, 1.0
    reached = follow_step(here, step, here.equalities, 1e-9, 1.0)
    assert reached.defect < 1e-4
    closed = close_iterate(reached, here.equalities)
    assert np.abs(closed.position[-1] - rod.position[-1]).max() < 1e-9
    assert closed.stiffness.mean() > rod.stiffness.mean() + 0.1
    assert follow_step(here, 1e4 * step, here.equalities, 1e-9, 1.0) is None


@pytest.mark.campaign
@pytest.mark.parametrize("seed", [58, 73, 101, 102])
def test_wishes_beyond_all_rods_end_quietly(seed):
    """Steep random curves: no warning, a rod in balance, an honest status."""
    rng = np.random.default_rng(seed)
    m = int(rng.integers(4, 10))
    points = np.column_stack([np.linspace(0, 200, m) + rng.normal(size=m) * 15, rng.normal(size=m) * 60])
    near = nearest_rod(PlaneCurve.spline(points, degree=3), Limits(ratio=1.3, margin=5.0))
    assert near.rod.residual < 1e-9
    assert near.met == (near.violation <= 1e-6)
