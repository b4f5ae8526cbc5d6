# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Bends strips forward as they are made and held, once nothing else waits: no recompute and no drag is held up."""

from typing import Any

from freecad.elastica_wb.host.lifetime import lives
from freecad.elastica_wb.host.qt import QtCore, QtWidgets
from freecad.elastica_wb.live.sketches import is_strip

PAUSE_MS = 300  # after the last recompute


class HeldShapes:
    """Tells of recomputed strips how far they stray, one at a time."""

    def __init__(self) -> None:
        self._waiting: dict[tuple[str, str], Any] = {}
        self._timer = QtCore.QTimer()
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._next)

    def slotRecomputedObject(self, obj: Any) -> None:
        """It is not asked for before the last of many is made."""
        if is_strip(obj):
            self._waiting[obj.Document.Name, obj.Name] = obj
            self._timer.start(PAUSE_MS)

    def _next(self) -> None:
        from freecad.elastica_wb.features.strip import tell_held

        if not self._waiting:
            return
        first, obj = next(iter(self._waiting.items()))
        # something is dragged, or the document is not done: its progress bar lets timers run
        if QtWidgets.QApplication.mouseButtons() or (lives(obj) and obj.Document.Recomputing):
            self._timer.start(PAUSE_MS)
            return
        del self._waiting[first]
        if lives(obj):
            tell_held(obj)
        self._timer.start(0)
