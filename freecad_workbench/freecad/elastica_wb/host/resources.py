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
"""Folder that `make addon` writes beside the modules. In a checkout it is beside `freecad`."""

_aside: list[Any] = []


def translate(context: str, words: str) -> str:
    """Return the words in the user's language."""
    return str(App.Qt.translate(context, words))


def QT_TRANSLATE_NOOP(_context: str, words: str) -> str:
    """Mark words for lupdate. They are translated where they are shown."""
    return words


def icon(name: str) -> str:
    """Return the path of an icon."""
    return str(RESOURCES / "icons" / f"{name}.svg")


def load_panel(name: str) -> Any:
    """Make a widget from its .ui file.

    PySide may reuse the wrapper of a deleted widget for a new widget at the same address, as in FreeCAD 1.0 with
    Python 3.13. Such a form is kept, so that its addresses stay occupied, and the file is loaded again.
    """
    import FreeCADGui as Gui

    for _ in range(TRIES):
        form = Gui.PySideUic.loadUi(str(RESOURCES / "ui" / f"{name}.ui"))
        if _sound(form):
            break
        _aside.append(form)
    return form


@cache
def quantities_of(name: str) -> dict[str, float]:
    """Return the values of the quantity boxes in a .ui file. The boxes keep only the digits that they show."""
    tree = ElementTree.parse(RESOURCES / "ui" / f"{name}.ui")
    values = {}
    for widget in tree.iter("widget"):
        if widget.get("class") == "Gui::QuantitySpinBox":
            value = widget.findtext("property[@name='rawValue']/double")
            values[widget.get("name", "")] = float(value or 0.0)
    return values


def _sound(form: Any) -> bool:
    """Return True if every widget has a wrapper of its own class."""
    from freecad.elastica_wb.host.qt import QtCore, QtWidgets

    for widget in vars(form).values():
        if isinstance(widget, QtCore.QObject):
            try:
                kind = getattr(QtWidgets, widget.metaObject().className(), QtCore.QObject)
            except RuntimeError:
                return False
            if not isinstance(widget, kind):
                return False
    return True
