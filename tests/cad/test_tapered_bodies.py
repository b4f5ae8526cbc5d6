"""Tapered strips, rods and tubes as bodies of the kernels: closed, valid, as heavy as the strip, and in STEP."""

from importlib import import_module
from importlib.util import find_spec

import pytest

from elastica_cad import Keep, PlaneCurve, Sheet, Tab, make_strip
from elastica_cad.kernel.occt import make_solid
from elastica_cad.kernel.step_files import write_strip_step
from elastica_cad.mechanics import LeavesLaw, RoundLaw, ThicknessLaw
from elastica_cad.strip import BentSolid, FlatSolid

GLASS = Sheet("glass", 3.0, 38000.0, density=1900.0, max_strain=0.02)
ARCH = PlaneCurve.spline([(0, 0), (60, 120), (140, 160), (240, 120), (300, 0)])
LEANING = PlaneCurve.spline([(0, 0), (10, 150), (120, 220), (240, 120), (300, 0)], degree=4)
LAWS = {
    "thickness": ThicknessLaw(GLASS, 1.0, 4.0, width=20.0),
    "rod": RoundLaw(GLASS, 1.0, 4.0),
    "tube": RoundLaw(GLASS, 1.0, 4.0, bore=0.6),
}


@pytest.mark.parametrize("law", LAWS.values(), ids=LAWS)
def test_flat_and_bent_bodies_are_valid_and_weigh_what_the_strip_does(law, tmp_path):
    from OCP.BRepCheck import BRepCheck_Analyzer
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps

    strip = make_strip(ARCH, GLASS, section=law)
    for record in (*FlatSolid.layers(strip), *BentSolid.layers(strip)):
        shape, properties = make_solid(record), GProp_GProps()
        BRepGProp.VolumeProperties_s(shape, properties)
        assert BRepCheck_Analyzer(shape).IsValid()
        assert properties.Mass() == pytest.approx(strip.mass / GLASS.density * 1e6, rel=2e-6)
    write_strip_step(strip, tmp_path / "batten.step")
    assert (tmp_path / "batten.step").stat().st_size > 10_000


LEAF = Sheet("ash leaf", 0.6, 12000.0, density=680.0, max_strain=0.02)


def test_leaves_are_bodies_of_their_own_that_touch(tmp_path):
    from OCP.BRepAlgoAPI import BRepAlgoAPI_Common
    from OCP.BRepCheck import BRepCheck_Analyzer
    from OCP.BRepExtrema import BRepExtrema_DistShapeShape
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps

    def volume(shape):
        properties = GProp_GProps()
        BRepGProp.VolumeProperties_s(shape, properties)
        return properties.Mass()

    strip = make_strip(LEANING, LEAF, section=LeavesLaw(LEAF, 3, 20.0), keep=Keep(), ends=(Tab(0), Tab(0)))
    section = strip.layout.section
    for form in (FlatSolid, BentSolid):
        shapes = [make_solid(record) for record in form.layers(strip)]
        assert all(BRepCheck_Analyzer(shape).IsValid() for shape in shapes)
        assert [volume(shape) for shape in shapes] == pytest.approx(
            [20.0 * 0.6 * leaf.length for leaf in section.leaves], rel=0.01 if form is BentSolid else 1e-6
        )
        above = list(zip(section.leaves, shapes, strict=True))[1:]
        # the kernel takes seconds for each pair of bent leaves, so one pair stands for the others
        for leaf, shape in above[:1] if form is BentSolid else above:
            below = next(
                s for one, s in zip(section.leaves, shapes, strict=True) if one.number == leaf.number - 1
            )
            assert BRepExtrema_DistShapeShape(shape, below).Value() < 1e-5
            assert volume(BRepAlgoAPI_Common(shape, below).Shape()) < 1e-2
    write_strip_step(strip, tmp_path / "leaves.step")
    text = (tmp_path / "leaves.step").read_text()
    assert text.count("MANIFOLD_SOLID_BREP") == 2 * len(section.leaves)
    assert "strip leaf 2" in text


def test_leaves_in_the_kernels():
    """The door of whichever kernel is there: as many solids as leaves."""
    law, count = LeavesLaw(LEAF, 3, 20.0), None
    for name in ("build123d", "cadquery"):
        if find_spec(name) is None:
            continue
        door = import_module(f"elastica_cad.{name}")
        make = door.elastic_strip if name == "build123d" else door.bent_strip
        made = make(ARCH, sheet=LEAF, section=law, keep=Keep())
        solids = made.layers if hasattr(made, "layers") else made.strip.layers
        count = len(solids)
        assert count == len(made.strip.layout.section.leaves)
    assert count is not None
