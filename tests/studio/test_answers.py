"""What the page is answered, without the server between."""

import asyncio
import json
import re
from itertools import count
from time import process_time

import ezdxf
import numpy as np
import pytest
import trimesh

import elastica_cad as ec
from elastica_cad.cli import main
from elastica_cad.mechanics import trials
from elastica_cad.mechanics.sheets import cut_sheets
from elastica_cad.strip.suggestions import suggest
from elastica_cad.strip.summary import strain_rows, strip_rows
from elastica_cad.web.answers import Download, answer, requested_spec, with_point_near, without_point
from elastica_cad.web.saved_design import compose_design, curve_table, open_design
from elastica_cad.web.vocabulary import page_words
from elastica_cad.web.worker import reply
from elastica_cad.web.workers import LONGEST_S, Workers
from tests.studio.conftest import ARCH, WAVE, design, wave, without_command

OFF_LINE = [(0, 0), (60, 80), (120, 100), (200, -60), (260, 50), (330, 0), (360, 50)]
ZIGZAG = [(0, 20), (60, 20), (120, 40), (180, -20), (240, 50), (300, -50)]
TWO_ARCS = {
    "spline": [[0, 0], [80, 90], [160, 0], [240, 90], [320, 0]], "degree": 2, "knots": [0, 0, 0, 1, 1, 2, 2, 2],
}  # fmt: skip
ARCHED = [[0, 0], [27, 0], [53, 24], [105, 24], [123, 0], [150, 0]]
LAMP = [[60, 0], [75, 20], [110, 60], [110, 120], [75, 160], [60, 180]]


def answer_to(do, **more):
    return answer({"do": do, "design": design(), **more})


def test_a_strip_is_the_one_that_python_makes():
    report, made = (
        answer_to("strip"),
        ec.make_strip(ec.PlaneCurve.spline(ARCH), "birch-plywood-0.8", max_width=40),
    )
    assert "refused" not in report
    assert report["length"] == pytest.approx(made.rod.length, abs=0.01)
    rows = [(row["label"], row["text"], row["details"], row["stops"]) for row in report["rows"]]
    assert rows == [(row.label, row.text, list(row.details), row.stops) for row in strip_rows(made)]
    assert max(report["shares"]) == pytest.approx(made.strain_verdict.used, rel=0.01)
    assert report["theorem"]["at"] == pytest.approx(made.rod.curve.inflections, abs=0.5)
    outer = [loop for layer in report["flat"] if layer["layer"] == "CUT_OUTER" for loop in layer["loops"]]
    assert np.ptp(outer[0], axis=0) == pytest.approx(np.ptp(made.outline.bounds, axis=0), abs=0.1)


def test_a_dragged_strip_is_checked_when_it_rests(monkeypatch):
    at_rest = {row["label"]: row["text"] for row in answer_to("strip")["rows"]}
    monkeypatch.setattr(ec.Strip, "held", None)
    monkeypatch.setattr(ec.Strip, "sideways", None)
    dragged = {row["label"]: row["text"] for row in answer_to("strip", live=True)["rows"]}
    assert dragged == at_rest | {"Stability": "…", "Accuracy": "…"}


SECTION = {"kind": "thickness", "limits": [0.4, 3], "width": 20}


