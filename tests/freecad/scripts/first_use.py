"""From an empty document to a cutting file, by buttons, mouse and keyboard alone."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import time

import FreeCAD as App
import FreeCADGui as Gui
from inside import (
    OUT,
    QtWidgets,
    answers,
    click,
    dialog_button,
    is_grey,
    keys,
    mouse,
    on_screen,
    panel,
    picture,
    press,
    run,
    told,
    toolbar_button,
    trigger,
    wait,
    window,
)

POLES = [(-170, -20), (-130, 60), (-50, 90), (30, 60), (70, -20)]  # 1.1 lays its panel over the right


def new_sketch():
    """The button asks for a plane; OK takes XY."""
    answers["grey at first"] = [name for name in ("Elastica_Strip", "Elastica_Live") if is_grey(name)]

    def accept(tries=60):
        for box in QtWidgets.QApplication.topLevelWidgets():
            if isinstance(box, QtWidgets.QDialog) and box.isVisible():
                buttons = box.findChildren(QtWidgets.QDialogButtonBox)
                for one in buttons:
                    button = one.button(QtWidgets.QDialogButtonBox.Ok)
                    if button is not None:
                        click(button)
                        return
        if tries:
            from inside import QtCore

            QtCore.QTimer.singleShot(100, lambda: accept(tries - 1))

    accept()
    press("Sketcher_NewSketch")
    for _ in range(30):
        if Gui.ActiveDocument.getInEdit() is not None:
            break
        button = dialog_button("Ok")
        if button is not None:
            click(button)
        wait(200)
    wait(600)
    assert Gui.ActiveDocument.getInEdit() is not None, "no sketch is open"


def draw():
    """The sketcher's B-spline tool, one click for each pole, Escape ends it."""
    for name in ("Sketcher_CreateBSpline", "Sketcher_CompCreateBSpline"):
        button = toolbar_button(name)
        if button is not None:
            break
    if button is None:
        trigger("Sketcher_CreateBSpline")  # a tool of FreeCAD's own that its toolbar hides
    else:
        click(button)
    wait(400)
    for place in POLES:
        x, y = on_screen(*place)
        mouse("mousemove", x - 4, y - 3, "sleep", 0.05, "mousemove", x, y, "sleep", 0.05, "click", 1)
    wait(200)
    mouse("click", 3)
    wait(400)
    keys("Escape")
    wait(400)


def work():
    began = time.monotonic()
    window()
    document = App.newDocument("First")
    document.UndoMode = 1
    Gui.activateWorkbench("ElasticaWorkbench")
    window()
    view = Gui.ActiveDocument.ActiveView
    view.viewTop()
    picture("1-empty.png")
    new_sketch()
    view = Gui.ActiveDocument.ActiveView
    view.setCameraType("Orthographic")
    view.getCameraNode().height.setValue(400)
    wait(300)
    from freecad.elastica_wb.live import session as live

    answers["session in the new sketch"] = live.session() is not None
    picture("2-sketch.png")
    draw()
    sketch = Gui.ActiveDocument.getInEdit().Object
    answers["drawn"] = [g.TypeId for g in sketch.Geometry][:2]
    answers["remembers"] = sketch.ElasticaLive
    wait(300)
    answers["overlay"] = live.session().overlay.shown()
    answers["verdict"] = live.session().card.answer.words
    picture("3-drawn.png")
    spline = next(g for g in sketch.Geometry if "BSpline" in g.TypeId)
    pole = tuple(spline.getPole(3))
    x, y = on_screen(*pole[:2])
    mouse("mousemove", x - 3, y + 3, "sleep", 0.1, "mousemove", x, y, "sleep", 0.1, "mousedown", 1)
    frames = len(live.session().times)
    for i in range(1, 13):
        mouse("mousemove", x + 2 * i, y - 4 * i)
    answers["frames while dragging"] = len(live.session().times) - frames
    answers["ms"] = [round(1000 * t, 2) for t in live.session().times[frames:]]
    picture("4-dragging.png")
    mouse("mouseup", 1)
    wait(300)
    answers["pole moved"] = (
        tuple(next(g for g in sketch.Geometry if "BSpline" in g.TypeId).getPole(3)) != pole
    )
    click(dialog_button("Close"))
    wait(600)
    answers["closed"] = [Gui.ActiveDocument.getInEdit() is None, live.session() is None]
    answers["back in"] = Gui.activeWorkbench().name()
    press("Elastica_Strip")
    wait(900)
    strip = document.getObject("Strip")
    answers["strip"] = [strip.State, strip.Verdict]
    answers["panel"] = panel().form.windowTitle()
    answers["held"] = [strip.Held, panel().form.numbers.text(), panel().form.footnote.text()]
    view = Gui.ActiveDocument.ActiveView
    view.viewIsometric()
    view.fitAll()
    wait(300)
    picture("5-strip.png")
    click(dialog_button("Ok"))
    wait(400)
    press("Elastica_Export")
    wait(400)
    picture("6-export.png")
    field = panel().form.folder
    (OUT / "files").mkdir()
    click(field)
    keys("ctrl+a")
    mouse("type", "--delay", 10, str(OUT / "files"))
    click(dialog_button("Ok"))
    wait(1500)
    answers["files"] = sorted(path.name for path in (OUT / "files").iterdir())
    answers["told"] = told()
    picture("7-exported.png")
    answers["seconds"] = time.monotonic() - began
    answers["comb of FreeCAD"] = App.ParamGet(
        "User parameter:BaseApp/Preferences/Mod/Sketcher/General"
    ).GetBool("BSplineCombVisible", True)


run(work)
