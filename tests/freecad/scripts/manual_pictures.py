"""Every tool of the workbench at work, as a picture for its page; docs/freecad_pictures.py runs it."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
import FreeCADGui as Gui
import Part
from inside import (
    ARCH,
    WAVE,
    QtCore,
    QtWidgets,
    answers,
    at_rest,
    choose,
    fill,
    fit,
    live_at_rest,
    panel,
    picture,
    run,
    sketch,
    trigger,
    wait,
    window,
)

STAND = App.Rotation(App.Vector(1, 0, 0), 90)
LARGE = 2.5
"""Curves this many times larger than those of the tests: plywood bears them."""


def scaled(points):
    """Larger."""
    return [(LARGE * x, LARGE * y) for x, y in points]


ARCH, WAVE = scaled(ARCH), scaled(WAVE)
HILL = scaled([(-75, 0), (-50, 60), (0, 95), (50, 60), (75, 0)])
CROSSING = scaled([(5, -40), (12, 0), (15, 50), (12, 100), (5, 140)])
GENTLE = [(1.3 * x, 1.3 * y) for x, y in WAVE]
BAD = scaled([(0, 0), (35, 80), (70, -70), (110, 60), (150, 70), (180, -30)])


def drawn(points=ARCH, name="Sketch", upright=True, poles=False):
    """A sketch in a document of its own."""
    document = App.ActiveDocument or App.newDocument("Manual")
    made = sketch(document, points, name=name, poles=poles)
    if upright:
        made.Placement = App.Placement(App.Vector(), STAND)
    document.recompute()
    return made


def strip_of(points=ARCH, label="A1", width=40, name="Sketch", upright=True):
    """A strip with its flat part."""
    from freecad.elastica_wb.features import flat, strip

    made = strip.create(App.ActiveDocument or App.newDocument("Manual"), drawn(points, name, upright))
    made.EngravedText, made.MaxWidth = label, width
    flat.create(made.Document, made)
    made.Document.recompute()
    return made


def look(name, top=False):
    """The window as it is, from the top or from a corner."""
    tidy()
    Gui.Selection.clearSelection()
    fit("Top" if top else "Isometric")
    wait(700)
    picture(f"{name}.png")


def close():
    """Nothing stays open."""
    if panel() is not None and Gui.Control.activeDialog():
        panel().reject()
    if Gui.ActiveDocument is not None and Gui.ActiveDocument.getInEdit() is not None:
        Gui.ActiveDocument.resetEdit()
    wait(200)
    for name in list(App.listDocuments()):
        App.closeDocument(name)
    wait(200)


def by_panel(command, *chosen, top=False, **values):
    """Choose, press, fill in, look."""
    choose(*chosen)
    assert trigger(command), command
    wait(500)
    at_rest()
    fill(panel(), **values)
    at_rest()
    wait(900)
    look(command.removeprefix("Elastica_").lower(), top=top)
    close()


def in_sketch(command, points, name):
    """An open sketch with a command that is turned on."""
    from freecad.elastica_wb.live import observers

    made = drawn(points, upright=False, poles=True)
    Gui.ActiveDocument.setEdit(made.Name)
    Gui.activateWorkbench("ElasticaWorkbench")
    wait(300)
    if command == "Elastica_Live":
        observers.switch(made, on=True)
    else:
        assert trigger(command), command
    live_at_rest()
    wait(900)
    look(name, top=True)
    close()


def crossing():
    """Two strips that cross."""
    return strip_of(HILL, "B", 40, "Hill"), strip_of(CROSSING, "C", 40, "Crossing")


def standing():
    """Two strips that are slotted into each other, in printed blocks."""
    choose(*crossing())
    assert trigger("Elastica_Interlock")
    wait(500)
    panel().accept()
    wait(500)
    choose(next(one for one in App.ActiveDocument.Objects if hasattr(one, "Strips")))
    assert trigger("Elastica_Fixtures")
    wait(900)
    panel().accept()
    wait(500)
    look("model")
    close()


def tidy():
    """The 3D view and the panel, nothing else."""
    for dock in Gui.getMainWindow().findChildren(QtWidgets.QDockWidget):
        if dock.objectName() in ("Python console", "Report view"):
            dock.hide()
        if dock.objectName() == "Combo View":
            Gui.getMainWindow().resizeDocks([dock], [380], QtCore.Qt.Horizontal)


def plain_background():
    """One colour: a gradient would take those of thin lines from a small palette."""
    view = App.ParamGet("User parameter:BaseApp/Preferences/View")
    view.SetBool("Gradient", False)
    view.SetBool("Simple", True)
    view.SetUnsigned("BackgroundColor", 0x54588AFF)


def work():
    plain_background()
    window()
    App.newDocument("Manual")
    Gui.activateWorkbench("ElasticaWorkbench")
    window()
    close()
    in_sketch("Elastica_Live", GENTLE, "live")
    in_sketch("Elastica_Live", BAD, "cannot")
    in_sketch("Elastica_Between", ARCH, "between")
    by_panel("Elastica_Check", drawn(BAD, upright=False), top=True)
    by_panel("Elastica_Nearest", drawn(BAD, upright=False), top=True)
    by_panel("Elastica_Projective", drawn(WAVE, upright=False), top=True)
    by_panel("Elastica_Strip", drawn(), MaxWidth=40.0)
    by_panel("Elastica_Perforate", strip_of(), OuterWidth=40.0)
    by_panel("Elastica_Laminate", strip_of(), OuterWidth=40.0)
    by_panel("Elastica_Bend", strip_of(upright=False), top=True, EndX=-40.0)
    choose(strip_of())
    assert trigger("Elastica_Tolerance")
    wait(500)
    fill(panel(), samples=12)
    panel().run()
    look("tolerance")
    close()
    by_panel("Elastica_Interlock", *crossing())
    by_panel("Elastica_Fixtures", strip_of())
    standing()
    by_panel("Elastica_Nest", *crossing())
    choose(strip_of())
    assert trigger("Elastica_Export")
    wait(500)
    panel().form.folder.setText("/home/me/arch")
    look("export")
    close()
    App.newDocument("Manual")
    choose()
    assert trigger("Elastica_Coupon")
    wait(500)
    panel().form.sheet.setCurrentText("card-200gsm")
    panel().make()
    point = QtCore.QLocale().decimalPoint()
    panel().form.readings.setText(f"100 = 13{point}5; 120 = 26")
    panel().form.readings.textEdited.emit("")
    look("coupon", top=True)
    close()
    App.newDocument("Manual")
    by_panel("Elastica_Sheets")
    barrel = App.newDocument("Manual").addObject("Part::Feature", "Barrel")
    face = Part.BSplineSurface()
    steps = range(-60, 61, 20)
    face.interpolate([[App.Vector(x, y, 60 - x * x / 90 - y * y / 160) for y in steps] for x in steps])
    barrel.Shape = face.toShape()
    App.ActiveDocument.recompute()
    by_panel("Elastica_Section", barrel, Family="parallel", Count=5)
    answers["done"] = True


run(work)
