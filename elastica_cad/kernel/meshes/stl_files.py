"""STL files, which every slicer reads: a body in triangles, mm."""

from os import PathLike

import numpy as np

from elastica_cad.formats.file_access.write_files import write_atomically
from elastica_cad.geometry.frame import Frame
from elastica_cad.kernel.meshes.face_triangles import face_triangles
from elastica_cad.kernel.ocp_import import Shape

CHORD_MM, TURN_RAD = 0.02, 0.4
"""How closely triangles follow faces: finer than a printer's layer."""

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
    nets = face_triangles(body, chord=CHORD_MM, turn=TURN_RAD)
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
