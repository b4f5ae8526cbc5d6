# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Observers of documents. FreeCAD installs them at its start, so large modules are imported on first use."""

import sys
from concurrent.futures import Future
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
from freecad.elastica_wb.host.objects import feature_kind, is_model, is_ours, is_sketch, is_strip, lives
from freecad.elastica_wb.host.qt import AGAIN_MS, InputLater, QtCore, QtWidgets, later, when_free
from freecad.elastica_wb.live.sketches import (
    edited_sketch,
    followers,
    recompute,
    remember,
    wants_overlay,
)

# delay, ms, of slow results after the last recompute, undo or redo
PAUSE_MS = 300
# interval, ms, between checks whether another thread has ended
SOUGHT_MS = 50


class LaterResults:
    """Observer that computes slow results after a recompute: deviation of strips, overlaps of models,
    messages on nests.
    """

    def __init__(self) -> None:
        self._waiting: dict[tuple[str, str], Any] = {}
        self._sought: dict[tuple[str, str], Future[tuple[str, ...]]] = {}
        self._nests: dict[str, list[Any]] = {}
        self._timer = later(self._next)

    def slotRecomputedObject(self, obj: Any) -> None:
        """Queue a recomputed strip or model until the whole document is recomputed."""
        if is_strip(obj) or is_model(obj):
            self._wait_for(obj)

    def slotUndoDocument(self, document: Any) -> None:
        """Queue every model, because an undo does not restore results computed after the recompute."""
        for obj in filter(is_model, document.Objects):
            self._wait_for(obj)
        self.slotRecomputedDocument(document)

    def slotRecomputedDocument(self, document: Any) -> None:
        """Queue every nest, because a nest may depend on strips without a link in FreeCAD."""
        self._nests[document.Name] = nests = [obj for obj in document.Objects if feature_kind(obj) == "Nest"]
        for obj in nests:
            self._wait_for(obj)

    def slotDeletedObject(self, obj: Any) -> None:
        """Queue the nests of the document for an update.

        The deleted object may have changed a strip of a nest, and FreeCAD does not recompute the nest.
        """
        for nest in filter(lives, self._nests.get(obj.Document.Name, ())):
            self._wait_for(nest)

    def slotDeletedDocument(self, document: Any) -> None:
        """Forget the nests of the document."""
        self._nests.pop(document.Name, None)

    slotRedoDocument = slotUndoDocument

    def _wait_for(self, obj: Any) -> None:
        name = obj.Document.Name, obj.Name
        self._sought.pop(name, None)
        self._waiting[name] = obj
        self._timer.start(PAUSE_MS)

    def _next(self) -> None:
        if not self._waiting:
            return
        first, obj = next(iter(self._waiting.items()))
        # wait while the user drags, and during a recompute, because timers run then too
        if QtWidgets.QApplication.mouseButtons() or (lives(obj) and obj.Document.Recomputing):
            self._timer.start(PAUSE_MS)
            return
        del self._waiting[first]
        is_finished = not lives(obj) or self._finish(first, obj)
        if not is_finished:
            self._waiting.setdefault(first, obj)
        self._timer.start(0 if is_finished else SOUGHT_MS)

    def _finish(self, name: tuple[str, str], obj: Any) -> bool:
        """Write the slow results of an object. Return False while the results are being computed."""
        if is_strip(obj):
            from freecad.elastica_wb.features.strip import show_held

            show_held(obj)
        elif feature_kind(obj) == "Nest":
            from freecad.elastica_wb.features.nest import report_left_out

            report_left_out(obj)
        else:
            from freecad.elastica_wb.features.model import overlaps_sought, show_overlaps

            future = self._sought.pop(name, None) or overlaps_sought(obj)
            if future is not None and not future.done():
                self._sought[name] = future
                return False
            if future is not None:
                show_overlaps(obj, future.result())
        return True


WORKBENCH = "ElasticaWorkbench"
CURVES = ("Nearest", "Bent", "Section")
SEEN_ONLY = ("Visibility", "HiddenByError", "ShownByError", "Label", "Messages")
"""Properties that do not affect the shape of a feature."""
_installed: list[Any] = []


def install() -> None:
    """Install the observers."""
    if not _installed:
        _installed.extend([Edits(), Changes(), LaterResults()])
        Gui.addDocumentObserver(_installed[0])
        for observer in _installed[1:]:
            App.addDocumentObserver(observer)


def is_on(sketch: Any) -> bool:
    """Return True if the overlay of this sketch is on."""
    session = _session()
    return session is not None and session.sketch is sketch


def switch(sketch: Any, *, on: bool) -> None:
    """Switch the overlay of an open sketch on or off, and store this in the sketch."""
    from freecad.elastica_wb.live import session

    remember(sketch, on)
    session.start(sketch) if on else session.stop()


