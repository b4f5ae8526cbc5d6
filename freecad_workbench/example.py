# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Opened by `make freecad`: a drawn arch, the strip that bends into it, and the flat part to cut."""

from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
from freecad.elastica_wb.features import flat, strip
from freecad.elastica_wb.shapes.part_shapes import spline_geometry
from PySide import QtCore

from elastica_cad.geometry.curves.plane_curve import PlaneCurve

SPAN = 400.0
LEFT = [(0, 0), (40, 5), (80, 40), (125, 160), (SPAN / 2, 175)]


def draw() -> None:
    """Draw the arch of examples/arch, standing upright."""
    document = App.newDocument("Arch")
    sketch = document.addObject("Sketcher::SketchObject", "Curve")
    sketch.Placement = App.Placement(App.Vector(), App.Rotation(App.Vector(1, 0, 0), 90))
    curve = PlaneCurve.spline([*LEFT, *((SPAN - x, y) for x, y in reversed(LEFT[:-1]))])
    sketch.exposeInternalGeometry(sketch.addGeometry(spline_geometry(curve), False))
    document.recompute()
    bent = strip.create(document, sketch)
    bent.MaxWidth = 40.0
    bent.EngravedText = "ARCH"
    flat.create(document, bent)
    document.recompute()


def look() -> None:
    """Show the view from the front, and the toolbar of the workbench."""
    Gui.activateWorkbench("ElasticaWorkbench")
    view = Gui.ActiveDocument.ActiveView
    view.viewIsometric()
    view.fitAll()
    App.Console.PrintMessage(
        f"Elastica ({Path(__file__).parents[1]}): double-click Curve under Strip, drag its poles, watch.\n"
    )


draw()
QtCore.QTimer.singleShot(500, look)
