"""Sheets with nested pieces: nothing closer than the margin, grain kept, nothing lost; the cut list."""

import csv
import io
from dataclasses import replace

import numpy as np
import pytest
import shapely

from elastica_cad import Drawing, InputError, Model, Path, Placed, Rod, Sheet, Slot, Strip
from elastica_cad.model import cut_list, nest_pieces
from elastica_cad.strip import CUT_INNER, CUT_OUTER, LayeredPath, Piece, compensate_kerf
from tests.refusals import refusal_test

CARD = Sheet.named("card-200gsm")
MDF = Sheet("board", 3.0, 3000.0, 700.0, 0.01, kerf=0.16)  # no grain
PLY_ACROSS = Sheet("ply-across", 1.0, 5000.0, 700.0, 0.01, grain="across")


def plate(name, width, height, sheet=MDF, count=1):
    hole = Path.circle((width / 2 - 7, height / 2 + 9), min(width, height) / 4)
    paths = [
        LayeredPath(CUT_INNER, hole),
        LayeredPath(CUT_OUTER, Path.rectangle(width, height, corner=(-7, 9))),
    ]
    return Piece(name, Drawing(name, paths), sheet, count)


def outlines(drawing):
    return [shapely.Polygon(path.points(1e-3)) for path in drawing.on(CUT_OUTER)]


def assert_margin_kept(nest, margin):
    shapes = outlines(nest)
    tree = shapely.STRtree(shapes)
    first, second = tree.query(shapes, predicate="dwithin", distance=margin - 1e-6)
    assert np.all(first == second)
    low = np.min([shape.bounds[:2] for shape in shapes], axis=0)
    high = np.max([shape.bounds[2:] for shape in shapes], axis=0)
    assert np.all(low >= margin - 1e-6)
    assert np.all(high <= np.array(nest.sheet_size) - margin + 1e-6)


@pytest.mark.parametrize("seed", range(6))
def test_pieces_alike_but_for_rounding_lie_in_the_order_given(seed):
    """Sizes come from optimisations: their last digits differ from machine to machine."""

    def laid(rounding):
        pieces = [
            plate(f"p{i}", *(np.array([(80, 60), (50, 60), (120, 30)][i % 3]) + rounding[i]))
            for i in range(12)
        ]
        return [nest.pieces for nest in nest_pieces(pieces, sheet_size=(260.0, 200.0), margin=3.0)]

    assert laid(np.random.default_rng(seed).uniform(-1e-11, 1e-11, (12, 2))) == laid(np.zeros((12, 2)))


@pytest.mark.parametrize("margin", [0.01, 1.5, 6.0])
@pytest.mark.parametrize("seed", range(4))
def test_margin_is_kept_and_nothing_is_lost(margin, seed):
    rng = np.random.default_rng(seed)
    sheets = [MDF, CARD, PLY_ACROSS]
    pieces = [
        plate(f"p{i}", *rng.uniform(20, 180, 2), sheet=sheets[i % 3], count=int(rng.integers(1, 4)))
        for i in range(24)
    ]
    nests = nest_pieces(pieces, sheet_size=(400, 300), margin=margin)
    laid = [name for nest in nests for name in nest.pieces]
    assert sorted(laid) == sorted(name for piece in pieces for name in [piece.name] * piece.count)
    for nest in nests:
        assert_margin_kept(nest, margin)
        assert {p.sheet for p in pieces if p.name in nest.pieces} == {nest.sheet}
        assert len(nest.on(CUT_OUTER)) == len(nest.on(CUT_INNER)) == len(nest.pieces)
        assert nest.filled <= nest.used <= 400 * 300


