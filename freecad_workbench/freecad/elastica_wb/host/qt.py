# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Qt in all supported releases of FreeCAD, and the widgets of 3D views."""

import gc
from collections.abc import Callable
from contextlib import suppress
from typing import Any

import FreeCAD as App
from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:
    from PySide2 import QtWidgets

__all__ = [
    "BUTTON_LETTERS",
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

# since Qt 6, QAction is in QtGui
ACTION = getattr(QtGui, "QAction", None) or QtWidgets.QAction
# largest number of letters in a line of a button in a panel
BUTTON_LETTERS = 32
# interval, ms, between checks whether a recompute has ended
AGAIN_MS = 20


def later(work: Callable[[], Any], wait: int = 0, parent: Any = None) -> Any:
    """Return a timer that calls a function once, `wait` ms after each start. `parent` owns the timer."""
    timer = QtCore.QTimer(parent)
    timer.setSingleShot(True)
    timer.setInterval(wait)
    timer.timeout.connect(work)
    return timer


def when_free(work: Callable[[], Any]) -> None:
    """Call a function soon, but not during a computation."""

    def look() -> None:
        if is_busy():
            QtCore.QTimer.singleShot(AGAIN_MS, look)
        else:
            work()

    QtCore.QTimer.singleShot(0, look)


def is_busy() -> bool:
    """Return True if a document is recomputing or a progress bar is displayed."""
    return EscapeKey.watching > 0 or any(document.Recomputing for document in App.listDocuments().values())


def surface_of(view: Any) -> Any | None:
    """Return the widget on which a 3D view is drawn, or None if PySide returns the wrapper of a closed view.

    While the wrapper of a closed view is referenced, PySide may return it for a new view at the same address.
    A garbage collection removes such wrappers.
    """
    for _ in (1, 2):
        with suppress(RuntimeError):
            surface = view.graphicsView()
            surface.viewport()
            return surface
        gc.collect()
    return None


def kind_of(event: Any) -> Any | None:
    """Return the type of an event, or None if PySide passes another object instead."""
    return event.type() if isinstance(event, QtCore.QEvent) else None


class InputLater(QtCore.QObject):
    """Event filter that delays shortcuts and timers until computations end, and ignores the mouse wheel.

    FreeCAD's progress bar blocks keys and mouse buttons only. An undo during a recompute cannot delete
    objects, and the undo step would be lost. Timers that repaint windows and display the bar are not delayed.
    """

    def watch(self) -> None:
        """Install the filter. Qt calls the most recently installed filter first."""
        QtCore.QCoreApplication.instance().installEventFilter(self)

    def leave(self) -> None:
        """Remove the filter."""
        QtCore.QCoreApplication.instance().removeEventFilter(self)

    def eventFilter(self, watched: Any, event: Any) -> bool:
        """Delay shortcuts and timers while FreeCAD is busy. A delayed timer fires again after its interval."""
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
    """Event filter that detects the Escape key, whatever widget has the keyboard focus."""

    watching = 0
    pressed = False

    def watch(self) -> None:
        """Start watching the keyboard."""
        EscapeKey.watching += 1
        super().watch()

    def leave(self) -> None:
        """Stop watching the keyboard."""
        EscapeKey.watching -= 1
        super().leave()

    def eventFilter(self, watched: Any, event: Any) -> bool:
        """Record a press of the Escape key, and hide it and later keys from all other receivers."""
        typed = kind_of(event) == QtCore.QEvent.KeyPress
        if typed and event.key() == QtCore.Qt.Key_Escape:
            self.pressed = True
        return (self.pressed and typed) or super().eventFilter(watched, event)
