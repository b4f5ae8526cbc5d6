"""Blocks and plates that hold tabs: right place, right angle, right size, nothing that meets."""

from dataclasses import replace

import numpy as np
import pytest

from elastica_cad import (
    Frame,
    Hole,
    InputError,
    Model,
    Path,
    Placed,
    PlaneCurve,
    Sheet,
    Strip,
    Tab,
    optimal_rod,
)
from elastica_cad.mechanics import Rod
from elastica_cad.model import BasePlate, EndFixture, PlacedTab, base_plate, end_fixtures
from elastica_cad.model.assembly import engraved_marks
from elastica_cad.model.fixtures import crowded_blocks
from elastica_cad.model.plates import TabSlot
from elastica_cad.strip import FlatSolid
from elastica_cad.strip.solids import convex_corners

PLY = Sheet.named("birch-plywood-0.8")
MDF = Sheet.named("mdf-3")
UPRIGHT = Frame((0, 0, 0), (1, 0, 0), (0, 0, 1))


@pytest.fixture(scope="module")
def arch():
    rod = optimal_rod(PlaneCurve.ellipse((0, 0), (100.0, 60.0), 0.0, 0.3, np.pi - 0.3))
    return Strip(
        rod, PLY, max_width=24.0, ends=(Tab(14), Tab(12, width=16, holes=(Hole(6, 3.0),))), label="A"
    )


def standing(strip, *angles, radius=300.0):
    """Strips on a circle, in upright planes through the axis, their feet on z = 0."""
    lowest = strip.rod.position[0, 1]
    places = []
    for v in angles:
        out = np.array([np.cos(v), np.sin(v), 0.0])
        places.append(Placed(strip, radius * out - (0, 0, lowest), out, (0, 0, 1)))
    return Model(places, name="ring")


def test_tabs_go_on_straight(arch):
    for end, k in (("start", 0), ("end", -1)):
        tab = PlacedTab.of(arch, end, UPRIGHT)
        x, y = arch.rod.position[k]
        assert tab.frame.origin == pytest.approx([x, 0, y])
        way = 1 if end == "end" else -1
        v = arch.rod.angle[k]
        assert tab.frame.x_axis == pytest.approx([way * np.cos(v), 0, way * np.sin(v)], abs=1e-12)
        assert tab.frame.x_axis[2] < 0
    assert (tab.length, tab.width, tab.thickness, tab.name) == (12, 16, 0.8, "A:2")


def test_the_pocket_is_the_tab_and_its_clearance(arch):
    leaning = EndFixture.of(arch, "end", UPRIGHT, clearance=0.2)
    block = replace(leaning, lean=(0.0, 0.0)).solid
    pocket = block.removed[0]
    low, high = pocket.outline.bounds
    assert high[0] == pytest.approx(12 + 0.2)
    assert (low[1], high[1]) == pytest.approx((-0.6, 0.6))
    assert pocket.thickness == pytest.approx(16 + 0.4)
    middle = pocket.frame.point(((low + high) / 2).tolist()) + pocket.frame.z_axis * pocket.thickness / 2
    tab = PlacedTab.of(arch, "end", UPRIGHT)
    assert tab.frame.local(middle)[1:] == pytest.approx([0, 0], abs=1e-9)
    assert block.joints["tab"] is not None


def test_holes_of_the_tab_go_through_the_block(arch):
    tab = PlacedTab.of(arch, "end", UPRIGHT)
    clamp = EndFixture.of(arch, "end", UPRIGHT).solid.removed[1]
    axis = tab.frame.local(clamp.frame.point(clamp.outline.segments[0].center))
    assert axis[:2] == pytest.approx([6, 0])
    assert axis[2] < -5
    assert axis[2] + clamp.thickness > 5


def test_the_foot_stands_on_the_floor(arch):
    floor = Frame((0, 0, -40.0))
    fixture = EndFixture.of(arch, "start", UPRIGHT, floor=floor)
    heights = [prism.frame.point(prism.outline.points(1e-3))[:, 2].min() for prism in fixture.solid.added]
    assert heights == pytest.approx([-40.0, -40.0])
    holes = [p for p in fixture.solid.removed if isinstance(p, FlatSolid)]
    drills = [p for p in holes if abs(p.frame.z_axis[2]) > 1 - 1e-9 and p.thickness == 6.0]
    assert len(drills) == 2
    for drill in drills:
        assert drill.frame.origin[2] == pytest.approx(-41.0)
        assert drill.frame.z_axis[2] == pytest.approx(1.0)


