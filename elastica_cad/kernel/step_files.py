"""Writer of STEP files of strips and models, and reader of curves from STEP and BREP files."""

import faulthandler
import os
import re
import signal
import sys
import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace
from functools import partial
from io import BytesIO
from itertools import count
from os import PathLike
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np

from elastica_cad._units import look_up_unit
from elastica_cad.errors import InputError
from elastica_cad.formats.drawn_file import DrawnCurve, DrawnFile, ReadUnit, kinds_of, list_things
from elastica_cad.formats.edges import Run
from elastica_cad.formats.placed_curve import drawing_plane, flatten_run, place_chain
from elastica_cad.formats.source_file import check_size
from elastica_cad.formats.write_files import write_atomically
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.kernel.drawn_edges import free_chains
from elastica_cad.kernel.occt import coordinates, make_location, make_solid, sub_shapes
from elastica_cad.kernel.ocp_import import Shape, bare, kernel
from elastica_cad.mechanics.sheets import sheet_color
from elastica_cad.model.assembly import Holder, assembly_parts, bent_names, shape_parts
from elastica_cad.model.model import Model
from elastica_cad.strip.solids import BentSolid, FlatSolid, bent_sheets, frame_beside
from elastica_cad.strip.strip import Strip

if TYPE_CHECKING:
    from elastica_cad.pairs.flexure import Flexure, State

LEAST_S, S_PER_MB = 5, 5
"""CPU time limit for reading a file: a constant in s, plus s per MB. Valid files need a tenth of the limit."""

BUSY = 10
"""Limit of the elapsed time, as a multiple of the CPU time limit, because the processor may be busy."""


def try_in_a_copy(task: Callable[[], object], size: int = 0) -> None:
    """Run a task in a forked copy of this process. Raise InputError if the copy crashes or takes too long.

    Exceptions of the task are ignored. On Linux, the copy also ends when this process ends. On systems without
    fork, nothing is done.

    Parameters
    ----------
    task : callable
        Function to run.
    size : int
        Size of the file that the task reads, bytes.
    """
    if not hasattr(os, "fork"):
        return
    seconds = LEAST_S + S_PER_MB * size // 2**20
    with warnings.catch_warnings():
        # Python warns that a fork copies no threads, but the copy needs none
        warnings.simplefilter("ignore", DeprecationWarning)
        parent, copy = os.getpid(), os.fork()
    if not copy:
        with suppress(BaseException):
            _limit(parent, seconds)
            with suppress(Exception):
                task()
            os._exit(0)
        os._exit(1)
    try:
        status = os.waitpid(copy, 0)[1]
    except BaseException:  # for example after Ctrl-C
        os.kill(copy, signal.SIGKILL)
        raise
    if os.WIFSIGNALED(status) and os.WTERMSIG(status) in (signal.SIGXCPU, signal.SIGALRM):
        raise InputError(f"OpenCASCADE needs more than {seconds} s for this file. Export only its curves.")
    if status:
        raise InputError("The file is damaged, and OpenCASCADE cannot read it. Export it again.")


def _limit(parent: int, seconds: int) -> None:
    """Limit the time of this process, also in compiled code, and suppress its output.

    On Linux, the process also ends when its parent ends.
    """
    import resource

    faulthandler.disable()
    silence = os.open(os.devnull, os.O_WRONLY)
    os.dup2(silence, 1)
    os.dup2(silence, 2)
    most = resource.getrlimit(resource.RLIMIT_CPU)[1]
    seconds = seconds if most == resource.RLIM_INFINITY else min(seconds, most)
    signal.signal(signal.SIGXCPU, signal.SIG_DFL)
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, most))
    signal.signal(signal.SIGALRM, signal.SIG_DFL)
    signal.alarm(BUSY * seconds)
    if sys.platform == "linux":
        import ctypes

        # option 1, PR_SET_PDEATHSIG, is the signal that a process gets when its parent ends
        ctypes.CDLL(None).prctl(1, signal.SIGKILL)
        if os.getppid() != parent:  # the parent ended before the call of `prctl`
            os._exit(1)


MANY_WIRES = 32
"""Number of wires above which a face is slow to write, because OpenCASCADE compares all pairs of wires."""


