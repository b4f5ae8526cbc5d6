"""When a curve is smoothed, and that it stays within a tolerance measured from both sides."""

from threading import Event, Thread

import numpy as np
import pytest

from elastica_cad import InputError, PlaneCurve, check_equilibrium, optimal_rod
from elastica_cad.form_finding import fairing_request, smooth_curve
from elastica_cad.form_finding.rod_spec import RodSpec
from elastica_cad.geometry.fairing import (
    fair_curve,
    smooth_for_corners,
    two_sided_distance,
    usual_tolerance,
)
from elastica_cad.geometry.measured_points import Provenance
from elastica_cad.geometry.splines import elevate_degree
from elastica_cad.mechanics.theorem1 import begin_at, require_bendable

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
    assert smooth_curve(fair.curve).curve is fair.curve
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


def test_what_cannot_be_faired_is_reported():
    corner = pen((0, 0), (10, 0), (20, 0), (30, 0), (30, 10), (30, 20), (30, 30))
    with pytest.raises(InputError, match="corners"):
        fair_curve(corner, 0.1)
    with pytest.raises(InputError, match="positive distance"):
        fair_curve(ARCH, 0.0)
    with pytest.raises(InputError, match=r"set a smoothing distance of about .* or more"):
        fair_curve(ARCH, 1e-9)


def kinked(degrees, handle=30.0):
    """Two cubics whose tangent turns by so much where they meet."""
    turn = np.radians([degrees / 2, -degrees / 2])
    node = np.array([100.0, 60.0])
    into, out = (handle * np.array([np.cos(a), np.sin(a)]) for a in turn)
    points = np.array([(0, 0), (20, 40), node - into, node, node + out, (180, 40), (200, 0)])
    return PlaneCurve(np.repeat([0.0, 1.0, 2.0], [4, 3, 4]), points, 3)


@pytest.mark.parametrize("degrees", [0.002, 0.05, 0.115, 0.2])
def test_slight_corners_are_taken_out_within_what_was_requested(degrees):
    drawn = kinked(degrees)
    smooth = smooth_for_corners(drawn)
    assert smooth >= 0.9 * usual_tolerance(drawn)
    smoothing = smooth_curve(drawn, smooth)
    assert not smoothing.curve.tangent_breaks
    assert two_sided_distance(drawn, smoothing.curve, 20000) <= smoothing.moved <= smooth
    assert f"rounded corners of at most {degrees:.2g} degrees" in smoothing.notes[-1]
    assert not any("as drawn" in text for text in smoothing.notes), "no strip has corners"
    with pytest.raises(InputError, match=f"set smooth to about {smooth:g} mm to smooth it"):
        require_bendable(drawn)


def test_a_corner_that_would_take_more_stays_a_corner():
    """Within 0.01 mm a handle of 30 mm turns by 0.01 degrees; 2 degrees are no detail of a curve of 250 mm."""
    with pytest.raises(InputError, match=r"a corner .* from its start, at .*, of 0.115 degrees"):
        smooth_curve(kinked(0.115), 0.01)
    assert smooth_for_corners(kinked(2.0)) is None
    with pytest.raises(InputError, match=r"or split the curve there$"):
        require_bendable(kinked(2.0))
    with pytest.raises(InputError, match="of 6 degrees"):
        smooth_curve(kinked(6.0, handle=1.0), 0.5)


EGG = pen((150, 50), (200, 50), (240, 100), (240, 160), (240, 210), (200, 250), (150, 250),
          (100, 250), (60, 210), (60, 160), (60, 100), (100, 50), (150, 50))  # fmt: skip


def test_a_closed_pen_curve_is_fair_where_it_closes_too():
    """Seam on a jump: begun at the egg's widest place, where two of its pieces meet."""
    begun = begin_at(EGG, float(EGG.arc_length(np.array(1.0))))
    for drawn in (EGG, begun):
        fair = fair_curve(drawn, 0.1)
        assert 0 < fair.moved <= 0.1
        assert fair.curve.is_closed
        assert fair.curve.seam.continuity >= 3
        assert min(b.continuity for b in fair.curve.breaks) >= 3
        assert smooth_curve(fair.curve).curve is fair.curve
    assert begun.seam.continuity == 1
    alike = two_sided_distance(fair_curve(EGG, 0.1).curve, fair_curve(begun, 0.1).curve)
    assert alike < 0.05, "where the curve was begun moves it less than the tolerance"


