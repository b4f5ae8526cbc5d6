# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""A verdict of `solving/verdicts`: a headline over a 3D view, and a box with reason, legend and buttons in the
panel *Tasks*.
"""

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from textwrap import fill
from typing import Any

import FreeCADGui as Gui
from freecad.elastica_wb.host.objects import sensor
from freecad.elastica_wb.host.qt import BUTTON_LETTERS, QtCore, QtWidgets, kind_of, later, surface_of
from freecad.elastica_wb.host.resources import translate
from freecad.elastica_wb.host.words import worded
from freecad.elastica_wb.live.overlay import COLORS, PARTS
from freecad.elastica_wb.solving.verdicts import Answer, Verdict
from pivy import coin

from elastica_cad.mechanics.sheets import hex_color

# distance, pixels, from the edges of the view, and from points that must stay visible
GAP_PX = 12
# space, pixels, for the navigation cube and the axes at the right edge
CUBE_PX = 140
# largest width of the headline, as a fraction of the view, so that the curve is visible beside it
WIDTH_FRACTION = 0.45
# delay, ms, after the last camera move, before the headline is placed again
LOOKED_MS = 100
# distance, pixels, of the box from the sides of its panel
SIDE_PX = 8
MESSAGES, UPDATE = "SketcherGui::TaskSketcherMessages", "manualUpdate"
"""Class of the sketcher's messages in the panel *Tasks*, and the name of a button in them."""


class VerdictCard(QtCore.QObject):
    """Headline over a view, and a box below the messages of the sketcher or in another layout.

    The headline ignores the mouse. It is in the corner where it hides the fewest points that should stay
    visible. In the box, `button` calls `use_nearest`, `larger` calls `enlarge`, and `keep` switches on that a
    dragged pole returns to the last position where the strip can be made.
    """

    def __init__(
        self,
        view: Any,
        use_nearest: Callable[[], None],
        enlarge: Callable[[], None],
        layout: Any = None,
    ) -> None:
        # without a drawing widget, use the area of all views
        self._view, self._over = view, surface_of(view) or Gui.getMainWindow().centralWidget()
        super().__init__(self._over)
        self.heading, self.box = QtWidgets.QLabel(self._over), QtWidgets.QWidget()
        self.heading.setObjectName("ElasticaVerdict")
        self.heading.setAttribute(QtCore.Qt.WA_TransparentForMouseEvents)
        self.verdict, self.words, self.legend, self.why = (QtWidgets.QLabel(self.box) for _ in range(4))
        # names of sheets may look like HTML
        for label in (self.heading, self.verdict, self.words, self.why):
            label.setTextFormat(QtCore.Qt.PlainText)
        self.button, self.larger = QtWidgets.QPushButton(self.box), QtWidgets.QPushButton(self.box)
        self.button.setObjectName("useNearest")
        self.larger.setObjectName("drawLarger")
        for button in (self.button, self.larger):
            button.hide()
        self.keep = QtWidgets.QCheckBox(translate("Elastica", "Keep it possible"), self.box)
        self.keep.setObjectName("keepPossible")
        self.keep.setToolTip(
            translate("Elastica", "A dragged pole returns to the last position where the strip can be made")
        )
        self.button.clicked.connect(lambda *_: use_nearest())
        self.larger.clicked.connect(lambda *_: enlarge())
        inside = QtWidgets.QVBoxLayout(self.box)
        inside.setContentsMargins(0, 0, 0, 0)
        inside.setSpacing(4)
        # buttons first, because the reason may be longer than the panel
        for part in (self.verdict, self.button, self.larger, self.keep, self.why, self.words, self.legend):
            inside.addWidget(part)
            # no keyboard focus, so that the sketcher receives the keys
            part.setFocusPolicy(QtCore.Qt.NoFocus)
            if isinstance(part, QtWidgets.QLabel):
                part.setWordWrap(True)
        self.answer: Answer | None = None
        self._layout, self._viewport, self._corner, self._title = layout, None, 0, ""
        self._places: Sequence[Any] = ()
        self._over.installEventFilter(self)
        self._soon = later(self._place, LOOKED_MS, self)
        self._camera = sensor(coin.SoNodeSensor, self._looks_elsewhere)

    def show(self, answer: Answer, sentence: str, counts: Mapping[str, int]) -> None:
        """Show a verdict. `counts` has the number of points of each part of the overlay."""
        with suppress(RuntimeError):  # the view may already be closed
            if self.box.parent() is None:
                self._insert()
            if self.answer is None or answer.verdict is not self.answer.verdict:
                for label in (self.heading, self.verdict):
                    label.setStyleSheet(heading_style(answer.verdict))
            self.words.setText(sentence)
            self.legend.setText(_legend(counts))
            title = worded(answer.words)
            if title != self._title:
                self._title = title
                self._place()
            self._fit()
            self.heading.show()
        self.answer = answer

    def _insert(self) -> None:
        """Insert the box into its layout, or below the messages of the sketcher if its panel is open."""
        if self._layout is not None:
            self._layout.addWidget(self.box)
            return
        # PySide crashes on some of FreeCAD's widgets, so that only this one is looked at
        widget = Gui.getMainWindow().findChild(QtWidgets.QAbstractButton, UPDATE)
        while widget is not None and widget.metaObject().className() != MESSAGES:
            widget = widget.parentWidget()
        if widget is not None:
            panel = widget.parentWidget()
            self._viewport, layout = panel.parentWidget(), panel.layout()
            self._viewport.installEventFilter(self)
            layout.insertWidget(layout.indexOf(widget) + 1, self.box, 0, QtCore.Qt.AlignLeft)

    def _fit(self) -> None:
        """Set the size of the box for its texts. In FreeCAD 0.20, the sketcher's panel is wider than its view."""
        if self._viewport is not None:
            width = self._viewport.width() - 2 * SIDE_PX
            self.box.setFixedSize(width, self.box.layout().totalHeightForWidth(width))

    def offer(self, words: str, *, usable: bool = True, button: Any = None) -> None:
        """Set the text of a button, by default the one that calls `use_nearest`. An empty text hides it."""
        button = button or self.button
        with suppress(RuntimeError):
            button.setText(fill(words, BUTTON_LETTERS))
            button.setEnabled(usable)
            button.setVisible(bool(words))
            self._fit()

    def allow_keep(self, why: str) -> None:
        """Enable the switch `keep`, or show why it has no effect."""
        with suppress(RuntimeError):
            self.keep.setEnabled(not why)
            self.why.setText(why)
            self.why.setVisible(bool(why))
            self._fit()

    def keep_off(self, places: Sequence[Any]) -> None:
        """Set the points in space that the headline should not hide."""
        with suppress(RuntimeError):
            self._places = places
            # place the headline first, because this call raises an error if the view was closed
            self._place()
            self._camera.attach(self._view.getCameraNode())

    def remove(self) -> None:
        """Remove headline and box. The view may already be closed."""
        self._camera.detach()
        with suppress(RuntimeError):
            self.box.hide()
            self.box.deleteLater()
        with suppress(RuntimeError):
            self._over.removeEventFilter(self)
            self.heading.hide()
            self.heading.deleteLater()
            self.deleteLater()
        # release the widgets, because PySide would reuse their wrappers for the next view
        self._over = self._view = self._viewport = None

    def eventFilter(self, _watched: Any, event: Any) -> bool:
        """Place headline and box again when the size of the view or of the panel changes."""
        if kind_of(event) == QtCore.QEvent.Resize:
            self._place()
        return False

    def _looks_elsewhere(self) -> None:
        """Place the headline again after a camera move. The view may already be closed."""
        with suppress(RuntimeError):
            self._soon.start()

    def _place(self) -> None:
        """Place the headline, and fit the box into its panel, whose visible part may be smaller now."""
        if self._over is None:  # FreeCAD may report a camera move while it closes the view
            return
        self._fit()
        part = free_part(self._over)
        room = round(WIDTH_FRACTION * part.width())
        letters = self.heading.fontMetrics()
        for label in (self.heading, self.verdict):
            label.setText(letters.elidedText(self._title, QtCore.Qt.ElideRight, room))
        self.heading.adjustSize()
        self.heading.move(*self._free_corner(part))

    def _free_corner(self, part: Any) -> tuple[int, int]:
        """Return the corner (x, y) where the headline hides the fewest points.

        `part` is the rectangle of the view that no panel covers. The current corner is preferred. A corner with
        another card is chosen last.
        """
        over, size = self._over, self.heading.size()
        others = over.findChildren(QtWidgets.QFrame, self.heading.objectName())
        cards = [card.geometry() for card in others if card != self.heading and card.isVisible()]
        start, above = part.left() + GAP_PX, part.top() + GAP_PX
        end = max(start, part.left() + part.width() - size.width() - CUBE_PX)
        below = max(above, part.top() + part.height() - size.height() - GAP_PX)
        corners = [(start, below), (start, above), (end, above), (end, below)]
        scale = self._view.getSize()[1] / over.height()
        points = [
            (x / scale, over.height() - y / scale) for x, y in map(self._view.getPointOnScreen, self._places)
        ]

        def hidden(corner: int) -> int:
            left, top = corners[corner]
            if any(card.intersects(QtCore.QRect(QtCore.QPoint(left, top), size)) for card in cards):
                return len(points) + 1
            wide, tall = size.width() + GAP_PX, size.height() + GAP_PX
            return sum(left - GAP_PX < x < left + wide and top - GAP_PX < y < top + tall for x, y in points)

        self._corner = min(range(len(corners)), key=lambda corner: (hidden(corner), corner != self._corner))
        return corners[self._corner]