@pytest.mark.parametrize("margin", [0.01, 1.0])
@pytest.mark.parametrize(("kerf", "burnt"), [(0.3, 0.3), (None, MDF.kerf), (-0.2, -0.2)])
def test_the_margin_holds_between_the_cuts_as_they_run(kerf, burnt, margin):
    """Without a margin the cuts touched, and the kerf was refused for it."""
    pieces = [plate(f"p{i}", 30 + 7 * i, 20 + 3 * i, sheet=MDF, count=3) for i in range(5)]
    for nest in nest_pieces(pieces, sheet_size=(200, 150), margin=margin, kerf=kerf):
        cut = compensate_kerf(nest, burnt)
        assert_margin_kept(replace(nest, paths=cut.paths), margin)


def test_rows_are_well_filled():
    """Equal plates that fill rows exactly leave nothing over."""
    nests = nest_pieces([plate("a", 98, 48, count=24)], sheet_size=(402, 302), margin=2)
    assert len(nests) == 1
    assert nests[0].counts == {"a": 24}
    assert nests[0].filled == pytest.approx(nests[0].used)


def test_the_better_side_is_chosen():
    """Long strips of a sheet without grain go along the short side where more of them fit."""
    strips = plate("s", 358, 45, count=12)
    assert len(nest_pieces([strips], sheet_size=(600, 400), margin=2)) == 1


@pytest.mark.parametrize("grain", ["width", "height"])
@pytest.mark.parametrize("sheet", [CARD, PLY_ACROSS])
def test_grain_runs_along_the_sheet(sheet, grain):
    pieces = [plate("g", 120, 30, sheet, count=5)]
    (nest,) = nest_pieces(pieces, sheet_size=(300, 300), margin=1, grain=grain)
    sizes = np.array([np.ptp(path.bounds, axis=0) for path in nest.on(CUT_OUTER)])
    assert np.all((sizes[:, 0] > sizes[:, 1]) == ((sheet is CARD) == (grain == "width")))
    assert f"along {'x' if grain == 'width' else 'y'}, parallel" in nest.grain


def test_a_strip_longer_than_the_width_goes_along_the_height():
    pieces = [plate("long", 371, 30, CARD, count=2)]
    with pytest.raises(InputError, match=r"turn the grain of the sheet \(nest.grain\)"):
        nest_pieces(pieces, sheet_size=(300, 600))
    (nest,) = nest_pieces(pieces, sheet_size=(300, 600), grain="height")
    assert_margin_kept(nest, 2.0)
    assert nest.grain == "the grain runs along y, parallel to the edge of the sheet that is 600 mm long"


def test_parts_larger_than_the_sheet_are_named():
    pieces = [plate("small", 20, 20), plate("beam", 700, 20)]
    with pytest.raises(
        InputError, match=r"beam: a part of 700 by 20 mm does not fit on a sheet of 600 by 400"
    ):
        nest_pieces(pieces)
    with pytest.raises(InputError, match=r"plank: a part of 500 by 30 mm, with its grain across the part"):
        nest_pieces([plate("plank", 500, 30, PLY_ACROSS)], sheet_size=(600, 400))
    nest_pieces([plate("plank", 500, 30)], sheet_size=(400, 600))


@pytest.mark.parametrize("bad", [{"sheet_size": (0, 400)}, {"sheet_size": (np.nan, 1)}, {"margin": -1}])
def test_impossible_sheets_are_refused(bad):
    with pytest.raises(InputError, match=r"(sheet_size|margin) is"):
        nest_pieces([plate("a", 10, 10)], **bad)


test_pieces_need_something_to_cut_out = refusal_test(
    [
        (lambda: Piece("empty", Drawing("empty", []), MDF), "empty: there is no closed outer cut"),
        (lambda: plate("a", 1, 1, count=0), "the number of copies is 0; give a"),
    ]
)


def strip(label, ratio=2.0):
    return Strip(Rod.straight(120.0, [1.0, ratio, 1.0]), CARD, max_width=20.0, label=label)


