"""Texts of the assembly sheet, read from the figures of its pages."""

import re
from dataclasses import replace

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad.model import slotted_frame
from elastica_cad.model.plate_pairs import end_plates
from elastica_cad.plot import save_assembly_sheet
from elastica_cad.strip.layers import LapPlates

BOW = ec.make_strip(ec.PlaneCurve.arc((0, 0), 60, 0.02, 3.12), "birch-plywood-0.8", max_width=20, label="A")


@pytest.fixture
def sheet(monkeypatch):
    """Return a function that makes a sheet and returns the texts of each page, which are 8 points or larger."""

    def read(model, *holders, **options):
        pages = []
        with monkeypatch.context() as patch:
            patch.setattr(
                "elastica_cad.plot.assembly_sheet.write_pages",
                lambda figures, *_, **__: pages.extend(figures),
            )
            save_assembly_sheet(model, "sheet.pdf", holders=holders, **options)
        texts = [[*page.texts, *(text for axes in page.axes for text in axes.texts)] for page in pages]
        assert min(text.get_fontsize() for page in texts for text in page) >= 8
        return [[text.get_text() for text in page] for page in texts]

    return read


def test_equal_strips_in_turn_share_a_row_and_a_label(sheet):
    last = ec.Placed(replace(BOW, label="B"), (0, 90, 0), (1, 0, 0), (0, 0, 1))
    model = ec.Model([*(ec.Placed(BOW, (0, y, 0), (1, 0, 0), (0, 0, 1)) for y in (0, 30, 60)), last])
    (page,) = sheet(model, model.base_plate("mdf-3"))
    assert {"strips 1 to 3", "B", "3 x A:1", "B:1"} <= {*page}
    assert page.count("base") == 5, "both ends of two rows, and the label of the plate"
    assert not any("(strip 2)" in text for text in page)


def test_the_sheet_of_two_stacks_of_rings_states_spacers_and_distance(sheet):
    bow = ec.PlaneCurve.spline([(60, 0), (90, 60), (90, 120), (60, 170)], degree=3)
    rib = ec.make_strip(bow, "birch-plywood-0.8", max_width=20, ends=(ec.Tab(25), ec.Tab(25)))
    turn = np.radians([0, 72, 144, 216, 288])
    lamp = ec.Model(
        [ec.Placed(rib, (0, 0, 0), (np.cos(t), np.sin(t), 0), (0, 0, 1)) for t in turn], name="lamp"
    )
    (page,) = sheet(lamp, *end_plates(lamp.placed, "mdf-3", gap=7))
    put = "Put spacers 7 mm high between"
    assert f"1   {put} ring-bottom-outer and ring-bottom. These spacers are not in the kit." in page
    assert f"2   {put} ring-top-outer and ring-top. These spacers are not in the kit." in page
    assert "ring-bottom and ring-bottom-outer" in page
    assert "The inner faces of ring-bottom and ring-top are 170.0 mm apart." in page
    assert "A strip without a label has the numbers 1 and 2 at its start and its end." in page
    assert "Positions of the plates (mm)" not in page
    assert_dimensions(page)
    assert {"ring-bottom", "ring-bottom-outer", "ring-top", "ring-top-outer"} <= {*page}


def test_the_text_of_a_large_model_is_on_pages_of_its_own(sheet):
    strips = [
        ec.Placed(replace(BOW, label=f"S{k}"), (0, 30 * k, 0), (1, 0, 0), (0, 0, 1)) for k in range(1, 61)
    ]
    picture, *tables = sheet(ec.Model(strips))
    assert "Order of assembly" not in picture
    assert all("Order of assembly" in page for page in tables)
    numbers = [f"S{k}" for k in range(1, 61)]
    assert [text for page in tables for text in page if text in numbers] == numbers
    assert picture[1:2] == [f"1 / {1 + len(tables)}"]


def test_parts_of_equal_shape_share_a_row(sheet):
    other = ec.make_strip(ec.PlaneCurve.arc((0, 0), 50, 0.02, 3.12), "birch-plywood-0.8", max_width=20)
    strips = [replace(BOW, label="A"), replace(other, label="B"), replace(BOW, label="C")]
    strips += [replace(other, label=label) for label in ("D", "E")]
    model = ec.Model(
        [ec.Placed(strip, (0, 30 * k, 0), (1, 0, 0), (0, 0, 1)) for k, strip in enumerate(strips)]
    )
    (page,) = sheet(model, cut_list=model.cut_list())
    row = page.index("A and C")
    assert page[row + 1] == "2"
    assert page[page.index("B, D and E") + 1] == "3"


