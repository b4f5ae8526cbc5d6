# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Example document for new users: a drawn arch, the strip that bends into it, and the flat part."""

from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
from freecad.elastica_wb import make_strip
from freecad.elastica_wb.curves.part_shapes import spline_geometry
from freecad.elastica_wb.host.resources import translate

from elastica_cad.geometry.plane_curve import PlaneCurve

SPAN = 400.0
LEFT = [(0, 0), (40, 5), (80, 40), (125, 160), (SPAN / 2, 175)]


def open_example() -> Any:
    """Draw the arch of examples/arch in a vertical plane of a new document, with its strip and flat part."""
    document = App.newDocument("Arch")
    sketch = document.addObject("Sketcher::SketchObject", "Curve")
    sketch.Label = translate("Elastica", "Curve")
    sketch.Placement = App.Placement(App.Vector(), App.Rotation(App.Vector(1, 0, 0), 90))
    curve = PlaneCurve.spline([*LEFT, *((SPAN - x, y) for x, y in reversed(LEFT[:-1]))])
    sketch.exposeInternalGeometry(sketch.addGeometry(spline_geometry(curve), False))
    document.recompute()
    make_strip(sketch, MaxWidth=40.0, EngravedText="ARCH")
    view = Gui.ActiveDocument.ActiveView
    view.viewIsometric()
    view.fitAll()
    return document


if __name__ == "__main__":
    Gui.activateWorkbench("ElasticaWorkbench")
    open_example()
