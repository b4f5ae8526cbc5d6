"""Errors and messages of elastica_cad.

Every message states the problem, its position (mm), and an instruction. It is a record: an English template, values
with their units, the position of the problem, and suggested changes.
"""

import re
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, Set
from contextvars import ContextVar
from dataclasses import dataclass
from datetime import date, time
from decimal import Decimal
from functools import cache
from math import ceil, degrees, floor, isfinite, log10
from pathlib import Path
from reprlib import Repr
from string import Formatter
from typing import Any, Literal, ParamSpec, Self, TypeVar

from elastica_cad._text import printable

Severity = Literal["error", "warning", "note"]

PLACES = ("file", "strip")
"""Keys of `where` that a message shows before its text, in this order. Other keys are for programs."""


class Worded:
    """Base of values in messages that each front end formats in its language and units."""

    __slots__ = ()

    def __format__(self, spec: str) -> str:
        return ENGLISH.format_field(self, spec)


class Quantity(Worded, float):
    """Number with a unit, shown with three digits or in the format of the template.

    Examples
    --------
    >>> f"{Force(12.345)}, {Strain(0.00456):.2f}, {Mass(1234)}, {Angle(0.5):.1f}"
    '12.3 N, 0.46 %, 1.23 kg, 28.6 degrees'
    """

    UNIT = ""

    def __str__(self) -> str:
        return format(self)

    @property
    def shown(self) -> tuple[float, str]:
        """Number and unit that are shown."""
        return self, self.UNIT


class Length(Quantity):
    """Length in mm, shown with its unit and at least three digits or in the format of the template.

    Examples
    --------
    >>> "the ends are {} apart".format(Length(1234.56)), f"{Length(0.1234)}", f"{Length(8):.1f}"
    ('the ends are 1235 mm apart', '0.123 mm', '8.0 mm')
    """


class BareLength(Length):
    """Length in mm, shown without its unit because a later length of the message has the unit.

    Examples
    --------
    >>> "a part of {} by {}".format(BareLength(300), Length(20))
    'a part of 300 by 20 mm'
    """


class Force(Quantity):
    """Force in N."""

    UNIT = "N"


class Moment(Quantity):
    """Moment in N mm."""

    UNIT = "N mm"


class Energy(Quantity):
    """Energy in mJ, which is N mm."""

    UNIT = "mJ"


class Degrees(Quantity):
    """Angle in degrees."""

    UNIT = "degrees"


class Angle(Degrees):
    """Angle in rad, shown in degrees."""

    @property
    def shown(self) -> tuple[float, str]:
        """Number and unit that are shown."""
        return degrees(self), self.UNIT


class Mass(Quantity):
    """Mass in g, shown in kg from 1000 g on."""

    @property
    def shown(self) -> tuple[float, str]:
        """Number and unit that are shown."""
        return (self / 1000, "kg") if self >= 1000 else (self, "g")


class Share(Quantity):
    """Fraction of a whole, shown in percent."""

    @property
    def shown(self) -> tuple[float, str]:
        """Number and unit that are shown."""
        return 100 * self, "%"


class Strain(Share):
    """Strain, shown in percent."""


class FieldName(Worded, str):
    """Name of a field of a request: its key in design files, preceded by the name of its table.

    Each front end shows the name that its users know: see `Wording.field` and `SPELLING`.

    Examples
    --------
    >>> f"set {FieldName('max_width')} to 30"
    'set max_width to 30'
    """

    __slots__ = ()


class MaterialWidth(FieldName):
    """Name of the field `max_width` where it limits ligaments or a backing, not the outline of the strip.

    FreeCAD has a separate property for this width. Files and options have only `max_width`.
    """

    __slots__ = ()


MATERIAL_WIDTH = MaterialWidth("max_width")

SPELLING: ContextVar[Callable[[str], str]] = ContextVar("spelling", default=str)
"""Function that spells the name of a field in English messages.

The command line sets a function that returns options."""


class Listed(Worded, tuple[Any, ...]):
    """Numbers, lengths or sentences that are listed in a message. At most six of them are shown.

    Examples
    --------
    >>> f"at {Listed([Length(12), Length(34.5)])}", f"{Listed('abc')}", f"{Listed([3.0, 1 / 3]):.2g}"
    ('at 12 and 34.5 mm', 'a, b and c', '3 and 0.33')
    """

    LAST = "{some} and {last}"


