"""Conversion of records to shapes of OpenCASCADE."""

from collections.abc import Sequence
from io import BytesIO
from typing import Any

import numpy as np

from elastica_cad.errors import InputError
from elastica_cad.formats.brep_writer import BinaryBrep, boundary_brep, face_brep, wire_brep
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.path import Path
from elastica_cad.kernel.ocp_import import Shape, kernel
from elastica_cad.strip.bent_boundary import Boundary
from elastica_cad.strip.solids import BodyRecord, FlatSolid, PrismSolid, glued


def make_wire(path: Path, frame: Frame | None = None) -> Shape:
    """Return a path as a TopoDS_Wire in the xy plane of `frame`."""
    return kernel().as_wire(_read(wire_brep(path, frame or Frame())))


def make_face(outline: Path, holes: Sequence[Path] = (), frame: Frame | None = None) -> Shape:
    """Return a plane TopoDS_Face with holes. The normal is the z axis of `frame`."""
    return sub_shapes(_read(face_brep(outline, holes, frame or Frame())), "face")[0]


def make_boundary(boundary: Boundary) -> Shape:
    """Return a closed boundary as a TopoDS_Solid, or an open boundary as a TopoDS_Shell."""
    k = kernel()
    return (k.as_solid if boundary.is_closed else k.as_shell)(_read(boundary_brep(boundary)))


def _read(brep: BinaryBrep) -> Shape:
    k = kernel()
    shape = k.TopoDS_Shape()
    k.BinTools.Read_s(shape, BytesIO(brep.for_bintools))
    return shape


def make_solid(record: BodyRecord | PrismSolid) -> Shape:
    """Return the solid of a record as a locked TopoDS_Solid: see `lock`."""
    return lock(_solid_of(record))


def lock(shape: Shape) -> Shape:
    """Lock a body, so that boolean operations change copies of its parts instead of the body."""
    shape.Locked(True)
    return shape


def make_sheets(records: Sequence[BodyRecord | PrismSolid]) -> list[Shape]:
    """Return the solids of a body: the sheets of a strip, or a single block."""
    return list(map(make_solid, glued(records)))


def _solid_of(record: BodyRecord | PrismSolid) -> Shape:
    """Return the shape of a record: united prisms without the removed ones, an extruded face, or a boundary."""
    k = kernel()
    if isinstance(record, PrismSolid):
        first, *rest = map(make_solid, record.added)
        whole = _combined(first, rest, k.BOPAlgo_Operation.BOPAlgo_FUSE)
        whole = _combined(whole, list(map(make_solid, record.removed)), k.BOPAlgo_Operation.BOPAlgo_CUT)
        with_few_faces = k.ShapeUpgrade_UnifySameDomain(whole, True, True, False)
        with_few_faces.Build()
        solids = sub_shapes(with_few_faces.Shape(), "solid")
        if len(solids) != 1:
            raise InputError(
                f"The prisms of a body form {len(solids)} separate pieces. Let them form a single piece."
            )
        return solids[0]
    if isinstance(record, FlatSolid) and record.is_prism:
        face = make_face(record.outline, record.holes, record.frame)
        return k.BRepPrimAPI_MakePrism(face, k.gp_Vec(*(record.frame.z_axis * record.thickness))).Shape()
    return make_boundary(record.boundary)


def _combined(shape: Shape, others: Sequence[Shape], operation: Any) -> Shape:
    """Return the shape after an operation of OpenCASCADE (fuse or cut) with others."""
    if not others:
        return shape
    builder = kernel().BOPAlgo_BOP()
    builder.AddArgument(shape)
    for other in others:
        builder.AddTool(other)
    builder.SetOperation(operation)
    builder.Perform()
    if builder.HasErrors():
        raise InputError(
            "OpenCASCADE could not combine the prisms of a body. Let prisms that only touch each other "
            "overlap, or move them apart."
        )
    return builder.Shape()


def sub_shapes(shape: Shape, *kinds: str) -> list[Shape]:
    """Return the sub-shapes of the kind `kinds[0]`, such as "face", in order.

    Sub-shapes inside the kind `kinds[1]`, if it is given, are omitted.
    """
    k = kernel()
    explorer = k.TopExp_Explorer(
        shape, *(getattr(k.TopAbs_ShapeEnum, f"TopAbs_{kind.upper()}") for kind in kinds)
    )
    shapes = []
    while explorer.More():
        shapes.append(getattr(k, f"as_{kinds[0]}")(explorer.Current()))
        explorer.Next()
    return shapes


def coordinates(place: Any) -> tuple[float, float, float]:
    """Return the coordinates of a gp_Pnt or gp_Dir."""
    return place.X(), place.Y(), place.Z()


def make_location(frame: Frame) -> Any:
    """Return the TopLoc_Location that moves the global axes to the axes of a frame."""
    k = kernel()
    place = k.gp_Trsf()
    place.SetTransformation(plane_axes_of(frame), k.gp_Ax3())
    return k.TopLoc_Location(place)


def moved_frame(frame: Frame, motion: Any) -> Frame:
    """Return the frame after a gp_Trsf: a translation, rotation or reflection.

    After a reflection, y is z x x for the reflected x and z, because frames are right-handed.
    """
    return _frame_of(plane_axes_of(frame).Transformed(motion))


def face_frame(face: Shape) -> Frame:
    """Return the frame of `make_face` after all motions of the face; y as in `moved_frame`."""
    return _frame_of(kernel().BRepAdaptor_Surface(face).Plane().Position())


def _frame_of(axes: Any) -> Frame:
    # return the frame of a gp_Ax3; a left-handed one gets the y axis of a right-handed frame
    x, z = coordinates(axes.XDirection()), coordinates(axes.Direction())
    return Frame(coordinates(axes.Location()), x, np.cross(z, x))


def plane_axes_of(frame: Frame) -> Any:
    """Return the origin, normal and x axis of a frame as a gp_Ax3."""
    k = kernel()
    origin, z, x = frame.origin.tolist(), frame.z_axis.tolist(), frame.x_axis.tolist()
    return k.gp_Ax3(k.gp_Pnt(*origin), k.gp_Dir(*z), k.gp_Dir(*x))
