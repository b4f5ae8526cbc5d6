"""A model as an assembly of CadQuery."""

from collections.abc import Iterable
from typing import TYPE_CHECKING

import cadquery as cq

from elastica_cad.fabrication.strip.outline import ENDS
from elastica_cad.geometry.frame import Frame
from elastica_cad.kernel import occt
from elastica_cad.kernel.strip_body import MadeStrip
from elastica_cad.kernel.strip_warnings import warn_of_missing_slots

if TYPE_CHECKING:
    from elastica_cad.fabrication.model.assembly import AssemblyPart, Holder
    from elastica_cad.fabrication.model.strip_model import Model

from elastica_cad.cadquery.native_places import free_name, make_location
from elastica_cad.cadquery.strip_shapes import StripSolid, dress


def model_assembly(model: "Model", *, others: "Iterable[Holder]" = ()) -> cq.Assembly:
    """The bent strips of a model as an assembly with names, colours and places.

    The ends of every strip are held by constraints (points and axes of their end faces), so that parts which are
    added and constrained to them find their places in `solve()` while the strips stay. Equal strips share one body.

    Parameters
    ----------
    model : Model
    others : iterable of BasePlate, SlottedFrame and EndFixture, optional
        What holds the strips, as further children, held where they are by `solve()` as the strips.

    Returns
    -------
    Assembly
        Called like the model; its children like the parts (with "_" for what queries cannot hold), each strip
        with its end faces tagged "start" and "end" and its `Strip` as metadata "strip". Of a laminate that is the
        base, with the backing as its child.

    Raises
    ------
    InputError
        Something else among `others`.
    """
    from elastica_cad.fabrication.model.assembly import assembly_parts, require_model, shape_parts

    require_model(model)
    assembly = cq.Assembly(name=model.name)
    parts = assembly_parts(model.placed, (*model.plates, *others))
    warn_of_missing_slots(model)
    for part, (body, *glued_on) in shape_parts(parts, _part_shapes):
        name, place = free_name(part.name, assembly), make_location(part.frame)
        color, *colors = (cq.Color(*each) for each in part.colors)
        if not isinstance(body, StripSolid):
            assembly.add(body, name=name, color=color, loc=place)
            assembly.constrain(name, "Fixed")
            continue
        work = cq.Workplane(obj=body)
        faces = {end: body.end_face(end) for end in ENDS}
        for end, face in faces.items():
            work.newObject([face]).tag(end)
        strip = cq.Assembly(work, name=name, loc=place, color=color, metadata={"strip": part.strip})
        for sheet, label, its_color in zip(glued_on, part.names[1:], colors, strict=True):
            strip.add(sheet, name=free_name(label, assembly), color=its_color)
        assembly.add(strip)
        for end, face in faces.items():
            there = face.moved(place)
            assembly.constrain(f"{name}?{end}", "FixedPoint", there.Center().toTuple())
            assembly.constrain(f"{name}?{end}", "FixedAxis", there.normalAt().toTuple())
    return assembly


def _part_shapes(part: "AssemblyPart") -> list[cq.Shape]:
    """A body, of a strip its sheets: the base is the one that knows its strip."""
    base, *glued_on = (cq.Solid(occt.make_solid(record)) for record in part.solids)
    if part.strip is not None:
        home = part.solids[0].joints["start"]
        made = MadeStrip(part.strip, Frame(), home=home)
        base = dress(StripSolid(base.wrapped), part.solids[0].joints, made)
    return [base, *glued_on]
