"""STEP files: names, colours, units and edges, read back by OpenCASCADE and by FreeCAD."""

import re
from collections import Counter
from pathlib import Path

import numpy as np
import pytest
from build123d import Bezier, export_step

from elastica_cad import (
    Frame,
    InputError,
    Perforated,
    PlaneCurve,
    Sheet,
    Strip,
    Tab,
    optimal_rod,
    read_curves,
)
from elastica_cad import Path as Chain
from elastica_cad.geometry import Spline
from elastica_cad.kernel import occt
from elastica_cad.kernel import step_files as step
from elastica_cad.strip import FlatSolid


def entities(path, name):
    return re.findall(rf"= {name}\(", Path(path).read_text())


def test_header_units_names_colours(arch_strip, tmp_path):
    path = tmp_path / "arch.step"
    step.write_strip_step(arch_strip, path)
    text = path.read_text()
    assert "AUTOMOTIVE_DESIGN { 1 0 10303 214" in text
    assert "SI_UNIT(.MILLI.,.METRE.)" in text.replace(" ", "")
    assert re.findall(r"= PRODUCT\('([^']*)'", text) == ["arch", "arch flat", "arch bent"]
    colors = {tuple(map(float, c)) for c in re.findall(r"COLOUR_RGB\('',([\d.]+),([\d.]+),([\d.]+)\)", text)}
    assert len(colors) == 1
    assert len(entities(path, "MANIFOLD_SOLID_BREP")) == 2


@pytest.mark.campaign
def test_a_body_of_many_holes_is_written_as_one_of_few(monkeypatch, tmp_path, measure):
    """Wires are parted by us there, also where holes touch the joint to a tab, and OpenCASCADE is not asked to."""
    curve = PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])
    style = Perforated(24.0, columns=3, rows=8, least_ligament=0.4)
    strip = Strip(optimal_rod(curve), Sheet.named("card-200gsm"), style=style, ends=(Tab(10), Tab(10)))
    found = {}
    for most in (10**6, 8):
        monkeypatch.setattr(step, "MANY_WIRES", most)
        path = tmp_path / f"{most}.step"
        step.write_strip_step(strip, path)
        kinds = Counter(re.findall(r"^#\d+ = \(? ?([A-Z_0-9]+)", path.read_text(), re.MULTILINE))
        solids = occt.sub_shapes(step.read_step_shape(path), "solid")
        found[most] = (
            kinds,
            [(measure.volume(solid, bent=False), measure.is_valid(solid)) for solid in solids],
        )
    (kinds, few), (shared, many) = found.values()
    bounds = ("FACE_BOUND", "EDGE_CURVE", "ADVANCED_FACE", "VERTEX_POINT", "PCURVE", "ORIENTED_EDGE")
    assert [kinds[kind] for kind in bounds] == [shared[kind] for kind in bounds]
    assert kinds["FACE_BOUND"] > 150
    assert all(sound for _, sound in many)
    assert [volume for volume, _ in many] == pytest.approx([volume for volume, _ in few], rel=1e-9)


def entity(text, number):
    """Name of an entity of the file and what stands in its brackets."""
    return re.search(rf"#{number} = (\w+)\((.*?)\);", text, re.DOTALL).groups()


def test_outline_is_a_few_spline_edges(plain, tmp_path):
    """The flat face has 8 edges in the file itself, its two long sides one spline each."""
    path = tmp_path / "flat.step"
    step.write_step([step.NamedShape("flat", occt.make_face(plain.outline))], path)
    text = path.read_text()
    kinds = []
    for number in re.findall(r"= EDGE_CURVE\('',#\d+,#\d+,#(\d+),", text):
        name, content = entity(text, number)
        if name == "SURFACE_CURVE":
            name, _ = entity(text, re.search(r"#(\d+)", content)[1])
        kinds.append(name)
    assert sorted(kinds) == ["B_SPLINE_CURVE_WITH_KNOTS"] * 2 + ["LINE"] * 6


def test_curves_come_back_from_a_file(curve, tilted, tmp_path):
    path = tmp_path / "curve.step"
    step.write_step([step.NamedShape("curve", occt.make_wire(Chain([Spline(curve)]), tilted))], path)
    (back,) = read_curves(path)
    assert back.length == pytest.approx(curve.length, rel=1e-9)
    assert back.degree == curve.degree
    mine, theirs = curve.sample(9), back.sample(9)
    side = np.sign(mine.curvature @ theirs.curvature)  # the plane may be seen from behind
    assert side * theirs.curvature == pytest.approx(mine.curvature, rel=1e-6, abs=1e-9)


