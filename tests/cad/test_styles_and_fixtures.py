"""Perforated and laminated strips as bodies, and the blocks that hold their ends."""

import numpy as np
import pytest

from elastica_cad import (
    Hole,
    InputError,
    Laminated,
    Model,
    Perforated,
    Placed,
    PlaneCurve,
    Sheet,
    Tab,
    make_strip,
)
from elastica_cad.kernel import occt
from elastica_cad.kernel import step_files as step
from elastica_cad.strip import BentSolid, FlatSolid
from tests.cad.libraries import bd, bd_strips, cq, cq_strips

ARCH = PlaneCurve.spline([(20, 0), (40, 60), (70, 80), (120, 60), (150, 0)])
ENDS = (Tab(14, holes=(Hole(7, 3),)), Tab(14, holes=(Hole(7, 3),)))
PLY = Sheet.named("birch-plywood-0.8")


@pytest.fixture(scope="module")
def laminate():
    return make_strip(
        ARCH, PLY, style=Laminated(width=24.0, backing=PLY), ends=ENDS, label="L", ignore_limits=True
    )


@pytest.fixture(scope="module")
def perforated():
    return make_strip(
        ARCH, PLY, style=Perforated(width=30.0, columns=2, rows=5), max_width=20, ends=ENDS, label="P"
    )


def test_perforated_strip_bends_with_all_its_holes(perforated, measure):
    record = BentSolid.of(perforated)
    solid = occt.make_solid(record)
    assert len(perforated.holes) > 10
    assert measure.is_valid(solid)
    assert measure.area(occt.make_boundary(record.middle)) == pytest.approx(perforated.area, rel=1e-6)


def test_laminate_is_two_bodies_that_touch(laminate, measure):
    base, backing = (occt.make_solid(solid) for solid in BentSolid.layers(laminate))
    assert measure.is_valid(base)
    assert measure.is_valid(backing)
    for solid, layer in zip((base, backing), laminate.layers, strict=True):
        assert measure.volume(solid) == pytest.approx(layer.area * layer.sheet.thickness, rel=2e-2)
    whole = 2 * PLY.thickness
    curve = laminate.rod.curve.at(np.array([0.4 * laminate.rod.length]))
    normal = np.array([-np.sin(curve.angle[0]), np.cos(curve.angle[0])])
    for solid, offset, away in (
        (base, whole / 2, 0.0),
        (backing, -whole / 2, 0.0),
        (base, -whole / 2, PLY.thickness),
    ):
        point = [*(curve.position[0] + offset * normal), 0.0]
        assert measure.distance(solid, [point]) == pytest.approx(away, abs=1e-6)


def test_flat_laminate_is_stacked(laminate):
    base, backing = FlatSolid.layers(laminate)
    assert base.frame.origin == pytest.approx([0, 0, 0])
    assert backing.frame.origin == pytest.approx([0, 0, PLY.thickness])
    assert base.joints["start"].origin == pytest.approx([0, 0, (2 * PLY.thickness) / 2])
    assert not backing.joints


def test_step_names_both_sheets(laminate, tmp_path):
    step.write_strip_step(laminate, tmp_path / "L.step")
    step.write_step(step.model_shapes(Model((Placed(laminate),))), tmp_path / "M.step", name="M")
    one, many = ((tmp_path / name).read_text() for name in ("L.step", "M.step"))
    for name in ("L flat", "L backing flat", "L bent", "L backing bent"):
        assert f"PRODUCT('{name}'" in one
    for name in ("L", "L backing", "M"):
        assert f"PRODUCT('{name}'" in many


