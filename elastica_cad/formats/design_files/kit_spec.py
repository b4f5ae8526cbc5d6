"""What goes with the strips of a model: sheets, cutting files, base, frame, fixtures, further pieces."""

from dataclasses import dataclass, field
from typing import Any

from elastica_cad.errors import InputError
from elastica_cad.fabrication.drawings.bridges import HoldingTabs
from elastica_cad.fabrication.holders.base_plate import BasePlate
from elastica_cad.fabrication.holders.end_fixtures import EndFixture
from elastica_cad.fabrication.holders.plate_pair import plate_pair
from elastica_cad.fabrication.holders.slotted_frame import SlottedFrame
from elastica_cad.fabrication.makeability.shop import DEFAULT_SHOP, Shop
from elastica_cad.fabrication.model.strip_model import Model
from elastica_cad.fabrication.sheets.coupon import coupon_drawing, reference_bar
from elastica_cad.fabrication.sheets.pieces import Piece
from elastica_cad.mechanics.material.sheet import Sheet


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

    def options(self, sheet: Sheet) -> dict[str, Any]:
        """Options of `save` for what is cut of a sheet.

        Raises
        ------
        InputError
            The sheet's own kerf is asked for, and not known.
        """
        if self.kerf is None and sheet.kerf == 0:
            raise InputError(
                f"no kerf is known for {sheet.name}: give a number of mm instead of the word sheet"
            )
        kerf = sheet.kerf if self.kerf is None else self.kerf
        return {"kerf": kerf, "curves": self.curves, "tolerance": self.tolerance, "holding": self.holding}


@dataclass(frozen=True, eq=False)
class KitSpec:
    """What is asked of a kit beside its strips.

    Attributes
    ----------
    nesting : Nesting
    cutting : Cutting
    base, frame : (Sheet, dict, Nesting) or None
        Sheet and options of the base plate, of the slotted frame, and the sheet size they are cut from.
    fixtures : dict or None
        Options of `Model.fixtures`, where asked for.
    coupon : bool
        Cut a coupon of every sheet.
    reference_bar : float or None
        Length of a bar to check the machine's scale with, mm.
    shop : Shop
        What the workshop can make.
    anyway : bool
        Make what it cannot, and say so in the report.
    """

    nesting: Nesting = field(default_factory=Nesting)
    cutting: Cutting = field(default_factory=Cutting)
    base: tuple[Sheet, dict[str, Any], Nesting] | None = None
    frame: tuple[Sheet, dict[str, Any], Nesting] | None = None
    fixtures: dict[str, Any] | None = None
    coupon: bool = False
    reference_bar: float | None = None
    shop: Shop = DEFAULT_SHOP
    anyway: bool = False

    def base_plates(self, model: Model) -> tuple[BasePlate, ...]:
        """The base plate, or the two with a gap that are asked for."""
        if self.base is None:
            return ()
        sheet, options, _ = self.base
        made = {"shop": self.shop, "anyway": self.anyway, **options}
        if "gap" in options:
            return plate_pair(model.placed, sheet, **made)
        return (model.base_plate(sheet, **made),)

    def slotted_frame(self, model: Model) -> SlottedFrame | None:
        """The slotted frame, where one is asked for."""
        if self.frame is None:
            return None
        sheet, options, _ = self.frame
        return model.slotted_frame(sheet, shop=self.shop, anyway=self.anyway, **options)

    def end_fixtures(self, model: Model) -> tuple[EndFixture, ...]:
        """The fixtures, where they are asked for."""
        return () if self.fixtures is None else model.fixtures(**self.fixtures)

    def extras(self, model: Model) -> tuple[Piece, ...]:
        """Coupons of the model's sheets and the reference bar, where they are asked for."""
        sheets = list(dict.fromkeys(strip.sheet for strip in model.strips))
        pieces = []
        if self.coupon:
            names = ["coupon"] if len(sheets) == 1 else [f"coupon-{n}" for n in range(1, len(sheets) + 1)]
            pieces += [Piece(name, coupon_drawing(s), s) for name, s in zip(names, sheets, strict=True)]
        if self.reference_bar is not None:
            pieces.append(Piece("reference-bar", reference_bar(self.reference_bar), sheets[0]))
        return tuple(pieces)
