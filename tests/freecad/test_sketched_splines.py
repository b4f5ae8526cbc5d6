"""A sketched spline is smoothed by its continuity: strip, overlay and check show the same curve."""

import FreeCAD as App
import numpy as np
import Part
import pytest
from freecad.elastica_wb.curves.sketch_curves import drawn_curve
from freecad.elastica_wb.features import strip
from freecad.elastica_wb.features.strip_properties import spec_of
from freecad.elastica_wb.live.curve_picture import curve_picture

from tests.freecad.features import new

WAVY = [(0, 0), (40, 90), (110, 130), (190, 150), (260, 120), (310, 60), (330, -20)]
PEN = [(0, 0), (30, 60), (80, 70), (120, 40), (160, 10), (200, 10), (240, 60)]
"""Two Bezier pieces; where they meet the bending is reversed by a jump of the curvature."""
PIECES = (0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2)


@pytest.mark.parametrize("degree", [3, 4])
def test_a_spline_of_continuous_curvature_is_followed_exactly(document, drawn, degree):
    made = new(strip.create, document, drawn(WAVY, degree))
    assert made.State == ["Up-to-date"], made.Reasons
    assert made.Deviation.Value == 0
    curve = drawn_curve(made.Curve).curve
    assert np.array_equal(strip.strip_of(made).rod.curve.control_points, curve.control_points)


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
