"""A periodic spline drawn by the mouse becomes a strip; the panel and the card show why strips fail."""

import sys
from math import cos, pi, sin
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCADGui as Gui
from inside import (
    ARCH,
    answers,
    begun,
    button,
    fit,
    live_at_rest,
    mouse,
    on_screen,
    open_panel,
    panel,
    picture,
    run,
    sketch,
    trigger,
    typed,
    until,
    wait,
    window,
)

TURNS = [2 * pi * i / 11 for i in range(11)]
OVAL = [((100 + 8 * cos(2 * a)) * cos(a) - 60, (100 + 8 * cos(2 * a)) * sin(a)) for a in TURNS]
SPIRAL = [(80 * (1 - 0.01 * i) * cos(pi * i / 4), 80 * (1 - 0.01 * i) * sin(pi * i / 4)) for i in range(18)]


def closed_by_mouse():
    """A periodic spline through poles that are clicked; a right click ends it, and the strip follows."""
    document = begun("Oval")
    from freecad.elastica_wb.live import observers
    from freecad.elastica_wb.live import session as live

    drawn = document.addObject("Sketcher::SketchObject", "Sketch")
    Gui.ActiveDocument.setEdit(drawn.Name)
    observers.switch(drawn, on=True)
    fit("Top")
    fit(height=330)
    trigger("Sketcher_CreatePeriodicBSpline")
    wait(500)
    for place in OVAL:
        x, y = on_screen(*place)
        mouse("mousemove", x - 2, y - 2, "sleep", 0.1, "mousemove", x, y, "sleep", 0.1, "click", 1)
    mouse("sleep", 0.2, "click", 3)
    until(lambda: any(one.TypeId == "Part::GeomBSplineCurve" for one in drawn.Geometry))
    mouse("sleep", 0.2, "click", 3)
    live_at_rest()
    answers["periodic card"] = live.session().card.heading.text()
    picture("periodic.png")
    Gui.ActiveDocument.resetEdit()
    splines = [one for one in drawn.Geometry if one.TypeId == "Part::GeomBSplineCurve"]
    answers["periodic"] = [one.isPeriodic() for one in splines]
    open_panel("Elastica_Strip", drawn)
    picture("oval.png")
    button()
    answers["oval"] = [
        document.Strip.State,
        document.Strip.Verdict,
        document.Strip.Length.Value,
        drawn.Shape.Length,
    ]


def told_of_faults():
    """The panel of a strip that tips over, of three strips, and the card over the sketch."""
    document = begun("Faults")
    from freecad.elastica_wb.live import observers
    from freecad.elastica_wb.live import session as live

    drawn = [sketch(document, SPIRAL, name=name, poles=False) for name in ("First", "Second")]
    drawn.append(sketch(document, ARCH, name="Third", poles=False))
    for i, one in enumerate(drawn):
        one.Placement.Base.x = 400 * i
    document.recompute()
    open_panel("Elastica_Strip", drawn[0])
    typed("MaxWidth", "16 mm")
    fit("Top")
    answers["one"] = [panel().form.message.text(), panel().form.numbers.text(), document.Strip.SidewaysMargin]
    picture("one.png")
    button()
    open_panel("Elastica_Strip", *drawn[1:])
    typed("MaxWidth", "16 mm")
    button()
    open_panel("Elastica_Edit", *(one for one in document.Objects if one.Name.startswith("Strip")))
    answers["several"] = panel().form.message.text()
    picture("several.png")
    button()
    Gui.ActiveDocument.setEdit(drawn[0].Name)
    observers.switch(drawn[0], on=True)
    fit("Top")
    live_at_rest()
    card = live.session().card
    answers["card"] = [card.heading.text(), card.answer.verdict.value, card.words.text()]
    picture("card.png")
    Gui.ActiveDocument.resetEdit()


def work():
    window()
    closed_by_mouse()
    told_of_faults()


run(work)
