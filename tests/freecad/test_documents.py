"""Strips among other things of a document: containers, links, expressions, copies, files of earlier versions."""

import math
import shutil
import sys
from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path

import FreeCAD as App
import numpy as np
import Part
import pytest
import Sketcher
from freecad.elastica_wb import make_strip
from freecad.elastica_wb.curves.edge_chains import curves_in, edges_drawn
from freecad.elastica_wb.curves.part_shapes import make_wire
from freecad.elastica_wb.curves.sketch_curves import (
    box_around,
    curve_into,
    drawn_curve,
    evened,
    lost_constraints,
    sketch_curve,
)
from freecad.elastica_wb.cutting_files import (
    KINDS,
    cutting_of,
    later_feature_messages,
    write_cutting_files,
)
from freecad.elastica_wb.features import curves, flat, nest, proxy, strip
from freecad.elastica_wb.features.pieces import cuts_of, without_refused
from freecad.elastica_wb.host import sheet_store as library
from freecad.elastica_wb.live.sketch_drag import Dragged

from elastica_cad import (
    InputError,
    MissingDependencyError,
    NotConvergedError,
    PlaneCurve,
    Sheet,
    check_equilibrium,
    four_point_map,
)
from elastica_cad import Path as PlanePath
from elastica_cad.geometry import Arc, Line
from tests.freecad.features import change, new

ARCH = [(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)]
BAD = [(0, 0), (40, 60), (80, -55), (120, 10), (160, 30), (180, 0)]


def middle(obj):
    """A place of the whole document: the middle of the bent strip's drawn curve must lie in it."""
    return obj.Curve[0].getGlobalPlacement().multVec(obj.Curve[0].Geometry[0].value(0.5))


def in_document(obj):
    shape = obj.Shape.copy()
    shape.Placement = obj.getGlobalPlacement()
    return shape


def test_a_file_saved_without_the_addon_is_revived(tmp_path: Path):
    """Such a FreeCAD keeps the properties and shapes of the features, but saves no proxies."""
    home, file = Path(__file__).parent / "data", tmp_path / "every.FCStd"
    shutil.copy(home / "every-feature-0.1.FCStd", file)
    there = App.openDocument(str(file))
    ours = [obj for obj in there.Objects if getattr(obj, "Proxy", None) is not None]
    kinds = {obj.Name: type(obj.Proxy) for obj in ours}
    there.getObject("Strip").Thickness = measured = 0.83
    for obj in ours:
        obj.Proxy = None
    there.save()
    App.closeDocument(there.Name)
    again = App.openDocument(str(file))
    try:
        assert {name: type(again.getObject(name).Proxy) for name in kinds} == kinds
        feature = again.getObject("Strip")
        assert feature.Thickness.Value == measured
        assert not [obj.Label for obj in again.Objects if "Touched" in obj.State]
        change(feature, MaxWidth=1e-3)
        assert "Invalid" in feature.State, "it follows its properties again"
    finally:
        App.closeDocument(again.Name)


def test_a_file_of_an_earlier_version(document, tmp_path: Path):
    file = tmp_path / "old.FCStd"
    shutil.copy(Path(__file__).parent / "data" / "strip-0.1.FCStd", file)
    old = App.openDocument(str(file))
    try:
        feature = old.getObject("Strip")
        assert feature.Shape.isValid()
        volume = feature.Shape.Volume
        assert feature.EngravedText == "OLD"
        assert feature.MaxWidth.Value == 24
        # what later versions ask for is there, with the meaning that the file had
        assert feature.Follow == "Exactly"
        assert feature.KeepTangents is False
        assert feature.SheetTitle == "Birch plywood 0.8 mm"
        assert feature.Anticlastic is False  # a sheet's nu was never asked for then
        feature.touch()
        old.recompute()
        assert feature.State == ["Up-to-date"]
        assert feature.Shape.Volume == pytest.approx(volume, rel=1e-5)
        room = old.addObject("App::Part", "Room")
        room.addObject(feature)
        assert feature.Curve[0] in room.Group
        assert old.getObject("Flat").Shape.isValid()
    finally:
        App.closeDocument(old.Name)


def test_inside_a_part(document, sketch):
    part = document.addObject("App::Part", "Part")
    part.addObject(sketch)
    part.Placement = App.Placement(App.Vector(100, 20, 5), App.Rotation(App.Vector(0, 1, 0), 30))
    sketch.Placement = App.Placement(App.Vector(1, 2, 3), App.Rotation(App.Vector(1, 0, 0), 90))
    inside = strip.create(document, sketch)
    assert inside.getParentGeoFeatureGroup() is part
    document.recompute()
    assert in_document(inside).isInside(middle(inside), 1e-6, True)
    outside = strip.create(document, sketch)
    part.removeObject(outside)
    document.recompute()
    assert in_document(outside).isInside(middle(outside), 1e-6, True)


