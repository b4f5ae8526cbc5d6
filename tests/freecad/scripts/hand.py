"""What a hand does: double clicks, context menus in tree and view, links, buttons over the view and in windows."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

from functools import partial

import FreeCAD as App
import FreeCADGui as Gui
from inside import (
    ARCH,
    OUT,
    QtCore,
    QtWidgets,
    answers,
    at_rest,
    choose,
    click,
    click_view,
    fit,
    keys,
    live_at_rest,
    looked,
    looks_from,
    panel,
    picture,
    press,
    press_button,
    press_on_card,
    run,
    scroll_to,
    shown_message,
    sketch,
    still,
    tree_row,
    trigger,
    until,
    wait,
    window,
)
from PySide import QtGui

BAD = [(0, 0), (40, 60), (80, -60), (120, 25), (160, 30), (180, 0)]


class Folders(QtCore.QObject):
    """Stands in for the program that shows folders."""

    @QtCore.Slot(QtCore.QUrl)
    def shown(self, address):
        answers["folder opened"] = address.toLocalFile()


def is_open():
    """Is a panel of ours open, with buttons that can be clicked?"""
    return (
        panel() is not None
        and Gui.Control.activeDialog()
        and panel().form is not None
        and panel().form.isVisible()
    )


def cancel():
    """The open panel by its button, if there is one."""
    if Gui.Control.activeDialog():
        at_rest()
        press_button("Cancel")
    until(lambda: not Gui.Control.activeDialog())


def double_clicks():
    """A double click in the tree edits every feature."""
    document = App.openDocument(str(Path(__file__).parents[1] / "data" / "every-feature-0.1.FCStd"))
    wait(500)
    until(lambda: Gui.ActiveDocument is not None and Gui.ActiveDocument.ActiveView is not None)
    titles = {}
    for obj in document.Objects:
        kind = type(getattr(obj, "Proxy", None)).__name__
        if kind in titles or not kind.endswith("Feature"):
            continue
        for _ in range(3):  # a tree that is still being filled takes the first click for a selection
            tree, item = tree_row(obj)
            click(tree.viewport(), times=2, at=tree.visualItemRect(item).center())
            if until(is_open):
                break
        titles[kind] = panel().form.windowTitle() if is_open() else ""
        cancel()
    answers["edited"] = titles
    App.closeDocument(document.Name)
    wait(200)


def menu_of(open_it, wanted):
    """Open a context menu by the right button, choose a command of ours in it; what it offered."""
    seen = []

    def look(tries=300):
        menu = QtWidgets.QApplication.activePopupWidget()
        if menu is None or not menu.actions():
            if tries:
                QtCore.QTimer.singleShot(100, lambda: look(tries - 1))
            return
        seen.extend(
            action.objectName() for action in menu.actions() if action.objectName().startswith("Elastica")
        )
        action = next((one for one in menu.actions() if one.objectName() == wanted), None)
        if action is None:
            keys("Escape")
        else:
            click(menu, at=menu.actionGeometry(action).center())

    QtCore.QTimer.singleShot(300, look)
    open_it()
    until(lambda: seen and QtWidgets.QApplication.activePopupWidget() is None)
    return seen


def right_click(strip, place):
    if place == "tree":
        tree, item = tree_row(strip)
        click(tree.viewport(), button=3, at=tree.visualItemRect(item).center())
    else:
        edge = strip.Shape.Edges[0]
        click_view(edge.valueAt(sum(edge.ParameterRange) / 2), button=3)


def context_menus(document, strip):
    from freecad.elastica_wb.panels.panel import Panel

    for place in ("tree", "view"):
        choose(strip)
        looked()
        Panel.opened = None
        answers[f"menu in the {place}"] = menu_of(partial(right_click, strip, place), "Elastica_Bend")
        answers[f"panel from the {place}"] = panel().form.windowTitle() if until(is_open) else ""
        cancel()


def links(document, strip):
    """A link of a strip, then an array of it: they follow, and commands take them for their strip."""
    choose(strip)
    trigger("Std_LinkMake")
    until(lambda: any(obj.TypeId == "App::Link" for obj in document.Objects))
    link = next(obj for obj in document.Objects if obj.TypeId == "App::Link")
    link.Placement.Base.z = 60
    document.recompute()
    choose(link)
    press("Elastica_Bend")
    until(is_open)
    answers["bend of a link"] = panel().object.Name
    cancel()
    link.ElementCount = 3
    strip.MaxWidth = 20
    document.recompute()
    answers["array"] = [len(link.ElementList) or link.ElementCount, strip.State[-1]]
    choose(link)
    press("Elastica_Export")
    until(is_open)
    answers["export of an array"] = [piece.count for piece in panel().pieces]
    cancel()
    document.removeObject(link.Name)


def another_curve(document, strip):
    """The curve is picked anew: the button of the panel, then the other sketch in the view."""
    other = sketch(document, [(x, y + 150) for x, y in ARCH], name="Other")
    fit("Top")
    first = strip.Curve[0]
    choose(strip)
    Gui.ActiveDocument.setEdit(strip.Name)
    until(is_open)
    still(looks_from)
    scroll_to(panel().form.pick)
    click(panel().form.pick)
    until(panel().form.pick.isChecked)
    edge = other.Shape.Edges[0]
    click_view(edge.valueAt(sum(edge.ParameterRange) / 2))
    until(lambda: strip.Curve[0] is other and not panel().form.pick.isChecked())
    at_rest()
    answers["picked"] = [strip.Curve[0].Name, panel().form.source.text(), panel().form.pick.isChecked()]
    picture("picked.png")
    press_button("Ok")
    until(lambda: not Gui.Control.activeDialog())
    trigger("Std_Undo")
    until(lambda: strip.Curve[0] is first)
    answers["picked, undone"] = strip.Curve[0] is first
    document.removeObject("Other")


def use_nearest(document):
    """The card over the view offers the nearest curve; its button draws it."""
    from freecad.elastica_wb.live import session as live

    bad = sketch(document, BAD, name="Bad")
    Gui.ActiveDocument.setEdit(bad.Name)
    until(lambda: live.session() is not None and live.session().near is not None, 120)
    fit()
    answers["refused"] = live.session().card.answer.verdict.value
    picture("refused.png")
    refused = bad.Geometry[0].NbPoles
    press_on_card("button")
    until(lambda: bad.Geometry[0].NbPoles != refused)
    until(lambda: live.session().card.answer.verdict.value != "cannot")
    live_at_rest()
    answers["drawn"] = live.session().card.answer.verdict.value
    picture("nearest-drawn.png")
    poles = bad.Geometry[0].NbPoles
    trigger("Std_Undo")  # in the sketch: 1.x makes a step of its own when it is closed
    until(lambda: bad.Geometry[0].NbPoles == refused)
    until(lambda: live.session().card.answer.verdict.value == "cannot")
    answers["nearest, undone"] = [poles, bad.Geometry[0].NbPoles, live.session().card.answer.verdict.value]
    Gui.ActiveDocument.resetEdit()
    wait(200)


def export(strip):
    """OK, then the button that opens the folder."""
    from freecad.elastica_wb.host import dialogs

    folders = Folders()
    QtGui.QDesktopServices.setUrlHandler("file", folders, "shown")
    choose(strip)
    press("Elastica_Export")
    until(is_open)
    panel().form.folder.setText(str(OUT / "files"))
    dialogs._open_boxes.clear()
    press_button("Ok")
    until(shown_message)
    answers["told"] = shown_message()
    button = dialogs._open_boxes[0].findChild(QtWidgets.QPushButton, "openFolder")
    still(lambda: (button.isVisible(), button.mapToGlobal(button.rect().center()).toTuple()))
    click(button)
    until(lambda: "folder opened" in answers)


def work():
    window()
    Gui.activateWorkbench("ElasticaWorkbench")
    double_clicks()
    from freecad.elastica_wb import make_strip

    document = App.newDocument("Hand")
    document.UndoMode = 1
    strip = make_strip(sketch(document, ARCH))
    window()
    Gui.activateWorkbench("ElasticaWorkbench")
    fit("Isometric")
    context_menus(document, strip)
    links(document, strip)
    another_curve(document, strip)
    use_nearest(document)
    export(strip)


run(work)
