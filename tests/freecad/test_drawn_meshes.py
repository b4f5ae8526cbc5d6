"""The triangles that a view gets with a bent strip: closed, as near as they say, taken as they are."""

import FreeCAD as App
import Mesh
import numpy as np
import Part
import pytest
from freecad.elastica_wb.shapes import part_shapes
from freecad.elastica_wb.shapes.binary_brep import brep_bytes
from freecad.elastica_wb.shapes.drawn_meshes import mesh_of
from freecad.elastica_wb.shapes.part_shapes import make_solid

from elastica_cad.fabrication.solids.strip_solids import BentSolid
from elastica_cad.fabrication.strip.outline import Hole, Tab
from elastica_cad.fabrication.strip_spec import make_strip
from elastica_cad.geometry.curves.plane_curve import PlaneCurve

CURVES = {
    "arch": PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)]),
    "wave": PlaneCurve.spline([(0, 0), (50, 80), (90, 60), (120, -60), (160, -80), (210, 0)]),
    "sharp": PlaneCurve.spline([(0, 0), (25, 55), (60, 45), (95, -50), (130, -40), (150, 0)]),
}


def bent(name, **options):
    return BentSolid.of(
        make_strip(CURVES[name], "birch-plywood-0.8", max_width=30, ignore_limits=True, **options)
    )


def drawn(record):
    mesh = mesh_of(record.boundary)
    return mesh, part_shapes._read(brep_bytes(record.boundary, mesh=mesh))


@pytest.mark.parametrize("name", CURVES)
def test_the_triangles_are_taken_as_they_are_and_close(name):
    mesh, shape = drawn(bent(name))
    assert shape.isValid()
    points, triangles = shape.tessellate(mesh.off)
    assert len(triangles) == sum(len(face.triangles) for face in mesh.faces)
    solid = Mesh.Mesh((points, triangles))
    assert solid.isSolid()
    assert solid.Volume == pytest.approx(shape.Volume, rel=2e-3)  # positive: seen from outside all along


@pytest.mark.campaign
@pytest.mark.parametrize("name", CURVES)
def test_no_triangle_is_farther_off_than_is_said(name):
    record = bent(name)
    mesh, shape = drawn(record)
    for face, surface in zip(mesh.faces, shape.Faces, strict=True):
        middles = face.points[face.triangles].mean(axis=1)
        sides = face.points[face.triangles[:, [0, 1]]].mean(axis=1)
        for place in np.concatenate([middles, sides])[::7]:
            assert surface.distToShape(Part.Vertex(App.Vector(*place.tolist())))[0] <= mesh.off + 1e-6
    for i, edge in enumerate(record.boundary.edges):
        assert mesh.parameters[i][[0, -1]].tolist() == [edge.first, edge.last]


def test_who_asks_for_finer_triangles_gets_finer_ones():
    mesh, shape = drawn(bent("arch"))
    assert len(shape.tessellate(mesh.off / 5)[1]) > 2 * sum(len(face.triangles) for face in mesh.faces)


@pytest.mark.parametrize(
    "options",
    [
        {"ends": (Tab(12, holes=(Hole(6, 3.2),)), Tab(12))},
        {"ends": (Tab(12, width=18, corner_radius=3), Tab(12))},
    ],
    ids=["a hole", "round corners"],
)
def test_other_faces_are_left_to_opencascade(options):
    assert mesh_of(bent("arch", **options).boundary) is None


def test_without_a_window_there_are_none(monkeypatch):
    """Boxes are drawn around triangles where there are any: what a script reads hangs on the curve alone."""
    record = bent("arch")
    asked = []
    monkeypatch.setattr(part_shapes, "mesh_of", asked.append)
    make_solid(record)
    assert not App.GuiUp
    assert asked == []
