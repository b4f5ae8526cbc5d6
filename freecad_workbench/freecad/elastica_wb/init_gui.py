# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Registers the workbench, its preferences page and its translations; FreeCAD imports this at its start."""

from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
from freecad.elastica_wb import command
from freecad.elastica_wb.features.views import KINDS, View
from freecad.elastica_wb.host.objects import view_providers
from freecad.elastica_wb.host.resources import RESOURCES, icon
from freecad.elastica_wb.live import observers

translate = App.Qt.translate


class ElasticaWorkbench(Gui.Workbench):
    """Strips that bend into drawn curves."""

    MenuText = translate("Workbench", "Elastica")
    ToolTip = translate("Workbench", "Flat strips that bend into drawn curves")
    Icon = icon("Elastica")

    def GetClassName(self) -> str:
        """Return FreeCAD's class for workbenches written in Python."""
        return "Gui::PythonWorkbench"

    def Initialize(self) -> None:
        """Add commands, toolbars and menus when the workbench is first activated."""
        import SketcherGui  # noqa: F401 - for the command that makes a sketch
        from freecad.elastica_wb import commands

        commands.register()
        for name, members in commands.TOOLBARS.items():
            self.appendToolbar(name, members)
        self.appendMenu("Elastica", commands.MENU)

    def ContextMenu(self, _recipient: str) -> None:
        """Add the commands for the selection to the context menu of the tree and the view."""
        from freecad.elastica_wb import commands

        names = commands.context_menu()
        if names:
            self.appendContextMenu("", names)


def _panel_of(obj: Any) -> Any:
    """Return the panel of a feature. The panels are imported when the first panel opens."""
    from freecad.elastica_wb.panels.feature_panels import panel_of

    return panel_of(obj)


def _begin() -> Any:
    Gui.addLanguagePath(str(RESOURCES / "translations"))
    Gui.updateLocale()
    Gui.addIconPath(str(RESOURCES / "icons"))
    Gui.addPreferencePage(str(RESOURCES / "ui" / "preferences.ui"), "Elastica")
    view_providers.update(KINDS)
    View.panel_of = staticmethod(_panel_of)
    observers.install()
    command.register()
    workbench = ElasticaWorkbench()
    Gui.addWorkbench(workbench)
    return workbench


WORKBENCH = _begin()
