"""What the core and the workbench say, in German and Chinese: every sentence that users meet has a key and both."""

import ast
import re
from pathlib import Path
from xml.etree import ElementTree

import pytest
from freecad.elastica_wb.host import sentences, user_units

ROOT = Path(__file__).resolve().parents[2]
CORE, WORKBENCH = ROOT / "elastica_cad", ROOT / "freecad_workbench" / "freecad" / "elastica_wb"
TRANSLATIONS = ROOT / "freecad_workbench" / "resources" / "translations"
SPOKEN = [
    "mechanics/loads/rest_curvature.py",
    "mechanics/theorem1",
    "mechanics/stiffness/optimal_rod.py",
    "mechanics/stiffness/optimal_balance.py",
    "mechanics/stability/stability_verdict.py",
    "mechanics/stability/sideways.py",
    "mechanics/bending/bend_forward.py",
    "mechanics/bending/between_clamps.py",
    "mechanics/material/section_limits.py",
    "fabrication/holding/held_shape.py",
    "fabrication/makeability",
    "fabrication/strip",
    "fabrication/strip_spec.py",
    "fabrication/slots",
    "fabrication/interlocking/interlock.py",
    "fabrication/interlocking/collisions.py",
    "fabrication/model/strip_model.py",
    "fabrication/drawings/cutting.py",
    "fabrication/holders/plates.py",
    "fabrication/holders/end_fixtures.py",
    "fabrication/sheets/nesting.py",
    "formats/reports/bent_blank.py",
    "formats/curve_files/placed_curve.py",
    "formats/curve_files/edges.py",
    "formats/curve_files/edge_plane.py",
    "formats/file_access/atomic_write.py",
    "forming/nearest/nearest_record.py",
    "forming/nearest/advice.py",
    "forming/plane_sections/section_curves.py",
    "forming/plane_sections/section_lines.py",
    "forming/fairing_request.py",
    "forming/rod_spec.py",
]
"""Where the core makes what a user of the workbench reads."""

NO_SENTENCES = ("tests.py", "sentences.py")
"""Tests, and what stands for parts of sentences."""

PROGRAMMERS = re.compile(
    r"""\b(record|records|Rod\b|None|keywords|rad\b|executor|mappings?|optimal_laminate|bend\ needs|of\ bend
    |upper|hull|exact|bending_stiffness|Tab\(|Plain|RestCurvature|PlaneCurve\ in|residual|unstable|nodes
    |coefficients|wavelength=|positive\ wavelength|above\ must|places\ 0|path\ (has|is\ a|of\ end)|of\ the\ path:
    |in\ a\ path:|path\ and\ widths|E\ I|weight=|`weight`|label\ is|weight\ profile
    |all\ lengths\ in\ mm|false_turn|tolerance=|Sheet\ or|PropertiesList|bit\ mask|three\ numbers|finite
    |must\ be\ positive|must\ be\ 0\ mm\ or\ more|ec\.)|,\ got\ %|^%\d\ =\ %\d\ mm$|[{}<|]|\\
    |%\ \(%2\ %\)|^no\ file\ was|points\ \(k|^mm\ of\ |^%1\ has\ %2\ lines$|Callable|^\w+\ =\ |^(%\d|mm|x
    |[^a-z])*$|color:""",
    re.VERBOSE,
)
"""What only a caller of Python can bring about, or what is no sentence."""


