"""Every button in every state is grey or does something that is seen; undo in a large document."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import time

import FreeCAD as App
import FreeCADGui as Gui
from inside import (
    ARCH,
    OUT,
    QtWidgets,
    answers,
    choose,
    click,
    dialog_button,
    is_grey,
    picture,
    report,
    run,
    shown_message,
    sketch,
    still,
    toolbar_button,
    until,
    wait,
    window,
)

answers["trouble"], answers["grey"], answers["pressed"] = [], {}, 0


def strangers():
    """What filters make of a widget that PySide hands them for an event."""
    from freecad.elastica_wb.host.fields import _InputFilter
    from freecad.elastica_wb.host.qt import EscapeKey, QtCore, kind_of

    found = [_InputFilter().eventFilter(QtWidgets.QLineEdit(), QtWidgets.QGraphicsView())]
    found += [EscapeKey().eventFilter(None, QtWidgets.QGraphicsView())]
    return [*found, kind_of(QtCore.QEvent(QtCore.QEvent.Wheel)) == QtCore.QEvent.Wheel]


answers["strangers"] = strangers()


def put_away():
    """Close what the button opened."""
    from freecad.elastica_wb.host import dialogs

    for box in dialogs._open_boxes:
        box.close()
    if Gui.Control.activeDialog():
        for kind in ("Cancel", "Close"):
            button = dialog_button(kind)
            if button is not None:
                click(button)
                until(lambda: not Gui.Control.activeDialog(), 5)
                break
    wait(100)
    if Gui.ActiveDocument is not None and Gui.ActiveDocument.getInEdit() is not None:
        Gui.ActiveDocument.resetEdit()
    if Gui.Control.activeDialog():
        Gui.Control.closeDialog()


def press_all(state, prepare):
    """Press every button that is not grey by the mouse; something must be seen of each."""
    from freecad.elastica_wb import commands
    from freecad.elastica_wb.live import session as live

    names = [name for bar in commands.TOOLBARS.values() for name in bar if name.startswith("Elastica")]
    grey = []
    for name in names:
        document = App.newDocument("State")
        document.UndoMode = 1
        Gui.activateWorkbench("ElasticaWorkbench")
        prepare(document)
        Gui.activateWorkbench("ElasticaWorkbench")
        until(lambda name=name: toolbar_button(name) is not None)
        if is_grey(name):
            grey.append(name)
        else:
            seen, before = len(report()), (len(document.Objects), live.session() is not None)
            click(toolbar_button(name))
            answers["pressed"] += 1

            def seen_of_it(document=document, before=before):
                after = (len(document.Objects), live.session() is not None)
                return Gui.Control.activeDialog() or shown_message() or after != before

            if not until(seen_of_it):
                answers["trouble"].append(f"{name} in {state}: nothing is seen")
            if "Traceback" in report()[seen:] or "Error:" in report()[seen:]:
                answers["trouble"].append(f"{name} in {state}: {report()[seen:][-600:]}")
        put_away()
        App.closeDocument(document.Name)
    answers["grey"][state] = grey


def strip_in(document):
    from freecad.elastica_wb.features import flat, strip

    made = strip.create(document, sketch(document, ARCH))
    flat.create(document, made)
    document.recompute()
    return made


def nothing(document):
    Gui.Selection.clearSelection()


def a_sketch(document):
    choose(sketch(document, ARCH))


def an_open_sketch(document):
    drawn = sketch(document, ARCH)
    Gui.Selection.clearSelection()
    Gui.ActiveDocument.setEdit(drawn.Name)
    until(lambda: Gui.ActiveDocument.getInEdit() is not None)
    wait(300)


def a_strip(document):
    choose(strip_in(document))


def a_strip_without_a_curve(document):
    made = strip_in(document)
    document.removeObject(made.Curve[0].Name)
    document.recompute()
    choose(made)


def a_model(document):
    from freecad.elastica_wb.features import model

    made = model.create(document, [strip_in(document)])
    document.recompute()
    choose(made)


def foreign(document):
    choose(document.addObject("Part::Box", "Box"), document.addObject("Spreadsheet::Sheet", "Cells"))
    document.recompute()


def many_strips():
    """Undo in a document with many strips recomputes those that changed, and only those."""
    from freecad.elastica_wb import make_strip
    from freecad.elastica_wb.features.strip import StripFeature

    document = App.newDocument("Many")
    document.UndoMode = 1
    strips = [
        make_strip(sketch(document, [(x + 3 * (i % 4), y) for x, y in ARCH], name=f"Drawn{i}", poles=False))
        for i in range(80)
    ]
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    made = []
    usual = StripFeature.make

    def counted(self, obj):
        made.append(obj.Name)
        usual(self, obj)

    StripFeature.make = counted
    document.openTransaction("Move")
    box.Placement.Base.x = 50
    document.commitTransaction()
    document.recompute()
    began = time.perf_counter()
    document.undo()
    wait(1)
    took = time.perf_counter() - began
    until(lambda: made, 1)
    answers["undo of a box"] = [made[:], took]
    document.openTransaction("Draw")
    curve = strips[3].Curve[0].Geometry[0]
    curve.setPole(3, App.Vector(70, 95, 0))
    strips[3].Curve[0].delGeometry(0)
    strips[3].Curve[0].addGeometry(curve, False)
    document.commitTransaction()
    document.recompute()
    ratio = strips[3].Ratio
    made.clear()
    document.undo()
    until(lambda: made and strips[3].Ratio != ratio)
    still(lambda: len(made))
    answers["undo of a curve"] = [sorted(set(made)), strips[3].Ratio != ratio]
    StripFeature.make = usual
    App.closeDocument(document.Name)


def work():
    from freecad.elastica_wb.host import preferences

    window()
    Gui.activateWorkbench("ElasticaWorkbench")
    preferences.put("ExportFolder", str(OUT))
    states = (nothing, a_sketch, an_open_sketch, a_strip, a_strip_without_a_curve, a_model, foreign)
    for prepare in states:
        press_all(prepare.__name__, prepare)
    picture("states.png")
    many_strips()


run(work)
