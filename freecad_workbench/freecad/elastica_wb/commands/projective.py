"""Projective edit."""

from freecad.elastica_wb.commands.base import Command, chosen_curves, show_panel
from freecad.elastica_wb.drawn import is_sketch
from freecad.elastica_wb.panels.projective import ProjectivePanel
from freecad.elastica_wb.text import tr

from elastica_cad.errors import InputError

__all__ = ["ProjectiveCommand"]


class ProjectiveCommand(Command):
    """Four handles about a curve; what could be bent still can."""

    name = "Elastica_Projective"
    text = "Projective edit"
    tip = "Pull the selected sketch's curve by four handles: lines stay lines, a curve that can be bent stays one"
    shortcut = "E, P"

    def run(self) -> None:
        """Open the panel."""
        (source, edges), *_ = chosen_curves()
        if edges or not is_sketch(source):
            raise InputError(tr("Select a sketch with a spline first."))
        show_panel(ProjectivePanel, source)
