"""Theorem 1 on curves whose verdict is known."""

import json
import re

import numpy as np
import pytest

from elastica_cad import End, InputError, NotRealizable, PlaneCurve, Supports, check_equilibrium
from elastica_cad.geometry.splines import fit_spline
from elastica_cad.mechanics import InflectionLine
from elastica_cad.mechanics.equilibrium_check import find_separating_line, fit_inflection_line

pytestmark = pytest.mark.core

ARC = PlaneCurve.arc((0, 0), 100.0, 0.0, 2.0)
ARCH = PlaneCurve.spline(
    [(0, 0), (20, 30), (40, 60), (100, 60), (120, 30), (140, 0)]
)  # no curvature at the ends
ONE = PlaneCurve.spline([(0, 0), (30, 40), (60, 5), (90, -40), (130, 0)])
PINNED = Supports("pinned", "pinned")


def sine(start, stop, amplitude=40.0, pitch=100.0, tolerance=1e-4):
    x = np.linspace(start, stop, 300)
    return PlaneCurve.fit(np.column_stack([pitch * x, amplitude * np.sin(x)]), degree=5, tolerance=tolerance)


def chain(*arcs):
    """Arcs (signed radius, angle) joined smoothly, as one rational quadratic."""
    p, theta = np.zeros(2), 0.0
    points, weights, knots = [p], [1.0], [0.0] * 3
    for i, (radius, angle) in enumerate(arcs):
        side, size = np.sign(radius), abs(radius)
        along = np.array([np.cos(theta), np.sin(theta)])
        middle = p + size * np.tan(angle / 2) * along
        theta += side * angle
        p = middle + size * np.tan(angle / 2) * np.array([np.cos(theta), np.sin(theta)])
        points += [middle, p]
        weights += [np.cos(angle / 2), 1.0]
        knots += [i + 1.0] * 2
    return PlaneCurve(np.array([*knots, knots[-1]]), np.array(points), 2, np.array(weights))


def with_line_before(*arcs):
    """A line of 50 mm, then arcs."""
    bent = chain(*arcs)
    knots = np.concatenate(([0.0] * 3, bent.knots[1:] + 1.0))
    points = np.vstack(([(-50.0, 0.0), (-25.0, 0.0)], bent.control_points))
    return PlaneCurve(knots, points, 2, np.concatenate(([1.0, 1.0], bent.weights)))


def double_spiral(winding):
    """One inflection with two arms that wind about it, as logarithmic spirals do."""
    t = np.linspace(-0.8, 1, 1201)
    angle = winding * np.log(1 + 50 * t**2)
    points = np.cumsum(np.column_stack([np.cos(angle), np.sin(angle)]), axis=0)
    return PlaneCurve.fit(points[::3], degree=5, tolerance=1e-2)


def bezier(*points, degree=3):
    """Bezier pieces joined at multiple knots."""
    pieces = (len(points) - 1) // degree
    knots = [0.0] * (degree + 1) + [float(k) for k in range(1, pieces) for _ in range(degree)]
    return PlaneCurve(knots + [float(pieces)] * (degree + 1), points, degree)


class TestRealizable:
    def test_no_inflection_is_always_realizable(self):
        check = check_equilibrium(ARC)
        assert check.realizable
        assert check.line is None
        assert check.inflections == ()
        assert "can take this curve of 200 mm; it has no inflections" in str(check)

    def test_one_inflection_has_a_line_through_it(self):
        check = check_equilibrium(ONE)
        assert check.realizable
        assert check.inflections == pytest.approx(ONE.inflections)
        at = ONE.at(ONE.inflections).position
        assert check.line.distance(at) == pytest.approx(0.0, abs=1e-9)

    @pytest.mark.parametrize(("start", "stop", "count"), [(-0.9, 3.8, 2), (-1.0, 7.0, 3)])
    def test_sine_waves_have_their_axis(self, start, stop, count):
        check = check_equilibrium(sine(start, stop))
        assert check.realizable
        assert len(check.inflections) == count
        assert abs(check.line.direction[1]) < 1e-4
        assert max(abs(d) for _, d in check.off_line) < 0.01
        assert check.moved < 0.1

    def test_straight_takes_any_stiffness(self):
        check = check_equilibrium(PlaneCurve.line((0, 0), (100, 20)))
        assert check.realizable
        assert check.any_stiffness
        assert "any width" in str(check)

    def test_steps_and_kinks_of_the_width_are_announced(self):
        steps = check_equilibrium(chain((100, 1), (60, 1), (80, 0.5)))
        assert steps.realizable
        assert "jumps at 100 and 160 mm" in str(steps)
        kinks = check_equilibrium(PlaneCurve.spline([(0, 0), (30, 40), (70, 50), (90, 40), (130, 0)], 3))
        assert kinks.realizable
        assert "have a corner at" in str(kinks)
        assert "to smooth the curve" in str(kinks)
        assert [one.severity for one in kinks.warnings] == ["warning"]
        assert check_equilibrium(ONE).warnings == ()

    def test_a_loop_is_announced(self):
        loop = PlaneCurve.spline([(0, 0), (200, 100), (-100, 100), (100, 0)], 3)
        check = check_equilibrium(loop)
        assert check.realizable
        ((first, second),) = loop.self_intersections()
        assert f"crosses itself ({first:.3g} and {second:.3g} mm from its start)" in str(check)

    def test_report_is_plain_json(self):
        for curve in (ARC, ONE, chain((100, 1), (-60, 1))):
            restored = json.loads(json.dumps(check_equilibrium(curve).as_dict()))
            assert restored["realizable"] == check_equilibrium(curve).realizable


