# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Printed blocks that hold the ends of strips, as a parametric object."""

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import FreeCAD as App
import Part
from freecad.elastica_wb.curves.copies import not_repeated
from freecad.elastica_wb.curves.part_shapes import make_solid
from freecad.elastica_wb.curves.sketch_curves import container
from freecad.elastica_wb.features.model import strips_model
from freecad.elastica_wb.features.proxy import CONTAINERS, REPORTS, Feature, added
from freecad.elastica_wb.host.objects import feature_kind
from freecad.elastica_wb.host.progress import go_on, progress
from freecad.elastica_wb.host.property_table import Property, declared_property, put, values_of
from freecad.elastica_wb.host.resources import QT_TRANSLATE_NOOP
from freecad.elastica_wb.solving.strip_cache import remembered

from elastica_cad.declared import declared
from elastica_cad.errors import InputError, one_of_each
from elastica_cad.model.fixtures import FIXTURE_COLOR, EndFixture, place_tabs
from elastica_cad.model.frames import Rib
from elastica_cad.model.held_tabs import holder_plays
from elastica_cad.model.model import Model
from elastica_cad.model.plates import BasePlate

SIZES = {option.name.title().replace("_", ""): option for option in declared(EndFixture)}
"""Options of blocks, by the names of their properties."""


class FixturesFeature(Feature):
    """The printed blocks for all tabs, in a single compound."""

    places = (CONTAINERS,)
    properties = (
        Property("LinkListGlobal", "Sources", "Fixtures", "Model or strips whose ends are held"),
        *(declared_property(field, "Fixtures", name) for name, field in SIZES.items()),
        REPORTS,
    )

    def make(self, obj: Any) -> None:
        """Set the shape to a block at every end."""
        model = source_model(obj.Sources, as_displayed=True)
        blocks = _blocks(obj, model)
        if not blocks:
            raise InputError("The strips have no tabs to hold. Add tabs to the strips.")
        inner = container(obj).inverse()
        shapes = []
        with progress(QT_TRANSLATE_NOOP("Elastica", "Making the blocks"), len(blocks)) as step:
            for done, block in enumerate(blocks):
                go_on(step, done, "recompute to try again")
                shape = block_shape(block).copy(False)
                shape.Placement = inner * shape.Placement
                shapes.append(shape)
        obj.Shape = Part.Compound(shapes)
        report_holders(obj, model, sorted(blocks, key=lambda block: -abs(block.lean[1])))


def _blocks(obj: Any, model: Model) -> tuple[EndFixture, ...]:
    return model.fixtures(**values_of(obj, SIZES))


def blocks_for(source: Any) -> list[EndFixture]:
    """Return the blocks that hold the ends of a strip or a model, at their places in the document."""
    hanging = dict.fromkeys(user for obj in (source, *getattr(source, "Strips", ())) for user in obj.InList)
    users = [obj for obj in hanging if feature_kind(obj) == "Fixtures"]
    tabs = {tab.key for tab in place_tabs(source_model([source]).placed)} if users else set()
    every = (block for obj in users for block in _blocks(obj, source_model(obj.Sources)))
    return [block for block in every if block.tab.key in tabs]


@remembered
def block_shape(block: EndFixture) -> Part.Shape:
    """Return the shape of a block at its position.

    The shape without the pocket is cached, because each change of a strip rotates the pockets of all blocks
    slightly.
    """
    pocket, *_ = block.solid.removed
    return _without_pocket(replace(block, lean=(0.0, 0.0))).cut(make_solid(pocket)).removeSplitter()


@remembered
def _without_pocket(block: EndFixture) -> Part.Shape:
    solid = block.solid
    return make_solid(replace(solid, removed=solid.removed[1:]))


def create(document: Any, sources: list[Any]) -> Any:
    """Make fixtures for a model or for strips, without recomputing the document."""
    obj = added(document, "Fixtures", FixturesFeature, sources, Sources=sources)
    if App.GuiUp:
        obj.ViewObject.ShapeColor = FIXTURE_COLOR
    return obj


def report_holders(obj: Any, model: Model, holders: Iterable[EndFixture | BasePlate | Rib]) -> None:
    """Write the clearance of the tabs in their holders, and the warnings of the holders, into the results."""
    warnings = one_of_each(text for holder in holders for text in holder.warnings)
    put(obj, Reports=[*holder_plays(model.placed, holders), *warnings])


def source_model(sources: list[Any], *, as_displayed: bool = False) -> Model:
    """Return one model of all strips and models among the sources. For `as_displayed`, see `strips_model`."""
    return strips_model(not_repeated(sources), name="strips", as_displayed=as_displayed)