def text(node):
    """A text, or an f-string with numbered gaps."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return node.value
    if isinstance(node, ast.JoinedStr):
        gaps = iter(range(1, 20))
        return "".join(v.value if isinstance(v, ast.Constant) else f"%{next(gaps)}" for v in node.values)
    return ""


def unspoken(node):
    """Parts of the code whose texts are no sentences, or have their own translation."""
    called = getattr(getattr(node, "func", None), "id", getattr(getattr(node, "func", None), "attr", ""))
    if called in ("tr", "translate", "QT_TRANSLATE_NOOP", "Property"):
        return [node]
    if isinstance(node, ast.ClassDef):
        names = ("text", "tip", "step")
        return [
            n for n in node.body if isinstance(n, ast.Assign) and getattr(n.targets[0], "id", "") in names
        ]
    if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
        return [node]
    if isinstance(node, ast.JoinedStr):
        return node.values
    return [part for part in (getattr(node, "annotation", None), getattr(node, "returns", None)) if part]


def spoken(path):
    tree = ast.parse(path.read_text(encoding="utf-8"))
    silent = {id(n) for node in ast.walk(tree) for part in unspoken(node) for n in ast.walk(part)}
    for node in ast.walk(tree):
        words = "" if id(node) in silent else text(node)
        if words.count(" ") >= 3 and words.strip().count(" ") >= 3 and not PROGRAMMERS.search(words.strip()):
            yield words.strip()


def keys():
    places = [CORE / place for place in SPOKEN] + [WORKBENCH]
    files = [file for place in places for file in ([place] if place.suffix else sorted(place.rglob("*.py")))]
    return {words for file in files if file.name not in NO_SENTENCES for words in spoken(file)}


def known(language):
    tree = ElementTree.parse(TRANSLATIONS / f"Elastica_{language}.ts")
    return {
        message.findtext("source"): message.findtext("translation")
        for context in tree.getroot().iter("context")
        for message in context.iter("message")
        if context.findtext("name") == sentences.CONTEXT
    }


@pytest.mark.campaign
@pytest.mark.parametrize("language", ["de", "zh-CN"])
def test_no_sentence_lacks_a_translation(language):
    found = known(language)
    wanted = keys()
    assert len(wanted) > 200
    assert {key for key in wanted if not found.get(key)} == set()
    for key, words in found.items():
        gaps = set(sentences.GAP.findall(key))
        assert set(sentences.GAP.findall(words)) <= gaps, key


@pytest.fixture
def chinese(monkeypatch):
    """The Chinese words."""
    yield from spoken_in("zh-CN", monkeypatch)


@pytest.fixture
def german(monkeypatch):
    """The German words."""
    yield from spoken_in("de", monkeypatch)


def spoken_in(language, monkeypatch):
    """The words of a language, without a window that would load them."""
    words = known(language)
    monkeypatch.setattr(sentences, "translate", lambda _context, text: words.get(text, text))
    monkeypatch.setattr(sentences, "_language", lambda: language)
    sentences._keys.cache_clear()
    sentences._translated.cache_clear()
    yield
    sentences._keys.cache_clear()
    sentences._translated.cache_clear()


@pytest.mark.usefixtures("german")
def test_a_sentence_is_known_by_its_key(monkeypatch):
    monkeypatch.setattr(user_units, "decimal_point", lambda: ",")
    crossing = "The curve crosses itself (at 12.5 mm): two parts of the strip must pass side by side there."
    assert user_units.worded(crossing).startswith("Die Kurve kreuzt sich selbst (bei 12,5 mm): zwei Teile")
    curve = "A flat strip can take this curve of 200.5 mm; it has 2 inflections, at 12 and 34.5 mm."
    said = user_units.worded(f"There is no strip. {curve}")
    assert said.startswith(
        "Es gibt keinen Streifen. Ein flacher Streifen kann diese Kurve von 200,5 mm annehmen; "
    )
    assert said.endswith("; sie hat 2 Wendepunkte, bei 12 und 34,5 mm.")
    crossed = (
        "The line through its inflections crosses the curve at 45.5 and 497 mm, where the moment would vanish "
        "or change sign and the curvature does not: move the curve off the line there, or support the strip "
        "between there and the inflections beside it."
    )
    said = user_units.worded(f"A flat strip cannot take this curve of 673.8 mm. {crossed}")
    assert "Die Gerade durch die Wendepunkte kreuzt die Kurve bei 45,5 und 497 mm; dort " in said
    assert user_units.worded("at (25.4, -50.8) mm") == "bei (25,4; -50,8) mm"
    assert user_units.worded("12.7 x 25.4 mm, birch-plywood-0.8") == "12,7 x 25,4 mm, birch-plywood-0.8"
    assert user_units.worded("wrote A1_birch-0.8_0.8mm_x4.dxf") == "wrote A1_birch-0.8_0.8mm_x4.dxf"
    held = (
        "as made and held the strip strays about 1.2 mm from its design, 0.59 % of its length, most of it as "
        "modelled: the model says 1.1 mm and leaves 0.2 mm open, and sheet, cut and clamps add 0.4 mm"
    )
    assert user_units.worded(f"{held}; each cause alone: 1.1 mm by slots; 0.15 mm by narrow tabs") == (
        "so wie er gemacht und gehalten ist, weicht der Streifen etwa 1,2 mm von seinem Entwurf "
        "ab, 0,59 % seiner Länge, das meiste davon laut Modell: Das Modell sagt 1,1 mm und lässt 0,2 mm offen, und "
        "Platte, Schnitt und Einspannung tragen 0,4 mm bei; "
        "jede Ursache für sich: 1,1 mm durch Schlitze; 0,15 mm durch schmale Laschen"
    )
    thin = (
        "A1: only 2.53 mm wide at 9.88 mm along it, 3 mm are needed in birch-plywood-0.8; only 2.54 mm wide "
        "at 158 mm along it, 3 mm are needed in birch-plywood-0.8; make it wider (max_width), or ask for the "
        "nearest curve with a smaller ratio. To make it all the same, set ignore_limits (--ignore-limits)."
    )
    assert not re.search(r"\b(only|are|needed|make|along)\b", user_units.worded(thin)), user_units.worded(
        thin
    )
    assert user_units.worded("margin 96.5.") == "margin 96,5."
    # what is to be typed keeps its points
    blank = "stations = [0, 300.5], curvatures = [0, 0.01], 12.5 mm"
    assert user_units.worded(blank) == "stations = [0, 300.5], curvatures = [0, 0.01], 12,5 mm"
    assert user_units.worded("at = 12.5, width = 1.2") == "at = 12.5, width = 1.2"
    assert user_units.worded(
        "elasto-gravity length 98.16 +- 0.75 mm\nreadings 96.99, 98.62 mm\nE 2782 +- 63 MPa"
    ) == ("elasto-gravitative Länge 98,16 +- 0,75 mm\nMesswerte 96,99; 98,62 mm\nE 2782 +- 63 MPa")
    assert user_units.worded("what nobody knows") == "what nobody knows"


TAKEN = "takes this curve: {}, stiffness ratio 1.44, strain 80 % of what the sheet bears."


@pytest.mark.usefixtures("german")
@pytest.mark.parametrize("how", ["A flat strip", "A strip bent beforehand"])
def test_an_even_width_is_told_once_in_german(how):
    assert ": 20.8 bis 30 mm breit, Steif" in user_units.worded(f"{how} {TAKEN.format('20.8 to 30 mm wide')}")
    even = user_units.worded(f"{how} {TAKEN.format('30 mm wide')}")
    assert even.endswith(
        "diese Kurve an: 30 mm breit, Steifigkeitsverhältnis 1.44, Dehnung 80 % dessen, was die Platte erträgt."
    )


@pytest.mark.usefixtures("chinese")
@pytest.mark.parametrize("how", ["A flat strip", "A strip bent beforehand"])
def test_an_even_width_is_told_once_in_chinese(how):
    assert "宽 20.8 至 30 mm，刚度比" in user_units.worded(f"{how} {TAKEN.format('20.8 to 30 mm wide')}")
    even = user_units.worded(f"{how} {TAKEN.format('30 mm wide')}")
    assert even.endswith("可以弯成这条曲线：宽 30 mm，刚度比 1.44，应变为板材承受值的 80 %。")


@pytest.mark.usefixtures("chinese")
def test_lines_of_a_card_are_told_each_for_itself():
    crossed = (
        "The line through its inflections crosses the curve at 45.68 and 497.4 mm, where the moment would vanish "
        "or change sign and the curvature does not: move the curve off the line there, or support the strip "
        "between there and the inflections beside it."
    )
    alone = user_units.worded(crossed)
    assert "at " not in alone
    assert (
        user_units.worded(f"{crossed}\nThe nearest curve is 13.4 mm away.")
        == f"{alone}\n最近曲线距此 13.4 mm。"
    )


@pytest.mark.usefixtures("german")
def test_a_strip_that_breaks_says_so_in_german(document, sketch):
    from freecad.elastica_wb.features import strip

    made = strip.create(document, sketch)
    made.Thickness = 4
    document.recompute()
    said = " ".join([made.Verdict, *made.Reasons])
    assert "Streifen" in said
    assert not re.search(r"\b(the|strain|curve)\b", said), said


@pytest.mark.usefixtures("german")
def test_on_which_side_the_backing_lies_is_told_in_german(document, sketch):
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
]
ENGLISH = re.compile(r"\b(the|it|and|values|give|leave|such|must|make|use|one|keep|deeper|positive|is)\b")


@pytest.mark.usefixtures("german")
@pytest.mark.parametrize("asked", REFUSED, ids=" ".join)
def test_refused_properties_are_told_in_german(document, sketch, asked):
    from freecad.elastica_wb.features import strip

    made = strip.create(document, sketch)
    for name, value in asked.items():
        if value is None:
            made.setExpression(name, "7")
        else:
            setattr(made, name, value)
    document.recompute()
    assert "Invalid" in made.State
    assert not ENGLISH.search(" ".join(made.Reasons)), made.Reasons


def test_a_line_that_cannot_be_read_is_told_what_its_property_takes(document, sketch):
    from freecad.elastica_wb.features import strip
    from freecad.elastica_wb.features.strip_request import KEEP_OUT_LINE, MASS_LINE, TAB_LINE, WEIGHT_LINE

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
    made.Gravity, made.Follow, made.KeepOut = False, "Nearest", ["junk"]
    document.recompute()
    assert KEEP_OUT_LINE in made.Reasons[0]


@pytest.mark.usefixtures("german")
def test_leaving_the_plane_is_told_in_german(monkeypatch):
    monkeypatch.setattr(user_units, "decimal_point", lambda: ",")
    tips = "it tips over sideways or twists out of its plane: guide it at the sides, or make it wider"
    said = user_units.worded(f"sideways margin -24.1 (unstable): {tips}")
    assert said.startswith("seitliche Reserve -24,1 (instabil): er kippt zur Seite oder dreht sich")
    assert user_units.worded("sideways ample: it stays in its plane") == (
        "seitlich reichlich: er bleibt in seiner Ebene"
    )


@pytest.mark.usefixtures("german")
def test_the_play_of_holders_is_told_in_german(monkeypatch):
    monkeypatch.setattr(user_units, "decimal_point", lambda: ",")
    said = user_units.worded("slot of Base leaves its tabs 0.3 mm across and -1.5 to +2 degrees")
    assert said == "Schlitz von Base lässt den Laschen 0,3 mm quer und -1,5 bis +2 Grad"


BLANKS = [
    "-0.004",
    "0.004",
    "stations = [0, 202], curvatures = [0, -0.01]",
    "stations = [0, 202], curvatures = [0, 0.01]",
]


@pytest.mark.parametrize("language", ["german", "chinese"])
@pytest.mark.parametrize("blank", BLANKS)
def test_blanks_bent_beforehand_are_told_in_other_languages(document, sketch, request, language, blank):
    from freecad.elastica_wb.features import strip

    request.getfixturevalue(language)
    made = strip.create(document, sketch)
    if "=" in blank:
        made.Blank = blank
    else:
        made.NaturalCurvature = float(blank)
    document.recompute()
    said = " ".join([made.Verdict, *made.Reasons])
    assert "Invalid" not in made.State, said
    assert not re.search(r"\b(bend|bent|beforehand|the|way|stands|its|strip|radius of|report)\b", said), said


def test_what_is_typed_elsewhere_has_the_name_of_its_property():
    told = sentences.translated(
        "The width of the strip has a kink at 20 mm, where the slope of the curvature jumps: "
        "smooth = 0.1, or --smooth 0.1, makes it a fair curve of degree 4 within 0.1 mm."
    )
    assert told.endswith("jumps: Smooth = 0.1 mm makes it a fair curve of degree 4 within 0.1 mm.")
    told = sentences.translated(
        "make it wider (max_width). To make it all the same, set ignore_limits (--ignore-limits)."
    )
    assert told == "make it wider (MaxWidth). To make it all the same, set Anyway."
    assert sentences.capital("too narrow") == "Too narrow"
    assert sentences.capital("rib: too narrow") == "rib: too narrow"
