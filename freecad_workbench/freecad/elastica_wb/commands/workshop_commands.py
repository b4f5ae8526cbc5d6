# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Commands for the workshop: coupon, cutting files, sheets."""

import FreeCAD as App
from freecad.elastica_wb.commands.command import Command, show_panel
from freecad.elastica_wb.commands.model_commands import OnParts
from freecad.elastica_wb.commands.selection import chosen_sources
from freecad.elastica_wb.example import open_example
from freecad.elastica_wb.host.resources import QT_TRANSLATE_NOOP
from freecad.elastica_wb.panels.coupon import CouponPanel
from freecad.elastica_wb.panels.export import ExportPanel
from freecad.elastica_wb.panels.sheets import SheetsPanel


class CouponCommand(Command):
    """Makes a test strip to cut, hang over an edge and measure. The readings give the user's sheet."""

    name = "Elastica_Coupon"
    text = QT_TRANSLATE_NOOP("Elastica_Coupon", "Coupon and calibrate")
    tip = QT_TRANSLATE_NOOP(
        "Elastica_Coupon",
        "Make a test strip to hang over an edge, and turn its measured droop into a sheet of your own",
    )

    def run(self) -> None:
        """Open the panel."""
        show_panel(CouponPanel, App.ActiveDocument)


class ExportCommand(OnParts):
    """Writes DXF, SVG, STEP and a cut list."""

    name = "Elastica_Export"
    text = QT_TRANSLATE_NOOP("Elastica_Export", "Export cutting files")
    tip = QT_TRANSLATE_NOOP(
        "Elastica_Export",
        "Write DXF, SVG and STEP files, nest and cut list of the selected strips, models and base plates",
    )
    shortcut = "Y, X"
    in_sketch = True

    def run(self) -> None:
        """Open the panel."""
        show_panel(ExportPanel, chosen_sources())


class SheetsCommand(Command):
    """Shows the built-in sheets and edits the user's sheets."""

    name = "Elastica_Sheets"
    text = QT_TRANSLATE_NOOP("Elastica_Sheets", "Sheet library")
    tip = QT_TRANSLATE_NOOP(
        "Elastica_Sheets", "Look at the sheets that are known, with their sources, and keep your own"
    )
    in_sketch = True

    def run(self) -> None:
        """Open the panel."""
        show_panel(SheetsPanel)


class ExampleCommand(Command):
    """Opens an example in a new document."""

    name = "Elastica_Example"
    text = QT_TRANSLATE_NOOP("Elastica_Example", "Open an example")
    tip = QT_TRANSLATE_NOOP(
        "Elastica_Example",
        "Open a drawn arch with its strip and its flat part; drag its poles, change its sheet",
    )

    def has_subject(self) -> bool:
        """Return True: the command needs nothing."""
        return True

    def run(self) -> None:
        """Make the example document."""
        open_example()