@pytest.mark.parametrize("make", [strip.create, curves.nearest])
def test_a_curve_goes_into_a_part_with_what_follows_it(document, sketch, make):
    feature = make(document, sketch)
    document.recompute()
    room = document.addObject("App::Part", "Room")
    room.Placement = App.Placement(App.Vector(7, 8, 9), App.Rotation(App.Vector(0, 1, 0), 40))
    room.addObject(feature)
    proxy.keep_containers(document, {feature.Name, sketch.Name})
    document.recompute()
    place = room.Placement.multVec(sketch.Geometry[0].value(0.5))
    assert in_document(feature).distToShape(Part.Vertex(place))[0] < 3  # the nearest curve is elsewhere
    room.removeObject(feature)
    assert room.Group == []


def test_out_of_a_part_that_holds_its_flat_part(document, sketch):
    """A strip that hung on that part were made from what is made from it: a cycle, which FreeCAD refuses."""
    room, house = document.addObject("App::Part", "Room"), document.addObject("App::Part", "House")
    room.addObject(sketch)
    made = strip.create(document, sketch)
    lying = flat.create(document, made)
    assert lying in room.Group
    made.Companions = []  # as in files of version 0.1: the sketch stays
    room.removeObject(made)
    proxy.keep_containers(document, {made.Name})
    assert set(made.OutList) == {sketch}
    room.Placement.Base.z = 80
    proxy.keep_places(room)
    document.recompute()
    assert made.Placement.Base.z == pytest.approx(80)
    house.Placement.Base.z = 1000
    house.addObject(room)
    proxy.keep_containers(document, {room.Name})
    document.recompute()
    assert made.Placement.Base.z == pytest.approx(1080)


def test_in_a_body(document, sketch):
    body = document.addObject("PartDesign::Body", "Body")
    body.addObject(sketch)
    body.Placement = App.Placement(App.Vector(0, 0, 50), App.Rotation())
    feature = new(strip.create, document, sketch)
    assert feature.TypeId == "PartDesign::FeatureAdditivePython"
    assert feature.getParentGeoFeatureGroup() is body
    assert feature.State == ["Up-to-date"]
    assert in_document(feature).isInside(middle(feature), 1e-6, True)
    assert body.Shape.Volume == pytest.approx(feature.Shape.Volume, rel=1e-9)


def test_a_refused_strip_is_named_and_the_others_are_cut(document, sketch, drawn):
    strips = [new(strip.create, document, source) for source in (sketch, drawn(BAD, 3), drawn(ARCH))]
    strips[1].Label = "Wavy"
    able, (message,) = without_refused(strips)
    assert able == [strips[0], strips[2]]
    assert str(message).startswith("Wavy is left out: ")
    with pytest.raises(InputError, match="Wavy is left out: "):
        without_refused(strips[1:2])


def test_what_goes_on_after_a_strip_is_reported_before_it_is_exported(document, sketch):
    """A pocket in its body, a cut of that body, a rounded flat part: files are written from the strip."""
    body = document.addObject("PartDesign::Body", "Body")
    body.addObject(sketch)
    feature = strip.create(document, sketch)
    twin = new(flat.create, document, feature)
    assert later_feature_messages(feature) == []
    laid = new(nest.create, document, [feature])
    assert laid.LeftOut == []
    hole = body.newObject("PartDesign::SubtractiveCylinder", "Hole")
    change(
        hole,
        Radius=2,
        Height=100,
        Placement=App.Placement(middle(feature) - App.Vector(0, 0, 50), App.Rotation()),
    )
    assert hole.State == ["Up-to-date"]
    assert body.Shape.Volume < feature.Shape.Volume - 1, "it takes something away"
    (text,) = later_feature_messages(feature)
    assert text.startswith("The cutting files show Strip without Hole, a later feature of its body. ")
    box = document.addObject("Part::Box", "Box")
    cut, rounded, away = (document.addObject(f"Part::{kind}", kind) for kind in ("Cut", "Chamfer", "Cut"))
    cut.Base, cut.Tool, rounded.Base, away.Base, away.Tool = body, box, twin, box, body
    assert later_feature_messages(feature)[0].startswith(
        "The cutting files show Strip without Hole, Cut, Chamfer, a later"
    )
    nest.report_left_out(
        laid
    )  # as the window does a moment after a recompute: the nest does not hang on them
    (text,) = laid.LeftOut
    assert text.startswith(
        "The nest shows Strip without Hole, Cut, Chamfer, a later feature of its body. Use the slots"
    )
    laid.touch()
    document.recompute()
    assert laid.LeftOut == [text]


