# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The panel for making holders: printed blocks, a slotted plate, and rings."""

from typing import Any

from freecad.elastica_wb.features import baseplate, fixtures
from freecad.elastica_wb.host import preferences
from freecad.elastica_wb.host.fields import put_sheets, set_value
from freecad.elastica_wb.host.objects import is_plate
from freecad.elastica_wb.host.refusal import why_not_made
from freecad.elastica_wb.host.resources import translate
from freecad.elastica_wb.host.sheet_store import default_sheet, sheet_list
from freecad.elastica_wb.panels.panel import Panel
from freecad.elastica_wb.recording import record_call, record_value, recorded

from elastica_cad.errors import InputError


class FixturesPanel(Panel):
    """Panel that makes the ticked kinds of holders, in one undo step."""

    file = "fixtures"
    icon_name = "Elastica_Fixtures"
    step = "End fixtures and base plate"

    def __init__(self, sources: list[Any]) -> None:
        """Open the panel for `sources`. If all sources are base plates, use the strips on these plates."""
        super().__init__(sources[0].Document, sources)
        strips = [source for obj in sources if is_plate(obj) for source in obj.Sources]
        self.sources = [obj for obj in sources if not is_plate(obj)] or list(dict.fromkeys(strips))
        for box in (self.form.sheet, self.form.ringSheet):
            put_sheets(box, sheet_list())
            set_value(box, default_sheet())
        set_value(self.form.slot, preferences.get("Clearance"))

    def finished(self) -> None:
        """Make the holders. If this fails, the panel stays open."""
        form = self.form
        if not any(box.isChecked() for box in (form.plate, form.rings, form.blocks)):
            raise InputError(translate("Elastica", "Select blocks, a plate or rings."))
        holders = []
        # make the plate first, because it is faster than the blocks and may raise an error
        if form.plate.isChecked():
            holders.append(recorded(baseplate.create, self.document, self.sources))
            record_value(holders[-1], "Sheet", self.value("sheet"))
            record_value(holders[-1], "Placement.Base.z", self.value("plateHeight"))
            for name, field in (("Play", "play"), ("Clearance", "slot"), ("Border", "border")):
                record_value(holders[-1], name, self.value(field))
            self._make(holders)
        if form.rings.isChecked():
            holders.append(recorded(baseplate.create_rings, self.document, self.sources))
            record_value(holders[-1], "Sheet", self.value("ringSheet"))
            record_value(holders[-1], "Gap", self.value("gap"))
            self._make(holders)
        if form.blocks.isChecked():
            holders.append(recorded(fixtures.create, self.document, self.sources))
            for name in ("Clearance", "Wall", "Foot", "Screw"):
                record_value(holders[-1], name, self.value(name.lower()))
            self._make(holders)

    def _make(self, features: list[Any]) -> None:
        self.document.recompute()
        failed = list(dict.fromkeys(filter(None, map(why_not_made, features))))
        if failed:
            for obj in features:
                record_call(self.document, "removeObject", obj.Name)
            raise InputError("; ".join(failed))
