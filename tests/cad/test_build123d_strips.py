"""The build123d skin: algebra and builder mode, pending edges, joints, copies."""

import copy

import build123d as bd
import numpy as np
import pytest

from elastica_cad import Hole, InputError, Tab
from elastica_cad.build123d import (
    BentStrip,
    EndFixture,
    FlatStrip,
    StripOutline,
    elastic_strip,
    section_strips,
)

POINTS = [(0, 0), (40, 40), (90, 50), (140, 0)]
SHEET = "birch-plywood-0.8"
OPTIONS = {"max_width": 30, "ends": (Tab(12, holes=(Hole(6, 3.2),)), Tab(12)), "label": "A1"}


@pytest.fixture(scope="module")
def edge():
    return bd.Edge.make_spline(POINTS)


@pytest.fixture(scope="module")
def bent(edge):
    return BentStrip(edge, SHEET, **OPTIONS)


def place(location):
    return np.array([*location.position])


class TestAlgebraMode:
    def test_outline(self, edge, measure):
        outline = StripOutline(edge, SHEET, **OPTIONS)
        assert measure.area(outline.face().wrapped) == pytest.approx(outline.strip.area, rel=1e-9)
        assert len(outline.face().outer_wire().edges()) == 8
        assert isinstance(outline, bd.Sketch)

    def test_flat(self, edge):
        flat = FlatStrip(edge, SHEET, **OPTIONS)
        assert flat.is_valid
        assert flat.volume == pytest.approx(flat.strip.area * 0.8, rel=1e-4)
        assert pytest.approx(0, abs=1e-6) == flat.bounding_box().min.Z
        assert pytest.approx(edge.length + 24, abs=1e-5) == flat.bounding_box().size.X

    def test_bent_stands_on_the_edge(self, edge, bent):
        assert bent.is_valid
        assert isinstance(bent, bd.Part)
        on_face = [edge @ u + 0.4 * side * normal(edge, u) for u in (0.3, 0.7) for side in (-1, 1)]
        assert all(bd.Vertex(*p).distance_to(bent) < 1e-6 for p in on_face)
        off_face = [edge @ u + 0.6 * side * normal(edge, u) for u in (0.3, 0.7) for side in (-1, 1)]
        assert all(bd.Vertex(*p).distance_to(bent) == pytest.approx(0.2, abs=1e-6) for p in off_face)

    def test_attributes(self, bent):
        assert bent.label == "A1"
        assert tuple(bent.color)[:3] == pytest.approx((0.85, 0.70, 0.48))
        assert bent.rod is bent.strip.rod
        assert bent.check.realizable
        assert bent.warnings == bent.strip.warnings

    @pytest.mark.parametrize(
        "made",
        [lambda s: bd.Pos(7, 0, 0) * s, copy.copy, copy.deepcopy, lambda s: s.moved(bd.Location((7, 0, 0)))],
    )
    def test_copies_keep_all(self, bent, made):
        other = made(bent)
        assert isinstance(other, BentStrip)
        assert (other.label, tuple(other.color)) == (bent.label, tuple(bent.color))
        assert other.strip is bent.strip
        assert set(other.joints) == set(bent.joints)

    def test_booleans_give_a_plain_part(self, bent):
        cut = bent - bd.Pos(70, 40, 0) * bd.Box(10, 60, 5)
        assert cut.is_valid
        assert not isinstance(cut, BentStrip)
        assert cut.volume < bent.volume

    def test_align_and_rotation(self, edge):
        strip = FlatStrip(edge, SHEET, align=bd.Align.CENTER, rotation=(0, 0, 90), **OPTIONS)
        box = strip.bounding_box()
        assert place(bd.Location(box.center())) == pytest.approx([0, 0, 0], abs=1e-6)
        assert box.size.Y > box.size.X
        assert place(strip.joints["start"].location)[0] == pytest.approx(0, abs=1e-6)


def normal(edge, u):
    return bd.Vector(-(edge % u).Y, (edge % u).X)


