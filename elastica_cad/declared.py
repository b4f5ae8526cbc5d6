"""Declaration of options on the fields of records, with the sentence that help and forms show. All front ends use
these declarations.

A field, or a parameter of a function, is declared by an annotation:
`ratio: Annotated[float | None, Option("Largest stiffness ratio.", least=1, common=True)] = None`.
"""

import inspect
import re
from collections.abc import Callable, Mapping, Sequence, Sized
from dataclasses import MISSING, dataclass, fields, is_dataclass, replace
from functools import cache
from pkgutil import resolve_name
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, TypeAlias, Union, cast, get_args, get_origin, get_type_hints

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._values import is_number, is_one_of, is_series, is_whole
from elastica_cad.errors import FieldName, InputError, note, quoted, sentences

Record: TypeAlias = Callable[..., Any]
"""A dataclass with declared fields, or a function with declared parameters."""

REQUIRED = MISSING


MOST_ELEMENTS = 10_000
"""Default limit for the number of elements of a list, ten times the longest list of the examples."""

TWO_TURNS_RAD = float(4 * np.pi)
"""Largest absolute value of an angle in files. A larger number is probably in degrees."""

LONGEST_TEXT = 1_000
"""Largest number of characters of a text without a declared limit. Paths of files are shorter."""


@dataclass(frozen=True)
class Option:
    """Declaration of an option: help, unit and bounds of a field.

    Attributes
    ----------
    help : str
        Help for the option, a sentence in English.
    unit : str
        "mm", "1/mm", "rad", "g" and so on, or "" for no unit.
    least, most : float or None
        Inclusive bounds of a number. For a text, `most` is the largest number of characters.
    above : float or None
        Exclusive lower bound.
    many : int
        Largest number of elements of a list.
    group : str
        Heading of the option's group in front ends.
    common : bool
        True if the field has its own command-line option and input field. Other fields are set by `--set` or
        in the property editor.
    written : type or str, optional
        Type of the value in files and options, if the field accepts more. "module:name" names a record that
        is imported on use.
    needs : str or callable
        Field without which this field has no effect, or "". Or a function of the keys in the table that returns the
        missing setting, such as "curves = arc", or "".
    replaces : tuple of str
        Fields that have no effect beside this field.
    """

    help: str
    unit: str = ""
    least: float | None = None
    most: float | None = None
    above: float | None = None
    many: int = MOST_ELEMENTS
    group: str = ""
    common: bool = False
    written: Any = None
    needs: str | Callable[[Mapping[str, Any]], str] = ""
    replaces: tuple[str, ...] = ()

    @property
    def bounds(self) -> str:
        """The bounds in words, or "" if there are none."""
        templates = {
            "from {bound:g}": self.least,
            "above {bound:g}": self.above,
            "up to {bound:g}": self.most,
        }
        return sentences(
            (note(text, bound=bound) for text, bound in templates.items() if bound is not None), " "
        )

    def holds(self, value: float) -> bool:
        """Return True if a number is within the bounds."""
        return (
            (self.least is None or value >= self.least)
            and (self.above is None or value > self.above)
            and (self.most is None or value <= self.most)
        )


@dataclass(frozen=True)
class Kind:
    """Kind of a value.

    Attributes
    ----------
    name : str
        One of "number", "count", "flag", "text", "choice", "names" (any names, each with a value), "list",
        "table", "either".
    of : tuple of Kind
        Kinds of the elements of a "list", kind of the values of "names", or alternatives of "either".
    size : int or None
        Size of a list, or None for any size.
    choices : tuple of str
        Permitted values of a "choice".
    source : callable, str or None
        Class or function that makes a record from a table, or its "module:name".
    """

    name: Literal["number", "count", "flag", "text", "choice", "names", "list", "table", "either"]
    of: tuple["Kind", ...] = ()
    size: int | None = None
    choices: tuple[str, ...] = ()
    source: Record | str | None = None

    @cached_property
    def record(self) -> Record | None:
        """Class or function that makes a record from a table of this kind."""
        return resolve_name(self.source) if isinstance(self.source, str) else self.source

    @property
    def alternatives(self) -> tuple["Kind", ...]:
        """The alternatives of "either", or a tuple of this kind alone."""
        return self.of if self.name == "either" else (self,)


@dataclass(frozen=True)
class Field:
    """A declared field."""

    name: str
    kind: Kind
    option: Option
    default: Any = REQUIRED

    @property
    def help(self) -> str:
        """Help for the field, a sentence in English."""
        return self.option.help


_PLAIN = {
    bool: Kind("flag"), int: Kind("count"), float: Kind("number"), str: Kind("text"),
}  # fmt: skip


@cache
def declared(record: Record) -> tuple[Field, ...]:
    """Return the declared fields of a dataclass or parameters of a function, in order.

    Examples
    --------
    >>> def hang(at: Annotated[float, Option("Place along the strip.", "mm")], mass: float = 1.0): ...
    >>> [(field.name, field.kind.name, field.option.unit) for field in declared(hang)]
    [('at', 'number', 'mm')]
    """
    hints = get_type_hints(record, include_extras=True)
    entries = []
    for name, default in _defaults(record):
        hint = hints.get(name)
        option = next((mark for mark in getattr(hint, "__metadata__", ()) if isinstance(mark, Option)), None)
        if option is not None:
            written = get_args(hint)[0] if option.written is None else option.written
            entries.append(Field(name, kind_of(written), option, default))
    return tuple(entries)


