"""Several strips: slotted into each other, held by fixtures and a base plate, laid on sheets."""

import csv
import math
import re
from dataclasses import replace

import FreeCAD as App
import numpy as np
import Part
import pytest
from freecad.elastica_wb.curves.copies import originals
from freecad.elastica_wb.curves.part_shapes import make_solid
from freecad.elastica_wb.curves.sketch_curves import linked
from freecad.elastica_wb.cutting_files import write_cutting_files
from freecad.elastica_wb.features import baseplate, curves, fixtures, flat, model, nest, proxy, strip
from freecad.elastica_wb.features.pieces import cuts_of
from freecad.elastica_wb.host import sheet_store
from freecad.elastica_wb.host.objects import is_model
from freecad.elastica_wb.host.refusal import why_not_made
from freecad.elastica_wb.solving import strip_cache

import elastica_cad as ec
from elastica_cad import InputError
from elastica_cad._text import distinct
from elastica_cad.model import interlocking as interlock
from elastica_cad.strip import PrismSolid
from tests.freecad.features import change, new

ARCH = [(-75, 0), (-50, 60), (0, 95), (50, 60), (75, 0)]


ACROSS = [(5, -40), (12, 0), (15, 50), (12, 100), (5, 140)]


def strips_of(document, sketches):
    strips = []
    for name, sketch in zip("AB", sketches, strict=True):
        made = strip.create(document, sketch)
        made.MaxWidth = 16
        made.StartTab = made.EndTab = 12
        made.EngravedText = name
        strips.append(made)
    document.recompute()
    return strips


@pytest.fixture
def crossing(document, drawn):
    """Two strips that cross once, their widths upright."""
    return strips_of(document, [drawn(ARCH), drawn(ACROSS)])


@pytest.fixture
def standing(document, drawn):
    """Two arches on their ends, side by side."""
    sketches = [drawn(ARCH), drawn(ARCH)]
    for y, sketch in zip((0, 60), sketches, strict=True):
        sketch.Placement = App.Placement(App.Vector(0, y, 0), App.Rotation(App.Vector(1, 0, 0), 90))
    return strips_of(document, sketches)


@pytest.mark.campaign
def test_interlocked_strips_touch_nowhere(document, crossing):
    made = new(model.create, document, crossing)
    assert made.State == ["Up-to-date"], made.getStatusString()
    assert made.Joints == 1
    first, second = made.Shape.childShapes()
    assert first.isValid()
    assert second.isValid()
    assert first.common(second).Volume < 1e-6
    free = new(model.create, document, crossing, interlock=False)
    first, second = free.Shape.childShapes()
    assert first.common(second).Volume > 1
    assert free.Joints == 0


def overlaps(made):
    """What is told a moment after the recompute."""
    model.show_overlaps(made, model.overlaps_sought(made).result())
    return list(made.Overlaps)


def test_strips_that_run_into_each_other_are_reported(document, crossing, drawn):
    made = new(model.create, document, crossing)
    assert overlaps(made) == []
    change(made, Interlock=False)
    assert overlaps(made) == model.overlaps_of(made)
    (result,) = made.Overlaps
    assert re.fullmatch(
        r"A \([0-9.]+ mm from its start\) passes through B \([0-9.]+ mm from its start\): cut slots .*",
        result,
    )
    document.recompute([made])
    assert made.State == ["Up-to-date"]
    assert list(made.Overlaps) == [result], "what is known is not forgotten"
    crossing[1].Curve[0].Placement.Base.z = 100
    document.recompute()
    assert list(made.Overlaps) == [], "what is sought anew is not told"
    assert overlaps(made) == []


def test_slotted_strips_that_collide_beside_their_slots_are_reported(document, drawn):
    sketches = [drawn(ARCH), drawn(ARCH)]
    sketches[1].Placement = App.Placement(App.Vector(0, 1, 4), App.Rotation(App.Vector(0, 1, 0.2), 9))
    made = new(model.create, document, strips_of(document, sketches))
    assert made.Joints
    assert "outside the slots that join them" in " ".join(overlaps(made))


def test_the_model_follows_its_strips(document, crossing, move_pole):
    made = new(model.create, document, crossing)
    before = made.Shape.BoundBox.YMax
    move_pole(crossing[0].Curve[0], 2, (0, 120))
    move_pole(crossing[1].Curve[0], 4, (5, 160))
    document.recompute()
    assert made.State == ["Up-to-date"], made.getStatusString()
    assert made.Joints == 1
    assert made.Shape.BoundBox.YMax > before + 5


def in_sight(things):
    return [one.Visibility for one in things]


