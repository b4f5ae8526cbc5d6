"""What the core and the workbench say, in German and Chinese: every template that users meet has both."""

import ast
import json
import re
from pathlib import Path
from string import Formatter
from xml.etree import ElementTree

import FreeCAD as App
import numpy as np
import pytest
from freecad.elastica_wb.features import baseplate, curves, fixtures, flat, flexure, model, nest
from freecad.elastica_wb.features.strip_properties import NEAREST, PROPERTIES
from freecad.elastica_wb.host import words
from freecad.elastica_wb.host.words import LABELS, Unit, capital, worded

from elastica_cad import InputError, PlaneCurve, Sheet, check_equilibrium
from elastica_cad.errors import (
    MATERIAL_WIDTH,
    Angle,
    BareLength,
    Either,
    FieldName,
    Force,
    Length,
    Listed,
    Point,
    Span,
    Strain,
    note,
    sentences,
)
from elastica_cad.mechanics import SidewaysStability
from elastica_cad.strip.uncuttable_parts import Fault
from tests.freecad.features import change

ROOT = Path(__file__).resolve().parents[2]
CORE, WORKBENCH = ROOT / "elastica_cad", ROOT / "freecad_workbench" / "freecad" / "elastica_wb"
CATALOGUES = ROOT / "elastica_cad" / "translations"
SPOKEN = """
    _values.py design/kit_spec.py design/reports.py design/tables.py formats/chains.py
    formats/drawn_file.py formats/edges.py
    formats/placed_curve.py formats/source_file.py formats/write_files.py form_finding/fairing_request.py
    form_finding/limits.py form_finding/nearest_record.py form_finding/nearest_task.py
    form_finding/plane_sections.py form_finding/rod_spec.py form_finding/section_lines.py
    form_finding/splitting.py form_finding/straight_ends.py geometry/measured_points.py geometry/nurbs_curve.py
    geometry/tangent_healing.py kit/kit_contents.py mechanics/bending.py mechanics/between_clamps.py
    mechanics/calibration.py mechanics/equilibrium_check.py mechanics/followed_path.py mechanics/least_ratio.py
    mechanics/loads.py
    mechanics/moment_conditions.py mechanics/newton_continuation.py mechanics/optimal_balance.py
    mechanics/section_limits.py mechanics/sideways.py mechanics/stability.py mechanics/theorem1.py
    mechanics/trials.py model/collisions.py model/fixtures.py model/held_tabs.py model/interlocking.py
    model/model.py model/nesting.py model/plate_holes.py model/plate_pairs.py model/plates.py model/rocking.py
    pairs/flexure.py pairs/matching.py pairs/pair_check.py pairs/pushed_rod.py pairs/summary.py errors.py
    strip/as_made.py strip/bent_boundary.py strip/drawing.py strip/held_shape.py strip/lamination.py
    strip/layers.py strip/makeable_strip.py strip/outline.py strip/own_weight.py strip/perforation.py
    strip/slots.py strip/solids.py strip/strip.py strip/strip_spec.py strip/styles.py strip/summary.py
    strip/tab_seats.py strip/uncuttable_parts.py web/answers.py
"""
"""Where the core makes what a user of the workbench or of the studio reads."""

PROGRAMMERS = re.compile(
    r"""!r\}|=\ takes|=:|\b(records?|Rod\b|None|keywords|rad\b|executor|mappings?|of\ bend|upper|exact\b
    |Tab\(|Plain|bending_stiffness\b|RestCurvature|PlaneCurve|residual|nodes|coefficients|wavelength=
    |path\ (has|is\ a|of\ end)|of\ the\ path|in\ a\ path|path\ and\ widths|weight=|`weight`|label\ is
    |false_turn|tolerance=|Sheet\ or|three\ numbers|finite|must\ be\ positive|must\ be\ 0\ mm|shape\ \{
    |of\ shape|Callable|give\ a\ number|(two|give)\ numbers|rows|array|sequence|callable|function
    |are\ numbers|Z\(s\)|G\ /\ E|half\ plane|box\ corners|limit\ (ratio|margin)=|station\ to
    |parameter\ outside|names\ vertex|points\ \(k|vertices\ \(n|holders\ are|a\ pattern
    |rotation\ pattern|pair\ \(|prisms|line=|closed\ skin|no\ scale|stay\ plane|are\ splines
    |limits\ are\ of|must\ be\ numbers|unexpected\ node)""",
    re.VERBOSE,
)
"""What only a caller of Python can bring about."""


