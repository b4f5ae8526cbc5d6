"""Macros are recorded while buttons are pressed and boxes filled by hand, and played in other documents."""

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
import FreeCADGui as Gui
from inside import (
    ARCH,
    OUT,
    Dialog,
    QtWidgets,
    answers,
    at_rest,
    begun,
    button,
    choose,
    click,
    fit,
    live_at_rest,
    open_panel,
    panel,
    press,
    press_button,
    press_on_card,
    run,
    scroll_to,
    sketch,
    still,
    trigger,
    typed,
    until,
    wait,
    window,
)

WIDE = [(x + 200, y) for x, y in ARCH]
FLAT = [(x + 400, 0.8 * y) for x, y in ARCH]
BAD = [(0, 0), (40, 60), (80, -60), (120, 25), (160, 30), (180, 0)]

STEPS = (
    "Strip from sketch",
    "End fixtures and base plate",
    "Nest on sheets",
    "Perforate",
    "Bend forward",
    "Projective edit",
    "Use the nearest curve",
    "Coupon and calibrate",
)
"""Ours: FreeCAD adds some of its own where a sketch is closed."""


def begin(box):
    """The dialog of FreeCAD's recorder: a name, and Record."""
    name, folder = (box.findChild(QtWidgets.QLineEdit, one) for one in ("lineEditPath", "lineEditMacroPath"))
    folder.setText(f"{OUT}/")
    name.setText("made_by_hand")
    still(lambda: box.geometry().getRect())  # the window manager moves it once more
    click(box.findChild(QtWidgets.QPushButton, "buttonStart"))
    replace = QtWidgets.QApplication.activeModalWidget()
    assert replace is None, replace


def strips_of(document):
    return [one for one in document.Objects if hasattr(one, "StrainUse")]


def found(document):
    document.recompute()
    nest = document.getObject("Nest")
    return {
        "objects": [[one.Name, one.TypeId, "Invalid" in one.State] for one in document.Objects],
        "strips": [
            [one.MaxWidth.Value, one.OuterWidth.Value, one.Style, one.Sheet, one.Follow, one.Curve[0].Name]
            for one in strips_of(document)
        ],
        "nest": nest and list(nest.Placement.Base),
        "volumes": [
            round(one.Shape.Volume, 6)
            for one in document.Objects
            if hasattr(one, "Shape") and one.Shape.Solids
        ],
        "lengths": [
            round(one.Shape.Length, 6)
            for one in document.Objects
            if hasattr(one, "Shape") and one.Shape.Edges
        ],
        "steps": [name for name in document.UndoNames if name in STEPS],
    }


def recorded(name, draw, by_hand):
    """Work by hand with the recorder on, then play what it wrote where the same sketches are drawn."""
    document = begun(f"{name}ByHand")
    draw(document)
    document.clearUndos()
    recorder = Dialog(begin)
    trigger("Std_DlgMacroRecord")
    until(lambda: recorder.done)
    by_hand(document)
    stop = "Std_MacroStopRecord"  # one command begins and ends it since FreeCAD 0.21
    trigger(stop if stop in Gui.listCommands() else "Std_DlgMacroRecord")
    file = OUT / "made_by_hand.FCMacro"
    text = file.read_text(encoding="utf-8")
    file.unlink()
    again = begun(f"{name}Played")
    draw(again)
    again.clearUndos()
    App.setActiveDocument(again.Name)
    # FreeCAD 1.1 names the document in a line of its own where a sketch is opened: which constraints are seen
    text = re.sub(r"App\.getDocument\('\w+'\)(.*\.setVisibility\()", r"App.ActiveDocument\1", text)
    names = {"FreeCAD": App, "App": App, "FreeCADGui": Gui, "Gui": Gui, "__name__": "__main__"}
    exec(compile(text, "made_by_hand.FCMacro", "exec"), names)  # as FreeCAD does after a new start
    until(lambda: not Gui.Control.activeDialog(), 5)
    answers[name] = {"recorded": text, "by hand": found(document), "played": found(again)}


def make_and_hold(document):
    open_panel("Elastica_Strip", *document.Objects)
    typed("MaxWidth", "25 mm")
    button()
    first, second = strips_of(document)
    open_panel("Elastica_Fixtures", first)
    button()
    choose(first, second)
    press("Elastica_Nest")
    until(lambda: document.getObject("Nest") is not None)
    choose(second)
    open_panel("Elastica_Perforate", second)
    button()


def change_ones_mind(document):
    """The nearest curve, another curve, Cancel, and holders that cannot be made."""
    bad, wide, low = document.Objects
    open_panel("Elastica_Strip", wide)
    button("Cancel")
    open_panel("Elastica_Strip", bad)
    panel().form.Follow.setCurrentIndex(1)  # as the keyboard does, because no button suggests it
    until(lambda: panel().object.Follow == "Nearest")
    button()
    (first,) = strips_of(document)
    open_panel("Elastica_Strip", wide)
    scroll_to(panel().form.pick)
    click(panel().form.pick)
    until(panel().form.pick.isChecked)
    choose(low)
    until(lambda: panel().object.Curve[0] is low)
    for name in ("StartTab", "EndTab"):
        typed(name, "0 mm")
    button()
    _, second = strips_of(document)
    open_panel("Elastica_Fixtures", second)
    press_button()
    until(lambda: "Add tabs to the strips" in panel().form.message.text())
    answers["refused"] = panel().form.message.text()
    button("Cancel")
    open_panel("Elastica_Perforate", second)
    button("Cancel")
    open_panel("Elastica_Fixtures", first)
    button()


def reshape(document):
    """A strip bent further, a curve pulled, a refused curve replaced while its sketch is open, a coupon."""
    from freecad.elastica_wb.live import session as live

    good, bad = document.Objects
    open_panel("Elastica_Projective", good)
    typed("y3", "90 mm")
    button()
    open_panel("Elastica_Strip", good)
    button()
    (made,) = strips_of(document)
    open_panel("Elastica_Bend", made)
    typed("EndX", "5 mm")
    button()
    Gui.ActiveDocument.setEdit(bad.Name)
    until(lambda: live.session() is not None and live.session().near is not None)
    fit()
    refused = bad.Geometry[0].NbPoles
    press_on_card("button")
    until(lambda: bad.Geometry[0].NbPoles != refused)
    live_at_rest()
    Gui.ActiveDocument.resetEdit()
    wait(200)
    choose()
    open_panel("Elastica_Coupon")
    scroll_to(panel().form.make)
    click(panel().form.make)
    until(lambda: document.getObject("Coupon") is not None)
    at_rest()
    button()


def work():
    window()
    recorded("made", lambda one: (sketch(one, ARCH), sketch(one, WIDE, name="Wide")), make_and_hold)
    recorded(
        "minds",
        lambda one: (sketch(one, BAD), sketch(one, WIDE, name="Wide"), sketch(one, FLAT, name="Low")),
        change_ones_mind,
    )
    recorded("reshaped", lambda one: (sketch(one, ARCH), sketch(one, BAD, name="Bad")), reshape)


run(work)
