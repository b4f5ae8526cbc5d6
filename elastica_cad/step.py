"""STEP files: strips and models written by OpenCASCADE, curves read by it."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from io import BytesIO
from os import PathLike
from pathlib import Path
from typing import Any

from elastica_cad.errors import InputError
from elastica_cad.fabrication import BentSolid, FlatSolid, Frame, Model, Strip, sheet_color
from elastica_cad.fabrication.assembly import Holder, bent_parts, holder_bodies, layer_names
from elastica_cad.formats.opening import existing_file, naming
from elastica_cad.formats.output import write_atomically
from elastica_cad.formats.step_text import canonical_step
from elastica_cad.geometry import PlaneCurve
from elastica_cad.occt import Shape, free_curves, kernel, make_location, make_solid

__all__ = [
    "Part",
    "model_parts",
    "read_step_curves",
    "read_step_shape",
    "step_bytes",
    "write_model_step",
    "write_step",
    "write_strip_step",
]


@dataclass(frozen=True, eq=False)
class Part:
    """A shape in an assembly: its name, its colour (red, green, blue in 0..1, as on a screen), its place.

    Parts that share a shape are written once and placed many times.
    """

    name: str
    shape: Shape
    color: tuple[float, float, float] = (0.8, 0.65, 0.42)
    frame: Frame | None = None


def model_parts(model: Model, others: Iterable[Holder] = ()) -> list[Part]:
    """The bent strips of a model, each in its place, and what holds them; equal strips share one shape."""
    shapes: dict[int, Shape] = {}
    parts = []
    for part in bent_parts(model):
        for name, solid, layer in zip(part.names, part.solids, part.strip.layers, strict=True):
            if id(solid) not in shapes:
                shapes[id(solid)] = make_solid(solid)
            parts.append(Part(name, shapes[id(solid)], sheet_color(layer.sheet), part.frame))
    holders = holder_bodies((*model.plates, *others))
    parts += [Part(body.name, make_solid(body.solid), body.color) for body in holders]
    return parts


def write_model_step(
    model: Model, path: str | PathLike[str], *, others: Iterable[Holder] = (), force: bool = False
) -> None:
    """Write the bent strips of a model, in their places, to one STEP file.

    `others` are its base plates, frames and fixtures, if these are wanted in the file.
    """
    write_step(model_parts(model, others), path, name=model.name, force=force)


def write_step(
    parts: Sequence[Part], path: str | PathLike[str], *, name: str | None = None, force: bool = False
) -> None:
    """Write parts to a STEP file: AP214, millimetres, names, colours, the same bytes for the same parts.

    Several parts make one assembly, called `name` (the file's own unless told).

    Raises
    ------
    InputError
        No parts, a file that is there already (without `force`), or a folder that cannot be written to.
    """
    if not parts:
        raise InputError("there is nothing to write: give one part or more")
    write_atomically(path, step_bytes(parts, name=name or Path(path).stem), force=force)


def step_bytes(parts: Sequence[Part], *, name: str) -> bytes:
    """The STEP file of the parts; several of them make one assembly called `name`."""
    k = kernel()
    document = k.TDocStd_Document(k.TCollection_ExtendedString("XmlOcaf"))
    shapes = k.XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    colors = k.XCAFDoc_DocumentTool.ColorTool_s(document.Main())
    k.XCAFDoc_DocumentTool.SetLengthUnit_s(document, 0.001)
    drawn: dict[int, Any] = {}
    for part in parts:
        if id(part.shape) not in drawn:
            label = shapes.AddShape(getattr(part.shape, "wrapped", part.shape), False)
            color = k.Quantity_Color(*part.color, k.Quantity_TypeOfColor.Quantity_TOC_sRGB)
            colors.SetColor(label, color, k.XCAFDoc_ColorType.XCAFDoc_ColorGen)
            _set_name(label, part.name)
            drawn[id(part.shape)] = label
    if len(parts) > 1 or parts[0].frame is not None:
        root = shapes.NewShape()
        for part in parts:
            place = make_location(part.frame or Frame())
            _set_name(shapes.AddComponent(root, drawn[id(part.shape)], place), part.name)
        _set_name(root, name)
        shapes.UpdateAssemblies()
    for printer in k.Message.DefaultMessenger_s().Printers():
        printer.SetTraceLevel(k.Message_Gravity.Message_Fail)
    writer = k.STEPCAFControl_Writer()
    writer.SetColorMode(True)
    writer.SetNameMode(True)
    k.Interface_Static.SetCVal_s("write.step.schema", "AP214IS")
    k.Interface_Static.SetCVal_s("write.step.unit", "MM")
    stream = BytesIO()
    done = writer.Transfer(document, k.STEPControl_StepModelType.STEPControl_AsIs)
    header = k.APIHeaderSection_MakeHeader(writer.Writer().Model())
    header.SetName(k.TCollection_HAsciiString(name))
    header.SetTimeStamp(k.TCollection_HAsciiString("2000-01-01T00:00:00"))
    header.SetOriginatingSystem(k.TCollection_HAsciiString("elastica_cad"))
    if not done or writer.WriteStream(stream) != k.IFSelect_ReturnStatus.IFSelect_RetDone:
        raise InputError("OpenCASCADE could not write these parts as STEP: check that they are valid solids")
    return canonical_step(stream.getvalue())


def _set_name(label: Any, name: str) -> None:
    """Name a label of a document."""
    k = kernel()
    k.TDataStd_Name.Set_s(label, k.TCollection_ExtendedString(name, True))


def write_strip_step(strip: Strip, path: str | PathLike[str], *, force: bool = False) -> None:
    """Write a strip as cut and as bent to one STEP file; the bent one stands on the curve in the xy plane.

    The sheets of a laminate are parts of their own.
    """
    name = strip.label or "strip"
    names, sheets = layer_names(name, strip), [layer.sheet for layer in strip.layers]
    shapes = {
        "flat": [make_solid(solid) for solid in FlatSolid.layers(strip)],
        "bent": [make_solid(solid) for solid in BentSolid.layers(strip)],
    }
    parts = [
        Part(f"{called} {form}", shape, sheet_color(sheet))
        for form, made in shapes.items()
        for called, shape, sheet in zip(names, made, sheets, strict=True)
    ]
    write_step(parts, path, name=name, force=force)


def read_step_curves(path: str | PathLike[str]) -> list[PlaneCurve]:
    """The plane curves drawn in a STEP (or BREP) file; edges that belong to faces are not curves of strips.

    Raises
    ------
    InputError
        No such file, no STEP file, no free edges in it, or edges that no strip can follow.
    """
    path = existing_file(Path(path))
    with naming(path):
        curves = free_curves(read_step_shape(path))
        if not curves:
            raise InputError(
                "the file holds no free edges or wires: export the curves themselves, not solids or faces"
            )
        return curves


def read_step_shape(path: Path) -> Shape:
    """All that a STEP or BREP file holds, mm.

    Raises
    ------
    InputError
        A file that OpenCASCADE cannot read.
    """
    k = kernel()
    if path.suffix.lower() in (".brep", ".brp"):
        shape = k.TopoDS_Shape()
        if not k.BRepTools.Read_s(shape, str(path), k.BRep_Builder()):
            raise InputError("this is no BREP file that OpenCASCADE can read")
        return shape
    for printer in k.Message.DefaultMessenger_s().Printers():
        printer.SetTraceLevel(k.Message_Gravity.Message_Fail)
    reader = k.STEPControl_Reader()
    if reader.ReadFile(str(path)) != k.IFSelect_ReturnStatus.IFSelect_RetDone or not reader.TransferRoots():
        raise InputError("this is no STEP file that OpenCASCADE can read")
    return reader.OneShape()
