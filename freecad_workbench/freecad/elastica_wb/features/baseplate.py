# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Slotted plates as parametric objects: a base plate for the tabs of all strips, or a ring at each end."""

from typing import Any, ClassVar

import Part
from freecad.elastica_wb.curves.part_shapes import make_solid
from freecad.elastica_wb.curves.sketch_curves import container, frame_of
from freecad.elastica_wb.features.fixtures import report_holders, source_model
from freecad.elastica_wb.features.proxy import CONTAINERS, REPORTS, Feature, added
from freecad.elastica_wb.host.objects import feature_kind
from freecad.elastica_wb.host.property_table import NOTHING, Property, declared_property, values_of
from freecad.elastica_wb.host.sheet_store import sheet_called

from elastica_cad.declared import Field, declared
from elastica_cad.geometry.frame import Frame
from elastica_cad.model.frames import Rib
from elastica_cad.model.plate_holes import PlateHoles
from elastica_cad.model.plate_pairs import end_plates
from elastica_cad.model.plates import BasePlate, PlateOptions, RingOptions
from elastica_cad.model.spacers import add_spacers
from elastica_cad.strip.outline import ENDS
from elastica_cad.strip.solids import FlatSolid

NAMES = {"play": "Play", "clearance": "Clearance", "border": "Border", "shape": "Outline"}
HELD_ENDS = ["both", "start", "end"]


def _sizes(options: type[PlateOptions]) -> dict[str, Field]:
    return {NAMES[option.name]: option for option in declared(options) if option.name in NAMES}


SIZES, RING_SIZES = _sizes(PlateOptions), _sizes(RingOptions)


HOLE_SIZES = {field.name.title(): field for field in declared(PlateHoles)}
PLATE_HOLE_SIZES = {name: field for name, field in HOLE_SIZES.items() if name not in ("Bridge", "Side")}


class BasePlateFeature(Feature):
    """A base plate. Its upper face is in the xy plane of the placement."""

    places = (CONTAINERS,)
    properties = (
        Property(
            "LinkListGlobal", "Sources", "Base plate", "Model or strips whose tabs go through the plate"
        ),
        Property("Enumeration", "Sheet", "Base plate", "Sheet of the plate"),
        Property("String", "SheetData", "Base plate", "Data of the sheet", hidden=True),
        *(declared_property(field, "Base plate", name) for name, field in SIZES.items()),
        *(declared_property(field, "Holes", name) for name, field in PLATE_HOLE_SIZES.items()),
        REPORTS,
    )

    sheets: ClassVar = {"Sheet": "SheetData"}

    def make(self, obj: Any) -> None:
        """Set the shape to the plate with its slots."""
        (plate,) = plates_of(obj)
        solid = plate.solid
        lowered = Frame().shifted(z=-solid.thickness)
        obj.Shape = make_solid(FlatSolid(solid.outline, solid.holes, solid.thickness, lowered))
        report_holders(obj, source_model(obj.Sources), [plate])


class RingsFeature(Feature):
    """A ring for the tabs at each end of the strips.

    A pair of rings at each end also fixes the angle of inclined tabs.
    """

    places = (CONTAINERS,)
    properties = (
        Property("LinkListGlobal", "Sources", "Rings", "Model or strips whose tabs go through the rings"),
        Property("Enumeration", "Sheet", "Rings", "Sheet of the rings"),
        Property("String", "SheetData", "Rings", "Data of the sheet", hidden=True),
        Property("Enumeration", "Ends", "Rings", "Ends of the strips that have a ring", HELD_ENDS),
        Property(
            "Length",
            "Gap",
            "Rings",
            "Distance between two rings that hold inclined tabs at their angle; 0 for one ring at each end",
        ),
        declared_property(declared(add_spacers)[0], "Rings", "Spacers"),
        *(declared_property(field, "Rings", name) for name, field in RING_SIZES.items()),
        *(declared_property(field, "Holes", name) for name, field in HOLE_SIZES.items()),
        REPORTS,
    )

    sheets: ClassVar = {"Sheet": "SheetData"}

    def make(self, obj: Any) -> None:
        """Set the shape to the rings, each in its position."""
        rings = plates_of(obj)
        shape = Part.Compound([make_solid(ring.solid) for ring in rings])
        shape.Placement = container(obj).inverse()
        obj.Shape = shape
        report_holders(obj, source_model(obj.Sources), rings)


def create(document: Any, sources: list[Any]) -> Any:
    """Make a base plate for a model or for strips, without recomputing the document."""
    return added(document, "BasePlate", BasePlateFeature, sources, Sources=sources)


def create_rings(document: Any, sources: list[Any]) -> Any:
    """Make rings for the ends of a model or of strips, without recomputing the document."""
    return added(document, "Rings", RingsFeature, sources, Sources=sources)


def plates_of(obj: Any) -> tuple[BasePlate | Rib, ...]:
    """Return the records of the plates that a base plate or rings show, and of their spacers."""
    model, sheet = source_model(obj.Sources), sheet_called(obj.Sheet, obj.SheetData)
    if feature_kind(obj) == "Rings":
        ends = ENDS if obj.Ends == HELD_ENDS[0] else (obj.Ends,)
        options = {**values_of(obj, RING_SIZES), "holes": _holes(obj, HOLE_SIZES), "name": obj.Label}
        plates = end_plates(model.placed, sheet, gap=obj.Gap.Value or None, ends=ends, **options)
        if not obj.Spacers:
            return plates
        plates, spacers = add_spacers(model.placed, plates, obj.Spacers)
        return (*plates, *spacers)
    options = {**values_of(obj, SIZES), "holes": _holes(obj, PLATE_HOLE_SIZES), "name": obj.Label}
    return (model.base_plate(sheet, frame=frame_of(obj.getGlobalPlacement()), **options),)


def _holes(obj: Any, sizes: dict[str, Field]) -> PlateHoles | None:
    values = values_of(obj, sizes)
    if not values["bulb"] and not values["screws"]:
        return None
    side = values.get("side", NOTHING)
    return PlateHoles(**{**values, "side": None if side == NOTHING else side})
