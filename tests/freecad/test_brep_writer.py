"""What FreeCAD reads from a record is the record: control points bit for bit, edges in (u, v) on their faces."""

import pathlib
import tempfile

import FreeCAD as App
import numpy as np
import Part
import pytest
from freecad.elastica_wb.curves.part_shapes import make_face, make_solid, make_wire

from elastica_cad import (
    Frame,
    Hole,
    InputError,
    Limits,
    Path,
    PlaneCurve,
    Sheet,
    Strip,
    StripSpec,
    Tab,
    make_strip,
    optimal_rod,
)
from elastica_cad.form_finding.rod_solution import solve_rod
from elastica_cad.formats.brep_writer import boundary_brep
from elastica_cad.geometry import Line
from elastica_cad.strip import BentSolid, FlatSolid
from elastica_cad.strip.bent_boundary import SpaceCurve, SpaceSurface

PLACE = Frame((5.0, -7.0, 11.0), (2.0, -1.0, 2.0), (2.0, 2.0, -1.0))
STRETCHES = {"arch": 1, "wave": 2}  # of the outline, between its kinks
CURVES = {
    "arch": PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)]),
    "wave": PlaneCurve.spline([(0, 0), (50, 80), (90, 60), (120, -60), (160, -80), (210, 0)]),
}


@pytest.fixture(params=sorted(CURVES))
def record(request):
    ends = (Tab(12, holes=(Hole(6, 3.2),)), Tab(14, width=18, corner_radius=3))
    rod = optimal_rod(CURVES[request.param])
    return BentSolid.of(Strip(rod, Sheet.named("birch-plywood-0.8"), max_width=30, ends=ends), PLACE)


def spline_numbers(curve):
    knots = np.repeat(curve.getKnots(), curve.getMultiplicities())
    return curve.Degree, knots.tobytes(), np.array([tuple(p) for p in curve.getPoles()]).tobytes()


def test_control_points_are_kept_bit_for_bit(record, request):
    shape = make_solid(record)
    assert shape.ShapeType == "Solid"
    assert shape.isValid()
    boundary = record.boundary
    assert (len(shape.Faces), len(shape.Edges), len(shape.Vertexes)) == (
        len(boundary.faces),
        len(boundary.edges),
        len(boundary.vertices),
    )
    given = {
        (e.curve.degree, e.curve.knots.tobytes(), e.curve.control_points.tobytes())
        for e in boundary.edges
        if isinstance(e.curve, SpaceCurve)
    }
    assert len(given) == 4 * STRETCHES[request.node.callspec.params["record"]]
    read = {spline_numbers(e.Curve) for e in shape.Edges if isinstance(e.Curve, Part.BSplineCurve)}
    assert given == read
    surfaces = [f.surface for f in boundary.faces if isinstance(f.surface, SpaceSurface)]
    poles = {surface.turned().control_points.tobytes() for surface in surfaces}
    bent = [f.Surface for f in shape.Faces if isinstance(f.Surface, Part.BSplineSurface)]
    assert poles == {np.array([[tuple(p) for p in row] for row in s.getPoles()]).tobytes() for s in bent}


@pytest.mark.parametrize(("name", "accuracy"), [("arch", 1e-6), ("wave", 5e-4)])
def test_freecad_reads_the_volume_that_the_sheet_has(name, accuracy):
    """As a user sees it: FreeCAD integrates by a fixed rule, which went wrong by tenths along the strip."""
    strip = Strip(optimal_rod(CURVES[name]), Sheet.named("birch-plywood-0.8"), max_width=30)
    assert make_solid(BentSolid.of(strip)).Volume == pytest.approx(strip.area * 0.8, rel=accuracy)


def test_freecad_reads_the_volume_of_a_flat_part_whose_sides_have_many_spans():
    """Its walls were extruded, which runs along the strip in u: 2.3 % were missing."""
    drawn = PlaneCurve.spline([(0, 0), (60, 120), (130, -60), (220, 100), (300, 0)])
    spec = StripSpec(drawn, "birch-plywood-0.8", max_width=40, limits=Limits(ratio=6.0))
    strip = spec.make(solve_rod(spec.rod_spec))
    body = make_solid(FlatSolid(strip.outline, strip.holes, 0.8, PLACE))
    assert body.isValid()
    assert body.Volume == pytest.approx(0.8 * strip.area, rel=1e-3)


