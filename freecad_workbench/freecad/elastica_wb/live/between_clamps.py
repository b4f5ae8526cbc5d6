# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Tool that draws the curve of a strip of given length between two clamped ends in an open sketch.

The solver of the sketcher cannot keep the length of a curve, so the curve is drawn when the mouse is released.
"""

from collections.abc import Callable
from contextlib import suppress
from math import atan2, cos, sin
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import Part
from freecad.elastica_wb.curves.sketch_curves import container, replace_curve
from freecad.elastica_wb.host.fields import calm, on_change, quantity_box, set_value, value_of
from freecad.elastica_wb.host.qt import QtCore, QtWidgets, later, surface_of
from freecad.elastica_wb.host.resources import translate
from freecad.elastica_wb.host.words import worded
from freecad.elastica_wb.live.preview import Handles, Place, Preview
from freecad.elastica_wb.live.sketches import edited_sketch
from freecad.elastica_wb.live.verdict_card import GAP_PX, free_part, heading_style
from freecad.elastica_wb.recording import record_call, recorded
from freecad.elastica_wb.solving.verdicts import Verdict
from freecad.elastica_wb.undo_steps import close_step, open_step

from elastica_cad._types import FloatArray
from elastica_cad.errors import ElasticaError
from elastica_cad.mechanics.between_clamps import ElasticaBetween, elastica_between

# distance of the tangents' handles from the ends, as a fraction of the chord
REACH = 0.25
# length of a new strip, as a multiple of its chord
SLACK = 1.3
# half the chord of a new curve, as a fraction of the height of the view
VIEW_FRACTION = 0.3
DIFFERENT_MM = 1e-6


class BetweenClamps:
    """Tool that draws a strip between clamped ends, set by two ends, two tangents and a length."""

    def __init__(self, sketch: Any, view: Any) -> None:
        self.sketch = sketch
        self.number, self.ends, self.angles, self.length, self.side = _initial_parameters(sketch, view)
        self.found: ElasticaBetween | None = None
        placement = container(sketch).multiply(sketch.Placement)
        self.card = LengthCard(view, self.length, self._lengthen, self._turn_over, stop)
        self.preview = Preview(view, placement)
        self._solve()
        # start with the tangents that were found for freely rotating ends
        if self.angles is None and self.found is not None:
            angles = self.found.rod.angle
            self.angles = [float(angles[0]), float(angles[-1])]
        self.angles = self.angles or [0.0, 0.0]
        self.preview.handles = Handles(view, placement, self._places(), self._moved, self._draw)
        Gui.addDocumentObserver(self)
        App.addDocumentObserver(self)
        if self.number is None:
            self._draw()

    def close(self) -> None:
        """Remove preview, handles and card, but not the drawn curve, from the view."""
        App.removeDocumentObserver(self)
        Gui.removeDocumentObserver(self)
        self.preview.remove()
        self.card.remove()

    def slotResetEdit(self, provider: Any) -> None:
        """End the tool when the sketch is closed."""
        if getattr(provider, "Object", None) is self.sketch:
            stop()

    def slotUndoDocument(self, document: Any) -> None:
        """End the tool after an undo, which has changed the curve."""
        if document is self.sketch.Document:
            stop()

    def slotDeletedDocument(self, document: Any) -> None:
        """End the tool when the document is closed."""
        if getattr(document, "Document", document) is self.sketch.Document:
            stop()

    def _moved(self, handle: int, place: Place) -> None:
        """Move an end (handles 0 and 1) or rotate a tangent (handles 2 and 3)."""
        end = handle % 2
        if handle < 2:
            self.ends[end] = np.array(place)
        else:
            x, y = (np.array(place) - self.ends[end]) * (1 if end == 0 else -1)
            self.angles[end] = atan2(y, x)
        self._solve()
        places = self._places()
        places[handle] = place
        self.preview.handles.put(places)

    def _lengthen(self, length: float) -> None:
        self.length = length
        self._solve()
        self._draw()

    def _turn_over(self) -> None:
        along = 2 * atan2(*(self.ends[1] - self.ends[0])[::-1])
        self.angles = [along - angle for angle in self.angles]
        self.side = -self.side
        self._solve()
        self._draw()

    def _solve(self) -> None:
        angles = (None, None) if self.angles is None else (self.angles[0], self.angles[1])
        try:
            self.found = elastica_between(*self.ends, self.length, angles=angles, side=self.side)
            self.card.show_message(str(self.found), good=True)
        except ElasticaError as error:
            self.found = None
            self.card.show_message(str(error), good=False)
        points = np.zeros((0, 2)) if self.found is None else self.found.rod.position
        order = [2, 0, 1, 3]  # order of the handles on the line: a tangent, both ends, the other tangent
        self.preview.show(np.zeros((0, 2)), points, None if self.angles is None else self._places()[order])

    def _draw(self) -> None:
        self.preview.handles.put(self._places())
        if self.found is None:
            return
        document = self.sketch.Document
        open_step(document, translate("Elastica_Between", "Curve of given length"))
        self.number = recorded(replace_curve, self.sketch, self.number, self.found.curve)
        # solve in the same undo step, because solving moves points
        record_call(self.sketch, "solve")
        close_step(document)

    def _places(self) -> FloatArray:
        reach = REACH * float(np.hypot(*(self.ends[1] - self.ends[0])))
        off = [np.array([cos(angle), sin(angle)]) * reach for angle in self.angles]
        return np.array([*self.ends, self.ends[0] + off[0], self.ends[1] - off[1]])


def _initial_parameters(
    sketch: Any, view: Any
) -> tuple[int | None, list[FloatArray], list[float] | None, float, int]:
    number = _chosen_number(sketch)
    if number is None:
        is_flat = str(view.getCameraType()) == "Orthographic"
        half = VIEW_FRACTION * float(view.getCameraNode().height.getValue()) if is_flat else 50.0
        return None, [np.array([-half, 0.0]), np.array([half, 0.0])], None, 2 * half * SLACK, 1
    curve = sketch.Geometry[number]
    first, last = curve.FirstParameter, curve.LastParameter
    ends = [np.array(tuple(curve.value(t))[:2]) for t in (first, last)]
    if not isinstance(curve, Part.BSplineCurve):
        return None, ends, None, SLACK * float(np.hypot(*(ends[1] - ends[0]))), 1
    tangents = [curve.tangent(t)[0] for t in (first, last)]
    angles = [atan2(tangent.y, tangent.x) for tangent in tangents]
    middle = np.array(tuple(curve.value(curve.parameterAtDistance(curve.length() / 2, first)))[:2])
    chord, off = ends[1] - ends[0], middle - ends[0]
    side = 1 if chord[0] * off[1] - chord[1] * off[0] >= 0 else -1
    return number, ends, angles, float(curve.length()), side


def _chosen_number(sketch: Any) -> int | None:
    for choice in Gui.Selection.getSelectionEx():
        names = [name for name in choice.SubElementNames if name.startswith("Edge")]
        if choice.Object is sketch and names and not _is_closed(sketch.Geometry[int(names[0][4:]) - 1]):
            return int(names[0][4:]) - 1
    splines = [
        i
        for i, curve in enumerate(sketch.Geometry)
        if isinstance(curve, Part.BSplineCurve) and not _is_closed(curve) and not sketch.getConstruction(i)
    ]
    return splines[0] if len(splines) == 1 else None


def _is_closed(curve: Any) -> bool:
    if not hasattr(curve, "FirstParameter"):
        return True
    ends = (curve.value(curve.FirstParameter), curve.value(curve.LastParameter))
    return bool((ends[0] - ends[1]).Length < DIFFERENT_MM)


_running: list[BetweenClamps] = []


def running() -> BetweenClamps | None:
    """Return the running tool, or None."""
    return _running[0] if _running else None


def switch() -> None:
    """Start the tool in the open sketch, or end it if it is running."""
    if running() is not None:
        stop()
        return
    sketch, view = edited_sketch(), Gui.ActiveDocument.ActiveView
    if sketch is not None and hasattr(view, "getSceneGraph"):
        _running.append(BetweenClamps(sketch, view))


def stop() -> None:
    """End the tool without removing the drawn curve."""
    while _running:
        _running.pop().close()


WIDE_PX = 300
# delay, ms, between the last key and the use of the length
PAUSE_MS = 150
STYLE = """
#ElasticaVerdict { background: rgba(32, 33, 38, 230); border: 1px solid rgba(255, 255, 255, 60); }
#ElasticaVerdict QLabel { padding: 1px 8px; color: #f2f2f2; background: transparent; }
"""
"""Style of the card: white on dark in every theme, because the view behind it may have any colour."""


class LengthCard(QtCore.QObject):
    """Card in the upper left corner of a view, with the length and buttons that mirror the curve and end the
    tool.
    """

    def __init__(
        self,
        view: Any,
        length: float,
        lengthened: Callable[[float], None],
        turned_over: Callable[[], None],
        done: Callable[[], None],
    ) -> None:
        over = surface_of(view) or Gui.getMainWindow().centralWidget()
        super().__init__(over)
        self.frame = QtWidgets.QFrame(over)
        self.frame.setObjectName("ElasticaVerdict")
        self.heading, self.words = QtWidgets.QLabel(self.frame), QtWidgets.QLabel(self.frame)
        self.words.setWordWrap(True)
        self.words.setTextFormat(QtCore.Qt.PlainText)
        self.length = quantity_box()
        self.length.setParent(self.frame)
        self.length.setObjectName("length")
        self.length.setProperty("unit", "mm")
        set_value(self.length, length)
        self.side = QtWidgets.QPushButton(translate("Elastica", "Other side"), self.frame)
        self.done = QtWidgets.QPushButton(translate("Elastica", "Done"), self.frame)
        self.heading.setText(translate("Elastica", "Length between the clamps"))
        self.heading.setToolTip(
            translate(
                "Elastica", "Pull the ends and the tangents by their handles; the curve is drawn on release"
            )
        )
        row = QtWidgets.QHBoxLayout()
        for widget in (self.length, self.side, self.done):
            row.addWidget(widget)
        row.setContentsMargins(8, 0, 8, 0)
        layout = QtWidgets.QVBoxLayout(self.frame)
        layout.setContentsMargins(0, 0, 0, 6)
        layout.addWidget(self.heading)
        layout.addLayout(row)
        layout.addWidget(self.words)
        self.frame.setStyleSheet(STYLE)
        calm(self.frame)
        self._pause = later(lambda: lengthened(value_of(self.length)), PAUSE_MS, self.frame)
        on_change(self.length, lambda *_: self._pause.start())
        self.side.clicked.connect(lambda *_: turned_over())
        # end the tool later, because a pressed button must not be deleted
        self.done.clicked.connect(lambda *_: QtCore.QTimer.singleShot(0, done))
        self.frame.setFixedWidth(WIDE_PX)
        self.frame.move(free_part(over).topLeft() + QtCore.QPoint(GAP_PX, GAP_PX))
        self.frame.show()

    def show_message(self, sentence: str, *, good: bool) -> None:
        """Describe the curve, or explain why there is none."""
        self.heading.setStyleSheet(heading_style(Verdict.CAN if good else Verdict.CANNOT))
        words = worded(sentence)
        if words != self.words.text():
            self.words.setText(words)
            self.frame.layout().activate()
            self.frame.setFixedHeight(max(self.frame.layout().totalHeightForWidth(WIDE_PX), 0))

    def remove(self) -> None:
        """Remove the card. The view may already be closed."""
        with suppress(RuntimeError):
            self._pause.stop()
            self.frame.hide()
            self.frame.deleteLater()
