"""The engraved text as edges on the flat part, and the message about a pocket that leans."""

import re

import build123d as bd
import cadquery as cq
import numpy as np
import pytest

import elastica_cad as ec

ARCH = ec.PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])
OPTIONS = {"max_width": 30, "label": "A1"}


def test_engraved_edges_are_the_strokes_of_the_drawing():
    from elastica_cad.build123d import BentStrip
    from elastica_cad.cadquery import bent_strip

    rib = BentStrip(ARCH, "birch-plywood-0.8", **OPTIONS, mode=bd.Mode.PRIVATE)
    strokes = [item.path for item in rib.strip.drawing().strokes if item.layer == "ENGRAVE"]
    length = sum(segment.length for path in strokes for segment in path.segments)
    edges = rib.engraving
    assert len(edges) == sum(len(path.segments) for path in strokes) > 4
    assert sum(edge.length for edge in edges) == pytest.approx(length)
    top = rib.flat.bounding_box().max.Z
    assert {round(edge.bounding_box().min.Z, 5) for edge in edges} == {round(top, 5)}
    others = bent_strip(ARCH, "birch-plywood-0.8", **OPTIONS).engraving
    assert sum(edge.Length() for edge in others) == pytest.approx(length)
    assert BentStrip(ARCH, "birch-plywood-0.8", **OPTIONS, engrave="", mode=bd.Mode.PRIVATE).engraving == []


@pytest.mark.parametrize("end", ["start", "end"])
def test_overlap_of_a_leaning_pocket_is_reported(end):
    from elastica_cad.build123d import BentStrip

    rib = BentStrip(ARCH, "birch-plywood-0.8", **OPTIONS, mode=bd.Mode.PRIVATE)
    block = rib.fixture(end)
    (text,) = set(block.warnings) - set(rib.warnings)
    angle, _, depth = map(float, re.search(r"by (\S+) degrees .* by (\S+) mm, .* to (\S+) mm", text).groups())
    place = block.joints["tab"].location.inverse()
    overlaps = [place * solid for solid in (block & rib).solids()]
    # the plane of the curve is xz of the joint; the overlaps are wedges beside both faces of the tab
    deepest = max(solid.bounding_box().size.Z for solid in overlaps)
    assert deepest == pytest.approx(depth, rel=0.05)
    assert angle == pytest.approx(abs(np.degrees(block._made.block.lean[1])), rel=0.05)


def test_pocket_of_an_unloaded_strip_does_not_lean():
    from elastica_cad.cadquery import bent_strip

    straight = bent_strip(cq.Edge.makeLine(cq.Vector(0, 0), cq.Vector(100, 0)), "mdf-3", max_width=20)
    assert straight.fixture("start").warnings == straight.warnings
