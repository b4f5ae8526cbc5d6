"""What the page shows after a refusal and beside its tools, at a desk and on a phone."""

import time
from contextlib import contextmanager

import numpy as np
import pytest

import elastica_cad as ec
from tests.studio.browser import chromium
from tests.studio.conftest import design, link, wave

pytestmark = pytest.mark.campaign

SHARP = [(20, 0), (60, 130), (120, 130), (140, 40), (160, -50), (220, -30), (280, 90)]
"""A curve whose strain is refused, with a sheet and a size that help."""
ZIGZAG = [(0, 0), (20, 60), (40, -40), (60, 60), (80, -40), (100, 0)]
"""A refused curve for which only a far curve is found, and with HOPELESS none."""
HOPELESS = {"limits": {"length": [10, 20]}}
WITHOUT_KERNEL = """
const read = JSON.parse;
JSON.parse = (...texts) => {
  const value = read(...texts);
  if (value?.downloads) {
    value.downloads = value.downloads.filter(kind => kind !== "step");
    value.missing = { step: "pip install build123d" };
  }
  return value;
};
"""


@contextmanager
def screen(server, folder, width, fragment="", language="en"):
    """The page on a desk of 1366 x 768 or on a phone of 390 x 844 with a touch screen."""
    with chromium(folder, (width, 1000), language) as studio:
        metrics = {"width": width, "height": 768 if width > 900 else 844, "deviceScaleFactor": 1}
        studio.browser.execute_cdp_cmd(
            "Emulation.setDeviceMetricsOverride", metrics | {"mobile": width < 900}
        )
        studio.browser.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": width < 900})
        studio.open(f"{server.address}#{fragment}" if fragment else server.address)
        yield studio


def is_in_view(studio, selector):
    x, y, wide, high = studio.box(selector)
    width, height = studio.browser.execute_script("return [innerWidth, innerHeight]")
    return x >= 0 and y >= 0 and x + wide <= width and y + high <= height


@pytest.fixture(params=[1366, 390], ids=["desk", "phone"])
def width(request):
    return request.param


def test_each_example_can_be_made_as_it_opens(server, tmp_path, width):
    with screen(server, tmp_path, width) as studio:
        studio.all("[data-do=starts]")[0].click()
        names = [card.get_attribute("data-name") for card in studio.until(lambda: studio.all(".card"))][1:]
        studio.click("Close")
        for name in names:
            studio.start(name)
            studio.until(lambda: "…" not in studio.text(".told"))
            assert studio.verdict() == "It can be made", name
            assert is_in_view(studio, ".verdict strong")
            assert is_in_view(studio, ".downloads summary")


@pytest.mark.filterwarnings("ignore:The copy of curve 1")
def test_a_refused_file_shows_the_place_and_the_changes(server, tmp_path, width):
    ec.write_curves([ec.PlaneCurve.spline(SHARP, 3)], tmp_path / "sharp.svg")
    with screen(server, tmp_path, width) as studio:
        studio.start("arch")
        studio.until(lambda: studio.shape("strip"))
        scene = studio.scene()
        studio.all("[data-do=draw]")[0].click()
        studio.drop(tmp_path / "sharp.svg")
        studio.until(lambda: studio.all(".cure"))
        assert studio.verdict() == "It cannot be made"
        assert studio.all("[data-do=draw]")[0].get_attribute("aria-pressed") == "false"
        assert is_in_view(studio, ".cure:last-child")
        place, peak = studio.center("g.marks .place circle"), studio.point(3)
        assert np.hypot(*(place - peak)) < 60
        assert not studio.all(".flat path")
        if width > 900:
            assert studio.scene() != scene  # the strip of before is gone
        else:
            assert not studio.all(".scene")[0].is_displayed()


def test_a_search_without_result_ends_with_a_sentence(server, tmp_path, width):
    with screen(server, tmp_path, width, link(design(ZIGZAG, **HOPELESS))) as studio:
        studio.until(lambda: "No change was found" in studio.text(".offers"))
        assert is_in_view(studio, ".offers p")


