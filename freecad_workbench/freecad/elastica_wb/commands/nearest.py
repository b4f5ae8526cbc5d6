"""Nearest curve to sketch."""

from freecad.elastica_wb.commands.base import Command, chosen_curves, show_panel
from freecad.elastica_wb.drawn import is_sketch
from freecad.elastica_wb.panels.nearest import NearestPanel
from freecad.elastica_wb.text import tr

from elastica_cad.errors import InputError

__all__ = ["NearestCommand"]


class NearestCommand(Command):
    """The curve nearest to a sketch that a strip can take, within limits."""

    name = "Elastica_Nearest"
    text = "Nearest curve to sketch"
    tip = "Find the curve nearest to the selected sketch that can be bent within limits"
    shortcut = "E, N"

    def run(self) -> None:
        """Open the panel."""
        (source, edges), *_ = chosen_curves()
        if edges or not is_sketch(source):
            raise InputError(tr("Select a sketch with a spline first."))
        show_panel(NearestPanel, source)
