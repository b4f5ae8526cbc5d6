"""What goes wrong at a maker's desk, how it is undone, and curves that others drew."""

import sys
from itertools import pairwise
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
import FreeCADGui as Gui
import Part
from inside import (
    ARCH,
    OUT,
    Dialog,
    QtWidgets,
    answers,
    begun,
    button,
    choose,
    click,
    drag_in_tree,
    fit,
    open_panel,
    panel,
    picture,
    press,
    run,
    shown_message,
    sketch,
    still,
    trigger,
    typed,
    until,
    window,
)

UPRIGHT = App.Placement(App.Vector(), App.Rotation(App.Vector(1, 0, 0), 90))
BESIDE = App.Placement(App.Vector(0, 80, 0), App.Rotation(App.Vector(1, 0, 0), 90))


def seen(document):
    """Which of the features are in sight."""
    return {obj.Label: obj.Visibility for obj in document.Objects if hasattr(obj, "HiddenByError")}


def strip_on(document, name, place):
    drawn = sketch(document, ARCH, name=name, poles=False)
    drawn.Placement = place
    open_panel("Elastica_Strip", drawn)
    button()
    return document.Objects[-2]


def strips_within_each_other():
    """A model of them fails: its strips are what shows why."""
    document = begun("Within")
    strips = [strip_on(document, name, UPRIGHT) for name in ("One", "Other")]
    open_panel("Elastica_Interlock", *strips)
    answers["told in the panel"] = panel().form.message.text()
    button()
    answers["made in error"] = seen(document)
    fit("Isometric")
    picture("within.png")
    other = document.Other
    for name, place in (("apart", BESIDE), ("within again", UPRIGHT)):
        document.openTransaction(name)
        other.Placement = place
        document.commitTransaction()
        trigger("Std_Refresh")
        until(lambda: not document.isTouched())
        answers[name] = seen(document)
    trigger("Std_Undo")
    until(lambda: document.Model.Visibility)
    answers["undone"] = seen(document)
    App.closeDocument(document.Name)


def undone_and_redone():
    """Undo and redo leave nothing marked as if it were to be made anew."""
    document = begun("Undone")
    one = strip_on(document, "One", UPRIGHT)
    open_panel("Elastica_Perforate", one)
    button()
    choose(one)
    press("Elastica_Nest")
    until(lambda: document.getObject("Nest"))
    Gui.ActiveDocument.setEdit("Nest")
    until(lambda: Gui.Control.activeDialog() and panel().form.isVisible())
    typed("SheetWidth", "800 mm")
    button()
    for command, number in (("Std_Undo", 3), ("Std_Redo", 3)):
        for _ in range(number):
            trigger(command)
            until(lambda: not document.isTouched(), 5)
            marked = [obj.Name for obj in document.Objects if "Touched" in obj.State]
            answers.setdefault("marked", []).append(marked)
    App.closeDocument(document.Name)


def undone_in_containers():
    """A strip goes into a moved container, or that moves: the sketch and the blocks go with the strip."""
    document = begun("Contained")
    part = document.addObject("App::Part", "Part")
    one = strip_on(document, "One", UPRIGHT)
    open_panel("Elastica_Fixtures", one)
    button()
    blocks = document.Fixtures
    part.Placement.Base.z = 200
    document.recompute()

    def heights():
        if document.isTouched():  # a drop in the tree recomputes
            trigger("Std_Refresh")
        until(lambda: not document.isTouched(), 5)
        found = []
        for obj in (one, blocks):
            inside = obj.getParentGeoFeatureGroup() is part
            found.append(round(obj.Shape.BoundBox.Center.z + inside * part.Placement.Base.z, 3))
        return found

    answers["before"] = heights()
    drag_in_tree(one, part)
    until(lambda: one in part.Group, 10)
    picture("contained.png")
    answers["in containers"] = [heights()]
    document.openTransaction("move it")
    part.Placement.Base.z = 300
    document.commitTransaction()
    answers["in containers"].append(heights())
    for command in ("Std_Undo", "Std_Undo", "Std_Redo", "Std_Redo"):
        trigger(command)
        answers["in containers"].append(still(heights))
    App.closeDocument(document.Name)


def curves_of_other_hands():
    """What FreeCAD reads from files: a filled shape of a drawing, a polyline as lines."""
    import importSVG

    document = begun("Read")
    drawing = OUT / "filled.svg"
    drawing.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="150mm" viewBox="0 0 200 150">'
        "<!-- Created with Inkscape (http://www.inkscape.org/) -->"
        '<circle id="ring" cx="80" cy="70" r="60" fill="#cccccc"/></svg>'
    )
    request = Dialog(lambda box: box.button(QtWidgets.QMessageBox.Yes).click())  # 96 dots in an inch?
    importSVG.insert(str(drawing), document.Name)
    request.stop()
    filled = document.Objects[0]
    answers["filled"] = filled.Shape.ShapeType
    open_panel("Elastica_Strip", filled)
    answers["strip on it"] = panel().form.message.text()
    button("Cancel")
    corners = [(0, 0), (40, 35), (90, 45), (150, 0)]
    lines = []
    for start, end in pairwise(corners):
        lines.append(document.addObject("Part::Feature", "Line"))
        lines[-1].Shape = Part.makeLine(App.Vector(*start, 0), App.Vector(*end, 0))
    before = len(document.Objects)
    choose(*lines)
    press("Elastica_Strip")
    until(shown_message)
    answers["lines"] = [shown_message(), len(document.Objects) - before]
    click(QtWidgets.QApplication.activeWindow().findChild(QtWidgets.QPushButton))
    until(lambda: not shown_message())
    polygon = document.addObject("Part::Feature", "Polygon")
    polygon.Shape = Part.makePolygon([App.Vector(*place, 0) for place in corners])
    open_panel("Elastica_Strip", polygon)
    answers["polygon"] = panel().form.message.text()
    button("Cancel")
    App.closeDocument(document.Name)


def work():
    window()
    for one in (strips_within_each_other, undone_and_redone, undone_in_containers, curves_of_other_hands):
        one()


run(work)
