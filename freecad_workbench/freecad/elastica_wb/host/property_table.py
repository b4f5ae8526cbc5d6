# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Declarations of the properties of features, which files of earlier versions also get."""

import json
from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

import FreeCAD as App
from freecad.elastica_wb.host.words import capital, packed, unpacked, worded

from elastica_cad.declared import Field
from elastica_cad.design.records import written
from elastica_cad.errors import FieldName, InputError

# FreeCAD's flags for properties that cause no recompute, and for properties that are not saved
OUTPUT, TRANSIENT = 8, 2


@dataclass(frozen=True)
class Property:
    """A property of a feature.

    `default` is a value or the list of choices. `example` is appended to the help. `of` returns the value of a
    result from what a feature made.
    """

    kind: str
    name: str
    group: str
    help: str
    default: Any = None
    result: bool = False
    hidden: bool = False
    transient: bool = False
    example: str = ""
    of: Callable[[Any], object] | None = None

    @property
    def type_id(self) -> str:
        """FreeCAD's name of the type of the property."""
        return f"App::Property{self.kind}"

    @property
    def translated_help(self) -> str:
        """Help for the property in the language of the user."""
        text = worded(str(App.Qt.translate("App::Property", self.help)))
        return f"{text} {self.example}" if self.example else text


def result(kind: str, name: str, help: str, **fields: Any) -> Property:
    """Return the property of a result. `fields` are further fields of `Property`."""
    return Property(kind, name, "Result", help, result=True, **fields)


KINDS = {"number": "Float", "count": "Integer", "flag": "Bool", "text": "String", "choice": "Enumeration"}
UNITS = {"mm": "Length", "rad": "Angle"}
NOTHING = "none"
"""Choice that means that an optional field is not set."""


def declared_property(
    field: Field, group: str, name: str = "", *, given: Any = None, example: str = ""
) -> Property:
    """Return the property of a declared field. `name` and `given` replace the field's name and default."""
    kind, name, default = written(field.kind), name or field.name.title().replace("_", ""), field.default
    called = KINDS.get(kind.name) or ("StringList" if kind.name == "list" else "String")
    if kind.name == "number":
        called = UNITS.get(field.option.unit, called)
    if kind.name == "list" and kind.of[0].name == "number":
        called = "FloatList"
    if kind.name == "choice":
        usual = NOTHING if default is None else default
        return Property(called, name, group, field.help, list(dict.fromkeys([usual, *kind.choices])))
    usual = default if isinstance(default, (bool, int, float, str)) else None
    return Property(called, name, group, field.help, usual if given is None else given, example=example)


def values_of(obj: Any, fields: Mapping[str, Field]) -> dict[str, Any]:
    """Return the values of properties by the names of their declared fields."""
    return {
        field.name: getattr(value, "Value", value)
        for field, value in ((field, getattr(obj, name)) for name, field in fields.items())
    }


def ensure(obj: Any, table: Iterable[Property]) -> None:
    """Add missing properties, replace properties of another type, and set their display in the property editor."""
    for entry in table:
        value = None
        if entry.name in obj.PropertiesList and obj.getTypeIdOfProperty(entry.name) != entry.type_id:
            value = getattr(obj, entry.name)
            obj.removeProperty(entry.name)
        if entry.name not in obj.PropertiesList:
            flags = (OUTPUT if entry.result else 0) | (TRANSIENT if entry.transient else 0)
            obj.addProperty(entry.type_id, entry.name, entry.group, entry.translated_help, flags)
            if entry.default is not None:
                setattr(obj, entry.name, entry.default)
            if value is not None:
                with suppress(TypeError, ValueError):
                    setattr(obj, entry.name, value)
        obj.setEditorMode(entry.name, (1 if entry.result else 0) | (2 if entry.hidden else 0))


