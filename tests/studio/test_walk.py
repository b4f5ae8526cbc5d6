"""Walks through the studio in Chromium, by mouse and keyboard; the long ones are a campaign."""

import re
import statistics
import subprocess
import sys
import time
import tomllib
from math import sin
from zipfile import ZipFile

import ezdxf
import numpy as np
import pytest

import elastica_cad as ec
from tests.house.stored_files import STORED
from tests.studio.browser import TIMED, chromium
from tests.studio.conftest import ARCH, design, link, linked, running, wave, without_command

CURVE = [(0.12, 0.75), (0.2, 0.6), (0.3, 0.25), (0.5, 0.15), (0.7, 0.25), (0.8, 0.6), (0.88, 0.75)]
"""Places on the drawing, in shares of its size."""


def drawn(studio, places):
    x, y, wide, high = studio.box(".plane > svg")
    for across, down in places:
        studio.press((x + wide * across, y + high * down))


def by_command(design, folder):
    """The cutting file that the command line makes of the same request."""
    curve, (strip,) = design["strips"][0]["curve"], design["strips"]
    ec.write_curves([ec.PlaneCurve.spline(curve["spline"], curve["degree"])], folder / "strip.json")
    words = [
        "strip",
        "strip.json",
        "--sheet",
        design["sheet"],
        "--max-width",
        design["max_width"],
        "--label",
        strip["label"],
    ]
    words += ["--gravity"] if design.get("gravity") else []
    command = [
        sys.executable,
        "-m",
        "elastica_cad",
        *map(str, words),
        "--no-step",
        "--no-pictures",
        "-o",
        "out",
    ]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return without_command((folder / "out" / "strip.dxf").read_bytes())


def test_from_an_empty_drawing_to_the_cutting_file(server, tmp_path):
    with chromium(tmp_path) as studio:
        studio.open(server.address)
        assert "token" not in studio.browser.current_url
        drawn(studio, CURVE)
        studio.until(lambda: studio.verdict().startswith("It can be made"))

        before = studio.shape()
        studio.press(studio.point(4), *((k, k / 2) for k in range(1, 20)))
        studio.until(lambda: studio.shape() not in ("", before))

        scene = studio.scene()
        studio.press(studio.center(".scene canvas"), (60, 20))
        studio.until(lambda: studio.scene() != scene)

        design = tomllib.loads(studio.download("design", "A1.toml").read_text())
        boxes = [float(one.get_attribute("value")) for one in studio.all(".point input")]
        assert boxes == pytest.approx(design["strips"][0]["curve"]["spline"][3], abs=1e-3)
        assert studio.download("dxf", "A1.dxf").read_bytes() == by_command(design, tmp_path)
        assert studio.logged() == []


@pytest.mark.campaign
def test_all_that_a_page_can_do(server, tmp_path):
    with chromium(tmp_path) as studio:
        studio.open(server.address)
        studio.start("arch")
        for _ in range(10):
            studio.press(studio.point(5), *((9 * sin(k), k / 3) for k in range(29, -1, -1)))
        studio.until(lambda: "It can" in studio.verdict())

        studio.all(".rest summary")[0].click()
        for field, value in (("sheet", "pom-1"), ("gravity", "true")):
            result = studio.text(".numbers")
            studio.choose(f"#field-{field}", value)
            studio.until(lambda result=result: studio.text(".numbers") != result)
        design = tomllib.loads(studio.download("design", "arch.toml").read_text())
        assert (design["sheet"], design["gravity"]) == ("pom-1", True)

        studio.press(studio.point(2), (0, -90))
        studio.until(lambda: studio.verdict() == "It cannot be made")
        studio.click("Nearest curve", ".tools button")
        studio.until(lambda: studio.verdict().startswith("It can be made"))
        assert len(studio.all("g.points circle")) == 9

        shape = studio.shape()
        studio.all(".bend input")[0].send_keys("\ue010")  # End: pressed together
        studio.until(lambda: " N mm" in studio.text(".forces"))
        studio.until(lambda: studio.shape() != shape)
        for _ in range(3):
            studio.click("Undo")
        assert len(studio.all("g.points circle")) == 9


def grey(studio, field):
    """Whether a field is grey, and its value."""
    (one,) = studio.all(f"#field-{field}")
    return one.get_property("disabled"), one.get_attribute("value")


