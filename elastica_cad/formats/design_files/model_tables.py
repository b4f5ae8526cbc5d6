"""What a design file says about all that goes with its strips: joints, base, fixtures, sheets, cutting."""

from collections.abc import Iterator
from typing import Any

from elastica_cad.fabrication.drawings.bridges import HoldingTabs
from elastica_cad.fabrication.holders.placed_tab import ENDS
from elastica_cad.formats.design_files.kit_spec import Cutting, HolderKind, HolderSpec, KitSpec, Nesting
from elastica_cad.formats.design_files.strip_records import find_sheet, read_shop
from elastica_cad.formats.design_files.tables import Table
from elastica_cad.formats.drawing_files.dxf_drawing import DXF_VERSIONS
from elastica_cad.geometry.frame import Frame
from elastica_cad.mechanics.material.sheet import Sheet


def read_interlock(table: Table) -> dict[str, Any]:
    """Options of `Model.interlock`."""
    table.only("clearance", "fit", "relief", "above")
    options: dict[str, Any] = {"clearance": table.number("clearance", 0.1)}
    options["fit"] = table.text("fit", "exact", ("exact", "paper"))
    options["relief"] = table.text("relief", "square", ("square", "round"))
    return options | ({"above": table.vector("above", 3)} if table.has("above") else {})


def read_kit(top: Table, sheets: dict[str, Sheet]) -> KitSpec:
    """All that goes with the strips, from the whole design."""
    nesting = _read_nesting(top.table("nest").only("sheet_size", "margin"), Nesting())
    extras = top.table("extras").only("coupon", "reference_bar")
    return KitSpec(
        nesting=nesting,
        cutting=_read_cutting(top.table("cut")),
        holders=tuple(_read_holders(top, sheets, nesting)),
        coupon=extras.flag("coupon"),
        reference_bar=extras.maybe("reference_bar"),
        shop=read_shop(top.table("shop")),
        anyway=top.flag("anyway"),
    )


HOLDER_SIZES: dict[HolderKind, tuple[str, ...]] = {
    "base": ("play", "clearance", "slot_width", "border", "gap", "feet"),
    "rings": ("play", "clearance", "border", "gap", "feet"),
    "frame": ("depth", "tongue", "play", "clearance", "border", "gap", "feet"),
    "fixtures": ("clearance", "wall", "foot", "foot_height", "screw"),
    "stand": (),
}
"""Lengths that a holder may be given, in the order in which kits hold them."""

OWN_KEYS = {
    "base": ("height", "shape", "ends", "name"), "rings": ("shape", "ends", "name"), "frame": ("ribs",),
    "fixtures": ("floor", "ends"), "stand": (),
}  # fmt: skip


def _read_holders(top: Table, sheets: dict[str, Sheet], nesting: Nesting) -> Iterator[HolderSpec]:
    """Base plates, rings, frames, fixtures: one table of each, or a list of them."""
    for kind in HOLDER_SIZES:
        if isinstance(top.raw(kind), list):
            tables = top.tables(kind)
        else:
            tables = [top.table(kind)] if top.has(kind) else []
        for number, table in enumerate(tables, start=1):
            yield _read_holder(kind, table, number if len(tables) > 1 else 0, sheets, nesting)


def _read_holder(
    kind: HolderKind, table: Table, number: int, sheets: dict[str, Sheet], nesting: Nesting
) -> HolderSpec:
    """One of them; those of a list have numbers in their names unless they bring their own."""
    sizes, own = HOLDER_SIZES[kind], OWN_KEYS[kind]
    plates = () if kind == "fixtures" else ("sheet", "thickness", "sheet_size")
    table.only("strips", *plates, *sizes, *own)
    options: dict[str, Any] = {**table.numbers(*sizes)}
    if "name" in own and (number or table.has("name")):
        options["name"] = table.text("name", f"{kind.removesuffix('s')}-{number}")
    if table.has("ends"):
        options["ends"] = (table.text("ends", choices=ENDS),)
    if "shape" in own and table.has("shape"):
        options["shape"] = table.text("shape", choices=("hull", "rectangle", "ring"))
    if kind == "base":
        options["frame"] = Frame((0.0, 0.0, table.number("height", 0.0)))
    if kind == "frame":
        options["ribs"] = table.count("ribs", 3)
    if table.has("floor"):
        options["floor"] = Frame((0.0, 0.0, table.number("floor")))
    return HolderSpec(
        kind,
        find_sheet(table, "sheet", sheets) if plates else None,
        options,
        _read_nesting(table, nesting),
        table.texts("strips", ("*",)),
        table.where,
    )


def _read_nesting(table: Table, usual: Nesting) -> Nesting:
    """The sheets that pieces are laid on."""
    width, height = table.vector("sheet_size", 2, usual.sheet_size)
    return Nesting((width, height), table.number("margin", usual.margin))


def _read_cutting(table: Table) -> Cutting:
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
