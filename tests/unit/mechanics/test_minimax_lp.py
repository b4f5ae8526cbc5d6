"""The row-generated program against the whole one, and against answers known by hand."""

import subprocess
import sys

import numpy as np
import pytest
from scipy.optimize import linprog

from elastica_cad.mechanics import minimax_lp
from elastica_cad.mechanics.minimax_lp import least_variation, minimax_ratio
from elastica_cad.paper.sampled_lp import sampled_stiffness
from tests.refusals import refusal_test

pytestmark = pytest.mark.core


def whole_program(rows, offset):
    """All rows at once, by scipy."""
    n, m = rows.shape
    matrix = np.block([[-rows, np.zeros((n, 1))], [rows, -np.ones((n, 1))]])
    limit = np.concatenate([offset - 1, -offset])
    result = linprog(np.eye(m + 1)[-1], matrix, limit, bounds=(None, None), method="highs")
    return result.x[-1] if result.status == 0 else None


def ellipse_rows(n, a=2.0, b=1.0):
    u = np.linspace(0.0, np.pi, n)
    curvature = a * b / (a**2 * np.sin(u) ** 2 + b**2 * np.cos(u) ** 2) ** 1.5
    return np.column_stack([np.ones(n), a * np.cos(u), b * np.sin(u)]) / curvature[:, None]


@pytest.fixture(params=["exchanged", "highspy", "scipy"])
def solver(request, monkeypatch):
    """The exchange of vertices as usual, or HiGHS in its place, which inside FreeCAD is scipy's."""
    if request.param != "exchanged":
        monkeypatch.setattr(minimax_lp, "METHOD", minimax_lp.Exchange(most=0))
    if request.param == "scipy":
        monkeypatch.setitem(sys.modules, "highspy", None)


@pytest.mark.usefixtures("solver")
@pytest.mark.parametrize("n", [9, 200, 2001])
def test_ellipse_matches_the_whole_program(n):
    rows = ellipse_rows(n)
    solution = minimax_ratio(rows)
    assert solution.ratio == pytest.approx(whole_program(rows, np.zeros(n)), rel=1e-9)
    assert solution.values.min() == pytest.approx(1.0, abs=1e-9)
    assert solution.values.max() == pytest.approx(solution.ratio, rel=1e-9)


@pytest.mark.parametrize("seed", range(8))
def test_random_programs_match_the_whole_one(seed):
    rng = np.random.default_rng(seed)
    s = np.linspace(0, 1, 301)
    rows = np.column_stack([1 + s, np.cos(5 * s + rng.random()), rng.normal(size=3) @ [s, s**2, s**3]])
    offset = rng.normal() * np.sin(3 * s)
    ours, theirs = minimax_ratio(rows, offset=offset), whole_program(rows, offset)
    assert ours.ratio == pytest.approx(theirs, rel=1e-8)


def test_scales_of_the_columns_do_not_matter():
    rows = ellipse_rows(400)
    solution = minimax_ratio(rows * [1e9, 1e-6, 1e3])
    assert solution.ratio == pytest.approx(minimax_ratio(rows).ratio, rel=1e-9)


@pytest.mark.usefixtures("solver")
def test_infeasible_is_none():
    s = np.linspace(-1, 1, 50)
    assert minimax_ratio(np.column_stack([s, s**3])) is None


@pytest.mark.usefixtures("solver")
@pytest.mark.parametrize("bounded", [False, True])
@pytest.mark.parametrize("unknowns", [1, 2, 3, 4])
def test_the_optimum_is_that_of_the_whole_program(unknowns, bounded):
    for seed in range(12):
        rng = np.random.default_rng(seed)
        count = int(rng.integers(5, 150))
        rows = rng.normal(size=(count, unknowns)) + np.r_[3.0, np.zeros(unknowns - 1)]
        offset, side = rng.normal(size=count), rng.normal(size=(1, unknowns))
        found = minimax_ratio(rows, offset=offset, side_rows=side if bounded else None)
        if found is None:
            assert bounded or whole_program(rows, offset) is None
            continue
        assert found.values.min() >= 1 - 1e-9
        assert side @ found.x > -1e-9 or not bounded
        if not bounded:
            assert found.ratio == pytest.approx(whole_program(rows, offset), rel=1e-9)


