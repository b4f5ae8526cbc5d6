# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The command for live feedback. It is registered when FreeCAD starts, so it works in every workbench."""

import FreeCADGui as Gui
from freecad.elastica_wb.command import Command
from freecad.elastica_wb.host.resources import QT_TRANSLATE_NOOP
from freecad.elastica_wb.live import observers, sketches

BETWEEN = "Elastica_Between"


def _toggle() -> None:
    """Turn the overlay of the open sketch on or off. The sketch stores the state."""
    sketch = sketches.edited_sketch()
    observers.switch(sketch, on=not observers.is_on(sketch))


LIVE = Command(
    name="Elastica_Live",
    text=QT_TRANSLATE_NOOP("Elastica_Live", "Live feedback"),
    tip=QT_TRANSLATE_NOOP(
        "Elastica_Live",
        "Show over the open sketch whether a flat strip can take its curve, while it is drawn and dragged",
    ),
    run=_toggle,
    has_subject=sketches.is_sketch_open,
    shortcut="Y, L",
    in_sketch=True,
    checkable=True,
)


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
    return [name for name in (LIVE.name, BETWEEN) if name in Gui.listCommands()]


def register() -> None:
    """Register the command, and keep its check mark in step with the overlay."""
    if LIVE.name not in Gui.listCommands():
        Gui.addCommand(LIVE.name, LIVE)
    sketches.listeners.append(_show_state)
    if hasattr(Gui, "addWorkbenchManipulator"):
        Gui.addWorkbenchManipulator(LiveManipulator())


def _show_state(on: bool) -> None:
    command = Gui.Command.get(LIVE.name)
    for action in command.getAction() if command is not None else []:
        action.blockSignals(True)  # only the display changes
        action.setChecked(on)
        action.blockSignals(False)