@pytest.mark.campaign
def test_what_is_made_from_a_strip_is_hidden_while_that_is_in_error(
    document, standing, drawn, spline_geometry
):
    """FreeCAD recomputes nothing behind a failed strip: models, holders and nests would show, as good, what was."""
    whole = model.create(document, standing, interlock=False)
    made = [
        whole,
        fixtures.create(document, [whole]),
        baseplate.create(document, [whole]),
        nest.create(document, [whole]),
        nest.create(document, standing[1:]),
    ]
    made[0].Strips[0].Visibility = False
    document.recompute()
    unseen, other = made[2], made[4]
    unseen.Visibility = False
    assert in_sight(made) == [True, True, False, True, True]
    first, second = (one.Curve[0] for one in standing)
    good = first.Geometry[0]
    for wrong in ([spline_geometry([(0, 0), (30, 60), (60, -60), (90, 60), (120, -60), (150, 0)])], []):
        change(first, Geometry=wrong)
        assert "Invalid" in standing[0].State
        assert in_sight(made) == [False, False, False, False, True]
        change(first, Geometry=[good])
        assert in_sight(made) == [True, True, False, True, True]
        assert not standing[0].Visibility, "it was hidden before"
    document.openTransaction("delete")
    document.removeObject(second.Name)
    document.commitTransaction()
    document.recompute()
    assert in_sight(made) == [False] * 5
    document.undo()
    document.recompute()
    assert in_sight(made) == [True, True, False, True, True]
    assert [one.State for one in (*standing, *made)] == [["Up-to-date"]] * 7
    assert other.Sheets == 1


def test_what_hangs_on_a_link_to_what_was_deleted_says_so(document, standing):
    """FreeCAD recomputes nothing behind a link that is broken: the nest showed a strip that is not there."""
    link = document.addObject("App::Link", "Link")
    link.LinkedObject = standing[1]
    whole = model.create(document, [standing[0], link], interlock=False)
    made = [whole, nest.create(document, [whole]), nest.create(document, standing[:1])]
    document.recompute()
    standing[0].Visibility = False
    document.removeObject(standing[1].Name)
    document.recompute()
    proxy.give_up(document)  # what a window is told
    assert in_sight(made) == [False, False, True]
    assert standing[0].Visibility, "it is well, and nothing stands for it"
    (sentence,) = whole.Reports
    assert sentence.startswith(
        'Link links to a deleted object. Choose another object in property "Linked Object"'
    )
    assert why_not_made(made[1]) == sentence
    with pytest.raises(InputError, match=r"^Link links to a deleted object"):
        cuts_of([standing[0], link])
    document.removeObject(link.Name)
    document.recompute()
    assert in_sight(made) == [True] * 3
    assert [one.State for one in made] == [["Up-to-date"]] * 3


def test_what_fails_itself_is_hidden_until_it_can_be_made(document, standing, drawn):
    made = nest.create(document, standing)
    near = curves.nearest(document, drawn(ARCH))
    after = new(strip.create, document, near)
    assert in_sight([made, near, after]) == [True] * 3
    made.SheetWidth = 20
    made.SheetHeight = 20
    near.Curve[0].Geometry = []
    document.recompute()
    assert in_sight([made, near, after]) == [False] * 3
    made.SheetWidth = made.SheetHeight = 500
    change(near, Curve=standing[0].Curve)
    assert in_sight([made, near, after]) == [True] * 3


def test_what_failed_is_hidden_when_its_sketch_is_closed(document, standing, drawn):
    """The sketcher hides what hangs on its sketch while that is open, and shows it again, failed or not."""
    drawing = drawn(ARCH)
    near, other = curves.nearest(document, drawing), nest.create(document, standing)
    document.recompute()
    good = drawing.Geometry[0]
    near.Visibility = False
    change(drawing, Geometry=[])
    near.Visibility = True
    proxy.hide_failed(drawing)
    assert in_sight([near, other]) == [False, True]
    change(drawing, Geometry=[good])
    assert in_sight([near, other]) == [True, True]


def test_the_strips_of_a_model_that_fails_come_into_sight(document, standing, spline_geometry):
    """Nothing was left in sight, so nobody could see which strips stand wrong."""
    first, second = standing
    made = new(model.create, document, standing)
    for one in standing:
        one.Visibility = False
    place = second.Curve[0].Placement
    second.Curve[0].Placement = first.Curve[0].Placement  # one within the other
    document.recompute()
    assert "touch" in made.getStatusString()
    assert made.Reports == [made.getStatusString()], "not those of before"
    assert in_sight([made, *standing]) == [False, True, True]
    first.Visibility = False  # the user looks at the other one
    change(made, Clearance=0.2)
    assert in_sight([made, *standing]) == [False, False, True]
    second.Curve[0].Placement = place
    document.recompute()
    assert in_sight([made, *standing]) == [True, False, False]
    good = first.Curve[0].Geometry[0]
    first.Curve[0].Geometry = []
    document.recompute()
    assert in_sight([made, *standing]) == [False, False, True], "what is wrong with one is told of that one"
    second.Curve[0].Placement = first.Curve[0].Placement
    first.Curve[0].Geometry = [good]
    document.recompute()
    assert in_sight([made, *standing]) == [False, True, True], "made, and inside the other"
    second.Curve[0].Placement = place
    change(second, Visibility=True)
    assert in_sight([made, *standing]) == [True, False, False]


