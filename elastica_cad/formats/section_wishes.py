"""What a design file says about sections of a mesh: which planes cut it, and the curves that come of it."""

from pathlib import Path

import numpy as np

from elastica_cad.errors import InputError
from elastica_cad.formats.meshes import read_mesh
from elastica_cad.formats.tables import Table
from elastica_cad.forming import (
    SectionCurve,
    mesh_sections,
    parallel_planes,
    planes_along,
    radial_planes,
    section_curves,
)
from elastica_cad.geometry import Frame

__all__ = ["sections_of"]

FAMILIES = ("radial", "parallel", "along")


def sections_of(table: Table, folder: Path) -> tuple[tuple[SectionCurve, ...], tuple[str, ...]]:
    """Curves of the sections that a table asks for, each in the plane of its own, and what is worth knowing.

    Raises
    ------
    InputError
        A missing mesh, planes that make no sense, or no section that a strip could follow.
    MissingDependencyError
        trimesh is not installed.
    """
    table.only("mesh", "unit", "scale", "half", "tolerance", "wavelength", *FAMILIES)
    found = [family for family in FAMILIES if table.has(family)]
    if len(found) != 1:
        raise InputError(
            f"{table.where} must hold one of {', '.join(FAMILIES)}: the planes that cut the mesh"
        )
    path = folder / table.text("mesh")
    if not path.is_file():
        raise InputError(f"{table.where}: there is no file {path}; names are relative to the design file")
    mesh = read_mesh(path, unit=table.text("unit") if table.has("unit") else None)
    scale = table.number("scale", 1.0)
    if not scale > 0:
        raise InputError(f"{table.place('scale')} is {scale:g}: it must be positive")
    with table.naming():
        planes = _PLANES[found[0]](table.table(found[0]))
    scaled = mesh.scaled(scale)
    sections = mesh_sections(
        scaled.vertices, scaled.faces, planes, half=table.flag("half", found[0] == "radial")
    )
    curves, reports = section_curves(
        sections, tolerance=table.number("tolerance", 0.3), wavelength=table.number("wavelength", 0.0)
    )
    if not curves:
        raise InputError(
            f"{table.where}: no plane gives a strip: {reports[0] if reports else 'none is given'}"
        )
    return curves, reports


def _radial(table: Table) -> tuple[Frame, ...]:
    """`angles`, or as many as `count` says all around."""
    table.only("point", "axis", "zero", "count", "angles")
    point, axis = table.vector("point", 3, (0.0, 0.0, 0.0)), table.vector("axis", 3, (0.0, 0.0, 1.0))
    zero = table.vector("zero", 3, (1.0, 0.0, 0.0))
    if table.has("angles"):
        return radial_planes(point, axis, _list(table, "angles"), zero=zero)
    count = table.count("count", 8)
    return radial_planes(point, axis, 2 * np.pi * np.arange(count) / count, zero=zero)


def _parallel(table: Table) -> tuple[Frame, ...]:
    table.only("point", "normal", "offsets", "up")
    point, up = table.vector("point", 3, (0.0, 0.0, 0.0)), table.vector("up", 3, (0.0, 0.0, 1.0))
    return parallel_planes(point, table.vector("normal", 3), _list(table, "offsets"), up=up)


def _along(table: Table) -> tuple[Frame, ...]:
    table.only("path", "count", "ends", "up")
    rows = table.raw("path")
    if not isinstance(rows, list):
        raise InputError(f"{table.place('path')} must be a list of points [x, y, z]")
    points = [
        Table({"point": row}, f"{table.place('path')}[{i}]", table.scope).vector("point", 3)
        for i, row in enumerate(rows, start=1)
    ]
    up = table.vector("up", 3, (0.0, 0.0, 1.0))
    return planes_along(points, table.count("count", 8), ends=table.flag("ends"), up=up)


_PLANES = {"radial": _radial, "parallel": _parallel, "along": _along}


def _list(table: Table, key: str) -> tuple[float, ...]:
    """Numbers, however many."""
    rows = table.raw(key)
    if not isinstance(rows, list) or not rows:
        raise InputError(f"{table.place(key)} must be a list of numbers, at least one")
    return table.vector(key, len(rows))