UNCHOSEN = [
    ("style", "1", {"width": "50", "columns": "3"}),
    ("ends", "0", {"length": "25", "corner_radius": "2"}),
    ("limits", "0", {"ratio": "4", "margin": "2"}),
    ("keep", "0", {"symmetry": "mirror", "points": "60; 200"}),
    ("loads", "0", {"alpha": "2"}),
    ("shop", "0", {"least_width": "3"}),
    ("tolerance", "0", {"kerf": "0.1"}),
    ("section", "0", {"limits": "0.4; 2", "width": "20"}),
]
"""Fields, a kind of their value, and values of that kind."""


def test_values_of_a_kind_not_chosen_are_grey_and_come_back(server, tmp_path):
    with chromium(tmp_path) as studio:
        start = design(gravity=True)
        studio.open(f"{server.address}#{link(start)}")
        studio.until(lambda: studio.verdict() == "It can be made")
        size = studio.text(".numbers dd").partition(" g")[0]
        studio.all(".rest summary")[0].click()
        for field, kind, values in UNCHOSEN:
            studio.choose(f"#field-{field}", kind)
            for name, value in values.items():
                (one,) = studio.all(f"#field-{field}-{name}")
                put = studio.choose if one.tag_name == "select" else studio.type
                put(f"#field-{field}-{name}", value)
                assert grey(studio, f"{field}-{name}") == (False, value)
            studio.choose(f"#field-{field}", "0" if field == "style" else "")
            assert {name: grey(studio, f"{field}-{name}") for name in values} == {
                name: (True, value) for name, value in values.items()
            }
        plain = start | {"style": {"kind": "plain"}}
        studio.until(lambda: linked(studio.browser.current_url) == plain)
        studio.until(lambda: studio.text(".numbers dd").startswith(size))
        assert studio.verdict() == "It can be made"

        studio.browser.refresh()
        studio.until(lambda: studio.verdict() == "It can be made")
        studio.all(".rest summary")[0].click()
        for field, kind, values in UNCHOSEN:
            studio.choose(f"#field-{field}", kind)
            assert {name: grey(studio, f"{field}-{name}") for name in values} == {
                name: (False, value) for name, value in values.items()
            }


def test_what_a_section_or_limits_replace_is_grey_and_comes_back(server, tmp_path):
    with chromium(tmp_path) as studio:
        studio.open(server.address)
        studio.start("arch")
        studio.all(".rest summary")[0].click()
        studio.type("#field-samples", "120")
        size = studio.until(lambda: studio.text(".numbers dd")).partition(" g")[0]
        studio.choose("#field-section", "0")
        studio.until(lambda: grey(studio, "max_width")[0])
        assert grey(studio, "max_width") == (True, "40")
        assert grey(studio, "min_width") == grey(studio, "compensate") == (True, "")
        assert grey(studio, "style")[0]
        studio.type("#field-section-limits", "0.4; 2")
        studio.type("#field-section-width", "20")
        studio.until(lambda: "20 mm wide" in studio.text(".numbers dd"))
        design = tomllib.loads(studio.download("design", "arch.toml").read_text())
        assert "max_width" not in design
        studio.choose("#field-section", "")
        studio.until(lambda: studio.text(".numbers dd").startswith(size))
        assert grey(studio, "max_width") == (False, "40")

        studio.tool("nearest")
        studio.until(lambda: grey(studio, "samples") == (True, "120"))
        studio.until(lambda: studio.verdict() == "It can be made")
        studio.type("#field-limits-ratio", "5")
        studio.tool("nearest")
        studio.until(lambda: grey(studio, "samples") == (False, "120"))
        assert grey(studio, "limits-ratio") == (True, "5")
        studio.tool("nearest")
        assert grey(studio, "limits-ratio") == (False, "5")


