"""Slots in the flat pattern: exact openings of the outline, reliefs, refusals, marks, solids."""

import numpy as np
import pytest
from shapely.geometry import MultiLineString, Polygon
from shapely.ops import unary_union

from elastica_cad import Hole, InputError, Perforated, PlaneCurve, Rod, Sheet, Slot, Strip, Tab, optimal_rod
from elastica_cad.geometry import Line, Spline
from elastica_cad.strip import CUT_INNER, CUT_OUTER, BentSolid, text_strokes
from elastica_cad.strip.slots import TEXT_DISTANCE_MM

CARD = Sheet.named("card-200gsm")
ARCH = PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])


def straight(*slots, width=20.0, **options):
    return Strip(Rod.straight(100.0), CARD, max_width=width, slots=slots, label="A", **options)


def arched(*slots, **options):
    return Strip(optimal_rod(ARCH), CARD, max_width=30, slots=slots, **options)


def polygon(path):
    return Polygon(path.points(1e-4))


def gaps(path):
    following = [*path.segments[1:], path.segments[0]]
    return max(np.hypot(*(a.end - b.start)) for a, b in zip(path.segments, following, strict=True))


def test_a_square_slot_takes_width_times_depth():
    strip = straight(Slot(40, width=1.2, depth=5))
    assert straight().area - strip.area == pytest.approx(1.2 * 5, abs=1e-9)
    sides = [s for s in strip.outline.segments if isinstance(s, Line) and abs(s.start[0] - s.end[0]) < 1e-9]
    x = sorted(s.start[0] for s in sides if 0 < s.start[0] < 100)
    np.testing.assert_allclose(x, [39.4, 40.6], atol=1e-12)
    assert min(s.bounds[0, 1] for s in sides if 0 < s.start[0] < 100) == pytest.approx(5.0, abs=1e-12)


def test_a_round_relief_adds_half_a_circle():
    strip = straight(Slot(40, width=2, depth=5, side="lower", relief="round"))
    assert straight().area - strip.area == pytest.approx(2 * 5 + np.pi / 2, abs=1e-9)
    assert strip.outline.segments[0].start[1] == -10


def test_without_a_depth_it_goes_to_the_centre_line():
    assert straight().area - straight(Slot(30, width=1)).area == pytest.approx(10.0, abs=1e-9)


def test_a_leaning_slot_is_a_sheared_one():
    """Its end is square to it, so what is missing on one side is too much on the other."""
    strip = straight(Slot(50, width=1, depth=4, lean=0.5))
    assert straight().area - strip.area == pytest.approx(4 / np.cos(0.5), abs=1e-9)


@pytest.mark.parametrize(
    "slots",
    [
        (Slot(40, 1.2, 5.0), Slot(90, 0.8, 9.0, side="lower", relief="round"), Slot(130, 2.5, lean=-0.6)),
        (Slot(-4, 1.0, 3.0), Slot(0.2, 1.0, 3.0, side="lower")),
        (Slot(0.0, 1.0, 4.0),),
        tuple(Slot(x, 0.7, 4.0, side=side) for x in range(10, 150, 7) for side in ("upper", "lower")),
    ],
)
def test_the_loop_stays_closed_and_loses_just_the_slots(slots):
    strip, whole = arched(*slots), arched()
    assert strip.outline.closed
    assert gaps(strip.outline) <= 1e-6
    assert strip.outline.area > 0
    cut = polygon(strip.outline)
    assert cut.is_valid
    assert polygon(whole.outline).buffer(1e-3).contains(cut)
    assert strip.outline.area == pytest.approx(cut.area, rel=1e-6)
    assert len([s for s in strip.outline.segments if isinstance(s, Spline)]) >= 2


def test_the_edge_is_cut_exactly(check_drawing):
    """What is left of the long sides lies on the very curve that the whole strip has."""
    strip, whole = arched(Slot(60, 1.0, 5), Slot(100, 2.0, 3, lean=0.3), label="x"), arched()
    for segment in strip.outline.segments:
        if isinstance(segment, Spline):
            x, y = segment.at(np.linspace(0, 1, 101)).T
            np.testing.assert_allclose(np.abs(y), whole.width(x) / 2, atol=1e-11)
    check_drawing(strip.drawing())


def test_a_bent_slot_follows_its_centre_line():
    x = np.linspace(0, 8, 9)
    path = np.column_stack([50 + 0.02 * x**2, 2 + x])
    slot = Slot.along(path, np.full(9, 1.0), side="upper")
    area = straight().area - straight(slot).area
    length = np.hypot(*np.diff(path, axis=0).T).sum()
    assert area == pytest.approx(length * 1.0, rel=5e-3)
    assert slot.at == 50


def test_turned_over():
    slot = Slot.along([(50, 2), (51, 10)], [1, 1.5], side="upper", mate="B")
    turned = slot.mirrored()
    assert (turned.side, turned.mate, turned.at) == ("lower", "B", 50)
    np.testing.assert_allclose(turned.path, slot.path * (1, -1))
    strip = straight(slot, ends=(Tab(10, holes=(Hole(5, 2, 3),)), Tab(10)))
    np.testing.assert_allclose(strip.mirrored().outline.bounds, strip.outline.bounds)
    assert strip.mirrored().holes[0].bounds.mean(axis=0)[1] == -strip.holes[0].bounds.mean(axis=0)[1]


