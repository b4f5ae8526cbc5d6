"""The parametric strip in a document, without a window."""

import math
import re
import sys
from pathlib import Path

import FreeCAD as App
import numpy as np
import Part
import pytest
from freecad.elastica_wb import strip_report
from freecad.elastica_wb.curves.part_shapes import make_face, make_solid, make_wire
from freecad.elastica_wb.features import flat, strip
from freecad.elastica_wb.host.words import worded
from freecad.elastica_wb.solving import strip_cache
from freecad.elastica_wb.solving.strip_cache import changes_that_help

from elastica_cad import InputError, PlaneCurve, Sheet, Strip, optimal_rod
from elastica_cad.strip import BentSolid, FlatSolid, summary
from tests.freecad.features import change, new

ARCH = [(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)]
WAVE = [(0, 0), (40, 60), (80, -60), (120, 0)]
BAD = [(0, 0), (40, 60), (80, -60), (120, 20), (160, 30), (180, 0)]


def core_strip(points, degree, weights=None, **options):
    curve = PlaneCurve.spline(points, degree)
    curve = PlaneCurve(curve.knots, curve.control_points, degree, weights)
    return Strip(optimal_rod(curve), Sheet.named("birch-plywood-0.8"), max_width=30.0, **options)


def mesh_area(face):
    """OpenCASCADE integrates along splines of many spans to some percent only; its triangles are true."""
    points, triangles = face.tessellate(0.001)
    corners = np.array([tuple(p) for p in points])[np.array(triangles)]
    return np.linalg.norm(np.cross(*np.diff(corners, axis=1).transpose(1, 0, 2)), axis=1).sum() / 2


@pytest.mark.parametrize(
    ("points", "degree", "weights"),
    [(WAVE, 3, None), (ARCH, 4, [1, 2, 0.5, 1, 1])],
)
def test_outline_and_volume_are_the_cores(document, drawn, points, degree, weights):
    feature = strip.create(document, drawn(points, degree, weights))
    feature.Anyway = True  # one of them is narrower than a workshop takes
    twin = flat.create(document, feature)
    change(twin, Placement=App.Placement())
    assert feature.State == ["Up-to-date"]
    assert feature.Shape.isValid()
    assert twin.Shape.isValid()
    expected = core_strip(points, degree, weights)
    s = np.linspace(0, expected.rod.length, 301)[1:-1]
    half = expected.width(s) / 2
    outer = make_wire(expected.outline)
    top = max(twin.Shape.Faces, key=lambda f: (len(f.Edges), f.CenterOfMass.z))
    for x, y in zip(s[::20], half[::20], strict=True):
        for side in (-y, y):
            point = Part.Vertex(x, side, top.CenterOfMass.z)
            assert top.OuterWire.distToShape(point)[0] < 1e-9
    assert outer.Length == pytest.approx(top.OuterWire.Length, rel=1e-9)
    assert twin.Shape.Volume == pytest.approx(make_solid(FlatSolid.of(expected)).Volume, rel=1e-9)
    assert mesh_area(top) == pytest.approx(expected.area, rel=1e-4)
    assert feature.Shape.Volume == pytest.approx(make_solid(BentSolid.of(expected)).Volume, rel=1e-9)
    assert feature.Ratio == pytest.approx(expected.rod.ratio, rel=1e-12)
    assert feature.Length.Value == pytest.approx(expected.rod.length, rel=1e-12)
    assert feature.Mass == pytest.approx(expected.mass, rel=1e-9)


def test_the_bent_strip_stands_on_the_drawn_curve(document, sketch):
    feature = strip.create(document, sketch)
    change(sketch, Placement=App.Placement(App.Vector(5, -7, 11), App.Rotation(20, 40, 60)))
    edge = sketch.Shape.Edges[0]
    normal = sketch.Placement.Rotation.multVec(App.Vector(0, 0, 1))
    for t in np.linspace(0.02, 0.98, 9):
        point, along = edge.valueAt(t), edge.tangentAt(t)
        aside = normal.cross(along)
        for sign in (-1, 1):
            skin = Part.Vertex(point + aside * (sign * 0.4))
            assert min(face.distToShape(skin)[0] for face in feature.Shape.Faces) < 2e-6
    assert feature.Shape.isInside(edge.valueAt(0.5), 1e-6, True)


