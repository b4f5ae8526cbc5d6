"""The panel of a model: how strips are slotted into each other."""

from typing import Any

from freecad.elastica_wb.panels.base import Panel
from freecad.elastica_wb.text import tr

__all__ = ["ModelPanel"]


class ModelPanel(Panel):
    """Edits a model that is there already; the slots follow."""

    file = "model"
    icon_name = "Elastica_Interlock"
    step = "Interlock strips"

    def __init__(self, obj: Any) -> None:
        super().__init__(obj.Document, [obj])
        self.object = obj
        form = self.form
        form.Interlock.setChecked(obj.Interlock)
        form.Clearance.setValue(obj.Clearance.Value)
        for name in ("Fit", "Relief"):
            widget = getattr(form, name)
            widget.addItems(obj.getEnumerationsOfProperty(name))
            widget.setCurrentText(getattr(obj, name))
        self.watch("Interlock", "Clearance", "Fit", "Relief")
        self._show()

    def changed(self) -> None:
        """Widgets to properties, then a recompute."""
        form, obj = self.form, self.object
        obj.Interlock = form.Interlock.isChecked()
        obj.Clearance = form.Clearance.value()
        obj.Fit, obj.Relief = form.Fit.currentText(), form.Relief.currentText()
        self.document.recompute()
        self._show()

    def finished(self) -> None:
        """Nothing may wait."""
        self.now()

    def _show(self) -> None:
        if "Invalid" in self.object.State:
            self.tell(self.object.getStatusString())
            return
        self.tell("\n".join([f"{tr('Joints')}: {self.object.Joints}", *self.object.Reports]))
