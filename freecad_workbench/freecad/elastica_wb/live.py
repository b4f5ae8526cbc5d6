"""Live feedback: while a sketch is edited, its overlay follows every move of the mouse."""

import time
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
from freecad.elastica_wb import preferences
from freecad.elastica_wb.design import Wish, nearest_now, solved
from freecad.elastica_wb.dragging import Dragged
from freecad.elastica_wb.drawn import drawn_curve, is_sketch, sketch_curve
from freecad.elastica_wb.features.asked import wish_of
from freecad.elastica_wb.features.refusal import FAILURES, explained
from freecad.elastica_wb.features.strip import hide_failed, is_strip
from freecad.elastica_wb.library import sheet_called
from freecad.elastica_wb.living import lives
from freecad.elastica_wb.overlay import Overlay
from freecad.elastica_wb.patience import begun
from freecad.elastica_wb.picture import comb_scale, curve_picture, sentence_of, width_lines
from freecad.elastica_wb.qt import QtCore
from freecad.elastica_wb.text import tr
from freecad.elastica_wb.units import worded
from pivy import coin

__all__ = ["Session", "followers", "install", "session", "start", "stop"]

REST = 40  # ms without a move after which the slower answers are computed
AGAIN = 20  # ms until a document that recomputes is asked again
PEEK = 60  # ms between looks whether the nearest curve was found
STATUS = 20000  # ms that the advice stays in the status bar

_session: "Session | None" = None
_watchers: list[Any] = []
_wanted: list[Callable[[], bool]] = []


class Session:
    """The overlay of one sketch, from the beginning of its edit to the end."""

    def __init__(self, sketch: Any, view: Any) -> None:
        self.sketch = sketch
        self.overlay = Overlay(view, sketch.getGlobalPlacement())
        self.times: list[float] = []
        self.moves = 0
        self.sentence = ""
        self._scale: float | None = None
        self._asks: Wish | None = None
        self._curve: Any = None
        self._sensor: Any = None
        self._node: Any = None
        self._dragged: Dragged | None = None
        self._soon = _timer(self._follow, 0)
        self._rest = _timer(self._finish, REST)
        self._asked: Any = None
        self._answer = _timer(self._look, PEEK)
        self._attach()
        self.refresh()

    def refresh(self) -> None:
        """Show the sketch as it is in the document."""
        self._soon.stop()
        self._scale = self._asks = None
        self._read()
        self._show(None)

    def close(self) -> None:
        """End of the edit."""
        for timer in (self._soon, self._rest, self._answer):
            timer.stop()
        if self._sensor is not None:
            self._sensor.detach()
        self.overlay.remove()

    def _attach(self) -> None:
        """Watch the points that the sketcher draws."""
        root = coin.SoNode.getByName("Sketch_EditRoot")
        if root is None:
            return
        search = coin.SoSearchAction()
        search.setName("PointsCoordinate0")
        search.setSearchingAll(True)
        search.apply(root)
        if search.getPath() is None:
            return
        self._node = search.getPath().getTail()
        self._sensor = coin.SoFieldSensor(self._moved, None)
        self._sensor.attach(self._node.point)

    def _read(self) -> None:
        """What the points mean; they were drawn for the geometry of now."""
        self._dragged = Dragged(self.sketch, self._points()) if self._node is not None else None

    def _points(self) -> list[Any]:
        field = self._node.point
        return [field[i].getValue() for i in range(field.getNum())]

    def _moved(self, *_: Any) -> None:
        self.moves += 1
        if not self._soon.isActive():
            self._soon.start()

    def _follow(self) -> None:
        """One frame: however many moves there were since the last one."""
        if self._dragged is not None and self._dragged.usable:
            points = self._points()
            try:
                self._show(self._dragged.geometry(points))
            except IndexError:  # the sketch has lost points: a release will tell
                self._dragged = None

    def _show(self, geometry: list[Any] | None) -> None:
        began = time.thread_time()  # what we cost, whatever else the machine does
        self._rest.stop()
        try:
            self._curve = sketch_curve(self.sketch, geometry)
            wish = self._wish()
            if self._scale is None:
                self._scale = comb_scale(self._curve)
            picture = curve_picture(self._curve, wish, self._scale)
        except FAILURES as error:
            self._curve = None
            self.overlay.clear()
            self._say(str(explained(error)))
            return
        self.overlay.show(picture)
        self.overlay.show_nearest(None)
        self._answer.stop()
        if picture.realizable is False:
            self.overlay.show_width(())
        self._say(picture.sentence)
        self.times.append(time.thread_time() - began)
        self._rest.start()

    def _finish(self) -> None:
        """The mouse rests: widths."""
        if self._curve is None:
            return
        wish = replace(self._wish(), nearest=False)
        try:
            strip = solved(self._curve, wish)
        except FAILURES as error:
            self.overlay.show_width(())
            self._say(sentence_of(explained(error)))
            if preferences.get("LiveNearest"):
                self._ask(wish)
            return
        self.overlay.show_width(width_lines(strip))
        self._say(sentence_of(strip))

    def _ask(self, wish: Wish) -> None:
        """Search the nearest curve beside the window; an answer to an older question is not waited for."""
        if wish.ratio is None and wish.margin is None:
            wish = replace(wish, ratio=10.0)
        if self._asked is None or self._asked.done():
            self._asked_for = self._curve
            self._asked = begun(nearest_now, self._curve, wish)
        self._answer.start()

    def _look(self) -> None:
        """Is the answer there?"""
        if not self._asked.done():
            self._answer.start()
        elif self._asked_for is not self._curve:
            self._finish()
        elif self._asked.exception() is None:
            near = self._asked.result()
            self.overlay.show_nearest(near.rod.position)
            self._say(f"{self.sentence} {tr('The nearest curve is')} {near.deviation:.3g} mm {tr('away')}.")

    def _wish(self) -> Wish:
        """What the strip of this sketch is asked for; it cannot change while the mouse is down."""
        if self._asks is None:
            self._asks = Wish(
                sheet_called(preferences.default_sheet()), max_width=preferences.get("MaxWidth")
            )
            for strip in followers(self.sketch):
                self._asks = wish_of(strip, drawn_curve(strip.Curve, strip))
        return self._asks

    def _say(self, sentence: str) -> None:
        self.sentence = sentence = worded(sentence)
        Gui.getMainWindow().statusBar().showMessage(sentence, STATUS)


