# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The panel of the tolerance study, which bends many strips with random errors and shows a chart and a table."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any

from freecad.elastica_wb.features.strip import strip_of
from freecad.elastica_wb.host.progress import progress
from freecad.elastica_wb.host.qt import QtCore, QtGui
from freecad.elastica_wb.host.resources import translate
from freecad.elastica_wb.host.words import shown_unit, worded
from freecad.elastica_wb.panels.panel import Panel

from elastica_cad.errors import ElasticaError, Length, note
from elastica_cad.mechanics.tolerances import ToleranceStudy, tolerance_study


class TolerancePanel(Panel):
    """Panel that runs the study of one strip. The Escape key stops the study without a result."""

    file = "tolerance"
    icon_name = "Elastica_Tolerance"
    only_tells = True

    def __init__(self, obj: Any) -> None:
        self.strip = strip_of(obj)
        super().__init__()
        self.study: ToleranceStudy | None = None
        self.form.run.clicked.connect(self.run)
        self.show_message(translate("Elastica", "Ranges are those of the sheet."))

    def run(self, *_: Any) -> None:
        """Bend all samples and show their deviations."""
        try:
            self.study = tolerance_study(
                self.strip.rod,
                sheet=self.strip.sheet,
                max_width=self.strip.width.extremes[1],
                samples=self.value("samples"),
                executor=Watched("Bending varied strips"),
            )
        except Stopped:
            self.show_message(translate("Elastica", "Stopped."))
            return
        except ElasticaError as error:
            self.show_message(str(error))
            return
        effects, unit = (*self.study.effects, self.study.combined), shown_unit()
        names = [translate("Elastica", effect.name) for effect in effects]
        table = [
            (translate("Elastica", "deviation") + f", {unit.name}", "95 %", translate("Elastica", "worst"))
        ]
        table += [
            (
                name,
                *(
                    worded(note("{far:.3f}", far=deviation / unit.size))
                    for deviation in (effect.percentile_95, effect.worst)
                ),
            )
            for name, effect in zip(names, effects, strict=True)
        ]
        rows = "".join(f"<tr><td>{'&nbsp;&nbsp;</td><td align=right>'.join(row)}</td></tr>" for row in table)
        self.form.table.setText(f"<table>{rows}</table>")
        bars = zip(names, effects, strict=True)
        self.form.plot.setPixmap(bar_chart([(name, e.percentile_95, e.worst) for name, e in bars]))
        self.show_message("")


class Stopped(Exception):  # noqa: N818 - not an error, but a decision of the user
    """The user pressed the Escape key."""


class Watched:
    """Executor that runs tasks in this thread and shows the progress."""

    def __init__(self, title: str) -> None:
        self._title = title

    def map(self, work: Callable[..., Any], *arguments: Iterable[Any], **_chunks: int) -> Iterator[Any]:
        """Yield the result of each task, like `map` of executors in `concurrent.futures`.

        Raises
        ------
        Stopped
            The user pressed the Escape key.
        """
        tasks = list(zip(*arguments, strict=True))
        with progress(self._title, len(tasks)) as step:
            for done, task in enumerate(tasks):
                if not step(done):
                    raise Stopped
                yield work(*task)


# height of a row, and width of the chart, pixels
ROW, WIDTH = 24, 196


def bar_chart(rows: Sequence[tuple[str, float, float]]) -> Any:
    """Draw two bars for each row (name, 95th percentile, worst case) of deviations, mm.

    The dark bar is the 95th percentile.
    """
    largest = max((worst for _, _, worst in rows), default=0.0) or 1.0
    picture = QtGui.QPixmap(WIDTH, ROW * len(rows) + 10)
    picture.fill(QtGui.QColor("white"))
    painter = QtGui.QPainter(picture)
    lengths = [painter.fontMetrics().boundingRect(name).width() for name, _, _ in rows]
    left = max(lengths, default=0) + 14
    width = WIDTH - left - 70
    for i, ((name, usual, worst), long) in enumerate(zip(rows, lengths, strict=True)):
        y = 6 + ROW * i
        painter.setPen(QtGui.QColor("#222222"))
        painter.drawText(QtCore.QPoint(left - 10 - long, y + 14), name)
        for value, color in ((worst, "#f0c9a0"), (usual, "#c8641e")):
            painter.fillRect(
                QtCore.QRect(left, y + 2, round(width * value / largest), 14), QtGui.QColor(color)
            )
        end = QtCore.QPoint(left + round(width * worst / largest) + 6, y + 14)
        painter.drawText(end, worded(note("{worst:.2f}", worst=Length(worst))))
    painter.end()
    return picture
