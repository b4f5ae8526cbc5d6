"""GLB files, which browsers, phones and Blender show: models written by OpenCASCADE's own exporter."""

from collections.abc import Sequence
from os import PathLike
from pathlib import Path
from tempfile import TemporaryDirectory

from elastica_cad.errors import InputError
from elastica_cad.formats.file_access.write_files import write_atomically
from elastica_cad.kernel.ocp_import import bare, kernel
from elastica_cad.kernel.step_files import NamedShape, make_document

CHORD_MM, TURN_RAD = 0.2, 0.4
"""How closely triangles follow faces: finer than a screen shows."""


def write_glb(
    parts: Sequence[NamedShape], path: str | PathLike[str], *, name: str, force: bool = False
) -> None:
    """Write parts, each in its place, to one GLB file called `name`: m, y up, named and coloured.

    Raises
    ------
    InputError
        A file that is there already (without `force`), or one that cannot be written.
    """
    k = kernel()
    for part in parts:
        k.BRepMesh_IncrementalMesh(bare(part.shape), CHORD_MM, False, TURN_RAD, True)
    document = make_document(parts, name=name)
    with TemporaryDirectory(prefix="elastica-") as folder:
        file = Path(folder, "model.glb")
        writer = k.RWGltf_CafWriter(k.TCollection_AsciiString(str(file)), True)
        converter = writer.ChangeCoordinateSystemConverter()
        converter.SetInputLengthUnit(0.001)
        converter.SetInputCoordinateSystem(k.RWMesh_CoordinateSystem.RWMesh_CoordinateSystem_Zup)
        converter.SetOutputLengthUnit(1.0)
        converter.SetOutputCoordinateSystem(k.RWMesh_CoordinateSystem.RWMesh_CoordinateSystem_glTF)
        about = k.Remarks()
        if not writer.Perform(document, about, k.Message_ProgressRange()):
            raise InputError("OpenCASCADE could not write this model as GLB: check that its parts are valid")
        content = file.read_bytes()
    write_atomically(path, content, force=force)
