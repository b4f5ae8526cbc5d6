"""Export cutting files."""

from freecad.elastica_wb.commands.base import Command, chosen_sources, show_panel
from freecad.elastica_wb.panels.export import ExportPanel

__all__ = ["ExportCommand"]


class ExportCommand(Command):
    """DXF, SVG, STEP and a cut list."""

    name = "Elastica_Export"
    text = "Export cutting files"
    tip = "Write DXF, SVG and STEP files, nest and cut list of the selected strips, models and base plates"
    shortcut = "E, X"

    def run(self) -> None:
        """Open the panel."""
        show_panel(ExportPanel, chosen_sources())
