# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Base class of all task panels: a form, an undo step from opening to OK, and delayed updates."""

import gc
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
from freecad.elastica_wb.curves.sketch_curves import boxes_of
from freecad.elastica_wb.host.fields import calm, into_sight, on_change, put_text, set_value, value_of
from freecad.elastica_wb.host.objects import document_lives, lives
from freecad.elastica_wb.host.qt import QtCore, QtGui, QtWidgets, later
from freecad.elastica_wb.host.refusal import FAILURES, explained
from freecad.elastica_wb.host.resources import icon, load_panel, quantities_of, translate
from freecad.elastica_wb.host.words import worded
from freecad.elastica_wb.live import session as live
from freecad.elastica_wb.recording import record_recompute
from freecad.elastica_wb.undo_steps import active_step, close_step, forget_step, open_step

from elastica_cad.errors import InputError

# delay, ms, between the last key and the computation of the results
PAUSE_MS = 60
# largest width, pixels, of a title in the narrowest task panel
TITLE_PX = 165


class Panel:
    """A task panel. It calls `changed` shortly after the user changes a widget."""

    file = ""
    icon_name = "Elastica"
    step = ""
    only_tells = False
    done = "Ok"
    """Button of the task panel that calls `finished`."""
    preview: Any = None
    opened: "Panel | None" = None

    def __init__(self, document: Any = None, subjects: Iterable[Any] = ()) -> None:
        """Open the panel, which may change `document`.

        If one of the objects `subjects` was deleted, OK shows an error.
        """
        Panel.opened = self
        self.subjects = list(subjects)
        self._homes = [subject.Document for subject in self.subjects] + [document]
        self.form = self.make_form()
        calm(self.form)
        for button in self.form.findChildren(QtWidgets.QAbstractButton):
            put_text(button, button.text())
        # labels of objects and names of sheets may look like HTML
        for label in self.form.findChildren(QtWidgets.QLabel):
            label.setWordWrap(True)
            if label.textFormat() == QtCore.Qt.AutoText:
                label.setTextFormat(QtCore.Qt.PlainText)
        bold = QtGui.QFont(self.form.font())
        bold.setBold(True)
        title = QtGui.QFontMetrics(bold).elidedText(self.form.windowTitle(), QtCore.Qt.ElideRight, TITLE_PX)
        self.form.setWindowTitle(title)
        self.form.setWindowIcon(QtGui.QIcon(icon(self.icon_name)))
        self.document = document
        self._timer = later(self._safely_changed, PAUSE_MS, self.form)
        # earlier changes without an undo step, such as in the console, must not become part of this step
        if self.step and not (document.HasPendingTransaction and active_step(document)):
            open_step(document, self.step)

    def make_form(self) -> Any:
        """Make the form. Messages are at the top, visible without scrolling."""
        form = load_panel(self.file)
        for name, value in quantities_of(self.file).items():
            set_value(getattr(form, name), value)
        form.layout().removeWidget(form.message)
        form.layout().insertWidget(0, form.message)
        return form

    def value(self, name: str) -> Any:
        """Return the value that a widget shows, with lengths in mm."""
        return value_of(getattr(self.form, name))

    def accept(self) -> bool:
        """Apply the panel (OK). All changes since its opening form one undo step."""
        try:
            self._all_there()
            self.finished()
        except FAILURES as error:
            self.show_message(str(explained(error)))
            into_sight(self.form.message)
            return False
        if self.document is not None:
            record_recompute(self.document)
            close_step(self.document)
        self._close()
        return True

    def reject(self) -> bool:
        """Restore the state before the panel was opened (Cancel)."""
        self._timer.stop()
        if self.document is not None and document_lives(self.document):
            close_step(self.document, abort=True)
            record_recompute(self.document)
        self._close()
        return True

    def abandon(self) -> None:
        """Close the panel of a closed document, without using the document or its view."""
        if self.form is None:
            return
        if self.step:
            forget_step()
        Gui.Control.closeDialog()
        self.form = None
        gc.collect()

    def getStandardButtons(self) -> int:
        """Return the buttons: OK (or Save) and Cancel, or Close for a panel that only shows results."""
        kinds = QtWidgets.QDialogButtonBox
        buttons = [kinds.Close] if self.only_tells else [getattr(kinds, self.done), kinds.Cancel]
        return sum(int(getattr(button, "value", button)) for button in buttons)

    def changed(self) -> None:
        """Compute and show the results for the current values of the widgets."""

    def finished(self) -> None:
        """Apply the panel after OK. After an error, the panel stays open."""

    def closed(self) -> None:
        """Remove the preview from the view."""
        if self.preview is not None:
            self.preview.remove()
            self.preview = None

    def let_go(self) -> None:
        """Release all references to the document before it is closed."""

    def show_message(self, sentence: str) -> None:
        """Show a message in the panel, with lengths in the unit that FreeCAD displays."""
        self.form.message.setText(worded(sentence))

    @contextmanager
    def telling(self) -> Iterator[None]:
        """Show errors of a `with` block in the panel."""
        try:
            yield
        except FAILURES as error:
            self.show_message(str(explained(error)))

    def watch(self, *names: str) -> None:
        """Call `changed` after the user changes one of these widgets."""
        for name in names:
            on_change(getattr(self.form, name), self.soon)

    def soon(self, *_: Any) -> None:
        """Call `changed` after a pause in the user's input."""
        self._timer.start()

    def now(self) -> None:
        """Call `changed` now if a call is waiting."""
        if self._timer.isActive():
            self._timer.stop()
            self._safely_changed()

    def _all_there(self) -> None:
        if not all(map(lives, self.subjects)):
            raise InputError(translate("Elastica", "The edited object was deleted. Press Cancel."))

    def _safely_changed(self) -> None:
        with self.telling():
            self._all_there()
            self.changed()

    def _close(self) -> None:
        self._timer.stop()
        self.closed()
        live.stop()
        if Gui.ActiveDocument is not None:
            Gui.ActiveDocument.resetEdit()
        Gui.Control.closeDialog()
        # delete widgets in reference cycles, because PySide would reuse their wrappers for new widgets
        self.form = None
        gc.collect()


class _Documents:
    """Observer that closes a panel together with its document."""

    def slotDeletedDocument(self, document: Any) -> None:
        panel = Panel.opened
        if panel is not None and panel.form is not None and any(home is document for home in panel._homes):
            panel._timer.stop()
            panel.let_go()
            panel.document, panel.preview = None, None
            panel._homes = []
            # close the panel later, because an undo would crash while FreeCAD destroys the document
            QtCore.QTimer.singleShot(0, panel.abandon)


_documents = _Documents()
App.addDocumentObserver(_documents)


def active_view() -> Any:
    """Return the 3D view, or None if another kind of view is active."""
    view = Gui.ActiveDocument.activeView() if Gui.ActiveDocument else None
    return view if hasattr(view, "getSceneGraph") else None


def bring_into_view(objects: Iterable[Any]) -> None:
    """Show the whole document if an object, or a source of it, is not completely in the 3D view."""
    view = active_view()
    sources = {source for obj in objects for source in (obj, *obj.OutList)}
    corners = [box.getPoint(i) for box in boxes_of(sources) for i in range(8)]
    if view is None or not corners:
        return
    limits, places = view.getSize(), [view.getPointOnScreen(corner) for corner in corners]
    if not all(0 <= x <= most for place in places for x, most in zip(place, limits, strict=True)):
        view.fitAll()