def test_a_strip_that_another_model_shows_stays_hidden(document, standing):
    made = [model.create(document, standing), model.create(document, standing, interlock=False)]
    document.recompute()
    for one in standing:
        one.Visibility = False
    made[0].Above = App.Vector(0, 0, 1)
    standing[1].Curve[0].Placement = standing[0].Curve[0].Placement
    document.recompute()
    assert in_sight([*made, *standing]) == [False, True, False, False]


def test_strips_that_touch_are_refused_in_words(document, crossing):
    crossing[1].Curve = crossing[0].Curve
    made = new(model.create, document, crossing)
    assert "Invalid" in made.State
    assert len(made.getStatusString()) > 20
    empty = new(model.create, document, [])
    assert "no strips" in empty.getStatusString()


def test_fixtures_hold_every_end(document, standing):
    made = model.create(document, standing)
    blocks = new(fixtures.create, document, [made])
    assert blocks.State == ["Up-to-date"], blocks.getStatusString()
    assert len(blocks.Shape.childShapes()) == 4
    assert blocks.Shape.isValid()
    assert blocks.Shape.distToShape(made.Shape)[0] < 1e-3
    # pockets lean for tabs that bend; the straight tabs of the bodies, of some 600 mm3, run into them a little
    assert blocks.Shape.common(made.Shape).Volume < 60
    (pocket,) = blocks.Reports  # the blocks leave no play
    angle = float(re.search(r"turned by (\S+) degrees.*\(and 3 more like this\)$", pocket)[1])
    records = fixtures.source_model([made]).fixtures()
    assert angle == pytest.approx(max(abs(np.degrees(block.lean[1])) for block in records), rel=0.05)
    single = new(fixtures.create, document, [standing[0]])
    assert len(single.Shape.childShapes()) == 2
    standing[0].StartTab = standing[0].EndTab = 0
    document.recompute()
    assert "tab" in single.getStatusString()


@pytest.mark.campaign
def test_blocks_and_bodies_are_kept_by_their_record(document, standing, drawn, monkeypatch):
    """One strip of three changes: its two blocks and its body are made, nothing of the others."""
    far = drawn(ARCH)
    far.Placement = App.Placement(App.Vector(0, 160, 0), App.Rotation(App.Vector(1, 0, 0), 90))
    made = model.create(document, [*standing, strip.create(document, far)])
    fixtures.create(document, [made])
    document.recompute()
    blocks, bodies = [], []
    monkeypatch.setattr(fixtures, "make_solid", lambda one: blocks.append(one) or make_solid(one))
    monkeypatch.setattr(strip_cache, "make_solid", lambda one: bodies.append(one) or make_solid(one))
    document.Fixtures.touch()
    document.recompute()
    assert not blocks
    document.Strip002.MaxWidth = 15
    document.recompute()
    assert sum(bool(one.added) for one in blocks if isinstance(one, PrismSolid)) == 2
    assert len(bodies) == 2, "the strip alone, and as it is called in the model"


def test_only_joints_of_the_strip_that_changed_are_sought(document, crossing, drawn, monkeypatch):
    third = drawn([(x + 30, y) for x, y in ACROSS])
    crossing.append(strip.create(document, third))
    crossing[-1].MaxWidth = 16
    made = new(model.create, document, crossing)
    sought = []
    search = interlock.strip_crossings
    monkeypatch.setattr(interlock, "strip_crossings", lambda *both: sought.append(both) or search(*both))
    before = {joint.members: joint for joint in model.model_of(made).joints}
    crossing[-1].MaxWidth = 17
    document.recompute()
    after = {joint.members: joint for joint in model.model_of(made).joints}
    assert before[0, 1] is after[0, 1]
    assert before[0, 2] is not after[0, 2]
    assert len(sought) <= 2


@pytest.fixture
def named(document, drawn):
    """Two arches whose sketches have names, in a model called Lamp."""
    strips = []
    for y, name in ((0, "Träger"), (60, "\u808b")):
        sketch = drawn(ARCH)
        sketch.Label = name
        sketch.Placement = App.Placement(App.Vector(0, y, 0), App.Rotation(App.Vector(1, 0, 0), 90))
        strips.append(strip.create(document, sketch))
    strips[1].Label = "\u808b\u9aa8"
    made = model.create(document, strips)
    change(made, Label="Lamp")
    return made


