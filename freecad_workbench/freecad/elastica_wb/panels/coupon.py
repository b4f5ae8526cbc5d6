# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The panel of the coupon, a test strip from whose droop the stiffness of the sheet is computed."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
from freecad.elastica_wb.curves.part_shapes import make_solid
from freecad.elastica_wb.cutting_files import cutting_of
from freecad.elastica_wb.features.proxy import keep_sheets
from freecad.elastica_wb.host import preferences
from freecad.elastica_wb.host.fields import put_sheets, set_value
from freecad.elastica_wb.host.qt import QtWidgets
from freecad.elastica_wb.host.resources import translate
from freecad.elastica_wb.host.sheet_store import (
    default_sheet,
    own_sheets,
    save_own_sheets,
    sheet_called,
    sheet_list,
)
from freecad.elastica_wb.host.words import decimal_point
from freecad.elastica_wb.panels.panel import Panel
from freecad.elastica_wb.recording import recorded

from elastica_cad._text import file_word
from elastica_cad.errors import InputError, Length, note, sentences
from elastica_cad.files import save
from elastica_cad.mechanics.calibration import Calibration, calibrate_cantilever
from elastica_cad.strip.coupon import coupon_drawing, coupon_overhang
from elastica_cad.strip.drawing import CUT_OUTER
from elastica_cad.strip.solids import FlatSolid


class CouponPanel(Panel):
    """Panel that makes the test strip, takes the measured sag of its free end, and saves the calibrated sheet."""

    file = "coupon"
    icon_name = "Elastica_Coupon"
    step = "Coupon and calibrate"

    def __init__(self) -> None:
        super().__init__(App.ActiveDocument)
        self.calibration: Calibration | None = None
        put_sheets(self.form.sheet, sheet_list())
        set_value(self.form.sheet, default_sheet())
        self.watch("sheet", "readings", "error")
        for button in (self.make, self.write, self.keep):
            getattr(self.form, button.__name__).clicked.connect(partial(self._pressed, button))
        self.changed()

    def changed(self) -> None:
        """Show the longest overhang of the coupon, and the stiffness that follows from the readings."""
        sheet = sheet_called(self.value("sheet"))
        longest = Length(coupon_overhang(sheet))
        words: list[str] = [note("Longest overhang of the coupon: {longest:g}", longest=longest)]
        self.calibration = None
        if self.form.readings.text().strip():
            overhangs, droops = readings_of(self.form.readings.text())
            self.calibration = calibrate_cantilever(
                overhangs,
                droops,
                thickness=sheet.thickness,
                density=sheet.density,
                reading_error=self.value("error"),
            )
            words.append(str(self.calibration))
        self.show_message(sentences(words, "\n"))

    def _pressed(self, button: Callable[[], None], *_: Any) -> None:
        with self.telling():
            button()

    def make(self) -> None:
        """Make the coupon as a flat body."""
        recorded(add_coupon, self.document, self.value("sheet"))

    def write(self) -> None:
        """Write the cutting file of the coupon."""
        sheet = sheet_called(self.value("sheet"))
        cutting = cutting_of(
            kerf=preferences.get("Kerf"),
            curves=preferences.get("Curves"),
            tolerance=preferences.get("Tolerance"),
            version=preferences.get("DxfVersion"),
        )
        drawing = coupon_drawing(sheet)
        usual = cutting.file_name(file_word(drawing.name), "dxf")
        title, kinds = translate("Elastica", "Save the coupon"), "DXF (*.dxf);;SVG (*.svg)"
        path, _ = QtWidgets.QFileDialog.getSaveFileName(Gui.getMainWindow(), title, usual, kinds)
        if path:
            written = save(replace(drawing, name=Path(path).stem), path, force=True, **cutting.options(sheet))
            self.show_message(f"{translate('Elastica', 'wrote')} {written}")

    def keep(self) -> None:
        """Save the calibrated sheet as one of the user's sheets."""
        if self.calibration is None:
            raise InputError(
                translate(
                    "Elastica",
                    "type the readings first: overhang = droop, in mm, such as 120 = 14.5; 150 = 31",
                )
            )
        base = sheet_called(self.value("sheet"))
        name = self.form.name.text().strip() or f"{base.name}-measured"
        sheet = self.calibration.sheet(
            name,
            max_strain=base.max_strain,
            kerf=base.kerf,
            shear_modulus=base.shear_modulus,
            grain=base.grain,
            kind=base.kind,
        )
        save_own_sheets((own_sheets() | {name: sheet}).values())
        keep_sheets()
        self.show_message(f"{translate('Elastica', 'kept as')} {name}")


def add_coupon(document: Any, sheet_name: str) -> Any:
    """Add the coupon of a sheet to the document, as a flat body."""
    sheet = sheet_called(sheet_name)
    drawing = coupon_drawing(sheet)
    (outline,) = drawing.on(CUT_OUTER)
    body = document.addObject("Part::Feature", "Coupon")
    body.Label = drawing.name
    body.Shape = make_solid(FlatSolid(outline, (), sheet.thickness))
    return body


def readings_of(text: str) -> tuple[list[float], list[float]]:
    """Return overhangs and droops from a text such as "120 = 14.5; 150 = 31"."""
    pairs = []
    # True if commas in the text are decimal separators
    commas = ";" in text or decimal_point() == ","
    for part in text.split(";" if commas else ","):
        try:
            overhang, droop = (float(number.replace(",", ".")) for number in part.split("="))
        except ValueError as error:
            raise InputError(
                "{reading!r} is not a pair of measurements. Write overhang = droop in mm, such as "
                "120 = 14.5; 150 = 31.",
                reading=part.strip(),
            ) from error
        pairs.append((overhang, droop))
    return [o for o, _ in pairs], [d for _, d in pairs]
