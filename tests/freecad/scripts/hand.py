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
    choose,
    click,
    click_view,
    dialog_button,
    keys,
    panel,
    picture,
    press,
    run,
    sketch,
    told,
    tree_row,
    trigger,
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


def double_clicks():
    """A double click in the tree edits every feature."""
    document = App.openDocument(str(Path(__file__).parents[1] / "data" / "every-feature-0.1.FCStd"))
    wait(500)
    from freecad.elastica_wb.features import curves

    strip = document.getObject("Strip")
    curves.bent(document, strip, EndX=-5.0)
    curves.nearest(document, strip.Curve[0])
    curves.section(document, [document.getObject("BasePlate")])
    document.recompute()
    titles = {}
    for obj in document.Objects:
        kind = type(getattr(obj, "Proxy", None)).__name__
        if kind in titles or not kind.endswith("Feature"):
            continue
        tree, item = tree_row(obj)
        click(tree.viewport(), times=2, at=tree.visualItemRect(item).center())
        wait(300)
        titles[kind] = panel().form.windowTitle() if Gui.Control.activeDialog() else ""
        if Gui.Control.activeDialog():
            click(dialog_button("Cancel"))
        wait(150)
    answers["edited"] = titles
    App.closeDocument(document.Name)
    wait(200)


def menu_of(open_it, wanted):
    """Open a context menu by the right button, choose a command of ours in it; what it offered."""
    seen = []

    def look(tries=40):
        menu = QtWidgets.QApplication.activePopupWidget()
        if menu is None:
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
    wait(600)
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
        wait(200)
        Panel.opened = None
        answers[f"menu in the {place}"] = menu_of(partial(right_click, strip, place), "Elastica_Bend")
        answers[f"panel from the {place}"] = panel().form.windowTitle() if panel() is not None else ""
        if Gui.Control.activeDialog():
            click(dialog_button("Cancel"))
        wait(200)


def links(document, strip):
    """A link of a strip, then an array of it: they follow, and commands take them for their strip."""
    choose(strip)
    trigger("Std_LinkMake")
    wait(300)
    link = next(obj for obj in document.Objects if obj.TypeId == "App::Link")
    link.Placement.Base.z = 60
    document.recompute()
    choose(link)
    press("Elastica_Bend")
    answers["bend of a link"] = panel().object.Name
    click(dialog_button("Cancel"))
    wait(200)
    link.ElementCount = 3
    strip.MaxWidth = 20
    document.recompute()
    answers["array"] = [len(link.ElementList) or link.ElementCount, strip.State[-1]]
    choose(link)
    press("Elastica_Export")
    answers["export of an array"] = panel().strips[0].Name
    click(dialog_button("Cancel"))
    wait(200)
    document.removeObject(link.Name)


def another_curve(document, strip):
    """The curve is picked anew: the button of the panel, then the other sketch in the view."""
    other = sketch(document, [(x, y + 150) for x, y in ARCH], name="Other")
    view = Gui.ActiveDocument.ActiveView
    view.viewTop()
    view.fitAll()
    wait(400)
    first = strip.Curve[0]
    choose(strip)
    Gui.ActiveDocument.setEdit(strip.Name)
    wait(300)
    click(panel().form.pick)
    wait(200)
    edge = other.Shape.Edges[0]
    click_view(edge.valueAt(sum(edge.ParameterRange) / 2))
    wait(400)
    answers["picked"] = [strip.Curve[0].Name, panel().form.source.text(), panel().form.pick.isChecked()]
    picture("picked.png")
    click(dialog_button("Ok"))
    wait(200)
    trigger("Std_Undo")
    wait(300)
    answers["picked, undone"] = strip.Curve[0] is first
    document.removeObject("Other")


def use_nearest(document):
    """The card over the view offers the nearest curve; its button draws it."""
    from freecad.elastica_wb.live import session as live

    bad = sketch(document, BAD, name="Bad")
    Gui.ActiveDocument.setEdit(bad.Name)
    wait(500)
    for _ in range(300):
        if live.session() is not None and live.session().card.button.isVisible():
            break
        wait(100)
    Gui.ActiveDocument.ActiveView.fitAll()
    wait(300)
    answers["refused"] = live.session().card.answer.verdict.value
    picture("refused.png")
    click(live.session().card.button)
    wait(600)
    answers["drawn"] = live.session().card.answer.verdict.value
    picture("nearest-drawn.png")
    poles = bad.Geometry[0].NbPoles
    trigger("Std_Undo")  # in the sketch: 1.x makes a step of its own when it is closed
    wait(400)
    answers["nearest, undone"] = [poles, bad.Geometry[0].NbPoles, live.session().card.answer.verdict.value]
    Gui.ActiveDocument.resetEdit()
    wait(200)


def export(strip):
    """OK, then the button that opens the folder."""
    from freecad.elastica_wb.host import telling

    folders = Folders()
    QtGui.QDesktopServices.setUrlHandler("file", folders, "shown")
    choose(strip)
    press("Elastica_Export")
    panel().form.folder.setText(str(OUT / "files"))
    click(dialog_button("Ok"))
    wait(1500)
    answers["told"] = told()
    click(telling._told[0].findChild(QtWidgets.QPushButton, "openFolder"))
    wait(300)


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
    Gui.ActiveDocument.ActiveView.viewIsometric()
    Gui.ActiveDocument.ActiveView.fitAll()
    wait(300)
    context_menus(document, strip)
    links(document, strip)
    another_curve(document, strip)
    use_nearest(document)
    export(strip)


run(work)
