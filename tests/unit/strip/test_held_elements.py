"""Rails, pins and ties on the holding template and on the assembly sheet."""

from dataclasses import replace

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad.plot.assembly_sheet import _element_rows
from elastica_cad.strip.holding_template import held_elements, holding_template

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
        f"R1 rail: x {point[0]:.1f}, y {point[1]:.1f}, touches the strip at x {contact[0]:.1f}, "
        f"y {contact[1]:.1f}, {rail.tilt:.1f} degrees from the line, {rail.force:.2g} N" in texts
    )
    assert {"R1", "T1"} <= set(texts)
    assert str(replace(rail, force=1012.0)).endswith(", 1000 N")


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
    assert text.endswith("-90.0 degrees from the line, 0.2 N")
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
