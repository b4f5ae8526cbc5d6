"""A strip is solved once: from one body come all others, through copies, moves and turns; options by name."""

from dataclasses import fields

import pytest

from elastica_cad import (
    Hole,
    InputError,
    Laminated,
    Limits,
    Model,
    PlaneCurve,
    Sheet,
    Slot,
    Strip,
    StripSpec,
    Tab,
    optimal_rod,
)
from elastica_cad.kernel.strip_body import StripWarning
from elastica_cad.kernel.strip_on_path import StripOptions
from tests.cad.libraries import bd, bd_strips, cq, cq_strips

CURVE = PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])
SHEET = "birch-plywood-0.8"
OPTIONS = {"max_width": 30, "ends": (Tab(12, holes=(Hole(6, 3.2),)), Tab(12)), "label": "A1"}


def test_options_are_those_of_the_request():
    request = {field.name for field in fields(StripSpec)} - {"curve", "sheet", "frame", "max_width"}
    assert set(StripOptions.__annotations__) == request | {"plane", "color"}


@pytest.mark.build123d
class TestBuild123d:
    @pytest.fixture
    def rib(self):
        return bd_strips.BentStrip(CURVE, SHEET, **OPTIONS)

    def test_all_bodies_of_one(self, rib):
        assert isinstance(rib.flat, bd_strips.FlatStrip)
        assert isinstance(rib.outline, bd_strips.StripOutline)
        assert isinstance(rib.fixture("end"), bd_strips.EndFixture)
        assert isinstance(rib.flat.bent(), bd_strips.BentStrip)
        for body in (
            rib.flat,
            rib.outline,
            rib.fixture("start"),
            rib.flat.bent(),
            bd_strips.FlatStrip(rib.strip),
        ):
            assert body.strip is rib.strip
        assert rib.flat.volume == pytest.approx(rib.strip.area * 0.8, rel=1e-4)

    def test_equal_requests_share_their_solve(self, rib):
        assert bd_strips.FlatStrip(CURVE, SHEET, **OPTIONS).strip is rib.strip
        assert bd_strips.BentStrip(CURVE, SHEET, **{**OPTIONS, "max_width": 29}).strip is not rib.strip

    def test_in_its_place(self, rib):
        place = bd.Location((5, -7, 11), (20, 30, 40))
        moved = place * rib
        placed = moved.placed
        wanted = place * bd.Plane.XY
        assert placed.frame.origin == pytest.approx(tuple(wanted.origin), abs=1e-9)
        assert placed.frame.z_axis == pytest.approx(tuple(wanted.z_dir), abs=1e-9)
        (part,) = Model([placed]).placed
        assert part.strip is rib.strip
        block = moved.fixture("start")
        assert (
            pytest.approx(moved.joints["start"].location.position.X, abs=1e-6)
            == block.joints["tab"].location.position.X
        )
        again = bd.Location((1, 0, 0)) * moved.bent()
        assert (again.center() - moved.center()).length == pytest.approx(1, abs=1e-6)

    def test_laminate(self, tmp_path):
        base = Sheet.named(SHEET)
        style = Laminated(width=24.0, backing=Sheet.named("hdf-1.5"), least_backing=0.2)
        rib = bd_strips.BentStrip(CURVE, base, style=style, label="L", ignore_limits=True)
        assert [layer.label for layer in rib.layers] == ["L", "L backing"]
        assert tuple(rib.layers[0].color) != tuple(rib.layers[1].color)
        assert rib.backing.label == "L backing"
        parts = (bd.Pos(0, 0, 9) * rib.assembly).children
        assert [part.label for part in parts] == ["L", "L backing"]
        assert sum(part.volume for part in parts) == pytest.approx(rib.volume)
        bd.export_step(rib.assembly, tmp_path / "laminate.step")
        read = bd.import_step(tmp_path / "laminate.step")
        assert [part.label for part in read.children] == ["L", "L_backing"]
        assert [tuple(part.color) for part in read.children] == [
            pytest.approx(tuple(part.color), abs=1e-3) for part in parts
        ]
        above = (bd.Pos(0, 0, 90) * rib).placed
        (child, twin) = bd_strips.model_compound(Model([rib.placed, above])).children
        assert [part.label for part in child.children] == ["L_1", "L_1 backing"]
        assert [part.label for part in twin.children] == ["L_2", "L_2 backing"]
        assert pytest.approx(90) == (twin.center() - child.center()).Z
        with pytest.raises(InputError, match="no backing"):
            _ = bd_strips.BentStrip(CURVE, SHEET, **OPTIONS).backing

    def test_faces_and_bodies_are_no_curves(self):
        for drawn in (bd.Box(30, 20, 10), bd.Face.make_rect(30, 20), bd.Box(30, 20, 10).faces()):
            with pytest.raises(InputError, match="Use one of its edges"):
                bd_strips.BentStrip(drawn, SHEET, max_width=5)
        bd_strips.BentStrip(bd.Box(30, 20, 10).edges()[0], SHEET, max_width=5)

    def test_bent_further(self, rib):
        near = rib.bent(end=(140.0, 0.0))
        assert pytest.approx(140, abs=1e-4) == near.joints["end"].location.position.X
        assert near.volume == pytest.approx(rib.volume, rel=1e-4)
        assert near.strip.rod.length == pytest.approx(rib.rod.length)

    def test_one_strip_a_chain(self):
        with bd.BuildPart() as part:
            with bd.BuildLine():
                bd.Spline((0, 0), (40, 40), (90, 50), (140, 0))
                bd.Spline((0, 90), (40, 130), (90, 140), (140, 90))
            strips = bd_strips.elastic_strip(sheet=SHEET, max_width=20, form="bent")
        assert [type(strip) for strip in strips] == [bd_strips.BentStrip] * 2
        assert len(part.part.solids()) == 2

    def test_deviation(self):
        moved = bd_strips.BentStrip(CURVE, SHEET, max_width=30, limits=Limits(ratio=1.2))
        assert moved.deviation > 0.01
        assert bd_strips.BentStrip(CURVE, SHEET, max_width=30).deviation == 0

    def test_too_much_strain_is_warned_of(self):
        with pytest.warns(StripWarning, match="thinner material") as result:
            bd_strips.FlatStrip(PlaneCurve.arc((0, 0), 20, 0, 2), SHEET, max_width=10, ignore_limits=True)
        assert result[0].filename == __file__


