"""The panel of a check: the whole answer in words, the overlay on the curve."""

from typing import Any

from freecad.elastica_wb import live, preferences
from freecad.elastica_wb.design import Wish, solved
from freecad.elastica_wb.drawn import drawn_curve, is_sketch
from freecad.elastica_wb.features.refusal import FAILURES, explained
from freecad.elastica_wb.library import sheet_called
from freecad.elastica_wb.panels.base import Panel
from freecad.elastica_wb.picture import sentence_of

from elastica_cad.errors import ElasticaError
from elastica_cad.mechanics import check_equilibrium

__all__ = ["CheckPanel"]


class CheckPanel(Panel):
    """Changes nothing; Close takes the overlay away."""

    file = "check"
    icon_name = "Elastica_Check"
    only_tells = True

    def __init__(self, source: Any, edges: tuple[str, ...]) -> None:
        super().__init__()
        self.check = None
        try:
            curve = drawn_curve((source, edges)).curve
            self.check = check_equilibrium(curve)
        except FAILURES as error:
            self.tell(str(explained(error)))
            return
        words = [str(self.check)]
        if self.check.realizable:
            wish = Wish(sheet_called(preferences.default_sheet()), max_width=preferences.get("MaxWidth"))
            try:
                words.append(sentence_of(solved(curve, wish)))
            except ElasticaError as error:
                words.append(str(error))
        self.tell("\n\n".join(words))
        if is_sketch(source) and not edges:
            live.start(source)
