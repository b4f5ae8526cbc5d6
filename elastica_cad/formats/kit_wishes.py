"""What a design file says about all that goes with its strips: joints, base, fixtures, sheets, cutting."""

from dataclasses import dataclass, replace
from typing import Any

from elastica_cad.fabrication import Frame, HoldingTabs
from elastica_cad.formats.dxf import DXF_VERSIONS
from elastica_cad.formats.tables import Table
from elastica_cad.formats.wishes import named_sheet
from elastica_cad.mechanics import Sheet

__all__ = [
    "Cutting",
    "Nesting",
    "base_wish",
    "cutting_wish",
    "fixtures_wish",
    "frame_wish",
    "interlock_wish",
    "nesting_wish",
]


@dataclass(frozen=True)
class Nesting:
    """Sheets that pieces are laid on: (width, height) and least distance, mm."""

    sheet_size: tuple[float, float] = (600.0, 400.0)
    margin: float = 2.0


@dataclass(frozen=True)
class Cutting:
    """How cutting files are written: `kerf` in mm, or None for each sheet's own; no `holding` tabs for None."""

    kerf: float | None = 0.0
    curves: str = "spline"
    tolerance: float = 0.02
    version: str = "R2010"
    holding: HoldingTabs | None = None


def interlock_wish(table: Table) -> dict[str, Any]:
    """Options of `Model.interlock`."""
    table.only("clearance", "fit", "relief", "above")
    options: dict[str, Any] = {"clearance": table.number("clearance", 0.1)}
    options["fit"] = table.text("fit", "exact", ("exact", "paper"))
    options["relief"] = table.text("relief", "square", ("square", "round"))
    return options | ({"above": table.vector("above", 3)} if table.has("above") else {})


def fixtures_wish(table: Table) -> dict[str, Any]:
    """Options of `Model.fixtures`."""
    sizes = ("clearance", "wall", "foot", "foot_height", "screw")
    table.only("floor", *sizes)
    options: dict[str, Any] = {key: table.number(key) for key in sizes if table.has(key)}
    if table.has("floor"):
        options["floor"] = Frame((0.0, 0.0, table.number("floor")))
    return options


def base_wish(
    table: Table, sheets: dict[str, Sheet], nesting: Nesting
) -> tuple[Sheet, dict[str, Any], Nesting]:
    """Sheet and options of the base plate, and the sheets it is cut from."""
    sizes = ("play", "clearance", "slot_width", "border")
    table.only("sheet", "height", "shape", "sheet_size", *sizes)
    options: dict[str, Any] = {key: table.number(key) for key in sizes if table.has(key)}
    options["frame"] = Frame((0.0, 0.0, table.number("height", 0.0)))
    options["shape"] = table.text("shape", "hull", ("hull", "rectangle"))
    size = table.vector("sheet_size", 2, nesting.sheet_size)
    return named_sheet(table, "sheet", sheets), options, replace(nesting, sheet_size=(size[0], size[1]))


def frame_wish(
    table: Table, sheets: dict[str, Sheet], nesting: Nesting
) -> tuple[Sheet, dict[str, Any], Nesting]:
    """Sheet and options of the slotted frame, and the sheets it is cut from."""
    sizes = ("depth", "tongue", "play", "clearance", "border")
    table.only("sheet", "ribs", "sheet_size", *sizes)
    options: dict[str, Any] = {key: table.number(key) for key in sizes if table.has(key)}
    options["ribs"] = table.count("ribs", 3)
    size = table.vector("sheet_size", 2, nesting.sheet_size)
    return named_sheet(table, "sheet", sheets), options, replace(nesting, sheet_size=(size[0], size[1]))


def nesting_wish(table: Table) -> Nesting:
    """The sheets that strips are laid on."""
    table.only("sheet_size", "margin")
    width, height = table.vector("sheet_size", 2, Nesting.sheet_size)
    return Nesting((width, height), table.number("margin", Nesting.margin))


def cutting_wish(table: Table) -> Cutting:
    """How cutting files are written."""
    table.only("kerf", "curves", "tolerance", "version", "holding")
    of_sheet = table.raw("kerf") == "sheet"
    return Cutting(
        kerf=None if of_sheet else table.number("kerf", 0.0),
        curves=table.text("curves", "spline", ("spline", "arc", "polyline")),
        tolerance=table.number("tolerance", 0.02),
        version=table.text("version", "R2010", DXF_VERSIONS),
        holding=_holding(table.table("holding")) if table.has("holding") else None,
    )


def _holding(table: Table) -> HoldingTabs:
    table.only("width", "spacing", "least", "inner")
    usual = HoldingTabs()
    with table.naming():
        return HoldingTabs(
            table.number("width", usual.width),
            table.number("spacing", usual.spacing),
            table.count("least", usual.least),
            table.flag("inner"),
        )
