"""The user reads inches: FreeCAD's own preference, boxes of panels typed into, sentences, the overlay's words."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
import FreeCADGui as Gui
from inside import (
    ARCH,
    Dialog,
    QtWidgets,
    answers,
    at_rest,
    choose,
    click,
    has_focus,
    keys,
    mouse,
    panel,
    picture,
    press,
    press_button,
    run,
    scroll_to,
    sketch,
    type_into,
    until,
    wait,
    window,
)


def preferences_page():
    def fill_in(box):
        until(lambda: box.findChild(QtWidgets.QComboBox, "dxfVersion").isVisible())
        box.findChild(QtWidgets.QComboBox, "dxfVersion").setCurrentText("R2000")
        box.findChild(QtWidgets.QDoubleSpinBox, "kerf").setValue(0.2)
        picture("preferences.png")
        box.accept()

    request = Dialog(fill_in)
    Gui.showPreferences("Elastica", 0)
    request.stop()


def typed_into(box, words, changed):
    """Type, then wait for what follows from it."""
    scroll_to(box)
    type_into(box, words)
    until(changed)
    at_rest()


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
    until(lambda: Gui.Control.activeDialog() and panel().form.MaxWidth.isVisible())
    at_rest()
    box = panel().form.MaxWidth
    scroll_to(box)
    answers["shown"] = box.text()
    strip = document.getObject("Strip")
    typed_into(box, answers["shown"], lambda: strip.MaxWidth.Value != 30)
    answers["typed as shown"] = strip.MaxWidth.Value
    typed = []
    for words in ("0.75 in", "2 cm", "1/2 in"):
        before = strip.MaxWidth.Value
        typed_into(box, words, lambda before=before: strip.MaxWidth.Value != before)
        typed.append(strip.MaxWidth.Value)
    answers["typed"] = typed
    thickness = panel().form.Thickness
    scroll_to(thickness)
    click(thickness)
    until(lambda: has_focus(thickness), 10)
    keys("Tab")
    until(lambda: not has_focus(thickness), 10)
    wait(300)
    at_rest()
    answers["looked at"] = strip.Thickness.Value
    scroll_to(box)
    click(box)
    until(lambda: has_focus(box), 10)
    before = strip.MaxWidth.Value
    keys("Up")
    until(lambda: strip.MaxWidth.Value > before)
    answers["stepped"] = strip.MaxWidth.Value
    keys("Tab")
    until(lambda: not has_focus(box), 10)
    at_rest()
    answers["before the wheel"] = strip.MaxWidth.Value
    place = box.mapToGlobal(box.rect().center())
    mouse("mousemove", place.x(), place.y(), "click", "--repeat", 3, 4)
    wait(400)
    at_rest()
    answers["wheel"] = strip.MaxWidth.Value
    answers["numbers"] = panel().form.numbers.text()
    strip.setExpression("MinWidth", None)
    strip.setExpression("MaxWidth", "1 in")
    document.recompute()
    until(box.isReadOnly)
    answers["expression"] = [strip.MaxWidth.Value, box.isReadOnly()]
    strip.setExpression("MaxWidth", None)
    strip.MaxWidth = 33.0
    until(lambda: abs(panel().value("MaxWidth") - 33) < 0.2)
    answers["elsewhere"] = panel().value("MaxWidth")
    picture("inches.png")
    press_button("Ok")
    until(lambda: not Gui.Control.activeDialog())
    choose(strip)
    press("Elastica_Export")
    until(lambda: Gui.Control.activeDialog() and panel().form.version.isVisible())
    at_rest()
    answers["cut list"] = panel().form.message.text()
    answers["kerf"] = panel().value("kerf")
    typed_into(panel().form.kerf, "0.15 mm", lambda: panel().value("kerf") != 0.2)
    answers["kerf typed"] = panel().value("kerf")
    answers["version"] = panel().form.version.currentText()
    press_button("Cancel")
    until(lambda: not Gui.Control.activeDialog())
    press("Elastica_Bend")
    until(lambda: Gui.Control.activeDialog() and panel().form.EndX.isVisible())
    typed_into(panel().form.EndX, "120 mm", lambda: panel().value("EndX") != 0)
    answers["bent by"] = panel().value("EndX")
    press_button("Cancel")
    until(lambda: not Gui.Control.activeDialog())
    Gui.ActiveDocument.setEdit(drawn.Name)
    # the verdict comes first, the strip's widths when they are found
    until(lambda: "wide" in live.session().sentence)
    answers["advice"] = live.session().sentence
    Gui.ActiveDocument.resetEdit()
    wait(100)


run(work)
