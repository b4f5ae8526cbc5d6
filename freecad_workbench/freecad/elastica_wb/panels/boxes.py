"""Boxes for lengths in the user's unit: the value stays in mm, what is shown and typed does not."""

import math
from typing import Any

import FreeCAD as App
from freecad.elastica_wb.qt import QtGui, QtWidgets
from freecad.elastica_wb.units import Unit, shown_unit

__all__ = ["LengthBox", "lengths_in_users_unit"]

FINER = 3  # digits more than the panel shows, so that 1/8 in stays what it is
MM = " mm"

Valid = QtGui.QValidator


class LengthBox(QtWidgets.QDoubleSpinBox):
    """A box whose value is mm; it takes other units too, typed after the number."""

    def __init__(self, unit: Unit, like: Any) -> None:
        super().__init__(like.parentWidget())
        self.unit = unit
        self.digits = max(0, like.decimals() + math.ceil(math.log10(unit.size)))
        self.setDecimals(like.decimals() + FINER)
        self.setRange(like.minimum(), like.maximum())
        self.setSingleStep(
            like.singleStep() if unit.size < 1 else unit.size * _round(like.singleStep() / unit.size)
        )
        self.setSuffix(f" {unit.name}")
        self.setKeyboardTracking(like.keyboardTracking())
        self.setToolTip(like.toolTip())
        self.setSizePolicy(like.sizePolicy())
        self.setEnabled(like.isEnabled())
        self.setObjectName(like.objectName())
        self.setValue(like.value())

    def textFromValue(self, value: float) -> str:
        """The number shown, without the unit."""
        return f"{value / self.unit.size:.{self.digits}f}"

    def valueFromText(self, text: str) -> float:
        """mm; what cannot be read leaves the value."""
        found = self.read(text)
        return self.value() if found is None else found

    def validate(self, text: str, place: int) -> Any:
        """Anything may be typed; it counts once it is a length within the range."""
        found = self.read(text)
        good = found is not None and self.minimum() <= found <= self.maximum()
        return (Valid.Acceptable if good else Valid.Intermediate), text, place

    def fixup(self, text: str) -> str:
        """What cannot be read becomes the value that was."""
        found = self.read(text)
        kept = self.value() if found is None else min(max(found, self.minimum()), self.maximum())
        return self.textFromValue(kept) + self.suffix()

    def read(self, text: str) -> float | None:
        """mm of a text, or None."""
        # Qt writes the suffix after whatever was typed, so also after "2 cm"
        words = text.removesuffix(self.suffix()).strip().replace(",", ".")
        if words == self.textFromValue(self.value()):
            return float(self.value())  # looked at is not changed, though fewer digits are shown
        try:
            found = App.Units.Quantity(words)
        except (ValueError, OSError):
            return None
        if not words or found.Unit not in (App.Units.Length, App.Units.Unit()):
            return None
        return float(found.Value) * (1.0 if found.Unit == App.Units.Length else self.unit.size)


def lengths_in_users_unit(form: Any) -> None:
    """Put boxes in the user's unit in place of the form's boxes for mm."""
    unit = shown_unit()
    for box in form.findChildren(QtWidgets.QDoubleSpinBox):
        if box.suffix() == MM and not isinstance(box, LengthBox):
            better = LengthBox(unit, box)
            box.parentWidget().layout().replaceWidget(box, better)
            # not deleted: PySide may take its Python face for another widget at the same address
            box.setObjectName("")
            box.hide()
            setattr(form, better.objectName(), better)


def _round(step: float) -> float:
    """A step of one digit."""
    power = 10.0 ** math.floor(math.log10(step))
    return power * (5 if step / power >= 5 else 2 if step / power >= 2 else 1)