def test_a_change_after_a_refusal_is_shown_applied_and_undone(server, tmp_path):
    """Pointing at the button shows the strip over the drawn curve, a click applies it, and one undo restores it."""
    with chromium(tmp_path) as studio:
        studio.open(f"{server.address}#{link(wave())}")
        titles = [button.text for button in studio.until(lambda: studio.all(".cure"))]
        assert titles[0].startswith("Rest the strip on a rail at 197 mm.\nthe curve as drawn, 78 %")
        refused, place = studio.shape(), studio.center(".cure:nth-of-type(1)")
        studio.mouse("mouseMoved", place, buttons=0)
        studio.until(lambda: studio.shape() != refused and studio.shape("ghost") and studio.shape("elements"))
        assert studio.verdict() == "It cannot be made"
        studio.mouse("mouseMoved", studio.center(".plane > svg"), buttons=0)
        studio.until(lambda: studio.shape() == refused and not studio.shape("ghost"))
        studio.press(place)
        studio.until(lambda: studio.verdict().startswith("It can be made"))
        assert not studio.all(".cure")
        studio.click("Undo")
        studio.until(lambda: studio.verdict() == "It cannot be made" and studio.all(".cure"))


def test_the_verdict_is_of_the_whole_model_however_it_was_opened(server, tmp_path):
    """A lamp whose plates are too far apart for its tabs, as a link, loaded again, and as a file."""
    spline = [[60, 0], [75, 20], [110, 60], [110, 120], [75, 160], [60, 180]]
    lamp = design(spline, sheet="polypropylene-0.8", max_width=30, ends={"length": 24})
    lamp |= {"patterns": [{"rotate": {"count": 6}}], "rings": {"sheet": "mdf-3", "gap": 20}}

    def is_refused():
        return studio.verdict() and "does not reach through the second plate" in studio.text(".verdict")

    with chromium(tmp_path) as studio:
        studio.open(f"{server.address}#{link(lamp)}")
        studio.until(is_refused)
        studio.browser.refresh()
        studio.until(is_refused)
        studio.all("#whole")[0].click()  # shows the strip alone, which is part of the model nevertheless
        studio.until(lambda: not studio.text(".said"))
        assert is_refused()
        path = studio.download("design", "arch.toml")
        studio.start("arch")
        assert studio.verdict() == "It can be made"
        studio.all("input[type=file]")[0].send_keys(str(path))
        studio.until(is_refused)


@pytest.mark.campaign
def test_the_slider_is_judged_in_the_words_of_the_report(server, tmp_path):
    near_the_limit = design(np.divide(ARCH, 1.5).tolist(), max_width=25)
    with chromium(tmp_path) as studio:
        studio.open(f"{server.address}#{link(near_the_limit)}")
        studio.until(
            lambda: studio.verdict() == "It can be made" and "allows 0.87 %" in studio.text(".numbers")
        )
        drawn = studio.text(".numbers")
        studio.all(".bend input")[0].send_keys("\ue010")  # End: pressed together
        studio.until(lambda: studio.verdict() == "Read the warnings before you bend it this far")
        assert re.search(r"The strain is 1\.\d+ % at \d+ mm .* allows 0\.87 %", studio.text(".verdict"))
        assert "Strain" not in studio.text(".numbers")
        studio.click("as drawn")
        studio.until(lambda: studio.verdict() == "It can be made")
        studio.until(lambda: studio.text(".numbers") == drawn)


@pytest.mark.campaign
def test_rails_ties_and_loads_are_set_on_the_curve(server, tmp_path):
    """A refused wave gets the rail of a button; a tie, a force and a mass are set by mouse, moved and typed."""
    with chromium(tmp_path) as studio:
        studio.open(f"{server.address}#{link(wave())}")
        studio.until(lambda: studio.all(".cure"))[0].click()
        studio.until(lambda: studio.verdict().startswith("It can be made"))
        rail = studio.center("g.elements .rail circle")
        pushed = studio.text("g.elements .rail text")
        studio.press(rail, (4, 0), (12, 0))
        studio.until(
            lambda: "from the start pushes" in studio.text(".numbers") and studio.text(".numbers") != pushed
        )

        for noun, at, ways in (
            ("tie", np.add(studio.point(2), (0, 40)), [studio.point(6) - studio.point(2)]),
            ("point force", np.add(rail, (-40, -10)), []),
            ("point mass", np.add(rail, (60, -10)), []),
        ):
            studio.all(".holding summary")[0].click()
            studio.all(f"[data-put='{noun}']")[0].click()
            studio.press(at, *ways)
            studio.until(lambda noun=noun: studio.all(f"g.elements .{noun.replace(' ', '-')}"))
        studio.type("#field-loads-0-force", "0; -0.05")
        studio.until(lambda: "0.05 N" in studio.shape("elements"))

        before = tomllib.loads(studio.download("design", "arch.toml").read_text())
        (tmp_path / "arch.toml").unlink()
        studio.press(studio.point(7), (6, 0), (20, 0))
        time.sleep(1)  # the answer to the last move
        after = tomllib.loads(studio.download("design", "arch.toml").read_text())
        length = [
            ec.PlaneCurve.spline(one["strips"][0]["curve"]["spline"], degree=5).length
            for one in (before, after)
        ]
        tie, moved = before["strips"][0]["between"][1], after["strips"][0]["between"][1]
        assert moved["end"] / length[1] == pytest.approx(tie["end"] / length[0], abs=1e-6)
        assert after["gravity"]
        (tmp_path / "arch.toml").unlink()
        packed = studio.until(lambda: studio.browser.current_url.partition("#")[2])
    with chromium(tmp_path) as fresh:
        fresh.open(f"{server.address}#{packed}")
        fresh.until(lambda: len(fresh.all("g.elements > g")) == 4)


