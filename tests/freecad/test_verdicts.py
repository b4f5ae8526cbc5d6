"""Three verdicts, DXF without ezdxf, strips that follow their body."""

import re
import sys
from dataclasses import replace
from math import cos, pi, sin

import ezdxf
import FreeCAD as App
import pytest
from freecad.elastica_wb.cutting_files import cutting_of
from freecad.elastica_wb.features import strip
from freecad.elastica_wb.host.words import together
from freecad.elastica_wb.live.curve_picture import curve_picture
from freecad.elastica_wb.solving.strip_cache import find_nearest_now, solve_strip
from freecad.elastica_wb.solving.verdicts import Verdict, refusal_answer, strip_answer, strip_faults

from elastica_cad import ElasticaError, Limits, PlaneCurve, Sheet, StripSpec, save
from elastica_cad.errors import StrainError
from elastica_cad.form_finding.rod_spec import RodSpec
from elastica_cad.mechanics.section_limits import sharpest_bend
from tests.freecad.features import change, new

ARCH = [(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)]
SHOULDERS = [(0, 0), (10, 70), (70, 90), (130, 70), (140, 0)]
BAD = [(0, 0), (40, 60), (80, -60), (120, 20), (160, 30), (180, 0)]


def verdict_on(points, **options):
    return StripSpec(PlaneCurve.spline(points), "birch-plywood-0.8", **{"max_width": 30.0} | options)


def test_what_can_be_made_is_said_so():
    spec = verdict_on(ARCH)
    assert curve_picture(spec.curve, spec).answer.verdict is Verdict.CAN
    assert strip_answer(solve_strip(spec)).verdict is Verdict.CAN


def test_strain_beyond_the_sheet_breaks_at_once():
    spec = verdict_on([(0.5 * x, 0.5 * y) for x, y in ARCH], max_width=15.0)
    quick = curve_picture(spec.curve, spec).answer
    assert quick.verdict is Verdict.BREAKS
    percent = float(quick.words.split(": ")[1].partition(" %")[0])
    assert percent > 100
    assert "would break" in quick.sentence
    with pytest.raises(StrainError) as refused:
        solve_strip(spec)
    for slow in (refusal_answer(refused.value), strip_answer(solve_strip(replace(spec, ignore_limits=True)))):
        assert slow.verdict is Verdict.BREAKS
        assert "would break" in slow.words
        assert float(slow.words.split(": ")[1].partition(" %")[0]) == pytest.approx(percent, abs=3)


def at_its_limit(spec, share):
    """The same request of a sheet that bears `share` of what the curve's sharpest place asks for."""
    strained = solve_strip(spec)
    sheet = replace(spec.material, max_strain=strained.max_strain * share, max_strain_range=None)
    return replace(spec, sheet=sheet)


@pytest.mark.parametrize(
    ("share", "verdict"), [(1.0, Verdict.CAN), (1.01, Verdict.CAN), (0.999, Verdict.BREAKS)]
)
def test_no_green_above_a_hundred_percent(share, verdict):
    """At the limit, a hundredth below, a thousandth above: over 100 % is told where it breaks, and only there."""
    spec = at_its_limit(verdict_on(ARCH), share)
    quick, slow = curve_picture(spec.curve, spec).answer, strip_answer(solve_strip(spec))
    assert [quick.verdict, slow.verdict] == [verdict, verdict]
    result = f"{slow.words} {slow.sentence}" if verdict is Verdict.CAN else slow.words
    (percent,) = (int(number) for number in re.findall(r"(\d+) %", result))
    assert percent == {1.0: 100, 1.01: 99, 0.999: 101}[share]
    assert (percent > 100) == (verdict is Verdict.BREAKS)
    assert ("allows" in slow.sentence) == (verdict is Verdict.BREAKS)


