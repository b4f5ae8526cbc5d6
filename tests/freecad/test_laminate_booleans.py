"""The two sheets of a bent laminate do not touch: of solids that do, Part's booleans lose one."""

import FreeCAD as App
import Part
import pytest
from freecad.elastica_wb.solving.strip_cache import bent_shape

from elastica_cad import Laminated, PlaneCurve, make_strip


def test_a_cut_laminate_is_the_sum_of_its_cut_sheets():
    curve = PlaneCurve.spline([(20, 0), (40, 60), (70, 80), (120, 60), (150, 0)])
    body = bent_shape(make_strip(curve, "pom-0.5", style=Laminated(width=30.0, backing="pom-0.5")))
    middle = body.BoundBox.Center
    half = Part.makeBox(400, 400, 400, App.Vector(middle.x, middle.y - 200, -200))
    sheets = sum(solid.cut(half).Volume for solid in body.Solids)
    assert body.cut(half).Volume == pytest.approx(sheets, rel=1e-6)
    assert body.common(half).Volume == pytest.approx(body.Volume - sheets, rel=1e-6)