def templates(path):
    """English templates of a module: what notes and errors are made from, and texts with named gaps."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    inside = {id(part) for one in ast.walk(tree) if isinstance(one, ast.JoinedStr) for part in ast.walk(one)}
    for one in ast.walk(tree):
        if isinstance(one, ast.Call) and one.args:
            called = getattr(one.func, "id", "")
            made = [one.args[0]] if called == "note" or called.endswith("Error") else []
            while made:
                part = made.pop()
                made += [part.body, part.orelse] if isinstance(part, ast.IfExp) else []
                if isinstance(part, ast.Constant) and isinstance(part.value, str):
                    yield part.value
        if isinstance(one, ast.Constant) and isinstance(one.value, str) and id(one) not in inside:
            yield from (
                [one.value]
                if re.search(r" .*\{[a-z_]+(:[^}]*)?\}", one.value) and "\n" not in one.value
                else []
            )


def gaps(template):
    return {(name, spec) for _, name, spec, _ in Formatter().parse(template) if name is not None}


def catalogue(language):
    return json.loads((CATALOGUES / f"{language}.json").read_text(encoding="utf-8"))


@pytest.mark.parametrize("language", ["de", "zh-CN"])
def test_no_template_lacks_a_translation(language):
    places = [CORE / place for place in SPOKEN.split()] + [WORKBENCH]
    files = [file for place in places for file in ([place] if place.suffix else place.rglob("*.py"))]
    wanted = {text for file in files if file.name != "tests.py" for text in templates(file)}
    found = catalogue(language)
    assert len(wanted) > 400
    assert {text for text in wanted if not PROGRAMMERS.search(text) and text not in found} == set()


@pytest.mark.parametrize("language", ["de", "zh-CN"])
def test_translations_have_the_gaps_of_their_templates(language):
    other = {text: result for text, result in catalogue(language).items() if gaps(text) != gaps(result)}
    assert other == {}


def translated(language):
    """Translations of the workbench's own words, by context and text."""
    if language == "en":
        return {}
    path = ROOT / "freecad_workbench" / "resources" / "translations" / f"Elastica_{language}.ts"
    return {
        (context.findtext("name"), message.findtext("source")): message.findtext("translation")
        for context in ElementTree.parse(path).getroot().iter("context")
        for message in context.iter("message")
    }


def speak(monkeypatch, language):
    """The words of a language, without a window that would load them."""
    known = translated(language)
    monkeypatch.setattr(words, "user_language", lambda: language)
    monkeypatch.setattr(words, "translate", lambda *text: known.get(text, text[1]))


@pytest.fixture
def chinese(monkeypatch):
    """The Chinese words."""
    speak(monkeypatch, "zh-CN")


@pytest.fixture
def german(monkeypatch):
    """The German words."""
    speak(monkeypatch, "de")


