"""The user reads inches: the preferences page, boxes of panels, sentences, the overlay's words."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
import FreeCADGui as Gui
from inside import ARCH, QtCore, QtWidgets, answers, choose, picture, run, sketch, wait


def type_into(box, words):
    box.lineEdit().setText(words)
    box.lineEdit().textEdited.emit(words)
    box.interpretText()
    wait(400)


def preferences_page():
    def look():
        for box in QtWidgets.QApplication.topLevelWidgets():
            if isinstance(box, QtWidgets.QDialog) and box.isVisible():
                box.findChild(QtWidgets.QComboBox, "units").setCurrentIndex(3)
                box.findChild(QtWidgets.QComboBox, "dxfVersion").setCurrentText("R2000")
                box.findChild(QtWidgets.QDoubleSpinBox, "kerf").setValue(0.2)
                picture("preferences.png")
                box.accept()

    QtCore.QTimer.singleShot(1500, look)
    Gui.showPreferences("Elastica", 0)


def work():
    Gui.activateWorkbench("ElasticaWorkbench")
    from freecad.elastica_wb import live, preferences
    from freecad.elastica_wb.panels.base import Panel

    preferences_page()
    answers["preferences"] = [preferences.get(name) for name in ("Units", "DxfVersion", "Kerf")]
    document = App.newDocument("Inches")
    document.UndoMode = 1
    drawn = sketch(document, ARCH)
    choose(drawn)
    Gui.runCommand("Elastica_Strip")
    wait(200)
    box = Panel.opened.form.MaxWidth
    answers["shown"] = box.text()
    for _ in range(50):  # until the panel is laid out
        wait(100)
        answers["in its row"] = box.y() > Panel.opened.form.Thickness.y() > 0
        if answers["in its row"]:
            break
    strip = document.getObject("Strip")
    typed = []
    for words in ("0.75", "2 cm", "1/2 in", "nonsense"):
        type_into(box, words)
        typed.append(strip.MaxWidth.Value)
    answers["typed"] = typed
    thickness = Panel.opened.form.Thickness
    type_into(thickness, thickness.text())
    answers["looked at"] = [thickness.text(), strip.Thickness.Value]
    box.stepUp()
    wait(400)
    answers["stepped"] = [box.text(), strip.MaxWidth.Value]
    answers["numbers"] = Panel.opened.form.numbers.text()
    picture("inches.png")
    Panel.opened.accept()
    wait(100)
    choose(strip)
    Gui.runCommand("Elastica_Export")
    wait(200)
    answers["cut list"] = Panel.opened.form.message.text()
    answers["kerf"] = [Panel.opened.form.kerf.text(), Panel.opened.form.kerf.value()]
    answers["version"] = Panel.opened.form.version.currentText()
    Panel.opened.reject()
    preferences.put("Units", "mm")
    choose(strip)
    Gui.ActiveDocument.setEdit(strip.Name)
    wait(200)
    type_into(Panel.opened.form.MaxWidth, "3/4 in")
    answers["typed beside mm"] = [Panel.opened.form.MaxWidth.text(), strip.MaxWidth.Value]
    Panel.opened.reject()
    wait(100)
    preferences.put("Units", "inch")
    Gui.ActiveDocument.setEdit(drawn.Name)
    wait(600)
    answers["advice"] = live.session().sentence
    Gui.ActiveDocument.resetEdit()
    wait(100)


run(work)