def test_one_number_has_nothing_to_optimise():
    assert minimax_ratio(np.array([[-2.0], [-4.0]])).ratio == 2.0
    assert minimax_ratio(np.array([[1.0], [-1.0]])) is None


def test_no_number_takes_the_offset_as_it_is():
    empty = np.zeros((3, 0))
    assert minimax_ratio(empty, offset=np.array([1.0, 2.0, 1.5])).ratio == 2.0
    assert minimax_ratio(empty, offset=np.array([0.5, 2.0, 1.5])) is None


def test_side_rows_bind():
    s = np.linspace(0, 1, 60)
    rows = np.column_stack([1 + s, 1 - s])
    free = minimax_ratio(rows)
    bound = minimax_ratio(rows, side_rows=np.array([[0.0, -1.0]]))
    assert free.ratio == pytest.approx(1.0)
    assert bound.x[1] <= 1e-9
    assert bound.ratio == pytest.approx(2.0)
    near = minimax_ratio(rows, side_rows=np.array([[0.0, -1.0]]), side_offset=np.array([0.25]))
    assert near.x == pytest.approx([0.75, 0.25])


test_sampled_stiffness_refuses_samples_on_inflections = refusal_test(
    [
        (
            lambda: sampled_stiffness([(0, 0), (1, 0), (2, 1)], [0.1, 0.0, 0.1]),
            "leave out samples at inflections",
        ),
        (lambda: sampled_stiffness([(0, 0), (1, 0)], [0.1, 0.2, 0.3]), "positions"),
    ],
    kind=ValueError,
)


@pytest.mark.parametrize("numbers", [1, 2, 3, 4])
@pytest.mark.parametrize("seed", range(3))
def test_least_variation_is_that_of_the_program_as_it_is_written(numbers, seed):
    """Section 5.3: sum |bends x + offset| with slack variables, against the descent along edges."""
    rng = np.random.default_rng(seed)
    rows, bends = rng.normal(size=(200, numbers)), rng.normal(size=(150, numbers))
    start, bend_offset = rng.normal(size=numbers), rng.normal(size=150)
    offset = rng.uniform(1.2, 2.8, 200) - rows @ start
    x = least_variation(rows, offset, bends, bend_offset, 3.0, start)
    stiffness = rows @ x + offset
    assert stiffness.min() > 1 - 1e-7
    assert stiffness.max() < 3 + 1e-7
    slack, none = np.eye(150), np.zeros((200, 150))
    matrix = np.block([[-rows, none], [rows, none], [bends, -slack], [-bends, -slack]])
    limit = np.concatenate([offset - 1, 3 - offset, -bend_offset, bend_offset])
    cost, bounds = np.repeat([0.0, 1.0], [numbers, 150]), [(None, None)] * numbers + [(0, None)] * 150
    whole = linprog(cost, matrix, limit, bounds=bounds, method="highs")
    assert np.abs(bends @ x + bend_offset).sum() == pytest.approx(whole.fun, rel=1e-8)


def test_highs_is_silent():
    """Of late it prints its name as it is made, past Python, into what programs read."""
    words = (
        "import numpy as np; from elastica_cad.mechanics import minimax_lp; "
        "minimax_lp.METHOD = minimax_lp.Exchange(most=0); "
        "minimax_lp.minimax_ratio(np.linspace((1, -1, 1), (1, 1, 2), 9))"
    )
    ran = subprocess.run([sys.executable, "-c", words], capture_output=True, text=True, check=True)
    assert ran.stdout == ran.stderr == ""
