"""Mirror images of strips with a slot and a hole beside the middle; points in space to which ends are led."""

import warnings

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad import PlaneCurve
from elastica_cad.kernel.strip_body import StripWarning
from tests.cad.libraries import bd, bd_strips, cq, cq_strips

SHEET = "polypropylene-0.8"
CURVE = PlaneCurve.spline([(0, 0), (20, 50), (60, 75), (100, 50), (120, 0)])
ONE_SIDED = {
    "max_width": 26,
    "ends": (ec.Tab(14, holes=ec.Hole(at=7, diameter=3, across=4)), ec.Tab(10)),
    "slots": ec.Slot(at=40, width=1),
}
PLANES = ("XY", "XZ", "YZ")


def near(a, b):
    assert np.asarray(tuple(a)) == pytest.approx(np.asarray(tuple(b)), abs=1e-6)


@pytest.mark.build123d
class TestBuild123d:
    @pytest.fixture
    def rib(self):
        return bd_strips.BentStrip(CURVE, SHEET, **ONE_SIDED)

    @pytest.mark.campaign
    @pytest.mark.parametrize("name", [*PLANES, "leaning"])
    def test_bodies_of_an_image_are_images(self, rib, name):
        leaning = bd.Plane((3, 4, 5), x_dir=(1, 2, 0), z_dir=(2, -1, 3))
        plane = leaning if name == "leaning" else getattr(bd.Plane, name)
        image = rib.mirror(plane)
        assert type(image) is type(rib)
        other = image.bent()
        assert (image - other).volume + (other - image).volume == pytest.approx(0, abs=1e-6)
        near(image.center(), other.center())
        for key, joint in rib.joints.items():
            mirrored = bd.Vertex(*joint.location.position).mirror(plane)
            near(image.joints[key].location.position, mirrored.center())
            near(other.joints[key].location.position, mirrored.center())
        block, its = rib.fixture("end", engrave=""), image.fixture("end", engrave="")
        near(its.center(), bd.Vertex(*block.center()).mirror(plane).center())
        assert (its & image) is None or (
            its & image
        ).volume < 15  # mm3: pockets lean, straight tabs run into them
        lower = bd.Pos(0, -50, 0) * bd.Box(400, 100, 10)
        shares = [(one & lower).volume for one in (rib.flat, image.flat)]
        assert sum(shares) == pytest.approx(rib.flat.volume, rel=1e-6)
        assert shares[0] != pytest.approx(shares[1], abs=1)
        near(image.mirror(plane).bent().center(), rib.center())

    @pytest.mark.parametrize("name", [*PLANES, "ZX", "leaning"])
    def test_an_end_is_led_to_a_point_in_space(self, name):
        leaning = bd.Plane((3, 4, 5), x_dir=(1, 2, 0), z_dir=(2, -1, 3))
        plane = -(leaning if name == "leaning" else getattr(bd.Plane, name))
        with bd.BuildPart():
            with bd.BuildLine(plane):
                bd_strips.Elastica((0, 0), (70, 0), 100, angles=(80, -80))
            rib = bd_strips.elastic_strip(sheet=SHEET, max_width=20, form="bent")
        goal = plane.from_local_coords(bd.Vector(60, 0))
        for body in (rib.bent(end=goal), rib.bent(end=tuple(goal)), rib.slider(end=goal).bent(10)):
            near(body.joints["end"].location.position, goal)
            near(body.joints["start"].location.position, rib.joints["start"].location.position)
        with pytest.raises(ec.InputError, match=r"end is 5 mm away from the plane"):
            rib.bent(end=goal + 5 * plane.z_dir)
        with pytest.raises(TypeError, match=r"ends is not an option of bending a strip: did you mean end"):
            rib.bent(ends=(60, 0))

    def test_a_strip_bent_too_far_is_reported_where_the_script_does_it(self, rib):
        with pytest.warns(StripWarning, match="strain") as result:
            rib.bent(end=(20, 0))
        assert {one.filename for one in result} == {__file__}
        slider = rib.slider(end=(20, 0))
        with pytest.warns(StripWarning, match="strain") as result:
            slider.bent(slider.travel.length)
        assert {one.filename for one in result} == {__file__}
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            rib.bent(end=(119, 0))
            slider.bent(1)

    def test_a_fixture_may_be_numbered_by_a_number(self, rib):
        one, other = (rib.fixture("end", engrave=number).volume for number in (7, "7"))
        assert one == other < rib.fixture("end", engrave="").volume

    def test_an_animation_has_its_own_ending(self, rib, tmp_path):
        slider = rib.slider(end=(110, 0))
        with pytest.raises(ec.InputError, match=r"rib.gltf is not .* name ending in .glb"):
            slider.write_glb(tmp_path / "rib.gltf")
        with pytest.raises(ec.InputError, match="a whole number, 2 or more"):
            slider.write_glb(tmp_path / "rib.glb", frames=2.5)
        for _ in range(2):
            slider.write_glb(tmp_path / "rib.glb", frames=3, force=True)


