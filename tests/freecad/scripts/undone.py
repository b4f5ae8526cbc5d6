"""An interlocked model of twelve ribs, taken back and made again by quick keys."""

import os
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
import numpy as np
from drawn_splines import spline
from freecad.elastica_wb.host.qt import kind_of
from inside import (
    ARCH,
    answers,
    begun,
    button,
    click,
    fit,
    open_panel,
    report,
    run,
    sketch,
    still,
    typed,
    until,
    viewport,
    wait,
    window,
)
from PySide import QtCore

GAPS_MS = [int(gap) for gap in os.environ.get("ELASTICA_TEST_GAPS", "30 120 450").split()]
"""Pauses between keys: shorter than that before a recompute, and so long that the next key falls into it."""
PLACES = (30, 60, 95, 205, 240, 270)
STEPS = 3


def ribs(document):
    """Sketches of arches along x and along y that cross each other on a dome."""
    points = [(2 * x, 1.2 * y) for x, y in ARCH]
    curve = spline(points)
    along = np.array([tuple(curve.value(t))[:2] for t in np.linspace(0, 1, 2001)])
    upright = App.Rotation(App.Vector(1, 0, 0), 90)
    for at in PLACES:
        height = float(np.interp(at, *along.T))
        for base, turn in (((0, at, height), 0), ((at, 0, height), 90)):
            made = sketch(document, points, name="Rib", poles=False)
            made.Placement = App.Placement(
                App.Vector(*base), App.Rotation(App.Vector(0, 0, 1), turn) * upright
            )
            yield made


def strips(document):
    return [one for one in document.Objects if one.Name.startswith("Strip")]


class Recomputes(QtCore.QObject):
    """Counts turns of the wheel over the view and timers within recomputes, and all turns."""

    def __init__(self, document):
        super().__init__()
        self.document, self.within, self.turns = document, {"wheel": 0, "timer": 0}, 0
        for widget in (viewport(), *viewport().findChildren(QtCore.QObject)):
            widget.installEventFilter(self)
        self.timer = QtCore.QTimer()
        self.timer.timeout.connect(lambda: self.note("timer"))
        self.timer.start(5)

    def note(self, name):
        self.within[name] += self.document.Recomputing

    def eventFilter(self, _watched, event):
        if kind_of(event) == QtCore.QEvent.Wheel:
            self.turns += 1
            self.note("wheel")
        return False


def quick(document, key, gap):
    """A key and the wheel three times, and the window until the document rests: what the document then holds."""
    click(viewport())
    keys = ["key", key, "sleep", str(gap / 1000), *["click", "4", "click", "5"] * 3] * STEPS
    process = subprocess.Popen(["xdotool", *keys])
    until(lambda: process.poll() is not None)

    def seen():
        volumes = [one.Shape.Volume for one in document.Objects if one.Name == "Model"]
        return document.Recomputing, document.UndoCount, len(document.Objects), volumes

    still(seen, quiet=1.5)
    invalid = [one.Name for one in document.Objects if "Invalid" in one.State]
    return [document.UndoNames, len(document.Objects), invalid, *seen()[3]]


def work():
    window()
    document = begun("Ribs")
    document.openTransaction("Ribs")
    drawn = list(ribs(document))
    document.commitTransaction()
    open_panel("Elastica_Strip", *drawn)
    button()
    open_panel("Elastica_Interlock", *strips(document))
    button()
    open_panel("Elastica_Edit", *strips(document))
    typed("MaxWidth", "26 mm")
    button()
    fit("Isometric")
    wait(1500)
    model = document.Model
    answers["made"] = [document.UndoNames, len(document.Objects), model.Joints, model.Shape.Volume]
    before, recomputes = len(report()), Recomputes(document)
    answers["rounds"] = [
        [gap, quick(document, "ctrl+z", gap), quick(document, "ctrl+shift+z", gap)] for gap in GAPS_MS
    ]
    answers["within"], answers["turns"] = recomputes.within, recomputes.turns
    answers["refused"] = [line for line in report()[before:].splitlines() if "recomput" in line]


run(work)
