"""Check curve."""

from freecad.elastica_wb import live
from freecad.elastica_wb.commands.base import Command, chosen_curves, edited_sketch, show_panel
from freecad.elastica_wb.panels.check import CheckPanel

__all__ = ["CheckCommand"]


class CheckCommand(Command):
    """Can it be bent? The answer in words, and the overlay on the curve."""

    name = "Elastica_Check"
    text = "Check curve"
    tip = "Say whether a flat strip can take the selected curve, and if not why and where"
    shortcut = "E, C"

    def run(self) -> None:
        """In the sketcher the overlay comes on; elsewhere a panel tells the whole answer."""
        (source, edges), *_ = chosen_curves()
        if edited_sketch() is source:
            live.start(source)
            return
        show_panel(CheckPanel, source, edges)
