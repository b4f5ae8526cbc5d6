from dataclasses import replace

import numpy as np
import pytest

from elastica_cad import Drawing, InputError, Model, Path, Placed, PlaneCurve, Strip, make_strip
from elastica_cad.geometry import Line, Spline
from elastica_cad.strip import (
    CUT_INNER,
    CUT_OUTER,
    ENGRAVE,
    MARK,
    LayeredPath,
    Text,
    compensate_kerf,
    text_strokes,
)
from elastica_cad.strip.holding_template import holding_template
from tests.refusals import refusal_test

pytestmark = pytest.mark.core


def plate():
    return Drawing(
        "plate",
        [
            LayeredPath(CUT_OUTER, Path.rectangle(40, 20)),
            LayeredPath(CUT_INNER, Path.circle((10, 10), 3)),
            LayeredPath(MARK, Path([Line((20, 0), (20, 20))])),
            LayeredPath(CUT_INNER, Path.rectangle(6, 4, corner=(28, 8))),
        ],
        [Text((2, 15), "A1", 3.0)],
    )


def test_strokes_come_in_working_order():
    layers = [item.layer for item in plate().strokes]
    assert layers == [ENGRAVE] * len(text_strokes(plate().texts[0])) + [MARK, CUT_INNER, CUT_INNER, CUT_OUTER]


def test_what_is_there_twice_is_cut_once():
    square = Path.rectangle(10, 10)
    again = Path.polygon([(10, 10), (10, 0), (0, 0), (0, 10)])
    crossing = [LayeredPath(MARK, Path([Line(a, b)])) for a, b in (((0, 0), (9, 9)), ((0, 9), (9, 0)))]
    drawing = Drawing(
        "twice", [LayeredPath(CUT_OUTER, square), LayeredPath(CUT_INNER, again), *crossing, *crossing]
    )
    assert [item.layer for item in drawing.strokes] == [MARK, MARK, CUT_INNER]
    shifted = again.moved(1e-4, 0)
    assert (
        len(Drawing("near", [LayeredPath(CUT_OUTER, square), LayeredPath(CUT_OUTER, shifted)]).strokes) == 2
    )


def test_transformed_moves_texts_along():
    matrix = np.array([[0, -2, 5], [2, 0, 1], [0, 0, 1.0]])
    moved = plate().transformed(matrix)
    assert len(moved.texts) == 1
    for a, b in zip(plate().strokes, moved.strokes, strict=True):
        assert np.allclose(b.path.start, a.path.start @ matrix[:2, :2].T + matrix[:2, 2], atol=1e-12)
        assert np.allclose(b.path.end, a.path.end @ matrix[:2, :2].T + matrix[:2, 2], atol=1e-12)


def test_mirrored_texts_become_paths():
    mirrored = plate().transformed(np.diag([-1.0, 1.0, 1.0]))
    assert not mirrored.texts
    assert mirrored.bounds == pytest.approx(np.array([[-40, 0], [0, 20]]))
    assert len(mirrored.strokes) == len(plate().strokes)


def test_merged_keeps_all():
    pair = Drawing.merged(
        "pair", [plate(), plate().transformed(np.array([[1, 0, 50], [0, 1, 0], [0, 0, 1.0]]))]
    )
    assert len(pair.paths) == 8
    assert len(pair.texts) == 2
    assert len(pair.on(CUT_INNER, CUT_OUTER)) == 6


def test_kerf_is_exact_on_rectangle_and_circle():
    cut = compensate_kerf(plate(), 0.2)
    outer, hole, mark, window = (item.path for item in cut.paths)
    assert outer.bounds == pytest.approx(np.array([[-0.1, -0.1], [40.1, 20.1]]), abs=1e-13)
    assert outer.area == pytest.approx(800 + 120 * 0.1 + np.pi * 0.01, rel=1e-13)
    assert hole.segments[0].radius == pytest.approx(2.9, rel=1e-15)
    assert window.area == pytest.approx(5.8 * 3.8, rel=1e-13)
    assert mark.length == 20
    assert cut.texts == plate().texts