def test_links_and_copies(document, sketch, move_pole):
    feature = strip.create(document, sketch)
    link = document.addObject("App::Link", "Link")
    change(link, LinkedObject=feature, Placement=App.Placement(App.Vector(0, 0, 100), App.Rotation()))
    assert link.Shape.Volume == pytest.approx(feature.Shape.Volume, rel=1e-9)
    copy = document.copyObject(feature, True)
    document.recompute()
    assert strip.is_strip(copy)
    assert copy.Curve[0] is not sketch
    move_pole(sketch, 2, (70, 90))
    document.recompute()
    assert copy.Shape.Volume != pytest.approx(feature.Shape.Volume, rel=1e-3)
    assert link.Shape.Volume == pytest.approx(feature.Shape.Volume, rel=1e-9)


@pytest.mark.parametrize("kind", proxy.Feature.__subclasses__(), ids=lambda kind: kind.__name__)
@pytest.mark.parametrize("backwards", [False, True])
def test_properties_arrive_one_by_one_and_in_another_order(document, kind, backwards):
    """A copy and a file bring them by name, and FreeCAD reports each to an object that lacks the others."""
    whole = document.addObject("Part::FeaturePython", "Whole")
    kind(whole)
    half = document.addObject("Part::FeaturePython", "Half")
    half.Proxy = kind.__new__(kind)
    for name in sorted((entry.name for entry in kind.properties), reverse=backwards):
        half.addProperty(whole.getTypeIdOfProperty(name), name)
        if choices := whole.getEnumerationsOfProperty(name):
            setattr(half, name, choices)
        setattr(half, name, getattr(whole, name))
        half.Proxy.onBeforeChange(half, name)
        half.Proxy.onChanged(half, name)
    half.Proxy.onDocumentRestored(half)
    for name in whole.PropertiesList:
        assert half.getEditorMode(name) == whole.getEditorMode(name), name


def test_expressions_and_spreadsheets(document, sketch):
    sheet = document.addObject("Spreadsheet::Sheet", "Numbers")
    sheet.set("A1", "=12 mm")
    sheet.setAlias("A1", "width")
    feature = strip.create(document, sketch)
    feature.setExpression("MaxWidth", "Numbers.width")
    document.recompute()
    assert strip.strip_of(feature).width.extremes[1] == pytest.approx(12)
    sheet.set("A1", "=18 mm")
    document.recompute()
    assert strip.strip_of(feature).width.extremes[1] == pytest.approx(18)
    sheet.set("B1", "=Strip.Mass")
    document.recompute()
    assert sheet.get("B1") == pytest.approx(feature.Mass)


def test_undo_is_one_step(document, sketch):
    document.openTransaction("make")
    feature = strip.create(document, sketch)
    flat.create(document, feature)
    document.recompute()
    document.commitTransaction()
    document.undo()
    assert [obj.Name for obj in document.Objects] == ["Sketch"]
    document.redo()
    assert document.getObject("Strip").Shape.isValid()


def test_edges_and_chains(document):
    path = PlanePath(
        (
            Line((0, 0), (50, 0)),
            Arc((50, 40), 40, -1.5707963267948966, 0.3),
        ),
        closed=False,
    )
    wire = document.addObject("Part::Feature", "Wire")
    change(
        wire,
        Shape=make_wire(path),
        Placement=App.Placement(App.Vector(3, 4, 5), App.Rotation(App.Vector(1, 0, 0), 90)),
    )
    curve = drawn_curve((wire, ())).curve
    assert curve.length == pytest.approx(path.length, rel=1e-9)
    only = drawn_curve((wire, ("Edge2",))).curve
    assert only.length == pytest.approx(path.segments[1].length, rel=1e-9)
    feature = new(strip.create, document, wire, ("Edge2",))
    assert feature.State == ["Up-to-date"]
    place = wire.Shape.Edges[1].valueAt(sum(wire.Shape.Edges[1].ParameterRange) / 2)
    assert in_document(feature).isInside(place, 1e-6, True)
    for name in ("Edge7", "?Edge7"):  # as FreeCAD 1.x marks what it does not find again
        with pytest.raises(InputError, match="no longer has Edge7"):
            drawn_curve((wire, (name,)))


def test_the_outline_of_a_face(document):
    """Draft makes a face of a closed curve unless told otherwise: its outline is the curve."""
    ring = document.addObject("Part::Feature", "Ring")
    circle = Part.makeCircle(60, App.Vector(10, 20, 30))
    ring.Shape = Part.Face(Part.Wire(circle))
    made = new(strip.create, document, ring)
    assert made.State == ["Up-to-date"], made.getStatusString()
    assert made.Length.Value == pytest.approx(120 * math.pi, rel=1e-9)
    hole = Part.Wire(Part.makeCircle(20, App.Vector(10, 20, 30)))
    change(ring, Shape=Part.Face([Part.Wire(circle), hole]))
    assert "Choose the edges for the strip" in made.getStatusString()
    ring.Shape = Part.makeCylinder(60, 20).Faces[0]
    made.touch()
    document.recompute()
    assert "Choose the edges for the strip" in made.getStatusString()


