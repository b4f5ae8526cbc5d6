"""The cut list: every piece with its sheet, size, count, file, cut length and weight."""

import csv
import io
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from elastica_cad.fabrication.sheets.pieces import Piece


@dataclass(frozen=True)
class CutListRow:
    """One line of the list; lengths in mm, masses in g, `cut_length` and `mass` of one piece."""

    part: str
    sheet: str
    thickness: float
    length: float
    width: float
    count: int
    cut_length: float
    mass: float
    file: str


@dataclass(frozen=True)
class CutList:
    """What is cut; `csv` for programs, `str()` for people.

    Attributes
    ----------
    rows : tuple of CutListRow
    """

    rows: tuple[CutListRow, ...]

    @property
    def count(self) -> int:
        """Number of all pieces."""
        return sum(row.count for row in self.rows)

    @property
    def cut_length(self) -> float:
        """Length of all cuts, mm."""
        return sum(row.count * row.cut_length for row in self.rows)

    @property
    def mass(self) -> float:
        """Of all pieces, g."""
        return sum(row.count * row.mass for row in self.rows)

    @property
    def csv(self) -> str:
        """Comma separated values with a header line; units are in the header."""
        stream = io.StringIO()
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(
            [
                "part",
                "sheet",
                "thickness_mm",
                "length_mm",
                "width_mm",
                "count",
                "file",
                "cut_length_mm",
                "mass_g",
            ]
        )
        for row in self.rows:
            size = [f"{row.length:.2f}", f"{row.width:.2f}", row.count]
            writer.writerow(
                [
                    row.part,
                    row.sheet,
                    f"{row.thickness:g}",
                    *size,
                    row.file,
                    f"{row.cut_length:.1f}",
                    f"{row.mass:.3f}",
                ]
            )
        return stream.getvalue()

    def __str__(self) -> str:
        """A table for people, with the sums below."""
        head = ("part", "sheet", "mm", "size mm", "count", "cut mm", "g", "file")
        body = [
            (
                row.part,
                row.sheet,
                f"{row.thickness:g}",
                f"{row.length:.1f} x {row.width:.1f}",
                str(row.count),
                f"{row.cut_length:.0f}",
                f"{row.mass:.2f}",
                row.file,
            )
            for row in self.rows
        ]
        total = ("in all", "", "", "", str(self.count), f"{self.cut_length:.0f}", f"{self.mass:.2f}", "")
        return _table([head, *body, total], right=(2, 3, 4, 5, 6))


def cut_list(pieces: Iterable[Piece], files: Mapping[str, str] | None = None) -> CutList:
    """The cut list of pieces, in their order.

    Parameters
    ----------
    pieces : iterable of Piece
    files : mapping, optional
        From a piece's name to its file; `file_stem` with .dxf where not given.
    """
    rows = []
    for piece in pieces:
        length, width = piece.size
        file = (files or {}).get(piece.name, f"{piece.file_stem}.dxf")
        rows.append(
            CutListRow(
                piece.name,
                piece.sheet.name,
                piece.sheet.thickness,
                length,
                width,
                piece.count,
                piece.cut_length,
                piece.mass,
                file,
            )
        )
    return CutList(tuple(rows))


def _table(rows: Sequence[Sequence[str]], *, right: Sequence[int]) -> str:
    widths = [max(len(row[k]) for row in rows) for k in range(len(rows[0]))]
    lines = []
    for row in rows:
        cells = [
            cell.rjust(width) if k in right else cell.ljust(width)
            for k, (cell, width) in enumerate(zip(row, widths, strict=True))
        ]
        lines.append("  ".join(cells).rstrip())
    lines.insert(1, "-" * max(map(len, lines)))
    lines.insert(-1, lines[1])
    return "\n".join(lines) + "\n"
