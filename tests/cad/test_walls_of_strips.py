"""Strips of even width have plane long sides, and strips side by side fuse to one body without slivers."""

import numpy as np
import pytest
import shapely
import shapely.affinity

from tests.cad.libraries import bd, bd_strips

TOLERANCES = {(1.0, 1.0): 4e-2, (0.1, 0.5): 1e-2, (0.01, 0.1): 2e-3}
"""Largest relative error of the volume of a mesh, by its tolerance (mm) and angle (rad); coarse meshes are first,
because kernels keep finer meshes."""


@pytest.fixture(scope="module")
def rib():
    return bd_strips.BentStrip(
        bd.Edge.make_circle(60, start_angle=0, end_angle=150), "pom-0.5", max_width=10, mode=bd.Mode.PRIVATE
    )


def volume_of_mesh(body, tolerance, angle):
    """Volume (mm3) within the triangles of a body, by the divergence theorem."""
    points, corners = body.tessellate(tolerance, angle)
    a, b, c = (np.array([tuple(points[i]) for i in column]) for column in zip(*corners, strict=True))
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


@pytest.mark.build123d
def test_long_sides_of_even_width_are_planes(rib):
    sides = [face for face in rib.faces() if abs(face.normal_at().Z) > 0.999]
    assert {face.geom_type for face in sides} == {bd.GeomType.PLANE}
    length = rib.strip.rod.length * 0.5
    assert sum(face.area > 0.9 * length for face in sides) == 2


@pytest.mark.build123d
@pytest.mark.parametrize("pitch", [10, 5])
def test_a_wall_of_ribs_is_one_body_without_slivers(rib, pitch):
    wall = bd.Part() + [bd.Pos(0, 0, pitch * number) * rib for number in range(3)]
    outline = shapely.Polygon(rib.strip.outline.points(1e-3))
    together = [shapely.affinity.translate(outline, 0, pitch * number) for number in range(3)]
    volume = shapely.union_all(together).area * 0.5
    assert len(wall.solids()) == 1
    assert wall.volume == pytest.approx(volume, rel=1e-5)
    assert min(face.area for face in wall.faces()) > 9
    for tolerance, error in TOLERANCES.items():
        assert volume_of_mesh(wall, *tolerance) == pytest.approx(volume, rel=error)
