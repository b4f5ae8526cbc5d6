# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Finds what takes as long as a recompute, once nothing else waits: no recompute and no drag is held up."""

from concurrent.futures import Future
from typing import Any

from freecad.elastica_wb.host.lifetime import lives
from freecad.elastica_wb.host.qt import QtCore, QtWidgets
from freecad.elastica_wb.live.sketches import is_model, is_nest, is_strip

PAUSE_MS = 300  # after the last recompute
AGAIN_MS = 50  # until work in another thread is asked for again


class LaterResults:
    """Tells of recomputed strips how far they stray, of models what overlaps in them, of nests what they leave out,
    one at a time.
    """

    def __init__(self) -> None:
        self._waiting: dict[tuple[str, str], Any] = {}
        self._sought: dict[tuple[str, str], Future[tuple[str, ...]]] = {}
        self._nests: dict[str, list[Any]] = {}
        self._timer = QtCore.QTimer()
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._next)

    def slotRecomputedObject(self, obj: Any) -> None:
        """It is not asked for before the last of many is made."""
        if is_strip(obj) or is_model(obj):
            self._wait_for(obj)

    def slotUndoDocument(self, document: Any) -> None:
        """What was written after a step was closed is not undone with it."""
        for obj in filter(is_model, document.Objects):
            self._wait_for(obj)
        self.slotRecomputedDocument(document)

    def slotRecomputedDocument(self, document: Any) -> None:
        """A nest is not made from what follows its strips."""
        self._nests[document.Name] = nests = [obj for obj in document.Objects if is_nest(obj)]
        for obj in nests:
            self._wait_for(obj)

    def slotDeletedObject(self, obj: Any) -> None:
        """It may have followed a strip, and nothing is recomputed."""
        for nest in filter(lives, self._nests.get(obj.Document.Name, ())):
            self._wait_for(nest)

    def slotDeletedDocument(self, document: Any) -> None:
        """Its nests are gone."""
        self._nests.pop(document.Name, None)

    def slotRedoDocument(self, document: Any) -> None:
        """As after undo."""
        self.slotUndoDocument(document)

    def _wait_for(self, obj: Any) -> None:
        name = obj.Document.Name, obj.Name
        self._sought.pop(name, None)
        self._waiting[name] = obj
        self._timer.start(PAUSE_MS)

    def _next(self) -> None:
        if not self._waiting:
            return
        first, obj = next(iter(self._waiting.items()))
        # something is dragged, or the document is not done: its progress bar lets timers run
        if QtWidgets.QApplication.mouseButtons() or (lives(obj) and obj.Document.Recomputing):
            self._timer.start(PAUSE_MS)
            return
        del self._waiting[first]
        is_told = not lives(obj) or self._told(first, obj)
        if not is_told:
            self._waiting.setdefault(first, obj)
        self._timer.start(0 if is_told else AGAIN_MS)

    def _told(self, name: tuple[str, str], obj: Any) -> bool:
        """Write what was found; False while it is sought."""
        if is_strip(obj):
            from freecad.elastica_wb.features.strip import tell_held

            tell_held(obj)
            return True
        if is_nest(obj):
            from freecad.elastica_wb.features.nest import tell_left_out

            tell_left_out(obj)
            return True
        from freecad.elastica_wb.features.model import overlaps_sought, tell_overlaps

        found = self._sought.pop(name, None) or overlaps_sought(obj)
        if found is not None and not found.done():
            self._sought[name] = found
            return False
        if found is not None:
            tell_overlaps(obj, found.result())
        return True