def both_names(first: str, second: str) -> Listed | str:
    """Return two names for a message. Equal names are the names of two copies.

    Examples
    --------
    >>> f"{both_names('A:1', 'B:1')}; {both_names('A:1', 'A:1')}"
    'A:1 and B:1; two copies of A:1'
    """
    return Listed((first, second)) if first != second else note("two copies of {name}", name=first)


class Either(Listed):
    """Alternative sentences or numbers, joined by "or".

    Examples
    --------
    >>> f"{Either(['widen it', 'take another sheet'])}"
    'widen it, or take another sheet'
    """

    LAST = "{some}, or {last}"


class Span(Listed):
    """Range of lengths, shown as a single length if both ends look equal."""

    LAST = "{some} to {last}"

    @classmethod
    def of(cls, low: float, high: float, digits: str = ".3g") -> "Span":
        """Return the range from `low` to `high`, mm.

        If both ends look equal, the range has a single length.

        Examples
        --------
        >>> f"{Span.of(20.83, 30)} wide", f"{Span.of(29.99, 30)} wide"
        ('20.8 to 30 mm wide', '30 mm wide')
        >>> f"{Span.of(6.35 - 1e-14, 6.35, '.1f')} in diameter"
        '6.35 mm in diameter'
        """
        alike = f"{low:{digits}}" == f"{high:{digits}}" or high - low <= 1e-9 * high
        return cls([Length(high)] if alike else [Length(low), Length(high)])


class Point(Worded, tuple[float, ...]):
    """A point in the plane or in space, mm.

    Examples
    --------
    >>> f"they meet at {Point((12, 34.56))}"
    'they meet at (12, 34.56) mm'
    """


class Wording(Formatter):
    """Formatter of messages as English sentences with lengths in mm. Front ends override its methods.

    Attributes
    ----------
    unit : str
        Unit of displayed lengths.
    size : float
        Size of the unit in mm.
    point : str
        Decimal separator.
    """

    unit, size, point = "mm", 1.0, "."

    def template(self, text: str) -> str:
        """Return the template in the language of the reader."""
        return text

    def sentence(self, message: str) -> str:
        """Return the message as a sentence in the language of the reader.

        A plain text is used as a template.
        """
        if not isinstance(message, Refusal):
            return self.template(message)
        text = self.template(message.text)
        return _with_places(self.vformat(text, (), message.values) if message.values else text, message.where)

    def field(self, name: str) -> str:
        """Return the name of a field as the front end spells it."""
        return SPELLING.get()(name)

    def format_field(self, value: Any, spec: str) -> str:
        """Format a value of a template."""
        match value:
            case FieldName():
                return self.field(str(value))
            case Refusal():
                return self.sentence(value)
            case BareLength():
                return self._in_unit(value, spec)
            case Length():
                return f"{self._in_unit(value, spec)} {self.unit}"
            case Quantity():
                number, unit = value.shown
                return f"{self._digits(number, spec or '.3g')} {self.template(unit)}"
            case Point():
                inside = self._separator.join(self._in_unit(item, spec or ".4g") for item in value)
                return f"({inside}) {self.unit}"
            case Listed():
                return self._joined(value, spec) + (f" {self.unit}" if _are_lengths(value) else "")
            case float():
                return self._digits(value, spec)
            case int() if spec.endswith(("f", "g")):
                return self._digits(value, spec)
        return str(format(value, spec))

    @property
    def _separator(self) -> str:
        return ", " if self.point == "." else "; "  # semicolons between numbers with decimal commas

    def _in_unit(self, mm: float, spec: str) -> str:
        if self.size != 1:
            return self._digits(mm / self.size, ".4g" if abs(mm) >= 0.1 * self.size else ".3g")
        return self._digits(mm, spec or (".0f" if 999.5 <= abs(mm) < 1e9 else ".3g"))

    def _digits(self, value: float, spec: str) -> str:
        """Format a number without an exponent at usual sizes, and without a sign before 0."""
        text = float.__format__(float(value), spec)
        text = text if text.strip("-0.") else text.lstrip("-")
        if "e" in text:
            whole = "+f" if spec.startswith("+") else "f"
            text = format(Decimal(text), whole) if 1e-12 < abs(value) < 1e9 else text
            text = "0" if abs(value) <= 1e-12 else text
        return text if self.point == "." else text.replace(".", self.point)

    def _joined(self, items: Listed, spec: str) -> str:
        """Join the items with commas. If all are lengths, the unit is not repeated."""
        lengths = _are_lengths(items)
        texts = [
            self._joined(item, spec) if lengths and isinstance(item, Listed) else
            self._in_unit(item, spec) if lengths else
            self.format_field(item, spec)
            for item in items
        ]  # fmt: skip
        separator = self._separator if lengths else ", "
        if (more := len(texts) - _MOST_LISTED) > 0:
            return self.template("{some} and {more} more").format(
                some=separator.join(texts[:_MOST_LISTED]), more=more
            )
        if len(texts) < 2:
            return "".join(texts)
        return self.template(items.LAST).format(some=separator.join(texts[:-1]), last=texts[-1])


