# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Commands about strips: make them, change their style, bend them, vary them."""

from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
from freecad.elastica_wb import make_strip
from freecad.elastica_wb.commands.command import Command, answers, show_panel
from freecad.elastica_wb.commands.curve_commands import CurveCommand
from freecad.elastica_wb.commands.selection import chosen_curves, chosen_strips
from freecad.elastica_wb.features import flat
from freecad.elastica_wb.host import preferences
from freecad.elastica_wb.host.resources import QT_TRANSLATE_NOOP
from freecad.elastica_wb.live.sketches import edited_sketch
from freecad.elastica_wb.panels.bend import BendPanel
from freecad.elastica_wb.panels.feature_panels import panel_of
from freecad.elastica_wb.panels.tolerance import TolerancePanel
from freecad.elastica_wb.recording import record_recompute, record_step, record_value, recorded


class OnStrips(Command):
    """A command that needs a strip."""

    in_sketch = True

    def has_subject(self) -> bool:
        """Return True if a strip is selected, or is the only strip of the document."""
        return answers(chosen_strips)


class StripCommand(CurveCommand):
    """Makes a bent strip on the curve and its flat part, and opens the panel with sheet and widths."""

    name = "Elastica_Strip"
    text = QT_TRANSLATE_NOOP("Elastica_Strip", "Strip from sketch")
    tip = QT_TRANSLATE_NOOP(
        "Elastica_Strip",
        "Make the flat strip that bends into the selected spline: the bent part and, linked to it, the flat one",
    )
    shortcut = "Y, S"

    def run(self) -> None:
        """Make a strip for every selected curve, and open one panel for all strips."""
        curves = chosen_curves()
        record_step(App.ActiveDocument, self.text)  # first, else FreeCAD names the step itself
        if edited_sketch() is not None:
            Gui.ActiveDocument.resetEdit()
        strips = [recorded(make_strip, source, edges, flat_part=False) for source, edges in curves]
        for strip in strips:
            _add_flat(strip)
        for source, _ in curves:
            source.Visibility = True
        show_panel(panel_of, strips[-1], strips)


def _add_flat(one: Any, layer: str = "Base") -> None:
    recorded(flat.create, one.Document, one, layer)
    record_recompute(one.Document)  # so that the next strip is placed beside it


def _even_out(strip: Any, style: str) -> None:
    """Give a strip a constant width. By default it is the largest width of the plain strip."""
    if (
        strip.Style == "Plain"
        and strip.MaxWidth.Value
        and strip.OuterWidth.Value == preferences.get("MaxWidth")
    ):
        record_value(strip, "OuterWidth", strip.MaxWidth.Value)
    record_value(strip, "Style", style)


class EditCommand(OnStrips):
    """One panel for all selected strips. Each change applies to all of them."""

    name = "Elastica_Edit"
    text = QT_TRANSLATE_NOOP("Elastica_Edit", "Edit strips")
    tip = QT_TRANSLATE_NOOP("Elastica_Edit", "Change sheet, widths and ends of all selected strips at once")

    def run(self) -> None:
        """Open the panel."""
        first, *others = chosen_strips()
        show_panel(panel_of, first, others)


class PerforateCommand(OnStrips):
    """Keeps the width constant and reduces the stiffness by holes."""

    name = "Elastica_Perforate"
    text = QT_TRANSLATE_NOOP("Elastica_Perforate", "Perforate")
    tip = QT_TRANSLATE_NOOP(
        "Elastica_Perforate",
        "Give the selected strips an even width and let holes make them as soft as they must be",
    )

    def run(self) -> None:
        """Change the style, and open the panel with widths and holes."""
        strips = chosen_strips()
        record_step(App.ActiveDocument, self.text)
        for chosen in strips:
            _even_out(chosen, "Perforated")
        record_recompute(App.ActiveDocument)
        show_panel(panel_of, strips[-1], strips)


class LaminateCommand(OnStrips):
    """Keeps the width constant and increases the stiffness by a narrower strip glued on."""

    name = "Elastica_Laminate"
    text = QT_TRANSLATE_NOOP("Elastica_Laminate", "Laminate")
    tip = QT_TRANSLATE_NOOP(
        "Elastica_Laminate",
        "Give the selected strips an even width and glue narrower strips on that make them stiff enough",
    )

    def run(self) -> None:
        """Change the style, add the flat part of the backing, and open the panel."""
        strips = chosen_strips()
        record_step(App.ActiveDocument, self.text)
        for chosen in strips:
            _even_out(chosen, "Laminated")
        record_recompute(App.ActiveDocument)
        for chosen in strips:
            if not any(part.Layer == "Backing" for part in flat.flats_of([chosen])):
                _add_flat(chosen, "Backing")
        show_panel(panel_of, strips[-1], strips)


class BendCommand(OnStrips):
    """Moves or turns an end of a strip and shows the new shape."""

    name = "Elastica_Bend"
    text = QT_TRANSLATE_NOOP("Elastica_Bend", "Bend forward")
    tip = QT_TRANSLATE_NOOP(
        "Elastica_Bend", "Move or turn the ends of the selected strip and watch it take its new rest shape"
    )
    shortcut = "Y, B"

    def run(self) -> None:
        """Open the panel."""
        show_panel(BendPanel, chosen_strips()[0])


class ToleranceCommand(OnStrips):
    """Shows how far a strip deviates if sheet, cut and clamps are not as designed."""

    name = "Elastica_Tolerance"
    text = QT_TRANSLATE_NOOP("Elastica_Tolerance", "Tolerance study")
    tip = QT_TRANSLATE_NOOP(
        "Elastica_Tolerance",
        "Find how far the bent strip strays when sheet, cut and clamps vary within their ranges",
    )

    def run(self) -> None:
        """Open the panel."""
        show_panel(TolerancePanel, chosen_strips()[0])
