"""Registers the workbench, its preferences page and its translations; FreeCAD imports this at its start."""

import time
from typing import Any

import FreeCADGui as Gui
from freecad.elastica_wb.text import RESOURCES, icon

JUST_NOW = 2.0  # s: opening a sketch switches to the Sketcher before anybody is told


class ElasticaWorkbench(Gui.Workbench):
    """Strips that bend into drawn curves."""

    MenuText = "Elastica"
    ToolTip = "Flat strips that bend into drawn curves"
    Icon = icon("Elastica")

    def __init__(self) -> None:
        self.left = 0.0
        self.active = False

    def GetClassName(self) -> str:
        """A workbench written in Python."""
        return "Gui::PythonWorkbench"

    def Initialize(self) -> None:
        """First activation: commands, menus, live feedback."""
        from freecad.elastica_wb import commands, live

        commands.register()
        for name, members in commands.TOOLBARS.items():
            self.appendToolbar(name, list(members))
        self.appendMenu("Elastica", list(commands.MENU))
        live.install(self.was_active)

    def Activated(self) -> None:
        """The user comes here."""
        self.active = True

    def Deactivated(self) -> None:
        """The user, or a sketch that he opens here, leaves for another workbench."""
        self.active, self.left = False, time.monotonic()

    def was_active(self) -> bool:
        """Is it this workbench from which a sketch is being opened?"""
        return self.active or time.monotonic() - self.left < JUST_NOW


def _begin() -> Any:
    Gui.addLanguagePath(str(RESOURCES / "translations"))
    Gui.updateLocale()
    Gui.addIconPath(str(RESOURCES / "icons"))
    Gui.addPreferencePage(str(RESOURCES / "ui" / "preferences.ui"), "Elastica")
    workbench = ElasticaWorkbench()
    Gui.addWorkbench(workbench)
    return workbench


WORKBENCH = _begin()
