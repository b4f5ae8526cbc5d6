# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The panel of a check: the complete result in words, and the overlay on the curve."""

from collections.abc import Sequence
from typing import Any

from freecad.elastica_wb.curves.sketch_curves import drawn_curve, read_line
from freecad.elastica_wb.host.objects import is_sketch
from freecad.elastica_wb.host.refusal import FAILURES, explained
from freecad.elastica_wb.host.words import together, worded
from freecad.elastica_wb.live import session as live
from freecad.elastica_wb.panels.panel import Panel
from freecad.elastica_wb.solving.strip_cache import default_spec, solve_strip
from freecad.elastica_wb.solving.verdicts import Verdict, strip_answer

from elastica_cad.errors import ElasticaError, sentences


class CheckPanel(Panel):
    """Panel that does not change the document. Close removes the overlay."""

    file = "check"
    icon_name = "Elastica_Check"
    only_tells = True

    def __init__(self, curves: Sequence[tuple[Any, tuple[str, ...]]]) -> None:
        super().__init__()
        names = [" ".join([source.Label, *edges]) for source, edges in curves]
        verdicts = [worded(_verdict(curve)) for curve in curves]
        single = len(curves) == 1
        self.show_message(verdicts[0] if single else "\n\n".join(together(zip(names, verdicts, strict=True))))
        source, edges = curves[0]
        if single and is_sketch(source) and not edges:
            live.start(source, self.form.layout())


def _verdict(link: tuple[Any, tuple[str, ...]]) -> str:
    try:
        curve, read = drawn_curve(link).curve, read_line(link)
        spec = default_spec(curve)
        check = spec.rod_spec.check
    except FAILURES as error:
        return str(explained(error))
    words = [str(check), *filter(None, [spec.tabs_message]), *spec.rod_spec.smoothing.notes]
    if check.realizable:
        try:
            answer = strip_answer(solve_strip(spec))
            # the check of the equilibrium does not matter if the sheet would break
            words = [answer.sentence] if answer.verdict is Verdict.BREAKS else [*words, answer.sentence]
        except ElasticaError as error:
            words.append(str(error))
    return sentences([read, *words], "\n\n")
