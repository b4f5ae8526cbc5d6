"""Reader of surfaces in files; triangle meshes (OBJ, STL, PLY) are read by trimesh."""

from collections.abc import Callable
from io import BytesIO
from pathlib import Path
from typing import TypeAlias

import numpy as np

from elastica_cad._process import interrupts_held
from elastica_cad._units import look_up_unit
from elastica_cad.errors import InputError, Length, missing_library
from elastica_cad.form_finding.plane_sections import Mesh, mesh_sections
from elastica_cad.form_finding.section_spec import Surface
from elastica_cad.formats.source_file import MESH_SUFFIXES, name_source, quiet_log, require_file

LIKELY_SIZES_MM = (50.0, 20000.0)
"""Range of likely sizes (diagonals of the bounding box), mm, of a model made of strips."""


def read_mesh(path: str | Path, *, unit: str | None = None, scale: float = 1.0) -> Mesh:
    """Read the triangles of a mesh file, in mm. Larger faces are cut into triangles.

    Parameters
    ----------
    path : path-like
        .obj, .stl or .ply.
    unit : str, optional
        Unit of the file: "mm", "cm", "m", "um", "in", "ft". These formats do not contain a unit. By default it is
        mm, and unlikely sizes are refused.
    scale : float
        Factor by which the model is larger than the object in the file, in addition to the unit.

    Raises
    ------
    MissingDependencyError
        trimesh is not installed.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     file = Path(folder, "tent.obj")
    ...     _ = file.write_text("v 0 0 0\\nv 9 0 0\\nv 9 9 5\\nv 0 9 5\\nf 1 2 3 4\\n")
    ...     read_mesh(file, unit="cm").faces.shape
    (2, 3)
    """
    path = require_file(path)
    suffix = path.suffix.lower()
    if suffix not in MESH_SUFFIXES:
        raise InputError(
            "{path} ends in {suffix!r}, but mesh files end in {mesh_suffixes}: export the mesh to such a file",
            path=path,
            suffix=suffix,
            mesh_suffixes=", ".join(MESH_SUFFIXES),
        )
    if not (np.isfinite(scale) and scale > 0):
        raise InputError("the scale of {path} is {scale:g}: set a number above 0", path=path, scale=scale)
    factor = look_up_unit(unit or "mm") * scale
    try:
        with interrupts_held():
            from trimesh import load
    except ImportError as error:
        raise missing_library(f"reading {path.name} needs trimesh", "trimesh") from error
    with name_source(path):
        try:
            with quiet_log("trimesh"), np.errstate(all="ignore"):
                source = _obj_with_positive_indices(path.read_bytes()) if suffix == ".obj" else path
                mesh = load(source, file_type=suffix[1:], force="mesh", process=False)
            vertices, faces = np.array(mesh.vertices, dtype=float), np.array(mesh.faces, dtype=int)
        except Exception as error:  # the parsers of trimesh raise exceptions of many kinds
            raise InputError(
                "is not a readable {upper} mesh: export the mesh again", upper=suffix[1:].upper()
            ) from error
        if not len(faces):
            raise InputError("has no faces: export a mesh, not points or lines")
        model = Mesh(vertices * factor, faces)
        if unit is None and not LIKELY_SIZES_MM[0] <= model.size <= LIKELY_SIZES_MM[1]:
            guesses = {name: model.size * look_up_unit(name) for name in ("um", "cm", "in", "m")}
            likely = [
                name for name, long in guesses.items() if LIKELY_SIZES_MM[0] <= long <= LIKELY_SIZES_MM[1]
            ]
            hint = f" ({', '.join(f'{name}: {guesses[name]:.4g} mm' for name in likely)})" if likely else ""
            likely_unit = likely[-1] if likely else "m"
            raise InputError(
                "is {size:.3g} from corner to corner, an unlikely size in mm, and a mesh file has no unit: set the "
                "unit, such as --unit {unit} or unit = \"{unit}\"{hint}, or mm if the size is right",
                size=model.size, unit=likely_unit, hint=hint,
            )  # fmt: skip
        return model


# lists of an OBJ file, with the place of their index in the corner of a face, such as 3/1/2
_OBJ_LISTS = {b"v": 0, b"vt": 1, b"vn": 2}


def _obj_with_positive_indices(data: bytes) -> BytesIO:
    """Return the OBJ file with positive indices only, because trimesh misreads negative indices.

    A negative index counts back from its own line, but trimesh counts back from the end of the file.
    """
    counts = [0, 0, 0]  # entries of each list before the line
    lines = []
    for line in data.splitlines():
        kind, *corners = line.split() or (b"",)
        if kind in _OBJ_LISTS:
            counts[_OBJ_LISTS[kind]] += 1
        elif kind == b"f":
            corners = [
                b"/".join(
                    b"%d" % (count + 1 + int(index)) if index.startswith(b"-") else index
                    for index, count in zip(corner.split(b"/"), counts, strict=False)
                )
                for corner in corners
            ]
        lines.append(b" ".join([kind, *corners]))
    return BytesIO(b"\n".join(lines))


LEAST_SIZE_MM, MOST_SIZE_MM = 1.0, 1e6
"""Range of sizes, mm, of a surface. A size outside this range means that the unit is wrong."""


SurfaceReader: TypeAlias = Callable[..., Surface]
"""Function that reads a surface: `read_surface(path, unit=..., scale=...)`."""


def mesh_surface(path: str | Path, *, unit: str | None = None, scale: float = 1.0) -> Surface:
    """Read a mesh file as a surface that planes can cut; see `read_mesh`."""
    mesh = read_mesh(path, unit=unit, scale=scale)
    return Surface(
        mesh.vertices, lambda planes, half: mesh_sections(mesh.vertices, mesh.faces, planes, half=half)
    )


def read_sized_surface(
    read_surface: SurfaceReader, path: Path, *, unit: str | None = None, scale: float | None = None
) -> Surface:
    """Read a surface from a file, in mm. `unit` is not needed if `scale` is given."""
    unit = "mm" if unit is None and scale is not None else unit
    surface = read_surface(path, unit=unit, scale=1.0 if scale is None else scale)
    if not LEAST_SIZE_MM <= surface.size <= MOST_SIZE_MM:
        raise InputError(
            "{path} is {size} from corner to corner with this unit and scale, too small or too large for "
            "strips: check the unit",
            path=path,
            size=Length(surface.size),
        )
    return surface
