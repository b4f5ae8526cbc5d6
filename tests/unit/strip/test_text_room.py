"""Labels and marks of strips lie on the material that is left: shapely's polygons against every stroke."""

import numpy as np
import pytest
import shapely

from elastica_cad import Hole, InputError, Laminated, Perforated, Rod, Sheet, Slot, Strip, Tab
from elastica_cad.strip import CUT_INNER, CUT_OUTER, MARK, TSlot, text_strokes

CARD = Sheet.named("card-200gsm")
LONG = "pergola-north-west-segment-042"


def polygon(path):
    return shapely.Polygon(path.points(1e-3))


def assert_on_material(drawing):
    """Every stroke of every text; what is left of the outline without the holes."""
    left = polygon(drawing.on(CUT_OUTER)[0]).difference(
        shapely.union_all([polygon(hole) for hole in drawing.on(CUT_INNER)])
    )
    for text in drawing.texts:
        assert left.contains(shapely.MultiLineString([one.points(0.05) for one in text_strokes(text)])), text


@pytest.mark.parametrize("label", ["A", "gjpqy", "_", LONG, "x" * 40])
@pytest.mark.parametrize("stiffness", [[1, 1], [1, 4, 1], [6, 1, 6], [1, 12, 1]])
@pytest.mark.parametrize("width", [3.0, 9.0, 40.0])
def test_a_label_lies_on_its_strip(label, stiffness, width):
    strip = Strip(Rod.straight(130.0, stiffness), CARD, max_width=width, label=label)
    (drawing,) = strip.drawings()
    omitted = any("is not engraved" in text for text in strip.warnings)
    assert [text.text for text in drawing.texts] == ([] if omitted else [label])
    assert omitted or width > 3
    assert all(text.height >= 1.5 for text in drawing.texts)
    assert_on_material(drawing)


def test_a_label_is_where_the_strip_is_wide():
    (drawing,) = Strip(Rod.straight(170.0, [7, 1, 7]), CARD, max_width=14.0, label="heron").drawings()
    (text,) = drawing.texts
    assert text.height > 4  # 2 mm high in the middle, at the waist
    assert_on_material(drawing)


def test_texts_keep_off_slots_that_they_would_lie_within():
    """A label in the throat of a wide slot; a mark in another one; a mark at a round inner end."""
    wide = Slot(50.0, 24.0, 18.0, relief="round", mate="B")
    rod = Rod.straight(120.0)
    drawing = Strip(rod, CARD, max_width=30.0, slots=(wide,), label="i").drawing()
    assert {text.text for text in drawing.texts} == {"i", "B"}
    assert_on_material(drawing)
    near = Slot(66.0, 1.0, 14.0, side="lower", mate="gjpq")
    assert_on_material(Strip(rod, CARD, max_width=30.0, slots=(wide, near), label="A").drawing())


@pytest.mark.parametrize("seed", range(12))
def test_texts_of_strips_with_any_slots_and_holes(seed):
    rng = np.random.default_rng(seed)
    rod, names = Rod.straight(480.0, rng.uniform(1, 3, 4)), ["A", "gj_", LONG, "B12"]
    slots = tuple(
        Slot(
            60.0 + 110 * i + float(rng.uniform(0, 40)),
            float(rng.uniform(0.5, 6)),
            float(rng.uniform(2, 9)),
            side=str(rng.choice(["upper", "lower"])),
            relief=str(rng.choice(["square", "round"])),
            mate=name,
        )
        for i, name in enumerate(names)
    )
    plain = Strip(rod, CARD, max_width=float(rng.uniform(21, 60)), slots=slots, label=LONG)
    assert_on_material(plain.drawing())
    style = Perforated(width=40.0, columns=1, rows=int(rng.integers(3, 8)))
    ends = (Tab(12.0, holes=(Hole(6.0, 3.2),), taper=1.5), Tab(9.0, 14.0))
    assert_on_material(Strip(rod, CARD, style=style, slots=slots, ends=ends, label=LONG).drawing())


def test_no_mark_runs_along_a_cut():
    """At a bare end, and along the shoulders of a tab that is narrower than a mark was."""
    drawing = Strip(Rod.straight(100.0), CARD, max_width=20.0, ends=(Tab(0.0), Tab(10.0, 4.0))).drawing()
    rim = polygon(drawing.on(CUT_OUTER)[0]).exterior
    (mark,) = drawing.on(MARK)
    assert shapely.LineString(mark.points(0.1)).intersection(rim.buffer(1e-6)).length == 0
    np.testing.assert_allclose(mark.points(0.1)[:, 0], 100.0)


@pytest.mark.parametrize(
    "tab",
    [
        Tab(20.0, taper=9.0, holes=(Hole(15.0, 8.0),)),
        Tab(20.0, chamfer=9.0, holes=(Hole(16.0, 4.0, 7.0),)),
        Tab(20.0, corner_radius=9.0, holes=(Hole(17.0, 4.0, 7.0),)),
    ],
)
def test_holes_that_break_the_sides_of_a_narrowed_tab_are_refused(tab):
    (centre,) = tab.holes
    rim = polygon_of(tab, 20.0)
    assert rim.distance(shapely.Point(centre.at, centre.across)) < centre.diameter / 2
    with pytest.raises(InputError, match="cuts the edge of a tab 20 mm wide"):
        _ = Strip(Rod.straight(100.0), CARD, max_width=20.0, ends=(tab, Tab(0.0))).outline


def polygon_of(tab, width):
    points = np.concatenate([part.at(np.linspace(0, 1, 200)) for part in tab.corners(width)])
    return shapely.LineString(points)


@pytest.mark.parametrize("seed", range(40))
def test_a_hole_fits_a_tab_where_its_circle_lies_inside(seed):
    rng = np.random.default_rng(seed)
    kind = ("taper", "chamfer", "corner_radius", "t_slot")[seed % 4]
    hole = Hole(*rng.uniform((4, 1, -7), (16, 6, 7)))
    size = float(rng.uniform(1, 9))
    tab = Tab(20.0, holes=(hole,), **{kind: TSlot(size + 7) if kind == "t_slot" else size})
    off = polygon_of(tab, 20.0).distance(shapely.Point(hole.at, hole.across)) - hole.diameter / 2
    rim = shapely.Polygon(polygon_of(tab, 20.0).coords)
    fits = off > 0 and rim.contains(shapely.Point(hole.at, hole.across))
    assert abs(off) > 1e-3
    if fits:
        assert len(tab.hole_paths(20.0)) == 1
    else:
        with pytest.raises(InputError, match="cuts the edge"):
            tab.hole_paths(20.0)


def test_a_laminate_has_no_register_hole_in_a_tab_too_narrow_for_one():
    strip = Strip(
        Rod.straight(200.0, [1, 2, 1]),
        CARD,
        style=Laminated(width=6.0, backing=CARD),
        ends=(Tab(20.0, 1.2), Tab(20.0)),
    )
    for drawing in strip.drawings():
        rim = polygon(drawing.on(CUT_OUTER)[0])
        holes = [polygon(hole) for hole in drawing.on(CUT_INNER)]
        assert len(holes) == 1
        assert rim.contains(holes[0])