def test_several_curves_and_a_solid_in_one_file(plain, tmp_path):
    from elastica_cad.geometry import Arc, Line

    path = tmp_path / "mixed.step"
    step.write_step(
        [
            step.NamedShape("one", occt.make_wire(Chain([Arc((0, 0), 10, 0, 2)]))),
            step.NamedShape("two", occt.make_wire(Chain([Line((0, 0), (30, 0))]), Frame((0, 0, 50)))),
            step.NamedShape("body", occt.make_solid(FlatSolid.of(plain))),
        ],
        path,
    )
    assert sorted(c.length for c in read_curves(path)) == pytest.approx([20, 30])


def test_brep_files_are_read_too(curve, tmp_path):
    from OCP.BRepTools import BRepTools

    path = tmp_path / "curve.brep"
    BRepTools.Write_s(occt.make_wire(Chain([Spline(curve)])), str(path))
    (back,) = read_curves(path)
    assert np.array_equal(back.control_points, curve.control_points)


@pytest.mark.parametrize(
    "name",
    [
        "Bügel 'A' 竹 NEXT_ASSEMBLY_USAGE_OCCURRENCE('7'",
        "左" * 90,
        "left (5')",
        "');#1=",
        "\\X2\\00E9\\X0\\",
        "C:\\S\\N\\T\\",
        "👨👩👧",
        "elastica-name-7",
    ],
)
def test_names_in_any_script(plain, tmp_path, name):
    """Umlauts, quotes, backslashes and Chinese come back as they went in."""
    from OCP.STEPCAFControl import STEPCAFControl_Reader
    from OCP.TCollection import TCollection_ExtendedString
    from OCP.TDataStd import TDataStd_Name
    from OCP.TDocStd import TDocStd_Document

    path = tmp_path / "any.step"
    shape = occt.make_solid(FlatSolid.of(plain))
    step.write_step([step.NamedShape(name, shape)], path)
    document = TDocStd_Document(TCollection_ExtendedString("XmlOcaf"))
    reader = STEPCAFControl_Reader()
    reader.SetNameMode(True)
    reader.ReadFile(str(path))
    reader.Transfer(document)
    label = document.Main().Root().FindChild(1).FindChild(1).FindChild(1)
    found = TDataStd_Name()
    assert label.FindAttribute(TDataStd_Name.GetID_s(), found)
    assert found.Get().ToExtString() == name


class TestBadInput:
    def test_nothing_to_write(self, tmp_path):
        with pytest.raises(InputError, match="nothing to write"):
            step.write_step([], tmp_path / "none.step")

    def test_file_that_is_there(self, plain, tmp_path):
        path = tmp_path / "there.step"
        path.write_text("mine")
        with pytest.raises(InputError, match="exists already"):
            step.write_strip_step(plain, path)
        assert path.read_text() == "mine"
        step.write_strip_step(plain, path, force=True)
        assert path.stat().st_size > 1000

    @pytest.mark.parametrize(
        "text", ["no step at all", "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n"]
    )
    def test_no_step_file(self, tmp_path, text, capfd):
        path = tmp_path / "odd.step"
        path.write_text(text)
        with pytest.raises(InputError, match=r"odd\.step.*STEP"):
            read_curves(path)

    @pytest.mark.parametrize("noise", [0.0, 0.01])
    def test_curves_of_upright_planes_are_seen_from_the_front(self, tmp_path, noise):
        places = [(0, -noise, 0), (20, noise, 45), (70, 0, 20), (95, noise, 0)]
        path = tmp_path / "upright.step"
        export_step(Bezier(*places), path)
        (curve,) = read_curves(path)
        assert np.abs(curve.control_points - [(x, z) for x, _, z in places]).max() < 1e-4

    def test_only_solids(self, plain, tmp_path):
        path = tmp_path / "solid.step"
        step.write_step([step.NamedShape("body", occt.make_solid(FlatSolid.of(plain)))], path)
        with pytest.raises(InputError, match=r"solid\.step.*no free edges"):
            read_curves(path)

    def test_missing_file(self, tmp_path):
        with pytest.raises(InputError, match=r"none\.step"):
            read_curves(tmp_path / "none.step")
