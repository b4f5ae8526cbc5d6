# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The card over a 3D view: a verdict of `solving/verdicts`, a legend, and a button for the nearest curve."""

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from typing import Any

import FreeCADGui as Gui
from freecad.elastica_wb.host import preferences
from freecad.elastica_wb.host.objects import sensor
from freecad.elastica_wb.host.qt import QtCore, QtWidgets, kind_of, later, surface_of
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
WIDEST_PX, NARROW_PX, FOLDED_PX = 480, 320, 240
# largest width of the card as a fraction of the view, so that the curve is visible beside it
WIDTH_FRACTION = 0.45
# a card that hides points and covers more than this fraction of the view is folded
SMALL = 0.15
# delay, ms, after the last camera move, before the card is placed again
LOOKED_MS = 100
FOLDED = "CardFolded"


class VerdictCard(QtCore.QObject):
    """Card over a view: a frame that ignores the mouse, and three buttons.

    `button` calls `use_nearest`, `fold` folds the card, and `keep` switches on that a dragged pole returns to
    the last position where the strip can be made. The card is in the corner where it hides the fewest points
    that should stay visible.
    """

    def __init__(self, view: Any, use_nearest: Callable[[], None]) -> None:
        # without a drawing widget, use the area of all views
        self._view, self._over = view, surface_of(view) or Gui.getMainWindow().centralWidget()
        super().__init__(self._over)
        self.frame = QtWidgets.QFrame(self._over)
        self.frame.setObjectName("ElasticaVerdict")
        self.frame.setAttribute(QtCore.Qt.WA_TransparentForMouseEvents)
        self.heading, self.words, self.legend = (QtWidgets.QLabel(self.frame) for _ in range(3))
        # names of sheets may look like HTML
        self.words.setTextFormat(QtCore.Qt.PlainText)
        layout = QtWidgets.QVBoxLayout(self.frame)
        layout.setSpacing(4)
        for label in (self.heading, self.words, self.legend):
            label.setWordWrap(label is not self.heading)
            layout.addWidget(label)
        # the frame ignores the mouse, so the buttons are beside it
        self.button, self.fold = QtWidgets.QPushButton(self._over), QtWidgets.QPushButton(self._over)
        self.keep = QtWidgets.QPushButton(translate("Elastica", "Keep it possible"), self._over)
        self.keep.setCheckable(True)
        self.keep.setObjectName("keepPossible")
        self.keep.setToolTip(
            translate("Elastica", "A dragged pole returns to the last position where the strip can be made")
        )
        self.button.setObjectName("useNearest")
        self.fold.setObjectName("foldVerdict")
        self.fold.setToolTip(translate("Elastica", "Fold or unfold the card"))
        self.button.clicked.connect(lambda *_: use_nearest())
        self.fold.clicked.connect(self._turn)
        for part in (self.frame, self.button, self.fold, self.keep):
            part.setStyleSheet(STYLE)
            # no keyboard focus, so that the sketcher receives the keys
            part.setFocusPolicy(QtCore.Qt.NoFocus)
        self.answer: Answer | None = None
        self._tall = self._corner = 0
        # two flags: a small view folded the card, and the user unfolded the card
        self._shrunk = self._stays_open = False
        self._places: Sequence[Any] = ()
        self._over.installEventFilter(self)
        self._soon = later(self._place, LOOKED_MS, self)
        self._camera = sensor(coin.SoNodeSensor, self._looks_elsewhere)

    def show(self, answer: Answer, sentence: str, counts: Mapping[str, int]) -> None:
        """Show a verdict. `counts` has the number of points of each part of the overlay."""
        with suppress(RuntimeError):  # the view may already be closed
            self._show(answer, sentence, _legend(counts))
        self.answer = answer

    def _show(self, answer: Answer, sentence: str, legend: str) -> None:
        self.heading.setText(worded(answer.words))
        if self.answer is None or answer.verdict is not self.answer.verdict:
            self.heading.setStyleSheet(heading_style(answer.verdict))
        if (sentence, legend) != (self.words.text(), self.legend.text()):
            self.words.setText(sentence)
            self.legend.setText(legend)
            tall = sum(label.heightForWidth(label.width()) for label in (self.words, self.legend))
            if tall != self._tall:
                self._tall = tall
                self._place()
        self.frame.show()

    def offer(self, words: str, *, usable: bool = True) -> None:
        """Set the text of the button that calls `use_nearest`. An empty text hides the button."""
        with suppress(RuntimeError):
            if words != self.button.text():
                self.button.setText(words)
                self.button.setEnabled(usable)
                self._place()

    def keep_off(self, places: Sequence[Any]) -> None:
        """Set the points in space that the card should not hide."""
        with suppress(RuntimeError):
            self._places = places
            # place the card first, because this call raises an error if the view was closed
            self._place()
            self._camera.attach(self._view.getCameraNode())

    def remove(self) -> None:
        """Remove the card. The view may already be closed."""
        self._camera.detach()
        with suppress(RuntimeError):
            self._over.removeEventFilter(self)
            for part in (self.frame, self.button, self.fold, self.keep):
                part.hide()
                part.deleteLater()
            self.deleteLater()
        # release the view, because PySide would reuse its wrapper for the next view
        self._over = self._view = None

    def eventFilter(self, _watched: Any, event: Any) -> bool:
        """Place the card again when the size of the view changes."""
        if kind_of(event) == QtCore.QEvent.Resize:
            self._place()
        return False

    def _looks_elsewhere(self) -> None:
        """Place the card again after a camera move. The view may already be closed."""
        with suppress(RuntimeError):
            self._soon.start()

    def _turn(self, *_: Any) -> None:
        if self._shrunk or self._stays_open:
            self._stays_open = self._shrunk
        else:
            preferences.put(FOLDED, not preferences.get(FOLDED))
        self._place()

    def _place(self) -> None:
        """Place the card. In a small view, the card is folded if it would hide points."""
        if self._over is None:  # FreeCAD may report a camera move while it closes the view
            return
        folded = preferences.get(FOLDED)
        part, cards = free_part(self._over), self._other_cards()
        hidden = self._lay_out(part, cards, folded=folded)
        is_small = self.frame.width() * self.frame.height() > SMALL * part.width() * part.height()
        self._shrunk = not folded and not self._stays_open and is_small and hidden > 0
        if self._shrunk:
            self._lay_out(part, cards, folded=True)

    def _other_cards(self) -> list[Any]:
        cards = self._over.findChildren(QtWidgets.QFrame, self.frame.objectName())
        return [card.geometry() for card in cards if card != self.frame and card.isVisible()]

    def _lay_out(self, part: Any, cards: Sequence[Any], *, folded: bool) -> int:
        """Set width and position of the card. Return the number of hidden points.

        `part` is the rectangle of the view that no panel covers, and `cards` are the rectangles of other cards.
        """
        self.fold.setText("▴" if folded else "▾")
        self.fold.setFixedSize(self.fold.sizeHint())
        self.button.setFixedSize(self.button.sizeHint())
        self.button.setVisible(bool(self.button.text()) and not folded)
        self.words.setVisible(not folded)
        self.legend.setVisible(bool(self.legend.text()) and not folded)
        self.keep.setFixedSize(self.keep.sizeHint())
        self.keep.setVisible(not folded)
        rows = [button for button in (self.keep, self.button) if button.isVisible()]
        layout, button_height = self.frame.layout(), sum(button.height() + GAP_PX for button in rows)
        layout.setContentsMargins(0, 0, 0, button_height + (0 if folded else GAP_PX // 2))
        widest = max(min(WIDEST_PX, round(WIDTH_FRACTION * part.width())), FOLDED_PX)
        # a narrow card is higher, and may fit beside the curve
        widths = (FOLDED_PX,) if folded else (widest, min(widest, NARROW_PX))

        def resized(width: int) -> tuple[int, tuple[int, int]]:
            self.frame.setFixedWidth(width)
            layout.activate()
            tall = self.heading.sizeHint().height() if folded else layout.totalHeightForWidth(width)
            self.frame.setFixedHeight(tall)
            corner, hidden = self._free_corner(part, cards)
            return hidden, corner

        width = min(widths, key=lambda width: resized(width)[0])
        hidden, (x, y) = resized(width)
        self.frame.move(x, y)
        self.fold.move(x + width - self.fold.width() - 2, y + 2)
        below = y + self.frame.height() + GAP_PX // 2
        for button in rows[::-1]:
            below -= button.height() + GAP_PX
            button.move(x + GAP_PX, below)
        self.fold.show()
        return hidden

    def _free_corner(self, part: Any, cards: Sequence[Any]) -> tuple[tuple[int, int], int]:
        """Return the corner (x, y) where the frame hides the fewest points, and their number.

        The current corner is preferred. A corner with another card is chosen last.
        """
        over, size = self._over, self.frame.size()
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
        return corners[self._corner], hidden(self._corner)


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
        f'<span style="color: {hex_color(part.color)};">{part.sign}</span>'
        f"&nbsp;{translate('Elastica', part.words).replace(' ', '&nbsp;')}"
        for name, part in PARTS.items()
        if counts[name]
    )


def heading_style(verdict: Verdict) -> str:
    """Return the style sheet of a heading in the colour of a result."""
    return f"background: {hex_color(COLORS[verdict])}; color: white; font-weight: bold; padding: 4px 8px;"


STYLE = """
#ElasticaVerdict { background: rgba(32, 33, 38, 230); border: 1px solid rgba(255, 255, 255, 60); }
#ElasticaVerdict QLabel { padding: 1px 8px; color: #f2f2f2; background: transparent; }
#useNearest, #keepPossible { padding: 3px 10px; }
#keepPossible:checked { color: white; background: #14873d; }
#foldVerdict { border: none; padding: 3px 8px; color: white; background: transparent; }
"""
"""Style of the card: white on dark in every theme, because the view behind it may have any colour."""
