"""Perforate and Laminate."""

import FreeCAD as App
from freecad.elastica_wb.commands.base import Command, chosen_strips, show_panel
from freecad.elastica_wb.features import flat
from freecad.elastica_wb.panels.strip import StripPanel

__all__ = ["LaminateCommand", "PerforateCommand"]


class PerforateCommand(Command):
    """The strip keeps one width; holes make it as soft as it must be."""

    name = "Elastica_Perforate"
    text = "Perforate"
    tip = "Give the selected strips an even width and let holes make them as soft as they must be"

    def run(self) -> None:
        """Change the style, then the panel to choose widths and holes."""
        strips = chosen_strips()
        App.ActiveDocument.openTransaction(self.text)
        for strip in strips:
            strip.Style = "Perforated"
        App.ActiveDocument.recompute()
        show_panel(StripPanel, strips[-1])


class LaminateCommand(Command):
    """The strip keeps one width; a narrower one glued on makes it as stiff as it must be."""

    name = "Elastica_Laminate"
    text = "Laminate"
    tip = "Give the selected strips an even width and glue narrower strips on that make them stiff enough"

    def run(self) -> None:
        """Change the style, add the flat part of the backing, then the panel."""
        strips = chosen_strips()
        App.ActiveDocument.openTransaction(self.text)
        for strip in strips:
            strip.Style = "Laminated"
            flat.create(App.ActiveDocument, strip, "Backing")
        App.ActiveDocument.recompute()
        show_panel(StripPanel, strips[-1])
