"""The panel of the export: which files, how written, where to."""

from importlib.util import find_spec
from pathlib import Path
from typing import Any

from freecad.elastica_wb import preferences
from freecad.elastica_wb.cutting import KINDS, pieces_of, write_cutting_files
from freecad.elastica_wb.panels.base import Panel, progress
from freecad.elastica_wb.panels.files import ask_folder
from freecad.elastica_wb.text import tr

from elastica_cad.errors import InputError
from elastica_cad.fabrication.pieces import Piece
from elastica_cad.formats import CURVES, DXF_VERSIONS

__all__ = ["ExportPanel"]

BY_HAND = "(--force, or force=True)"  # how those who type allow files to be overwritten


class ExportPanel(Panel):
    """OK writes the files; the document stays as it is."""

    file = "export"
    icon_name = "Elastica_Export"

    def __init__(self, strips: list[Any]) -> None:
        self.pieces = pieces_of(strips)
        super().__init__(subjects=strips)
        self.strips = strips
        self.written: list[Path] = []
        form = self.form
        form.version.addItems(list(DXF_VERSIONS))
        form.version.setCurrentText(preferences.get("DxfVersion"))
        form.curves.addItems(list(CURVES))
        form.curves.setCurrentText(preferences.get("Curves"))
        form.kerf.setValue(preferences.get("Kerf"))
        form.tolerance.setValue(preferences.get("Tolerance"))
        form.dxf.setChecked(find_spec("ezdxf") is not None)
        saved = Path(strips[0].Document.FileName).parent if strips[0].Document.FileName else Path.home()
        form.folder.setText(str(saved))
        form.browse.clicked.connect(self.browse)
        form.dxf.clicked.connect(self.need_ezdxf)
        self.tell("\n".join(map(_listed, self.pieces)))

    def browse(self, *_: Any) -> None:
        """Choose the folder."""
        folder = ask_folder(tr("Folder for the files"))
        if folder:
            self.form.folder.setText(folder)

    def need_ezdxf(self, wanted: bool) -> None:
        """DXF needs a library that FreeCAD does not bring."""
        if wanted and find_spec("ezdxf") is None:
            from freecad.elastica_wb.commands.libraries import offer

            self.form.dxf.setChecked(offer(["ezdxf"]))

    def finished(self) -> None:
        """Write the files."""
        try:
            self._write()
        except InputError as error:
            raise InputError(str(error).replace(BY_HAND, tr("tick the box for it"))) from error

    def _write(self) -> None:
        kinds = [kind for kind in KINDS if getattr(self.form, kind).isChecked()]
        if not self.form.folder.text().strip():
            raise InputError(tr("choose a folder for the files"))
        with progress(tr("Writing files"), len(self.pieces) + len(self.strips)) as go_on:
            self.written = write_cutting_files(
                self.strips,
                self.form.folder.text(),
                kinds=kinds,
                sheet_size=(self.form.sheetWidth.value(), self.form.sheetHeight.value()),
                kerf=self.form.kerf.value(),
                curves=self.form.curves.currentText(),
                tolerance=self.form.tolerance.value(),
                version=self.form.version.currentText(),
                force=self.form.force.isChecked(),
                step=go_on,
            )


def _listed(piece: Piece) -> str:
    """A line of the cut list."""
    return f"{piece.count} x {piece.name}: {piece.size[0]:.5g} x {piece.size[1]:.5g} mm, {piece.sheet.name}"
