"""Sheet library editor."""

from freecad.elastica_wb.commands.base import Command, show_panel
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
        show_panel(SheetsPanel)
