# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Words and pictures of the workbench: translation, icons, panels."""

from functools import cache
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import FreeCAD as App

TRIES = 10

HERE = Path(__file__).resolve()

RESOURCES = next(at / "resources" for at in (HERE.parents[1], HERE.parents[3]) if (at / "resources").is_dir())
"""In the folder that `make addon` writes beside the modules, in a checkout beside `freecad`."""

_aside: list[Any] = []


def translate(context: str, words: str) -> str:
    """Return the words in the user's language."""
    return str(App.Qt.translate(context, words))


def QT_TRANSLATE_NOOP(_context: str, words: str) -> str:
    """Words that are translated where they are shown; here lupdate finds them."""
    return words


def icon(name: str) -> str:
    """Return the path of an icon."""
    return str(RESOURCES / "icons" / f"{name}.svg")


def load_panel(name: str) -> Any:
    """Make a widget from its .ui file.

    PySide may take the Python face of a deleted widget for a new one at the same address (FreeCAD 1.0 on
    Python 3.13 does); such a form is put aside, where it keeps its addresses, and the file is loaded anew.
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
    """The values that a .ui file gives its quantity boxes: these keep only the digits that they show."""
    tree = ElementTree.parse(RESOURCES / "ui" / f"{name}.ui")
    found = {}
    for widget in tree.iter("widget"):
        if widget.get("class") == "Gui::QuantitySpinBox":
            given = widget.findtext("property[@name='rawValue']/double")
            found[widget.get("name", "")] = float(given or 0.0)
    return found


def _sound(form: Any) -> bool:
    """Does every widget have the face of its own class?"""
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