@pytest.mark.parametrize(
    ("keys", "idle"),
    [
        (
            {"section": SECTION, "min_width": 3, "compensate": True},
            {"max_width", "min_width", "compensate", "slots", "style"},
        ),
        ({"limits": {"ratio": 5}, "samples": 120}, {"samples"}),
        ({"keep": {"ends": True}, "samples": 120}, {"samples"}),
    ],
)
def test_keys_without_effect_are_answered_as_if_they_were_not_there(keys, idle):
    given = {"sheet": "pom-1"} | keys
    acting = {key: value for key, value in design(**given).items() if key not in idle}
    told, without = (answer_to("strip", design=tables) for tables in (design(**given), acting))
    assert set(told["idle"]) == idle
    assert told == without
    assert "refused" not in told
    (strip,) = design()["strips"]
    in_the_strip = {"schema": 1, "strips": [strip | given | {"max_width": 40}]}
    assert answer_to("strip", design=in_the_strip)["rows"] == told["rows"]
    assert answer_to("file", design=design(**given), kind="dxf") == answer_to(
        "file", design=acting, kind="dxf"
    )
    assert answer_to("save", design=design(**given), copy=True) == answer_to("save", design=acting, copy=True)
    if "section" in given:
        slotted = strip | {"slots": [{"at": 90, "width": 1.2}], "style": {"kind": "perforated", "width": 50}}
        with_slot = answer_to("strip", design=design(**given, strips=[slotted]))
        assert with_slot == told
    other = design(**given, strips=[strip, strip | {"label": "A2", "section": SECTION}])
    assert answer_to("strip", design=other, strip=1).get("refused") is None


def test_the_place_of_the_push_is_grey_for_a_part_that_does_not_snap():
    """The ends of the first two curves are at the same places; the third curve is narrower."""
    first, second, narrow = (
        {"spline": [[x * wide, y * high] for x, y in ARCHED], "degree": 4}
        for wide, high in ((1, 1), (1, -0.8), (0.97, 1.2))
    )
    pair = {"sheet": "pom-2", "first": first, "least_thickness": 0.5, "ignore_limits": True}
    snaps, moves, without = (
        answer({"do": "pair", "design": {"schema": 1, "pair": pair | keys}})
        for keys in (
            {"second": second, "push_at": 50},
            {"second": narrow, "push_at": 50},
            {"second": narrow},
        )
    )
    assert (snaps["idle"], moves["idle"]) == ([], ["push_at"])
    assert moves == without


def test_the_aim_of_a_part_with_a_free_state_is_answered_as_if_it_were_not_there():
    first, second = ({"spline": [[0, 0], [30, y], [90, y], [120, 0]], "degree": 3} for y in (8, -8))
    pair = {"sheet": "pom-2", "first": first, "second": second, "least_thickness": 0.5, "ignore_limits": True}
    asked = {"schema": 1, "pair": pair | {"free": "first", "objective": "ratio"}}
    without = {"schema": 1, "pair": pair | {"free": "first"}}
    told = answer({"do": "pair", "design": asked})
    assert "objective" in told["idle"]
    assert told == answer({"do": "pair", "design": without})
    assert "refused" not in told
    assert answer({"do": "file", "kind": "dxf", "design": asked}) == answer(
        {"do": "file", "kind": "dxf", "design": without}
    )
    both = answer({"do": "pair", "design": {"schema": 1, "pair": pair | {"objective": "ratio"}}})
    assert "objective" not in both["idle"]


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", r"1 strip, 1 piece on 1 sheet, .* g, 2 printed blocks"),
        ("de", r"1 Streifen, 1 Teil auf 1 Platte, .* g, 2 gedruckte Halter"),
    ],
)
def test_one_strip_is_not_counted_in_the_plural(language, said):
    held = design(fixtures={})
    _, content = reply(json.dumps({"do": "model", "design": held, "language": language}))
    assert re.fullmatch(said, json.loads(content)["text"])


def test_rows_are_in_the_language_of_the_page():
    rows = json.loads(reply(json.dumps({"do": "strip", "design": design(), "language": "de"}).encode())[1])[
        "rows"
    ]
    assert [row["label"] for row in rows] == ["Größe", "Dehnung", "Stabilität", "Halten", "Genauigkeit"]
    text = " ".join(sentence for row in rows for sentence in (row["text"], *row["details"]))
    assert re.search(r"\d,\d mm lang", text)
    assert not re.search(r"\b(the|is|long|apart|about|at)\b", text), text