def test_edges_run_on_their_faces(record):
    checked = 0
    for face in make_solid(record).Faces:
        for edge in face.Edges:
            if not isinstance(face.Surface, Part.BSplineSurface):
                continue
            trace, first, last = face.curveOnSurface(edge)
            for t in np.linspace(first, last, 7):
                at = trace.value(t)
                assert face.Surface.value(at.x, at.y).distanceToPoint(edge.Curve.value(t)) < 1e-7
            checked += 1
    assert checked >= 16


def test_an_open_sheet_is_a_shell(record, tmp_path: pathlib.Path):
    file = tmp_path / "middle.bin"
    file.write_bytes(boundary_brep(record.middle).for_freecad)
    shell = Part.Shape()
    shell.importBinary(str(file))
    assert shell.ShapeType == "Shell"
    assert shell.isValid()
    assert not shell.isClosed()


def test_the_passing_file_goes_and_its_lack_is_a_sentence(record, tmp_path: pathlib.Path, monkeypatch):
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    make_solid(record)
    assert list(tmp_path.iterdir()) == []
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "gone"))
    with pytest.raises(InputError, match="temporary file"):
        make_solid(record)


PLATE, HOLES = Path.rectangle(40, 20), [Path.circle((5, 5), 2), Path.circle((20, 10), 3).reversed()]
ROUNDED = Path.polyline([(0, 0), (30, 0), (30, 20), (0, 20)], [0.3, -0.2, 0.3, 0], closed=True)
SIDED = FlatSolid.of(make_strip(CURVES["wave"], "birch-plywood-0.8", max_width=30, ignore_limits=True))


@pytest.mark.parametrize(
    ("outline", "holes"),
    [
        (PLATE, HOLES),
        (PLATE.reversed(), [Path.rectangle(4, 4, corner=(30, 6))]),
        (ROUNDED, HOLES[1:]),
        (Path.circle((0, 0), 9), [Path.circle((0, 0), 4)]),
        (SIDED.outline, ()),
    ],
    ids=["circles in a plate", "run the other way", "arcs both ways", "ring", "strip"],
)
def test_a_plane_face_is_the_one_that_its_wires_make(outline, holes):
    ways = [(path if (path.area > 0) == (path is outline) else path.reversed()) for path in (outline, *holes)]
    wires = [make_wire(path, PLACE) for path in ways]
    plane = Part.Plane(App.Vector(*PLACE.origin.tolist()), App.Vector(*PLACE.z_axis.tolist()))
    made = make_face(outline, holes, PLACE)
    drawn = Part.Face(wires) if holes else Part.Face(plane, wires[0])
    up = App.Vector(*map(float, 0.8 * PLACE.z_axis))
    for ours, theirs in ((made, drawn), (made.extrude(up), drawn.extrude(up))):
        assert ours.isValid()
        assert ours.ShapeType == theirs.ShapeType
        for parts in ("Faces", "Edges", "Vertexes"):
            assert len(getattr(ours, parts)) == len(getattr(theirs, parts))
        assert ours.Area == pytest.approx(theirs.Area, rel=1e-12)
        assert tuple(ours.CenterOfMass) == pytest.approx(tuple(theirs.CenterOfMass), rel=1e-12, abs=1e-12)
        for side in ("XMin", "YMin", "ZMin", "XMax", "YMax", "ZMax"):
            assert getattr(ours.BoundBox, side) == pytest.approx(
                getattr(theirs.BoundBox, side), rel=1e-12, abs=1e-11
            )
    assert made.extrude(up).Volume == pytest.approx(drawn.extrude(up).Volume, rel=1e-12)
    assert tuple(made.normalAt(0, 0)) == pytest.approx(tuple(PLACE.z_axis))


def test_ends_that_meet_nearly_are_within_their_vertices():
    ajar = Path([Line((0, 0), (9, 0)), Line((9, 8e-7), (9, 9)), Line((9, 9), (0, 0))], closed=True)
    assert make_face(ajar).isValid()
