"""Coupon and calibrate."""

import FreeCAD as App
from freecad.elastica_wb.commands.base import Command, show_panel
from freecad.elastica_wb.panels.coupon import CouponPanel

__all__ = ["CouponCommand"]


class CouponCommand(Command):
    """A strip to cut, hang over an edge and measure; the readings make a sheet of your own."""

    name = "Elastica_Coupon"
    text = "Coupon and calibrate"
    tip = "Make a test strip to hang over an edge, and turn its measured droop into a sheet of your own"

    def run(self) -> None:
        """Open the panel."""
        show_panel(CouponPanel, App.ActiveDocument)
