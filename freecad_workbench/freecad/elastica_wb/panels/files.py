"""Asking for files, and writing drawings with the user's preferences."""

from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import FreeCADGui as Gui
from freecad.elastica_wb import preferences
from freecad.elastica_wb.qt import QtWidgets

from elastica_cad.fabrication import Drawing
from elastica_cad.formats import write_drawing

__all__ = ["ask_file", "ask_folder", "save_drawing"]


def ask_file(title: str, name: str, kinds: str) -> str:
    """A file to write; empty when the user cancels."""
    return str(QtWidgets.QFileDialog.getSaveFileName(Gui.getMainWindow(), title, name, kinds)[0])


def ask_folder(title: str) -> str:
    """A folder; empty when the user cancels."""
    return str(QtWidgets.QFileDialog.getExistingDirectory(Gui.getMainWindow(), title))


def save_drawing(drawing: Drawing, path: str | Path, **options: Any) -> Path:
    """Write a drawing as the preferences say; a DXF offers to install what it needs."""
    path = Path(path)
    if path.suffix.lower() == ".dxf" and find_spec("ezdxf") is None:
        from freecad.elastica_wb.commands.libraries import offer

        offer(["ezdxf"])
    given = {
        "kerf": preferences.get("Kerf"),
        "curves": preferences.get("Curves"),
        "tolerance": preferences.get("Tolerance"),
        "version": preferences.get("DxfVersion"),
        "force": True,
    }
    return write_drawing(replace(drawing, name=path.stem), path, **(given | options))