def test_a_moved_pole_changes_the_strip(document, sketch, move_pole):
    feature = new(strip.create, document, sketch)
    before = feature.Shape.Volume
    move_pole(sketch, 2, (70, 95))
    document.recompute()
    expected = core_strip([*ARCH[:2], (70, 95), *ARCH[3:]], 4)
    assert feature.Ratio == pytest.approx(expected.rod.ratio, rel=1e-12)
    assert feature.Shape.Volume != pytest.approx(before, rel=1e-3)


def test_a_curve_that_cannot_be_bent_is_a_state_and_passes(document, sketch, spline_geometry, move_pole):
    feature = new(strip.create, document, sketch)
    volume = feature.Shape.Volume
    good = sketch.Geometry[0]
    sketch.delGeometry(0)
    sketch.addGeometry(spline_geometry(BAD), False)
    document.recompute()
    assert "Invalid" in feature.State
    assert "crosses the curve" in feature.getStatusString()
    assert feature.Verdict == "A flat strip cannot take this curve."
    assert feature.Reasons[0].startswith("The strip would break 41.2 mm from the start")
    assert "crosses the curve" in feature.Reasons[1]
    assert feature.Shape.Volume == volume
    assert not feature.Visibility
    sketch.delGeometry(0)
    sketch.addGeometry(good, False)
    document.recompute()
    assert feature.State == ["Up-to-date"]
    assert feature.Visibility
    assert feature.Shape.Volume == pytest.approx(volume, rel=1e-9)


def test_a_flat_part_is_hidden_while_its_strip_is_in_error(document, sketch, spline_geometry):
    """FreeCAD recomputes nothing behind a failed strip: the part would show, as good, what is cut no more."""
    feature = new(strip.create, document, sketch)
    seen, unseen = flat.create(document, feature), flat.create(document, feature)
    document.recompute()
    unseen.Visibility = False
    good = sketch.Geometry[0]
    for wrong in ([spline_geometry(BAD)], []):
        change(sketch, Geometry=wrong)
        assert [one.Visibility for one in (feature, seen, unseen)] == [False] * 3
        change(sketch, Geometry=[good])
        assert [one.Visibility for one in (feature, seen, unseen)] == [True, True, False]
    document.openTransaction("delete")
    document.removeObject(sketch.Name)
    document.commitTransaction()
    document.recompute()
    assert not seen.Visibility
    document.undo()
    document.recompute()
    assert [one.Visibility for one in (feature, seen, unseen)] == [True, True, False]


def test_what_stands_in_the_same_container_stays_in_sight(document, sketch, drawn):
    """The other strip hangs on the container by its curve's place alone."""
    part, other = document.addObject("App::Part", "Part"), drawn(ARCH)
    part.addObjects([sketch, other])
    failing, outside = strip.create(document, sketch), strip.create(document, other)
    outside.Companions = []  # as in files of version 0.1: the sketch stays
    part.removeObject(outside)
    change(outside, Curve=other)
    assert outside.Containers == [part]
    change(sketch, Geometry=[])
    assert [failing.Visibility, outside.Visibility] == [False, True]