@pytest.mark.usefixtures("german")
def test_records_are_said_in_german_with_commas(monkeypatch):
    monkeypatch.setattr(words, "decimal_point", lambda: ",")
    loop = PlaneCurve.spline([(0, 0), (200, 100), (-100, 100), (100, 0)], 3)
    text = worded(str(check_equilibrium(loop)))
    assert text == (
        "Ein flacher Streifen kann diese Kurve von 254 mm annehmen; sie hat keine Wendepunkte. Die Kurve kreuzt "
        "sich selbst (58,4 und 195 mm vom Anfang): zwei Teile des Streifens müssen dort nebeneinander vorbei."
    )
    thin = Fault("A1", note("Made anyway: {fault}", fault=note("a hole")), note("Make it wider, or split it"))
    assert (
        worded(str(thin))
        == "A1: Trotzdem hergestellt: einem Loch. Den Streifen breiter machen oder zerteilen"
    )
    assert worded(note("{place}", place=Point((25.4, -50.8)))) == "(25,4; -50,8) mm"
    assert worded("wrote A1_birch-0.8_0.8mm_x4.dxf") == "wrote A1_birch-0.8_0.8mm_x4.dxf"
    tips = SidewaysStability(-24.1, -40.2, 0.1, 100.0)
    assert worded(str(tips)).startswith(
        "seitliche Stabilität: instabil; der Streifen kippt zur Seite oder dreht sich"
    )
    with pytest.raises(InputError) as unknown:
        Sheet.named("birch-plywood-8")
    assert worded(unknown.value.refusal) == (
        "unbekannte Platte „birch-plywood-8“: verwenden Sie birch-plywood-6 und setzen Sie „Dicke“ auf 8 mm"
    )
    assert worded(InputError("what nobody knows").refusal) == "what nobody knows"
    both = sentences([note("{width} wide", width=Span.of(20.8, 30)), note("the material stays bent there")])
    assert worded(both) == "20,8 bis 30 mm breit; das Material bleibt dort gebogen"


@pytest.mark.usefixtures("chinese")
def test_records_are_said_in_chinese():
    line = note("crosses the curve at {places}", places=Listed(map(Length, (45.68, 497.4))))
    assert worded(line) == "在 45.7 和 497 mm 处与曲线相交"
    assert worded(note("{width} wide", width=Span.of(20.8, 30))) == "宽 20.8 至 30 mm"


def test_lengths_are_said_in_the_users_unit():
    inch = Unit("in", 25.4)
    assert (
        worded(note("at {places}", places=Listed(map(Length, (25.4, 50.8, 76.2)))), inch)
        == "at 1, 2 and 3 in"
    )
    assert worded(note("near {place}", place=Point((25.4, -50.8))), inch) == "near (1, -2) in"
    assert (
        worded(note("{far:.2g} off, {bend} 1/mm", far=Length(2.54), bend=0.02), inch)
        == "0.1 in off, 0.02 1/mm"
    )
    for mm, text in ((0.001, "0.0000394 in"), (0.25, "0.00984 in"), (20.0, "0.7874 in"), (1234.5, "48.6 in")):
        assert worded(note("{far}", far=Length(mm)), inch) == text
    two = note("{long:g} by {short:g}", long=BareLength(50.8), short=Length(25.4))
    assert (str(two), worded(two, inch)) == ("50.8 by 25.4 mm", "2 by 1 in")


CORE_OF_FREECAD = ("geometry", "mechanics", "form_finding", "strip", "model", "pairs")
"""Packages of the core whose messages users of the workbench meet."""

QUOTES = {"en": '"{}"', "de": "„{}“", "zh-CN": "“{}”"}
PROPERTY = {"en": 'property "{}"', "de": "Eigenschaft „{}“", "zh-CN": "属性“{}”"}


def calls_of(file, name):
    tree = ast.parse(file.read_text(encoding="utf-8"))
    return [
        node for node in ast.walk(tree) if isinstance(node, ast.Call) and getattr(node.func, "id", "") == name
    ]


def constants(node):
    return {
        part.value
        for part in ast.walk(node)
        if isinstance(part, ast.Constant) and isinstance(part.value, str)
    }


def labels_of_boxes():
    """What stands beside the boxes of all panels, in English: layouts, .ui files, and the row of the curve."""
    panels = WORKBENCH / "panels"
    layouts = calls_of(panels / "feature_panels.py", "Layout")
    names = {name for layout in layouts for group in layout.args[3].values for name in constants(group)}
    assert len(names) > 60
    files = (ROOT / "freecad_workbench" / "resources" / "ui").glob("*.ui")
    widgets = [widget for file in files for widget in ElementTree.parse(file).getroot().iter("widget")]
    texts = {
        w.findtext("property[@name='text']/string")
        for w in widgets
        if w.get("class") in ("QLabel", "QCheckBox")
    }
    rows = {
        call.args[1].value
        for call in calls_of(panels / "property_panel.py", "translate")
        if constants(call.args[1])
    }
    return {LABELS[name] for name in names} | texts | rows


