"""Rails, pins and ties on the holding template and on the assembly sheet."""

from dataclasses import replace
from typing import get_args

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad.mechanics.loads import End, EndName
from elastica_cad.model.assembly import list_assembly_steps
from elastica_cad.plot.assembly_sheet import _element_rows
from elastica_cad.strip.holding_template import (
    angle_text,
    ends_message,
    freedom_text,
    held_elements,
    held_ends,
    holding_template,
)
from elastica_cad.strip.summary import hold_row

WAVE = ec.PlaneCurve.spline(
    [(0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (360, 0)], degree=5
)
SHEET = "birch-plywood-0.8"


def strip_of(*elements):
    return ec.make_strip(WAVE, SHEET, max_width=40, between=elements, label="A")


def test_the_template_has_a_bar_on_the_side_from_which_a_rail_pushes():
    strip = strip_of(ec.Rail(200), ec.Tie(40, 310))
    rail, tie = held_elements(strip)
    assert (rail.name, tie.name) == ("R1", "T1")
    assert rail.outward[0] @ rail.action.force[0] < 0
    point, angle = WAVE.at([200.0]).position[0], WAVE.at([200.0]).angle[0]
    assert rail.places[0] == pytest.approx(point)
    assert rail.tilt == pytest.approx(np.degrees(angle))
    drawing = holding_template(strip)
    contact = point + 0.4 * rail.outward[0]
    starts = [path.points(0.1)[0] for path in drawing.on("MARK")]
    assert min(np.hypot(*(start - contact)) for start in starts) < 1e-6
    cords = [path.points(0.1) for path in drawing.on("MARK") if len(path.points(0.1)) == 2]
    assert any(np.allclose(cord, WAVE.at([40.0, 310.0]).position) for cord in cords)
    texts = [text.text for text in drawing.texts]
    assert (
        f"R1 rail: touches the strip at x {contact[0]:.1f}, y {contact[1]:.1f}, bar above the strip, "
        f"strip {rail.tilt:.1f} degrees to the left, {rail.force:.2g} N downward" in texts
    )
    assert {"R1", "T1"} <= set(texts)
    assert str(replace(rail, force=1012.0)).endswith(", 1000 N downward")


def test_loads_are_arrows_with_their_force_on_template_and_sheet():
    loads = (ec.PointMass(100, 20), ec.PointForce(250, (0.3, 0.4)))
    strip = ec.make_strip(
        WAVE, SHEET, max_width=40, between=ec.Rail(200), loads=loads, gravity=True, label="A"
    )
    _, force, mass = held_elements(strip)
    assert (mass.name, mass.noun, force.name, force.noun) == ("M1", "point mass 20 g", "F1", "point force")
    assert mass.force == pytest.approx(0.020 * 9.80665)
    assert mass.outward[0] == pytest.approx((0, -1))
    assert (force.force, force.tilt) == pytest.approx((0.5, np.degrees(np.arctan2(0.4, 0.3))))
    drawing = holding_template(strip)
    lines = [path.points(0.1) for path in drawing.on("MARK")]
    hung = WAVE.at([100.0]).position[0]
    assert any(len(line) == 2 and np.allclose(line, [hung, hung - (0, 20)], atol=1e-6) for line in lines)
    text = next(text.text for text in drawing.texts if text.text.startswith("M1 "))
    assert text.endswith("90.0 degrees to the right, 0.2 N downward")
    model = ec.Model([ec.Placed(strip, (0, 0, 100), (1, 0, 0), (0, 0, 1))])
    assert [row[1] for row in _element_rows(model)] == ["R1 rail", "F1 point force", "M1 point mass 20 g"]


def test_the_assembly_sheet_has_a_row_for_each_element():
    strip = strip_of(ec.Pin(200), ec.Tie(40, 310))
    model = ec.Model([ec.Placed(strip, (0, 0, 100), (1, 0, 0), (0, 0, 1))])
    pin, tie = _element_rows(model)
    x, y = WAVE.at([200.0]).position[0]
    assert pin[:3] == ("A", "P1 pin", f"({x:z.1f}, 0.0, {100 + y:z.1f})")
    force = strip.bending_stiffness * strip.rod.between[1].size
    assert tie[4:] == (
        f"{force:.2g}",
        f"{np.hypot(*np.diff(WAVE.at([40.0, 310.0]).position, axis=0)[0]):.1f}",
    )
    assert not [
        *_element_rows(
            ec.Model([ec.Placed(ec.make_strip(ec.PlaneCurve.arc((0, 0), 60, 3, 0), SHEET, max_width=9))])
        )
    ]


ARCH = ec.PlaneCurve.spline([(0, 0), (60, 25), (150, 40), (240, 25), (300, 0)], degree=3)


def arch_of(*elements):
    return ec.make_strip(
        ARCH,
        "birch-plywood-1.5",
        max_width=40,
        between=elements,
        loads=ec.PointMass(200, 80),
        gravity=True,
        supports=ec.Supports("slide-x", "clamped"),
        label="D",
    )


@pytest.mark.parametrize(
    ("x_axis", "y_axis", "side"),
    [
        ((1, 0, 0), (0, 0, 1), "below the strip"),
        ((0, 1, 0), (0, 0, 1), "below the strip"),
        ((0, 0, 1), (1, 0, 0), "on the -x side of the strip"),
        ((1, 0, 0), (0, 0, -1), "above the strip"),
    ],
)
def test_the_sheet_gives_the_place_and_the_side_at_which_the_bar_of_a_rail_touches(x_axis, y_axis, side):
    strip = arch_of(ec.Rail(120))
    member = ec.Placed(strip, (7, 3, 100), x_axis, y_axis)
    rail, _ = held_elements(strip)
    rod = strip.rod
    at = rod.curve.at(rod.between[0].s)
    below = at.position[0] + 0.75 * np.array([np.sin(at.angle[0]), -np.cos(at.angle[0])])
    assert rail.contact == pytest.approx(below)
    place = ", ".join(f"{x:z.1f}" for x in member.frame.point(below))
    (row, _) = _element_rows(ec.Model([member]))
    assert row[2] == f"({place}) (bar {side})"
    assert f"touches the strip at x {below[0]:.1f}, y {below[1]:.1f}, bar below the strip" in str(rail)


def test_a_rail_with_two_bars_is_at_the_middle_of_the_strip():
    strip = arch_of(ec.Rail(120, one_sided=False))
    rail, _ = held_elements(strip)
    x, y = rail.position[0]
    (row, _) = _element_rows(ec.Model([ec.Placed(strip, (0, 0, 0), (1, 0, 0), (0, 0, 1))]))
    assert row[2] == f"({x:.1f}, 0.0, {y:.1f}) (middle between two bars)"
    assert f"x {x:.1f}, y {y:.1f}, middle between two bars" in str(rail)


def test_forces_have_the_direction_in_which_they_push():
    strip = arch_of(ec.Rail(120))
    rail, mass = (
        row[4] for row in _element_rows(ec.Model([ec.Placed(strip, (0, 0, 0), (1, 0, 0), (0, 0, 1))]))
    )
    assert rail.endswith(" upward")
    assert mass == "0.78 downward"
    assert [
        row[4] for row in _element_rows(ec.Model([ec.Placed(strip, (0, 0, 0), (0, 0, 1), (1, 0, 0))]))
    ] == [
        rail.replace("upward", "towards +x"),
        "0.78 towards -x",
    ]


STEEP = ec.PlaneCurve.spline([(10, 0), (60, 90), (110, 190), (75, 300), (60, 420), (95, 500)], degree=3)


@pytest.mark.parametrize("turn", [0.0, 0.5, np.pi])
def test_row_template_and_sheet_state_the_same_angle_of_each_end(turn):
    turned = [[np.cos(turn), -np.sin(turn), 0], [np.sin(turn), np.cos(turn), 0], [0, 0, 1]]
    strip = ec.make_strip(STEEP.transformed(turned), "birch-plywood-1.5", max_width=60, between=ec.Pin(200))
    start, end = (angle_text(end.tilt) for end in held_ends(strip))
    assert (start, end) == ("19.4 degrees to the right", "14.0 degrees to the right")
    assert f"points {start} at the start, {end} at the end" in hold_row(strip).text
    assert f"points {start} at the start, {end} at the end" in ends_message(strip)
    texts = [text.text for text in holding_template(strip).texts]
    assert {f"start (1): strip {start}", f"end (2): strip {end}"} <= {*texts}
    (step,) = list_assembly_steps(ec.Model([ec.Placed(strip, (0, 0, 0), (1, 0, 0), (0, 0, 1))]))
    for text, angle in zip(step.ends, (start, end), strict=True):
        assert f"), {angle} (" in text


@pytest.mark.parametrize(
    ("x_axis", "y_axis", "along"),
    [
        ((1, 0, 0), (0, 0, 1), "x"),
        ((0, -1, 0), (0, 0, 1), "y"),
        ((0.6, 0.8, 0), (0, 0, 1), "(0.60, 0.80, 0.00)"),
    ],
)
def test_sheet_and_template_state_that_an_end_slides(x_axis, y_axis, along):
    strip = arch_of(ec.Rail(120))
    texts = [text.text for text in holding_template(strip).texts]
    (start,) = (text for text in texts if text.startswith("start (1)"))
    assert start.endswith(", free to slide along the x axis of the drawing")
    assert not any("free" in text for text in texts if text.startswith("end (2)"))
    model = ec.Model([ec.Placed(strip, (0, 0, 0), x_axis, y_axis)])
    for holders in ((), model.fixtures()):
        (step,) = list_assembly_steps(model, holders)
        assert step.motions == (f"free to slide along {along}", "")


def test_ends_that_turn_or_hold_only_their_angle_have_their_motion():
    named = {name: freedom_text(End.named(name)) for name in get_args(EndName)}
    assert named == {
        "clamped": "",
        "pinned": "free to turn",
        "slide-x": "free to slide along x",
        "slide-y": "free to slide along y",
        "roller-x": "free to slide along x and to turn",
        "roller-y": "free to slide along y and to turn",
        "guided": "free to slide along x and y",
        "free": "free: nothing holds it",
    }
