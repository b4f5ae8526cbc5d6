"""A workshop that measures its own sheets, and links, moves and renames what it has made."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
import FreeCADGui as Gui
import Part
from inside import (
    ARCH,
    QtWidgets,
    answers,
    at_rest,
    button,
    choose,
    click,
    fill,
    is_grey,
    keys,
    mouse,
    panel,
    picture,
    press,
    run,
    scroll_to,
    sketch,
    tree_row,
    trigger,
    typed,
    until,
    window,
)


def shown():
    """Wait for a panel of ours."""
    until(lambda: Gui.Control.activeDialog() and panel().form.isVisible())
    at_rest()


def pressed(name):
    scroll_to(getattr(panel().form, name))
    click(getattr(panel().form, name))
    at_rest()


def edited(obj):
    choose(obj)
    Gui.ActiveDocument.setEdit(obj.Name)
    shown()


def linked_sketch(document):
    """A strip from a link to a sketch."""
    drawn = sketch(document, ARCH)
    choose(drawn)
    trigger("Std_LinkMake")
    until(lambda: any(obj.TypeId == "App::Link" for obj in document.Objects))
    link = next(obj for obj in document.Objects if obj.TypeId == "App::Link")
    link.Placement = App.Placement(App.Vector(0, 400, 30), App.Rotation(App.Vector(1, 0, 0), 90))
    document.recompute()
    choose(link)
    answers["grey for a link"] = is_grey("Elastica_Strip")
    press("Elastica_Strip")
    shown()
    button()
    strip = document.getObject("Strip")
    place = link.Placement.multVec(drawn.Geometry[0].value(0.5))
    answers["strip of a link"] = [strip.State[-1], strip.Shape.distToShape(Part.Vertex(place))[0]]
    return strip


def calibrated(strip):
    """A coupon is measured: open documents offer the sheet, which is changed in the library then."""
    choose()
    press("Elastica_Coupon")
    shown()
    fill(panel(), sheet="birch-plywood-0.8")
    typed("readings", "120 = 14.5; 150 = 31")
    typed("name", "my ply")
    pressed("keep")
    button()
    edited(strip)
    box = panel().form.Sheet
    answers["offered"] = box.findData("my ply") >= 0
    fill(panel(), Sheet="my ply")
    until(lambda: strip.Sheet == "my ply")
    at_rest()
    button()
    press("Elastica_Sheets")
    shown()
    fill(panel(), sheets="my ply")
    typed("thickness", "0.95 mm")
    button("Save")
    from freecad.elastica_wb.features.strip import strip_of
    from freecad.elastica_wb.host.sheet_store import own_sheets, sheet_from_text

    until(lambda: strip.Thickness.Value == 0.95, 10)
    own = own_sheets()["my ply"]
    answers["grain"] = own.grain
    answers["follows"] = [strip.Thickness.Value, strip.State[-1]]
    answers["as thick as"] = strip.Shape.Volume / strip.Document.getObject("Flat").Shape.Volume
    answers["kept in the document"] = sheet_from_text("my ply", strip.SheetData) == own
    answers["made with"] = strip_of(strip).sheet == own


def not_lost():
    """A file of sheets with a slip in it is not written over."""
    from freecad.elastica_wb.host.sheet_store import own_sheets_file

    file = own_sheets_file()
    spoiled = file.read_text().replace("[sheets", "[sheets.", 1)
    file.write_text(spoiled)
    press("Elastica_Sheets")
    shown()
    typed("name", "another")
    button("Save")
    answers["refused"] = panel().form.message.text() if Gui.Control.activeDialog() else ""
    answers["not lost"] = file.read_text() == spoiled
    if Gui.Control.activeDialog():
        button("Cancel")
    file.unlink()


def held_in_place(document, strip):
    """Blocks for a link of a strip that stands elsewhere."""
    choose(strip)
    before = set(document.Objects)
    trigger("Std_LinkMake")
    until(lambda: set(document.Objects) - before)
    (link,) = set(document.Objects) - before
    link.Placement = App.Placement(App.Vector(500, 0, 0), App.Rotation(App.Vector(0, 0, 1), 40))
    document.recompute()
    choose(link)
    press("Elastica_Fixtures")
    shown()
    button()
    blocks = document.getObject("Fixtures")
    answers["blocks"] = [block.distToShape(link.Shape)[0] for block in blocks.Shape.Solids]
    link.Placement.Base.x = 700
    document.recompute()
    answers["blocks moved"] = [block.distToShape(link.Shape)[0] for block in blocks.Shape.Solids]


def renamed(document):
    """Sentences speak of things by the names that they have now."""
    ring = document.addObject("Part::Torus", "Ring")
    ring.Radius1, ring.Radius2 = 100, 20
    document.recompute()
    choose(ring)
    press("Elastica_Section")
    shown()
    fill(panel(), Family="about an axis", Axis="X")
    button()
    section = document.getObject("Section")
    answers["told"] = section.Reports[0].split(",")[0]
    tree, item = tree_row(ring)
    click(tree.viewport(), at=tree.visualItemRect(item).center())
    keys("F2")
    until(lambda: tree.viewport().findChildren(QtWidgets.QLineEdit), 10)
    keys("ctrl+a")
    mouse("type", "--delay", 15, "Hat")
    keys("Return")
    until(lambda: ring.Label == "Hat", 10)
    until(lambda: section.Reports[0].startswith("Hat"), 10)
    answers["told then"] = [ring.Label, section.Reports[0].split(",")[0]]
    trigger("Std_Undo")
    until(lambda: ring.Label == "Ring" and section.Reports[0].startswith("Ring"), 10)
    answers["told at last"] = [ring.Label, section.Reports[0].split(",")[0]]


def work():
    window()
    Gui.activateWorkbench("ElasticaWorkbench")
    document = App.newDocument("Workshop")
    document.UndoMode = 1
    strip = linked_sketch(document)
    calibrated(strip)
    not_lost()
    held_in_place(document, strip)
    renamed(document)
    picture("workshop.png")


run(work)
