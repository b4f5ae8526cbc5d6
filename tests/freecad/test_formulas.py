"""Choices that are given by formulas: what is none of them is told with its property and its formula."""

import pytest
from freecad.elastica_wb.features import baseplate, curves, flat, flexure, model, proxy, strip
from freecad.elastica_wb.features.pieces import cuts_of
from freecad.elastica_wb.features.proxy import Feature
from freecad.elastica_wb.host.sheet_store import sheet_list

from elastica_cad import InputError


def message_of(obj):
    obj.Document.recompute()
    return str(obj.getStatusString()) if "Invalid" in obj.State else ""


@pytest.fixture
def made(document, sketch):
    return strip.create(document, sketch)


@pytest.mark.parametrize(
    ("name", "formula", "gives", "takes"),
    [
        ("Style", "5", "5", "0 to 2, or a name such as <<Plain>>"),
        ("Style", "-1", "-1", "0 to 2, or a name such as <<Plain>>"),
        ("Style", "<<Nope>>", "Nope", "0 to 2, or a name such as <<Plain>>"),
        ("Form", "2", "2", "0 to 1, or a name such as <<Bent>>"),
        ("KeepEnds", "9", "9", "0 to 3, or a name such as <<both>>"),
        ("Sheet", "1000", "1000", "such as <<"),
    ],
)
def test_a_formula_out_of_range_is_reported(made, name, formula, gives, takes):
    made.setExpression(name, formula)
    text = message_of(made)
    assert text.startswith(f"Strip.{name} has the formula {formula}, which gives {gives}. Use 0 to ")
    assert takes in text
    assert text.endswith(". Correct or remove the formula.")
    assert made.Reasons == [text]
    with pytest.raises(InputError, match="Correct or remove the formula"):
        cuts_of([made])
    made.setExpression(name, "0")
    assert message_of(made) == ""


def test_a_formula_within_range_is_taken(document, made):
    cells = document.addObject("Spreadsheet::Sheet", "Cells")
    cells.set("A1", "1")
    cells.setAlias("A1", "kind")
    made.Anyway = True  # two layers of plywood would break
    for formula, style in (("Cells.kind", "Perforated"), ("<<Laminated>>", "Laminated"), ("0.9", "Plain")):
        made.setExpression("Style", formula)
        assert [message_of(made), made.Style] == ["", style]
    made.setExpression("Style", "Cells.kind")
    cells.set("A1", "3")
    assert message_of(made).startswith("Strip.Style has the formula Cells.kind, which gives 3. ")


@pytest.mark.parametrize("formula", ["7", "-1", "3", "1e9", "<<Nope>>", "<<>>"])
def test_a_formula_that_is_taken_away_leaves_what_was_chosen(made, formula):
    made.Style = "Perforated"
    made.setExpression("Style", formula)
    assert message_of(made) != ""
    made.setExpression("Style", None)
    made.touch()
    assert [message_of(made), made.Style] == ["", "Perforated"]
    made.Style = "Plain"
    assert [message_of(made), made.Style] == ["", "Plain"]


@pytest.mark.campaign
def test_every_list_of_choices_outlives_its_formula(document, made):
    document.recompute()  # what has a shape can be cut into sections
    everything = [
        made,
        flat.create(document, made),
        model.create(document, [made]),
        baseplate.create(document, [made]),
        curves.section(document, [made]),
        curves.nearest(document, made.Curve[0]),
        baseplate.create_rings(document, [made]),
        flexure.create(document, made.Curve[0], (), made.Curve[0], ()),
    ]
    with_choices = {kind for kind in Feature.__subclasses__() if kind.choices}
    assert with_choices == {type(obj.Proxy) for obj in everything}
    for obj in everything:
        for name in obj.Proxy.choices:
            choices, first = obj.getEnumerationsOfProperty(name), getattr(obj, name)
            for formula, chosen in ((str(len(choices)), first), ("<<Nope>>", choices[-1])):
                setattr(obj, name, chosen)
                obj.setExpression(name, formula)
                document.recompute()
                assert "Invalid" in obj.State
                assert [getattr(obj, name), obj.getEnumerationsOfProperty(name)] == [chosen, choices]
                obj.setExpression(name, None)
            setattr(obj, name, first)
            for choice in choices:
                setattr(obj, name, choice)
                assert getattr(obj, name) == choice
            setattr(obj, name, first)


@pytest.mark.parametrize("formula", ["1000", "<<Nope>>"])
def test_a_formula_that_gives_no_sheet_leaves_the_thickness(made, formula):
    made.Sheet = sheet_list()[-1]
    made.Thickness, sheet, kept = 1.3, made.Sheet, made.SheetData
    made.setExpression("Sheet", formula)
    assert message_of(made) != ""
    assert [made.Sheet, made.Thickness.Value, made.SheetData] == [sheet, 1.3, kept]


def test_a_word_that_comes_and_goes_leaves_what_was_chosen_before(document, made):
    cells = document.addObject("Spreadsheet::Sheet", "Cells")
    cells.set("A1", "Perforated")
    cells.setAlias("A1", "kind")
    document.recompute()
    made.setExpression("Style", "Cells.kind")
    assert [message_of(made), made.Style] == ["", "Perforated"]
    for word in ("Perforatd", "Nope"):
        cells.set("A1", word)
        assert message_of(made).startswith(f"Strip.Style has the formula Cells.kind, which gives {word}. ")
        assert made.Style == "Perforated"
    cells.set("A1", "Plain")
    assert [message_of(made), made.Style] == ["", "Plain"]
    cells.set("A1", "Nope")
    assert message_of(made) != ""
    assert made.Style == "Plain"


def test_other_features_report_it_too(document, made):
    twin, whole = flat.create(document, made), model.create(document, [made])
    twin.setExpression("Layer", "2")
    whole.setExpression("Fit", "2")
    document.recompute()
    assert message_of(twin).startswith("Flat.Layer has the formula 2, which gives 2. Use 0 to 1, ")
    assert message_of(whole).startswith("Model.Fit has the formula 2, ")


def test_a_formula_whose_spreadsheet_is_gone(document, made):
    cells = document.addObject("Spreadsheet::Sheet", "Cells")
    cells.set("A1", "1")
    document.recompute()
    made.setExpression("Style", "Cells.A1")
    assert message_of(made) == ""
    document.removeObject(cells.Name)
    with pytest.raises(
        InputError, match=r"FreeCAD cannot compute the formula of Style \(Cells.A1\). Correct or"
    ):
        strip.strip_of(made)
    assert strip.is_stale(made, {made.Name})


def test_another_sheet_library_while_a_formula_gives_no_sheet(document, made, monkeypatch):
    made.setExpression("Sheet", "1000")
    text = message_of(made)
    monkeypatch.setattr(proxy, "sheet_list", lambda: ["my-ply", *sheet_list()])
    proxy.keep_sheets()
    assert made.getStatusString() == text.replace(
        f"to {len(sheet_list()) - 1},", f"to {len(sheet_list())},"
    ).replace(f"<<{sheet_list()[0]}>>", "<<my-ply>>")
    made.setExpression("Sheet", "1")
    assert message_of(made) == ""
    assert made.Sheet == sheet_list()[0]
