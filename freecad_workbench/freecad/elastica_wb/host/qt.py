# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Qt in all supported releases (PySide of FreeCAD 0.20 has no QtWidgets), and the widgets of 3D views."""

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

ACTION = getattr(QtGui, "QAction", None) or QtWidgets.QAction  # moved in Qt 6
AGAIN_MS = 20  # before a document that recomputes is checked again: its progress bar lets timers run


def later(work: Callable[[], Any], wait: int = 0, parent: Any = None) -> Any:
    """Return a timer that does work once, `wait` ms after each start. It is deleted with its `parent`."""
    timer = QtCore.QTimer(parent)
    timer.setSingleShot(True)
    timer.setInterval(wait)
    timer.timeout.connect(work)
    return timer


def when_free(work: Callable[[], Any]) -> None:
    """Do work soon, but not during a computation."""

    def look() -> None:
        if is_busy():
            QtCore.QTimer.singleShot(AGAIN_MS, look)
        else:
            work()

    QtCore.QTimer.singleShot(0, look)


def is_busy() -> bool:
    """Return True if a document recomputes or a progress bar waits for work."""
    return EscapeKey.watching > 0 or any(document.Recomputing for document in App.listDocuments().values())


def surface_of(view: Any) -> Any | None:
    """Return the widget on which a 3D view is drawn, or None if PySide returns the wrapper of a closed view.

    Qt may put a new view at the address of a closed view. PySide then returns the old wrapper as long as something
    refers to it. Therefore unused reference cycles are collected first.
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
    """Return the type of an event, or None if PySide passes a widget's wrapper instead of an event.

    An event may be at the address of a deleted widget, and the old wrapper has no event type.
    """
    return event.type() if isinstance(event, QtCore.QEvent) else None


class InputLater(QtCore.QObject):
    """Delays shortcuts and timers until nothing is computed, and ignores the mouse wheel.

    FreeCAD's progress bar blocks keys and mouse buttons, but not shortcuts, timers and the wheel. An undo during a
    recompute cannot delete objects, and its step is lost. Timers that repaint windows and show the bar continue.
    """

    def watch(self) -> None:
        """Start watching. Qt calls the filter that was installed last first."""
        QtCore.QCoreApplication.instance().installEventFilter(self)

    def leave(self) -> None:
        """Stop watching."""
        QtCore.QCoreApplication.instance().removeEventFilter(self)

    def eventFilter(self, watched: Any, event: Any) -> bool:
        """Delay an event. A delayed timer fires again after its interval."""
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
    """Detects the Escape key, regardless of the keyboard focus."""

    watching = 0
    pressed = False

    def watch(self) -> None:
        """Start watching."""
        EscapeKey.watching += 1
        super().watch()

    def leave(self) -> None:
        """Stop watching."""
        EscapeKey.watching -= 1
        super().leave()

    def eventFilter(self, watched: Any, event: Any) -> bool:
        """Keep Escape from all other receivers."""
        typed = kind_of(event) == QtCore.QEvent.KeyPress
        if typed and event.key() == QtCore.Qt.Key_Escape:
            self.pressed = True
        return (self.pressed and typed) or super().eventFilter(watched, event)
