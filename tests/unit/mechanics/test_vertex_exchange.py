"""Exchanged vertices against HiGHS: the same optima, and none where there is none."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from elastica_cad.mechanics.stiffness.minimax_lp import minimax_ratio
from elastica_cad.mechanics.stiffness.vertex_exchange import VertexExchange

pytestmark = pytest.mark.core


def program(rows, offset):
    """1 <= rows @ x + offset <= R as `VertexExchange` takes it."""
    exchange = VertexExchange(rows.shape[1])
    exchange.add(np.vstack([rows, rows]), np.concatenate([offset - 1, offset]), len(rows))
    return exchange


@pytest.mark.campaign
@given(st.integers(0, 2**32 - 1), st.integers(5, 150), st.integers(1, 4), st.booleans(), st.booleans())
@settings(max_examples=150, deadline=None)
def test_the_optimum_is_that_of_the_library(seed, count, unknowns, dead_weight, bounded):
    rng = np.random.default_rng(seed)
    rows = rng.normal(size=(count, unknowns)) + np.r_[3.0, np.zeros(unknowns - 1)]
    offset = rng.normal(size=count) * dead_weight
    side = rng.normal(size=(1, unknowns)) if bounded else None
    ours = minimax_ratio(rows, offset=offset, side_rows=side)
    theirs = minimax_ratio(rows, offset=offset, side_rows=side, solver="scipy")
    assert (ours is None) == (theirs is None)
    if ours is not None:
        assert ours.ratio == pytest.approx(theirs.ratio, rel=1e-9)
        assert ours.values.min() >= 1 - 1e-9


def test_conditions_that_come_later_move_the_vertex_on():
    s = np.linspace(0.0, 1.0, 101)
    rows = np.column_stack([1 + s, 1 + s**2])
    whole = program(rows, np.zeros(101)).solve()
    exchange = program(rows[::20], np.zeros(6))
    assert exchange.solve()[-1] <= whole[-1]
    rest = np.delete(rows, np.s_[::20], axis=0)
    exchange.add(np.vstack([rest, rest]), np.r_[np.full(len(rest), -1.0), np.zeros(len(rest))], len(rest))
    assert exchange.solve() == pytest.approx(whole, rel=1e-9)


def test_no_vertex_where_nothing_meets_the_conditions():
    s = np.linspace(-1.0, 1.0, 20)
    assert program(np.column_stack([s, s**3]), np.zeros(20)).solve() is None


def test_no_vertex_of_an_unbounded_program():
    exchange = VertexExchange(2)
    exchange.add(np.array([[1.0, 0.0]]), np.array([-1.0]), 1)
    assert exchange.solve() is None
