# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The panel of a check: the full verdict in words, and the overlay on the curve."""

from typing import Any

from freecad.elastica_wb.curves.sketch_curves import drawn_curve, read_line
from freecad.elastica_wb.host.objects import is_sketch
from freecad.elastica_wb.host.refusal import FAILURES, explained
from freecad.elastica_wb.live import session as live
from freecad.elastica_wb.panels.panel import Panel
from freecad.elastica_wb.solving.strip_cache import default_spec, solve_strip
from freecad.elastica_wb.solving.verdicts import Verdict, strip_answer

from elastica_cad.errors import ElasticaError
from elastica_cad.refusals import sentences


class CheckPanel(Panel):
    """Changes nothing. Close removes the overlay."""

    file = "check"
    icon_name = "Elastica_Check"
    only_tells = True

    def __init__(self, source: Any, edges: tuple[str, ...]) -> None:
        super().__init__()
        self.check = None
        try:
            curve, read = drawn_curve((source, edges)).curve, read_line((source, edges))
            spec = default_spec(curve)
            self.check = spec.rod_spec.check
        except FAILURES as error:
            self.show_message(str(explained(error)))
            return
        words = [str(self.check), *filter(None, [spec.tabs_message]), *spec.rod_spec.smoothing.notes]
        if self.check.realizable:
            try:
                answer = strip_answer(solve_strip(spec))
                # the curve is in equilibrium, but the sheet would break
                words = [answer.sentence] if answer.verdict is Verdict.BREAKS else [*words, answer.sentence]
            except ElasticaError as error:
                words.append(str(error))
        self.show_message(sentences([read, *words], "\n\n"))
        if is_sketch(source) and not edges:
            live.start(source)
