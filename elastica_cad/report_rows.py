"""Labelled rows of reports, which text output, notebooks, FreeCAD and the web page display."""

from collections.abc import Sequence
from dataclasses import dataclass

from elastica_cad.refusals import Severity

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