class TestJoints:
    def test_places(self, edge, bent):
        assert set(bent.joints) == {"start", "end", "hole1", "hole1:top", "hole1:bottom"}
        assert place(bent.joints["start"].location) == pytest.approx([0, 0, 0], abs=1e-9)
        assert place(bent.joints["end"].location) == pytest.approx([140, 0, 0], abs=1e-9)
        outward = bd.Plane(bent.joints["end"].location).x_dir
        assert (outward - edge % 1).length < 1e-9

    def test_connect(self, bent):
        block = bd.Box(10, 10, 10)
        bd.RigidJoint("top", block, bd.Location((0, 0, 5)))
        bent.joints["start"].connect_to(block.joints["top"])
        assert place(block.joints["top"].location) == pytest.approx(place(bent.joints["start"].location))

    def test_moved_strip_takes_its_joints_along(self, bent):
        assert place((bd.Pos(1, 2, 3) * bent).joints["start"].location) == pytest.approx([1, 2, 3])


class TestBuilderMode:
    def test_pending_edges_in_a_part(self, bent):
        with bd.BuildPart() as part:
            with bd.BuildLine():
                bd.Spline(*POINTS)
            strip = elastic_strip(sheet=SHEET, form="bent", **OPTIONS)
        assert isinstance(strip, BentStrip)
        assert part.part.volume == pytest.approx(bent.volume, rel=1e-4)
        assert len(part.pending_edges) == 0

    def test_on_another_plane(self):
        with bd.BuildPart(bd.Plane.XZ.offset(5)) as part:
            with bd.BuildLine():
                bd.Spline(*POINTS)
            elastic_strip(sheet=SHEET, form="bent", **OPTIONS)
        box = part.part.bounding_box()
        assert pytest.approx((-20, 10), abs=1e-5) == (box.min.Y, box.max.Y)
        assert pytest.approx(51, abs=0.5) == box.max.Z

    def test_pending_edges_in_a_sketch(self, edge):
        with bd.BuildSketch() as sketch:
            with bd.BuildLine():
                bd.Spline(*POINTS)
            outline = elastic_strip(sheet=SHEET, form="outline", **OPTIONS)
        assert sketch.sketch.area == pytest.approx(outline.strip.area, rel=1e-4)

    def test_locations_and_modes(self, edge):
        with bd.BuildPart() as part:
            bd.Box(400, 100, 10, align=(bd.Align.CENTER, bd.Align.CENTER, bd.Align.MAX))
            with bd.Locations((-100, -25, -0.8), (-100, 25, -0.8)):
                strip = FlatStrip(edge, SHEET, mode=bd.Mode.SUBTRACT, **OPTIONS)
        assert part.part.volume == pytest.approx(400 * 100 * 10 - 2 * strip.strip.area * 0.8, rel=1e-6)

    def test_pending_edges_lie_where_locations_put_them(self, bent):
        """Bent strips stand on them, one each; the locations are not applied again."""
        places = (0, 0, 0), (0, 0, 90)
        with bd.BuildPart() as part, bd.Locations(*places):
            with bd.BuildLine():
                bd.Spline(*POINTS)
            strips = elastic_strip(sheet=SHEET, form="bent", **OPTIONS)
        assert len(strips) == len(part.part.solids()) == 2
        box, one = part.part.bounding_box(), bent.bounding_box()
        assert pytest.approx(one.size.Z + 90, abs=1e-4) == box.size.Z
        assert pytest.approx(one.max.Z + 90, abs=1e-4) == box.max.Z

    @pytest.mark.parametrize("kind", [BentStrip, FlatStrip, EndFixture])
    def test_each_copy_has_its_joints(self, edge, kind):
        places = bd.Location((0, 200, 7)), bd.Location((30, -90, 0), (0, 0, 40))
        options = {**OPTIONS, "engrave": "", "rotation": (0, 0, 25)}
        alone = kind(edge, SHEET, **options)
        with bd.BuildPart(), bd.Locations(*places):
            made = kind(edge, SHEET, **options)
        moved = bd.Pos(1, 2, 3) * made
        for body, before in ((made, bd.Location()), (moved, bd.Pos(1, 2, 3))):
            assert len(body.copies) == len(body.solids()) == 2
            for number, copied in enumerate(body.copies):
                single = before * places[number] * alone
                assert [*copied.center()] == pytest.approx([*single.center()], abs=1e-6)
                assert set(copied.joints) == set(alone.joints)
                for name, joint in single.joints.items():
                    shared = body.joints[f"{name}:2" if number else name]
                    assert place(copied.joints[name].location) == pytest.approx(
                        place(joint.location), abs=1e-6
                    )
                    assert place(shared.location) == pytest.approx(place(joint.location), abs=1e-6)
        assert [one.label for one in alone.copies] == [alone.label]

    def test_copies_are_bent_one_by_one(self, edge):
        with bd.BuildPart(), bd.Locations((0, 200, 0), (0, 400, 0)):
            made = BentStrip(edge, SHEET, **OPTIONS)
        second = made.copies[1]
        total = sum(copied.strip.mass for copied in made.copies)
        assert total == pytest.approx(made.volume * made.strip.sheet.density * 1e-6, rel=1e-4)
        assert place(second.bent(end=(130, 0)).joints["end"].location) == pytest.approx(
            [130, 400, 0], abs=1e-6
        )
        for refused in (made.bent, lambda: made.frame, lambda: made.fixture("end"), lambda: made.placed):
            with pytest.raises(InputError, match=r"has 2 copies of a strip"):
                refused()

    def test_private_mode(self, edge):
        with bd.BuildPart() as part:
            FlatStrip(edge, SHEET, mode=bd.Mode.PRIVATE, **OPTIONS)
        assert part.part is None


