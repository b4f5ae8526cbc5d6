"""Strips that close: their verdict, where they are joined, and the shape that the joint leaves them."""

import json
from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import root

from elastica_cad import (
    Gravity,
    InputError,
    Laminated,
    Limits,
    PlaneCurve,
    Sheet,
    StripSpec,
    Tab,
    bend,
    check_equilibrium,
    make_strip,
    optimal_rod,
    stability,
)
from elastica_cad.design import report_strip
from elastica_cad.geometry.measured_points import Provenance
from elastica_cad.mechanics.theorem1 import begin_at, flattest_place
from elastica_cad.model.collisions import self_contact
from elastica_cad.strip import BentSolid

pytestmark = pytest.mark.core

PLY = Sheet.named("birch-plywood-0.8")
BEAM = replace(PLY, poisson_ratio=0.0)
CIRCLE = PlaneCurve.arc((0, 0), 60, 0, 2 * np.pi)
ELLIPSE = PlaneCurve.ellipse((10, -5), (120, 90), rotation=0.3, start=0.7, end=0.7 + 2 * np.pi)
OVAL = PlaneCurve.spline([(0, 0), (80, 0), (160, 120), (0, 360), (-160, 120), (-80, 0), (0, 0)], degree=6)


def periodic(radius, count=24, degree=4):
    """The smooth closed spline whose control points lie on r = radius(angle)."""
    angle = 2 * np.pi * np.arange(count + degree) / count
    points = radius(angle)[:, None] * np.column_stack([np.cos(angle), np.sin(angle)])
    return PlaneCurve(np.arange(count + 2 * degree + 1), points, degree)


SQUARISH = periodic(lambda angle: 100 + 4 * np.cos(4 * angle))
PEANUT = periodic(lambda angle: 70 + 30 * np.cos(2 * angle))
UPRIGHT = PlaneCurve.ellipse((0, 0), (90, 60), start=0, end=2 * np.pi)
CLOSED = {"upright": UPRIGHT, "circle": CIRCLE, "ellipse": ELLIPSE, "oval": OVAL, "squarish": SQUARISH}


@pytest.mark.parametrize("beyond", [-1e-4, 3e-5, 1e-4])
def test_a_curve_that_begins_beside_a_knot_has_no_step_there(beyond):
    oval = periodic(lambda angle: 100 + 12 * np.cos(2 * angle), 14, 3)
    begun = begin_at(oval, float(oval.arc_length(np.array([oval.domain[0] + 5 + beyond]))[0]))
    assert begun.seam.continuity == 2
    assert not any("steps" in warning for warning in check_equilibrium(begun).warnings)


def waisted():
    """A pen curve with two waists, of Bezier pieces whose handles line up."""
    half = [
        (-60, 30),
        (-36, 50),
        (-20, 10),
        (0, 10),
        (20, 10),
        (36, 50),
        (60, 30),
        (84, 10),
        (84, -10),
        (60, -30),
    ]
    points = np.array([*half, *(-np.array(half[1:]))], dtype=float)
    pieces = len(points) // 3
    return PlaneCurve([0, *np.repeat(np.arange(pieces + 1), 3), pieces], points, 3)


def lapped_shape(strip):
    """The closed strip with its lap, integrated from its start: M = K (kappa - rest), M affine in position."""
    rod, length, lap = strip.rod, strip.rod.length, strip.ends[1].length
    w_lap = strip.end_widths[1]

    def law(s):
        K, kappa = rod.profile(s), rod.curve.at(np.atleast_1d(s)).curvature[0]
        if s > lap:
            return K, 0.0
        w = float(strip.width(s))
        glued = (w + w_lap + 12 * w * w_lap / (w + w_lap)) / w
        return glued * K, kappa - (w + w_lap) / w * kappa / glued

    def slope(s, y, a, bx, by):
        K, rest = law(s)
        return [np.cos(y[2]), np.sin(y[2]), rest + (a + bx * y[0] + by * y[1]) / K]

    start = [*rod.position[0], float(rod.angle[0])]

    def shape(p):
        first = solve_ivp(
            slope, (0, lap), start, args=tuple(p), rtol=1e-10, atol=1e-10, t_eval=rod.s[rod.s < lap]
        )
        end = solve_ivp(slope, (0, lap), start, args=tuple(p), rtol=1e-10, atol=1e-10).y[:, -1]
        rest = solve_ivp(
            slope, (np.nextafter(lap, length), length), end, args=tuple(p), rtol=1e-10, atol=1e-10,
            t_eval=rod.s[rod.s >= np.nextafter(lap, length)],
        )  # fmt: skip
        return np.hstack([first.y, rest.y])

    def gap(p):
        x, y, angle = shape(p)[:, -1]
        return [x - start[0], y - start[1], 100 * (angle - float(rod.angle[-1]))]

    M, (fx, fy) = rod.moment[0], rod.force[0]
    b = np.array([fy, -fx])
    found = root(gap, [M - b @ rod.position[0], *b], tol=1e-12).x
    assert np.abs(gap(found)).max() < 1e-4
    return shape(found)[:2].T