def test_parts_are_called_as_in_the_tree_whatever_can_be_engraved(named):
    found = model.model_of(named)
    assert [one.label for one in found.strips] == ["Träger strip", "\u808b\u9aa8"]
    assert [text.text for one in found.strips for text in one.drawing().texts] == ["Trager strip", "1"]
    assert [cut.piece.called for cut in cuts_of([named])] == ["Träger strip", "1 = \u808b\u9aa8"]


def test_numbers_of_single_strips_and_of_models_differ(document, standing, named, tmp_path):
    for feature, label in zip(standing, ("\u5de6", "\u53f3"), strict=True):
        change(feature, EngravedText=label)
    called = {cut.piece.called for cut in cuts_of([named, *standing])}
    assert called == {"Träger strip", "1 = \u808b\u9aa8", "2 = \u5de6", "3 = \u53f3"}
    write_cutting_files([named, *standing], tmp_path, kinds=("csv",))
    with (tmp_path / "cut-list.csv").open(newline="", encoding="utf-8") as file:
        assert {row["engraved_number"] for row in csv.DictReader(file)} == {"", "1", "2", "3"}
    rings = [new(baseplate.create_rings, document, [named]) for _ in range(2)]
    for feature, label in zip(rings, ("\u73af", "\u5e95"), strict=True):
        change(feature, Label=label)
    called = [cut.piece.called for cut in cuts_of([*rings, named])]
    words = ["\u73af-start", "\u73af-end", "\u5e95-start", "\u5e95-end"]
    assert called[:-2] == [f"{number} = {word}" for number, word in enumerate(words, 2)]


@pytest.mark.campaign
def test_blocks_are_in_the_step_file_under_the_name_of_the_model(document, named, tmp_path):
    fixtures.create(document, [named])
    document.recompute()
    (file,) = write_cutting_files([named], tmp_path, kinds=["step"])
    names = re.findall(r"PRODUCT\('([^']*)'", file.read_text(encoding="utf-8"))
    assert names[0] == "Lamp"
    assert "fixture Träger strip:2" in names
    assert len(names) == 1 + 2 + 4


def test_engraved_blocks_are_valid(document, standing):
    standing[0].EngravedText = "R8"
    document.recompute()
    for block in fixtures.source_model(standing[:1]).fixtures():
        marked, plain = make_solid(block.solid), make_solid(replace(block, engrave="").solid)
        assert marked.isValid()
        assert 0.5 < plain.Volume - marked.Volume < 8
        assert len(marked.Faces) < len(plain.Faces) + 50


def test_the_base_plate_takes_all_tabs(document, standing):
    made = model.create(document, standing)
    plate = baseplate.create(document, [made])
    change(plate, Placement=App.Placement(App.Vector(0, 0, -2), App.Rotation()))
    assert plate.State == ["Up-to-date"], plate.getStatusString()
    assert plate.Shape.isValid()
    assert plate.Shape.BoundBox.ZMax == pytest.approx(-2, abs=1e-6)
    assert len(plate.Shape.Faces) > 6 + 4 * 4 - 4
    (text,) = plate.Reports
    assert re.fullmatch(
        r"In the slot of BasePlate, a tab can (shift by [\d.]+ mm and )?tip within a range of [\d.]+ degrees",
        text,
    )
    change(plate, Placement=App.Placement(App.Vector(0, 0, -500), App.Rotation()))
    assert "no tab" in plate.getStatusString()


BOW = [(60, 0), (85, 40), (95, 90), (85, 140), (60, 180)]


@pytest.fixture
def lamp(document, drawn):
    """Six strips around the z axis: one, and links to it."""
    drawing = drawn(BOW)
    drawing.Placement = App.Placement(App.Vector(), App.Rotation(App.Vector(1, 0, 0), 90))
    made = strip.create(document, drawing)
    made.MaxWidth, made.StartTab, made.EndTab, made.EngravedText = 20, 14, 14, "L"
    document.recompute()
    links = []
    for k in range(1, 6):
        links.append(document.addObject("App::Link", "Copy"))
        turn = App.Placement(App.Vector(), App.Rotation(App.Vector(0, 0, 1), 60 * k))
        links[-1].LinkedObject, links[-1].Placement = made, turn * made.Placement
    document.recompute()
    return [made, *links]


