"""The verdict on an open sketch: a headline over the view, reason and buttons in the panel Tasks."""

import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCADGui as Gui
from inside import (
    QtCore,
    QtWidgets,
    answers,
    begun,
    click,
    drag,
    fit,
    live_at_rest,
    looks_from,
    mouse,
    on_screen,
    picture,
    press_on_card,
    run,
    sketch,
    until,
    wait,
    window,
)

BAD = [(0, 0), (40, 60), (80, -60), (120, 60), (160, -10), (200, 90)]
IMPOSSIBLE = {
    "off line": BAD,
    "crossing": [(0, 0), (30, 90), (70, -60), (110, 80), (150, 0)],
    "sharp": [(0, 0), (0, 60), (8, 90), (16, 60), (16, 0)],
    "thin": [(0, 0), (20, 90), (60, -60), (90, 95), (120, -20), (150, 0)],
}


def middle(widget):
    return widget.mapToGlobal(widget.rect().center())


def covering(card):
    """Panels of FreeCAD 1.1 that lie over the headline."""

    def on_the_screen(widget):
        return QtCore.QRect(widget.mapToGlobal(QtCore.QPoint(0, 0)), widget.size())

    panels = [
        one
        for one in Gui.getMainWindow().findChildren(QtWidgets.QTabWidget)
        if one.metaObject().className() == "Gui::OverlayTabWidget" and one.isVisible() and one.count()
    ]
    return [one.objectName() for one in panels if on_the_screen(one).intersects(on_the_screen(card.heading))]


def is_hidden(card, place):
    """Does the headline lie over a place in space?"""
    corner = card.heading.mapToGlobal(QtCore.QPoint(0, 0))
    return card.heading.rect().contains(QtCore.QPoint(*on_screen(*place)) - corner)


def poles(drawn):
    return [tuple(point)[:2] for point in drawn.Geometry[0].getPoles()]


def is_in_sight(widget):
    """Can the whole width of a widget be seen, without scrolling to the side?"""
    return widget.isVisible() and widget.visibleRegion().boundingRect().width() == widget.width()


def seen(card):
    """What a person sees of the verdict without doing anything."""
    parts = (card.verdict, card.words, card.button, card.keep)
    return [all(map(is_in_sight, parts)), card.heading.height() < 40]


def work():
    window()
    document = begun("Card")
    from freecad.elastica_wb.host.progress import begun as in_thread
    from freecad.elastica_wb.live import observers
    from freecad.elastica_wb.live import session as live

    def opened(points, name):
        drawn = sketch(document, points, name=name)
        Gui.ActiveDocument.setEdit(drawn.Name)
        observers.switch(drawn, on=True)
        fit("Top")
        fit(height=320)
        until(lambda: live.session() is not None)
        until(live.session().card.verdict.isVisible)
        return drawn, live.session().card

    answers["verdicts"] = {}
    for _ in range(2):  # both threads are busy, so that the first search is seen
        in_thread(time.sleep, 5)
    for name, points in IMPOSSIBLE.items():
        drawn, card = opened(points, name.title())
        if "searching" not in answers:
            until(card.button.isVisible)
            answers["searching"] = card.button.isEnabled()
        live_at_rest()
        until(lambda card=card: live.session().near is not None and card.button.isEnabled())
        wait(200)
        found = [card.heading.text(), card.words.text(), card.button.text(), *seen(card)]
        hidden = [place for place in poles(drawn) if is_hidden(card, place)]
        answers["verdicts"][name] = [*found, hidden, covering(card), card.keep.isEnabled(), card.why.text()]
        answers.setdefault("legend", card.legend.text())
        picture(f"card-{name.replace(' ', '-')}.png")
        Gui.ActiveDocument.resetEdit()
        until(lambda: live.session() is None)
    answers["removed"] = not any(
        one.objectName() == "keepPossible" and one.isVisible()
        for one in Gui.getMainWindow().findChildren(QtWidgets.QCheckBox)
    )
    drawn, card = opened(BAD, "Dragged")
    live_at_rest()
    # the wheel over the headline zooms the view below it
    place, before = middle(card.heading), looks_from()
    mouse("mousemove", place.x(), place.y(), "sleep", 0.1, "click", 4)
    answers["wheel goes through"] = until(lambda: looks_from() != before)
    fit(height=320)
    # a pole is dragged below the headline, which then lies elsewhere
    start, place = poles(drawn)[2], middle(card.heading)
    x, y = on_screen(*start)
    drag(start, 8, ((place.x() - x) / 8, (place.y() - y) / 8))
    until(lambda: poles(drawn)[2] != start)
    live_at_rest()
    answers["kept off"] = until(lambda: not is_hidden(card, poles(drawn)[2]), 10)
    picture("kept-off.png")
    document.undo()
    live_at_rest()
    until(lambda: live.session().near is not None)
    press_on_card("button")
    until(lambda: drawn.Geometry[0].NbPoles > len(BAD), 120)
    live_at_rest()
    circles = [one for one in drawn.Geometry if one.TypeId == "Part::GeomCircle"]
    answers["drawn"] = [drawn.Geometry[0].NbPoles, len(circles), card.answer.verdict.value]
    answers["cost"] = live.session().sentence
    answers["keep"] = [card.keep.isEnabled(), card.why.text()]
    picture("poles.png")
    # a curve too sharp for the sheet is drawn as large as the sheet needs
    Gui.ActiveDocument.resetEdit()
    drawn, card = opened(IMPOSSIBLE["sharp"], "Larger")
    live_at_rest()
    words, before = card.larger.text(), poles(drawn)
    first = live.session().sentence
    press_on_card("larger")
    until(lambda: poles(drawn) != before)
    live_at_rest()
    answers["larger"] = [words, poles(drawn)[-1][0] / before[-1][0], first, live.session().sentence]
    picture("larger.png")
    # nothing can be kept possible in an empty sketch
    Gui.ActiveDocument.resetEdit()
    empty = document.addObject("Sketcher::SketchObject", "Empty")
    Gui.ActiveDocument.setEdit(empty.Name)
    observers.switch(empty, on=True)
    until(lambda: live.session() is not None)
    until(live.session().card.verdict.isVisible)
    card = live.session().card
    live_at_rest()
    click(card.keep)
    wait(200)
    answers["empty"] = [card.heading.text(), card.keep.isChecked(), card.keep.isEnabled(), card.why.text()]
    picture("empty.png")


run(work)