def test_a_curve_of_very_many_pieces_has_the_reason_why_no_change_is_offered(server, tmp_path, width):
    x = np.linspace(0.0, 2900.0, 2010)
    many = design(np.column_stack([x, 60 * np.sin(x / 132)]).round(3).tolist())
    with screen(server, tmp_path, width, link(many), "de") as studio:
        studio.until(lambda: "Nicht versucht, weil die Kurve 2006 Stücke hat" in studio.text(".offers"))


def test_a_far_nearest_curve_is_offered(server, tmp_path, width):
    with screen(server, tmp_path, width, link(design(ZIGZAG))) as studio:
        studio.until(lambda: studio.all(".cure"))
        (nearest,) = studio.all(".cure")
        assert "another shape" in nearest.text
        nearest.click()
        studio.until(lambda: not studio.all(".verdict.no"))


def test_an_error_ends_with_the_next_change(server, tmp_path, width):
    (tmp_path / "empty.svg").write_text("<svg/>")
    with screen(server, tmp_path, width) as studio:
        studio.start("arch")
        studio.drop(tmp_path / "empty.svg")
        studio.until(lambda: studio.all(".said.no"))
        studio.press(studio.point(5), (0, 5))
        studio.until(lambda: studio.verdict() == "It can be made" and not studio.text(".said"))


def test_an_enlarged_curve_stays_in_view(server, tmp_path, width):
    with screen(server, tmp_path, width, link(design(SHARP))) as studio:
        studio.until(lambda: studio.all(".cure"))
        (larger,) = (one for one in studio.all(".cure") if one.text.startswith("Draw the curve"))
        larger.click()
        studio.until(lambda: not studio.all(".verdict.no"))
        (x, y, wide, high), count = studio.box(".plane > svg"), len(studio.all("g.points circle"))
        places = np.array([studio.point(k + 1) for k in range(count)])
        assert (places > (x, y)).all()
        assert (places < (x + wide, y + high)).all()


def test_suitable_sheets_name_each_reason_once_and_close(server, tmp_path, width):
    with screen(server, tmp_path, width) as studio:
        studio.start("hook")
        began = time.monotonic()
        studio.tool("sheets")
        studio.until(lambda: studio.all("dialog[open] [role=status]"))
        assert is_in_view(studio, "dialog .close")
        studio.until(lambda: studio.all("dialog details"))
        print(f"suitable sheets within {time.monotonic() - began:.1f} s")
        studio.all("dialog summary")[0].click()
        reasons = [one.text for one in studio.all("dialog details p")]
        assert len(reasons) < 6
        assert is_in_view(studio, "dialog .close")
        before = studio.text(".numbers")
        studio.click("PETG 0.5 mm", "dialog td button")
        studio.until(lambda: studio.text(".numbers") != before)
        assert studio.all("#field-sheet")[0].get_attribute("value") == "petg-0.5"

        studio.open(f"{server.address}#{link(wave())}")
        studio.browser.refresh()
        studio.until(lambda: studio.verdict() == "It cannot be made")
        studio.tool("sheets")
        studio.until(lambda: "No sheet fits" in studio.text("dialog"))
        assert len(studio.all("dialog details p")) == 1
        studio.click("Close")
        assert not studio.all("dialog[open]")


def test_the_nearest_curve_is_a_switch_that_keeps_the_points(server, tmp_path, width):
    with screen(server, tmp_path, width, link(wave())) as studio:
        studio.until(lambda: studio.verdict() == "It cannot be made")
        points = studio.shape("points")
        studio.tool("nearest")
        studio.until(lambda: "from the drawn curve" in studio.text(".numbers"))
        assert studio.shape("points") == points
        assert studio.shape("strip")
        assert not studio.all("g.marks .crossing")
        studio.tool("nearest")
        studio.until(lambda: studio.verdict() == "It cannot be made")


