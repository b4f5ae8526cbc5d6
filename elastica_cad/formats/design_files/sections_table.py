"""What a design file says about sections of a surface: which file, which planes cut it, how it is divided."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from elastica_cad.errors import InputError
from elastica_cad.formats.curve_files.number_gate import LARGEST_NUMBER
from elastica_cad.formats.design_files.keys.strip_keys import STRIP_TABLES
from elastica_cad.formats.design_files.tables import Table
from elastica_cad.formats.surface_files.mesh_files import SurfaceReader, mesh_surface, read_sized_surface
from elastica_cad.forming.plane_sections.section_curves import SectionCurve
from elastica_cad.forming.plane_sections.section_spec import (
    AlongPath,
    CornerSplit,
    Cuts,
    ParallelCuts,
    PlaneSplit,
    PointSplit,
    RadialCuts,
    SectionSpec,
    Split,
)

MANY = LARGEST_NUMBER  # planes: sections say themselves how many they cut
FAMILIES = ("radial", "parallel", "along")


def read_sections(
    table: Table, folder: Path, read_surface: SurfaceReader | None
) -> tuple[tuple[SectionCurve, ...], tuple[str, ...]]:
    """Curves of the sections that a table asks for, each in the plane of its own, and what is worth knowing.

    Raises
    ------
    InputError
        A missing surface, planes that make no sense, or no section that a strip could follow.
    MissingDependencyError
        trimesh is not installed, or for CAD bodies no kernel.
    """
    table.only(*STRIP_TABLES["sections"])
    found = [family for family in FAMILIES if table.has(family)]
    if len(found) != 1:
        raise InputError(
            "{where_} must hold one of {families}: the planes that cut the mesh",
            where_=table.where,
            families=", ".join(FAMILIES),
        )
    path = folder / table.text("mesh")
    if not path.is_file():
        raise InputError(
            "{where_}: there is no file {path}; names are relative to the design file",
            where_=table.where,
            path=path,
        )
    scale = table.maybe("scale")
    if scale is not None and not scale > 0:
        raise InputError("{place} is {scale:g}: it must be positive", place=table.place("scale"), scale=scale)
    family = table.table(found[0]).only(*STRIP_TABLES[found[0]])
    spec = SectionSpec(
        _READERS[found[0]](family),
        half=table.flag("half") if table.has("half") else None,
        longest=table.flag("longest"),
        splits=_splits(table),
        tolerance=table.number("tolerance", 0.3),
        wavelength=table.number("wavelength", 0.0),
    )
    unit = table.text("unit") if table.has("unit") else None
    with table.naming():
        return spec.curves(read_sized_surface(read_surface or mesh_surface, path, unit=unit, scale=scale))


def _splits(table: Table) -> tuple[Split, ...]:
    """Ways to split a line: by a plane through a point, at the places nearest to points in space, at corners."""
    given = table.raw("split", [])
    tables = [table.table("split")] if isinstance(given, dict) else table.tables("split")
    return tuple(_split(cut) for cut in tables)


def _split(cut: Table) -> Split:
    with cut.naming():
        if cut.has("corners"):
            return CornerSplit(cut.only(*STRIP_TABLES["split corners"]).number("corners"))
        if cut.has("points"):
            return PointSplit(np.array(cut.only(*STRIP_TABLES["split points"]).points("points", 3)))
        cut.only(*STRIP_TABLES["split plane"])
        return PlaneSplit(_triple(cut, "normal"), _triple(cut, "point", (0.0, 0.0, 0.0)))


def _radial(table: Table) -> RadialCuts:
    """`angles`, or as many as `count` says all around."""
    if table.has("count") and table.has("angles"):
        raise InputError(
            "{place} means nothing beside angles: leave one of them out", place=table.place("count")
        )
    given: dict[str, Any] = {key: _triple(table, key) for key in ("point", "axis", "zero") if table.has(key)}
    angles = _list(table, "angles") if table.has("angles") else None
    return RadialCuts(table.count("count", RadialCuts.count, MANY), angles, **given)


def _parallel(table: Table) -> ParallelCuts:
    """`offsets` from the point, or through the middles of `count` equal slices of the surface."""
    if table.has("count") and table.has("offsets"):
        raise InputError(
            "{place} means nothing beside offsets: leave one of them out", place=table.place("count")
        )
    given: dict[str, Any] = {key: _triple(table, key) for key in ("point", "up") if table.has(key)}
    offsets = None if table.has("count") else _list(table, "offsets")
    return ParallelCuts(_triple(table, "normal"), table.count("count", 1, MANY), offsets, **given)


def _along(table: Table) -> AlongPath:
    count, up = table.count("count", AlongPath.count, MANY), _triple(table, "up", AlongPath.up)
    return AlongPath(np.array(table.points("path", 3)), count, table.flag("ends"), up)


_READERS: dict[str, Callable[[Table], Cuts]] = {"radial": _radial, "parallel": _parallel, "along": _along}


def _triple(
    table: Table, key: str, default: tuple[float, float, float] | None = None
) -> tuple[float, float, float]:
    x, y, z = table.vector(key, 3, default)
    return x, y, z


def _list(table: Table, key: str) -> tuple[float, ...]:
    """Numbers, however many."""
    rows = table.raw(key)
    if not isinstance(rows, list) or not rows:
        raise InputError("{key} must be a list of numbers, at least one", key=table.place(key))
    return table.vector(key, len(rows))
