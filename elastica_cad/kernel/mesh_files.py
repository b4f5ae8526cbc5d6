"""Bodies as triangles, and the files that hold them: STL for printing, GLB for browsers and phones."""

from collections.abc import Iterator, Sequence
from os import PathLike
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.errors import InputError
from elastica_cad.formats.write_files import write_atomically
from elastica_cad.geometry.frame import Frame
from elastica_cad.kernel.occt import sub_shapes
from elastica_cad.kernel.ocp_import import Shape, bare, kernel
from elastica_cad.kernel.step_files import NamedShape, make_document


def face_triangles(body: Shape, *, chord: float, turn: float) -> Iterator[tuple[FloatArray, IntArray]]:
    """Yield the points (n, 3), mm, of every face and its triangles (m, 3) as numbers of points, anticlockwise from
    outside.

    Parameters
    ----------
    body : Shape
        One kind of mesh is kept with it: a second call with coarser values may find the finer one.
    chord : float
        How far triangles may leave the faces, mm.
    turn : float
        Largest turn from one triangle to the next along an edge, rad.
    """
    k = kernel()
    k.BRepMesh_IncrementalMesh(body, chord, False, turn)
    for face in map(k.as_face, sub_shapes(body, k.TopAbs_ShapeEnum.TopAbs_FACE)):
        place = k.TopLoc_Location()
        net = k.BRep_Tool.Triangulation_s(face, place)
        move = place.Transformation()
        nodes = (net.Node(i).Transformed(move) for i in range(1, net.NbNodes() + 1))
        corners = np.array([net.Triangle(i).Get() for i in range(1, net.NbTriangles() + 1)]) - 1
        if face.Orientation() == k.TopAbs_Orientation.TopAbs_REVERSED:
            corners = corners[:, ::-1]
        yield np.array([(p.X(), p.Y(), p.Z()) for p in nodes]), corners


PRINTED_MM, SHOWN_MM, TURN_RAD = 0.02, 0.2, 0.4
"""How closely triangles follow faces: finer than a printer's layer, or than a screen shows."""

HEADING = b"binary STL, mm".ljust(80)
TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def write_stl(
    body: Shape, path: str | PathLike[str], *, bed: Frame | None = None, force: bool = False
) -> None:
    """Write a body as binary STL, as it lies on the printer's bed.

    Parameters
    ----------
    body : Shape
    path : path-like
    bed : Frame, optional
        The plane that becomes z = 0, its z axis up; the body stays where it is unless given.
    force : bool
        Overwrite a file that exists.

    Raises
    ------
    InputError
        A file that is there already (without `force`), or one that cannot be written.
    """
    bed = bed or Frame()
    nets = face_triangles(body, chord=PRINTED_MM, turn=TURN_RAD)
    corners = np.concatenate([bed.local(points)[triangles] for points, triangles in nets]).astype("<f4")
    # triangles at the pole of a ball have no area, and make programs call the body open
    same = [(corners[:, i] == corners[:, i - 1]).all(axis=1) for i in range(3)]
    corners = corners[~np.any(same, axis=0)]
    rows = np.zeros(len(corners), dtype=TRIANGLE)
    rows["corners"] = corners
    rows["normal"] = _normals(corners)
    content = HEADING + np.uint32(len(rows)).astype("<u4").tobytes() + rows.tobytes()
    write_atomically(path, content, force=force)


def _normals(corners: np.ndarray) -> np.ndarray:
    """Outward, of length one."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    across = np.cross((b - a).astype(float), (c - a).astype(float))
    return np.asarray(across / np.maximum(np.linalg.norm(across, axis=1), 1e-30)[:, None])


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
            raise InputError("OpenCASCADE could not write this model as GLB: check that its parts are valid")
        content = file.read_bytes()
    write_atomically(path, content, force=force)
