"""Cut list with a row for every piece, as CSV and as a printed table."""

import csv
import io
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from elastica_cad._values import require_record, several
from elastica_cad.strip.drawing import CUT_INNER, CUT_OUTER
from elastica_cad.strip.layers import Layer
from elastica_cad.strip.pieces import DistinctShapes, FlatShape, Piece

CSV_COLUMNS = {
    "part": "{0.part}", "sheet": "{0.sheet}", "thickness_mm": "{0.thickness:g}", "length_mm": "{0.length:.2f}",
    "width_mm": "{0.width:.2f}", "count": "{0.count}", "file": "{0.file}", "cut_length_mm": "{0.cut_length:.1f}",
    "mass_g": "{0.mass:.3f}", "grain": "{0.grain}", "same_shape_as": "{0.like}",
}  # fmt: skip
"""Columns of the list in a file, with the format of each value."""

TABLE_COLUMNS = {
    "part": "{0.part}", "sheet": "{0.sheet}", "mm": "{0.thickness:g}", "size mm": "{0.length:.1f} x {0.width:.1f}",
    "count": "{0.count}", "cut mm": "{0.cut_length:.0f}", "g": "{0.mass:.2f}", "grain": "{0.grain}",
    "shape as": "{0.like}", "file": "{0.file}",
}  # fmt: skip
"""Columns of the printed table, with the format of each value."""

SUMMED = ("count", "cut mm", "g")


@dataclass(frozen=True)
class CutListRow:
    """Row of the cut list; lengths in mm, masses in g, `cut_length` and `mass` of one piece.

    `grain` is the direction of `length` relative to the grain; it is empty for a sheet without grain. `like`
    is the name of the first piece with the same shape, possibly turned or flipped, and different
    engraving.
    """

    part: str
    sheet: str
    thickness: float
    length: float
    width: float
    count: int
    cut_length: float
    mass: float
    file: str
    grain: str = ""
    like: str = ""


@dataclass(frozen=True)
class CutList:
    """List of the pieces to be cut. `csv` returns it for programs, and `str()` as a printed table.

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
    def shapes(self) -> int:
        """Number of different shapes; engraving is ignored."""
        return sum(not row.like for row in self.rows)

    @property
    def cut_length(self) -> float:
        """Length of all cuts, mm."""
        return sum(row.count * row.cut_length for row in self.rows)

    @property
    def mass(self) -> float:
        """Mass of all pieces, g."""
        return sum(row.count * row.mass for row in self.rows)

    @property
    def csv(self) -> str:
        """Comma separated values, with a header line that states the units.

        A text that a spreadsheet would treat as a formula is preceded by an apostrophe.
        """
        stream = io.StringIO()
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(CSV_COLUMNS)
        writer.writerows([_cell(text.format(row)) for text in CSV_COLUMNS.values()] for row in self.rows)
        return stream.getvalue()

    def in_files(self, files: Mapping[str, str]) -> "CutList":
        """Return the list with new file names by part name; other parts keep their file names."""
        require_record(files, Mapping, "the names of files", "a mapping from part to file")
        return CutList(tuple(replace(row, file=files.get(row.part, row.file)) for row in self.rows))

    def __str__(self) -> str:
        """Return the list as a table of text, with the sums in its last line."""
        body = [[text.format(row) for text in TABLE_COLUMNS.values()] for row in self.rows]
        sums = [TABLE_COLUMNS[name].format(self) if name in SUMMED else "" for name in TABLE_COLUMNS]
        return _table([[*TABLE_COLUMNS], *body, ["in all", *sums[1:]]], right=(2, 3, 4, 5, 6))


def _cell(text: str) -> str:
    """Return the text, preceded by an apostrophe if a spreadsheet would treat it as a formula."""
    return f"'{text}" if text[:1] in tuple("=+-@\t\r") else text


def cut_list(pieces: Iterable[Piece], files: Mapping[str, str] | None = None) -> CutList:
    """Return the cut list of pieces, in their order.

    Parameters
    ----------
    pieces : iterable of Piece
    files : mapping, optional
        Mapping from the name of a piece to its file. The default file name is `file_stem` with .dxf.
    """
    rows, pieces = [], several("pieces", pieces, Piece, "Piece")
    shapes, first_names = DistinctShapes(), list[str]()
    for piece in pieces:
        length, width = piece.size
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
                f"{piece.file_stem}.dxf",
                "" if piece.sheet.grain == "none" else piece.sheet.grain,
                _like(piece, shapes, first_names),
            )
        )
    return CutList(tuple(rows)).in_files({} if files is None else files)


def _like(piece: Piece, shapes: DistinctShapes, first_names: list[str]) -> str:
    """Return the name of the first earlier piece with the same shape, or register this piece and return ""."""
    outer = piece.drawing.on(CUT_OUTER)
    # skip pieces whose shape is not determined by the drawing alone
    if len(outer) != 1 or piece.worked is not None:
        return ""
    shape = FlatShape((Layer(piece.sheet, outer[0], piece.drawing.on(CUT_INNER)),))
    number = shapes.number(shape)
    if number < len(first_names):
        return first_names[number]
    first_names.append(piece.name)
    return ""


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
