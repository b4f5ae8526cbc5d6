"""What all commands share: how they look, one undo step, errors as sentences."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
from freecad.elastica_wb.drawn import is_sketch
from freecad.elastica_wb.features.flat import is_flat
from freecad.elastica_wb.features.refusal import FAILURES, explained
from freecad.elastica_wb.features.strip import is_strip
from freecad.elastica_wb.qt import QtWidgets
from freecad.elastica_wb.text import icon, tr
from freecad.elastica_wb.units import worded

from elastica_cad.errors import InputError

__all__ = [
    "Command",
    "chosen_curves",
    "chosen_sketch",
    "chosen_sources",
    "chosen_strips",
    "edited_sketch",
    "show_panel",
    "tell",
    "undo_step",
]

_told: list[Any] = []


class Command:
    """A command; `run` does the work and raises `ElasticaError` with a sentence where it cannot."""

    name = "Elastica"
    text = ""
    tip = ""
    shortcut = ""
    needs_document = True

    def GetResources(self) -> dict[str, str]:
        """Icon, words and keys; FreeCAD translates the words with the command's name as context."""
        found = {"Pixmap": icon(self.name), "MenuText": self.text, "ToolTip": self.tip}
        return found | ({"Accel": self.shortcut} if self.shortcut else {})

    def IsActive(self) -> bool:
        """Most commands need a document; none works beside a panel, but for that of a sketch, which they close."""
        if self.needs_document and App.ActiveDocument is None:
            return False
        return not Gui.Control.activeDialog() or edited_sketch() is not None

    def Activated(self, _index: int = 0) -> None:
        """The user asks for it."""
        step = App.getActiveTransaction()
        try:
            self.run()
        except FAILURES as error:
            if App.getActiveTransaction() != step:
                App.closeActiveTransaction(True)
            tell(str(explained(error)))

    def run(self) -> None:
        """Do it."""
        raise NotImplementedError


def edited_sketch() -> Any:
    """The sketch that is being edited, or None."""
    provider = Gui.ActiveDocument.getInEdit() if Gui.ActiveDocument else None
    source = getattr(provider, "Object", None)
    return source if source is not None and is_sketch(source) else None


def show_panel(make: Callable[..., Any], *arguments: Any) -> None:
    """Close the sketcher, then open a panel."""
    if edited_sketch() is not None:
        Gui.ActiveDocument.resetEdit()
    Gui.Control.showDialog(make(*arguments))


def tell(sentence: str) -> None:
    """A sentence in the report view, the status bar and a window that stops nobody."""
    sentence = worded(sentence)
    App.Console.PrintError(f"Elastica: {sentence}\n")
    Gui.getMainWindow().statusBar().showMessage(sentence, 20000)
    box = QtWidgets.QMessageBox(Gui.getMainWindow())
    box.setIcon(QtWidgets.QMessageBox.Information)
    box.setWindowTitle("Elastica")
    box.setText(sentence)
    box.setModal(False)
    box.show()
    _told[:] = [box]


@contextmanager
def undo_step(document: Any, name: str) -> Iterator[None]:
    """Everything inside is one step of the undo history, or after an error none."""
    document.openTransaction(name)
    try:
        yield
    except BaseException:
        document.abortTransaction()
        App.closeActiveTransaction(True)
        raise
    document.commitTransaction()
    App.closeActiveTransaction(False)


def chosen_curves() -> list[tuple[Any, tuple[str, ...]]]:
    """The selected sketches and edges, each with the names of its edges.

    Raises
    ------
    InputError
        Nothing of that kind is selected.
    """
    found = []
    for choice in Gui.Selection.getSelectionEx():
        edges = tuple(name for name in choice.SubElementNames if name.startswith("Edge"))
        if is_sketch(choice.Object):
            found.append((choice.Object, ()))
        elif edges:
            found.append((choice.Object, edges))
        elif hasattr(choice.Object, "Shape") and not choice.Object.Shape.Faces and choice.Object.Shape.Edges:
            found.append((choice.Object, ()))
    edited = edited_sketch()
    if not found and edited is not None:
        found.append((edited, ()))
    if not found:
        raise InputError(tr("Select a sketch with a spline, or an edge of an object, first."))
    return found


def chosen_sketch() -> Any:
    """The selected or edited sketch.

    Raises
    ------
    InputError
        Something else is selected, or nothing.
    """
    (source, edges), *_ = chosen_curves()
    if edges or not is_sketch(source):
        raise InputError(tr("Select a sketch with a spline first."))
    return source


def chosen_sources() -> list[Any]:
    """The selected strips, models and base plates; where none is selected, all that is not part of another."""
    from freecad.elastica_wb.features.baseplate import is_base_plate
    from freecad.elastica_wb.features.model import is_model

    found = [obj for obj in Gui.Selection.getSelection() if is_model(obj) or is_base_plate(obj)]
    if not any(is_strip(obj) or is_flat(obj) for obj in Gui.Selection.getSelection()) and not found:
        found = [obj for obj in App.ActiveDocument.Objects if is_model(obj) or is_base_plate(obj)]
    return found or chosen_strips()


def chosen_strips(*, least: int = 1) -> list[Any]:
    """The selected strips, through their flat parts and links too; the only strip of a document by itself.

    Raises
    ------
    InputError
        Fewer than `least` of them.
    """
    found: list[Any] = []
    for obj in Gui.Selection.getSelection():
        source = obj.LinkedObject if obj.TypeId == "App::Link" else obj
        strip = source.Strip if is_flat(source) else source
        if is_strip(strip) and strip not in found:
            found.append(strip)
    everything = [obj for obj in App.ActiveDocument.Objects if is_strip(obj)]
    if not found and least == 1 and len(everything) == 1:
        found = everything
    if len(found) < least:
        wanted = tr("Select a strip first.") if least == 1 else tr("Select two strips or more first.")
        raise InputError(wanted)
    return found
