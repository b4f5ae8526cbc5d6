"""What a design file says about a surface of revolution: its meridian, and the strips and rings it is made of."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.fabrication.makeability.shop import DEFAULT_SHOP, Shop
from elastica_cad.fabrication.model.revolution_model import revolve
from elastica_cad.fabrication.model.strip_model import Model
from elastica_cad.fabrication.strip.outline import Tab
from elastica_cad.formats.design_files.keys.model_keys import MODEL_TABLES
from elastica_cad.formats.design_files.strip_records import find_sheet, read_shop, read_tabs
from elastica_cad.formats.design_files.strip_table import CurveReader, read_drawn_curve
from elastica_cad.formats.design_files.tables import Table
from elastica_cad.forming.revolution.meridian import Meridian, meridian, meridian_through
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.refusals import Length, note

NEAR_MM = 1e-3
"""A meridian this near to its points passes them: no cut is as exact."""

OWN_KEYS = ("a", "b", "start", "angle", "length")


@dataclass(frozen=True, eq=False)
class RevolutionEntry:
    """A surface of revolution to be made.

    Attributes
    ----------
    meridian : Meridian
    strips : int
    sheet : Sheet
    ends : pair of Tab or None
        None for tabs that keep apart.
    rings : Sheet or None
        Of the rings at both ends.
    gap : float or None
        Between two rings that hold inclined tabs, mm; one ring each without.
    shop : Shop
        What the workshop can make.
    ignore_limits : bool
        Make what it cannot, and say so.
    """

    meridian: Meridian
    strips: int
    sheet: Sheet
    ends: tuple[Tab, Tab] | None = None
    rings: Sheet | None = None
    gap: float | None = None
    shop: Shop = DEFAULT_SHOP
    ignore_limits: bool = False

    def model(self, name: str) -> Model:
        """All strips, and the rings.

        Raises
        ------
        InputError
            As `revolve`.
        """
        return revolve(
            self.meridian,
            self.strips,
            sheet=self.sheet,
            ends=self.ends,
            rings=self.rings,
            gap=self.gap,
            name=name,
            shop=self.shop,
            ignore_limits=self.ignore_limits,
        )

    @property
    def reports(self) -> tuple[str, ...]:
        """How far the meridian is off what was drawn, where it is."""
        off = self.meridian.deviation
        if off <= NEAR_MM:
            return ()
        return (
            note(
                "the meridian is {far} off its points at most: no meridian that strips can tile is nearer",
                far=Length(off),
            ),
        )


def read_revolution(
    table: Table, folder: Path, sheets: dict[str, Sheet], read_curves: CurveReader
) -> RevolutionEntry:
    """What the table `revolution` asks for.

    Raises
    ------
    InputError
        Unknown keys, a meridian told in two ways or none, or one that cannot be; the place is named.
    """
    table.only(*MODEL_TABLES["revolution"])
    ring = table.maybe("ring")
    ways = [way for way in ("points", "curve", "a") if table.has(way)]
    if len(ways) != 1:
        raise InputError(
            "{where_} must hold one of points, curve, or {own_keys}: what the meridian is to be",
            where_=table.where,
            own_keys=", ".join(OWN_KEYS),
        )
    try:
        with table.naming():
            if ways[0] == "a":
                b, start = table.vector("b", 2), table.vector("start", 2)
                numbers: Any = (table.number("angle"), table.number("length"))
                line = meridian(table.number("a"), b, start, *numbers, ring=ring)
            elif ways[0] == "points":
                line = meridian_through(table.points("points", 2), ring=ring)
            else:
                line = meridian_through(read_drawn_curve(table, folder, read_curves), ring=ring)
    except NotConvergedError as problem:
        raise NotConvergedError("{where_}: {problem}", where_=table.where, problem=problem) from problem
    return RevolutionEntry(
        line,
        table.count("strips", 16),
        find_sheet(table, "sheet", sheets),
        read_tabs(table) if table.has("ends") else None,
        find_sheet(table, "rings", sheets) if table.has("rings") else None,
        table.maybe("gap"),
        read_shop(table.table("shop")),
        table.flag("ignore_limits"),
    )