class TestNotRealizable:
    def test_inflections_off_one_line(self):
        x = np.linspace(-1.0, 7.2, 300)
        bumpy = PlaneCurve.fit(
            np.column_stack([100 * x, 40 * np.sin(x) - 8 * x**2]), degree=5, tolerance=1e-4
        )
        check = check_equilibrium(bumpy)
        assert len(check.inflections) == 3
        assert not check.realizable
        places = bumpy.at(np.array(check.inflections)).position
        line = fit_inflection_line(places)
        assert [d for _, d in check.off_line] == pytest.approx(list(line.distance(places)), abs=1e-6)
        assert "are not on one line" in str(check)
        assert f"{abs(check.off_line[0][1]):.3g}" in str(check)

    def test_line_crosses_elsewhere(self):
        """A hook whose end comes back over the inflection line."""
        hook = sine(-0.9, 3.8)
        tail = np.array([(380, -28), (470, -110), (520, 20), (430, 90)])
        curve = PlaneCurve.fit(np.concatenate([hook.sample(60).position[:-1], tail]), degree=5, tolerance=2.0)
        check = check_equilibrium(curve)
        assert not check.realizable
        assert check.crossings or check.off_line

    def test_line_through_two_inflections_crossing_a_third_time(self):
        spiral_end = [(0, 0), (40, 60), (80, -60), (120, 60), (200, 90), (240, 0), (160, -160), (40, -40)]
        curve = PlaneCurve.spline(spiral_end, 4)
        check = check_equilibrium(curve)
        assert len(check.inflections) == 2
        assert not check.realizable
        on_line = check.line.distance(curve.at(np.array(check.crossings)).position)
        assert on_line == pytest.approx(0.0, abs=1e-6)
        assert "crosses the curve at" in str(check)
        # a support in the crossing itself would leave the line in the end of a piece
        where = curve.parameter(check.crossings[0])
        first = float(curve.parameter(check.inflections[-1]))
        start, end = curve.domain
        assert check.crossings[0] > check.inflections[-1]
        assert not check_equilibrium(curve.trimmed(start, float(where))).realizable
        assert "support the strip between each of these places and the next inflection" in str(check)
        between = (float(where) + first) / 2
        for piece in ((start, between), (between, end)):
            assert check_equilibrium(curve.trimmed(*piece)).realizable

    def test_no_line_through_one_inflection(self):
        """Both arms wind so far that every line through the inflection meets one of them."""
        curve = double_spiral(2.5)
        assert len(curve.inflections) == 1
        check = check_equilibrium(curve)
        assert not check.realizable
        (zero,) = curve.curvature_zeros
        assert check.crossings
        assert min(abs(s - zero.s) for s in check.crossings) > 0.05 * curve.length
        assert "or meets the curve again (near " in str(check)

    def test_curve_through_its_inflection_again(self):
        def loop(t):
            return 100 * np.stack([t * (1 - t**2) ** 2, 2 * t**3 * (1 - t) * (2 - t)], axis=-1)

        check = check_equilibrium(PlaneCurve.fit_function(loop, -0.1, 1.0, tolerance=1e-8, degree=5))
        assert not check.realizable
        assert "The curve returns to its inflection (9.82 mm from the start)." in str(check)

    @pytest.mark.parametrize(("winding", "realizable"), [(0.5, 1), (0.9, 1), (1.2, 0), (2.0, 0)])
    def test_one_inflection_agrees_with_all_directions_tried(self, winding, realizable):
        curve = double_spiral(winding)
        (zero,) = curve.curvature_zeros
        samples = curve.sample(4001)
        p = curve.evaluate(np.array(zero.t))
        far = np.abs(samples.s - zero.s) > 1e-3 * curve.length
        v = ((samples.position - p) * np.sign(samples.curvature)[:, None])[far]
        v = v / np.hypot(*v.T)[:, None]
        turn = np.linspace(0, 2 * np.pi, 7201)
        best = (np.column_stack([np.cos(turn), np.sin(turn)]) @ v.T).min(axis=1).max()
        assert check_equilibrium(curve).realizable == (best > 0) == bool(realizable)
        spread = find_separating_line(curve, zero, zero.after).spread
        if best > 0:
            assert np.cos(spread / 2) == pytest.approx(best, abs=2e-3)

    def test_straight_piece_joined_to_a_bent_one(self):
        curve = bezier((0, 0), (10, 0), (20, 0), (40, 0), (60, 0), (90, 10), (100, 50))
        check = check_equilibrium(curve)
        assert not check.realizable
        assert check.flats == (pytest.approx((0.0, 40.0), abs=1e-9),)
        assert "Support the strip at 40 mm" in str(check)
        assert check_equilibrium(curve.trimmed(1.0, 2.0)).realizable

    def test_where_a_straight_piece_ends_no_fair_curve_is_advised(self):
        """Smoothed within 0.1 mm it waves about its line, and no strip takes it either."""
        check = check_equilibrium(with_line_before((60, 1)))
        assert "Support the strip at 50 mm" in str(check)
        assert "smooth" not in str(check)
        further = check_equilibrium(with_line_before((60, 1), (30, 1)))
        assert "The width of the strip jumps at 110 mm" in str(further.warnings[0])
        assert "The width of the strip jumps" not in str(further)

    @pytest.mark.parametrize(("radius", "told"), [(99.999, False), (99.95, False), (99.8, True)])
    def test_radii_that_differ_so_little_that_no_width_shows_it(self, radius, told):
        assert (
            "The width of the strip jumps" in str(check_equilibrium(chain((100, 1), (radius, 1))))
        ) is told

    def test_straight_piece_that_bends_too_gently_for_a_support(self):
        """kappa grows as the square of the distance: alone, the bent piece can't be had either."""
        line = [(0, 0), (10, 0), (20, 0), (30, 0), (40, 0)]
        curve = bezier(*line, (50, 0), (60, 0), (70, 0), (80, 10), degree=4)
        check = check_equilibrium(curve)
        assert check.flats == (pytest.approx((0.0, 40.0), abs=1e-9),)
        assert "A support at the joint does not help. Draw the piece with a slight bend" in str(check)
        assert "Support the strip at" not in str(check)
        assert not check_equilibrium(curve.trimmed(1.0, 2.0)).realizable

    def test_inflection_by_a_jump(self):
        check = check_equilibrium(chain((100, 1.0), (-60, 1.0)))
        assert not check.realizable
        assert check.jumps == (pytest.approx(100.0),)
        assert "curvature jumps from one sign to the other 100 mm from the start" in str(check)
        assert "Support" in str(check)

    def test_curvature_touching_zero(self):
        x = np.linspace(-1, 1, 201)
        curve = bezier((0, 0), (1, 0), (2, 0), (3, 0), (4, 1), degree=4)
        check = check_equilibrium(curve)
        assert not check.realizable
        assert check.curvature_touches
        touching = PlaneCurve.fit(np.column_stack([100 * x, 20 * x**4]), degree=4, tolerance=1e-6)
        exact = bezier((-100, 20), (-50, -20), (0, 20), (50, -20), (100, 20), degree=4)
        check = check_equilibrium(exact)
        assert not check.realizable
        assert check.curvature_touches == (pytest.approx(exact.length / 2),)
        assert "does not clearly bend to the other side" in str(check)
        assert touching.length == pytest.approx(exact.length, rel=1e-3)
        assert "even with a support. Bend the curve a little more there" in str(check)
        # nor does a support there help: each half keeps the place as its end
        for half in ((0.0, 0.5), (0.5, 1.0)):
            assert not check_equilibrium(exact.trimmed(*half)).realizable

    def test_tangent_line(self):
        """y = x^5 - like inflection with zero slope of the curvature is not secant-bounded."""
        exact = bezier((-100, -20), (-60, 20), (-20, -20), (20, 20), (60, -20), (100, 20), degree=5)
        check = check_equilibrium(exact)
        assert not check.realizable
        assert check.curvature_touches == (pytest.approx(exact.length / 2),)