@pytest.mark.campaign
def test_rings_hold_a_lamp_at_both_ends(document, lamp):
    rings = new(baseplate.create_rings, document, lamp)
    change(rings, Sheet="mdf-3")
    assert rings.State == ["Up-to-date"], rings.getStatusString()
    lower, upper = rings.Shape.Solids
    assert lower.isValid()
    assert upper.isValid()
    assert lower.BoundBox.ZMax == pytest.approx(0, abs=1e-6)
    assert upper.BoundBox.ZMin == pytest.approx(180, abs=1e-6)
    bent = Part.Compound([Part.getShape(member) for member in lamp])
    assert len(bent.Solids) == 6
    assert rings.Shape.common(bent).Volume < 1e-3
    radii = sorted(edge.Curve.Radius for edge in lower.Edges if isinstance(edge.Curve, Part.Circle))
    slots = 3 * math.pi * (radii[-1] ** 2 - radii[0] ** 2) - lower.Volume
    # across a tab 20 mm wide; along a tab of 0.8 mm that leans by 25 mm on a height of 40 mm
    size = (20 + 2 * 0.3, 0.8 * math.hypot(25, 40) / 40 + 3 * 25 / 40 + 0.1)
    assert slots == pytest.approx(6 * 3 * size[0] * size[1], rel=0.01)


def test_rings_are_cut_with_their_lamp(document, lamp):
    rings = new(baseplate.create_rings, document, lamp)
    cuts = cuts_of([*lamp, rings])
    assert [(cut.piece.name, cut.piece.count) for cut in cuts] == [
        ("L", 6),
        ("Rings-bottom", 1),
        ("Rings-top", 1),
    ]
    assert [line.partition(",")[0] for line in rings.Reports] == [
        "In the slot of Rings-bottom",
        "In the slot of Rings-top",
    ]
    change(rings, Ends="end", Gap=4)
    assert [cut.piece.name for cut in cuts_of([rings])] == ["Rings", "Rings-outer"]
    change(rings, Ends="start", Gap=40)
    assert "make the tab" in rings.getStatusString()


def test_spacers_are_cut_with_their_rings(document, lamp):
    rings = new(baseplate.create_rings, document, lamp)
    change(rings, Ends="end", Gap=4, Spacers=3)
    assert rings.State == ["Up-to-date"], rings.getStatusString()
    pieces = [cut.piece for cut in cuts_of([rings])]
    assert [(piece.name, piece.count) for piece in pieces] == [
        ("Rings", 1),
        ("Rings-outer", 1),
        ("Rings-spacer", 3),
    ]
    inner, outer, *spacers = rings.Shape.Solids
    assert len(spacers) == 3
    heights = [(solid.BoundBox.ZMin, solid.BoundBox.ZMax) for solid in (inner, outer)]
    for spacer in spacers:
        assert spacer.common(inner.fuse(outer)).Volume < 1e-6
        box = spacer.BoundBox
        assert (box.ZMin, box.ZMax) == pytest.approx((min(heights)[0], max(heights)[1]))
    change(rings, Gap=0)
    assert 'Set "Gap (0 = one ring)"' in rings.getStatusString()


def test_rings_are_drilled_for_a_lamp_holder(document, lamp):
    rings = new(baseplate.create_rings, document, lamp)
    plain = [cut.piece.size for cut in cuts_of([rings])]
    change(rings, Bulb=40, Bridge=12, Screws=3, Side="top")
    assert rings.State == ["Up-to-date"], rings.getStatusString()
    lower, upper = rings.Shape.Solids
    radii = [
        sorted(round(edge.Curve.Radius, 6) for edge in solid.Edges if isinstance(edge.Curve, Part.Circle))
        for solid in (lower, upper)
    ]
    assert 20 not in radii[0]
    assert radii[1].count(2.1) == 6
    assert radii[1].count(20) == 2
    assert [cut.piece.size for cut in cuts_of([rings])] == plain
    change(rings, Side="none", Circle=44)
    assert "overlap" in rings.getStatusString()


def test_a_nest_and_its_files(document, standing, tmp_path):
    made = model.create(document, standing)
    plate = baseplate.create(document, [made])
    plate.Placement = App.Placement(App.Vector(0, 0, -2), App.Rotation())
    laid = new(nest.create, document, [made, plate])
    assert laid.State == ["Up-to-date"], laid.getStatusString()
    assert laid.Sheets == 1
    box = laid.Shape.BoundBox
    assert (box.XLength, box.YLength) == pytest.approx((600, 400), abs=1e-6)
    assert [cut.piece.count for cut in cuts_of([made, plate])] == [1, 1, 1]
    files = write_cutting_files([made, plate], tmp_path, kinds=("svg", "csv", "nest", "step"))
    assert sum(file.name.startswith("nest") for file in files) == 1
    assert (tmp_path / "Model.step").exists()
    in_step = Part.Shape()
    in_step.read(str(tmp_path / "BasePlate.step"))
    assert in_step.Volume == pytest.approx(plate.Shape.Volume, rel=1e-6)
    assert in_step.BoundBox.ZMax == pytest.approx(-2, abs=1e-6)
    change(laid, SheetWidth=100)
    assert "Invalid" in laid.State


