"""What goes wrong at a maker's desk, and how it is undone: strips that stand in each other."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
from inside import (
    ARCH,
    answers,
    begun,
    button,
    fit,
    open_panel,
    panel,
    picture,
    run,
    sketch,
    trigger,
    until,
    window,
)

UPRIGHT = App.Placement(App.Vector(), App.Rotation(App.Vector(1, 0, 0), 90))
BESIDE = App.Placement(App.Vector(0, 80, 0), App.Rotation(App.Vector(1, 0, 0), 90))


def seen(document):
    """Which of the features are in sight."""
    return {obj.Label: obj.Visibility for obj in document.Objects if hasattr(obj, "HiddenByError")}


def strip_on(document, name, place):
    drawn = sketch(document, ARCH, name=name, poles=False)
    drawn.Placement = place
    open_panel("Elastica_Strip", drawn)
    button()
    return document.Objects[-2]


def strips_within_each_other():
    """A model of them fails: its strips are what shows why."""
    document = begun("Within")
    strips = [strip_on(document, name, UPRIGHT) for name in ("One", "Other")]
    open_panel("Elastica_Interlock", *strips)
    answers["told in the panel"] = panel().form.message.text()
    button()
    answers["made in error"] = seen(document)
    fit("Isometric")
    picture("within.png")
    other = document.Other
    for name, place in (("apart", BESIDE), ("within again", UPRIGHT)):
        document.openTransaction(name)
        other.Placement = place
        document.commitTransaction()
        trigger("Std_Refresh")
        until(lambda: not document.isTouched())
        answers[name] = seen(document)
    trigger("Std_Undo")
    until(lambda: document.Model.Visibility)
    answers["undone"] = seen(document)
    App.closeDocument(document.Name)


def work():
    window()
    strips_within_each_other()


run(work)