def test_nests_pass_the_file_checks(check_drawing):
    model = Model([Placed(strip("A")), Placed(strip("B", 3.0)), Placed(strip("A"))], name="kit")
    (nest,) = model.nest(sheet_size=(300, 200), margin=2, others=[plate("bar", 40, 10, CARD)])
    assert nest.counts == {"A": 2, "B": 1, "bar": 1}
    assert nest.name == "kit-nest-1-card-200gsm"
    assert_margin_kept(nest, 2)
    check_drawing(nest)


def test_cut_list_reports_sizes_and_sums():
    model = Model([Placed(strip("A")), Placed(strip("B", 3.0)), Placed(strip("A"))])
    listed = model.cut_list()
    rows = list(csv.DictReader(io.StringIO(listed.csv)))
    assert [(row["part"], int(row["count"])) for row in rows] == [("A", 2), ("B", 1)]
    assert float(rows[0]["length_mm"]) == pytest.approx(140.0)
    assert float(rows[0]["width_mm"]) == pytest.approx(20.0)
    assert rows[0]["file"] == "A_card-200gsm_0.2mm_x2.dxf"
    a = strip("A")
    assert float(rows[0]["cut_length_mm"]) == pytest.approx(a.outline.length, abs=0.06)
    assert float(rows[0]["mass_g"]) == pytest.approx(a.mass, abs=6e-4)
    assert listed.mass == pytest.approx(2 * a.mass + strip("B", 3.0).mass)
    assert listed.count == 3
    assert "in all" in str(listed)
    assert str(listed).count("\n") == 6


def test_equal_shapes_are_reported_whatever_is_engraved():
    """As it is, turned about, mirrored across, mirrored along; a little longer is another shape."""
    uneven = Strip(
        Rod.straight(120.0, [1.0, 2.0, 1.4]), CARD, max_width=20.0, slots=(Slot(30.0, 0.4),), label="A"
    )
    about = Strip(
        Rod.straight(120.0, [1.4, 2.0, 1.0]), CARD, max_width=20.0, slots=(Slot(90.0, 0.4),), label="B"
    )
    other = Strip(
        Rod.straight(121.0, [1.0, 2.0, 1.4]), CARD, max_width=20.0, slots=(Slot(30.0, 0.4),), label="D"
    )
    turned = replace(about.mirrored(), label="C")
    listed = Model([Placed(one) for one in (uneven, about, turned, other)]).cut_list()
    assert [(row.part, row.like) for row in listed.rows] == [("A", ""), ("B", "A"), ("C", "A"), ("D", "")]
    assert listed.shapes == 2
    assert [row.grain for row in listed.rows] == ["along"] * 4
    assert "same_shape_as" in listed.csv


@pytest.mark.parametrize(
    ("sheet", "told"),
    [(CARD, "the grain runs along x, parallel to the edge of the sheet that is 300 mm long"), (MDF, "")],
)
def test_nests_say_where_the_grain_runs(sheet, told):
    (nest,) = nest_pieces([plate("g", 120, 30, sheet)], sheet_size=(300, 200))
    assert nest.grain == told


def test_the_edge_of_the_sheet_can_be_left_out():
    pieces = [plate("g", 120, 30)]
    (whole,), (bare,) = nest_pieces(pieces), nest_pieces(pieces, edge=False)
    assert [item.layer for item in whole.paths if item.layer == "SHEET"] == ["SHEET"]
    assert [item.layer for item in bare.paths] == [item.layer for item in whole.paths[1:]]


def test_different_parts_with_one_label_are_numbered():
    model = Model([Placed(strip("A")), Placed(strip("A", 3.0)), Placed(strip("A-2", 1.5))])
    names = [piece.name for piece in model.pieces]
    assert names == ["A", "A-3", "A-2"]
    assert model.pieces[1].drawing.texts[0].text == "A-3"


def test_file_names_hold_no_odd_letters():
    piece = Piece("P 1/2: top", plate("x", 10, 10).drawing, MDF, 3)
    assert piece.file_stem == "P-1-2-top_board_3mm_x3"
    assert cut_list([piece]).rows[0].file == f"{piece.file_stem}.dxf"