@pytest.mark.parametrize("sheet", ['plywood 1/32"', "a/../../../out", "..", "a\\b"])
def test_no_file_leaves_the_folder_whatever_a_sheet_is_called(
    document, standing, tmp_path, monkeypatch, sheet
):
    own = replace(ec.Sheet.named("birch-plywood-0.8"), name=sheet)
    monkeypatch.setattr(sheet_store, "own_sheets", lambda: {sheet: own})
    for feature in standing:
        feature.Sheet = sheet_store.sheet_list()
        feature.Sheet = sheet
        feature.EngravedText = f"{feature.EngravedText}\u00a0\u200d1"
    document.recompute()
    assert [cut.piece.sheet.name for cut in cuts_of(standing)] == [sheet] * 2
    folder = tmp_path / "deep" / "down" / "cut"
    files = write_cutting_files(standing, folder, kinds=("svg", "csv", "nest", "step"))
    assert {path for path in tmp_path.rglob("*") if path.is_file()} == set(files)
    assert {path.parent for path in files} == {folder}


def test_a_nest_lies_in_front_of_what_has_an_end(document, standing):
    """FreeCAD 1.1 keeps planes and axes without end in every body and part; datum planes had none before."""
    document.addObject("App::Part", "Part")
    document.addObject("PartDesign::Plane", "Datum")
    room, block = document.addObject("App::Part", "Room"), document.addObject("Part::Box", "Block")
    room.addObject(block)
    room.Placement.Base.y = -700
    document.recompute()
    laid = new(nest.create, document, standing)
    assert laid.Placement.Base.y + laid.Shape.BoundBox.YLength == pytest.approx(-750)


def test_a_flat_part_of_a_strip_on_a_datum_plane_lies_within_reach(document):
    datum = document.addObject("PartDesign::Plane", "Datum")
    document.recompute()
    lying = flat.create(document, strip.create(document, datum))
    assert lying.Placement.Base.Length < 100


def test_the_step_file_of_a_model_is_its_bodies(document, standing, tmp_path):
    made = new(model.create, document, standing)
    standing[0].MaxWidth = 12  # FreeCAD has not recomputed it yet: the drawings are of the new width
    write_cutting_files([made], tmp_path, kinds=("svg", "step"))
    document.recompute()
    written = Part.Shape()
    written.read(str(tmp_path / "Model.step"))
    assert len(written.Solids) == 2
    for found, shown in zip(written.Solids, made.Shape.Solids, strict=True):
        assert found.Volume == pytest.approx(shown.Volume, rel=1e-6)
        assert found.CenterOfMass.distanceToPoint(shown.CenterOfMass) < 1e-3


def test_the_cut_list_has_the_printed_blocks(document, standing, tmp_path):
    """Also those of a strip beside its model, which has the same blocks."""
    made = model.create(document, standing)
    blocks = new(fixtures.create, document, [made])
    for kinds in (("csv",), ("csv", "step")):
        write_cutting_files([made, standing[0]], tmp_path, kinds=kinds, force=True)
        with (tmp_path / "cut-list.csv").open(encoding="utf-8") as file:
            rows = [row for row in csv.DictReader(file) if row["sheet"] == "printed"]
        assert [row["part"] for row in rows] == [f"fixture {end}" for end in ("A:1", "A:2", "B:1", "B:2")]
        assert {row["file"] for row in rows} == {"Model.step" if "step" in kinds else ""}
    for row, shape in zip(rows, blocks.Shape.Solids, strict=True):
        assert float(row["height_mm"]) == pytest.approx(shape.BoundBox.ZLength, abs=0.006)
        assert float(row["width_mm"]) == pytest.approx(shape.BoundBox.YLength, abs=0.006)


LABELS = [
    ("A/B", "A-B"),
    ("A", "A"),
    ("A", "a"),
    ("x:y" * 40, "x:y" * 40 + "z"),
    ("..", "???"),
    ("弧 1", "弧:1"),
]