class TestSupports:
    def test_pinned_ends_without_curvature(self):
        check = check_equilibrium(ARCH, PINNED)
        assert check.realizable
        ends = ARCH.evaluate(np.array(ARCH.domain))
        assert check.line.distance(ends) == pytest.approx([0, 0], abs=1e-9)

    def test_pinned_end_with_curvature(self):
        check = check_equilibrium(ARC, Supports("clamped", "pinned"))
        assert not check.realizable
        assert "The end (at 200 mm) is free to turn" in str(check)
        assert "Only a clamped end may be bent" in str(check)

    @pytest.mark.parametrize(("turn", "slide", "realizable"), [
        (np.pi / 2, "slide-x", True), (0.0, "slide-x", False),
        (0.0, "slide-y", True), (np.pi / 2, "slide-y", False),
    ])  # fmt: skip
    def test_sliding_end_fixes_the_direction_of_the_line(self, turn, slide, realizable):
        c, s = np.cos(turn), np.sin(turn)
        wave = sine(-0.9, 3.8)
        wave = PlaneCurve(wave.knots, wave.control_points @ [[c, s], [-s, c]], wave.degree)
        check = check_equilibrium(wave, Supports("clamped", slide))
        assert check.realizable is realizable
        if realizable:
            assert abs(check.line.b[0 if slide == "slide-y" else 1]) < 1e-12
        else:
            assert ("vertical" if slide == "slide-x" else "horizontal") in str(check)

    def test_no_force_no_inflection(self):
        guided = Supports("clamped", "guided")
        assert check_equilibrium(ARC, guided).realizable
        check = check_equilibrium(ONE, guided)
        assert not check.realizable
        assert "hold both ends" in str(check)

    def test_free_end_bends_nothing(self):
        assert not check_equilibrium(ARCH, Supports("clamped", "free")).realizable
        assert check_equilibrium(PlaneCurve.line((0, 0), (9, 0)), Supports("clamped", "free")).realizable

    def test_single_zero_with_a_given_direction(self):
        half = PlaneCurve.spline([(0, 0), (20, 30), (40, 60), (80, 60), (110, 40)])
        slides = Supports(End(angle=False), End(x=True, y=False, angle=True))
        check = check_equilibrium(half, slides)
        assert check.line.b == pytest.approx([0, 1])
        assert check.realizable


