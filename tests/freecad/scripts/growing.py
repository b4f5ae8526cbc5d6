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
    drag,
    fit,
    keys,
    open_panel,
    panel,
    press,
    press_button,
    report,
    run,
    scroll_to,
    shown_message,
    sketch,
    still,
    trigger,
    type_into,
    until,
    window,
)

ACROSS = [(65, -40), (72, 0), (75, 50), (72, 100), (65, 140)]


def ok():
    boxes = Gui.getMainWindow().findChildren(QtWidgets.QDialogButtonBox)
    wanted = [box.button(QtWidgets.QDialogButtonBox.Ok) for box in boxes if box.isVisible()]
    scroll_to(next(one for one in wanted if one is not None))
    press_button("Ok")
    until(lambda: not Gui.Control.activeDialog())


def deleted(obj):
    """The key Delete, and yes to what FreeCAD asks."""
    document, name = obj.Document, obj.Name
    choose(obj)
    request = Dialog(lambda _: keys("alt+y"))
    trigger("Std_Delete")
    until(lambda: document.getObject(name) is None)
    request.stop()


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
    from freecad.elastica_wb.host import dialogs

    folder = OUT / "cut"
    folder.mkdir()
    open_panel("Elastica_Export", document.Flat)
    scroll_to(panel().form.folder)
    type_into(panel().form.folder, str(folder))
    press_button("Ok")
    until(shown_message)
    for box in dialogs._open_boxes:
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


def cancel():
    press_button("Cancel")
    until(lambda: not Gui.Control.activeDialog())


def in_error():
    """A strip that cannot be made: what is to be made from it says why, and leaves nothing behind."""
    from freecad.elastica_wb.host import dialogs

    document = App.newDocument("Error")
    document.UndoMode = 1
    for name, points in (("Arch", ARCH), ("Across", ACROSS)):
        open_panel("Elastica_Strip", sketch(document, points, name=name))
        ok()
    narrow = document.Strip
    narrow.MaxWidth = 2
    document.recompute()
    before = len(document.Objects)
    open_panel("Elastica_Fixtures", narrow)
    press_button("Ok")
    until(lambda: not Gui.Control.activeDialog() or "wide" in panel().form.message.text(), 10)
    found = [panel().form.message.text() if Gui.Control.activeDialog() else "closed"]
    cancel() if Gui.Control.activeDialog() else None
    choose(narrow)
    press("Elastica_Nest")
    until(shown_message, 10)
    found.append(shown_message())
    for box in dialogs._open_boxes:
        box.close()
    open_panel("Elastica_Interlock", narrow, document.Strip001)
    found.append(panel().form.message.text())
    answers["other in sight"] = document.Strip001.Visibility
    cancel()
    answers["left behind"] = len(document.Objects) - before
    document.Strip001.StartTab = 700  # longer than the sheet
    document.recompute()
    choose(document.Strip001)
    press("Elastica_Nest")
    until(shown_message, 10)
    found.append(shown_message())
    App.closeDocument(document.Name)
    return found


def halved():
    """Closed sections of a ball in halves: the halves meet, and each is a strip of its own."""
    document = App.newDocument("Ball")
    document.UndoMode = 1
    ball = document.addObject("Part::Sphere", "Ball")
    ball.Radius = 60
    document.recompute()
    open_panel("Elastica_Section", ball)
    field = panel().form.Closed
    scroll_to(field)
    click(field)
    keys("End", "Return")
    until(lambda: document.Section.Closed == "above and below")
    at_rest()
    ok()
    open_panel("Elastica_Strip", document.Section)
    ok()
    strips = [obj for obj in document.Objects if hasattr(obj, "StrainUse")]
    found = [len(document.Section.Shape.Edges), len(strips), {tuple(obj.State) for obj in strips}]
    App.closeDocument(document.Name)
    return found


def model_gone(document):
    """The strips that it hid are in sight again; undo hides them."""
    pair = [document.Strip, document.Strip001]
    hidden = [one.Visibility for one in pair]
    deleted(document.Model)
    seen = [one.Visibility for one in pair]
    trigger("Std_Undo")
    until(lambda: document.getObject("Model") is not None)
    return [hidden, seen, [one.Visibility for one in pair]]


def gone_in_error(document):
    """A strip that cannot be made stays hidden where its model goes, until it can."""
    pair = [document.Strip, document.Strip001]
    drawn = pair[0].Curve[0]
    good, drawn.Geometry = list(drawn.Geometry), []
    document.recompute()
    in_sight = document.Model.Visibility
    deleted(document.Model)
    seen = [one.Visibility for one in pair]
    drawn.Geometry = good
    document.recompute()
    return [in_sight, seen, [one.Visibility for one in pair]]


def work():
    window()
    document = project()
    answers["undone"], answers["heights"] = undone(document)
    answers["member"] = member(document)
    answers["exported"] = exported(document)
    answers["rooms"] = rooms(document)
    answers["model gone"] = model_gone(document)
    answers["gone in error"] = gone_in_error(document)
    answers["halved"] = halved()
    answers["in error"] = in_error()
    answers["tracebacks"] = report().count("Traceback")


run(work)