@pytest.mark.cadquery
class TestCadQuery:
    @pytest.fixture
    def rib(self):
        return cq_strips.bent_strip(CURVE, SHEET, **OPTIONS)

    def test_all_bodies_of_one(self, rib):
        for body in (
            rib.flat,
            rib.outline,
            rib.fixture("start"),
            rib.flat.bent(),
            cq_strips.flat_strip(rib.strip),
        ):
            assert body.strip is rib.strip
        assert cq_strips.strip_outline(CURVE, SHEET, **OPTIONS).strip is rib.strip
        assert rib.bent(end=(140.0, 0.0)).joints["end"].toTuple()[0][0] == pytest.approx(140, abs=1e-4)
        assert rib.label == "A1"
        assert rib.color.toTuple()[:3] == pytest.approx((0.85, 0.70, 0.48))

    @pytest.mark.parametrize(
        "change",
        [
            lambda s: s.copy(),
            lambda s: s.translate((1, 2, 3)),
            lambda s: s.rotate((0, 0, 0), (0, 0, 1), 30),
            lambda s: s.mirror("XZ"),
            lambda s: s.clean(),
            lambda s: s.moved(x=5),
            lambda s: s.translate((1, 2, 3)).moved(x=5).rotate((0, 0, 0), (1, 1, 0), 50),
        ],
        ids=["copy", "translate", "rotate", "mirror", "clean", "moved", "all"],
    )
    def test_stays_a_strip(self, rib, change):
        made = change(rib)
        assert type(made) is type(rib)
        assert made.strip is rib.strip
        assert (made.label, made.color.toTuple()) == (rib.label, rib.color.toTuple())
        for end in ("start", "end"):
            face = made.end_face(end)
            assert face.geomType() == "PLANE"
            tip = made.joints[end] * cq.Location((12, 0, 0))
            assert (face.Center() - cq.Vector(*tip.toTuple()[0])).Length < 1e-6

    def test_laminate(self):
        style = Laminated(width=24.0, backing=Sheet.named("hdf-1.5"), least_backing=0.2)
        rib = cq_strips.bent_strip(CURVE, SHEET, style=style, label="L", ignore_limits=True)
        assert [layer.label for layer in rib.layers] == ["L", "L backing"]
        base, backing = rib.assembly.children
        assert (rib.assembly.name, base.name, backing.name) == ("L", "L_2", "L_backing")
        assert base.color.toTuple() != backing.color.toTuple()
        with pytest.raises(InputError, match="Use one of its edges"):
            cq_strips.bent_strip(base.obj, SHEET, max_width=5)
        assert base.obj.Volume() + backing.obj.Volume() == pytest.approx(rib.Volume())

    def test_in_its_place(self, rib):
        frame = rib.translate((1, 2, 3)).rotate((0, 0, 0), (1, 0, 0), 90).placed.frame
        assert frame.origin == pytest.approx((1, -3, 2), abs=1e-9)
        assert frame.z_axis == pytest.approx((0, -1, 0), abs=1e-9)

    def test_a_strip_at_each_point_and_for_each_chain(self):
        cq_strips.register()
        drawn = cq.Workplane().spline([(0, 0), (40, 40), (90, 50), (140, 0)])
        many = drawn.pushPoints([(0, 0), (0, 60), (0, 120)]).elasticStrip(SHEET, max_width=20, form="flat")
        assert sorted(round(body.Center().y) for body in many.vals()) == [0, 60, 120]
        assert sorted(round(face.Center().y) for face in many.faces(tag="end").vals()) == [0, 60, 120]
        drawn = cq.Workplane().spline([(0, 0), (40, 40), (90, 50), (140, 0)])
        two = drawn.moveTo(0, 90).spline([(40, 130), (90, 140), (140, 90)], includeCurrent=True)
        assert len(two.elasticStrip(SHEET, max_width=20, form="bent").vals()) == 2
        drawn = cq.Workplane("XZ").spline([(0, 0), (40, 40), (90, 50), (140, 0)])
        two = drawn.moveTo(0, 90).spline([(40, 130), (90, 140), (140, 90)], includeCurrent=True)
        four = two.pushPoints([(0, 0), (0, 60)]).elasticStrip(SHEET, max_width=20, form="flat")
        assert sorted(round(body.Center().z) for body in four.vals()) == [0, 0, 60, 60]


