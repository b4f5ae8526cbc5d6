"""A project that grows and changes: slots and holders follow a curve through undo, models go, rooms move."""

import sys
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
    at_rest,
    choose,
    click,
    dialog_button,
    drag,
    fit,
    keys,
    panel,
    press,
    run,
    scroll_to,
    sketch,
    still,
    told,
    trigger,
    type_into,
    until,
    window,
)

ACROSS = [(65, -40), (72, 0), (75, 50), (72, 100), (65, 140)]


def report():
    view = Gui.getMainWindow().findChild(QtWidgets.QTextEdit, "Report view")
    return view.toPlainText() if view is not None else ""


def open_panel(command, *things):
    choose(*things)
    press(command)
    until(lambda: Gui.Control.activeDialog() and panel().form.isVisible())
    at_rest()


def ok():
    boxes = Gui.getMainWindow().findChildren(QtWidgets.QDialogButtonBox)
    wanted = [box.button(QtWidgets.QDialogButtonBox.Ok) for box in boxes if box.isVisible()]
    scroll_to(next(one for one in wanted if one is not None))
    click(dialog_button("Ok"))
    until(lambda: not Gui.Control.activeDialog())


def deleted(obj):
    """The key Delete, and yes to what FreeCAD asks."""
    document, name = obj.Document, obj.Name
    choose(obj)
    asked = Dialog(lambda _: keys("alt+y"))
    trigger("Std_Delete")
    until(lambda: document.getObject(name) is None)
    asked.stop()


def project():
    """Two strips that cross, their model, its holders."""
    document = App.newDocument("Growing")
    document.UndoMode = 1
    Gui.activateWorkbench("ElasticaWorkbench")
    for name, points in (("Arch", ARCH), ("Across", ACROSS)):
        open_panel("Elastica_Strip", sketch(document, points, name=name))
        ok()
    open_panel("Elastica_Interlock", document.Strip, document.Strip001)
    ok()
    open_panel("Elastica_Fixtures", document.Model)
    ok()
    return document


def disagree(document):
    """By how much (mm3) the model and a flat part are not those of the strip's curve, and mm to its holders."""
    strip, model = document.Strip, document.Model
    own = next(one for one in model.Shape.Solids if one.BoundBox.YMin > -30)
    ends = [Part.Vertex(strip.Placement.multVec(App.Vector(x, 0, 0))) for x in (0, 150)]
    return [
        round(abs(own.Volume - document.Flat.Shape.Volume), 1),
        round(own.BoundBox.YMax - strip.Shape.BoundBox.YMax, 2),
        round(max(document.Fixtures.Shape.distToShape(end)[0] for end in ends), 2),
    ]


def undone(document):
    """A pole is dragged, the sketch closed: undo and redo bring model, flat part and holders along."""
    drawn = document.Arch
    fit("Top")
    Gui.ActiveDocument.setEdit(drawn.Name)
    until(lambda: Gui.ActiveDocument.getInEdit() is not None)
    drag((70, 80, 0), 4, (0, -8))
    Gui.ActiveDocument.resetEdit()
    until(lambda: Gui.ActiveDocument.getInEdit() is None)
    found = [disagree(document)]
    heights = [document.Strip.Shape.BoundBox.YMax]
    for command in ("Std_Undo", "Std_Undo", "Std_Redo", "Std_Redo"):
        names = len(document.UndoNames)
        trigger(command)
        until(lambda names=names: len(document.UndoNames) != names)
        still(lambda: [document.Strip.Shape.BoundBox.YMax, document.Model.Shape.Volume], 0.5)
        found.append(disagree(document))
        heights.append(document.Strip.Shape.BoundBox.YMax)
    return found, heights


def member(document):
    """A strip goes and comes back: what hangs on it is whole again."""
    deleted(document.Strip001)
    until(lambda: "Invalid" in document.Flat001.State)
    trigger("Std_Undo")
    until(lambda: "Invalid" not in document.Flat001.State, 10)
    return document.Flat001.State[-1]


def exported(document):
    """The flat part in sight has slots, and so have its files."""
    from freecad.elastica_wb.host import telling

    folder = OUT / "cut"
    folder.mkdir()
    open_panel("Elastica_Export", document.Flat)
    scroll_to(panel().form.folder)
    type_into(panel().form.folder, str(folder))
    scroll_to(dialog_button("Ok"))
    click(dialog_button("Ok"))
    until(told)
    for box in telling._told:
        box.close()
    return sorted(file.name for file in folder.iterdir())


def rooms(document):
    """Holders in a room of their own stay with strips that are outside, wherever the room goes."""
    room = document.addObject("App::Part", "Room")
    room.addObject(document.Fixtures)
    document.recompute()
    room.Placement.Base.z = 100
    document.recompute()
    box = document.Fixtures.Shape.BoundBox
    return box.Center.z + 100


def model_gone(document):
    """The strips that it hid are in sight again; undo hides them."""
    pair = [document.Strip, document.Strip001]
    hidden = [one.Visibility for one in pair]
    deleted(document.Model)
    seen = [one.Visibility for one in pair]
    trigger("Std_Undo")
    until(lambda: document.getObject("Model") is not None)
    return [hidden, seen, [one.Visibility for one in pair]]


def work():
    window()
    document = project()
    answers["undone"], answers["heights"] = undone(document)
    answers["member"] = member(document)
    answers["exported"] = exported(document)
    answers["rooms"] = rooms(document)
    answers["model gone"] = model_gone(document)
    answers["tracebacks"] = report().count("Traceback")


run(work)