class TestBadInput:
    def test_nothing_drawn(self):
        with pytest.raises(InputError, match="There is no curve"):
            elastic_strip(sheet=SHEET, max_width=10)
        with bd.BuildPart(), pytest.raises(InputError, match="There is no curve"):
            elastic_strip(sheet=SHEET, max_width=10)

    def test_inside_the_line(self):
        with bd.BuildPart(), bd.BuildLine():
            bd.Spline(*POINTS)
            with pytest.raises(InputError, match="cannot be called inside BuildLine"):
                elastic_strip(sheet=SHEET, max_width=10)

    def test_unknown_form(self, edge):
        with pytest.raises(InputError, match="flat, bent, outline"):
            elastic_strip(edge, sheet=SHEET, max_width=10, form="rolled")

    def test_rotation_that_is_not_a_number(self, edge):
        with pytest.raises(InputError, match=r"rotation is .*, in degrees"):
            StripOutline(edge, SHEET, max_width=10, rotation=np.array(90.0))

    def test_closed_with_a_corner(self):
        with pytest.raises(ValueError, match="corner"):
            StripOutline(bd.Wire.make_polygon([(0, 0), (90, 0), (40, 60)]), SHEET, max_width=10)


@pytest.mark.parametrize("given", [None, bd.BuildLine()])
def test_what_is_no_edge_is_reported_what_to_give(given):
    result = r"not an edge or wire .* the `line` of a builder"
    with pytest.raises(InputError, match=result):
        BentStrip(given, "birch-plywood-0.8", max_width=30)


@pytest.mark.parametrize("given", [bd.Curve(), bd.Compound(), [bd.Curve()], bd.Curve([])])
def test_shapes_that_hold_nothing_are_reported_as_no_edge(given):
    """What a filter or a boolean leaves nothing of: build123d asserts that a shape is there."""
    with pytest.raises(InputError, match="there is no edge: select at least one edge or wire"):
        BentStrip(given, "birch-plywood-0.8", max_width=30)


def test_a_body_that_holds_nothing_cannot_be_cut():
    with pytest.raises(InputError, match="Pass a face, shell or solid"):
        section_strips(bd.Part(), bd.Plane.XZ, "birch-plywood-0.8", max_width=30)


def test_gravity_is_a_vector_of_the_library(edge):
    upright = edge.rotate(bd.Axis.X, 90)
    felt = BentStrip(upright, "card-200gsm", max_width=30, gravity=bd.Vector(0, 0, -1))
    assert felt.rod.gravity == BentStrip(upright, "card-200gsm", max_width=30, gravity=(0, 0, -1)).rod.gravity
    assert felt.rod.gravity is not None
    with pytest.raises(InputError, match="such as"):
        BentStrip(upright, "card-200gsm", max_width=30, gravity=bd.Vector(0, 0, 0))
