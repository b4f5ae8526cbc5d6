"""Changes after a refusal: one list in Python, command line, page and FreeCAD, and the panel's buttons by mouse."""

import json
from importlib.util import find_spec

import numpy as np
import pytest
from freecad.elastica_wb import make_strip
from freecad.elastica_wb.features.strip import (
    CHANGEABLE,
    changeable,
    strip_of,
    suggestions,
    valid_request,
    values_of,
)
from freecad.elastica_wb.solving.strip_cache import changes_that_help

import elastica_cad as ec
from elastica_cad.cli import main
from elastica_cad.strip.suggestions import suggest
from elastica_cad.web.answers import answer
from elastica_cad.web.saved_design import curve_table

from . import launching
from .features import change

ZIGZAG = [(0, 20), (60, 20), (120, 40), (180, -20), (240, 50), (300, -50)]
WAVE = [(0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (360, 0)]
HOOK = [(0, 0), (40, 90), (90, 110), (150, 60), (170, -20), (230, -60)]
BOW = [(0, 0), (30, 60), (60, 80), (90, 80), (120, 60), (150, 0)]


@pytest.mark.parametrize(
    ("points", "sheet", "fields"),
    [
        (BOW, "oak-3", ["sheet", "size", "nearest"]),
        pytest.param(ZIGZAG, "pom-0.5", ["nearest", "point"], marks=pytest.mark.campaign),
        pytest.param(WAVE, "birch-plywood-0.8", ["between", "nearest"], marks=pytest.mark.campaign),
    ],
)
def test_all_front_ends_list_the_same_changes(points, sheet, fields, drawn, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    curve = ec.PlaneCurve.spline(points, degree=5)
    spec = ec.StripSpec(curve, sheet, max_width=25)
    with pytest.raises(ec.ElasticaError) as refusal:
        spec.make()
    expected = [(one.change.field, one.title, one.effect) for one in suggest(spec, refusal.value)]
    assert [field for field, *_ in expected] == fields

    strip = make_strip(drawn(points, 5), Sheet=sheet, MaxWidth=25, flat_part=False)
    found = changes_that_help(valid_request(strip), changeable(strip))
    assert [(one.change.field, one.title, one.effect) for one in found] == expected

    design = {"schema": 1, "sheet": sheet, "max_width": 25, "strips": [{"curve": curve_table(curve)}]}
    cures = answer({"do": "cures", "design": design})["cures"]
    words = [(title, effect) for _, title, effect in expected]
    assert [(cure["text"], cure["effect"]) for cure in cures] == words

    if find_spec("click") is None:  # FreeCAD 1.1 comes without the command line's library
        return
    ec.write_curves([curve], "curve.json")
    with pytest.raises(SystemExit):
        main(["strip", "curve.json", "--sheet", sheet, "--max-width", "25", "-o", "out", "--json"])
    listed = json.loads(capsys.readouterr().out)["cures"]
    assert [cure["field"] for cure in listed] == fields
    assert all(str(effect) in cure["text"] for cure, (*_, effect) in zip(listed, expected, strict=True))


@pytest.mark.parametrize("field", ["sheet", "nearest"])
def test_a_change_makes_the_strip_of_its_suggestion(drawn, field):
    strip = make_strip(drawn(BOW, 5), Sheet="oak-3", MaxWidth=25, flat_part=False)
    found = changes_that_help(valid_request(strip), changeable(strip))
    suggestion = next(one for one in found if one.change.field == field)
    change(strip, **values_of(strip, suggestion.change))
    assert strip.State == ["Up-to-date"]
    (made,) = suggestion.strips
    assert strip_of(strip).rod.position == pytest.approx(made.rod.position)
    assert strip_of(strip).sheet == made.sheet


def test_no_nearest_curve_is_suggested_with_point_forces(drawn):
    strip = make_strip(drawn(HOOK), MaxWidth=30, flat_part=False)
    assert {"Follow": "Nearest", "RatioLimit": 0.0} in suggestions(strip).values()
    change(strip, Loads=["at = 90, force = [0, -1]"])
    assert suggestions(strip) == {}


def test_a_strip_that_lost_its_curve_keeps_its_other_changes(drawn):
    strip = make_strip(drawn(BOW), flat_part=False)
    assert "point" in changeable(strip)
    strip.Curve = None
    assert changeable(strip) == CHANGEABLE


@pytest.mark.campaign
def test_changes_by_mouse(tmp_path):
    found = launching.run_window("changes.py", tmp_path)
    assert found["searching"] == "Searching for changes that help …"
    assert found["offered"] == found["offered again"]
    assert "nearest curve" in found["offered"][0]  # the moved point is a change more than 10 times as large
    assert found["offered"][1].startswith("Move control point 4 to (")
    assert found["shown"]["nearest"] > 100
    assert "of the drawn curve" in found["tip"]
    poles, verdict, offered, hidden = found["applied"]
    moved = np.linalg.norm(np.subtract(poles, found["drawn"]), axis=1)
    assert np.flatnonzero(moved > 1e-6).tolist() == [3]
    assert verdict.startswith("A flat strip can be bent into this curve.")
    assert (offered, hidden) == ([], True)
    assert found["undone"][0] == found["drawn"]
    assert "cannot" in found["undone"][1]
    words, visible, offered = found["none"]
    assert words.startswith("No change was found")
    assert (visible, offered) == (True, [])
    words, visible, offered = found["not tried"]
    assert words.startswith("Not tried, because the curve has 1 pieces, more than 0.")
    assert (visible, offered) == (True, [])


@pytest.mark.campaign
def test_a_dragged_pole_stops_at_the_border(tmp_path):
    found = launching.run_window("keep.py", tmp_path)
    assert found["stored"] == [True, True]
    before, poles, circles, steps, verdict = found["dragged"]
    assert (steps, verdict) == (1, "")
    assert found["farther"], "it is the border"
    moved = np.linalg.norm(np.subtract(poles, before), axis=1)
    assert np.flatnonzero(moved > 1e-3).tolist() == [2]
    assert np.array(circles) == pytest.approx(np.array(poles), abs=1e-2)
    assert found["undone"] == before
    drags, refused, stopped = found["drags"]
    assert (drags, refused) == (500, [])
    assert 50 < stopped < 450
    assert 90 < found["strained"] < 100.5, "in percent of the limit that the verdict shows"
    assert found["circles"] < 1e-2
    assert found["off"] == [False, True]
