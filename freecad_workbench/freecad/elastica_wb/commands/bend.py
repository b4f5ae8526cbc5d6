"""Bend forward."""

from freecad.elastica_wb.commands.base import Command, chosen_strips, show_panel
from freecad.elastica_wb.panels.bend import BendPanel

__all__ = ["BendCommand"]


class BendCommand(Command):
    """Move or turn an end and watch the strip follow."""

    name = "Elastica_Bend"
    text = "Bend forward"
    tip = "Move or turn the ends of the selected strip and watch it take its new rest shape"
    shortcut = "E, B"

    def run(self) -> None:
        """Open the panel."""
        show_panel(BendPanel, chosen_strips()[0])
