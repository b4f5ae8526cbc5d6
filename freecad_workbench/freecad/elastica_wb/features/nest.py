# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The nest as a parametric object: all pieces of a document, arranged on sheets."""

from typing import Any

import FreeCAD as App
import Part
from freecad.elastica_wb.curves.part_shapes import make_wire
from freecad.elastica_wb.curves.sketch_curves import boxes_of
from freecad.elastica_wb.features.pieces import counted, cuts_of, later_features, pre_bend_messages_of
from freecad.elastica_wb.features.proxy import REPORTS, Feature, added
from freecad.elastica_wb.host.property_table import Property, put, result
from freecad.elastica_wb.host.refusal import FAILURES
from freecad.elastica_wb.host.words import report_warning, worded

from elastica_cad.errors import note, sentences
from elastica_cad.model.nesting import nest_pieces

# distance in y, mm, of a nest of cut parts from the other objects
SPACE_MM = 50.0
SHEET_GAP_MM = 30.0


class NestFeature(Feature):
    """The outlines of all cuts on sheets side by side."""

    places = ()
    properties = (
        Property("LinkListGlobal", "Sources", "Nest", "Strips, models and base plates to be cut"),
        Property("Length", "SheetWidth", "Nest", "Width of a sheet, along its grain", 600.0),
        Property("Length", "SheetHeight", "Nest", "Height of a sheet", 400.0),
        Property("Length", "Margin", "Nest", "Smallest distance between parts, and from the edge", 2.0),
        result("Integer", "Sheets", "Number of sheets"),
        REPORTS,
        result("StringList", "LeftOut", "Later features that the cut parts do not contain"),
    )

    def make(self, obj: Any) -> None:
        """Arrange the pieces on sheets."""
        size = (obj.SheetWidth.Value, obj.SheetHeight.Value)
        cuts = cuts_of(obj.Sources)
        sheets = nest_pieces([cut.piece for cut in cuts], sheet_size=size, margin=obj.Margin.Value)
        wires = []
        for i, sheet in enumerate(sheets):
            outlines = [make_wire(item.path) for item in sheet.paths]
            for wire in outlines:
                wire.translate(App.Vector(i * (size[0] + SHEET_GAP_MM), 0, 0))
            wires += outlines
        obj.Shape = Part.Compound(wires)
        put(obj, Sheets=len(sheets), Reports=pre_bend_messages_of(cuts))
        report_left_out(obj)


def report_left_out(obj: Any) -> None:
    """Report later features that change the nested pieces and are not in the nest."""
    try:
        later_by_label = {original.Label: later_features(original) for original in counted(obj.Sources)}
    except FAILURES:  # the recompute has reported the error
        return
    messages = [
        note(
            "The nest shows {strip} without {later}, a later feature of its body. Use the slots, tabs and "
            "holes of the strip instead, or draw the change in the cutting files.",
            strip=label,
            later=later,
        )
        for label, later in later_by_label.items()
        if later
    ]
    if messages and obj.LeftOut != [worded(message) for message in messages]:
        report_warning(sentences(messages, " "), obj.Label)
    put(obj, LeftOut=messages)


def create(document: Any, sources: list[Any]) -> Any:
    """Make a nest in front of all objects, without recomputing the document."""
    lowest = min((box.YMin for box in boxes_of(document.Objects)), default=0.0)
    obj = added(document, "Nest", NestFeature, Sources=sources)
    obj.Placement.Base.y = lowest - obj.SheetHeight.Value - SPACE_MM
    return obj
