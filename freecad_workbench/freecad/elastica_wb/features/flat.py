"""The flat twin of a strip: a body of its own for assemblies, drawings and cutting."""

from typing import Any

import FreeCAD as App
from freecad.elastica_wb.design import flat_shape
from freecad.elastica_wb.features.properties import Property, ensure
from freecad.elastica_wb.features.strip import is_strip, strip_of

from elastica_cad.errors import ElasticaError, InputError

__all__ = ["FlatFeature", "create", "is_flat"]

GAP = 10.0  # mm between the curve and the flat part

LAYERS = ["Base", "Backing"]

PROPERTIES = (
    Property("LinkGlobal", "Strip", "Strip", "The strip whose flat part this is"),
    Property(
        "Enumeration", "Layer", "Strip", "Of a laminated strip the base, or the backing glued on", LAYERS
    ),
)


class FlatFeature:
    """Proxy of the flat part; it may be placed anywhere."""

    def __init__(self, obj: Any) -> None:
        obj.Proxy = self
        ensure(obj, PROPERTIES)

    def onDocumentRestored(self, obj: Any) -> None:
        """Bring a file of an earlier version up to date."""
        ensure(obj, PROPERTIES)

    def execute(self, obj: Any) -> None:
        """Take the flat shape of the strip."""
        if obj.Strip is None or not is_strip(obj.Strip):
            raise ValueError("the strip is missing: choose one in the property Strip")
        try:
            strip = strip_of(obj.Strip)
            layer = LAYERS.index(obj.Layer)
            if layer >= len(strip.layers):
                raise InputError(
                    f"{obj.Strip.Label} is not laminated: it has no backing; choose the layer Base"
                )
            obj.Shape = flat_shape(strip, layer)
        except ElasticaError as error:
            raise ValueError(str(error)) from None

    def dumps(self) -> None:
        """Nothing to save."""

    def loads(self, state: Any) -> None:
        """Nothing to load."""

    __getstate__ = dumps
    __setstate__ = loads


def create(document: Any, strip: Any, layer: str = "Base") -> Any:
    """The flat part of a strip, lying in front of it; recompute the document to see it."""
    obj = document.addObject("Part::FeaturePython", "Flat")
    FlatFeature(obj)
    obj.Strip = strip
    obj.Layer = layer
    obj.Label = f"{strip.Label} {'flat' if layer == 'Base' else 'backing'}"
    obj.Placement = _beside(strip)
    group = strip.getParentGeoFeatureGroup()
    if group is not None and group.TypeId == "App::Part":
        group.addObject(obj)
    if App.GuiUp:
        from freecad.elastica_wb.features.views import FlatView

        FlatView(obj.ViewObject)
        obj.ViewObject.ShapeColor = strip.ViewObject.ShapeColor
    return obj


def _beside(strip: Any) -> App.Placement:
    """On the ground in front of the drawn curve."""
    box = strip.Curve[0].Shape.BoundBox
    if not box.isValid():  # a sketch that was not recomputed yet
        return App.Placement(App.Vector(0, -GAP - strip.MaxWidth.Value, 0), App.Rotation())
    return App.Placement(App.Vector(box.XMin, box.YMin - GAP - strip.MaxWidth.Value, 0), App.Rotation())


def is_flat(obj: Any) -> bool:
    """Is this object the flat part of a strip?"""
    return isinstance(getattr(obj, "Proxy", None), FlatFeature)