@pytest.mark.build123d
class TestBuild123d:
    @pytest.mark.campaign
    def test_laminate(self, laminate):
        options = {
            "style": Laminated(width=24.0, backing=PLY),
            "ends": ENDS,
            "label": "L",
            "ignore_limits": True,
        }
        for made in (bd_strips.BentStrip(ARCH, PLY, **options), bd_strips.FlatStrip(ARCH, PLY, **options)):
            assert len(made.solids()) == 2
            assert made.is_valid
            assert {"start", "end", "hole1", "hole2"} <= set(made.joints)
        whole = bd_strips.model_compound(Model((Placed(laminate),)))
        assert len(whole.children[0].solids()) == 2

    def test_fixture_holds_the_tab(self):
        options = {"max_width": 30, "ends": ENDS, "label": "A"}
        strip = bd_strips.BentStrip(ARCH, PLY, **options)
        for end in ("start", "end"):
            block = bd_strips.EndFixture(ARCH, PLY, end=end, **options)
            assert block.is_valid
            assert block.distance_to(strip) < 1e-3  # the pocket leans against the load: its walls touch there
            joint, mate = block.joints["tab"].location, strip.joints[end].location
            assert [*joint.position] == pytest.approx([*mate.position], abs=1e-9)
            assert block.strip.label == "A"
            assert block.label.startswith("fixture A:")

    def test_fixture_needs_a_tab(self):
        with pytest.raises(InputError, match="no tab"):
            bd_strips.EndFixture(ARCH, PLY, max_width=30, ends=(Tab(0), Tab(10)))


@pytest.mark.cadquery
class TestCadQuery:
    @pytest.mark.campaign
    def test_laminate(self, laminate):
        made = cq_strips.bent_strip(
            ARCH, PLY, style=Laminated(width=24.0, backing=PLY), ends=ENDS, label="L", ignore_limits=True
        )
        assert isinstance(made, cq_strips.StripCompound)
        assert len(made.Solids()) == 2
        assert made.end_face("end").geomType() == "PLANE"
        assert len(cq_strips.model_assembly(Model((Placed(laminate),))).children) == 1

    def test_fixture_holds_the_tab(self):
        options = {"max_width": 30, "ends": ENDS, "label": "A"}
        strip = cq_strips.bent_strip(ARCH, PLY, **options)
        block = cq_strips.end_fixture(ARCH, PLY, end="end", **options)
        assert block.isValid()
        assert block.distance(strip) < 1e-3  # the pocket leans against the load: its walls touch there
        assert block.joints["tab"].toTuple()[0] == pytest.approx(strip.joints["end"].toTuple()[0], abs=1e-9)


@pytest.fixture(scope="module")
def wide_laminate():
    """One of which half was lost in cuts as long as its two sheets had no face in common."""
    pom = Sheet.named("pom-0.5")
    return make_strip(ARCH, pom, style=Laminated(width=30.0, backing=pom))


def volumes_beside(strip, measure, cutter):
    """mm3 of the sheets less a body, of their part in it, and of all, one sheet after the other."""
    sheets = [occt.make_solid(solid) for solid in BentSolid.layers(strip)]
    operation = occt.kernel().BOPAlgo_Operation.BOPAlgo_COMMON
    inside = sum(measure.volume(occt._combined(sheet, [cutter], operation)) for sheet in sheets)
    whole = sum(map(measure.volume, sheets))
    return whole - inside, inside, whole - inside + measure.volume(cutter)


@pytest.mark.campaign
@pytest.mark.cadquery
def test_booleans_of_bent_laminates_in_cadquery(wide_laminate, measure):
    body = cq_strips.bent_strip(wide_laminate)
    box = body.BoundingBox()
    corner = cq.Vector((box.xmin + box.xmax) / 2, (box.ymin + box.ymax) / 2 - 200, -200)
    half = cq.Solid.makeBox(400, 400, 400, corner)
    found = body - half, body * half, body + half
    assert len(body.Solids()) == 2
    assert all(shape.isValid() for shape in found)
    assert [shape.Volume() for shape in found] == pytest.approx(
        volumes_beside(wide_laminate, measure, half.wrapped), abs=0.05
    )


@pytest.mark.build123d
def test_booleans_of_bent_laminates_in_build123d(wide_laminate, measure):
    body = bd_strips.BentStrip(wide_laminate)
    middle = body.bounding_box().center()
    half = bd.Pos(middle.X + 200, middle.Y, 0) * bd.Box(400, 400, 400)
    found = body - half, body & half, body.fuse(half)
    assert len(body.solids()) == 2
    assert all(shape.is_valid for shape in found)
    assert [shape.volume for shape in found] == pytest.approx(
        volumes_beside(wide_laminate, measure, half.wrapped), abs=0.05
    )