def test_a_chain_in_a_sketch(document):
    sketch = document.addObject("Sketcher::SketchObject", "Sketch")
    arc = Arc((0, 0), 50, 0.2, 1.2)
    (edge,) = make_wire(PlanePath([arc])).Edges
    circle = Part.Circle(App.Vector(0, 0, 0), App.Vector(0, 0, 1), 50)
    sketch.addGeometry(Part.ArcOfCircle(circle, 0.2, 1.2), False)
    end = edge.valueAt(edge.LastParameter)
    along = edge.tangentAt(edge.LastParameter)
    sketch.addGeometry(Part.LineSegment(end, end + along * 30), False)
    document.recompute()
    curve = sketch_curve(sketch)
    assert curve.length == pytest.approx(80, rel=1e-9)


RIBS = [[(x, 0), (x + 30, 60), (x + 70, 80), (x + 120, 60), (x + 150, 0)] for x in (0, 10, 200)]


@pytest.fixture
def ribs(document, spline_geometry):
    """An upright sketch of three splines, with the circles of the poles of the first before the others."""
    sketch = document.addObject("Sketcher::SketchObject", "Ribs")
    sketch.Placement = App.Placement(App.Vector(5, 6, 7), App.Rotation(App.Vector(1, 0, 0), 90))
    for points in RIBS:
        number = sketch.addGeometry(spline_geometry(points), False)
        if points is RIBS[0]:
            sketch.exposeInternalGeometry(number)
    document.recompute()
    return sketch


def test_each_curve_of_a_sketch_has_its_strip(document, ribs):
    chains = curves_in(ribs)
    assert sorted(chains) == [("Edge1",), ("Edge2",), ("Edge3",)]
    strips = [new(strip.create, document, ribs, chain) for chain in chains]
    assert [made.State for made in strips] == [["Up-to-date"]] * 3, [made.Reasons for made in strips]
    for made, chain in zip(strips, chains, strict=True):
        middle = ribs.Shape.getElement(chain[0]).valueAt(0.5)
        assert in_document(made).isInside(middle, 1e-6, True)
        assert made.Placement.Rotation.isSame(ribs.Placement.Rotation, 1e-12)
    assert curves_in(ribs, ["Edge2"]) == [("Edge2",)]
    assert len({strip.strip_of(made).rod.curve.control_points[0, 0] for made in strips}) == 3
    with pytest.raises(InputError, match="apart"):
        drawn_curve((ribs, ()))


def test_edges_picked_in_an_open_sketch_count_its_geometry(ribs):
    numbers = [i for i, one in enumerate(ribs.Geometry) if not ribs.getConstruction(i)]
    assert numbers[1] > 5, "the poles come between"
    for number, points in zip(numbers, RIBS, strict=True):
        (name,) = edges_drawn(ribs, [f"Edge{number + 1}"])
        start = ribs.Placement.multVec(App.Vector(*points[0], 0))
        assert any(v.Point.isEqual(start, 1e-9) for v in ribs.Shape.getElement(name).Vertexes)
    assert edges_drawn(ribs, [f"Edge{numbers[0] + 2}"]) == []


def test_a_picked_edge_goes_on_to_the_next_corner(document):
    sketch = document.addObject("Sketcher::SketchObject", "Sketch")
    corners = [(0, 0), (40, 0), (90, 1), (90, 50), (300, 50), (300.3, 50), (400, 50)]
    for i in (0, 1, 2, 4 + 1):
        ends = [App.Vector(*corners[k], 0) for k in (i, i + 1)]
        sketch.addGeometry(Part.LineSegment(*ends), False)
    sketch.addGeometry(Part.LineSegment(App.Vector(200, 50, 0), App.Vector(300, 50, 0)), False)
    document.recompute()

    def ends(chain):
        edges = [sketch.Shape.getElement(name) for name in chain]
        return sorted(round(v.X) for edge in edges for v in edge.Vertexes)

    found = {tuple(ends(chain)) for chain in curves_in(sketch)}
    assert found == {(0, 40, 40, 90, 90, 90), (200, 300, 300, 400)}, "0.3 mm are a gap, not two curves"
    names = {tuple(ends([f"Edge{k}"])): f"Edge{k}" for k in range(1, 6)}
    (chain,) = curves_in(sketch, [names[0, 40]])
    assert ends(chain) == [0, 40, 40, 90]
    assert curves_in(sketch, [names[90, 90]]) == [(names[90, 90],)]
    (both,) = curves_in(sketch, [names[40, 90], names[90, 90]])
    assert ends(both) == [40, 90, 90, 90], "what is picked, with its corner"


