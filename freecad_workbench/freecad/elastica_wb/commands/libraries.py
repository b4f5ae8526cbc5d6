"""Install missing libraries, after asking."""

import FreeCADGui as Gui
from freecad.elastica_wb.commands.base import Command, tell
from freecad.elastica_wb.libraries import OPTIONAL, install, missing
from freecad.elastica_wb.qt import QtWidgets
from freecad.elastica_wb.text import tr

__all__ = ["LibrariesCommand", "offer"]


class LibrariesCommand(Command):
    """highspy and ezdxf, without touching FreeCAD's numpy."""

    name = "Elastica_Libraries"
    text = "Install missing libraries"
    tip = "Install the optional libraries that FreeCAD does not bring: ezdxf (DXF files), highspy (faster)"
    needs_document = False

    def run(self) -> None:
        """Ask, then install."""
        wanted = missing()
        if not wanted:
            tell(tr("All optional libraries are installed."))
            return
        offer(wanted)


def offer(names: list[str]) -> bool:
    """Ask whether to install these libraries, and do it; True when they are there afterwards."""
    reasons = "\n".join(f"{name}: {tr(OPTIONAL[name])}" for name in names)
    question = tr("Download and install into FreeCAD's own folder?") + f"\n\n{reasons}"
    answer = QtWidgets.QMessageBox.question(Gui.getMainWindow(), "Elastica", question)
    if answer != QtWidgets.QMessageBox.Yes:
        return False
    install(names)
    return True