@pytest.mark.campaign
def test_a_dragged_point_stops_at_the_border_of_what_can_be_made(server, tmp_path):
    with chromium(tmp_path) as studio:
        studio.open(server.address)
        studio.start("arch")
        studio.all("[data-do=keep]")[0].click()
        rng, stopped = np.random.default_rng(71), 0
        for _ in range(20):
            k, way = int(rng.integers(2, 9)), rng.normal(size=2) * 60
            place = studio.point(k)
            studio.press(place, *(way * part for part in np.linspace(0.1, 1, 10)))
            studio.until(lambda: not studio.all(".plane > [aria-busy=true]"))
            studio.until(lambda: studio.text(".numbers").count("…") == 0)
            assert studio.verdict().startswith("It can be made")
            stopped += np.hypot(*(studio.point(k) - place - way)) > 3
            dragged = studio.shape("points")
            studio.tool("undo")  # each drag starts from the arch, not from the border
            studio.until(lambda dragged=dragged: studio.shape("points") != dragged)
        assert 3 < stopped < 20
        studio.all("[data-do=keep]")[0].click()
        studio.press(studio.point(2), (0, -150))
        studio.until(lambda: studio.verdict() == "It cannot be made")


FIVE = [(0.15, 0.8), (0.3, 0.45), (0.5, 0.3), (0.7, 0.45), (0.85, 0.8)]
"""An arch of five points, in shares of the drawing."""


def set_on_curve(studio, noun, place):
    studio.all(".holding summary")[0].click()
    studio.all(f"[data-put='{noun}']")[0].click()
    studio.press(place)
    studio.until(lambda: studio.text(".settings").count(f"{noun} 1") or "combined" in studio.verdict())


@pytest.mark.campaign
@pytest.mark.parametrize("noun", ["rail", "pin", "point mass", "point force"])
def test_a_nearest_curve_or_what_holds_the_strip(server, tmp_path, noun):
    """Both cannot be combined: each of two buttons takes one of them away."""
    with chromium(tmp_path) as studio:
        studio.open(server.address)
        drawn(studio, FIVE)
        studio.until(lambda: studio.verdict() == "It can be made")
        studio.tool("draw")
        down = studio.point(1) - studio.point(3)
        studio.press(studio.point(3), (0, down[1] / 2), (0, 1.1 * down[1]))
        nearest = studio.until(lambda: [one for one in studio.all(".cure") if "Take the nearest" in one.text])
        nearest[0].click()
        studio.until(lambda: studio.verdict() == "It can be made")
        set_on_curve(studio, noun, studio.center("g.strip path:nth-child(1)"))
        studio.until(lambda: studio.verdict() == "These settings cannot be combined" and studio.all(".cure"))
        off, rid = studio.all(".cure")
        assert off.text.startswith("Switch the nearest curve off.")
        assert rid.text.startswith("Remove the rails, pins, ties and loads.\n")
        assert "strips[" not in studio.text(".told")
        rid.click()
        studio.until(lambda: studio.verdict() == "It can be made" and not studio.all(".cure"))
        studio.click("Undo")
        studio.until(lambda: studio.all(".cure"))[0].click()
        studio.until(lambda: "combined" not in studio.verdict() and "…" not in studio.text(".told"))
        assert studio.all("[data-do=nearest]")[0].get_attribute("aria-pressed") == "false"
        assert "nearest" not in studio.text(".told")


