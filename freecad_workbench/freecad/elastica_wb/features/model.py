# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The model as a parametric object: several strips at their positions, with slots where they cross."""

from collections.abc import Iterator
from concurrent.futures import Future
from typing import Any
from weakref import WeakKeyDictionary

import FreeCAD as App
import numpy as np
import Part
from freecad.elastica_wb.curves.copies import turned_over
from freecad.elastica_wb.curves.sketch_curves import container, drawn_curve, frame_of, placement_of
from freecad.elastica_wb.features.proxy import REPORTS, Feature, added
from freecad.elastica_wb.features.strip import shown_strip, shown_strips, strip_of
from freecad.elastica_wb.host import preferences
from freecad.elastica_wb.host.objects import is_model, is_strip
from freecad.elastica_wb.host.progress import begun, in_background
from freecad.elastica_wb.host.property_table import Property, declared_property, put, result, values_of
from freecad.elastica_wb.host.refusal import FAILURES
from freecad.elastica_wb.host.resources import QT_TRANSLATE_NOOP
from freecad.elastica_wb.host.words import report_warning, worded
from freecad.elastica_wb.solving.strip_cache import bent_shape, remembered
from freecad.elastica_wb.solving.verdicts import pre_bend_messages

from elastica_cad.declared import declared
from elastica_cad.errors import ElasticaError, FieldName, InputError, one_of_each
from elastica_cad.model.collisions import missing_slots
from elastica_cad.model.interlocking import interlock
from elastica_cad.model.model import Model
from elastica_cad.strip.strip import Placed, Strip

_overlaps: WeakKeyDictionary[Model, "Future[tuple[str, ...]]"] = WeakKeyDictionary()


_shown: WeakKeyDictionary[Feature, tuple[Part.Shape, App.Placement, Model]] = WeakKeyDictionary()
"""Displayed shape, placement of its container, and model of each feature."""


SLOTS = {option.name.title(): option for option in declared(interlock) if option.name != "above"}
"""Options of slots, by the names of their properties. The zero vector means that a direction is not set."""


class ModelFeature(Feature):
    """Bent strips with their slots, in a single compound."""

    properties = (
        Property("LinkListGlobal", "Strips", "Model", "The strips, in the order of assembly"),
        Property("Bool", "Interlock", "Model", "Cut slots where strips cross", True),
        *(declared_property(field, "Model", name) for name, field in SLOTS.items()),
        Property(
            "Vector",
            "Above",
            "Model",
            "Direction from which later strips are pushed on; zero for any direction",
            App.Vector(),
        ),
        result("Integer", "Joints", "Number of joints of two slots"),
        REPORTS,
        result(
            "StringList",
            "Overlaps",
            "Collisions of strips outside their slots, known a moment after the other results",
        ),
    )

    def make(self, obj: Any) -> None:
        """Set the shape to all strips in their positions, with slots."""
        model = model_of(obj, as_displayed=True)
        shape = Part.Compound(solids_of(model, container(obj).inverse()))
        obj.Shape = shape
        _shown[self] = shape, container(obj), model
        overlaps = _overlaps.get(model)
        named_strips = ((model.name_of(i), strip) for i, strip in enumerate(model.strips))
        put(
            obj,
            Joints=len(model.joints),
            Reports=[*pre_bend_messages(named_strips), *one_of_each(model.reports)],
            Overlaps=list(overlaps.result()) if overlaps is not None and overlaps.done() else [],
        )

    def show_error(self, obj: Any, error: ElasticaError) -> None:
        """Replace the results by the error."""
        put(obj, Joints=0, Reports=[str(error)], Overlaps=[])

    def covered(self, obj: Any) -> list[Any]:
        """Return the strips, which are hidden because the model displays them with slots."""
        return [strip for strip in obj.Strips if is_strip(strip)]


def create(document: Any, strips: list[Any], *, interlock: bool = True) -> Any:
    """Make a model of strips, without recomputing the document."""
    clearance = preferences.get("Clearance")
    obj = added(
        document, "Model", ModelFeature, strips, Strips=strips, Interlock=interlock, Clearance=clearance
    )
    if App.GuiUp and strips:
        obj.ViewObject.ShapeColor = strips[0].ViewObject.ShapeColor
    return obj


def shown_model(obj: Any) -> Model:
    """Return the model from which the current shape was made. If the model is unknown, compute it."""
    shape, place, model = _shown.get(obj.Proxy, (None, None, None))
    return model if model and obj.Shape.isPartner(shape) and container(obj) == place else model_of(obj)


