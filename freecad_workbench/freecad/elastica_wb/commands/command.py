# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""What all commands share: how they look, when they can be used, one undo step, errors as sentences."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
from freecad.elastica_wb.host.refusal import FAILURES, explained
from freecad.elastica_wb.host.resources import icon
from freecad.elastica_wb.host.telling import tell
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
    """A command; `run` does the work and raises `ElasticaError` with a sentence where it cannot."""

    name = "Elastica"
    text = ""
    tip = ""
    shortcut = ""
    in_sketch = False
    """Can it be used while a sketch is open? It then closes the sketch where it must."""

    def GetResources(self) -> dict[str, str]:
        """Return icon, words and keys; FreeCAD translates the words with the command's name as context."""
        found = {"Pixmap": icon(self.name), "MenuText": self.text, "ToolTip": self.tip}
        found |= {"WhatsThis": self.name, "StatusTip": self.tip}
        if self.in_sketch:
            found["CmdType"] = "ForEdit"  # FreeCAD greys out all others while something is edited
        return found | ({"Accel": self.shortcut} if self.shortcut else {})

    def IsActive(self) -> bool:
        """Is there what it works on, and no panel in the way? FreeCAD asks several times a second."""
        if Gui.Control.activeDialog() and not (self.in_sketch and edited_sketch() is not None):
            return False
        return self.has_subject()

    def has_subject(self) -> bool:
        """Is what the command works on selected or alone in the document?"""
        return App.ActiveDocument is not None

    def Activated(self, _index: int = 0) -> None:
        """Run the command, and show an error where it refuses."""
        step = App.getActiveTransaction()
        try:
            self.run()
        except FAILURES as error:
            if App.getActiveTransaction() != step:
                record_abort()
            tell(str(explained(error)))

    def run(self) -> None:
        """Do what the command is for; each command defines this."""
        raise NotImplementedError


def answers(question: Callable[..., Any], *arguments: Any, **options: Any) -> bool:
    """Does a question about the selection have an answer?"""
    with suppress(ElasticaError):
        return App.ActiveDocument is not None and bool(question(*arguments, **options))
    return False


def show_panel(make: Callable[..., Any], *arguments: Any) -> None:
    """Close the sketcher, then open a panel."""
    if edited_sketch() is not None:
        Gui.ActiveDocument.resetEdit()
    Gui.Control.showDialog(make(*arguments))


def edit_new(step: str, make: Callable[..., Any], *arguments: Any) -> None:
    """Make a feature in the open document and open its panel: one undo step until OK."""
    record_step(App.ActiveDocument, step)  # first, or it bears FreeCAD's name for closing the sketch
    if edited_sketch() is not None:
        Gui.ActiveDocument.resetEdit()
    made = recorded(make, App.ActiveDocument, *arguments)
    record_recompute(App.ActiveDocument)
    show_panel(panel_of, made)


@contextmanager
def undo_step(document: Any, name: str) -> Iterator[None]:
    """Everything inside is one step of the undo history, or after an error none."""
    record_step(document, name)
    try:
        yield
    except BaseException:
        record_end_of_step(document, abort=True)
        raise
    record_end_of_step(document)
