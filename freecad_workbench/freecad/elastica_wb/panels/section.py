"""The panel of sections: axis, number of planes, tolerance."""

from typing import Any

import FreeCAD as App
from freecad.elastica_wb.panels.base import Panel
from freecad.elastica_wb.sections import AXES, section_sketches
from freecad.elastica_wb.text import tr
from freecad.elastica_wb.units import worded

from elastica_cad.errors import InputError

__all__ = ["SectionPanel"]


class SectionPanel(Panel):
    """The sketches are made at OK, in one undo step."""

    file = "section"
    icon_name = "Elastica_Section"
    step = "Section into curves"

    def __init__(self, bodies: list[Any]) -> None:
        super().__init__(App.ActiveDocument)
        self.bodies = bodies
        self.sketches: list[Any] = []
        self.form.axis.addItems(list(AXES))
        self.watch("axis", "count")
        self.changed()

    def changed(self) -> None:
        """Where the planes will be."""
        box, axis = self.bodies[0].Shape.BoundBox, self.form.axis.currentText()
        low, high = (getattr(box, f"{axis}{side}") for side in ("Min", "Max"))
        gap = (high - low) / self.form.count.value()
        self.tell(f"{tr('planes')}: {gap:.4g} mm {tr('apart')}")

    def finished(self) -> None:
        """Cut."""
        remarks: list[str] = []
        for body in self.bodies:
            made, said = section_sketches(
                self.document,
                body,
                self.form.axis.currentText(),
                self.form.count.value(),
                self.form.tolerance.value(),
            )
            self.sketches += made
            remarks += said
        if not self.sketches:
            raise InputError("; ".join(remarks))
        for remark in remarks:
            App.Console.PrintWarning(f"Elastica: {worded(remark)}\n")
