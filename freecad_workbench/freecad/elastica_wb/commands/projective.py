"""Projective edit."""

from freecad.elastica_wb.commands.base import Command, chosen_sketch, show_panel
from freecad.elastica_wb.panels.projective import ProjectivePanel

__all__ = ["ProjectiveCommand"]


class ProjectiveCommand(Command):
    """Four handles about a curve; what could be bent still can."""

    name = "Elastica_Projective"
    text = "Projective edit"
    tip = "Pull the selected sketch's curve by four handles: lines stay lines, a curve that can be bent stays one"
    shortcut = "E, P"

    def run(self) -> None:
        """Open the panel."""
        show_panel(ProjectivePanel, chosen_sketch())
