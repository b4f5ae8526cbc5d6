"""Strips that rails, pins, ties and point forces hold: their report and what refuses these elements."""

import json
from dataclasses import replace

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad.design.reports import report_strip
from elastica_cad.design.strip_request import FinishedStrip, request_record
from elastica_cad.errors import InputError
from elastica_cad.mechanics.cross_sections import ThicknessLaw
from elastica_cad.mechanics.theorem1 import NotRealizable
from elastica_cad.strip.holding_template import ends_message, holding_template
from elastica_cad.strip.suggestions import suggest
from elastica_cad.strip.summary import between_rows, strip_rows

WAVE = ec.PlaneCurve.spline(
    [(0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (360, 0)], degree=5
)
SHEET = "birch-plywood-0.8"


def strip_between(*elements, **options):
    return ec.make_strip(WAVE, SHEET, max_width=40, between=elements, **options)


def test_the_report_has_each_force_and_says_what_is_not_checked():
    strip = strip_between(ec.Rail(200), ec.Tie(40, 310))
    rows = {row.label: row for row in strip_rows(strip)}
    rail, tie = strip.bending_stiffness * strip.rod.between_forces
    chord = np.hypot(*np.diff(WAVE.at([40.0, 310.0]).position, axis=0)[0])
    assert abs(rail[0]) < -rail[1], "the rail is above the strip"
    assert rows["Between"].text == (
        f"rail 200 mm from the start pushes the strip downward with {np.hypot(*rail):.2g} N (bar above the strip); "
        f"tie from 40 mm to 310 mm, {chord:.1f} mm long, pulls {np.hypot(*tie):.2g} N"
    )
    assert (
        rows["Stability"].text == "stable: the strip neither snaps into another shape nor tips over sideways"
    )
    assert rows["Accuracy"].text.startswith("not computed")
    report = json.loads(json.dumps(report_strip(strip, name="wave", files={})))
    assert report["sideways"]["margin"] == pytest.approx(strip.sideways.margin, rel=1e-3)
    assert report["held"] is report["measuring"] is None
    assert [element["kind"] for element in report["between"]] == ["rail", "tie"]
    assert report["between"][1]["force"][0] == pytest.approx(tie, rel=1e-3)


def test_loads_keep_their_fraction_of_a_smoothed_curve():
    arch = ec.PlaneCurve.spline([(0, 0), (60, 60), (150, 80), (240, 60), (300, 0)], degree=2)
    loads = (ec.PointMass(arch.length / 4, 1), ec.PointForce(arch.length / 4, (0, -0.01)))
    rod = ec.make_strip(arch, SHEET, max_width=40, smooth=3, gravity=True, loads=loads).rod
    assert abs(rod.length - arch.length) > 1
    assert rod.weight.masses[0].s == pytest.approx(rod.length / 4)
    assert rod.acting[0].s == pytest.approx(rod.length / 4)


def test_no_kink_is_reported_where_the_force_of_a_rail_causes_it():
    points = [(0, 0), (133, 0), (267, 14), (400, 14), (533, 14), (667, 0), (800, 0)]
    slat = ec.PlaneCurve([0.0] * 4 + [1.0] * 3 + [2.0] * 4, points, 3)
    strips = [
        ec.make_strip(slat, "birch-plywood-6", max_width=100, between=rails, smooth=0)
        for rails in (ec.Rail(400), ())
    ]
    kinks = [
        [warning for warning in strip.warnings if "have a corner at" in warning.text] for strip in strips
    ]
    assert [len(found) for found in kinks] == [0, 1]


def test_a_pin_and_a_force_are_reported_and_the_forces_balance():
    loads = (ec.PointMass(150, 50), ec.PointForce(250, (0, -0.2)))
    strip = strip_between(ec.Pin(200), loads=loads, gravity=True)
    text = {row.label: row.text for row in strip_rows(strip)}["Between"]
    pin = strip.bending_stiffness * strip.rod.between_forces[0]
    assert text == (
        f"pin 200 mm from the start pushes the strip with {np.hypot(*pin):.2g} N "
        f"at {np.degrees(np.arctan2(pin[1], pin[0])):.0f} degrees"
    )
    ends = strip.reactions()
    held = ends.start_force + ends.end_force + pin + (0, -0.2)
    newtons = 9.80665e-3 * (strip.mass * strip.rod.length / (strip.rod.length + 20) + 50)  # without two tabs
    assert held == pytest.approx([0, newtons], abs=5e-3)


@pytest.mark.parametrize(("cut", "slides"), [({}, True), ({"hole": 3}, False), ({"notch": 2}, False)])
def test_a_ring_that_would_slide_is_named_unless_the_strip_has_a_cut_for_the_pin(cut, slides):
    text = {
        row.label: row.text for row in strip_rows(strip_between(ec.Rail(200), ec.Pin(60, **cut)), quick=True)
    }
    assert ("a ring would slide" in text["Between"]) == slides


def test_a_pin_that_pushes_across_the_strip_can_be_a_ring():
    rod = ec.optimal_rod(WAVE, between=ec.Pin(200))
    (pin,), angle = rod.between, float(rod.curve.at(rod.between[0].s).angle[0])
    for turn, slides in ((90, False), (-75, False), (70, True), (0, True)):
        direction = np.array([np.cos(angle + np.radians(turn)), np.sin(angle + np.radians(turn))])
        (row,) = between_rows(replace(rod, between=(replace(pin, force=direction[None]),)), 1.0)
        assert ("a ring would slide" in row.text) == slides


@pytest.mark.parametrize(
    ("options", "what"),
    [
        ({"limits": ec.Limits()}, r"a nearest curve.* \(rod.curve\) as the drawn curve, leave out limits"),
        ({"keep": ec.Keep()}, r"a nearest curve.* \(rod.curve\) as the drawn curve, leave out keep"),
        ({"style": ec.Perforated(30), "max_width": None}, "a style other than plain. Leave out style"),
        ({"style": ec.Laminated(30, "card-200gsm"), "max_width": None}, "a style other than plain"),
        (
            {"section": ThicknessLaw(ec.Sheet.named(SHEET), 1, 3, width=20), "max_width": None},
            "a section. Leave out",
        ),
        ({"creep": 0.5}, "creep. Leave out creep"),
        ({"compensate": True}, "compensation of the widths. Leave out compensate"),
        ({"curve": ec.PlaneCurve.ellipse((0, 0), (90, 60))}, "a closed curve. Leave out curve"),
    ],
)
def test_other_tasks_refuse_elements_in_one_sentence(options, what):
    request = {"curve": WAVE, "sheet": SHEET, "max_width": 40} | options
    for element in ({"between": ec.Rail(200)}, {"loads": ec.PointForce(200, (0, -0.1))}):
        with pytest.raises(InputError, match=f"cannot be combined with {what}"):
            ec.StripSpec(**request, **element)


@pytest.mark.parametrize(("width", "sheet"), [(4, SHEET), (40, "mdf-3")])
def test_no_nearest_curve_is_suggested_for_a_strip_with_elements(width, sheet):
    with pytest.raises(InputError) as refused:
        ec.make_strip(WAVE, sheet, max_width=width, between=ec.Rail(200))
    assert "nearest" not in {change.field for change in refused.value.refusal.all_changes}
    assert "nearest" not in str(refused.value)


def test_a_bow_may_have_free_ends():
    flat = ec.Rod.straight(500.0)
    bent = ec.bend(flat, end=(400.0, 0.0), supports=ec.Supports("pinned", "pinned")).curve
    free = ec.Supports("free", "free")
    bow = ec.make_strip(bent, SHEET, max_width=20, supports=free, between=ec.Tie(0, bent.length), smooth=0)
    assert any("400.0 mm long, pulls" in row.text for row in strip_rows(bow))
    with pytest.raises(InputError, match="free to move"):
        ec.StripSpec(bent, SHEET, max_width=20, supports=free)


def test_a_report_makes_the_same_strip_again():
    """Places are then along the rest shape, which is smoothed."""
    spec = ec.StripSpec(
        WAVE, SHEET, max_width=40, smooth=1, between=(ec.Tie(40, 310), ec.Rail(200)),
        loads=ec.PointForce((60, 34), (0, -0.1)),
    )  # fmt: skip
    strip = spec.make()
    record = json.loads(json.dumps(request_record(spec, strip)))
    again = FinishedStrip.read(record, strip.rod.curve).make()
    forces = [made.bending_stiffness * made.rod.between_forces for made in (again, strip)]
    assert forces[0] == pytest.approx(forces[1], abs=0.02 * np.abs(forces[1]).max())
    assert again.width.extremes == pytest.approx(strip.width.extremes, rel=1e-3)


def test_a_strip_on_a_rail_has_fixtures_that_lean_against_its_load():
    held = strip_between(ec.Rail(200))
    loaded = held.as_made.loaded
    far = np.hypot(*(loaded.position - held.as_made.design.position).T).max()
    assert 0 < far < 0.1, "the rail holds the strip as made, too"
    upside_down = WAVE.transformed(np.diag([1.0, -1.0, 1.0]))
    other = ec.make_strip(upside_down, SHEET, max_width=40, between=ec.Rail(200))
    lean, opposite = (ec.model.EndFixture.of(strip, "start").lean for strip in (held, other))
    assert abs(lean[1]) > 0
    assert lean == pytest.approx([-value for value in opposite], rel=1e-3)
    with pytest.raises(InputError, match="as made"):
        held.held()


def test_the_report_has_the_displacement_by_errors_in_mounting():
    strip = strip_between(ec.Rail(200), ec.Tie(40, 310))
    text = {row.label: row.text for row in strip_rows(strip)}["Mounting"]
    rail, tie = (element["moved_per_mm"] for element in report_strip(strip, name="wave", files={})["between"])
    assert text == (
        f"if mounted with an error of 0.5 mm, the rail 200 mm from the start moves the strip by "
        f"{rail / 2:.2g} mm; the tie from 40 mm to 310 mm moves the strip by {tie / 2:.2g} mm"
    )
    assert "Mounting" not in {row.label for row in strip_rows(strip, quick=True)}


def test_a_pin_out_of_reach_after_a_mounting_error_has_a_row_of_its_own():
    rows = strip_rows(strip_between(ec.Rail(200), ec.Pin(345)))
    assert [row.stops for row in rows if row.label == "Mounting"] == [True, False]
    first, second = (row.text for row in rows if row.label == "Mounting")
    assert first.startswith(
        "the pin 345 mm from the start allows an error of at most 0.34 mm, because the strip from 345 mm to 394 mm "
        "is almost straight and reaches no farther."
    )
    assert "pin" not in second
    assert not any(
        "allows an error" in row.text for row in strip_rows(strip_between(ec.Rail(200), ec.Pin(330)))
    )


def test_a_pin_whose_error_moves_the_strip_far_is_marked_and_suggested_last(tmp_path):
    poles = "0 -21.2 \n 50 16 \n 100 -18.4 \n 150 14.2 \n 200 -24 \n 250 9.1 \n 300 -21.3 \n 350 4.3"
    (tmp_path / "wave.txt").write_text(f"4 8\n{poles}\n")
    (curve,) = ec.read_curves(tmp_path / "wave.txt")
    spec = ec.StripSpec(curve, "polypropylene-0.6", max_width=30)
    with pytest.raises(NotRealizable) as refused:
        spec.make()
    *_, last = suggest(spec, refused.value, {"nearest", "between"})
    assert "; a small mounting error moves the strip far; build the pin" in str(last)
    (row,) = (row for row in strip_rows(last.strips[0]) if row.label == "Mounting")
    assert row.stops
    assert "moves the strip by 8.1 mm. Movements above 3 % of the length are large" in row.text


def test_a_shallow_strip_rests_as_designed_if_its_ends_are_closer_by_its_compression():
    """A strip is cut as long as drawn, so it is shorter under the designed force."""
    (slat,) = ec.read_curves("examples/slat/slat.svg")
    strip = ec.make_strip(slat, "birch-plywood-6", max_width=60, between=ec.Rail(350))
    (row,) = (row for row in strip_rows(strip) if row.label == "Hold")
    change = strip.compressed_length
    assert f"set the ends {change:.2f} mm closer" in " ".join([row.text, *row.details])
    rod = strip.rod_to_bend
    uncompressed = replace(rod.compression, pull=np.zeros_like(rod.compression.pull))
    cut = replace(rod, compression=uncompressed)
    x, y = rod.position[-1]
    thrusts = [float(np.hypot(*ec.bend(cut, end=(x - by, y)).support_forces[0])) for by in (0.0, change)]
    designed = float(np.hypot(*rod.support_forces[0]))
    assert abs(thrusts[1] / designed - 1) < 0.02 < abs(thrusts[0] / designed - 1)


def test_a_high_strip_has_no_advice_on_its_compression():
    arch = ec.PlaneCurve.spline([(0, 0), (100, 75), (200, 100), (300, 75), (400, 0)])
    strip = ec.make_strip(arch, "birch-plywood-0.8", max_width=40)
    (row,) = (row for row in strip_rows(strip) if row.label == "Hold")
    assert "closer" not in row.text


def bow_with_cord(**options):
    ends = ec.Supports("free", "free")
    straight = ec.Rod.straight(600.0, samples=241)
    bent = ec.bend(straight, between=ec.Tie(100, 500, length=330), side=1, supports=ends)
    return ec.make_strip(
        bent.curve, "gfrp-1", max_width=20, between=ec.Tie(100, 500, hole=3), supports=ends, **options
    )


def test_a_free_end_has_no_tab_by_default():
    assert [tab.length for tab in bow_with_cord().ends] == [0.0, 0.0]
    assert [tab.length for tab in bow_with_cord(ends=ec.Tab(10)).ends] == [10.0, 10.0]
    cantilever = ec.make_strip(WAVE, SHEET, max_width=40, between=ec.Rail(200))
    assert [tab.length for tab in cantilever.ends] == [10.0, 10.0]


@pytest.mark.parametrize(("tab", "first"), [(0, 100.0), (25, 125.0)])
def test_the_holes_of_cords_are_listed_from_the_cut_end(tab, first):
    strip = bow_with_cord(ends=ec.Tab(tab))
    (row,) = [row for row in strip_rows(strip) if row.label == "Holes"]
    assert f"holes of 3 mm at {first:g} and {first + 400:g} mm" in row.text
    left = strip.outline.bounds[0][0]
    middles = sorted(float(np.mean(hole.bounds[:, 0])) - left for hole in strip.layers[0].holes)
    assert middles == pytest.approx([first, first + 400], abs=0.05)


def test_nothing_holds_free_ends():
    strip = bow_with_cord()
    (row,) = [row for row in strip_rows(strip) if row.label == "Hold"]
    assert row.text.startswith("both ends are free: nothing holds them; they rest ")
    texts = [text.text for text in holding_template(strip).texts]
    assert any(text.startswith("start (1)") and "free: nothing holds it" in text for text in texts)
    assert str(ends_message(strip)).startswith("nothing holds the free ends")
