"""A frame of rails and ribs: tabs through rails, tongues in slots, nothing that collides."""

import numpy as np
import pytest
import shapely

from elastica_cad import Frame, InputError, Model, Placed, PlaneCurve, Sheet, Strip, Tab, optimal_rod
from elastica_cad.model import PlacedTab, slotted_frame
from elastica_cad.model.frames import SHOULDER_MM
from elastica_cad.strip import text_strokes

PLY = Sheet.named("birch-plywood-0.8")
MDF = Sheet.named("mdf-3")


def arch(label, *, span=100.0, start=-0.3, tab=20.0):
    rod = optimal_rod(PlaneCurve.ellipse((0, 0), (span, 60.0), 0.0, start, np.pi - start))
    return Strip(rod, PLY, max_width=16.0, ends=(Tab(tab), Tab(tab)), label=label)


def row(*spans, **options):
    places = [
        Placed(arch(f"H{i}", span=span, **options), (0, 45.0 * i, 0), (1, 0, 0), (0, 0, 1))
        for i, span in enumerate(spans, start=1)
    ]
    return Model(places, name="row")


@pytest.fixture(scope="module", params=["flat", "tilted"])
def model(request):
    """Arches side by side; their tabs point down, or outward so that the rails lie at an angle."""
    return row(100, 96, 92, 96, 100) if request.param == "flat" else row(*[100] * 5, start=0.9)


@pytest.fixture(scope="module")
def frame(model):
    return model.slotted_frame(MDF, ribs=4, border=7)


def test_every_tab_has_a_slot_in_its_rail(model, frame):
    for rail, end in zip(frame.rails, ("start", "end"), strict=True):
        slots = {slot.name: shapely.Polygon(slot.corners) for slot in rail.slots}
        for placed in model.placed:
            tab = PlacedTab.of(placed.strip, end, placed.frame)
            edges, step = rail.frame.local(tab.edges), rail.frame.axes @ tab.frame.x_axis
            for z in (0.0, -3.0):
                through = edges + np.outer((z - edges[:, 2]) / step[2], step)
                assert slots[tab.name].covers(shapely.MultiPoint(through[:, :2]))
            assert rail.frame.local(tab.tip)[2] < -3.0


def test_tongues_fill_their_slots(frame):
    assert [rib.name for rib in frame.ribs] == ["rib-1", "rib-2", "rib-3", "rib-4"]
    for rib in frame.ribs:
        loop = rib.frame.point(rib.outline.points(1e-3))
        for rail in frame.rails:
            assert abs(rib.frame.z_axis @ rail.frame.z_axis) < 1e-9
            (slot,) = [slot for slot in rail.slots if slot.name == rib.name]
            assert slot.size == pytest.approx((12.6, 3.1))
            local = rail.frame.local(loop)
            top = local[np.abs(local[:, 2]) < 1e-6][:, :2]
            hole = shapely.Polygon(slot.corners).buffer(1e-6)
            inside = top[[hole.covers(shapely.Point(p)) for p in top]]
            assert len(inside) == 2
            assert np.hypot(*(inside[1] - inside[0])) == pytest.approx(12.0)
            beside = local[np.abs(local[:, 2] + 3.0) < 1e-6]
            assert len(beside) >= 3
            reach = np.hypot(*(beside[:, :2] - slot.corners.mean(axis=0)).T)
            assert np.sort(reach)[:3] == pytest.approx([6.0, 6.0, 6.0 + SHOULDER_MM])


def test_tongues_are_as_wide_as_their_slots_in_both_rails_of_a_pair():
    """Cut through half the thickness of each rail, which the inner rails make narrower."""
    frame = row(100, 96, 92).slotted_frame(MDF, ribs=2, border=7, gap=12)
    widths = set()
    for rib in frame.ribs:
        solid = shapely.Polygon(rib.outline.points(1e-3))
        assert solid.is_valid
        for rail in frame.rails:
            (slot,) = [slot for slot in rail.slots if slot.name == rib.name]
            middle, along = slot.corners.mean(axis=0), slot.corners[1] - slot.corners[0]
            ends = [rib.frame.local(rail.frame.point((*(middle + k * along), -1.5)))[:2] for k in (-1, 1)]
            widths.add(round(slot.size[0], 6))
            assert solid.intersection(shapely.LineString(ends)).length == pytest.approx(slot.size[0] - 0.6)
    assert len(widths) == 2


