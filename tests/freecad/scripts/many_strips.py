"""An overlay, a recompute and an undo by the clock, with one strip and among a hundred."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import time

import FreeCAD as App
import FreeCADGui as Gui
from inside import ARCH, answers, fit, mouse, on_screen, run, sketch, until

MANY, MOVES, RECOMPUTES = 100, 25, 40


def shifted(k):
    return [(x + 3 * (k % 4) + 0.1 * k, y) for x, y in ARCH]


def overlay(document, drawn):
    """Seconds of each answer while a real mouse drags a pole."""
    from freecad.elastica_wb.live import session as live

    Gui.ActiveDocument.setEdit(drawn.Name)
    until(lambda: live.session() is not None)
    fit("Top")
    session = live.session()
    until(lambda: session.overlay.shown()["width"])
    x, y = on_screen(*tuple(drawn.Geometry[0].getPole(2))[:2])
    mouse("mousemove", x - 2, y + 2, "sleep", 0.1, "mousemove", x, y, "sleep", 0.15, "mousedown", 1)
    first = len(session.times)
    for i in range(1, MOVES + 1):
        seen = len(session.times)
        mouse("mousemove", x + i, y - 2 * i)
        until(lambda seen=seen: len(session.times) > seen, 2)
    times = session.times[first:]
    mouse("mouseup", 1)
    until(lambda: session.overlay.shown()["width"])
    Gui.ActiveDocument.resetEdit()
    until(lambda: live.session() is None)
    document.recompute()
    return times


def recomputes(document, strip, lift):
    """Seconds of a recompute after each of many changes of a curve; `lift` (mm) makes them others than before."""
    took = []
    drawn = strip.Curve[0]
    for k in range(RECOMPUTES):
        curve = drawn.Geometry[0]
        curve.setPole(3, App.Vector(70, 80 + lift + 0.05 * (k + 1), 0))
        drawn.Geometry = [curve, *drawn.Geometry[1:]]
        drawn.recompute()
        began = time.perf_counter()
        document.recompute()
        took.append(time.perf_counter() - began)
        assert strip.State == ["Up-to-date"], strip.State
    return took


def undo_of_a_box(document):
    """Seconds by the clock and of the processor until an undo is done and the window has caught up."""
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    document.openTransaction("Move")
    box.Placement.Base.x = 50
    document.commitTransaction()
    document.recompute()
    clock, began = time.perf_counter(), time.process_time()
    document.undo()
    Gui.updateGui()
    return time.perf_counter() - clock, time.process_time() - began


def work():
    Gui.activateWorkbench("ElasticaWorkbench")
    from freecad.elastica_wb import make_strip

    document = App.newDocument("Many")
    document.UndoMode = 1
    dragged = sketch(document, ARCH)
    make_strip(dragged, flat_part=False)
    plain = make_strip(sketch(document, shifted(0), name="Plain", poles=False), flat_part=False)
    answers["overlay alone"] = overlay(document, dragged)
    answers["recompute alone"] = recomputes(document, plain, 0.0)
    for k in range(2, MANY):
        make_strip(sketch(document, shifted(k), name=f"Drawn{k}", poles=False), flat_part=False)
    answers["strips"] = len([one for one in document.Objects if hasattr(one, "StrainUse")])
    answers["overlay among many"] = overlay(document, dragged)
    answers["recompute among many"] = recomputes(document, plain, 5.0)
    answers["undo of a box"] = undo_of_a_box(document)


run(work)
