# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Widgets of panels: values, signals, FreeCAD's quantity boxes, and protection from the mouse wheel."""

from collections.abc import Callable
from contextlib import suppress
from functools import cache
from textwrap import fill
from typing import Any

import FreeCADGui as Gui
from freecad.elastica_wb.host.qt import QtCore, QtGui, QtWidgets, kind_of
from freecad.elastica_wb.host.resources import translate
from freecad.elastica_wb.host.sheet_store import titled_sheets
from freecad.elastica_wb.host.words import worded

LARGEST = 1e9
WHOLE = 1_000_000
# visible letters of a choice, such as the name of a sheet, in a narrow panel
CHOICE_LETTERS = 14
# least width, pixels, of a box for a length with its unit, and largest width of a text on a button
NARROWEST_PX, BUTTON_PX = 105, 150
TRIES = 10

_aside: list[Any] = []

# text of keys that type nothing, such as arrows, Tab, Enter and Escape
UNTYPED = ("", "\t", "\r", "\x1b")
# properties of a box: the exact value, and the rounded value that it shows
EXACT, SHOWN = "exactValue", "shownValue"
UNITS = {"App::PropertyLength": "mm", "App::PropertyDistance": "mm", "App::PropertyAngle": "deg"}
NUMBER_CHANGED = QtCore.SIGNAL("valueChanged(double)")
"""Signal of FreeCAD's quantity box that sends a number. Python cannot read the signal that sends a quantity."""


def field_for(obj: Any, name: str) -> Any:
    """Return a widget that shows a property of an object."""
    kind = obj.getTypeIdOfProperty(name)
    if kind in UNITS or kind == "App::PropertyFloat":
        box = quantity_box()
        box.setProperty("unit", UNITS.get(kind, ""))
        box.setProperty("minimum", 0.0 if kind == "App::PropertyLength" else -LARGEST)
        box.setProperty("maximum", LARGEST)
        bind(box, obj, name)
    elif kind == "App::PropertyInteger":
        box = QtWidgets.QSpinBox()
        box.setRange(0, WHOLE)
    elif kind == "App::PropertyBool":
        box = QtWidgets.QCheckBox()
    elif kind == "App::PropertyEnumeration":
        box = QtWidgets.QComboBox()
        put_choices_of(box, obj, name)
    else:
        box = QtWidgets.QLineEdit()
    box.setObjectName(name)
    return box


def bind(box: Any, obj: Any, name: str) -> None:
    """Let a quantity box take formulas for a property."""
    if _is_quantity(box):
        Gui.ExpressionBinding(box).bind(obj, name)


def put_away(widget: Any) -> None:
    """Delete a widget of `field_for`, because a widget that remains would continue to react to formulas."""
    widget.blockSignals(True)
    widget.setParent(None)
    widget.deleteLater()


def put_choices_of(box: Any, obj: Any, name: str) -> None:
    """Fill a combo box with the choices of a property."""
    put = put_sheets if name in obj.Proxy.sheets else put_choices
    put(box, obj.getEnumerationsOfProperty(name))


def put_choices(box: Any, choices: list[str]) -> None:
    """Fill a combo box with choices in the language of the user."""
    _put_items(box, [(translate("Elastica", choice), choice) for choice in choices])


def put_sheets(box: Any, names: list[str]) -> None:
    """Fill a combo box with sheets, grouped under titles that cannot be chosen."""
    _put_items(box, [(worded(text), name) for text, name in titled_sheets(names)])
    for i in range(box.count()):
        if box.itemData(i) is None:
            # set the flags under the role that Qt uses, because the item sometimes has the wrong type in
            # PySide
            box.setItemData(i, 0, int(QtCore.Qt.UserRole) - 1)


def _put_items(box: Any, items: list[tuple[str, str | None]]) -> None:
    if [(box.itemText(i), box.itemData(i)) for i in range(box.count())] != items:
        blocked = box.blockSignals(True)
        box.clear()
        for text, value in items:
            box.addItem(text, value)
        box.blockSignals(blocked)
        box.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        box.setMinimumContentsLength(CHOICE_LETTERS)
        box.view().setMinimumWidth(box.view().sizeHintForColumn(0))


