"""The CadQuery skin: free functions, Workplane and Sketch methods."""

import cadquery as cq
import numpy as np
import pytest

from elastica_cad import Hole, InputError, Tab
from elastica_cad.cadquery import (
    StripSolid,
    StripWarning,
    Workplane,
    bent_strip,
    end_fixture,
    flat_strip,
    register,
    strip_outline,
)

POINTS = [(0, 0), (40, 40), (90, 50), (140, 0)]
SHEET = "birch-plywood-0.8"
OPTIONS = {"max_width": 30, "ends": (Tab(12, holes=(Hole(6, 3.2),)), Tab(12)), "label": "A1"}


@pytest.fixture(scope="module")
def edge():
    return cq.Edge.makeSpline([cq.Vector(*p) for p in POINTS])


@pytest.fixture(scope="module", autouse=True)
def registered():
    register()
    register()


def place(location):
    return np.array(location.toTuple()[0])


class TestFreeFunctions:
    def test_outline(self, edge, measure):
        outline = strip_outline(edge, SHEET, **OPTIONS)
        assert outline.isValid()
        assert measure.area(outline.wrapped) == pytest.approx(outline.strip.area, rel=1e-9)
        assert len(outline.outerWire().Edges()) == 8

    def test_flat(self, edge):
        flat = flat_strip(edge, SHEET, **OPTIONS)
        assert flat.isValid()
        assert flat.Volume() == pytest.approx(flat.strip.area * 0.8, rel=1e-4)

    def test_bent_stands_on_the_edge(self, edge):
        bent = bent_strip(edge, SHEET, **OPTIONS)
        assert bent.isValid()
        assert bent.distance(edge) == pytest.approx(0, abs=1e-9)
        for u in (0.2, 0.5, 0.8):
            out = edge.positionAt(u) + edge.tangentAt(u).cross(cq.Vector(0, 0, 1)) * 0.6
            assert cq.Vertex.makeVertex(*out.toTuple()).distance(bent) == pytest.approx(0.2, abs=1e-6)

    def test_attributes_follow_a_move(self, edge):
        bent = bent_strip(edge, SHEET, **OPTIONS)
        moved = bent.moved(cq.Location((1, 2, 3)))
        assert isinstance(moved, StripSolid)
        assert moved.strip is bent.strip
        assert moved.check.realizable
        assert moved.rod.ratio == bent.rod.ratio
        assert moved.warnings == bent.warnings
        assert place(moved.joints["start"]) == pytest.approx([1, 2, 3])
        assert set(moved.joints) == {"start", "end", "hole1", "hole1:top", "hole1:bottom"}

    def test_end_faces(self, edge):
        bent = bent_strip(edge, SHEET, **OPTIONS)
        for end, u in (("start", 0.0), ("end", 1.0)):
            face = bent.end_face(end)
            outward = edge.tangentAt(u) * (1 if end == "end" else -1)
            assert face.geomType() == "PLANE"
            assert (face.normalAt() - outward).Length < 1e-9
            assert (face.Center() - edge.positionAt(u) - outward * 12).Length < 1e-9

    def test_faces_in_holes(self, edge):
        bent = bent_strip(edge, SHEET, **OPTIONS).moved(cq.Location((1, 2, 3), (0, 1, 0), 30))
        for tag, joint in (("hole1", "hole1"), ("hole1_top", "hole1:top"), ("hole1_bottom", "hole1:bottom")):
            face = bent.hole_face(tag)
            outward = cq.Plane(bent.joints[joint]).zDir
            assert face.Center().toTuple() == pytest.approx(place(bent.joints[joint]), abs=1e-9)
            assert (face.normalAt() - outward).Length < 1e-9
        with pytest.raises(
            InputError, match=r"no hole 'hole2'\. Its holes are: hole1, hole1_top, hole1_bottom"
        ):
            bent.hole_face("hole2")

    def test_several_edges_and_workplanes(self, edge):
        arc = cq.Edge.makeThreePointArc(cq.Vector(0, 0), cq.Vector(10, 10), cq.Vector(20, 0))
        with pytest.warns(StripWarning, match=r"strain is 4 %.*allows"):
            assert flat_strip([arc], SHEET, max_width=5, ignore_limits=True).rod.length == pytest.approx(
                10 * np.pi
            )
        drawn = cq.Workplane("XZ").spline(POINTS)
        assert bent_strip(drawn, SHEET, **OPTIONS).BoundingBox().zmax == pytest.approx(51, abs=0.5)


