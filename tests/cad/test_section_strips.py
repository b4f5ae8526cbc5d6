"""Strips along the sections of faces and bodies, in both libraries."""

import numpy as np
import pytest

from elastica_cad import InputError, Limits
from elastica_cad.form_finding.section_spec import ParallelCuts, PlaneSplit, SectionSpec
from elastica_cad.kernel.strip_body import StripWarning
from tests.cad.libraries import bd, bd_strips, cq, cq_strips

CARD = "card-200gsm"
CUTS = SectionSpec(ParallelCuts((0, 1, 0), offsets=(-20.0, 20.0)), splits=(PlaneSplit((0, 0, 1)),))


def off_sphere(body, radius):
    """How far the middle of a strip leaves the sphere about the origin, mm."""
    at = body.frame.point(body.rod.position)
    return np.abs(np.linalg.norm(at, axis=1) - radius).max()


@pytest.mark.build123d
def test_build123d():
    ball = bd.Solid.make_sphere(60, angle1=20)
    dome = ball.faces().sort_by(bd.Axis.Z)[-1]
    planes = [bd.Plane.XZ.offset(y) for y in (-20, 0, 20)]
    ribs = bd_strips.section_strips(dome, planes, CARD, max_width=8, label="rib")
    assert [type(rib) for rib in ribs] == [bd_strips.BentStrip] * 3
    assert [rib.label for rib in ribs] == ["rib-1", "rib-2", "rib-3"]
    for rib, plane in zip(ribs, planes, strict=True):
        assert off_sphere(rib, 60) < 0.3
        assert rib.frame.origin @ rib.frame.z_axis == pytest.approx(tuple(plane.origin) @ rib.frame.z_axis)
    (half,) = bd_strips.section_strips(dome, bd.Plane.XZ, CARD, max_width=8, half=True)
    assert half.rod.length == pytest.approx(ribs[1].rod.length / 2, rel=1e-3)
    halves = bd_strips.section_strips(bd.Sphere(60), CUTS, CARD, max_width=8, limits=Limits(ratio=3))
    assert len(halves) == 4
    with pytest.raises(InputError, match="split"):
        bd_strips.section_strips(bd.Sphere(60), bd.Plane.XZ, CARD, max_width=8)
    with pytest.raises(InputError, match="no faces"):
        bd_strips.section_strips(bd.Edge.make_line((0, 0), (1, 0)), bd.Plane.XZ, CARD, max_width=8)
    with pytest.raises(InputError, match="There is no plane"):
        bd_strips.section_strips(dome, [], CARD, max_width=8)
    with pytest.warns(StripWarning, match="misses"):
        bd_strips.section_strips(dome, [bd.Plane.XZ, bd.Plane.XZ.offset(100)], CARD, max_width=8)


@pytest.mark.cadquery
def test_cadquery():
    dome = cq.Workplane().sphere(60, angle1=20).faces(">Z")
    planes = [cq.Plane.XZ((0, y, 0)) for y in (-20, 0, 20)]
    ribs = cq_strips.section_strips(dome, planes, CARD, max_width=8)
    assert [type(rib) for rib in ribs] == [cq_strips.StripSolid] * 3
    assert [rib.label for rib in ribs] == ["strip-1", "strip-2", "strip-3"]
    assert max(off_sphere(rib, 60) for rib in ribs) < 0.3
    halves = cq_strips.section_strips(cq.Solid.makeSphere(60, angleDegrees1=-90), CUTS, CARD, max_width=8)
    assert len(halves) == 4
    with pytest.raises(InputError, match="split"):
        cq_strips.section_strips(cq.Solid.makeSphere(60, angleDegrees1=-90), cq.Plane.XZ(), CARD, max_width=8)
    with pytest.raises(InputError, match=r"for a Workplane pass its \.plane"):
        cq_strips.section_strips(dome, cq.Workplane("XZ"), CARD, max_width=8)