def _are_lengths(items: Iterable[Any]) -> bool:
    verdicts = [
        _are_lengths(item) if isinstance(item, Listed) else isinstance(item, Length) for item in items
    ]
    return bool(verdicts) and all(verdicts)


ENGLISH = Wording()


def number_text(value: float, spec: str = ".3g") -> str:
    """Return a number for an English text, formatted as in a message: without exponent for usual sizes.

    Examples
    --------
    >>> number_text(101, ".2g"), number_text(23456.7, ".4g")
    ('100', '23460')
    """
    return ENGLISH.format_field(float(value), spec)


_MOST_LISTED = 6


@dataclass(frozen=True)
class Change:
    """Suggested value of a field that may make the request possible.

    Attributes
    ----------
    field : str
        Name of the field, as in a design file: "max_width", "smooth". "nearest" lets the curve change, within
        the limits of sheet and widths, or forbids it. "nearest_curve" draws the nearest curve instead and adds
        the fields of its value, such as rails. "elements" removes rails, pins, ties and loads. "join"
        closes gaps between drawn edges up to a width.
    value : object
        Suggested value. Lengths are in mm.
    """

    field: str
    value: Any


class Refusal(str):
    """Message of an error, or message about a result: an English sentence with its data.

    The `str` of a message is the location and the sentence. From the template and the values, front ends can
    format the message in another language or unit. No code parses the sentence.

    Parameters
    ----------
    kind : str
        Kind of the refusal, as a word for programs.
    text : str
        English template with {name} for each value, or a complete sentence without values.
    values : mapping
        Values by name. A value may be a Refusal.
    where : mapping
        Location of the problem: "file", "strip", "field" (name of an option, or several names) or "at" (mm
        along the curve).
    changes : sequence of Change
        Alternative changes that may help but are not tested.
    severity : "error", "warning" or "note"

    Examples
    --------
    >>> far = {"distance": Length(120), "length": Length(100)}
    >>> refusal = Refusal("input", "the ends are {distance} apart, the strip is {length} long", far)
    >>> print(refusal.at(strip="A1"))
    A1: the ends are 120 mm apart, the strip is 100 mm long
    """

    kind: str
    text: str
    values: Mapping[str, Any]
    where: Mapping[str, Any]
    changes: tuple[Change, ...]
    severity: Severity

    def __new__(
        cls,
        kind: str,
        text: str,
        values: Mapping[str, Any] | None = None,
        where: Mapping[str, Any] | None = None,
        changes: Sequence[Change] = (),
        severity: Severity = "error",
    ) -> "Refusal":
        """Return a record with its formatted text."""
        values, where = dict(values or {}), dict(where or {})
        sentence = ENGLISH.template(text)
        sentence = ENGLISH.vformat(sentence, (), values) if values else sentence
        # a traceback prints the text on a terminal, so control codes must be escaped
        record = super().__new__(cls, printable(_with_places(sentence, where)))
        record.kind, record.text, record.severity = kind, text, severity
        record.values, record.where, record.changes = values, where, tuple(changes)
        return record

    def __getnewargs__(self) -> tuple[Any, ...]:
        return self.kind, self.text, self.values, self.where, self.changes, self.severity

    def at(self, **where: Any) -> "Refusal":
        """Return the record with these keys added to its location `where`."""
        return Refusal(
            self.kind, self.text, self.values, {**self.where, **where}, self.changes, self.severity
        )

    def walk(self) -> Iterator["Refusal"]:
        """Yield this record and the records inside its values."""
        yield self
        for value in self.values.values():
            if isinstance(value, Refusal):
                yield from value.walk()

    @property
    def all_changes(self) -> tuple[Change, ...]:
        """Changes of this record and of the records in its values."""
        return tuple(change for record in self.walk() for change in record.changes)

    @property
    def fields(self) -> set[str]:
        """Names of fields among the values of this record and of the records inside its values."""
        values = (value for record in self.walk() for value in record.values.values())
        return {str(value) for value in values if isinstance(value, FieldName)}

    @property
    def record(self) -> dict[str, Any]:
        """Return the data of the refusal for JSON: kind, values, where, changes, severity, and the message."""
        return {
            "kind": self.kind,
            "severity": self.severity,
            "text": self.text,
            "values": {name: _plain(value) for name, value in self.values.items()},
            "where": {name: _plain(value) for name, value in self.where.items()},
            "changes": [{"field": change.field, "value": _plain(change.value)} for change in self.changes],
            "message": str(self),
        }


