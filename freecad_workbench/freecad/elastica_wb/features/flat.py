# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The flat part of a strip as a parametric object, for assemblies, drawings and cutting."""

from collections.abc import Iterable, Iterator
from typing import Any

import FreeCAD as App
from freecad.elastica_wb.curves.part_shapes import is_bounded, make_face
from freecad.elastica_wb.features.model import shown_model
from freecad.elastica_wb.features.proxy import Feature, added
from freecad.elastica_wb.features.strip import shown_strip
from freecad.elastica_wb.features.strip_properties import style_of
from freecad.elastica_wb.host.objects import is_flat, is_model, is_strip
from freecad.elastica_wb.host.property_table import Property
from freecad.elastica_wb.host.resources import QT_TRANSLATE_NOOP, translate
from freecad.elastica_wb.solving.strip_cache import engraved_shape

from elastica_cad.errors import FieldName, InputError

# distance, mm, between the curve and the flat part
GAP_MM = 10.0

LAYERS = ["Base", "Backing"]

PART, OUTLINE = "Part::FeaturePython", "Part::Part2DObjectPython"
"""Types of flat parts: the body, and its outline as a plane face.

FreeCAD takes an object of the second type for a sketch, for example as the profile of a pocket.
"""

WORDS = {
    (PART, "Base"): QT_TRANSLATE_NOOP("Elastica", "flat"),
    (PART, "Backing"): QT_TRANSLATE_NOOP("Elastica", "backing"),
    (OUTLINE, "Base"): QT_TRANSLATE_NOOP("Elastica", "flat outline"),
    (OUTLINE, "Backing"): QT_TRANSLATE_NOOP("Elastica", "backing outline"),
}


class FlatFeature(Feature):
    """Proxy of the flat part. The user may place the part anywhere."""

    places = ()
    properties = (
        Property("LinkGlobal", "Strip", "Strip", "Strip of this flat part"),
        Property("Enumeration", "Layer", "Strip", "Layer of a laminated strip: base or backing", LAYERS),
        Property("LinkGlobal", "Model", "Strip", "Model whose slots the part gets; none for a single strip"),
    )

    def make(self, obj: Any) -> None:
        """Set the shape to the flat strip with its engraved text, or to the face inside its outline."""
        if obj.Strip is None or not is_strip(obj.Strip):
            raise InputError("The strip is missing. Choose a strip in {box}.", box=FieldName("Strip"))
        if obj.Model is None:
            strip = shown_strip(obj.Strip)
        elif is_model(obj.Model) and obj.Strip in obj.Model.Strips:
            strip = shown_model(obj.Model).strips[obj.Model.Strips.index(obj.Strip)]
        else:
            raise InputError(
                "{strip} does not belong to {model}. Choose the strip's model, or no model.",
                strip=obj.Strip.Label,
                model=obj.Model.Label,
            )
        layer = LAYERS.index(obj.Layer)
        if layer >= len(strip.layers):
            raise InputError(
                "{strip} is not laminated and has no backing. Choose the layer Base.", strip=obj.Strip.Label
            )
        if obj.TypeId == PART:
            obj.Shape = engraved_shape(strip, layer)
            return
        obj.Shape = make_face(strip.layers[layer].outline, strip.layers[layer].holes)
        obj.positionBySupport()


def create(document: Any, strip: Any, layer: str = "Base", type_id: str = PART) -> Any:
    """Make the flat part of a strip, or its outline, in front of the strip, without recomputing the document."""
    properties = {
        "Strip": strip,
        "Layer": layer,
        "Label": f"{strip.Label} {translate('Elastica', WORDS[type_id, layer])}",
        "Placement": _free_placement(strip),
    }
    obj = added(document, "Flat", FlatFeature, [strip], type_id=type_id, **properties)
    if App.GuiUp:
        obj.ViewObject.ShapeColor = strip.ViewObject.ShapeColor
    return obj


def layers_of(strip: Any) -> list[str]:
    """Return the names of the layers of a strip. Each layer is cut from its own sheet."""
    return LAYERS if style_of(strip) == "Laminated" else LAYERS[:1]


def missing_layers(strip: Any, type_id: str = PART) -> list[str]:
    """Return the layers of a strip that have no flat part, or no outline."""
    present = {part.Layer for part in flats_of([strip]) if part.TypeId == type_id}
    return [layer for layer in layers_of(strip) if layer not in present]


def _free_placement(strip: Any) -> App.Placement:
    source = strip.Curve[0] if strip.Curve else None
    width = max(strip.MaxWidth.Value, strip.OuterWidth.Value)
    if source is not None and not _box(source).isValid():
        # update the sketch, which may be outdated after an undo
        source.recompute()
    box = _box(source)
    if not is_bounded(box):
        return App.Placement(App.Vector(0, -GAP_MM - width, 0), App.Rotation())
    y = box.YMin - GAP_MM - width
    left, right = box.XMin - strip.StartTab.Value, box.XMin + source.Shape.Length + strip.EndTab.Value
    for other in sorted(_other_boxes(strip), key=lambda flat_box: -flat_box.YMax):
        if (
            other.XMin < right
            and left < other.XMax
            and y - width / 2 < other.YMax
            and other.YMin < y + width / 2
        ):
            y = other.YMin - GAP_MM - width / 2
    return App.Placement(App.Vector(box.XMin, y, 0), App.Rotation())


def _box(source: Any) -> App.BoundBox:
    return source.Shape.BoundBox if hasattr(source, "Shape") else App.BoundBox()


def _other_boxes(strip: Any) -> Iterator[App.BoundBox]:
    group = strip.getParentGeoFeatureGroup()
    for obj in strip.Document.Objects:
        is_flat_shape = is_flat(obj) or (is_strip(obj) and obj is not strip)
        if is_flat_shape and obj.getParentGeoFeatureGroup() is group and obj.Shape.BoundBox.isValid():
            yield obj.Shape.BoundBox


def flats_of(strips: Iterable[Any]) -> list[Any]:
    """Return the features of the flat parts of strips."""
    return [obj for strip in strips for obj in strip.InList if is_flat(obj) and obj.Strip is strip]
