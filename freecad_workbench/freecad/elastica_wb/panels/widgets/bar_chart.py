# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""A bar chart without matplotlib, which Debian's FreeCAD may lack."""

from collections.abc import Sequence
from typing import Any

from freecad.elastica_wb.host.qt import QtCore, QtGui
from freecad.elastica_wb.host.words import worded

from elastica_cad.refusals import Length, note

ROW, LEFT, WIDTH = 24, 105, 300  # px: height of a row, width for names, width of the picture


def bar_chart(rows: Sequence[tuple[str, float, float]]) -> Any:
    """Draw rows (name, usual, worst), mm, with a dark bar for the usual value and a light bar for the worst."""
    largest = max((worst for _, _, worst in rows), default=0.0) or 1.0
    picture = QtGui.QPixmap(WIDTH, ROW * len(rows) + 10)
    picture.fill(QtGui.QColor("white"))
    painter = QtGui.QPainter(picture)
    room = WIDTH - LEFT - 70
    for i, (name, usual, worst) in enumerate(rows):
        y = 6 + ROW * i
        painter.setPen(QtGui.QColor("#222222"))
        long = painter.fontMetrics().boundingRect(name).width()
        painter.drawText(QtCore.QPoint(LEFT - 10 - long, y + 14), name)
        for value, color in ((worst, "#f0c9a0"), (usual, "#c8641e")):
            painter.fillRect(
                QtCore.QRect(LEFT, y + 2, round(room * value / largest), 14), QtGui.QColor(color)
            )
        end = QtCore.QPoint(LEFT + round(room * worst / largest) + 6, y + 14)
        painter.drawText(end, worded(note("{worst:.2f}", worst=Length(worst))))
    painter.end()
    return picture