def test_an_edge_that_gets_the_number_of_another(document, spline_geometry):
    """The chosen edge is still there, as another; an edge that changes itself is no other edge."""
    curves = [[(x / size, y / size + rise) for x, y in ARCH] for size, rise in ((1, 300), (1, 0), (4, -200))]
    sketch = document.addObject("Sketcher::SketchObject", "Sketch")
    for points in curves:
        sketch.addGeometry(spline_geometry(points), False)
    document.recompute()
    feature = new(strip.create, document, sketch, ("Edge2",))
    length = feature.Length.Value
    move = getattr(sketch, "moveGeometry", None) or sketch.movePoint  # the latter in FreeCAD 0.20
    move(1, 2, App.Vector(165, 0, 0))  # the end of the second spline
    document.recompute()
    assert feature.Length.Value > length + 5
    assert not any("another edge" in reason for reason in feature.Reasons)
    name, before = feature.Curve[1][0], feature.Length.Value
    sketch.delGeometry(0)
    document.recompute()
    # FreeCAD 1.x follows the edge
    remark = f"The curve is another edge than before: {before:.4g} mm -> 50.56 mm. Choose the curve again."
    told = feature.Reasons[:1] == [remark] and feature.Curve[1][0] == name
    assert told or feature.Length.Value == pytest.approx(before)
    change(feature, Curve=(sketch, ["Edge1"]))
    assert feature.Length.Value == pytest.approx(before)
    assert not any("another edge" in reason for reason in feature.Reasons)


def test_save_and_reload(document, sketch, tmp_path: Path, move_pole):
    feature = strip.create(document, sketch)
    feature.MaxWidth = 22
    feature.EngravedText = "A1"
    flat.create(document, feature)
    document.recompute()
    volume = feature.Shape.Volume
    file = tmp_path / "arch.FCStd"
    document.saveAs(str(file))
    App.closeDocument(document.Name)
    again = App.openDocument(str(file))
    try:
        loaded = again.getObject("Strip")
        assert loaded.Proxy.__class__ is strip.StripFeature
        assert loaded.Shape.Volume == pytest.approx(volume, rel=1e-12)
        assert (loaded.MaxWidth.Value, loaded.EngravedText) == (22, "A1")
        move_pole(again.getObject("Sketch"), 2, (70, 90))
        again.recompute()
        assert loaded.State == ["Up-to-date"]
        assert again.getObject("Flat").State == ["Up-to-date"]
        assert loaded.Shape.Volume != pytest.approx(volume, rel=1e-3)
    finally:
        App.closeDocument(again.Name)


def test_flat_record_and_core_agree(document, sketch):
    feature = new(strip.create, document, sketch)
    record = FlatSolid.of(strip.strip_of(feature))
    assert mesh_area(make_face(record.outline)) == pytest.approx(record.area, rel=1e-5)
    assert make_solid(record).Volume == pytest.approx(record.volume, rel=1e-5)  # as far as OCCT integrates


def empty(sketch):
    sketch.delGeometry(0)


def construction_only(sketch):
    sketch.setConstruction(0, True)


def two_curves(sketch):
    sketch.addGeometry(Part.LineSegment(App.Vector(500, 0, 0), App.Vector(600, 50, 0)), False)


def triangle(sketch):
    sketch.delGeometry(0)
    corners = [App.Vector(0, 0, 0), App.Vector(200, 0, 0), App.Vector(100, 150, 0)]
    for start, end in zip(corners, corners[1:] + corners[:1], strict=True):
        sketch.addGeometry(Part.LineSegment(start, end), False)


def corner(sketch):
    sketch.addGeometry(Part.LineSegment(App.Vector(150, 0, 0), App.Vector(250, 0, 0)), False)


def apart(sketch):
    sketch.addGeometry(Part.LineSegment(App.Vector(150.4, 0, 0), App.Vector(250, 0, 0)), False)


def deleted(sketch):
    sketch.Document.removeObject(sketch.Name)


@pytest.mark.parametrize(
    ("spoil", "says"),
    [
        (empty, "is empty"),
        (construction_only, "construction geometry"),
        (two_curves, "2 separate chains"),
        (triangle, "corner"),
        (corner, "corner"),
        (apart, "0.4 mm apart at (150, 0, 0) mm: join their ends there (in a sketch, by a coincident"),
        (deleted, "missing"),
    ],
)
def test_bad_sketches_are_sentences(document, sketch, spoil, says):
    feature = new(strip.create, document, sketch)
    spoil(sketch)
    feature.touch()
    document.recompute()
    assert "Invalid" in feature.State
    assert says in feature.getStatusString()
    with pytest.raises(InputError, match=re.escape(says)):
        strip.strip_of(feature)


