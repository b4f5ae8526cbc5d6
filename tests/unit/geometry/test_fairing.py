"""Pen curves are made fair within a tolerance that is measured from both sides."""

import numpy as np
import pytest

from elastica_cad.errors import InputError
from elastica_cad.forming.fairing_request import smooth_curve
from elastica_cad.geometry.curve_editing.fairing import (
    fair_curve,
    has_rough_curvature,
    smooth_for_corners,
    two_sided_distance,
    usual_tolerance,
)
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.pen_curves.provenance import Provenance
from elastica_cad.mechanics.stiffness.optimal_rod import optimal_rod
from elastica_cad.mechanics.theorem1.curvature_conditions import begin_at, require_bendable
from elastica_cad.mechanics.theorem1.equilibrium_check import check_equilibrium

pytestmark = pytest.mark.core


def pen(*points):
    pieces = (len(points) - 1) // 3
    knots = np.repeat(np.arange(pieces + 1.0), [4, *[3] * (pieces - 1), 4])
    return PlaneCurve(knots, points, 3)


ARCH = pen((0, 0), (0, 60), (40, 100), (100, 100), (150, 100), (200, 70), (200, 0))
S_NODE = pen((0, 0), (30, 60), (80, 70), (120, 40), (160, 10), (200, 10), (240, 60))


@pytest.mark.parametrize("tolerance", [0.005, 0.02, 0.1, 0.5, 3.0])
@pytest.mark.parametrize("drawn", [ARCH, S_NODE])
def test_curvature_and_its_slope_become_continuous_within_the_tolerance(drawn, tolerance):
    fair = fair_curve(drawn, tolerance)
    assert 0 < fair.moved <= tolerance
    dense = drawn.sample(20001).position
    from_fair = [np.hypot(*(dense - p).T).min() for p in fair.curve.sample(400).position]
    assert max(from_fair) <= tolerance + drawn.length / 20000
    assert all(b.continuity >= 3 for b in fair.curve.breaks)
    assert not has_rough_curvature(fair.curve)
    ends = np.array([0.0, 1.0])
    here, there = fair.curve.at(ends * fair.curve.length), drawn.at(ends * drawn.length)
    assert here.position == pytest.approx(there.position, abs=1e-12)
    assert here.angle == pytest.approx(there.angle, abs=1e-12)


def test_the_width_no_longer_steps_and_the_ratio_falls():
    drawn = pen((0, 0), (0, 60), (40, 100), (100, 100), (130, 100), (200, 70), (200, 0))
    before, after = optimal_rod(drawn), optimal_rod(fair_curve(drawn, 0.1).curve)
    jumps = [np.abs(np.diff(r.curvature)).max() / np.abs(r.curvature).max() for r in (before, after)]
    assert jumps[0] > 0.1
    assert jumps[1] < 0.03
    assert after.ratio < before.ratio


def test_bending_that_was_reversed_by_a_jump_can_be_bent_after():
    assert check_equilibrium(S_NODE).jumps
    check = check_equilibrium(fair_curve(S_NODE, 0.1).curve)
    assert check.realizable
    assert len(check.inflections) == 1


def test_a_curve_scaled_is_faired_alike():
    small = fair_curve(ARCH, 0.1)
    large = fair_curve(ARCH.transformed(np.diag([1000.0, 1000.0, 1.0])), 100.0)
    assert large.moved == pytest.approx(1000 * small.moved, rel=1e-3)


def test_distance_from_both_sides_sees_what_one_side_misses():
    line = PlaneCurve.line((0, 0), (100, 0))
    longer = PlaneCurve.line((0, 0), (103, 0))
    assert two_sided_distance(line, longer) == pytest.approx(3.0)


def test_what_cannot_be_faired_is_told():
    corner = pen((0, 0), (10, 0), (20, 0), (30, 0), (30, 10), (30, 20), (30, 30))
    with pytest.raises(InputError, match="corners"):
        fair_curve(corner, 0.1)
    with pytest.raises(InputError, match="positive distance"):
        fair_curve(ARCH, 0.0)
    with pytest.raises(InputError, match="allow more"):
        fair_curve(ARCH, 1e-9)


def kinked(degrees, handle=30.0):
    """Two cubics whose tangent turns by so much where they meet."""
    turn = np.radians([degrees / 2, -degrees / 2])
    node = np.array([100.0, 60.0])
    into, out = (handle * np.array([np.cos(a), np.sin(a)]) for a in turn)
    points = np.array([(0, 0), (20, 40), node - into, node, node + out, (180, 40), (200, 0)])
    return PlaneCurve(np.repeat([0.0, 1.0, 2.0], [4, 3, 4]), points, 3)


