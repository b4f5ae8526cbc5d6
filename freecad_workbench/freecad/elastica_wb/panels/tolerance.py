# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The panel of the tolerance study: bends many varied strips, a plot and a table at the end."""

from collections.abc import Callable, Iterable, Iterator
from typing import Any

from freecad.elastica_wb.features.strip import strip_of
from freecad.elastica_wb.host.progress import progress
from freecad.elastica_wb.host.resources import tr
from freecad.elastica_wb.host.user_units import shown_unit, worded
from freecad.elastica_wb.panels.panel import Panel
from freecad.elastica_wb.panels.widgets.bar_chart import bar_chart

from elastica_cad.errors import ElasticaError
from elastica_cad.mechanics.studies.tolerance_study import ToleranceStudy, tolerance_study


class TolerancePanel(Panel):
    """Runs on request; a progress bar can stop it, what is found until then is shown."""

    file = "tolerance"
    icon_name = "Elastica_Tolerance"
    only_tells = True

    def __init__(self, obj: Any) -> None:
        self.strip = strip_of(obj)
        super().__init__()
        self.study: ToleranceStudy | None = None
        self.form.run.clicked.connect(self.run)
        self.tell(tr("Ranges are those of the sheet."))

    def run(self, *_: Any) -> None:
        """Bend them all."""
        try:
            self.study = tolerance_study(
                self.strip.rod,
                sheet=self.strip.sheet,
                max_width=self.strip.width.extremes[1],
                samples=self.value("samples"),
                executor=Watched("Bending varied strips"),
            )
        except Stopped:
            self.tell(tr("Stopped."))
            return
        except ElasticaError as error:
            self.tell(str(error))
            return
        effects, unit = (*self.study.effects, self.study.combined), shown_unit()
        rows = "".join(
            f"<tr><td>{tr(e.name)}&nbsp;&nbsp;</td><td align=right>{e.percentile_95 / unit.size:.3f}"
            f"&nbsp;&nbsp;</td><td align=right>{e.worst / unit.size:.3f}</td></tr>"
            for e in effects
        )
        head = (
            f"<tr><td>{tr('deviation')}, {unit.name}</td><td>95 %&nbsp;&nbsp;</td><td>{tr('worst')}</td></tr>"
        )
        self.form.table.setText(worded(f"<table>{head}{rows}</table>"))
        self.form.plot.setPixmap(bar_chart([(tr(e.name), e.percentile_95, e.worst) for e in effects]))
        self.tell("")


class Stopped(Exception):  # noqa: N818 - no error: the user said so
    """The user pressed Cancel."""


class Watched:
    """An executor that works here and now, and shows after every task how far it is."""

    def __init__(self, title: str) -> None:
        self._title = title

    def map(self, work: Callable[..., Any], *arguments: Iterable[Any]) -> Iterator[Any]:
        """The answers one by one.

        Raises
        ------
        Stopped
            Cancel was pressed.
        """
        tasks = list(zip(*arguments, strict=True))
        with progress(self._title, len(tasks)) as step:
            for done, task in enumerate(tasks):
                if not step(done):
                    raise Stopped
                yield work(*task)