@pytest.mark.parametrize("number", ["A:2", "an arch with a name:2"])
def test_numbers_lie_between_the_ends_of_the_tab_and_the_tip_of_the_block(arch, number):
    fixture = EndFixture.of(arch, "end", UPRIGHT, engrave=number)
    letters = [
        fixture.tab.frame.local(one.frame.point(one.outline.points(0.01)))
        for one in fixture.solid.removed
        if abs(one.frame.z_axis @ fixture.tab.frame.y_axis) == pytest.approx(1.0) and one.thickness < 1.0
    ]
    x = np.concatenate(letters)[:, 0]
    assert len(letters) >= 5
    assert 0 < x.min() < x.max() < fixture.tab.length + fixture.wall


def test_all_fixtures_of_a_model_share_the_floor(arch):
    fixtures = end_fixtures(standing(arch, 0.0, 1.0).placed)
    assert [f.engrave for f in fixtures] == ["A:1", "A:2", "A:1", "A:2"]
    ground = fixtures[0].floor
    assert all(f.floor is ground for f in fixtures)
    assert min(f.lowest for f in fixtures) == pytest.approx(0.0, abs=1e-9)


def test_blocks_are_as_low_as_their_strips_allow(arch):
    """Each of two arches, one 600 mm above the other, has its floor. An upright slat has one behind each tab."""
    upper = Model(
        [
            *standing(arch, 0.0).placed,
            *(one.moved(np.eye(3), (0, 0, 600)) for one in standing(arch, 0.0).placed),
        ]
    )
    floors = [block.floor.origin[2] for block in end_fixtures(upper.placed)]
    assert np.diff(floors) == pytest.approx([0.0, 600.0, 0.0], abs=1e-9)
    slat = Strip(
        Rod.straight(1700.0),
        Sheet.named("birch-plywood-4"),
        max_width=60.0,
        ends=(Tab(40), Tab(40)),
        label="S",
    )
    for turned in (
        Placed(slat, (0, 0, 0), (0, 0, 1), (0, 1, 0)),
        Placed(slat, (0, 0, 0), (0, 0, -1), (0, 1, 0)),
    ):
        blocks = end_fixtures([turned])
        low, high = sorted(blocks, key=lambda block: block.lowest_height)
        assert max(block.size[2] for block in blocks) < 50
        assert (low.floor.z_axis @ (0, 0, 1), high.floor, high.ground.z_axis @ (0, 0, -1)) == (
            1.0,
            None,
            pytest.approx(1.0),
        )
        assert not crowded_blocks(blocks, [turned])


def test_leaning_strips_stand_square_to_their_tabs(arch):
    leaning = Model([Placed(arch, (0, 0, 0), (1, 0, 0), (0, np.cos(0.4), np.sin(0.4)))])
    fixtures = leaning.fixtures(foot=8, screw=3)
    assert all(f.floor is None and f.lowest == pytest.approx(0.0, abs=1e-9) for f in fixtures)
    with pytest.raises(InputError, match=r"fixture A:1: the strip leans by .* degrees"):
        leaning.fixtures(floor=Frame((0, 0, -500)))


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"floor": Frame()}, r"fixture A:1: the block reaches .* mm below the floor"),
        ({"clearance": -1}, "clearance is -1"),
        ({"wall": 0}, "wall is 0"),
        ({"screw": 30}, "a screw of 30 mm does not fit"),
        ({"end": "middle"}, r"ends are \['middle'\]"),
    ],
)
def test_impossible_blocks_are_refused(arch, options, message):
    with pytest.raises(InputError, match=message):
        EndFixture.of(arch, options.pop("end", "start"), UPRIGHT, **options)


def test_no_tab_no_fixture(arch):
    bare = Strip(arch.rod, PLY, max_width=24.0, ends=(Tab(0), Tab(10)), label="B")
    with pytest.raises(InputError, match="fixture B:1: the strip has no tab at this end"):
        EndFixture.of(bare, "start")
    assert [f.engrave for f in end_fixtures([Placed(bare)])] == ["B:2"]


