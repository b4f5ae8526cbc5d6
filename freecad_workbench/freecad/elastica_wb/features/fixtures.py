# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Printed blocks that hold the ends of strips, as a parametric object."""

from collections.abc import Iterable
from typing import Any

import Part
from freecad.elastica_wb.curves.copies import not_repeated
from freecad.elastica_wb.curves.sketch_curves import container
from freecad.elastica_wb.features.model import strips_model
from freecad.elastica_wb.features.proxy import CONTAINERS, Feature, added
from freecad.elastica_wb.host.progress import in_steps
from freecad.elastica_wb.host.property_table import Property, put
from freecad.elastica_wb.host.resources import QT_TRANSLATE_NOOP
from freecad.elastica_wb.host.words import worded
from freecad.elastica_wb.shapes.part_shapes import make_solid

from elastica_cad.errors import InputError
from elastica_cad.fabrication.holders.held_tabs import holder_plays
from elastica_cad.fabrication.model.strip_model import Model

PLAYS = Property("StringList", "Reports", "Result", "What was found on the way", [], result=True)
"""How much room tabs have in what holds them."""


class FixturesFeature(Feature):
    """The printed blocks for all tabs, as one compound."""

    properties = (
        Property("LinkListGlobal", "Sources", "Fixtures", "A model, or strips, whose ends are held"),
        Property("Length", "Clearance", "Fixtures", "Room around the tab", 0.15),
        Property("Length", "Wall", "Fixtures", "Least thickness around the pocket", 4.0),
        Property(
            "Length", "Foot", "Fixtures", "How far the foot sticks out on either side; 0 for none", 12.0
        ),
        Property("Length", "FootHeight", "Fixtures", "Height of the foot", 4.0),
        Property("Length", "Screw", "Fixtures", "Diameter of the screw holes in the foot; 0 for none", 4.3),
        PLAYS,
        CONTAINERS,
    )

    def make(self, obj: Any) -> None:
        """Place a block at every end."""
        model = source_model(obj.Sources)
        blocks = model.fixtures(
            clearance=obj.Clearance.Value,
            wall=obj.Wall.Value,
            foot=obj.Foot.Value,
            foot_height=obj.FootHeight.Value,
            screw=obj.Screw.Value,
        )
        if not blocks:
            raise InputError("no strip here has a tab to be held: give the strips tabs")
        inner, solids = container(obj).inverse(), [block.solid for block in blocks]
        made = in_steps(QT_TRANSLATE_NOOP("Elastica", "Making the blocks"), solids, make_solid)
        for block in made:
            block.Placement = inner * block.Placement
        obj.Shape = Part.Compound(made)
        tell_plays(obj, model, blocks)


def create(document: Any, sources: list[Any]) -> Any:
    """Fixtures for a model or for strips; recompute the document to see them."""
    obj = added(document, "Fixtures", FixturesFeature, sources)
    obj.Sources = sources
    return obj


def tell_plays(obj: Any, model: Model, holders: Iterable[object]) -> None:
    """Write into a holder's results how far tabs shift and turn in it."""
    put(obj, Reports=[worded(line) for line in holder_plays(model.placed, holders)])


def source_model(sources: list[Any]) -> Model:
    """One model of all strips and models among the sources, each where it stands."""
    return strips_model(not_repeated(sources), name="strips")
