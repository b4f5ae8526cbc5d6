"""Labelled rows and tables of reports, which text output, notebooks, FreeCAD and the web page display."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import isfinite
from typing import Any

from elastica_cad.errors import Severity, number_text

LABEL_WIDTH = 11
"""Width of the column of labels in text."""


@dataclass(frozen=True)
class Row:
    """A labelled line of a report.

    Attributes
    ----------
    label : str
        Word that names the subject.
    text : str
        Text of the line. A warning states the problem and one instruction.
    details : sequence of str
        Sentences for verbose output.
    severity : "error", "warning" or "note"
        A warning is marked, and is printed before the notes.
    """

    label: str
    text: str
    details: Sequence[str] = ()
    severity: Severity = "note"

    @property
    def stops(self) -> bool:
        """True for an error or warning, on which the user must act before cutting."""
        return self.severity != "note"


def warning_row(text: str, label: str = "Warning") -> Row:
    """Return the row of a warning without details."""
    return Row(label, text, severity="warning")


def in_order(rows: Sequence[Row]) -> tuple[Row, ...]:
    """Return the rows on which the user must act, and then the other rows."""
    return tuple(sorted(rows, key=lambda row: not row.stops))


def printed_row(row: Row) -> str:
    """Return a row as a line of text, with the label in a column.

    A row on which the user must act is marked with "!".

    Examples
    --------
    >>> rows = [Row("Size", "20 mm long"), Row("Stability", "unstable", (), "warning")]
    >>> print(*map(printed_row, in_order(rows)), sep="\\n")
    ! Stability unstable
    Size        20 mm long
    """
    label = f"! {row.label}" if row.stops else row.label
    return f"{label:<{LABEL_WIDTH}} {row.text}"


DECIMALS = {"mm": 2, "inch": 3, "deg": 1, "percent": 3, "safety": 2}
"""Number of decimals in a column, by the unit at the end of its name. Other columns have three digits."""

SYMBOLS = {"percent": "%", "Nmm": "N mm"}
"""Units in headings that differ from the units in the names of columns."""


def printed_table(columns: Mapping[str, Iterable[Any]]) -> Iterator[str]:
    """Yield the lines of a table, aligned to the right: the headings and the rows.

    The name of a column of numbers ends with its unit, as in `csv_text`.

    Examples
    --------
    >>> print(*printed_table({"end_force_x_N": [12.345, -0.0], "turn_deg": [90, float("inf")]}), sep="\\n")
    end force x N  turn deg
             12.3      90.0
                0         -
    """
    table = []
    for name, values in columns.items():
        *words, unit = name.split("_")
        digits = f".{DECIMALS[unit]}f" if unit in DECIMALS else ".3g"
        cells = [
            value if isinstance(value, str) else number_text(value, digits) if isfinite(value) else "-"
            for value in values
        ]
        heading = " ".join([*words, SYMBOLS.get(unit, unit)])
        width = max(map(len, (heading, *cells)))
        table.append([f"{cell:>{width}}" for cell in (heading, *cells)])
    yield from map("  ".join, zip(*table, strict=True))
