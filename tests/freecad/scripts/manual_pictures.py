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
    looks_from,
    panel,
    picture,
    run,
    sketch,
    still,
    trigger,
    until,
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
UP = [(15, 75), (57, 75), (87, 102), (126, 102), (162, 102), (201, 75), (240, 75)]
DOWN = [(15, 51), (51, 51), (81, 27), (120, 27), (162, 27), (204, 51), (240, 51)]
"""Both states of a clip; degree 4 as other curves here."""
LONG_WAVE = [(0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (360, 0)]
"""No strip takes it without a rail."""


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
    """The window when nothing in it moves any more, from the top or from a corner."""
    tidy()
    Gui.Selection.clearSelection()
    fit("Top" if top else "Isometric")
    still(shown, quiet=0.6)
    picture(f"{name}.png")


def shown():
    """What a person reads in the window: its texts, what stands in its fields, what is drawn."""
    main = Gui.getMainWindow()
    fields = [
        (field.objectName(), field.text(), field.geometry().getRect())
        for kind in (QtWidgets.QLabel, QtWidgets.QLineEdit, QtWidgets.QPushButton)
        for field in main.findChildren(kind)
        if field.isVisible()
    ]
    objects = App.ActiveDocument.Objects if App.ActiveDocument is not None else ()
    return fields, [(one.Name, one.State) for one in objects], looks_from()


def is_open():
    """Is a panel of ours open, with all that it tells?"""
    opened = panel()
    return opened is not None and Gui.Control.activeDialog() and opened.form.isVisible()


def opened(command, *chosen):
    """The panel of a command, when it has told what it tells at first."""
    choose(*chosen)
    assert trigger(command), command
    assert until(is_open), command
    at_rest()
    return panel()


def close():
    """Nothing stays open."""
    if panel() is not None and Gui.Control.activeDialog():
        panel().reject()
    if Gui.ActiveDocument is not None and Gui.ActiveDocument.getInEdit() is not None:
        Gui.ActiveDocument.resetEdit()
        assert until(lambda: Gui.ActiveDocument.getInEdit() is None)
    assert until(lambda: not Gui.Control.activeDialog())
    for name in list(App.listDocuments()):
        App.closeDocument(name)
    assert until(lambda: not App.listDocuments())


def by_panel(command, *chosen, top=False, **values):
    """Choose, press, fill in, look."""
    fill(opened(command, *chosen), **values)
    at_rest()
    look(command.removeprefix("Elastica_").lower(), top=top)
    close()


def in_sketch(command, points, name):
    """An open sketch with a command that is turned on."""
    from freecad.elastica_wb.live import observers

    made = drawn(points, upright=False, poles=True)
    Gui.ActiveDocument.setEdit(made.Name)
    Gui.activateWorkbench("ElasticaWorkbench")
    assert until(lambda: Gui.ActiveDocument.getInEdit() is not None)
    if command == "Elastica_Live":
        observers.switch(made, on=True)
    else:
        assert trigger(command), command
    live_at_rest()
    look(name, top=True)
    close()


def crossing():
    """Two strips that cross."""
    return strip_of(HILL, "B", 40, "Hill"), strip_of(CROSSING, "C", 40, "Crossing")


def flat_again():
    """The flat part of a strip that had lost it; this tool has no panel."""
    strip = strip_of(label="RIB 7", upright=False)
    choose(strip.Document.Flat)
    assert trigger("Std_Delete")
    choose(strip)
    assert trigger("Elastica_Flat")
    assert until(lambda: strip.Document.getObject("Flat") is not None)
    look("flat", top=True)
    close()


def outlined():
    """The outline of a strip below its flat part; this tool has no panel."""
    strip = strip_of(label="RIB 7", upright=False)
    strip.TabHole = 4
    choose(strip)
    assert trigger("Elastica_Outline")
    assert until(lambda: strip.Document.getObject("Flat001") is not None)
    look("outline", top=True)
    close()


def standing():
    """Two strips that are slotted into each other, in printed blocks."""
    opened("Elastica_Interlock", *crossing()).accept()
    assert until(lambda: not Gui.Control.activeDialog())
    model = next(one for one in App.ActiveDocument.Objects if hasattr(one, "Strips"))
    opened("Elastica_Fixtures", model).accept()
    assert until(lambda: not Gui.Control.activeDialog())
    look("model")
    close()


def nested():
    """What two strips are cut from; this tool has no panel."""
    choose(*crossing())
    before = len(App.ActiveDocument.Objects)
    assert trigger("Elastica_Nest")
    assert until(lambda: len(App.ActiveDocument.Objects) > before)
    look("nest")
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
    by_panel("Elastica_Projective", drawn(HILL, upright=False), top=True, x3=250.0, y3=230.0)
    by_panel("Elastica_Strip", drawn(), MaxWidth=40.0)
    by_panel("Elastica_Edit", *crossing(), StartTab=15.0)
    by_panel("Elastica_Perforate", strip_of(), OuterWidth=40.0)
    by_panel("Elastica_Laminate", strip_of(), OuterWidth=40.0)
    flat_again()
    outlined()
    held = strip_of(LONG_WAVE, upright=False)
    held.Between = ["at = [180, -9]"]
    held.Document.recompute()
    by_panel("Elastica_Rails", held, top=True)
    clip = [drawn(points, name, upright=False) for points, name in ((UP, "Up"), (DOWN, "Down"))]
    by_panel("Elastica_Flexure", *clip)
    by_panel("Elastica_Bend", strip_of(upright=False), top=True, EndX=-40.0)
    fill(opened("Elastica_Tolerance", strip_of()), samples=12)
    panel().run()
    look("tolerance")
    close()
    by_panel("Elastica_Interlock", *crossing())
    by_panel("Elastica_Fixtures", strip_of())
    standing()
    nested()
    opened("Elastica_Export", strip_of()).form.folder.setText("/home/me/arch")
    look("export")
    close()
    App.newDocument("Manual")
    fill(opened("Elastica_Coupon"), sheet="card-200gsm")
    panel().make()
    point = QtCore.QLocale().decimalPoint()
    panel().form.readings.setText(f"100 = 13{point}5; 120 = 26")
    panel().form.readings.textEdited.emit("")
    at_rest()
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
    assert trigger("Elastica_Example")
    assert until(lambda: App.ActiveDocument.getObject("Flat") is not None)
    look("example")
    close()
    answers["done"] = True


run(work)
