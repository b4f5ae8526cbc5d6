"""Flat parts of copied strips, on demand, and in a drawing: by the menu's commands, as a person gives them."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
import FreeCADGui as Gui
from freecad.elastica_wb import make_strip
from inside import (
    ARCH,
    Dialog,
    answers,
    begun,
    button,
    choose,
    drag_in_tree,
    fit,
    open_panel,
    panel,
    picture,
    press,
    press_button,
    run,
    shown_message,
    sketch,
    trigger,
    until,
    wait,
    window,
)


def names(document):
    from freecad.elastica_wb.host.objects import feature_kind

    return sorted(feature_kind(obj) or obj.TypeId for obj in document.Objects)


def pasted(document):
    """Copy the strip with its sketch, paste it, and take that back."""
    choose(document.Strip)
    request = Dialog(lambda box: box.accept())
    trigger("Std_Copy")
    wait(600)
    request.stop()
    before = names(document)
    trigger("Std_Paste")
    until(lambda: len(document.Objects) > len(before) and document.Objects[-1].Shape.Volume > 0)
    flats = [obj for obj in document.Objects if obj.Name.startswith("Flat")]
    fit("Top")
    picture("1-pasted.png")
    found = [[obj.Strip.Name, obj.Shape.Volume, [*obj.Placement.Base]] for obj in flats]
    after = names(document)
    trigger("Std_Undo")
    until(lambda: names(document) == before)
    answers["undone"] = names(document) == before
    trigger("Std_Redo")
    until(lambda: names(document) == after)
    wait(500)
    answers["redone"] = names(document) == after
    return found


def drawn(document):
    """Put the flat part on a drawing, as TechDraw's command does it."""
    page = document.addObject("TechDraw::DrawPage", "Page")
    template = document.addObject("TechDraw::DrawSVGTemplate", "Template")
    folder = Path(App.getResourceDir()) / "Mod/TechDraw/Templates"
    template.Template = str(next(folder.rglob("A3_*.svg")))
    page.Template = template
    view = document.addObject("TechDraw::DrawViewPart", "View")
    page.addView(view)
    view.Source, view.Direction, view.XDirection = [document.Flat], App.Vector(0, 0, 1), App.Vector(1, 0, 0)
    view.X, view.Y, view.ScaleType, view.Scale = 210, 150, "Custom", 1.5
    document.recompute()
    until(lambda: len(view.getVisibleEdges()) > 4)
    page.ViewObject.doubleClicked()
    wait(1500)
    picture("2-drawing.png")
    return len(view.getVisibleEdges())


def pocket_of_outline():
    """A pocket with the outline of a strip as its profile; the strip then changes."""
    document = begun("Outline")
    strip = make_strip(sketch(document, ARCH))
    body = document.addObject("PartDesign::Body", "Body")
    block = document.addObject("PartDesign::AdditiveBox", "Block")
    block.Length, block.Width, block.Height, block.Placement.Base = 300, 200, 5, App.Vector(-50, -150, -5)
    body.addObject(block)
    document.recompute()
    choose(strip)
    press("Elastica_Outline")
    outline = until(lambda: document.Flat001.Shape.Area) and document.Flat001
    outline.Placement.Base = App.Vector(0, -80, 0)
    drag_in_tree(outline, body)
    until(lambda: outline in body.Group, 10)
    Gui.activateWorkbench("PartDesignWorkbench")
    Gui.ActiveDocument.ActiveView.setActiveObject("pdbody", body)
    choose(outline)
    press("PartDesign_Pocket")
    until(lambda: Gui.Control.activeDialog() and document.getObject("Pocket"))
    press_button()
    until(lambda: not Gui.Control.activeDialog())
    volumes = []
    for width in (30, 20):
        strip.MaxWidth = width
        document.Pocket.Length = 2
        document.recompute()
        volumes.append([300 * 200 * 5 - body.Shape.Volume, 2 * outline.Shape.Area])
    fit("Isometric")
    picture("3-pocket.png")
    answers["pocket"] = [outline.Label, document.Pocket.State, volumes]
    App.closeDocument(document.Name)


def export_of_an_array():
    """The flat part is chosen, but what is cut is what the array of its strip needs; Cancel leaves the list."""
    import Draft

    document = begun("Array")
    strip = make_strip(sketch(document, ARCH))
    Draft.make_polar_array(strip, 8, 360, App.Vector(75, -200, 0))
    document.recompute()
    open_panel("Elastica_Export", document.Flat)
    listed = panel().form.message.text()
    request = Dialog(lambda box: box.reject())  # where FreeCAD requests a folder
    press_button()
    until(lambda: panel().form.message.text() != listed)
    request.stop()
    picture("4-export.png")
    answers["list"] = [listed, panel().form.message.text()]
    button("Cancel")
    App.closeDocument(document.Name)


def work():
    from freecad.elastica_wb.host import dialogs

    window()
    pocket_of_outline()
    export_of_an_array()
    document = begun("Flats")
    sketch(document, ARCH)
    choose(document.Sketch)
    press("Elastica_Strip")
    until(lambda: document.getObject("Strip") is not None and Gui.Control.activeDialog())
    button()
    document.Strip.EngravedText = "RIB 7"
    document.recompute()
    answers["pasted"] = pasted(document)
    choose(document.Flat)
    trigger("Std_Delete")
    until(lambda: document.getObject("Flat") is None)
    choose(document.Strip)
    press("Elastica_Flat")
    until(lambda: names(document).count("Flat") == 2)
    answers["on demand"] = [obj.Strip.Name for obj in document.Objects if obj.Name.startswith("Flat")]
    steps = document.UndoCount
    trigger("Std_Undo")
    until(lambda: document.UndoCount < steps)
    answers["on demand, undone"] = names(document).count("Flat")
    trigger("Std_Redo")
    until(lambda: names(document).count("Flat") == 2)
    choose(document.Strip)
    press("Elastica_Flat")
    until(shown_message)
    answers["again"] = shown_message()
    for box in list(dialogs._open_boxes):
        box.close()
    answers["edges"] = drawn(document)


run(work)
