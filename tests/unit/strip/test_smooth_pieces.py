"""Outlines with an edge for every smooth piece: where they are cut, and that nothing else changes."""

from itertools import pairwise

import numpy as np
import pytest

from elastica_cad import Path, Perforated, PlaneCurve, Sheet, Slot, Strip, optimal_rod
from elastica_cad.form_finding.fairing_request import smooth_curve
from elastica_cad.geometry import Arc, Line, Spline
from elastica_cad.geometry.splines import SplineFunction, interpolated, interpolation_sites
from elastica_cad.strip import flat_pattern
from elastica_cad.strip.flat_pattern import (
    MOST_SPANS,
    SIDE_PIECES,
    in_short_pieces,
    in_smooth_pieces,
)

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


def test_sides_with_few_jumps_are_cut_and_not_approximated(monkeypatch):
    strip = strip_of([(0, 0), (25, 55), (60, 45), (95, -50), (130, -40), (150, 0)], degree=4)
    assert min(continuity for _, continuity in strip.width.breaks) == 1

    def approximated(*_, **__):
        raise AssertionError("a side is approximated")

    monkeypatch.setattr(flat_pattern, "adaptive_spline", approximated)
    assert len(in_smooth_pieces(strip.outline).segments) > len(strip.outline.segments)


SKETCH = np.array([(0, 0), (70, 90), (150, 110), (240, -60), (330, -110), (400, 0.0)])
"""A cubic that has corners in its outline where its pieces meet."""


def smoothed_strip(points, smooth=1.0, **options):
    return Strip(
        optimal_rod(smooth_curve(PlaneCurve.spline(points, degree=3), smooth).curve), SHEET, **options
    )


def long_sides(path):
    return [segment for segment in path.segments if isinstance(segment, Spline)]


@pytest.mark.parametrize("smooth", [0.1, 0.5, 2.0])
def test_the_sides_of_a_smoothed_strip_have_as_many_edges_wherever_the_poles_are(smooth):
    for pole, move in ((0, (0, 0)), (1, (3, -2)), (2, (-4, 5)), (3, (2, 2)), (4, (-1, 3)), (5, (6, 1))):
        points = SKETCH.copy()
        points[pole] += move
        strip = smoothed_strip(points, smooth, max_width=40)
        outline = in_smooth_pieces(strip.outline)
        sides = long_sides(outline)
        assert (len(sides), len(outline.segments)) == (SIDE_PIECES, SIDE_PIECES + 6)
        forth, back = sides[: SIDE_PIECES // 2], sides[SIDE_PIECES // 2 :]
        for run, (start, end) in ((forth, (0, strip.rod.length)), (back, (strip.rod.length, 0))):
            assert [run[0].start[0], run[-1].end[0]] == pytest.approx([start, end])
            assert all(np.array_equal(one.end, other.start) for one, other in pairwise(run))
        assert outline.area == pytest.approx(strip.outline.area, rel=2e-7)
        for side in sides:
            x, y = side.at(np.linspace(0, 1, 101)).T
            assert np.abs(np.abs(y) - strip.width(x) / 2).max() < 0.005


def test_a_symmetric_wave_has_as_many_edges_as_one_beside_it():
    """Where the inflection is at a knot of the smoothed curve, the width has a kink."""
    wave = np.array([(0, 0), (60, 60), (130, 40), (200, -40), (270, -60), (330, 0.0)])
    counts = set()
    for off in (0.0, 0.5):
        strip = smoothed_strip(wave + np.eye(6, 1, -5) * [0, off], 0.5, max_width=40)
        counts.add(
            (any(order < 1 for _, order in strip.width.breaks), len(in_smooth_pieces(strip.outline).segments))
        )
    assert counts == {(True, SIDE_PIECES + 6), (False, SIDE_PIECES + 6)}


def test_the_holes_of_a_smoothed_strip_have_the_edges_of_their_drawing():
    points = [(0, 0), (90, 70), (180, 100), (270, 80), (360, -10)]
    strip = smoothed_strip(points, style=Perforated(width=40))
    edges = [segment for hole in strip.holes for segment in long_sides(hole)]
    assert any(np.unique(edge.curve.knots, return_counts=True)[1][1:-1].max(initial=0) == 2 for edge in edges)
    for hole in strip.holes:
        assert len(in_smooth_pieces(hole, 1).segments) == len(hole.segments)


def test_slots_and_the_sides_of_a_smoothed_strip_share_the_edges():
    slots = [Slot(at, 4.0, 2.0) for at in (60.0, 150.0, 270.0)]
    outline = smoothed_strip(SKETCH, max_width=40, slots=slots).outline
    between = len(long_sides(outline))
    assert between == 5
    assert len(long_sides(in_smooth_pieces(outline))) == 5 * between


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


def test_a_knot_at_which_the_curve_continues_smoothly_costs_no_edge():
    cubic = SplineFunction(np.repeat([0.0, 1.0], 4), np.array([(0, 0), (40, 60), (90, 50), (140, 0.0)]), 3)
    for inner in ([0.3], [0.2, 0.45, 0.9], [0.3, 0.31]):
        knots = np.sort([0.0] * 4 + inner + [1.0] * 4)
        sites = interpolation_sites(knots, 3)
        curve = PlaneCurve(knots, interpolated(sites, cubic(sites), knots, 3), 3)
        strip = Strip(optimal_rod(curve), SHEET, max_width=30)
        assert in_smooth_pieces(strip.outline) is strip.outline
    bent = PlaneCurve.spline([(0, 0), (40, 40), (60, 55), (90, 50), (140, 0)], 3)
    strip = Strip(optimal_rod(bent), SHEET, max_width=30)
    assert len(in_smooth_pieces(strip.outline).segments) == len(strip.outline.segments) + 2


def test_the_sides_of_an_arc_in_two_pieces_are_single_edges():
    corner = np.sqrt(0.5)
    half = PlaneCurve([0, 0, 0, 1, 1, 2, 2, 2], [(-60, 0), (-60, 60), (0, 60), (60, 60), (60, 0)], 2,
                      [1, corner, 1, corner, 1])  # fmt: skip
    strip = Strip(optimal_rod(half), SHEET, max_width=10)
    assert in_smooth_pieces(strip.outline) is strip.outline


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