@pytest.mark.parametrize("labels", LABELS)
def test_each_part_has_files_of_its_own_whatever_its_label(document, standing, tmp_path, labels):
    for obj, label in zip(standing, labels, strict=True):
        obj.EngravedText = ""
        obj.Label = label
    document.recompute()
    # FreeCAD numbers equal labels where it is not told that they may be equal
    App.ParamGet("User parameter:BaseApp/Preferences/Document").SetBool("DuplicateLabels", True)
    try:
        standing[1].Label = labels[1]
    finally:
        App.ParamGet("User parameter:BaseApp/Preferences/Document").RemBool("DuplicateLabels")
    files = write_cutting_files(standing, tmp_path, kinds=("svg", "step", "csv"))
    names = [file.name for file in files]
    assert len({name.casefold() for name in names}) == 5, names
    assert sorted(path.name for path in tmp_path.rglob("*")) == sorted(names), "none in a folder of its own"
    message = (tmp_path / "cut-list.csv").read_text(encoding="utf-8")
    assert all(name in message for name in names if name.endswith(".svg"))


def test_numbers_behind_names_take_no_name_that_is_there():
    assert distinct(["A", "A", "A-2", "a", "B"]) == ["A", "A-3", "A-2", "a-4", "B"]


def test_a_model_survives_saving(document, crossing, tmp_path):
    made = model.create(document, crossing)
    laid = new(nest.create, document, [made])
    file = tmp_path / "model.FCStd"
    document.saveAs(str(file))
    names = made.Name, laid.Name
    App.closeDocument(document.Name)
    again = App.openDocument(str(file))
    try:
        loaded, sheets = (again.getObject(name) for name in names)
        assert is_model(loaded)
        loaded.touch()
        again.recompute()
        assert loaded.State == ["Up-to-date"]
        assert sheets.State == ["Up-to-date"]
    finally:
        App.closeDocument(again.Name)


def test_flat_parts_get_the_slots_of_their_model(document, crossing):
    part = new(flat.create, document, crossing[0])
    plain = len(part.Shape.Faces)
    change(part, Model=model.create(document, crossing))
    assert part.State == ["Up-to-date"], part.getStatusString()
    assert len(part.Shape.Faces) >= plain + 3
    assert flat.flats_of(crossing) == [part]
    change(part, Model=model.create(document, crossing[1:]))
    assert "does not belong" in part.getStatusString()


@pytest.mark.campaign
def test_holders_of_links_and_arrays(document, crossing):
    link = document.addObject("App::Link", "Link")
    link.LinkedObject = crossing[0]
    link.ElementCount = 3
    for i, one in enumerate(link.ElementList):
        one.Placement.Base.z = 100.0 * i
    room = document.addObject("App::Part", "Room")
    room.addObject(link)
    change(room, Placement=App.Placement(App.Vector(9, 8, 7), App.Rotation(App.Vector(1, 2, 3), 77)))
    all_of_them = fixtures.create(document, [link])
    second = new(fixtures.create, document, [link.ElementList[1]])
    assert len(all_of_them.Shape.Solids) == 6
    strips = Part.getShape(link).Solids
    gaps = [min(one.distToShape(block)[0] for one in strips) for block in all_of_them.Shape.Solids]
    assert gaps == pytest.approx([0] * 6, abs=1e-3)
    assert len(second.Shape.Solids) == 2
    change(link, Scale=2)
    assert 'Set property "Scale" to 1' in all_of_them.getStatusString()
    link.Scale = 1
    other = new(model.create, document, [crossing[1], link])
    assert "is not a strip" in other.getStatusString()


def test_links_containers_and_flat_parts_are_counted(document, standing):
    first, second = standing
    second.Quantity = 2
    lying = flat.create(document, first)
    link = document.addObject("App::Link", "Link")
    link.LinkedObject = first
    again = document.addObject("App::Link", "Again")
    again.LinkedObject = link
    spread = document.addObject("App::Link", "Spread")
    change(spread, LinkedObject=lying, ElementCount=6)
    counts = {cut.piece.name: cut.piece.count for cut in cuts_of([first, second, again, link])}
    assert counts == {"A": 3, "B": 2}
    assert [cut.piece.count for cut in cuts_of([first, lying])] == [1], "the same piece, bent and flat"
    assert [cut.piece.count for cut in cuts_of([first, spread])] == [6]
    link.Scale = 2
    with pytest.raises(InputError, match="Set Scale to 1"):
        cuts_of([link])


def test_models_and_plates_are_counted_where_they_are_linked(document, standing, tmp_path):
    made = model.create(document, standing, interlock=False)
    part = document.addObject("App::Part", "House")
    plate = baseplate.create(document, [made])
    part.addObject(plate)
    link = document.addObject("App::Link", "Link")
    link.LinkedObject = made
    link.ElementCount = 2
    houses = document.addObject("App::Link", "Houses")
    change(houses, LinkedObject=part)
    counts = [(cut.piece.name, cut.piece.count) for cut in cuts_of([made, link, plate, houses])]
    assert counts == [("A", 3), ("B", 3), (plate.Label, 2)]
    files = write_cutting_files([made, link], tmp_path, kinds=("step", "svg"))
    assert [file.name for file in files if file.suffix == ".step"] == ["Model.step"]
    assert "A_birch-plywood-0.8_0.8mm_x3.svg" in {file.name for file in files}