def test_negative_kerf_goes_the_other_way():
    outer, hole, _, window = (item.path for item in compensate_kerf(plate(), -0.2).paths)
    assert outer.area == pytest.approx(39.8 * 19.8, rel=1e-13)
    assert hole.segments[0].radius == pytest.approx(3.1)
    assert window.area == pytest.approx(24 + 20 * 0.1 + np.pi * 0.01, rel=1e-13)


def test_kerf_grows_a_spline_loop_evenly():
    loop = Path([Spline(PlaneCurve.ellipse((0, 0), (30, 20)))], closed=True)
    cut = compensate_kerf(Drawing("x", [LayeredPath(CUT_OUTER, loop)]), 0.3).paths[0].path
    assert cut.area == pytest.approx(loop.area + 0.15 * loop.length + np.pi * 0.15**2, abs=2e-3)


def test_open_cuts_have_no_side():
    slit = LayeredPath(CUT_INNER, Path([Line((5, 5), (15, 5))]))
    assert compensate_kerf(Drawing("slit", [slit]), 0.5).paths == (slit,)


def test_no_kerf_changes_nothing():
    drawing = plate()
    assert compensate_kerf(drawing, 0.0) is drawing


@pytest.mark.parametrize(
    ("items", "kerf", "message"),
    [
        (
            [(CUT_INNER, Path.rectangle(10, 0.14))],
            0.15,
            "too wide for a loop on CUT_INNER.*mm at|removes the path at",
        ),
        (
            [(CUT_INNER, Path.circle((3, 4), 0.07))],
            0.15,
            r"CUT_INNER.*removes the path at \(2.93, 4\) mm",
        ),
        (
            [(CUT_OUTER, Path.rectangle(10, 10)), (CUT_OUTER, Path.rectangle(10, 10, corner=(10.1, 5)))],
            0.15,
            r"two closed cuts meet at \(10.0",
        ),
        (
            [(CUT_OUTER, Path.circle((0, 0), 5)), (CUT_INNER, Path.circle((0, 4), 0.95))],
            -0.2,
            r"meet at \(.* mm",
        ),
        ([(CUT_OUTER, Path.circle((0, 0), 5))], np.inf, "kerf is inf"),
        ([(CUT_OUTER, Path.circle((0, 0), 5))], 50.0, "50 mm, wider than the cut of any tool: set"),
    ],
)
def test_impossible_kerfs_are_refused_with_their_place(items, kerf, message):
    with pytest.raises(InputError, match=message):
        compensate_kerf(Drawing("bad", [LayeredPath(*item) for item in items]), kerf)


def test_slots_of_a_part_are_checked_too():
    comb = Path.polygon([(0, 0), (20, 0), (20, 10), (10.1, 10), (10.1, 4), (10, 4), (10, 10), (0, 10)])
    with pytest.raises(InputError, match=r"kerf .* of 0.15 mm.*removes the path at \(10"):
        compensate_kerf(Drawing("comb", [LayeredPath(CUT_OUTER, comb)]), 0.15)


test_unknown_layers_and_empty_drawings_are_refused = refusal_test(
    [
        (lambda: LayeredPath("cut", Path.rectangle(1, 1)), "no layer 'cut'"),
        (lambda: Drawing("x", (), [Text((0, 0), "a", 1.0, layer="X")]), "no layer 'X'"),
        (lambda: Drawing("nothing").bounds, "'nothing' has neither"),
    ]
)


def test_joints_are_named_on_the_cut_pattern_and_the_template():
    arch = make_strip(PlaneCurve.arc((0, 0), 100, np.pi, 0), "card-200gsm", max_width=20)
    joined = replace(arch, joints=("", "J7"))
    names = [{text.text for text in made(joined).texts} for made in (Strip.drawing, holding_template)]
    assert "J7" in names[0] & names[1]
    assert names[1] & {"1", "2", "J7"} == {"1", "J7"}
    assert not {"J7"} & {text.text for text in (*arch.drawing().texts, *holding_template(arch).texts)}
    assert len(Model([Placed(arch), Placed(joined)]).parts) == 2
