"""Scripts as users of both libraries write them: arrays, assemblies, and what they export."""

import copy
import math
import os
import pickle
import subprocess
import sys

import numpy as np
import pytest

from elastica_cad import Hole, InputError, PlaneCurve, StripSpec, Tab
from tests.cad.libraries import bd, bd_strips, cq, cq_strips

CURVE = PlaneCurve.arc((60, 0), 50, -0.6, 0.9)
END = 60 + 50 * math.cos(0.9), 50 * math.sin(0.9)
OPTIONS = {"max_width": 12.0, "ends": (Tab(12, holes=(Hole(6, 3.2),)),) * 2, "label": "rib"}
SHEET = "birch-plywood-0.8"


def stl_volume(path):
    """What the triangles of a binary STL file enclose, mm3; they must close."""
    triangle = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("spare", "<u2")])
    a, b, c = (
        np.frombuffer(path.read_bytes(), triangle, offset=84)["corners"].astype(float).transpose(1, 0, 2)
    )
    areas = np.cross(b - a, c - a) / 2
    assert np.abs(areas.sum(axis=0)).max() < 1e-4 * np.linalg.norm(areas, axis=1).sum()
    return (a * np.cross(b, c)).sum() / 6


@pytest.mark.build123d
class TestBuild123d:
    @pytest.fixture
    def rib(self):
        return bd_strips.BentStrip(CURVE, SHEET, plane=bd.Plane.XZ, **OPTIONS)

    def test_polar_locations(self, rib):
        around = bd.PolarLocations(0, 5) * rib
        assert all(body.strip is rib.strip for body in around)
        with bd.BuildPart() as part, bd.PolarLocations(0, 5):
            bd_strips.BentStrip(rib, mode=bd.Mode.ADD)
        assert len(part.part.solids()) == 5
        assert part.part.volume == pytest.approx(5 * rib.volume, rel=1e-6)
        for k, body in enumerate(around):
            place = tuple(body.joints["end"].location.position)
            turn = 2 * math.pi * k / 5
            assert place == pytest.approx(
                (END[0] * math.cos(turn), END[0] * math.sin(turn), END[1]), abs=1e-6
            )

    def test_exporters(self, rib, tmp_path):
        bd.export_stl(rib, tmp_path / "rib.stl", tolerance=1e-3)
        assert stl_volume(tmp_path / "rib.stl") == pytest.approx(rib.volume, rel=2e-3)
        bd.export_step(rib, tmp_path / "rib.step")
        read = bd.import_step(tmp_path / "rib.step")
        assert (read.label, read.volume) == ("rib", pytest.approx(rib.volume, rel=1e-4))
        bd.export_gltf(rib, str(tmp_path / "rib.glb"), binary=True)
        assert (tmp_path / "rib.glb").read_bytes()[:4] == b"glTF"
        drawing = bd.ExportSVG()
        drawing.add_shape(rib.outline)
        drawing.write(tmp_path / "rib.svg")
        size = bd.Compound(bd.import_svg(tmp_path / "rib.svg")).bounding_box().size
        assert pytest.approx((rib.rod.length + 24, 12), abs=0.2) == (size.X, size.Y)

    def test_pickled(self, rib):
        """As multiprocessing and caches do."""
        for body in (rib, rib.flat, rib.outline, rib.fixture()):
            read = pickle.loads(pickle.dumps(body))
            assert (read.label, tuple(read.color)) == (body.label, tuple(body.color))
            assert read.strip.mass == body.strip.mass
            assert read.area == pytest.approx(body.area, rel=1e-9)
            assert list(read.joints) == list(body.joints)

    def test_scaled_it_is_no_strip(self, rib):
        for body in (rib, rib.flat, rib.outline):
            larger = body.scale(2)
            assert larger.area == pytest.approx(4 * body.area, rel=1e-6)
            assert larger.label == "rib"
            assert not hasattr(larger, "strip")
        stretched = rib.transform_geometry(bd.Matrix([[1, 0, 0, 0], [0, 2, 0, 0], [0, 0, 1, 0]]))
        assert not hasattr(stretched, "strip")

    @pytest.mark.campaign
    def test_made_anew_elsewhere_its_other_bodies_follow(self, rib):
        """`transformed` and `transform=True` make a shape anew instead of placing it."""

        there = bd.Location((10, 20, 30), (0, 0, 30))
        for moved in (
            rib.transformed((0, 0, 30), (10, 20, 30)),
            rib.rotate(bd.Axis.Z, 30, transform=True).translate((10, 20, 30), transform=True),
        ):
            placed = there * rib
            for name, joint in placed.joints.items():
                assert (moved.joints[name].location.position - joint.location.position).length < 1e-6
            for body, other in ((moved, placed), (moved.bent(), placed), (moved.fixture(), placed.fixture())):
                assert (body.center() - other.center()).length < 1e-4


