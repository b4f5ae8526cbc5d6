"""The workbench speaks the language of FreeCAD; its preferences page is there."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
import FreeCADGui as Gui
from inside import ARCH, QtWidgets, answers, choose, picture, run, sketch, trigger, wait
from PySide import QtCore


def work():
    Gui.activateWorkbench("ElasticaWorkbench")
    from freecad.elastica_wb import commands
    from freecad.elastica_wb.host import preferences
    from freecad.elastica_wb.panels.panel import Panel

    words = {}
    for action in Gui.getMainWindow().findChildren(QtWidgets.QWidget):
        for one in action.actions():
            if one.objectName() in commands.MENU:
                words[one.objectName()] = one.text().replace("&", "")
    answers["menu"] = words
    english = {command.name: command.text for command in commands.COMMANDS}
    answers["untranslated"] = [name for name, text in words.items() if text == english.get(name)]
    document = App.newDocument("Sprache")
    choose(sketch(document, ARCH))
    trigger("Elastica_Strip")
    wait(200)
    answers["panel"] = Panel.opened.form.windowTitle()
    picture("german.png")
    Panel.opened.reject()
    wait(100)

    def look():
        for box in QtWidgets.QApplication.topLevelWidgets():
            if isinstance(box, QtWidgets.QDialog) and box.isVisible():
                field = box.findChild(QtWidgets.QLineEdit, "defaultSheet")
                answers["preferences"] = field.text() if field else None
                picture("preferences.png")
                box.reject()

    QtCore.QTimer.singleShot(1500, look)
    Gui.showPreferences("Elastica", 0)
    answers["kerf"] = preferences.get("Kerf")


run(work)
