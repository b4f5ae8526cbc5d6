"""Strips of the curves in one sketch: all of them, one picked in the view, one picked in the open sketch."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
import FreeCADGui as Gui
from drawn_splines import spline
from inside import (
    answers,
    at_rest,
    begun,
    button,
    choose,
    click,
    click_view,
    fit,
    live_at_rest,
    panel,
    picture,
    press,
    run,
    tree_row,
    trigger,
    until,
    window,
)

RIB = [(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)]


def ribs(document):
    """Three splines in one sketch, the first with its poles."""
    sketch = document.addObject("Sketcher::SketchObject", "Ribs")
    for y in (0, 40, 80):
        number = sketch.addGeometry(spline([(x, v + y) for x, v in RIB]), False)
        if not y:
            sketch.exposeInternalGeometry(number)
    document.recompute()
    return sketch


def middle(sketch, number):
    """The middle of a spline, a little off the poles."""
    curves = [one for one in sketch.Geometry if "BSpline" in one.TypeId]
    return tuple(curves[number].value(0.4))


def strips(document):
    return [obj for obj in document.Objects if obj.Name.startswith("Strip")]


def made(document, name, start=press):
    """Press the button, or take the menu; the strips that it makes, and undo them."""
    start("Elastica_Strip")
    until(lambda: strips(document) and Gui.Control.activeDialog() and panel().form.isVisible())
    at_rest()
    picture(f"{name}.png")
    answers[name] = sorted([list(one.Curve[1]), one.State] for one in strips(document))
    button()
    answers[f"{name}, flat parts"] = sum(obj.Name.startswith("Flat") for obj in document.Objects)
    trigger("Std_Undo")
    until(lambda: not strips(document))


def work():
    window()
    document = begun("Picked")
    sketch = ribs(document)
    window()
    fit("Top")
    tree, item = tree_row(sketch)
    click(tree.viewport(), at=tree.visualItemRect(item).center())
    made(document, "all")
    fit("Top")
    choose()
    click_view(middle(sketch, 1))
    until(Gui.Selection.getSelection)
    answers["in the view"] = [list(one.SubElementNames) for one in Gui.Selection.getSelectionEx()]
    made(document, "picked in the view")
    fit("Top")
    choose()
    press("Elastica_Check")
    until(lambda: Gui.Control.activeDialog() and panel().form.isVisible())
    answers["checked"] = panel().form.message.text()
    button("Close")
    from freecad.elastica_wb.live import observers
    from freecad.elastica_wb.live import session as live

    choose()
    Gui.ActiveDocument.setEdit(sketch.Name)
    until(lambda: Gui.ActiveDocument.getInEdit() is not None)
    observers.switch(sketch, on=True)
    until(lambda: live.session() is not None)
    live_at_rest()
    session = live.session()
    answers["card"] = [
        session.card.heading.text(),
        session.card.words.text(),
        session.overlay.shown()["comb"],
    ]
    fit("Top", 260)
    click_view(middle(sketch, 2))
    until(Gui.Selection.getSelection)
    answers["in the sketch"] = [list(one.SubElementNames) for one in Gui.Selection.getSelectionEx()]
    picture("open.png")
    made(document, "picked in the sketch", trigger)  # the sketcher hides the button
    answers["edges"] = [[round(vertex.Y) for vertex in edge.Vertexes] for edge in sketch.Shape.Edges]
    App.closeDocument(document.Name)


run(work)
