"""The user reads inches: FreeCAD's own preference, boxes of panels typed into, sentences, the overlay's words."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
import FreeCADGui as Gui
from inside import (
    ARCH,
    QtCore,
    QtWidgets,
    answers,
    choose,
    click,
    dialog_button,
    keys,
    mouse,
    panel,
    picture,
    press,
    run,
    scroll_to,
    sketch,
    type_into,
    wait,
    window,
)


def preferences_page():
    def look():
        for box in QtWidgets.QApplication.topLevelWidgets():
            if isinstance(box, QtWidgets.QDialog) and box.isVisible():
                box.findChild(QtWidgets.QComboBox, "dxfVersion").setCurrentText("R2000")
                box.findChild(QtWidgets.QDoubleSpinBox, "kerf").setValue(0.2)
                picture("preferences.png")
                box.accept()

    QtCore.QTimer.singleShot(1500, look)
    Gui.showPreferences("Elastica", 0)


def work():
    window()
    App.ParamGet("User parameter:BaseApp/Preferences/Units").SetInt("UserSchema", 3)
    App.Units.setSchema(3)
    Gui.activateWorkbench("ElasticaWorkbench")
    from freecad.elastica_wb.host import preferences
    from freecad.elastica_wb.live import session as live

    preferences_page()
    answers["preferences"] = [preferences.get(name) for name in ("DxfVersion", "Kerf")]
    document = App.newDocument("Inches")
    document.UndoMode = 1
    drawn = sketch(document, ARCH)
    choose(drawn)
    press("Elastica_Strip")
    box = panel().form.MaxWidth
    scroll_to(box)
    answers["shown"] = box.text()
    strip = document.getObject("Strip")
    typed = []
    for words in ("0.75 in", "2 cm", "1/2 in"):
        scroll_to(box)
        type_into(box, words)
        wait(400)
        typed.append(strip.MaxWidth.Value)
    answers["typed"] = typed
    thickness = panel().form.Thickness
    scroll_to(thickness)
    click(thickness)
    keys("Tab")
    wait(300)
    answers["looked at"] = strip.Thickness.Value
    scroll_to(box)
    click(box)
    keys("Up")
    wait(500)
    answers["stepped"] = strip.MaxWidth.Value
    keys("Tab")
    answers["before the wheel"] = strip.MaxWidth.Value
    place = box.mapToGlobal(box.rect().center())
    mouse("mousemove", place.x(), place.y(), "click", "--repeat", 3, 4)
    wait(400)
    answers["wheel"] = strip.MaxWidth.Value
    answers["numbers"] = panel().form.numbers.text()
    strip.setExpression("MinWidth", None)
    strip.setExpression("MaxWidth", "1 in")
    document.recompute()
    wait(300)
    answers["expression"] = [strip.MaxWidth.Value, box.isReadOnly()]
    strip.setExpression("MaxWidth", None)
    strip.MaxWidth = 33.0
    wait(300)
    answers["elsewhere"] = panel().value("MaxWidth")
    picture("inches.png")
    click(dialog_button("Ok"))
    wait(300)
    choose(strip)
    press("Elastica_Export")
    answers["cut list"] = panel().form.message.text()
    answers["kerf"] = panel().value("kerf")
    answers["version"] = panel().form.version.currentText()
    click(dialog_button("Cancel"))
    wait(200)
    Gui.ActiveDocument.setEdit(drawn.Name)
    wait(600)
    for _ in range(100):  # the verdict comes first, the strip's widths when they are found
        if "wide" in live.session().sentence:
            break
        wait(100)
    answers["advice"] = live.session().sentence
    Gui.ActiveDocument.resetEdit()
    wait(100)


run(work)