def test_closed_curves_are_smoothed_where_their_width_would_step():
    assert 0 < smooth_curve(EGG).moved <= usual_tolerance(EGG)
    circle = PlaneCurve.arc((0, 0), 80, 0, 2 * np.pi)
    assert circle.seam.continuity >= 3
    assert smooth_curve(circle).moved == 0


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
    assert "rounded corners" in smoothing.notes[-1]


def test_a_real_corner_where_a_curve_closes_is_refused_with_its_place_as_drawn():
    points = EGG.control_points.copy()
    points[1] += (0, 30)
    drawn = pen(*points).drawn_as(Provenance(place=np.diag([1.0, -1.0, 1.0])))
    with pytest.raises(InputError, match=r"closed curve has a corner of 31 degrees at \(150, -50\) mm"):
        require_bendable(drawn)
    with pytest.raises(InputError, match="closed curve has a corner"):
        smooth_curve(drawn, 1.0)
    with pytest.raises(InputError, match="with corners cannot be smoothed"):
        fair_curve(drawn, 1.0)


JUMPS = [(0, 0), (0, 60), (40, 100), (100, 100), (150, 100), (200, 70), (200, 0)]


def with_handle(length):
    """Two pieces whose curvatures are equal where they meet if the handle behind it is 60 mm long."""
    return pen((0, 0), (0, 60), (40, 100), (100, 100), (100 + length, 100), (200, 60), (200, 0))


def step_of(drawn):
    """Largest step of the width of the strip along the curve as drawn, as a fraction."""
    rod = optimal_rod(drawn)
    low, high = np.sort(rod.profile(np.array(rod.profile.steps or [(0.0, 0.0)])), axis=1).T
    return float((1 - low / high).max())


@pytest.mark.parametrize("length", [50, 59.7, 59.99, 60, 60.3, 70])
def test_a_curve_with_a_step_or_a_corner_is_smoothed(length):
    drawn = with_handle(length)
    assert min(knot.continuity for knot in drawn.breaks) == (2 if length == 60 else 1)
    smoothing = smooth_curve(drawn)
    assert smoothing.moved > 0
    assert step_of(smoothing.curve) == 0


@pytest.mark.parametrize(("second", "smoothed"), [(100.5, False), (101.5, False), (103, True), (130, True)])
def test_a_step_without_a_corner_is_smoothed_from_two_percent_on(second, smoothed):
    """Two arcs, whose curvatures do not change within the arcs."""
    points = [(-100, 0), (-100, 100), (0, 100), (second, 100), (second, 100 - second)]
    drawn = PlaneCurve([0, 0, 0, 1, 1, 2, 2, 2], points, 2, [1, np.sqrt(0.5), 1, np.sqrt(0.5), 1])
    assert (smooth_curve(drawn).moved > 0) == smoothed


def test_the_decision_is_by_continuity_whatever_the_degree():
    jumps = pen(*JUMPS)
    raised = PlaneCurve(*elevate_degree(jumps.knots, jumps.control_points, 3, None)[:2], 4)
    assert smooth_curve(raised).moved == pytest.approx(smooth_curve(jumps).moved, rel=1e-6)
    cubic = PlaneCurve.spline([(0, 0), (60, 120), (140, 160), (240, 120), (300, 0)], 3)
    assert [b.continuity for b in cubic.breaks] == [2]
    assert smooth_curve(cubic).moved > 0
    quartic = PlaneCurve.spline([(0, 0), (60, 120), (140, 160), (240, 120), (270, 60), (300, 0)], 4)
    assert [b.continuity for b in quartic.breaks] == [3]
    assert smooth_curve(quartic).moved == 0


def test_a_cubic_with_corners_in_its_outline_is_smoothed():
    cubic = PlaneCurve.spline([(0, 0), (60, 120), (140, 160), (240, 120), (300, 0)], 3)
    smoothing = smooth_curve(cubic)
    assert 0 < smoothing.moved <= usual_tolerance(cubic)
    assert "or had a kink" in smoothing.notes[0]
    warned = [
        any("have a corner" in text for text in check_equilibrium(curve).warnings)
        for curve in (cubic, smoothing.curve)
    ]
    assert warned == [True, False]
    assert smooth_curve(cubic, 0).curve is cubic


