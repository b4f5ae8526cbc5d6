"""The commands of the workbench, in the order of its menu."""

from freecad.elastica_wb.commands.base import Command
from freecad.elastica_wb.commands.bend import BendCommand
from freecad.elastica_wb.commands.check import CheckCommand
from freecad.elastica_wb.commands.coupon import CouponCommand
from freecad.elastica_wb.commands.export import ExportCommand
from freecad.elastica_wb.commands.libraries import LibrariesCommand
from freecad.elastica_wb.commands.models import FixturesCommand, InterlockCommand, NestCommand
from freecad.elastica_wb.commands.nearest import NearestCommand
from freecad.elastica_wb.commands.projective import ProjectiveCommand
from freecad.elastica_wb.commands.section import SectionCommand
from freecad.elastica_wb.commands.sheets import SheetsCommand
from freecad.elastica_wb.commands.strip import StripCommand
from freecad.elastica_wb.commands.styles import LaminateCommand, PerforateCommand
from freecad.elastica_wb.commands.tolerance import ToleranceCommand

__all__ = ["COMMANDS", "MENU", "TOOLBARS", "register"]

COMMANDS: tuple[Command, ...] = (
    CheckCommand(),
    StripCommand(),
    NearestCommand(),
    ProjectiveCommand(),
    PerforateCommand(),
    LaminateCommand(),
    InterlockCommand(),
    FixturesCommand(),
    SectionCommand(),
    BendCommand(),
    ToleranceCommand(),
    CouponCommand(),
    NestCommand(),
    ExportCommand(),
    SheetsCommand(),
    LibrariesCommand(),
)
MENU = tuple(command.name for command in COMMANDS)
TOOLBARS = {"Elastica": MENU[:-1]}


def register() -> None:
    """Make FreeCAD know the commands."""
    import FreeCADGui as Gui

    known = set(Gui.listCommands())
    for command in COMMANDS:
        if command.name not in known:
            Gui.addCommand(command.name, command)
