"""A model as an assembly of build123d."""

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import build123d as bd

from elastica_cad.geometry.frame import Frame
from elastica_cad.kernel import occt
from elastica_cad.kernel.strip_body import MadeStrip
from elastica_cad.kernel.strip_warnings import warn_of_missing_slots

if TYPE_CHECKING:
    from elastica_cad.fabrication.model.assembly import AssemblyPart, Holder
    from elastica_cad.fabrication.model.strip_model import Model

from elastica_cad.build123d.native_shapes import add_joints, make_solids
from elastica_cad.build123d.strip_objects import PlacedStrip


def model_compound(model: "Model", *, others: "Iterable[Holder]" = ()) -> bd.Compound:
    """The bent strips of a model as an assembly: a compound whose children are called like the parts.

    Equal strips share one body. Every child has the joints of `BentStrip` and knows its `strip`; the sheets of a
    laminate are its children.

    Parameters
    ----------
    model : Model
    others : iterable of BasePlate, SlottedFrame and EndFixture, optional
        What holds the strips, as further children: plates and blocks, these with their joint "tab".

    Returns
    -------
    Compound
        Called like the model, with one `PlacedStrip` a strip.

    Raises
    ------
    InputError
        Something else among `others`.
    """
    from elastica_cad.fabrication.model.assembly import assembly_parts, require_model, shape_parts

    require_model(model)
    parts = assembly_parts(model.placed, (*model.plates, *others))
    warn_of_missing_slots(model)
    children = [
        _child(part, solids) for part, solids in shape_parts(parts, lambda part: make_solids(part.solids))
    ]
    return bd.Compound(label=model.name, children=children)


def _child(part: "AssemblyPart", solids: list[bd.Solid]) -> bd.Part:
    """A part of an assembly in its place; of a strip one that knows it."""
    child: Any = bd.Part(solids[0].wrapped)
    if part.strip is not None:
        child = PlacedStrip(bd.Compound(solids).wrapped)
        base: Any = part.solids[0]
        child._made = MadeStrip(part.strip, Frame(), home=base.joints["start"])
        if len(solids) > 1:
            # new wrappers: equal strips share shapes, but a child has one parent
            layers = [bd.Solid(solid.wrapped) for solid in solids]
            for layer, name, color in zip(layers, part.names, part.colors, strict=True):
                layer.label, layer.color = name, bd.Color(*color)
            child.children = layers
    add_joints(child, part.solids[0])
    child.label, child.color = part.name, bd.Color(*part.colors[0])
    child.location = bd.Location(occt.make_location(part.frame))
    return child
