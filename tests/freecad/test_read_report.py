"""The line of what was read of picked edges and of sketches."""

import re

import FreeCAD as App
import Part
import pytest
from freecad.elastica_wb.curves.sketch_curves import read_line
from freecad.elastica_wb.host import words
from freecad.elastica_wb.host.words import worded

from elastica_cad import InputError

SPLINE = [(0, 0), (40, 80), (140, 80), (180, 0)]


def bezier(points):
    curve = Part.BezierCurve()
    curve.setPoles([App.Vector(*point) for point in points])
    return curve


def feature(document, *curves):
    made = document.addObject("Part::Feature", "Drawn")
    made.Shape = Part.Compound([Part.Edge(curve) for curve in curves])
    return made


def test_a_sketched_spline_is_read_exactly(document, sketch):
    points = sketch.Shape.Edges[0].discretize(2001)
    width, height = (max(p[i] for p in points) - min(p[i] for p in points) for i in (0, 1))
    line = (
        f"Read: {width:.1f} x {height:.1f} mm (unit from the document), 1 spline, read without approximation."
    )
    assert read_line((sketch, ())) == line


def test_a_pole_that_is_dragged_is_read_where_it_is_now(document, sketch):
    spline = sketch.Geometry[0].copy()
    spline.scale(App.Vector(), 2)
    assert read_line((sketch, ()), [spline]).startswith("Read: 300.0 x ")


def test_edges_that_are_picked_are_counted_joined_and_turned(document):
    line = Part.LineSegment(App.Vector(180, 0, 0), App.Vector(220, 0, -80))
    circle = Part.Circle(App.Vector(900, 0, 0), App.Vector(0, 0, 1), 50)
    made = feature(document, bezier([(x, 0, y) for x, y in SPLINE]), line, circle)
    joined = "(unit from the document), 1 spline, 1 line, joined, turned, read without approximation"
    assert read_line((made, ("Edge1", "Edge2"))) == f"Read: 220.0 x 140.0 mm {joined}."
    assert "100.0 x 100.0 mm (unit from the document), 1 arc, read without approximation" in read_line(
        (made, ("Edge3",))
    )
    with pytest.raises(InputError, match="separate chains"):
        read_line((made, ()))


def test_the_distance_of_a_bounded_end_is_reported(document):
    first = bezier([(0, 0), (0, 0), (80, 80), (180, 0)])
    line = read_line((feature(document, first), ()))
    far = float(re.search(r"within (\S+) mm of the drawing", line)[1])
    assert 1e-3 < far < 0.005


def test_the_line_is_in_german_with_commas(document, sketch, monkeypatch):
    monkeypatch.setattr(words, "user_language", lambda: "de")
    monkeypatch.setattr(words, "decimal_point", lambda: ",")
    german = "Gelesen: 150,0 x 60,0 mm (Einheit aus dem Dokument), 1 Spline, ohne Näherung gelesen."
    assert worded(read_line((sketch, ()))) == german