def test_the_boxes_of_a_point_cover_no_drawing(server, tmp_path, width):
    with screen(server, tmp_path, width) as studio:
        studio.start("arch")
        place = studio.box(".plane > svg")
        for k in (1, 5, 9):
            studio.press(studio.point(k))
            studio.until(lambda: studio.all(".point:not([hidden])"))
            assert studio.box(".plane > svg") == place  # nothing moves under the pointer
            _, y, _, high = studio.box(".point")
            assert y + high <= place[1]
            assert is_in_view(studio, ".point button")


BOXES = """
const all = [...document.querySelectorAll(".elastica-studio :not(:is(svg *, canvas))")];
const place = one => Object.values(one.getBoundingClientRect().toJSON()).map(Math.round).join();
const isShown = one => one.isConnected && one.checkVisibility();
const moved = (window.seen ?? []).filter(([one, before]) => isShown(one) && place(one) !== before);
window.seen = all.filter(isShown).map(one => [one, place(one)]);
return moved.map(([one]) => one.outerHTML.slice(0, 60));
"""
"""Start of the elements that have moved since this was last run."""
CONTROLS = """
return [...document.querySelectorAll("button, summary, select, input, label, dd, section, .cure")]
  .filter(one => one.checkVisibility())
  .map(one => one.getBoundingClientRect())
  .map(({ x, y, width, height }) => [x + width / 2, y + height / 2])
  .filter(([x, y]) => x > 0 && y > 0 && x < innerWidth && y < innerHeight);
"""


@pytest.mark.parametrize("fragment", ["arch", "refused"])
def test_nothing_moves_when_the_pointer_does(server, tmp_path, fragment):
    with screen(server, tmp_path, 1366, link(design(SHARP)) if fragment == "refused" else "") as studio:
        if fragment == "refused":
            studio.until(lambda: studio.all(".cure"))
        else:
            studio.start(fragment)
            studio.until(lambda: "Accuracy" in studio.text(".numbers") and not studio.text(".empty"))
        studio.browser.execute_script(BOXES)
        for place in studio.browser.execute_script(CONTROLS):
            studio.mouse("mouseMoved", place, buttons=0)
            assert not studio.browser.execute_script(BOXES), place
        control = ".cure" if fragment == "refused" else ".bend"
        studio.mouse("mouseMoved", studio.center(control), buttons=0)
        studio.until(lambda: studio.all("g.ghost path, .bend .marks path"))
        assert not studio.browser.execute_script(BOXES)


def test_the_empty_view_in_space_has_a_reason(server, tmp_path):
    with screen(server, tmp_path, 1366) as studio:
        assert studio.text(".empty").startswith("The bent strip is shown here")
        studio.start("arch")
        studio.until(lambda: not studio.text(".empty"))
        studio.open(f"{server.address}#{link(design(SHARP))}")
        studio.browser.refresh()
        studio.until(lambda: "Point at a change" in studio.text(".empty"))
        empty = studio.scene()
        studio.mouse("mouseMoved", studio.center(".cure"), buttons=0)
        strip = studio.until(lambda: not studio.text(".empty") and studio.scene())
        assert strip != empty
        studio.mouse("mouseMoved", studio.center(".plane > svg"), buttons=0)
        studio.until(lambda: "cannot be made" in studio.text(".empty") and studio.scene() != strip)


def test_settings_with_short_names_are_explained(server, tmp_path, width):
    with screen(server, tmp_path, width) as studio:
        studio.start("arch")
        studio.tool("nearest")
        studio.until(lambda: studio.all("#field-limits-ratio"))
        studio.all(".rest summary")[0].click()
        for name in ("limits-ratio", "limits-margin", "section"):
            (help_text,) = studio.all(f".field:has(> #field-{name}) > .help")
            assert help_text.is_displayed()
            assert help_text.text.endswith(".")