def is_reported(message: str) -> bool:
    """Return True for an error or warning. Notes appear only in verbose output."""
    return not isinstance(message, Refusal) or message.severity != "note"


def note(
    text: str, /, *, severity: Severity = "note", changes: Sequence[Change] = (), **values: Any
) -> Refusal:
    """Return a message about a result. The text is a complete sentence, or a template with {name} for each value.

    Examples
    --------
    >>> message = note("it rests {far} away", far=Length(1.234))
    >>> print(message, message.values["far"] + 0.0)
    it rests 1.23 mm away 1.234
    """
    return Refusal("note", text, values, changes=changes, severity=severity)


def one_of_each(messages: Iterable[str]) -> Iterator[str]:
    """Of messages that differ only in numbers and names, yield the first, with the number of the others."""
    kinds: dict[str, list[str]] = {}
    for message in dict.fromkeys(messages):
        kinds.setdefault(getattr(message, "text", message), []).append(message)
    for alike in kinds.values():
        first = alike[0]
        yield note("{first} (and {count} more like this)", first=first, count=len(alike) - 1,
                   severity=getattr(first, "severity", "warning")) if alike[1:] else first  # fmt: skip


def sentences(parts: Iterable[str], between: str = "; ", end: str = "") -> str:
    """Join sentences to a message that contains them as separate records, which front ends can translate.

    A single sentence is returned unchanged.

    Examples
    --------
    >>> both = sentences([note("it is too long"), note("it breaks")])
    >>> print(both, len(both.values))
    it is too long; it breaks 2
    """
    parts = [part for part in parts if part]
    if len(parts) == 1 and not end:
        return parts[0]
    names = [f"part{k}" for k in range(len(parts))]
    return Refusal(
        "list", between.join(f"{{{name}}}" for name in names) + end, dict(zip(names, parts, strict=True))
    )


def ended(message: str) -> str:
    """Return a message with a full stop at its end, so that another sentence can follow.

    Examples
    --------
    >>> print(ended(note("it breaks")), ended(note("It breaks.")))
    it breaks. It breaks.
    """
    return message if message.endswith((".", "?", "!", ":")) else note("{sentence}.", sentence=message)


def _with_places(text: str, where: Mapping[str, Any]) -> str:
    for name in (str(where[place]) for place in reversed(PLACES) if where.get(place)):
        text = text if text.startswith(name) else f"{name}: {text}"
    return text


def _plain(value: Any) -> Any:
    """Return a value as plain data for JSON. Quantities are numbers in the shown unit."""
    if isinstance(value, bool | str) or value is None:
        return value
    if isinstance(value, Quantity):
        value = value.shown[0]
    if isinstance(value, int | float):
        return value if isfinite(value) else str(value)
    if isinstance(value, Mapping):
        return {str(name): _plain(item) for name, item in value.items()}
    if isinstance(value, Sequence | Set):
        return [_plain(item) for item in value]
    return _plain(value.tolist()) if hasattr(value, "tolist") else str(value)


P = ParamSpec("P")
R = TypeVar("R")


class _Quoted(Repr):
    def repr_date(self, value: date | time, _: int) -> str:
        return value.isoformat()

    repr_datetime = repr_time = repr_date


