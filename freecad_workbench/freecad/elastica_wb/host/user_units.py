# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Sentences as the user reads them: in his language, unit and decimal point. Everything is worded in mm before."""

import re
from dataclasses import dataclass

import FreeCAD as App
from freecad.elastica_wb.host.sentences import decimal_point, translated

USUAL_MM = 10.0  # mm: a strip's width tells which of its units FreeCAD would use for all

NUMBER = r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?"
BETWEEN = r"(?:, |; |、|,? (?:and|und|和|to|bis|至|到|or|oder|或|x|by|mal|与|\+-) )"
LIST = rf"\(?{NUMBER}\)?(?:{BETWEEN}\(?{NUMBER}\)?)*"
# 1/mm, mm2 and N/mm2 are no lengths; 0.8mm in the name of a file is not followed by one either
LENGTHS = re.compile(rf"(?<![\w./])({LIST})( |&nbsp;)mm(?![\w²/^*])")
DECIMAL = re.compile(r"(?<![\w./-])(-?\d+)\.(\d+)(?![\w/]|\.\w)")
TYPED = re.compile(r"(\[[^\]]*\]|= -?\d+(?:\.\d+)?)")
"""What a property is written in, with points whatever the language: [0, 0.01], smooth = 0.1."""


@dataclass(frozen=True)
class Unit:
    """What lengths are shown in: its name, and how many mm it has."""

    name: str
    size: float


def shown_unit() -> Unit:
    """What FreeCAD shows lengths in."""
    _, size, name = App.Units.Quantity(USUAL_MM, App.Units.Length).getUserPreferred()
    return Unit({'"': "in", "'": "ft"}.get(name, name), size)


def worded(sentence: str, unit: Unit | None = None) -> str:
    """A sentence in the user's language, its lengths in his unit instead of mm, with his decimal point."""
    unit, sentence, point = unit or shown_unit(), translated(sentence), decimal_point()

    def convert(found: re.Match[str]) -> str:
        numbers = re.sub(NUMBER, lambda n: f"{float(n[0]) / unit.size:.4g}", found[1])
        return f"{numbers}{found[2]}{unit.name}"

    if unit.size != 1.0:
        sentence = LENGTHS.sub(convert, sentence)
    if point == ".":
        return sentence
    parts = TYPED.split(sentence)
    parts[::2] = [_with_point(part, point) for part in parts[::2]]
    return "".join(parts)


def _with_point(words: str, point: str) -> str:
    # a list of numbers is told apart by semicolons where commas stand in the numbers
    words = re.sub(r"(?<=\d), (?=-?\d+\.\d|-?\d+[,)])", "; ", words)
    return DECIMAL.sub(rf"\g<1>{point}\g<2>", words)
