"""Strip from sketch."""

import FreeCAD as App
import FreeCADGui as Gui
from freecad.elastica_wb.commands.base import Command, chosen_curves, edited_sketch, show_panel
from freecad.elastica_wb.features import flat, strip
from freecad.elastica_wb.panels.strip import StripPanel

__all__ = ["StripCommand"]


class StripCommand(Command):
    """The bent strip on the curve and its flat twin, then the panel to choose sheet and widths."""

    name = "Elastica_Strip"
    text = "Strip from sketch"
    tip = "Make the flat strip that bends into the selected spline: the bent part and, linked to it, the flat one"
    shortcut = "E, S"

    def run(self) -> None:
        """One strip for every selected curve; the panel of the last one stays open."""
        curves = chosen_curves()
        document = App.ActiveDocument
        if edited_sketch() is not None:
            Gui.ActiveDocument.resetEdit()
        document.openTransaction("Strip from sketch")
        for source, edges in curves:
            made = strip.create(document, source, edges)
            flat.create(document, made)
        document.recompute()
        for source, _ in curves:
            source.Visibility = True
        show_panel(StripPanel, made)