def names_of_properties():
    tables = [PROPERTIES, NEAREST]
    for module in (baseplate, curves, fixtures, flat, flexure, model, nest):
        tables += [kind.properties for kind in vars(module).values() if hasattr(kind, "properties")]
    return {entry.name for table in tables for entry in table}


def fields_in_messages():
    """Keys of all fields that messages name."""
    files = [file for folder in CORE_OF_FREECAD for file in (CORE / folder).rglob("*.py")]
    named = [
        call.args[0] for file in (*files, *WORKBENCH.rglob("*.py")) for call in calls_of(file, "FieldName")
    ]
    return {key for name in named if not isinstance(name, ast.JoinedStr) for key in constants(name)}


@pytest.mark.parametrize("language", ["en", "de", "zh-CN"])
def test_messages_name_boxes_as_they_are_labelled(monkeypatch, language):
    speak(monkeypatch, language)

    def shown(text):
        return words.translate("Elastica", text)

    boxes = {*map(shown, labels_of_boxes()), shown("Nearest curve to sketch")}
    boxes.add(f"{shown(LABELS['Follow'])}: {shown('Nearest')}")
    assert {*map(shown, LABELS.values())} <= boxes
    properties = names_of_properties() | {"Scale", "LinkedObject", "FileName"}
    spaced = {re.sub("(?<=[a-z])(?=[A-Z])", " ", name) for name in properties}
    named = {*map(QUOTES[language].format, boxes), *map(PROPERTY[language].format, spaced)}
    texts = {key: words.Words(language, Unit("mm", 1), ".").field(key) for key in fields_in_messages()}
    assert len(texts) > 40
    only_in_files = {"feet", "full", "second_state", "shop.lap"}
    assert {key for key, text in texts.items() if text not in named} == only_in_files


def test_no_message_names_a_property_in_its_text():
    names = "|".join(
        name for name in names_of_properties() | {"LinkedObject", "FileName"} if name[1:].lower() != name[1:]
    )
    raw = re.compile(rf"\b({names})\b|[Pp]roperty [A-Z{{]|Eigenschaft [A-Z{{]")
    texts = {text for file in WORKBENCH.rglob("*.py") if file.name != "tests.py" for text in templates(file)}
    texts |= {text for language in ("de", "zh-CN") for text in catalogue(language).values()}
    texts |= {entry.help for entry in PROPERTIES}
    assert {text for text in texts if raw.search(text)} == set()


def test_fields_have_the_names_of_their_boxes():
    keys = (
        "max_width",
        "shop.least_width",
        "ignore_limits",
        "gravity",
        "style.hole_ratio",
        "limits",
        "shop.lap",
    )
    text = [worded(note("raise {field}", field=FieldName(key))).removeprefix("raise ") for key in keys]
    assert text == [
        '"Largest width"', 'property "Least Width"', '"Make it anyway"', '"Own weight"', 'property "Hole Ratio"',
        '"Follow the curve: Nearest"', 'key "shop.lap" of a design file',
    ]  # fmt: skip
    assert capital("too narrow") == "Too narrow"
    assert capital("rib: too narrow") == "rib: too narrow"


@pytest.mark.usefixtures("german")
def test_lines_of_a_property_are_named_with_their_number(drawn):
    from freecad.elastica_wb import make_strip

    made = make_strip(drawn([(0, 0), (60, 40), (120, 60), (240, 40), (300, 0)], 4), flat_part=False)
    change(made, Loads=["mass = 1, at = 20", "mass = 2, att = 9"])
    assert "Eigenschaft „Loads[2]“: unbekannter Schlüssel 'att'; meinten Sie at?" in made.Reasons[0]
    change(made, Loads=["mass = -1, at = 20"])
    assert "Eigenschaft „Loads[1]“: mass ist -1" in made.Reasons[0]


