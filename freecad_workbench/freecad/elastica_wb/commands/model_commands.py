# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Commands for models: interlock, end fixtures and base plate, nest."""

import FreeCAD as App
from freecad.elastica_wb.commands.command import Command, answers, show_panel, undo_step
from freecad.elastica_wb.commands.selection import chosen_sources, chosen_strips
from freecad.elastica_wb.features import flat, model, nest
from freecad.elastica_wb.host.dialogs import tell
from freecad.elastica_wb.host.refusal import why_not_made
from freecad.elastica_wb.host.resources import QT_TRANSLATE_NOOP
from freecad.elastica_wb.panels.feature_panels import panel_of
from freecad.elastica_wb.panels.fixtures import FixturesPanel
from freecad.elastica_wb.recording import record_recompute, record_step, record_value, recorded

from elastica_cad.errors import InputError


class OnParts(Command):
    """A command that needs an object to cut."""

    def has_subject(self) -> bool:
        """Return True if strips, models or base plates are selected, or if the document determines them."""
        return answers(chosen_sources)


class InterlockCommand(Command):
    """Makes slots where strips cross, so that they slide into each other."""

    name = "Elastica_Interlock"
    text = QT_TRANSLATE_NOOP("Elastica_Interlock", "Interlock selected strips")
    tip = QT_TRANSLATE_NOOP(
        "Elastica_Interlock", "Put the selected strips together to a model and cut slots where they cross"
    )
    shortcut = "Y, I"

    def has_subject(self) -> bool:
        """Return True if two or more strips are selected."""
        return answers(chosen_strips, least=2)

    def run(self) -> None:
        """Make the model, hide its single strips, and open the panel."""
        strips = chosen_strips(least=2)
        record_step(App.ActiveDocument, self.text)
        feature = recorded(model.create, App.ActiveDocument, strips)
        for part in flat.flats_of(strips):
            record_value(part, "Model", feature)
        record_recompute(App.ActiveDocument)
        failed = bool(why_not_made(feature))
        for strip in strips:
            if not failed:
                record_value(strip, "Visibility", False)
            elif strip.Visibility:  # nothing replaces the strip until the model can be made
                record_value(strip, "ShownByError", True)
        show_panel(panel_of, feature)


class FixturesCommand(OnParts):
    """Makes printed blocks for the ends, or one slotted plate for all."""

    name = "Elastica_Fixtures"
    text = QT_TRANSLATE_NOOP("Elastica_Fixtures", "End fixtures and base plate")
    tip = QT_TRANSLATE_NOOP(
        "Elastica_Fixtures",
        "Make printed blocks that hold the ends of the selected strips or model, or one slotted base plate",
    )

    def run(self) -> None:
        """Open the panel."""
        show_panel(FixturesPanel, chosen_sources())


class NestCommand(OnParts):
    """Arranges all parts on sheets."""

    name = "Elastica_Nest"
    text = QT_TRANSLATE_NOOP("Elastica_Nest", "Nest on sheets")
    tip = QT_TRANSLATE_NOOP(
        "Elastica_Nest",
        "Lay everything that must be cut for the selected strips, models and base plates on sheets",
    )

    def run(self) -> None:
        """Make the nest in front of all objects."""
        document = App.ActiveDocument
        sources = chosen_sources()
        failed = [message for message in map(why_not_made, sources) if message]
        if failed:
            raise InputError("; ".join(failed))
        with undo_step(document, self.text):
            feature = recorded(nest.create, document, sources)
            record_recompute(document)
        if "Invalid" in feature.State:  # keep it, because the parts may fit on other sheets
            tell(feature.getStatusString())
        elif feature.LeftOut or feature.Reports:
            tell("\n".join([*feature.LeftOut, *feature.Reports]))