@pytest.mark.parametrize(
    ("name", "value", "says"),
    [
        ("Thickness", 0, "thickness"),
        ("MaxWidth", 0, '"Largest width" or "Least width"'),
        ("MinWidth", 29.9, 'less than "Least width"'),
        ("TabRadius", 50, "tab corners"),
        ("TabHole", 12, "does not fit"),
        ("StartSupport", "free", "pinned|free|curvature"),
        ("GravityDirection", App.Vector(0, 0, 0), "zero"),
    ],
)
def test_bad_properties_are_sentences(document, sketch, name, value, says):
    feature = strip.create(document, sketch)
    if name == "GravityDirection":
        feature.Gravity = True
    setattr(feature, name, value)
    document.recompute()
    assert "Invalid" in feature.State
    assert re.search(says, feature.getStatusString())


def test_a_tiny_sketch_says_why(document, drawn):
    feature = new(strip.create, document, drawn([(x * 0.1 / 150, y * 0.1 / 150) for x, y in ARCH]))
    assert "Invalid" in feature.State
    assert "the material may crack there" in feature.getStatusString()
    change(feature, Anyway=True)
    assert "Invalid" in feature.State
    assert "would fold there. Use a thinner sheet" in feature.getStatusString()


def test_a_huge_sketch_says_why_and_is_made_anyway(document, drawn):
    feature = new(strip.create, document, drawn([(40 * x, 40 * y) for x, y in ARCH]))
    assert "Invalid" in feature.State
    assert "larger than the stock of 3050 x 1525 mm" in feature.getStatusString()
    change(feature, Anyway=True)
    assert "Invalid" not in feature.State
    assert feature.Shape.isValid()
    assert feature.Shape.BoundBox.XLength == pytest.approx(6000, abs=25)  # its tabs stand out


def test_a_kernel_that_fails_is_a_sentence(document, sketch, monkeypatch):
    def fails(_):
        raise Part.OCCError("BRep_API: command not done")

    feature = strip.create(document, sketch)
    monkeypatch.setattr(strip, "bent_shape", fails)
    document.recompute()
    assert "kernel cannot make this shape (BRep_API: command not done)" in feature.getStatusString()
    assert not hasattr(sys, "tracebacklimit"), "other people's tracebacks are left alone"


def test_how_far_it_strays_as_made_and_held(document, sketch):
    feature = strip.create(document, sketch)
    change(feature, Slots=["at = 60, width = 1.2", "at = 100, width = 1.2"])
    strip.show_held(feature)
    held = strip.strip_of(feature).held()
    assert feature.HeldDeviation.Value == pytest.approx(held.deviation)
    assert held.deviation > 0.5
    assert "due to slots" in feature.Held
    before = feature.Held
    document.recompute()
    assert feature.Held == before
    change(feature, MaxWidth=20)
    assert [feature.Held, feature.HeldDeviation.Value] == ["", 0]
    strip.show_held(feature)
    assert feature.Held != before


LOOP = [(0, 0), (120, 0), (-60, 200), (160, 200), (-20, 0), (100, 0)]


def test_whether_it_stays_in_its_plane_is_known_with_the_shape(document, sketch, drawn):
    upright, tipping = strip.create(document, sketch), strip.create(document, drawn(LOOP, 3))
    tipping.MaxWidth, tipping.Anyway = 5, True  # narrower than a workshop takes
    document.recompute()
    assert upright.Sideways == "sideways stability: stable; the strip stays in its plane"
    assert upright.SidewaysMargin == pytest.approx(strip.strip_of(upright).sideways.margin)
    assert re.match(
        r"sideways stability: unstable; the strip tips over sideways .*wider",
        tipping.Sideways,
    )
    assert tipping.SidewaysMargin < 0
    assert "tips over sideways" in tipping.Verdict
    change(upright, OuterWidth=60, Style="Perforated")
    assert "too wide for its length and bend" in upright.Sideways
    assert upright.SidewaysMargin == 0
    assert any("too wide for its length and bend" in reason for reason in upright.Reasons)