def test_a_request_that_takes_too_long_is_refused_in_the_language_of_the_page(monkeypatch):
    monkeypatch.setitem(LONGEST_S, "strip", 0.0)
    question = {"do": "strip", "id": 7, "design": design(), "language": "de"}

    async def first_answer():
        workers, answered = Workers(None), asyncio.get_running_loop().create_future()

        async def send(kind, content):
            answered.set_result(json.loads(content))

        workers.start()
        assert workers.request(1, question, json.dumps(question).encode(), send)
        found = await answered
        await workers.stop()
        return found

    found = asyncio.run(first_answer())
    assert (found["id"], found["do"]) == (7, "strip")
    assert found["refused"]["message"].startswith("Die Anfrage dauerte länger als 0 s.")


def test_a_curve_that_cannot_be_bent_is_shown_with_its_faults():
    report = answer({"do": "strip", "design": design(OFF_LINE)})
    assert report["refused"]["kind"] == "not realizable"
    assert len(report["theorem"]["off"]) >= 2
    assert len(report["drawn"]) > 100


def test_a_strip_that_feels_its_weight_needs_no_line():
    report = answer_to("strip")
    heavy = answer({"do": "strip", "design": design(gravity=True)})
    assert report["theorem"]["line"] is not None
    assert "refused" not in heavy
    assert heavy["theorem"]["line"] is None
    assert heavy["theorem"]["at"] == report["theorem"]["at"]


def test_straight_ends_are_tabs_on_the_page_too():
    first, last = [(x, 0) for x in (0, 20, 40, 60, 160)], [(x, 150) for x in (200, 300, 320, 340, 360)]
    knots = [*[0] * 4, *[1] * 3, *[3] * 3, *[4] * 4]
    drawn = design()
    drawn["strips"][0]["curve"] = curve_table(ec.PlaneCurve(knots, [*first, *last], 3))
    report = answer({"do": "strip", "design": drawn})
    assert "refused" not in report
    assert len(report["theorem"]["at"]) == 1


def test_the_nearest_curve_can_be_made():
    report = answer({"do": "strip", "design": design(OFF_LINE, limits=page_words()["nearest"])})
    assert "refused" not in report
    assert report["deviation"] > 0
    assert not any(row["stops"] for row in report["rows"])


def test_sheets_that_can_do_it_are_reported_apart():
    rows = {row["name"]: row for row in answer_to("sheets")["sheets"]}
    assert set(rows) == {sheet.name for sheet in cut_sheets()}
    assert rows["birch-plywood-0.8"]["fits"]
    assert not rows["acrylic-3"]["fits"]
    made = ec.StripSpec(ec.PlaneCurve.spline(ARCH), "acrylic-3", max_width=40, ignore_limits=True).make()
    assert rows["acrylic-3"]["used"] == pytest.approx(made.strain_verdict.used, abs=0.01)
    assert answer({"do": "sheets", "design": design(), "names": ["pom-1"]})["sheets"] == [rows["pom-1"]]


@pytest.mark.parametrize("keys", [{"thickness": 3}, {"max_width": 5}])
def test_the_place_of_a_refusal_is_on_the_curve(keys):
    report, curve = answer({"do": "strip", "design": design(**keys)}), ec.PlaneCurve.spline(ARCH)
    assert report["places"] == [
        pytest.approx(curve.at([report["refused"]["where"]["at"]]).position[0], abs=1e-3)
    ]


def test_a_strip_is_bent_from_flat_to_its_design_and_on():
    frames = answer_to("bend")["frames"]
    drawn = next(frame for frame in frames if frame["part"] == 1)
    flat = np.array(frames[0]["position"])
    away = np.diff(flat, axis=0)
    assert np.ptp(np.arctan2(away[:, 1], away[:, 0])) < 0.1
    assert drawn["position"][1] == [0, 0]
    assert frames[-1]["part"] > 1
    assert frames[-1]["force"] > 0


