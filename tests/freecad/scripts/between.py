"""The curve of given length between two clamps: by its button, a handle pulled by the mouse, a length typed."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
import FreeCADGui as Gui
from inside import (
    ARCH,
    answers,
    at_rest,
    click,
    fit,
    live_at_rest,
    looks_from,
    mouse,
    on_screen,
    picture,
    press,
    run,
    sketch,
    still,
    toolbar_button,
    trigger,
    type_into,
    until,
    wait,
    window,
)


def edit(drawn):
    """Open a sketch as seen from above, with the tool at hand: 0.20's sketcher does not show foreign tools."""
    Gui.ActiveDocument.setEdit(drawn.Name)
    until(lambda: Gui.ActiveDocument.getInEdit() is not None)
    wait(400)
    if toolbar_button("Elastica_Between") is None:
        Gui.activateWorkbench("ElasticaWorkbench")
    until(lambda: toolbar_button("Elastica_Between") is not None)
    fit("Top", height=300)


def spline_of(drawn):
    return next(g for g in drawn.Geometry if "BSpline" in g.TypeId)


def measured(drawn):
    curve = spline_of(drawn)
    ends = [tuple(round(x, 2) for x in p[:2]) for p in (curve.StartPoint, curve.EndPoint)]
    return [len(drawn.Geometry), round(curve.length(), 3), *ends]


def opened():
    """The tool by its button."""
    from freecad.elastica_wb.live import between_clamps

    press("Elastica_Between")
    until(lambda: between_clamps.running() is not None)
    wait(300)
    return between_clamps.running()


def pull(tool, handle, dx, dy):
    """A handle, left of where 1.1 lays its panel: does the curve follow the mouse, does the sketch wait?"""
    still(looks_from)
    x, y = on_screen(*tool.preview.handles.places[handle])
    solved = []
    usual = tool._solve
    tool._solve = lambda: (solved.append(1), usual())
    before = measured(tool.sketch)
    mouse("mousemove", x - 3, y, "sleep", 0.1, "mousemove", x, y, "sleep", 0.1, "mousedown", 1)
    for i in range(1, 11):
        seen = len(solved)
        mouse("mousemove", x + dx * i / 10, y + dy * i / 10)
        until(lambda seen=seen: len(solved) > seen, 2)
    held = measured(tool.sketch) == before
    picture(f"pulled-{handle}.png")
    mouse("mouseup", 1)
    until(lambda: measured(tool.sketch) != before)
    wait(300)
    tool._solve = usual
    return [len(solved) >= 5, held]


def work():
    window()
    document = App.newDocument("Between")
    document.UndoMode = 1
    Gui.activateWorkbench("ElasticaWorkbench")
    window()
    from freecad.elastica_wb.live import between_clamps, observers

    drawn = document.addObject("Sketcher::SketchObject", "Drawn")
    observers.remember(drawn, True)
    document.recompute()
    edit(drawn)
    answers["grey"] = not toolbar_button("Elastica_Between").isEnabled()
    tool = opened()
    answers["new"] = measured(drawn)
    answers["length"] = tool.length
    answers["words"] = tool.card.words.text()
    picture("new.png")
    steps = document.UndoCount
    answers["end pulled"] = [*pull(tool, 0, 60, -40), measured(drawn), document.UndoCount - steps]
    answers["tangent pulled"] = [*pull(tool, 2, 40, 60), measured(drawn), spline_of(drawn).NbPoles]
    before = tool.card.words.text()
    click(tool.card.side)
    until(lambda: tool.card.words.text() != before)
    wait(300)
    answers["other side"] = [before, tool.card.words.text(), measured(drawn)]
    type_into(tool.card.length, "320 mm")
    until(lambda: abs(measured(drawn)[1] - 320) < 0.1)
    answers["longer"] = measured(drawn)
    type_into(tool.card.length, "20 mm")
    until(lambda: "make the strip longer" in tool.card.words.text())
    answers["too short"] = [tool.card.words.text(), measured(drawn)]
    picture("short.png")
    type_into(tool.card.length, "300 mm")
    until(lambda: abs(measured(drawn)[1] - 300) < 0.1)
    live_at_rest()
    from freecad.elastica_wb.live import session as live

    answers["verdict"] = live.session().card.answer.verdict.value
    click(tool.card.done)
    answers["done"] = until(lambda: between_clamps.running() is None)
    tool = opened()
    answers["taken again"] = [tool.number is not None, round(tool.length, 2), tool.side, measured(drawn)]
    picture("again.png")
    trigger("Std_Undo")
    until(lambda: between_clamps.running() is None and abs(spline_of(drawn).length() - 320) < 0.1)
    answers["undone"] = [between_clamps.running() is None, round(spline_of(drawn).length(), 1)]
    opened()
    Gui.ActiveDocument.resetEdit()
    answers["closed with its sketch"] = until(lambda: between_clamps.running() is None)
    press("Elastica_Strip")
    until(lambda: Gui.Control.activeDialog() and document.getObject("Strip").State == ["Up-to-date"])
    at_rest()
    strip = document.getObject("Strip")
    answers["strip"] = [strip.State, strip.Ratio]
    Gui.Control.closeDialog()
    line = sketch(document, [(0, 0), (10, 0), (20, 0), (30, 0), (40, 0)], name="Line", poles=False)
    line.delGeometry(0)
    import Part

    line.addGeometry(Part.LineSegment(App.Vector(0, 0, 0), App.Vector(60, 0, 0)))
    document.recompute()
    edit(line)
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(document.Name, line.Name, "Edge1")
    opened()
    answers["over a line"] = measured(line)
    Gui.ActiveDocument.resetEdit()
    arch = sketch(document, ARCH, name="Arch")
    edit(arch)
    opened()
    answers["with poles"] = measured(arch)
    answers["poles go"] = [*pull(between_clamps.running(), 0, 20, 10), measured(arch)]
    App.closeDocument(document.Name)
    answers["closed with its document"] = until(lambda: between_clamps.running() is None)


run(work)
