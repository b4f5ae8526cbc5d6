# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Base class of the commands, and the command that switches live feedback.

FreeCAD imports this module when it starts, so large modules are imported on first use.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
from freecad.elastica_wb.host.resources import QT_TRANSLATE_NOOP, icon
from freecad.elastica_wb.live import observers, sketches


def has_document() -> bool:
    """Return True if a document is open."""
    return App.ActiveDocument is not None


@dataclass(frozen=True)
class Command:
    """A command with its texts, undo step and error messages.

    Attributes
    ----------
    name, text, tip, shortcut : str
        Texts of the command. FreeCAD translates them in the context `name`, which is also the name of the
        icon.
    run : callable
        Function that does the work. It raises `ElasticaError` with a message if it fails.
    has_subject : callable
        Function that returns True if an object for the command is selected or can be guessed.
    in_sketch : bool
        True if the command can be used while a sketch is open. It closes the sketch if necessary.
    checkable : bool
        True if the command switches a state on and off.
    """

    name: str
    text: str
    tip: str
    run: Callable[[], None]
    has_subject: Callable[[], bool] = has_document
    shortcut: str = ""
    in_sketch: bool = True
    checkable: bool = False

    def GetResources(self) -> dict[str, str | bool]:
        """Return the icon, texts and shortcut of the command."""
        resources = {
            "Pixmap": icon(self.name),
            "MenuText": self.text,
            "ToolTip": self.tip,
            "WhatsThis": self.name,
            "StatusTip": self.tip,
            "Accel": self.shortcut,
            # while a sketch is open, FreeCAD enables only commands of the type "ForEdit"
            "CmdType": "ForEdit" if self.in_sketch else "",
        }
        # in FreeCAD, the value of "Checkable" is the initial check mark
        return resources | ({"Checkable": False} if self.checkable else {})

    def IsActive(self) -> bool:
        """Return True if the command can be used now. FreeCAD calls this method several times a second."""
        if Gui.Control.activeDialog() and not (self.in_sketch and sketches.is_sketch_open()):
            return False
        return self.has_subject()

    def Activated(self, _index: int = 0) -> None:
        """Run the command, and show its error if it fails."""
        from freecad.elastica_wb.host.dialogs import show_message
        from freecad.elastica_wb.host.refusal import FAILURES, explained
        from freecad.elastica_wb.panels.panel import bring_into_view
        from freecad.elastica_wb.undo_steps import active_steps, undo_new_steps

        before, present = active_steps(), _objects()
        try:
            self.run()
            if new := [obj for obj in _objects() if obj not in present]:
                bring_into_view(new)
        except FAILURES as error:
            undo_new_steps(before)
            show_message(str(explained(error)))


def _objects() -> list[Any]:
    return App.ActiveDocument.Objects if has_document() else []


def _switch_overlay() -> None:
    sketch = sketches.edited_sketch()
    observers.switch(sketch, on=not observers.is_on(sketch))


LIVE = Command(
    name="Elastica_Live",
    text=QT_TRANSLATE_NOOP("Elastica_Live", "Live feedback"),
    tip=QT_TRANSLATE_NOOP(
        "Elastica_Live",
        "Show over the open sketch whether a flat strip can take its curve, while it is drawn and dragged",
    ),
    run=_switch_overlay,
    has_subject=sketches.is_sketch_open,
    shortcut="Y, L",
    checkable=True,
)


class LiveManipulator:
    """Adds the commands for an open sketch to the sketcher's toolbar and menu (FreeCAD 1.0 and later)."""

    def modifyToolBars(self) -> list[dict[str, str]]:
        """Insert the commands before the sketcher's button for the section view."""
        return [{"insert": name, "toolItem": "Sketcher_ViewSection"} for name in _registered_names()]

    def modifyMenuBar(self) -> list[dict[str, str]]:
        """Add the commands to the sketcher's menu."""
        return [{"append": name, "menuItem": "Sketcher_ViewSection"} for name in _registered_names()]


def _registered_names() -> list[str]:
    return [name for name in (LIVE.name, "Elastica_Between") if name in Gui.listCommands()]


def register() -> None:
    """Register the command for live feedback, with its place in the sketcher's toolbar and menu."""
    if LIVE.name not in Gui.listCommands():
        Gui.addCommand(LIVE.name, LIVE)
    sketches.listeners.append(_show_state)
    if hasattr(Gui, "addWorkbenchManipulator"):
        Gui.addWorkbenchManipulator(LiveManipulator())


def _show_state(on: bool) -> None:
    command = Gui.Command.get(LIVE.name)
    for action in command.getAction() if command is not None else []:
        action.blockSignals(True)
        action.setChecked(on)
        action.blockSignals(False)