SMALL = {"Style": "Perforated", "OuterWidth": 24.0, "MaterialWidth": 2.0}
BACKED = {"Style": "Laminated", "OuterWidth": 24.0, "MaterialWidth": 3.0, "LeastBacking": 2.9}


@pytest.mark.parametrize("options", [SMALL, BACKED])
def test_a_limit_of_the_material_is_called_by_its_own_property(document, sketch, options):
    from freecad.elastica_wb.features import strip

    made = strip.create(document, sketch)
    made.Backing = made.Sheet
    for name, value in options.items():
        setattr(made, name, value)
    document.recompute()
    text = " ".join([made.Verdict, *made.Reasons])
    assert 'property "Material Width"' in text, text
    assert "Largest width" not in text, text


@pytest.mark.usefixtures("german")
def test_a_strip_that_breaks_says_so_in_german(document, sketch):
    from freecad.elastica_wb.features import strip

    made = strip.create(document, sketch)
    change(made, Thickness=4)
    text = " ".join([made.Verdict, *made.Reasons])
    assert "Streifen" in text
    assert not re.search(r"\b(the|strain|curve)\b", text), text


@pytest.mark.usefixtures("german")
def test_on_which_side_the_backing_lies_is_reported_in_german(document, sketch):
    from freecad.elastica_wb.features import strip

    made = strip.create(document, sketch)
    made.Style, made.Backing, made.Anyway = "Laminated", made.Sheet, True
    document.recompute()
    assert any("die Verstärkung" in reason and "SIDE" in reason for reason in made.Reasons), made.Reasons


REFUSED = [
    {"Loads": ["at = 50, mass = 20"]},
    {"Loads": ["at 50"], "Gravity": True},
    {"Loads": ["at = 50, mass = -3"], "Gravity": True},
    {"Style": "Laminated", "Follow": "Nearest", "Gravity": True, "GravityDirection": (0, -1, 0)},
    {"Follow": "Nearest", "Gravity": True, "GravityDirection": (0, -1, 0), "Loads": ["at = 50, mass = 20"]},
    {"Follow": "Nearest", "MostLength": 100},
    {"Follow": "Nearest", "LeastWidth": 50, "MostWidth": 10},
    {"Slots": ["at = 5000, width = 1"]},
    {"Law": "junk"},
    {"Law": "E = 4"},
    {"WeightLaw": "junk"},
    {"StartTabKeys": "length = -4"},
    {"Thickness": 0},
    {"Samples": 1},
    {"Creep": -1},
    {"Style": "Laminated", "OuterWidth": 0},
    {"Style": None},
    {"MaxWidth": 4},
]
ENGLISH = re.compile(r"\b(the|it|and|values|give|leave|such|must|make|use|one|keep|deeper|positive|is)\b")


@pytest.mark.usefixtures("german")
@pytest.mark.parametrize("asked", REFUSED, ids=" ".join)
def test_refused_properties_are_reported_in_german(document, sketch, monkeypatch, asked):
    from freecad.elastica_wb.features import strip

    monkeypatch.setattr(words, "decimal_point", lambda: ",")
    made = strip.create(document, sketch)
    for name, value in asked.items():
        if value is None:
            made.setExpression(name, "7")
        else:
            setattr(made, name, value)
    document.recompute()
    assert "Invalid" in made.State
    text = " ".join(made.Reasons)
    assert not ENGLISH.search(text), text
    assert not re.search(r"[0-9]\.[0-9]|^strip", text.replace("birch-plywood-0.8", "")), text


