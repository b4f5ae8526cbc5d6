# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""File dialogs, and the cutting options of the preferences."""

import FreeCADGui as Gui
from freecad.elastica_wb.export.cutting_files import cutting_of
from freecad.elastica_wb.host import preferences
from freecad.elastica_wb.host.qt import QtWidgets

from elastica_cad.design.kit_spec import Cutting


def ask_file(title: str, name: str, kinds: str) -> str:
    """Let the user choose a file to write. Return "" if the user cancels."""
    return str(QtWidgets.QFileDialog.getSaveFileName(Gui.getMainWindow(), title, name, kinds)[0])


def ask_folder(title: str) -> str:
    """Let the user choose a folder. Return "" if the user cancels."""
    return str(QtWidgets.QFileDialog.getExistingDirectory(Gui.getMainWindow(), title))


def usual_cutting() -> Cutting:
    """Return the options of cutting files from the preferences."""
    return cutting_of(
        kerf=preferences.get("Kerf"),
        curves=preferences.get("Curves"),
        tolerance=preferences.get("Tolerance"),
        version=preferences.get("DxfVersion"),
    )
