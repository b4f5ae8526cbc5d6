"""Tolerance study."""

from freecad.elastica_wb.commands.base import Command, chosen_strips, show_panel
from freecad.elastica_wb.panels.tolerance import TolerancePanel

__all__ = ["ToleranceCommand"]


class ToleranceCommand(Command):
    """How far the strip strays when sheet, cut and clamps are not as designed."""

    name = "Elastica_Tolerance"
    text = "Tolerance study"
    tip = "Find how far the bent strip strays when sheet, cut and clamps vary within their ranges"

    def run(self) -> None:
        """Open the panel."""
        show_panel(TolerancePanel, chosen_strips()[0])