def put_text(button: Any, text: str) -> None:
    """Set the text of a button or check box, in lines that fit into a narrow panel."""
    wide = button.fontMetrics().boundingRect(text).width()
    button.setText(fill(text, len(text) * BUTTON_PX // wide) if wide > BUTTON_PX else text)


def value_of(widget: Any) -> Any:
    """Return the value that a widget shows, with lengths in mm."""
    if isinstance(widget, QtWidgets.QComboBox):
        return widget.currentText() if widget.currentData() is None else widget.currentData()
    if isinstance(widget, QtWidgets.QAbstractButton):
        return widget.isChecked()
    if isinstance(widget, QtWidgets.QLineEdit):
        return widget.text()
    if _is_quantity(widget):
        displayed, exact = float(widget.property("rawValue")), widget.property(EXACT)
        # the box stores only the displayed digits, so a kerf of 0.2 mm would become 0.01 in
        return float(exact) if exact is not None and displayed == widget.property(SHOWN) else displayed
    return widget.value()


def set_value(widget: Any, value: Any) -> None:
    """Set a widget's value without sending a signal."""
    blocked = widget.blockSignals(True)
    if isinstance(widget, QtWidgets.QComboBox):
        widget.setCurrentIndex(max(widget.findData(value), widget.findText(value)))
    elif isinstance(widget, QtWidgets.QAbstractButton):
        widget.setChecked(value)
    elif isinstance(widget, QtWidgets.QLineEdit):
        widget.setText(value)
    elif _is_quantity(widget):
        widget.setProperty("rawValue", float(value))
        widget.setProperty(EXACT, float(value))
        widget.setProperty(SHOWN, float(widget.property("rawValue")))
    else:
        widget.setValue(value)
    widget.blockSignals(blocked)


def on_change(widget: Any, slot: Callable[..., Any]) -> None:
    """Call `slot` whenever the user changes the value of a widget."""
    if _is_quantity(widget):
        QtCore.QObject.connect(widget, NUMBER_CHANGED, slot)
    else:
        _signal_of(widget).connect(slot)


def send_change(widget: Any, value: Any) -> None:
    """Send the signal of a changed widget."""
    if _is_quantity(widget):
        widget.emit(NUMBER_CHANGED, value)
    else:
        _signal_of(widget).emit(value)


def _signal_of(widget: Any) -> Any:
    if isinstance(widget, QtWidgets.QComboBox):
        return widget.currentIndexChanged
    if isinstance(widget, QtWidgets.QLineEdit):
        return widget.textEdited
    if isinstance(widget, QtWidgets.QAbstractButton):
        return widget.toggled
    return widget.valueChanged


def into_sight(widget: Any) -> None:
    """Scroll the panel of a widget to the widget."""
    above = widget.parentWidget()
    while above is not None:
        if isinstance(above, QtWidgets.QScrollArea):
            above.ensureWidgetVisible(widget)
        above = above.parentWidget()


def calm(form: Any) -> None:
    """Make the widgets of a form ignore the mouse wheel until clicked, and keep the digits of typed numbers."""
    keeper = _InputFilter(form)
    for kind in (QtWidgets.QAbstractSpinBox, QtWidgets.QComboBox):
        for widget in form.findChildren(kind):
            widget.setFocusPolicy(QtCore.Qt.StrongFocus)
            widget.installEventFilter(keeper)
            if _is_quantity(widget):
                # with limits, FreeCAD drops the first m of "0.15 mm" if 0.15 m is too large
                if widget.property("minimum") < 0:
                    widget.setProperty("minimum", -LARGEST)
                widget.setProperty("maximum", LARGEST)
            if isinstance(widget, QtWidgets.QAbstractSpinBox):
                widget.setKeyboardTracking(False)
                widget.setMinimumWidth(NARROWEST_PX)


@cache
def _loader() -> Any:
    """Return the cached loader of forms. PySide deletes the widgets of a deleted loader."""
    return Gui.UiLoader()


def quantity_box() -> Any:
    """Return a new FreeCAD input field for quantities.

    PySide sometimes gives a new widget the unusable Python wrapper of a deleted widget at the same address.
    Such a widget stays in memory, so that the next attempt gets another address.
    """
    for _ in range(TRIES):
        box = _loader().createWidget("Gui::QuantitySpinBox")
        try:
            box.text()
        except (RuntimeError, AttributeError):
            _aside.append(box)
        else:
            break
    return box


def _is_quantity(widget: Any) -> bool:
    return str(widget.metaObject().className()) in ("Gui::QuantitySpinBox", "Gui::PrefQuantitySpinBox")


def _is_emptied(widget: Any) -> bool:
    """Return True for an emptied box with a special text for its minimum.

    Qt would restore the old text.
    """
    may_be_empty = isinstance(widget, QtWidgets.QDoubleSpinBox) and bool(widget.specialValueText())
    return may_be_empty and not widget.cleanText().strip()


def _is_number_box(widget: Any) -> bool:
    return isinstance(widget, QtWidgets.QAbstractSpinBox) and not isinstance(widget, QtWidgets.QSpinBox)


class _InputFilter(QtCore.QObject):
    def eventFilter(self, widget: Any, event: Any) -> bool:
        kind = kind_of(event)
        typed_text = event.text() if kind == QtCore.QEvent.KeyPress else ""
        if typed_text == "." and _is_number_box(widget):
            point = str(widget.locale().decimalPoint())
            if point != ".":
                # the box would read the point as a separator of thousands, and 0.5 mm as 5 mm
                typed = QtGui.QKeyEvent(kind, QtCore.Qt.Key_Comma, event.modifiers(), point)
                QtWidgets.QApplication.sendEvent(widget, typed)
                return True
        if kind == QtCore.QEvent.Wheel and not widget.hasFocus():
            event.ignore()
            return True
        if (kind == QtCore.QEvent.FocusOut or typed_text == "\r") and _is_emptied(widget):
            widget.setValue(widget.minimum())
        if typed_text not in UNTYPED and _is_quantity(widget):
            widget.setProperty(EXACT, None)
        elif kind == QtCore.QEvent.FocusOut and _is_quantity(widget) and widget.property(EXACT) is None:
            # wait until the box has read the typed text
            QtCore.QTimer.singleShot(0, lambda: _settle(widget))
        return False


def _settle(box: Any) -> None:
    """Send the change signal, which Qt omits if the rounded value is the same."""
    with suppress(RuntimeError):  # the panel may already be closed
        displayed = float(box.property("rawValue"))
        box.setProperty(EXACT, displayed)
        box.setProperty(SHOWN, displayed)
        send_change(box, displayed)
