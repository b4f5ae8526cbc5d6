"""Rails, pins, ties and loads of a strip: properties, overlay, support after a refusal, and the panel by mouse."""

import re

import numpy as np
import pytest
from freecad.elastica_wb import make_strip
from freecad.elastica_wb.curves.sketch_curves import drawn_curve
from freecad.elastica_wb.features import fixtures
from freecad.elastica_wb.features.strip import changeable, show_held, strip_of, valid_request, values_of
from freecad.elastica_wb.features.strip_properties import acting_lines, spec_of
from freecad.elastica_wb.live.curve_picture import curve_picture
from freecad.elastica_wb.solving.strip_cache import changes_that_help
from freecad.elastica_wb.solving.verdicts import Verdict

import elastica_cad as ec

from . import launching
from .features import change, new

POINTS = [(0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (360, 0)]
"""No strip takes it without a support."""

WAVE = ec.PlaneCurve.spline(POINTS, degree=5)
ITEMS = (
    ec.Rail((180, -9), one_sided=False),
    ec.Pin(200.0),
    ec.Tie(40.5, 310.0),
    ec.PointForce(150.0, (0.0, -0.2)),
    ec.PointMass(90.0, 3.0),
)


@pytest.fixture
def refused(drawn):
    return make_strip(drawn(POINTS, 5), flat_part=False)


def test_lines_of_elements_and_loads_are_read_back(refused):
    lines = acting_lines(ITEMS)
    assert lines["Between"][1:] == ['kind = "pin", at = 200.0', 'kind = "tie", start = 40.5, end = 310.0']
    refused.Between, refused.Loads = lines["Between"], lines["Loads"]
    refused.Gravity, refused.GravityDirection = True, (0, -1, 0)
    spec = spec_of(refused, drawn_curve(refused.Curve, refused))
    assert (*spec.between, *spec.loads) == ITEMS


def test_undo_and_redo_keep_the_curve_of_ties_and_loads(refused):
    document, (first, *others) = (
        refused.Document,
        [acting_lines((tie,)) for tie in (ITEMS[2], ec.Tie(50, 300))],
    )
    change(refused, **first)
    length = refused.PlacesLength.Value
    for lines in others:
        document.openTransaction("Tie")
        change(refused, **lines)
        document.commitTransaction()
    document.undo()
    assert (refused.Between, refused.PlacesLength.Value) == (first["Between"], length)
    document.redo()
    assert refused.PlacesLength.Value == length > 0


def test_a_refused_curve_gets_the_support_that_the_core_finds(refused):
    assert "cannot" in refused.Verdict
    suggestion, *_ = (
        found
        for found in changes_that_help(valid_request(refused), changeable(refused))
        if found.change.field == "between"
    )
    support = suggestion.change.value
    assert support == ec.Rail(197.0)
    change(refused, **values_of(refused, suggestion.change))
    assert refused.State == ["Up-to-date"]
    rod = ec.optimal_rod(WAVE, between=support)
    assert refused.Ratio == pytest.approx(rod.ratio, rel=1e-4)
    forces = strip_of(refused).rod.between_forces
    assert forces[0] == pytest.approx(rod.between_forces[0], rel=1e-3)


def test_a_strip_on_a_rail_has_fixtures_and_no_accuracy(refused):
    change(refused, Between=["at = 197"])
    show_held(refused)
    assert refused.Held == ""
    blocks = new(fixtures.create, refused.Document, [refused])
    assert blocks.State == ["Up-to-date"]
    assert len(blocks.Shape.Solids) == 2


def test_a_support_is_added_to_the_one_that_a_refused_request_has(refused):
    change(refused, Between=["at = 100"])
    (suggestion,) = changes_that_help(valid_request(refused), changeable(refused))
    change(refused, **values_of(refused, suggestion.change))
    assert refused.State == ["Up-to-date"]
    first, second = strip_of(refused).rod.between
    assert (first.element, second.element) == (ec.Rail(100.0), suggestion.change.value)


def test_ties_and_loads_keep_their_fraction_of_a_changed_sketch(refused, move_pole):
    sketch = refused.Curve[0]
    change(refused, Between=["at = [180, -9]", "at = 200", "kind = 'tie', start = 40, end = 310"],
           Loads=["at = 150, force = [0, -0.2]"])  # fmt: skip
    before = drawn_curve(refused.Curve, refused).curve.length
    refused.Document.openTransaction("Drag")
    move_pole(sketch, 3, (180, -70))
    factor = drawn_curve(refused.Curve, refused).curve.length / before
    assert factor > 1.015
    live = spec_of(refused, drawn_curve(refused.Curve, refused))
    assert live.between[2] == ec.Tie(round(40 * factor, 6), round(310 * factor, 6)), "in the open sketch too"
    refused.Document.recompute()
    refused.Document.commitTransaction()
    spec = spec_of(refused, drawn_curve(refused.Curve, refused))
    assert (spec.between, spec.loads) == (live.between, live.loads)
    assert spec.between[:2] == (ec.Rail((180, -9)), ec.Rail(200.0))
    assert spec.loads[0].at == pytest.approx(150 * factor, abs=1e-6)
    refused.Document.undo()
    refused.Document.recompute()
    assert spec_of(refused, drawn_curve(refused.Curve, refused)).between[2] == ec.Tie(40.0, 310.0)
    change(refused, Between=["kind = 'tie', start = 50, end = 300"])
    (tie,) = spec_of(refused, drawn_curve(refused.Curve, refused)).between
    assert tie == ec.Tie(50.0, 300.0), "typed places are on the present curve"


def test_the_overlay_shows_the_thrust_line_in_place_of_the_inflection_line():
    spec = ec.StripSpec(WAVE, "birch-plywood-0.8", max_width=30, between=(ec.Rail(200), ec.Tie(40, 310)))
    picture = curve_picture(WAVE, spec)
    assert picture.realizable
    assert picture.line is None
    assert [noun for _, noun in picture.stations] == ["rail", "tie", ""]
    (cord,) = picture.cords
    assert cord == pytest.approx(WAVE.at(np.array([40.0, 310.0])).position)
    sides = [
        side.distance(picture.on_line) for side in ec.optimal_rod(WAVE, between=spec.between).thrust_line
    ]
    assert np.abs(sides).min(axis=0).max() < 0.02, "each inflection is on a side"
    first, second = curve_picture(WAVE, spec.changed(between=ec.Rail(200))).thrust
    gaps = [np.hypot(*(a - b)) for a in first for b in second]
    assert min(gaps) < 1e-6, "the sides meet in a corner"


def test_the_overlay_refuses_what_no_rail_holds():
    spec = ec.StripSpec(WAVE, "birch-plywood-0.8", max_width=30, between=ec.Rail(40))
    picture = curve_picture(WAVE, spec)
    assert (picture.realizable, picture.answer.verdict, picture.thrust) == (False, Verdict.CANNOT, ())


@pytest.mark.campaign
def test_rails_ties_and_loads_by_mouse(tmp_path):
    found = launching.run_window("rails.py", tmp_path)
    assert "cannot" in found["refused"]
    assert found["offered"] == "Rest the strip on a rail at 197 mm."
    (between, _, state), verdict, offered = found["held"]
    assert (between, state, verdict, offered) == (
        ["at = 197.0"], ["Up-to-date"], "A flat strip can be bent into this curve.", False,
    )  # fmt: skip
    assert "rail 197 mm from the start pushes" in found["numbers"]
    assert found["listed"] == ["Rail at 197 mm"]
    assert found["overlay"] == {"thrust": 4, "stations": 1, "on_line": 2}
    before, frames, place, (between, *_) = found["dragged"]
    assert frames >= 4, "the mark follows the mouse"
    assert place > before[0] + 5
    assert between == [f"at = {place}"]
    assert "other end" in found["first end"]
    rows, (between, *_), picking = found["tie"]
    assert (len(rows), len(between), picking) == (2, 2, False)
    assert found["typed"][0][1].endswith("to 300 mm")
    rows, (_, loads, state), verdict = found["force"]
    assert loads[0].endswith("force = [0.0, -0.2]")
    assert state == ["Up-to-date"]
    assert verdict.startswith("A flat strip can be bent into this curve."), (
        "perhaps with a remark on the cord"
    )
    assert "pulls" in found["numbers with all"]
    rows, keeps, (between, *_) = found["pin"]
    assert (keeps, rows[2][:3]) == (True, "Pin")
    assert "at = [" in between[2]
    assert "[" not in found["along the curve"][0][2]
    assert found["hole"][2].endswith("hole = 3.0")
    assert found["removed"][1] == found["closed"] == found["force"][1]
    assert found["undone"][:2] == [["at = 197.0"], []]
    shares = [
        [
            float(word) / length
            for line in (between[1], loads[0])
            for word in re.findall(r"\b[\d.]+(?=,|$)", line)[:2]
        ]
        for length, between, loads in found["kept fractions"]
    ]
    assert found["kept fractions"][0][0] != found["kept fractions"][1][0]
    assert shares[0][:3] == pytest.approx(shares[1][:3], abs=1e-5)  # places have four digits
    assert found["live"]["stations"] == 4
    assert found["live"]["thrust"] >= 4
    assert "line" not in found["live"]
    assert found["live verdict"] == "can"