def require_choices(obj: Any, table: Iterable[Property]) -> None:
    """Raise InputError if a formula gives a value that is not one of the choices of its property.

    FreeCAD would set the first choice.
    """
    formulas = _formulas(obj)
    for name in [entry.name for entry in table if entry.kind == "Enumeration"]:
        if name not in formulas:
            continue
        formula, choices = formulas[name], obj.getEnumerationsOfProperty(name)
        try:
            value = obj.evalExpression(formula)
        except Exception as error:  # FreeCAD raises errors of many classes
            raise InputError(
                "FreeCAD cannot compute the formula of {box} ({reason}). Correct or remove the formula.",
                box=FieldName(name),
                reason=formula,
            ) from error
        if not _is_choice(value, choices):
            raise InputError(
                "{property} has the formula {formula}, which gives {given}. Use 0 to {most}, or a name such as "
                "{name}. Correct or remove the formula.",
                property=f"{obj.Name}.{name}",
                formula=formula,
                given=value,
                most=len(choices) - 1,
                name=f"<<{choices[0]}>>",
            )


def _formulas(obj: Any) -> dict[str, str]:
    return {name: formula for name, formula, *_ in obj.ExpressionEngine}


def _is_choice(value: Any, choices: list[str]) -> bool:
    if isinstance(value, str):
        return value in choices
    # FreeCAD uses the integer part of a number as the index of a choice
    return isinstance(value, (int, float)) and -1 < value < len(choices)


def is_misread(obj: Any, name: str) -> bool:
    """Return True if a formula gives an invalid choice.

    FreeCAD then leaves the property empty, or sets the first choice for an unknown name.
    """
    present, formula = getattr(obj, name), _formulas(obj).get(name)
    if present is None or formula is None:
        return present is None
    choices = obj.getEnumerationsOfProperty(name)
    if present != choices[0]:
        return False
    with suppress(Exception):
        return not _is_choice(obj.evalExpression(formula), choices)
    return False


def choose_again(obj: Any, name: str, chosen: str | None) -> None:
    """Restore the choice `chosen`, or set the first choice if `chosen` is not available.

    After an index out of range, FreeCAD 1.0 and 1.1 accept an index only together with the list of choices.
    """
    choices = obj.getEnumerationsOfProperty(name)
    if choices:
        setattr(obj, name, (choices, choices.index(chosen) if chosen in choices else 0))


MESSAGES = ("Verdict", "Reasons", "Reports", "Overlaps", "LeftOut", "Held", "Sideways")
"""Properties with messages in the language of the user. `RECORDS` stores these messages for other
languages."""

RECORDS = result("String", "Messages", "Messages in all languages", hidden=True)


def put(obj: Any, **values: Any) -> None:
    """Set the properties whose values differ. Unchanged results are not added to the undo history.

    Messages are also stored as records, because a user with another language may open the file.
    """
    messages = {name: value for name, value in values.items() if name in MESSAGES}
    if messages:
        records = _records(obj) | {name: packed(value) for name, value in messages.items()}
        values |= {name: _worded(name, value) for name, value in messages.items()}
        values[RECORDS.name] = json.dumps(records)
    _put(obj, values)


def reword(obj: Any) -> None:
    """Set the stored messages of an object in the language of the user."""
    # the file may have been edited by hand
    with suppress(LookupError, TypeError, ValueError):
        _put(obj, {name: _worded(name, unpacked(data)) for name, data in _records(obj).items()})


def _records(obj: Any) -> dict[str, Any]:
    with suppress(ValueError):
        records = json.loads(obj.Messages or "{}")
        return {name: data for name, data in records.items() if name in MESSAGES}
    return {}


def _worded(name: str, message: str | list[str]) -> str | list[str]:
    if isinstance(message, str):
        return worded(message)
    words = map(worded, message)
    return [capital(sentence) for sentence in words] if name == "Reasons" else list(words)


def _put(obj: Any, values: Mapping[str, Any]) -> None:
    for name, value in values.items():
        present = getattr(obj, name)
        if getattr(present, "Value", present) != value:
            setattr(obj, name, value)
