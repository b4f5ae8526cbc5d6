"""Outlines with an edge for every smooth piece: where they are cut, and that nothing else changes."""

import numpy as np
import pytest

from elastica_cad import Path, PlaneCurve, Profile, Rod, Sheet, Strip, optimal_rod
from elastica_cad.geometry import Arc, Line, Spline
from elastica_cad.strip import flat_pattern
from elastica_cad.strip.flat_pattern import MOST_SPANS, in_short_pieces, in_smooth_pieces

pytestmark = pytest.mark.core

SHEET = Sheet.named("birch-plywood-0.8")


def strip_of(points, degree=3):
    return Strip(optimal_rod(PlaneCurve.spline(points, degree=degree)), SHEET, max_width=30)


def two_arcs():
    """A curve whose curvature jumps, so that the width does."""
    turn, meet = 1.1, 50 * np.array([np.cos(np.pi - 1.1), np.sin(np.pi - 1.1)])
    a = Arc((0, 0), 50, np.pi, np.pi - turn).as_spline().curve
    b = Arc(meet - 90 * meet / 50, 90, np.pi - turn, np.pi - turn - 0.8).as_spline().curve
    weights = np.concatenate([a.weights / a.weights[-1], b.weights[1:] / b.weights[0]])
    points = np.vstack([a.control_points, b.control_points[1:]])
    return PlaneCurve(np.array([0, 0, 0, 1, 1, 2, 2, 2.0]), points, 2, weights)


def test_a_kink_becomes_a_corner_between_edges():
    strip = strip_of([(0, 0), (20, 50), (60, 70), (110, 60), (140, 20), (150, 0)])
    kinks = [s for s, continuity in strip.width.breaks if continuity < 1]
    assert len(kinks) == 2
    pieces = [s for s in in_smooth_pieces(strip.outline).segments if isinstance(s, Spline)]
    assert sorted({round(float(x), 6) for piece in pieces for x in (piece.start[0], piece.end[0])}) == (
        pytest.approx([0.0, *kinks, strip.rod.length], abs=1e-6)
    )
    for piece in pieces:
        curve = piece.curve
        inner, counts = np.unique(curve.knots[4:-4], return_counts=True)
        assert inner.size == 0 or counts.max() == 1


def test_nothing_moves():
    strip = strip_of([(0, 0), (20, 50), (60, 70), (110, 60), (140, 20), (150, 0)])
    cut = in_smooth_pieces(strip.outline)
    assert cut.area == pytest.approx(strip.outline.area, rel=1e-12)
    for piece in cut.segments:
        if isinstance(piece, Spline):
            x, y = piece.at(np.linspace(0, 1, 50)).T
            assert np.abs(np.abs(y) - strip.width(x) / 2).max() < 1e-9


def test_sides_without_slight_jumps_are_cut_and_not_fitted_anew(monkeypatch):
    strip = strip_of([(0, 0), (25, 55), (60, 45), (95, -50), (130, -40), (150, 0)], degree=4)
    assert min(continuity for _, continuity in strip.width.breaks) == 1

    def fitted(*_):
        raise AssertionError("a side is fitted anew")

    monkeypatch.setattr(flat_pattern, "interpolated", fitted)
    assert len(in_smooth_pieces(strip.outline).segments) > len(strip.outline.segments)


def test_a_ramp_becomes_a_step():
    strip = Strip(optimal_rod(two_arcs()), SHEET, max_width=30)
    (before, _), (after, _) = strip.width.breaks
    half = (after - before) / 2  # so far points move
    assert half == pytest.approx(5e-6 * strip.rod.length, rel=1e-3)
    assert half < flat_pattern.RAMP_FRACTION / 2 * strip.rod.length
    cut = in_smooth_pieces(strip.outline)
    steps = [s for s in cut.segments if isinstance(s, Line) and abs(s.start[0] - (before + after) / 2) < 1e-9]
    assert len(steps) == 2
    rise = abs(float(strip.width(after) - strip.width(before))) / 2
    for step in steps:
        assert step.start[0] == pytest.approx(step.end[0], abs=1e-12)
        assert step.length == pytest.approx(rise, rel=1e-4)
    assert cut.area == pytest.approx(strip.outline.area, rel=1e-9)


def test_a_jump_of_curvature_that_is_none_costs_no_edge():
    knots = np.array([0, 0, 0, 0, 40, 40, 100, 100, 100, 100.0])
    smooth = Profile(knots, 1 + np.array([0, 40 / 3, 80 / 3, 60, 80, 100]) / 50)
    strip = Strip(Rod.straight(100.0, smooth), SHEET, max_width=30)
    assert len(in_smooth_pieces(strip.outline).segments) == 8
    bent = Profile(knots, smooth.coefficients + np.array([0, 0.1, 0.1, 0.0, 0.4, 0.3]))
    assert len(in_smooth_pieces(Strip(Rod.straight(100.0, bent), SHEET, max_width=30).outline).segments) > 8


def test_a_smooth_outline_is_itself():
    strip = strip_of([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)], degree=4)
    assert in_smooth_pieces(strip.outline) is strip.outline
    circle = Path.circle((0, 0), 3)
    assert in_smooth_pieces(circle) is circle


def test_short_pieces_are_the_same_loop():
    outline = strip_of([(0, 0), (20, 50), (60, 70), (110, 60), (140, 20), (150, 0)]).outline
    short = in_short_pieces(outline)
    sides = [s for s in short.segments if isinstance(s, Spline)]
    assert len(sides) > sum(isinstance(s, Spline) for s in outline.segments)
    assert max(np.unique(s.curve.knots).size for s in sides) == MOST_SPANS + 1
    assert (short.area, short.length) == pytest.approx((outline.area, outline.length), rel=1e-9)