@pytest.mark.cadquery
class TestCadQuery:
    @pytest.fixture
    def rib(self):
        return cq_strips.bent_strip(CURVE, SHEET, **ONE_SIDED)

    @pytest.mark.campaign
    @pytest.mark.parametrize("plane", PLANES)
    def test_bodies_of_an_image_are_images(self, rib, plane):
        image = rib.mirror(plane)
        other = image.bent()
        assert image.cut(other).Volume() + other.cut(image).Volume() == pytest.approx(0, abs=1e-6)
        for key, place in other.joints.items():
            near(place.toTuple()[0], image.joints[key].toTuple()[0])
        placed = ec.Model([image.placed]).placed[0].strip
        assert [slot.side for slot in placed.slots] == ["lower"]
        near(image.mirror(plane).bent().Center().toTuple(), rib.Center().toTuple())
        assert image.fixture("end", engrave="").intersect(image).Volume() < 15  # mm3, as above

    def test_an_end_is_led_to_a_point_in_space(self):
        plane = cq.Plane((3, 4, 5), xDir=(1, 2, 0), normal=(2, -1, 3))
        edge = cq_strips.elastica((0, 0), (70, 0), 100, angles=(80, -80)).moved(plane.location)
        rib, goal = cq_strips.bent_strip(edge, SHEET, max_width=20), plane.toWorldCoords((60, 0, 0))
        for body in (rib.bent(end=goal), rib.bent(end=goal.toTuple()), rib.slider(end=goal).bent(10)):
            near(body.joints["end"].toTuple()[0], goal.toTuple())
        with pytest.warns(StripWarning, match="strain") as result:
            rib.bent(end=plane.toWorldCoords((20, 0, 0)))
        assert {one.filename for one in result} == {__file__}

    @pytest.mark.campaign
    def test_bent_strips_stand_at_every_point_of_the_stack(self):
        cq_strips.register()
        drawn = cq.Workplane("XZ").spline([(0, 0), (60, 50), (120, 0)])
        options = {"max_width": 20, "form": "bent"}
        (one,) = drawn.elasticStrip(SHEET, **options).vals()
        six = (
            cq.Workplane("XZ")
            .spline([(0, 0), (60, 50), (120, 0)])
            .polarArray(100, 0, 360, 6)
            .elasticStrip(SHEET, **options)
            .vals()
        )
        places = cq.Workplane("XZ").polarArray(100, 0, 360, 6).objects
        to_plane = cq.Plane.named("XZ").location
        assert len(six) == 6
        for body, place in zip(six, places, strict=True):
            expected = one.moved(to_plane.inverse).moved(place).moved(to_plane)
            near(body.Center().toTuple(), expected.Center().toTuple())
            assert body.cut(expected).Volume() == pytest.approx(0, abs=1e-6)
            assert body.strip is one.strip