def _with_wires_apart(shape: Shape) -> Shape:
    """Give the wires of a face separate vertices where they share a vertex.

    OpenCASCADE's writer does the same, but slowly, because it compares all pairs of wires.
    """
    k = kernel()
    context, is_changed = k.ShapeBuild_ReShape(), False
    for face in sub_shapes(shape, "face"):
        wires = sub_shapes(face, "wire")
        touching = _touching(wires)
        if not touching:
            continue
        # a face with only the wires that share vertices, because all pairs of its wires are compared
        few, builder, split = face.EmptyCopied(), k.BRep_Builder(), k.ShapeFix_SplitCommonVertex()
        for number in touching:
            builder.Add(few, wires[number])
        split.SetContext(context)
        split.Init(few)
        split.Perform()
        is_changed = True
    return context.Apply(shape) if is_changed else shape


def _transfer_as_they_are(writer: Any, shapes: Iterable[Shape]) -> None:
    """Convert shapes to STEP entities without checks of their wires, by means of a new controller.

    The controller of a writer asks for these checks, which are slow for many wires, and OCP cannot switch them off.
    A controller that no writer has set up does not ask. The later transfer of the document reuses these entities.
    """
    session = writer.ChangeWriter().WS()
    session.SetController(kernel().STEPCAFControl_Controller())
    writer.ChangeWriter().Model(True)
    for shape in shapes:
        session.TransferWriteShape(shape)


def _touching(wires: list[Shape]) -> list[int]:
    """Return the indices of wires of a face that share a vertex with another wire."""
    if len(wires) < 2:
        return []
    owner: dict[tuple[float, float, float], int] = {}
    touching = set[int]()
    for number, wire in enumerate(wires):
        for vertex in sub_shapes(wire, "vertex"):
            other = owner.setdefault(coordinates(kernel().BRep_Tool.Pnt_s(vertex)), number)
            if other != number:
                touching |= {other, number}
    return sorted(touching)


SETTINGS = {"write.step.schema": "AP214IS", "write.step.unit": "MM"}
ELEMENTARY = ("Plane", "Cylinder", "Cone", "Sphere", "Torus")
"""Kinds of surfaces for which readers compute edges exactly as curves in the parameters of the faces."""


@dataclass(frozen=True, eq=False)
class NamedShape:
    """Shape in an assembly, with its name, colour and position.

    A shape that occurs several times is written once.
    """

    name: str
    shape: Shape
    color: tuple[float, ...] = (0.8, 0.65, 0.42)
    frame: Frame | None = None


def model_shapes(model: Model, others: Iterable[Holder] = ()) -> list[NamedShape]:
    """Return the bent strips of a model and their holders, in their positions. Equal strips share a shape."""
    parts = assembly_parts(model.placed, (*model.plates, *others))
    return [
        NamedShape(name, shape, color, part.frame)
        for part, shapes in shape_parts(parts, lambda part: list(map(make_solid, part.solids)))
        for name, shape, color in zip(part.names, shapes, part.colors, strict=True)
    ]


def write_step(
    parts: Sequence[NamedShape], path: str | PathLike[str], *, name: str | None = None, force: bool = False
) -> None:
    """Write parts with names and colours to a STEP file (AP214, millimetres).

    Several parts form the assembly `name`, by default named after the file.
    """
    if not parts:
        raise InputError("There is nothing to write. Pass at least one part.")
    write_atomically(path, step_bytes(parts, name=name or Path(path).stem), force=force)


def make_document(parts: Sequence[NamedShape], *, name: str) -> Any:
    """Return an OpenCASCADE document with parts in mm, their names and colours.

    Several parts form the assembly `name`.
    """
    k = kernel()
    document = k.TDocStd_Document(k.TCollection_ExtendedString("XmlOcaf"))
    shapes = k.XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    colors = k.XCAFDoc_DocumentTool.ColorTool_s(document.Main())
    k.XCAFDoc_DocumentTool.SetLengthUnit_s(document, 0.001)
    drawn: dict[int, Any] = {}  # label of each shape in the document, by the id of the shape
    for part in parts:
        if id(part.shape) not in drawn:
            label = shapes.AddShape(bare(part.shape), False)
            color = k.Quantity_Color(*part.color[:3], k.Quantity_TypeOfColor.Quantity_TOC_sRGB)
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
    return document


