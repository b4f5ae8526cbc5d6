"""Pen curves of any shape: healed within their digits, fair within the tolerance, without new inflections."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from elastica_cad import InputError, PlaneCurve
from elastica_cad.geometry.fairing import fair_curve, two_sided_distance
from elastica_cad.geometry.tangent_healing import LARGEST_REMOVED_RAD, heal_tangents

pytestmark = pytest.mark.core


@st.composite
def pen_curves(draw, least=2, most=4):
    """Cubics that share tangents at their nodes, turning by less than a right angle from node to node."""
    pieces = draw(st.integers(least, most))
    angle, node = draw(st.floats(-3, 3)), np.zeros(2)
    points = [node]
    for _ in range(pieces):
        length, turn = draw(st.floats(40, 150)), draw(st.floats(-1.4, 1.4))
        first, second = draw(st.floats(0.25, 0.45)), draw(st.floats(0.25, 0.45))
        chord = angle + turn * draw(st.floats(0.35, 0.65))
        end = node + length * np.array([np.cos(chord), np.sin(chord)])
        points.append(node + first * length * np.array([np.cos(angle), np.sin(angle)]))
        angle += turn
        points += [end - second * length * np.array([np.cos(angle), np.sin(angle)]), end]
        node = end
    knots = np.repeat(np.arange(pieces + 1.0), [4, *[3] * (pieces - 1), 4])
    return knots, np.array(points)


@pytest.mark.campaign
@settings(max_examples=40, deadline=None)
@given(drawn=pen_curves(), tolerance=st.sampled_from([0.02, 0.1, 1.0]))
def test_fair_curves_stay_within_the_tolerance_and_keep_their_ends(drawn, tolerance):
    curve = PlaneCurve(*drawn, 3)
    assume(not curve.tangent_breaks)
    try:
        fair = fair_curve(curve, tolerance)
    except InputError:
        assume(False)
    assert fair.moved <= tolerance
    assert two_sided_distance(curve, fair.curve, 3000) <= tolerance * 1.001
    assert min(b.continuity for b in fair.curve.breaks) >= 3
    bent = np.abs(curve.sample(400).curvature)
    if not curve.inflections.size and bent.min() > 0.25 * bent.max():
        assert not fair.curve.inflections.size
    ends = fair.curve.evaluate(np.array(fair.curve.domain))
    assert ends == pytest.approx(drawn[1][[0, -1]], abs=1e-9)


@pytest.mark.campaign
@settings(max_examples=25, deadline=None)
@given(drawn=pen_curves(most=3), degrees=st.floats(-180, 180), scale=st.floats(0.1, 30))
def test_fairing_follows_turns_and_scales(drawn, degrees, scale):
    curve = PlaneCurve(*drawn, 3)
    assume(not curve.tangent_breaks and not any(zero.kind == "flat" for zero in curve.curvature_zeros))
    c, s = scale * np.cos(np.radians(degrees)), scale * np.sin(np.radians(degrees))
    image = curve.transformed(np.array([[c, -s, 7.0], [s, c, -3.0], [0, 0, 1]]))
    try:
        here = fair_curve(curve, 0.1)
    except InputError:
        assume(False)
    there = fair_curve(image, 0.1 * scale)
    assert there.moved == pytest.approx(scale * here.moved, rel=0.02)
    assert there.curve.length == pytest.approx(scale * here.curve.length, rel=1e-5)


@settings(max_examples=60, deadline=None)
@given(drawn=pen_curves(), decimals=st.integers(0, 5), scale=st.sampled_from([1.0, 25.4 / 96, 25.4 / 72]))
def test_rounding_is_healed_wherever_it_is_small(drawn, decimals, scale):
    knots, points = drawn
    rounded = scale * np.round(points / scale, decimals)
    rounding = scale * 0.5 * 10.0**-decimals
    healing = heal_tangents(knots, rounded, 3, rounding=rounding)
    curve = PlaneCurve(healing.knots, healing.control_points, 3)
    assert not curve.tangent_breaks or all(turn.angle > LARGEST_REMOVED_RAD for turn in healing.undecided)
    assert len(curve.tangent_breaks) <= len(healing.undecided)
    assert healing.moved <= 4 * np.sqrt(2) * rounding
    assert healing.control_points[::3] == pytest.approx(rounded[::3], abs=0)


@settings(max_examples=40, deadline=None)
@given(drawn=pen_curves(), node=st.integers(1, 3), degrees=st.floats(2, 170), decimals=st.integers(3, 6))
def test_real_corners_are_never_healed(drawn, node, degrees, decimals):
    knots, points = drawn
    at = 3 * min(node, (len(points) - 1) // 3 - 1)
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    points[at + 1] = points[at] + (points[at + 1] - points[at]) @ np.array([[c, s], [-s, c]])
    healing = heal_tangents(knots, np.round(points, decimals), 3, rounding=0.5 * 10.0**-decimals)
    handles = healing.control_points[at - 1 : at + 2]
    before, after = np.diff(handles, axis=0)
    turn = np.degrees(abs(np.arctan2(before[0] * after[1] - before[1] * after[0], before @ after)))
    assert turn > 1.5