def followers(sketch: Any) -> list[Any]:
    """The strips that follow a sketch."""
    return [obj for obj in sketch.InList if is_strip(obj) and obj.Curve and obj.Curve[0] is sketch]


def session() -> Session | None:
    """The session that runs now."""
    return _session


def start(sketch: Any) -> Session | None:
    """Show the overlay of a sketch, in edit or not."""
    global _session  # noqa: PLW0603 - one view shows one overlay
    stop()
    view = Gui.getDocument(sketch.Document.Name).activeView()
    if view is None or not hasattr(view, "getSceneGraph"):
        return None
    _session = Session(sketch, view)
    return _session


def stop() -> None:
    """Take the overlay off."""
    global _session  # noqa: PLW0603
    if _session is not None:
        _session.close()
        _session = None


def install(wanted: Callable[[], bool] | None = None) -> None:
    """Begin to watch edits; `wanted` says whether a sketch that no strip follows gets an overlay too."""
    if wanted is not None:
        _wanted[:] = [wanted]
    if not _watchers:
        _watchers.extend([_Edits(), _Changes()])
        Gui.addDocumentObserver(_watchers[0])
        App.addDocumentObserver(_watchers[1])


class _Edits:
    """Beginning and end of edits."""

    def slotInEdit(self, provider: Any) -> None:
        sketch = getattr(provider, "Object", None)
        if sketch is None or not is_sketch(sketch) or not preferences.get("LiveMode"):
            return
        if followers(sketch) or any(ask() for ask in _wanted):
            # the sketcher draws its points after this signal
            QtCore.QTimer.singleShot(0, lambda: _start_if_edited(sketch))

    def slotResetEdit(self, provider: Any) -> None:
        if _session is not None and getattr(provider, "Object", None) is _session.sketch:
            sketch = _session.sketch
            stop()
            QtCore.QTimer.singleShot(0, lambda: hide_failed(followers(sketch) if lives(sketch) else []))

    def slotDeletedDocument(self, document: Any) -> None:
        if _session is not None and _session.sketch.Document.Name == document.Document.Name:
            stop()


class _Changes:
    """Released mouse buttons, undo, redo."""

    def __init__(self) -> None:
        self._pending = False

    def slotChangedObject(self, obj: Any, name: str) -> None:
        if _session is not None and obj is _session.sketch and name == "Geometry":
            self._soon()

    def slotUndoDocument(self, document: Any) -> None:
        self._after_undo(document)

    def slotRedoDocument(self, document: Any) -> None:
        self._after_undo(document)

    def slotDeletedObject(self, obj: Any) -> None:
        if _session is not None and obj is _session.sketch:
            stop()

    def _after_undo(self, document: Any) -> None:
        """The strip's shape was not undone with the sketch: recompute what is stale."""
        stale = [o for o in document.Objects if is_strip(o)]
        if stale:
            QtCore.QTimer.singleShot(0, lambda: _recompute(stale))
        if _session is not None:
            self._soon()

    def _soon(self) -> None:
        if not self._pending:
            self._pending = True
            QtCore.QTimer.singleShot(0, self._refresh)

    def _refresh(self) -> None:
        self._pending = False
        if _session is None:
            return
        _session.refresh()
        _recompute(followers(_session.sketch))


def _start_if_edited(sketch: Any) -> None:
    if not lives(sketch):
        return
    edited = Gui.getDocument(sketch.Document.Name).getInEdit()
    if edited is not None and edited.Object is sketch:
        start(sketch)


def _recompute(strips: list[Any]) -> None:
    """Strips and what hangs on them, nothing else."""
    alive = [strip for strip in strips if lives(strip)]
    if not alive:
        return
    if alive[0].Document.Recomputing:  # its progress bar lets timers run
        QtCore.QTimer.singleShot(AGAIN, lambda: _recompute(alive))
        return
    for strip in alive:
        strip.touch()
    alive[0].Document.recompute(alive)


def _timer(work: Callable[[], None], wait: int) -> Any:
    timer = QtCore.QTimer()
    timer.setSingleShot(True)
    timer.setInterval(wait)
    timer.timeout.connect(work)
    return timer
