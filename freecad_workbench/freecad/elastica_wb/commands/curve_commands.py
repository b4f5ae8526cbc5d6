# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Commands for curves: live feedback, check, nearest curve, projective edit, sections of bodies."""

from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
from freecad.elastica_wb.commands.command import Command, answers, edit_new, show_panel
from freecad.elastica_wb.commands.selection import chosen_curves, chosen_sketch, is_curve_chosen
from freecad.elastica_wb.curves.plane_sections import chosen_bodies, is_path
from freecad.elastica_wb.features import curves
from freecad.elastica_wb.host.resources import QT_TRANSLATE_NOOP
from freecad.elastica_wb.live import observers
from freecad.elastica_wb.live.sketches import edited_sketch
from freecad.elastica_wb.panels import between_clamps
from freecad.elastica_wb.panels.check import CheckPanel
from freecad.elastica_wb.panels.projective import ProjectivePanel


class CurveCommand(Command):
    """A command that needs a curve."""

    in_sketch = True

    def has_subject(self) -> bool:
        """Return True if a curve is selected or its sketch is open."""
        return App.ActiveDocument is not None and is_curve_chosen()


class CheckCommand(CurveCommand):
    """Reports whether the curve can be bent, and shows the overlay."""

    name = "Elastica_Check"
    text = QT_TRANSLATE_NOOP("Elastica_Check", "Check curve")
    tip = QT_TRANSLATE_NOOP(
        "Elastica_Check", "Say whether a flat strip can take the selected curve, and if not why and where"
    )
    shortcut = "Y, C"

    def run(self) -> None:
        """Turn the overlay on in the sketcher, or else open a panel with the full verdict."""
        (source, edges), *_ = chosen_curves()
        if edited_sketch() is source:
            observers.switch(source, on=True)
            return
        show_panel(CheckPanel, source, edges)


class NearestCommand(CurveCommand):
    """Makes the nearest curve that a strip can take within limits."""

    name = "Elastica_Nearest"
    text = QT_TRANSLATE_NOOP("Elastica_Nearest", "Nearest curve to sketch")
    tip = QT_TRANSLATE_NOOP(
        "Elastica_Nearest", "Find the curve nearest to the selected sketch that can be bent within limits"
    )
    shortcut = "Y, N"

    def run(self) -> None:
        """Make the nearest curve as a feature and open its panel."""
        (source, edges), *_ = chosen_curves()
        edit_new(self.text, curves.nearest, source, edges)


class BetweenCommand(Command):
    """Draws the curve of a strip of given length between two clamps."""

    name = "Elastica_Between"
    text = QT_TRANSLATE_NOOP("Elastica_Between", "Curve of given length")
    tip = QT_TRANSLATE_NOOP(
        "Elastica_Between",
        "Draw the curve that a strip of given length takes between two clamps into the open sketch; pull its ends",
    )
    shortcut = "Y, E"
    in_sketch = True

    def has_subject(self) -> bool:
        """Return True if a sketch is open."""
        return edited_sketch() is not None

    def run(self) -> None:
        """Start or end the drawing between two clamps."""
        between_clamps.switch()


class ProjectiveCommand(CurveCommand):
    """Edits a curve by four handles. A curve that can be bent stays bendable."""

    name = "Elastica_Projective"
    text = QT_TRANSLATE_NOOP("Elastica_Projective", "Projective edit")
    tip = QT_TRANSLATE_NOOP(
        "Elastica_Projective",
        "Pull the selected sketch's curve by four handles: lines stay lines, a curve that can be bent stays one",
    )
    shortcut = "Y, P"

    def run(self) -> None:
        """Open the panel."""
        show_panel(ProjectivePanel, chosen_sketch())


class SectionCommand(Command):
    """Cuts a body or a mesh by planes into curves for strips."""

    name = "Elastica_Section"
    text = QT_TRANSLATE_NOOP("Elastica_Section", "Section into curves")
    tip = QT_TRANSLATE_NOOP(
        "Elastica_Section",
        "Cut the selected body, surface or mesh by planes into smooth curves that strips can follow",
    )

    def has_subject(self) -> bool:
        """Return True if something to cut is selected."""
        return answers(_bodies_and_path)

    def run(self) -> None:
        """Make the curves and open their panel."""
        edit_new(self.text, curves.section, *_bodies_and_path())


def _bodies_and_path() -> tuple[list[Any], Any]:
    """Return the bodies to cut and the path of the planes: a selected sketch, wire or chain of edges."""
    paths, others = [], []
    for choice in Gui.Selection.getSelectionEx():
        edges = tuple(name for name in choice.SubElementNames if name.startswith("Edge"))
        if edges or is_path(choice.Object):
            paths.append((choice.Object, edges))
        else:
            others.append(choice.Object)
    if not others:  # edges of the body itself
        others = [obj for obj, edges in paths if edges]
    return chosen_bodies(others), paths[0] if paths else None
