"""A strip that closes, in FreeCAD: a ring with its lap, or flat with a tab."""

import FreeCAD as App
import Part
import pytest
from freecad.elastica_wb.features import strip


@pytest.fixture
def ring(document):
    """A sketch with one circle."""
    sketch = document.addObject("Sketcher::SketchObject", "Ring")
    sketch.addGeometry(Part.Circle(App.Vector(), App.Vector(0, 0, 1), 60), False)
    document.recompute()
    return sketch


def test_a_circle_becomes_a_ring_and_its_lap(document, ring):
    feature = strip.create(document, ring)
    feature.Sheet, feature.MaxWidth, feature.Form = "birch-plywood-0.8", 20.0, "Bent"
    document.recompute()
    assert feature.State == ["Up-to-date"], feature.getStatusString()
    assert feature.Shape.isValid()
    made, lap = feature.Shape.Solids
    assert made.Volume == pytest.approx(376.99 * 20 * 0.8, rel=1e-3)
    assert lap.Volume == pytest.approx(10 * 20 * 0.8 * 59.2 / 60, rel=1e-3)
    feature.Form = "Flat"
    document.recompute()
    assert feature.Shape.BoundBox.XLength == pytest.approx(376.99 + 10, abs=0.01)
