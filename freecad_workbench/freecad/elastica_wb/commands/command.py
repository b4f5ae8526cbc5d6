# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Base of all commands: texts, availability, undo steps and error messages."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
from freecad.elastica_wb.host.dialogs import tell
from freecad.elastica_wb.host.refusal import FAILURES, explained
from freecad.elastica_wb.host.resources import icon
from freecad.elastica_wb.live.sketches import edited_sketch
from freecad.elastica_wb.panels.feature_panels import panel_of
from freecad.elastica_wb.recording import (
    record_abort,
    record_end_of_step,
    record_recompute,
    record_step,
    recorded,
)

from elastica_cad.errors import ElasticaError


class Command:
    """A command. `run` does the work and raises `ElasticaError` with a message if it fails."""

    name = "Elastica"
    text = ""
    tip = ""
    shortcut = ""
    in_sketch = False
    """True if the command can be used while a sketch is open. It closes the sketch if necessary."""

    def GetResources(self) -> dict[str, str]:
        """Return icon, texts and shortcut. FreeCAD translates the texts in the context of the command's name."""
        resources = {"Pixmap": icon(self.name), "MenuText": self.text, "ToolTip": self.tip}
        resources |= {"WhatsThis": self.name, "StatusTip": self.tip}
        if self.in_sketch:
            resources["CmdType"] = "ForEdit"  # FreeCAD disables all other commands during editing
        return resources | ({"Accel": self.shortcut} if self.shortcut else {})

    def IsActive(self) -> bool:
        """Return True if the command can be used now. FreeCAD calls this several times a second."""
        if Gui.Control.activeDialog() and not (self.in_sketch and edited_sketch() is not None):
            return False
        return self.has_subject()

    def has_subject(self) -> bool:
        """Return True if an object for the command is selected, or is the only candidate."""
        return App.ActiveDocument is not None

    def Activated(self, _index: int = 0) -> None:
        """Run the command, and show its error if it fails."""
        step = App.getActiveTransaction()
        try:
            self.run()
        except FAILURES as error:
            if App.getActiveTransaction() != step:
                record_abort()
            tell(str(explained(error)))

    def run(self) -> None:
        """Do the command's work. Each command defines this method."""
        raise NotImplementedError


def answers(question: Callable[..., Any], *arguments: Any, **options: Any) -> bool:
    """Return True if a function of the selection succeeds with a true result."""
    with suppress(ElasticaError):
        return App.ActiveDocument is not None and bool(question(*arguments, **options))
    return False


def show_panel(make: Callable[..., Any], *arguments: Any) -> None:
    """Close the sketcher, then open a panel."""
    if edited_sketch() is not None:
        Gui.ActiveDocument.resetEdit()
    Gui.Control.showDialog(make(*arguments))


def edit_new(step: str, make: Callable[..., Any], *arguments: Any) -> None:
    """Make a feature in the open document and open its panel, in one undo step until OK."""
    record_step(App.ActiveDocument, step)  # first, otherwise FreeCAD names the step after closing the sketch
    if edited_sketch() is not None:
        Gui.ActiveDocument.resetEdit()
    feature = recorded(make, App.ActiveDocument, *arguments)
    record_recompute(App.ActiveDocument)
    show_panel(panel_of, feature)


@contextmanager
def undo_step(document: Any, name: str) -> Iterator[None]:
    """Make all changes inside one undo step. Take them back after an error."""
    record_step(document, name)
    try:
        yield
    except BaseException:
        record_end_of_step(document, abort=True)
        raise
    record_end_of_step(document)
