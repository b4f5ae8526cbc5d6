# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Windows with messages that do not block FreeCAD."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import FreeCADGui as Gui
from freecad.elastica_wb.host.qt import QtCore, QtGui, QtWidgets
from freecad.elastica_wb.host.resources import translate
from freecad.elastica_wb.host.words import report, report_error, report_warning, worded

from elastica_cad._text import printable

STATUS_MS = 20_000
MOST_FILES = 12

_open_boxes: list[Any] = []


def show_message(sentence: str) -> None:
    """Show a sentence in the report view, in the status bar, and in a window that does not block FreeCAD."""
    sentence = worded(sentence)
    report_error(sentence)
    Gui.getMainWindow().statusBar().showMessage(sentence, STATUS_MS)
    _show(sentence)


def show_files(files: list[Path], notes: Sequence[str] = ()) -> None:
    """Show the written files and notes, with a button that opens the folder."""
    folder = files[0].parent
    names = [file.name for file in files[:MOST_FILES]] + ["..."] * (len(files) > MOST_FILES)
    heading = f"{translate('Elastica', 'Written to')} {folder}:"
    report(f"{heading} {', '.join(file.name for file in files)}")
    notes = list(map(worded, notes))
    for note in notes:
        report_warning(note)
    box = _show("\n".join([heading, *names, *notes]))
    button = box.addButton(translate("Elastica", "Open folder"), QtWidgets.QMessageBox.ActionRole)
    button.setObjectName("openFolder")
    address = QtCore.QUrl.fromLocalFile(str(folder))
    button.clicked.connect(lambda: QtGui.QDesktopServices.openUrl(address))


def _show(words: str) -> Any:
    box = QtWidgets.QMessageBox(Gui.getMainWindow())
    box.setObjectName("ElasticaTold")
    box.setIcon(QtWidgets.QMessageBox.Information)
    box.setWindowTitle("Elastica")
    # a label may look like HTML
    box.setTextFormat(QtCore.Qt.PlainText)
    box.setText(printable(words))
    box.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
    box.setStandardButtons(QtWidgets.QMessageBox.Ok)
    box.setModal(False)
    box.show()
    _open_boxes[:] = [box]
    return box