def model_of(obj: Any, *, as_displayed: bool = False) -> Model:
    """Return the `Model` record of a model feature. For `as_displayed`, see `strips_model`."""
    other = next((strip for strip in obj.Strips if not is_strip(strip)), None)
    if other is not None:
        raise InputError("{object} is not a strip. Choose strips for the model.", object=other.Label)
    options: tuple[tuple[str, Any], ...] = ()
    if obj.Interlock:
        above = tuple(obj.Above) if obj.Above.Length > 0 else None
        options = (*values_of(obj, SLOTS).items(), ("above", above))
    return strips_model(obj.Strips, name=obj.Label, options=options, as_displayed=as_displayed)


def overlaps_of(obj: Any) -> list[str]:
    """Return a message for each pair of strips in a model that intersect without a slot."""
    looking = QT_TRANSLATE_NOOP("Elastica", "Looking for strips that meet")
    return list(map(worded, in_background(looking, _search_overlaps(model_of(obj)).result)))


def overlaps_sought(obj: Any) -> "Future[tuple[str, ...]] | None":
    """Start the search for intersecting strips of a model. Return None if there is no model.

    The search takes about as long as making the model, so it runs in another thread after the recompute.
    """
    try:
        return _search_overlaps(model_of(obj))
    except FAILURES:  # the recompute has reported the error
        return None


def show_overlaps(obj: Any, overlaps: tuple[str, ...]) -> None:
    """Write messages on intersecting strips of a model into its results."""
    messages = list(map(worded, overlaps))
    if messages and obj.Overlaps != messages:
        report_warning(" ".join(messages), obj.Label)
    put(obj, Overlaps=list(dict.fromkeys(overlaps)))


def _search_overlaps(model: Model) -> "Future[tuple[str, ...]]":
    if model not in _overlaps:
        _overlaps[model] = begun(missing_slots, model.placed, model.joints)
    return _overlaps[model]


def solids_of(model: Model, place: App.Placement) -> list[Any]:
    """Return the bent strips of a model as solids, in the coordinate system of `place`."""
    solids = []
    for placed in model.placed:
        solid = bent_shape(placed.strip).copy(False)
        solid.Placement = place * placement_of(placed.frame)
        solids.append(solid)
    return solids


def strips_model(
    strips: list[Any], *, name: str, options: tuple[tuple[str, Any], ...] = (), as_displayed: bool = False
) -> Model:
    """Combine strips and models in their positions into one model. If `options` is given, cut slots.

    Copies, such as links and arrays, are included. With `as_displayed`, the strips are those from which the
    displayed shapes were made.
    """
    if not strips:
        raise InputError("The model has no strips. Choose strips in {box}.", box=FieldName("Strips"))
    places = [
        (strip, _numbers(world)) for obj in strips for strip, world in _placed_strips(obj, as_displayed)
    ]
    return in_background(
        QT_TRANSLATE_NOOP("Elastica", "Putting the model together"), _model, tuple(places), name, options
    )


def _placed_strips(obj: Any, as_displayed: bool) -> Iterator[tuple[Strip, App.Placement]]:
    strip_in, model_in = (shown_strip, shown_model) if as_displayed else (strip_of, model_of)
    standing = list(shown_strips(obj))
    if not any(is_strip(original) or is_model(original) for original, *_ in standing):
        raise InputError("{object} is not a strip. Choose strips for the model.", object=obj.Label)
    for original, place, is_image in standing:
        if is_strip(original):
            world = drawn_curve(original.Curve, original).world if original is obj else place
            strip = strip_in(original).mirrored() if is_image else strip_in(original)
            yield _labelled(strip, original.EngravedText or obj.Label), world
        elif is_model(original):
            here = container(original).inverse()
            for placed in model_in(original).placed:
                strip, inside = placed.strip, here * placement_of(placed.frame)
                yield (strip.mirrored(), place * turned_over(inside)) if is_image else (strip, place * inside)


@remembered
def _model(
    places: tuple[tuple[Strip, tuple[float, ...]], ...], name: str, options: tuple[tuple[str, Any], ...]
) -> Model:
    model = Model(tuple(_placed(*place) for place in places), name=name)
    return model.interlock(**dict(options)) if options else model


@remembered
def _placed(strip: Strip, numbers: tuple[float, ...]) -> Placed:
    """Return a strip placed in a frame. `numbers` are the origin and the x and y axes of the frame.

    Placed strips are cached, so that models with the same strip in the same place share its cached joints.
    """
    return Placed(strip, *np.array(numbers).reshape(3, 3))


@remembered
def _labelled(strip: Strip, label: str) -> Strip:
    return strip.labelled(label)


def _numbers(world: App.Placement) -> tuple[float, ...]:
    frame = frame_of(world)
    rows = np.array([frame.origin, frame.x_axis, frame.y_axis])
    return tuple(rows.ravel().tolist())
