"""Strips that collide beside their slots, as OpenCASCADE sees them bent in space."""

import pytest

from elastica_cad.kernel import occt
from elastica_cad.kernel.strip_body import StripWarning, model_parts
from elastica_cad.model.collisions import SHARED_MM, Body, deepest_collision
from elastica_cad.strip import BentSolid


def depth_in(placed, point):
    """How far a point within a bent strip is from its boundary, mm; None outside."""
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeVertex
    from OCP.BRepClass3d import BRepClass3d_SolidClassifier
    from OCP.BRepExtrema import BRepExtrema_DistShapeShape
    from OCP.gp import gp_Pnt
    from OCP.TopAbs import TopAbs_IN

    record, place = BentSolid.of(placed.strip, placed.frame), gp_Pnt(*point)
    solid = occt.make_solid(record)
    if BRepClass3d_SolidClassifier(solid, place, 1e-7).State() != TopAbs_IN:
        return None
    (shell,) = occt.sub_shapes(solid, "shell")
    return BRepExtrema_DistShapeShape(BRepBuilderAPI_MakeVertex(place).Vertex(), shell).Value()


@pytest.mark.parametrize("seed", [12, 32, 44, 71, 76, 96, 98, 118])
def test_the_place_that_is_reported_is_in_both_bodies(seed, slotted_pairs):
    placed = slotted_pairs.pair(seed).placed
    found = deepest_collision(*map(Body.of, placed))
    depths = [depth_in(one, found.position) for one in placed]
    # beside an edge of one of them, a little within it; tapering sides take some of that
    assert 0.8 * SHARED_MM / 2 < min(depths) < 1.01 * SHARED_MM / 2
    assert max(depths) + SHARED_MM / 2 == pytest.approx(found.depth, rel=2e-3)


def test_cad_programs_warn(slotted_pairs):
    with pytest.warns(
        StripWarning, match=r"A \(.* mm from its start\) overlaps B \(.* mm from its start\) by"
    ):
        model_parts(slotted_pairs.pair(76), (), str)