_QUOTED = _Quoted()
_QUOTED.maxstring = _QUOTED.maxother = 60


class ElasticaError(Exception):
    """Base class of all errors raised by elastica_cad.

    Parameters
    ----------
    text : str
        A complete sentence, or a template with {name} for each value.
    kind : str, optional
        Identifier of the kind of error, for programs. The default is the identifier of the class.
    where : mapping, optional
        Location of the problem: "file", "strip", "field" (name of an option) or "at" (mm along the curve).
    changes : sequence of Change, optional
        Suggested values of options.
    **values : object
        Values of the template. Lengths are passed as `Length`.

    Attributes
    ----------
    refusal : Refusal
        Record of the message with `kind`, `where`, `changes` and `values`.
    details : tuple of str
        Sentences for verbose output.

    Examples
    --------
    >>> problem = InputError("the ends are {distance} apart", distance=Length(120), where={"field": "end"})
    >>> str(problem.at(strip="A1")), problem.refusal.values["distance"] + 0.0, problem.refusal.where["field"]
    ('A1: the ends are 120 mm apart', 120.0, 'end')
    """

    KIND = "error"

    refusal: Refusal
    details: tuple[str, ...] = ()

    def __init__(
        self,
        text: str = "",
        /,
        *,
        kind: str | None = None,
        where: Mapping[str, Any] | None = None,
        changes: Sequence[Change] = (),
        **values: Any,
    ) -> None:
        # a message with its data, such as that of another error, keeps template, values, location and changes
        if isinstance(text, Refusal):
            where, changes = {**text.where, **(where or {})}, (*changes, *text.changes)
            values = {**text.values, **values}
            text = text.text
        # store errors as texts, because errors cannot be passed to another process
        values = {
            name: str(value) if isinstance(value, BaseException) else value for name, value in values.items()
        }
        self.refusal = Refusal(kind or self.KIND, str(text), values, where, changes)
        super().__init__(str(self.refusal))

    def __str__(self) -> str:
        return self.refusal  # front ends can translate a Refusal, which is a str

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (type(self), str(self)), self.__dict__

    def at(self, **where: Any) -> Self:
        """Add a location to this error and return it: `raise problem.at(strip="A1")`."""
        self.refusal = self.refusal.at(**where)
        return self


def _restored(kind: type[ElasticaError], message: str) -> ElasticaError:
    """Restore a pickled error without calling its constructor, whose signature depends on the class."""
    return kind.__new__(kind, message)


class InputError(ElasticaError, ValueError):
    """The input is not valid: a file, number, option or curve."""

    KIND = "input"


class UnknownOptionError(InputError, TypeError):
    """An option does not exist. This error is also a `TypeError`, which Python raises for unknown arguments."""

    KIND = "unknown"


class StrainError(InputError):
    """The strip would break, because its strain exceeds the breaking strain of its sheet."""

    KIND = "strain"


class FaultError(InputError):
    """No part can be made within the widths of the request and the limits of the workshop."""

    KIND = "fault"


class NotConvergedError(ElasticaError, RuntimeError):
    """A solver did not reach its tolerance, so there is no result."""

    KIND = "not converged"


class NotMetError(NotConvergedError):
    """The limits cannot be met close enough to the drawn curve."""

    KIND = "not met"


class MissingDependencyError(ElasticaError, ImportError, RuntimeError):
    """A required optional library is not installed, or its version is not supported."""

    KIND = "missing"


def quoted(value: object) -> str:
    """Format a value from a file for a message. Long texts and lists are truncated.

    Examples
    --------
    >>> quoted("mm"), len(quoted("m" * 2000))
    ("'mm'", 60)
    """
    return _QUOTED.repr(value)


def toml_slip(text: str, error: Exception) -> str:
    """Return how to correct a line with a TOML error.

    Examples
    --------
    >>> toml_slip("max_width = 2,5", ValueError("Expected newline (at line 1, column 14)"))
    'write decimals with a point, 2.5'
    """
    match = re.search(r"at line (\d+)", str(error))
    lines = text.splitlines()
    line = lines[int(match[1]) - 1] if match and int(match[1]) <= len(lines) else ""
    if "\\" in line:
        return "write / in place of \\ in paths"
    if comma := re.search(r"=\s*([+-]?\d+),(\d+)", line):
        return f"write decimals with a point, {comma[1]}.{comma[2]}"
    if line.lstrip().startswith("[") and not line.isascii():
        return 'put names with letters beyond a-z in quotes, as in [sheets."grün"]'
    return "mend that line"


