# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The panel of the sheet library: built-in sheets with the sources of their data, and the user's sheets."""

from dataclasses import replace
from typing import Any

from freecad.elastica_wb.features.proxy import keep_sheets
from freecad.elastica_wb.host.fields import put_sheets, set_value
from freecad.elastica_wb.host.resources import translate
from freecad.elastica_wb.host.sheet_store import own_sheets, save_own_sheets, sheet_called, sheet_list
from freecad.elastica_wb.panels.panel import Panel

from elastica_cad.errors import Length, note
from elastica_cad.mechanics.sheets import Sheet

NUMBERS = ("thickness", "youngs_modulus", "density", "max_strain", "kerf", "poisson_ratio", "shear_modulus")


class SheetsPanel(Panel):
    """Panel that shows a sheet. Save stores a changed sheet under the typed name, as one of the user's sheets."""

    file = "sheets"
    icon_name = "Elastica_Sheets"
    done = "Save"

    def __init__(self) -> None:
        super().__init__()
        self.own = own_sheets()
        self.before = dict(self.own)
        self.seen = sheet_called(sheet_list()[0])
        self._list()
        self.form.sheets.currentIndexChanged.connect(self.shown)
        self.form.remove.clicked.connect(self.remove)
        self.shown()

    def shown(self, *_: Any) -> None:
        """Show the data of the selected sheet."""
        name = self.value("sheets")
        self.seen = sheet = self.own.get(name) or sheet_called(name)
        self.form.name.setText(name)
        self.form.source.setPlainText(sheet.source)
        for field in NUMBERS:
            set_value(getattr(self.form, field), getattr(sheet, field) or 0.0)
        self.filled = {field: self.value(field) for field in NUMBERS}
        self.show_message(note(
            "{radius_name} {radius}, {length_name} {length}",
            radius_name=translate("Elastica", "least radius"), radius=Length(sheet.least_radius),
            length_name=translate("Elastica", "elasto-gravity length"),
            length=Length(sheet.elasto_gravity_length),
        ))  # fmt: skip

    def remove(self, *_: Any) -> None:
        """Remove the selected sheet, which must be one of the user's sheets."""
        if self.own.pop(self.value("sheets"), None) is None:
            self.show_message(translate("Elastica", "Built-in sheets stay: keep yours under another name."))
            return
        self._list()
        self.shown()

    def sheet(self) -> Sheet:
        """Return the sheet that the widgets define."""
        # read only changed numbers, because widgets round numbers
        typed = {field: self.value(field) for field in NUMBERS if self.value(field) != self.filled[field]}
        # remove the range of values of a typed number
        ranges = {f"{field}_range": None for field in typed if hasattr(self.seen, f"{field}_range")}
        name, source = self.form.name.text().strip(), " ".join(self.form.source.toPlainText().split())
        # an empty field has the value 0 and means that the modulus is estimated
        if typed.get("shear_modulus") == 0:
            typed["shear_modulus"] = None
        return replace(self.seen, name=name, source=source, **typed, **ranges)

    def finished(self) -> None:
        """Write the user's sheets, including the changed sheet."""
        sheet = self.sheet()
        if sheet != self.seen:
            self.own[sheet.name] = sheet
        changed = {name: sheet for name, sheet in self.own.items() if self.before.get(name) != sheet}
        removed = self.before.keys() - self.own.keys()
        if changed or removed:
            # read the file again, because another window may have saved sheets
            now = own_sheets() | changed
            save_own_sheets(sheet for name, sheet in now.items() if name not in removed)
            keep_sheets()

    def _list(self) -> None:
        names = list(self.own) + [n for n in sheet_list() if n not in self.own and n not in self.before]
        put_sheets(self.form.sheets, names)
        set_value(self.form.sheets, names[0])
