# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Resources of the workbench: translations, icons, panels."""

from functools import cache
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import FreeCAD as App

TRIES = 10

HERE = Path(__file__).resolve()

RESOURCES = next(at / "resources" for at in (HERE.parents[1], HERE.parents[3]) if (at / "resources").is_dir())
"""Folder of resources: beside the modules in an addon, beside the folder `freecad` in a checkout."""

_aside: list[Any] = []


def translate(context: str, words: str) -> str:
    """Return a text in the language of the user."""
    return str(App.Qt.translate(context, words))


def QT_TRANSLATE_NOOP(_context: str, words: str) -> str:
    """Mark a text for lupdate, so that `translate` can translate it later."""
    return words


def icon(name: str) -> str:
    """Return the path of an icon."""
    return str(RESOURCES / "icons" / f"{name}.svg")


def load_panel(name: str) -> Any:
    """Make a widget from its .ui file.

    PySide in FreeCAD 1.0 with Python 3.13 may give a new widget the Python wrapper of a deleted widget at the
    same address. A form with such a wrapper stays in memory, and the file is loaded again at other addresses.
    """
    import FreeCADGui as Gui

    for _ in range(TRIES):
        form = Gui.PySideUic.loadUi(str(RESOURCES / "ui" / f"{name}.ui"))
        if _has_right_wrappers(form):
            break
        _aside.append(form)
    return form


@cache
def quantities_of(name: str) -> dict[str, float]:
    """Return the values of the quantity boxes in a .ui file.

    The boxes themselves keep only the displayed digits.
    """
    tree = ElementTree.parse(RESOURCES / "ui" / f"{name}.ui")
    values = {}
    for widget in tree.iter("widget"):
        if widget.get("class") == "Gui::QuantitySpinBox":
            value = widget.findtext("property[@name='rawValue']/double")
            values[widget.get("name", "")] = float(value or 0.0)
    return values


def _has_right_wrappers(form: Any) -> bool:
    from freecad.elastica_wb.host.qt import QtCore, QtWidgets

    for widget in vars(form).values():
        if not isinstance(widget, QtCore.QObject):
            return False
        try:
            name = widget.metaObject().className()
        except RuntimeError:
            return False
        # Qt does not have FreeCAD's own widgets, such as Gui::QuantitySpinBox
        if not isinstance(widget, getattr(QtWidgets, name, QtWidgets.QWidget)):
            return False
    return True