def test_the_language_can_be_chosen(server, tmp_path, width):
    with screen(server, tmp_path, width) as studio:
        studio.start("arch")
        assert is_in_view(studio, "header > select")
        studio.choose("header > select", "de")
        studio.until(lambda: studio.verdict() == "Machbar")
        assert len(studio.all("g.points circle")) == 9
        for typed in ("30.5", "31,5"):
            studio.type("#field-max_width", typed)
            studio.until(lambda typed=typed: value(studio) == typed.replace(".", ","))
        studio.choose("header > select", "en")
        studio.until(lambda: value(studio) == "31.5")


def value(studio):
    return studio.all("#field-max_width")[0].get_attribute("value")


TEXTS = """
const least = arguments[0], shown = [...document.querySelectorAll(".elastica-studio *")];
const words = one => [...one.childNodes].some(({ nodeType, data }) => nodeType === 3 && data.trim());
const scale = one => (one.closest("svg") ? one.getScreenCTM().a : 1);
const isSmall = one => words(one) && parseFloat(getComputedStyle(one).fontSize) * scale(one) < least - 0.01;
const isHidden = one => !one.checkVisibility() || getComputedStyle(one).clipPath !== "none" || one.closest("svg");
const isCut = one => !isHidden(one) && one.clientWidth && one.scrollWidth > one.clientWidth + 1;
const isOutside = one => !isHidden(one) && one.getBoundingClientRect().right > innerWidth + 1;
return [one => one.checkVisibility() && isSmall(one), isCut, isOutside]
  .map(fault => shown.filter(fault).map(one => one.outerHTML.slice(0, 80)));
"""
"""Start of the elements with small letters, with contents wider than themselves, and outside the window."""


@pytest.mark.parametrize("language", ["en", "de", "zh"])
def test_texts_are_whole_and_large_enough(server, tmp_path, width, language):
    """At least 12 px on a desk and 14 px on a phone; nothing is wider than its place."""
    with screen(server, tmp_path, width, language=language) as studio:
        for name in ("lamp", "arch"):
            studio.start(name)
            studio.until(lambda: not studio.text(".empty"))
            studio.tool("nearest")
            studio.until(lambda: studio.all("#field-limits-ratio"))
            studio.all(".rest summary")[0].click()
            studio.mouse("mouseMoved", studio.center(".bend input"), buttons=0)
            assert studio.browser.execute_script(TEXTS, 12 if width > 900 else 14) == [[], [], []]


def test_the_slider_has_marks(server, tmp_path, width):
    with screen(server, tmp_path, width) as studio:
        studio.start("arch")
        assert studio.text(".bend .marks").split() == ["flat", "as", "drawn"]
        studio.browser.execute_script("document.querySelector('.bend').scrollIntoView()")
        x, y, wide, high = studio.box(".bend input")
        studio.mouse("mouseMoved", (x + 0.9 * wide, y + high / 2), buttons=0)
        studio.until(lambda: studio.all(".bend .marks path"))
        assert studio.box(".bend input") == [x, y, wide, high]  # the slider does not move under the pointer
        studio.press((x + 0.9 * wide, y + high / 2))
        studio.until(lambda: "N mm" in studio.text(".forces"))
        assert studio.text(".bend .marks").count(" N") == 3
        assert len(studio.all(".bend .marks path")) > 30
        studio.click("as drawn")
        studio.until(lambda: "400 mm" in studio.text(".forces"))


def test_files_that_cannot_be_written_are_explained(server, tmp_path, width):
    with screen(server, tmp_path, width) as studio:
        studio.browser.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": WITHOUT_KERNEL})
        studio.open(server.address)
        studio.start("arch")
        studio.all(".downloads summary")[0].click()
        assert not studio.all("[data-kind=step]")
        assert "Not available: STEP. To get it: pip install build123d" in studio.text(".downloads p")
        assert is_in_view(studio, ".downloads p")