def test_a_dragged_pole(document, sketch):
    sketch.exposeInternalGeometry(0)
    document.recompute()
    counts = {"Part::GeomBSplineCurve": 2, "Part::GeomCircle": 1, "Part::GeomPoint": 1}
    points = [(0.0, 0.0)]
    for geometry in sketch.Geometry:
        if geometry.TypeId == "Part::GeomBSplineCurve":
            points += [tuple(geometry.StartPoint)[:2], tuple(geometry.EndPoint)[:2]]
        else:
            place = (
                geometry.Center
                if geometry.TypeId == "Part::GeomCircle"
                else App.Vector(geometry.X, geometry.Y, 0)
            )
            points.append(tuple(place)[:2])
    assert len(points) == 1 + sum(counts[g.TypeId] for g in sketch.Geometry)
    for shown in (points, points[1:]):  # 1.1 leaves the origin out
        dragged = Dragged(sketch, shown)
        assert dragged.usable
        moved = list(shown)
        moved[moved.index((70.0, 80.0))] = (75.0, 99.0)
        curve = sketch_curve(sketch, dragged.geometry(moved))
        expected = PlaneCurve.spline([*ARCH[:2], (75, 99), *ARCH[3:]])
        assert curve.length == pytest.approx(expected.length, rel=1e-9)
    assert not Dragged(sketch, [(9.0, 9.0)] * len(points)).usable


def test_a_hidden_pole_makes_the_drag_unusable(document, sketch):
    assert not Dragged(sketch, [(0, 0), (0, 0), (150, 0)]).usable


def test_files_without_guide_lines_and_without_ezdxf(document, sketch, tmp_path: Path, monkeypatch):
    feature = strip.create(document, sketch)
    change(feature, EngravedText="A1")
    monkeypatch.setitem(sys.modules, "ezdxf", None)
    for marks in (True, False):
        cutting, folder = cutting_of(marks=marks), tmp_path / str(marks)
        *drawn, listed = write_cutting_files([feature], folder, kinds=("dxf", "nest", "csv"), cutting=cutting)
        stems = ("A1_birch-plywood-0.8_0.8mm_x1", "nest-1-birch-plywood-0.8")
        assert [file.name for file in drawn] == [f"{stem}-mm.dxf" for stem in stems]
        assert [b"  8\nMARK\n" in file.read_bytes() for file in drawn] == [marks, marks]
        assert drawn[0].name in listed.read_text()


def test_cutting_files(document, sketch, tmp_path: Path, request):
    feature = strip.create(document, sketch)
    change(feature, EngravedText="A1", TabHole=3, Quantity=4)
    # Debian's FreeCAD has no ezdxf: there DXF is refused in words, everything else works
    complete = find_spec("ezdxf") is not None
    kinds = KINDS if complete else [kind for kind in KINDS if kind != "dxf"]
    if not complete:
        with pytest.raises(MissingDependencyError, match="Install missing libraries"):
            write_cutting_files([feature], tmp_path / "out")
    files = write_cutting_files([feature], tmp_path / "out", kinds=kinds)
    flat = ("dxf", "svg") if complete else ("svg",)
    stems = ("A1_birch-plywood-0.8_0.8mm_x4", "nest-1-birch-plywood-0.8")
    assert [f.name for f in files[:-2]] == [f"{stem}.{kind}" for stem in stems for kind in flat]
    assert [f.name for f in files[-2:]] == ["Strip.step", "cut-list.csv"]
    if complete and find_spec("svgelements") is not None:
        for file in files[:4]:
            request.getfixturevalue("check_drawing_file")(file)
    assert "A1,birch-plywood-0.8" in files[-1].read_text()
    with pytest.raises(InputError, match="exists already"):
        write_cutting_files([feature], tmp_path / "out", kinds=kinds)
    with pytest.raises(NotConvergedError, match="no file was written"):
        write_cutting_files([feature], tmp_path / "stopped", kinds=kinds, step=lambda done: done < 1)
    assert not list((tmp_path / "stopped").glob("*"))
    again = write_cutting_files([feature], tmp_path / "again", kinds=kinds)
    alike = [
        a.read_bytes() == b.read_bytes() for a, b in zip(files, again, strict=True) if a.suffix != ".step"
    ]
    assert alike == [True] * (len(files) - 1)
    names = [cut.piece.name for cut in cuts_of([feature, document.copyObject(feature)])]
    assert len(set(names)) == 2
    with pytest.raises(InputError, match="nothing to cut"):
        cuts_of([sketch])


