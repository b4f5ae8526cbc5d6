"""The panel of a strip: sheet, widths, supports, ends, and the numbers that follow."""

from typing import Any

from freecad.elastica_wb.panels.base import Panel
from freecad.elastica_wb.qt import QtWidgets
from freecad.elastica_wb.text import tr
from freecad.elastica_wb.units import worded

__all__ = ["StripPanel"]

FIELDS = (
    "Sheet", "Thickness", "MaxWidth", "MinWidth", "Style",
    "OuterWidth", "Columns", "Rows", "Backing", "StartSupport", "EndSupport", "Gravity", "Follow",
    "RatioLimit", "MarginLimit", "StrainLimit", "KeepTangents", "KeepLength", "StartTab", "EndTab",
    "TabRadius", "TabHole", "EngravedText", "Quantity", "Form",
)  # fmt: skip
"""Widgets of the panel; each is called as the property that it shows."""


class StripPanel(Panel):
    """Edits the properties of one strip, with its numbers and its shape following."""

    file = "strip"
    icon_name = "Elastica_Strip"
    step = "Edit strip"

    def __init__(self, obj: Any) -> None:
        super().__init__(obj.Document, [obj])
        self.object = obj
        for name in FIELDS:
            self._fill(name)
        self.watch(*FIELDS)
        self.form.Sheet.currentIndexChanged.connect(self._new_sheet)
        self._show()

    def changed(self) -> None:
        """Widgets to properties, then a recompute."""
        for name in FIELDS:
            value = _value(getattr(self.form, name))
            present = getattr(self.object, name)
            if getattr(present, "Value", present) != value:
                setattr(self.object, name, value)
        self.document.recompute()
        self._show()

    def finished(self) -> None:
        """Nothing may wait."""
        self.now()

    def _new_sheet(self, *_: Any) -> None:
        """A chosen sheet brings its thickness at once."""
        self.object.Sheet = self.form.Sheet.currentText()
        self._fill("Thickness")

    def _fill(self, name: str) -> None:
        widget, value = getattr(self.form, name), getattr(self.object, name)
        widget.blockSignals(True)
        if isinstance(widget, QtWidgets.QComboBox):
            widget.clear()
            widget.addItems(self.object.getEnumerationsOfProperty(name))
            widget.setCurrentText(value)
        elif isinstance(widget, QtWidgets.QCheckBox):
            widget.setChecked(value)
        elif isinstance(widget, QtWidgets.QLineEdit):
            widget.setText(value)
        else:
            widget.setValue(getattr(value, "Value", value))
        widget.blockSignals(False)

    def _show(self) -> None:
        obj = self.object
        if "Invalid" in obj.State:
            self.form.numbers.setText("")
            self.tell(" ".join([obj.Verdict, *obj.Reasons]))
            return
        rows = (
            (tr("Length"), f"{obj.Length.Value:.2f} mm"),
            (tr("Narrowest place"), f"{obj.NarrowestWidth.Value:.2f} mm"),
            (tr("Stiffness ratio"), f"{obj.Ratio:.3g}"),
            (tr("Largest strain"), f"{obj.LargestStrain:.2f} % ({obj.StrainUse} %)"),
            (tr("Stability margin"), f"{obj.Margin:.3g}"),
            (tr("Mass"), f"{obj.Mass:.3g} g"),
        )
        table = "".join(
            f"<tr><td>{name}&nbsp;&nbsp;</td><td><b>{value}</b></td></tr>" for name, value in rows
        )
        self.form.numbers.setText(worded(f"<table>{table}</table>"))
        self.tell(" ".join([obj.Verdict, *obj.Reasons]))


def _value(widget: Any) -> Any:
    if isinstance(widget, QtWidgets.QComboBox):
        return widget.currentText()
    if isinstance(widget, QtWidgets.QCheckBox):
        return widget.isChecked()
    return widget.text() if isinstance(widget, QtWidgets.QLineEdit) else widget.value()