def step_bytes(parts: Sequence[NamedShape], *, name: str) -> bytes:
    """Return the content of a STEP file with the parts. Several parts form the assembly `name`."""
    k = kernel()
    shapes = {id(part.shape): bare(part.shape) for part in parts}
    faces = [face for shape in shapes.values() for face in sub_shapes(shape, "face")]
    holed = any(len(sub_shapes(face, "wire")) > MANY_WIRES for face in faces)
    if holed:
        shapes = {number: _with_wires_apart(shape) for number, shape in shapes.items()}
    texts = [_step_text(called) for called in (*(part.name for part in parts), name)]
    # OpenCASCADE breaks lines within letters and leaves \S\ as it is, so names are put in afterwards
    mark = "elastica-name-{}".format
    marked = [replace(part, name=mark(k), shape=shapes[id(part.shape)]) for k, part in enumerate(parts)]
    document = make_document(marked, name=mark(len(parts)))
    stream = BytesIO()
    # separate vertices of wires change no surface
    kinds = [getattr(k.GeomAbs_SurfaceType, f"GeomAbs_{name}") for name in ELEMENTARY]
    elementary = all(k.BRepAdaptor_Surface(face).GetType() in kinds for face in faces)
    # edges as curves in the parameters of their faces are more than half of a file
    with _own_settings({"write.surfacecurve.mode": "0" if elementary else "1"}):
        writer = k.STEPCAFControl_Writer()
        writer.SetColorMode(True)
        writer.SetNameMode(True)
        if holed:
            _transfer_as_they_are(writer, shapes.values())
        done = writer.Transfer(document, k.STEPControl_StepModelType.STEPControl_AsIs)
        header = k.APIHeaderSection_MakeHeader(writer.Writer().Model())
        text = k.TCollection_HAsciiString
        header.SetName(text(mark(len(parts))))
        header.SetTimeStamp(text("2000-01-01T00:00:00"))
        header.SetAuthorValue(1, text(""))
        for say in (header.SetOriginatingSystem, header.SetPreprocessorVersion):
            say(text("elastica_cad"))
        header.SetOrganizationValue(1, text(""))
        header.SetDescriptionValue(1, text("strips bent to shape"))
        done = done and writer.WriteStream(stream) == k.IFSelect_ReturnStatus.IFSelect_RetDone
    if not done:
        raise InputError("OpenCASCADE could not write these parts as STEP. Check that they are valid solids.")
    content = _in_order(stream.getvalue())
    return re.sub(rb"elastica-name-(\d+)", lambda found: texts[int(found[1])], content)


def _in_order(content: bytes) -> bytes:
    """Return a STEP file with its places numbered from 1 and its styles in the order of the parts.

    OpenCASCADE counts the places of all files that it has written. It writes the styles, which are the last
    entities of a file, in the order of the addresses of shapes in memory. So a file would differ at each run.
    """
    places = count(1)
    content = re.sub(
        rb"(?s)(USAGE_OCCURRENCE\(')\d+(.*?;)",
        lambda found: b"%s%d%s" % (found[1], next(places), found[2].replace(b"\n  ", b"")),
        content,
    )
    styles = re.search(rb"(?s)#\d+ = MECHANICAL_DESIGN.*(?=ENDSEC)", content)
    if styles is None:
        return content
    bodies = dict(re.findall(rb"(?s)#(\d+) = (.*?;\n)", styles[0]))
    first, numbers = min(map(int, bodies)), dict[bytes, bytes]()

    def number(entity: bytes) -> None:
        if entity in bodies and entity not in numbers:
            numbers[entity] = b"%d" % (first + len(numbers))
            for used in re.findall(rb"#(\d+)", bodies[entity]):
                number(used)

    # the last number in the style of a part is that of the part's context
    roots = [entity for entity, body in bodies.items() if body.startswith(b"MECHANICAL_DESIGN")]
    for root in sorted(roots, key=lambda entity: int(re.findall(rb"#(\d+)", bodies[entity])[-1])):
        number(root)
    text = b"".join(b"#%s = %s" % (entity, bodies[entity]) for entity in numbers)
    text = re.sub(rb"#(\d+)", lambda found: b"#" + numbers.get(found[1], found[1]), text)
    return content[: styles.start()] + text + content[styles.end() :]


def _step_text(name: str) -> bytes:
    """Return a name as in a STEP file, in ASCII (ISO 10303-21).

    An apostrophe is written as \\X\\27, because OpenCASCADE cannot read a doubled one before a bracket.
    """
    plain = name.replace("\\", "\\\\").replace("'", "\\X\\27")

    def in_hex(signs: re.Match[str]) -> str:
        return f"\\X2\\{signs[0].encode('utf-16-be', 'surrogatepass').hex().upper()}\\X0\\"

    return re.sub("[^ -~]+", in_hex, plain).encode()


