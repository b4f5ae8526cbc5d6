"""Sheet library editor."""

import FreeCADGui as Gui
from freecad.elastica_wb.commands.base import Command
from freecad.elastica_wb.panels.sheets import SheetsPanel

__all__ = ["SheetsCommand"]


class SheetsCommand(Command):
    """Look at the built-in sheets, keep your own."""

    name = "Elastica_Sheets"
    text = "Sheet library"
    tip = "Look at the sheets that are known, with their sources, and keep your own"
    needs_document = False

    def run(self) -> None:
        """Open the panel."""
        Gui.Control.showDialog(SheetsPanel())