@pytest.mark.parametrize("name", CLOSED)
def test_curves_that_bend_one_way_close(name):
    curve = CLOSED[name]
    check = check_equilibrium(curve)
    assert check.realizable
    strip = make_strip(curve, BEAM, max_width=20)
    rod = strip.rod
    start, end = strip.end_widths
    assert end == pytest.approx(start, abs=1e-4)
    # what one end asks of the joint the other gives
    held = strip.reactions()
    assert held.start_force == pytest.approx(-held.end_force, abs=1e-9)
    assert held.start_moment == pytest.approx(-held.end_moment, rel=1e-6)
    assert stability(rod).stable
    again = bend(rod, end=rod.position[-1])
    assert np.abs(again.position - rod.position).max() < 2e-5 * rod.length
    assert self_contact(strip) is None


@pytest.mark.campaign
@pytest.mark.parametrize("name", ["circle", "ellipse", "squarish"])
def test_the_lap_straightens_the_joint_as_reported(name):
    """Against the equation integrated with the lap's own ends."""
    strip = make_strip(CLOSED[name], BEAM, max_width=20)
    result, wanted = strip.held().rod, lapped_shape(strip)
    nodes = np.column_stack([np.interp(strip.rod.s, result.s, column) for column in result.position.T])
    strayed = np.hypot(*(wanted - strip.rod.position).T).max()
    assert np.hypot(*(nodes - wanted).T).max() < 0.05 * strayed
    assert strip.held().parts.keys() >= {"lap joint"}
    assert result.moment[0] == pytest.approx(result.moment[-1], rel=1e-5)
    assert result.force[0] == pytest.approx(result.force[-1], abs=1e-12)


@pytest.mark.parametrize("name", CLOSED)
def test_widths_make_up_for_the_lap_and_close(name):
    plain = make_strip(CLOSED[name], PLY, max_width=20)
    better = make_strip(CLOSED[name], PLY, max_width=20, compensate=True)
    assert better.held_deviation < min(plain.held_deviation / 3, 1.5e-4 * plain.rod.length)
    start, end = better.end_widths
    assert end == pytest.approx(start, abs=0.01)


def test_whether_it_closes_is_a_plain_truth_value():
    """As JSON takes it; of closed strips it had been one of numpy's."""
    arc = PlaneCurve.arc((0, 0), 60, 0, 2)
    result = [make_strip(curve, PLY, max_width=20).is_closed for curve in (CIRCLE, arc)]
    assert json.dumps(result) == "[true, false]"


def test_without_a_lap_the_shape_is_the_drawn_one():
    strip = make_strip(ELLIPSE, BEAM, max_width=20, ends=(Tab(10), Tab(0)))
    assert strip.held_deviation < 1e-5 * strip.rod.length
    assert "butt to butt" in strip.joint


def test_where_it_is_joined():
    request = StripSpec(ELLIPSE, PLY, max_width=20)
    bent = np.abs(request.make().rod.curvature)
    assert bent[0] == pytest.approx(bent.min(), rel=1e-4)
    there = request.changed(seam_position=100.0).make()
    assert there.rod.position[0] == pytest.approx(ELLIPSE.at(np.array([100.0])).position[0], abs=1e-6)
    assert there.ends[0].length == 0
    with pytest.raises(InputError, match=r"seam_position is 1000.*0 to 66\d"):
        request.changed(seam_position=1000.0)
    free = request.changed(seam_position=100.0, limits=Limits(ratio=9.0)).make()
    assert free.rod.position[0] == pytest.approx(there.rod.position[0], abs=1e-6)
    with pytest.raises(InputError, match="seam_position puts a joint 100 mm from its start"):
        request.changed(seam_position=100.0, curve=PlaneCurve.arc((0, 0), 60, 0, 3))