def start_if_wanted(sketch: Any) -> None:
    """Start the overlay of a sketch if the sketch is still open and `wants_overlay` returns True."""
    if lives(sketch) and edited_sketch() is sketch and wants_overlay(sketch):
        from freecad.elastica_wb.live import session

        session.start(sketch)


class Edits:
    """Observer that starts the overlay when a sketch is opened, and ends it when the sketch is closed."""

    def slotInEdit(self, provider: Any) -> None:
        """Start the overlay after FreeCAD has handled this signal and drawn the points of the sketch."""
        sketch = getattr(provider, "Object", None)
        if is_sketch(sketch):
            QtCore.QTimer.singleShot(0, lambda: start_if_wanted(sketch))

    def slotResetEdit(self, provider: Any) -> None:
        """End the overlay when its sketch is closed."""
        sketch = getattr(provider, "Object", None)
        if is_on(sketch):
            _module_if_imported("live.session").stop()
            QtCore.QTimer.singleShot(0, lambda: _hide_failed(sketch))

    def slotDeletedDocument(self, document: Any) -> None:
        """End the overlay when its document is closed."""
        session = _session()
        if session is not None and session.sketch.Document.Name == document.Document.Name:
            _module_if_imported("live.session").stop()


class Changes:
    """Observer of new sketches, changed and deleted objects, undo, redo and pasted objects."""

    def __init__(self) -> None:
        self._pending = False
        self._pasted: list[Any] = []
        self._before: dict[tuple[str, str, str], Any] = {}
        self._changed: dict[str, dict[str, set[str]]] = {}
        self._undone: dict[str, tuple[dict[str, set[str]], set[str]]] = {}
        self._after_undone = later(lambda: when_free(self._recompute_undone), PAUSE_MS)
        self._input = InputLater()

    def slotCreatedObject(self, obj: Any) -> None:
        """Switch the overlay on for sketches created in this workbench."""
        if _is_importing(obj.Document):
            self._pasted.append(obj)
            if len(self._pasted) == 1:
                QtCore.QTimer.singleShot(0, self._after_paste)
        if (
            is_sketch(obj)
            and not obj.Document.Restoring
            and not obj.Document.Transacting
            and Gui.activeWorkbench().name() == WORKBENCH
        ):
            remember(obj, True)

    def slotBeforeChangeObject(self, obj: Any, name: str) -> None:
        """Store a label, or the members of a container, before a change."""
        if obj.Document.Restoring:
            return
        if name in ("Label", "Group"):
            before = obj.Label if name == "Label" else _names(obj.Group)
            self._before[obj.Document.Name, obj.Name, name] = before

    def slotChangedObject(self, obj: Any, name: str) -> None:
        """Update the overlay and dependent features after a change."""
        before = self._before.pop((obj.Document.Name, obj.Name, name), None)
        if name == "Label":
            _rename_users(obj, before or "")
        if obj.Document.Transacting:
            if name not in SEEN_ONLY:
                names = self._changed.setdefault(obj.Document.Name, {})
                names.setdefault(obj.Name, set()).add(name)
        elif name == "Group" and not obj.Document.Restoring:
            _call_in_proxy("keep_containers", obj.Document, (before or set()) ^ _names(obj.Group))
        elif name == "Placement" and obj.hasExtension("App::GeoFeatureGroupExtension"):
            _call_in_proxy("keep_places", obj)
        if name == "Geometry" and is_on(obj):
            self._soon()

    def slotBeforeRecomputeDocument(self, document: Any) -> None:
        """Delay shortcuts during a recompute, because FreeCAD does not block them."""
        if any(map(is_ours, document.Objects)):
            self._input.watch()

    def slotRecomputedDocument(self, document: Any) -> None:
        """Set the error of features that FreeCAD skipped because an object failed."""
        self._input.leave()
        _call_in_proxy("give_up", document)

    def slotDeletedObject(self, obj: Any) -> None:
        """End the overlay when its sketch is deleted."""
        if is_on(obj):
            _module_if_imported("live.session").stop()

    def slotUndoDocument(self, document: Any) -> None:
        """Record what an undo changed, and recompute later, because the next undo may delete the objects.

        An undo does not restore shapes that were computed after the end of the undo step.
        """
        step = self._changed.pop(document.Name, {})
        self._changed.clear()
        if step:
            changed, half = self._undone.setdefault(document.Name, ({}, set()))
            for name, properties in step.items():
                changed.setdefault(name, set()).update(properties)
            ours = filter(is_ours, document.Objects)
            half.update(obj.Name for obj in ours if not is_strip(obj) and _is_half_undone(obj, step))
        self._after_undone.start()
        if _session() is not None:
            self._soon()

    slotRedoDocument = slotUndoDocument

    def _recompute_undone(self) -> None:
        undone, self._undone = self._undone, {}
        for name, (changed, half) in undone.items():
            document = App.listDocuments().get(name)
            ours = [] if document is None else [obj for obj in document.Objects if is_ours(obj)]
            if ours:
                recompute(_stale(ours, changed, half))

    def _after_paste(self) -> None:
        """Recompute pasted features, whose sources may be missing. FreeCAD 0.20 does not recompute them."""
        pasted = [obj for obj in self._pasted if lives(obj)]
        # wait during an import, because timers run then too
        if any(_is_importing(obj.Document) for obj in pasted):
            QtCore.QTimer.singleShot(AGAIN_MS, self._after_paste)
            return
        self._pasted = []
        for name in dict.fromkeys(obj.Document.Name for obj in pasted):
            recompute([obj for obj in pasted if obj.Document.Name == name and is_ours(obj)])

    def slotBeforeCloseTransaction(self, abort: bool) -> None:
        """Make the flat parts of pasted strips, in the undo step of the paste."""
        pasted = [obj for obj in self._pasted if not abort and lives(obj) and is_strip(obj)]
        if any(_is_importing(obj.Document) for obj in pasted):
            return
        for strip in pasted:
            from freecad.elastica_wb.features import flat

            self._pasted += [
                flat.create(strip.Document, strip, layer) for layer in flat.missing_layers(strip)
            ]

    def _soon(self) -> None:
        if not self._pending:
            self._pending = True
            QtCore.QTimer.singleShot(0, self._refresh)

    def _refresh(self) -> None:
        self._pending = False
        session = _session()
        if session is not None:
            session.refresh()
            if not self._after_undone.isActive():
                recompute(followers(session.sketch))