class TestNaturalCurvature:
    def test_arc_with_its_own_curvature_is_not_bent(self):
        check = check_equilibrium(ARC, natural_curvature=0.01)
        assert check.any_stiffness

    def test_zeros_are_those_of_the_difference(self):
        ellipse = PlaneCurve.ellipse((0, 0), (200, 100), 0.0, 0.3, np.pi / 2)
        check = check_equilibrium(ellipse, natural_curvature=0.01)
        (s,) = check.inflections
        assert ellipse.at(np.array([s])).curvature == pytest.approx(0.01, rel=1e-9)
        assert check.realizable

    def test_no_flat_strip_is_spoken_of(self):
        ellipse = PlaneCurve.ellipse((0, 0), (200, 100), 0.0, 0.3, np.pi / 2)
        result = [str(check_equilibrium(ellipse, natural_curvature=rest)) for rest in (-0.01, 0.01)]
        result.append(str(check_equilibrium(ARC, natural_curvature=0.01)))
        wave = PlaneCurve.spline([(0, 0), (40, 60), (80, -60), (120, 0)], degree=3)
        result.append(str(check_equilibrium(wave, Supports("pinned", "clamped"), natural_curvature=0.001)))
        ways = [
            r"can take .*\. It is bent from its pre-bent shape to one side only",
            r"can take .*\. The side to which it is bent from its pre-bent shape changes at .* mm",
        ]
        for text, way in zip(result, [*ways, "already has .* mm", "cannot take .* mm"], strict=True):
            assert re.match(rf"The pre-bent strip {way}\.", text), text
            assert "flat" not in text

    def test_not_a_number(self):
        with pytest.raises(InputError, match="natural_curvature"):
            check_equilibrium(ARC, natural_curvature=np.nan)


