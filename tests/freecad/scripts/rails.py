"""Rails, ties and loads by hand: the button after a refusal, clicks on the curve, a dragged mark, numbers."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
import FreeCADGui as Gui
from inside import (
    QtCore,
    answers,
    button,
    choose,
    click,
    click_view,
    drag,
    fit,
    live_at_rest,
    looks_from,
    open_panel,
    panel,
    picture,
    press,
    run,
    scroll_to,
    sketch,
    still,
    suggested,
    suggestions,
    trigger,
    typed,
    until,
    wait,
    window,
)

POINTS = [(0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (360, 0)]
"""No strip takes it without a support."""


def lines(strip):
    return [list(strip.Between), list(strip.Loads), strip.State]


def place_at(drawn, share):
    """A point of the drawn curve."""
    edge = drawn.Shape.Edges[0]
    return edge.valueAt(edge.getParameterByLength(share * edge.Length))


def chosen_kind(name):
    """Choose a kind of element as the keyboard does, press the button."""
    kind = panel().form.kind
    kind.setCurrentIndex(kind.findData(name))
    scroll_to(panel().form.pick)
    click(panel().form.pick)
    until(panel().form.pick.isChecked)
    still(looks_from)


def rows():
    listed = panel().form.elements
    return [listed.item(i).text() for i in range(listed.count())]


def work():
    window()
    document = App.newDocument("Rails")
    document.UndoMode = 1
    Gui.activateWorkbench("ElasticaWorkbench")
    window()
    drawn = sketch(document, POINTS, degree=5, poles=False)
    fit("Top")
    choose(drawn)
    press("Elastica_Strip")
    until(lambda: Gui.Control.activeDialog() and panel().form is not None)
    strip = document.getObject("Strip")
    answers["refused"] = strip.Verdict
    until(lambda: any("rail" in words for words in suggestions()))
    answers["offered"] = next(words for words in suggestions() if "rail" in words)
    picture("offered.png")
    click(suggested(answers["offered"]))
    until(lambda: strip.Between and strip.State == ["Up-to-date"])
    answers["held"] = [lines(strip), strip.Verdict, bool(suggestions())]
    answers["numbers"] = panel().form.numbers.text()
    button()

    open_panel("Elastica_Rails", strip)
    fit("Top")
    one = panel()
    answers["listed"] = rows()
    answers["overlay"] = {name: count for name, count in one.preview.shown().items() if count}
    picture("panel.png")
    before = [one.value("place"), list(strip.Between)]
    spot = place_at(drawn, 197 / drawn.Shape.Length)
    frames = drag(tuple(spot), 6, (4, 0), grab=lambda: one.value("place"), name="dragged.png")
    until(lambda: list(strip.Between) != before[1])
    answers["dragged"] = [before, len(set(frames)), one.value("place"), lines(strip)]

    chosen_kind("Tie (cord)")
    click_view(tuple(place_at(drawn, 0.15)))
    until(lambda: "other end" in one.form.message.text())
    answers["first end"] = one.form.message.text()
    click_view(tuple(place_at(drawn, 0.78)))
    until(lambda: len(strip.Between) == 2)
    answers["tie"] = [rows(), lines(strip), one.form.pick.isChecked()]
    typed("other", "300 mm")
    until(lambda: "300" in strip.Between[1])
    answers["typed"] = [rows(), strip.Verdict]
    chosen_kind("Force")
    click_view(tuple(place_at(drawn, 0.3)))
    until(lambda: strip.Loads)
    typed("forceY", "-0.2")
    until(lambda: "-0.2" in strip.Loads[0])
    answers["force"] = [rows(), lines(strip), strip.Verdict]
    answers["numbers with all"] = one.form.numbers.text()
    picture("all.png")
    chosen_kind("Pin (the strip turns)")
    click_view(tuple(place_at(drawn, 0.6)))
    until(lambda: len(strip.Between) == 3)
    answers["pin"] = [rows(), one.form.fixed.isChecked(), lines(strip)]
    scroll_to(one.form.fixed)
    click(
        one.form.fixed, at=QtCore.QPoint(12, one.form.fixed.height() // 2)
    )  # beside the text nothing happens
    until(lambda: "[" not in strip.Between[2])
    answers["along the curve"] = lines(strip)
    scroll_to(one.form.hole)
    typed("hole", "3 mm")
    until(lambda: "hole" in strip.Between[2])
    answers["hole"] = list(strip.Between)
    scroll_to(one.form.remove)
    click(one.form.remove)
    until(lambda: len(strip.Between) == 2)
    answers["removed"] = [rows(), lines(strip)]
    button()
    answers["closed"] = lines(strip)

    trigger("Std_Undo")
    until(lambda: not strip.Loads)
    answers["undone"] = lines(strip)
    trigger("Std_Redo")
    until(lambda: strip.Loads)
    from freecad.elastica_wb.live import session as live

    Gui.ActiveDocument.setEdit(drawn.Name)
    until(lambda: live.session() is not None)
    live_at_rest()
    fit("Top")
    fit(height=800)  # so that no panel of 1.1 is over the end
    wait(500)
    shown = live.session().overlay.shown()
    answers["live"] = {name: count for name, count in shown.items() if count}
    answers["live verdict"] = live.session().card.answer.verdict.value
    picture("live.png")
    before = [drawn.Shape.Length, list(strip.Between), list(strip.Loads)]
    drag((360, 0, 0), 8, (2, 0))
    until(lambda: drawn.Geometry[0].getPole(7).x > 361)
    live_at_rest()
    Gui.ActiveDocument.resetEdit()
    until(lambda: Gui.ActiveDocument.getInEdit() is None)
    document.recompute()
    answers["kept fractions"] = [before, [drawn.Shape.Length, list(strip.Between), list(strip.Loads)]]


run(work)