def free_part(over: Any) -> Any:
    """Return the rectangle of a view that no panel covers. FreeCAD 1.x shows panels over views."""
    free = over.rect()
    for panel in Gui.getMainWindow().findChildren(QtWidgets.QTabWidget):
        if panel.metaObject().className() == PANELS and panel.isVisible() and panel.count():
            covered = free.intersected(
                QtCore.QRect(over.mapFromGlobal(panel.mapToGlobal(NOWHERE)), panel.size())
            )
            if covered.isEmpty():
                continue
            if covered.height() > covered.width():
                at_left = covered.center().x() < free.center().x()
                free.setLeft(covered.right() + 1) if at_left else free.setRight(covered.left() - 1)
            else:
                at_top = covered.center().y() < free.center().y()
                free.setTop(covered.bottom() + 1) if at_top else free.setBottom(covered.top() - 1)
    return free


PANELS, NOWHERE = "Gui::OverlayTabWidget", QtCore.QPoint(0, 0)


def _legend(counts: Mapping[str, int]) -> str:
    return " &nbsp; ".join(
        f'<span style="color: {hex_color(part.color)};">{part.sign}</span>&nbsp;{translate("Elastica", part.words)}'
        for name, part in PARTS.items()
        if counts[name]
    )


def heading_style(verdict: Verdict) -> str:
    """Return the style sheet of a heading in the colour of a result."""
    return f"background: {hex_color(COLORS[verdict])}; color: white; font-weight: bold; padding: 4px 8px;"