def test_the_assembled_size_includes_the_thickness_of_the_sheet(sheet):
    arch = ec.make_strip(ec.PlaneCurve.arc((0, 0), 100, np.pi, 0), "polypropylene-3", max_width=20, label="A")
    model = ec.Model([ec.Placed(arch, (0, 0, 0), (1, 0, 0), (0, 0, 1))])
    (page,) = sheet(model)
    assert any("assembled 203 x 20 x " in text for text in page)
    (size,) = re.findall(r"assembled ([\dx ]+ mm)", "\n".join(page))
    assert ec.plot.model(model).get_suptitle().endswith(f", {size}"), "the picture has the same size"
    assert_dimensions(page)


def assert_dimensions(page):
    """The dimension lines have the size in the first line."""
    (size,) = [text for text in page if "assembled" in text]
    wide, _, high = re.search(r"assembled (\d+) x (\d+) x (\d+) mm", size).groups()
    assert {f"width {wide} mm", f"height {high} mm"} <= {*page}


def test_the_sheet_of_a_frame_states_the_distances_of_its_plates(sheet):
    model = ec.Model([ec.Placed(BOW, (0, 70 * k, 0), (1, 0, 0), (0, 0, 1)) for k in range(4)])
    frame = slotted_frame(model.placed, "mdf-3")
    (page,) = sheet(model, frame)
    assert_dimensions(page)
    middles = []
    for plate in (*frame.rails, *frame.ribs):
        row = next(k for k, text in enumerate(page) if text == plate.name and page[k + 1].startswith("("))
        middles.append(np.array([float(x) for x in page[row + 1].strip("()").split(",")]))
        if middles[1:]:
            assert float(page[row + 2]) == pytest.approx(np.linalg.norm(middles[-1] - middles[-2]), abs=0.15)
    assert abs(middles[0] - middles[1]) == pytest.approx([2 * 60, 0, 0], abs=6)


def test_the_sheet_states_the_loads_at_the_ends(sheet):
    strips = [replace(BOW, label="A"), replace(BOW, label="B")]
    (page,) = sheet(ec.Model([ec.Placed(strip, (0, 30 * k, 0)) for k, strip in enumerate(strips)]))
    loads = BOW.reactions()
    row = page[page.index("Force and moment at the ends") :]
    row = row[row.index("A and B") :]
    assert [float(text.split()[0]) for text in row[1:5]] == pytest.approx(
        [np.hypot(*loads.start_force), abs(loads.start_moment)] * 2, rel=0.05
    )


def test_the_sheet_has_a_step_for_gluing_before_bending(sheet):
    layered = ec.make_strip(
        ec.PlaneCurve.arc((0, 0), 110, 0.02, 3.12),
        "birch-plywood-0.8",
        max_width=20,
        style=ec.Laminated(width=20, backing="birch-plywood-0.8"),
    )
    strips = [replace(layered, label="L"), replace(BOW, label="P", plates=LapPlates((90.0,), 30.0)), BOW]
    model = ec.Model(
        [ec.Placed(strip, (0, 30 * k, 0), (1, 0, 0), (0, 0, 1)) for k, strip in enumerate(strips)]
    )
    texts = [text for page in sheet(model, model.base_plate("mdf-3")) for text in page]
    steps = [texts.index(next(t for t in texts if t.startswith(f"{k}   "))) for k in (1, 2)]
    assert "layers of L" in texts[steps[0]]
    assert "pieces of P" in texts[steps[1]]
    assert texts[texts.index("step") :].index("3") > 0, "strips are placed after that"


def test_a_closed_strip_is_glued_after_bending(sheet):
    circle = ec.PlaneCurve.ellipse((0, 0), (100, 80))
    ring = ec.make_strip(circle, "birch-plywood-0.8", max_width=15, ends=(ec.Tab(0), ec.Tab(12)), label="R")
    texts = [text for page in sheet(ec.Model([ec.Placed(ring)])) for text in page]
    assert "glue to its start (1)" in texts
    assert any(text.startswith("Bend R along the curve, and glue") for text in texts)


@pytest.mark.parametrize(("language", "title"), [("de", "Reihenfolge der Montage"), ("zh-CN", "装配顺序")])
def test_the_sheet_is_in_another_language(language, title, sheet, monkeypatch):
    monkeypatch.setattr("elastica_cad.plot.assembly_sheet.chinese_font", lambda: "DejaVu Sans")
    strips = [replace(BOW, label="strip"), replace(BOW, label="B")]
    model = ec.Model(
        [ec.Placed(strip, (0, 30 * k, 0), (1, 0, 0), (0, 0, 1)) for k, strip in enumerate(strips)]
    )
    options = {"cut_list": model.cut_list()}
    (page,), (english,) = (
        sheet(model, model.base_plate("mdf-3"), language=word, **options) for word in (language, "en")
    )
    assert title in page
    assert any(text.startswith("strip ") for text in page), "names of parts stay"
    kept = {text for text in page if text in english and re.search("[a-z]{2}", text)}
    assert all(re.search(r"strip|base|plywood|dxf|mdf|model|mm$", text) for text in kept), kept


