"""From an empty document to a cutting file, by buttons, mouse and keyboard alone."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import time

import FreeCAD as App
import FreeCADGui as Gui
from inside import (
    OUT,
    answers,
    at_rest,
    fit,
    is_grey,
    live_at_rest,
    looks_from,
    mouse,
    on_screen,
    panel,
    picture,
    press,
    press_button,
    run,
    shown_message,
    still,
    type_into,
    typed,
    until,
    window,
)
from sketching import draw, new_sketch, splines

POLES = [(-170, -20), (-130, 60), (-50, 90), (30, 60), (70, -20)]  # 1.1 lays its panel over the right


def work():
    began = time.monotonic()
    window()
    Gui.activateWorkbench("ElasticaWorkbench")
    answers["grey without a document"] = is_grey("Elastica_Sheets")
    document = App.newDocument("First")
    document.UndoMode = 1
    Gui.activateWorkbench("ElasticaWorkbench")
    window()
    Gui.ActiveDocument.ActiveView.viewTop()
    still(looks_from)
    picture("1-empty.png")
    answers["grey at first"] = [name for name in ("Elastica_Strip", "Elastica_Live") if is_grey(name)]
    new_sketch()
    from freecad.elastica_wb.live import session as live

    until(lambda: live.session() is not None)
    fit(height=400)
    answers["session in the new sketch"] = live.session() is not None
    picture("2-sketch.png")
    draw(POLES)
    sketch = Gui.ActiveDocument.getInEdit().Object
    answers["drawn"] = [g.TypeId for g in sketch.Geometry][:2]
    answers["remembers"] = sketch.ElasticaLive
    until(lambda: live.session().overlay.shown()["width"])
    live_at_rest()
    answers["overlay"] = live.session().overlay.shown()
    answers["verdict"] = live.session().card.heading.text()
    picture("3-drawn.png")
    pole = tuple(splines(sketch)[0].getPole(3))
    x, y = on_screen(*pole[:2])
    mouse("mousemove", x - 3, y + 3, "sleep", 0.1, "mousemove", x, y, "sleep", 0.1, "mousedown", 1)
    frames = len(live.session().times)
    for i in range(1, 13):
        seen = len(live.session().times)
        mouse("mousemove", x + 2 * i, y - 4 * i)
        until(lambda seen=seen: len(live.session().times) > seen, 2)
    answers["frames while dragging"] = len(live.session().times) - frames
    answers["ms"] = [round(1000 * t, 2) for t in live.session().times[frames:]]
    picture("4-dragging.png")
    mouse("mouseup", 1)
    answers["pole moved"] = until(lambda: tuple(splines(sketch)[0].getPole(3)) != pole)
    press_button("Close")
    until(lambda: Gui.ActiveDocument.getInEdit() is None and live.session() is None)
    until(lambda: Gui.activeWorkbench().name() == "ElasticaWorkbench")
    answers["closed"] = [Gui.ActiveDocument.getInEdit() is None, live.session() is None]
    answers["back in"] = Gui.activeWorkbench().name()
    press("Elastica_Strip")
    until(lambda: document.getObject("Strip") is not None)
    strip = document.getObject("Strip")
    until(lambda: strip.Held and strip.Held in panel().form.footnote.text())
    at_rest()
    answers["strip"] = [strip.State, strip.Verdict]
    answers["panel"] = panel().form.windowTitle()
    answers["held"] = [strip.Held, panel().form.numbers.text(), panel().form.footnote.text()]
    typed("MaxWidth", "31 mm")
    answers["typed"] = until(lambda: strip.MaxWidth.Value == 31)
    fit("Isometric")
    picture("5-strip.png")
    press_button("Ok")
    until(lambda: not Gui.Control.activeDialog())
    press("Elastica_Export")
    until(lambda: Gui.Control.activeDialog() and panel().form.folder.isVisible())
    picture("6-export.png")
    field = panel().form.folder
    (OUT / "files").mkdir()
    type_into(field, str(OUT / "files"))
    press_button("Ok")
    until(shown_message)
    answers["files"] = sorted(path.name for path in (OUT / "files").iterdir())
    answers["told"] = shown_message()
    picture("7-exported.png")
    answers["seconds"] = time.monotonic() - began
    answers["comb of FreeCAD"] = App.ParamGet(
        "User parameter:BaseApp/Preferences/Mod/Sketcher/General"
    ).GetBool("BSplineCombVisible", True)


run(work)
