"""Bodies of thousands of holes on their way to STEP: OpenCASCADE compares each wire of a face with all others."""

from collections.abc import Iterable
from typing import Any

from elastica_cad.kernel.occt import sub_shapes
from elastica_cad.kernel.ocp_import import Shape, kernel

MANY_WIRES = 32
"""Of one face: fewer are compared in no time."""


def has_many_wires(shape: Shape) -> bool:
    """Has a face so many holes that OpenCASCADE takes long to compare them?"""
    k = kernel()
    faces = sub_shapes(shape, k.TopAbs_ShapeEnum.TopAbs_FACE)
    return any(len(sub_shapes(face, k.TopAbs_ShapeEnum.TopAbs_WIRE)) > MANY_WIRES for face in faces)


def with_wires_apart(shape: Shape) -> Shape:
    """The shape with a corner of its own for every wire of a face, as OpenCASCADE writes it.

    It looks for corners that wires share pair by pair of wires, in the square of their number; here only wires that
    do share one are shown to it.
    """
    k = kernel()
    context, found = k.ShapeBuild_ReShape(), False
    for face in sub_shapes(shape, k.TopAbs_ShapeEnum.TopAbs_FACE):
        wires = sub_shapes(face, k.TopAbs_ShapeEnum.TopAbs_WIRE)
        touching = _touching(wires)
        if not touching:
            continue
        few, builder, split = face.EmptyCopied(), k.BRep_Builder(), k.ShapeFix_SplitCommonVertex()
        for number in touching:
            builder.Add(few, wires[number])
        split.SetContext(context)
        split.Init(few)
        split.Perform()
        found = True
    return context.Apply(shape) if found else shape


def transfer_as_they_are(writer: Any, shapes: Iterable[Shape]) -> None:
    """Turn shapes into STEP entities, without the look at their wires that the writer would take first.

    Its own transfer of a document finds what has been transferred. A controller that no writer has set up yet asks
    for no such look; OCP has no way to tell a writer so.
    """
    k = kernel()
    session = writer.ChangeWriter().WS()
    session.SetController(k.STEPCAFControl_Controller())
    writer.ChangeWriter().Model(True)
    for shape in shapes:
        session.TransferWriteShape(shape)


def _touching(wires: list[Shape]) -> list[int]:
    """Numbers of the wires of a face that have a corner in common with another one."""
    if len(wires) < 2:
        return []
    k = kernel()
    owner: dict[tuple[float, float, float], int] = {}
    touching = set[int]()
    for number, wire in enumerate(wires):
        for vertex in sub_shapes(wire, k.TopAbs_ShapeEnum.TopAbs_VERTEX):
            place = k.BRep_Tool.Pnt_s(k.as_vertex(vertex))
            other = owner.setdefault((place.X(), place.Y(), place.Z()), number)
            if other != number:
                touching |= {other, number}
    return sorted(touching)
