"""The workbench speaks the language of FreeCAD; its preferences page is there."""

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
    button,
    choose,
    click,
    keys,
    picture,
    run,
    scroll_to,
    sketch,
    trigger,
    type_into,
    until,
    window,
)


def work():
    window()
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
    until(lambda: Gui.Control.activeDialog() and Panel.opened.form.MaxWidth.isVisible())
    at_rest()
    answers["panel"] = Panel.opened.form.windowTitle()
    answers["sheet"] = Panel.opened.form.Sheet.currentText()
    strip, box = document.getObject("Strip"), Panel.opened.form.MaxWidth
    typed = []
    until(lambda: strip.Held)
    for text in ("25,5", "12,25 mm", "1,5 cm"):
        before = strip.MaxWidth.Value
        scroll_to(box)
        type_into(box, text)
        until(lambda before=before: strip.MaxWidth.Value != before)
        at_rest()
        typed.append([strip.MaxWidth.Value, box.text()])
    answers["typed"] = typed
    until(lambda: strip.Held and strip.Held in Panel.opened.form.footnote.text())
    at_rest()
    answers["numbers"] = Panel.opened.form.numbers.text()
    answers["message"] = Panel.opened.form.message.text() + Panel.opened.form.footnote.text()
    picture("german.png")
    button()
    answers["kept"] = strip.MaxWidth.Value
    trigger("Elastica_Export")
    until(lambda: Gui.Control.activeDialog() and Panel.opened.form.curves.isVisible())
    box = Panel.opened.form.curves
    answers["curves"] = [[box.itemText(i) for i in range(box.count())], Panel.opened.value("curves")]
    button("Cancel")

    def read(box):
        until(lambda: box.findChild(QtWidgets.QComboBox, "defaultSheet").isVisible())
        field = box.findChild(QtWidgets.QComboBox, "defaultSheet")
        shown = field.currentText()
        click(field)
        until(lambda: field.view().isVisible())
        picture("preferences.png")
        keys("Up", "Up", "Return")  # over the title of the group
        until(lambda: field.currentText() != shown)
        answers["preferences"] = [shown, field.currentText()]
        box.accept()

    request = Dialog(read)
    Gui.showPreferences("Elastica", 0)
    request.stop()
    answers["kept preferences"] = [preferences.get(name) for name in ("DefaultSheet", "Kerf", "DxfVersion")]


run(work)
