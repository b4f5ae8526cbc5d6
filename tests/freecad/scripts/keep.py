"""Keep it possible: a pole that is dragged too far returns to the border, in one undo step; 500 drags by script."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from inside import (
    ARCH,
    answers,
    begun,
    drag,
    fit,
    live_at_rest,
    picture,
    press_on_card,
    run,
    sketch,
    trigger,
    until,
    wait,
    window,
)

DRAGS = 500


def poles(drawn):
    """The control points of the drawn curve, and the centres of the circles that show them."""
    curve = next(one for one in drawn.Geometry if hasattr(one, "getPoles"))
    circles = [one.Center for one in drawn.Geometry if "Circle" in one.TypeId]
    return [[[p.x, p.y] for p in points] for points in (curve.getPoles(), circles)]


strained = []
"""Strains of the strips that were possible, in percent of the limit."""


def verdict(drawn, k=0, shift=(0, 0)):
    """Why no strip of the preferences takes the curve, with one pole moved; empty if a strip does."""
    from freecad.elastica_wb.curves.sketch_curves import sketch_curve
    from freecad.elastica_wb.solving.strip_cache import default_spec
    from freecad.elastica_wb.solving.verdicts import strip_faults

    from elastica_cad import ElasticaError

    curve = sketch_curve(drawn)
    points = curve.control_points.copy()
    points[k] += shift
    try:
        strip = default_spec(curve.with_control_points(points)).make()
    except ElasticaError as error:
        return str(error)
    strained.append(100 * strip.max_strain / strip.strain_limit)
    return ", ".join(fault.words for fault in strip_faults(strip))


def moved(drawn, k, place):
    """Move a pole as the sketcher does when the mouse is released, and let the window follow."""
    move = getattr(drawn, "movePoint", None) or drawn.moveGeometry
    circles = [i for i, one in enumerate(drawn.Geometry) if "Circle" in one.TypeId]
    drawn.Document.openTransaction("Drag Point")
    move(circles[k], 3, App.Vector(*place, 0), 0)
    drawn.Document.commitTransaction()
    for _ in range(4):
        wait(1)


def work():
    window()
    document = begun("Keep")
    drawn = sketch(document, ARCH)
    from freecad.elastica_wb.live import observers
    from freecad.elastica_wb.live import session as live

    Gui.ActiveDocument.setEdit(drawn.Name)
    observers.switch(drawn, on=True)
    fit("Top")
    fit(height=320)
    until(lambda: live.session() is not None)
    live_at_rest()
    until(live.session().card.keep.isEnabled)
    press_on_card("keep")
    until(lambda: drawn.ElasticaKeep)
    answers["stored"] = [drawn.ElasticaKeep, live.session().card.keep.isChecked()]
    before, _ = poles(drawn)
    steps = document.UndoCount
    drag(tuple(before[2]), 8, (0, 25))
    until(lambda: poles(drawn)[0] != before)
    live_at_rest()
    wait(300)
    answers["dragged"] = [before, *poles(drawn), document.UndoCount - steps, verdict(drawn)]
    answers["heading"] = live.session().card.heading.text()
    picture("keep.png")
    answers["farther"] = verdict(drawn, 2, (0, -1.5))
    strained.clear()
    trigger("Std_Undo")
    until(lambda: poles(drawn)[0] == before)
    answers["undone"] = poles(drawn)[0]

    start, rng = np.array(before), np.random.default_rng(71)
    refused, stopped = [], 0
    for _ in range(DRAGS):
        k = int(rng.integers(1, len(start) - 1))
        place = start[k] + rng.normal(size=2) * 40
        moved(drawn, k, place)
        refused += filter(None, [verdict(drawn)])
        stopped += bool(np.hypot(*(poles(drawn)[0][k] - place)) > 0.1)
    answers["drags"] = [DRAGS, refused[:3], stopped]
    answers["strained"] = max(strained)
    apart = np.subtract(*poles(drawn))
    answers["circles"] = float(np.abs(apart).max())
    press_on_card("keep")
    until(lambda: not drawn.ElasticaKeep)
    moved(drawn, 2, start[2] + (0, -400))
    answers["off"] = [drawn.ElasticaKeep, verdict(drawn) != ""]


run(work)