@contextmanager
def _own_settings(further: Mapping[str, str] = MappingProxyType({})) -> Iterator[None]:
    """Silence OpenCASCADE and set the format of STEP files in a `with` block.

    The previous settings are restored at the end of the block.
    """
    k, settings = kernel(), {**SETTINGS, **further}
    k.STEPControl_Writer()  # OpenCASCADE defines the settings when it makes the first writer
    before = {name: k.Interface_Static.CVal_s(name) for name in settings}
    messenger = k.Message.DefaultMessenger_s()
    printers = list(messenger.Printers())
    try:
        for printer in printers:
            messenger.RemovePrinter(printer)
        for setting, value in settings.items():
            k.Interface_Static.SetCVal_s(setting, value)
        yield
    finally:
        for setting, value in before.items():
            k.Interface_Static.SetCVal_s(setting, value)
        for printer in printers:
            messenger.AddPrinter(printer)


def _set_name(label: Any, name: str) -> None:
    k = kernel()
    k.TDataStd_Name.Set_s(label, k.TCollection_ExtendedString(name, True))


def write_strip_step(
    strip: Strip, path: str | PathLike[str], *, frame: Frame | None = None, force: bool = False
) -> None:
    """Write a flat and a bent strip to one STEP file.

    The curve of the bent strip is in the plane of `frame`. The sheets of a laminate are separate parts.
    """
    name = strip.label or "strip"
    names, sheets = bent_names(name, strip), bent_sheets(strip)
    frame = frame or Frame()
    bodies = {
        "flat": FlatSolid.layers(strip, frame_beside(strip, frame)),
        "bent": BentSolid.layers(strip, frame),
    }
    # a closed bent strip has a further body, its lap
    parts = [
        NamedShape(f"{called} {form}", make_solid(solid), sheet_color(sheet))
        for form, solids in bodies.items()
        for called, solid, sheet in zip(names, solids, sheets, strict=False)
    ]
    write_step(parts, path, name=name, force=force)


def write_flexure_step(
    part: "Flexure",
    path: str | PathLike[str],
    *,
    state: "State | None" = None,
    name: str | None = None,
    force: bool = False,
) -> None:
    """Write the body of a flexure to a STEP file, unloaded or in one of its two states."""
    name = name or part.label or "flexure"
    shape = NamedShape(name, make_solid(part.solid_in(state)), sheet_color(part.sheet))
    write_step([shape], path, name=name, force=force)


def read_step_drawing(file: Path, *, unit: str | None = None, **_: Any) -> DrawnFile:
    """Return the curves of a STEP or BREP file, and the numbers of other items.

    Edges that belong to a face are ignored.
    """
    chains, skipped = free_chains(read_step_shape(file))
    if not chains:
        left_out = f" (found {list_things(skipped)})" if skipped else ""
        raise InputError(
            "The file has no free edges or wires. Export the curves themselves, not solids or faces."
            + left_out
        )
    scale = look_up_unit(unit or "mm")
    curves = [
        DrawnCurve(
            i,
            partial(_scaled, chain, scale),
            kinds=kinds_of(chain),
            chain=tuple(edge.mapped(scale * np.eye(3), np.zeros(3)) for edge in chain),
            flatten=partial(flatten_run, tolerance=0.0),
        )
        for i, chain in enumerate(chains, start=1)
    ]
    stated = ReadUnit("mm", "assumed" if file.suffix.lower() == ".brep" else "stated", "STEP")
    known = ReadUnit.requested(unit) if unit else stated
    return DrawnFile(file, curves, dict(sorted(skipped.items())), unit=known)


def _scaled(chain: Run, scale: float) -> PlaneCurve:
    curve, _ = place_chain(chain, drawing_plane)
    check_size(scale * curve.control_points)
    return curve if scale == 1.0 else curve.transformed(np.diag([scale, scale, 1.0]))


def read_step_shape(path: Path) -> Shape:
    """Return all shapes in a STEP or BREP file, in mm."""
    kernel()
    try_in_a_copy(lambda: _read_shape(path), path.stat().st_size)
    return _read_shape(path)


def _read_shape(path: Path) -> Shape:
    """Return the shape in a STEP or BREP file."""
    k = kernel()
    if path.suffix.lower() in (".brep", ".brp"):
        shape = k.TopoDS_Shape()
        with path.open("rb") as file:
            begins = file.read(200)
        if b"CASCADE Topology V" not in begins or not k.BRepTools.Read_s(shape, str(path), k.BRep_Builder()):
            raise InputError("OpenCASCADE cannot read this file as BREP. Export it again.")
        return shape
    with _own_settings():
        reader = k.STEPControl_Reader()
        read = reader.ReadFile(str(path)) == k.IFSelect_ReturnStatus.IFSelect_RetDone
        if not (read and reader.TransferRoots()):
            raise InputError("OpenCASCADE cannot read this file as STEP. Export it again.")
        return reader.OneShape()
