"""The record of a refusal: its English template, the values in it, where it is, and which changes would mend it."""

from collections.abc import Iterable, Mapping, Sequence, Set
from dataclasses import dataclass
from math import isfinite
from typing import Any, Literal

from elastica_cad._printable import printable

Severity = Literal["error", "warning", "note"]

PLACES = ("file", "strip")
"""Places that stand before the text, in this order; the others are for programs."""


class Length(float):
    """A length in mm, which a text shows with its unit, with three digits unless its template has a format.

    Examples
    --------
    >>> "the ends are {} apart".format(Length(1234.56)), f"{Length(0.1234)}", f"{Length(8):.1f}"
    ('the ends are 1230 mm apart', '0.123 mm', '8.0 mm')
    """

    def __format__(self, spec: str) -> str:
        return f"{float.__format__(self, spec) if spec else _in_digits(float(self))} mm"

    def __str__(self) -> str:
        return format(self)


def _in_digits(value: float) -> str:
    """Three digits, without an exponent where a person would write none."""
    rounded = float(f"{value:.3g}")
    return f"{rounded:.0f}" if 1e3 <= abs(rounded) < 1e7 else f"{rounded:g}"


@dataclass(frozen=True)
class Change:
    """A value of one field of the request with which it may be met.

    Attributes
    ----------
    field : str
        As in a design file: "max_width", "smooth"; "nearest" lets the curve change within the sheet and the widths.
    value : object
        What to give it; lengths in mm.
    """

    field: str
    value: Any


class Refusal(str):
    """Why a request is refused, or what is to be said of its answer: an English sentence that is a record too.

    As a text it is the sentence, with the places before it. Front ends make the sentence in another language, or
    with lengths in another unit, from the template and the values; nothing reads the sentence back.

    Parameters
    ----------
    kind : str
        What programs tell refusals apart by.
    text : str
        The English template, {name} for each of the values; without values a finished sentence.
    values : mapping
        By name, of their own types; a value may be a Refusal itself.
    where : mapping
        Places by kind: "file", "strip", "field" (or several, of the request), "at" (mm along the curve).
    changes : sequence of Change
        Each of which may help; none of them was tried.
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
        """The record; its text is made here."""
        values, where = dict(values or {}), dict(where or {})
        said = text.format_map(values) if values else text
        # a traceback shows it on a terminal
        record = super().__new__(cls, printable(_with_places(said, where)))
        record.kind, record.text, record.severity = kind, text, severity
        record.values, record.where, record.changes = values, where, tuple(changes)
        return record

    def __getnewargs__(self) -> tuple[Any, ...]:
        return self.kind, self.text, self.values, self.where, self.changes, self.severity

    def at(self, **where: Any) -> "Refusal":
        """The same with more places."""
        return Refusal(
            self.kind, self.text, self.values, {**self.where, **where}, self.changes, self.severity
        )

    @property
    def record(self) -> dict[str, Any]:
        """For programs, as JSON holds it: kind, values, where, changes, severity, and the message."""
        return {
            "kind": self.kind,
            "severity": self.severity,
            "text": self.text,
            "values": {name: _plain(value) for name, value in self.values.items()},
            "where": {name: _plain(value) for name, value in self.where.items()},
            "changes": [{"field": one.field, "value": _plain(one.value)} for one in self.changes],
            "message": str(self),
        }


def note(text: str, /, *, severity: Severity = "note", **values: Any) -> Refusal:
    """What is to be said of an answer: a finished sentence, or a template with {name} for each of the values.

    Examples
    --------
    >>> said = note("it rests {far} away", far=Length(1.234))
    >>> print(said, said.values["far"] + 0.0)
    it rests 1.23 mm away 1.234
    """
    return Refusal("note", text, values, severity=severity)


def sentences(parts: Iterable[str], between: str = "; ") -> str:
    """Several sentences as one that front ends can still take apart; a single one is itself.

    Examples
    --------
    >>> both = sentences([note("it is too long"), note("it breaks")])
    >>> print(both, len(both.values))
    it is too long; it breaks 2
    """
    parts = [part for part in parts if part]
    if len(parts) == 1:
        return parts[0]
    names = [f"part{k}" for k in range(len(parts))]
    return Refusal(
        "list", between.join(f"{{{name}}}" for name in names), dict(zip(names, parts, strict=True))
    )


def _with_places(said: str, where: Mapping[str, Any]) -> str:
    for name in (str(where[place]) for place in reversed(PLACES) if where.get(place)):
        said = said if said.startswith(name) else f"{name}: {said}"
    return said


def _plain(value: Any) -> Any:
    """A value as JSON holds it."""
    if isinstance(value, bool | str) or value is None:
        return value
    if isinstance(value, int | float):
        return value if isfinite(value) else str(value)
    if isinstance(value, Mapping):
        return {str(name): _plain(one) for name, one in value.items()}
    if isinstance(value, Sequence | Set):
        return [_plain(one) for one in value]
    return _plain(value.tolist()) if hasattr(value, "tolist") else str(value)
