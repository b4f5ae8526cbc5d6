# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The verdict in the view: a card that wraps its sentence, tells the colours and offers a way out."""

from collections.abc import Callable
from contextlib import suppress
from typing import Any

import FreeCADGui as Gui
from freecad.elastica_wb.host.qt import QtCore, QtWidgets, kind_of, surface_of
from freecad.elastica_wb.host.resources import translate
from freecad.elastica_wb.live.overlay import COLORS
from freecad.elastica_wb.live.verdict import Answer, Verdict

GAP_PX = 12  # from the view's edges
WIDEST_PX = 620  # a line that is longer reads badly
SHARE = 0.62  # of the view's width: the navigation cube and the axes keep their corners


class VerdictCard(QtCore.QObject):
    """A frame over a view; `wanted` is called when the user asks for the nearest curve."""

    def __init__(self, view: Any, wanted: Callable[[], None]) -> None:
        # without a surface of its own the card lies on the area of all views
        self._over = surface_of(view) or Gui.getMainWindow().centralWidget()
        super().__init__(self._over)
        self.frame = QtWidgets.QFrame(self._over)
        self.frame.setObjectName("ElasticaVerdict")
        self.heading, self.words, self.legend = (QtWidgets.QLabel(self.frame) for _ in range(3))
        self.button = QtWidgets.QPushButton(translate("Elastica", "Use the nearest curve"), self.frame)
        self.button.setObjectName("useNearest")
        self.button.setFocusPolicy(QtCore.Qt.NoFocus)  # keys go on to the sketcher
        self.button.clicked.connect(lambda *_: wanted())
        self.words.setWordWrap(True)
        layout = QtWidgets.QVBoxLayout(self.frame)
        layout.setContentsMargins(0, 0, 0, 6)
        layout.setSpacing(4)
        for widget in (self.heading, self.words, self.button, self.legend):
            layout.addWidget(widget)
        layout.setAlignment(self.button, QtCore.Qt.AlignLeft)
        self.frame.setStyleSheet(STYLE)
        self.legend.setText(_legend())
        self.button.hide()
        self._over.installEventFilter(self)
        self.answer: Answer | None = None
        self._tall = 0

    def show(self, answer: Answer, sentence: str) -> None:
        """Another verdict; `sentence` is in the user's units."""
        with suppress(RuntimeError):  # the view was closed
            self._show(answer, sentence)
        self.answer = answer

    def _show(self, answer: Answer, sentence: str) -> None:
        if self.answer is None or answer.words != self.answer.words:
            self.heading.setText(answer.words)
        if self.answer is None or answer.verdict is not self.answer.verdict:
            color = hex_of(COLORS[answer.verdict])
            self.heading.setStyleSheet(
                f"background: {color}; color: white; font-weight: bold; padding: 4px 8px;"
            )
            self.legend.setVisible(answer.verdict is Verdict.CAN)
        if sentence != self.words.text():
            self.words.setText(sentence)
            tall = self.words.heightForWidth(self.words.width())
            if tall != self._tall:  # most moves of the mouse change figures only
                self._tall = tall
                self._place()
        self.frame.show()

    def offer(self, *, nearest: bool) -> None:
        """Is there a nearest curve to be used?"""
        with suppress(RuntimeError):
            if self.button.isVisibleTo(self.frame) != nearest:
                self.button.setVisible(nearest)
                self._place()

    def remove(self) -> None:
        """Take it off the view, which may be closed already."""
        with suppress(RuntimeError):
            self._over.removeEventFilter(self)
            self.frame.hide()
            self.frame.deleteLater()

    def eventFilter(self, _watched: Any, event: Any) -> bool:
        """The view has another size."""
        if kind_of(event) == QtCore.QEvent.Resize:
            self._place()
        return False

    def _place(self) -> None:
        """In the lower left corner, as wide as reads well."""
        width = min(WIDEST_PX, round(SHARE * self._over.width()))
        self.frame.setFixedWidth(max(width, 200))
        self.frame.layout().activate()
        height = self.frame.layout().totalHeightForWidth(self.frame.width())
        self.frame.setFixedHeight(max(height, self.frame.sizeHint().height() if height < 0 else height))
        self.frame.move(GAP_PX, self._over.height() - self.frame.height() - GAP_PX)


def _legend() -> str:
    """One line: what the colours of the overlay mean."""
    names = (
        ("comb", translate("Elastica", "curvature")),
        ("width", translate("Elastica", "the strip laid flat")),
        (Verdict.CAN, translate("Elastica", "inflections on their line")),
    )
    return " &nbsp; ".join(
        f'<span style="color: {hex_of(COLORS[key])};">&#9644;</span> {name}' for key, name in names
    )


def hex_of(color: tuple[float, float, float]) -> str:
    """Return a colour as style sheets write it, "#rrggbb"."""
    return "#" + "".join(f"{round(255 * part):02x}" for part in color)


STYLE = """
#ElasticaVerdict { background: rgba(32, 33, 38, 230); border: 1px solid rgba(255, 255, 255, 60); }
#ElasticaVerdict QLabel { padding: 1px 8px; color: #f2f2f2; background: transparent; }
#useNearest { margin-left: 8px; padding: 3px 10px; }
"""
"""White on dark whatever the theme: style sheets do not tell their colours, and the view behind may be anything."""