@pytest.mark.parametrize(
    "points", [[(0, 0), (40, 110), (130, 60), (220, 0)], [(220, 0), (130, 60), (40, 110), (0, 0)]]
)
def test_force_and_moment_beside_the_bar_are_the_larger_of_both_ends(points):
    drawn = design(strips=[{"label": "A1", "curve": curve_table(ec.PlaneCurve.spline(points, degree=3))}])
    strip = requested_spec(drawn).make()
    start, end = strip.bending_stiffness * np.abs(strip.rod.moment[[0, -1]])
    assert max(start, end) > 1.2 * min(start, end)
    shown = next(frame for frame in answer({"do": "bend", "design": drawn})["frames"] if frame["part"] == 1)
    assert shown["moment"] == pytest.approx(max(start, end), rel=1e-2)
    assert shown["force"] == pytest.approx(strip.bending_stiffness * np.hypot(*strip.rod.force[0]), rel=1e-2)


@pytest.mark.parametrize(("scale", "sheet"), [(1.5, "birch-plywood-0.8"), (2, "pom-1")])
def test_each_shape_of_the_slider_has_the_rows_of_the_report(scale, sheet):
    drawn = design(np.divide(ARCH, scale).tolist(), sheet=sheet, max_width=25)
    frames = answer({"do": "bend", "design": drawn})["frames"]
    made = requested_spec(drawn).make()
    (strain,) = strain_rows(made)
    shown = next(frame for frame in frames if frame["part"] == 1)
    assert [str(row["text"]) for row in shown["rows"]] == [str(strain.text)]
    beyond = [max(frame["shares"]) > 1 for frame in frames]
    assert 0 < sum(beyond) < len(frames)
    assert beyond == [frame["rows"][0]["stops"] for frame in frames]
    assert f"{made.sheet.name} allows" in str(frames[-1]["rows"][0]["text"])


def test_a_shape_that_snaps_has_the_row_on_its_stability():
    points = [(0, 0), (50, 120), (100, 144), (150, 120), (200, 0)]
    turned_over = design(points, sheet="spring-steel-0.2", max_width=15, natural_curvature=-1 / 60)
    frames = answer({"do": "bend", "design": turned_over | {"ignore_limits": True}})["frames"]
    texts = [
        [row["text"].text for row in frame["rows"] if str(row["label"]) == "Stability"] for frame in frames
    ]
    snapped = ["snaps on the way" in " ".join(rows) for rows in texts]
    assert snapped.index(False) > 3, "pulled flat, it has turned over"
    assert not any(snapped[snapped.index(False) :])
    for frame, rows in zip(frames, texts, strict=True):
        assert frame["stable"] == ("unstable: the strip snaps into another shape" not in rows)


def test_copies_between_rings_stand_in_their_places():
    lamp = design(
        LAMP,
        sheet="polypropylene-0.8",
        max_width=30,
        patterns=[{"rotate": {"count": 12}}],
        rings={"sheet": "mdf-3"},
    )
    report = answer({"do": "model", "design": lamp})
    assert len(report["places"]) == 12
    assert len(report["plates"]) == 2
    assert len(report["warnings"]) == 2  # strips tip in the slots of one thin ring
    half_a_turn = np.array(report["places"][6][1]).reshape(4, 4).T
    assert half_a_turn @ [60, 0, 0, 1] == pytest.approx([-60, 0, 0, 1], abs=1e-3)


def test_a_control_point_more_keeps_the_curve_and_one_less_keeps_the_others():
    curve = ec.PlaneCurve.ellipse((0, 0), (40, 25), 0.2, 0.1, 2.9)
    finer = with_point_near(curve, (0, 25))
    t = np.linspace(*curve.domain, 50)
    assert len(finer.control_points) == len(curve.control_points) + 1
    assert finer.evaluate(t) == pytest.approx(curve.evaluate(t), abs=1e-12)
    fewer = without_point(finer, 2)
    assert np.array_equal(np.delete(finer.control_points, 2, axis=0), fewer.control_points)


@pytest.mark.parametrize(
    "curve", [ec.PlaneCurve.spline(ARCH), ec.PlaneCurve.ellipse((0, 0), (40, 25), 0.2, 0.1, 2.9)]
)
def test_a_curve_goes_through_a_design_file_exactly(curve, tmp_path):
    path = tmp_path / "one.toml"
    path.write_text(compose_design(design() | {"strips": [{"curve": curve_table(curve)}]}))
    table = open_design(path)["strips"][0]["curve"]
    assert table == curve_table(curve)