def how_to_install(package: str) -> str:
    """Return the command that installs a package in the running environment.

    Examples
    --------
    >>> how_to_install("matplotlib").endswith(" -m pip install matplotlib")
    True
    """
    here = sys.executable if Path(sys.executable).stem.startswith("python") else "python"
    words = (
        f'"{word}"' if set(word) & set(" []") else word for word in (here, "-m", "pip", "install", package)
    )
    return " ".join(words)


def missing_library(use: str, library: str) -> MissingDependencyError:
    """Return the error for a missing library. `use` is the operation that needs it.

    Examples
    --------
    >>> str(missing_library("reading a.dxf needs ezdxf", "ezdxf")).endswith("pip install ezdxf")
    True
    """
    return MissingDependencyError(f"{use}: {how_to_install(library)}")


def installed_version(package: str) -> str | None:
    """Return the version of an installed package, or None. elastica_cad may run from a checkout."""
    from importlib.metadata import PackageNotFoundError, version

    try:
        return version(package)
    except PackageNotFoundError:
        return None


def refuse_unknown(options: Iterable[str], known: Iterable[str], what: str) -> None:
    """Raise an error for unknown names of options.

    Parameters
    ----------
    options, known : iterable of str
        The names to be checked, and the known names.
    what : str
        Name, in the message, of the object that has these options.

    Raises
    ------
    UnknownOptionError
        A name is unknown. The message suggests the known name with the most similar spelling, or lists all.

    Examples
    --------
    >>> refuse_unknown(["widht"], ["width", "height"], "a plate")
    Traceback (most recent call last):
    elastica_cad.errors.UnknownOptionError: widht is not an option of a plate: did you mean width?
    """
    names = sorted(known)
    for name in options:
        if name not in names:
            near = near_names(name, names)
            hint = f"did you mean {near[0]}?" if near else f"there are {', '.join(names)}"
            raise UnknownOptionError(
                "{name} is not an option of {what}: {hint}", name=name, what=what, hint=hint, near=near
            )


def near_names(name: str, known: Iterable[str], *, cutoff: float = 0.6) -> list[str]:
    """Return a list of the known name with the most similar spelling, or an empty list.

    A name is similar enough if its similarity by `difflib`, 0 to 1, is at least `cutoff`.
    """
    from difflib import get_close_matches

    return get_close_matches(name, list(known), n=1, cutoff=cutoff)


def refuse_options_unlike(names: Iterable[str], function: Callable[..., object], what: str) -> None:
    """Raise UnknownOptionError for the first name that is not a keyword of the function."""
    refuse_unknown(names, _keywords(function), what)


@cache
def _keywords(function: Callable[..., object]) -> tuple[str, ...]:
    from inspect import signature

    return tuple(
        name
        for name, parameter in signature(function).parameters.items()
        if parameter.kind is parameter.KEYWORD_ONLY
    )


def rounded_up(value: float, figures: int = 4) -> float:
    """Round a minimum up for a message, so that the displayed value is sufficient.

    Examples
    --------
    >>> rounded_up(20.4612), rounded_up(20.0), rounded_up(0.0123401, 3)
    (20.47, 20.0, 0.0124)
    """
    return _rounded(value, figures, up=True)


def rounded_down(value: float, figures: int = 4) -> float:
    """Round a maximum down for a message, so that the displayed value is permitted.

    Examples
    --------
    >>> rounded_down(5.786, 3), rounded_down(5.78, 3)
    (5.78, 5.78)
    """
    return _rounded(value, figures, up=False)


def _rounded(value: float, figures: int, *, up: bool) -> float:
    """Return a positive number with `figures` significant digits, rounded up or down."""
    if not (isfinite(value) and value > 0):
        return value
    step = 10.0 ** (floor(log10(value)) - figures + 1)
    steps = value / step
    # the allowance of 1e-9 keeps numbers that need no rounding
    whole = ceil(steps - 1e-9) if up else floor(steps + 1e-9)
    return float(f"{whole * step:.{figures}g}")
