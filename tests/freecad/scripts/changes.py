"""Changes after a refusal: the panel lists them, the mouse over a button shows the curve, a click applies it."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
import FreeCADGui as Gui
from inside import (
    answers,
    at_rest,
    begun,
    button,
    choose,
    click,
    fit,
    mouse,
    open_panel,
    panel,
    picture,
    press,
    run,
    sketch,
    suggested,
    suggestions,
    trigger,
    until,
    window,
)

from elastica_cad.mechanics import trials

ZIGZAG = [(0, 20), (60, 20), (120, 40), (180, -20), (240, 50), (300, -50)]


def poles(drawn):
    """The control points of the drawn curve."""
    curves = [curve for curve in drawn.Geometry if hasattr(curve, "getPoles")]
    return [[pole.x, pole.y] for curve in curves for pole in curve.getPoles()]


def pointed_at(widget):
    """Move the mouse onto a widget; the numbers of points that the view shows then."""
    place = widget.mapToGlobal(widget.rect().center())
    mouse("mousemove", place.x() - 2, place.y() - 1, "sleep", 0.1, "mousemove", place.x(), place.y())
    until(lambda: panel()._overlay is not None, 5)
    return {name: count for name, count in panel()._overlay.shown().items() if count}


def found(name):
    """What the panel offers when its search has ended."""
    until(lambda: not panel().form.searching.isVisible() and len(suggestions()) > 0, 120)
    answers[name] = suggestions()


def work():
    window()
    document = begun("Changes")
    drawn = sketch(document, ZIGZAG, degree=5)
    fit("Top")
    choose(drawn)
    press("Elastica_Strip")
    until(lambda: Gui.Control.activeDialog() and panel().form is not None)
    strip = document.getObject("Strip")
    strip.Sheet, strip.MaxWidth = "pom-0.5", 25
    document.recompute()
    at_rest()
    answers["searching"] = panel().form.searching.text()
    found("offered")
    button()
    answers["drawn"] = poles(drawn)

    open_panel("Elastica_Edit", strip)
    found("offered again")
    point = suggested(suggestions()[1])
    answers["shown"] = pointed_at(point)
    answers["tip"] = point.toolTip()
    picture("shown.png")
    click(point)
    until(lambda: strip.State == ["Up-to-date"])
    at_rest()
    answers["applied"] = [poles(drawn), strip.Verdict, suggestions(), panel()._overlay is None]
    picture("applied.png")
    button()
    trigger("Std_Undo")
    until(lambda: poles(drawn) == answers["drawn"])
    at_rest()
    answers["undone"] = [poles(drawn), strip.Verdict]

    drawn.Placement = App.Placement(App.Vector(), App.Rotation(App.Vector(1, 0, 0), 90))
    strip.Gravity, strip.Loads = True, ["at = 150, mass = 3"]
    document.recompute()
    open_panel("Elastica_Edit", strip)
    until(lambda: panel().form.searching.text() != answers["searching"], 120)
    answers["none"] = [panel().form.searching.text(), panel().form.searching.isVisible(), suggestions()]
    picture("none.png")
    button("Cancel")

    trials.MOST_PIECES = 0
    strip.Sheet, strip.MaxWidth = "pom-0.5", 26
    document.recompute()
    open_panel("Elastica_Edit", strip)
    until(lambda: panel().form.searching.text() not in (answers["searching"], answers["none"][0]), 120)
    answers["not tried"] = [panel().form.searching.text(), panel().form.searching.isVisible(), suggestions()]
    picture("not-tried.png")
    button("Cancel")


run(work)