@pytest.mark.parametrize("language", ["de", "zh"])
@pytest.mark.parametrize("fields", ["fields", "pair_fields"])
def test_fields_are_explained_in_the_language_of_the_page(language, fields):
    report = page_words()
    helps = re.findall(r'"help": "(.*?)"', json.dumps(report[fields]))
    assert len(helps) > len(report[fields])  # those of fields in tables too
    assert set(helps) - set(report["words"][language]) == set()


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "“min width” is 50 mm, more than “max width” (40 mm): exchange these two widths"),
        (
            "de",
            "„kleinste Breite“ ist 50 mm, mehr als „größte Breite“ (40 mm): diese beiden Breiten vertauschen",
        ),
        ("zh", "“最小宽度” 为 50 mm，大于 “最大宽度”（40 mm）：请交换这两个宽度"),
    ],
)
def test_fields_in_messages_are_called_as_their_labels(language, said):
    keys = {"max_width": 40, "min_width": 50}
    question = {"do": "strip", "language": language, "design": design(limits={}, **keys)}
    assert said in json.loads(reply(json.dumps(question).encode())[1])["refused"]["message"]


def test_a_dropped_file_brings_its_curves():
    paths = '<path d="M0 0C10 20 40 60 80 0"/><path d="M0 90C10 99 40 99 80 90"/>'
    svg = f'<svg xmlns="http://www.w3.org/2000/svg">{paths}</svg>'
    read = [one["read"] for one in answer({"do": "read", "name": "two.svg", "text": svg})["curves"]]
    assert [line.partition(" mm")[0] for line in read] == ["21.2 x 8.4", "21.2 x 1.8"]


@pytest.mark.parametrize(
    "keys",
    [
        {"strips": [{"curve": "/etc/passwd"}]},
        {"strips": [{"curve": {"file": "../secret.dxf"}}]},
        {"sheets_file": "/etc/passwd"},
        {"sheet": "../../mine.toml:S"},
        {"strips": [{"sections": {"mesh": "bowl.obj", "radial": {}}}]},
    ],
)
@pytest.mark.parametrize("do", ["strip", "model", "file"])
def test_no_file_is_opened_by_its_name(do, keys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    report = answer({"do": do, "kind": "kit", "design": design(**keys)})
    assert report["refused"]["text"].startswith("The page cannot open a file")


@pytest.mark.parametrize(
    "text",
    [
        '[[strips]]\ncurve = "arch.json"',
        '[pair]\nsheet = "pom-2"\nfirst = "arch.json"\nsecond = "arch.json"',
        '[pair]\nsheet = "pom-2"\nfirst = { file = "arch.json" }\nsecond = { file = "arch.json" }',
    ],
)
def test_a_dropped_design_opens_no_file_either(text, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    ec.write_curves([ec.PlaneCurve.spline(ARCH)], "arch.json")
    report = answer({"do": "read", "name": "a.toml", "text": f"schema = 1\n{text}\n"})
    assert report["refused"]["text"].startswith("The page cannot open a file")


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("my arch.svg", "<svg/>"),
        ("my arch.dxf", "?"),
        ("my arch.toml", "?"),
        ("my arch.toml", 'schema = 1\n[[strips]]\nsheet = "pom-1"\nmax_width = 20\n'),
    ],
)
def test_a_dropped_file_is_called_by_its_name(name, text):
    assert answer({"do": "read", "name": name, "text": text})["refused"]["message"].startswith(name)


def test_a_dropped_file_is_refused_in_the_language_of_the_page():
    question = {"do": "read", "name": "my arch.svg", "text": "", "language": "de"}
    assert "my arch.svg ist leer" in json.loads(reply(json.dumps(question).encode())[1])["refused"]["message"]


def test_a_kind_of_file_that_is_not_made_is_named():
    assert answer_to("file", kind="../dxf")["refused"]["message"].startswith("'../dxf' is not a file")


