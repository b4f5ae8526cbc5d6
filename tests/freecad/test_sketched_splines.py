"""A sketched spline is smoothed by its continuity: strip, overlay and check show the same curve."""

import re

import FreeCAD as App
import numpy as np
import Part
import pytest
from freecad.elastica_wb.curves.sketch_curves import drawn_curve
from freecad.elastica_wb.features import flexure, strip
from freecad.elastica_wb.features.strip_properties import FIELDS, PROPERTIES, spec_of
from freecad.elastica_wb.live.curve_picture import curve_picture

from elastica_cad.form_finding import fairing_request
from tests.freecad.features import change, new

WAVY = [(0, 0), (40, 90), (110, 130), (190, 150), (260, 120), (310, 60), (330, -20)]
PEN = [(0, 0), (30, 60), (80, 70), (120, 40), (160, 10), (200, 10), (240, 60)]
"""Two Bezier pieces; where they meet the bending is reversed by a jump of the curvature."""
PIECES = (0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2)


@pytest.mark.parametrize(("degree", "options"), [(3, {"AsDrawn": True}), (4, {})])
def test_a_spline_without_corners_or_kept_as_drawn_is_followed_exactly(document, drawn, degree, options):
    made = new(strip.create, document, drawn(WAVY, degree))
    change(made, **options)
    assert made.State == ["Up-to-date"], made.Reasons
    assert made.Deviation.Value == 0
    curve = drawn_curve(made.Curve).curve
    assert np.array_equal(strip.strip_of(made).rod.curve.control_points, curve.control_points)


def test_the_distance_counts_although_the_curve_is_kept_as_drawn_without_it(document, drawn):
    made = new(strip.create, document, drawn(WAVY, 3))
    by_default = made.Deviation.Value
    assert 0 < by_default <= 0.1
    assert any(reason.startswith("The curvature jumped or had a kink") for reason in made.Reasons)
    change(made, AsDrawn=True)
    assert made.Deviation.Value == 0
    change(made, Smooth=0.05)
    assert 0 < made.Deviation.Value <= 0.05


def test_no_help_of_an_option_gives_0_a_meaning_where_0_is_the_default():
    """A property has no state without a value: 0 stands for the default of an optional field."""
    fields = [*FIELDS.values(), *(field for _, field in flexure.FIELDS.values())]
    helps = [field.help for field in fields if field.default is None]
    assert len(helps) > 5
    assert [words for words in helps if re.search(r"\b0\b", words)] == []


def test_the_help_of_smooth_names_the_distance_of_0(document, drawn):
    (text,) = (entry.help for entry in PROPERTIES if entry.name == "Smooth")
    within = float(re.search(r"; 0 removes only .* within ([\d.]+) mm", text)[1])
    made = new(strip.create, document, drawn(WAVY, 3))
    assert made.Smooth.Value == 0
    assert 0 < made.Deviation.Value <= within


@pytest.mark.parametrize("as_drawn", [True, False])
def test_strips_of_earlier_files_keep_their_curve(document, drawn, as_drawn):
    made = new(strip.create, document, drawn(WAVY, 3))
    change(made, AsDrawn=as_drawn)
    deviation = made.Deviation.Value
    made.removeProperty("AsDrawn")
    made.Proxy.onDocumentRestored(made)
    assert made.AsDrawn is as_drawn
    made.touch()
    document.recompute()
    assert made.Deviation.Value == deviation


def test_overlay_and_strip_follow_the_smoothed_curve(document, drawn):
    made = new(strip.create, document, drawn(PEN, 3, knots=PIECES))
    assert made.State == ["Up-to-date"], made.Reasons
    assert 0 < made.Deviation.Value <= 0.1
    assert any(reason.startswith("The curvature jumped") for reason in made.Reasons)
    source = drawn_curve(made.Curve)
    spec, rod = spec_of(made, source), strip.strip_of(made).rod
    picture = curve_picture(source.curve, spec)
    assert picture.realizable
    (dot,) = picture.on_line
    (s,) = rod.curve.inflections
    assert dot == pytest.approx(rod.curve.at(s).position[0], abs=1e-6)
    as_drawn = curve_picture(source.curve, spec.changed(smooth=0.0))
    assert not as_drawn.realizable


def test_arcs_and_lines_are_followed_exactly(document):
    sketch = document.addObject("Sketcher::SketchObject", "Sketch")
    center, axis = App.Vector(0, 0, 0), App.Vector(0, 0, 1)
    sketch.addGeometry(Part.ArcOfCircle(Part.Circle(center, axis, 100), 0, 1.5), False)
    document.recompute()
    made = new(strip.create, document, sketch)
    assert made.Deviation.Value == 0


BENDS = [(0, 0), (40, 60), (80, -60), (120, 20), (160, 30), (180, 0)]
"""No flat strip takes this curve."""


@pytest.mark.parametrize(
    ("points", "scale", "knots", "options", "fails"),
    [
        (PEN, 1.1, PIECES, {}, False),
        (PEN, 0.2, PIECES, {}, True),
        (PEN, 1.2, PIECES, {"MinWidth": 29.0}, True),
        (BENDS, 1.0, None, {"Smooth": 0.5}, True),
    ],
    ids=["made", "too sharp", "too narrow", "not realizable"],
)
def test_a_curve_is_smoothed_once_for_results_and_errors(
    document, drawn, monkeypatch, points, scale, knots, options, fails
):
    """FreeCAD recomputes a failed strip at each change of the document."""
    smoothed, fair = [], fairing_request.fair_curve
    monkeypatch.setattr(
        fairing_request, "fair_curve", lambda curve, *rest: smoothed.append(curve) or fair(curve, *rest)
    )
    made = strip.create(document, drawn([(scale * x, scale * y) for x, y in points], 3, knots=knots))
    change(made, **options)
    reasons, state = made.Reasons, made.State
    assert ("Invalid" in state) == fails
    for x in (1, 2):
        made.touch()
        change(document.getObject("Box") or document.addObject("Part::Box", "Box"), Length=x)
        assert [made.Reasons, made.State] == [reasons, state]
    assert len(smoothed) == 1
