"""Tables that say what a rod is to bear and to keep: supports, loads, limits, its shape before it is bent."""

from typing import Any

from elastica_cad.errors import InputError, quoted
from elastica_cad.formats.design_files.keys.strip_keys import STRIP_TABLES
from elastica_cad.formats.design_files.tables import Table
from elastica_cad.forming.limits import Box, HalfPlane, Keep, Limits
from elastica_cad.mechanics.loads.rest_curvature import RestCurvature
from elastica_cad.mechanics.loads.supports import Supports
from elastica_cad.mechanics.loads.weight import PointMass, Weight
from elastica_cad.mechanics.material.sheet import Sheet

BLANK_LINE = "stations = [0, 300], curvatures = [0, 0.01]"
"""What a refused line is told to look like."""


def read_supports(table: Table) -> Supports:
    """What holds the two ends, by their names."""
    given = table.raw("supports", ["clamped", "clamped"])
    if not isinstance(given, list) or len(given) != 2:
        raise InputError(
            '{place} is {given}: name two, e.g. ["clamped", "pinned"]',
            place=table.place("supports"),
            given=quoted(given),
        )
    with table.naming("supports"):
        return Supports(*given)


def read_loads(table: Table) -> tuple[PointMass, ...] | Weight:
    """Masses in a list, or the table of a `Weight` with its masses."""
    if not isinstance(table.raw("loads", []), dict):
        return tuple(read_mass(one) for one in table.tables("loads"))
    given = table.table("loads").only(*STRIP_TABLES["loads"])
    with given.naming():
        return Weight(
            alpha=given.number("alpha", 0.0),
            beta=given.number("beta", 0.0),
            masses=tuple(read_mass(one) for one in given.tables("masses")),
            own=given.flag("own"),
        )


def read_mass(table: Table) -> PointMass:
    """A mass in g hung at a place along the strip, mm."""
    table.only(*STRIP_TABLES["mass"])
    with table.naming():
        return PointMass(table.number("at"), table.number("mass"))


def read_limits(table: Table, sheet: Sheet) -> Limits:
    """Limits of the rod; `strain` is true for what the sheet bears, or a number."""
    table.only(*STRIP_TABLES["limits"])
    keep_strain = table.raw("strain", False)
    ranges: dict[str, Any] = {key: table.vector(key, 2) for key in ("length", "width") if table.has(key)}
    bounds = table.table("stiffness_bounds") if table.has("stiffness_bounds") else None
    with table.naming():
        return Limits(
            ratio=table.maybe("ratio"),
            margin=table.maybe("margin"),
            curvature=table.maybe("curvature"),
            sheet=sheet if keep_strain else None,
            strain=None if isinstance(keep_strain, bool) else table.number("strain"),
            keep_out=tuple(read_keep_out(one) for one in table.tables("keep_out")),
            stiffness_bounds=None if bounds is None else read_stiffness_bounds(bounds),
            **ranges,
        )


def read_keep_out(table: Table) -> HalfPlane | Box:
    """Ground or a wall from `point` and `normal`, or a box from `lower` and `upper` corner."""
    wall, box = STRIP_TABLES["half plane"], STRIP_TABLES["box"]
    table.only(*wall, *box)
    with table.naming():
        if table.has("lower") or table.has("upper"):
            table.only(*box)
            return Box(table.pair("lower"), table.pair("upper"))
        return HalfPlane(table.pair("point", (0.0, 0.0)), table.pair("normal", (0.0, 1.0)))


def read_stiffness_bounds(table: Table) -> tuple[Any, Any]:
    """`lower` and `upper` bound of K / min K along the strip: a number, values at equal distances, or none."""
    table.only(*STRIP_TABLES["stiffness bounds"])
    return _bound(table, "lower"), _bound(table, "upper")


def _bound(table: Table, key: str) -> float | tuple[float, ...] | None:
    given = table.raw(key)
    return table.vector(key, len(given)) if isinstance(given, list) else table.maybe(key)


def read_keep(table: Table) -> Keep:
    """What the nearest rod keeps of the drawn curve."""
    table.only(*STRIP_TABLES["keep"])
    symmetry: Any = table.text("symmetry", choices=("mirror", "turn")) if table.has("symmetry") else None
    points = table.raw("points", [])
    line: Any = table.raw("line")
    if isinstance(line, list):
        line = tuple(table.points("line", 2, 2))
    with table.naming():
        return Keep(
            ends=_read_both_ends(table, "ends", True),
            tangents=_read_both_ends(table, "tangents", False),
            length=table.flag("length"),
            symmetry=symmetry,
            points=table.vector("points", len(points), ()) if isinstance(points, list) else points,
            line=line,
        )


def _read_both_ends(table: Table, key: str, default: bool) -> bool | tuple[bool, bool]:
    """True or false for both ends, or a pair for start and end."""
    given = table.raw(key, default)
    return tuple(given) if isinstance(given, list) else table.flag(key, default)


def read_rest_curvature(table: Table) -> RestCurvature:
    """The curvature of a blank before it is bent, straight between stations."""
    table.only(*STRIP_TABLES["blank"])
    columns = []
    for key in STRIP_TABLES["blank"]:
        row = table.raw(key)
        if not isinstance(row, list) or not row:
            raise InputError(
                "{key} is {row}: give a list of numbers, as many of each",
                key=table.place(key),
                row=quoted(row),
            )
        columns.append(table.vector(key, len(row)))
    with table.naming():
        return RestCurvature.linear(*columns)