def test_nearest_follows_when_requested(document, drawn):
    feature = strip.create(document, drawn(BAD))
    change(feature, Follow="Nearest", StrainLimit=5)
    assert "the material may crack there" in feature.getStatusString(), "more strain was allowed than is safe"
    change(feature, Anyway=True)
    assert feature.State == ["Up-to-date"], feature.getStatusString()
    assert 0 < feature.Deviation.Value < 20
    assert feature.Ratio <= 3.5 * (1 + 1e-6)
    assert feature.Shape.isValid()
    change(feature, Sheet="card-200gsm", StrainLimit=0, Anyway=False)
    assert "but it can take a curve at most" in feature.Verdict
    assert feature.StrainUse <= 100


def test_replacing_the_spline_of_a_sketch(document, drawn):
    sketch = drawn(BAD)
    sketch.exposeInternalGeometry(0)
    guide = sketch.addGeometry(Part.LineSegment(App.Vector(0, -50, 0), App.Vector(90, -50, 0)), True)
    assert guide > 0
    curve_into(sketch, PlaneCurve.spline(ARCH))
    document.recompute()
    assert check_equilibrium(sketch_curve(sketch)).realizable
    assert sketch_curve(sketch).control_points == pytest.approx(
        PlaneCurve.spline(ARCH).control_points, abs=1e-6
    )
    kept = [g for g in sketch.Geometry if g.TypeId == "Part::GeomLineSegment"]
    assert len(kept) == 1


def test_a_macro_gets_a_flat_part_for_each_sheet_of_a_laminated_strip(document, sketch):
    laminated = {"Sheet": "pom-0.5", "Backing": "pom-0.5", "Style": "Laminated", "OuterWidth": 28}
    feature = make_strip(sketch, **laminated)
    base, backing = sorted(flat.flats_of([feature]), key=lambda part: part.Layer == "Backing")
    sheets = feature.Shape.Solids
    assert base.Shape.Volume == pytest.approx(sheets[0].Volume, rel=1e-2)
    assert backing.Shape.Volume == pytest.approx(sheets[1].Volume, rel=1e-2)
    assert not base.Shape.BoundBox.intersect(backing.Shape.BoundBox)
    assert not flat.flats_of([make_strip(sketch, **laminated, flat_part=False)])


@pytest.mark.parametrize("style", ["Perforated", "Laminated"])
def test_styles(document, sketch, tmp_path: Path, style):
    feature = strip.create(document, sketch)
    feature.Style = style
    feature.OuterWidth = 28
    feature.Anyway = True  # two layers of plywood would break
    base = new(flat.create, document, feature)
    assert feature.State == ["Up-to-date"], feature.getStatusString()
    assert feature.Shape.isValid()
    made = strip.strip_of(feature)
    assert base.Shape.BoundBox.YLength == pytest.approx(28, abs=1e-6)
    assert len(base.Shape.Faces) == 2 + sum(len(p.segments) for p in (made.outline, *made.holes))
    kinds = ("svg", "step")
    if style == "Perforated":
        assert len(made.holes) > 5
        assert len(feature.Shape.Solids) == 1
        assert len(write_cutting_files([feature], tmp_path, kinds=kinds)) == 2
        return
    backing = new(flat.create, document, feature, "Backing")
    assert len(feature.Shape.Solids) == 2
    assert backing.Shape.isValid()
    assert backing.Shape.Volume < base.Shape.Volume
    assert len(write_cutting_files([feature], tmp_path, kinds=kinds)) == 3
    change(feature, Style="Plain")
    assert "Invalid" in backing.State
    assert "no backing" in backing.getStatusString()


def test_missing_scipy_is_a_sentence(document, drawn, monkeypatch):
    feature = strip.create(document, drawn([(0, 0), (31, 60), (72, 81), (121, 60), (150, 0)]))
    feature.Follow, feature.RatioLimit = "Nearest", 1.5
    monkeypatch.setitem(sys.modules, "scipy.interpolate", None)
    monkeypatch.setitem(sys.modules, "scipy.spatial", None)
    document.recompute()
    assert "Invalid" in feature.State
    assert "scipy" in feature.getStatusString()
    assert "not installed" in feature.getStatusString()
    monkeypatch.undo()
    feature.touch()
    document.recompute()
    assert feature.State == ["Up-to-date"]


def test_external_geometry_only(document, sketch):
    other = document.addObject("Sketcher::SketchObject", "Other")
    other.addExternal(sketch.Name, "Edge1")
    document.recompute()
    feature = new(strip.create, document, other)
    assert "Invalid" in feature.State
    assert "external geometry only" in feature.getStatusString()


