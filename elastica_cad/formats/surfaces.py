"""A surface in a file, whatever its kind: what is asked of it is points of it and its sections."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TypeAlias

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.formats.meshes import read_mesh
from elastica_cad.forming import Section, mesh_sections
from elastica_cad.geometry import Frame

__all__ = ["Surface", "SurfaceReader", "mesh_surface"]


@dataclass(frozen=True, eq=False)
class Surface:
    """A surface that can be cut by planes.

    Attributes
    ----------
    points : (n, 3) array
        Places whose hull holds it, mm: the vertices of a mesh, the corners of a box around a CAD body.
    cut : callable
        Its sections by planes, with half planes if the second argument is true: `cut(planes, half)`.
    """

    points: FloatArray
    cut: Callable[[Sequence[Frame], bool], tuple[Section, ...]]

    @property
    def middle(self) -> FloatArray:
        """Middle (3,) of the box around it, mm."""
        return np.asarray((self.points.min(axis=0) + self.points.max(axis=0)) / 2)

    @property
    def size(self) -> float:
        """Diagonal of the box around it, mm."""
        return float(np.linalg.norm(np.ptp(self.points, axis=0)))


SurfaceReader: TypeAlias = Callable[..., Surface]
"""`read_surface(path, unit=..., scale=...)`."""


def mesh_surface(path: str | Path, *, unit: str | None = None, scale: float = 1.0) -> Surface:
    """The surface of a mesh file; see `read_mesh`."""
    mesh = read_mesh(path, unit=unit, scale=scale)
    return Surface(
        mesh.vertices, lambda planes, half: mesh_sections(mesh.vertices, mesh.faces, planes, half=half)
    )
