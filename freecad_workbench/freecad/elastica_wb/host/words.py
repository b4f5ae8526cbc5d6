# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Wording of messages in the language of the user, with the property names, unit of length and decimal point of
FreeCAD. Equal messages on several objects are joined.

A message is a record with an English template and values. A catalogue has translations of templates.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import partial
from numbers import Real
from typing import Any

import FreeCAD as App
from freecad.elastica_wb.host.resources import translate

from elastica_cad import errors
from elastica_cad._text import printable
from elastica_cad.errors import MaterialWidth, Refusal, Worded
from elastica_cad.translations import Translated

NAMES = {
    "section": "Law", "style.width": "OuterWidth", "style.corner_radius": "HoleRadius", "style.sides": "HoleSides",
    "seam_position": "Joint", "ignore_limits": "Anyway", "label": "EngravedText", "nest.sheet_size": "SheetWidth",
    "supports.start": "StartSupport", "supports.end": "EndSupport",
    "limits": "Follow", "limits.keep_out": "KeepOut", "limits.stiffness_bounds": "StiffnessBounds",
}  # fmt: skip
"""Names of properties that are not derived from keys, because users' files contain them."""


def name_of(path: str) -> str:
    """Return the name of the property for a key, such as MaxWidth, RatioLimit or KeepLength."""
    if path in NAMES:
        return NAMES[path]
    table, _, key = path.rpartition(".")
    name = key.title().replace("_", "")
    if table == "limits":
        return f"{name}Limit"
    return f"Keep{name}" if table == "keep" else name


# typical width of a strip, mm; messages use the unit in which FreeCAD displays this length
USUAL_MM = 10.0


@dataclass(frozen=True)
class Unit:
    """A unit of length: its name and its size in mm."""

    name: str
    size: float


def shown_unit() -> Unit:
    """Return the unit in which FreeCAD displays lengths."""
    _, size, name = App.Units.Quantity(USUAL_MM, App.Units.Length).getUserPreferred()
    return Unit({'"': "in", "'": "ft"}.get(name, name), size)


class Words(Translated):
    """Formatter of messages in the language and unit of the user."""

    def __init__(self, language: str, unit: Unit, point: str) -> None:
        super().__init__(language)
        self.unit, self.size, self.point = unit.name, unit.size, point

    def field(self, name: str) -> str:
        """Return the name of the property of a field, or of the command that draws the curve of a nearest rod."""
        if name == "rod.curve":
            return translate("Elastica_Nearest", "Nearest curve to sketch")
        return name_of(name)

    def format_field(self, value: Any, spec: str) -> str:
        """Return the text of a value in a message.

        A value of the class `MaterialWidth` is shown as the property MaterialWidth, which limits the width of
        ligaments or a backing. In design files, this limit is the field `max_width`.
        """
        return "MaterialWidth" if isinstance(value, MaterialWidth) else super().format_field(value, spec)


def user_language() -> str:
    """Return the name of the user's catalogue, which can change while FreeCAD runs."""
    return translate("Elastica", "en")


def worded(text: str, unit: Unit | None = None) -> str:
    """Return a message in the language of the user. Other texts, such as names, are unchanged."""
    words = Words(user_language(), unit or shown_unit(), decimal_point())
    return printable(words.sentence(text)) if text else ""


def capital(sentence: str) -> str:
    """Return the sentence with an initial capital, unless it begins with the name of an object and a colon."""
    first = sentence.partition(" ")[0]
    return sentence if first.endswith(":") else sentence[:1].upper() + sentence[1:]


def together(sentences: Iterable[tuple[str, str]]) -> list[str]:
    """Combine equal sentences on several objects to one sentence that begins with their names."""
    names: dict[str, list[str]] = {}
    for name, sentence in sentences:
        names.setdefault(sentence, []).append(name)
    return [
        Refusal(
            "note", "{sentence}", {"sentence": sentence}, {"strip": ", ".join(dict.fromkeys(of_sentence))}
        )
        for sentence, of_sentence in names.items()
        if sentence
    ]


TYPES = {
    name: kind for name, kind in vars(errors).items() if isinstance(kind, type) and issubclass(kind, Worded)
}
"""Types of values that messages format in a special way, by name."""


def packed(value: Any) -> Any:
    """Convert a message or one of its values to data for JSON."""
    if isinstance(value, Refusal):
        inside, where = ({k: packed(v) for k, v in part.items()} for part in (value.values, value.where))
        return {"text": value.text, "values": inside, "where": where}
    if isinstance(value, (tuple, list)):
        plain: Any = [packed(item) for item in value]
    else:
        plain = value if value is None or isinstance(value, (bool, int)) else _plain(value)
    kind = type(value).__name__
    return {kind: plain} if kind in TYPES else plain


def _plain(value: Any) -> float | str:
    return float(value) if isinstance(value, Real) else str(value)


def unpacked(data: Any) -> Any:
    """Convert data of `packed` back to the message or value."""
    if isinstance(data, list):
        return [unpacked(item) for item in data]
    if not isinstance(data, dict):
        return data
    if "text" in data:
        inside, where = ({k: unpacked(v) for k, v in data[part].items()} for part in ("values", "where"))
        return Refusal("note", data["text"], inside, where)
    ((kind, value),) = data.items()
    return TYPES[kind](unpacked(value))


def decimal_point() -> str:
    """Return the decimal separator that FreeCAD's input fields use."""
    if not App.GuiUp:
        return "."
    from freecad.elastica_wb.host.qt import QtCore

    return str(QtCore.QLocale().decimalPoint())


before_report: list[Callable[[], None]] = []
"""Functions that are called before each report."""


def report(sentence: str, who: str = "", printed: Callable[[str], None] = App.Console.PrintMessage) -> None:
    """Report an action in the report view and the terminal. `who` is the label of its object."""
    for prepare in before_report:
        prepare()
    printed(f"Elastica, {who}: {worded(sentence)}\n" if who else f"Elastica: {worded(sentence)}\n")


report_warning = partial(report, printed=App.Console.PrintWarning)
"""Function that shows a warning in the report view. Its arguments are those of `report`."""

report_error = partial(report, printed=App.Console.PrintError)
"""Function that shows an error in the report view. Its arguments are those of `report`."""
