"""A pole of a spline is dragged by a real mouse in the sketcher; the overlay follows."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import time

import FreeCAD as App
import FreeCADGui as Gui
from inside import (
    WAVE,
    answers,
    button,
    fit,
    mouse,
    on_screen,
    panel,
    picture,
    run,
    scene,
    sketch,
    trigger,
    until,
    wait,
)


def work():
    Gui.activateWorkbench("ElasticaWorkbench")
    from freecad.elastica_wb.features import strip
    from freecad.elastica_wb.live import session as live

    document = App.newDocument("Drag")
    document.UndoMode = 1
    drawn = sketch(document, WAVE)
    feature = strip.create(document, drawn)
    document.recompute()
    Gui.ActiveDocument.setEdit(drawn.Name)
    until(lambda: live.session() is not None)
    fit("Top")
    session = live.session()
    until(lambda: session.overlay.shown()["width"])
    answers["overlay at start"] = session.overlay.shown()
    answers["usable"] = session._dragged.usable
    answers["sentence"] = session.sentence
    picture("edit.png")
    frames, moves = len(session.times), session.moves
    ratio, pole = feature.Ratio, tuple(drawn.Geometry[0].getPole(3))
    x, y = on_screen(*pole[:2])
    mouse("mousemove", x - 2, y + 2, "sleep", 0.1, "mousemove", x, y, "sleep", 0.15, "mousedown", 1)
    for i in range(1, 16):
        seen = len(session.times)
        mouse("mousemove", x + 2 * i, y - 4 * i)
        until(lambda seen=seen: len(session.times) > seen, 2)
    answers["updates while dragging"] = len(session.times) - frames
    answers["moves while dragging"] = session.moves - moves
    answers["times"] = session.times[frames:]
    answers["document pole while dragging"] = tuple(drawn.Geometry[0].getPole(3))
    answers["start pole"] = pole
    picture("dragging.png")
    mouse("mouseup", 1)
    until(lambda: tuple(drawn.Geometry[0].getPole(3)) != pole and feature.Ratio != ratio)
    until(lambda: session.overlay.shown()["width"])
    answers["pole"] = tuple(drawn.Geometry[0].getPole(3))
    answers["state"] = feature.State
    answers["ratio"] = (ratio, feature.Ratio)
    answers["sentence after"] = session.sentence
    answers["overlay after"] = session.overlay.shown()
    scene("overlay.png")
    dragged = feature.Ratio
    document.undo()
    until(lambda: feature.Ratio == ratio)
    answers["pole after undo"] = tuple(drawn.Geometry[0].getPole(3))
    answers["ratio after undo"] = feature.Ratio
    document.redo()
    until(lambda: feature.Ratio == dragged)
    answers["ratio after redo"] = feature.Ratio
    began = time.perf_counter()
    session.refresh()
    answers["refresh"] = time.perf_counter() - began
    Gui.ActiveDocument.resetEdit()
    until(lambda: live.session() is None)
    answers["closed"] = live.session() is None
    # a curve that cannot be bent: the nearest one is shown beside it
    bad = sketch(document, [(0, 0), (40, 60), (80, -60), (120, 25), (160, 30), (180, 0)], name="Bad")
    strip.create(document, bad)
    document.recompute()
    Gui.ActiveDocument.setEdit(bad.Name)
    until(lambda: live.session() is not None)
    fit("Top")
    until(lambda: live.session().overlay.shown()["nearest"], 120)
    answers["overlay of a bad curve"] = live.session().overlay.shown()
    answers["sentence of a bad curve"] = live.session().sentence
    picture("bad.png")
    for command in ("Elastica_Nearest", "Elastica_Strip"):
        if live.session() is None:
            Gui.ActiveDocument.setEdit(bad.Name)
        until(lambda: live.session() is not None)
        trigger(command)
        until(lambda: Gui.Control.activeDialog() and panel() is not None and panel().form.isVisible())
        answers.setdefault("steps from the open sketch", []).append(document.UndoNames[0])
        button("Cancel")
        answers.setdefault("left by Cancel", []).append(len(document.Objects))
    wait(100)


run(work)
