"""What ocp_vscode, CQ-editor and Jupyter do with an object to show it: meshes, compounds, web pages, colours."""

import numpy as np
import pytest

from elastica_cad import Hole, Laminated, Model, Placed, PlaneCurve, Sheet, Tab, make_strip
from tests.cad.libraries import bd_strips, cq, cq_strips

ARCH = PlaneCurve.spline([(20, 0), (40, 60), (70, 80), (120, 60), (150, 0)])
PLY = Sheet.named("birch-plywood-0.8")
OPTIONS = {"max_width": 20, "ends": (Tab(12, holes=(Hole(6, 3.2),)), Tab(12)), "label": "A"}
LAMINATE = {"style": Laminated(width=24.0, backing=PLY), "label": "L", "ignore_limits": True}


@pytest.fixture(scope="module")
def model():
    strip = make_strip(ARCH, PLY, **OPTIONS)
    return Model((Placed(strip, (0, 0, 0), (1, 0, 0), (0, 0, 1)),), name="crown").rotated(3)


def enclosed(vertices, triangles):
    """Volume inside a closed mesh, by the divergence theorem."""
    a, b, c = np.moveaxis(np.array([tuple(v) for v in vertices])[np.array(triangles)], 1, 0)
    return np.einsum("ij,ij->", a, np.cross(b, c)) / 6


@pytest.mark.build123d
class TestBuild123d:
    def shown(self, model):
        return [
            bd_strips.BentStrip(ARCH, PLY, **OPTIONS),
            bd_strips.FlatStrip(ARCH, PLY, **OPTIONS),
            bd_strips.BentStrip(ARCH, PLY, **LAMINATE),
            bd_strips.EndFixture(ARCH, PLY, **OPTIONS),
            bd_strips.model_compound(model, others=model.fixtures()[:1]),
        ]

    def test_meshes_are_closed_and_fine(self, model):
        for shape in self.shown(model):
            for solid in shape.solids():  # those of a laminate share a face
                vertices, triangles = solid.tessellate(0.01)
                points = [tuple(vertex) for vertex in vertices]
                assert enclosed(points, triangles) == pytest.approx(solid.volume, rel=0.02)

    @pytest.mark.campaign
    def test_jupyter(self, model):
        from build123d.vtk_tools import has_vtk

        for shape in self.shown(model):
            page = shape._repr_html_()
            assert ("<script>" in page) if has_vtk else repr(shape) == page

    @pytest.mark.campaign
    def test_colours_names_and_joints_of_all_that_is_shown(self, model):
        """ocp_vscode walks children, and asks each for label, colour and the symbols of its joints."""
        *single, whole = self.shown(model)
        for shape in (*single, *whole.children):
            assert shape.label
            assert len(tuple(shape.color)) == 4
            assert shape.joints
            assert all(joint.symbol.edges() for joint in shape.joints.values())
        assert [child.label for child in whole.children] == ["A_1", "A_2", "A_3", "fixture A:1"]


@pytest.mark.cadquery
class TestCadQuery:
    def shown(self):
        return [
            cq_strips.bent_strip(ARCH, PLY, **OPTIONS),
            cq_strips.flat_strip(ARCH, PLY, **OPTIONS),
            cq_strips.bent_strip(ARCH, PLY, **LAMINATE),
            cq_strips.end_fixture(ARCH, PLY, **OPTIONS),
        ]

    @pytest.mark.campaign
    def test_meshes_are_closed_and_fine(self):
        for shape in self.shown():
            for solid in shape.Solids():  # those of a laminate share a face
                vertices, triangles = solid.tessellate(0.01)
                assert enclosed([v.toTuple() for v in vertices], triangles) == pytest.approx(
                    solid.Volume(), rel=0.02
                )

    @pytest.mark.campaign
    def test_what_web_pages_are_made_of(self, model):
        from cadquery.occ_impl.assembly import toJSON

        for shape in (*self.shown(), cq_strips.strip_outline(ARCH, PLY, **OPTIONS)):
            parts = toJSON(cq.Assembly(shape))
            assert parts
            assert all("<VTKFile" in part["shape"] for part in parts)
        parts = toJSON(cq_strips.model_assembly(model))
        assert sum(np.allclose(part["color"], (0.85, 0.70, 0.48, 1), atol=0.01) for part in parts) == 3

    @pytest.mark.campaign
    @pytest.mark.build123d  # which brings IPython
    def test_jupyter(self, model):
        for shown in (self.shown()[0], cq_strips.model_assembly(model)):
            assert "render" in shown._repr_javascript_()

    @pytest.mark.campaign
    def test_cq_editor(self, model):
        """`show_object` puts shapes into one compound, and turns an assembly into a document of OpenCASCADE."""
        from cadquery.occ_impl.assembly import toCAF

        shapes = self.shown()
        together = cq.Compound.makeCompound(shapes)
        assert together.Volume() == pytest.approx(sum(shape.Volume() for shape in shapes), rel=1e-3)
        label, _ = toCAF(cq_strips.model_assembly(model, others=model.fixtures()[:1]))
        assert label.NbChildren() == 4

    def test_joints_are_no_dict(self):
        """ocp_vscode takes a dict called joints for build123d's, whose values have symbols to draw."""

        shape = cq_strips.bent_strip(ARCH, PLY, **OPTIONS)
        assert set(shape.joints) == {"start", "end", "hole1", "hole1:top", "hole1:bottom"}
        assert not isinstance(shape.joints, dict)
