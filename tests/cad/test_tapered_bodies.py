"""Tapered strips, rods and tubes as bodies of the kernels: closed, valid, as heavy as the strip, and in STEP."""

import pytest

from elastica_cad.fabrication.solids.strip_solids import BentSolid, FlatSolid
from elastica_cad.fabrication.strip_spec import make_strip
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.kernel.occt import make_solid
from elastica_cad.kernel.step_files import write_strip_step
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.material.tapered_sections import RoundLaw, ThicknessLaw

GLASS = Sheet("glass", 3.0, 38000.0, density=1900.0, max_strain=0.02)
ARCH = PlaneCurve.spline([(0, 0), (60, 120), (140, 160), (240, 120), (300, 0)])
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

    strip = make_strip(ARCH, GLASS, law=law)
    for record in (*FlatSolid.layers(strip), *BentSolid.layers(strip)):
        shape, properties = make_solid(record), GProp_GProps()
        BRepGProp.VolumeProperties_s(shape, properties)
        assert BRepCheck_Analyzer(shape).IsValid()
        assert properties.Mass() == pytest.approx(strip.mass / GLASS.density * 1e6, rel=2e-6)
    write_strip_step(strip, tmp_path / "batten.step")
    assert (tmp_path / "batten.step").stat().st_size > 10_000
