"""A surface in a file, whatever its kind: what is asked of it is points of it and its sections."""

from collections.abc import Callable
from pathlib import Path
from typing import TypeAlias

from elastica_cad.errors import InputError
from elastica_cad.formats.surface_files.mesh_files import read_mesh
from elastica_cad.forming.plane_sections.mesh_sections import mesh_sections
from elastica_cad.forming.plane_sections.section_spec import Surface

LEAST_SIZE_MM, MOST_SIZE_MM = 1.0, 1e6
"""What is told to be smaller or larger was told in a wrong unit."""


SurfaceReader: TypeAlias = Callable[..., Surface]
"""`read_surface(path, unit=..., scale=...)`."""


def mesh_surface(path: str | Path, *, unit: str | None = None, scale: float = 1.0) -> Surface:
    """The surface of a mesh file; see `read_mesh`."""
    mesh = read_mesh(path, unit=unit, scale=scale)
    return Surface(
        mesh.vertices, lambda planes, half: mesh_sections(mesh.vertices, mesh.faces, planes, half=half)
    )


def read_sized_surface(
    read_surface: SurfaceReader, path: Path, *, unit: str | None = None, scale: float | None = None
) -> Surface:
    """The surface of a file in mm; a scale tells the size, so that the unit need not be told too.

    Raises
    ------
    InputError
        A surface of a size that nothing made of strips has, and as `read_surface`.
    """
    unit = "mm" if unit is None and scale is not None else unit
    surface = read_surface(path, unit=unit, scale=1.0 if scale is None else scale)
    if not LEAST_SIZE_MM <= surface.size <= MOST_SIZE_MM:
        raise InputError(
            f"{path} measures {surface.size:.3g} mm from corner to corner with this unit and scale: nothing made "
            "of strips does"
        )
    return surface
