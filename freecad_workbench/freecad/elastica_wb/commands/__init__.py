# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The commands of the workbench, in the groups of its menu and its toolbars."""

from collections.abc import Iterable

from freecad.elastica_wb.commands.command import Command
from freecad.elastica_wb.commands.curve_commands import (
    BetweenCommand,
    CheckCommand,
    NearestCommand,
    ProjectiveCommand,
    SectionCommand,
)
from freecad.elastica_wb.commands.model_commands import FixturesCommand, InterlockCommand, NestCommand
from freecad.elastica_wb.commands.strip_commands import (
    BendCommand,
    EditCommand,
    LaminateCommand,
    PerforateCommand,
    StripCommand,
    ToleranceCommand,
)
from freecad.elastica_wb.commands.workshop_commands import (
    CouponCommand,
    ExampleCommand,
    ExportCommand,
    SheetsCommand,
)
from freecad.elastica_wb.live.live_command import NAME as LIVE

__all__ = ["COMMANDS", "MENU", "TOOLBARS", "context_menu", "register"]

SKETCH = "Sketcher_NewSketch"
DRAW = (BetweenCommand(), CheckCommand(), NearestCommand(), ProjectiveCommand(), SectionCommand())
STRIPS = (
    StripCommand(),
    EditCommand(),
    PerforateCommand(),
    LaminateCommand(),
    BendCommand(),
    ToleranceCommand(),
)
MODELS = (InterlockCommand(), FixturesCommand(), NestCommand(), ExportCommand())
WORKSHOP = (SheetsCommand(), CouponCommand())
EXAMPLE = ExampleCommand()

COMMANDS: tuple[Command, ...] = (*DRAW, *STRIPS, *MODELS, *WORKSHOP, EXAMPLE)


def _names(commands: Iterable[Command]) -> list[str]:
    return [command.name for command in commands]


TOOLBARS = {
    "Elastica": [SKETCH, LIVE, "Separator", *_names(DRAW), "Separator", *_names(STRIPS)],
    "Elastica models": [*_names(MODELS), "Separator", *_names(WORKSHOP)],
}
MENU = [*TOOLBARS["Elastica"], "Separator", *TOOLBARS["Elastica models"], "Separator", EXAMPLE.name]


def register() -> None:
    """Register all commands with FreeCAD."""
    import FreeCADGui as Gui

    known = set(Gui.listCommands())
    for command in COMMANDS:
        if command.name not in known:
            Gui.addCommand(command.name, command)


def context_menu() -> list[str]:
    """Return the commands of the context menu: those that work on the present selection."""
    import FreeCADGui as Gui

    if not Gui.Selection.getSelection():
        return []
    groups = [[c.name for c in group if c.has_subject() and c.IsActive()] for group in (DRAW, STRIPS, MODELS)]
    names: list[str] = []
    for group in filter(None, groups):
        names += ["Separator", *group] if names else group
    return names