@pytest.mark.parametrize(("points", "share"), [(ARCH, 0.97), (BAD, 0.8), (SHOULDERS, 0.97), (SHOULDERS, 0.6)])
def test_the_nearest_curve_can_be_used(points, share):
    """A rod at the limit of its sheet strays above it once drawn as a spline: what is offered does not."""
    curve = PlaneCurve.spline(points)
    sheet = Sheet.named("birch-plywood-0.8")
    bears = share * sharpest_bend(curve, 0.0)[0] * sheet.thickness / 2
    sheet = replace(sheet, max_strain=bears, max_strain_range=None)
    near = find_nearest_now(RodSpec(curve, limits=Limits(ratio=10, sheet=sheet)))
    assert near.met
    again = StripSpec(near.curve, sheet, max_width=30.0)
    assert curve_picture(near.curve, again).answer.verdict is Verdict.CAN
    assert not {fault.number for fault in strip_faults(solve_strip(again))} & {"LargestStrain", "Length"}


SPIRAL = [(80 * (1 - 0.01 * i) * cos(pi * i / 4), 80 * (1 - 0.01 * i) * sin(pi * i / 4)) for i in range(18)]
LOOP = [(0, 0), (150, 20), (-40, 160), (100, 260), (240, 160), (50, 20), (200, 0)]
WAVY = [(0, 0), (40, 90), (110, 130), (190, 150), (260, 120), (310, 60), (330, -20)]
"""Drawn with degree 3: the slope of its curvature jumps, but the width of the strip does not step."""


@pytest.mark.parametrize(
    ("points", "widest", "failing"),
    [
        (ARCH, 30, {}),
        (SPIRAL, 15, {"Margin": "snaps into another shape", "SidewaysMargin": "tips over sideways"}),
        (LOOP, 12, {"LargestStrain": "strain too large: ", "SidewaysMargin": "tips over sideways"}),
        ([(5 * x, 5 * y) for x, y in ARCH], 650, {"Length": "too short for its width"}),
        (WAVY, 12, {}),
    ],
)
def test_headline_card_and_numbers_agree_on_what_fails(document, drawn, points, widest, failing):
    feature = strip.create(document, drawn(points, 3 if points is WAVY else 4))
    change(feature, Sheet="birch-plywood-0.8", MaxWidth=widest, Anyway=True)
    assert feature.State == ["Up-to-date"], feature.Reasons
    card = strip_answer(strip.strip_of(feature))
    assert (card.verdict is Verdict.CAN) == (not failing)
    assert feature.Verdict.startswith(
        "The strip fails: " if failing else "A flat strip can be bent into this curve."
    )
    assert feature.Fails == list(failing)
    for words in failing.values():
        assert words in feature.Verdict
        assert words in card.words
    for sentence, reason in zip(card.sentence.splitlines() if failing else (), feature.Reasons, strict=False):
        assert sentence[1:9] == reason[1:9]


@pytest.mark.parametrize(("widest", "fails"), [(30.0, True), (1.0, False)])
def test_a_strip_fails_by_steps_that_can_be_seen(widest, fails):
    """Of a pen curve as drawn: its width steps by 10 %."""
    control = [(0, 0), (0, 60), (40, 100), (100, 100), (150, 100), (200, 70), (200, 0)]
    pen = PlaneCurve([0] * 4 + [1] * 3 + [2] * 4, control, 3)
    spec = StripSpec(pen, "birch-plywood-0.8", max_width=widest, smooth=0, ignore_limits=True)
    faults = strip_faults(solve_strip(spec))
    assert ("NarrowestWidth" in {fault.number for fault in faults}) == fails


def test_equal_remarks_are_listed_once_with_their_strips():
    text = [("A", "fails"), ("A", "kinks"), ("B", "fails"), ("C", "takes it"), ("C", "kinks"), ("C", "")]
    assert together(text) == ["A, B: fails", "A, C: kinks", "C: takes it"]


def test_a_sketch_too_small_for_its_strip_is_reported():
    spec = verdict_on([(0.02 * x, 0.02 * y) for x, y in ARCH])
    answer = curve_picture(spec.curve, spec).answer
    assert answer.verdict is Verdict.BREAKS
    assert "30 mm wide" in answer.sentence
    assert "mm long" in answer.sentence


