"""Nearest curve to sketch."""

from freecad.elastica_wb.commands.base import Command, chosen_sketch, show_panel
from freecad.elastica_wb.panels.nearest import NearestPanel

__all__ = ["NearestCommand"]


class NearestCommand(Command):
    """The curve nearest to a sketch that a strip can take, within limits."""

    name = "Elastica_Nearest"
    text = "Nearest curve to sketch"
    tip = "Find the curve nearest to the selected sketch that can be bent within limits"
    shortcut = "E, N"

    def run(self) -> None:
        """Open the panel."""
        show_panel(NearestPanel, chosen_sketch())
