# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Wording of messages in the language of the user, with the property names, unit of length and decimal point of
FreeCAD. Equal messages on several objects are joined.

A message is a record with an English template and values. A catalogue has translations of templates.
"""

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import partial
from numbers import Real
from typing import Any

import FreeCAD as App
from freecad.elastica_wb.host.resources import QT_TRANSLATE_NOOP, translate

from elastica_cad import errors
from elastica_cad._text import printable
from elastica_cad.errors import MaterialWidth, Refusal, Worded
from elastica_cad.translations import Translated

NAMES = {
    "section": "Law", "style.width": "OuterWidth", "style.corner_radius": "HoleRadius", "style.sides": "HoleSides",
    "seam_position": "Joint", "ignore_limits": "Anyway", "label": "EngravedText",
    "nest.sheet_size": "SheetWidth", "nest.grain": "SheetWidth",
    "supports.start": "StartSupport", "supports.end": "EndSupport",
    "limits": "Follow", "limits.keep_out": "KeepOut", "limits.stiffness_bounds": "StiffnessBounds",
    "pad.length": "PadLength", **dict.fromkeys(("feet", "full", "second_state", "shop.lap"), ""),
}  # fmt: skip
"""Names of properties that are not derived from keys, because users' files contain them.

The name "" marks a key that only design files have.
"""


def name_of(path: str) -> str:
    """Return the name of the property for a key, such as MaxWidth, RatioLimit or KeepLength.

    The name of a property is returned unchanged.
    """
    if path in NAMES:
        return NAMES[path]
    table, _, key = path.rpartition(".")
    name = "".join(word[:1].upper() + word[1:] for word in key.split("_"))
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
        """Return the label of the box for a field, in quotes.

        A field without a box is named as in the property editor, or as in design files if it has no property.
        """
        called = name_of(name)
        label = LABELS.get(name) or LABELS.get(called)
        if label:
            return self.template('"{box}"').format(box=translate("Elastica", label))
        if not called:
            return self.template('key "{key}" of a design file').format(key=name)
        spaced = re.sub("(?<=[a-z])(?=[A-Z])", " ", called)  # as FreeCAD's property editor shows names
        return self.template('property "{name}"').format(name=translate("App::Property", spaced))

    def format_field(self, value: Any, spec: str) -> str:
        """Return the text of a value in a message.

        A value of the class `MaterialWidth` is shown as the property MaterialWidth, which limits the width of
        ligaments or a backing. In design files, this limit is the field `max_width`.
        """
        return (
            self.field("MaterialWidth")
            if isinstance(value, MaterialWidth)
            else super().format_field(value, spec)
        )


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
        is_plain = value is None or isinstance(value, (bool, int))
        plain = value if is_plain else float(value) if isinstance(value, Real) else str(value)
    kind = type(value).__name__
    return {kind: plain} if kind in TYPES else plain


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


LABELS = {
    "Anyway": QT_TRANSLATE_NOOP("Elastica", "Make it anyway"),
    "AsDrawn": QT_TRANSLATE_NOOP("Elastica", "Keep the curve as drawn"),
    "Axis": QT_TRANSLATE_NOOP("Elastica", "Axis"),
    "Backing": QT_TRANSLATE_NOOP("Elastica", "Backing"),
    "Border": QT_TRANSLATE_NOOP("Elastica", "Border"),
    "Clearance": QT_TRANSLATE_NOOP("Elastica", "Clearance"),
    "Closed": QT_TRANSLATE_NOOP("Elastica", "Closed lines"),
    "Columns": QT_TRANSLATE_NOOP("Elastica", "Columns of holes"),
    "Count": QT_TRANSLATE_NOOP("Elastica", "Number"),
    "Curve": QT_TRANSLATE_NOOP("Elastica", "Curve"),
    "Ends": QT_TRANSLATE_NOOP("Elastica", "Ends held"),
    "EndSupport": QT_TRANSLATE_NOOP("Elastica", "End is held"),
    "EndTab": QT_TRANSLATE_NOOP("Elastica", "Tab at the end"),
    "EngravedText": QT_TRANSLATE_NOOP("Elastica", "Engraved text"),
    "Family": QT_TRANSLATE_NOOP("Elastica", "Planes"),
    "Fillet": QT_TRANSLATE_NOOP("Elastica", "Radius at the pads"),
    "Fit": QT_TRANSLATE_NOOP("Elastica", "Width of slots"),
    "Follow": QT_TRANSLATE_NOOP("Elastica", "Follow the curve"),
    "Foot": QT_TRANSLATE_NOOP("Elastica", "Foot (0 = none)"),
    "FootHeight": QT_TRANSLATE_NOOP("Elastica", "Height of the foot"),
    "Form": QT_TRANSLATE_NOOP("Elastica", "Shape shown"),
    "Free": QT_TRANSLATE_NOOP("Elastica", "State without forces"),
    "Gap": QT_TRANSLATE_NOOP("Elastica", "Gap (0 = one ring)"),
    "Gravity": QT_TRANSLATE_NOOP("Elastica", "Own weight"),
    "Height": QT_TRANSLATE_NOOP("Elastica", "Height of its upper face"),
    "Hole": QT_TRANSLATE_NOOP("Elastica", "Hole"),
    "Interlock": QT_TRANSLATE_NOOP("Elastica", "Cut slots where strips cross"),
    "KeepEnds": QT_TRANSLATE_NOOP("Elastica", "Keep the ends"),
    "KeepLength": QT_TRANSLATE_NOOP("Elastica", "Keep the length"),
    "KeepSymmetry": QT_TRANSLATE_NOOP("Elastica", "Keep the symmetry"),
    "KeepTangents": QT_TRANSLATE_NOOP("Elastica", "Keep end tangents"),
    "Kerf": QT_TRANSLATE_NOOP("Elastica", "Kerf"),
    "Layer": QT_TRANSLATE_NOOP("Elastica", "Layer"),
    "LeastThickness": QT_TRANSLATE_NOOP("Elastica", "Thinnest place (0 = automatic)"),
    "LimitMargin": QT_TRANSLATE_NOOP("Elastica", "Must be stable"),
    "limits": QT_TRANSLATE_NOOP("Elastica", "Follow the curve: Nearest"),
    "LimitStrain": QT_TRANSLATE_NOOP("Elastica", "Must not break"),
    "Margin": QT_TRANSLATE_NOOP("Elastica", "Distance between parts"),
    "MarginLimit": QT_TRANSLATE_NOOP("Elastica", "Least stability margin"),
    "Match": QT_TRANSLATE_NOOP("Elastica", "Equal lengths: keep"),
    "MaxWidth": QT_TRANSLATE_NOOP("Elastica", "Largest width"),
    "MinWidth": QT_TRANSLATE_NOOP("Elastica", "Least width"),
    "Notch": QT_TRANSLATE_NOOP("Elastica", "Notches"),
    "Objective": QT_TRANSLATE_NOOP("Elastica", "Largest thickness or least ratio"),
    "OuterWidth": QT_TRANSLATE_NOOP("Elastica", "Outer width"),
    "Outline": QT_TRANSLATE_NOOP("Elastica", "Outline"),
    "PadHole": QT_TRANSLATE_NOOP("Elastica", "Holes in pads"),
    "PadInset": QT_TRANSLATE_NOOP("Elastica", "Holes from the ends of pads"),
    "PadLength": QT_TRANSLATE_NOOP("Elastica", "Length of pads"),
    "PadWidth": QT_TRANSLATE_NOOP("Elastica", "Width of pads"),
    "Play": QT_TRANSLATE_NOOP("Elastica", "Play beside tabs"),
    "Printed": QT_TRANSLATE_NOOP("Elastica", "Printed"),
    "PushAt": QT_TRANSLATE_NOOP("Elastica", "Pushed at (0 = middle)"),
    "Quantity": QT_TRANSLATE_NOOP("Elastica", "Quantity"),
    "RatioLimit": QT_TRANSLATE_NOOP("Elastica", "Largest stiffness ratio"),
    "Relief": QT_TRANSLATE_NOOP("Elastica", "Inner ends of slots"),
    "rod.curve": QT_TRANSLATE_NOOP("Elastica", "Nearest curve to sketch"),
    "Rows": QT_TRANSLATE_NOOP("Elastica", "Rows of holes (0 = automatic)"),
    "Screw": QT_TRANSLATE_NOOP("Elastica", "Screw holes (0 = none)"),
    "Sheet": QT_TRANSLATE_NOOP("Elastica", "Sheet"),
    "SheetHeight": QT_TRANSLATE_NOOP("Elastica", "Sheet height"),
    "SheetWidth": QT_TRANSLATE_NOOP("Elastica", "Sheet width"),
    "Smooth": QT_TRANSLATE_NOOP("Elastica", "Smooth the curve by"),
    "StartSupport": QT_TRANSLATE_NOOP("Elastica", "Start is held"),
    "StartTab": QT_TRANSLATE_NOOP("Elastica", "Tab at the start"),
    "StrainLimit": QT_TRANSLATE_NOOP("Elastica", "Largest strain, % (0 = sheet)"),
    "Style": QT_TRANSLATE_NOOP("Elastica", "Style"),
    "Sweep": QT_TRANSLATE_NOOP("Elastica", "Spread over"),
    "TabHole": QT_TRANSLATE_NOOP("Elastica", "Hole in tabs"),
    "TabRadius": QT_TRANSLATE_NOOP("Elastica", "Rounding of tabs"),
    "Thickness": QT_TRANSLATE_NOOP("Elastica", "Thickness"),
    "ThroughX": QT_TRANSLATE_NOOP("Elastica", "Axis at x"),
    "ThroughY": QT_TRANSLATE_NOOP("Elastica", "Axis at y"),
    "ThroughZ": QT_TRANSLATE_NOOP("Elastica", "Axis at z"),
    "Tolerance": QT_TRANSLATE_NOOP("Elastica", "Tolerance"),
    "Wall": QT_TRANSLATE_NOOP("Elastica", "Wall"),
    "Waves": QT_TRANSLATE_NOOP("Elastica", "Smooth waves below"),
}
"""Labels of boxes in panels, which messages also use, by the name of the property.

For "limits" and "rod.curve", which are keys of messages, the label is a choice and a command.
"""
