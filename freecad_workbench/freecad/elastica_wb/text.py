"""Words and pictures of the workbench: translation, icons, panels."""

from pathlib import Path
from typing import Any

import FreeCAD as App

__all__ = ["RESOURCES", "icon", "load_panel", "tr"]

RESOURCES = Path(__file__).resolve().parents[2] / "resources"


def tr(words: str, context: str = "Elastica") -> str:
    """The words in the user's language."""
    return str(App.Qt.translate(context, words))


def icon(name: str) -> str:
    """Path of an icon."""
    return str(RESOURCES / "icons" / f"{name}.svg")


def load_panel(name: str) -> Any:
    """A widget from its .ui file."""
    import FreeCADGui as Gui

    return Gui.PySideUic.loadUi(str(RESOURCES / "ui" / f"{name}.ui"))