def slab_corners(tab, depth):
    """Where the tab's four long edges meet a plane `depth` mm under the plate's upper face, z = 0."""
    origins, way = tab.edges, tab.frame.x_axis
    return (origins + np.outer((-depth - origins[:, 2]) / way[2], way))[:, :2]


@pytest.mark.parametrize("shape", ["hull", "rectangle"])
def test_every_tab_goes_through_its_slot(arch, shape, check_drawing):
    import shapely

    model = standing(arch, 0.0, 0.4, 0.8)
    base = model.base_plate(MDF, play=0.3, clearance=0.1, shape=shape)
    assert [slot.name for slot in base.slots] == ["A:1", "A:2"] * 3
    outline = shapely.Polygon(base.outline.points(1e-3))
    for i, placed in enumerate(model.placed):
        for k, end in enumerate(("start", "end")):
            slot = base.slots[2 * i + k]
            hole = shapely.Polygon(slot.corners)
            tab = PlacedTab.of(placed.strip, end, placed.frame)
            phi = np.arcsin(-tab.frame.x_axis[2])
            width = tab.thickness / np.sin(phi) + MDF.thickness / np.tan(phi) + 0.1
            assert slot.size == pytest.approx((tab.width + 0.6, width))
            for depth in (0.0, 1.5, 3.0):
                assert hole.covers(shapely.MultiPoint(slab_corners(tab, depth)))
            assert outline.exterior.distance(hole) >= 12 - 2e-3  # the polyline of a rounded corner
    spans = np.ptp(np.concatenate([slot.corners for slot in base.slots]), axis=0) + 2 * 12
    assert np.ptp(base.outline.bounds, axis=0) == pytest.approx(spans)
    assert (base.outline.area == pytest.approx(spans.prod())) == (shape == "rectangle")
    assert base.solid.frame.origin[2] == -3.0
    assert base.solid.area == pytest.approx(base.piece.area)
    check_drawing(base.drawing)


def test_labels_keep_off_the_slots(arch):
    import shapely

    from elastica_cad.strip import text_strokes

    base = standing(arch, *np.linspace(0, 6, 16)).base_plate(MDF)
    slots = shapely.MultiPolygon([shapely.Polygon(slot.corners) for slot in base.slots])
    for text in base.drawing.texts:
        for stroke in text_strokes(text):
            assert shapely.LineString(stroke.points(0.05)).distance(slots) > 0.8


@pytest.mark.parametrize("side", [-1, 1])
def test_a_label_goes_where_no_slot_is_in_the_way(side):
    """Beside one other slot: away from it, and above where both sides are free. The name is clear of all."""
    import shapely

    from elastica_cad.strip import text_strokes

    slots = [
        TabSlot(np.array([(0, y), (20, y), (20, y + 3), (0, y + 3)], dtype=float), f"A:{k}", 0.8)
        for k, y in enumerate((0.0, side * 6.0, 100.0))
    ]
    plate = BasePlate(
        MDF, Frame(), Path.polygon([(-50, -50), (70, -50), (70, 150), (-50, 150)]), tuple(slots)
    )
    first, _, lone, name = plate.drawing.texts
    assert (first.position[1] < 0) == (side == 1)
    assert lone.position[1] > 103
    assert (name.text, name.height) == ("base", 4.0)
    strokes = shapely.MultiLineString(
        [stroke.points(0.05) for text in (first, lone) for stroke in text_strokes(text)]
    )
    cuts = [plate.outline.points(0.1), *(slot.corners for slot in slots)]
    written = shapely.MultiLineString([stroke.points(0.05) for stroke in text_strokes(name)])
    assert min(written.distance(shape) for shape in (strokes, *map(shapely.LinearRing, cuts))) > 0.4


