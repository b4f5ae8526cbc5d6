"""Bodies, surfaces and meshes cut by families of planes into curves for strips."""

import FreeCAD as App
import Mesh
import numpy as np
import Part
import pytest
from freecad.elastica_wb.curves.plane_sections import (
    CLOSED,
    Family,
    chosen_bodies,
    curves_of,
    cut,
    path_points,
    section_sketches,
)
from freecad.elastica_wb.features import curves, strip

from elastica_cad import InputError, NotConvergedError
from tests.freecad.features import change, new

RADIUS = 50.0


@pytest.fixture
def shell(document):
    """A doubly curved surface."""
    face = Part.BSplineSurface()
    across = (-60, -30, 0, 30, 60)
    face.interpolate([[App.Vector(x, y, 40 - x * x / 90 - y * y / 160) for y in across] for x in across])
    body = document.addObject("Part::Feature", "Shell")
    change(body, Shape=face.toShape())
    return body


@pytest.fixture
def ball(document):
    """A sphere of triangles about the origin, within 0.02 mm of a true one."""
    made = document.addObject("Mesh::Feature", "Ball")
    change(made, Mesh=Mesh.createSphere(RADIUS, 120))
    return made


def middle_of(sketch):
    edge = sketch.Shape.Edges[0]
    return edge.valueAt(edge.getParameterByLength(edge.Length / 2))


def test_half_planes_through_the_poles_of_an_egg(document):
    """FreeCAD 0.20 ends when some of these wires are divided whole: they are divided edge by edge."""
    egg = document.addObject("Part::Ellipsoid", "Egg")
    change(egg, Radius1=100, Radius2=60)
    curves, remarks = curves_of(cut(egg, Family("parallel", 5, "X")), closed=CLOSED[1])
    assert (len(curves), remarks) == (10, [])
    curves, remarks = curves_of(cut(egg, Family("about an axis", 5, "Z")))
    assert (len(curves), remarks) == (5, [])
    for found in curves:
        assert found.curve.length == pytest.approx(255.27, abs=0.05)


def test_parallel_planes_through_a_surface(document, shell):
    sections = cut(shell, Family("parallel", 3, "X"))
    curves, remarks = curves_of(sections, tolerance=0.02)
    sketches = section_sketches(document, shell, curves)
    document.recompute()
    assert (len(sketches), remarks) == (3, [])
    for sketch, x in zip(sketches, (-40, 0, 40), strict=True):
        edge = sketch.Shape.Edges[0]
        for t in (0.1, 0.5, 0.9):
            point = edge.valueAt(t)
            assert point.x == pytest.approx(x, abs=1e-6)
            assert shell.Shape.distToShape(Part.Vertex(point))[0] < 0.021
    group = document.getObject("Curves")
    assert group.Group == sketches
    made = new(strip.create, document, sketches[1])
    assert made.State == ["Up-to-date"], made.getStatusString()


@pytest.mark.campaign
def test_half_planes_about_the_axis_of_a_mesh(document, ball):
    curves, remarks = curves_of(cut(ball, Family("about an axis", 4, "Z", through=(0, 0, 0))))
    assert remarks == []
    sketches = section_sketches(document, ball, curves)
    document.recompute()
    for k, sketch in enumerate(sketches):
        turn = np.pi / 2 * k
        assert sketch.Shape.Length == pytest.approx(np.pi * RADIUS, rel=1e-3)
        assert tuple(middle_of(sketch)) == pytest.approx(
            (RADIUS * np.cos(turn), RADIUS * np.sin(turn), 0), abs=0.1
        )
    part = Family("about an axis", 3, "Z", through=(0, 0, 0), sweep=90)
    assert [section.name[-4:-1] for section in cut(ball, part)] == ["(0°", "45°", "90°"]


def test_half_planes_about_the_axis_of_a_solid(document):
    body = document.addObject("Part::Sphere", "Sphere")
    body.Radius = RADIUS
    body.Placement.Base = App.Vector(10, 20, 30)
    document.recompute()
    sections = cut(body, Family("about an axis", 5, "X"))
    curves, remarks = curves_of(sections)
    assert remarks == []
    assert [curve.curve.length for curve in curves] == pytest.approx([np.pi * RADIUS] * 5, rel=1e-3)


def test_planes_along_a_path(document, ball):
    path = document.addObject("Part::Feature", "Path")
    circle = Part.Circle(App.Vector(0, 0, 0), App.Vector(0, 0, 1), 100)
    path.Shape = Part.ArcOfCircle(circle, 0.0, np.pi / 2).toShape()
    part = document.addObject("App::Part", "Part")
    part.addObject(path)
    part.Placement.Base = App.Vector(-100, 0, 0)
    document.recompute()
    points = path_points(path)
    assert points[0] == pytest.approx([0, 0, 0], abs=1e-9)
    sections = cut(ball, Family("along a path", 5, path=points))
    middles = [section.frame.origin for section in sections]
    assert np.hypot(*(np.array(middles)[:, :2] + (100, 0)).T) == pytest.approx([100] * 5, abs=0.01)
    for section in sections:
        x, y, _ = section.frame.origin - path.getParentGeoFeatureGroup().Placement.Base
        assert section.frame.z_axis == pytest.approx([-y / 100, x / 100, 0], abs=1e-3)
    curves, remarks = curves_of(sections, closed=CLOSED[1])
    assert len(curves) + len(remarks) >= 5
    with pytest.raises(InputError, match="the path is missing"):
        cut(ball, Family("along a path", 5))
    with pytest.raises(InputError, match="0 chains"):
        path_points(ball)


