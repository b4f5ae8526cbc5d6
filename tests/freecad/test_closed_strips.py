"""A strip that closes, in FreeCAD: a ring with its lap, or flat with a tab."""

from math import cos, pi, sin

import FreeCAD as App
import Part
import pytest
from freecad.elastica_wb.curves.sketch_curves import drawn_curve
from freecad.elastica_wb.features import strip

from tests.freecad.features import change


@pytest.fixture
def ring(document):
    """A sketch with one circle."""
    sketch = document.addObject("Sketcher::SketchObject", "Ring")
    sketch.addGeometry(Part.Circle(App.Vector(), App.Vector(0, 0, 1), 60), False)
    document.recompute()
    return sketch


def test_a_circle_becomes_a_ring_and_its_lap(document, ring):
    feature = strip.create(document, ring)
    change(feature, Sheet="birch-plywood-0.8", MaxWidth=20.0, Form="Bent")
    assert feature.State == ["Up-to-date"], feature.getStatusString()
    assert feature.Shape.isValid()
    made, lap = feature.Shape.Solids
    assert made.Volume == pytest.approx(376.99 * 20 * 0.8, rel=1e-3)
    assert lap.Volume == pytest.approx(10 * 20 * 0.8 * 59.2 / 60, rel=1e-3)
    change(feature, Form="Flat")
    assert feature.Shape.BoundBox.XLength == pytest.approx(376.99 + 10, abs=0.01)


def periodic(degree, count=14):
    """A smooth oval without a corner anywhere, as the sketcher's tool for periodic splines draws it."""
    turns = [2 * pi * i / count for i in range(count)]
    poles = [App.Vector((100 + 12 * cos(2 * a)) * cos(a), (100 + 12 * cos(2 * a)) * sin(a), 0) for a in turns]
    spline = Part.BSplineCurve()
    spline.buildFromPolesMultsKnots(poles, [1] * (count + 1), range(count + 1), True, degree, [1.0] * count)
    return spline


@pytest.mark.parametrize("degree", [3, 4, 6])
def test_a_periodic_spline_closes_without_a_corner(document, degree):
    sketch = document.addObject("Sketcher::SketchObject", "Oval")
    sketch.addGeometry(periodic(degree), False)
    feature = strip.create(document, sketch)
    change(feature, Sheet="birch-plywood-0.8", MaxWidth=20.0)
    assert feature.State == ["Up-to-date"], feature.getStatusString()
    assert feature.Length.Value == pytest.approx(sketch.Shape.Length, abs=0.1)


@pytest.mark.parametrize("ends", [(2, 5), (10.2, 18), (3, 17), (3.3, 17.3)])
def test_a_part_of_a_periodic_spline_may_run_over_its_seam(document, ends):
    source = document.addObject("Part::Feature", "Part")
    source.Shape = periodic(3).toShape(*ends)
    curve = drawn_curve((source, ())).curve
    assert curve.length == pytest.approx(source.Shape.Length, rel=1e-8)
    assert curve.is_closed == (ends[1] - ends[0] == 14)
    assert (curve.knots[curve.degree], curve.knots[-curve.degree - 1]) == (curve.knots[0], curve.knots[-1])