def test_what_cannot_be_bent_and_what_cannot_be_made():
    spec = verdict_on(BAD)
    assert curve_picture(spec.curve, spec).answer.verdict is Verdict.CANNOT
    with pytest.raises(ElasticaError) as refused:
        solve_strip(spec)
    assert refusal_answer(refused.value).verdict is Verdict.CANNOT
    with pytest.raises(ElasticaError) as narrow:
        solve_strip(verdict_on(ARCH, min_width=29.9))
    assert refusal_answer(narrow.value).verdict is Verdict.BREAKS


def test_dxf_without_ezdxf(monkeypatch, tmp_path, check_drawing_file):
    made = solve_strip(verdict_on(ARCH, label="A1"))
    with monkeypatch.context() as bare:
        bare.setitem(sys.modules, "ezdxf", None)
        cutting = cutting_of(version="R2010")
        path = save(made.drawing(), tmp_path / cutting.file_name("A1", "dxf"), **cutting.options(made.sheet))
    assert path.name == "A1-mm.dxf"
    document = ezdxf.readfile(path)
    assert document.dxfversion == "AC1009"
    loops = [curve for curve in check_drawing_file(path) if curve.layer == "CUT_OUTER"]
    assert len(loops) == 1
    assert loops[0].closed
    assert {entity.dxf.layer for entity in document.modelspace()} == {"CUT_OUTER", "ENGRAVE", "MARK"}
    box = made.outline.bounds
    assert loops[0].points.min(axis=0) == pytest.approx(box[0], abs=0.05)
    assert loops[0].points.max(axis=0) == pytest.approx(box[1], abs=0.05)


def test_a_strip_beside_a_body_follows_it(document, sketch):
    body = document.addObject("PartDesign::Body", "Body")
    body.addObject(sketch)
    outside = document.addObject("App::Part", "Elsewhere")
    feature = new(strip.create, document, sketch)
    free = strip.create(document, sketch)
    if free.getParentGeoFeatureGroup() is not None:
        free.getParentGeoFeatureGroup().removeObject(free)
    free.Curve = (sketch, [])
    outside.addObject(free)
    document.recompute()
    assert free.Containers == [body]
    assert body.Group[0] is sketch, "a sketch of a body stays in it"
    before = free.Placement.Base.z
    body.Placement.Base = App.Vector(0, 0, 40)
    document.recompute()
    assert free.Placement.Base.z == pytest.approx(before + 40)
    assert feature.State == ["Up-to-date"]


def mirrored(twin, axes):
    twin.MirrorPlane = (axes["YZ_Plane"], [""])


def in_a_row(twin, axes):
    twin.Direction, twin.Length, twin.Occurrences = (axes["Z_Axis"], [""]), 40, 3  # 30 mm wide: they touch


def about_an_axis(twin, axes):
    twin.Axis, twin.Angle, twin.Occurrences = (axes["Y_Axis"], [""]), 360, 4


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("kind", "arrange", "count"),
    [("Mirrored", mirrored, 2), ("LinearPattern", in_a_row, 3), ("PolarPattern", about_an_axis, 4)],
)
def test_patterns_in_a_body(document, sketch, kind, arrange, count):
    """A body is one solid: copies that touch are one with the strip, as with every feature there."""
    body = document.addObject("PartDesign::Body", "Body")
    body.addObject(sketch)
    feature = new(strip.create, document, sketch)
    volume = body.Shape.Volume
    twin = document.addObject(f"PartDesign::{kind}", kind)
    body.addObject(twin)
    twin.Originals = [feature]
    arrange(twin, {one.Role: one for one in body.Origin.OriginFeatures})
    change(body, Tip=twin)
    assert twin.State == ["Up-to-date"], twin.getStatusString()
    assert twin.Shape.isValid()
    assert 1.2 * volume < body.Shape.Volume <= count * volume * (1 + 1e-6)


def test_strain_use_is_not_capped(document, drawn):
    feature = strip.create(document, drawn([(0.5 * x, 0.5 * y) for x, y in ARCH]))
    change(feature, MaxWidth=15)
    assert feature.StrainUse > 150
    assert feature.Verdict.startswith("A flat strip would break")
    change(feature, Anyway=True)
    assert feature.State == ["Up-to-date"], feature.getStatusString()
    assert feature.StrainUse > 150
    assert feature.Verdict.startswith("A flat strip would break")
