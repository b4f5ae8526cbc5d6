# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Registration of the workbench, its preferences page and its translations, when FreeCAD starts."""

from collections.abc import Iterator
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
from freecad.elastica_wb import command
from freecad.elastica_wb.features.views import KINDS, View
from freecad.elastica_wb.host import preferences
from freecad.elastica_wb.host.objects import view_providers
from freecad.elastica_wb.host.resources import RESOURCES, icon, load_panel
from freecad.elastica_wb.live import observers

translate = App.Qt.translate


class ElasticaWorkbench(Gui.Workbench):
    """FreeCAD workbench for strips that bend into drawn curves."""

    MenuText = translate("Workbench", "Elastica")
    ToolTip = translate("Workbench", "Flat strips that bend into drawn curves")
    Icon = icon("Elastica")

    def GetClassName(self) -> str:
        """Return FreeCAD's class for workbenches written in Python."""
        return "Gui::PythonWorkbench"

    def Initialize(self) -> None:
        """Add commands, toolbars and menus when the workbench is first activated."""
        import SketcherGui  # noqa: F401 - makes FreeCAD register the command for sketches
        from freecad.elastica_wb import commands

        commands.register()
        for name, members in commands.TOOLBARS.items():
            self.appendToolbar(name, members)
        self.appendMenu("Elastica", commands.MENU)

    def ContextMenu(self, _recipient: str) -> None:
        """Add the commands that apply to the selection to the context menu."""
        from freecad.elastica_wb import commands

        names = commands.context_menu()
        if names:
            self.appendContextMenu("", names)


def _panel_of(obj: Any) -> Any:
    """Import the module of panels only when the first panel opens."""
    from freecad.elastica_wb.panels.feature_panels import panel_of

    return panel_of(obj)


class PreferencesPage:
    """The page of the workbench in FreeCAD's preferences."""

    def __init__(self, _parent: Any = None) -> None:
        from freecad.elastica_wb.host.fields import put_sheets
        from freecad.elastica_wb.host.sheet_store import sheet_list

        self.form = load_panel("preferences")
        put_sheets(self.form.defaultSheet, sheet_list())

    def loadSettings(self) -> None:
        """Set the widgets to the stored preferences."""
        from freecad.elastica_wb.host.fields import set_value

        for name, widget in self._widgets():
            set_value(widget, preferences.get(name))

    def saveSettings(self) -> None:
        """Store the values of the widgets as preferences."""
        from freecad.elastica_wb.host.fields import value_of

        for name, widget in self._widgets():
            preferences.put(name, value_of(widget))

    def _widgets(self) -> Iterator[tuple[str, Any]]:
        for name in preferences.DEFAULTS:
            widget = getattr(self.form, name[0].lower() + name[1:], None)
            if widget is not None:
                yield name, widget


def _begin() -> Any:
    Gui.addLanguagePath(str(RESOURCES / "translations"))
    Gui.updateLocale()
    Gui.addIconPath(str(RESOURCES / "icons"))
    Gui.addPreferencePage(PreferencesPage, "Elastica")
    view_providers.update(KINDS)
    View.panel_of = staticmethod(_panel_of)
    observers.install()
    command.register()
    workbench = ElasticaWorkbench()
    Gui.addWorkbench(workbench)
    return workbench


WORKBENCH = _begin()