def test_least_slot_width_and_height_of_the_plate(arch):
    model = standing(arch, 0.0)
    assert model.base_plate(MDF, slot_width=4.0).slots[0].size[1] == pytest.approx(4.0)
    with pytest.raises(InputError, match=r"\(and 1 more\) is 9 mm wide, but a tab 0.8 mm thick is held only"):
        model.base_plate(MDF, slot_width=9.0)
    tips = [
        PlacedTab.of(one.strip, end, one.frame).tip[2] for one in model.placed for end in ("start", "end")
    ]
    least = min(tips) + 50
    result = (
        f"lowest tip is {least:.1f} mm above .* Move the plate up by {np.ceil(least + 3):.0f} mm .base.height"
    )
    with pytest.raises(InputError, match=result):
        base_plate(model.placed, MDF, frame=Frame((0, 0, -50)))
    with pytest.raises(InputError, match=r"come from below the plate. Move the plate down .base\.height"):
        base_plate(model.placed, MDF, frame=Frame((0, 0, 500)))
    with pytest.raises(InputError, match="holds no end of any strip"):
        base_plate([], MDF)


def test_slots_that_meet_are_named(arch):
    close = standing(arch, 0.0, 0.03)
    with pytest.raises(InputError, match=r"base: the slots of two copies of A:1 overlap near \("):
        close.base_plate(MDF)


def test_flat_tabs_are_named():
    low = optimal_rod(PlaneCurve.ellipse((0, 0), (100.0, 12.0), 0.0, 0.9, np.pi - 0.9))
    model = standing(Strip(low, PLY, max_width=20.0, label="flat"), 0.0)
    with pytest.raises(InputError, match=r"base: the tab of flat:1 is at .* degrees to the plate"):
        model.base_plate(MDF)


@pytest.mark.parametrize("bad", [{"play": -1}, {"border": np.nan}, {"shape": "round"}])
def test_impossible_plates_are_refused(arch, bad):
    with pytest.raises(InputError, match="base: "):
        standing(arch, 0.0).base_plate(MDF, **bad)


def test_convex_outlines_are_those_of_scipy():
    from scipy.spatial import ConvexHull

    random = np.random.default_rng(4)
    for _ in range(50):
        points = random.normal(size=(int(random.integers(4, 40)), 2)) * 10 ** random.uniform(-1, 3)
        points = np.concatenate(
            [points, (points + points[::-1]) / 2, points[:2]]
        )  # some on sides, some twice
        corners = convex_corners(points)
        theirs = points[ConvexHull(points).vertices]
        first = int(np.abs(theirs - corners[0]).sum(axis=1).argmin())
        assert corners.tolist() == np.roll(theirs, -first, axis=0).tolist()


def test_the_cut_list_counts_equal_blocks(arch):
    model = standing(arch, 0.0, 1.0, 2.0)
    listed = model.cut_list(model.fixtures(foot=0))
    assert [(row.part, row.count) for row in listed.printed] == [("fixture A:1", 3), ("fixture A:2", 3)]
    assert (listed.count, listed.csv.count("printed"), str(listed).count("fixture A:")) == (3, 2, 2)
    across = [tab.width + 2 * (0.15 + 4.0) for tab in (PlacedTab.of(arch, end) for end in ("start", "end"))]
    assert [row.width for row in listed.printed] == pytest.approx(across)
    wider = model.cut_list(model.fixtures(foot=5.0, screw=0)).printed
    assert [row.length - 10 for row in wider] == pytest.approx([row.length for row in listed.printed])
    assert [row.thickness for row in wider] == [row.thickness for row in listed.printed]


def test_a_floor_far_below_a_block_is_reported(arch):
    near, far = (EndFixture.of(arch, "start", UPRIGHT, floor=Frame((0, 0, -height))) for height in (100, 900))
    assert not any("high" in text for text in near.warnings)
    (message,) = (text for text in far.warnings if "high" in text)
    assert message.severity == "warning"
    assert message.values["height"] == pytest.approx(far.size[2])
    assert message.values["extra"] == pytest.approx(near.lowest + 800)


def test_printed_blocks_are_named_even_where_nothing_is_engraved(arch):
    """A cutting service engraves nothing, but a block is printed."""
    ring = standing(replace(arch, unmarked=True), 0.0)
    (told,) = engraved_marks(ring, end_fixtures(ring.placed))
    assert told == "Each block has the name of its end, such as A:1."
    assert not list(engraved_marks(ring, []))
