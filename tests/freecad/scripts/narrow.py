"""Panels in the narrow dock of FreeCAD 0.20, formulas and units in their boxes, and errors that are told once."""

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
    at_rest,
    begun,
    button,
    choose,
    click,
    has_focus,
    keys,
    mouse,
    open_panel,
    panel,
    picture,
    press,
    report,
    run,
    scroll_to,
    sketch,
    typed,
    until,
    wait,
    window,
)

BAD = [(0, 0), (40, 60), (80, -55), (120, 10), (160, 30), (180, 0)]
UP = [(15, 75), (57, 75), (87, 102), (126, 102), (162, 102), (201, 75), (240, 75)]
DOWN = [(15, 51), (51, 51), (81, 27), (120, 27), (162, 27), (204, 51), (240, 51)]


def too_wide(command, *things):
    """By how many pixels a panel is wider than its dock."""
    open_panel(command, *things)
    wait(500)
    areas = Gui.getMainWindow().findChildren(QtWidgets.QScrollArea)
    over = max(area.horizontalScrollBar().maximum() for area in areas if area.isAncestorOf(panel().form))
    picture(f"{command}.png")
    button("Close" if panel().only_tells else "Cancel")
    return over


def in_view(obj):
    """Are all corners of an object in the 3D view?"""
    view = Gui.ActiveDocument.ActiveView
    places = [view.getPointOnScreen(obj.Shape.BoundBox.getPoint(i)) for i in range(8)]
    return all(0 <= x <= most for place in places for x, most in zip(place, view.getSize()))  # noqa: B905


def formula(document, strip):
    """The wall of blocks by a formula, which is typed into the panel that makes them."""
    sheet = document.addObject("Spreadsheet::Sheet", "Table")
    sheet.set("A1", "=7 mm")
    document.recompute()
    open_panel("Elastica_Fixtures", strip)
    scroll_to(panel().form.wall)
    click(panel().form.wall)
    until(lambda: has_focus(panel().form.wall))
    mouse("type", "--delay", 20, "--", "=")
    wait(500)
    mouse("type", "--delay", 20, "--", "Table.A1 * 1")
    keys("Return")
    # in FreeCAD 1.1, this key chooses from the list of names
    for editor in [one for one in QtWidgets.QApplication.topLevelWidgets() if one.isVisible()]:
        if editor.objectName() == "DlgExpressionInput":
            click(next(one for one in editor.findChildren(QtWidgets.QPushButton) if one.text() == "OK"))
    until(lambda: document.Fixtures.ExpressionEngine, 5)
    picture("formula.png")
    button()
    walls = [document.Fixtures.Wall.Value]
    sheet.set("A1", "=9 mm")
    document.recompute()
    return [*walls, document.Fixtures.Wall.Value, document.Fixtures.State]


def mass(strip):
    """A mass in its box, as it is shown and stored; typed as a number and in kilograms."""
    open_panel("Elastica_Rails", strip)
    panel().form.kind.setCurrentIndex(5)
    panel().clicked((75, 70))
    at_rest()
    found = [panel().form.mass.text(), list(strip.Loads)]
    for words in ("25", "0.03 kg"):
        typed("mass", words)
        found.append(list(strip.Loads))
    button("Cancel")
    return found


def curves(strip):
    """Curves that the export offers, with DXF and without."""
    open_panel("Elastica_Export", strip)
    box, found = panel().form.curves, []
    for _ in range(2):
        found.append([box.itemText(i) for i in range(box.count())])
        scroll_to(panel().form.dxf)
        click(panel().form.dxf, at=QtCore.QPoint(8, 8))
        at_rest()
    button("Cancel")
    return found


def work():
    from importlib.util import find_spec

    window()
    document = begun("Narrow")
    drawn = sketch(document, ARCH, poles=False)
    drawn.Placement = App.Placement(App.Vector(), App.Rotation(App.Vector(1, 0, 0), 90))
    document.recompute()
    Gui.ActiveDocument.ActiveView.viewTop()
    choose(drawn)
    press("Elastica_Strip")
    until(lambda: document.Flat.Shape.Volume)
    button()
    strip = document.Strip
    answers["in view"] = [in_view(strip), in_view(document.Flat)]
    states = [
        sketch(document, points, name=name, poles=False) for name, points in (("Up", UP), ("Down", DOWN))
    ]
    document.recompute()
    answers["too wide"] = {
        command: too_wide(command, *things)
        for command, things in {
            "Elastica_Check": [drawn],
            "Elastica_Nearest": [drawn],
            "Elastica_Projective": [drawn],
            "Elastica_Edit": [strip],
            "Elastica_Rails": [strip],
            "Elastica_Flexure": states,
            "Elastica_Bend": [strip],
            "Elastica_Tolerance": [strip],
            "Elastica_Fixtures": [strip],
            "Elastica_Export": [strip],
            "Elastica_Sheets": [],
            "Elastica_Coupon": [],
        }.items()
    }
    answers["ezdxf"] = find_spec("ezdxf") is not None
    answers["curves"] = curves(strip)
    answers["mass"] = mass(strip)
    answers["walls"] = formula(document, strip)
    strip.Curve = sketch(document, BAD, name="Bad", poles=False)
    for length in (5, 6, 7):
        document.Table.set("A2", str(length))
        document.Table.touch()
        document.recompute()
        wait(200)
    answers["told"] = report().count("209 mm")
    App.closeDocument(document.Name)


run(work)
