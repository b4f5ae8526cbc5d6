"""The record of a refusal: its English template, the values in it, where it is, and which changes would mend it."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Literal

from elastica_cad._printable import printable

Severity = Literal["error", "warning", "note"]

PLACES = ("file", "strip")
"""Places that stand before the text, in this order; the others are for programs."""


class Length(float):
    """A length in mm that a text shows with three digits and its unit, unless the template has a format of its own.

    Examples
    --------
    >>> "the ends are {} apart".format(Length(1234.56)), f"{Length(0.1234)}", f"{Length(8):.1f}"
    ('the ends are 1230 mm apart', '0.123 mm', '8.0')
    """

    def __format__(self, spec: str) -> str:
        return float.__format__(self, spec) if spec else f"{_in_digits(self)} mm"

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


@dataclass(frozen=True)
class Refusal:
    """Why a request is refused, or what is to be said of its answer.

    Attributes
    ----------
    kind : str
        What programs tell refusals apart by.
    text : str
        The English template, {name} for each of the values; without values a finished sentence.
    values : mapping
        By name, of their own types.
    where : mapping
        Places by kind: "file", "strip", "field" (or several, of the request), "at" (mm along the curve).
    changes : tuple of Change
        Each of which may help; none of them was tried.
    severity : "error", "warning" or "note"

    Examples
    --------
    >>> far = {"distance": Length(120), "length": Length(100)}
    >>> refusal = Refusal("input", "the ends are {distance} apart, the strip is {length} long", far)
    >>> str(refusal.at(strip="A1"))
    'A1: the ends are 120 mm apart, the strip is 100 mm long'
    """

    kind: str
    text: str
    values: Mapping[str, Any] = field(default_factory=dict)
    where: Mapping[str, Any] = field(default_factory=dict)
    changes: tuple[Change, ...] = ()
    severity: Severity = "error"

    @property
    def sentence(self) -> str:
        """The text with its values, without the places before it."""
        return self.text.format_map(self.values) if self.values else self.text

    def __str__(self) -> str:
        said = self.sentence
        for name in (str(self.where[place]) for place in reversed(PLACES) if self.where.get(place)):
            said = said if said.startswith(name) else f"{name}: {said}"
        return printable(said)  # a traceback shows it on a terminal

    def at(self, **where: Any) -> "Refusal":
        """The same with more places."""
        return replace(self, where={**self.where, **where})
