# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Sentences as the user reads them: in his language, with FreeCAD's names of fields, his unit and decimal point.

The core and the workbench make records: an English template and its values. A catalogue holds the template of a
language for each of the English ones; what it does not hold is said in English.
"""

from collections.abc import Iterable
from dataclasses import dataclass

import FreeCAD as App
from freecad.elastica_wb.host.property_names import name_of
from freecad.elastica_wb.host.resources import translate

from elastica_cad._text import printable
from elastica_cad.words import Translated

USUAL_MM = 10.0  # mm: a strip's width tells which of its units FreeCAD would use for all


@dataclass(frozen=True)
class Unit:
    """A unit of length: its name, and how many mm it has."""

    name: str
    size: float


def shown_unit() -> Unit:
    """Return the unit in which FreeCAD shows lengths."""
    _, size, name = App.Units.Quantity(USUAL_MM, App.Units.Length).getUserPreferred()
    return Unit({'"': "in", "'": "ft"}.get(name, name), size)


class Words(Translated):
    """Words messages in the user's language and unit."""

    def __init__(self, language: str, unit: Unit, point: str) -> None:
        super().__init__(language)
        self.unit, self.size, self.point = unit.name, unit.size, point

    def field(self, name: str) -> str:
        """Return the property that holds a field."""
        return name_of(name)


def user_language() -> str:
    """The name of a catalogue; it can be changed while FreeCAD runs."""
    return translate("Elastica", "en")


def worded(said: str, unit: Unit | None = None) -> str:
    """A record as the user reads it; what was worded before, and names of the user's, stay."""
    words = Words(user_language(), unit or shown_unit(), decimal_point())
    return printable(words.sentence(said)) if said else ""


def capital(sentence: str) -> str:
    """Return the sentence with a capital letter, but for a user's name that a colon follows."""
    first = sentence.partition(" ")[0]
    return sentence if first.endswith(":") else sentence[:1].upper() + sentence[1:]


def together(named: Iterable[tuple[str, str]]) -> list[str]:
    """Return each sentence once, behind the names of all that it is about; without the empty ones."""
    names: dict[str, list[str]] = {}
    for name, said in named:
        names.setdefault(said, []).append(name)
    return [f"{', '.join(dict.fromkeys(names[said]))}: {said}" for said in names if said]


def decimal_point() -> str:
    """Return the sign between whole and decimal digits, as in FreeCAD's own input fields."""
    if not App.GuiUp:
        return "."
    from freecad.elastica_wb.host.qt import QtCore

    return str(QtCore.QLocale().decimalPoint())


def report(sentence: str, who: str = "") -> None:
    """Something that was done, in the report view and on the terminal that FreeCAD was started from."""
    App.Console.PrintMessage(_line(sentence, who))


def report_warning(sentence: str, who: str = "") -> None:
    """Show a warning in the report view; `who` is the label of its object."""
    App.Console.PrintWarning(_line(sentence, who))


def report_error(sentence: str, who: str = "") -> None:
    """Show an error in the report view; `who` is the label of its object."""
    App.Console.PrintError(_line(sentence, who))


def _line(sentence: str, who: str) -> str:
    return f"Elastica, {who}: {worded(sentence)}\n" if who else f"Elastica: {worded(sentence)}\n"