def test_a_sheet_of_the_users_own(document, sketch, tmp_path: Path):
    own = Sheet("my-board", thickness=1.1, youngs_modulus=4000, density=700, max_strain=0.02)
    library.save_own_sheets([own])
    try:
        feature = strip.create(document, sketch)
        assert library.sheet_list()[0] == "my-board"
        feature.Sheet = "my-board"
        assert feature.Thickness.Value == 1.1
        assert feature.SheetTitle == "my-board"
        document.recompute()
        file = tmp_path / "own.FCStd"
        document.saveAs(str(file))
    finally:
        library.save_own_sheets([])
    App.closeDocument(document.Name)
    assert "my-board" not in library.sheet_list()
    again = App.openDocument(str(file))
    try:
        loaded = again.getObject("Strip")
        loaded.touch()
        again.recompute()
        assert loaded.State == ["Up-to-date"], "the numbers travel with the document"
        assert strip.strip_of(loaded).sheet.youngs_modulus == 4000
        loaded.Sheet = "card-200gsm"
        assert (loaded.SheetTitle, loaded.BackingTitle) == ("Card 200 g/m2", "Birch plywood 0.8 mm")
    finally:
        App.closeDocument(again.Name)


def test_sheets_on_a_disk_that_nobody_may_write_to(monkeypatch):
    """Root may write into every folder: the refusal of a read-only disk is that of its calls."""

    def refuse(self, *_, **__):
        raise OSError(30, "Read-only file system", str(self))

    own = Sheet("my-board", thickness=1.1, youngs_modulus=4000, density=700, max_strain=0.02)
    library.save_own_sheets([own])
    try:
        with monkeypatch.context() as patched:
            patched.setattr(Path, "unlink", refuse)
            with pytest.raises(
                InputError, match=r"elastica-sheets.toml cannot be changed: Read-only file system. "
            ):
                library.save_own_sheets([])
        assert library.own_sheets() == {"my-board": own}
        with monkeypatch.context() as patched:
            patched.setattr(Path, "mkdir", refuse)
            with pytest.raises(InputError, match="cannot be changed: Read-only"):
                library.save_own_sheets([own])
    finally:
        library.save_own_sheets([])


def test_a_stored_sheet_is_found_whatever_spaces_its_name_had():
    own = Sheet("my\u00a0board", thickness=1.1, youngs_modulus=4000, density=700, max_strain=0.02)
    assert (
        library.sheet_called("my\u00a0board", own.toml())
        == library.sheet_called("my board", own.toml())
        == own
    )


def test_the_numbers_of_a_sheet_that_was_changed(document, sketch):
    """What strips are made with is what the document keeps, and what was measured of one sheet stays."""
    old = Sheet("my-board", thickness=1.1, youngs_modulus=4000, density=700, max_strain=0.02)
    feature, measured = (strip.create(document, sketch) for _ in range(2))
    library.save_own_sheets([old])
    try:
        proxy.keep_sheets()
        for one in (feature, measured):
            assert "my-board" in one.getEnumerationsOfProperty("Sheet"), "it can be chosen at once"
            assert one.Sheet == "birch-plywood-0.8"
            one.Sheet = "my-board"
        change(measured, Thickness=1.05)
        mass = feature.Mass
        library.save_own_sheets([replace(old, density=1400, thickness=1.2)])
        proxy.keep_sheets()
        assert feature.Thickness.Value == 1.2
        assert measured.Thickness.Value == 1.05
        assert feature.Mass == pytest.approx(mass * 2 * 1.2 / 1.1, rel=1e-6)
    finally:
        library.save_own_sheets([])
    for one in (feature, measured):
        one.touch()
    document.recompute()
    assert strip.strip_of(feature).sheet.density == 1400, "as where the document goes"


def test_gravity_falls_in_space(document, sketch):
    feature = strip.create(document, sketch)
    change(feature, Sheet="card-200gsm", Gravity=True)
    assert strip.strip_of(feature).rod.gravity is None, "the sketch lies flat: its plane feels no weight"
    change(sketch, Placement=App.Placement(App.Vector(), App.Rotation(App.Vector(1, 0, 0), 90)))
    gravity = strip.strip_of(feature).rod.gravity
    assert gravity.direction == pytest.approx((0, -1), abs=1e-12)
    assert gravity.length == pytest.approx(Sheet.named("card-200gsm").elasto_gravity_length)


def test_a_link_to_a_sketch(document, sketch):
    part = document.addObject("App::Part", "Part")
    part.Placement.Base = App.Vector(0, 0, 300)
    link = document.addObject("App::Link", "Link")
    link.LinkedObject = sketch
    link.Placement = App.Placement(App.Vector(5, 6, 7), App.Rotation(App.Vector(1, 0, 0), 90))
    part.addObject(link)
    feature = new(strip.create, document, link)
    assert feature.State == ["Up-to-date"], feature.getStatusString()
    assert feature.getParentGeoFeatureGroup() is part
    place = part.Placement * link.Placement
    assert in_document(feature).isInside(place.multVec(sketch.Geometry[0].value(0.5)), 1e-6, True)
    link.Placement.Base = App.Vector(5, 6, 17)
    document.recompute()
    place = part.Placement * link.Placement
    assert in_document(feature).isInside(place.multVec(sketch.Geometry[0].value(0.5)), 1e-6, True)