BEZIER = """<svg xmlns="http://www.w3.org/2000/svg" width="297mm" height="210mm" viewBox="0 0 297 210">
<path fill="none" stroke="#000" d="m 20,150 c 30,-60 90,-60 120,0 20,40 60,50 90,30"/></svg>"""


def is_outside(studio):
    (x, y, wide, high), count = studio.box(".plane > svg"), len(studio.all("g.points circle"))
    places = np.array([studio.point(k + 1) for k in range(count)])
    return bool((places < (x, y)).any() or (places > (x + wide, y + high)).any())


def test_a_smooth_joint_of_an_opened_file_stays_smooth(server, tmp_path, width):
    (tmp_path / "wave.svg").write_text(BEZIER)
    with screen(server, tmp_path, width) as studio:
        studio.start("arch")
        studio.press(studio.point(2))
        studio.until(lambda: studio.all(".point:not([hidden])"))
        studio.drop(tmp_path / "wave.svg")
        studio.until(lambda: studio.text(".numbers dd").startswith("210.0 x 85.0 mm"))
        assert not studio.all(".point:not([hidden])")
        assert studio.verdict() == "It can be made"  # smoothed by less than a cut is wide
        studio.until(lambda: not is_outside(studio))
        handle, before = studio.point(3), studio.shape("points")
        studio.press(handle, (4, -4), (8, -8))
        studio.until(lambda: studio.shape("points") != before and studio.shape("strip"))
        one, joint, other = (studio.point(k) for k in (3, 4, 5))
        a, b = one - joint, other - joint
        assert abs(a[0] * b[1] - a[1] * b[0]) < 0.02 * np.hypot(*a) * np.hypot(*b)
        studio.until(lambda: "…" not in studio.text(".told"))
        assert "corner" not in studio.text(".verdict")
        assert studio.download("dxf", "wave.dxf").stat().st_size > 1000


def test_copies_offer_their_kit_their_sheet_and_two_plates(server, tmp_path, width):
    points = [[150, -120], [215, -35], [248, 95], [215, 225], [150, 310]]
    lamp = design(points, sheet="birch-plywood-3", max_width=30, patterns=[{"rotate": {"count": 10}}])
    with screen(server, tmp_path, width, link(lamp | {"rings": {"sheet": "mdf-3"}})) as studio:

        def kinds():
            return [one.get_attribute("data-kind") for one in studio.all(".downloads button")]

        studio.until(lambda: studio.verdict() == "It can be made")
        studio.all("#whole")[0].click()
        studio.until(lambda: studio.all(".cure"))
        assert studio.verdict() == "Read the warnings before you cut"
        assert kinds()[0] == "kit"
        assert "DXF, one strip" in [
            one.get_attribute("textContent") for one in studio.all(".downloads button")
        ]
        studio.type("#field-sheet_size", "300 x 200")
        studio.until(lambda: "Use a larger sheet (“sheet size”)" in studio.text(".verdict"))
        assert studio.text(".told").count("larger sheet") == 1
        assert studio.all("[data-kind=kit]")[0].get_property("disabled")
        studio.all(".downloads summary")[0].click()
        assert studio.text(".downloads .reason") == "Not available: It cannot be made"
        studio.type("#field-sheet_size", "1200, 600")
        studio.until(lambda: studio.all(".cure"))
        assert not studio.all("[data-kind=kit]")[0].get_property("disabled")
        studio.all(".cure")[0].click()
        studio.until(lambda: studio.verdict() == "It can be made" and "14 pieces" in studio.text(".told"))
        studio.type("#field-gap", "60")
        scene = studio.until(lambda: studio.verdict() == "It cannot be made" and studio.scene())
        studio.all("#whole")[0].click()
        studio.until(lambda: studio.scene() != scene)  # the copies were still shown


