"""Buttons that carry the numbers of a refusal: pressed by the mouse, each gives a strip."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import math

import FreeCAD as App
import Part
from inside import (
    ARCH,
    answers,
    at_rest,
    begun,
    button,
    choose,
    click,
    fit,
    open_panel,
    panel,
    picture,
    press,
    run,
    scroll_to,
    sketch,
    suggested,
    suggestions,
    trigger,
    typed,
    until,
    window,
)

BOW = [(0, 0), (25, 45), (35, 90), (25, 135), (0, 180)]


def seen(name, strip):
    """What the panel offers, and how it looks."""
    at_rest()
    until(lambda: not panel().form.searching.isVisible())
    answers[name] = [strip.State[-1], suggestions()]
    picture(f"{name}.png")


def taken(words, strip):
    """Press the button with these words; the strip afterwards."""
    click(suggested(words))
    until(lambda: "Invalid" not in strip.State)
    at_rest()
    answers[words] = [strip.State, suggestions(), strip.Verdict]


def strip_along(document, drawn):
    before = set(document.Objects)
    open_panel("Elastica_Strip", drawn)
    return next(obj for obj in document.Objects if obj not in before and obj.Name.startswith("Strip"))


def broken_line(document):
    """An arc and a line whose ends are a thousandth of a millimetre apart."""
    made = document.addObject("Sketcher::SketchObject", "Gap")
    circle = Part.Circle(App.Vector(300, 100, 0), App.Vector(0, 0, 1), 100)
    made.addGeometry(Part.ArcOfCircle(circle, -math.pi / 2, -0.5), False)
    start = App.Vector(300, -0.001, 0)
    made.addGeometry(Part.LineSegment(start, start + App.Vector(-60, 0, 0)), False)
    document.recompute()
    return made


def work():
    window()
    document = begun("Suggested")
    drawn = sketch(document, ARCH)
    strip = strip_along(document, drawn)
    fit()
    typed("MaxWidth", "2 mm")
    seen("narrow", strip)
    width = next(words for words in suggestions() if any(char.isdigit() for char in words))
    taken(width, strip)
    answers["width"] = [width, strip.MaxWidth.Value]
    typed("Thickness", "4 mm")
    seen("breaks", strip)
    taken(suggestions()[-1], strip)
    answers["anyway"] = [strip.Anyway, strip.Thickness.Value]
    button()
    trigger("Std_Undo")
    until(lambda: document.getObject("Strip") is None)
    cubic = sketch(document, [(x + 200, y) for x, y in BOW], degree=3, name="Cubic")
    strip = strip_along(document, cubic)
    seen("smoothed", strip)
    answers["moved"] = strip.Deviation.Value
    box = panel().form.AsDrawn
    scroll_to(box)
    # the field is as wide as the panel in FreeCAD 1.1, and only its mark takes the click
    click(box, at=box.rect().topLeft() + type(box.rect().center())(8, box.height() // 2))
    until(lambda: strip.AsDrawn and suggestions())
    seen("kinks", strip)
    taken(suggestions()[0], strip)
    answers["smooth"] = strip.Smooth.Value
    button()
    gap = strip_along(document, broken_line(document))
    seen("gap", gap)
    taken(suggestions()[0], gap)
    answers["joined"] = [gap.JoinGaps.Value, gap.Length.Value, 60 + 100 * (math.pi / 2 - 0.5)]
    button()
    choose(cubic)
    press("Elastica_Projective")
    until(lambda: panel().form is not None and hasattr(panel().form, "reset"))
    at_rest()
    answers["pulled"] = panel().form.message.text()
    button("Cancel")
    strip.MaxWidth = 17
    document.recompute()
    choose(cubic)
    press("Elastica_Projective")
    until(lambda: panel().form is not None and hasattr(panel().form, "reset"))
    at_rest()
    answers["pulled, narrower"] = panel().form.message.text()
    picture("projective.png")
    button("Cancel")
    App.closeDocument(document.Name)


run(work)