@pytest.mark.parametrize(
    ("found", "says"),
    [(InputError("its tabs do not reach"), "its tabs do not reach"), (None, "far from its design")],
)
def test_why_it_is_held_in_no_shape(document, sketch, monkeypatch, found, says):
    """What failed is told: the panel does not wait for ever."""

    def held(_strip):
        if found is not None:
            raise found

    feature = new(strip.create, document, sketch)
    monkeypatch.setattr(strip, "held_shape", held)
    strip.show_held(feature)
    assert says in feature.Held
    assert feature.HeldDeviation.Value == 0


RAILED = [(0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (360, 0)]


@pytest.mark.parametrize(
    ("points", "degree", "options", "label"),
    [
        (ARCH, 4, {"Creep": 2.0}, "Creep"),
        (RAILED, 5, {"Between": ["at = 200", "kind = 'tie', start = 40, end = 310, hole = 3"]}, "Mounting"),
        (RAILED, 5, {"Between": ["at = 200", "kind = 'tie', start = 40, end = 310, hole = 3"]}, "Holes"),
        (BAD, 3, {"Follow": "Nearest", "RatioLimit": 4.0}, "Curve"),
        (WAVE, 3, {"MaxWidth": 9, "Thickness": 2.0, "Anyway": True}, "Strain"),
    ],
)
def test_the_panel_has_every_row_of_the_report(document, drawn, points, degree, options, label):
    """Remarks stand in the message above the rows, and a failed row is red."""
    feature = strip.create(document, drawn(points, degree))
    change(feature, **options)
    assert feature.State == ["Up-to-date"], feature.Reasons
    strip.show_held(feature)
    near = strip.shown_nearest(feature)
    request = {(row.label, row.text) for row in summary.strip_rows(strip.strip_of(feature), near)}
    shown = strip_report.strip_rows(feature)
    assert label in {row.label for row in shown}
    missing = request - {(row.label, row.text) for row in shown}
    reasons = " ".join(feature.Reasons).lower()
    assert all(worded(text).lower() in reasons for _, text in missing)
    assert ("error" in {row.severity for row in shown}) == bool(feature.Fails)


def test_slow_rows_follow_the_recompute(document, sketch):
    feature = strip.create(document, sketch)
    change(feature, Creep=1.0)
    texts = [{row.label: row.text for row in strip_report.strip_rows(feature)}]
    strip.show_held(feature)
    texts.append({row.label: row.text for row in strip_report.strip_rows(feature)})
    assert [row["Accuracy"] == summary.LATER for row in texts] == [True, False]
    assert ["Creep" in row for row in texts] == [False, True]


@pytest.mark.parametrize("points", [ARCH, WAVE])
def test_parts_of_a_flat_body_keep_their_numbers(points):
    """A file of before names Edge3 of it: its face was one for whose outline FreeCAD had looked for a plane."""
    record = FlatSolid.of(core_strip(points, len(points) - 1))
    found = Part.Face([make_wire(record.outline, record.frame)]).extrude(App.Vector(0, 0, record.thickness))
    made = make_solid(record)
    assert record.is_prism
    for before, after in ((found.Faces, made.Faces), (found.Edges, made.Edges)):
        assert [one.Orientation for one in after] == [one.Orientation for one in before]
        for one, other in zip(after, before, strict=True):
            assert one.CenterOfMass.distanceToPoint(other.CenterOfMass) < 1e-6


def suggested(made):
    """What the panel would offer, as words and values: without a search, and after it."""
    spec, found = strip.valid_request(made), {}
    if spec is not None and "Invalid" in made.State:
        tried = changes_that_help(spec, strip.changeable(made))
        for one in tried:
            changes = [one.change] if one.width is None else [one.change, one.width]
            found[str(one.title)] = {k: v for each in changes for k, v in strip.values_of(made, each).items()}
    return found | {str(words): values for words, values in strip.suggestions(made).items()}


def test_suggestions_carry_numbers_that_give_a_strip(document, sketch):
    made = new(strip.create, document, sketch)
    assert suggested(made) == {}
    change(made, MaxWidth=2)
    offered = suggested(made)
    assert [*offered][-1] == "Make it anyway"
    (width,) = (values["MaxWidth"] for values in offered.values() if [*values] == ["MaxWidth"])
    change(made, MaxWidth=0.98 * width)
    assert "Invalid" in made.State, "it is the least width"
    change(made, MaxWidth=width)
    assert made.State == ["Up-to-date"], made.Reasons
    change(made, MaxWidth=2, **offered["Make it anyway"])
    assert made.State == ["Up-to-date"], made.Reasons
    change(made, MaxWidth=0, MinWidth=0, Anyway=False)
    assert suggested(made) == {}, "it has no width"
    change(made, MaxWidth=16, Style="Perforated", OuterWidth=20, MaterialWidth=2)
    assert {"MaterialWidth": pytest.approx(4.333)} in suggested(made).values()


def test_kinks_are_smoothed_unless_the_curve_stays_as_drawn(document, drawn):
    made = new(strip.create, document, drawn([(0, 0), (25, 45), (35, 90), (25, 135), (0, 180)], 3))
    assert made.State == ["Up-to-date"]
    assert 0 < made.Deviation.Value <= 0.1
    assert suggested(made) == {}
    change(made, AsDrawn=True)
    assert made.Deviation.Value == 0
    assert suggested(made) == {"Smooth the curve by at most 0.1 mm.": {"Smooth": 0.1}}


@pytest.mark.parametrize("gap", [0.001, 0.037, 0.45])
def test_ends_are_joined_by_the_suggested_gap(document, gap):
    made = document.addObject("Sketcher::SketchObject", "Sketch")
    circle = Part.Circle(App.Vector(), App.Vector(0, 0, 1), 100)
    made.addGeometry(Part.ArcOfCircle(circle, -math.pi / 2, -0.5), False)
    made.addGeometry(Part.ArcOfCircle(circle, -0.5, 0.7), False)
    start = App.Vector(gap * 0.6, -100 - gap * 0.8, 0)
    made.addGeometry(Part.LineSegment(start, start - App.Vector(60, 0, 0)), False)
    document.recompute()
    joined = new(strip.create, document, made)
    assert "apart" in joined.Reasons[0]
    assert [*suggested(joined)] == ["Join the ends"]
    change(joined, **suggested(joined)["Join the ends"])
    assert joined.State == ["Up-to-date"], joined.Reasons
    assert joined.Length.Value + 60 == pytest.approx(60 + 100 * (math.pi / 2 + 0.7), rel=1e-6)


def test_ends_far_apart_are_not_joined(document):
    made = document.addObject("Sketcher::SketchObject", "Sketch")
    for x in (0, 61):
        made.addGeometry(Part.LineSegment(App.Vector(x, 0, 0), App.Vector(x + 60, 0, 0)), False)
    document.recompute()
    assert suggested(new(strip.create, document, made)) == {}


@pytest.mark.parametrize("degree", [3, 4])
def test_failed_strips_are_not_solved_again_at_an_unrelated_change(document, drawn, monkeypatch, degree):
    strips = [
        strip.create(document, drawn([(x, y + (x == 80) * -0.7 * k) for x, y in BAD], degree=degree))
        for k in range(12)
    ]
    box = new(lambda document: document.addObject("Part::Box", "Box"), document)
    assert all("Invalid" in feature.State for feature in strips)
    solved = []
    for name in ("solve_rod", "glued"):
        solve = getattr(strip_cache, name)
        monkeypatch.setattr(
            strip_cache, name, lambda *given, solve=solve: solved.append(given) or solve(*given)
        )
    change(box, Length=20)
    assert box.Shape.BoundBox.XLength == pytest.approx(20)
    assert solved == []
    sketch = strips[0].Curve[0]
    curve = sketch.Geometry[0]
    curve.setPole(3, curve.getPole(3) + App.Vector(0, -5, 0))
    sketch.Geometry = [curve, *sketch.Geometry[1:]]
    document.recompute()
    assert len(solved) == 1, "only the changed strip is solved"
