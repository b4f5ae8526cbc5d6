# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The panel for writing cutting files: kinds of files, options and folder."""

import os
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import FreeCADGui as Gui
from freecad.elastica_wb.cutting_files import (
    KINDS,
    cutting_of,
    later_feature_messages,
    write_cutting_files,
)
from freecad.elastica_wb.features.model import overlaps_of
from freecad.elastica_wb.features.pieces import counted, cuts_of, pre_bend_messages_of, without_refused
from freecad.elastica_wb.host import preferences
from freecad.elastica_wb.host.dialogs import show_files
from freecad.elastica_wb.host.fields import put_choices, set_value
from freecad.elastica_wb.host.objects import is_model
from freecad.elastica_wb.host.progress import progress
from freecad.elastica_wb.host.qt import QtWidgets
from freecad.elastica_wb.host.resources import QT_TRANSLATE_NOOP, translate
from freecad.elastica_wb.panels.panel import Panel

from elastica_cad.design.kit_spec import Cutting
from elastica_cad.design.records import idle_keys
from elastica_cad.design.tables import Table
from elastica_cad.errors import InputError, Length, note, sentences
from elastica_cad.formats.drawing_style import CURVES
from elastica_cad.formats.dxf_drawing import DXF_VERSIONS
from elastica_cad.strip.pieces import Piece

INEXACT = ["arc", "polyline"]
"""Types of curves in DXF files of version R12, which have no splines."""


class ExportPanel(Panel):
    """Panel that writes files on OK. The document does not change."""

    file = "export"
    icon_name = "Elastica_Export"

    def __init__(self, sources: list[Any]) -> None:
        strips, left_out = without_refused(sources)
        cuts = cuts_of(strips)
        self.pieces = [cut.piece for cut in cuts]
        super().__init__(subjects=strips)
        self.strips = strips
        self.written: list[Path] = []
        form = self.form
        form.version.addItems(list(DXF_VERSIONS))
        form.version.setCurrentText(preferences.get("DxfVersion"))
        self._offer(list(CURVES), preferences.get("Curves"))
        set_value(form.kerf, preferences.get("Kerf"))
        set_value(form.tolerance, preferences.get("Tolerance"))
        form.layout().removeWidget(form.whereGroup)
        form.layout().insertWidget(1, form.whereGroup)
        form.nest.toggled.connect(self._show_sheet)
        self._show_sheet(form.nest.isChecked())
        form.folder.setText(_usual_folder(strips[0].Document))
        form.browse.clicked.connect(self.browse)
        cut = counted(strips)
        words = left_out + [message for obj in cut for message in later_feature_messages(obj)]
        words += [message for obj in cut if is_model(obj) for message in overlaps_of(obj)]
        words += pre_bend_messages_of(cuts)
        if find_spec("ezdxf") is None:
            words.append(
                translate(
                    "Elastica",
                    "DXF files are of version R12 here, curves as arcs: the library ezdxf is missing.",
                )
            )
            for name in ("version", "label_1_DXFversion"):
                getattr(form, name).hide()
        self.words = words
        self.watch("kerf", "curves", "version", "dxf")
        self.changed()

    def changed(self) -> None:
        """Show the messages on the parts, whether the kerf is compensated, and the sizes of the parts."""
        version = self._cutting().version
        curves = INEXACT if version == "R12" and self.value("dxf") else list(CURVES)
        self._offer(curves, self.value("curves"))
        chosen = {"curves": self.value("curves"), "version": version}
        self.form.tolerance.setEnabled("tolerance" not in idle_keys(Cutting, Table(chosen, "", {})))
        self.show_message("")

    def _offer(self, curves: list[str], chosen: str) -> None:
        put_choices(self.form.curves, curves)
        set_value(self.form.curves, chosen if chosen in curves else curves[0])

    def show_message(self, sentence: str) -> None:
        """Show a message above the messages on the parts and their sizes."""
        lines = [sentence, *self.words, *self._kerf_notes(), *map(_piece_line, self.pieces)]
        super().show_message(sentences(filter(None, lines), "\n"))

    def _cutting(self) -> Cutting:
        return cutting_of(
            kerf=self.value("kerf"),
            curves=self.value("curves"),
            tolerance=self.value("tolerance"),
            version=self.form.version.currentText(),
            marks=self.form.marks.isChecked(),
        )

    def _kerf_notes(self) -> list[str]:
        text = self._cutting().kerf_note([piece.sheet for piece in self.pieces], of_sheet=False)
        return [] if text is None else [text]

    def browse(self, *_: Any) -> None:
        """Let the user choose the folder."""
        title = translate("Elastica", "Folder for the files")
        folder = QtWidgets.QFileDialog.getExistingDirectory(Gui.getMainWindow(), title)
        if folder:
            self.form.folder.setText(folder)

    def _show_sheet(self, visible: bool) -> None:
        for name in ("sheetWidth", "label_5_Sheetwidth", "sheetHeight", "label_6_Sheetheight"):
            getattr(self.form, name).setVisible(visible)

    def finished(self) -> None:
        """Write the files."""
        kinds = [kind for kind in KINDS if getattr(self.form, kind).isChecked()]
        if not self.form.folder.text().strip():
            self.browse()
        if not self.form.folder.text().strip():
            raise InputError(translate("Elastica", "choose a folder for the files"))
        folder = Path(os.path.expanduser(self.form.folder.text().strip()))
        # refuse relative paths, because users do not know FreeCAD's working folder
        if not folder.is_absolute():
            raise InputError(translate("Elastica", "Enter the full path of the folder, or press Browse."))
        title, count = QT_TRANSLATE_NOOP("Elastica", "Writing files"), len(self.pieces) + len(self.strips)
        try:
            with progress(title, count) as go_on:
                self.written = write_cutting_files(
                    self.strips,
                    folder,
                    kinds=kinds,
                    sheet_size=(self.value("sheetWidth"), self.value("sheetHeight")),
                    cutting=self._cutting(),
                    force=self.form.force.isChecked(),
                    step=go_on,
                )
        except InputError as error:
            if error.refusal.kind != "exists":
                raise
            raise InputError(
                "{path} exists already. Choose another folder, or allow overwriting.",
                path=error.refusal.values["path"],
            ) from error
        preferences.put("ExportFolder", str(folder))
        if self.written:
            show_files(self.written, [*self._kerf_notes(), *pre_bend_messages_of(cuts_of(self.strips))])


def _usual_folder(document: Any) -> str:
    last = preferences.get("ExportFolder")
    if last and os.path.isdir(last):
        return str(last)
    return str(Path(document.FileName).parent) if document.FileName else ""


def _piece_line(piece: Piece) -> str:
    long, short = map(Length, piece.size)
    return note(
        "{count} x {piece}: {long:.5g} x {short:.5g}, {sheet}",
        count=piece.count, piece=piece.called, long=long, short=short, sheet=piece.sheet.name,
    )  # fmt: skip