def test_the_cutting_file_is_that_of_the_command_line(tmp_path, capsys):
    ec.write_curves([ec.PlaneCurve.spline(ARCH)], tmp_path / "arch.json")
    words = [
        "strip",
        tmp_path / "arch.json",
        "--sheet",
        "birch-plywood-0.8",
        "--max-width",
        "40",
        "--label",
        "A1",
    ]
    with pytest.raises(SystemExit, match=r"^0$"):
        main([*map(str, words), "--no-step", "--no-pictures", "-o", str(tmp_path / "out")])
    capsys.readouterr()
    for kind in ("dxf", "svg"):
        given = answer_to("file", kind=kind)
        assert isinstance(given, Download)
        assert given.content == without_command((tmp_path / "out" / given.name).read_bytes())
    assert len(ezdxf.readfile(tmp_path / "out" / "arch.dxf").modelspace()) > 0


def test_a_print_file_is_a_closed_body(tmp_path):
    path = tmp_path / "arch.stl"
    path.write_bytes(answer_to("file", kind="stl").content)
    body = trimesh.load(path)
    assert body.is_watertight
    assert body.extents[1] == pytest.approx(175, rel=0.2)


def test_saving_keeps_the_comments_of_a_design():
    before = (
        "# my lamp\nschema = 1\nmax_width = 40  # of the laser\n"
        "[[strips]]\nlabel = 'A'  # first\ncurve = { spline = [[0, 0]] }\n"
    )
    moved = {"label": "A", "curve": {"spline": [[1, 1]]}}
    after = compose_design({"schema": 1, "max_width": 30, "strips": [moved]}, before)
    assert "# my lamp" in after
    assert "max_width = 30  # of the laser" in after
    assert "# first" in after
    assert "[[1, 1]]" in after


def test_two_curves_become_one_part(tmp_path):
    first = {"spline": [[0, 0], [30, 8], [90, 8], [120, 0]], "degree": 3}
    second = {"spline": [[0, 0], [30, -8], [90, -8], [120, 0]], "degree": 3}
    cut = {"for": "service"}
    pair = {
        "schema": 1, "name": "clip", "cut": cut, "pair": {"sheet": "pom-2", "first": first, "second": second},
    }  # fmt: skip
    report = answer({"do": "pair", "design": pair})
    heights = [np.array(state["position"])[:, 1] for state in report["states"]]
    assert heights[0].max() == pytest.approx(-heights[1].min(), abs=0.05)
    assert [row["label"] for row in report["rows"]] == [
        "Size",
        "Strain",
        "Stability",
        "Position",
        "Accuracy",
        "Hold",
    ]
    dragged = answer({"do": "pair", "design": pair, "live": True})["rows"]
    assert {row["label"]: row["text"] for row in dragged}["Stability"] == "…"
    assert not any(row["stops"] for row in report["rows"])
    path = tmp_path / "clip.toml"
    path.write_text(compose_design(pair))
    assert open_design(path) == pair
    given = answer({"do": "file", "kind": "dxf", "design": pair})
    with pytest.raises(SystemExit, match=r"^0$"):
        main(["pair", str(path), "-o", str(tmp_path / "out"), "-q"])
    assert given.name == "clip-mm.dxf"
    assert given.content == without_command((tmp_path / "out" / given.name).read_bytes())


def test_elements_are_shown_at_their_places_with_their_forces():
    between = [{"at": [180, 5]}, {"kind": "tie", "start": 40, "end": 310}]
    report = answer({"do": "strip", "design": wave(between=between, loads=[{"at": 150, "force": [0, -0.1]}])})
    made = ec.make_strip(
        ec.PlaneCurve.spline(WAVE, degree=5), "birch-plywood-0.8", max_width=40,
        between=(ec.Rail((180, 5)), ec.Tie(40, 310)), loads=(ec.PointForce(150, (0, -0.1)),),
    )  # fmt: skip
    rail, tie, load = report["elements"]
    assert [one["noun"] for one in (rail, tie, load)] == ["rail", "tie", "point force"]
    forces = made.bending_stiffness * made.rod.between_forces
    assert np.array([rail["force"], tie["force"]]) == pytest.approx(forces, abs=1e-5)
    assert load["force"] == [0, -0.1]
    for one, held in zip(report["elements"], made.rod.acting, strict=True):
        assert np.array(one["places"]) == pytest.approx(made.rod.curve.at(held.s).position, abs=2e-3)
    assert report["theorem"]["line"] is None
    assert len(report["thrust"]) >= 3


