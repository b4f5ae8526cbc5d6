# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""A card over the view with a field for the length, which also describes the drawn curve."""

from collections.abc import Callable
from contextlib import suppress
from typing import Any

import FreeCADGui as Gui
from freecad.elastica_wb.host.qt import QtCore, QtWidgets, later, surface_of
from freecad.elastica_wb.host.resources import translate
from freecad.elastica_wb.host.words import worded
from freecad.elastica_wb.live.overlay import COLORS
from freecad.elastica_wb.live.verdict import Verdict
from freecad.elastica_wb.live.verdict_card import GAP_PX, STYLE, hex_of
from freecad.elastica_wb.panels.widgets.fields import calm, on_change, quantity_box, set_value, value_of

WIDE_PX = 300
PAUSE_MS = 150  # ms after the last key


class LengthCard(QtCore.QObject):
    """A card in the upper left corner of a view: a length, a button for the other side, and a button to finish."""

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
        # do not delete a button while it is pressed
        self.done.clicked.connect(lambda *_: QtCore.QTimer.singleShot(0, done))
        self.frame.setFixedWidth(WIDE_PX)
        self.frame.move(GAP_PX, GAP_PX)
        self.frame.show()

    def tell(self, sentence: str, *, good: bool) -> None:
        """Describe the curve, or explain why there is none. Lengths are in mm."""
        color = hex_of(COLORS[Verdict.CAN if good else Verdict.CANNOT])
        self.heading.setStyleSheet(f"background: {color}; color: white; font-weight: bold; padding: 4px 8px;")
        words = worded(sentence)
        if words != self.words.text():
            self.words.setText(words)
            self.frame.layout().activate()
            self.frame.setFixedHeight(max(self.frame.layout().totalHeightForWidth(WIDE_PX), 0))

    def remove(self) -> None:
        """Remove the card from the view, which may be closed already."""
        with suppress(RuntimeError):
            self._pause.stop()
            self.frame.hide()
            self.frame.deleteLater()