def require_declared(record: Record, values: Mapping[str, Any], whose: str = "") -> None:
    """Raise InputError for values of declared fields that have a wrong kind or are out of bounds.

    Names of other fields are ignored. None is accepted if it is the default.

    Examples
    --------
    >>> def hang(at: Annotated[float, Option("Place along the strip.", "mm", least=0)]): ...
    >>> require_declared(hang, {"at": -3}, "mass")
    Traceback (most recent call last):
    elastica_cad.errors.InputError: mass at is -3: give a number from 0, in mm
    """
    for entry in declared(record):
        value = values.get(entry.name, entry.default)
        if (
            entry.option.written is None
            and value is not entry.default
            and not _fits(value, entry.kind, entry.option)
        ):
            raise _refusal(
                entry,
                value,
                f"{whose} {entry.name}" if whose else FieldName(entry.name),
                where=None if whose else {"field": entry.name},
            )


def require_bounds(entry: Field, value: Any, place: str) -> None:
    """Raise InputError if a number, or the length of a text or list, is out of the bounds of its field."""
    for kind in entry.kind.alternatives:
        numbers = [value] if kind.name in ("number", "count") else []
        if kind.name == "list" and kind.of[0].name == "number" and isinstance(value, tuple):
            numbers = list(value)
        outside = any(is_number(number) and not entry.option.holds(number) for number in numbers)
        misfit = (kind.name == "text" and isinstance(value, str)) or (
            kind.name == "list" and kind.size is None
        )
        if outside or (misfit and not _fits(value, kind, entry.option)):
            raise _refusal(replace(entry, kind=kind), value, place)


def _refusal(entry: Field, value: Any, place: str, **where: Any) -> InputError:
    return InputError(
        "{field} is {given}: give {wanted}",
        field=place, given=value if isinstance(value, float) else quoted(value),
        wanted=_valid_values(entry.kind, entry.option), **where,
    )  # fmt: skip


def _fits(value: Any, kind: Kind, option: Option) -> bool:
    """Return True if a value has the kind and is within the bounds of the option.

    Values of the kinds "names" and "either" are not checked. Of a list without a given size, only the length is
    checked, because the reader of the field checks its items.
    """
    match kind.name:
        case "number" | "count":
            return (is_number if kind.name == "number" else is_whole)(value) and option.holds(value)
        case "flag":
            return isinstance(value, bool | np.bool_)
        case "text":
            return isinstance(value, str) and len(value) <= (option.most or LONGEST_TEXT)
        case "choice":
            return is_one_of(value, kind.choices)
        case "list" if kind.size is not None:
            several = tuple(value) if is_series(value) else ()
            return len(several) == kind.size and all(_fits(item, kind.of[0], option) for item in several)
        case "list":
            return not (is_series(value) and isinstance(value, Sized)) or len(value) <= option.many
        case "table":
            return not is_dataclass(kind.record) or isinstance(value, cast(type, kind.record))
        case _:
            return True


def _valid_values(kind: Kind, option: Option) -> str:
    """Return in words which values an option accepts, for messages."""
    if kind.name == "choice":
        return note("one of {choices}", choices=", ".join(kind.choices))
    if kind.name == "table":
        return note("a {record}", record=getattr(kind.record, "__name__", ""))
    if kind.name == "text":
        return note("a text of at most {most} characters", most=option.most or LONGEST_TEXT)
    words = {"number": "a number", "count": "a whole number", "flag": "True or False"}
    several = "a list of at most {most} elements" if kind.size is None else "{size} numbers"
    known = note(words.get(kind.name, several), most=option.many, size=kind.size)
    text = sentences((known, option.bounds), " ")
    return sentences((text, option.unit and note("in {unit}", unit=option.unit)), ", ")


def _defaults(record: Record) -> list[tuple[str, Any]]:
    if is_dataclass(record):
        return [
            (field.name, field.default if field.default_factory is MISSING else field.default_factory())
            for field in fields(record)
            if field.init
        ]
    parameters = inspect.signature(record).parameters.values()
    return [
        (parameter.name, REQUIRED if parameter.default is parameter.empty else parameter.default)
        for parameter in parameters
    ]


def kind_of(hint: Any) -> Kind:
    """Return the kind of value for a type annotation.

    None as an alternative is ignored, because it stands for a missing value.

    Examples
    --------
    >>> kind_of(tuple[float, float] | None).size, kind_of(Literal["a", "b"]).choices
    (2, ('a', 'b'))
    """
    if isinstance(hint, type(Annotated[int, 0])):
        hint = get_args(hint)[0]
    origin, inner = get_origin(hint), get_args(hint)
    if origin in (Union, UnionType):
        kinds = tuple(dict.fromkeys(kind_of(part) for part in inner if part is not NoneType))
        return kinds[0] if len(kinds) == 1 else Kind("either", kinds)
    if origin is Literal:
        return Kind("choice", choices=inner)
    if origin in (tuple, list, Sequence):
        several = origin is not tuple or inner[-1] is ...
        return Kind("list", (kind_of(inner[0]),), None if several else len(inner))
    if origin is dict:
        return Kind("names", (kind_of(inner[1]),))
    plain = _PLAIN.get(hint)
    if plain is None and not (callable(hint) or isinstance(hint, str)):
        raise TypeError(f"{hint!r} cannot be read from files: set the type in files with Option(written=...)")
    return plain or Kind("table", source=hint)


def name_of(record: Record) -> str:
    """Return the title of a record's table in the manual: its class name in words, without a final "keys" or
    "table".

    Examples
    --------
    >>> class HalfPlane: ...
    >>> name_of(HalfPlane)
    'half plane'
    """
    words = re.sub(r"(?<=[a-z])(?=[A-Z])|_", " ", record.__name__)
    return re.sub(r" (keys|table)$", "", words.strip().lower())