class TestWorkplane:
    @pytest.mark.parametrize("workplane", [cq.Workplane, Workplane])
    def test_bent_on_a_plane(self, workplane):
        work = workplane("XZ").spline(POINTS).elasticStrip(SHEET, form="bent", **OPTIONS)
        box = work.val().BoundingBox()
        assert (box.ymin, box.ymax) == pytest.approx((-15, 15), abs=1e-5)
        assert work.val().isValid()
        assert work.faces(tag="end").size() == work.faces(tag="hole1_top").size() == 1
        assert work.val().strip.label == "A1"
        assert type(work) is workplane

    @pytest.mark.parametrize("plane", ["XY", "XZ"])
    def test_fixture_of_what_is_drawn_on_a_plane(self, plane):
        drawn = cq.Workplane(plane, origin=(0, 7, 0)).spline(POINTS)
        options = {**OPTIONS, "engrave": ""}
        block, held = end_fixture(drawn, SHEET, end="end", **options), bent_strip(drawn, SHEET, **OPTIONS)
        assert place(block.joints["tab"]) == pytest.approx(place(held.joints["end"]), abs=1e-9)
        assert block.Volume() == pytest.approx(held.fixture("end", engrave="").Volume(), rel=1e-9)

    def test_flat_lies_on_the_workplane(self):
        work = cq.Workplane("XZ", origin=(0, 7, 0)).spline(POINTS).elasticStrip(SHEET, form="flat", **OPTIONS)
        box = work.val().BoundingBox()
        assert (box.ymin, box.ymax) == pytest.approx((6.2, 7), abs=1e-5)
        assert box.xmin == pytest.approx(-12, abs=1e-5)
        assert work.faces(tag="start").val().Center().toTuple() == pytest.approx((-12, 6.6, 0), abs=1e-5)

    def test_outlines_are_extruded_where_points_are(self):
        drawn = cq.Workplane("XZ", origin=(0, 7, 0)).spline(POINTS).pushPoints([(0, 0), (0, 60)])
        faces = drawn.elasticStrip(SHEET, form="outline", **OPTIONS)
        one, two = faces.vals()
        assert one.geomType() == "PLANE"
        assert two.strip.label == "A1"
        assert two.Center().z - one.Center().z == pytest.approx(60)
        strip = flat_strip(cq.Workplane().spline(POINTS), SHEET, **OPTIONS)
        sheets = faces.extrude(0.8, combine=False)
        volumes = [solid.Volume() for solid in sheets.solids().vals()]
        # the kernel integrates the short level ends of the sides only roughly
        assert volumes == pytest.approx([strip.Volume()] * 2, rel=3e-4)
        assert sheets.val().BoundingBox().ymax == pytest.approx(7, abs=1e-5)

    def test_outlines_join_no_solid(self):
        drawn = cq.Workplane().box(400, 60, 10).faces(">Z").workplane().spline(POINTS)
        with pytest.raises(InputError, match="An outline is a face and cannot be combined with a solid"):
            drawn.elasticStrip(SHEET, form="outline", combine=True, **OPTIONS)

    def test_combines(self):
        base = cq.Workplane().box(400, 60, 10).faces(">Z").workplane()
        work = base.spline(POINTS).elasticStrip(SHEET, form="flat", combine=True, **OPTIONS)
        strip = flat_strip(cq.Workplane().spline(POINTS), SHEET, **OPTIONS)
        assert work.solids().size() == 1
        assert work.val().Volume() == pytest.approx(400 * 60 * 10 + strip.Volume(), rel=1e-6)

    def test_selected_edges(self):
        work = cq.Workplane().spline(POINTS)
        work.ctx.popPendingEdges()
        assert work.elasticStrip(SHEET, form="flat", **OPTIONS).val().isValid()

    def test_assembly_with_constraints(self, edge):
        """Two strips end to end, by the tags of their end faces."""
        flat = cq.Workplane().spline(POINTS).elasticStrip(SHEET, form="flat", **OPTIONS)
        made = (
            cq.Assembly(name="pair")
            .add(flat, name="one", color=cq.Color(0.85, 0.7, 0.48))
            .add(flat, name="two")
        )
        made.constrain("one", "Fixed")
        made.constrain("one?end", "two?start", "Plane")
        made.solve()
        gap = place(made.objects["two"].loc)[0] - (flat.val().rod.length + 24)
        assert gap == pytest.approx(0, abs=1e-3)


class TestSketch:
    def test_face(self):
        sketch = (
            cq.Sketch().spline([cq.Vector(*p) for p in POINTS]).elasticStrip(SHEET, tag="strip", **OPTIONS)
        )
        strip = flat_strip(cq.Workplane().spline(POINTS), SHEET, **OPTIONS)
        solid = cq.Workplane().placeSketch(sketch).extrude(2)
        assert solid.val().Volume() == pytest.approx(2 * strip.strip.area, rel=3e-4)
        assert sketch.faces(tag="strip").vals()

    def test_no_edges(self):
        with pytest.raises(InputError, match="Draw edges"):
            cq.Sketch().elasticStrip(SHEET, max_width=3)


class TestBadInput:
    def test_foreign_method_is_left_alone(self, monkeypatch):
        monkeypatch.setattr(cq.Workplane, "elasticStrip", print)
        with pytest.raises(InputError, match="another library"):
            register()
        assert cq.Workplane.elasticStrip is print

    def test_nothing_drawn(self):
        with pytest.raises(InputError, match="There is no curve"):
            cq.Workplane().elasticStrip(SHEET, max_width=3)

    def test_unknown_form(self):
        with pytest.raises(InputError, match="flat, bent, outline"):
            cq.Workplane().spline(POINTS).elasticStrip(SHEET, max_width=3, form="rolled")

    def test_no_edge(self):
        with pytest.raises(ValueError, match="an object of type int is not an edge"):
            flat_strip(3, SHEET, max_width=3)


def test_gravity_is_a_vector_of_the_library(edge):
    upright = edge.rotate(cq.Vector(), cq.Vector(1, 0, 0), 90)
    felt = bent_strip(upright, "card-200gsm", max_width=30, gravity=cq.Vector(0, 0, -1))
    assert (
        felt.rod.gravity == bent_strip(upright, "card-200gsm", max_width=30, gravity=(0, 0, -1)).rod.gravity
    )
    assert felt.rod.gravity is not None
    with pytest.raises(InputError, match="such as"):
        bent_strip(upright, "card-200gsm", max_width=30, gravity=cq.Vector(0, 0, 0))