@pytest.mark.cadquery
class TestCadQuery:
    @pytest.fixture
    def rib(self):
        return cq_strips.bent_strip(CURVE, SHEET, plane=cq.Plane.XZ(), **OPTIONS)

    def test_as_plugins_are_tested(self):
        """`cadquery-plugins` asks that an object comes at every point of the stack, and combines if told."""

        cq_strips.register()
        drawn = cq.Workplane("XZ").spline([(0, 0), (60, 50), (120, 0)])
        result = (
            drawn.rect(400, 200, forConstruction=True)
            .vertices()
            .elasticStrip(SHEET, max_width=12, form="flat")
        )
        assert result.solids().size() == 4
        corners = sorted((round(body.Center().x), round(body.Center().z)) for body in result.vals())
        assert np.ptp(corners, axis=0) == pytest.approx((400, 200), abs=1)
        base = cq.Workplane().box(500, 300, 2, centered=(False, True, False))
        joined = base.faces(">Z").workplane().spline([(0, 0), (60, 50), (120, 0)]).elasticStrip(
            SHEET, max_width=12, form="flat", combine=True
        )  # fmt: skip
        assert joined.solids().size() == 1
        assert joined.val().Volume() > base.val().Volume()

    def test_assembly_that_is_solved(self, rib):
        """A foot finds its place on the strip's end face."""

        work = cq.Workplane(obj=rib)
        work.newObject([rib.end_face("start")]).tag("start")
        foot = cq.Workplane().box(20, 20, 5)
        foot.faces(">Z").tag("top")
        made = (
            cq.Assembly(name="lamp").add(work, name="rib").add(foot, name="foot", loc=cq.Location((5, 5, 5)))
        )
        made.constrain("rib", "Fixed").constrain("rib?start", "foot?top", "Plane")
        made.solve()
        there = made.objects["foot"].loc * cq.Location((0, 0, 2.5))
        assert (cq.Vector(*there.toTuple()[0]) - rib.end_face("start").Center()).Length < 1e-3

    def test_exporters(self, rib, tmp_path):
        cq.exporters.export(cq.Workplane(obj=rib), str(tmp_path / "rib.stl"), tolerance=1e-3)
        assert stl_volume(tmp_path / "rib.stl") == pytest.approx(rib.Volume(), rel=2e-3)
        cq.exporters.export(cq.Workplane(obj=rib), str(tmp_path / "rib.step"))
        read = cq.importers.importStep(str(tmp_path / "rib.step")).val()
        assert read.isValid()
        assert read.Volume() == pytest.approx(rib.Volume(), rel=1e-4)
        made = cq.Assembly(rib, name="rib", color=rib.color)
        made.export(str(tmp_path / "rib.glb"))
        assert (tmp_path / "rib.glb").read_bytes()[:4] == b"glTF"
        cq.exporters.export(cq.Workplane(obj=rib.outline), str(tmp_path / "rib.svg"))
        assert "<path" in (tmp_path / "rib.svg").read_text()

    def test_copied_and_pickled(self, rib):
        """As multiprocessing and caches do."""
        for body in (rib, rib.flat, rib.outline, rib.fixture()):
            for read in (copy.copy(body), copy.deepcopy(body), pickle.loads(pickle.dumps(body))):
                assert (type(read), read.label) == (type(body), body.label)
                assert read.color.toTuple() == body.color.toTuple()
                assert read.strip.mass == body.strip.mass
                assert read.Area() == pytest.approx(body.Area(), rel=1e-9)
                assert read.flat.Volume() == pytest.approx(rib.flat.Volume(), rel=1e-9)
        assert pickle.loads(pickle.dumps(rib)).joints["end"].toTuple() == rib.joints["end"].toTuple()

    def test_scaled_it_is_no_strip(self, rib):
        for body in (rib, rib.flat, rib.outline):
            larger = body.scale(2)
            assert larger.Area() == pytest.approx(4 * body.Area(), rel=1e-6)
            assert larger.label == "rib"
            assert not hasattr(larger, "strip")

    def test_rounded_it_is_no_strip(self, rib):
        """CadQuery gives it the same class: it is copied, pickled and mirrored like any solid."""

        flat = rib.flat
        corner = cq.Workplane(obj=flat).edges("|Z and <X").vals()[:1]
        for body in (rib.fillet(0.1, rib.Edges()[:1]), flat.chamfer(0.1, None, corner)):
            for read in (
                copy.copy(body),
                pickle.loads(pickle.dumps(body)),
                body.mirror("YZ"),
                body.moved(x=1),
            ):
                assert read.Volume() == pytest.approx(body.Volume(), rel=1e-6)
                assert not hasattr(read, "strip")
            for ask in (
                lambda body=body: body.strip,
                lambda body=body: body.bent(),
                lambda body=body: body.color,
            ):
                with pytest.raises(AttributeError, match="was rounded, chamfered or hollowed has no"):
                    ask()
        with pytest.raises(AttributeError, match="has no attribute 'widht'"):
            _ = rib.widht

    def test_slips_are_reported_in_a_sentence(self, rib):
        ball = cq.Workplane().sphere(60)
        slips = {
            "max_width is '12'": lambda: cq_strips.bent_strip(CURVE, SHEET, max_width="12"),
            "compensate is 'no': give True or False": lambda: cq_strips.bent_strip(
                CURVE, SHEET, max_width=12, compensate="no"
            ),
            "walls is not an option of a fixture: did you mean wall": lambda: rib.fixture(walls=3),
            "no end 'middle'": lambda: rib.end_face("middle"),
            "Pass a point in space, or two numbers": lambda: rib.bent(end="x"),
            "A int cannot be cut": lambda: cq_strips.section_strips(5, cq.Plane.XZ(), SHEET, max_width=9),
            "plane is 'XZ'": lambda: cq_strips.section_strips(ball, "XZ", SHEET, max_width=9),
            "angles are .*: give two": lambda: cq_strips.elastica((0, 0), (10, 0), 50, angles=30),
            r"A StripSpec is not a curve\. Pass the strip that its \.make\(\)": lambda: cq_strips.bent_strip(
                StripSpec(CURVE, SHEET, max_width=12)
            ),
            r"A Rod is not a curve\. Pass ec\.Strip": lambda: cq_strips.bent_strip(
                rib.rod, SHEET, max_width=12
            ),
            r"A Placed is not a curve\. Pass its \.strip": lambda: cq_strips.bent_strip(rib.placed),
            "the model is a list": lambda: cq_strips.model_assembly([rib.placed]),
            "buckling is 0: give": lambda: cq_strips.elastica((0, 0), (10, 0), 50, buckling=0),
        }
        for says, slip in slips.items():
            with pytest.raises(InputError, match=says):
                slip()
        on_vectors = cq_strips.elastica(cq.Vector(0, 0), cq.Vector(10, 0), 50)
        assert on_vectors.Length() == pytest.approx(50, rel=1e-6)

    @pytest.mark.campaign
    def test_a_label_of_any_letters_is_engraved(self):
        """A fixture's own number is in letters that the alphabet has."""

        rib = cq_strips.bent_strip(CURVE, SHEET, max_width=12, label="Träger ß")
        block = rib.fixture("end")
        assert block.isValid()
        assert block.Volume() < rib.fixture("end", engrave="").Volume()


