# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The command for live feedback. It is registered when FreeCAD starts, so it works in every workbench."""

from typing import Any

import FreeCADGui as Gui
from freecad.elastica_wb.host.resources import QT_TRANSLATE_NOOP, icon
from freecad.elastica_wb.live import observers, sketches

NAME, BETWEEN = "Elastica_Live", "Elastica_Between"


class LiveCommand:
    """Turns the overlay of the open sketch on and off. The sketch stores the state."""

    name = NAME
    text = QT_TRANSLATE_NOOP("Elastica_Live", "Live feedback")
    tip = QT_TRANSLATE_NOOP(
        "Elastica_Live",
        "Show over the open sketch whether a flat strip can take its curve, while it is drawn and dragged",
    )
    shortcut = "Y, L"

    def GetResources(self) -> dict[str, Any]:
        """Return icon, texts and shortcut."""
        return {
            "Pixmap": icon(self.name),
            "MenuText": self.text,
            "ToolTip": self.tip,
            "StatusTip": self.tip,
            "WhatsThis": self.name,
            "Accel": self.shortcut,
            "CmdType": "ForEdit",
            "Checkable": False,  # this means checkable, but not checked
        }

    def IsActive(self) -> bool:
        """Return True if a sketch is open."""
        return sketches.edited_sketch() is not None

    def Activated(self, _index: int = 0) -> None:
        """Toggle the overlay."""
        sketch = sketches.edited_sketch()
        if sketch is not None:
            observers.switch(sketch, on=not observers.is_on(sketch))


class LiveManipulator:
    """Adds the commands for an open sketch to the sketcher's tools (FreeCAD 1.0 and later)."""

    def modifyToolBars(self) -> list[dict[str, str]]:
        """Insert the commands before the command that shows a section of the sketch."""
        return [{"insert": name, "toolItem": "Sketcher_ViewSection"} for name in _known()]

    def modifyMenuBar(self) -> list[dict[str, str]]:
        """Add the commands to the sketcher's menu."""
        return [{"append": name, "menuItem": "Sketcher_ViewSection"} for name in _known()]


def _known() -> list[str]:
    """Return the live command, and the tool for sketches if the workbench has been opened."""
    return [name for name in (NAME, BETWEEN) if name in Gui.listCommands()]


def register() -> None:
    """Register the command, and keep its check mark in step with the overlay."""
    if NAME not in Gui.listCommands():
        Gui.addCommand(NAME, LiveCommand())
    sketches.listeners.append(_show_state)
    if hasattr(Gui, "addWorkbenchManipulator"):
        Gui.addWorkbenchManipulator(LiveManipulator())


def _show_state(on: bool) -> None:
    command = Gui.Command.get(NAME)
    for action in command.getAction() if command is not None else []:
        action.blockSignals(True)  # only the display changes
        action.setChecked(on)
        action.blockSignals(False)
