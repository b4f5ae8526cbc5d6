"""The sketcher draws splines of degree 3, whose curvature has kinks at the knots: strips have none."""

import FreeCAD as App
import numpy as np
import Part
from freecad.elastica_wb.curves.sketch_curves import drawn_curve
from freecad.elastica_wb.features import strip
from freecad.elastica_wb.features.strip_request import spec_of

WAVY = [(0, 0), (40, 90), (110, 130), (190, 150), (260, 120), (310, 60), (330, -20)]


def sharpest_kink(made):
    """Largest change of the slope of the width from one of 2001 stations to the next, away from the ends."""
    s = np.linspace(0, made.width.length, 2001)
    return np.abs(np.diff(np.gradient(made.width(s), s)))[20:-20].max()


def test_no_kink_in_a_strip_of_a_drawn_spline(document, drawn):
    cubic = strip.create(document, drawn(WAVY, 3))
    document.recompute()
    assert cubic.State == ["Up-to-date"], cubic.Reasons
    curve = drawn_curve(cubic.Curve)
    as_drawn = spec_of(cubic, curve).changed(smooth=0.0).make()
    assert sharpest_kink(strip.strip_of(cubic)) < 0.1 * sharpest_kink(as_drawn)
    assert 0 < cubic.Deviation.Value <= 0.1
    assert [reason.partition(":")[0] for reason in cubic.Reasons] == [
        "A spline of degree 3 would give the strip kinks"
    ]


def test_what_has_no_kinks_is_followed_exactly(document, drawn):
    quartic = strip.create(document, drawn(WAVY, 4))
    document.recompute()
    assert (quartic.Deviation.Value, quartic.Reasons) == (0, [])


def test_arcs_and_lines_are_followed_exactly(document):
    sketch = document.addObject("Sketcher::SketchObject", "Sketch")
    center, axis = App.Vector(0, 0, 0), App.Vector(0, 0, 1)
    sketch.addGeometry(Part.ArcOfCircle(Part.Circle(center, axis, 100), 0, 1.5), False)
    document.recompute()
    made = strip.create(document, sketch)
    document.recompute()
    assert made.Deviation.Value == 0