def test_a_closed_curve_begins_anywhere():
    begun = begin_at(ELLIPSE, 123.0)
    assert begun.is_closed
    assert begun.length == pytest.approx(ELLIPSE.length, abs=1e-9)
    assert abs(begun.seam_turn) < 1e-9
    s = np.linspace(0, ELLIPSE.length - 123, 50)
    assert begun.at(s).position == pytest.approx(ELLIPSE.at(s + 123).position, abs=1e-8)
    assert flattest_place(CIRCLE) == 0
    with pytest.raises(InputError, match="open"):
        begin_at(PlaneCurve.arc((0, 0), 10, 0, 3), 2.0)


def test_inflections_off_one_line_are_refused():
    check = check_equilibrium(PEANUT)
    assert not check.realizable
    assert len(check.inflections) == 4
    assert "he inflections are not on one line" in str(check)
    assert "support the strip between them" in str(check)
    drawn = check_equilibrium(waisted())
    assert not drawn.realizable
    assert "support the strip" in str(drawn)


def test_drawn_to_begin_in_an_inflection_it_is_counted_from_elsewhere():
    check = check_equilibrium(begin_at(PEANUT, float(PEANUT.inflections[0])))
    assert "measured from" in check.warnings[0]
    assert len(check.inflections) == 4
    assert not check.realizable


def test_what_does_not_close():
    with pytest.raises(InputError, match="closed strip needs one sheet"):
        make_strip(CIRCLE, PLY, style=Laminated(width=20, backing=Sheet.named("card-200gsm")))
    heavy = make_strip(CIRCLE, PLY, max_width=20, gravity=Gravity(300.0, (1.0, 0.3)), seam_position=40.0)
    assert any(text.startswith("The ends of the closed strip do not fit") for text in heavy.warnings)


def test_pattern_and_report():
    strip = make_strip(CIRCLE, PLY, max_width=20, label="R")
    (low, _), (high, _) = strip.outline.bounds
    assert (low, high) == pytest.approx((0.0, strip.rod.length + 10.0), abs=1e-9)
    marks = [path.start[0] for path in strip.drawing().on("MARK")]
    assert marks == pytest.approx([10.0, strip.rod.length])
    answer = report_strip(strip, name="R", files={})["joint"]
    assert answer["lap"] == 10.0
    assert answer["moment"] == pytest.approx(abs(strip.bending_stiffness / 60), rel=1e-3)
    assert "the tab of 10 mm" in answer["meaning"]


def test_bodies():
    strip = make_strip(CIRCLE, PLY, max_width=20, min_width=20)
    ring, lap = BentSolid.layers(strip)
    assert ring.boundary.is_closed
    assert lap.boundary.is_closed
    # the lap lies on the inside, on the ring's inner face
    radius = np.hypot(*lap.boundary.vertices[:, :2].T)
    assert radius.max() == pytest.approx(59.6, abs=1e-6)
    assert radius.min() == pytest.approx(58.8, abs=1e-6)


def test_the_rod_of_a_closed_curve_closes():
    rod = optimal_rod(CIRCLE)
    assert rod.ratio == pytest.approx(1.0, abs=1e-9)
    assert rod.moment[0] == pytest.approx(rod.moment[-1])


def test_the_joint_is_reported_where_the_drawing_program_shows_it():
    """An SVG's y runs down: 150 below the top there is -150 here."""
    drawn = UPRIGHT.drawn_as(Provenance(place=np.diag([1.0, -1.0, 1.0])))
    result, plain = (make_strip(one, PLY, max_width=20) for one in (drawn, UPRIGHT))
    x, y = plain.rod.position[0]
    assert f"at {Provenance().shown((x, y))}, where" in plain.joint
    assert abs(y) > 1
    assert f"at {Provenance().shown((x, -y))}, where" in result.joint
