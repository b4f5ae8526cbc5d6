"""What a design file says about a surface of revolution: its meridian, and the strips and rings it is made of."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.fabrication import Model, Tab, revolved
from elastica_cad.formats.tables import Table
from elastica_cad.formats.wishes import CurveReader, drawn_curve, named_sheet, tabs
from elastica_cad.forming import Meridian, meridian, meridian_through
from elastica_cad.mechanics import Sheet

__all__ = ["RevolutionWish", "revolution_wish"]

NEAR = 1e-3
"""mm; a meridian this near to its points passes them."""

CONSTANTS = ("a", "b", "start", "angle", "length")


@dataclass(frozen=True, eq=False)
class RevolutionWish:
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
    """

    meridian: Meridian
    strips: int
    sheet: Sheet
    ends: tuple[Tab, Tab] | None = None
    rings: Sheet | None = None

    def model(self, name: str) -> Model:
        """All strips, and the rings.

        Raises
        ------
        InputError
            As `revolved`.
        """
        return revolved(
            self.meridian, self.strips, sheet=self.sheet, ends=self.ends, rings=self.rings, name=name
        )

    @property
    def reports(self) -> tuple[str, ...]:
        """How far the meridian is off what was drawn, where it is."""
        off = self.meridian.deviation
        if off <= NEAR:
            return ()
        return (
            f"the meridian is {off:.3g} mm off its points at most: no meridian that strips can tile is nearer",
        )


def revolution_wish(
    table: Table, folder: Path, sheets: dict[str, Sheet], read_curves: CurveReader
) -> RevolutionWish:
    """The wish that the table `revolution` makes.

    Raises
    ------
    InputError
        Unknown keys, a meridian told in two ways or none, or one that cannot be; the place is named.
    """
    table.only("sheet", "strips", "ring", "rings", "ends", "points", "curve", *CONSTANTS)
    ring = table.maybe("ring")
    ways = [way for way in ("points", "curve", "a") if table.has(way)]
    if len(ways) != 1:
        raise InputError(
            f"{table.where} must hold one of points, curve, or {', '.join(CONSTANTS)}: what the meridian is to be"
        )
    try:
        with table.naming():
            if ways[0] == "a":
                b, start = table.vector("b", 2), table.vector("start", 2)
                numbers: Any = (table.number("angle"), table.number("length"))
                line = meridian(table.number("a"), b, start, *numbers, ring=ring)
            elif ways[0] == "points":
                line = meridian_through(_points(table), ring=ring)
            else:
                line = meridian_through(drawn_curve(table, folder, read_curves), ring=ring)
    except NotConvergedError as problem:
        raise NotConvergedError(f"{table.where}: {problem}") from problem
    return RevolutionWish(
        line,
        table.count("strips", 16),
        named_sheet(table, "sheet", sheets),
        tabs(table) if table.has("ends") else None,
        named_sheet(table, "rings", sheets) if table.has("rings") else None,
    )


def _points(table: Table) -> list[tuple[float, ...]]:
    rows = table.raw("points")
    if not isinstance(rows, list):
        raise InputError(f"{table.place('points')} must be a list of points [x, y], x from the axis, mm")
    return [
        Table({"point": row}, f"{table.place('points')}[{i}]", table.scope).vector("point", 2)
        for i, row in enumerate(rows, start=1)
    ]
