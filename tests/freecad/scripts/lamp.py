"""A lamp from an empty document to its files: one rib by the mouse, an array, rings at both ends."""

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCADGui as Gui
from inside import (
    OUT,
    QtWidgets,
    answers,
    begun,
    button,
    choose,
    click,
    fill,
    fit,
    open_panel,
    panel,
    picture,
    press,
    press_button,
    run,
    scroll_to,
    shown_message,
    trigger,
    type_into,
    typed,
    until,
    wait,
    window,
)
from sketching import draw, new_sketch

RIB = [(-60, 0, -90), (-85, 0, -45), (-95, 0, 0), (-85, 0, 45), (-60, 0, 90)]


def field(name):
    """A visible field of any panel, by the name that FreeCAD gave it."""
    fields = Gui.getMainWindow().findChildren(QtWidgets.QWidget, name)
    return next(one for one in fields if one.isVisible())


def array(strip):
    """Draft's polar array, its number typed."""
    choose(strip)
    trigger("Draft_PolarArray")
    until(lambda: field("spinbox_number").isVisible())
    type_into(field("spinbox_number"), "6")
    press_button("Ok")
    until(lambda: not Gui.Control.activeDialog())
    found = [obj for obj in strip.InList if obj.Label.startswith(("Array", "Polar"))]
    assert found, [obj.Label for obj in strip.InList]
    return found[0]


def tick(name):
    """A box of the open panel, by the mouse."""
    box = getattr(panel().form, name)
    scroll_to(box)
    click(box, at=box.rect().topLeft() + type(box.rect().center())(8, box.height() // 2))
    wait(100)


def work():
    window()
    Gui.activateWorkbench("DraftWorkbench")  # loads the array's command
    document = begun("Lamp")
    window()
    new_sketch("XZ")
    fit(height=240)
    draw(RIB)
    press_button("Close")
    until(lambda: Gui.ActiveDocument.getInEdit() is None)
    until(lambda: Gui.activeWorkbench().name() == "ElasticaWorkbench")
    press("Elastica_Strip")
    until(lambda: document.getObject("Strip") is not None and Gui.Control.activeDialog())
    strip = document.getObject("Strip")
    for name, words in (("MaxWidth", "22 mm"), ("StartTab", "16 mm"), ("EndTab", "16 mm")):
        typed(name, words)
    button()
    answers["strip"] = [strip.State, strip.Verdict, list(strip.Reasons)]
    lamp = array(strip)
    Gui.activateWorkbench("ElasticaWorkbench")
    fit("Isometric")
    open_panel("Elastica_Fixtures", lamp)
    tick("blocks")
    tick("rings")
    fill(panel(), ringSheet="mdf-3")
    picture("1-panel.png")
    button()
    rings = document.getObject("Rings")
    answers["rings"] = [rings.State, len(rings.Shape.Solids), list(rings.Reports)]
    answers["heights"] = [round(solid.CenterOfMass.z) for solid in rings.Shape.Solids]
    fit("Isometric")
    picture("2-lamp.png")
    Gui.ActiveDocument.setEdit(rings.Name)
    until(lambda: Gui.Control.activeDialog() and panel().form.isVisible())
    typed("Gap", "6 mm")
    answers["pairs"] = len(rings.Shape.Solids)
    picture("3-pairs.png")
    button()
    choose()
    press("Elastica_Nest")
    until(lambda: document.getObject("Nest") is not None)
    answers["nest"] = document.getObject("Nest").Sheets
    open_panel("Elastica_Export")
    (OUT / "files").mkdir()
    type_into(panel().form.folder, str(OUT / "files"))
    press_button("Ok")
    until(shown_message)
    answers["files"] = sorted(path.name for path in (OUT / "files").iterdir())
    answers["list"] = (OUT / "files" / "cut-list.csv").read_text().splitlines()
    texts = [path.read_text() for path in (OUT / "files").glob("*.step")]
    answers["colours"] = [len(set(re.findall(r"COLOUR_RGB[^)]*", text))) for text in texts]
    picture("4-exported.png")


run(work)
