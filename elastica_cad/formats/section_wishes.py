"""What a design file says about sections of a surface: which planes cut it, and the curves that come of it."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TypeAlias

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.formats.surfaces import Surface, SurfaceReader
from elastica_cad.formats.tables import Table
from elastica_cad.forming import (
    Section,
    SectionCurve,
    SectionLine,
    parallel_planes,
    planes_along,
    radial_planes,
    section_curves,
)
from elastica_cad.geometry import Frame

__all__ = ["FAMILIES", "sections_of"]

Split: TypeAlias = tuple[str, Callable[[SectionLine], tuple[SectionLine, ...]]]
"""What it splits at, in words, and how."""

SIZES = (1.0, 1e6)
"""mm; what is told to be smaller or larger was told wrongly."""

MOST = 1000
"""Planes."""

NAMED = 6
"""Reasons that a refusal names."""

FAMILIES = ("radial", "parallel", "along")


def sections_of(
    table: Table, folder: Path, read_surface: SurfaceReader
) -> tuple[tuple[SectionCurve, ...], tuple[str, ...]]:
    """Curves of the sections that a table asks for, each in the plane of its own, and what is worth knowing.

    Raises
    ------
    InputError
        A missing surface, planes that make no sense, or no section that a strip could follow.
    MissingDependencyError
        trimesh is not installed, or for CAD bodies no kernel.
    """
    table.only("mesh", "unit", "scale", "half", "longest", "split", "tolerance", "wavelength", *FAMILIES)
    found = [family for family in FAMILIES if table.has(family)]
    if len(found) != 1:
        raise InputError(
            f"{table.where} must hold one of {', '.join(FAMILIES)}: the planes that cut the mesh"
        )
    path = folder / table.text("mesh")
    if not path.is_file():
        raise InputError(f"{table.where}: there is no file {path}; names are relative to the design file")
    scale = table.number("scale", 1.0)
    if not scale > 0:
        raise InputError(f"{table.place('scale')} is {scale:g}: it must be positive")
    # a scale that is given tells the size, so the unit need not be asked for
    unit = table.text("unit", "mm") if table.has("unit") or table.has("scale") else None
    splits = _splits(table)
    with table.naming():
        surface = read_surface(path, unit=unit, scale=scale)
    if not SIZES[0] <= surface.size <= SIZES[1]:
        raise InputError(
            f"{path} measures {surface.size:.3g} mm from corner to corner with this unit and scale: nothing made "
            "of strips does"
        )
    with table.naming():
        planes = _PLANES[found[0]](table.table(found[0]), surface)
        sections = surface.cut(planes, table.flag("half", found[0] == "radial"))
        divided = [_divided(section, table.flag("longest"), splits) for section in sections]
        curves, reports = section_curves(
            [section for section, _ in divided],
            tolerance=table.number("tolerance", 0.3),
            wavelength=table.number("wavelength", 0.0),
        )
    if not curves:
        raise InputError(f"{table.where}: no plane gives a strip: {_reasons(reports)}")
    idle = [name for name, _ in splits if not any(name in used for _, used in divided)]
    return curves, (*reports, *(f"{name} splits no section" for name in idle))


def _reasons(reports: Sequence[str]) -> str:
    """Why sections gave no strip, one after the other."""
    reasons = [text for text in reports if text.startswith("section ")] or list(reports)
    more = f"; and {len(reasons) - NAMED} more like these" if len(reasons) > NAMED else ""
    return "; ".join(reasons[:NAMED]) + more if reasons else "none is given"


def _splits(table: Table) -> list[Split]:
    """Ways to split a line: by a plane through a point, at the places nearest to points in space, at corners."""
    given = table.raw("split", [])
    return [
        _split(cut) for cut in ([table.table("split")] if isinstance(given, dict) else table.tables("split"))
    ]


def _split(cut: Table) -> Split:
    if cut.has("corners"):
        turn = cut.only("corners").number("corners")
        if not 0 < turn < np.pi:
            raise InputError(f"{cut.place('corners')} is {turn:g}: corners turn by an angle between 0 and pi")
        name = f"a turn of more than {np.degrees(turn):.4g} degrees at a corner"
        return name, lambda line: line.split_at_corners(turn)
    if cut.has("points"):
        points = _points(cut.only("points"), "points")
        return "a point", lambda line: line.split_at(line.frame.local(points)[:, :2])
    cut.only("point", "normal")
    point, normal = cut.vector("point", 3, (0.0, 0.0, 0.0)), cut.vector("normal", 3)
    if not any(normal):
        raise InputError(f"{cut.place('normal')} is zero: give a direction of three numbers")
    through, across = (", ".join(f"{v:.4g}" for v in vector) for vector in (point, normal))
    name = f"the plane through ({through}) mm across ({across})"
    return name, lambda line: line.split_by(point, normal)


def _divided(section: Section, longest: bool, splits: Sequence[Split]) -> tuple[Section, frozenset[str]]:
    """The section with the lines that are wanted of it, split where that is asked for; what split any of them."""
    used = set()
    lines, reports = section.lines, section.reports
    if longest and len(lines) > 1:
        reports = (*reports, f"{section.name}: the longest line is kept, {lines[0].length:.4g} mm of it")
        lines = lines[:1]
    for name, split in splits:
        pieces: list[SectionLine] = []
        for line in lines:
            try:
                found = split(line)
            except InputError as problem:
                text = str(problem)
                reports = (*reports, text if text.startswith(line.name) else f"{line.name}: {text}")
                used.add(name)
                continue
            pieces += found
            if found != (line,):
                used.add(name)
        lines = tuple(pieces)
    if not lines:
        used |= {name for name, _ in splits if not section.lines}
    return replace(section, lines=lines, reports=reports), frozenset(used)


def _radial(table: Table, _surface: Surface) -> tuple[Frame, ...]:
    """`angles`, or as many as `count` says all around."""
    table.only("point", "axis", "zero", "count", "angles")
    point, axis = table.vector("point", 3, (0.0, 0.0, 0.0)), table.vector("axis", 3, (0.0, 0.0, 1.0))
    zero = table.vector("zero", 3, (1.0, 0.0, 0.0))
    if table.has("angles"):
        angles = _list(table, "angles")
        _once(table.place("angles"), angles, 2 * np.pi)
        return radial_planes(point, axis, angles, zero=zero)
    count = _count(table)
    return radial_planes(point, axis, 2 * np.pi * np.arange(count) / count, zero=zero)


def _parallel(table: Table, surface: Surface) -> tuple[Frame, ...]:
    """`offsets` from the point, or through the middles of `count` equal slices of the surface."""
    table.only("point", "normal", "offsets", "count", "up")
    point, up = table.vector("point", 3, (0.0, 0.0, 0.0)), table.vector("up", 3, (0.0, 0.0, 1.0))
    normal = table.vector("normal", 3)
    if not table.has("count"):
        given = _list(table, "offsets")
        _once(table.place("offsets"), given)
        return parallel_planes(point, normal, given, up=up)
    if table.has("offsets"):
        raise InputError(f"{table.place('count')} means nothing beside offsets: leave one of them out")
    count = _count(table)
    (first,) = parallel_planes(point, normal, 0.0, up=up)
    away = (surface.points - point) @ first.z_axis
    offsets = away.min() + np.ptp(away) * (np.arange(count) + 0.5) / count
    return parallel_planes(point, normal, offsets, up=up)


def _along(table: Table, _surface: Surface) -> tuple[Frame, ...]:
    table.only("path", "count", "ends", "up")
    up = table.vector("up", 3, (0.0, 0.0, 1.0))
    points = _points(table, "path")
    return planes_along(points, _count(table), ends=table.flag("ends"), up=up)


_PLANES = {"radial": _radial, "parallel": _parallel, "along": _along}


def _once(place: str, values: Sequence[float], period: float = np.inf) -> None:
    """Refuse planes that are given twice."""
    order = np.argsort(np.mod(values, period), kind="stable")
    ring = np.append(order, order[:1]) if np.isfinite(period) else order
    steps = np.diff(np.asarray(values)[ring])
    if np.isfinite(period):
        steps -= period * np.round(steps / period)
    twice = np.flatnonzero(np.abs(steps) <= 1e-9 * max(1.0, float(np.abs(values).max(initial=0.0))))
    if len(values) > 1 and twice.size:
        i, j = sorted((int(ring[twice[0]]), int(ring[twice[0] + 1])))
        raise InputError(f"{place} holds one plane twice, as its numbers {i + 1} and {j + 1}: leave one out")


def _count(table: Table) -> int:
    """How many planes."""
    count = table.count("count", 8)
    if count > MOST:
        raise InputError(f"{table.place('count')} is {count}: {MOST} planes are the most")
    return count


def _points(table: Table, key: str) -> FloatArray:
    """Places in space, however many."""
    rows = table.raw(key)
    if not isinstance(rows, list) or not rows:
        raise InputError(f"{table.place(key)} must be a list of points [x, y, z]")
    return np.array(
        [
            Table({"point": row}, f"{table.place(key)}[{i}]", table.scope).vector("point", 3)
            for i, row in enumerate(rows, start=1)
        ]
    )


def _list(table: Table, key: str) -> tuple[float, ...]:
    """Numbers, however many."""
    rows = table.raw(key)
    if not isinstance(rows, list) or not rows:
        raise InputError(f"{table.place(key)} must be a list of numbers, at least one")
    return table.vector(key, len(rows))
