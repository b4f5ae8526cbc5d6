# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Lengths as the user reads them. Everything is computed and worded in mm; what is shown passes through here."""

import re
from dataclasses import dataclass

import FreeCAD as App

USUAL_MM = 10.0  # mm: a strip's width tells which of its units FreeCAD would use for all

NUMBER = r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?"
LIST = rf"\(?{NUMBER}\)?(?:(?:, |; |,? and | to | or | x | by | \+- )\(?{NUMBER}\)?)*"
# 1/mm, mm2 and N/mm2 are no lengths; 0.8mm in the name of a file is not followed by one either
LENGTHS = re.compile(rf"(?<![\w./])({LIST})( |&nbsp;)mm(?![\w²/^*])")


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
    """A sentence with its lengths in the user's unit instead of mm."""
    unit = unit or shown_unit()
    if unit.size == 1.0:
        return sentence

    def convert(found: re.Match[str]) -> str:
        numbers = re.sub(NUMBER, lambda n: f"{float(n[0]) / unit.size:.4g}", found[1])
        return f"{numbers}{found[2]}{unit.name}"

    return LENGTHS.sub(convert, sentence)