@pytest.mark.campaign
def test_slots_keep_apart_and_inside(frame, check_drawing):
    for rail in frame.rails:
        slots = [shapely.Polygon(slot.corners) for slot in rail.slots]
        first, second = shapely.STRtree(slots).query(slots, predicate="dwithin", distance=2.9)
        assert np.all(first == second)
        edge = shapely.Polygon(rail.outline.points(1e-3)).exterior
        assert min(edge.distance(slot) for slot in slots) > 7 - 2e-3
    for piece in frame.pieces:
        check_drawing(piece.drawing)
        outline = shapely.Polygon(piece.drawing.on("CUT_OUTER")[0].points(1e-3))
        for item in piece.drawing.strokes:
            assert outline.buffer(1e-3).covers(shapely.LineString(item.path.points(1e-2)))


@pytest.mark.campaign
def test_nothing_collides(model, frame):
    from OCP.BRepAlgoAPI import BRepAlgoAPI_Common
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps

    from elastica_cad.kernel.occt import make_solid
    from elastica_cad.strip import BentSolid

    plates = [make_solid(solid) for _, solid in frame.solids]
    bent = [make_solid(BentSolid.of(p.strip, p.frame)) for p in model.placed]
    for i, plate in enumerate(plates):
        for other in plates[i + 1 :] + bent:
            mass = GProp_GProps()
            BRepGProp.VolumeProperties_s(BRepAlgoAPI_Common(plate, other).Shape(), mass)
            assert abs(mass.Mass()) < 1e-6


def test_two_strips_make_a_frame_and_one_does_too():
    assert len(slotted_frame(row(100, 90).placed, MDF).ribs) == 3
    assert len(slotted_frame(row(100).placed, MDF).ribs) == 2


def test_frames_turn_with_the_model(model, frame):
    turn = Frame((0, 0, 0), (0.6, 0.8, 0), (0, 0, 1)).axes
    moved = Model([placed.moved(turn, (1.0, 2.0, 3.0)) for placed in model.placed])
    again = moved.slotted_frame(MDF, ribs=4, border=7)
    assert [p.area for p in again.pieces] == pytest.approx([p.area for p in frame.pieces])


@pytest.mark.parametrize(
    ("model", "options", "message"),
    [
        (row(100, 96), {"ribs": 1}, "frame ribs is 1: give a whole number from 2 up to 200"),
        (row(100, 96), {"depth": 0}, "frame depth is 0"),
        (row(100, 96, tab=1), {}, "rail-start: the tab of H1:1 ends inside the plate"),
        (Model([Placed(arch("A")), Placed(arch("B"), (0, 0, 200), (-1, 0, 0), (0, -1, 0))]), {},
         "rail-start: the tabs point in too many directions"),
        (Model([Placed(arch("A")), Placed(arch("B"), (0, 0, 3))]), {}, "the slots of A:1 and B:1 overlap"),
    ],
)  # fmt: skip
def test_frames_refuse_in_words(model, options, message):
    with pytest.raises(InputError, match=message):
        model.slotted_frame(MDF, **options)


@pytest.mark.parametrize("tongue", [4.0, 12.0])
def test_names_of_ribs_stay_on_their_ribs(model, tongue):
    frame = slotted_frame(model.placed, MDF, tongue=tongue, border=7)
    for rib in frame.ribs:
        strokes = shapely.MultiLineString([stroke.points(0.05) for stroke in text_strokes(rib.label)])
        assert shapely.Polygon(rib.outline.points(0.05)).covers(strokes), rib.name
