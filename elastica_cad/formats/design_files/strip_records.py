"""Tables that say how one strip is made: limits, style, ends, slots, loads; of a design file or of one line."""

import tomllib
from collections.abc import Callable, Sequence
from typing import Any, TypeVar

from elastica_cad.errors import InputError, quoted
from elastica_cad.fabrication.makeability.shop import Shop
from elastica_cad.fabrication.slots.slot import Slot
from elastica_cad.fabrication.strip.lamination import Laminated
from elastica_cad.fabrication.strip.perforation import Perforated
from elastica_cad.fabrication.strip.styles import Plain, Style
from elastica_cad.fabrication.strip.tabs import Hole, Tab, TSlot
from elastica_cad.formats.design_files.keys.strip_keys import STRIP_TABLES
from elastica_cad.formats.design_files.keys.values import COUNT, NUMBER
from elastica_cad.formats.design_files.tables import Table
from elastica_cad.forming.limits import Box, HalfPlane, Keep, Limits
from elastica_cad.mechanics.loads.rest_curvature import RestCurvature
from elastica_cad.mechanics.loads.supports import Supports
from elastica_cad.mechanics.loads.weight import PointMass, Weight
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.material.stiffness_law import BoundedLaw
from elastica_cad.mechanics.material.tapered_sections import LeavesLaw, RoundLaw, ThicknessLaw

T = TypeVar("T")


LAW_LINE = 'kind = "thickness", limits = [3, 8], width = 20'
BLANK_LINE = "stations = [0, 300], curvatures = [0, 0.01]"
"""What a refused line is told to look like."""


def parse_line(
    line: str, where: str, reader: Callable[[Table], T], *, example: str = "at = 40, side = 'lower'"
) -> T:
    """What one line tells, written as the inside of a table of a design file: `at = 40, width = 1.2`.

    Parameters
    ----------
    example : str
        What a line that cannot be read is told to look like.

    Raises
    ------
    InputError
        A line that is no such table, or what `reader` refuses; it names `where` the line stands.

    Examples
    --------
    >>> parse_line("at = 40, width = 1.2, side = 'lower'", "--slot", read_slot).side
    'lower'
    """
    inside = line.strip()
    try:
        data = tomllib.loads(f"line = {inside}" if inside.startswith("{") else f"line = {{{inside}}}")
    except tomllib.TOMLDecodeError as error:
        raise InputError(
            f"{where}: {line!r} cannot be read: write keys and values, such as {example}"
        ) from error
    table = Table(data["line"], where, {})
    with table.naming():
        return reader(table)


def parse_lines(lines: Sequence[str], where: str, reader: Callable[[Table], T]) -> tuple[T, ...]:
    """What every line tells that is not empty."""
    return tuple(parse_line(line, where, reader) for line in lines if line.strip())


def find_sheet(table: Table, key: str, sheets: dict[str, Sheet]) -> Sheet:
    """One of the design's own sheets, or a built-in one."""
    if not table.has(key):
        raise InputError(f'{table.place(key)} is missing; name a sheet, e.g. sheet = "birch-plywood-0.8"')
    name = table.text(key)
    with table.naming(key):
        found = sheets[name] if name in sheets else Sheet.named(name)
        thickness = table.maybe("thickness") if key == "sheet" else None
        return found if thickness is None else found.with_thickness(thickness)