def test_a_line_that_cannot_be_read_is_reported_what_its_property_takes(document, sketch):
    from freecad.elastica_wb.features import strip
    from freecad.elastica_wb.features.strip_properties import EXAMPLES, MASS_LINE, TAB_LINE, WEIGHT_LINE

    made = strip.create(document, sketch)
    made.Gravity, made.GravityDirection = True, (0, -1, 0)
    for name, line in (("Loads", MASS_LINE), ("WeightLaw", WEIGHT_LINE), ("StartTabKeys", TAB_LINE)):
        good = [line] if name == "Loads" else line
        setattr(made, name, ["junk"] if name == "Loads" else "junk")
        document.recompute()
        assert line in made.Reasons[0], "its own example"
        setattr(made, name, good)
        document.recompute()
        assert not any("cannot be read" in reason for reason in made.Reasons), "what it tells is good"
        setattr(made, name, [] if name == "Loads" else "")
    change(made, Gravity=False, Follow="Nearest", KeepOut=["junk"])
    assert EXAMPLES["KeepOut"] in made.Reasons[0]


BLANKS = [
    "-0.004",
    "0.004",
    "stations = [0, 202], curvatures = [0, -0.01]",
    "stations = [0, 202], curvatures = [0, 0.01]",
]


@pytest.mark.parametrize("language", ["german", "chinese"])
@pytest.mark.parametrize("blank", BLANKS)
def test_blanks_bent_beforehand_are_reported_in_other_languages(document, sketch, request, language, blank):
    from freecad.elastica_wb.features import strip

    request.getfixturevalue(language)
    made = strip.create(document, sketch)
    if "=" in blank:
        made.Blank = blank
    else:
        made.NaturalCurvature = float(blank)
    document.recompute()
    text = " ".join([made.Verdict, *made.Reasons])
    assert "Invalid" not in made.State, text
    assert not re.search(r"\b(bend|bent|beforehand|the|way|stands|its|strip|radius of|report)\b", text), text


def test_messages_are_stored_for_readers_of_all_languages(document, sketch, monkeypatch, tmp_path):
    """A file that was saved in German is read in English; a file that was edited by hand opens."""
    from freecad.elastica_wb.features import strip

    monkeypatch.setattr(words, "user_language", lambda: "de")
    made, broken = strip.create(document, sketch), strip.create(document, sketch)
    made.NaturalCurvature, broken.Sheet = 0.004, "birch-plywood-3"
    document.recompute()
    german = [made.Verdict, *made.Reasons, made.Sideways, broken.Verdict, *broken.Reasons]
    assert made.Verdict == "Ein vorgebogener Streifen lässt sich in diese Kurve biegen."
    broken.Messages = broken.Messages[:-9]
    document.saveAs(str(tmp_path / "german.FCStd"))
    monkeypatch.setattr(words, "user_language", lambda: "en")
    again = App.openDocument(str(tmp_path / "german.FCStd"))
    try:
        first, second = again.getObject(made.Name), again.getObject(broken.Name)
        english = [first.Verdict, *first.Reasons, first.Sideways]
        assert english[0] == "A pre-bent strip can be bent into this curve."
        assert second.Verdict == broken.Verdict
        for obj in (first, second):
            obj.touch()
        again.recompute()
        assert [first.Verdict, *first.Reasons, first.Sideways] == english
        assert not {*german} & {*english, second.Verdict, *second.Reasons}
    finally:
        App.closeDocument(again.Name)


def test_a_stored_message_has_all_its_values():
    message = sentences([
        note("at {at}, {width}", at=Listed(map(Length, (1.5, 20))), width=Span.of(20.8, 30)),
        note("{far} from {place}", far=Length(1.25), place=Point((25.4, -50.8))).at(strip="A1"),
        note("{long} by {wide}", long=BareLength(5), wide=Length(1.25)),
        note("{count} {flag} {share:.3g}", count=3, flag=True, share=np.float64(0.123456)),
        note("{force} at {turn}, {strain:.2f}", force=Force(1.5), turn=Angle(30), strain=Strain(0.00456)),
        note("set {name}, or {other}", name=FieldName("max_width"), other=MATERIAL_WIDTH),
        note("{either}", either=Either(["widen it", note("take {name}", name="another sheet")])),
    ])  # fmt: skip
    again = words.unpacked(json.loads(json.dumps(words.packed(message))))
    inch = Unit("in", 25.4)
    assert (str(again), worded(again, inch)) == (str(message), worded(message, inch))
    assert 'property "Material Width"' in worded(again)