@pytest.mark.campaign
def test_a_skin_is_there_soon_after_its_library(project_root):
    """What solves and animates strips is imported when it is asked for."""
    library = os.environ.get("ELASTICA_KERNELS", "build123d").split(",")[0]
    late = "optimal_rod", "nearest_rod", "end_travel", "strip_as_made", "assembly", "strip_spec"
    code = (
        f"import sys, elastica_cad.{library}\n"
        f"print(sorted(set({late}) & {{name.rpartition('.')[2] for name in sys.modules if 'elastica' in name}}))"
    )
    result = subprocess.run(
        [sys.executable, "-c", code], cwd=project_root, capture_output=True, text=True, check=False
    )
    assert result.stdout.strip() == "[]", result.stderr


class TestWhatAScriptExpects:
    """Defaults and words that people guess."""

    POINTS = ((0, 0), (60, 50), (120, 0))

    @pytest.mark.build123d
    def test_a_strip_is_bent_and_has_a_flat_one(self):
        with bd.BuildPart() as part:
            with bd.BuildLine(bd.Plane.XZ) as drawn:
                bd.Spline(*self.POINTS)
            rib = bd_strips.elastic_strip(sheet=SHEET, max_width=12)
        assert part.part.bounding_box().size.Z > 20
        assert pytest.approx(rib.strip.sheet.thickness) == rib.flat.bounding_box().size.Z
        assert rib.bent().volume == pytest.approx(rib.volume)
        again = bd_strips.elastic_strip(drawn, sheet=SHEET, max_width=12)  # a builder stands for its line
        assert again.volume == pytest.approx(rib.volume)

    @pytest.mark.cadquery
    def test_a_curve_drawn_in_metres_is_refused(self):
        edge = cq.Edge.makeSpline([cq.Vector(x / 1000, y / 1000) for x, y in self.POINTS])
        with pytest.raises(InputError, match="Draw it in millimetres"):
            cq_strips.bent_strip(edge, SHEET, max_width=12)

    @pytest.mark.cadquery
    def test_a_fixture_of_cadquery_has_its_own_name_and_colour(self):
        rib = cq_strips.bent_strip(
            cq.Edge.makeSpline([cq.Vector(*point) for point in self.POINTS]), SHEET, max_width=12
        )
        block = rib.fixture("end")
        assert block.label != rib.label
        assert block.color.toTuple() != rib.color.toTuple()
