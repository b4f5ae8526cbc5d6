"""What a design file says about all that goes with its strips: joints, base, fixtures, sheets, cutting."""

from typing import Any

from elastica_cad.fabrication.drawings.bridges import HoldingTabs
from elastica_cad.formats.design_files.kit_spec import Cutting, KitSpec, Nesting
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
        base=_read_base(top.table("base"), sheets, nesting) if top.has("base") else None,
        frame=_read_frame(top.table("frame"), sheets, nesting) if top.has("frame") else None,
        fixtures=_read_fixtures(top.table("fixtures")) if top.has("fixtures") else None,
        coupon=extras.flag("coupon"),
        reference_bar=extras.maybe("reference_bar"),
        shop=read_shop(top.table("shop")),
        anyway=top.flag("anyway"),
    )


def _read_fixtures(table: Table) -> dict[str, Any]:
    """Options of `Model.fixtures`."""
    sizes = ("clearance", "wall", "foot", "foot_height", "screw")
    table.only("floor", *sizes)
    options: dict[str, Any] = {**table.numbers(*sizes)}
    if table.has("floor"):
        options["floor"] = Frame((0.0, 0.0, table.number("floor")))
    return options


def _read_base(
    table: Table, sheets: dict[str, Sheet], nesting: Nesting
) -> tuple[Sheet, dict[str, Any], Nesting]:
    """Sheet and options of the base plate, or of two with a gap, and the sheets they are cut from."""
    sizes = ("play", "clearance", "slot_width", "border", "gap")
    table.only("sheet", "thickness", "height", "shape", "sheet_size", *sizes)
    options: dict[str, Any] = {**table.numbers(*sizes)}
    options["frame"] = Frame((0.0, 0.0, table.number("height", 0.0)))
    options["shape"] = table.text("shape", "hull", ("hull", "rectangle"))
    return find_sheet(table, "sheet", sheets), options, _read_nesting(table, nesting)


def _read_frame(
    table: Table, sheets: dict[str, Sheet], nesting: Nesting
) -> tuple[Sheet, dict[str, Any], Nesting]:
    """Sheet and options of the slotted frame, and the sheets it is cut from."""
    sizes = ("depth", "tongue", "play", "clearance", "border")
    table.only("sheet", "thickness", "ribs", "sheet_size", *sizes)
    options: dict[str, Any] = {**table.numbers(*sizes)}
    options["ribs"] = table.count("ribs", 3)
    return find_sheet(table, "sheet", sheets), options, _read_nesting(table, nesting)


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