@pytest.mark.campaign
@pytest.mark.parametrize("kind", ["Link", "array", "Part"])
def test_holders_stand_where_models_are_shown(document, standing, kind):
    """Blocks and a plate of what shows a model are those of the model, moved as FreeCAD moves what is shown."""
    made = new(model.create, document, standing, interlock=False)
    first = new(fixtures.create, document, [made])
    at_home = sorted(tuple(block.CenterOfMass) for block in first.Shape.Solids)
    shown = document.addObject("App::Part" if kind == "Part" else "App::Link", "Shown")
    if kind == "Part":
        for one in (made, *standing, *(strip_made.Curve[0] for strip_made in standing)):
            shown.addObject(one)
    else:
        shown.LinkedObject = made
    places = [App.Placement()]
    if kind == "array":
        shown.ElementCount = 3
        places = [App.Placement(App.Vector(0, 200.0 * i, 0), App.Rotation()) for i in range(3)]
        for one, place in zip(shown.ElementList, places, strict=True):
            one.Placement = place
    shown.Placement = App.Placement(App.Vector(400, 30, 12), App.Rotation(App.Vector(0, 0, 1), 25))
    room = document.addObject("App::Part", "Room")
    room.addObject(shown)
    room.Placement.Base = App.Vector(7, 8, 9)
    document.recompute()
    blocks = fixtures.create(document, [shown])
    plate = baseplate.create(document, [shown])
    plate.Placement.Base.z = 5  # in the room that they all stand in
    document.recompute()
    assert blocks.State == plate.State == ["Up-to-date"], blocks.getStatusString() + plate.getStatusString()
    expected = [shown.Placement * place * App.Vector(*one) for place in places for one in at_home]
    for block in blocks.Shape.Solids:
        assert min((block.CenterOfMass - one).Length for one in expected) < 1e-4
    assert len(blocks.Shape.Solids) == len(expected)
    assert max(len(face.Wires) for face in plate.Shape.Faces) == 1 + len(expected), "a slot for every tab"


def test_several_models_are_held(document, standing):
    first, second = (model.create(document, [one], interlock=False) for one in standing)
    document.recompute()
    blocks = new(fixtures.create, document, [first, second])
    assert len(blocks.Shape.Solids) == 4


@pytest.mark.campaign
def test_a_model_that_was_moved_is_held_where_it_stands(document, standing):
    made = model.create(document, standing, interlock=False)
    made.Placement.Base = App.Vector(0, 0, 300)
    document.recompute()
    blocks = new(fixtures.create, document, [made])
    box, held = made.Shape.BoundBox, blocks.Shape.BoundBox
    assert box.ZMin > 250
    assert held.ZMin < box.ZMin < held.ZMax < box.ZMax


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("labels", "engraved"),
    [(("Träger/1", "Größe"), ("Träger/1", "Größe")), (("拱", "桥"), ("1", "2"))],
)
def test_labels_that_cannot_be_engraved(document, standing, tmp_path, labels, engraved):
    """Users of other languages name things as they like: a model of them is cut, held and exported."""
    for one, label in zip(standing, labels, strict=True):
        one.EngravedText, one.Label = "", label
    made = model.create(document, standing)
    blocks = fixtures.create(document, [made])
    plate = baseplate.create(document, [made])
    plate.Label = "Plättchen"
    sheets = new(nest.create, document, [made, plate])
    for one in (made, blocks, plate, sheets):
        assert one.State == ["Up-to-date"], one.getStatusString()
    cuts = cuts_of([made])
    assert tuple(cut.piece.name for cut in cuts) == labels
    assert tuple(cut.strip.engraved for cut in cuts) == engraved, "a number where letters cannot be engraved"
    assert len(write_cutting_files([made, plate], tmp_path, kinds=("svg", "csv", "step"))) == 6


def test_a_link_to_a_strip_inside_a_container(document, standing):
    room = document.addObject("App::Part", "Room")
    room.addObjects([standing[0].Curve[0], standing[0]])
    link = document.addObject("App::Link", "Link")
    link.setLink(room, f"{standing[0].Name}.")
    group = document.addObject("App::LinkGroup", "Group")
    change(group, ElementList=[link])
    assert linked(link) is standing[0]
    assert linked(group) is group
    assert originals(group) == [standing[0]]
    assert [cut.piece.count for cut in cuts_of([link, standing[0]])] == [2]
