"""The coupon: its outline, the scale that is engraved, refusals."""

import numpy as np
import pytest

from elastica_cad import InputError, Sheet
from elastica_cad.mechanics import cantilever_droop
from elastica_cad.strip import CUT_OUTER, ENGRAVE, coupon_drawing, coupon_overhang, text_width

pytestmark = pytest.mark.core

CARD = Sheet.named("card-200gsm")


def stiff_sheet():
    return Sheet("steel", 0.5, 200e3, density=7850.0, max_strain=0.005)


def test_outline_is_clamp_and_overhang():
    (outline,) = coupon_drawing(CARD, overhang=120.0, width=15.0, clamp=30.0).on(CUT_OUTER)
    assert outline.closed
    assert outline.bounds.tolist() == [[-30.0, -7.5], [120.0, 7.5]]
    assert outline.area == pytest.approx(150 * 15)


def test_overhang_droops_by_half():
    length = coupon_overhang(CARD)
    assert cantilever_droop(length, CARD.elasto_gravity_length) / length == pytest.approx(0.5, abs=0.06)
    assert coupon_overhang(stiff_sheet()) == 400.0
    assert coupon_overhang(stiff_sheet(), max_overhang=297.0) == 290.0


@pytest.mark.parametrize("overhang", [160.0, 133.5, 20.0])
def test_every_tick_leaves_the_length_that_is_written_beside_it(overhang):
    drawing = coupon_drawing(CARD, overhang=overhang, label="", width=16.0)
    ticks = sorted(float(path.start[0]) for path in drawing.on(ENGRAVE))
    left = overhang - np.array(ticks)
    assert left[0] == overhang
    assert left[1:] == pytest.approx(np.arange(10 * np.ceil(overhang / 10 - 1), 0, -10))
    for text in drawing.texts:
        near = np.abs(left - float(text.text)).argmin()
        assert left[near] == pytest.approx(float(text.text))
    assert {text.text for text in drawing.texts} == {f"{overhang:g}", *(
        f"{v}" for v in range(50, int(np.ceil(overhang)), 50)
    )}  # fmt: skip


def test_engraving_stays_on_the_strip_and_off_its_edges():
    drawing = coupon_drawing(CARD, width=10.0, overhang=150.0, clamp=12.0)
    assert drawing.texts[-1].text == CARD.name
    strokes = [item.path.bounds for item in drawing.strokes if item.layer == ENGRAVE]
    low, high = np.min([b[0] for b in strokes], axis=0), np.max([b[1] for b in strokes], axis=0)
    assert np.all(low >= [-12.0, -4.51])
    assert np.all(high <= [150.0, 4.51])


def test_figures_do_not_run_into_each_other():
    for width in (8.0, 20.0):
        texts = coupon_drawing(CARD, overhang=203.0, label="", width=width).texts
        low = np.array([t.position for t in texts])
        high = low + [(text_width(t.text, t.height), t.height) for t in texts]
        for i in range(len(texts)):
            for j in range(i):
                assert np.any((high[i] < low[j]) | (high[j] < low[i])), (texts[i].text, texts[j].text)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"overhang": 0.0}, r"overhang is 0\.0"),
        ({"width": -1.0}, r"width is -1\.0"),
        ({"clamp": float("nan")}, "clamp is nan"),
        ({"overhang": 15.0}, "too short for its engraved scale"),
        ({"overhang": 1e6}, "longer than any board"),
        ({"width": 5.0}, "too narrow for its engraving"),
        ({"overhang": 30.0, "width": 40.0}, "bends as a plate"),
    ],
)
def test_bad_sizes(options, message):
    with pytest.raises(InputError, match=message):
        coupon_drawing(CARD, **options)
