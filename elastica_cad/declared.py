"""What can be asked for: a field is declared once, on its record, and every front end reads it here.

A field, or a parameter of a function, is declared by its annotation:
`ratio: Annotated[float | None, Asked("Largest stiffness ratio.", least=1, common=True)] = None`.
"""

import inspect
import re
from collections.abc import Callable, Sequence
from dataclasses import MISSING, dataclass, fields, is_dataclass
from functools import cache
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, TypeAlias, Union, get_args, get_origin, get_type_hints

Record: TypeAlias = Callable[..., Any]
"""A dataclass, or a function whose parameters are declared in the same way."""

REQUIRED = MISSING
"""Default of a field that must be given."""


@dataclass(frozen=True)
class Asked:
    """What people are told of a field, where it is declared.

    Attributes
    ----------
    help : str
        One English sentence.
    unit : str
        "mm", "1/mm", "rad", "g" and so on; empty for what has none.
    least, most : float or None
        Bounds that input fields show; the record checks them itself.
    group : str
        Heading below which front ends list it.
    common : bool
        It has an option and a field of its own; the others are set by name (`--set`, the property editor).
    written : type, optional
        Of the value in files and options, where the field takes more than can be written there.
    """

    help: str
    unit: str = ""
    least: float | None = None
    most: float | None = None
    group: str = ""
    common: bool = False
    written: Any = None


@dataclass(frozen=True)
class Kind:
    """What a value is made of.

    Attributes
    ----------
    name : str
        "number", "count", "flag", "text", "choice", "names" (any names, each with a value), "list", "table" or
        "either".
    of : tuple of Kind
        Elements of a list, values of names (one kind), or the alternatives of "either".
    size : int or None
        Of a list; None for any.
    choices : tuple of str
        Of a choice.
    record : callable or None
        What a table makes.
    """

    name: Literal["number", "count", "flag", "text", "choice", "names", "list", "table", "either"]
    of: tuple["Kind", ...] = ()
    size: int | None = None
    choices: tuple[str, ...] = ()
    record: Record | None = None

    @property
    def alternatives(self) -> tuple["Kind", ...]:
        """Itself, or what it may be."""
        return self.of if self.name == "either" else (self,)


@dataclass(frozen=True)
class Field:
    """One declared field."""

    name: str
    kind: Kind
    asked: Asked
    default: Any = REQUIRED

    @property
    def help(self) -> str:
        """One English sentence."""
        return self.asked.help


_PLAIN = {
    bool: Kind("flag"), int: Kind("count"), float: Kind("number"), str: Kind("text"),
}  # fmt: skip


@cache
def declared(record: Record) -> tuple[Field, ...]:
    """The declared fields of a dataclass or parameters of a function, in order.

    Examples
    --------
    >>> def hang(at: Annotated[float, Asked("Place along the strip.", "mm")], mass: float = 1.0): ...
    >>> [(one.name, one.kind.name, one.asked.unit) for one in declared(hang)]
    [('at', 'number', 'mm')]
    """
    hints = get_type_hints(record, include_extras=True)
    found = []
    for name, default in _defaults(record):
        hint = hints.get(name)
        asked = next((one for one in getattr(hint, "__metadata__", ()) if isinstance(one, Asked)), None)
        if asked is not None:
            written = get_args(hint)[0] if asked.written is None else asked.written
            found.append(Field(name, kind_of(written), asked, default))
    return tuple(found)


def _defaults(record: Record) -> list[tuple[str, Any]]:
    """Names in order, with their defaults."""
    if is_dataclass(record):
        return [
            (one.name, one.default if one.default_factory is MISSING else one.default_factory())
            for one in fields(record)
            if one.init
        ]
    parameters = inspect.signature(record).parameters.values()
    return [(one.name, REQUIRED if one.default is one.empty else one.default) for one in parameters]


def kind_of(hint: Any) -> Kind:
    """The kind of values of a type; None among the alternatives is what is not given.

    Examples
    --------
    >>> kind_of(tuple[float, float] | None).size, kind_of(Literal["a", "b"]).choices
    (2, ('a', 'b'))
    """
    if isinstance(hint, type(Annotated[int, 0])):
        hint = get_args(hint)[0]
    origin, inner = get_origin(hint), get_args(hint)
    if origin in (Union, UnionType):
        kinds = tuple(dict.fromkeys(kind_of(one) for one in inner if one is not NoneType))
        return kinds[0] if len(kinds) == 1 else Kind("either", kinds)
    if origin is Literal:
        return Kind("choice", choices=inner)
    if origin in (tuple, list, Sequence):
        several = origin is not tuple or inner[-1] is ...
        return Kind("list", (kind_of(inner[0]),), None if several else len(inner))
    if origin is dict:
        return Kind("names", (kind_of(inner[1]),))
    plain = _PLAIN.get(hint)
    if plain is None and not callable(hint):
        raise TypeError(f"{hint!r} cannot be declared: say what stands in files with Asked(written=...)")
    return plain or Kind("table", record=hint)


def name_of(record: Record) -> str:
    """How pages call the table that makes a record: its name in words, without "keys" or "table" at its end.

    Examples
    --------
    >>> class HalfPlane: ...
    >>> name_of(HalfPlane)
    'half plane'
    """
    words = re.sub(r"(?<=[a-z])(?=[A-Z])|_", " ", record.__name__)
    return re.sub(r" (keys|table)$", "", words.strip().lower())
