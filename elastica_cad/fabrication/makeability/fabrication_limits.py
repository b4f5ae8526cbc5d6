"""What a workshop can make: least widths, the largest sheet it takes, the slots it accepts."""

from dataclasses import dataclass
from typing import Annotated

from elastica_cad._values import require_record
from elastica_cad.declared import Asked, require_declared
from elastica_cad.mechanics.material.sheet import Sheet

LEAST_STRIP_MM = 3.0  # narrower strips of any sheet break when they are lifted out
THICKNESSES = 3.0  # a strip narrower than this many thicknesses bends sideways and twists rather than flat
LEAST_BRIDGE_MM = 2.0  # between two cuts of a plate: what the heat of two passes leaves sound
LEAST_LIGAMENT_MM = 0.5  # lines of a laser closer than this may burn away what is between them
LARGEST_PANEL_MM = (3050.0, 1525.0)  # the largest sheet of plywood and board on sale
WIDEST_SLOT_THICKNESSES = 6.0  # of the tab: a vertical slot this wide holds a tab at no angle
FILLED_SLOT_MM = 1.6  # a slot no wider holds a thin tab with glue on both sides
SLENDEREST = 600.0  # length over least width, beyond which a loose strip cannot be handled flat


@dataclass(frozen=True)
class FabricationLimits:
    """Limits of the workshop; what is not given follows from the sheet.

    Parameters
    ----------
    least_width : float, optional
        Of a strip, a tab or a tongue, mm; where not given the sheet's own, or 3 thicknesses of it, 3 mm at least.
    least_ligament : float, optional
        Between the holes of a perforated strip, mm; where not given the sheet's own, or 0.5 mm.
    least_bridge : float, optional
        Between the cuts of a ring or a plate, mm; where not given the sheet's own, or its thickness, 2 mm at least.
    stock : (float, float), optional
        Longer and shorter side of the largest sheet, mm; where not given the sheet's own, or 3050 by 1525 mm.
    lap : float, optional
        Length of the plates that join the pieces of a strip longer than the stock, mm; without it such strips are
        refused.

    Raises
    ------
    InputError
        A limit that is not positive.

    Examples
    --------
    >>> FabricationLimits().width_for(Sheet.named("birch-plywood-0.8"))
    3.0
    >>> FabricationLimits(least_width=1.5).width_for(Sheet.named("birch-plywood-0.8"))
    1.5
    """

    least_width: Annotated[
        float | None,
        Asked(
            "Narrowest strip, tab or tongue that can be made; that of the sheet unless given.",
            "mm",
            least=0.05,
            group="limits",
        ),
    ] = None
    least_ligament: Annotated[
        float | None,
        Asked("Least material between the holes of a perforated strip.", "mm", least=0.05, group="limits"),
    ] = None
    least_bridge: Annotated[
        float | None, Asked("Least material between the cuts of a plate.", "mm", least=0.05, group="limits")
    ] = None
    stock: Annotated[
        tuple[float, float] | None, Asked("Sides of the largest sheet.", "mm", above=0, group="limits")
    ] = None
    lap: Annotated[
        float | None,
        Asked(
            "Length of the plates that join pieces of a strip longer than the stock.",
            "mm",
            above=0,
            group="limits",
        ),
    ] = None

    def __post_init__(self) -> None:
        require_declared(FabricationLimits, vars(self))
        if self.stock is not None:
            object.__setattr__(self, "stock", (float(max(self.stock)), float(min(self.stock))))

    def width_for(self, sheet: Sheet) -> float:
        """Least width of strips, tabs and tongues of a sheet, mm."""
        sheet = Sheet.of(sheet)
        return self.least_width or sheet.least_width or max(LEAST_STRIP_MM, THICKNESSES * sheet.thickness)

    def ligament_for(self, sheet: Sheet) -> float:
        """Least material between the holes of a perforated strip, mm."""
        sheet = Sheet.of(sheet)
        return self.least_ligament or sheet.least_ligament or LEAST_LIGAMENT_MM

    def bridge_for(self, sheet: Sheet) -> float:
        """Least material between two cuts of a plate, mm."""
        sheet = Sheet.of(sheet)
        return self.least_bridge or sheet.least_bridge or max(LEAST_BRIDGE_MM, sheet.thickness)

    def stock_for(self, sheet: Sheet) -> tuple[float, float]:
        """Longer and shorter side of the largest sheet, mm."""
        sheet = Sheet.of(sheet)
        long, short = sorted(self.stock or sheet.stock or LARGEST_PANEL_MM, reverse=True)
        return long, short


def limits_or_default(shop: FabricationLimits | None) -> FabricationLimits:
    """The shop, one of which nothing is known for None; refuses what is neither."""
    if shop is None:
        return DEFAULT_LIMITS
    require_record(shop, FabricationLimits, "the shop", "a FabricationLimits record")
    return shop


DEFAULT_LIMITS = FabricationLimits()
"""A shop of which nothing is known."""
