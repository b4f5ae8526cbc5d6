# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Asking for files, and writing drawings with the user's preferences."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import FreeCADGui as Gui
from freecad.elastica_wb.export.cutting_files import write_cut
from freecad.elastica_wb.host import preferences
from freecad.elastica_wb.host.qt import QtWidgets

from elastica_cad.fabrication.drawings.drawing import Drawing


def ask_file(title: str, name: str, kinds: str) -> str:
    """Ask for a file to write; empty when the user cancels."""
    return str(QtWidgets.QFileDialog.getSaveFileName(Gui.getMainWindow(), title, name, kinds)[0])


def ask_folder(title: str) -> str:
    """Ask for a folder; empty when the user cancels."""
    return str(QtWidgets.QFileDialog.getExistingDirectory(Gui.getMainWindow(), title))


def save_drawing(drawing: Drawing, path: str | Path, **options: Any) -> Path:
    """Write a drawing with kerf, curves, tolerance and version as the preferences give them."""
    path = Path(path)
    given = {
        "kerf": preferences.get("Kerf"),
        "curves": preferences.get("Curves"),
        "tolerance": preferences.get("Tolerance"),
        "version": preferences.get("DxfVersion"),
    }
    return write_cut(replace(drawing, name=path.stem), path, **(given | options))