@pytest.mark.campaign
def test_without_two_states_the_design_is_as_before(server, tmp_path):
    with chromium(tmp_path) as studio:
        studio.open(server.address)
        studio.start("lamp")
        studio.until(lambda: "16 pieces" in studio.text(".told"))
        before = tomllib.loads(studio.download("design", "lamp.toml").read_text())
        (tmp_path / "lamp.toml").unlink()
        studio.tool("pair")
        studio.until(lambda: "State" in studio.text(".settings") and studio.verdict() == "It cannot be made")
        assert studio.shape("drawn"), "the curve is drawn, though the part is refused"
        assert studio.shape("ghost")
        studio.browser.refresh()
        studio.until(lambda: studio.verdict() == "It cannot be made")
        studio.press(studio.point(2), (5, 5))
        studio.tool("pair")
        studio.until(lambda: studio.verdict() == "It can be made")
        assert tomllib.loads(studio.download("design", "lamp.toml").read_text()) == before
        studio.click("Undo")
        studio.until(lambda: studio.all("[data-do=pair]")[0].get_attribute("aria-pressed") == "true")


@pytest.mark.campaign
def test_a_part_of_two_states_that_was_opened_becomes_its_first_strip(server, tmp_path):
    curve = {"spline": ARCH, "degree": 4}
    pair = {"schema": 1, "pair": {"sheet": "pom-1", "first": curve, "second": curve}}
    with chromium(tmp_path) as studio:
        studio.open(f"{server.address}#{link(pair)}")
        studio.until(studio.verdict)
        studio.tool("pair")
        studio.until(lambda: studio.verdict() and studio.all("#field-sheet"))
        assert studio.all("#field-sheet")[0].get_property("value") == "pom-1"
        assert len(studio.all("g.points circle")) == len(ARCH)


@pytest.mark.campaign
def test_a_clicked_point_is_added_only_if_the_strip_stays_possible(server, tmp_path):
    with chromium(tmp_path) as studio:
        studio.open(server.address)
        drawn(studio, FIVE)
        studio.until(lambda: studio.verdict() == "It can be made")
        studio.tool("keep")
        drawn(studio, [(0.4, 0.6)])  # back into the arch
        studio.until(lambda: studio.text(".said").startswith("Not changed:"))
        assert (len(studio.all("g.points circle")), studio.verdict()) == (5, "It can be made")
        drawn(studio, [(0.95, 0.95)])  # farther out
        studio.until(lambda: len(studio.all("g.points circle")) == 6)
        studio.until(lambda: studio.verdict() == "It can be made" and not studio.text(".said"))


@pytest.mark.campaign
def test_holders_that_no_longer_fit_are_said_to_be_unchecked(server, tmp_path):
    with chromium(tmp_path) as studio:
        studio.open(server.address)
        studio.start("lamp")
        studio.until(lambda: "16 pieces" in studio.text(".told"))
        studio.tool("keep")
        studio.press(studio.point(4), *((40 * k, 0) for k in range(1, 9)))
        studio.until(lambda: studio.verdict() == "It cannot be made")
        assert "checks each strip alone" in studio.text(".verdict")
        studio.tool("keep")
        studio.until(lambda: "checks each strip alone" not in studio.text(".verdict"))


