"""Section an object by planes into curves."""

import FreeCADGui as Gui
from freecad.elastica_wb.commands.base import Command, show_panel
from freecad.elastica_wb.panels.section import SectionPanel
from freecad.elastica_wb.sections import chosen_bodies, is_path

__all__ = ["SectionCommand"]


class SectionCommand(Command):
    """Plane sections of a body or a mesh, as curves for strips."""

    name = "Elastica_Section"
    text = "Section into curves"
    tip = "Cut the selected body, surface or mesh by planes into smooth curves that strips can follow"

    def run(self) -> None:
        """Open the panel; a sketch, a wire or edges selected too are the path that planes stand across."""
        paths, others = [], []
        for choice in Gui.Selection.getSelectionEx():
            edges = tuple(name for name in choice.SubElementNames if name.startswith("Edge"))
            if edges or is_path(choice.Object):
                paths.append((choice.Object, edges))
            else:
                others.append(choice.Object)
        if not others:  # edges of the body itself
            others = [obj for obj, edges in paths if edges]
        show_panel(SectionPanel, chosen_bodies(others), paths[0] if paths else None)