def test_a_held_point_is_said_to_be_stopped(server, tmp_path, width):
    with screen(server, tmp_path, width) as studio:
        studio.start("arch")
        studio.tool("keep")
        at = studio.point(5)
        studio.mouse("mouseMoved", at, buttons=0)
        studio.mouse("mousePressed", at, clickCount=1)
        for k in range(1, 9):
            studio.mouse("mouseMoved", at + np.array([0, -10 * k]))
        studio.until(lambda: studio.text(".said").startswith("Stopped:"))
        assert studio.verdict() == "It can be made"
        studio.mouse("mouseReleased", at + np.array([0, -80]), clickCount=1)
        studio.until(lambda: not studio.text(".said") and "…" not in studio.text(".told"))
        assert studio.verdict() == "It can be made"  # not above the strain limit


def test_the_view_fits_again_after_undo_and_when_the_bent_strip_leaves_it(server, tmp_path, width):
    with screen(server, tmp_path, width, link(design(SHARP))) as studio:
        studio.until(lambda: studio.all(".cure"))
        span = np.hypot(*(studio.point(1) - studio.point(7)))
        (larger,) = (one for one in studio.all(".cure") if one.text.startswith("Draw the curve"))
        larger.click()
        studio.until(lambda: not studio.all(".verdict.no"))
        studio.tool("undo")
        studio.until(lambda: studio.all(".verdict.no"))
        assert np.hypot(*(studio.point(1) - studio.point(7))) == pytest.approx(span, rel=0.05)

        studio.start("arch")
        studio.until(lambda: studio.verdict() == "It can be made" and "…" not in studio.text(".told"))
        studio.browser.execute_script("document.querySelector('.bend').scrollIntoView()")
        x, y, wide, high = studio.box(".bend input")
        studio.mouse("mouseMoved", (x + 0.9 * wide, y + high / 2), buttons=0)
        studio.press((x + 0.1 * wide, y + high / 2))
        studio.until(lambda: "does not snap" in studio.text(".bend .marks"))
        x, _, wide, _ = studio.box(".plane > svg")
        left, _, strip, _ = studio.box("g.strip")
        assert left >= x
        assert left + strip <= x + wide


def test_an_empty_drawing_keeps_sheet_and_copies(server, tmp_path, width):
    with screen(server, tmp_path, width) as studio:
        studio.start("lamp")
        studio.until(lambda: "16 pieces" in studio.text(".told"))
        studio.start("empty")
        assert studio.all("#field-sheet")[0].get_property("value") == "polypropylene-0.8"
        assert studio.all("#field-Number-of-strips-around-the-axis")[0].get_property("value") == "12"
        x, _, wide, _ = studio.box(".plane > svg")
        assert x < studio.center("g.axis path")[0] < x + wide


def test_the_curve_stays_when_a_setting_is_refused(server, tmp_path, width):
    with screen(server, tmp_path, width) as studio:
        studio.start("arch")
        studio.type("#field-max_width", "-3")
        studio.until(lambda: studio.verdict() == "It cannot be made")
        assert len(studio.shape("drawn")) > 1000
        values = studio.all("#field-ends option[value=value]")
        assert all(one.get_property("hidden") for one in values)


def test_every_point_of_a_curve_can_be_dragged(server, tmp_path, width):
    with screen(server, tmp_path, width) as studio:
        studio.start("bow")
        for k in range(1, 6):
            before = studio.shape("points")
            studio.press(studio.point(k), (0, -3))
            studio.until(lambda before=before: studio.shape("points") != before)
        assert not studio.logged()


@pytest.mark.parametrize("language", ["en", "de", "zh"])
def test_all_rows_are_in_sight_on_a_small_laptop(server, tmp_path, language):
    """Also beside a refusal of the whole model."""
    model = design(patterns=[{"rotate": {"count": 3, "point": [200, 0, 0]}}], base={"sheet": "mdf-3"})
    for drawn in (design(), model):
        with screen(server, tmp_path, 1366, link(drawn), language) as studio:
            studio.until(lambda: len(studio.all(".numbers dd")) >= 5)
            room = "const e = document.querySelector('.numbers'); return e.scrollHeight - e.clientHeight"
            assert studio.browser.execute_script(room) == 0