def _is_importing(document: Any) -> bool:
    return bool(getattr(document, "Importing", False))


def _module_if_imported(module: str) -> Any:
    return sys.modules.get(f"freecad.elastica_wb.{module}")


def _session() -> Any:
    module = _module_if_imported("live.session")
    return None if module is None else module.session()


def _call_in_proxy(work: str, *subject: Any) -> None:
    module = _module_if_imported("features.proxy")
    if module is not None:
        getattr(module, work)(*subject)


def _rename_users(obj: Any, old: str) -> None:
    module = _module_if_imported("features.proxy")
    if old and not obj.Document.Transacting and not _is_importing(obj.Document):
        for user in filter(is_ours, obj.InList):
            if user.Label.startswith(f"{old} "):
                user.Label = f"{obj.Label}{user.Label[len(old) :]}"
    outdated = module.telling(obj, old) if module is not None and old not in ("", obj.Label) else []
    if outdated:
        QtCore.QTimer.singleShot(0, lambda: recompute(outdated))


def _hide_failed(sketch: Any) -> None:
    """Hide failed features again, because the sketcher shows them when it closes a sketch."""
    if lives(sketch):
        _call_in_proxy("hide_failed", sketch)


def _stale(ours: list[Any], changed: dict[str, set[str]], half: set[str]) -> list[Any]:
    """Return the features whose shape does not match their properties, and their dependent features.

    `half` contains the names of features for which `_is_half_undone` is True.
    """
    from freecad.elastica_wb.features.strip import is_stale

    regrouped = any("Group" in names for names in changed.values())
    touched = set(changed) | ({obj.Name for obj in ours} if regrouped else set())
    stale = [obj for obj in ours if is_strip(obj) and is_stale(obj, touched)]
    restored = [obj for obj in ours if obj.Name in changed and "Touched" in obj.State and obj not in stale]
    for strip in filter(is_strip, restored):
        strip.purgeTouched()
    names = {*changed, *(obj.Name for obj in stale)}
    for obj in (feature for feature in ours if not is_strip(feature)):
        follows = any(source.Name in names for source in obj.OutList)
        failed = "Invalid" in obj.State and (follows or obj.Name in changed)
        stands_elsewhere = regrouped or any(
            above.Name in changed
            for above in (obj.getParentGeoFeatureGroup(), *getattr(obj, "Containers", ()))
            if above is not None
        )
        if (
            failed
            or (follows and feature_kind(obj) in CURVES)
            or obj.Name in half
            or stands_elsewhere
            or obj in restored
        ):
            stale.append(obj)
    users = {user for obj in stale for user in obj.InListRecursive}
    return stale + [obj for obj in ours if obj in users and obj not in stale]


def _names(objects: list[Any]) -> set[str]:
    """Return the names of objects. FreeCAD lists an object that is being deleted as None."""
    return {obj.Name for obj in objects if obj is not None}


def _is_half_undone(obj: Any, changed: dict[str, set[str]]) -> bool:
    """Return True if an undo restored only the shape of a feature, or only its sources.

    FreeCAD records the recompute after closing a sketch as a separate step.
    """
    results = {entry.name for entry in obj.Proxy.properties if entry.result}
    properties = changed.get(obj.Name, set())
    inputs = properties - results - {"Shape"}
    followed = any(source.Name in changed for source in obj.OutList)
    return bool(inputs or followed) != ("Shape" in properties)
