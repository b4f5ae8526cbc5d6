# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Qt as this FreeCAD has it: 0.20's PySide has no QtWidgets of its own; and the widgets below its views."""

import gc
from collections.abc import Callable
from typing import Any

import FreeCAD as App
from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:
    from PySide2 import QtWidgets

__all__ = [
    "EscapeKey",
    "InputLater",
    "QtCore",
    "QtGui",
    "QtWidgets",
    "kind_of",
    "later",
    "surface_of",
    "when_free",
]

ACTION = getattr(QtGui, "QAction", None) or QtWidgets.QAction  # Qt 6 has moved it
AGAIN_MS = 20  # until a document that recomputes is asked again: its progress bar lets timers run


def later(work: Callable[[], Any], wait: int = 0, parent: Any = None) -> Any:
    """A timer that does work once, `wait` ms after each start; what belongs to a `parent` ends with it."""
    timer = QtCore.QTimer(parent)
    timer.setSingleShot(True)
    timer.setInterval(wait)
    timer.timeout.connect(work)
    return timer


def when_free(work: Callable[[], Any]) -> None:
    """Do work soon, but not while something is computed."""

    def look() -> None:
        if is_busy():
            QtCore.QTimer.singleShot(AGAIN_MS, look)
        else:
            work()

    QtCore.QTimer.singleShot(0, look)


def is_busy() -> bool:
    """Does a document recompute, or a progress bar wait for the end of some work?"""
    return EscapeKey.watching > 0 or any(document.Recomputing for document in App.listDocuments().values())


def surface_of(view: Any) -> Any | None:
    """The widget that a 3D view is drawn on; None where PySide still holds the one of a closed view for it.

    Qt may put a new view where a closed one lay in memory, and PySide then hands out the old wrapper for as long as
    something refers to that. Circles of references that nobody needs any more are taken away first.
    """
    for attempt in (1, 2):
        try:
            surface = view.graphicsView()
            surface.viewport()
        except RuntimeError:
            if attempt == 1:
                gc.collect()
        else:
            return surface
    return None


def kind_of(event: Any) -> Any | None:
    """Return the type of an event; None where PySide hands a widget's wrapper to the filter instead of an event.

    As with views: an event may lie in memory where a deleted widget lay, and it is then no event that can be asked.
    """
    return event.type() if isinstance(event, QtCore.QEvent) else None


class InputLater(QtCore.QObject):
    """Puts shortcuts and timers off until nothing is computed, and ignores the wheel.

    FreeCAD's progress bar keeps keys and mouse buttons from the window, but not these. An undo in a recompute
    cannot delete objects, and its step is lost. Timers that repaint windows and show the bar go on.
    """

    def watch(self) -> None:
        """Begin to watch; the filter that was installed last is called first."""
        QtCore.QCoreApplication.instance().installEventFilter(self)

    def leave(self) -> None:
        """Stop watching."""
        QtCore.QCoreApplication.instance().removeEventFilter(self)

    def eventFilter(self, watched: Any, event: Any) -> bool:
        """Hold back an event; a timer that is held back fires again after its interval."""
        kind = kind_of(event)
        if kind == QtCore.QEvent.Shortcut and isinstance(watched, ACTION) and is_busy():
            when_free(watched.trigger)
            return True
        return (
            kind in (QtCore.QEvent.Wheel, QtCore.QEvent.Timer)
            and is_busy()
            and not isinstance(watched, QtGui.QWindow)
            and not isinstance(watched.parent(), QtWidgets.QProgressBar)
        )


class EscapeKey(InputLater):
    """Notes that Escape was pressed, whoever has the keyboard."""

    watching = 0
    pressed = False

    def watch(self) -> None:
        """Begin to watch."""
        EscapeKey.watching += 1
        super().watch()

    def leave(self) -> None:
        """Stop watching."""
        EscapeKey.watching -= 1
        super().leave()

    def eventFilter(self, watched: Any, event: Any) -> bool:
        """Escape is for us alone."""
        typed = kind_of(event) == QtCore.QEvent.KeyPress
        if typed and event.key() == QtCore.Qt.Key_Escape:
            self.pressed = True
        return (self.pressed and typed) or super().eventFilter(watched, event)
