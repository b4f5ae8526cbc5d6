# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Charts for panels."""

from collections.abc import Sequence
from typing import Any

from freecad.elastica_wb.host.qt import QtCore, QtGui
from freecad.elastica_wb.host.words import worded

from elastica_cad.errors import note

WIDTH_PX, HEIGHT_PX, LEFT_PX, EDGE_PX, LINE_PX = 196, 150, 44, 22, 2
INK, LINE, MARK = "#222222", "#1f5fa8", "#c2571a"


def line_chart(x: Sequence[float], y: Sequence[float], names: tuple[str, str], mark: float | None) -> Any:
    """Draw y over x with the given names of the axes (x, y), and a dashed line at x = mark."""
    picture = QtGui.QPixmap(WIDTH_PX, HEIGHT_PX)
    picture.fill(QtGui.QColor("white"))
    painter = QtGui.QPainter(picture)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    low, high, end = min(0.0, *y), max(0.0, *y), max(x) or 1.0
    wide, tall = WIDTH_PX - LEFT_PX - EDGE_PX, HEIGHT_PX - 2 * EDGE_PX

    def place(a: float, b: float) -> Any:
        up = (b - low) / ((high - low) or 1.0)
        return QtCore.QPointF(LEFT_PX + wide * a / end, HEIGHT_PX - EDGE_PX - tall * up)

    painter.setPen(QtGui.QColor(INK))
    painter.drawLine(place(0.0, low), place(0.0, high))
    painter.drawLine(place(0.0, 0.0), place(end, 0.0))
    below = HEIGHT_PX - EDGE_PX // 4
    painter.drawText(QtCore.QPointF(LEFT_PX, EDGE_PX - 6), names[1])
    name_px = painter.fontMetrics().boundingRect(names[0]).width()
    painter.drawText(QtCore.QPointF(WIDTH_PX - name_px - 6, below), names[0])
    for value in dict.fromkeys((low, 0.0, high)):
        painter.drawText(QtCore.QPointF(4, place(0.0, value).y() + 4), _number(value))
    painter.drawText(QtCore.QPointF(place(end, 0.0).x() - 12, place(end, 0.0).y() - 4), _number(end))
    if mark is not None:
        painter.setPen(QtGui.QPen(QtGui.QColor(MARK), 1, QtCore.Qt.DashLine))
        painter.drawLine(place(mark, low), place(mark, high))
    painter.setPen(QtGui.QPen(QtGui.QColor(LINE), LINE_PX))
    painter.drawPolyline(QtGui.QPolygonF([place(a, b) for a, b in zip(x, y, strict=True)]))
    painter.end()
    return picture


def _number(value: float) -> str:
    return worded(note("{number:.3g}", number=value))