@pytest.mark.parametrize("degrees", [0.002, 0.05, 0.115, 0.2])
def test_slight_corners_are_taken_out_within_what_was_asked_for(degrees):
    drawn = kinked(degrees)
    smooth = smooth_for_corners(drawn)
    assert smooth >= 0.9 * usual_tolerance(drawn)
    smoothing = smooth_curve(drawn, smooth)
    assert not smoothing.curve.tangent_breaks
    assert two_sided_distance(drawn, smoothing.curve, 20000) <= smoothing.moved <= smooth
    assert f"corners, of {degrees:.2g} degrees at most, were rounded" in smoothing.notes[-1]
    with pytest.raises(InputError, match=rf"take it out within {smooth:g} mm \(smooth = {smooth:g}, "):
        require_bendable(drawn)


def test_a_corner_that_would_take_more_stays_a_corner():
    """Within 0.01 mm a handle of 30 mm turns by 0.01 degrees; 2 degrees are no detail of a curve of 250 mm."""
    with pytest.raises(InputError, match=r"a corner at .* of 0.115 degrees"):
        smooth_curve(kinked(0.115), 0.01)
    assert smooth_for_corners(kinked(2.0)) is None
    with pytest.raises(InputError, match=r"or draw two curves$"):
        require_bendable(kinked(2.0))
    with pytest.raises(InputError, match="of 6 degrees"):
        smooth_curve(kinked(6.0, handle=1.0), 0.5)


EGG = pen((150, 50), (200, 50), (240, 100), (240, 160), (240, 210), (200, 250), (150, 250),
          (100, 250), (60, 210), (60, 160), (60, 100), (100, 50), (150, 50))  # fmt: skip


def test_a_closed_pen_curve_is_fair_where_it_closes_too():
    """Seam on a jump: begun at the egg's widest place, where two of its pieces meet."""
    begun = begin_at(EGG, float(EGG.arc_length(np.array(1.0))))
    for drawn in (EGG, begun):
        assert has_rough_curvature(drawn)
        fair = fair_curve(drawn, 0.1)
        assert 0 < fair.moved <= 0.1
        assert fair.curve.is_closed
        assert fair.curve.seam.continuity == 3
        assert min(b.continuity for b in fair.curve.breaks) >= 3
        assert not has_rough_curvature(fair.curve)
    assert begun.seam.continuity == 1
    alike = two_sided_distance(fair_curve(EGG, 0.1).curve, fair_curve(begun, 0.1).curve)
    assert alike < 0.05, "where the curve was begun moves it less than the tolerance"


def test_only_pen_curves_that_close_are_moved_unasked():
    drawn = EGG.drawn_as(Provenance("pen"))
    assert 0 < smooth_curve(drawn).moved <= usual_tolerance(drawn)
    assert smooth_curve(EGG).moved == 0
    circle = PlaneCurve.arc((0, 0), 80, 0, 2 * np.pi)
    assert circle.seam.continuity >= 3
    assert smooth_curve(circle.drawn_as(Provenance("pen"))).moved == 0


@pytest.mark.parametrize("degrees", [0.01, 0.1])
def test_slight_corners_of_a_closed_curve_go_wherever_they_are(degrees):
    points = EGG.control_points.copy()
    points[1] += 50 * np.array([0, np.sin(np.radians(degrees))])  # the seam
    points[4] += 50 * np.array([np.sin(np.radians(degrees)), 0])
    drawn = pen(*points)
    assert np.degrees(abs(drawn.seam_turn)) == pytest.approx(degrees, rel=1e-3)
    assert drawn.has_corners
    smooth = smooth_for_corners(drawn)
    smoothing = smooth_curve(drawn, smooth)
    assert smoothing.curve.is_closed
    assert not smoothing.curve.has_corners
    assert two_sided_distance(drawn, smoothing.curve, 20000) <= smoothing.moved <= smooth
    assert "were rounded within that" in smoothing.notes[-1]


def test_a_real_corner_where_a_curve_closes_is_refused_with_its_place_as_drawn():
    points = EGG.control_points.copy()
    points[1] += (0, 30)
    drawn = pen(*points).drawn_as(Provenance("pen", place=np.diag([1.0, -1.0, 1.0])))
    with pytest.raises(InputError, match=r"closed with a corner of 31 degrees at \(150, -50\) mm"):
        require_bendable(drawn)
    with pytest.raises(InputError, match="closed with a corner"):
        smooth_curve(drawn, 1.0)
    with pytest.raises(InputError, match="with corners cannot be made fair"):
        fair_curve(drawn, 1.0)


def test_a_spline_drawn_by_poles_gets_a_continuous_slope_of_curvature_unasked():
    cubic = PlaneCurve.spline([(0, 0), (60, 120), (140, 160), (240, 120), (300, 0)], 3)
    assert [b.continuity for b in cubic.breaks] == [2]
    assert smooth_curve(cubic).moved == 0
    fair = smooth_curve(cubic.drawn_as(Provenance("poles")))
    assert 0 < fair.moved <= 0.1
    assert all(b.continuity >= 3 for b in fair.curve.breaks)
    (told,) = fair.notes
    assert told.values["degree"] == 3
    quartic = PlaneCurve.spline(cubic.control_points, 4).drawn_as(Provenance("poles"))
    assert smooth_curve(quartic).moved == 0
