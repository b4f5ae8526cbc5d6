"""Section an object by planes into curves."""

import FreeCADGui as Gui
from freecad.elastica_wb.commands.base import Command, show_panel
from freecad.elastica_wb.panels.section import SectionPanel
from freecad.elastica_wb.sections import chosen_bodies

__all__ = ["SectionCommand"]


class SectionCommand(Command):
    """Plane sections of a body, as curves for strips."""

    name = "Elastica_Section"
    text = "Section into curves"
    tip = "Cut the selected object by parallel planes into smooth curves that strips can follow"

    def run(self) -> None:
        """Open the panel."""
        show_panel(SectionPanel, chosen_bodies(Gui.Selection.getSelection()))