def test_without_a_font_the_chinese_sheet_is_in_english_and_states_why(sheet, monkeypatch):
    monkeypatch.setattr("elastica_cad.plot.assembly_sheet.chinese_font", lambda: None)
    (page,) = sheet(ec.Model([ec.Placed(BOW)]), language="zh-CN")
    assert "Order of assembly" in page
    assert any("no font with Chinese characters" in text for text in page)


@pytest.mark.parametrize("language", ["fr", np.zeros((0, 2))])
def test_an_unknown_language_is_refused(sheet, language):
    with pytest.raises(ec.InputError, match="Use en, de or zh-CN"):
        sheet(ec.Model([ec.Placed(BOW)]), language=language)


WAVE = ec.PlaneCurve.spline(
    [(0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (360, 0)], degree=5
)


def wave_with(label, *elements, **more):
    strip = ec.make_strip(WAVE, "birch-plywood-0.8", max_width=40, between=elements, label=label, **more)
    return ec.Placed(strip, (0, 60 * ord(label), 0), (1, 0, 0), (0, 0, 1))


def test_elements_and_loads_are_the_last_steps(sheet):
    loads = (ec.PointMass(100, 20), ec.PointForce(250, (0.3, 0.4)))
    tied = wave_with("A", ec.Rail(200), ec.Tie(40, 310), loads=loads, gravity=True)
    pinned = wave_with("B", ec.Rail(200, one_sided=False), ec.Pin(300))
    pages = sheet(ec.Model([tied, pinned]))
    texts = [text for page in pages for text in page]
    steps = [text for text in texts if text[:1].isdigit() and text[1:4] == "   "]
    assert steps == [
        "3   Mount the rails and pins at the places in the table below.",
        "4   Tie the cords between the places in the table below.",
        "5   Last, add the masses and forces at the places in the table below.",
    ]
    angles = (
        "Angles are measured from the line between the ends of the strip, seen from start (1) to end (2)."
    )
    assert angles in texts
    (page,) = sheet(ec.Model([wave_with("C", ec.Rail(200))]))
    assert [text for text in page if text.startswith("2   ")] == [
        "2   Mount the rails at the places in the table below."
    ]
    assert not any("Mount" in text for text in sheet(ec.Model([ec.Placed(BOW)]))[0])


def test_a_sliding_end_is_stated_in_its_step(sheet):
    strip = ec.make_strip(
        ec.PlaneCurve.spline([(0, 0), (60, 25), (150, 40), (240, 25), (300, 0)], degree=3),
        "birch-plywood-1.5", max_width=40, between=ec.Rail(120), loads=ec.PointMass(200, 80), gravity=True,
        supports=ec.Supports("clamped", "slide-x"), label="S",
    )  # fmt: skip
    model = ec.Model([ec.Placed(strip, (0, 0, 0), (1, 0, 0), (0, 0, 1))])
    blocks = model.fixtures()
    assert "its block, free to slide along x" in sheet(model, *blocks)[0]
    assert "sein Halter, frei verschieblich entlang x" in sheet(model, *blocks, language="de")[0]


@pytest.mark.parametrize("language", ["de", "zh-CN"])
def test_the_texts_on_elements_are_translated(language, sheet, monkeypatch):
    monkeypatch.setattr("elastica_cad.plot.assembly_sheet.chinese_font", lambda: "DejaVu Sans")
    loads = (ec.PointMass(100, 20), ec.PointForce(250, (0.3, 0.4)))
    tied = wave_with("A", ec.Rail(200), ec.Tie(40, 310), loads=loads, gravity=True)
    pinned = wave_with("B", ec.Rail(200, one_sided=False), ec.Pin(300))
    turned = replace(pinned, x_axis=(0, 1, 0), y_axis=(1, 0, 0))
    texts = " ".join(text for page in sheet(ec.Model([tied, turned]), language=language) for text in page)
    for english in (
        "degrees",
        "towards",
        "upward",
        "bar",
        "bars",
        "Mount",
        "Tie",
        "Last",
        "Angles",
        "force",
        "hold",
    ):
        assert not re.search(rf"\b{english}\b", texts), english
