# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The panel for making holders: printed blocks, a slotted plate, and rings."""

from typing import Any

from freecad.elastica_wb.features import baseplate, fixtures
from freecad.elastica_wb.host import preferences
from freecad.elastica_wb.host.fields import bind, put_away, put_sheets, set_value
from freecad.elastica_wb.host.objects import is_plate
from freecad.elastica_wb.host.refusal import why_not_made
from freecad.elastica_wb.host.resources import translate
from freecad.elastica_wb.host.sheet_store import default_sheet, sheet_list
from freecad.elastica_wb.panels.panel import Panel
from freecad.elastica_wb.recording import record_call, record_value, recorded

from elastica_cad.errors import InputError

HOLDERS = {
    # the plate is made first, because it is faster than the blocks and may raise an error
    "plate": (
        baseplate.create,
        {
            "Sheet": "sheet",
            "Placement.Base.z": "plateHeight",
            "Play": "play",
            "Clearance": "slot",
            "Border": "border",
        },
    ),
    "rings": (baseplate.create_rings, {"Sheet": "ringSheet", "Gap": "gap"}),
    "blocks": (fixtures.create, {name: name.lower() for name in ("Clearance", "Wall", "Foot", "Screw")}),
}
"""Function that makes each kind of holder, and the names of its boxes by the properties that they set."""


class FixturesPanel(Panel):
    """Panel that makes the ticked kinds of holders, in one undo step. The boxes take FreeCAD's formulas."""

    file = "fixtures"
    icon_name = "Elastica_Fixtures"
    step = "End fixtures and base plate"

    def __init__(self, sources: list[Any]) -> None:
        """Open the panel for `sources`. If all sources are base plates, use the strips on these plates."""
        super().__init__(sources[0].Document, sources)
        strips = [source for obj in sources if is_plate(obj) for source in obj.Sources]
        self.sources = [obj for obj in sources if not is_plate(obj)] or list(dict.fromkeys(strips))
        self.holders: dict[str, Any] = {}
        for box in (self.form.sheet, self.form.ringSheet):
            put_sheets(box, sheet_list())
            set_value(box, default_sheet())
        set_value(self.form.slot, preferences.get("Clearance"))
        for kind in HOLDERS:
            getattr(self.form, kind).toggled.connect(self._begin)
        self._begin()

    def finished(self) -> None:
        """Make the holders. If this fails, the panel stays open."""
        chosen = self._chosen()
        if not chosen:
            raise InputError(translate("Elastica", "Select blocks, a plate or rings."))
        for kind in [kind for kind in self.holders if kind not in chosen]:
            record_call(self.document, "removeObject", self.holders.pop(kind).Name)
        for kind in chosen:
            obj, (_, boxes) = self.holders[kind], HOLDERS[kind]
            formulas = {path.lstrip(".") for path, _ in obj.ExpressionEngine}
            for name in [name for name in boxes if name not in formulas]:
                record_value(obj, name, self.value(boxes[name]))
            obj.recompute()  # not the blocks before the plate is accepted
            failed = why_not_made(obj)
            if failed:
                raise InputError(failed)

    def let_go(self) -> None:
        """Delete the boxes, because their formulas refer to features of the document."""
        for _, boxes in HOLDERS.values():
            for box in boxes.values():
                put_away(getattr(self.form, box))

    def _chosen(self) -> list[str]:
        return [kind for kind in HOLDERS if self.value(kind)]

    def _begin(self, *_: Any) -> None:
        """Make the ticked features without their shapes, so that formulas of the boxes have properties."""
        with self.telling():
            self._all_there()
            for kind in [kind for kind in self._chosen() if kind not in self.holders]:
                make, boxes = HOLDERS[kind]
                self.holders[kind] = recorded(make, self.document, self.sources)
                for name, box in boxes.items():
                    bind(getattr(self.form, box), self.holders[kind], name)
