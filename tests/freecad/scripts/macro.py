"""A macro is recorded while strips, holders and a nest are made by hand, and played in another document."""

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
    begun,
    button,
    choose,
    click,
    open_panel,
    press,
    run,
    sketch,
    trigger,
    typed,
    until,
    window,
)

WIDE = [(x + 200, y) for x, y in ARCH]


def begin(box):
    """The dialog of FreeCAD's recorder: a name, and Record."""
    name, folder = (box.findChild(QtWidgets.QLineEdit, one) for one in ("lineEditPath", "lineEditMacroPath"))
    folder.setText(f"{OUT}/")
    name.setText("made_by_hand")
    click(box.findChild(QtWidgets.QPushButton, "buttonStart"))


def drawn(document):
    return sketch(document, ARCH), sketch(document, WIDE, name="Wide")


def found(document):
    document.recompute()
    strips = [one for one in document.Objects if hasattr(one, "StrainUse")]
    return {
        "objects": [[one.Name, one.TypeId, one.State] for one in document.Objects],
        "strips": [[one.MaxWidth.Value, one.Sheet, round(one.Mass, 9), one.Style] for one in strips],
        "nest": list(document.getObject("Nest").Placement.Base),
        "volumes": [round(one.Shape.Volume, 6) for one in document.Objects if hasattr(one, "Shape")],
    }


def work():
    window()
    document = begun("ByHand")
    sketches = drawn(document)
    recorder = Dialog(begin)
    trigger("Std_DlgMacroRecord")
    until(lambda: recorder.done)
    open_panel("Elastica_Strip", *sketches)
    typed("MaxWidth", "25 mm")
    button()
    strips = [one for one in document.Objects if hasattr(one, "StrainUse")]
    open_panel("Elastica_Fixtures", strips[0])
    button()
    choose(*strips)
    press("Elastica_Nest")
    until(lambda: document.getObject("Nest") is not None)
    choose(strips[1])
    open_panel("Elastica_Perforate", strips[1])
    button()
    stop = "Std_MacroStopRecord"  # one command begins and ends it since FreeCAD 0.21
    trigger(stop if stop in Gui.listCommands() else "Std_DlgMacroRecord")
    answers["by hand"] = found(document)
    text = (OUT / "made_by_hand.FCMacro").read_text(encoding="utf-8")
    answers["recorded"] = text
    again = begun("Played")
    drawn(again)
    App.setActiveDocument(again.Name)
    import __main__

    exec(compile(text, "made_by_hand.FCMacro", "exec"), vars(__main__))  # as FreeCAD plays macros
    until(lambda: not Gui.Control.activeDialog(), 5)
    answers["played"] = found(again)


run(work)
