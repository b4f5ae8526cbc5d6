"""Lengths in the unit that the user reads; the preference, the sentences and what FreeCAD's page keeps."""

from pathlib import Path
from xml.etree import ElementTree

import FreeCAD as App
import pytest
from freecad.elastica_wb.features import strip
from freecad.elastica_wb.host import preferences
from freecad.elastica_wb.host.words import Unit, shown_unit

from tests.freecad.features import change

INCH = Unit("in", 25.4)
UI = Path(__file__).resolve().parents[2] / "freecad_workbench" / "resources" / "ui" / "preferences.ui"


@pytest.fixture
def schema():
    """`schema(number)`: FreeCAD's own preference of units."""
    before = App.ParamGet("User parameter:BaseApp/Preferences/Units").GetInt("UserSchema", 0)
    yield App.Units.setSchema
    App.Units.setSchema(before)


def test_freecads_units_rule(schema):
    assert shown_unit() == Unit("mm", 1.0)
    for number, unit in ((2, INCH), (3, INCH), (4, Unit("cm", 10.0)), (7, Unit("ft", 304.8))):
        schema(number)
        assert shown_unit().name == unit.name
        assert shown_unit().size == pytest.approx(unit.size)


def test_features_speak_it(document, sketch, schema):
    schema(3)
    feature = strip.create(document, sketch)
    change(feature, TabHole=12.7)
    assert " in " in feature.getStatusString()
    assert " mm" not in feature.getStatusString()
    assert " mm" not in " ".join(feature.Reasons)


def test_choices_are_those_of_the_page():
    """FreeCAD keeps the number of a choice."""
    boxes = [
        w for w in ElementTree.parse(UI).getroot().iter("widget") if w.get("class") == "Gui::PrefComboBox"
    ]
    assert len(boxes) == len(preferences.CHOICES)
    for box in boxes:
        entry = next(p for p in box.iter("property") if p.get("name") == "prefEntry").findtext("cstring")
        items = [item.findtext("property/string") for item in box.findall("item")]
        assert [item.replace("as ", "") for item in items] == list(preferences.CHOICES[entry])
        assert preferences.CHOICES[entry][0] == preferences.DEFAULTS[entry]
    group = App.ParamGet(preferences.PATH)
    group.SetInt("DxfVersion", 2)
    try:
        assert preferences.get("DxfVersion") == "R2000"
        group.SetInt("DxfVersion", 99)
        assert preferences.get("DxfVersion") == "R2010"
    finally:
        group.RemInt("DxfVersion")
