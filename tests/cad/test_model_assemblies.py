"""A whole model in build123d, CadQuery and STEP: every strip in its place, equal ones sharing a body."""

import re

import numpy as np
import pytest

from elastica_cad import Frame, InputError, Laminated, Model, Placed, PlaneCurve, Sheet, Slot, make_strip
from elastica_cad.kernel import occt
from elastica_cad.kernel import step_files as step
from elastica_cad.model import slotted_frame
from elastica_cad.model.assembly import assembly_parts, require_model
from tests.cad.libraries import bd_strips, cq, cq_strips

ARCH = PlaneCurve.spline([(20, 0), (40, 60), (70, 80), (120, 60), (150, 0)])
S = PlaneCurve.spline([(20, 0), (50, 60), (100, 10), (150, -40), (200, 20)])


@pytest.fixture(scope="module")
def model():
    """A crown of three equal arches, an S with slots, and its mirror image."""
    arch = make_strip(ARCH, "birch-plywood-0.8", max_width=15, label="arch")
    slots = (Slot(at=60, width=1), Slot(at=120, width=1, side="lower"))
    bow = make_strip(S, "card-200gsm", max_width=15, slots=slots)
    crown = Model((Placed(arch, (0, 0, 0), (1, 0, 0), (0, 0, 1)),), name="crown").rotated(3)
    one = Model((Placed(bow, (0, 0, 100), (1, 0, 0), (0, 1, 0)),))
    both = one.mirrored((0, -50, 0), (0, 1, 0))
    return Model((*crown.placed, *both.placed), name="crown")


NAMES = ["arch_1", "arch_2", "arch_3", "strip 4", "strip 5"]


def middle_of(placed, s):
    return placed.frame.point(placed.strip.rod.curve.at(np.array([s])).position)[0]


def test_step_has_each_body_once(model, tmp_path):
    path = tmp_path / "crown.step"
    step.write_step(step.model_shapes(model), path, name=model.name)
    text = path.read_text()
    assert re.findall(r"NEXT_ASSEMBLY_USAGE_OCCURRENCE\('\d+','([^']*)'", text) == NAMES
    assert "PRODUCT('crown'" in text
    assert text.count("MANIFOLD_SOLID_BREP(") == 3


def test_step_is_the_same_wherever_the_bodies_lie_in_memory(model):
    """OpenCASCADE writes colours in the order of the addresses of bodies."""
    made = [step.model_shapes(model) for _ in range(6)]  # all are kept, so that their addresses differ
    assert len({step.step_bytes(shapes, name=model.name) for shapes in made}) == 1


def test_step_is_read_back_in_place(model, tmp_path, measure):
    from OCP.STEPControl import STEPControl_Reader

    path = tmp_path / "crown.step"
    step.write_step(step.model_shapes(model), path, name=model.name)
    reader = STEPControl_Reader()
    reader.ReadFile(str(path))
    reader.TransferRoots()
    whole = reader.OneShape()
    assert measure.volume(whole) == pytest.approx(
        sum(p.strip.area * p.strip.sheet.thickness for p in model.placed), rel=1e-6
    )
    for placed in model.placed:
        middle = middle_of(placed, 0.3 * placed.strip.rod.length)
        assert measure.distance(whole, [middle]) == pytest.approx(placed.strip.sheet.thickness / 2, abs=1e-6)


def test_place_of_a_frame(tilted):
    from OCP.gp import gp_Pnt

    there = gp_Pnt(1, 2, 3).Transformed(occt.make_location(tilted).Transformation())
    assert (there.X(), there.Y(), there.Z()) == pytest.approx(tilted.point([1, 2, 3]))
    assert (
        occt.make_location(Frame()).IsIdentity()
        or occt.make_location(Frame()).Transformation().Value(1, 1) == 1
    )


@pytest.mark.build123d
def test_build123d_compound(model):
    made = bd_strips.model_compound(model)
    assert made.label == "crown"
    assert [child.label for child in made.children] == NAMES
    assert made.is_valid
    for child, placed in zip(made.children, model.placed, strict=True):
        assert isinstance(child, bd_strips.PlacedStrip)
        assert child.strip is placed.strip
        assert [*child.joints["start"].location.position] == pytest.approx(middle_of(placed, 0.0))
        assert [*child.joints["end"].location.position] == pytest.approx(
            middle_of(placed, placed.strip.rod.length)
        )
    first = made.children[0]
    assert first.volume == pytest.approx(
        bd_strips.BentStrip(ARCH, "birch-plywood-0.8", max_width=15).volume, rel=1e-4
    )
    assert first.solid().wrapped.IsPartner(made.children[1].solid().wrapped)


@pytest.mark.cadquery
def test_cadquery_assembly(model):
    made = cq_strips.model_assembly(model)
    assert made.name == "crown"
    assert [child.name for child in made.children] == [name.replace(" ", "_") for name in NAMES]
    assert [child.metadata["strip"] for child in made.children] == list(model.strips)
    for child, placed in zip(made.children, model.placed, strict=True):
        start = child.obj.val().joints["start"]
        assert (child.loc * start).toTuple()[0] == pytest.approx(middle_of(placed, 0.0))
    before = [child.loc.toTuple() for child in made.children]
    made.solve()
    for child, (position, angles) in zip(made.children, before, strict=True):
        assert child.loc.toTuple()[0] == pytest.approx(position, abs=1e-4)
        assert np.cos(child.loc.toTuple()[1]) == pytest.approx(np.cos(angles), abs=1e-5)


