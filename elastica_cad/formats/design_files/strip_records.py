"""Tables that say how one strip is made: sheet, style, law, tabs, slots, what the workshop can cut."""

from typing import Any

from elastica_cad.errors import InputError
from elastica_cad.fabrication.holding.expected_error import MakingTolerance
from elastica_cad.fabrication.makeability.shop import Shop
from elastica_cad.fabrication.slots.slot import Slot
from elastica_cad.fabrication.strip.lamination import Laminated
from elastica_cad.fabrication.strip.outline import Hole, Tab, TSlot
from elastica_cad.fabrication.strip.perforation import Perforated
from elastica_cad.fabrication.strip.styles import Plain, Style
from elastica_cad.formats.design_files.keys.strip_keys import STRIP_TABLES
from elastica_cad.formats.design_files.keys.values import COUNT, NUMBER
from elastica_cad.formats.design_files.tables import Table
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.material.stiffness_law import BoundedLaw, LeavesLaw, RoundLaw, ThicknessLaw

LAW_LINE = 'kind = "thickness", limits = [3, 8], width = 20'
"""What a refused line is told to look like."""


def find_sheet(table: Table, key: str, sheets: dict[str, Sheet]) -> Sheet:
    """One of the design's own sheets, or a built-in one."""
    if not table.has(key):
        raise InputError(
            '{key} is missing; name a sheet, e.g. sheet = "birch-plywood-0.8"', key=table.place(key)
        )
    name = table.text(key)
    with table.naming(key):
        found = sheets[name] if name in sheets else Sheet.named(name)
        thickness = table.maybe("thickness") if key == "sheet" else None
        return found if thickness is None else found.with_thickness(thickness)


def read_shop(table: Table) -> Shop:
    """What the workshop can make."""
    widths = ("least_width", "least_ligament", "least_bridge", "lap")
    table.only(*STRIP_TABLES["shop"])
    given: dict[str, Any] = {**table.numbers(*widths)}
    if table.has("stock"):
        given["stock"] = table.vector("stock", 2)
    with table.naming():
        return Shop(**given)


TOLERANCE_LINE = "thickness_wave = 0.01, clamps = 0.01, kerf = 0.05"
"""A line that tells one, as people may write it."""


def read_tolerance(table: Table) -> MakingTolerance:
    """What is assumed to be off in sheet, cut and clamps."""
    names = tuple(STRIP_TABLES["tolerance"])
    table.only(*names)
    with table.naming():
        return MakingTolerance(**table.numbers(*names))


def read_tabs(table: Table) -> tuple[Tab, Tab]:
    """One table for both ends, or a list of two."""
    given = table.raw("ends", {})
    if isinstance(given, list):
        if len(given) != 2:
            raise InputError(
                "{place} lists {count} tabs: give one table, or two in a list",
                place=table.place("ends"),
                count=len(given),
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
        table.pair("nut", TSlot.nut),
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
