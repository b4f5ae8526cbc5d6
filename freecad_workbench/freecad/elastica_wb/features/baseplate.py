# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The base plate as a parametric object: one slotted plate for the tabs of all strips."""

from typing import Any, ClassVar

from freecad.elastica_wb.curves.part_shapes import make_solid
from freecad.elastica_wb.curves.sketch_curves import frame_of
from freecad.elastica_wb.features.fixtures import show_plays, source_model
from freecad.elastica_wb.features.proxy import CONTAINERS, REPORTS, Feature, added
from freecad.elastica_wb.host.property_table import Property, declared_property, values_of
from freecad.elastica_wb.host.sheet_store import sheet_called

from elastica_cad.declared import declared
from elastica_cad.geometry.frame import Frame
from elastica_cad.model.plates import BasePlate, PlateOptions
from elastica_cad.strip.solids import FlatSolid

NAMES = {"play": "Play", "clearance": "Clearance", "border": "Border", "shape": "Outline"}
SIZES = {NAMES[option.name]: option for option in declared(PlateOptions) if option.name in NAMES}
"""Options of a plate, by its properties."""


class BasePlateFeature(Feature):
    """A base plate. The plane z = 0 of its placement is its upper face."""

    properties = (
        Property(
            "LinkListGlobal", "Sources", "Base plate", "Model or strips whose tabs go through the plate"
        ),
        Property("Enumeration", "Sheet", "Base plate", "Sheet of the plate"),
        Property("String", "SheetData", "Base plate", "Data of the sheet", hidden=True),
        *(declared_property(field, "Base plate", name) for name, field in SIZES.items()),
        REPORTS,
        CONTAINERS,
    )

    sheets: ClassVar = {"Sheet": "SheetData"}

    def make(self, obj: Any) -> None:
        """Make the plate with its slots."""
        plate = plate_of(obj)
        solid = plate.solid
        lowered = Frame().shifted(z=-solid.thickness)
        obj.Shape = make_solid(FlatSolid(solid.outline, solid.holes, solid.thickness, lowered))
        show_plays(obj, source_model(obj.Sources), [plate])


def create(document: Any, sources: list[Any]) -> Any:
    """Make a base plate for a model or for strips; recompute the document to see it."""
    return added(document, "BasePlate", BasePlateFeature, sources, Sources=sources)


def plate_of(obj: Any) -> BasePlate:
    """Return the `BasePlate` record that a base plate feature shows."""
    return source_model(obj.Sources).base_plate(
        sheet_called(obj.Sheet, obj.SheetData),
        frame=frame_of(obj.getGlobalPlacement()),
        **values_of(obj, SIZES),
        name=obj.Label,
    )
