"""A curve cut to pieces, shuffled, turned round and nudged comes back as one curve."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from elastica_cad import PlaneCurve
from elastica_cad.formats.chains import curve_from_run, join_runs
from elastica_cad.formats.edges import Edge

pytestmark = pytest.mark.core

coordinate = st.floats(-100, 100)


@st.composite
def splines(draw):
    count = draw(st.integers(6, 10))
    x = 30.0 * np.arange(count)
    y = np.array(draw(st.lists(coordinate, min_size=count, max_size=count)))
    weights = np.array(draw(st.lists(st.floats(0.5, 2), min_size=count, max_size=count)))
    degree = draw(st.integers(2, 4))
    inner = np.arange(1.0, count - degree)
    knots = np.concatenate([np.zeros(degree + 1), inner, np.full(degree + 1, count - degree)])
    return PlaneCurve(knots, np.column_stack([x, y]), degree, weights)


@settings(max_examples=40, deadline=None)
@given(curve=splines(), seed=st.integers(0, 2**16))
def test_shuffled_pieces_make_the_curve_again(curve, seed):
    rng = np.random.default_rng(seed)
    pieces = []
    for h in curve.bezier_table[1]:
        knots = np.repeat([0.0, 1.0], curve.degree + 1)
        nudge = rng.uniform(-0.002, 0.002, 2)
        edge = Edge(knots, h[:, :2] / h[:, 2:] + nudge, curve.degree, h[:, 2])
        pieces.append((edge if rng.random() < 0.5 else edge.reversed(),))
    rng.shuffle(pieces)
    (run,) = join_runs(pieces, 0.01).chains
    back = curve_from_run(run)
    if np.hypot(*(back.evaluate(back.domain[0]) - curve.control_points[0])) > 1:
        back = back.reversed()
    assert abs(back.length - curve.length) < 1e-9 * curve.length
    assert not back.tangent_breaks
    gap = back.sample(50).position - curve.sample(50).position
    assert np.hypot(*gap.T).max() < 0.006 * len(pieces)


@settings(max_examples=40, deadline=None)
@given(curve=splines(), degree=st.integers(2, 5), shift=st.floats(0, 3))
def test_joined_curves_of_any_degree_stay_themselves(curve, degree, shift):
    end = curve.evaluate(curve.domain[1])
    points = end + np.column_stack([np.linspace(0, 90, degree + 1), shift * np.arange(degree + 1) ** 2])
    tail = Edge.bezier(points)
    head = Edge(curve.knots, curve.control_points, curve.degree, curve.weights)
    whole = curve_from_run((head, tail))
    tail_length = PlaneCurve(tail.knots, points, degree).length
    assert abs(whole.length - curve.length - tail_length) < 1e-9 * whole.length
    s = np.linspace(0, curve.length * (1 - 1e-9), 60)
    assert np.abs(whole.at(s).position - curve.at(s).position).max() < 1e-7
    inner = [b.continuity for b in whole.breaks if b.s < curve.length - 1e-6]
    assert inner == [b.continuity for b in curve.breaks]