def test_ties_and_loads_keep_their_fraction_of_an_edited_curve():
    between = [{"at": [180, 5]}, {"at": 100}, {"kind": "tie", "start": 0, "end": 390}]
    shorter = wave([(0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (350, 0)],
                   between=between, loads=[{"at": 195, "force": [0, -1]}])  # fmt: skip
    report = answer({"do": "strip", "design": shorter, "length": 390})
    length = report["path"]["length"]
    assert report["kept"]["between"][:2] == between[:2]
    assert report["kept"]["between"][2] == {"kind": "tie", "start": 0, "end": pytest.approx(length, abs=1e-6)}
    assert report["kept"]["loads"][0]["at"] == pytest.approx(length / 2, abs=1e-6)
    assert answer({"do": "strip", "design": shorter})["kept"] == {}


@pytest.mark.parametrize("between", [[], [{"at": 200}]], ids=["alone", "rail"])
def test_a_dragged_point_stops_at_the_border(between):
    """Half a step further, or on the whole way, the strip is refused; along x it goes where that is possible."""
    points, k = (WAVE, 3) if between else (ARCH, 1)
    degree = 5 if between else 4

    def at(place, **more):
        drawn = design([place if i == k else xy for i, xy in enumerate(points)], between=between)
        drawn["strips"][0]["curve"]["degree"] = degree
        return answer({"do": "strip", "design": drawn, "live": True, **more})

    hold = {"point": [k], "from": [list(points[k])], "step": 0.5}
    far = [points[k][0] + 1.0, points[k][1] - 300.0]
    assert "refused" in at(far)
    answers = [at(far, hold=hold)]
    while {"position", "turn"} & answers[-1].keys():  # as the page, which asks until the point stays
        assert "refused" not in at(*answers[-1]["point"])
        answers.append(
            at(far, hold=hold | {"from": answers[-1]["point"], "turn": answers[-1].get("turn", 0)})
        )
    assert 2 < len(answers) < 30
    assert answers[-1] == {"point": answers[-2]["point"], "idle": []}
    ((x, y),) = answers[-1]["point"]
    assert y > far[1] + 1
    assert "refused" in at([x, y - 1.1])
    near = [points[k][0], points[k][1] - 0.1]
    assert "point" not in at(near, hold=hold)


@pytest.mark.parametrize(
    ("drawn", "fields"),
    [
        pytest.param(wave(), ["between", "nearest"], marks=pytest.mark.campaign),
        (wave(between=[{"at": 100}]), ["between"]),
        pytest.param(wave(ZIGZAG, sheet="pom-0.5"), ["nearest", "point"], marks=pytest.mark.campaign),
        (design(sheet="oak-3", thickness=4.0), ["sheet", "nearest"]),
        (design(strips=[{"label": "A1", "curve": TWO_ARCS}]), ["split_corners", "nearest"]),
    ],
)
def test_each_change_that_helps_makes_the_strip(drawn, fields):
    """The page replaces the strip by the tables of the answer; the shape is that of the request that was tried."""
    spec = requested_spec(drawn)
    with pytest.raises(ec.ElasticaError) as refusal:
        spec.make()
    tried, cures = list(suggest(spec, refusal.value)), answer({"do": "cures", "design": drawn})["cures"]
    assert [suggestion.change.field for suggestion in tried] == fields
    assert [(cure["text"], cure["effect"]) for cure in cures] == [(one.title, one.effect) for one in tried]
    for suggestion, cure in zip(tried, cures, strict=True):
        for k, request in enumerate(suggestion.requests):
            made = answer({"do": "strip", "design": drawn | {"strips": cure["strips"]}, "strip": k})
            assert made["length"] == pytest.approx(request.make().rod.length, abs=0.01)


def test_the_page_gets_the_reason_why_no_change_is_tried(monkeypatch):
    assert answer({"do": "cures", "design": wave()})["reason"] is None
    monkeypatch.setattr(trials, "MOST_PIECES", 1)
    found = answer({"do": "cures", "design": wave()})
    assert found["cures"] == []
    assert found["reason"].startswith("Not tried, because the curve has 2 pieces, more than 1.")


def test_a_strip_that_can_be_made_needs_no_change():
    assert answer_to("cures") == {"cures": []}


def test_a_strip_of_a_model_is_not_enlarged_beyond_its_sheets():
    """Of the strip alone, a larger drawing is suggested."""

    def listed(**tables):
        cures = answer({"do": "cures", "design": design(sheet="oak-3") | tables})["cures"]
        return [cure["effect"] for cure in cures if cure["text"].startswith("Draw the curve")]

    (effect,) = listed()
    assert float(effect.split()[2]) > 600
    assert listed(base={}) == []
    assert listed(base={}, nest={"sheet_size": [3000, 1500]}) == [effect]


@pytest.mark.campaign
@pytest.mark.parametrize("points", [ARCH, LAMP], ids=["arch", "lamp"])
def test_an_answer_costs_little_more_than_its_strip(points):
    """While a curve is dragged: at most 2.2 of `make_strip`, which computes widths and strain only when asked."""
    moved = count()

    def another():
        (x, y), *others = points
        return [(x, y + 1e-3 * next(moved)), *others]

    def made():
        ec.make_strip(ec.PlaneCurve.spline(another()), "birch-plywood-0.8", max_width=40, label="A1")

    def told():
        request = {"do": "strip", "live": True, "design": design(another())}
        assert b"refused" not in reply(json.dumps(request).encode())[1]

    def cost(once):
        began = process_time()
        once()
        return process_time() - began

    ratio = min(cost(told) for _ in range(40)) / min(cost(made) for _ in range(40))
    print(f"\n{ratio:.2f} of make_strip")
    assert ratio <= 2.2


def test_the_strain_limit_is_a_border_for_a_dragged_point():
    def at(height, **more):
        points = [[x, height if k == 4 else y] for k, (x, y) in enumerate(ARCH)]
        return answer({"do": "strip", "design": design(points), "live": True, **more})

    hold = {"point": [4], "from": [ARCH[4]], "step": 0.5}
    above = next(height for height in range(180, 400, 10) if max(at(height)["shares"]) > 1.02)
    assert "point" not in at(above, hold=hold)
    stopped = at(above, hold=hold | {"strain": True})
    assert max(stopped["shares"]) <= 1
    assert ARCH[4][1] < stopped["point"][0][1] < above


def test_a_corner_has_its_place():
    bent = design([[0, 0], [40, 40], [80, 40], [120, 0], [140, -60], [180, -60], [220, 0]])
    bent["strips"][0]["curve"] |= {"degree": 3, "knots": [0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2]}
    ((x, y),) = answer({"do": "strip", "design": bent})["places"]
    assert (x, y) == pytest.approx((120, 0))


@pytest.mark.parametrize("above", [True, False])
def test_settings_that_cannot_be_combined_have_a_change_each(above):
    """A key above all strips is removed, too."""
    keys = {"limits": {"margin": 5}}
    drawn = wave(**(keys if above else {}))
    drawn["strips"][0] |= {"between": [{"at": 197}]} | ({} if above else keys)
    refused = answer({"do": "strip", "design": drawn})["refused"]
    assert refused["message"].startswith(
        "Rails, pins, ties and point forces cannot be combined with a nearest"
    )
    assert refused["where"]["field"] == ["limits", "between", "loads"]
    cures = answer({"do": "cures", "design": drawn})["cures"]
    assert [cure["removed"] for cure in cures] == [["limits", "keep"], ["between", "loads"]]
    assert cures[0]["effect"].startswith("the curve as drawn")
