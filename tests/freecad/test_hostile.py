"""What a careless or hostile user does: every object ends well or in one sentence."""

import FreeCAD as App
import pytest
from freecad.elastica_wb.features import baseplate, fixtures, flat, model, nest, proxy, strip
from freecad.elastica_wb.features.pieces import cuts_of

from elastica_cad import InputError
from tests.freecad.features import change, new

V = App.Vector
ARCH = [(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)]
WAVE = [(0, 0), (25, 55), (60, 45), (95, -50), (130, -40), (150, 0)]


def judged(document, *objects):
    """Recompute, and what each object says: "" for those that are well."""
    document.recompute()
    text = []
    for obj in objects:
        if "Invalid" in obj.State:
            sentence = obj.getStatusString()
            assert len(sentence) > 15, f"{obj.Label}: {sentence!r}"
            assert "Traceback" not in sentence
            assert "\n" not in sentence
            text.append(sentence)
        else:
            # what hangs on something that failed is left as it was
            assert obj.Shape.isNull() or obj.Shape.isValid()
            text.append("")
    return text


SPLINES = {
    "all in one place": [(0, 0)] * 5,
    "start thrice": [(0, 0), (0, 0), (0, 0), (70, 80), (120, 60), (150, 0)],
    "loop": [(0, 0), (150, 80), (-20, 120), (-20, -20), (100, 0)],
    "zigzag": [(i * 3, ((i * 7919) % 13) * 0.5) for i in range(200)],
    "a thousand poles": [(i, 0.001 * i * (1000 - i)) for i in range(1000)],
    "ends meet": [(0, 0), (50, 80), (100, 80), (100, -50), (0, 0)],
    "a kilometre": [(x * 1e5, y * 1e5) for x, y in ARCH],
    "an atom": [(x * 1e-8, y * 1e-8) for x, y in ARCH],
    "far away": [(x + 1e6, y - 1e6) for x, y in ARCH],
}


@pytest.mark.parametrize("name", SPLINES)
@pytest.mark.parametrize("degree", [3, 4])
def test_odd_splines(document, drawn, name, degree):
    feature = strip.create(document, drawn(SPLINES[name], degree))
    part = flat.create(document, feature)
    judged(document, feature, part)


def test_a_size_out_of_range_names_no_option_of_files(document, drawn):
    """Only files have an option for their unit."""
    (text,) = judged(document, strip.create(document, drawn(SPLINES["a kilometre"])))
    assert text.endswith(", outside 0.001 to 1000000 mm. Check the unit.")


@pytest.mark.parametrize("weights", [[1, 1e6, 1, 1e-6, 1], [1e-12, 1, 1, 1, 1], [1, 1, 1, 1, 1e12]])
def test_odd_weights(document, drawn, weights):
    judged(document, strip.create(document, drawn(ARCH, 4, weights)))


@pytest.mark.parametrize(
    ("name", "value", "says"),
    [
        ("MaxWidth", 1e12, "hundred metres"),
        ("StartTab", 1e9, "hundred metres"),
        ("Thickness", 1e-6, "foil"),
        ("Thickness", 1e3, "would fold there"),
        ("Samples", -5, "1 or more"),
        ("Samples", 200_000, "above the limit of 10000"),
        ("Quantity", 0, ""),
        ("NaturalCurvature", float("nan"), "finite"),
        ("NaturalCurvature", float("inf"), "finite"),
        ("EngravedText", "x" * 3000, "200"),
        ("EngravedText", "../äöü漢字\"'<>&", ""),
        ("EngravedText", "two\nlines", "printable"),
        ("Columns", 0, "columns"),
        ("Columns", 100_000, "above the limit of 10000"),
        ("Rows", -1, "rows"),
        ("OuterWidth", 0, "width"),
    ],
)
def test_odd_numbers(document, drawn, name, value, says):
    feature = strip.create(document, drawn(WAVE))
    feature.Sheet = "card-200gsm"
    if name in ("Columns", "Rows", "OuterWidth"):
        feature.Style = "Perforated"
        feature.OuterWidth = 60
    setattr(feature, name, value)
    (text,) = judged(document, feature, flat.create(document, feature))[:1]
    assert says in text
    assert bool(says) == bool(text)


def test_edges_of_solids(document):
    box, cylinder = document.addObject("Part::Box", "Box"), document.addObject("Part::Cylinder", "Cylinder")
    ball, helix = document.addObject("Part::Sphere", "Ball"), document.addObject("Part::Helix", "Helix")
    document.recompute()
    round_edge = next(f"Edge{i}" for i, e in enumerate(cylinder.Shape.Edges, 1) if e.isClosed())
    options = [
        (box, ("Edge1",), ""),
        (box, ("Edge1", "Edge2"), "corner"),
        (box, ("Edge1", "Edge7"), "chains"),
        (box, (), "many edges"),
        (box, ("Face1",), "corner"),
        (box, ("Vertex1",), "no curve"),
        (box, ("Edge99",), "no longer has Edge99"),
        (box, ("nonsense",), "no longer has nonsense"),
        (cylinder, (round_edge,), ""),
        (ball, ("Edge1",), "degenerate"),
        (helix, (), "plane"),
    ]
    made = [strip.create(document, source, edges) for source, edges, _ in options]
    for one in made:
        one.Sheet = "card-200gsm"
    for text, (_, edges, says) in zip(judged(document, *made), options, strict=True):
        assert says in text, edges
        assert bool(says) == bool(text)