@pytest.mark.campaign
def test_by_finger_a_curve_is_drawn_moved_and_looked_at(server, tmp_path):
    with chromium(tmp_path, (500, 900)) as studio:
        studio.open(server.address)
        studio.browser.execute_cdp_cmd(
            "Emulation.setTouchEmulationEnabled", {"enabled": True, "maxTouchPoints": 2}
        )
        corner, size = np.split(np.array(studio.box(".plane > svg")), 2)
        for place in CURVE:
            studio.touch([corner + size * place])
        studio.until(lambda: studio.verdict().startswith("It can be made"))
        place = studio.point(1)
        studio.touch([corner + size * 0.5 + (3 * k, 9 * k) for k in range(8)])  # a swipe moves the view
        assert len(studio.all("g.points circle")) == len(CURVE)
        assert studio.point(1) == pytest.approx(np.add(place, (21, 63)), abs=12)

        before, place = studio.shape(), studio.point(4)
        studio.touch([place, np.add(place, (4, 12)), np.add(place, (8, 24))])
        studio.until(lambda: studio.shape() != before)
        assert studio.point(4) == pytest.approx(np.add(place, (8, 24)), abs=1)

        wide, low = studio.point(7) - studio.point(1), corner + size * (0.5, 0.5)
        studio.touch(*([np.add(low, (side * (20 + k), 0)) for k in range(0, 30, 3)] for side in (-1, 1)))
        assert len(studio.all("g.points circle")) == len(CURVE)
        assert np.hypot(*(studio.point(7) - studio.point(1))) > 1.5 * np.hypot(*wide)

        # over the picture of the bent strip, a finger scrolls the page upwards and turns the view sideways
        studio.browser.execute_script("document.querySelector('.space').scrollIntoView({block: 'center'})")
        scrolled = studio.browser.execute_script("return scrollY")
        low = studio.center(".scene")
        studio.touch([np.add(low, (0, 40 - 10 * k)) for k in range(12)])
        studio.until(lambda: studio.browser.execute_script("return scrollY") > scrolled)
        studio.browser.execute_script("document.querySelector('.space').scrollIntoView({block: 'center'})")
        seen, low = studio.scene(), studio.center(".scene")
        studio.touch([np.add(low, (10 * k - 60, 0)) for k in range(12)])
        studio.until(lambda: studio.scene() != seen)

        # beside the settings, the verdict is a line that leads back to it
        studio.browser.execute_script("document.querySelector('#field-max_width').scrollIntoView()")
        (line,) = studio.until(lambda: [one for one in studio.all(".sum") if one.is_displayed()])
        assert line.text == studio.verdict()
        line.click()
        studio.until(lambda: not line.is_displayed())


@pytest.mark.campaign
@pytest.mark.filterwarnings("ignore:The copy of curve 1 in arch.svg")
@pytest.mark.parametrize("kind", ["svg", "dxf", "csv"])
def test_a_file_is_dropped_on_the_drawing(server, tmp_path, kind):
    curve = ec.PlaneCurve.spline(ARCH)
    if kind == "csv":
        rows = curve.sample(200).position.tolist()
        (tmp_path / "arch.csv").write_text("".join(f"{x},{y}\n" for x, y in rows))
    else:
        ec.write_curves([curve], tmp_path / f"arch.{kind}")
    with chromium(tmp_path) as studio:
        studio.open(server.address)
        studio.drop(tmp_path / f"arch.{kind}")
        studio.until(lambda: studio.all(".yes, .care"))
        (left, bottom), (right, top) = curve.bounds
        read = studio.text(".numbers dd:nth-of-type(1)")
        assert read.startswith(f"{right - left:.1f} x {top - bottom:.1f} mm (unit ")
        length = float(studio.text(".numbers dd:nth-of-type(2)").partition(" mm")[0])
        assert length == pytest.approx(curve.length, rel=1e-3)
        studio.press(studio.point(3), (0, 15))
        studio.until(lambda: "Read" not in studio.text(".numbers dt"))


@pytest.mark.campaign
@pytest.mark.parametrize("path", sorted(STORED.glob("*/link.txt")), ids=lambda path: path.parent.name)
def test_a_link_of_an_earlier_version_is_opened(path, server, tmp_path):
    with chromium(tmp_path) as studio:
        studio.open(f"{server.address}#{path.read_text().strip()}")
        assert studio.until(lambda: studio.text(".numbers dd:nth-of-type(1)"))
        assert studio.all("g.strip path")