def test_a_curve_pulled_by_handles(document, drawn):
    sketch = drawn([(0, 0), (25, 55), (60, 45), (95, -50), (130, -40), (150, 0)])
    sketch.exposeInternalGeometry(0)
    sketch.addConstraint(Sketcher.Constraint("Coincident", 0, 1, -1, 1))
    feature = strip.create(document, sketch)
    feature.LeastWidth = 1.0  # what the pulled curve asks for is narrower than plywood takes
    feature.Anyway = True  # and is bent beyond what it bears
    document.recompute()
    before = feature.Ratio
    assert lost_constraints(sketch) == 1
    curve = sketch_curve(sketch)
    corners = box_around(curve)
    shifts = np.array([(0, 0), (20, -5), (0, 30), (-10, 0)])
    pulled = curve.transformed(four_point_map(corners, corners + shifts))
    assert pulled.weights is not None
    kept = evened(pulled)
    assert np.prod(kept.weights) == pytest.approx(1)
    curve_into(sketch, kept)
    document.recompute()
    assert sketch.Geometry[0].isRational()
    assert lost_constraints(sketch) == 0
    assert sketch_curve(sketch).length == pytest.approx(pulled.length, rel=1e-9)
    assert feature.State == ["Up-to-date"], feature.getStatusString()
    assert feature.Ratio != pytest.approx(before, rel=1e-3)
    straight = box_around(PlaneCurve.line((0, 0), (100, 0)))
    assert np.ptp(straight, axis=0) == pytest.approx([100, 20])


def test_a_sheet_of_the_library_that_all_commands_share(document, sketch, tmp_path: Path, monkeypatch):
    """What `elastica coupon --keep` writes can be chosen here."""
    board = Sheet("felt", thickness=0.9, youngs_modulus=3000, density=720, max_strain=0.02)
    (tmp_path / "felt.toml").write_text(board.toml(), encoding="utf-8")
    monkeypatch.setenv("ELASTICA_SHEETS", str(tmp_path))
    feature = strip.create(document, sketch)
    change(feature, Sheet="felt")
    assert feature.State == ["Up-to-date"]
    assert feature.Thickness.Value == 0.9
    assert strip.strip_of(feature).sheet == board


def test_a_spline_of_freecads_own_tool_is_replaced(document):
    """The tool draws the poles before the spline; deleting that takes the poles away, and numbers move."""
    sketch = document.addObject("Sketcher::SketchObject", "Sketch")
    for i, (x, y) in enumerate(ARCH):
        sketch.addGeometry(Part.Circle(App.Vector(x, y, 0), App.Vector(0, 0, 1), 10), True)
        sketch.addConstraint(Sketcher.Constraint(*(("Equal", 0, i) if i else ("Weight", 0, 1.0))))
    curve = Part.BSplineCurve()
    curve.buildFromPoles([App.Vector(x, y, 0) for x, y in ARCH], False, 3)
    number = sketch.addGeometry(curve, False)
    for i in range(len(ARCH)):
        sketch.addConstraint(
            Sketcher.Constraint("InternalAlignment:Sketcher::BSplineControlPoint", i, 3, number, i)
        )
    sketch.exposeInternalGeometry(number)
    beside = sketch.addGeometry(Part.LineSegment(App.Vector(0, -50, 0), App.Vector(9, -50, 0)), True)
    assert beside > number
    wanted = PlaneCurve.spline([(0, 0), (50, 90), (100, 90), (150, 0)], degree=3)
    curve_into(sketch, wanted)
    document.recompute()
    kinds = [g.TypeId for g in sketch.Geometry]
    assert kinds.count("Part::GeomBSplineCurve") == 1
    assert kinds.count("Part::GeomLineSegment") == 1, "construction geometry stays"
    assert kinds.count("Part::GeomCircle") == 4, "the new poles, none of the old"
    assert sketch_curve(sketch).length == pytest.approx(wanted.length)


def test_an_unknown_sheet_in_the_preferences_is_reported_once(document, sketch, monkeypatch):
    from freecad.elastica_wb.host import preferences, sheet_store
    from freecad.elastica_wb.host.words import worded

    text = []
    monkeypatch.setattr(sheet_store, "report_warning", lambda sentence, who="": text.append(sentence))
    before = preferences.get("DefaultSheet")
    preferences.put("DefaultSheet", "plywood I had once")
    try:
        feature = new(strip.create, document, sketch)
    finally:
        preferences.put("DefaultSheet", before)
    assert feature.Sheet == preferences.DEFAULTS["DefaultSheet"]
    assert len(text) == 1
    assert "'plywood I had once' of the preferences is unknown" in worded(text[0])
