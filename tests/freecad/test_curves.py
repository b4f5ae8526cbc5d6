"""Curves as features: the nearest one, one bent further, sections. They follow what they are made from."""

import FreeCAD as App
import Part
import pytest
from freecad.elastica_wb.features import curves, strip

from tests.freecad.features import change, new

V = App.Vector
SNAKE = [(0, 0), (40, 60), (80, -60), (120, 20), (160, 30), (180, 0)]


def ok(*objects):
    for obj in objects:
        assert obj.State == ["Up-to-date"], obj.getStatusString()


def ends(obj):
    edge = obj.Shape.Edges[0]
    return [tuple(edge.valueAt(t)) for t in edge.ParameterRange]


def test_the_nearest_curve_follows_its_sketch(document, drawn, move_pole):
    source = drawn(SNAKE)
    near = curves.nearest(document, source)
    near.LimitStrain = False
    made = strip.create(document, near)
    change(made, Sheet="card-200gsm")
    ok(near, made)
    assert near.Deviation.Value > 0.5
    assert near.Ratio <= 3.5 + 1e-6
    before = near.Shape.Length
    move_pole(source, 3, (120, 45))
    document.recompute()
    ok(near, made)
    assert near.Shape.Length != pytest.approx(before, rel=1e-3)
    assert made.Length.Value == pytest.approx(near.Shape.Length, rel=1e-6)
    source.Placement.Base.z = 20
    document.recompute()
    assert [place[2] for place in ends(near)] == pytest.approx([20, 20])


def test_the_nearest_curve_moves_with_the_part_of_its_sketch(document, drawn):
    part = document.addObject("App::Part", "Part")
    source = drawn(SNAKE)
    part.addObject(source)
    near = curves.nearest(document, source)
    near.LimitStrain = False
    assert near.getParentGeoFeatureGroup() is part
    part.Placement.Base = V(0, 0, 7)
    document.recompute()
    ok(near)
    assert near.getGlobalPlacement().Base.z == pytest.approx(7)


def test_a_nearest_curve_drawn_into_its_sketch(document, drawn):
    source = drawn(SNAKE)
    near = curves.nearest(document, source)
    change(near, LimitStrain=False)
    length = near.Shape.Length
    curves.draw_into(near)
    document.recompute()
    assert document.getObject("Nearest") is None
    assert source.Shape.Edges[0].Length == pytest.approx(length, rel=1e-6)
    made = strip.create(document, source)
    change(made, Sheet="card-200gsm")
    ok(made)


def test_a_nearest_curve_as_a_sketch_to_edit(document, drawn):
    source = drawn(SNAKE)
    near = curves.nearest(document, source)
    change(near, LimitStrain=False)
    length = near.Shape.Length
    curves.nearest_sketch(near)
    document.recompute()
    (copy,) = [o for o in document.Objects if o.TypeId == "Sketcher::SketchObject" and o is not source]
    assert copy.Shape.Edges[0].Length == pytest.approx(length, rel=1e-6)


def test_a_bent_strip_follows_its_strip(document, sketch, move_pole):
    made = new(strip.create, document, sketch)
    further = curves.bent(document, made, EndX=-20.0)
    document.recompute()
    ok(further)
    assert ends(further)[1] == pytest.approx((130, 0, 0), abs=1e-3)
    assert further.LargestMove.Value == pytest.approx(20, abs=0.1)
    assert further.Margin > 0
    further.StartX = 5
    move_pole(sketch, 4, (150, 10))
    document.recompute()
    ok(made, further)
    assert ends(further) == [pytest.approx((5, 0, 0), abs=1e-3), pytest.approx((130, 10, 0), abs=1e-3)]
    document.removeObject(made.Name)
    document.recompute()
    assert "strip is missing" in further.getStatusString()


def test_sections_follow_their_body(document):
    cylinder = document.addObject("Part::Cylinder", "Cylinder")
    change(cylinder, Radius=40, Height=100)
    cuts = curves.section(document, [cylinder])
    cuts.Axis, cuts.Count, cuts.Closed = "Z", 3, "left and right"
    made = new(strip.create, document, cuts, ("Edge2",))
    ok(cuts, made)
    assert cuts.Curves == len(cuts.Shape.Edges) == 6
    assert made.Length.Value == pytest.approx(40 * 3.14159, rel=1e-3)
    change(cylinder, Radius=50)
    ok(cuts, made)
    assert made.Length.Value == pytest.approx(50 * 3.14159, rel=1e-3)
    change(cuts, Count=1)
    ok(cuts, made)
    change(cuts, Closed="left out")
    assert "closed" in cuts.getStatusString()


def test_sections_along_a_path_and_as_sketches(document, sketch):
    tube = document.addObject("Part::Feature", "Shell")
    face = Part.BSplineSurface()
    across = (-60, -30, 0, 30, 60)
    face.interpolate([[V(x, y, 40 - x * x / 90 - y * y / 160) for y in across] for x in across])
    tube.Shape = face.toShape()
    path = document.addObject("Part::Feature", "Path")
    change(path, Shape=Part.makeLine(V(-40, 0, 0), V(40, 0, 0)))
    cuts = curves.section(document, [tube], (path, ()))
    change(cuts, Count=3)
    ok(cuts)
    assert [edge.valueAt(0).x for edge in cuts.Shape.Edges] == pytest.approx([-80 / 3, 0, 80 / 3], abs=1e-3)
    change(path, Shape=Part.makeLine(V(-30, 0, 0), V(30, 0, 0)))
    assert cuts.Shape.Edges[0].valueAt(0).x == pytest.approx(-20, abs=1e-3)
    curves.section_sketches_of(cuts)
    document.recompute()
    assert document.getObject("Section") is None or document.getObject("Section").TypeId.startswith(
        "Sketcher"
    )
    assert len(document.getObject("Curves").Group) == 3


def test_a_strip_smooths_its_curve(document):
    """Two arcs that meet without a jump of direction, but with one of curvature."""
    sketch = document.addObject("Sketcher::SketchObject", "Arcs")
    first = Part.ArcOfCircle(Part.Circle(V(0, 0, 0), V(0, 0, 1), 100), 1.5708, 2.4)
    second = Part.ArcOfCircle(Part.Circle(V(0, 20, 0), V(0, 0, 1), 80), 0.8, 1.5708)
    sketch.addGeometry([first, second], False)
    made = new(strip.create, document, sketch)
    rough = made.Ratio
    change(made, Smooth=0.5)
    ok(made)
    assert 0 < made.Deviation.Value <= 0.5
    assert made.Ratio != pytest.approx(rough, rel=1e-6)
