"""Triangle meshes of bodies, and writers of STL files for printing and GLB files for browsers and phones."""

from collections.abc import Iterator, Sequence
from os import PathLike
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.errors import InputError
from elastica_cad.formats.write_files import write_atomically
from elastica_cad.geometry.frame import Frame
from elastica_cad.kernel.flexure_body import FlexureBody
from elastica_cad.kernel.occt import coordinates, sub_shapes
from elastica_cad.kernel.ocp_import import Shape, bare, kernel
from elastica_cad.kernel.step_files import NamedShape, make_document, write_step
from elastica_cad.kernel.strip_body import StripBody, color_numbers


def face_triangles(body: Shape, *, chord: float, turn: float) -> Iterator[tuple[FloatArray, IntArray]]:
    """Yield points (n, 3), mm, and triangles (m, 3) of each face of a body.

    A triangle consists of three indices of points, anticlockwise as seen from outside.

    Parameters
    ----------
    body : Shape
        Body to mesh. OpenCASCADE stores the mesh in the body, so a later call with larger tolerances may
        return the finer mesh.
    chord : float
        Largest distance of triangles from the faces, mm.
    turn : float
        Largest angle between successive segments of an edge, rad.
    """
    k = kernel()
    k.BRepMesh_IncrementalMesh(body, chord, False, turn)
    for face in sub_shapes(body, "face"):
        place = k.TopLoc_Location()
        net = k.BRep_Tool.Triangulation_s(face, place)
        move = place.Transformation()
        nodes = [coordinates(net.Node(i).Transformed(move)) for i in range(1, net.NbNodes() + 1)]
        corners = np.array([net.Triangle(i).Get() for i in range(1, net.NbTriangles() + 1)]) - 1
        if face.Orientation() == k.TopAbs_Orientation.TopAbs_REVERSED:
            corners = corners[:, ::-1]
        yield np.array(nodes), corners


PRINTED_MM, SHOWN_MM, TURN_RAD = 0.02, 0.2, 0.4
"""Largest distance of triangles from faces, mm, for printing and for display, and largest angle between
successive segments of an edge, rad."""

# record of a triangle in a binary STL file
TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def write_body(body: StripBody | FlexureBody, path: str | PathLike[str], *, force: bool = False) -> None:
    """Write a body of a CAD library at its position to a STEP, STL or GLB file, as the suffix of `path` states."""
    suffix = Path(path).suffix.lower()
    if suffix == ".stl":
        write_stl(body.wrapped, path, force=force)
        return
    parts = [NamedShape(part.label, part.wrapped, color_numbers(part.color)) for part in body._named_parts()]
    write = write_glb if suffix == ".glb" else write_step
    write(parts, path, name=body.label, force=force)


def write_stl(
    body: Shape, path: str | PathLike[str], *, bed: Frame | None = None, force: bool = False
) -> None:
    """Write a body to a binary STL file, optionally placed on the printer bed.

    Parameters
    ----------
    body : Shape
    path : path-like
    bed : Frame, optional
        Plane that becomes z = 0, with its z axis upward. By default the body is not moved.
    """
    bed = bed or Frame()
    nets = face_triangles(body, chord=PRINTED_MM, turn=TURN_RAD)
    corners = np.concatenate([bed.local(points)[triangles] for points, triangles in nets]).astype("<f4")
    # omit triangles without area, as at the pole of a sphere, because programs would report an open body
    corners = corners[(corners != np.roll(corners, 1, axis=1)).any(axis=2).all(axis=1)]
    a, b, c = corners.swapaxes(0, 1)
    across = np.cross((b - a).astype(float), (c - a).astype(float))
    rows = np.zeros(len(corners), dtype=TRIANGLE)
    rows["corners"] = corners
    rows["normal"] = across / np.maximum(np.linalg.norm(across, axis=1), 1e-30)[:, None]
    count = np.uint32(len(rows)).astype("<u4")
    write_atomically(path, b"binary STL, mm".ljust(80) + count.tobytes() + rows.tobytes(), force=force)


def write_glb(
    parts: Sequence[NamedShape], path: str | PathLike[str], *, name: str, force: bool = False
) -> None:
    """Write parts with their positions, names and colours to a GLB file, in metres and with y upward."""
    k = kernel()
    for part in parts:
        k.BRepMesh_IncrementalMesh(bare(part.shape), SHOWN_MM, False, TURN_RAD, True)
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
            raise InputError("OpenCASCADE could not write this model as GLB. Check that its parts are valid.")
        content = file.read_bytes()
    write_atomically(path, content, force=force)