def made_by(library):
    import importlib

    module = importlib.import_module(f"elastica_cad.{library}")
    return module.BentStrip if library == "build123d" else module.bent_strip


@pytest.mark.parametrize(
    "library",
    [
        pytest.param("build123d", marks=pytest.mark.build123d),
        pytest.param("cadquery", marks=pytest.mark.cadquery),
    ],
)
class TestOptions:
    def test_one_tab_and_one_slot(self, library):
        body = made_by(library)(CURVE, SHEET, max_width=30, ends=Tab(5), slots=Slot(80, 1.2, 4))
        assert body.strip.ends == (Tab(5), Tab(5))
        assert len(body.strip.slots) == 1

    @pytest.mark.parametrize(
        ("options", "says"),
        [
            ({"slot": 3}, "did you mean slots"),
            ({"backing": "pom-0.5"}, r"style=Laminated\(width=\.\.\., backing=\.\.\.\)"),
            ({"widht": 3}, "widht is not an option"),
            ({"slots": 3}, "slots"),
            ({"ends": 5}, "ends"),
        ],
    )
    def test_one_sentence(self, library, options, says):
        with pytest.raises(InputError, match=says):
            made_by(library)(CURVE, SHEET, max_width=30, **options)

    def test_a_strip_has_its_options(self, library):
        strip = Strip(optimal_rod(CURVE), Sheet.named(SHEET), max_width=30)
        with pytest.raises(
            InputError, match="sheet, max_width, label: the options of a finished strip cannot be changed"
        ):
            made_by(library)(strip, SHEET, max_width=20, label="B")
        with pytest.raises(InputError, match="needs a sheet"):
            made_by(library)(CURVE, max_width=20)
