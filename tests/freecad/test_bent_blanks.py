"""Strips whose blank is bent beforehand: whoever cuts or mounts one is told, as no cut pattern shows it."""

import csv
import re

import FreeCAD as App
import pytest
from freecad.elastica_wb.curves.sketch_curves import drawn_curve
from freecad.elastica_wb.cutting_files import write_cutting_files
from freecad.elastica_wb.features import curves, flat, model, nest, strip
from freecad.elastica_wb.features.pieces import cuts_of, pre_bend_messages_of
from freecad.elastica_wb.features.strip_properties import nearest_spec_of

from tests.freecad.features import change, new

UPRIGHT = App.Rotation(App.Vector(1, 0, 0), 90)
BAD = [(0, 0), (40, 60), (80, -60), (120, 20), (160, 30), (180, 0)]
EVEN = (
    "Before assembly, bend the strip to a radius of 250 mm along its whole length. The inner face of this "
    "bend is also the inner face at 94.4 mm from the start after assembly. The widths are designed for "
    "this pre-bending."
)


@pytest.fixture
def bent(document, sketch):
    """A strip that is bent beforehand all along."""
    made = strip.create(document, sketch)
    change(made, NaturalCurvature=-0.004)
    return made


def test_a_strip_reports_its_blank_first(document, bent):
    assert bent.Verdict == "A pre-bent strip can be bent into this curve."
    assert bent.Reasons[0] == EVEN
    change(bent, Thickness=4)
    assert bent.Verdict.startswith("A pre-bent strip would break on this curve.")
    change(bent, Thickness=0.8, Follow="Nearest", RatioLimit=1.2)
    assert re.match(".* it can take a curve at most .* mm from it", bent.Verdict), bent.Verdict
    change(bent, NaturalCurvature=0.0, Follow="Exactly")
    assert [bent.Verdict, bent.Reasons] == ["A flat strip can be bent into this curve.", []]


def test_a_curve_that_such_a_strip_cannot_take(document, drawn):
    made = strip.create(document, drawn(BAD))
    change(made, NaturalCurvature=-0.0005)
    assert made.Verdict == "A pre-bent strip cannot take this curve."


def test_a_blank_along_the_strip_is_the_property_blank(document, bent):
    change(bent, Blank="stations = [0, 101, 202.2], curvatures = [0, -0.01, 0]")
    assert bent.Reasons[0].startswith(
        "Before assembly, bend the strip; the smallest radius is 100 mm, at 101 mm from the start. "
    )
    assert 'list the curvature along the strip (property "Blank").' in bent.Reasons[0]


def test_what_is_cut_reports_it(document, bent, drawn, tmp_path):
    flat.create(document, bent)
    straight = strip.create(document, drawn([(x, y + 200) for x, y in [(0, 0), (60, 60), (120, 0)]], 2))
    laid = new(nest.create, document, [bent, straight])
    result = f"{bent.Label}: {EVEN}"
    assert pre_bend_messages_of(cuts_of([bent, straight])) == laid.Reports == [result]
    write_cutting_files([bent, straight], tmp_path, kinds=["csv", "dxf"])
    with (tmp_path / "cut-list.csv").open(encoding="utf-8") as file:
        rows = {row["part"]: row for row in csv.DictReader(file)}
    assert {name: row["bent_beforehand"] for name, row in rows.items()} == {
        bent.Label: EVEN,
        straight.Label: "",
    }
    write_cutting_files([straight], tmp_path / "flat", kinds=["csv"])
    assert "beforehand" not in (tmp_path / "flat" / "cut-list.csv").read_text(encoding="utf-8")


def test_a_model_names_the_strips_that_are_bent_alike(document, bent):
    bent.Curve[0].Placement = App.Placement(App.Vector(), UPRIGHT)
    other = document.copyObject(bent)
    other.Label, bent.Label = "Other", "One"
    flatly = document.copyObject(bent)
    flatly.Label, flatly.NaturalCurvature = "Flatly", 0.0
    whole = new(model.create, document, [bent, other, flatly], interlock=False)
    assert whole.Reports == pre_bend_messages_of(cuts_of([whole])) == [f"One, Other: {EVEN}"]


def test_both_layers_of_a_laminate_are_reported(document, bent):
    bent.Style, bent.Backing, bent.Anyway = "Laminated", bent.Sheet, True  # it is bent beyond its limit
    document.recompute()
    (result,) = pre_bend_messages_of(cuts_of([bent]))
    assert re.match(rf"{bent.Label}\b.*, {bent.Label}.*: Before assembly, bend", result)


def test_the_nearest_curve_is_sought_for_the_same_blank(document, bent, sketch):
    """What is drawn for a strip bent beforehand is near for that one: a flat one has other curves."""
    bent.Follow, bent.RatioLimit = "Nearest", 1.2
    alone = curves.nearest(document, sketch)
    change(alone, RatioLimit=1.2, NaturalCurvature=-0.004)
    assert alone.State == ["Up-to-date"], alone.getStatusString()
    assert alone.Deviation.Value == pytest.approx(bent.Deviation.Value, rel=1e-3)
    assert nearest_spec_of(bent, drawn_curve(bent.Curve, bent)).natural_curvature == -0.004
    change(alone, NaturalCurvature=0.0)
    assert abs(alone.Deviation.Value - bent.Deviation.Value) > 0.05 * bent.Deviation.Value