@pytest.mark.campaign
@pytest.mark.cadquery
def test_sheets_of_laminates_in_cadquery(tmp_path):
    style = Laminated(width=24.0, backing=Sheet.named("hdf-1.5"), least_backing=0.2)
    arch = make_strip(ARCH, "birch-plywood-0.8", style=style, label="L", ignore_limits=True)
    made = cq_strips.model_assembly(
        Model((Placed(arch, (0, 0, 0), (1, 0, 0), (0, 0, 1)),), name="crown").rotated(2)
    )
    assert [child.name for child in made.children] == ["L_1", "L_2"]
    for child in made.children:
        (backing,) = child.children
        assert backing.name == f"{child.name}_backing"
        assert backing.color.toTuple() != child.color.toTuple()
        whole = child.obj.val().Volume() + backing.obj.Volume()
        assert whole == pytest.approx(child.obj.val().bent().Volume())
    made.solve()
    assert made.objects["L_2"].loc.toTuple()[0] == pytest.approx((0, 0, 0), abs=1e-4)
    made.export(str(tmp_path / "crown.step"))
    read = cq.Assembly.importStep(str(tmp_path / "crown.step"))
    names = [name.rsplit("/", 1)[-1] for name in read.objects]
    assert {"L_1", "L_2"} < set(names)
    assert (
        sum(name.endswith("_backing") for name in names) >= 1
    )  # the twins share one shape, which has one name


@pytest.fixture(scope="module")
def crown():
    arch = make_strip(ARCH, "birch-plywood-0.8", max_width=15, label="arch")
    return Model((Placed(arch, (0, 0, 0), (1, 0, 0), (0, 0, 1)),), name="crown").rotated(3)


@pytest.fixture(scope="module")
def holders(crown):
    base = crown.base_plate(Sheet.named("birch-plywood-0.8"))
    return (base, *crown.fixtures()[:2])


class TestWhatHoldsTheStrips:
    """A base plate and printed blocks in the same assembly, where they belong."""

    NAMES = ("base", "fixture arch:1", "fixture arch:2")

    def test_records(self, crown, holders):
        assert tuple(body.name for body in assembly_parts((), holders)) == self.NAMES
        twice = assembly_parts((), (holders[1], holders[1]))
        assert [body.name for body in twice] == ["fixture arch:1_1", "fixture arch:1_2"]

    def test_a_slotted_frame_is_its_rails_and_ribs(self):
        arch = make_strip(ARCH, "birch-plywood-0.8", max_width=15)
        row = Model(tuple(Placed(arch, (0, 30 * k, 0), (1, 0, 0), (0, 0, 1)) for k in range(3)))
        frame = slotted_frame(row.placed, Sheet.named("birch-plywood-0.8"))
        assert [body.name for body in assembly_parts((), [frame])] == [name for name, _ in frame.solids]

    def test_something_else(self, crown):
        with pytest.raises(InputError, match="a str is not a holder: give base plates"):
            step.model_shapes(crown, ["plate"])
        with pytest.raises(InputError, match=r"the model is a tuple\. Pass a Model"):
            require_model(crown.placed)

    @pytest.mark.campaign
    def test_step(self, crown, holders, tmp_path, measure):
        from OCP.STEPControl import STEPControl_Reader

        path = tmp_path / "crown.step"
        step.write_step(step.model_shapes(crown, holders), path, name=crown.name)
        text = path.read_text()
        names = re.findall(r"NEXT_ASSEMBLY_USAGE_OCCURRENCE\('\d+','([^']*)'", text)
        assert names == ["arch_1", "arch_2", "arch_3", *self.NAMES]
        reader = STEPControl_Reader()
        reader.ReadFile(str(path))
        reader.TransferRoots()
        corner = holders[0].frame.point([*holders[0].slots[0].corners[0], 0.0])
        assert measure.distance(reader.OneShape(), [corner]) < 1e-6

    @pytest.mark.build123d
    def test_build123d(self, crown, holders):
        made = bd_strips.model_compound(crown, others=holders)
        assert [child.label for child in made.children][3:] == list(self.NAMES)
        assert made.is_valid
        strip, base, block = made.children[0], made.children[3], made.children[4]
        assert not strip & base
        assert tuple(base.color) == pytest.approx(tuple(strip.color))
        mate = strip.joints["start"].location
        assert [*block.joints["tab"].location.position] == pytest.approx([*mate.position], abs=1e-9)

    @pytest.mark.campaign
    @pytest.mark.cadquery
    def test_cadquery(self, crown, holders):
        made = cq_strips.model_assembly(crown, others=holders)
        names = [child.name for child in made.children][3:]
        assert names == ["base", "fixture_arch_1", "fixture_arch_2"]
        before = [child.loc.toTuple()[0] for child in made.children]
        made.solve()
        for child, place in zip(made.children, before, strict=True):
            assert child.loc.toTuple()[0] == pytest.approx(place, abs=1e-4)
        assert made.children[3].obj.isValid()