class TestBadCurves:
    def test_closed_with_a_corner(self):
        drop = PlaneCurve.spline([(0, 0), (40, 60), (-40, 60), (0, 0)], degree=3)
        with pytest.raises(InputError, match=r"closed curve has a corner of 113 degrees at \(0, 0\)"):
            check_equilibrium(drop)

    def test_corner(self):
        with pytest.raises(InputError, match=r"corner 30 mm from its start"):
            check_equilibrium(bezier((0, 0), (10, 0), (20, 0), (30, 0), (30, 10), (35, 20), (50, 30)))


def test_error_carries_the_check():
    check = check_equilibrium(chain((100, 1), (-60, 1)))
    error = NotRealizable(check)
    assert isinstance(error, ValueError)
    assert error.check is check
    assert str(error) == str(check)


def test_line_record():
    line = InflectionLine((1.0, 2.0), (0.0, 1.0))
    assert line.distance(np.array([[1.0, 9.0], [0.0, 0.0]])).tolist() == [0.0, 1.0]
    assert line.a + line.b @ np.array([1.0, 5.0]) == 0.0


@pytest.mark.parametrize("weight", [1e-2, 1e-3, 1e-4])
def test_light_control_points_make_no_inflection_of_a_clamped_end(weight):
    """A hull that turns one way has no inflection; its curve turns sharply just behind its ends."""
    curve = PlaneCurve([0] * 4 + [1] * 4, [(0, 0), (30, 60), (70, 60), (100, 0)], 3, [1, weight, weight, 1])
    check = check_equilibrium(curve)
    assert check.zeros == ()
    assert check.realizable


@pytest.mark.parametrize("held", ["pinned", "clamped"])
def test_a_measured_arch_with_one_pinned_end(held):
    """The curvature of what is fitted vanishes just inside both ends: beside a clamped one that is no hindrance."""
    x = np.linspace(0.0, 200.0, 400)
    arch = PlaneCurve.fit(np.column_stack([x, 40 * np.sin(np.pi * x / 200)]), tolerance=1e-4)
    for curve, supports in ((arch, Supports("pinned", held)), (arch.reversed(), Supports(held, "pinned"))):
        check = check_equilibrium(curve, supports)
        assert check.realizable, str(check)
        end = check.curve.domain[supports.start.angle]
        assert abs(check.curve.curvature_at(np.array(end))) < 1e-12
        assert check.moved < 1e-3


@pytest.mark.parametrize("flip", [False, True])
def test_a_straight_end_that_is_free_is_refused_for_its_own_reason(flip):
    """No message quotes a curvature of 0 against the limit 0, or asks for the support that is there."""
    curve = PlaneCurve([0, 0, 0, 20, 20, 60, 60, 60], [(0, 0), (10, 0), (20, 0), (40, 0), (50, 20)], 2)
    supports = Supports("pinned" if flip else "free", "clamped")
    (reason,) = check_equilibrium(curve, supports=supports).reasons
    assert reason.startswith("The piece from 0 mm to 20 mm is straight and has an end that is free to turn")
    assert reason.endswith("with a tie, pin or rail at 20 mm, or let the curve end at 20 mm.")


@pytest.mark.parametrize(("share", "realizable"), [(7e-4, True), (4e-3, True), (0.03, False)])
def test_a_faint_curvature_at_an_end_that_may_turn_is_noise(share, realizable):
    """The slope of the curvature is 0 there, so a nearby zero of the curvature does not show that it is noise."""
    s = np.linspace(0.0, 430.0, 1501)
    kappa = 4e-3 * (share + (1 - share) * np.sin(np.pi * s / 430) ** 2)
    angle = np.append(0.0, np.cumsum((kappa[1:] + kappa[:-1]) / 2 * np.diff(s)))
    steps = np.column_stack([np.cos(angle), np.sin(angle)])
    points = np.append(
        [[0, 0]], np.cumsum((steps[1:] + steps[:-1]) / 2 * np.diff(s)[:, None], axis=0), axis=0
    )
    curve = PlaneCurve(*fit_spline(points, 5, 4e-4), 5)
    check = check_equilibrium(curve, supports=Supports("pinned", "pinned"))
    assert check.realizable == realizable
    assert check.moved < 1e-4 * curve.length