@pytest.mark.campaign
def test_the_address_alone_restores_the_design(server, tmp_path):
    with chromium(tmp_path) as studio:
        studio.open(server.address)
        studio.start("s-curve")
        length = studio.until(lambda: studio.text(".numbers dd:nth-of-type(1)"))
        fragment = studio.until(lambda: studio.browser.current_url.partition("#")[2])
    with chromium(tmp_path) as fresh:
        fresh.open(f"{server.address}#{fragment}")
        assert fresh.until(lambda: fresh.text(".numbers dd:nth-of-type(1)")) == length
        fresh.press(fresh.point(2), (5, 5))
        fresh.until(lambda: fresh.text(".numbers dd:nth-of-type(1)") != length)
        fresh.until(lambda: fragment not in fresh.browser.current_url)
        fresh.browser.refresh()
        fresh.until(lambda: fresh.all("g.strip path"))
        fresh.click("Undo")
        fresh.until(lambda: fresh.text(".numbers dd:nth-of-type(1)") == length)


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("language", "said"), [("de", "Machbar"), ("zh", "可以制作"), ("en", "It can be made")]
)
@pytest.mark.parametrize(
    ("size", "scheme"), [((1400, 1000), "light"), ((500, 900), "dark")], ids=["desk", "phone"]
)
def test_the_page_is_accessible_in_every_language(server, tmp_path, language, said, size, scheme):
    with chromium(tmp_path, size, language) as studio:
        features = [{"name": "prefers-color-scheme", "value": scheme}]
        studio.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": features})
        studio.open(server.address)
        studio.start("arch")
        assert studio.verdict() == said
        assert studio.complaints() == []
        assert studio.browser.execute_script("return document.documentElement.scrollWidth - innerWidth") <= 0
        studio.browser.execute_script("document.querySelector('g.points circle').focus()")
        shape = studio.shape()
        studio.browser.switch_to.active_element.send_keys("\ue013")  # Up
        studio.until(lambda: studio.shape() != shape)


@pytest.mark.campaign
def test_a_lamp_of_twelve_strips_from_an_empty_page(server, tmp_path):
    """In the words of the README: draw, set copies and rings, take the zip; within five minutes."""
    began = time.monotonic()
    with chromium(tmp_path) as studio:
        studio.open(server.address)
        drawn(studio, [(0.2, 0.9), (0.23, 0.8), (0.34, 0.65), (0.34, 0.35), (0.23, 0.2), (0.2, 0.1)])
        studio.until(lambda: studio.verdict() == "It can be made")
        studio.type("#field-Number-of-strips-around-the-axis", "12")
        studio.choose("#field-Holders", "rings")
        studio.until(lambda: "12 strips" in studio.text(".told") and "2 sheets" in studio.text(".told"))
        studio.until(
            lambda: studio.verdict() == "Read the warnings before you cut"
        )  # tabs rock in one thin ring
        path = studio.download("kit", "A1.zip")
    print(f"a lamp within {time.monotonic() - began:.0f} s")
    with ZipFile(path) as packed:
        names = packed.namelist()
        packed.extractall(tmp_path)
    sheets = [name for name in names if "/sheets/" in name and name.endswith(".dxf")]
    assert len(sheets) == 2
    assert all(len(ezdxf.readfile(tmp_path / name).modelspace()) for name in sheets)
    assert any(name.endswith("cut-list.csv") for name in names)


@pytest.mark.campaign
def test_what_holds_the_copies_is_part_of_the_verdict(server, tmp_path):
    """One ring lets strips tip, two hold them; where tabs do not reach the second, the verdict is red."""
    with chromium(tmp_path) as studio:
        studio.open(server.address)
        studio.start("lamp")
        studio.until(lambda: "16 pieces" in studio.text(".told"))
        assert studio.verdict() == "It can be made"
        studio.type("#field-gap", "20")
        studio.until(lambda: studio.verdict() == "It cannot be made")
        assert "does not reach through the second plate" in studio.text(".verdict")
        studio.type("#field-gap", "")
        studio.until(lambda: studio.verdict() == "Read the warnings before you cut")
        assert "14 pieces" in studio.text(".told")
        studio.type("#field-ends-length", "40")
        studio.type("#field-gap", "12")
        studio.until(lambda: studio.verdict() == "It can be made")