def read_supports(table: Table) -> Supports:
    """What holds the two ends, by their names."""
    given = table.raw("supports", ["clamped", "clamped"])
    if not isinstance(given, list) or len(given) != 2:
        raise InputError(
            f'{table.place("supports")} is {quoted(given)}: name two, e.g. ["clamped", "pinned"]'
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


def read_shop(table: Table) -> Shop:
    """What the workshop can make."""
    widths = ("least_width", "least_ligament", "least_bridge", "lap")
    table.only(*STRIP_TABLES["shop"])
    given: dict[str, Any] = {**table.numbers(*widths)}
    if table.has("stock"):
        given["stock"] = table.vector("stock", 2)
    with table.naming():
        return Shop(**given)


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
            return Box(_pair(table, "lower"), _pair(table, "upper"))
        return HalfPlane(_pair(table, "point", (0.0, 0.0)), _pair(table, "normal", (0.0, 1.0)))


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


def read_tabs(table: Table) -> tuple[Tab, Tab]:
    """One table for both ends, or a list of two."""
    given = table.raw("ends", {})
    if isinstance(given, list):
        if len(given) != 2:
            raise InputError(
                f"{table.place('ends')} lists {len(given)} tabs: give one table, or two in a list"
            )
        start, end = table.tables("ends")
        return read_tab(start), read_tab(end)
    tab = read_tab(table.table("ends"))
    return tab, tab


def read_tab(table: Table) -> Tab:
    """The tab of one end."""
    table.only(*STRIP_TABLES["tab"])
    holes = tuple(
        Hole(hole.number("at"), hole.number("diameter"), hole.number("across", 0.0))
        for hole in (one.only(*STRIP_TABLES["hole"]) for one in table.tables("holes"))
    )
    sizes = {key: table.number(key, 0.0) for key in ("corner_radius", "chamfer", "taper")}
    with table.naming():
        t_slot = _read_t_slot(table.table("t_slot")) if table.has("t_slot") else None
        return Tab(table.number("length", 10.0), table.maybe("width"), holes=holes, t_slot=t_slot, **sizes)


def _read_t_slot(table: Table) -> TSlot:
    table.only(*STRIP_TABLES["t-slot"])
    return TSlot(
        table.number("depth"),
        table.number("screw", TSlot.screw),
        _pair(table, "nut", TSlot.nut),
        table.number("wall", TSlot.wall),
    )


def read_style(table: Table, sheets: dict[str, Sheet]) -> Style:
    """Plain, perforated or laminated."""
    kind = table.text("kind", "plain", ("plain", "perforated", "laminated"))
    with table.naming():
        if kind == "perforated":
            return Perforated(**_sizes(table, kind))
        if kind == "laminated":
            return Laminated(**_sizes(table, kind), backing=find_sheet(table, "backing", sheets))
    table.only(*STRIP_TABLES["style plain"])
    return Plain()


def read_law(table: Table, sheet: Sheet) -> BoundedLaw:
    """What stiffness is made of: kind = "thickness", "rod" or "tube", with limits in mm, or "leaves"."""
    kind = table.text("kind", "", ("thickness", "rod", "tube", "leaves"))
    table.only(*STRIP_TABLES[f"law {kind}"])
    if kind == "leaves":
        most, width = int(table.number("leaves")), table.number("width")
        with table.naming():
            return LeavesLaw(sheet, table.count("leaves", most), width, table.count("fewest", 1))
    least, largest = table.vector("limits", 2)
    with table.naming():
        if kind == "thickness":
            return ThicknessLaw(sheet, least, largest, width=table.number("width"))
        return RoundLaw(sheet, least, largest, bore=table.number("bore") if kind == "tube" else 0.0)


def read_rest_curvature(table: Table) -> RestCurvature:
    """The curvature of a blank before it is bent, straight between stations."""
    table.only(*STRIP_TABLES["blank"])
    columns = []
    for key in STRIP_TABLES["blank"]:
        row = table.raw(key)
        if not isinstance(row, list) or not row:
            raise InputError(f"{table.place(key)} is {quoted(row)}: give a list of numbers, as many of each")
        columns.append(table.vector(key, len(row)))
    with table.naming():
        return RestCurvature.linear(*columns)


def _sizes(table: Table, kind: str) -> dict[str, Any]:
    """The fields of a style that are given: whole numbers, words and numbers, as its keys say."""
    keys = STRIP_TABLES[f"style {kind}"]
    table.only(*keys)
    chosen: dict[str, Any] = {"width": table.number("width")}
    for name, (value, _) in keys.items():
        if not table.has(name):
            continue
        if value is COUNT:
            chosen[name] = table.count(name, 1)
        elif value is NUMBER:
            chosen[name] = table.number(name)
        elif name == "sides":
            chosen[name] = table.text(name)
    return chosen


def read_slot(table: Table) -> Slot:
    """A slot, with the keys of `Slot` but for a bent centre line."""
    table.only(*STRIP_TABLES["slot"])
    chosen: dict[str, Any] = {
        "depth": table.maybe("depth"),
        "side": table.text("side", "upper"),
        "lean": table.number("lean", 0.0),
        "relief": table.text("relief", "square"),
        "mate": table.text("mate", ""),
    }
    with table.naming():
        return Slot(table.number("at"), table.number("width"), **chosen)


def _pair(table: Table, key: str, default: Sequence[float] | None = None) -> tuple[float, float]:
    x, y = table.vector(key, 2, default)
    return x, y
