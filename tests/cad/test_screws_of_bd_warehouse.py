"""A user's script: screws of bd_warehouse through the holes of a strip's tabs, into a foot."""

import pytest

from elastica_cad import Hole, PlaneCurve, Tab
from tests.cad.libraries import bd, bd_strips

HOLE = 3.4
TABS = (Tab(12, holes=(Hole(6, HOLE),)),) * 2


def test_a_strip_screwed_to_its_foot():
    from bd_warehouse.fastener import ClearanceHole, HexNut, SocketHeadCapScrew

    arc = PlaneCurve.arc((60, 0), 50, -0.6, 0.9)
    rib = bd_strips.BentStrip(
        arc, "birch-plywood-0.8", plane=bd.Plane.XZ, max_width=12, ends=TABS, label="rib"
    )
    screw = SocketHeadCapScrew("M3-0.5", length=12, fastener_type="iso4762")
    nut = HexNut("M3-0.5", fastener_type="iso4032")
    with bd.BuildPart() as foot:
        bd.Box(11, 12, 6, align=(bd.Align.CENTER, bd.Align.CENTER, bd.Align.MAX))
        with bd.Locations((0, 0, 0)):
            ClearanceHole(fastener=screw, counter_sunk=False)
    foot.part.label = "foot"
    bd.RigidJoint("seat", foot.part, bd.Location((0, 0, 0), (180, 0, 0)))
    rib.joints["hole1:bottom"].connect_to(foot.part.joints["seat"])
    rib.joints["hole1:top"].connect_to(screw.joints["a"])

    shared = [rib & foot.part, rib & screw, foot.part & screw]
    assert [sum(solid.volume for solid in both.solids()) if both else 0 for both in shared] == pytest.approx(
        [0] * 3, abs=1e-6
    )
    head = screw.faces().sort_by(bd.Axis.Z)[-1].center()
    assert (head - rib.joints["hole1:top"].location.position).length < 13
    lamp = bd.Compound(label="lamp", children=[rib, foot.part, screw, nut])
    assert [child.label for child in lamp.children][:2] == ["rib", "foot"]
    with bd.BuildPart() as opened:
        bd_strips.BentStrip(rib)
        with bd.Locations(rib.joints["hole2:top"].location):
            ClearanceHole(fastener=screw, fit="Loose", counter_sunk=False)
    assert 0.1 < rib.volume - opened.part.volume < 1.5