@pytest.mark.parametrize(
    ("slots", "message"),
    [
        ((Slot(40, 1, 25),), "A: the slot at 40 mm cuts through to another edge"),
        ((Slot(40, 1, 4), Slot(40.5, 1, 4)), "slots 40"),
        ((Slot(40, 1, 12), Slot(40.3, 1, 12, side="lower")), "slots 40"),
        ((Slot(40, 30, 4), Slot(40, 1, 4)), "slots 40 mm and 40 mm from the start touch"),
        ((Slot(400, 1, 4),), "A: the slot 400 mm from the start is not on the strip, which extends"),
    ],
)
def test_refused(slots, message):
    with pytest.raises(InputError, match=message):
        _ = straight(*slots).outline


def test_a_slot_that_meets_a_hole_is_refused():
    ends = (Tab(12, holes=(Hole(6, 3),)), Tab(10))
    with pytest.raises(InputError, match="the slot -6 mm from the start meets a hole at"):
        _ = straight(Slot(-6, 1, 9.5), ends=ends).outline


@pytest.mark.parametrize(
    "arguments",
    [
        {"at": np.nan, "width": 1},
        {"at": 1, "width": 0},
        {"at": 1, "width": 1, "depth": -1},
        {"at": 1, "width": 1, "side": "left"},
        {"at": 1, "width": 1, "relief": "oval"},
        {"at": 1, "width": 1, "lean": 90.0},
        {"at": 1, "width": 1, "path": np.zeros((3, 2))},
        {"at": 1, "width": 1, "path": np.zeros((3, 2)), "widths": np.ones(2)},
        {"at": 1, "width": 1, "path": np.full((2, 2), np.inf), "widths": np.ones(2)},
    ],
)
def test_bad_numbers(arguments):
    with pytest.raises(InputError, match="slot"):
        Slot(**arguments)


def test_three_points_do_not_make_a_bent_slot():
    with pytest.raises(InputError, match="four or more"):
        _ = straight(Slot.along([(50, 2), (50.5, 6), (50, 10)], np.ones(3), side="upper")).outline


def test_mates_are_named_beside_their_slots(check_drawing):
    strip = arched(
        Slot(60, 1, 5, mate="B7"), Slot(100, 1, 5, side="lower", mate="C"), Slot(120, 1, 5), label="A"
    )
    drawing = strip.drawing()
    texts = {text.text: text for text in drawing.texts}
    assert set(texts) == {"A", "B7", "C"}
    assert texts["B7"].layer == texts["C"].layer == "MARK"
    assert abs(texts["B7"].position[0] - 60) < 6
    inner_end = strip.width(60.0) / 2 - 5
    gap = inner_end - texts["B7"].position[1] - texts["B7"].height
    assert TEXT_DISTANCE_MM <= gap < texts["B7"].height
    check_drawing(drawing)


def test_equal_mates_are_named_once():
    for names, engraved in ((("S", "S", "S"), ["S"]), (("S", "T", "S"), ["S", "S", "T"])):
        slots = [Slot(at, 1, 5, mate=name) for at, name in zip((40, 70, 100), names, strict=True)]
        assert (
            sorted(text.text for text in arched(*slots, label="A").drawing().texts if text.text != "A")
            == engraved
        )


def test_no_room_for_a_name_no_name():
    narrow = Strip(Rod.straight(100.0), CARD, max_width=2.0, slots=(Slot(50, 0.5, 1, mate="LONG NAME"),))
    assert not narrow.drawing().texts


def test_bent_solids_have_the_slots():
    strip = arched(Slot(60, 1.0, 5), Slot(100, 2.0, 6, side="lower", lean=0.3, relief="round"))
    solid, whole = BentSolid.of(strip), BentSolid.of(arched())
    assert solid.boundary.is_closed
    assert len(solid.boundary.faces) > len(whole.boundary.faces) + 5


@pytest.mark.parametrize("at", [50.0, 47.0, 53.5])
def test_the_label_keeps_off_the_slots(at):
    (drawing,) = straight(Slot(at=at, width=1.5, depth=14.0)).drawings()
    left = Polygon(drawing.on(CUT_OUTER)[0].points(0.01))
    (label,) = [text for text in drawing.texts if text.text == "A"]
    assert label.height == 5.0
    assert left.contains(MultiLineString([stroke.points(0.05) for stroke in text_strokes(label)]))
    (plain,) = straight().drawings()
    assert abs(label.position[0] - plain.texts[0].position[0]) < 8.0  # as near to the middle as it can lie


def test_a_strip_is_drawn_once_for_all_files_and_notes():
    strip = straight(Slot(at=50.0, width=1.5, depth=14.0))
    assert not any("is not engraved" in text for text in strip.warnings)
    assert strip.drawing().strokes is strip.drawings()[0].strokes


def test_the_label_of_a_perforated_strip_keeps_off_the_holes_of_its_tabs():
    held = (Tab(12, holes=(Hole(6, 3.2),)), Tab(12, holes=(Hole(6, 3.2),)))
    strip = Strip(optimal_rod(ARCH), CARD, style=Perforated(width=30, columns=2), ends=held, label="ARCH 1")
    (drawing,) = strip.drawings()
    left = Polygon(drawing.on(CUT_OUTER)[0].points(0.01))
    left = left.difference(unary_union([Polygon(hole.points(0.01)) for hole in drawing.on(CUT_INNER)]))
    (label,) = drawing.texts
    assert left.contains(MultiLineString([stroke.points(0.05) for stroke in text_strokes(label)]))