@pytest.mark.campaign
@pytest.mark.parametrize("language", ["en", "de", "zh"])
def test_all_that_is_needed_is_in_view(server, tmp_path, language):
    """At 1366 x 768: canvas, verdict, bent and flat strip no scrolling; tools in one row, menus in the window."""
    with chromium(tmp_path, (1366, 768), language) as studio:
        inside = studio.browser.execute_script("return [innerWidth, innerHeight]")
        studio.browser.set_window_size(2 * 1366 - inside[0], 2 * 768 - inside[1])
        studio.open(server.address)
        for name in ("arch", "lamp"):
            studio.start(name)
            studio.until(lambda: studio.all("g.strip path"))
            assert studio.browser.execute_script("return document.documentElement.scrollHeight") <= 768
            for selector, least in ((".plane", 280), (".space", 280), (".flat", 90), (".verdict", 40)):
                x, y, wide, high = studio.box(selector)
                assert min(x, y) >= 0, selector
                assert x + wide <= 1366, selector
                assert y + high <= 768, selector
                assert high >= least, selector
        tools = studio.browser.execute_script(
            "return [...document.querySelectorAll('.tools button:has(> .icon), .tools summary')]"
            ".filter(tool => tool.checkVisibility())"
            ".map(tool => [tool.getBoundingClientRect().top, tool.querySelector('svg') !== null, tool.innerText])"
        )
        assert len({top for top, _, _ in tools}) == 1
        assert all(icon and words for _, icon, words in tools)
        for menu in ("downloads", "holding"):
            studio.all(f".{menu} summary")[0].click()
            x, y, wide, high = studio.box(f".{menu} > div")
            assert x >= 0
            assert x + wide <= 1366
            assert y + high <= 768
            studio.press(studio.center(".plane > svg"))  # beside the menu
            assert not studio.all(".menu[open]")
            studio.all(f".{menu} summary")[0].click()
            studio.browser.switch_to.active_element.send_keys("\ue00c")  # Escape
            assert not studio.all(".menu[open]")
        sides = "const box = document.querySelector('.settings'); return [box.offsetHeight, box.clientHeight]"
        outer, inner = studio.browser.execute_script(sides)
        assert outer - inner <= 2  # no scroll bar along the bottom
        before = studio.box(".plane"), studio.box(".space")
        studio.type("#field-Number-of-strips-around-the-axis", "16")  # too many: a long verdict
        studio.until(lambda: studio.all(".verdict.no"))
        assert (studio.box(".plane"), studio.box(".space")) == before
        words = studio.text(".told")
        assert words.count(studio.all(".verdict p")[0].text) == 1
        studio.all(".verdict .link")[0].click()  # the setting that the verdict names
        assert studio.browser.switch_to.active_element.get_attribute("id") == "field-ignore_limits"
        studio.press(studio.point(2), (-300, 0))
        studio.until(lambda: studio.all(".no-strip"))
        assert (studio.box(".plane"), studio.box(".space")) == before


@pytest.mark.campaign
def test_the_end_of_the_server_is_reported_and_the_design_stays(tmp_path):
    with chromium(tmp_path) as studio:
        with running() as server:
            studio.open(server.address)
            studio.start("arch")
        studio.until(lambda: "server has stopped" in studio.text(".said"))
        assert len(studio.all("g.points circle")) == 9


@pytest.mark.campaign
def test_the_strip_follows_the_pointer(tmp_path, monkeypatch):
    """From pointer to painted strip, without compiled code: the numbers are told, a slow machine is no fault."""
    monkeypatch.setenv("ELASTICA_PURE", "1")
    with running() as server, chromium(tmp_path) as studio:
        studio.open(server.address)
        studio.start("arch")
        studio.browser.execute_script(TIMED)
        place = studio.point(5)
        studio.mouse("mousePressed", place, clickCount=1)
        for k in range(1, 301):
            seen = studio.browser.execute_script("return painted.length")
            studio.mouse("mouseMoved", (place[0] + 30 * sin(k / 9), place[1] + 20 * sin(k / 13)))
            studio.until(lambda: studio.browser.execute_script("return painted.length") > seen)  # noqa: B023
        times = sorted(studio.browser.execute_script("return painted"))
    median, late = statistics.median(times), times[int(0.95 * len(times))]
    print(f"\n{len(times)} moves: median {median:.0f} ms, 95 % {late:.0f} ms")


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("linked", "message"),
    [
        ({"strips": [1]}, "cannot be read"),
        ({"strips": [{"curve": {"spline": [3]}}]}, "cannot be read"),
        ({"pair": {"first": {"spline": {}}}, "strips": {}}, "cannot be read"),
        ({"revolution": {"curve": {"spline": [[10, 0], [[], 40]]}}}, "It cannot be made"),
        ({"max_width": [], "strips": [{"curve": {"spline": [["a"], [1], []]}}]}, "It cannot be made"),
    ],
)
def test_a_link_of_wrong_types_is_answered_by_a_sentence(server, tmp_path, linked, message):
    with chromium(tmp_path) as studio:
        studio.open(f"{server.address}#{link(linked)}")
        studio.until(lambda: message in studio.text(".told"))
        assert studio.logged() == []