def test_closed_sections_are_split_or_named(document, ball):
    sections = cut(ball, Family("parallel", 3, "Z"))
    curves, remarks = curves_of(sections)
    assert not curves
    assert len(remarks) == 3
    assert all("closed" in remark and "Ball, section" in remark for remark in remarks)
    for closed in CLOSED[1:]:
        curves, remarks = curves_of(sections, closed=closed)
        assert (len(curves), remarks) == (6, [])
        for found in curves:
            middle = found.curve.at(np.array([found.curve.length / 2])).position[0]
            side = CLOSED.index(closed) - 1
            assert abs(middle[1 - side]) < 0.3
            assert abs(middle[side]) == pytest.approx(found.curve.length / np.pi, rel=1e-2)


def test_closed_sections_alone_are_reported_once(document, ball):
    ball.Placement.Base = App.Vector(0.004, 7.3, 0)
    made = curves.section(document, [ball])
    document.recompute()
    assert made.getStatusString() == (
        "Every section is a closed line, but a strip has two ends. Choose how to divide the lines in "
        '"Closed lines".'
    )
    assert [made.ThroughX.Value, made.ThroughY.Value] == [0, 7.3]
    change(made, Closed=CLOSED[1])
    assert made.Curves == 10


def test_a_linked_mesh_in_a_moved_part(document, ball):
    part = document.addObject("App::Part", "Part")
    part.Placement = App.Placement(App.Vector(0, 0, 500), App.Rotation())
    part.addObject(ball)
    ball.Placement.Base = App.Vector(200, 0, 0)
    link = document.addObject("App::Link", "Link")
    link.LinkedObject = ball
    link.Placement.Base = App.Vector(0, 700, 0)
    document.recompute()
    for source, middle in ((ball, (200, 0, 500)), (link, (0, 700, 0))):
        (section,) = cut(source, Family("parallel", 1, "X"))
        (line,) = section.lines
        assert line.places.mean(axis=0) == pytest.approx(middle, abs=0.5)
    assert chosen_bodies([link, ball]) == [link, ball]


def test_broken_meshes_are_reported_and_cut(document):
    half = [f for f in Mesh.createSphere(RADIUS, 40).Facets if f.Points[0][2] > 0]
    fins = [[(0, 0, 0), (0, 0, 90), (30, 0, 0)], [(0, 0, 0), (0, 0, 90), (-30, 5, 0)]]
    fins.append([(0, 0, 0), (0, 0, 90), (0, 40, 0)])
    made = document.addObject("Mesh::Feature", "Open")
    made.Mesh = Mesh.Mesh([f.Points for f in half])
    crowded = document.addObject("Mesh::Feature", "Crowded")
    change(crowded, Mesh=Mesh.Mesh(fins))
    first, *_ = cut(made, Family("parallel", 3, "X"))
    assert first.reports[0].startswith("Open: the mesh is open along")
    curves, _ = curves_of([first])
    assert len(curves) == 1
    (section,) = cut(crowded, Family("parallel", 1, "Z"))
    assert any("more than two faces" in report for report in section.reports)
    with pytest.raises(InputError, match="select a body"):
        chosen_bodies([document.addObject("Mesh::Feature", "Empty")])


def test_a_mesh_with_a_place_that_is_none(document):
    spoiled = document.addObject("Mesh::Feature", "Spoiled")
    spoiled.Mesh = Mesh.Mesh([(0.0, 0.0, 0.0), (90.0, 0.0, 0.0), (0.0, 90.0, float("nan"))])
    with pytest.raises(InputError, match=r"a coordinate is nan mm.*export the file again"):
        curves.section(document, [spoiled])


def test_datum_planes_and_axes_have_no_end(document, shell):
    datum = document.addObject("PartDesign::Plane", "Datum")
    axis = document.addObject("PartDesign::Line", "Axis")
    document.recompute()
    assert chosen_bodies([shell, datum]) == [shell]
    with pytest.raises(InputError, match="select a body, a surface or a mesh"):
        chosen_bodies([datum])
    with pytest.raises(InputError, match="An edge is infinitely long"):
        path_points(axis)


def test_a_path_of_two_chains_is_reported(document):
    lines = document.addObject("Part::Feature", "Lines")
    lines.Shape = Part.Compound(
        [Part.makeLine(App.Vector(x, 0, 0), App.Vector(x + 50, 0, 0)) for x in (0, 90)]
    )
    with pytest.raises(
        InputError, match=r"Lines has 2 chains of edges\. Choose the edges of a single chain as the path."
    ):
        path_points(lines)


def test_planes_that_miss_and_a_stop(document, shell, ball):
    sections = cut(shell, Family("about an axis", 4, "Z", through=(500, 0, 0)))
    curves, remarks = curves_of(sections)
    missing = [remark for remark in remarks if "misses" in remark]
    assert len(curves) + len(missing) == 4
    assert missing[0].startswith("Shell, section ")
    with pytest.raises(NotConvergedError, match="stopped"):
        cut(shell, Family(), lambda done: done < 2)
    with pytest.raises(NotConvergedError, match="stopped"):
        curves_of(cut(ball, Family()), step=lambda done: done < 2)
    with pytest.raises(InputError, match="axis"):
        cut(shell, Family(axis="W"))
