"""What a design file says about all that goes with its strips: joints, base, fixtures, sheets, cutting."""

from collections.abc import Iterator
from typing import Any, get_args

from elastica_cad.fabrication.drawings.cutting import HoldingTabs
from elastica_cad.fabrication.strip.outline import ENDS
from elastica_cad.formats.design_files.keys.model_keys import MODEL_TABLES
from elastica_cad.formats.design_files.keys.values import NUMBER
from elastica_cad.formats.design_files.kit_spec import Cutting, HolderKind, HolderSpec, KitSpec, Nesting
from elastica_cad.formats.design_files.strip_records import find_sheet, read_shop
from elastica_cad.formats.design_files.tables import Table
from elastica_cad.formats.drawing_files.dxf_drawing import DXF_VERSIONS
from elastica_cad.geometry.frame import Frame
from elastica_cad.mechanics.material.sheet import Sheet


def read_interlock(table: Table) -> dict[str, Any]:
    """Options of `Model.interlock`."""
    table.only(*MODEL_TABLES["interlock"])
    options: dict[str, Any] = {"clearance": table.number("clearance", 0.1)}
    options["fit"] = table.text("fit", "exact", ("exact", "paper"))
    options["relief"] = table.text("relief", "square", ("square", "round"))
    return options | ({"above": table.vector("above", 3)} if table.has("above") else {})


def read_kit(top: Table, sheets: dict[str, Sheet]) -> KitSpec:
    """All that goes with the strips, from the whole design."""
    nesting = _read_nesting(top.table("nest").only(*MODEL_TABLES["nest"]), Nesting())
    extras = top.table("extras").only(*MODEL_TABLES["extras"])
    return KitSpec(
        nesting=nesting,
        cutting=_read_cutting(top.table("cut")),
        holders=tuple(_read_holders(top, sheets, nesting)),
        coupon=extras.flag("coupon"),
        reference_bar=extras.maybe("reference_bar"),
        shop=read_shop(top.table("shop")),
        ignore_limits=top.flag("ignore_limits"),
    )


HOLDERS: tuple[HolderKind, ...] = get_args(HolderKind)
"""In the order in which kits hold them."""

_NO_SIZES = ("thickness", "height", "floor", "margin")  # numbers of a holder that its maker does not take


def _read_holders(top: Table, sheets: dict[str, Sheet], nesting: Nesting) -> Iterator[HolderSpec]:
    """Base plates, rings, frames, fixtures: one table of each, or a list of them."""
    for kind in HOLDERS:
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
    keys = MODEL_TABLES[kind]
    table.only(*keys)
    sizes = (key for key, (value, _) in keys.items() if value is NUMBER and key not in _NO_SIZES)
    options: dict[str, Any] = {**table.numbers(*sizes)}
    if "name" in keys and (number or table.has("name")):
        options["name"] = table.text("name", f"{kind.removesuffix('s')}-{number}")
    if table.has("ends"):
        options["ends"] = (table.text("ends", choices=ENDS),)
    if table.has("shape"):
        options["shape"] = table.text("shape", choices=("hull", "rectangle", "ring"))
    if kind == "base":
        options["frame"] = Frame((0.0, 0.0, table.number("height", 0.0)))
    if kind == "frame":
        options["ribs"] = table.count("ribs", 3)
    if table.has("floor"):
        options["floor"] = Frame((0.0, 0.0, table.number("floor")))
    return HolderSpec(
        kind,
        find_sheet(table, "sheet", sheets) if "sheet" in keys else None,
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
    table.only(*MODEL_TABLES["cut"])
    of_sheet = table.raw("kerf") == "sheet"
    return Cutting(
        kerf=None if of_sheet else table.number("kerf", 0.0),
        curves=table.text("curves", "spline", ("spline", "arc", "polyline")),
        tolerance=table.number("tolerance", 0.02),
        version=table.text("version", "R2010", DXF_VERSIONS),
        holding=_holding(table.table("holding")) if table.has("holding") else None,
    )


def _holding(table: Table) -> HoldingTabs:
    table.only(*MODEL_TABLES["holding"])
    usual = HoldingTabs()
    with table.naming():
        return HoldingTabs(
            table.number("width", usual.width),
            table.number("spacing", usual.spacing),
            table.count("least", usual.least),
            table.flag("inner"),
        )
