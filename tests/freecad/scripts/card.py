"""The card over an open sketch: the mouse goes through, poles stay in sight, it folds, and its button draws."""

import sys
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
    run,
    sketch,
    still,
    until,
    window,
)

BAD = [(0, 0), (40, 60), (80, -60), (120, 60), (160, -10), (200, 90)]


def at_the_card(card):
    """The middle of its words on the screen."""
    return card.words.mapToGlobal(card.words.rect().center())


def covering(card):
    """Panels of FreeCAD 1.1 that lie over the card."""

    def on_the_screen(widget):
        return QtCore.QRect(widget.mapToGlobal(QtCore.QPoint(0, 0)), widget.size())

    panels = [
        one
        for one in Gui.getMainWindow().findChildren(QtWidgets.QTabWidget)
        if one.metaObject().className() == "Gui::OverlayTabWidget" and one.isVisible() and one.count()
    ]
    return [one.objectName() for one in panels if on_the_screen(one).intersects(on_the_screen(card.frame))]


def is_hidden(card, place):
    """Does the card lie over a place in space?"""
    corner = card.frame.mapToGlobal(QtCore.QPoint(0, 0))
    return card.frame.rect().contains(QtCore.QPoint(*on_screen(*place)) - corner)


def pole(drawn, number):
    return tuple(drawn.Geometry[0].getPole(number))[:2]


def in_a_small_view(drawn, card):
    """The card where the view has little room: points of the curve below it; unfolded and folded by its button."""
    main = Gui.getMainWindow()
    main.showNormal()
    main.resize(760, 520)
    until(lambda: card.frame.parent().height() < 330)
    fit("Top")
    fit(height=150)
    folded = until(lambda: not card.words.isVisible(), 10)
    still(lambda: card.frame.geometry().getRect())
    curve = drawn.Geometry[0]
    span = curve.LastParameter - curve.FirstParameter
    points = [tuple(curve.value(curve.FirstParameter + span * k / 60))[:2] for k in range(61)]
    picture("small.png")
    below = sum(is_hidden(card, point) for point in points)
    click(card.fold)
    opened = until(card.words.isVisible, 10)
    still(lambda: card.frame.geometry().getRect())
    picture("small-opened.png")
    click(card.fold)
    return [folded, below, opened, until(lambda: not card.words.isVisible(), 10)]


def work():
    window()
    drawn = sketch(begun("Card"), BAD)
    from freecad.elastica_wb.live import observers
    from freecad.elastica_wb.live import session as live

    Gui.ActiveDocument.setEdit(drawn.Name)
    observers.switch(drawn, on=True)
    fit("Top")
    fit(height=320)
    searching = until(live.session().card.button.isVisible)
    card = live.session().card
    answers["searching"] = [searching, card.button.text(), card.button.isEnabled()]
    live_at_rest()
    answers["legend"] = card.legend.text()
    answers["covered"] = covering(card)
    answers["found"] = [card.button.text(), card.button.isEnabled()]
    picture("card.png")
    # the wheel over the words of the card zooms the view below it
    place, before = at_the_card(card), looks_from()
    mouse("mousemove", place.x(), place.y(), "sleep", 0.1, "click", 4)
    answers["wheel goes through"] = until(lambda: looks_from() != before)
    fit(height=320)
    # a pole is dragged below the card, which then lies elsewhere
    start, place = pole(drawn, 3), at_the_card(card)
    x, y = on_screen(*start)
    drag(start, 8, ((place.x() - x) / 8, (place.y() - y) / 8))
    until(lambda: pole(drawn, 3) != start)
    live_at_rest()
    answers["kept off"] = until(lambda: not is_hidden(card, pole(drawn, 3)), 10)
    picture("kept-off.png")
    drawn.Document.undo()
    live_at_rest()
    until(card.words.isVisible)  # folded while it would hide the pole
    height = card.frame.height()
    click(card.fold)
    answers["folded"] = [card.frame.height() < height / 3, card.words.isVisible(), card.button.isVisible()]
    picture("folded.png")
    click(card.fold)
    answers["unfolded"] = [card.frame.height() > height / 2, card.words.isVisible()]
    until(lambda: live.session().near is not None)
    answers["small"] = in_a_small_view(drawn, card)
    window()
    fit(height=320)
    answers["large again"] = until(card.words.isVisible, 10)
    until(lambda: live.session().near is not None)
    click(card.button)
    until(lambda: drawn.Geometry[0].NbPoles > len(BAD), 120)
    live_at_rest()
    circles = [one for one in drawn.Geometry if one.TypeId == "Part::GeomCircle"]
    answers["drawn"] = [drawn.Geometry[0].NbPoles, len(circles), card.answer.verdict.value]
    answers["cost"] = live.session().sentence
    picture("poles.png")


run(work)