def test_a_slope_that_jumps_in_an_inflection_is_smoothed():
    """The width steps there, although the curvature is continuous."""
    right = np.array([(0, 0), (30, 0), (60, 0), (90, 40)], dtype=float)
    drawn = pen(*(-0.9 * right[:0:-1]), *right)
    (node,) = drawn.breaks
    assert node.continuity == 2
    assert step_of(drawn) > 0.02
    assert smooth_curve(drawn).moved > 0


def test_a_curve_whose_ratio_smoothing_would_enlarge_stays_as_drawn():
    points = np.array(
        [(3.9, -1.8), (-2.7, 62.9), (35.8, 94.4), (102.9, 114.8), (0, 0), (193.0, 62.0), (203.1, 5.1)]
    )
    points[4] = points[3] + 0.57 * (points[3] - points[2])
    drawn = pen(*points)
    assert step_of(drawn) > 0.02
    assert optimal_rod(fair_curve(drawn, usual_tolerance(drawn)).curve).ratio > 1.1 * optimal_rod(drawn).ratio
    assert smooth_curve(drawn).curve is drawn


def scattered(rng):
    """Pieces that meet with a jump of the curvature."""
    points = np.array(JUMPS) + rng.normal(0, 6, (7, 2))
    points[4] = points[3] + (points[3] - points[2]) * rng.uniform(0.5, 1.2)
    return pen(*points)


@pytest.mark.campaign
def test_smoothing_adds_no_inflection_and_narrows_no_strip():
    """Of 60 pen curves some would be spoilt by 10 % or more, and stay as drawn."""
    rng = np.random.default_rng(1)
    left = 0
    for _ in range(60):
        drawn = scattered(rng)
        smoothing = smooth_curve(drawn)
        before, after = smoothing.ratio_as_drawn, smooth_curve(smoothing.curve).ratio_as_drawn
        assert len(smoothing.curve.inflections) <= len(drawn.inflections)
        assert before is None or after < 1.1 * before
        left += not smoothing.moved
    assert 0 < left < 30


def test_a_curve_that_smoothing_gives_more_inflections_stays_as_drawn():
    """Of three inflections, with jumps of the curvature beside them: smoothed it has five."""
    heights = (-7.84, 28.22, 16.81, -12.2, -30.58, -12.92, 11.2, 32.99, 18.35, -32.34, -19.84, 12.2)
    control = np.column_stack([np.linspace(0.0, 300.0, 12), heights])
    drawn = PlaneCurve([0] * 4 + [1, 1, 2, 2, 3, 3, 4, 4] + [5] * 4, control, 3)
    faired = fair_curve(drawn, usual_tolerance(drawn)).curve
    assert (len(drawn.inflections), len(faired.inflections)) == (3, 5)
    assert smooth_curve(drawn).curve is drawn


def test_a_curve_without_kinks_stays_within_the_tolerance():
    smooth = PlaneCurve.spline([(0, 0), (30, 60), (80, 70), (120, 40), (160, 10)], degree=4)
    assert not smooth.breaks
    assert fair_curve(smooth, 0.1).moved <= 0.1


def test_a_curve_is_checked_while_another_thread_smooths_one(monkeypatch):
    """Up to Python 3.11 a cached property has one lock for all objects; two of them stopped FreeCAD for ever."""
    smooths, checks = Event(), Event()
    examined = RodSpec.examined

    def examine(spec, *tolerance):
        checks.set()
        return examined(spec, *tolerance)

    def fair(*arguments):
        smooths.set()
        checks.wait(60)
        return fair_curve(*arguments)

    monkeypatch.setattr(RodSpec, "examined", examine)
    monkeypatch.setattr(fairing_request, "fair_curve", fair)
    first, second = RodSpec(ARCH), RodSpec(S_NODE)
    threads = [
        Thread(target=work, daemon=True) for work in (lambda: first.curve_to_bend, lambda: second.check)
    ]
    threads[0].start()
    assert smooths.wait(60)
    threads[1].start()
    for thread in threads:
        thread.join(60)
    assert not any(thread.is_alive() for thread in threads)