def test_things_without_a_curve(document):
    kinds = (
        "App::DocumentObjectGroup",
        "Spreadsheet::Sheet",
        "App::Part",
        "App::FeaturePython",
        "Mesh::Feature",
    )
    made = [strip.create(document, document.addObject(kind, "Thing")) for kind in kinds]
    assert all("has no shape" in text for text in judged(document, *made))


def test_wrong_and_lost_sources(document, sketch):
    box = document.addObject("Part::Box", "Box")
    bent = strip.create(document, sketch)
    part = flat.create(document, bent)
    part.Strip = box
    made = [
        model.create(document, [box]),
        fixtures.create(document, [box]),
        baseplate.create(document, [sketch]),
        nest.create(document, [box]),
        nest.create(document, []),
        part,
    ]
    assert all(judged(document, *made))
    whole = model.create(document, [bent])
    users = [maker.create(document, [whole]) for maker in (baseplate, nest)]
    users[0].Placement.Base = V(0, 0, -2)
    document.recompute()
    document.removeObject(bent.Name)
    for obj in (whole, *users):
        obj.touch()
    assert all(judged(document, whole, part))
    document.removeObject(whole.Name)
    assert all(judged(document, *users))


def test_curve_of_its_own_shape(document, sketch):
    feature = new(strip.create, document, sketch)
    change(feature, Curve=(feature, ["Edge1"]))
    feature.Curve = None
    assert "missing" in judged(document, feature)[0]
    feature.Curve = (sketch, [])
    assert judged(document, feature) == [""]


def test_expressions_that_go_wrong(document, sketch):
    feature = strip.create(document, sketch)
    cells = document.addObject("Spreadsheet::Sheet", "Numbers")
    for value, says in (("=-5 mm", "positive"), ("=0 mm", "positive|thickness"), ("=0.8 mm", "")):
        cells.set("A1", value)
        cells.setAlias("A1", "value")
        document.recompute()
        feature.setExpression("Thickness", "Numbers.value")
        text = judged(document, feature)[0]
        assert bool(text) == bool(says)
    cells.set("A1", "=1/0")
    document.recompute()
    assert feature.Shape.isValid(), "the last good shape is kept"
    cells.set("A1", "=0.8 mm")
    assert judged(document, feature) == [""]


@pytest.mark.parametrize("lost", ["cell", "sheet"])
def test_a_formula_that_cannot_be_computed(document, sketch, lost):
    """FreeCAD keeps the number of before and asks nobody: that shape was shown, and cut, without a word."""
    feature = strip.create(document, sketch)
    made = [feature, flat.create(document, feature), nest.create(document, [feature])]
    cells = document.addObject("Spreadsheet::Sheet", "Numbers")
    cells.set("A1", "=14 mm")
    cells.setAlias("A1", "breadth")
    document.recompute()
    feature.setExpression("MaxWidth", "Numbers.breadth")
    document.recompute()
    if lost == "cell":
        cells.set("A1", "=1/0")
        says = r"^Numbers cannot be made \(.*\). Correct this object first.$"
    else:
        document.removeObject(cells.Name)
        says = (
            r'^FreeCAD cannot compute the formula of "Largest width" \(.*Numbers.*\). '
            r"Correct or remove the formula.$"
        )
    document.recompute()
    with pytest.raises(InputError, match=says):
        cuts_of([feature])
    proxy.give_up(document)  # what a window is told
    assert [one.Visibility for one in made] == [False] * 3
    assert feature.Verdict == "There is no strip."
    (text,) = feature.Reasons
    feature.setExpression("MaxWidth", None)
    feature.MaxWidth = 20
    if lost == "cell":
        cells.set("A1", "=14 mm")
    document.recompute()
    assert [one.Visibility for one in made] == [True] * 3
    assert [one.State for one in made] == [["Up-to-date"]] * 3
    assert feature.Reasons == [], text
    assert [cut.piece.size[1] for cut in cuts_of([feature])] == pytest.approx([20])


def test_a_backing_of_a_strip_whose_curve_was_deleted(document, sketch):
    """Laminate adds it whether there is a curve or not."""
    feature = new(strip.create, document, sketch)
    document.removeObject(sketch.Name)
    feature.Style = "Laminated"
    backing = flat.create(document, feature, "Backing")
    assert "the curve is missing" in judged(document, feature, backing)[0]
    feature.Curve = (document.addObject("App::FeaturePython", "Text"), [])
    flat.create(document, feature)
    assert "has no shape" in judged(document, feature)[0]


@pytest.mark.parametrize("data", ["not toml ][", '[sheets.nope]\nthickness = "a"\n', "[sheets]\n", ""])
def test_a_sheet_that_nobody_knows(document, sketch, data):
    feature = strip.create(document, sketch)
    feature.Sheet = ["nope"]
    feature.Sheet = "nope"
    feature.SheetData = data
    assert judged(document, feature)[0]
